//! Reads the XML files of Linkage.

use super::ImportError;
use super::drawing::{
    Drawing, DrawnAngleLimit, DrawnInput, DrawnLaw, DrawnPart, DrawnSlide, DrawnSlider,
    InputElement, MAX_ELEMENTS, difference, number, wrapped,
};
use super::linkage_layout::{AttributeUse, is_read_elsewhere, layout, names_link};
use super::names::letters;
use crate::scene::Unit;
use crate::wording::words;
use roxmltree::{Document, Node, ParsingOptions};
use std::collections::{BTreeMap, HashMap, HashSet};

/// Maximum number of nodes of a file.
const MAX_NODES: u32 = 200_000;
/// Units of a file per inch, whatever its unit of display.
const PER_INCH: f64 = 96.0;
/// Millimetres per inch.
const INCH: f64 = 25.4;
/// Significant digits of converted coordinates.
const DIGITS: usize = 12;
/// The bits of the layers of drawings and of mechanisms.
const DRAWING_LAYER: i64 = 1;
const MECHANISM_LAYER: i64 = 16;
/// A pin is on an arc if its distance from the centre differs from the radius by less than this
/// fraction.
const ON_ARC: f64 = 1e-3;

/// A pin is at an end of its slot if it is within this fraction of the slot's length from it: files
/// have six decimals.
const AT_END: f64 = 1e-6;

/// Returns a travel that contains the drawing, or `None` if the drawing is outside of it by more
/// than a tolerance.
fn opened_travel([low, high]: [f64; 2], tolerance: f64) -> Option<[f64; 2]> {
    let is_open = low <= tolerance && -tolerance <= high;
    // A pin at an end is exactly there.
    let ends = [low, high].map(|end| if end.abs() <= tolerance { 0.0 } else { end });
    (is_open && ends[0] < ends[1]).then_some(ends)
}

/// Returns `true` for a file of Linkage.
pub(super) fn is_linkage(text: &str) -> bool {
    text.starts_with('<') && text.contains("<linkage2")
}

/// Reads a file.
pub(super) fn read_linkage(text: &str) -> Result<Drawing, ImportError> {
    let text = spaced(text);
    let options = ParsingOptions {
        nodes_limit: MAX_NODES,
        ..ParsingOptions::default()
    };
    let document = Document::parse_with_options(&text, options);
    let document =
        document.map_err(|why| ImportError::new(&words().import_xml(&why.to_string())))?;
    let root = document.root_element();
    let mut reader = LinkageReader {
        document: &document,
        drawing: Drawing::default(),
        scale: 1.0,
        connectors: HashMap::new(),
        links: HashMap::new(),
        skipped: HashSet::new(),
        inputs: Vec::new(),
        rods: Vec::new(),
    };
    reader.check(root);
    reader.program(root);
    reader.connectors(root)?;
    reader.links(root)?;
    reader.fastenings(root);
    reader.sliders(root);
    reader.loose_connectors(root);
    reader.ratios(root);
    reader.inputs();
    match reader.drawing.is_too_large() {
        true => Err(ImportError::too_large()),
        false => Ok(reader.drawing),
    }
}

/// Separates attributes that are glued to the value before them, as some files have them. The
/// lines stay the same.
fn spaced(text: &str) -> String {
    let mut spaced = String::with_capacity(text.len() + 16);
    let (mut in_tag, mut quote, mut is_closed) = (false, None, false);
    for c in text.chars() {
        if is_closed && (c.is_alphanumeric() || c == '_') {
            spaced.push(' ');
        }
        is_closed = false;
        match (quote, c) {
            (Some(open), c) if c == open => {
                quote = None;
                is_closed = true;
            }
            (Some(_), _) => {}
            (None, '"' | '\'') if in_tag => quote = Some(c),
            (None, '<') => in_tag = true,
            (None, '>') => in_tag = false,
            (None, _) => {}
        }
        spaced.push(c);
    }
    spaced
}

