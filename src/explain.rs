//! Joins what the solver found wrong, by ids, to names and lines of the scene file.

use crate::scene::{Diagnostic, Diagnostics, Scene, coordinate_key, figure, key};
use crate::solver::Fault;
use crate::{Body, Element, LinkId, PointId, SlideId, Slider, Vec2};

/// Elements that one message points at.
const POINTED_AT: usize = 6;

impl Scene {
    /// Says in the words of the scene file why its mechanism cannot be solved, and what would mend it.
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
            Fault::Vague { point, choices } => vague(self, *point, choices),
            Fault::ChangePoint { group } => change_point(self, *group),
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
    let mut item = Diagnostic::new(match mobility {
        0 => "the mobility is 0, not 1: nothing can move".to_owned(),
        1 => {
            "the mobility is 1, but the driver is held, and other links move without it".to_owned()
        }
        n => format!("the mobility is {n}, not 1: the driver does not determine every link"),
    });
    item = match floating.split_first() {
        None => item.at(scene.place(Element::Driver), "driven here"),
        Some((&first, rest)) => {
            let label = |link| format!("{} floats", link_name(scene, link));
            let mut item = item.at(scene.place(Element::Link(first)), label(first));
            for &link in rest.iter().take(POINTED_AT - 1) {
                item = item.and(scene.place(Element::Link(link)), label(link));
            }
            item.note(format!("links that float: {}", link_list(scene, floating)))
        }
    };
    if redundant > 0 {
        let count = plural(
            redundant,
            "constraint repeats others and holds nothing",
            "constraints repeat others and hold nothing",
        );
        item = item.note(if repeating.is_empty() {
            count
        } else {
            format!("{count}, among {}", element_list(scene, repeating))
        });
    }
    if *is_unclear {
        item = item.note(UNCLEAR);
    }
    if mobility == 0 {
        return item.help("take out a link or a joint: one that holds what should move");
    }
    for (one, other) in loose_ends(scene, floating) {
        let (name, twin) = (point_name(scene, one), point_name(scene, other));
        item = item
            .and(scene.place(Element::Point(one)), "named nowhere else")
            .and(scene.place(Element::Point(other)), "is this the same?")
            .help(format!(
                "if {name} and {twin} are the same point, give it one name"
            ));
    }
    if let Some(help) = parallel_guides(scene, repeating) {
        return item.help(help);
    }
    let missing = plural(mobility.max(2) - 1, "constraint is", "constraints are");
    let item = item.help(format!(
        "{missing} missing: join a floating link to another by a common point, or add a slide"
    ));
    if redundant == 0 {
        return item;
    }
    item.help("what repeats others may be what is missing elsewhere: are its dimensions meant to be equal?")
}

/// Why a rank may be told wrongly.
const UNCLEAR: &str = "this cannot be told for certain: dimensions that differ by rounding alone would hold what seems free";

/// The mend where guides repeat each other.
fn parallel_guides(scene: &Scene, elements: &[Element]) -> Option<&'static str> {
    let of_slides = elements.iter().filter(|e| matches!(e, Element::Slide(_)));
    let all = guides(scene, elements);
    (of_slides.count() >= 2 && all.len() >= 2)
        .then_some("guides that are parallel hold nothing along them: turn one by its `angle`")
}

fn element_list(scene: &Scene, elements: &[Element]) -> String {
    let named = elements.iter().take(4 * POINTED_AT);
    let mut names: Vec<String> = named.map(|&e| element_name(scene, e)).collect();
    if elements.len() > names.len() {
        names.push(format!("and {} more", elements.len() - names.len()));
    }
    names.join(", ")
}

/// Points at which a floating link ends in nothing, each with another moving point whose name differs
/// only in case.
fn loose_ends(scene: &Scene, floating: &[LinkId]) -> Vec<(PointId, PointId)> {
    let mechanism = &scene.mechanism;
    let slid = |point| {
        let mut slides = mechanism.slides().iter();
        slides.any(|slide| slide.slider.point() == point)
    };
    let mut found = Vec::new();
    for &link in floating.iter().take(POINTED_AT) {
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
            let told = |twin: &PointId| found.contains(&(*twin, end));
            found.extend(twin.filter(|t| !told(t)).map(|twin| (end, twin)));
        }
    }
    found
}

fn over_constrained(
    scene: &Scene,
    element: Element,
    others: &[Element],
    misfit: f64,
    at: f64,
) -> Diagnostic {
    if let Element::Link(link) = element
        && let Some(pins) = pinned_twice(scene, link)
    {
        return frame_as_link(scene, link, pins, misfit);
    }
    let name = element_name(scene, element);
    let mut item = Diagnostic::new(format!(
        "over-constrained: with {name} nothing can move, it does not fit the others by {}",
        length(scene, misfit)
    ))
    .at(
        scene.place(element),
        "holds what others hold already, but not equally",
    )
    .note(format!(
        "found with the driver at {}",
        coordinate(scene, at)
    ));
    if !others.is_empty() {
        item = item.note(format!("the others are {}", element_list(scene, others)));
    }
    let item =
        item.help("correct its dimensions so that they agree with the others, or take it out");
    // A misfit grows on the way: what is proposed is a power of ten of at least this many times its size.
    let accepted = 10.0_f64.powf((GROWTH * misfit).log10().ceil());
    if accepted > FEW_DIGITS * longest(scene) {
        return item;
    }
    item.help(format!(
        "or accept what a drawing of few digits leaves:\n[redundant]\nmisfit = {accepted:e}"
    ))
}

