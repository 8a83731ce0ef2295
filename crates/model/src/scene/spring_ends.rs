//! Resolves the names in springs.

use super::link::DraftLink;
use super::names::Sort;
use super::reader::Name;
use super::resolve::Resolver;
use super::spring::{DraftLaw, DraftSpring};
use crate::document::Diagnostic;
use crate::wording::words;
use crate::{Body, LinkId, Load};

impl<'t> Resolver<'_, '_, 't> {
    /// Adds all springs to the builder.
    pub(super) fn springs(&mut self) {
        let draft = self.draft;
        for spring in &draft.springs {
            let load = match &spring.to {
                Some(to) if !matches!(spring.law, DraftLaw::Torsion { .. }) => {
                    self.between_points(spring, to)
                }
                to => self.between_links(spring, to.as_ref()),
            };
            if let Some(load) = load {
                self.builder.load(load);
            }
        }
    }

    /// Returns a spring along the line between two points. Reports faults, and returns `None` for
    /// them.
    fn between_points(&mut self, spring: &DraftSpring<'t>, to: &Name<'t>) -> Option<Load> {
        let of = words().the_spring();
        let begin = self.point(&words().key_of("from", of), &spring.from);
        let end = self.point(&words().key_of("to", of), to);
        let (from_point, to_point) = (begin?, end?);
        if let Some(fault) = self.idle(&spring.from, to) {
            self.reader.report(fault);
            return None;
        }
        let (from, to, damping) = (from_point, to_point, spring.damping);
        match spring.law {
            DraftLaw::Line {
                stiffness,
                length,
                preload,
            } => Some(Load::Spring {
                from,
                to,
                stiffness,
                length,
                preload,
                damping,
            }),
            DraftLaw::Gas(ref force) => Some(Load::GasSpring {
                from,
                to,
                force: force.clone(),
                damping,
            }),
            DraftLaw::Torsion { .. } => None,
        }
    }

    /// Returns a torsion spring. Reports faults, and returns `None` for them.
    fn between_links(&mut self, spring: &DraftSpring<'t>, to: Option<&Name<'t>>) -> Option<Load> {
        let DraftLaw::Torsion {
            stiffness,
            angle,
            preload,
        } = spring.law
        else {
            return None;
        };
        let link = self.spring_link("link", &spring.from)?;
        let fixed = match to {
            Some(name) if name.text != "ground" => Body::Link(self.spring_link("to", name)?),
            Some(_) | None => Body::Ground,
        };
        if let Some(to) = to.filter(|to| to.text == spring.from.text) {
            let fault = to_itself(&spring.from, to, words().name_two_links());
            self.reader.report(fault);
            return None;
        }
        Some(Load::TorsionSpring {
            link,
            to: fixed,
            stiffness,
            angle,
            preload,
            damping: spring.damping,
        })
    }

    fn spring_link(&mut self, key: &str, name: &Name<'t>) -> Option<LinkId> {
        let what = words().key_of(key, words().the_spring());
        let link = self.names.find(self.reader, &what, name, Sort::Link)?;
        Some(LinkId::new(link))
    }

    /// Returns the diagnostic of a spring whose length never changes; `None` for other springs.
    fn idle(&self, from: &Name<'t>, to: &Name<'t>) -> Option<Diagnostic> {
        if from.text == to.text {
            return Some(to_itself(from, to, words().name_two_points()));
        }
        let grounded = |name: &Name<'_>| self.ground.contains_key(name.text);
        let carried = |link: &&DraftLink<'_>| [from, to].iter().all(|name| carries(link, name));
        let body = if grounded(from) && grounded(to) {
            words().the_ground_as_body().to_owned()
        } else {
            let link = self.draft.links.iter().find(carried)?;
            words().link_called(&link.name.to_string())
        };
        Some(
            Diagnostic::new(words().spring_on_one_body(&body))
                .at(to.span.clone(), words().length_never_changes())
                .and(from.span.clone(), words().begins_here())
                .help(words().springs_join_bodies()),
        )
    }
}

/// Returns the diagnostic of a spring with two equal ends.
fn to_itself(from: &Name<'_>, to: &Name<'_>, help: &'static str) -> Diagnostic {
    Diagnostic::new(words().spring_to_itself(&from.to_string()))
        .at(to.span.clone(), words().end_is_beginning())
        .and(from.span.clone(), words().begins_here())
        .help(help)
}

/// Returns `true` if a point or a centre of mass belongs to the link.
fn carries(link: &DraftLink<'_>, name: &Name<'_>) -> bool {
    let centre = name.text.strip_suffix(".com");
    centre == Some(link.name.text) || link.point_names().any(|point| point.text == name.text)
}
