//! Reads the loads on the mechanism and resolves the names in them.

use crate::document::{Diagnostic, WrittenValue, items};
use crate::nearest::did_you_mean;
use crate::scene::elements::slide::DraftSlide;
use crate::scene::keys;
use crate::scene::loading::profile;
use crate::scene::names::NameKind;
use crate::scene::numbers::reader::{Name, Reader};
use crate::scene::resolve::Resolver;
use crate::scene::table::KeyTable;
use crate::wording::words;
use crate::{Body, Load, Profile, SlideId, StrokeEnd, Vec2, angle};

const LOAD: ListExample = ["[[loads]]", r#"point = "C""#, "force = [0, -500]"];

/// The heading of a list, and two keys of a table in it.
pub(crate) type ListExample = [&'static str; 3];

pub(crate) fn load_example([list, one, other]: ListExample) -> String {
    words().example_of_list(list, one, other)
}

#[derive(Debug)]
pub(crate) enum DraftLoad<'t> {
    Force {
        point: Name<'t>,
        force: Vec2,
        /// The link that the force turns with; `None` for the ground's frame.
        frame: Option<Name<'t>>,
        over: Profile,
    },
    Torque {
        link: Name<'t>,
        torque: f64,
        over: Profile,
    },
    Press {
        slide: Name<'t>,
        curve: Profile,
        /// `None` if the direction of the guide decides.
        end: Option<StrokeEnd>,
    },
}

/// The kinds of loads, each identified by the key of its magnitude.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum LoadKind {
    Force,
    Torque,
    Press,
}

impl LoadKind {
    const ALL: [LoadKind; 3] = [LoadKind::Force, LoadKind::Torque, LoadKind::Press];

    /// Returns the key of its magnitude, which is also its name.
    fn size(self) -> &'static str {
        match self {
            LoadKind::Force => "force",
            LoadKind::Torque => "torque",
            LoadKind::Press => "press",
        }
    }

    /// Returns the key of the element that it acts on.
    fn on(self) -> &'static str {
        match self {
            LoadKind::Force => "point",
            LoadKind::Torque => "link",
            LoadKind::Press => "slide",
        }
    }

    fn example(self) -> &'static str {
        match self {
            LoadKind::Force => r#"point = "C", force = [0, -500]"#,
            LoadKind::Torque => r#"link = "r4", torque = 12"#,
            LoadKind::Press => r#"slide = "r6", press = [[12, 0], [0, 350e3]]"#,
        }
    }
}

/// Reads the loads. Reports and omits those that could not be read.
pub(crate) fn loads<'v>(
    reader: &mut Reader<'_>,
    value: &'v WrittenValue<'v>,
) -> Vec<DraftLoad<'v>> {
    let items = list(reader, "loads", LOAD, value);
    items.iter().filter_map(|v| load(reader, v)).collect()
}

/// Returns the items of a list of tables. Reports a value that is not a list, and returns an empty
/// slice for it.
pub(crate) fn list<'v>(
    reader: &mut Reader<'_>,
    key: &str,
    example: ListExample,
    value: &'v WrittenValue<'v>,
) -> &'v [WrittenValue<'v>] {
    if let Some(items) = items(value) {
        return items;
    }
    reader.report(
        Diagnostic::new(words().must_be_list_of_tables(key))
            .at(value.span(), words().expected(words().a_list()))
            .help(words().for_example(&load_example(example))),
    );
    &[]
}

fn load<'v>(reader: &mut Reader<'_>, value: &'v WrittenValue<'v>) -> Option<DraftLoad<'v>> {
    let names = [words().a_load(), words().the_load()];
    let table = &reader.open(names, keys::LOAD, &load_example(LOAD), value)?;
    reader.only_known(table);
    let kind = kind(reader, table)?;
    foreign(reader, table, kind);
    let on = reader.text_of(table, kind.on());
    match kind {
        LoadKind::Force => {
            let force = reader.pair_of(table, "force");
            let frame = reader.text_of(table, "frame");
            let over = profile::over(reader, table);
            if frame.is_none() && table.has("frame") {
                return None;
            }
            Some(DraftLoad::Force {
                point: on?,
                force: force?,
                frame,
                over: over?,
            })
        }
        LoadKind::Torque => {
            let torque = reader.number_of(table, "torque");
            let over = profile::over(reader, table);
            Some(DraftLoad::Torque {
                link: on?,
                torque: torque?,
                over: over?,
            })
        }
        LoadKind::Press => {
            let curve = profile::press(reader, table);
            let end = table.has("end").then(|| stroke_end(reader, table));
            Some(DraftLoad::Press {
                slide: on?,
                curve: curve?,
                end: match end {
                    Some(read) => Some(read?),
                    None => None,
                },
            })
        }
    }
}