const GROWTH: f64 = 5.0;
/// A misfit of up to this part of the longest link may be one of digits.
const FEW_DIGITS: f64 = 1e-3;

fn longest(scene: &Scene) -> f64 {
    let links = scene.mechanism.links().iter();
    let lengths = links.flat_map(|link| link.members.iter().map(|m| m.local.norm()));
    lengths.fold(0.0, f64::max)
}

/// Two points of the ground that a link joins, with their places.
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
    Diagnostic::new(format!(
        "over-constrained: link {name} does not fit by {} between the ground points `{tail}` and `{head}`",
        length(scene, misfit)
    ))
    .at(scene.place(Element::Link(link)), "cannot move")
    .note(format!(
        "`{tail}` and `{head}` are {} apart",
        length(scene, (to - at).norm())
    ))
    .help(format!(
        "the frame needs no link; to see it in the tables, move it to [vectors]: {vector}"
    ))
}

fn open(scene: &Scene, point: PointId, links: &[LinkId], gap: f64) -> Diagnostic {
    let name = point_name(scene, point);
    let missing = length(scene, gap);
    let item = Diagnostic::new(format!(
        "the linkage cannot close at the start: {name} is out of reach by {missing}"
    ))
    .at(
        scene.place(Element::Point(point)),
        format!("{name} cannot be placed"),
    );
    let item = links.iter().take(POINTED_AT).fold(item, |item, &link| {
        let reach = match scene.mechanism.link(link).ends {
            Some(_) => format!("{} has to reach it", link_name(scene, link)),
            None => format!("{} has to meet it", link_name(scene, link)),
        };
        item.and(scene.place(Element::Link(link)), reach)
    });
    let driver = scene.mechanism.driver();
    item.note(format!(
        "the driver stands at {}",
        coordinate(scene, driver.start)
    ))
    .help("change a length or a ground point by that much, or open the scene at another position of the driver")
}

fn vague(scene: &Scene, point: PointId, choices: &[Vec2]) -> Diagnostic {
    let name = point_name(scene, point);
    let places: Vec<String> = choices.iter().map(|&c| pair(c, "(", ")")).collect();
    let item = Diagnostic::new(format!(
        "the start does not say which assembly is meant: {name} can be at {} {}",
        places.join(" or "),
        scene.unit.symbol()
    ))
    .at(
        scene.place(Element::Point(point)),
        format!("where is {name}?"),
    );
    let given = scene.mechanism.start().iter().find(|(p, _)| *p == point);
    let item = match given {
        Some(&(_, near)) => item.note(format!(
            "[start] has {name} at {}, which is as near to one as to the other",
            pair(near, "(", ")")
        )),
        None => item,
    };
    let bare = bare_name(scene, point);
    let key = key(&bare);
    let lines: Vec<String> = choices
        .iter()
        .map(|&c| format!("{key} = {}", pair(c, "[", "]")))
        .collect();
    item.help(format!(
        "give a rough position, one of:\n[start]\n{}",
        lines.join("   # or\n")
    ))
}

fn change_point(scene: &Scene, group: Element) -> Diagnostic {
    let name = element_name(scene, group);
    let option = |sign| format!("`--assembly {}={sign}`", group_text(scene, group));
    let coordinate = coordinate_key(&scene.mechanism);
    Diagnostic::new(format!(
        "the scene opens at a change point, where the two assemblies of {name} meet and both lead on"
    ))
    .at(scene.place(group), "which way does it go on?")
    .help(format!(
        "choose the side beyond it by {} or {}",
        option('+'),
        option('-')
    ))
    .help(format!(
        "or open the scene elsewhere, at another `{coordinate}` of the driver"
    ))
}

/// A group as the command line names it.
fn group_text(scene: &Scene, group: Element) -> String {
    element_name(scene, group)
        .rsplit(' ')
        .next()
        .unwrap_or_default()
        .trim_matches('`')
        .to_owned()
}

fn no_choice(scene: &Scene, group: Element, found: usize) -> Diagnostic {
    let name = element_name(scene, group);
    let says = match found {
        0 => format!("{name} names no group that could be assembled in another way"),
        1 => format!("{name} has one assembly alone here"),
        n => format!("{name} has {n} assemblies here, numbered from 1 to {n}"),
    };
    Diagnostic::new(says).at(scene.place(group), "picked here")
}