/// A file that is being read.
struct LinkageReader<'d> {
    document: &'d Document<'d>,
    drawing: Drawing,
    /// The size of a unit of the file in the scene's unit.
    scale: f64,
    /// The connectors by id.
    connectors: HashMap<i64, Connector>,
    /// The ids of connectors that are no part of the mechanism.
    skipped: HashSet<i64>,
    /// The links by id.
    links: HashMap<i64, DrawnPart>,
    /// The connectors that turn, with their speeds in rpm, in the order of the file.
    inputs: Vec<TurningInput>,
    /// The actuators in the order of the file.
    rods: Vec<DrawnInput>,
}

#[derive(Clone, Copy)]
struct Connector {
    point: usize,
    is_input: bool,
}

struct TurningInput {
    point: usize,
    rpm: Option<f64>,
    /// The angle over which the input swings, in degrees.
    limit: Option<f64>,
    place: String,
}

/// Returns the id of an element.
fn id(node: Node<'_, '_>, name: &str) -> Option<i64> {
    node.attribute(name)?.trim().parse().ok()
}

/// Returns `true` if an attribute is there and not empty.
fn is_given(node: Node<'_, '_>, name: &str) -> bool {
    node.attribute(name)
        .is_some_and(|value| !value.trim().is_empty())
}

fn is_true(node: Node<'_, '_>, name: &str) -> bool {
    node.attribute(name) == Some("true")
}

/// Returns `true` for an element of the mechanism; drawings and measurements are skipped.
fn is_mechanism(node: Node<'_, '_>) -> bool {
    let layer = id(node, "layer").unwrap_or(0);
    let is_drawing = layer & DRAWING_LAYER != 0 && layer & MECHANISM_LAYER == 0;
    !is_true(node, "measurementelement") && !is_drawing
}

/// Returns the children that are connectors of the mechanism, or its links.
fn children<'a>(root: Node<'a, 'a>, is_link: bool) -> impl Iterator<Item = Node<'a, 'a>> {
    root.children().filter(move |node| {
        let name = node.tag_name().name();
        let is_kind = match is_link {
            true => names_link(name),
            false => name == "connector",
        };
        node.is_element() && is_kind && is_mechanism(*node)
    })
}

impl<'d> LinkageReader<'d> {
    /// Returns the place of an element in the file.
    fn place(&self, node: Node<'_, '_>) -> String {
        let position = self.document.text_pos_at(node.range().start);
        let name = format!(
            "{} {}",
            node.tag_name().name(),
            node.attribute("id").unwrap_or_default()
        );
        words().import_element(position.row, name.trim())
    }

    fn remark(&mut self, node: Node<'_, '_>, text: &str) {
        let place = self.place(node);
        self.drawing.remark(&place, text);
    }

    /// Returns a length of the file in the scene's unit.
    fn length(&self, node: Node<'_, '_>, name: &str) -> Option<f64> {
        let value = number(node.attribute(name)?)? * self.scale;
        let rounded = format!("{value:.*e}", DIGITS - 1).parse();
        Some(rounded.unwrap_or(value))
    }

    /// Remarks upon elements and attributes that no reader uses, and upon values that are no numbers
    /// or flags.
    fn check(&mut self, root: Node<'d, 'd>) {
        // Files repeat an attribute in every element: one remark counts them.
        let mut unknown: BTreeMap<(String, String), (String, usize)> = BTreeMap::new();
        for node in root.children().filter(Node::is_element) {
            let Some(layout) = layout(node) else {
                if !is_read_elsewhere(node.tag_name().name()) {
                    self.remark(node, words().import_unknown_element());
                }
                continue;
            };
            if !is_mechanism(node) {
                if node.has_tag_name("connector") {
                    self.skipped.extend(id(node, "id"));
                }
                continue;
            }
            for attribute in node.attributes() {
                let (name, value) = (attribute.name(), attribute.value().trim());
                let known = layout.attributes.iter().find(|(known, _)| *known == name);
                match known.map(|(_, of)| of) {
                    Some(AttributeUse::Number) if !value.is_empty() && number(value).is_none() => {
                        self.remark(node, &words().import_not_a_number(name, value));
                    }
                    Some(AttributeUse::Flag) if !["", "true", "false"].contains(&value) => {
                        self.remark(node, &words().import_not_a_flag(name, value));
                    }
                    Some(_) => {}
                    None => {
                        let key = (node.tag_name().name().to_owned(), name.to_owned());
                        let place = self.place(node);
                        unknown.entry(key).or_insert((place, 0)).1 += 1;
                    }
                }
            }
            for child in node.children().filter(Node::is_element) {
                if !layout.children.contains(&child.tag_name().name()) {
                    self.remark(child, words().import_unknown_element());
                }
            }
        }
        for ((_, name), (place, count)) in unknown {
            let text = words().import_unknown_attribute(&name, count);
            self.drawing.remark(&place, &text);
        }
    }

