//! Reduces a drawing to what a scene can say: parts that move as one become one link, blocks become
//! pins in slots, and elements without effect are left out.

use super::drawing::{
    Drawing, DrawnAngleLimit, DrawnInput, DrawnLink, DrawnPart, DrawnSlide, DrawnSlider,
    InputElement, both_travels, common_travel, difference, reversed_travel,
};
use crate::wording::words;
use std::collections::{BTreeSet, HashMap};

/// Two points nearer than this fraction of the drawing's size are at the same place.
const EQUALITY_TOLERANCE: f64 = 1e-9;
/// A pin within this fraction of the drawing's size is on the guide of another pin: files have six
/// decimals.
const ON_GUIDE: f64 = 1e-6;
/// A pin farther from its slot than this fraction of the size is remarked upon.
const BESIDE: f64 = 1e-3;

/// Simplifies a drawing in place.
pub(super) fn settle(drawing: &mut Drawing) {
    let size = drawing.size();
    join_coincident_joints(drawing);
    join_repeated_joints(drawing);
    let is_fixed = |slide: &DrawnSlide| slide.on == DrawnPart::Frame;
    if drawing.ground.is_empty() && !drawing.slides.iter().any(is_fixed) {
        drawing.remark("", words().import_no_ground());
    }
    weld(drawing, size);
    drop_idle_inputs(drawing);
    turn_blocks_into_pins(drawing, size);
    join_pins_of_one_guide(drawing, size);
    seat_fixed_pins(drawing);
    leave_out_idle_links(drawing, size);
    limit_further_inputs(drawing);
}

/// Joins the points of links whose points are all at one place, as such a link does. Its length of
/// zero would decide by rounding whether the scene opens.
fn join_coincident_joints(drawing: &mut Drawing) {
    // The point that replaces each point.
    let mut leaders: Vec<usize> = (0..drawing.points.len()).collect();
    for link in 0..drawing.links.len() {
        let drawn = &drawing.links[link];
        let [first, others @ ..] = drawn.points.as_slice() else {
            continue;
        };
        let is_at_one_place = others
            .iter()
            .all(|&other| drawing.distance(*first, other) == 0.0);
        if others.is_empty() || !is_at_one_place {
            continue;
        }
        let name = link_name(drawing, link);
        let is_welded = drawing
            .welds
            .iter()
            .any(|pair| pair.contains(&DrawnPart::Link(link)));
        let is_kept = drawn.is_needed
            || drawn.mass.is_some()
            || is_welded
            || is_used(drawing, link, usize::MAX);
        if is_kept {
            // A block is at one place; a crank or a body usually is not.
            if drawn.is_needed || drawn.mass.is_some() {
                let text = words().import_zero_link(&name);
                drawing.remark("", &text);
            }
            continue;
        }
        for &other in others {
            let ends = [*first, other].map(|point| leader_of(&leaders, point));
            leaders[ends[0].max(ends[1])] = ends[0].min(ends[1]);
        }
        drawing.links[link] = DrawnLink::default();
        let text = words().import_joined_points(&name);
        drawing.remark("", &text);
    }
    replace_points(drawing, &leaders);
}

/// Joins joints of the same two parts at the same place: the second one says nothing new.
fn join_repeated_joints(drawing: &mut Drawing) {
    let parts = parts_at(drawing);
    let mut first_at: HashMap<[u64; 2], Vec<usize>> = HashMap::new();
    let mut leaders: Vec<usize> = (0..drawing.points.len()).collect();
    for (point, own) in parts.iter().enumerate() {
        // Adding 0 makes both zeros equal.
        let place = drawing.points[point].at.map(|x| (x + 0.0).to_bits());
        let known = first_at.entry(place).or_default();
        let is_same = |&&other: &&usize| {
            let shared = own.iter().filter(|part| parts[other].contains(part));
            shared.count() > 1
        };
        match known.iter().find(is_same) {
            Some(&other) => {
                leaders[point] = other;
                let [x, y] = drawing.points[point].at;
                let text = words().import_repeated_joint(x, y);
                drawing.remark("", &text);
            }
            None => known.push(point),
        }
    }
    replace_points(drawing, &leaders);
}

