//! Converts faults of the solver, which contain ids, to diagnostics with names and lines of the
//! scene file.

use crate::angle::TURN;
use crate::scene::{Diagnostic, Diagnostics, Scene, coordinate_key, figure, key};
use crate::solver::{Fault, OpenChoice};
use crate::wording::words;
use crate::{
    Body, ElementId, Input, Limit, LimitId, LimitOf, LinkId, PointId, SlideId, Slider, Vec2,
};

/// Maximum number of elements marked in one message.
const MAX_MARKED_ELEMENTS: usize = 6;

impl Scene {
    /// Explains in terms of the scene file why its mechanism cannot be solved, and suggests fixes.
    #[must_use]
    pub fn explain(&self, fault: &Fault) -> Diagnostics {
        let item = match fault {
            Fault::Mobility { .. } => mobility_fault(self, fault),
            Fault::OverConstrained {
                element,
                others,
                misfit,
                at,
            } => over_constrained(self, *element, others, *misfit, *at),
            Fault::Open { point, links, gap } => open(self, *point, links, *gap),
            Fault::Vague {
                point,
                choices,
                behind: after,
            } => vague(self, *point, choices, after),
            Fault::ChangePoint { group, has_sides } => change_point(self, *group, *has_sides),
            Fault::FastInput { number } => fast_input(self, *number),
            Fault::BeyondStop { limit, value } => beyond_stop(self, *limit, *value),
            Fault::HeldByStops { down, up } => held_by_stops(self, *down, *up),
            Fault::NoChoice { group, found } => no_choice(self, *group, *found),
            Fault::NotAssembled { points, gap } => not_assembled(self, points, *gap),
            Fault::Singular {
                elements,
                is_here_only,
            } => singular(self, elements, *is_here_only),
        };
        self.diagnostics(vec![item])
    }
}

fn mobility_fault(scene: &Scene, fault: &Fault) -> Diagnostic {
    let Fault::Mobility {
        mobility,
        redundant,
        repeating,
        floating,
        is_unclear,
    } = fault
    else {
        return Diagnostic::new(fault.to_string());
    };
    let (mobility, redundant) = (*mobility, *redundant);
    let inputs = scene.mechanism.inputs().count();
    let mut item = Diagnostic::new(if mobility == 0 {
        words().mobility_of_none(inputs)
    } else if mobility < inputs {
        words().mobility_of_few(mobility, inputs)
    } else if mobility == inputs {
        words().mobility_elsewhere(inputs)
    } else {
        words().mobility_of_many(mobility, inputs)
    });
    item = match floating.split_first() {
        None => item.at(scene.place(ElementId::Driver), words().driven_here()),
        Some((&first, rest)) => {
            let label = |link| words().floats(&link_name(scene, link));
            let mut item = item.at(scene.place(ElementId::Link(first)), label(first));
            for &link in rest.iter().take(MAX_MARKED_ELEMENTS - 1) {
                item = item.and(scene.place(ElementId::Link(link)), label(link));
            }
            item.note(words().links_that_float(&link_list(scene, floating)))
        }
    };
    if redundant > 0 {
        let count = words().constraints_repeat(redundant);
        item = item.note(if repeating.is_empty() {
            count
        } else {
            words().among(&count, &element_list(scene, repeating))
        });
    }
    if *is_unclear {
        item = item.note(words().mobility_unclear());
    }
    if mobility == 0 {
        return item.help(words().take_out_a_part());
    }
    for (one, other) in loose_ends(scene, floating) {
        let (name, twin) = (point_name(scene, one), point_name(scene, other));
        item = item
            .and(
                scene.place(ElementId::Point(one)),
                words().named_nowhere_else(),
            )
            .and(
                scene.place(ElementId::Point(other)),
                words().is_this_the_same(),
            )
            .help(words().give_it_one_name(&name, &twin));
    }
    if let Some(help) = parallel_guides(scene, repeating) {
        return item.help(help);
    }
    let more = mobility.saturating_sub(inputs);
    let item = item.help(words().constraints_missing(more.max(1)));
    let item = match more {
        0 => item,
        more => item.help(words().or_further_inputs(more)),
    };
    if redundant == 0 {
        return item;
    }
    item.help(words().are_dimensions_equal())
}

/// Returns the hint for guides that repeat each other's constraints; `None` for fewer than two.
fn parallel_guides(scene: &Scene, elements: &[ElementId]) -> Option<&'static str> {
    let of_slides = elements.iter().filter(|e| matches!(e, ElementId::Slide(_)));
    let all = guides(scene, elements);
    (of_slides.count() >= 2 && all.len() >= 2).then(|| words().turn_a_guide())
}

