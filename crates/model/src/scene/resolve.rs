//! Resolves the names of a draft and builds the mechanism.

use super::accuracy::deviations::ToleranceResolver;
use super::elements::limits::LimitPlaces;
use super::elements::link::DraftLink;
use super::elements::link_points::Sighted;
use super::elements::points::PlacedPoint;
use super::elements::redundant;
use super::elements::slide::DraftSlide;
use super::inputs::input::DraftInput;
use super::inputs::leading_point::LeadingPoint;
use super::names::{NameKind, Names};
use super::numbers::reader::{ByteSpan, Name, Reader};
use super::raw_elements::SceneDraft;
use super::{TextPlaces, Vector, VectorKind, defect};
use crate::document::Diagnostic;
use crate::nearest::nearest;
use crate::wording::words;
use crate::{Body, Builder, Driver, LinkId, Mechanism, PointId, SlideId, Tolerances, mechanism};
use std::collections::{HashMap, HashSet};

/// The parts of a scene that depend on resolved names.
pub(crate) struct Resolved {
    pub(crate) mechanism: Mechanism,
    pub(crate) vectors: Vec<Vector>,
    pub(crate) traces: Vec<PointId>,
    pub(crate) point_names: Vec<Option<String>>,
    pub(crate) link_names: Vec<String>,
    pub(crate) slide_names: Vec<String>,
    pub(crate) lead: Option<LeadingPoint>,
    pub(crate) limits: LimitPlaces,
    pub(crate) tolerances: Tolerances,
    pub(crate) places: TextPlaces,
}

/// Resolves names and builds the mechanism; returns `None` if any diagnostic was reported.
pub(crate) fn resolve<'t>(reader: &mut Reader<'_>, draft: &SceneDraft<'t>) -> Option<Resolved> {
    if draft.unreadable {
        return None;
    }
    let names = Names::collect(reader, draft);
    let mut resolver = Resolver::new(reader, draft, &names);
    resolver.points();
    resolver.links();
    resolver.centres();
    resolver.slides();
    resolver.driver();
    resolver.timed_inputs();
    resolver.limits();
    resolver.start();
    resolver.vectors();
    resolver.loads();
    resolver.springs();
    resolver.redundant();
    resolver.view();
    if !(draft.lost_points || draft.lost_references) {
        resolver.unused();
        resolver.loose_pins();
    }
    resolver.finish()
}

/// The state of resolving: the mechanism under construction and the ids of its elements.
pub(crate) struct Resolver<'r, 's, 't> {
    pub(crate) reader: &'r mut Reader<'s>,
    pub(crate) draft: &'r SceneDraft<'t>,
    pub(crate) names: &'r Names<'t>,
    pub(crate) builder: Builder,
    pub(crate) ground: HashMap<&'t str, &'r PlacedPoint<'t>>,
    pub(crate) points: HashMap<&'t str, PointId>,
    /// Points used by slides, vectors and loads, which do not define them.
    pub(crate) referred: HashSet<&'t str>,
    /// The centres of mass, by the link's index in the draft.
    centres: HashMap<usize, PointId>,
    pub(crate) slides: HashMap<&'t str, SlideId>,
    /// The slides added to the builder, by id.
    pub(crate) built_slides: Vec<&'r DraftSlide<'t>>,
    point_names: Vec<Option<String>>,
    pub(crate) limit_places: LimitPlaces,
    vectors: Vec<(ByteSpan, Vector)>,
    traces: Vec<PointId>,
    places: TextPlaces,
}

impl<'r, 's, 't> Resolver<'r, 's, 't> {
    fn new(reader: &'r mut Reader<'s>, draft: &'r SceneDraft<'t>, names: &'r Names<'t>) -> Self {
        Resolver {
            reader,
            draft,
            names,
            builder: Mechanism::builder(),
            ground: draft.ground.iter().map(|p| (p.name.text, p)).collect(),
            points: HashMap::new(),
            referred: HashSet::new(),
            centres: HashMap::new(),
            slides: HashMap::new(),
            built_slides: Vec::new(),
            point_names: Vec::new(),
            limit_places: Vec::new(),
            vectors: Vec::new(),
            traces: Vec::new(),
            places: TextPlaces {
                driver: draft.driver_key.clone().unwrap_or_default(),
                ..TextPlaces::default()
            },
        }
    }

