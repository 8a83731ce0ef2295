//! Highlighting of a part selected elsewhere: wider bars, a filled mark, the name in
//! brackets, and the text colour.

use crate::quantity::Subject;
use crate::{Input, Mechanism};

/// Returns the part of the drawing that shows a subject: a point, a link, a slide, or the line
/// between two points. Returns `None` for the frame, which has no part of its own.
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

/// Formats a name in brackets, as the tables' cursor marks a value.
pub(super) fn bracketed(name: &str) -> String {
    format!("[{name}]")
}