    /// Reads the unit.
    fn program(&mut self, root: Node<'_, '_>) {
        let program = root.children().find(|node| node.has_tag_name("program"));
        let units = program
            .and_then(|node| node.attribute("units"))
            .unwrap_or_default();
        let is = |unit: &str| units.trim().eq_ignore_ascii_case(unit);
        let unit = match is("inches") {
            true => Unit::Inch,
            false => Unit::Millimetre,
        };
        if let Some(program) = program {
            if !["inches", "millimeters", ""].into_iter().any(is) {
                self.remark(program, &words().import_unknown_unit(units));
            }
            let scale = program.attribute("scalefactor").and_then(number);
            if let Some(scale) = scale.filter(|&scale| scale != 1.0 && scale != 0.0) {
                self.remark(program, &words().import_scale_factor(scale));
            }
        }
        self.drawing.unit = Some(unit);
        self.scale = match unit {
            Unit::Inch => 1.0 / PER_INCH,
            _ => INCH / PER_INCH,
        };
    }

    fn connectors(&mut self, root: Node<'d, 'd>) -> Result<(), ImportError> {
        for node in children(root, false) {
            if self.drawing.points.len() > MAX_ELEMENTS {
                return Err(ImportError::too_large());
            }
            let (Some(key), Some(x), Some(y)) = (
                id(node, "id"),
                self.length(node, "x"),
                self.length(node, "y"),
            ) else {
                self.remark(node, words().import_not_a_connector());
                continue;
            };
            if self.connectors.contains_key(&key) {
                self.remark(node, words().import_same_id());
                continue;
            }
            let letters = usize::try_from(key).map(letters);
            let named = node
                .attribute("name")
                .filter(|name| !name.trim().is_empty());
            let name = named.map(str::to_owned).or(letters.ok());
            let point = self.drawing.point(name, [x, y]);
            let is_anchor = is_true(node, "anchor");
            if is_anchor {
                self.drawing.attach(point, DrawnPart::Frame);
            }
            let is_input = is_true(node, "input");
            if is_input && !is_anchor {
                self.remark(node, words().import_input_not_fixed());
            } else if is_input {
                self.inputs.push(TurningInput {
                    point,
                    // An input that the user moves has no speed.
                    rpm: node
                        .attribute("rpm")
                        .and_then(number)
                        .filter(|_| !is_true(node, "alwaysmanual")),
                    limit: node
                        .attribute("limitangle")
                        .and_then(number)
                        .filter(|&at| at != 0.0),
                    place: self.place(node),
                });
            }
            let connector = Connector { point, is_input };
            self.connectors.insert(key, connector);
        }
        match self.connectors.is_empty() {
            true => Err(ImportError::new(words().import_no_joints())),
            false => Ok(()),
        }
    }