    /// Adds every named point, in the order in which the file first names it.
    fn points(&mut self) {
        for (name, span) in self.names.points() {
            let id = match self.ground.get(name) {
                Some(place) => {
                    let at = place.at();
                    match self.draft.marks.contains(name) {
                        true => self.builder.mark(at.x, at.y),
                        false => self.builder.ground_point(at.x, at.y),
                    }
                }
                None => self.builder.moving_point(),
            };
            self.points.insert(name, id);
            self.name_point(name.to_owned(), span.clone());
        }
    }

    fn name_point(&mut self, name: String, span: ByteSpan) {
        self.point_names.push(Some(name));
        self.places.points.push(span);
    }

    fn links(&mut self) {
        for link in &self.draft.links {
            let id = match &link.ends {
                Some(ends) => {
                    let (from, to) = (self.points[ends.from.text], self.points[ends.to.text]);
                    let id = self.builder.link(from, to, ends.length);
                    self.push_vector(&link.name, VectorKind::Link(id));
                    id
                }
                None => self.builder.free_link(),
            };
            for place in &link.points {
                let point = self.points[place.name.text];
                match &place.sighted {
                    None => self.builder.carry(id, point, place.at()),
                    Some(sighted) => {
                        let (from, arm) = self.arm(sighted);
                        self.builder.carry_at(id, point, from, arm);
                    }
                }
            }
            self.builder.mass(id, link.mass, link.inertia);
            self.places.links.push(link.name.span.clone());
        }
    }

    /// Adds the centres of mass after all named points, so that tables show the joints first.
    fn centres(&mut self) {
        for (i, link) in self.draft.links.iter().enumerate() {
            if let Some(com) = &link.com {
                let id = LinkId::new(i);
                let centre = match &com.sighted {
                    None => self.builder.centre_of_mass(id, com.at()),
                    Some(sighted) => {
                        let (from, arm) = self.arm(sighted);
                        self.builder.centre_of_mass_at(id, from, arm)
                    }
                };
                self.centres.insert(i, centre);
                self.name_point(format!("{}.com", link.name.text), com.name.span.clone());
            }
        }
    }

    /// Returns the reference point of a place on a link, with its length and angle.
    fn arm(&self, sighted: &Sighted<'_>) -> (Option<PointId>, (f64, f64)) {
        let from = sighted.from.as_ref();
        let from = from.and_then(|from| self.points.get(from.text).copied());
        (from, (sighted.length, sighted.angle))
    }

    fn push_vector(&mut self, name: &Name<'t>, kind: VectorKind) {
        let vector = Vector {
            name: name.text.to_owned(),
            kind,
        };
        self.vectors.push((name.span.clone(), vector));
    }

    /// Records a slide added to the builder.
    pub(crate) fn push_slide(&mut self, slide: &'r DraftSlide<'t>, id: SlideId) {
        self.slides.insert(slide.name.text, id);
        self.built_slides.push(slide);
        self.places.slides.push(slide.name.span.clone());
        self.push_vector(&slide.name, VectorKind::Slide(id));
    }

    fn driver(&mut self) {
        let draft = self.draft;
        let Some(driver) = &draft.driver else { return };
        let input = match &driver.input {
            DraftInput::Link(name) => {
                let what = words().key_of("link", words().the_driver());
                let seat = words().key_of("from", words().the_driver());
                self.turned_link([&what, &seat], name, driver.from.as_ref())
                    .map(mechanism::Input::Turn)
            }
            DraftInput::Slide(name) => self.driven_slide(name).map(mechanism::Input::Push),
        };
        if let Some(input) = input {
            self.builder.driver(Driver {
                input,
                start: driver.start,
                speed: driver.speed,
                acceleration: driver.acceleration,
            });
        }
        if driver.is_converted {
            self.builder.converted_rates();
        }
        if let Some(rates) = driver.typed_rates {
            self.builder.typed_rates(rates);
        }
    }