/// Returns the kind of a load that has a magnitude and an element to act on; reports any other
/// load.
fn kind(reader: &mut Reader<'_>, table: &KeyTable<'_>) -> Option<LoadKind> {
    let given = |kind: LoadKind| Some((kind, table.key(kind.size())?.span));
    let mut sizes = LoadKind::ALL.into_iter().filter_map(given);
    let fault = match (sizes.next(), sizes.next()) {
        (Some((kind, _)), None) if table.has(kind.on()) => return Some(kind),
        (Some((kind, _)), None) => without(table, kind)?,
        (Some((one, first)), Some((other, second))) => {
            Diagnostic::new(words().load_has_both(one.size(), other.size()))
                .at(second, words().a_second_load())
                .and(first, words().one_load())
                .help(words().each_a_load_of_its_own())
        }
        (None, _) => nothing(table)?,
    };
    reader.report(fault);
    None
}

/// Returns the diagnostic of a load without an element to act on; `None` if a misspelt key, already
/// reported, explains it.
fn without(load: &KeyTable<'_>, kind: LoadKind) -> Option<Diagnostic> {
    let (size, on) = (kind.size(), kind.on());
    if load.is_probable_misspelling(on) {
        return None;
    }
    let fault = Diagnostic::new(words().load_has_no_target(size, on))
        .at(load.span.clone(), words().acts_on_what(size))
        .help(words().kinds_of_loads());
    Some(fault.help(words().for_example(kind.example())))
}

/// Returns the diagnostic of a load without a magnitude; `None` if a misspelt key explains it.
fn nothing(load: &KeyTable<'_>) -> Option<Diagnostic> {
    let intended = |kind: &LoadKind| load.is_probable_misspelling(kind.size());
    if LoadKind::ALL.iter().any(intended) {
        return None;
    }
    Some(match load.key("over") {
        Some(key) => Diagnostic::new(words().over_without_size())
            .at(key.span, words().factors_of_what())
            .help(words().over_scales()),
        None => Diagnostic::new(words().load_has_no_size())
            .at(load.span.clone(), words().no_load_here())
            .help(words().kinds_of_loads())
            .help(words().for_example(&load_example(LOAD))),
    })
}

/// Reports keys that belong to another kind of load.
fn foreign(reader: &mut Reader<'_>, table: &KeyTable<'_>, kind: LoadKind) {
    for key in table.strays(kind.size()) {
        let why = match key.text {
            "frame" => words().no_frame_to_turn_with(),
            "over" => words().press_is_given_over_way(),
            "end" => words().only_press_has_end(),
            _ => words().one_load_acts_on_one(),
        };
        let kind = kind.size();
        reader.report(
            Diagnostic::new(words().kind_has_no_key(kind, key.text))
                .at(key.span, words().not_for_kind(kind))
                .help(why),
        );
    }
}

fn stroke_end(reader: &mut Reader<'_>, table: &KeyTable<'_>) -> Option<StrokeEnd> {
    let name = reader.text_of(table, "end")?;
    let end = match name.text {
        "least" => return Some(StrokeEnd::Minimum),
        "greatest" => return Some(StrokeEnd::Maximum),
        _ => Diagnostic::new(words().least_or_greatest(&name.to_string())),
    };
    reader.report(
        end.at(name.span.clone(), words().is_no_end_of_stroke())
            .maybe_help(did_you_mean(name.text, ["least", "greatest"]))
            .help(words().which_ends_there_are()),
    );
    None
}

impl<'t> Resolver<'_, '_, 't> {
    /// Adds all loads, gravity and the unit in metres, which only forces need, to the builder.
    pub(crate) fn loads(&mut self) {
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
                let link = self.link(&of_load("link"), link)?;
                Some(Load::Torque {
                    link,
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
        let frame = self.body(&of_load("frame"), name);
        if frame.is_none() {
            self.reader.help(words().keeps_direction_without_frame());
        }
        frame
    }

    fn press(&mut self, name: &Name<'t>, curve: &Profile, end: Option<StrokeEnd>) -> Option<Load> {
        let what = of_load("slide");
        let index = self.names.find(self.reader, &what, name, NameKind::Slide)?;
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
            return Some(StrokeEnd::Minimum);
        }
        if up < 0.0 {
            return Some(StrokeEnd::Maximum);
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