/// Returns the point that replaces a point.
fn leader_of(leaders: &[usize], mut point: usize) -> usize {
    while leaders[point] != point {
        point = leaders[point];
    }
    point
}

/// Replaces every point by its leader.
fn replace_points(drawing: &mut Drawing, leaders: &[usize]) {
    if leaders.iter().enumerate().all(|(point, &to)| point == to) {
        return;
    }
    let join = |points: &mut Vec<usize>| {
        let mut seen = BTreeSet::new();
        for point in points.iter_mut() {
            *point = leader_of(leaders, *point);
        }
        points.retain(|&point| seen.insert(point));
    };
    join(&mut drawing.ground);
    for link in &mut drawing.links {
        join(&mut link.points);
    }
    for slide in &mut drawing.slides {
        match &mut slide.slider {
            DrawnSlider::Pin(point) | DrawnSlider::Link { at: point, .. } => {
                *point = leader_of(leaders, *point);
            }
        }
        slide.through = slide.through.map(|point| leader_of(leaders, point));
    }
    for load in &mut drawing.loads {
        load.point = leader_of(leaders, load.point);
    }
}

/// Returns the name by which remarks call a link.
fn link_name(drawing: &Drawing, link: usize) -> String {
    let drawn = &drawing.links[link];
    let at = drawn.points.first().map(|&point| drawing.points[point].at);
    let place = || at.map_or(String::new(), |[x, y]| format!("({x}, {y})"));
    drawn.name.clone().unwrap_or_else(place)
}

/// Turns the ranges of all inputs but the driver into limits of their elements, and leaves out
/// limits between which nothing moves.
fn limit_further_inputs(drawing: &mut Drawing) {
    for input in drawing.inputs.iter_mut().skip(1) {
        let Some(travel) = input.range.take() else {
            continue;
        };
        match input.element {
            InputElement::Slide(slide) => {
                let slide = &mut drawing.slides[slide];
                slide.travel = both_travels(slide.travel, Some(travel));
            }
            InputElement::Turn { link, from } => {
                drawing
                    .angle_limits
                    .push(DrawnAngleLimit { link, from, travel });
            }
        }
    }
    let mut kept: Vec<DrawnAngleLimit> = Vec::new();
    for limit in std::mem::take(&mut drawing.angle_limits) {
        let mut same = kept
            .iter_mut()
            .filter(|kept| kept.link == limit.link && kept.from == limit.from);
        match same.next() {
            Some(same) => same.travel = common_travel(same.travel, limit.travel),
            None => kept.push(limit),
        }
    }
    let remarks = &mut drawing.remarks;
    kept.retain(|limit| {
        let [low, high] = limit.travel;
        // An angle over whole turns has no stops.
        let is_limit = low < high && high - low < 360.0;
        if !is_limit {
            remarks.add("", words().import_no_limits());
        }
        is_limit
    });
    drawing.angle_limits = kept;
    for slide in &mut drawing.slides {
        if slide.travel.is_some_and(|[low, high]| !(low < high)) {
            slide.travel = None;
            remarks.add("", words().import_no_limits());
        }
    }
}

/// Sets of parts that move as one.
struct WeldGroups {
    /// The parent of each part; the frame is 0, and link i is i + 1.
    parents: Vec<usize>,
}

fn index(part: DrawnPart) -> usize {
    match part {
        DrawnPart::Frame => 0,
        DrawnPart::Link(link) => link + 1,
    }
}

impl WeldGroups {
    fn root(&mut self, part: usize) -> usize {
        let mut root = part;
        while self.parents[root] != root {
            root = self.parents[root];
        }
        let mut at = part;
        while self.parents[at] != root {
            at = std::mem::replace(&mut self.parents[at], root);
        }
        root
    }

    /// Joins two parts; returns `true` if they were apart. The smaller index leads.
    fn join(&mut self, one: usize, other: usize) -> bool {
        let (one, other) = (self.root(one), self.root(other));
        self.parents[one.max(other)] = one.min(other);
        one != other
    }
}

