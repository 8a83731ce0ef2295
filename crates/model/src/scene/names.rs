//! The common namespace of points, links, slides and vectors.

use super::draft::SceneDraft;
use super::elements::slide::DraftSlider;
use super::keys;
use super::numbers::reader::{ByteSpan, Name, Reader, quoted};
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
const LISTED: usize = 12;

/// The kinds of named elements.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub(crate) enum Sort {
    Point,
    Link,
    Slide,
    Vector,
    Figure,
    Parameter,
    Limit,
}

impl Sort {
    const ALL: [Sort; Sort::COUNT] = [
        Sort::Point,
        Sort::Link,
        Sort::Slide,
        Sort::Vector,
        Sort::Figure,
        Sort::Parameter,
        Sort::Limit,
    ];
    const COUNT: usize = 7;

    fn noun(self) -> &'static str {
        match self {
            Sort::Point => words().noun_point(),
            Sort::Link => words().noun_link(),
            Sort::Slide => words().noun_slide(),
            Sort::Vector => words().noun_vector(),
            Sort::Figure => words().noun_figure(),
            Sort::Parameter => words().noun_parameter(),
            Sort::Limit => words().noun_limit(),
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
    /// The elements of each name, indexed by [`Sort`]. A name with two meanings keeps both after
    /// the clash has been reported.
    symbols: HashMap<&'t str, [Option<Symbol>; Sort::COUNT]>,
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

    fn define(&mut self, name: &Name<'t>, sort: Sort, index: usize) {
        let symbol = &mut self.symbols.entry(name.text).or_default()[sort as usize];
        if symbol.is_some() {
            return;
        }
        let span = name.span.clone();
        let index = if sort == Sort::Point {
            self.points.push((name.text, span.clone()));
            self.points.len() - 1
        } else {
            index
        };
        *symbol = Some(Symbol { index, span });
    }

    fn get(&self, name: &str, sort: Sort) -> Option<&Symbol> {
        self.symbols.get(name)?[sort as usize].as_ref()
    }

    /// Returns an element of another kind with this name, if any.
    fn other(&self, name: &str, sort: Sort) -> Option<(Sort, &Symbol)> {
        let mut others = Sort::ALL.into_iter().filter(|&other| other != sort);
        others.find_map(|other| Some((other, self.get(name, other)?)))
    }

    fn clash(&self, name: &Name<'_>, sort: Sort) -> Option<Diagnostic> {
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
        sort: Sort,
    ) -> Option<usize> {
        if let Some(symbol) = self.get(name.text, sort) {
            return Some(symbol.index);
        }
        let noun = sort.noun();
        let fault = match self.other(name.text, sort) {
            Some((other, symbol)) => {
                let other = other.noun();
                Diagnostic::new(words().is_another(what, &name.to_string(), other, noun))
                    .at(name.span.clone(), words().expected_name_of(noun))
                    .and(symbol.span.clone(), words().that_one(other))
            }
            // The name may be defined in an unreadable part.
            None if sort == Sort::Point && self.lost_points => return None,
            None => Diagnostic::new(words().there_is_no(what, noun, &name.to_string()))
                .at(name.span.clone(), words().unknown_noun(noun)),
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
    fn help(&self, reader: &Reader<'_>, name: &Name<'_>, sort: Sort) -> Option<String> {
        if reader.is_full() {
            return None;
        }
        let noun = sort.noun();
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
            0 => Some(words().scene_has_no(noun)),
            1..=LISTED => {
                let names = format!("`{}`", known.join("`, `"));
                Some(words().those_of_scene(noun, &names))
            }
            _ => None,
        };
        did_you_mean(name.text, known.iter().copied()).or_else(listed)
    }
}

/// Returns every definition of a name.
fn mentions<'d, 't>(draft: &'d SceneDraft<'t>) -> Vec<(&'d Name<'t>, Sort, usize)> {
    let mut all = Vec::new();
    all.extend(draft.ground.iter().map(|p| (&p.name, Sort::Point, 0)));
    for (i, link) in draft.links.iter().enumerate() {
        all.push((&link.name, Sort::Link, i));
        if let Some(ends) = &link.ends {
            all.extend([(&ends.from, Sort::Point, 0), (&ends.to, Sort::Point, 0)]);
        }
        all.extend(link.points.iter().map(|p| (&p.name, Sort::Point, 0)));
    }
    for (i, slide) in draft.slides.iter().enumerate() {
        all.push((&slide.name, Sort::Slide, i));
        if let Some(DraftSlider::Pin(point)) = &slide.slider {
            all.push((point, Sort::Point, 0));
        }
    }
    for (i, vector) in draft.vectors.iter().enumerate() {
        all.push((&vector.name, Sort::Vector, i));
    }
    for (i, figure) in draft.figures.iter().enumerate() {
        all.push((&figure.name, Sort::Figure, i));
    }
    for (i, parameter) in draft.parameters.iter().enumerate() {
        all.push((&parameter.name, Sort::Parameter, i));
    }
    // Other limits have the name of the element that they limit.
    let of_angles = draft.limits.iter().filter(|limit| limit.angle.is_some());
    all.extend(of_angles.map(|limit| (&limit.name, Sort::Limit, 0)));
    all
}

/// Returns `true` if a value may have this name, as far as the name alone decides.
pub fn is_figure_name(text: &str) -> bool {
    let name = Name { text, span: 0..0 };
    bad(&name, Sort::Figure).is_none()
}

/// Returns the list of names reserved for values, if `text` is one of them.
pub fn reserved_for_figures(text: &str) -> Option<String> {
    reserved(text, Sort::Figure)
}

/// Returns the list of names reserved for this kind, if `text` is one of them.
fn reserved(text: &str, sort: Sort) -> Option<String> {
    let of_formulas = &RESERVED_IN_FORMULAS[..match sort {
        Sort::Figure | Sort::Parameter => RESERVED_IN_FORMULAS.len(),
        _ => 0,
    }];
    let all = [&RESERVED, of_formulas].concat();
    let list = || format!("`{}`", all.join("`, `"));
    all.contains(&text).then(list)
}

/// Returns the diagnostic of an invalid name; `None` for a valid one.
fn bad(name: &Name<'_>, sort: Sort) -> Option<Diagnostic> {
    let text = name.text;
    let fits = |c: char| c.is_ascii_alphanumeric() || matches!(c, '_' | '-' | '\'');
    let fault =
        |message: String, label: &str| Diagnostic::new(message).at(name.span.clone(), label);
    if let Some(list) = reserved(text, sort) {
        let fault = fault(
            words().name_is_reserved(&name.to_string()),
            words().is_reserved(),
        )
        .help(words().columns_use(&list));
        return Some(if text == "ground" && sort == Sort::Point {
            fault.help(words().name_a_ground_point())
        } else {
            fault
        });
    }
    let read_as = match sort {
        Sort::Parameter if expression::is_unit(text) => Some(words().formulas_read_a_unit(text)),
        Sort::Parameter if expression::is_function(text) => {
            Some(words().formulas_read_a_function(text))
        }
        _ => None,
    };
    if let Some(help) = read_as {
        let message = words().name_is_reserved(&name.to_string());
        return Some(fault(message, words().is_reserved()).help(help));
    }
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
    if sort == Sort::Parameter && text.starts_with(|c: char| c.is_ascii_digit()) {
        let message = words().parameter_reads_as_number(&name.to_string());
        return Some(fault(message, words().is_no_name()).help(words().begin_it_with_a_letter()));
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