fn not_assembled(scene: &Scene, points: &[PointId], gap: f64) -> Diagnostic {
    let names: Vec<String> = points.iter().map(|&p| point_name(scene, p)).collect();
    let mut item = Diagnostic::new(format!(
        "no assembly was found near the start: {} miss their places by at least {}",
        names.join(", "),
        length(scene, gap)
    ));
    for (i, &point) in points.iter().take(POINTED_AT).enumerate() {
        let place = scene.place(Element::Point(point));
        item = if i == 0 {
            item.at(place, "solved together")
        } else {
            item.and(place, "with this")
        };
    }
    if points.is_empty() {
        item = item.at(
            scene.place(Element::Driver),
            "at this position of the driver",
        );
    }
    let missing: Vec<String> = points
        .iter()
        .filter(|&&p| !scene.mechanism.start().iter().any(|&(s, _)| s == p))
        .filter_map(|&p| scene.point_name(p))
        .map(|name| format!("{} = [x, y]", key(name)))
        .collect();
    let help = if missing.is_empty() {
        "bring the positions in [start] nearer to an assembly, or check the lengths".to_owned()
    } else {
        let lines = missing.join("\n");
        format!("give rough positions, or check the lengths:\n[start]\n{lines}")
    };
    item.help(help)
}

fn singular(scene: &Scene, elements: &[Element], is_here_only: bool) -> Diagnostic {
    let guides = guides(scene, elements);
    let elements = if guides.len() >= 2 { &guides } else { elements };
    let names: Vec<String> = elements.iter().map(|&e| element_name(scene, e)).collect();
    let mut item = Diagnostic::new(if is_here_only {
        format!(
            "the scene opens where {} determine no position: at a change point or a dead point",
            names.join(" and ")
        )
    } else {
        format!(
            "{} never determine a position, wherever the driver stands",
            names.join(" and ")
        )
    });
    for (i, &element) in elements.iter().take(POINTED_AT).enumerate() {
        let place = scene.place(element);
        item = if i == 0 {
            item.at(place, "these together leave a motion free")
        } else {
            item.and(place, "with this")
        };
    }
    if is_here_only {
        item.help("open the scene elsewhere, at another `angle` or `position` of the driver")
    } else if guides.len() >= 2 {
        item.help("guides that are parallel hold nothing along them: turn one by its `angle`")
    } else {
        item.help("no dimension mends this: join these parts in another way")
    }
}

/// The slides among the elements, and those of which an element slides or carries the guide.
fn guides(scene: &Scene, elements: &[Element]) -> Vec<Element> {
    let mechanism = &scene.mechanism;
    let takes_part = |id: SlideId| {
        let slide = mechanism.slide(id);
        let sliding = match slide.slider {
            Slider::Pin(point) => Element::Point(point),
            Slider::Link { link, .. } => Element::Link(link),
        };
        let on = match slide.on {
            Body::Ground => None,
            Body::Link(link) => Some(Element::Link(link)),
        };
        let own = [Element::Slide(id), sliding];
        own.into_iter().chain(on).any(|e| elements.contains(&e))
    };
    let ids = mechanism.slide_ids().filter(|&id| takes_part(id));
    ids.map(Element::Slide).collect()
}

fn point_name(scene: &Scene, point: PointId) -> String {
    match scene.point_name(point) {
        Some(name) => format!("`{name}`"),
        None => match carrier_of_origin(scene, point) {
            Some(link) => format!("the origin of {}", link_name(scene, link)),
            None => "a joint".to_owned(),
        },
    }
}

/// The name as the file writes it, for a line that may be copied.
fn bare_name(scene: &Scene, point: PointId) -> String {
    let name = scene.point_name(point).unwrap_or("POINT");
    name.to_owned()
}

/// The sliding link whose hidden origin this is.
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
    let named = links.iter().take(4 * POINTED_AT);
    let mut names: Vec<String> = named.map(|&link| link_name(scene, link)).collect();
    if links.len() > names.len() {
        names.push(format!("and {} more", links.len() - names.len()));
    }
    names.join(", ")
}

fn element_name(scene: &Scene, element: Element) -> String {
    let slide = |slide: SlideId| format!("slide `{}`", scene.slide_name(slide));
    match element {
        Element::Point(point) => point_name(scene, point),
        Element::Link(link) => format!("link {}", link_name(scene, link)),
        Element::Slide(id) => slide(id),
        Element::Driver => "the driver".to_owned(),
    }
}

fn plural(count: usize, one: &str, many: &str) -> String {
    format!("{count} {}", if count == 1 { one } else { many })
}

fn length(scene: &Scene, value: f64) -> String {
    format!("{} {}", figure(value), scene.unit.symbol())
}

fn coordinate(scene: &Scene, at: f64) -> String {
    match scene.mechanism.driver().input {
        crate::Input::Turn(_) => format!("{} deg", figure(at)),
        crate::Input::Push(_) => length(scene, at),
    }
}

fn pair(at: Vec2, open: &str, close: &str) -> String {
    format!("{open}{}, {}{close}", figure(at.x), figure(at.y))
}

#[cfg(test)]
mod tests;