/// Joins the parts that the file fastens to each other, and those that share two places.
fn weld(drawing: &mut Drawing, size: f64) {
    let count = drawing.links.len() + 1;
    let mut groups = WeldGroups {
        parents: (0..count).collect(),
    };
    for [one, other] in std::mem::take(&mut drawing.welds) {
        groups.join(index(one), index(other));
    }
    // A link that an actuator lengthens is not rigid, so that its barrel has one point only.
    loop {
        let mut at_point: Vec<BTreeSet<usize>> = vec![BTreeSet::new(); drawing.points.len()];
        for &point in &drawing.ground {
            at_point[point].insert(0);
        }
        for (link, drawn) in drawing.links.iter().enumerate() {
            let root = groups.root(link + 1);
            for &point in &drawn.points {
                at_point[point].insert(root);
            }
        }
        let mut shared: HashMap<[usize; 2], usize> = HashMap::new();
        let mut joined = false;
        for (point, parts) in at_point.iter().enumerate() {
            let parts: Vec<usize> = parts.iter().copied().collect();
            for (i, &one) in parts.iter().enumerate() {
                for &other in &parts[i + 1..] {
                    let first = *shared.entry([one, other]).or_insert(point);
                    if drawing.distance(first, point) > EQUALITY_TOLERANCE * size {
                        joined |= groups.join(one, other);
                    }
                }
            }
        }
        if !joined {
            break;
        }
    }
    rename_parts(drawing, |part| groups.root(part));
}

/// Replaces every part by its leader, and moves all points to it.
fn rename_parts(drawing: &mut Drawing, mut leader: impl FnMut(usize) -> usize) {
    let mut part_of = |part: DrawnPart| match leader(index(part)) {
        0 => DrawnPart::Frame,
        link => DrawnPart::Link(link - 1),
    };
    for link in 0..drawing.links.len() {
        let to = part_of(DrawnPart::Link(link));
        if to == DrawnPart::Link(link) {
            continue;
        }
        let points = std::mem::take(&mut drawing.links[link].points);
        let mass = drawing.links[link].mass.take();
        for point in points {
            drawing.attach(point, to);
        }
        if let DrawnPart::Link(to) = to {
            let is_needed = drawing.links[link].is_needed;
            let link = &mut drawing.links[to];
            link.is_needed |= is_needed;
            let unit = drawing.unit.unwrap_or_default();
            link.mass = match (link.mass, mass) {
                (Some(one), Some(other)) => Some(one.with(other, unit)),
                (one, other) => one.or(other),
            };
        }
    }
    let mut slides = std::mem::take(&mut drawing.slides);
    for slide in &mut slides {
        slide.on = part_of(slide.on);
        if let DrawnSlider::Link { link, at } = slide.slider {
            slide.slider = match (part_of(DrawnPart::Link(link)), slide.on) {
                (DrawnPart::Link(link), _) => DrawnSlider::Link { link, at },
                // What carries the guide slides on what is fixed: the same motion.
                (DrawnPart::Frame, DrawnPart::Link(on)) => {
                    slide.on = DrawnPart::Frame;
                    DrawnSlider::Link { link: on, at }
                }
                (DrawnPart::Frame, DrawnPart::Frame) => DrawnSlider::Pin(at),
            };
        }
    }
    drawing.slides = slides;
    let mut inputs = std::mem::take(&mut drawing.inputs);
    inputs.retain_mut(|input| {
        let InputElement::Turn { link, from } = input.element else {
            return true;
        };
        let from = part_of(from);
        match part_of(DrawnPart::Link(link)) {
            to if to == from => {
                drawing.remark(&input.place, words().import_input_is_fixed());
                false
            }
            DrawnPart::Link(link) => {
                input.element = InputElement::Turn { link, from };
                true
            }
            DrawnPart::Frame => match from {
                DrawnPart::Link(link) => {
                    input.element = InputElement::Turn {
                        link,
                        from: DrawnPart::Frame,
                    };
                    true
                }
                DrawnPart::Frame => false,
            },
        }
    });
    drawing.inputs = inputs;
    drawing.angle_limits.retain_mut(|limit| {
        limit.from = part_of(limit.from);
        match part_of(DrawnPart::Link(limit.link)) {
            to if to == limit.from => false,
            DrawnPart::Link(link) => {
                limit.link = link;
                true
            }
            // The carrier turns about a fixed bar, in the opposite sense.
            DrawnPart::Frame => match limit.from {
                DrawnPart::Link(link) => {
                    *limit = DrawnAngleLimit {
                        link,
                        from: DrawnPart::Frame,
                        travel: reversed_travel(limit.travel),
                    };
                    true
                }
                DrawnPart::Frame => false,
            },
        }
    });
    for load in &mut drawing.loads {
        load.turns_with = load
            .turns_with
            .and_then(|link| match part_of(DrawnPart::Link(link)) {
                DrawnPart::Link(link) => Some(link),
                DrawnPart::Frame => None,
            });
    }
}