fn element_list(scene: &Scene, elements: &[ElementId]) -> String {
    let named = elements.iter().take(4 * MAX_MARKED_ELEMENTS);
    let mut names: Vec<String> = named.map(|&e| element_name(scene, e)).collect();
    if elements.len() > names.len() {
        names.push(words().and_more(elements.len() - names.len()));
    }
    names.join(", ")
}

/// Returns points at which a floating link has a free end, each with another moving point whose
/// name differs only in case.
fn loose_ends(scene: &Scene, floating: &[LinkId]) -> Vec<(PointId, PointId)> {
    let mechanism = &scene.mechanism;
    let slid = |point| {
        let mut slides = mechanism.slides().iter();
        slides.any(|slide| slide.slider.point() == point)
    };
    let mut found = Vec::new();
    for &link in floating.iter().take(MAX_MARKED_ELEMENTS) {
        let Some((from, to)) = mechanism.link(link).ends else {
            continue;
        };
        for end in [from, to] {
            let point = mechanism.point(end);
            if point.ground.is_some() || point.links.len() > 1 || slid(end) {
                continue;
            }
            let twin = mechanism.point_ids().find(|&other| {
                let names = (scene.point_name(end), scene.point_name(other));
                other != end && matches!(names, (Some(a), Some(b)) if a.eq_ignore_ascii_case(b))
            });
            let text = |twin: &PointId| found.contains(&(*twin, end));
            found.extend(twin.filter(|t| !text(t)).map(|twin| (end, twin)));
        }
    }
    found
}

fn over_constrained(
    scene: &Scene,
    element: ElementId,
    others: &[ElementId],
    misfit: f64,
    at: f64,
) -> Diagnostic {
    if let ElementId::Link(link) = element
        && let Some(pins) = pinned_twice(scene, link)
    {
        return frame_as_link(scene, link, pins, misfit);
    }
    let name = element_name(scene, element);
    let mut item = Diagnostic::new(words().over_constrained(&name, &length(scene, misfit)))
        .at(scene.place(element), words().holds_what_is_held())
        .note(words().found_at(&coordinate(scene, at)));
    if !others.is_empty() {
        item = item.note(words().the_others_are(&element_list(scene, others)));
    }
    let mut item = item.help(words().correct_its_dimensions());
    let further: Vec<String> = scene
        .mechanism
        .inputs()
        .skip(1)
        .map(|input| format!("`{}`", scene.input_name(input)))
        .collect();
    if !further.is_empty() {
        item = item.help(words().or_drive_fewer(&further.join(", ")));
    }
    // The misfit grows during the motion, so the suggested value is the next power of ten at or
    // above five times its size.
    let accepted = 10.0_f64.powf((GROWTH * misfit).log10().ceil());
    if !accepted.is_finite() || accepted > FEW_DIGITS * longest(scene) {
        return item;
    }
    item.help(words().accept_few_digits(&format!("[redundant]\nmisfit = {accepted:e}")))
}

const GROWTH: f64 = 5.0;
/// Maximum misfit, relative to the longest link, that may come from rounded digits.
const FEW_DIGITS: f64 = 1e-3;

fn longest(scene: &Scene) -> f64 {
    let links = scene.mechanism.links().iter();
    let lengths = links.flat_map(|link| link.members.iter().map(|m| m.local.norm()));
    lengths.fold(0.0, f64::max)
}

/// Returns two points of the ground joined by a link, with their coordinates; `None` if it has
/// fewer.
fn pinned_twice(scene: &Scene, link: LinkId) -> Option<[(PointId, Vec2); 2]> {
    let mechanism = &scene.mechanism;
    let members = mechanism.link(link).members.iter();
    let mut pins = members.filter_map(|m| Some((m.point, mechanism.point(m.point).ground?)));
    Some([pins.next()?, pins.next()?])
}

fn frame_as_link(
    scene: &Scene,
    link: LinkId,
    [(one, at), (other, to)]: [(PointId, Vec2); 2],
    misfit: f64,
) -> Diagnostic {
    let name = link_name(scene, link);
    let (tail, head) = (bare_name(scene, one), bare_name(scene, other));
    let vector = format!("{} = [\"{tail}\", \"{head}\"]", key(scene.link_name(link)));
    let distance = length(scene, (to - at).norm());
    let misfit = length(scene, misfit);
    // A link with two points only can be fixed by its length.
    let ends = scene.mechanism.link(link).ends;
    let is_rod = ends == Some((one, other)) || ends == Some((other, one));
    // All digits are shown, because a rounded length would not fit either.
    let fix = is_rod.then(|| words().frame_fits_with(&(to - at).norm().to_string()));
    let fault = Diagnostic::new(words().frame_does_not_fit(&name, &misfit, &tail, &head))
        .at(scene.place(ElementId::Link(link)), words().cannot_move())
        .note(words().are_apart(&tail, &head, &distance));
    let fault = match fix {
        Some(fix) => fault.help(fix),
        None => fault,
    };
    fault.help(words().frame_needs_no_link(&vector))
}

