//! Joins the names of a draft and builds the mechanism.

use super::diagnostic::Diagnostic;
use super::draft::{self, Draft, Input, Slider, Through};
use super::names::{Names, Sort};
use super::reader::{Name, Reader, Span};
use super::{Places, Vector, VectorKind, defect};
use crate::{Body, Builder, Driver, LinkId, Load, Mechanism, PointId, SlideId, Vec2, mechanism};
use std::collections::HashMap;

/// Everything of a scene that comes from joining names.
pub(super) struct Resolved {
    pub(super) mechanism: Mechanism,
    pub(super) vectors: Vec<Vector>,
    pub(super) point_names: Vec<Option<String>>,
    pub(super) link_names: Vec<String>,
    pub(super) slide_names: Vec<String>,
    pub(super) places: Places,
}

/// Joins names and builds; `None` if anything was or is reported.
pub(super) fn resolve<'t>(
    reader: &mut Reader<'_>,
    draft: &Draft<'t>,
    driver: Span,
) -> Option<Resolved> {
    let names = Names::collect(reader, draft);
    let mut resolver = Resolver {
        reader,
        draft,
        names: &names,
        builder: Mechanism::builder(),
        points: HashMap::new(),
        slides: HashMap::new(),
        point_names: Vec::new(),
        vectors: Vec::new(),
        places: Places {
            driver,
            ..Places::default()
        },
    };
    resolver.points();
    resolver.links();
    resolver.slides();
    resolver.driver();
    resolver.start();
    resolver.vectors();
    resolver.loads();
    resolver.finish()
}

struct Resolver<'r, 's, 't> {
    reader: &'r mut Reader<'s>,
    draft: &'r Draft<'t>,
    names: &'r Names<'t>,
    builder: Builder,
    points: HashMap<&'t str, PointId>,
    slides: HashMap<&'t str, SlideId>,
    point_names: Vec<Option<String>>,
    vectors: Vec<(Span, Vector)>,
    places: Places,
}

impl<'t> Resolver<'_, '_, 't> {
    /// Every named point, in the order in which the file first names it.
    fn points(&mut self) {
        let ground: HashMap<&str, Vec2> = self
            .draft
            .ground
            .iter()
            .map(|p| (p.name.text, p.at))
            .collect();
        for (name, span) in self.names.points() {
            let id = match ground.get(name) {
                Some(at) => self.builder.ground_point(at.x, at.y),
                None => self.builder.moving_point(),
            };
            self.points.insert(name, id);
            self.name_point(name.to_owned(), span.clone());
        }
    }

    fn name_point(&mut self, name: String, span: Span) {
        self.point_names.push(Some(name));
        self.places.points.push(span);
    }

    /// All links, then their centres of mass, so that these follow the joints.
    fn links(&mut self) {
        for (i, link) in self.draft.links.iter().enumerate() {
            let id = match &link.ends {
                Some(ends) => {
                    let (from, to) = (self.points[ends.from.text], self.points[ends.to.text]);
                    let id = self.builder.link(from, to, ends.length);
                    self.push_vector(&link.name, VectorKind::Link(id));
                    id
                }
                None => self.builder.free_link(),
            };
            debug_assert_eq!(id, LinkId::new(i));
            for place in &link.points {
                self.builder
                    .carry(id, self.points[place.name.text], place.at);
            }
            self.builder.mass(id, link.mass, link.inertia);
            self.places.links.push(link.name.span.clone());
        }
        for (i, link) in self.draft.links.iter().enumerate() {
            if let Some((span, at)) = &link.com {
                self.builder.centre_of_mass(LinkId::new(i), *at);
                self.name_point(format!("{}.com", link.name.text), span.clone());
            }
        }
    }

    fn push_vector(&mut self, name: &Name<'t>, kind: VectorKind) {
        let vector = Vector {
            name: name.text.to_owned(),
            kind,
        };
        self.vectors.push((name.span.clone(), vector));
    }

    fn slides(&mut self) {
        for slide in &self.draft.slides {
            let on = self.body(slide);
            let slider = self.slider(slide);
            let Some((on, body)) = on else { continue };
            let (Some(through), Some(slider)) = (self.through(slide, on), slider) else {
                continue;
            };
            let id = match slider {
                Sliding::Pin(point) => self.builder.pin_in_slot(point, body, through, slide.angle),
                Sliding::Link(link, turn) => {
                    self.builder
                        .sliding_link(link, turn, body, through, slide.angle)
                }
            };
            self.slides.insert(slide.name.text, id);
            self.places.slides.push(slide.name.span.clone());
            self.push_vector(&slide.name, VectorKind::Slide(id));
        }
    }

    /// What carries the guide: `None` inside stands for the ground.
    fn body(&mut self, slide: &draft::Slide<'t>) -> Option<(Option<usize>, Body)> {
        if slide.on.text == "ground" {
            return Some((None, Body::Ground));
        }
        let what = format!("`on` of slide {}", slide.name);
        let link = self.names.find(self.reader, &what, &slide.on, Sort::Link)?;
        Some((Some(link), Body::Link(LinkId::new(link))))
    }

    fn slider(&mut self, slide: &draft::Slide<'t>) -> Option<Sliding> {
        match &slide.slider {
            Slider::Pin(point) => Some(Sliding::Pin(self.points[point.text])),
            Slider::Link { link, turn } => {
                let what = format!("`link` of slide {}", slide.name);
                let link = self.names.find(self.reader, &what, link, Sort::Link)?;
                Some(Sliding::Link(LinkId::new(link), *turn))
            }
        }
    }