    fn driven_slide(&mut self, name: &Name<'t>) -> Option<SlideId> {
        let what = words().key_of("slide", words().the_driver());
        let slide = self.names.find(self.reader, &what, name, NameKind::Slide);
        if slide.is_none() && self.draft.links.iter().any(|l| l.name.text == name.text) {
            self.reader.help(words().driven_link_is_given());
        }
        self.slides.get(name.text).copied()
    }

    /// Resolves a link that an input turns, relative to the ground or to the link that carries its
    /// motor.
    pub(crate) fn turned_link(
        &mut self,
        [what, seat]: [&str; 2],
        name: &Name<'t>,
        from: Option<&Name<'t>>,
    ) -> Option<LinkId> {
        let link = self.driven_link(what, name);
        let Some(from) = from.filter(|from| from.text != "ground") else {
            return link;
        };
        let seat = self.link(seat, from);
        let (link, seat) = (link?, seat?);
        if link == seat {
            self.reader.report(
                Diagnostic::new(words().turns_from_itself(&name.to_string()))
                    .at(from.span.clone(), words().the_driven_link())
                    .help(words().seat_is_another_link()),
            );
            return None;
        }
        self.builder.turned_from(link, seat);
        Some(link)
    }

    /// Resolves the name of a link.
    pub(crate) fn link(&mut self, what: &str, name: &Name<'t>) -> Option<LinkId> {
        let link = self.names.find(self.reader, what, name, NameKind::Link);
        link.map(LinkId::new)
    }

    /// Resolves the name of a link, or `ground`.
    pub(crate) fn body(&mut self, what: &str, name: &Name<'t>) -> Option<Body> {
        match name.text {
            "ground" => Some(Body::Ground),
            _ => self.link(what, name).map(Body::Link),
        }
    }

    /// Resolves a driven link. Reports a link pinned to the ground at two places, which cannot
    /// turn.
    pub(crate) fn driven_link(&mut self, what: &str, name: &Name<'t>) -> Option<LinkId> {
        let link = self.names.find(self.reader, what, name, NameKind::Link);
        if link.is_none() && self.slides.contains_key(name.text) {
            self.reader.help(words().driven_slide_is_given());
        }
        let link = link?;
        let points = self.draft.links[link].point_names();
        let mut pins = points.filter_map(|p| self.ground.get(p.text).map(|place| (p, place.at())));
        let first = pins.next();
        let second = first.and_then(|(_, at)| pins.find(|&(_, other)| other != at));
        if let (Some((first, _)), Some((second, _))) = (first, second) {
            self.reader.report(
                Diagnostic::new(words().pinned_to_ground_twice(&name.to_string()))
                    .at(name.span.clone(), words().the_driven_link())
                    .and(first.span.clone(), words().one_pin())
                    .and(second.span.clone(), words().another_pin())
                    .help(words().turns_about_one_point()),
            );
        }
        Some(LinkId::new(link))
    }

    fn start(&mut self) {
        for place in &self.draft.start {
            let name = &place.name;
            // A centre of mass may be the only point that selects the assembly of its link.
            if let Some(link) = name.text.strip_suffix(".com") {
                if let Some(centre) = self.centre("[start]", name, link) {
                    self.builder.start(centre, place.at());
                }
                continue;
            }
            let found = self
                .names
                .find(self.reader, "[start]", name, NameKind::Point);
            if found.is_none() {
                continue;
            }
            if let Some(ground) = self.ground.get(name.text) {
                self.reader.report(
                    Diagnostic::new(words().start_of_ground_point(&name.to_string()))
                        .at(name.span.clone(), words().does_not_move())
                        .and(ground.name.span.clone(), words().fixed_here())
                        .help(words().start_is_for_moving()),
                );
                continue;
            }
            self.builder.start(self.points[name.text], place.at());
        }
    }

    fn vectors(&mut self) {
        for vector in &self.draft.vectors {
            let what = words().vector_called(&vector.name.to_string());
            let tail = self.point(&what, &vector.tail);
            let head = self.point(&what, &vector.head);
            let (Some(tail), Some(head)) = (tail, head) else {
                continue;
            };
            if tail == head {
                self.reader.report(
                    Diagnostic::new(words().runs_to_itself(&what, &vector.tail.to_string()))
                        .at(vector.head.span.clone(), words().head_is_tail())
                        .help(words().name_tail_and_head()),
                );
            }
            self.push_vector(&vector.name, VectorKind::Between(tail, head));
        }
    }