fn open(scene: &Scene, point: PointId, links: &[LinkId], gap: f64) -> Diagnostic {
    let name = point_name(scene, point);
    let missing = length(scene, gap);
    let item = Diagnostic::new(words().cannot_close(&name, &missing)).at(
        scene.place(ElementId::Point(point)),
        words().cannot_be_placed(&name),
    );
    let item = links
        .iter()
        .take(MAX_MARKED_ELEMENTS)
        .fold(item, |item, &link| {
            let reach = match scene.mechanism.link(link).ends {
                Some(_) => words().has_to_reach_it(&link_name(scene, link)),
                None => words().has_to_meet_it(&link_name(scene, link)),
            };
            item.and(scene.place(ElementId::Link(link)), reach)
        });
    let driver = scene.mechanism.driver();
    item.note(words().driver_stands_at(&coordinate(scene, driver.start)))
        .help(words().change_a_length())
}

fn vague(scene: &Scene, point: PointId, choices: &[Vec2], after: &[OpenChoice]) -> Diagnostic {
    let name = point_name(scene, point);
    let places: Vec<String> = choices.iter().map(|&c| pair(c, "(", ")")).collect();
    let places = words().either(&places);
    let mut expected = words().start_is_vague(&name, &places, scene.unit.symbol());
    if !after.is_empty() {
        let shown = after.iter().take(4 * MAX_MARKED_ELEMENTS);
        let mut names: Vec<String> = shown.map(|open| point_name(scene, open.point)).collect();
        if after.len() > names.len() {
            names.push(words().and_more(after.len() - names.len()));
        }
        expected.push_str(&words().open_as_well(&names));
    }
    let mut item = Diagnostic::new(expected).at(
        scene.place(ElementId::Point(point)),
        words().where_is(&name),
    );
    for open in after.iter().take(MAX_MARKED_ELEMENTS - 1) {
        let span = scene.place(ElementId::Point(open.point));
        item = item.and(span, words().where_is(&point_name(scene, open.point)));
    }
    let given = scene.mechanism.start().iter().find(|(p, _)| *p == point);
    let item = match given {
        Some(&(_, near)) => item.note(words().start_is_between(&name, &pair(near, "(", ")"))),
        None => item,
    };
    if after.is_empty() {
        return item.help(words().give_one_position(&start_lines(scene, point, choices)));
    }
    let own = start_lines(scene, point, choices);
    let others = after.iter().take(4 * MAX_MARKED_ELEMENTS);
    let others = others.map(|open| start_lines(scene, open.point, &open.choices));
    let all: Vec<String> = std::iter::once(own)
        .chain(others)
        .map(|lines| words().one_of_lines(&lines))
        .collect();
    item.help(words().give_a_position_each(&all.join("\n")))
}

/// Returns the lines of `[start]` that select each of a point's places.
fn start_lines(scene: &Scene, point: PointId, choices: &[Vec2]) -> Vec<String> {
    let plain = bare_name(scene, point);
    let key = key(&plain);
    let line = |&c: &Vec2| format!("{key} = {}", pair(c, "[", "]"));
    choices.iter().map(line).collect()
}

fn change_point(scene: &Scene, group: ElementId, has_sides: bool) -> Diagnostic {
    let name = element_name(scene, group);
    let option = |sign| format!("`--assembly {}={sign}`", group_text(scene, group));
    let coordinate = coordinate_key(&scene.mechanism);
    let item = Diagnostic::new(words().opens_at_change_point(&name))
        .at(scene.place(group), words().which_way());
    if has_sides {
        item.help(words().choose_the_side(&option('+'), &option('-')))
            .help(words().open_at_another(coordinate))
    } else {
        item.help(words().open_elsewhere_in_motion())
    }
}