/// Removes inputs of the same element, and slides between one part and itself.
fn drop_idle_inputs(drawing: &mut Drawing) {
    let mut seen = Vec::new();
    let mut inputs = std::mem::take(&mut drawing.inputs);
    inputs.retain(|input| {
        let is_new = !seen.contains(&input.element);
        match is_new {
            true => seen.push(input.element),
            false => drawing.remark(&input.place, words().import_input_twice()),
        }
        is_new
    });
    drawing.inputs = inputs;
    let is_idle = |drawing: &Drawing, slide: &DrawnSlide| match slide.slider {
        DrawnSlider::Pin(point) => has_point(drawing, slide.on, point),
        DrawnSlider::Link { link, .. } => slide.on == DrawnPart::Link(link),
    };
    let idle: Vec<usize> = (0..drawing.slides.len())
        .filter(|&slide| is_idle(drawing, &drawing.slides[slide]))
        .collect();
    for &slide in &idle {
        let name = slide_name(drawing, slide);
        drawing.remark("", &words().import_slide_is_fixed(&name));
    }
    remove_slides(drawing, &idle);
}

/// Returns the name by which remarks call a slide.
fn slide_name(drawing: &Drawing, slide: usize) -> String {
    let slide = &drawing.slides[slide];
    let at = match slide.slider {
        DrawnSlider::Pin(point) | DrawnSlider::Link { at: point, .. } => point,
    };
    let named = slide
        .name
        .clone()
        .or_else(|| drawing.points[at].name.clone());
    named.unwrap_or_else(|| {
        let [x, y] = drawing.points[at].at;
        format!("({x}, {y})")
    })
}

fn has_point(drawing: &Drawing, part: DrawnPart, point: usize) -> bool {
    match part {
        DrawnPart::Frame => drawing.ground.contains(&point),
        DrawnPart::Link(link) => drawing.links[link].points.contains(&point),
    }
}

/// Removes slides, given in ascending order, together with their inputs.
fn remove_slides(drawing: &mut Drawing, idle: &[usize]) {
    if idle.is_empty() {
        return;
    }
    let mut kept = 0;
    let places: Vec<Option<usize>> = (0..drawing.slides.len())
        .map(|slide| {
            let place = idle.binary_search(&slide).is_err().then_some(kept);
            kept += usize::from(place.is_some());
            place
        })
        .collect();
    let mut slides = std::mem::take(&mut drawing.slides).into_iter().enumerate();
    drawing.slides = slides
        .by_ref()
        .filter(|(slide, _)| places[*slide].is_some())
        .map(|(_, slide)| slide)
        .collect();
    drawing.inputs.retain_mut(|input| match input.element {
        InputElement::Slide(slide) => match places[slide] {
            Some(place) => {
                input.element = InputElement::Slide(place);
                true
            }
            None => false,
        },
        InputElement::Turn { .. } => true,
    });
}

/// Turns a sliding link whose points are all at one place into a pin in a slot.
fn turn_blocks_into_pins(drawing: &mut Drawing, size: f64) {
    let holders = holders(drawing);
    for slide in 0..drawing.slides.len() {
        let DrawnSlider::Link { link, at } = drawing.slides[slide].slider else {
            continue;
        };
        let block = &drawing.links[link];
        let is_at_one_place = block
            .points
            .iter()
            .all(|&point| drawing.distance(at, point) <= EQUALITY_TOLERANCE * size);
        let is_pin = |&&point: &&usize| holders[point] > 1;
        let mut pins = block.points.iter().filter(is_pin);
        let (Some(&pin), None) = (pins.next(), pins.next()) else {
            continue;
        };
        if !is_at_one_place || block.mass.is_some() || is_used(drawing, link, slide) {
            continue;
        }
        let block = std::mem::take(&mut drawing.links[link]);
        let slide = &mut drawing.slides[slide];
        slide.slider = DrawnSlider::Pin(pin);
        // The block's name is free now.
        slide.name = block.name.or(slide.name.take());
        if pin != at && drawing.points[pin].name.is_none() {
            drawing.points[pin].name = drawing.points[at].name.take();
        }
    }
}

