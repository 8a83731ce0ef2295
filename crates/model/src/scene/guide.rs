//! Resolves the names in slides: the slider, the body that carries the guide, and the guide's
//! point.

use super::names::Sort;
use super::reader::Name;
use super::resolve::Resolver;
use super::slide::{DraftSlide, DraftSlider, Through};
use crate::document::Diagnostic;
use crate::wording::words;
use crate::{Body, LinkId, PointId, Vec2};

/// The body that carries a guide: the ground, or a link by its index in the draft.
#[derive(Clone, Copy)]
enum Carrier {
    Ground,
    Link(usize),
}

impl Carrier {
    fn body(self) -> Body {
        match self {
            Carrier::Ground => Body::Ground,
            Carrier::Link(link) => Body::Link(LinkId::new(link)),
        }
    }
}

/// The slider, by id.
enum SlidingId {
    Pin(PointId),
    Link { link: LinkId, turn: f64 },
}

impl<'r, 't> Resolver<'r, '_, 't> {
    /// Adds all slides to the builder, except those that name an unknown element.
    pub(super) fn slides(&mut self) {
        let draft = self.draft;
        for slide in &draft.slides {
            let on = slide.on.as_ref().and_then(|on| self.carrier(slide, on));
            let sliding = slide.slider.as_ref().and_then(|s| self.sliding(slide, s));
            let through = match (&slide.through, on) {
                (Some(Through::At(at)), _) => Some(*at),
                (Some(Through::Point(name)), Some(on)) => self.through(slide, name, on),
                (Some(Through::Point(_)) | None, _) => None,
            };
            if let (Some(on), Some(sliding), Some(through)) = (on, sliding, through) {
                self.slide(slide, sliding, on.body(), through);
            }
        }
    }

    fn slide(&mut self, slide: &'r DraftSlide<'t>, sliding: SlidingId, on: Body, through: Vec2) {
        let angle = slide.angle;
        let id = match sliding {
            SlidingId::Pin(point) => self.builder.pin_in_slot(point, on, through, angle),
            SlidingId::Link { link, turn } => {
                self.builder.sliding_link(link, turn, on, through, angle)
            }
        };
        if let Some(Through::Point(name)) = &slide.through
            && let Some(&point) = self.points.get(name.text)
        {
            self.builder.named_through(id, point);
        }
        self.push_slide(slide, id);
    }

    fn carrier(&mut self, slide: &DraftSlide<'t>, on: &Name<'t>) -> Option<Carrier> {
        if on.text == "ground" {
            return Some(Carrier::Ground);
        }
        let what = words().key_of("on", &words().slide_called(&slide.name.to_string()));
        let link = self.names.find(self.reader, &what, on, Sort::Link);
        if link.is_none() {
            self.reader.help(words().guide_in_the_frame());
        }
        link.map(Carrier::Link)
    }

    fn sliding(&mut self, slide: &DraftSlide<'t>, slider: &DraftSlider<'t>) -> Option<SlidingId> {
        match slider {
            DraftSlider::Pin(point) => Some(SlidingId::Pin(self.points[point.text])),
            DraftSlider::Link { link, turn } => {
                let slide = words().slide_called(&slide.name.to_string());
                let what = words().key_of("link", &slide);
                let link = self.names.find(self.reader, &what, link, Sort::Link)?;
                Some(SlidingId::Link {
                    link: LinkId::new(link),
                    turn: *turn,
                })
            }
        }
    }

    /// Returns the coordinates of the guide's named point in the frame of the body that carries the
    /// guide. Reports a point that the body does not have, and returns `None`.
    fn through(&mut self, slide: &DraftSlide<'t>, name: &Name<'t>, on: Carrier) -> Option<Vec2> {
        let what = words().key_of("through", &words().slide_called(&slide.name.to_string()));
        self.referred.insert(name.text);
        self.names.find(self.reader, &what, name, Sort::Point)?;
        let (local, body) = match on {
            Carrier::Ground => {
                let place = self.ground.get(name.text);
                (
                    place.map(|p| p.at()),
                    words().the_ground_as_body().to_owned(),
                )
            }
            Carrier::Link(link) => {
                let link = &self.draft.links[link];
                (
                    link.local(name.text),
                    words().link_called(&link.name.to_string()),
                )
            }
        };
        if local.is_none() {
            let rule = words().must_be_point_of(&what, &body, &name.to_string());
            self.reader.report(
                Diagnostic::new(rule)
                    .at(name.span.clone(), words().no_point_of(&body))
                    .help(words().name_point_of(&body)),
            );
        }
        local
    }
}
