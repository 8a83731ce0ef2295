//! The common namespace of points, links, slides and vectors.

use super::keys;
use super::numbers::reader::{ByteSpan, Name, Reader, quoted};
use super::raw_elements::SceneDraft;
use crate::document::Diagnostic;
use crate::expression;
use crate::nearest::did_you_mean;
use crate::wording::words;
use std::collections::{HashMap, HashSet};

/// Names with a special meaning in columns.
const RESERVED: [&str; 4] = ["driver", "ground", "com", "state"];
/// Further names reserved for values and parameters: the time axis, and a mathematical constant.
const RESERVED_IN_FORMULAS: [&str; 2] = ["time", "pi"];
/// Maximum length of a name in bytes, which for valid names equals the number of characters. Names
/// become column headers.
const MAX_LEN: usize = 64;
/// Maximum number of names in a hint.
const MAX_LISTED: usize = 12;

/// The kinds of named elements.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub(crate) enum NameKind {
    Point,
    Link,
    Slide,
    Vector,
    Figure,
    Parameter,
    Limit,
}

impl NameKind {
    const ALL: [NameKind; NameKind::COUNT] = [
        NameKind::Point,
        NameKind::Link,
        NameKind::Slide,
        NameKind::Vector,
        NameKind::Figure,
        NameKind::Parameter,
        NameKind::Limit,
    ];
    const COUNT: usize = 7;

    fn noun(self) -> &'static str {
        match self {
            NameKind::Point => words().noun_point(),
            NameKind::Link => words().noun_link(),
            NameKind::Slide => words().noun_slide(),
            NameKind::Vector => words().noun_vector(),
            NameKind::Figure => words().noun_figure(),
            NameKind::Parameter => words().noun_parameter(),
            NameKind::Limit => words().noun_limit(),
        }
    }
}

struct Symbol {
    /// The position among the elements of its kind, in the order of the draft; for points, in that
    /// of the file.
    index: usize,
    span: ByteSpan,
}

/// All names of a scene.
pub(crate) struct Names<'t> {
    /// The elements of each name, indexed by [`NameKind`]. A name with two meanings keeps both after
    /// the clash has been reported.
    symbols: HashMap<&'t str, [Option<Symbol>; NameKind::COUNT]>,
    points: Vec<(&'t str, ByteSpan)>,
    lost_points: bool,
}

impl<'t> Names<'t> {
    /// Collects every name that the draft defines, in the order of the file. A point is defined by
    /// the ground, a link or a slide that names it. Reports invalid names and clashes.
    pub(crate) fn collect(reader: &mut Reader<'_>, draft: &SceneDraft<'t>) -> Self {
        let mut names = Names {
            symbols: HashMap::new(),
            points: Vec::new(),
            lost_points: draft.lost_points,
        };
        let mut mentions = mentions(draft);
        mentions.sort_by_key(|(name, ..)| name.span.start);
        let mut reported = HashSet::new();
        for (name, sort, index) in mentions {
            let fault = bad(name, sort).or_else(|| names.clash(name, sort));
            if let Some(fault) = fault
                && reported.insert(name.text)
            {
                reader.report(fault);
            }
            names.define(name, sort, index);
        }
        names
    }

    fn define(&mut self, name: &Name<'t>, sort: NameKind, index: usize) {
        let symbol = &mut self.symbols.entry(name.text).or_default()[sort as usize];
        if symbol.is_some() {
            return;
        }
        let span = name.span.clone();
        let index = if sort == NameKind::Point {
            self.points.push((name.text, span.clone()));
            self.points.len() - 1
        } else {
            index
        };
        *symbol = Some(Symbol { index, span });
    }

    fn get(&self, name: &str, sort: NameKind) -> Option<&Symbol> {
        self.symbols.get(name)?[sort as usize].as_ref()
    }

