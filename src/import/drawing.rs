//! The form into which every reader converts a file: points with coordinates, the links that share
//! them, slides and inputs.
//!
//! All coordinates are those of the drawing, which is the opening pose. Angles are in degrees,
//! counter-clockwise from the drawing's x axis.

use crate::scene::Unit;
use crate::wording::words;

/// Maximum number of points, of links and of slides of a drawing.
pub(super) const MAX_ELEMENTS: usize = 2_000;
/// Maximum number of memberships: of points on links.
pub(super) const MAX_MEMBERS: usize = 10_000;
/// Maximum number of remarks; further ones are counted only.
const MAX_REMARKS: usize = 100;
/// Maximum size of a coordinate.
const MAX_COORDINATE: f64 = 1e150;

/// A mechanism as another program stores it.
#[derive(Debug, Default)]
pub(super) struct Drawing {
    /// The title; `None` if the file has none.
    pub(super) title: Option<String>,
    /// The unit of lengths; `None` if the file has none.
    pub(super) unit: Option<Unit>,
    pub(super) points: Vec<DrawnPoint>,
    pub(super) links: Vec<DrawnLink>,
    /// The points fixed in the frame.
    pub(super) ground: Vec<usize>,
    /// Parts that move as one.
    pub(super) welds: Vec<[DrawnPart; 2]>,
    pub(super) slides: Vec<DrawnSlide>,
    pub(super) inputs: Vec<DrawnInput>,
    pub(super) angle_limits: Vec<DrawnAngleLimit>,
    pub(super) loads: Vec<DrawnLoad>,
    pub(super) gravity: Option<[f64; 2]>,
    /// What was not taken over, with its place in the file.
    pub(super) remarks: Remarks,
}

/// A point of the drawing.
#[derive(Clone, Debug)]
pub(super) struct DrawnPoint {
    /// The name in the file; `None` if points have no names there.
    pub(super) name: Option<String>,
    pub(super) at: [f64; 2],
}

/// A rigid link.
#[derive(Clone, Debug, Default)]
pub(super) struct DrawnLink {
    pub(super) name: Option<String>,
    /// The indices of the link's points, each once.
    pub(super) points: Vec<usize>,
    pub(super) mass: Option<DrawnMass>,
    /// `true` if the link is kept even if it connects nothing: an input turns it, or it carries a
    /// guide.
    pub(super) is_needed: bool,
}

/// A mass with its centre in the drawing.
#[derive(Clone, Copy, Debug)]
pub(super) struct DrawnMass {
    pub(super) centre: [f64; 2],
    /// In kg.
    pub(super) mass: f64,
    /// About the centre, in kg m^2.
    pub(super) inertia: f64,
}

impl DrawnMass {
    /// Returns both masses as one; `unit` is that of the coordinates.
    pub(super) fn with(self, other: DrawnMass, unit: Unit) -> DrawnMass {
        let mass = self.mass + other.mass;
        if !(mass > 0.0) {
            return self;
        }
        let share = other.mass / mass;
        let distance = difference(other.centre, self.centre);
        let metres = distance[0].hypot(distance[1]) * unit.metres();
        DrawnMass {
            centre: [0, 1].map(|i| self.centre[i] + share * distance[i]),
            mass,
            inertia: self.inertia + other.inertia + self.mass * share * metres * metres,
        }
    }
}

/// The frame, or a link by its index.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub(super) enum DrawnPart {
    Frame,
    Link(usize),
}

/// A straight guide and what slides along it.
#[derive(Clone, Debug)]
pub(super) struct DrawnSlide {
    pub(super) name: Option<String>,
    pub(super) slider: DrawnSlider,
    /// What carries the guide.
    pub(super) on: DrawnPart,
    /// The direction of the guide.
    pub(super) angle: f64,
    /// A point of the carrier from which positions are measured, if there is one.
    pub(super) through: Option<usize>,
    /// How far the slider can move from the drawing, back and forth along the guide.
    pub(super) travel: Option<[f64; 2]>,
}

/// How far a link can turn from the drawing, as seen from a part, in degrees.
#[derive(Clone, Copy, Debug)]
pub(super) struct DrawnAngleLimit {
    pub(super) link: usize,
    pub(super) from: DrawnPart,
    pub(super) travel: [f64; 2],
}

/// What slides along a guide.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum DrawnSlider {
    /// A pin in a slot.
    Pin(usize),
    /// A link that does not turn on its guide; the guide is drawn at the point.
    Link { link: usize, at: usize },
}

/// An input.
#[derive(Clone, Debug)]
pub(super) struct DrawnInput {
    pub(super) element: InputElement,
    pub(super) law: DrawnLaw,
    /// The range of the coordinate, relative to the drawing.
    pub(super) range: Option<[f64; 2]>,
    pub(super) place: String,
}

/// What an input moves.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum InputElement {
    Turn { link: usize, from: DrawnPart },
    Slide(usize),
}

/// How an input moves over time.
#[derive(Clone, Debug, PartialEq)]
pub(super) enum DrawnLaw {
    /// The file gives no speed.
    Unknown,
    /// A constant speed, with the unit's name.
    Speed(f64, &'static str),
    /// A sine about a middle position.
    Sine {
        amplitude: f64,
        /// The period, in s.
        time: f64,
        /// The phase in the drawing, in degrees.
        phase: f64,
    },
}

/// A force at a point, in N.
#[derive(Clone, Copy, Debug)]
pub(super) struct DrawnLoad {
    pub(super) point: usize,
    pub(super) force: [f64; 2],
    /// The link with which the force turns.
    pub(super) turns_with: Option<usize>,
}

/// Sentences on what was not taken over, or was decided on the way.
#[derive(Debug, Default)]
pub(super) struct Remarks {
    list: Vec<String>,
    more: usize,
}

impl Remarks {
    /// Adds a sentence about a place of the file.
    pub(super) fn add(&mut self, place: &str, text: &str) {
        match self.list.len() < MAX_REMARKS {
            true => self.list.push(match place {
                "" => text.to_owned(),
                place => format!("{place}: {text}"),
            }),
            false => self.more += 1,
        }
    }