    fn links(&mut self, root: Node<'d, 'd>) -> Result<(), ImportError> {
        for node in children(root, true) {
            if self.drawing.is_too_large() {
                return Err(ImportError::too_large());
            }
            // Older files have links of the same id, which only fastenings refer to.
            let key = id(node, "id");
            if is_true(node, "gear") {
                self.remark(node, words().import_gears());
            }
            let named = node
                .attribute("name")
                .filter(|name| !name.trim().is_empty());
            let known = key.filter(|key| !self.links.contains_key(key));
            let numbered = known.map(|key| format!("link-{}", key.saturating_add(1)));
            let name = named.map(str::to_owned).or(numbered);
            let mut points = Vec::new();
            for child in node
                .children()
                .filter(|child| child.has_tag_name("connector"))
            {
                match id(child, "id").and_then(|key| self.connectors.get(&key)) {
                    Some(connector) if !points.contains(&connector.point) => {
                        points.push(connector.point);
                    }
                    Some(_) => {}
                    None => self.remark(child, words().import_no_such_connector()),
                }
            }
            if points.is_empty() {
                self.remark(node, words().import_link_of_no_connector());
            }
            if is_true(node, "actuator")
                && let Some(barrel) = self.actuator(node, name.as_deref(), &points)
            {
                if let Some(key) = known {
                    self.links.insert(key, barrel);
                }
                continue;
            }
            let link = self.drawing.link(name);
            if let Some(key) = known {
                self.links.insert(key, DrawnPart::Link(link));
            }
            self.drawing.links[link].points = points;
        }
        Ok(())
    }

    /// Reads an actuator: a barrel with a rod that slides in it. Returns the barrel, or `None` if
    /// the link is rigid.
    fn actuator(
        &mut self,
        node: Node<'_, '_>,
        name: Option<&str>,
        points: &[usize],
    ) -> Option<DrawnPart> {
        let &[one, other] = points else {
            self.remark(node, words().import_actuator_of_two());
            return None;
        };
        let is_fixed = |point: usize| self.drawing.ground.contains(&point);
        // A fixed point carries the barrel.
        let (foot, eye) = match is_fixed(other) && !is_fixed(one) {
            true => (other, one),
            false => (one, other),
        };
        let length = self.drawing.distance(foot, eye);
        if is_fixed(eye) || !(length > 0.0) {
            self.remark(node, words().import_actuator_is_fixed());
            return None;
        }
        let named = name.map(|name| format!("{name}-barrel"));
        let barrel = self.drawing.link(named);
        self.drawing.links[barrel].is_needed = true;
        self.drawing.attach(foot, DrawnPart::Link(barrel));
        let angle = self.drawing.direction(foot, eye);
        self.drawing.slides.push(DrawnSlide {
            name: name.map(str::to_owned),
            through: Some(foot),
            ..DrawnSlide::new(DrawnSlider::Pin(eye), DrawnPart::Link(barrel), angle)
        });
        let throw = self.length(node, "throw").unwrap_or(0.0);
        if throw < 0.0 {
            self.remark(node, words().import_negative_throw());
        }
        let throw = throw.abs();
        let cpm = node.attribute("cpm").and_then(number).unwrap_or(0.0);
        // The drawing shows the beginning of the stroke. A negative number of cycles retracts.
        let sign = if cpm < 0.0 { -1.0 } else { 1.0 };
        let has_stroke = throw > 0.0;
        let moves = has_stroke && cpm != 0.0 && !is_true(node, "alwaysmanual");
        if !moves && !is_true(node, "alwaysmanual") {
            self.remark(node, words().import_actuator_without_law());
        }
        let law = match moves {
            true => DrawnLaw::Sine {
                amplitude: 0.5 * throw,
                time: 60.0 / cpm.abs(),
                phase: -90.0 * sign,
            },
            false => DrawnLaw::Unknown,
        };
        let ends = [0.0_f64.min(sign * throw), 0.0_f64.max(sign * throw)];
        if has_stroke && length + ends[0] <= 0.0 {
            self.remark(node, words().import_stroke_too_long());
        }
        self.rods.push(DrawnInput {
            element: InputElement::Slide(self.drawing.slides.len() - 1),
            law,
            range: has_stroke.then_some(ends),
            place: self.place(node),
        });
        Some(DrawnPart::Link(barrel))
    }