    fn view(&mut self) {
        let what = words().key_of("traces", "[view]");
        for name in &self.draft.view.traces {
            let point = self.point(&what, name);
            let is_new = |point: &PointId| !self.traces.contains(point);
            self.traces.extend(point.filter(is_new));
        }
    }

    fn redundant(&mut self) {
        redundant::check(self.reader, self.draft);
        self.builder.misfit(self.draft.redundant.misfit);
        self.builder.decimals();
        if self.reader.has_rounded {
            self.builder.rounded();
        }
    }

    /// Resolves a point by its name; `r3.com` is the centre of mass of `r3`.
    pub(crate) fn point(&mut self, what: &str, name: &Name<'t>) -> Option<PointId> {
        if let Some(link) = name.text.strip_suffix(".com") {
            return self.centre(what, name, link);
        }
        self.referred.insert(name.text);
        self.names.find(self.reader, what, name, NameKind::Point)?;
        self.points.get(name.text).copied()
    }

    fn centre(&mut self, what: &str, name: &Name<'t>, link: &'t str) -> Option<PointId> {
        let of = Name {
            text: link,
            span: name.span.clone(),
        };
        let index = self.names.find(self.reader, what, &of, NameKind::Link)?;
        let centre = self.centres.get(&index).copied();
        if centre.is_none() {
            let link = &self.draft.links[index];
            self.reader.report(
                Diagnostic::new(words().has_no_centre(what, &of.to_string()))
                    .at(name.span.clone(), words().no_such_point())
                    .and(link.name.span.clone(), words().has_no_com())
                    .help(words().give_the_link_one()),
            );
        }
        centre
    }

    /// Reports ground points without any reference: usually one name was written in two ways.
    fn unused(&mut self) {
        let links = self.draft.links.iter().flat_map(DraftLink::point_names);
        let pins = self.draft.slides.iter().filter_map(DraftSlide::pin);
        let mut used = std::mem::take(&mut self.referred);
        used.extend(links.chain(pins).map(|name| name.text));
        for place in &self.draft.ground {
            let name = &place.name;
            let is_used = used.contains(name.text) || self.draft.marks.contains(name.text);
            if is_used || place.read.is_none() {
                continue;
            }
            let moving = self.names.points().map(|(name, _)| name);
            let moving = moving.filter(|name| !self.ground.contains_key(name));
            let near = (!self.reader.is_full()).then(|| nearest(name.text, moving));
            let help = match near.flatten() {
                Some(near) => words().was_moving_meant(near, &name.to_string()),
                None => words().take_out_or_use().to_owned(),
            };
            self.reader.report(
                Diagnostic::new(words().belongs_to_nothing(&name.to_string()))
                    .at(name.span.clone(), words().nothing_names_it())
                    .help(help),
            );
        }
    }