fn fast_input(scene: &Scene, number: usize) -> Diagnostic {
    let timed = number.checked_sub(1);
    let timed = timed.and_then(|index| scene.mechanism.timed().get(index));
    let element = timed.map_or(ElementId::Driver, |timed| match timed.input {
        Input::Turn(link) => ElementId::Link(link),
        Input::Push(slide) => ElementId::Slide(slide),
    });
    Diagnostic::new(words().input_too_fast(&element_name(scene, element)))
        .at(scene.place(element), words().too_fast_to_follow())
        .help(words().drive_the_fast_input())
}

fn beyond_stop(scene: &Scene, limit: LimitId, value: f64) -> Diagnostic {
    let Limit { of, low, high } = *scene.mechanism.limit(limit);
    let counts_in_degrees = match of {
        LimitOf::Driver | LimitOf::Table(_) => {
            matches!(scene.mechanism.driver().input, Input::Turn(_))
        }
        LimitOf::Slide(_) => false,
        LimitOf::Angle { .. } => true,
    };
    let text = |value: f64| match counts_in_degrees {
        true => words().degrees(&figure(value)),
        false => length(scene, value),
    };
    // Stops are compared in the turn next to them. For stops within the first turn the angle is
    // shown as in tables, from 0 to below 360 deg.
    let turn = 0.0..=TURN;
    let is_of_tables =
        matches!(of, LimitOf::Angle { .. }) && turn.contains(&low) && turn.contains(&high);
    let value = match is_of_tables {
        true => value.rem_euclid(TURN),
        false => value,
    };
    let name = format!("`{}`", scene.limit_name(limit));
    let coordinate = coordinate_key(&scene.mechanism);
    if let LimitOf::Table(_) = of {
        let [value, low, high] = [value, low, high].map(text);
        return Diagnostic::new(words().opens_beyond_table(&name, &value, &low, &high))
            .at(scene.limit_place(limit), words().not_in_the_table())
            .help(words().open_within_table(coordinate));
    }
    Diagnostic::new(words().opens_beyond_stop(&name, &text(value), &text(low), &text(high)))
        .at(scene.limit_place(limit), words().is_passed_at_opening())
        .note(words().driver_stands_at(&self::coordinate(scene, scene.mechanism.driver().start)))
        .help(words().open_between_stops(coordinate))
}

fn held_by_stops(scene: &Scene, down: LimitId, up: LimitId) -> Diagnostic {
    let [one, other] = [down, up].map(|limit| format!("`{}`", scene.limit_name(limit)));
    let coordinate = coordinate_key(&scene.mechanism);
    Diagnostic::new(words().held_by_stops(&one, &other))
        .at(scene.limit_place(down), words().no_way_down())
        .and(scene.limit_place(up), words().no_way_up())
        .help(words().open_between_stops(coordinate))
}

/// Returns the name of a group on the command line.
fn group_text(scene: &Scene, group: ElementId) -> String {
    let of_link = |link| scene.link_name(link);
    let of_point = |point| scene.point_name(point);
    let name = match group {
        ElementId::Point(point) => {
            of_point(point).or_else(|| carrier_of_origin(scene, point).map(of_link))
        }
        ElementId::Link(link) => Some(of_link(link)),
        ElementId::Slide(slide) => Some(scene.slide_name(slide)),
        ElementId::Driver => None,
    };
    name.unwrap_or("NAME").to_owned()
}

fn no_choice(scene: &Scene, group: ElementId, found: usize) -> Diagnostic {
    let name = element_name(scene, group);
    let expected = match found {
        0 => words().names_no_choice(&name),
        1 => words().has_one_assembly(&name),
        n => words().has_assemblies(&name, n),
    };
    Diagnostic::new(expected).at(scene.place(group), words().picked_here())
}

fn not_assembled(scene: &Scene, points: &[PointId], gap: f64) -> Diagnostic {
    let names: Vec<String> = points.iter().map(|&p| point_name(scene, p)).collect();
    let (names, gap) = (names.join(", "), length(scene, gap));
    let mut item = Diagnostic::new(words().no_assembly_near(&names, &gap));
    for (i, &point) in points.iter().take(MAX_MARKED_ELEMENTS).enumerate() {
        let span = scene.place(ElementId::Point(point));
        item = if i == 0 {
            item.at(span, words().solved_together())
        } else {
            item.and(span, words().with_this())
        };
    }
    if points.is_empty() {
        item = item.at(scene.place(ElementId::Driver), words().at_this_position());
    }
    let missing: Vec<String> = points
        .iter()
        .filter(|&&p| !scene.mechanism.start().iter().any(|&(s, _)| s == p))
        .filter_map(|&p| scene.point_name(p))
        .map(|name| format!("{} = [x, y]", key(name)))
        .collect();
    let help = if missing.is_empty() {
        words().bring_start_nearer().to_owned()
    } else {
        words().give_positions(&missing.join("\n"))
    };
    item.help(help)
}

