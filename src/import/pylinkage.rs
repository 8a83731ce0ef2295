//! Reads the mechanisms of pylinkage in JSON.

use super::ImportError;
use super::drawing::{
    Drawing, DrawnInput, DrawnLaw, DrawnPart, DrawnSlide, DrawnSlider, InputElement, MAX_ELEMENTS,
    difference, direction, is_usable,
};
use crate::wording::words;
use serde_json::Value;
use std::collections::HashMap;

/// A slider farther from its line than this fraction of the distance is remarked upon.
const BESIDE: f64 = 1e-6;
/// The types of joints in the older format, which stores constraints instead of links.
const OLDER_TYPES: [&str; 6] = [
    "Static",
    "Crank",
    "Revolute",
    "Fixed",
    "Linear",
    "Prismatic",
];

/// Returns `true` for JSON with a joint of pylinkage and a list of links, also if its syntax is
/// invalid.
pub(super) fn is_pylinkage(text: &str) -> bool {
    let has_keys = || {
        ["\"joints\"", "\"links\""]
            .iter()
            .all(|key| text.contains(key))
    };
    if !text.starts_with('{') || !has_keys() {
        return false;
    }
    let is_joint = |joint: &Value| pair_of(joint, "position").is_some() || is_older(joint);
    let file: Result<Value, _> = serde_json::from_str(text);
    file.map_or(true, |file| {
        let joints = list(&file, "joints").filter(|_| list(&file, "links").is_some());
        joints.is_some_and(|joints| joints.iter().any(is_joint))
    })
}

/// Returns `true` for a joint of the older format.
fn is_older(joint: &Value) -> bool {
    text_of(joint, "type").is_some_and(|kind| OLDER_TYPES.contains(&kind))
}

/// Reads a mechanism.
pub(super) fn read_pylinkage(text: &str) -> Result<Drawing, ImportError> {
    let file: Value = serde_json::from_str(text)
        .map_err(|why| ImportError::new(&words().import_json(&why.to_string())))?;
    let (Some(joints), Some(links)) = (list(&file, "joints"), list(&file, "links")) else {
        return Err(ImportError::new(words().import_other_json()));
    };
    if joints.iter().any(is_older) {
        return Err(ImportError::new(words().import_older_pylinkage()));
    }
    if joints.len() > MAX_ELEMENTS || links.len() > MAX_ELEMENTS {
        return Err(ImportError::too_large());
    }
    let mut reader = MechanismReader {
        drawing: Drawing {
            title: text_of(&file, "name")
                .filter(|name| !name.is_empty())
                .map(str::to_owned),
            ..Drawing::default()
        },
        joints: HashMap::new(),
    };
    for (number, joint) in joints.iter().enumerate() {
        reader.joint(number, joint);
    }
    let ground = text_of(&file, "ground");
    for (number, link) in links.iter().enumerate() {
        reader.link(number, link, ground);
    }
    reader.trackers();
    reader.sliders();
    if reader.drawing.points.is_empty() {
        return Err(ImportError::new(words().import_no_joints()));
    }
    if reader.drawing.inputs.is_empty() {
        reader.drawing.remark("", words().import_no_input());
    }
    match reader.drawing.is_too_large() {
        true => Err(ImportError::too_large()),
        false => Ok(reader.drawing),
    }
}

fn list<'v>(value: &'v Value, key: &str) -> Option<&'v Vec<Value>> {
    value.get(key)?.as_array()
}

fn text_of<'v>(value: &'v Value, key: &str) -> Option<&'v str> {
    value.get(key)?.as_str()
}

fn number_of(value: &Value, key: &str) -> Option<f64> {
    value.get(key)?.as_f64().filter(|value| is_usable(*value))
}

fn pair_of(value: &Value, key: &str) -> Option<[f64; 2]> {
    let [x, y] = value.get(key)?.as_array()?.as_slice() else {
        return None;
    };
    let pair = [x.as_f64()?, y.as_f64()?];
    pair.iter().all(|value| is_usable(*value)).then_some(pair)
}

struct MechanismReader {
    drawing: Drawing,
    joints: HashMap<String, MechanismJoint>,
}

