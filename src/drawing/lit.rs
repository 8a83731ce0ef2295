//! What is lit up in a drawing because something else points at it: its bars are wider, its mark is full, its name
//! stands between brackets, and its hue is that of the ink.

use crate::quantity::Subject;
use crate::{Input, Mechanism};

/// The part of the drawing that shows a subject: a point, a link, a slide, or the line between two points. Nothing
/// shows the frame as a whole.
pub(super) fn shown_as(subject: Subject, mechanism: &Mechanism) -> Option<Subject> {
    match subject {
        Subject::Point(_) | Subject::Link(_) | Subject::Slide(_) | Subject::Between(..) => {
            Some(subject)
        }
        Subject::Driver | Subject::Drive(_) => Some(match mechanism.driver().input {
            Input::Turn(link) => Subject::Link(link),
            Input::Push(slide) => Subject::Slide(slide),
        }),
        Subject::Joint(_, point) => Some(Subject::Point(point)),
        Subject::Frame | Subject::FrameResidual => None,
    }
}

/// A name as the cursor of the tables marks a figure.
pub(super) fn bracketed(name: &str) -> String {
    format!("[{name}]")
}