    /// Reads what is fastened to what.
    fn fastenings(&mut self, root: Node<'d, 'd>) {
        for node in children(root, true) {
            let Some(&part) = id(node, "id").and_then(|key| self.links.get(&key)) else {
                continue;
            };
            if is_given(node, "fastenlink") {
                match id(node, "fastenlink").and_then(|key| self.links.get(&key)) {
                    Some(&other) => self.drawing.welds.push([part, other]),
                    None => self.remark(node, words().import_fastened_to_nothing()),
                }
            }
            if is_given(node, "fastenconnector") {
                let connector =
                    id(node, "fastenconnector").and_then(|key| self.connectors.get(&key));
                match connector.copied() {
                    // The link turns with the input.
                    Some(Connector {
                        point,
                        is_input: true,
                    }) => self.drawing.attach(point, part),
                    _ => self.remark(node, words().import_fastened_to_connector()),
                }
            }
            for child in node.children() {
                let key = id(child, "id");
                if child.has_tag_name("fastenconnector") {
                    match key.and_then(|key| self.connectors.get(&key)) {
                        Some(connector) => {
                            let point = connector.point;
                            self.drawing.attach(point, part);
                        }
                        // Drawings move with links.
                        None if key.is_some_and(|key| self.skipped.contains(&key)) => {}
                        None => self.remark(child, words().import_no_such_connector()),
                    }
                } else if child.has_tag_name("fastenlink") {
                    match key.and_then(|key| self.links.get(&key)) {
                        Some(&other) => self.drawing.welds.push([part, other]),
                        None => self.remark(child, words().import_fastened_to_nothing()),
                    }
                }
            }
        }
        for node in children(root, false) {
            let Some(&connector) = id(node, "id").and_then(|key| self.connectors.get(&key)) else {
                continue;
            };
            let name = match node.has_attribute("fasten") {
                true => "fasten",
                false => "fastenlink",
            };
            let own = is_given(node, name).then_some((node, name));
            let elements = node.children();
            let elements = elements.filter(|child| child.has_tag_name("fastenlink"));
            for (at, name) in own.into_iter().chain(elements.map(|child| (child, "id"))) {
                match id(at, name).and_then(|key| self.links.get(&key)) {
                    Some(&part) => self.drawing.attach(connector.point, part),
                    None => self.remark(at, words().import_fastened_to_nothing()),
                }
            }
            if is_given(node, "fastenconnector") {
                self.remark(node, words().import_fastened_to_connector());
            }
        }
    }

    /// Remarks upon connectors that no link has and that slide in no slot.
    fn loose_connectors(&mut self, root: Node<'d, 'd>) {
        let links = self.drawing.links.iter().flat_map(|link| &link.points);
        let mut held: HashSet<usize> = links.chain(&self.drawing.ground).copied().collect();
        held.extend(self.drawing.slides.iter().map(|slide| match slide.slider {
            DrawnSlider::Pin(point) | DrawnSlider::Link { at: point, .. } => point,
        }));
        for node in children(root, false) {
            let connector = id(node, "id").and_then(|key| self.connectors.get(&key));
            if connector.is_some_and(|connector| !held.contains(&connector.point)) {
                self.remark(node, words().import_loose_connector());
            }
        }
    }

    /// Reads the sliding connectors.
    fn sliders(&mut self, root: Node<'d, 'd>) {
        for node in children(root, false) {
            if !is_true(node, "slider") {
                if let Some(end) = node
                    .children()
                    .find(|child| child.has_tag_name("slidelimit"))
                {
                    self.remark(end, words().import_ends_without_slot());
                }
                continue;
            }
            let Some(&Connector { point: pin, .. }) =
                id(node, "id").and_then(|key| self.connectors.get(&key))
            else {
                continue;
            };
            let limits = node
                .children()
                .filter(|child| child.has_tag_name("slidelimit"));
            let limits: Vec<Option<usize>> = limits
                .map(|child| Some(self.connectors.get(&id(child, "id")?)?.point))
                .collect();
            if limits.len() > 2 {
                self.remark(node, words().import_further_ends());
            }
            let [Some(one), Some(other), ..] = limits[..] else {
                self.remark(node, words().import_slot_without_ends());
                continue;
            };
            if self.drawing.distance(one, other) == 0.0 {
                self.remark(node, words().import_slot_without_ends());
                continue;
            }
            let Some(on) = self.carrier(one, other) else {
                self.remark(node, words().import_slot_on_nothing());
                continue;
            };
            let radius = self.length(node, "slideradius").unwrap_or(0.0);
            match radius == 0.0 {
                true => {
                    let travel = self.travel(node, pin, [one, other]);
                    let angle = self.drawing.direction(one, other);
                    self.drawing.slides.push(DrawnSlide {
                        through: Some(one),
                        travel,
                        ..DrawnSlide::new(DrawnSlider::Pin(pin), on, angle)
                    });
                }
                false => self.arc(node, pin, [one, other], on, radius.abs()),
            }
        }
    }