/// Returns the number of parts that hold each point.
fn holders(drawing: &Drawing) -> Vec<usize> {
    let mut holders = vec![0; drawing.points.len()];
    let links = drawing.links.iter().flat_map(|link| &link.points);
    for &point in links.chain(&drawing.ground) {
        holders[point] += 1;
    }
    holders
}

/// Returns `true` if an input, a load or another slide needs the link.
fn is_used(drawing: &Drawing, link: usize, but: usize) -> bool {
    let part = DrawnPart::Link(link);
    let slides = drawing.slides.iter().enumerate();
    let mut others = slides
        .filter(|&(slide, _)| slide != but)
        .map(|(_, slide)| slide);
    let turns = |input: &DrawnInput| match input.element {
        InputElement::Turn { link: turned, from } => turned == link || from == part,
        InputElement::Slide(_) => false,
    };
    drawing.inputs.iter().any(turns)
        || drawing
            .loads
            .iter()
            .any(|load| load.turns_with == Some(link))
        || others.any(|slide| {
            let slides_itself =
                matches!(slide.slider, DrawnSlider::Link { link: sliding, .. } if sliding == link);
            slide.on == part || slides_itself
        })
}

/// Turns two pins of one part in one straight guide into a part that slides without turning, and
/// removes further pins in that guide, which change nothing.
fn join_pins_of_one_guide(drawing: &mut Drawing, size: f64) {
    let parts_at = parts_at(drawing);
    let driven: Vec<usize> = drawing
        .inputs
        .iter()
        .filter_map(|input| match input.element {
            InputElement::Slide(slide) => Some(slide),
            InputElement::Turn { .. } => None,
        })
        .collect();
    // The first slide of each pair of a carrier and a sliding part.
    let mut firsts: HashMap<[DrawnPart; 2], Vec<usize>> = HashMap::new();
    let mut idle = Vec::new();
    for slide in 0..drawing.slides.len() {
        let (DrawnSlider::Pin(pin), on) = (drawing.slides[slide].slider, drawing.slides[slide].on)
        else {
            continue;
        };
        let angle = drawing.slides[slide].angle;
        let found = parts_at[pin].iter().find_map(|&part| {
            let known = firsts.get(&[on, part])?;
            let first = known.iter().copied().find(|&first| {
                let known = &drawing.slides[first];
                let at = match known.slider {
                    DrawnSlider::Pin(at) | DrawnSlider::Link { at, .. } => at,
                };
                let [dx, dy] = difference(drawing.points[pin].at, drawing.points[at].at);
                let (sin, cos) = known.angle.to_radians().sin_cos();
                let turned = (angle - known.angle).to_radians().sin().abs();
                (dx * sin - dy * cos).abs() <= ON_GUIDE * size
                    && dx.hypot(dy) > EQUALITY_TOLERANCE * size
                    && turned <= ON_GUIDE
            })?;
            Some((part, first))
        });
        match found {
            Some((part, first)) if !driven.contains(&slide) => {
                if let DrawnSlider::Pin(at) = drawing.slides[first].slider {
                    let slides = match (part, on) {
                        (DrawnPart::Link(link), _) => Some((link, on)),
                        (DrawnPart::Frame, DrawnPart::Link(link)) => Some((link, DrawnPart::Frame)),
                        (DrawnPart::Frame, DrawnPart::Frame) => None,
                    };
                    if let Some((link, on)) = slides {
                        let known = &mut drawing.slides[first];
                        if known.on != on {
                            // The guide moves along the fixed pins.
                            known.travel = known.travel.map(reversed_travel);
                        }
                        known.slider = DrawnSlider::Link { link, at };
                        known.on = on;
                        drawing.links[link].is_needed = true;
                    }
                }
                // The part is as free as its least free pin.
                let travel = drawing.slides[slide].travel;
                let is_opposite = (angle - drawing.slides[first].angle).to_radians().cos() < 0.0;
                let moves_guide = drawing.slides[first].on != on;
                let travel = match is_opposite != moves_guide {
                    true => travel.map(reversed_travel),
                    false => travel,
                };
                drawing.slides[first].travel = both_travels(drawing.slides[first].travel, travel);
                idle.push(slide);
            }
            _ => {
                for &part in &parts_at[pin] {
                    firsts.entry([on, part]).or_default().push(slide);
                }
            }
        }
    }
    remove_slides(drawing, &idle);
}