    /// Returns an element of another kind with this name, if any.
    fn other(&self, name: &str, sort: NameKind) -> Option<(NameKind, &Symbol)> {
        let mut others = NameKind::ALL.into_iter().filter(|&other| other != sort);
        others.find_map(|other| Some((other, self.get(name, other)?)))
    }

    fn clash(&self, name: &Name<'_>, sort: NameKind) -> Option<Diagnostic> {
        let (other, known) = self.other(name.text, sort)?;
        let (one, other) = (sort.noun(), other.noun());
        Some(
            Diagnostic::new(words().names_both(&name.to_string(), other, one))
                .at(name.span.clone(), words().named_here(one))
                .and(known.span.clone(), words().named_here(other))
                .help(words().names_are_shared()),
        )
    }

    /// Returns the points in the order of the file, each with the place that first names it.
    pub(crate) fn points(&self) -> impl Iterator<Item = (&'t str, &ByteSpan)> {
        self.points.iter().map(|(name, span)| (*name, span))
    }

    /// Returns the position of a named element of this kind; reports an unknown name, or one of
    /// another kind.
    pub(crate) fn find(
        &self,
        reader: &mut Reader<'_>,
        what: &str,
        name: &Name<'_>,
        sort: NameKind,
    ) -> Option<usize> {
        if let Some(symbol) = self.get(name.text, sort) {
            return Some(symbol.index);
        }
        let kind_name = sort.noun();
        let fault = match self.other(name.text, sort) {
            Some((other, symbol)) => {
                let other = other.noun();
                Diagnostic::new(words().is_another(what, &name.to_string(), other, kind_name))
                    .at(name.span.clone(), words().expected_name_of(kind_name))
                    .and(symbol.span.clone(), words().that_one(other))
            }
            // The name may be defined in an unreadable part.
            None if sort == NameKind::Point && self.lost_points => return None,
            None => Diagnostic::new(words().there_is_no(what, kind_name, &name.to_string()))
                .at(name.span.clone(), words().unknown_noun(kind_name)),
        };
        let help = if keys::find(keys::SCENE, name.text).is_some() {
            Some(words().key_stands_above(name.text))
        } else {
            self.help(reader, name, sort)
        };
        reader.report(fault.maybe_help(help));
        None
    }

    /// Suggests a similar name, or lists the known names.
    fn help(&self, reader: &Reader<'_>, name: &Name<'_>, sort: NameKind) -> Option<String> {
        if reader.is_full() {
            return None;
        }
        let kind_name = sort.noun();
        let mut known: Vec<(&str, usize)> = self
            .symbols
            .iter()
            .filter_map(|(name, by_sort)| {
                let symbol = by_sort[sort as usize].as_ref()?;
                Some((*name, symbol.span.start))
            })
            .collect();
        known.sort_by_key(|&(_, start)| start);
        let known: Vec<&str> = known.into_iter().map(|(name, _)| name).collect();
        let listed = || match known.len() {
            0 => Some(words().scene_has_no(kind_name)),
            1..=MAX_LISTED => {
                let names = format!("`{}`", known.join("`, `"));
                Some(words().those_of_scene(kind_name, &names))
            }
            _ => None,
        };
        did_you_mean(name.text, known.iter().copied()).or_else(listed)
    }
}

/// Returns every definition of a name.
fn mentions<'d, 't>(draft: &'d SceneDraft<'t>) -> Vec<(&'d Name<'t>, NameKind, usize)> {
    let mut all = Vec::new();
    all.extend(draft.ground.iter().map(|p| (&p.name, NameKind::Point, 0)));
    for (i, link) in draft.links.iter().enumerate() {
        all.push((&link.name, NameKind::Link, i));
        all.extend(link.point_names().map(|name| (name, NameKind::Point, 0)));
    }
    for (i, slide) in draft.slides.iter().enumerate() {
        all.push((&slide.name, NameKind::Slide, i));
        all.extend(slide.pin().map(|pin| (pin, NameKind::Point, 0)));
    }
    for (i, vector) in draft.vectors.iter().enumerate() {
        all.push((&vector.name, NameKind::Vector, i));
    }
    for (i, figure) in draft.figures.iter().enumerate() {
        all.push((&figure.name, NameKind::Figure, i));
    }
    for (i, parameter) in draft.parameters.iter().enumerate() {
        all.push((&parameter.name, NameKind::Parameter, i));
    }
    // Other limits have the name of the element that they limit.
    let of_angles = draft.limits.iter().filter(|limit| limit.angle.is_some());
    all.extend(of_angles.map(|limit| (&limit.name, NameKind::Limit, 0)));
    all
}