fn singular(scene: &Scene, elements: &[ElementId], is_here_only: bool) -> Diagnostic {
    let guides = guides(scene, elements);
    let elements = if guides.len() >= 2 { &guides } else { elements };
    let names: Vec<String> = elements.iter().map(|&e| element_name(scene, e)).collect();
    let names = words().together(&names);
    let mut item = Diagnostic::new(match is_here_only {
        true => words().opens_singular(&names),
        false => words().never_determine(&names),
    });
    for (i, &element) in elements.iter().take(MAX_MARKED_ELEMENTS).enumerate() {
        let span = scene.place(element);
        item = if i == 0 {
            item.at(span, words().leave_a_motion_free())
        } else {
            item.and(span, words().with_this())
        };
    }
    if is_here_only {
        item.help(words().open_elsewhere_in_motion())
    } else if guides.len() >= 2 {
        item.help(words().turn_a_guide())
    } else {
        item.help(words().join_in_another_way())
    }
}

/// Returns the slides among the elements, and those whose slider or guide belongs to one of the
/// elements.
fn guides(scene: &Scene, elements: &[ElementId]) -> Vec<ElementId> {
    let mechanism = &scene.mechanism;
    let takes_part = |id: SlideId| {
        let slide = mechanism.slide(id);
        let sliding = match slide.slider {
            Slider::Pin(point) => ElementId::Point(point),
            Slider::Link { link, .. } => ElementId::Link(link),
        };
        let on = match slide.on {
            Body::Ground => None,
            Body::Link(link) => Some(ElementId::Link(link)),
        };
        let own = [ElementId::Slide(id), sliding];
        own.into_iter().chain(on).any(|e| elements.contains(&e))
    };
    let ids = mechanism.slide_ids().filter(|&id| takes_part(id));
    ids.map(ElementId::Slide).collect()
}

fn point_name(scene: &Scene, point: PointId) -> String {
    match scene.point_name(point) {
        Some(name) => format!("`{name}`"),
        None => match carrier_of_origin(scene, point) {
            Some(link) => words().origin_of(&link_name(scene, link)),
            None => words().a_joint().to_owned(),
        },
    }
}

/// Returns the name as written in the file, for a line that may be copied.
fn bare_name(scene: &Scene, point: PointId) -> String {
    let name = scene.point_name(point).unwrap_or("POINT");
    name.to_owned()
}

/// Returns the sliding link with this hidden origin.
fn carrier_of_origin(scene: &Scene, point: PointId) -> Option<LinkId> {
    let slides = scene.mechanism.slides();
    slides.iter().find_map(|slide| match slide.slider {
        Slider::Link { link, origin, .. } if origin == point => Some(link),
        Slider::Link { .. } | Slider::Pin(_) => None,
    })
}

fn link_name(scene: &Scene, link: LinkId) -> String {
    format!("`{}`", scene.link_name(link))
}

fn link_list(scene: &Scene, links: &[LinkId]) -> String {
    let named = links.iter().take(4 * MAX_MARKED_ELEMENTS);
    let mut names: Vec<String> = named.map(|&link| link_name(scene, link)).collect();
    if links.len() > names.len() {
        names.push(words().and_more(links.len() - names.len()));
    }
    names.join(", ")
}

fn element_name(scene: &Scene, element: ElementId) -> String {
    let slide = |slide: SlideId| words().slide_named(scene.slide_name(slide));
    match element {
        ElementId::Point(point) => point_name(scene, point),
        ElementId::Link(link) => words().a_link(&link_name(scene, link)),
        ElementId::Slide(id) => slide(id),
        ElementId::Driver => words().the_driver().to_owned(),
    }
}

/// Formats a length with its unit. A misfit or gap that could not be computed has no number.
fn length(scene: &Scene, value: f64) -> String {
    match value.is_finite() {
        true => format!("{} {}", figure(value), scene.unit.symbol()),
        false => words().unknown_amount().to_owned(),
    }
}

fn coordinate(scene: &Scene, at: f64) -> String {
    match scene.mechanism.driver().input {
        crate::Input::Turn(_) => words().degrees(&figure(at)),
        crate::Input::Push(_) => length(scene, at),
    }
}

fn pair(at: Vec2, open: &str, close: &str) -> String {
    format!("{open}{}, {}{close}", figure(at.x), figure(at.y))
}

#[cfg(test)]
mod tests;