    /// The point of the guide in the frame of what carries it.
    fn through(&mut self, slide: &draft::Slide<'t>, on: Option<usize>) -> Option<Vec2> {
        let name = match &slide.through {
            Through::At(at) => return Some(*at),
            Through::Point(name) => name,
        };
        let what = format!("`through` of slide {}", slide.name);
        self.names.find(self.reader, &what, name, Sort::Point)?;
        let local = match on {
            None => {
                let ground = self.draft.ground.iter().find(|p| p.name.text == name.text);
                ground.map(|p| p.at)
            }
            Some(link) => self.draft.links[link].local(name.text),
        };
        if local.is_none() {
            let body = if on.is_none() {
                "the ground".to_owned()
            } else {
                format!("link {}", slide.on)
            };
            self.reader.report(
                Diagnostic::new(format!("{what} must be a point of {body}; {name} is not"))
                    .at(name.span.clone(), format!("not a point of {body}"))
                    .and(slide.on.span.clone(), "the guide is fixed to this")
                    .help(format!(
                        "name a point of {body}, or give coordinates in its frame: through = [0, 0]"
                    )),
            );
        }
        local
    }

    fn driver(&mut self) {
        let Some(driver) = &self.draft.driver else {
            return;
        };
        let input = match &driver.input {
            Input::Link(name) => {
                let found = self
                    .names
                    .find(self.reader, "`link` of the driver", name, Sort::Link);
                found.map(|link| mechanism::Input::Turn(LinkId::new(link)))
            }
            Input::Slide(name) => {
                let found =
                    self.names
                        .find(self.reader, "`slide` of the driver", name, Sort::Slide);
                found
                    .and_then(|_| self.slides.get(name.text))
                    .map(|&slide| mechanism::Input::Push(slide))
            }
        };
        if let Some(input) = input {
            self.builder.driver(Driver {
                input,
                start: driver.start,
                speed: driver.speed,
                acceleration: driver.acceleration,
            });
        }
    }

    fn start(&mut self) {
        for place in &self.draft.start {
            let found = self
                .names
                .find(self.reader, "[start]", &place.name, Sort::Point);
            if found.is_none() {
                continue;
            }
            let ground = self
                .draft
                .ground
                .iter()
                .find(|p| p.name.text == place.name.text);
            if let Some(ground) = ground {
                self.reader.report(
                    Diagnostic::new(format!("[start]: {} is a point of the ground", place.name))
                        .at(place.name.span.clone(), "does not move")
                        .and(ground.name.span.clone(), "fixed here")
                        .help("[start] is for moving points; take the line out"),
                );
                continue;
            }
            self.builder.start(self.points[place.name.text], place.at);
        }
    }

    fn vectors(&mut self) {
        for vector in &self.draft.vectors {
            let what = format!("vector {}", vector.name);
            let tail = self.point(&what, &vector.tail);
            let head = self.point(&what, &vector.head);
            let (Some(tail), Some(head)) = (tail, head) else {
                continue;
            };
            if tail == head {
                self.reader.report(
                    Diagnostic::new(format!("{what} runs from {} to itself", vector.tail)).at(
                        vector.head.span.clone(),
                        "a vector needs two different points",
                    ),
                );
            }
            self.push_vector(&vector.name, VectorKind::Between(tail, head));
        }
    }

    fn loads(&mut self) {
        for load in &self.draft.loads {
            match load {
                draft::Load::Force { point, force } => {
                    if let Some(point) = self.point("`point` of the load", point) {
                        self.builder.load(Load::Force {
                            point,
                            force: *force,
                        });
                    }
                }
                draft::Load::Torque { link, torque } => {
                    let found =
                        self.names
                            .find(self.reader, "`link` of the load", link, Sort::Link);
                    if let Some(link) = found {
                        let link = LinkId::new(link);
                        self.builder.load(Load::Torque {
                            link,
                            torque: *torque,
                        });
                    }
                }
            }
        }
        self.builder.gravity(self.draft.gravity);
    }

    /// A point by its name; `r3.com` is the centre of mass of `r3`.
    fn point(&mut self, what: &str, name: &Name<'t>) -> Option<PointId> {
        if name.text.ends_with(".com") {
            let com = self
                .point_names
                .iter()
                .position(|n| n.as_deref() == Some(name.text));
            if let Some(com) = com {
                return Some(PointId::new(com));
            }
        }
        self.names.find(self.reader, what, name, Sort::Point)?;
        self.points.get(name.text).copied()
    }

    fn finish(self) -> Option<Resolved> {
        let Resolver {
            reader,
            draft,
            mut point_names,
            mut vectors,
            mut places,
            builder,
            ..
        } = self;
        let mechanism = match builder.build() {
            Ok(mechanism) if reader.found.is_empty() => mechanism,
            Ok(_) => return None,
            Err(defects) => {
                defect::report(reader, draft, &places, &point_names, &defects);
                return None;
            }
        };
        // The origins of sliding links have no name; they follow all named points.
        point_names.resize(mechanism.points().len(), None);
        places.points.resize(mechanism.points().len(), 0..0);
        for (slide, span) in mechanism.slides().iter().zip(&places.slides) {
            let origin = slide.slider.point().index();
            if point_names[origin].is_none() {
                places.points[origin] = span.clone();
            }
        }
        vectors.sort_by_key(|(span, _)| span.start);
        Some(Resolved {
            mechanism,
            vectors: vectors.into_iter().map(|(_, vector)| vector).collect(),
            point_names,
            link_names: draft.links.iter().map(|l| l.name.text.to_owned()).collect(),
            slide_names: draft
                .slides
                .iter()
                .map(|s| s.name.text.to_owned())
                .collect(),
            places,
        })
    }
}

enum Sliding {
    Pin(PointId),
    Link(LinkId, f64),
}
