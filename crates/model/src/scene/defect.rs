//! Converts the builder's defects to diagnostics that name the elements as the file does.

use super::elements::link::DraftLink;
use super::elements::slide::{DraftSlide, DraftSlider};
use super::inputs::input::DraftDriver;
use super::numbers::reader::{Name, Reader, quoted};
use super::raw_elements::SceneDraft;
use crate::document::Diagnostic;
use crate::wording::words;
use crate::{Defect, LinkId, PointId, SlideId};

/// The draft and names by which the ids of a builder are resolved.
pub(crate) struct ResolvedDraft<'r, 't> {
    pub(crate) draft: &'r SceneDraft<'t>,
    /// The slides added to the builder, by id.
    pub(crate) slides: &'r [&'r DraftSlide<'t>],
    pub(crate) point_names: &'r [Option<String>],
}

impl<'t> ResolvedDraft<'_, 't> {
    /// Reports defects, except those that follow from an earlier diagnostic.
    pub(crate) fn report(&self, reader: &mut Reader<'_>, defects: &[Defect]) {
        for defect in defects {
            if let Some(fault) = self.diagnostic(defect) {
                reader.report(fault);
            }
        }
        // Every defect followed from an earlier one. Report all of them, so that parsing never
        // fails without a diagnostic.
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
            Defect::Twice { link, point } => Some(self.twice(self.sound_link(link)?, point)),
            Defect::OnItself { slide } => Some(self.on_itself(slide)),
            Defect::NoPivot { link } => self.no_pivot(self.sound_link(link)?),
            Defect::Proportion {
                link,
                length,
                longest,
            } => Some(proportion(self.sound_link(link)?, length, longest)),
            Defect::NoDriver => self.no_driver(),
            Defect::NoCentre { link } => Some(no_centre(self.sound_link(link)?)),
            // The reader rejects these earlier and quotes the literal. An element without points or
            // a point without an element cannot come from a file whose names were all read.
            Defect::Length { .. }
            | Defect::Coordinates { .. }
            | Defect::Driver
            | Defect::DrivenTwice { .. }
            | Defect::OpenTable { .. }
            | Defect::TurnedFromItself { .. }
            | Defect::Mass { .. }
            | Defect::Load
            | Defect::RateError
            | Defect::Limit { .. }
            | Defect::Empty { .. }
            | Defect::Stray { .. } => None,
        }
    }

    /// Returns the link unless a diagnostic was already reported for it.
    fn sound_link(&self, link: LinkId) -> Option<&DraftLink<'t>> {
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
            Diagnostic::new(words().pinned_to_itself(&of.to_string(), &quoted(name)))
                .help(words().joins_two_points())
        } else {
            Diagnostic::new(words().names_point_twice(&link.name.to_string(), &quoted(name))).help(
                match link.direction {
                    Some(_) => words().name_each_point_once(),
                    None => words().ends_are_points(),
                },
            )
        };
        let fault = match second {
            Some(second) => fault.at(second.span.clone(), words().again_here()),
            None => fault.at(link.name.span.clone(), ""),
        };
        match first {
            Some(first) => fault.and(first.span.clone(), words().once_here()),
            None => fault,
        }
    }

    fn on_itself(&self, slide: SlideId) -> Diagnostic {
        let slide = self.slides[slide.index()];
        let on = slide.on.as_ref().map_or("", |on| on.text);
        let body = if on == "ground" {
            words().the_ground_as_body().to_owned()
        } else {
            words().link_called(&quoted(on))
        };
        let (what, span) = match &slide.slider {
            Some(DraftSlider::Link { link, .. }) if link.text == on => {
                (words().cannot_slide_on_itself(&body), &link.span)
            }
            Some(DraftSlider::Link { link, .. }) => (
                words().origin_is_fixed(&link.to_string(), &body),
                &link.span,
            ),
            Some(DraftSlider::Pin(point)) => {
                (words().carried_by(&point.to_string(), &body), &point.span)
            }
            None => (words().nothing_slides_on(&body), &slide.name.span),
        };
        let fault = Diagnostic::new(words().slide_called(&slide.name.to_string()) + ": " + &what)
            .at(span.clone(), words().this_slides());
        match &slide.on {
            Some(on) => fault.and(on.span.clone(), words().guide_is_fixed_to()),
            None => fault,
        }
        .help(words().guide_and_slider_differ())
    }

    fn no_pivot(&self, link: &DraftLink<'t>) -> Option<Diagnostic> {
        let driver = self.draft.driver.iter();
        let timed = self.draft.timed.iter().map(|timed| &timed.name);
        let mut driven = driver.filter_map(DraftDriver::driven_link).chain(timed);
        let driven = driven.find(|driven| driven.text == link.name.text)?;
        let fit = self.links_at_ground().map(|link| link.name.to_string());
        let fit: Vec<String> = fit.take(8).collect();
        let fault = Diagnostic::new(words().no_pivot(&link.name.to_string()))
            .at(driven.span.clone(), words().not_joined_to_ground())
            .and(link.name.span.clone(), words().none_in_ground());
        let fault = if fit.is_empty() {
            fault.help(words().put_into_ground())
        } else {
            fault.help(words().links_with_ground_point(&fit.join(", ")))
        };
        Some(
            fault.maybe_help(
                self.seat_for(link)
                    .map(|seat| words().or_name_its_seat(seat)),
            ),
        )
    }

    /// Returns a link that can carry the motor of `driven`: preferably one pinned to it, or else
    /// any other link.
    fn seat_for(&self, driven: &DraftLink<'t>) -> Option<&'t str> {
        let others = || {
            self.draft
                .links
                .iter()
                .filter(|l| l.name.text != driven.name.text)
        };
        let is_joined = |link: &&DraftLink<'t>| {
            let mut points = link.point_names();
            points.any(|point| driven.point_names().any(|own| own.text == point.text))
        };
        let seat = others().find(is_joined).or_else(|| others().next());
        seat.map(|link| link.name.text)
    }

    /// Returns the links with a point of the ground.
    fn links_at_ground(&self) -> impl Iterator<Item = &DraftLink<'t>> {
        let ground = &self.draft.ground;
        let is_ground = |name: &Name<'_>| ground.iter().any(|p| p.name.text == name.text);
        let links = self.draft.links.iter();
        links.filter(move |link| link.point_names().any(is_ground))
    }

    fn no_driver(&self) -> Option<Diagnostic> {
        if self.draft.driver_key.is_some() {
            return None;
        }
        let crank = self.links_at_ground().next();
        let crank = crank.map_or("r2", |link| link.name.text);
        let fault = Diagnostic::new(words().no_driver());
        let fault = match &self.draft.links_key {
            Some(links) => fault.at(links.clone(), words().none_is_driven()),
            None => fault,
        };
        let example = format!("[driver]\nlink = \"{crank}\"\nangle = 60\nspeed = \"15 rad/s\"");
        Some(fault.help(words().add_for_example(&example)))
    }
}

fn proportion(link: &DraftLink<'_>, length: f64, longest: f64) -> Diagnostic {
    let of = &link.name;
    Diagnostic::new(words().out_of_proportion(&of.to_string(), &length, &longest))
        .at(link.name.span.clone(), words().less_than_part())
        .help(words().look_for_mistyped())
}

fn no_centre(link: &DraftLink<'_>) -> Diagnostic {
    let (key, span) = match &link.mass_key {
        Some(key) => (key.text, key.span.clone()),
        None => ("mass", link.name.span.clone()),
    };
    let help = match &link.ends {
        Some(ends) => words().give_centre_at_middle(ends.length / 2.0),
        None => words().give_centre().to_owned(),
    };
    let of = link.name.to_string();
    let message = match key {
        "mass" => words().mass_without_centre(&of),
        _ => words().inertia_without_centre(&of),
    };
    Diagnostic::new(message)
        .at(span, words().about_which_point())
        .help(help)
}