    /// Returns how far a pin can move in its slot. Remarks upon a pin drawn beyond an end.
    fn travel(
        &mut self,
        node: Node<'_, '_>,
        pin: usize,
        [one, other]: [usize; 2],
    ) -> Option<[f64; 2]> {
        let points = &self.drawing.points;
        let [dx, dy] = difference(points[other].at, points[one].at);
        let length = dx.hypot(dy);
        let [px, py] = difference(points[pin].at, points[one].at);
        let at = (px * dx + py * dy) / length;
        let travel = opened_travel([-at, length - at], AT_END * length);
        if travel.is_none() {
            self.remark(node, words().import_beyond_slot());
        }
        travel
    }

    /// Returns the part that has both ends of a slot.
    fn carrier(&self, one: usize, other: usize) -> Option<DrawnPart> {
        let ground = &self.drawing.ground;
        if ground.contains(&one) && ground.contains(&other) {
            return Some(DrawnPart::Frame);
        }
        let holders = |point: usize| -> Vec<DrawnPart> {
            let links = self.drawing.links.iter().enumerate();
            let links = links.filter(|(_, link)| link.points.contains(&point));
            let fixed = ground.contains(&point).then_some(DrawnPart::Frame);
            links
                .map(|(link, _)| DrawnPart::Link(link))
                .chain(fixed)
                .collect()
        };
        let (first, second) = (holders(one), holders(other));
        let both = first.iter().find(|part| second.contains(part));
        both.copied().or_else(|| {
            let mut first = first.iter().copied();
            first.find(|&part| self.fastened(part).iter().any(|part| second.contains(part)))
        })
    }

    /// Returns all parts that are fastened to a part, directly or by others.
    fn fastened(&self, part: DrawnPart) -> Vec<DrawnPart> {
        let mut found = vec![part];
        let mut next = 0;
        while let Some(&part) = found.get(next) {
            for [one, other] in &self.drawing.welds {
                for (from, to) in [(*one, *other), (*other, *one)] {
                    if from == part && !found.contains(&to) {
                        found.push(to);
                    }
                }
            }
            next += 1;
        }
        found
    }