struct MechanismJoint {
    /// The place in the file's list.
    number: usize,
    point: usize,
    /// The direction of a slider, in degrees.
    axis: Option<f64>,
    /// The links that name a slider; the frame among them carries its guide.
    links: Vec<DrawnPart>,
    /// The joints between which a tracker is seen.
    seen_from: Option<[String; 2]>,
}

impl MechanismReader {
    fn joint(&mut self, number: usize, joint: &Value) {
        let place = format!("joints[{number}]");
        let (Some(id), Some(at)) = (text_of(joint, "id"), pair_of(joint, "position")) else {
            self.drawing.remark(&place, words().import_not_a_joint());
            return;
        };
        let kind = text_of(joint, "type").unwrap_or("revolute");
        if !["ground", "revolute", "prismatic", "tracker"].contains(&kind) {
            self.drawing
                .remark(&place, &words().import_unknown_kind(kind));
            return;
        }
        if self.joints.contains_key(id) {
            self.drawing.remark(&place, words().import_same_id());
            return;
        }
        let name = text_of(joint, "name").unwrap_or(id);
        let point = self.drawing.point(Some(name.to_owned()), at);
        if kind == "ground" {
            self.drawing.attach(point, DrawnPart::Frame);
        }
        let axis = (kind == "prismatic").then(|| {
            let axis = pair_of(joint, "axis").filter(|axis| *axis != [0.0; 2]);
            if axis.is_none() {
                self.drawing.remark(&place, words().import_no_axis());
            }
            direction(axis.unwrap_or([1.0, 0.0]))
        });
        if let (Some(axis), Some(through)) = (axis, pair_of(joint, "line_point")) {
            let [dx, dy] = difference(at, through);
            let (sin, cos) = axis.to_radians().sin_cos();
            let off = (dx * sin - dy * cos).abs();
            if off > BESIDE * dx.hypot(dy) {
                self.drawing
                    .remark(&place, &words().import_joint_beside_line(off));
            }
        }
        let joint = MechanismJoint {
            number,
            point,
            axis,
            links: Vec::new(),
            seen_from: text_of(joint, "ref_joint1_id")
                .zip(text_of(joint, "ref_joint2_id"))
                .filter(|_| kind == "tracker")
                .map(|(one, other)| [one.to_owned(), other.to_owned()]),
        };
        self.joints.insert(id.to_owned(), joint);
    }

    fn link(&mut self, number: usize, link: &Value, ground: Option<&str>) {
        let place = format!("links[{number}]");
        let Some(id) = text_of(link, "id") else {
            self.drawing.remark(&place, words().import_not_a_link());
            return;
        };
        let kind = text_of(link, "type").unwrap_or("link");
        if !["ground", "link", "driver", "arc_driver"].contains(&kind) {
            self.drawing
                .remark(&place, &words().import_unknown_link_kind(kind));
        }
        if list(link, "joints").is_none() {
            self.drawing.remark(&place, words().import_not_a_link());
            return;
        }
        let part = match kind == "ground" || ground == Some(id) {
            true => DrawnPart::Frame,
            false => {
                let name = text_of(link, "name").unwrap_or(id);
                DrawnPart::Link(self.drawing.link(Some(name.to_owned())))
            }
        };
        for joint in list(link, "joints").into_iter().flatten() {
            let found = joint.as_str().and_then(|id| self.joints.get_mut(id));
            match found {
                Some(joint) if joint.axis.is_some() => joint.links.push(part),
                Some(joint) => {
                    let point = joint.point;
                    self.drawing.attach(point, part);
                }
                None => {
                    let joint = joint.as_str().unwrap_or_default();
                    self.drawing
                        .remark(&place, &words().import_unknown_joint(joint));
                }
            }
            if self.drawing.is_too_large() {
                return;
            }
        }
        if let (DrawnPart::Link(part), "driver" | "arc_driver") = (part, kind) {
            self.driver(part, link, place);
        }
    }

