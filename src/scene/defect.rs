//! Says in the words of the file what the builder found wrong with an element.

use super::draft::SceneDraft;
use super::input::DraftInput;
use super::link::DraftLink;
use super::reader::{Name, Reader, quoted};
use super::slide::{DraftSlide, DraftSlider};
use crate::document::Diagnostic;
use crate::{Defect, LinkId, PointId, SlideId};

/// The draft behind the ids of a builder.
pub(super) struct Drafted<'r, 't> {
    pub(super) draft: &'r SceneDraft<'t>,
    /// The slides that were built, by id.
    pub(super) slides: &'r [&'r DraftSlide<'t>],
    pub(super) point_names: &'r [Option<String>],
}

impl<'t> Drafted<'_, 't> {
    /// Reports defects, without those that only follow from what was reported before.
    pub(super) fn report(&self, reader: &mut Reader<'_>, defects: &[Defect]) {
        for defect in defects {
            if let Some(fault) = self.diagnostic(defect) {
                reader.report(fault);
            }
        }
        // Defects that follow from an earlier report were left out; nothing may pass in silence.
        if reader.found.is_empty() {
            reader.found.extend(
                defects
                    .iter()
                    .map(|defect| Diagnostic::new(defect.to_string())),
            );
        }
    }

    fn diagnostic(&self, defect: &Defect) -> Option<Diagnostic> {
        match *defect {
            Defect::Twice { link, point } => Some(self.twice(self.sound(link)?, point)),
            Defect::OnItself { slide } => Some(self.on_itself(slide)),
            Defect::NoPivot { link } => self.no_pivot(self.sound(link)?),
            Defect::Proportion {
                link,
                length,
                longest,
            } => Some(proportion(self.sound(link)?, length, longest)),
            Defect::NoDriver => self.no_driver(),
            Defect::NoCentre { link } => Some(no_centre(self.sound(link)?)),
            // Refused while reading, with the literal of the file; an element without points or a
            // point without an element cannot come out of a file whose names were all read.
            Defect::Length { .. }
            | Defect::Coordinates { .. }
            | Defect::Driver
            | Defect::Mass { .. }
            | Defect::Load
            | Defect::Misfit
            | Defect::Empty { .. }
            | Defect::Stray { .. } => None,
        }
    }

    /// A link about which nothing was reported yet.
    fn sound(&self, link: LinkId) -> Option<&DraftLink<'t>> {
        let link = &self.draft.links[link.index()];
        (!link.broken).then_some(link)
    }

    fn point_name(&self, point: PointId) -> &str {
        self.point_names[point.index()].as_deref().unwrap_or("?")
    }

    fn twice(&self, link: &DraftLink<'t>, point: PointId) -> Diagnostic {
        let name = self.point_name(point);
        let mut same = link.point_names().filter(|n| n.text == name);
        let (first, second) = (same.next(), same.next());
        let pinned = link.ends.as_ref().is_some_and(|e| e.from.text == e.to.text);
        let fault = if pinned {
            let of = &link.name;
            Diagnostic::new(format!(
                "link {of} is pinned to itself: {} is both its ends",
                quoted(name)
            ))
            .help("a link joins two different points")
        } else {
            Diagnostic::new(format!(
                "link {} names the point {} twice",
                link.name,
                quoted(name)
            ))
            .help("its ends are [0, 0] and [length, 0] already; `points` are further points")
        };
        let fault = match second {
            Some(second) => fault.at(second.span.clone(), "again here"),
            None => fault.at(link.name.span.clone(), ""),
        };
        match first {
            Some(first) => fault.and(first.span.clone(), "once here"),
            None => fault,
        }
    }

    fn on_itself(&self, slide: SlideId) -> Diagnostic {
        let slide = self.slides[slide.index()];
        let on = slide.on.as_ref().map_or("", |on| on.text);
        let body = if on == "ground" {
            "the ground".to_owned()
        } else {
            format!("link {}", quoted(on))
        };
        let (what, span) = match &slide.slider {
            Some(DraftSlider::Link { link, .. }) if link.text == on => {
                (format!("{body} cannot slide on itself"), &link.span)
            }
            Some(DraftSlider::Link { link, .. }) => (
                format!("link {link} cannot slide on {body}: its origin is fixed there"),
                &link.span,
            ),
            Some(DraftSlider::Pin(point)) => (
                format!("{point} cannot slide on {body}, which carries it"),
                &point.span,
            ),
            None => (format!("nothing slides on {body}"), &slide.name.span),
        };
        let fault = Diagnostic::new(format!("slide {}: {what}", slide.name))
            .at(span.clone(), "this slides");
        match &slide.on {
            Some(on) => fault.and(on.span.clone(), "the guide is fixed to this"),
            None => fault,
        }
        .help("a guide and what slides along it belong to different bodies")
    }

    fn no_pivot(&self, link: &DraftLink<'t>) -> Option<Diagnostic> {
        let Some(DraftInput::Link(driven)) = self.draft.driver.as_ref().map(|d| &d.input) else {
            return None;
        };
        let joins = |link: &&DraftLink<'t>| link.point_names().any(|n| self.is_ground(n));
        let mut fit = self
            .draft
            .links
            .iter()
            .filter(joins)
            .map(|l| l.name.to_string());
        let fit: Vec<String> = fit.by_ref().take(8).collect();
        let fault = Diagnostic::new(format!(
            "the driven link {} has no ground point to turn about",
            link.name
        ))
        .at(driven.span.clone(), "not joined to the ground")
        .and(link.name.span.clone(), "none of its points is in [ground]");
        Some(if fit.is_empty() {
            fault.help("put one of its points into [ground]: A = [0, 0]")
        } else {
            fault.help(format!("links with a ground point: {}", fit.join(", ")))
        })
    }

    fn is_ground(&self, name: &Name<'_>) -> bool {
        self.draft.ground.iter().any(|p| p.name.text == name.text)
    }

    fn no_driver(&self) -> Option<Diagnostic> {
        if self.draft.driver_key.is_some() {
            return None;
        }
        let joins = |link: &&DraftLink<'t>| link.point_names().any(|n| self.is_ground(n));
        let crank = self
            .draft
            .links
            .iter()
            .find(joins)
            .map_or("r2", |l| l.name.text);
        let fault = Diagnostic::new("the scene has no driver: nothing turns");
        let fault = match &self.draft.links_key {
            Some(links) => fault.at(links.clone(), "none of these is driven"),
            None => fault,
        };
        Some(fault.help(format!(
            "add, for example:\n[driver]\nlink = \"{crank}\"\nangle = 60\nspeed = \"15 rad/s\""
        )))
    }
}

fn proportion(link: &DraftLink<'_>, length: f64, longest: f64) -> Diagnostic {
    let of = &link.name;
    Diagnostic::new(format!(
        "link {of} is out of all proportion: {length:e} long, where the longest length of the scene is {longest:e}"
    ))
    .at(link.name.span.clone(), "less than 1e-75 of the longest")
    .help("no double holds products of both; look for a coordinate, a `com` or a length that is mistyped")
}

fn no_centre(link: &DraftLink<'_>) -> Diagnostic {
    let (key, span) = link
        .mass_key
        .clone()
        .unwrap_or(("mass", link.name.span.clone()));
    let article = if key == "mass" { "a" } else { "an" };
    let example = match &link.ends {
        Some(ends) => format!("; at mid-length: com = [{}, 0]", ends.length / 2.0),
        None => ": com = [20, 10], for example".to_owned(),
    };
    let of = &link.name;
    Diagnostic::new(format!(
        "link {of} has {article} {key} but no centre of mass"
    ))
    .at(span, "about which point?")
    .help(format!("give the centre in the link's frame{example}"))
}