    /// Returns all sentences; the last one counts those that were left out.
    pub(super) fn into_list(mut self) -> Vec<String> {
        if self.more > 0 {
            self.list.push(words().import_more_remarks(self.more));
        }
        self.list
    }
}

impl DrawnSlide {
    /// Creates a slide without a name and without limits.
    pub(super) fn new(slider: DrawnSlider, on: DrawnPart, angle: f64) -> DrawnSlide {
        DrawnSlide {
            name: None,
            slider,
            on,
            angle,
            through: None,
            travel: None,
        }
    }
}

impl Drawing {
    /// Adds a remark on a place in the file.
    pub(super) fn remark(&mut self, place: &str, text: &str) {
        self.remarks.add(place, text);
    }

    /// Adds a point and returns its index.
    pub(super) fn point(&mut self, name: Option<String>, at: [f64; 2]) -> usize {
        self.points.push(DrawnPoint { name, at });
        self.points.len() - 1
    }

    /// Adds a link and returns its index.
    pub(super) fn link(&mut self, name: Option<String>) -> usize {
        self.links.push(DrawnLink {
            name,
            ..DrawnLink::default()
        });
        self.links.len() - 1
    }

    /// Puts a point on a part.
    pub(super) fn attach(&mut self, point: usize, part: DrawnPart) {
        let points = match part {
            DrawnPart::Frame => &mut self.ground,
            DrawnPart::Link(link) => &mut self.links[link].points,
        };
        if !points.contains(&point) {
            points.push(point);
        }
    }

    /// Returns `true` if the drawing exceeds the maximum size.
    pub(super) fn is_too_large(&self) -> bool {
        let counts = [
            self.points.len(),
            self.links.len(),
            self.slides.len(),
            self.inputs.len(),
            self.loads.len(),
        ];
        let members: usize = self.links.iter().map(|link| link.points.len()).sum();
        counts.into_iter().any(|count| count > MAX_ELEMENTS) || members > MAX_MEMBERS
    }

    /// Returns `true` if a slide or a link has limits.
    pub(super) fn has_limits(&self) -> bool {
        !self.angle_limits.is_empty() || self.slides.iter().any(|slide| slide.travel.is_some())
    }

    /// Returns the length of the diagonal of the drawing.
    pub(super) fn size(&self) -> f64 {
        let start = [f64::INFINITY, f64::NEG_INFINITY];
        let extent = |i: usize| {
            let ends = self.points.iter().map(|point| point.at[i]);
            let [low, high] = ends.fold(start, |[low, high], x| [low.min(x), high.max(x)]);
            (high - low).max(0.0)
        };
        extent(0).hypot(extent(1))
    }

    /// Returns the distance between two points.
    pub(super) fn distance(&self, from: usize, to: usize) -> f64 {
        let [dx, dy] = difference(self.points[to].at, self.points[from].at);
        dx.hypot(dy)
    }

    /// Returns the direction from one point to another, in degrees.
    pub(super) fn direction(&self, from: usize, to: usize) -> f64 {
        direction(difference(self.points[to].at, self.points[from].at))
    }
}

/// Returns the part of two travels that both permit; `None` permits everything.
pub(super) fn both_travels(one: Option<[f64; 2]>, other: Option<[f64; 2]>) -> Option<[f64; 2]> {
    match (one, other) {
        (Some(one), Some(other)) => Some(common_travel(one, other)),
        (one, other) => one.or(other),
    }
}

/// Returns the part of two travels that both permit; its first end exceeds the second if there is none.
pub(super) fn common_travel(one: [f64; 2], other: [f64; 2]) -> [f64; 2] {
    [one[0].max(other[0]), one[1].min(other[1])]
}

/// Returns a travel as seen from the other part, or along the opposite direction.
pub(super) fn reversed_travel([low, high]: [f64; 2]) -> [f64; 2] {
    [0.0 - high, 0.0 - low]
}

/// Returns `a - b`.
pub(super) fn difference(a: [f64; 2], b: [f64; 2]) -> [f64; 2] {
    [a[0] - b[0], a[1] - b[1]]
}

/// Returns the direction of a vector in degrees; exact for multiples of 90.
pub(super) fn direction([x, y]: [f64; 2]) -> f64 {
    match (x, y) {
        (_, 0.0) if x < 0.0 => 180.0,
        (_, 0.0) => 0.0,
        (0.0, _) if y > 0.0 => 90.0,
        (0.0, _) => -90.0,
        _ => y.atan2(x).to_degrees(),
    }
}

/// Returns an angle between -180 and 180 degrees.
pub(super) fn wrapped(angle: f64) -> f64 {
    let turned = angle.rem_euclid(360.0);
    if turned > 180.0 {
        turned - 360.0
    } else {
        turned
    }
}

/// Reads a number; `None` for text, for values that are not finite and for huge ones.
pub(super) fn number(text: &str) -> Option<f64> {
    let text = text.trim();
    let is_numeral = |c: char| c.is_ascii_digit() || matches!(c, '+' | '-' | '.' | 'e' | 'E');
    // `f64::from_str` also reads `inf` and `nan`.
    if !text.chars().all(is_numeral) {
        return None;
    }
    text.parse().ok().filter(|value| is_usable(*value))
}

/// Returns `true` for a finite number of a size that a drawing may have.
pub(super) fn is_usable(value: f64) -> bool {
    value.abs() <= MAX_COORDINATE
}