    fn driver(&mut self, part: usize, link: &Value, place: String) {
        for key in ["angular_velocity", "initial_angle", "arc_start", "arc_end"] {
            if let Some(value) = link.get(key).filter(|value| !value.is_null())
                && number_of(link, key).is_none()
            {
                let text = words().import_unread_cell(key, &value.to_string());
                self.drawing.remark(&place, &text);
            }
        }
        if let Some(id) = link.get("motor_joint").filter(|value| !value.is_null()) {
            let id = id.as_str().unwrap_or_default();
            match self.joints.get(id).map(|joint| joint.point) {
                // The program fixes the joint of a motor.
                Some(point) => self.drawing.attach(point, DrawnPart::Frame),
                None => {
                    let text = words().import_unknown_joint(id);
                    self.drawing.remark(&place, &text);
                }
            }
        }
        let law = match number_of(link, "angular_velocity") {
            Some(speed) if speed != 0.0 => DrawnLaw::Speed(speed, "rad/s"),
            _ => DrawnLaw::Unknown,
        };
        let end = |key: &str| number_of(link, key).map(f64::to_degrees);
        let first = end("initial_angle").or_else(|| end("arc_start"));
        let range = match (end("arc_start"), end("arc_end"), first) {
            (Some(low), Some(high), Some(first)) if low < high => {
                let ends = [low - first, high - first];
                (ends[0] <= 0.0 && ends[1] >= 0.0).then_some(ends)
            }
            _ => None,
        };
        if range.is_none() && (link.get("arc_start").is_some() || link.get("arc_end").is_some()) {
            self.drawing.remark(&place, words().import_beyond_arc());
        }
        self.drawing.links[part].is_needed = true;
        self.drawing.inputs.push(DrawnInput {
            element: InputElement::Turn {
                link: part,
                from: DrawnPart::Frame,
            },
            law,
            range,
            place,
        });
    }

    /// Puts each tracker on the link of the joints between which it is seen, and remarks upon joints
    /// of no link.
    fn trackers(&mut self) {
        let mut joints: Vec<&MechanismJoint> = self.joints.values().collect();
        joints.sort_by_key(|joint| joint.number);
        for joint in joints {
            let known = |id: &String| self.joints.get(id).map(|joint| joint.point);
            let links = &self.drawing.links;
            let seen_from = joint.seen_from.as_ref();
            let seen_on = match seen_from.map(|ids| ids.each_ref().map(known)) {
                Some([Some(one), Some(other)]) => links
                    .iter()
                    .position(|link| link.points.contains(&one) && link.points.contains(&other)),
                _ => None,
            };
            let is_held = joint.axis.is_some()
                || self.drawing.ground.contains(&joint.point)
                || links.iter().any(|link| link.points.contains(&joint.point));
            match seen_on {
                Some(link) => self.drawing.attach(joint.point, DrawnPart::Link(link)),
                None if !is_held => {
                    let place = format!("joints[{}]", joint.number);
                    let text = words().import_joint_without_links();
                    self.drawing.remark(&place, text);
                }
                None => {}
            }
        }
    }

    /// Adds the slides of sliding joints.
    fn sliders(&mut self) {
        let mut joints: Vec<MechanismJoint> =
            std::mem::take(&mut self.joints).into_values().collect();
        joints.sort_by_key(|joint| joint.number);
        for joint in joints {
            let Some(angle) = joint.axis else { continue };
            let place = format!("joints[{}]", joint.number);
            if joint.links.is_empty() {
                let text = words().import_joint_without_links();
                self.drawing.remark(&place, text);
                continue;
            }
            // The frame carries the guides of this program; a joint of one part slides on it.
            let is_alone = joint.links.len() == 1;
            for &part in &joint.links {
                if is_alone || part != DrawnPart::Frame {
                    self.drawing.attach(joint.point, part);
                }
            }
            if !is_alone && !joint.links.contains(&DrawnPart::Frame) {
                self.drawing
                    .remark(&place, words().import_slider_on_frame());
            }
            let (slider, on) = (DrawnSlider::Pin(joint.point), DrawnPart::Frame);
            self.drawing.slides.push(DrawnSlide::new(slider, on, angle));
        }
    }
}