    /// Reports pins in a single slot that no link carries: usually the link's end has another name. A pin without a
    /// link may be at the crossing of two slots, or on a driven slide.
    fn loose_pins(&mut self) {
        let draft = self.draft;
        let carried = draft.links.iter().flat_map(DraftLink::point_names);
        let mut slots = HashMap::new();
        for name in carried {
            *slots.entry(name.text).or_insert(0) += 2;
        }
        let slides = draft.slides.iter();
        let pins = slides.filter_map(|slide| Some((slide, slide.pin()?)));
        for (_, point) in pins.clone() {
            *slots.entry(point.text).or_insert(0) += 1;
        }
        let pushed = draft.driver.iter().filter(|d| d.driven_link().is_none());
        let driven = pushed.map(|driver| driver.driven().text);
        let timed = draft.timed.iter().map(|timed| timed.name.text);
        let driven: HashSet<&str> = driven.chain(timed).collect();
        for (slide, point) in pins {
            let is_placed = self.ground.contains_key(point.text) || slots[point.text] > 1;
            if is_placed || driven.contains(slide.name.text) {
                continue;
            }
            let of = words().slide_called(&slide.name.to_string());
            let mut fault = Diagnostic::new(words().no_link_has(&of, &point.to_string()))
                .at(point.span.clone(), words().no_link_names_it());
            let moving = self.names.points().map(|(name, _)| name);
            let moving =
                moving.filter(|name| *name != point.text && !self.ground.contains_key(name));
            let near = (!self.reader.is_full())
                .then(|| nearest(point.text, moving))
                .flatten();
            // An end of one link and of nothing else probably belongs in the slot.
            let ends = draft.links.iter().filter_map(|link| link.ends.as_ref());
            let ends = ends.flat_map(|ends| [&ends.from, &ends.to]);
            let mut loose = ends.filter(|end| {
                slots[end.text] == 2
                    && !self.ground.contains_key(end.text)
                    && near.is_none_or(|near| near == end.text)
            });
            if let (Some(end), None) = (loose.next(), loose.next()) {
                fault = fault
                    .and(end.span.clone(), words().named_nowhere_else())
                    .help(words().did_you_mean(end.text));
            } else {
                let help = near.map(|near| words().did_you_mean(near));
                fault = fault
                    .help(help.unwrap_or_else(|| words().carry_it_by_a_link(&point.to_string())));
            }
            self.reader.report(fault);
        }
    }

    fn finish(mut self) -> Option<Resolved> {
        let drafted = defect::ResolvedDraft {
            draft: self.draft,
            slides: &self.built_slides,
            point_names: &self.point_names,
        };
        let mechanism = match std::mem::take(&mut self.builder).build() {
            Ok(mechanism) if self.reader.found.is_empty() => mechanism,
            Ok(_) => return None,
            Err(defects) => {
                drafted.report(self.reader, defects.list());
                return None;
            }
        };
        let links = self.draft.links.iter().map(|link| natural(link.name.text));
        let points = self.point_names.iter();
        let points = points.map(|name| natural(name.as_deref().unwrap_or_default()));
        let mechanism = mechanism.ranked(&links.collect::<Vec<_>>(), &points.collect::<Vec<_>>());
        let settling = ToleranceResolver {
            reader: &mut *self.reader,
            draft: self.draft,
            names: self.names,
            points: &self.points,
            point_names: &self.point_names,
            slides: &self.built_slides,
            mechanism: &mechanism,
        };
        let tolerances = settling.settle();
        let lead = self.leading_point(&mechanism);
        if !self.reader.found.is_empty() {
            return None;
        }
        let limits = self.limit_places;
        let mut places = self.places;
        let mut point_names = self.point_names;
        name_origins(&mechanism, &mut point_names, &mut places);
        let mut vectors = self.vectors;
        vectors.sort_by_key(|(span, _)| span.start);
        let name = |name: &Name<'_>| name.text.to_owned();
        Some(Resolved {
            mechanism,
            vectors: vectors.into_iter().map(|(_, vector)| vector).collect(),
            traces: self.traces,
            lead,
            point_names,
            link_names: self.draft.links.iter().map(|l| name(&l.name)).collect(),
            slide_names: self.built_slides.iter().map(|s| name(&s.name)).collect(),
            limits,
            tolerances,
            places,
        })
    }
}

/// Returns a key for natural sorting: r9 before r10.
fn natural(name: &str) -> (&str, usize, &str) {
    let letters = name.trim_end_matches(|c: char| c.is_ascii_digit());
    let number = &name[letters.len()..];
    (letters, number.len(), number)
}

/// Extends `names` and `places` by the origins added for sliding links. They follow all named
/// points, have no name, and get the place of their slide.
fn name_origins(mechanism: &Mechanism, names: &mut Vec<Option<String>>, places: &mut TextPlaces) {
    names.resize(mechanism.points().len(), None);
    places.points.resize(mechanism.points().len(), 0..0);
    for (slide, span) in mechanism.slides().iter().zip(&places.slides) {
        let origin = slide.slider.point().index();
        if names[origin].is_none() {
            places.points[origin] = span.clone();
        }
    }
}