/// Returns the parts that hold each point.
fn parts_at(drawing: &Drawing) -> Vec<Vec<DrawnPart>> {
    let mut parts = vec![Vec::new(); drawing.points.len()];
    for &point in &drawing.ground {
        parts[point].push(DrawnPart::Frame);
    }
    for (link, drawn) in drawing.links.iter().enumerate() {
        for &point in &drawn.points {
            parts[point].push(DrawnPart::Link(link));
        }
    }
    parts
}

/// Adds a block on each fixed pin in the slot of a link: the link slides on the block, which turns
/// about the pin.
fn seat_fixed_pins(drawing: &mut Drawing) {
    for slide in 0..drawing.slides.len() {
        let (DrawnSlider::Pin(pin), DrawnPart::Link(carrier)) =
            (drawing.slides[slide].slider, drawing.slides[slide].on)
        else {
            continue;
        };
        if !drawing.ground.contains(&pin) {
            continue;
        }
        let name = drawing.slides[slide].name.clone();
        let block = drawing.link(name.map(|name| format!("{name}-block")));
        drawing.links[block].is_needed = true;
        drawing.attach(pin, DrawnPart::Link(block));
        drawing.slides[slide].slider = DrawnSlider::Link {
            link: carrier,
            at: pin,
        };
        drawing.slides[slide].on = DrawnPart::Link(block);
        drawing.slides[slide].through = None;
        // The link moves along the pin.
        drawing.slides[slide].travel = drawing.slides[slide].travel.map(reversed_travel);
    }
}

/// Removes links that hold one place only and do nothing else, and remarks upon pins beside their
/// slots.
fn leave_out_idle_links(drawing: &mut Drawing, size: f64) {
    let holders = holders(drawing);
    let slide_pins: BTreeSet<usize> = drawing
        .slides
        .iter()
        .map(|slide| match slide.slider {
            DrawnSlider::Pin(pin) | DrawnSlider::Link { at: pin, .. } => pin,
        })
        .collect();
    for link in 0..drawing.links.len() {
        let drawn = &drawing.links[link];
        let Some(&first) = drawn.points.first() else {
            continue;
        };
        let mut places = drawn.points.iter();
        let is_at_one_place =
            places.all(|&point| drawing.distance(first, point) <= EQUALITY_TOLERANCE * size);
        // Points that coincide are held together by the link.
        let holds = drawn.points.len() > 1 || drawn.mass.is_some();
        if !is_at_one_place || holds || drawn.is_needed || is_used(drawing, link, usize::MAX) {
            continue;
        }
        // The point stays if anything else holds it.
        let is_lost = holders[first] == 1 && !slide_pins.contains(&first);
        let drawn: DrawnLink = std::mem::take(&mut drawing.links[link]);
        if let Some(name) = drawn.name.filter(|_| is_lost) {
            drawing.remark("", &words().import_link_of_one_point(&name));
        }
    }
    for slide in 0..drawing.slides.len() {
        let drawn = &drawing.slides[slide];
        let (DrawnSlider::Pin(pin), Some(through)) = (drawn.slider, drawn.through) else {
            continue;
        };
        let [dx, dy] = difference(drawing.points[pin].at, drawing.points[through].at);
        let (sin, cos) = drawn.angle.to_radians().sin_cos();
        let nearby = (dx * sin - dy * cos).abs();
        if nearby > BESIDE * size {
            let name = slide_name(drawing, slide);
            drawing.remark("", &words().import_pin_beside_slot(&name, nearby));
        }
    }
}