    /// Adds the bar from the centre of an arc slot to its pin.
    fn arc(
        &mut self,
        node: Node<'_, '_>,
        pin: usize,
        ends: [usize; 2],
        on: DrawnPart,
        radius: f64,
    ) {
        let [one, other] = ends.map(|end| self.drawing.points[end].at);
        let [dx, dy] = difference(other, one);
        let half = 0.5 * dx.hypot(dy);
        // A half circle is drawn with a rounded radius.
        if radius < half * (1.0 - ON_ARC) {
            self.remark(node, words().import_radius_too_small());
        }
        let radius = radius.max(half);
        let height = (radius.powi(2) - half.powi(2)).max(0.0).sqrt();
        let share = 0.5 * height / half;
        let at = self.drawing.points[pin].at;
        let centres = [1.0, -1.0].map(|side: f64| {
            let centre = [
                one[0] + 0.5 * dx - side * share * dy,
                one[1] + 0.5 * dy + side * share * dx,
            ];
            let [x, y] = difference(at, centre);
            (centre, (x.hypot(y) - radius).abs())
        });
        // The pin is on one of the two arcs.
        let [left, right] = centres;
        let (centre, off) = if right.1 < left.1 { right } else { left };
        if off > ON_ARC * radius {
            self.remark(node, &words().import_pin_beside_arc(off));
        }
        let name = self.drawing.points[pin].name.clone();
        let named = |suffix: &str| name.as_ref().map(|name| format!("{name}-{suffix}"));
        let point = self.drawing.point(named("centre"), centre);
        self.drawing.attach(point, on);
        let bar = self.drawing.link(named("slot"));
        self.drawing.attach(point, DrawnPart::Link(bar));
        self.drawing.attach(pin, DrawnPart::Link(bar));
        let opening = self.drawing.direction(point, pin);
        // The slot is the shorter arc between its ends.
        let turns = ends.map(|end| wrapped(self.drawing.direction(point, end) - opening));
        let turns = [turns[0].min(turns[1]), turns[0].max(turns[1])];
        match opened_travel(turns, (AT_END * half / radius).to_degrees()) {
            Some(travel) => self.drawing.angle_limits.push(DrawnAngleLimit {
                link: bar,
                from: on,
                travel,
            }),
            None => self.remark(node, words().import_beyond_slot()),
        }
    }

    /// Remarks upon ratios of gears and chains.
    fn ratios(&mut self, root: Node<'d, 'd>) {
        let ratios = root.children().filter(|node| node.has_tag_name("ratios"));
        for node in ratios.flat_map(|node| node.children()) {
            if node.has_tag_name("ratio") {
                let text = match node.attribute("type") {
                    Some("gears") => words().import_gears(),
                    _ => words().import_chain(),
                };
                self.remark(node, text);
            }
        }
    }

    /// Collects the inputs: the turning ones first, in the order of the file. All links on a
    /// turning connector turn with it.
    fn inputs(&mut self) {
        let mut inputs = Vec::new();
        for input in std::mem::take(&mut self.inputs) {
            let links = self.drawing.links.iter().enumerate();
            let turned: Vec<usize> = links
                .filter(|(_, link)| link.points.contains(&input.point))
                .filter(|(_, link)| {
                    let fixed = |point: &&usize| self.drawing.ground.contains(point);
                    link.points.iter().filter(fixed).count() == 1
                })
                .filter(|(link, _)| !self.is_barrel(*link))
                .map(|(link, _)| link)
                .collect();
            let [first, others @ ..] = turned.as_slice() else {
                self.drawing
                    .remark(&input.place, words().import_input_turns_nothing());
                continue;
            };
            for &other in others {
                self.drawing
                    .welds
                    .push([DrawnPart::Link(*first), DrawnPart::Link(other)]);
            }
            self.drawing.links[*first].is_needed = true;
            // A positive speed is clockwise in the file.
            let law = match input.rpm {
                Some(rpm) => DrawnLaw::Speed(0.0 - rpm, "rpm"),
                None => DrawnLaw::Unknown,
            };
            let sign = if input.rpm.is_some_and(|rpm| rpm > 0.0) {
                -1.0
            } else {
                1.0
            };
            let range = input.limit.map(|limit| {
                let end = sign * limit;
                [end.min(0.0), end.max(0.0)]
            });
            inputs.push(DrawnInput {
                element: InputElement::Turn {
                    link: *first,
                    from: DrawnPart::Frame,
                },
                law,
                range,
                place: input.place,
            });
        }
        // A standing input cannot lead the others.
        inputs.sort_by_key(|input| input.law == DrawnLaw::Speed(0.0, "rpm"));
        inputs.append(&mut self.rods);
        if inputs.is_empty() {
            self.drawing.remark("", words().import_no_input());
        }
        self.drawing.inputs = inputs;
    }

    fn is_barrel(&self, link: usize) -> bool {
        self.rods.iter().any(|rod| match rod.element {
            InputElement::Slide(slide) => self.drawing.slides[slide].on == DrawnPart::Link(link),
            InputElement::Turn { .. } => false,
        })
    }
}
