//! Turns a list of joints, each with the names of its links, into a drawing. PMKS, PMKS+ and Pyslvs
//! store mechanisms in this form.

use super::drawing::{
    Drawing, DrawnInput, DrawnLaw, DrawnPart, DrawnSlide, DrawnSlider, InputElement, MAX_ELEMENTS,
};
use crate::wording::words;
use std::collections::HashMap;

/// The kind of a joint.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum JointKind {
    /// A pin.
    Pin,
    /// A link slides on another without turning.
    Slider,
    /// A pin in a slot.
    PinInSlot,
    /// Two gears.
    Gears,
}

impl JointKind {
    /// Returns the kind of a type's name.
    pub(super) fn parse(text: &str) -> Option<JointKind> {
        [
            ("R", JointKind::Pin),
            ("P", JointKind::Slider),
            ("RP", JointKind::PinInSlot),
            ("G", JointKind::Gears),
        ]
        .into_iter()
        .find_map(|(name, kind)| text.eq_ignore_ascii_case(name).then_some(kind))
    }
}

/// A joint of a file.
#[derive(Clone, Debug)]
pub(super) struct ReadJoint {
    pub(super) name: Option<String>,
    /// The links in the order of the file; the frame has a reserved name.
    pub(super) links: Vec<String>,
    pub(super) kind: JointKind,
    pub(super) at: [f64; 2],
    /// The direction of sliding, in degrees.
    pub(super) angle: f64,
    pub(super) is_input: bool,
    /// The place in the file, for remarks.
    pub(super) place: String,
}

/// Joints that are being collected.
#[derive(Debug, Default)]
pub(super) struct Joints {
    pub(super) drawing: Drawing,
    parts: HashMap<String, DrawnPart>,
    /// The candidates for an input, in the order of the file.
    inputs: Vec<InputCandidate>,
    is_too_large: bool,
}

#[derive(Debug)]
struct InputCandidate {
    element: InputElement,
    is_input: bool,
    is_named: bool,
    meets_frame: bool,
    /// `true` if the joint can be the input of a file that marks none.
    can_lead: bool,
    place: String,
}

/// Returns `true` for a name of the frame.
pub(super) fn is_frame(name: &str) -> bool {
    let name = name.to_ascii_lowercase();
    name == "gnd" || name == "grnd" || name == "0" || name.starts_with("ground")
}

/// The name by which a file calls the link that is to be driven.
const INPUT: &str = "input";

impl Joints {
    /// Returns the part of this name, which may be new.
    pub(super) fn part(&mut self, name: &str) -> DrawnPart {
        if is_frame(name) {
            return DrawnPart::Frame;
        }
        if let Some(&part) = self.parts.get(name) {
            return part;
        }
        if self.drawing.links.len() > MAX_ELEMENTS {
            self.is_too_large = true;
            return DrawnPart::Frame;
        }
        let part = DrawnPart::Link(self.drawing.link(Some(name.to_owned())));
        self.parts.insert(name.to_owned(), part);
        part
    }

    /// Returns the known part of this name.
    pub(super) fn known(&self, name: &str) -> Option<DrawnPart> {
        match is_frame(name) {
            true => Some(DrawnPart::Frame),
            false => self.parts.get(name).copied(),
        }
    }

    /// Adds a joint; returns its point.
    pub(super) fn add(&mut self, joint: &ReadJoint) -> Option<usize> {
        if self.drawing.points.len() > MAX_ELEMENTS || self.drawing.is_too_large() {
            self.is_too_large = true;
            return None;
        }
        let mut parts: Vec<DrawnPart> = Vec::new();
        for name in &joint.links {
            let part = self.part(name);
            if !parts.contains(&part) {
                parts.push(part);
            }
        }
        if parts.is_empty() {
            self.drawing
                .remark(&joint.place, words().import_joint_without_links());
            return None;
        }
        let (kind, place) = (joint.kind, joint.place.as_str());
        if kind == JointKind::Gears {
            self.drawing.remark(place, words().import_gears());
            return None;
        }
        let point = self.drawing.point(joint.name.clone(), joint.at);
        let element = match (kind, parts.as_slice()) {
            (JointKind::Pin, parts) | (_, parts @ [_]) => {
                for &part in parts {
                    self.drawing.attach(point, part);
                }
                self.turned(parts)
            }
            (JointKind::PinInSlot, [slot, pins @ ..]) => {
                for &part in pins {
                    self.drawing.attach(point, part);
                }
                let slide = self.slide(DrawnSlider::Pin(point), *slot, joint.angle);
                Some((InputElement::Slide(slide), *slot == DrawnPart::Frame))
            }
            (_, [one, other, more @ ..]) => {
                if !more.is_empty() {
                    self.drawing.remark(place, words().import_slider_of_many());
                }
                self.slider(point, [*one, *other], joint.angle)
            }
            (_, []) => None,
        };
        let is_named = joint
            .links
            .iter()
            .any(|name| name.eq_ignore_ascii_case(INPUT));
        if let Some((element, meets_frame)) = element {
            self.inputs.push(InputCandidate {
                element,
                is_input: joint.is_input,
                is_named,
                meets_frame,
                can_lead: kind != JointKind::PinInSlot,
                place: place.to_owned(),
            });
        } else if joint.is_input {
            self.drawing
                .remark(place, words().import_input_of_one_link());
        }
        Some(point)
    }

