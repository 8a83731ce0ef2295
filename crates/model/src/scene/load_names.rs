//! Resolves the names in loads.

use super::loads::DraftLoad;
use super::names::Sort;
use super::reader::Name;
use super::resolve::Resolver;
use super::slide::DraftSlide;
use crate::document::Diagnostic;
use crate::wording::words;
use crate::{Body, LinkId, Load, Profile, SlideId, StrokeEnd, angle};

impl<'t> Resolver<'_, '_, 't> {
    /// Adds all loads, gravity and the unit in metres, which only forces need, to the builder.
    pub(super) fn loads(&mut self) {
        let draft = self.draft;
        for load in &draft.loads {
            if let Some(load) = self.load(load) {
                self.builder.load(load);
            }
        }
        self.builder.gravity(draft.gravity);
        self.builder.metres(draft.unit.metres());
    }

    fn load(&mut self, load: &DraftLoad<'t>) -> Option<Load> {
        match load {
            DraftLoad::Force {
                point,
                force,
                frame,
                over,
            } => {
                let point = self.point(&of_load("point"), point);
                let frame = match frame {
                    Some(name) => self.frame(name),
                    None => Some(Body::Ground),
                };
                Some(Load::Force {
                    point: point?,
                    force: *force,
                    frame: frame?,
                    over: over.clone(),
                })
            }
            DraftLoad::Torque { link, torque, over } => {
                let what = of_load("link");
                let link = self.names.find(self.reader, &what, link, Sort::Link)?;
                Some(Load::Torque {
                    link: LinkId::new(link),
                    torque: *torque,
                    over: over.clone(),
                })
            }
            DraftLoad::Press { slide, curve, end } => self.press(slide, curve, *end),
        }
    }

    /// Returns the body in whose frame a force is given. Reports an unknown link, and returns
    /// `None`.
    fn frame(&mut self, name: &Name<'t>) -> Option<Body> {
        if name.text == "ground" {
            return Some(Body::Ground);
        }
        let what = of_load("frame");
        let link = self.names.find(self.reader, &what, name, Sort::Link);
        if link.is_none() {
            self.reader.help(words().keeps_direction_without_frame());
        }
        link.map(|link| Body::Link(LinkId::new(link)))
    }

    fn press(&mut self, name: &Name<'t>, curve: &Profile, end: Option<StrokeEnd>) -> Option<Load> {
        let what = of_load("slide");
        let index = self.names.find(self.reader, &what, name, Sort::Slide)?;
        let slide = &self.draft.slides[index];
        self.on_ground(name, slide)?;
        let end = match end {
            Some(end) => end,
            None => self.lower_end(name, slide)?,
        };
        Some(Load::Press {
            slide: self.built(slide)?,
            end,
            curve: curve.clone(),
        })
    }

    /// Returns the slide, unless a diagnostic was reported for it.
    fn built(&self, slide: &DraftSlide<'t>) -> Option<SlideId> {
        self.slides.get(slide.name.text).copied()
    }

    /// Reports a press with a moving guide, and returns `None`: its stroke would have no ends in
    /// the frame.
    fn on_ground(&mut self, name: &Name<'t>, slide: &DraftSlide<'t>) -> Option<()> {
        let on = slide.on.as_ref()?;
        if on.text == "ground" {
            return Some(());
        }
        self.reader.report(
            Diagnostic::new(words().press_on_moving_guide(&name.to_string(), &on.to_string()))
                .at(name.span.clone(), words().press_acts_on_this())
                .and(on.span.clone(), words().guide_is_fixed_to())
                .help(words().press_needs_the_frame())
                .help(words().springs_act_between()),
        );
        None
    }

    /// Returns the lower end of the stroke, in the direction of y. Reports a horizontal guide, and
    /// returns `None`.
    fn lower_end(&mut self, name: &Name<'t>, slide: &DraftSlide<'t>) -> Option<StrokeEnd> {
        let up = angle::unit(slide.angle).y;
        if up > 0.0 {
            return Some(StrokeEnd::Least);
        }
        if up < 0.0 {
            return Some(StrokeEnd::Greatest);
        }
        self.reader.report(
            Diagnostic::new(words().press_without_end(&name.to_string()))
                .at(name.span.clone(), words().at_which_end())
                .and(slide.name.span.clone(), words().no_lower_end())
                .help(words().least_is_where())
                .help(words().greatest_is_where()),
        );
        None
    }
}

/// Returns the name of a load's key in messages.
fn of_load(key: &str) -> String {
    words().key_of(key, words().the_load())
}
