//! Reads slides and resolves the names in them.

use crate::document::{Diagnostic, WrittenValue};
use crate::scene::accuracy::deviations::{self, DraftTolerance};
use crate::scene::keys;
use crate::scene::names::NameKind;
use crate::scene::numbers::reader::{Name, Reader};
use crate::scene::resolve::Resolver;
use crate::scene::table::KeyTable;
use crate::wording::words;
use crate::{Body, LinkId, PointId, Vec2};

const SLIDE: &str = r#"r4 = { point = "C", on = "ground", through = "A", angle = 0 }"#;

#[derive(Clone, Debug)]
pub(crate) struct DraftSlide<'t> {
    pub(crate) name: Name<'t>,
    /// `None` here and in the following fields means that a fault was reported.
    pub(crate) slider: Option<DraftSlider<'t>>,
    pub(crate) on: Option<Name<'t>>,
    pub(crate) through: Option<Through<'t>>,
    pub(crate) angle: f64,
    /// The tolerance of the coordinates of `through`.
    pub(crate) tolerance: Option<DraftTolerance>,
}

impl<'t> DraftSlide<'t> {
    /// Returns the name of its pin.
    pub(crate) fn pin(&self) -> Option<&Name<'t>> {
        match self.slider.as_ref()? {
            DraftSlider::Pin(point) => Some(point),
            DraftSlider::Link { .. } => None,
        }
    }

    /// Returns the names of its points: the pin and the point of the guide.
    pub(crate) fn point_names(&self) -> impl Iterator<Item = &Name<'t>> {
        let through = self.through.iter().filter_map(|through| match through {
            Through::Point(point) => Some(point),
            Through::At(_) => None,
        });
        self.pin().into_iter().chain(through)
    }
}

#[derive(Clone, Debug)]
pub(crate) enum DraftSlider<'t> {
    Pin(Name<'t>),
    Link { link: Name<'t>, turn: f64 },
}

#[derive(Clone, Debug)]
pub(crate) enum Through<'t> {
    Point(Name<'t>),
    At(Vec2),
}

/// Reads the section.
pub(crate) fn slides<'v>(
    reader: &mut Reader<'_>,
    value: &'v WrittenValue<'v>,
) -> Vec<DraftSlide<'v>> {
    let slides = reader.entries("[slides]", SLIDE, value);
    slides
        .map(|(name, value)| slide(reader, name, value))
        .collect()
}

fn slide<'v>(
    reader: &mut Reader<'_>,
    name: Name<'v>,
    value: &'v WrittenValue<'v>,
) -> DraftSlide<'v> {
    let of = words().slide_called(&name.to_string());
    let mut slide = DraftSlide {
        name,
        slider: None,
        on: None,
        through: None,
        angle: 0.0,
        tolerance: None,
    };
    let Some(mut table) = reader.open([&of, &of], keys::SLIDE, SLIDE, value) else {
        return slide;
    };
    slide.slider = slider(reader, &slide.name, &mut table);
    slide.angle = reader.number_of(&table, "angle").unwrap_or(0.0);
    slide.tolerance = deviations::tolerance_of(reader, &table);
    table.kind = "link";
    let span = &slide.name.span;
    reader.require(&table, "on", span, r#"on = "ground""#);
    reader.require(&table, "through", span, "through = [0, 0]");
    slide.on = reader.text_of(&table, "on");
    slide.through = through(reader, &table);
    slide
}

/// Reads a point of the guide, by name or by coordinates.
fn through<'v>(reader: &mut Reader<'_>, table: &KeyTable<'v>) -> Option<Through<'v>> {
    let value = table.get("through")?;
    if let Some(text) = value.get_ref().as_str() {
        let span = value.span();
        return Some(Through::Point(Name { text, span }));
    }
    reader.pair_of(table, "through").map(Through::At)
}

/// Reads the slider: a pin or a link.
fn slider<'v>(
    reader: &mut Reader<'_>,
    name: &Name<'v>,
    table: &mut KeyTable<'v>,
) -> Option<DraftSlider<'v>> {
    let fault = |message: String, label: &str| {
        Diagnostic::new(message)
            .at(name.span.clone(), label)
            .help(words().pin_or_link())
    };
    match (table.has("point"), table.has("link")) {
        (true, false) => {
            table.kind = "point";
            if let Some(key) = table.key("turn") {
                reader.report(
                    Diagnostic::new(words().pin_has_no_turn(&table.of))
                        .at(key.span, words().for_slide_of_link())
                        .help(words().slide_the_link()),
                );
            } else {
                reader.only_known(table);
            }
            reader.text_of(table, "point").map(DraftSlider::Pin)
        }
        (false, true) => {
            table.kind = "link";
            reader.only_known(table);
            let turn = reader.number_of(table, "turn").unwrap_or(0.0);
            let link = reader.text_of(table, "link")?;
            Some(DraftSlider::Link { link, turn })
        }
        (true, true) => {
            let label = words().one_of_them_slides();
            reader.report(fault(words().has_point_and_link(&table.of), label));
            None
        }
        (false, false) => {
            reader.only_known(table);
            let label = words().nothing_slides_here();
            reader.report(fault(words().has_no_point_nor_link(&table.of), label));
            None
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
    pub(crate) fn slides(&mut self) {
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
                self.slide(slide, sliding, on, through);
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

    fn carrier(&mut self, slide: &DraftSlide<'t>, on: &Name<'t>) -> Option<Body> {
        let what = words().key_of("on", &words().slide_called(&slide.name.to_string()));
        let carrier = self.body(&what, on);
        if carrier.is_none() {
            self.reader.help(words().guide_in_the_frame());
        }
        carrier
    }

    fn sliding(&mut self, slide: &DraftSlide<'t>, slider: &DraftSlider<'t>) -> Option<SlidingId> {
        match slider {
            DraftSlider::Pin(point) => Some(SlidingId::Pin(self.points[point.text])),
            DraftSlider::Link { link, turn } => {
                let slide = words().slide_called(&slide.name.to_string());
                let what = words().key_of("link", &slide);
                let link = self.link(&what, link)?;
                Some(SlidingId::Link { link, turn: *turn })
            }
        }
    }

    /// Returns the coordinates of the guide's named point in the frame of the body that carries the
    /// guide. Reports a point that the body does not have, and returns `None`.
    fn through(&mut self, slide: &DraftSlide<'t>, name: &Name<'t>, on: Body) -> Option<Vec2> {
        let what = words().key_of("through", &words().slide_called(&slide.name.to_string()));
        self.referred.insert(name.text);
        self.names.find(self.reader, &what, name, NameKind::Point)?;
        let (local, body) = match on {
            Body::Ground => {
                let place = self.ground.get(name.text);
                (
                    place.map(|p| p.at()),
                    words().the_ground_as_body().to_owned(),
                )
            }
            Body::Link(link) => {
                let link = &self.draft.links[link.index()];
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