/// Returns `true` if a value may have this name, as far as the name alone decides.
pub fn is_figure_name(text: &str) -> bool {
    let name = Name { text, span: 0..0 };
    bad(&name, NameKind::Figure).is_none()
}

/// Returns the list of names reserved for values, if `text` is one of them.
pub fn reserved_for_figures(text: &str) -> Option<String> {
    reserved(text, NameKind::Figure)
}

/// Returns the list of names reserved for this kind, if `text` is one of them.
fn reserved(text: &str, sort: NameKind) -> Option<String> {
    let of_formulas = &RESERVED_IN_FORMULAS[..match sort {
        NameKind::Figure | NameKind::Parameter => RESERVED_IN_FORMULAS.len(),
        _ => 0,
    }];
    let all = [&RESERVED, of_formulas].concat();
    let list = || format!("`{}`", all.join("`, `"));
    all.contains(&text).then(list)
}

/// Returns the diagnostic of an invalid name; `None` for a valid one.
fn bad(name: &Name<'_>, sort: NameKind) -> Option<Diagnostic> {
    let text = name.text;
    let fault =
        |message: String, label: &str| Diagnostic::new(message).at(name.span.clone(), label);
    if let Some(list) = reserved(text, sort) {
        let fault = fault(
            words().name_is_reserved(&name.to_string()),
            words().is_reserved(),
        )
        .help(words().columns_use(&list));
        return Some(if text == "ground" && sort == NameKind::Point {
            fault.help(words().name_a_ground_point())
        } else {
            fault
        });
    }
    let read_as = match sort {
        NameKind::Parameter if expression::is_unit(text) => {
            Some(words().formulas_read_a_unit(text))
        }
        NameKind::Parameter if expression::is_function(text) => {
            Some(words().formulas_read_a_function(text))
        }
        _ => None,
    };
    if let Some(help) = read_as {
        let message = words().name_is_reserved(&name.to_string());
        return Some(fault(message, words().is_reserved()).help(help));
    }
    if sort == NameKind::Parameter && text.starts_with(|c: char| c.is_ascii_digit()) {
        let message = words().parameter_reads_as_number(&name.to_string());
        return Some(fault(message, words().is_no_name()).help(words().begin_it_with_a_letter()));
    }
    invalid_part(name)
}

/// Returns the diagnostic of a text that is no valid part of any name; `None` for a valid one.
pub(super) fn invalid_part(name: &Name<'_>) -> Option<Diagnostic> {
    let text = name.text;
    let fits = |c: char| c.is_ascii_alphanumeric() || matches!(c, '_' | '-' | '\'');
    let fault =
        |message: String, label: &str| Diagnostic::new(message).at(name.span.clone(), label);
    if text.is_empty() {
        return Some(fault(words().name_is_empty().into(), words().is_empty()));
    }
    if text.len() > MAX_LEN {
        let count = text.chars().count();
        return Some(fault(
            words().name_is_too_long(&name.to_string(), count, MAX_LEN),
            words().is_too_long(),
        ));
    }
    let odd = text.chars().find(|&c| !fits(c))?;
    Some(
        fault(
            words().name_contains(&name.to_string(), &quoted(&odd.to_string())),
            words().is_no_name(),
        )
        .help(words().names_are_made_of()),
    )
}