    /// Returns the turning input of a pin, and whether it turns against the frame.
    fn turned(&self, parts: &[DrawnPart]) -> Option<(InputElement, bool)> {
        let is_input = |part: &DrawnPart| match part {
            DrawnPart::Link(link) => self.drawing.links[*link]
                .name
                .as_deref()
                .is_some_and(|name| name.eq_ignore_ascii_case(INPUT)),
            DrawnPart::Frame => false,
        };
        let from = match parts.contains(&DrawnPart::Frame) {
            true => DrawnPart::Frame,
            false => *parts.iter().find(|part| !is_input(part))?,
        };
        let moving = |part: &&DrawnPart| **part != from;
        let named = parts.iter().filter(moving).find(|part| is_input(part));
        match named.or_else(|| parts.iter().find(moving))? {
            DrawnPart::Link(link) => {
                let element = InputElement::Turn { link: *link, from };
                Some((element, from == DrawnPart::Frame))
            }
            DrawnPart::Frame => None,
        }
    }

    /// Adds a slide and returns its index.
    fn slide(&mut self, slider: DrawnSlider, on: DrawnPart, angle: f64) -> usize {
        self.drawing.slides.push(DrawnSlide::new(slider, on, angle));
        self.drawing.slides.len() - 1
    }

    /// Adds a slide of a link that does not turn on its guide.
    fn slider(
        &mut self,
        point: usize,
        [one, other]: [DrawnPart; 2],
        angle: f64,
    ) -> Option<(InputElement, bool)> {
        let (on, link) = match (one, other) {
            (on, DrawnPart::Link(link)) => (on, link),
            (DrawnPart::Link(link), DrawnPart::Frame) => (DrawnPart::Frame, link),
            (DrawnPart::Frame, DrawnPart::Frame) => return None,
        };
        self.drawing.attach(point, DrawnPart::Link(link));
        let slide = self.slide(DrawnSlider::Link { link, at: point }, on, angle);
        Some((InputElement::Slide(slide), on == DrawnPart::Frame))
    }

    /// Chooses the inputs and returns the drawing; `None` if it is too large. `law` is that of all
    /// inputs. A file with one input may mark several; then only the first one counts.
    pub(super) fn finish(mut self, law: &DrawnLaw, has_one: bool) -> Option<Drawing> {
        if self.is_too_large || self.drawing.is_too_large() {
            return None;
        }
        let all = std::mem::take(&mut self.inputs);
        let mut marked: Vec<&InputCandidate> = all.iter().filter(|input| input.is_input).collect();
        if has_one && marked.len() > 1 {
            for other in marked.split_off(1) {
                self.drawing
                    .remark(&other.place, words().import_second_input());
            }
        }
        if marked.is_empty() {
            let mut leading = all
                .iter()
                .filter(|input| input.meets_frame && input.can_lead);
            let named = leading.find(|input| input.is_named);
            let first = || all.iter().find(|input| input.meets_frame && input.can_lead);
            match named.or_else(first) {
                Some(input) => {
                    if !input.is_named {
                        self.drawing
                            .remark(&input.place, words().import_first_joint());
                    }
                    marked.push(input);
                }
                None => self.drawing.remark("", words().import_no_input()),
            }
        }
        for input in marked {
            if let InputElement::Turn { link, .. } = input.element {
                self.drawing.links[link].is_needed = true;
            }
            self.drawing.inputs.push(DrawnInput {
                element: input.element,
                law: law.clone(),
                range: None,
                place: input.place.clone(),
            });
        }
        Some(self.drawing)
    }
}
