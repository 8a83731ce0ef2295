//! Reads tolerances and clearances, and decides which of them applies to which length.

use crate::document::{Diagnostic, WrittenValue};
use crate::nearest::did_you_mean;
use crate::scene::Unit;
use crate::scene::accuracy::general_tolerance::{GeneralSizes, GeneralTolerance};
use crate::scene::elements::slide::DraftSlide;
use crate::scene::names::{NameKind, Names};
use crate::scene::numbers::reader::{ByteSpan, Name, Reader, quoted};
use crate::scene::raw_elements::SceneDraft;
use crate::scene::table::{KeyTable, NumberRule};
use crate::wording::words;
use crate::{Length, LinkId, Mechanism, PointId, Slider, Tolerances};
use std::cmp::Reverse;
use std::collections::HashMap;

/// A tolerance of a length, with its place in the file.
#[derive(Clone, Debug)]
pub(crate) struct DraftTolerance {
    size: AllowedDeviation,
    span: ByteSpan,
}

/// The clearance of a pin, with its place in the file.
#[derive(Clone, Debug)]
pub(crate) struct DraftClearance {
    size: f64,
    span: ByteSpan,
}

/// A tolerance as given in the file.
#[derive(Clone, Copy, Debug)]
pub(crate) enum AllowedDeviation {
    /// A deviation in the scene's unit.
    Size(f64),
    Class(GeneralTolerance),
}

impl AllowedDeviation {
    /// Returns the permissible deviation of a length of size `nominal`, both in the scene's unit;
    /// `mm` is that unit in mm. A coordinate of 0 is exact under a class, because it has no size.
    ///
    /// # Errors
    /// Returns the class if it has no deviation for this size.
    pub(crate) fn of(self, nominal: f64, mm: f64) -> Result<f64, GeneralTolerance> {
        match self {
            AllowedDeviation::Size(size) => Ok(size),
            AllowedDeviation::Class(_) if nominal == 0.0 => Ok(0.0),
            AllowedDeviation::Class(class) => {
                let deviation = class.deviation(nominal * mm);
                deviation.map(|deviation| deviation / mm).ok_or(class)
            }
        }
    }
}

/// Returns `true` if a deviation of `by` could make a length zero; never for a coordinate.
pub(crate) fn is_beyond(length: Length, nominal: f64, by: f64) -> bool {
    matches!(length, Length::Link(_) | Length::Arm(..)) && by >= nominal
}

/// Parses the designation of a class. Returns `None` if the text does not look like one, and a
/// message that lists the known classes if the class is unknown.
pub(crate) fn designated(text: &str) -> Option<Result<GeneralTolerance, String>> {
    names_class(text).then(|| {
        GeneralTolerance::designated(text.trim()).ok_or_else(|| {
            let all = GeneralTolerance::designations();
            words().known_general_tolerances(&format!("\"{}\"", all.join("\", \"")))
        })
    })
}

/// Returns the message that a class has no deviation for a size in mm.
pub(crate) fn unsized_by(class: GeneralTolerance, what: &str, mm: f64) -> String {
    let GeneralSizes {
        least: minimum,
        is_above,
        greatest: maximum,
    } = class.sizes();
    let sizes = match is_above {
        true => words().sizes_over_to(minimum, maximum),
        false => words().sizes_from_to(minimum, maximum),
    };
    words().no_deviation_of_size(&class.designation(), what, mm, &sizes)
}

/// All tolerances and clearances except those given in links and slides.
#[derive(Debug, Default)]
pub(crate) struct DraftTolerances<'t> {
    pub(crate) general: Option<DraftTolerance>,
    pub(crate) points: Vec<(Name<'t>, DraftTolerance)>,
    pub(crate) clearance: Option<DraftClearance>,
    pub(crate) pins: Vec<(Name<'t>, DraftClearance)>,
    /// The names and tolerances of the links that are the frame.
    pub(crate) of_frame: Vec<(String, DraftTolerance)>,
}

/// Reads the tolerance of the element that a table describes.
pub(crate) fn tolerance_of(
    reader: &mut Reader<'_>,
    table: &KeyTable<'_>,
) -> Option<DraftTolerance> {
    let what = table.what(reader, "tolerance");
    tolerance(reader, &what, table.get("tolerance")?)
}

/// Reads a tolerance: a number, or a class of ISO 2768.
fn tolerance(
    reader: &mut Reader<'_>,
    what: &str,
    value: &WrittenValue<'_>,
) -> Option<DraftTolerance> {
    let span = value.span();
    let size = match value.get_ref().as_str() {
        Some(text) if names_class(text) => {
            AllowedDeviation::Class(class(reader, what, text, &span)?)
        }
        _ => AllowedDeviation::Size(reader.measured(what, "", NumberRule::Deviation, value)?),
    };
    Some(DraftTolerance { size, span })
}

/// Returns `true` if a text is, or looks like, a class of the standard; any other text is a
/// formula.
fn names_class(text: &str) -> bool {
    let starts = text.trim_start().get(..3);
    starts
        .is_some_and(|start| start.eq_ignore_ascii_case("iso") || start == "DIN" || start == "276")
        || GeneralTolerance::designated(text).is_some()
}

fn class(
    reader: &mut Reader<'_>,
    what: &str,
    text: &str,
    span: &ByteSpan,
) -> Option<GeneralTolerance> {
    let class = GeneralTolerance::designated(text);
    if class.is_none() {
        let all = GeneralTolerance::designations();
        let near = did_you_mean(text, all.iter().map(String::as_str));
        reader.report(
            Diagnostic::new(words().no_general_tolerance(what, &quoted(text)))
                .at(span.clone(), words().unknown_general_tolerance())
                .maybe_help(near)
                .help(words().known_general_tolerances(&format!("\"{}\"", all.join("\", \"")))),
        );
    }
    class
}

/// Reads `[tolerances]`.
pub(crate) fn points<'v>(
    reader: &mut Reader<'_>,
    value: &'v WrittenValue<'v>,
) -> Vec<(Name<'v>, DraftTolerance)> {
    let entries = reader.entries("[tolerances]", "A = 0.05", value);
    let read = |(name, value): (Name<'v>, &WrittenValue<'_>)| {
        let what = words().tolerance_of_point(&name.to_string());
        let read = tolerance(reader, &what, value)?;
        Some((name, read))
    };
    entries.filter_map(read).collect()
}

/// Reads `[clearances]`.
pub(crate) fn pins<'v>(
    reader: &mut Reader<'_>,
    value: &'v WrittenValue<'v>,
) -> Vec<(Name<'v>, DraftClearance)> {
    let entries = reader.entries("[clearances]", "B = 0.02", value);
    let read = |(name, value): (Name<'v>, &WrittenValue<'_>)| {
        let what = words().clearance_of_pin(&name.to_string());
        Some((name, clearance(reader, &what, value)?))
    };
    entries.filter_map(read).collect()
}

/// Reads the clearance of one pin, or of all.
pub(crate) fn clearance(
    reader: &mut Reader<'_>,
    what: &str,
    value: &WrittenValue<'_>,
) -> Option<DraftClearance> {
    Some(DraftClearance {
        size: reader.measured(what, "", NumberRule::Deviation, value)?,
        span: value.span(),
    })
}

/// The inputs needed to resolve the tolerances of a scene.
pub(crate) struct ToleranceResolver<'r, 's, 't> {
    pub(crate) reader: &'r mut Reader<'s>,
    pub(crate) draft: &'r SceneDraft<'t>,
    pub(crate) names: &'r Names<'t>,
    pub(crate) points: &'r HashMap<&'t str, PointId>,
    pub(crate) point_names: &'r [Option<String>],
    pub(crate) slides: &'r [&'r DraftSlide<'t>],
    pub(crate) mechanism: &'r Mechanism,
}

impl<'r> ToleranceResolver<'r, '_, '_> {
    /// Returns the tolerance of every length and the clearance of every pin.
    pub(crate) fn settle(mut self) -> Tolerances {
        for (name, tolerance) in &self.draft.tolerances.of_frame {
            self.reader.report(
                Diagnostic::new(words().frame_has_no_tolerance(name))
                    .at(tolerance.span.clone(), words().is_of_the_frame())
                    .help(words().give_ground_points_tolerances()),
            );
        }
        self.unused_slides();
        let own = self.own_tolerances();
        let mut lengths = Vec::new();
        for length in self.mechanism.lengths() {
            if let Some(tolerance) = self.of(length, &own) {
                lengths.push((length, self.size(length, tolerance)));
            }
        }
        Tolerances {
            lengths,
            clearances: self.clearances(),
        }
    }

    /// Reports tolerances of guides through a named point: they have no coordinates that could be
    /// off.
    fn unused_slides(&mut self) {
        for (slide, id) in self.slides.iter().zip(self.mechanism.slide_ids()) {
            let is_named = self.mechanism.slide(id).named.is_some();
            if let Some(tolerance) = slide.tolerance.as_ref().filter(|_| is_named) {
                let of = words().slide_called(&slide.name.to_string());
                self.reader.report(
                    Diagnostic::new(words().guide_has_no_tolerance(&of))
                        .at(tolerance.span.clone(), words().nothing_to_be_off())
                        .help(words().give_point_of_guide_tolerance()),
                );
            }
        }
    }

    /// Returns the tolerances given for single points. Reports points without coordinates of their
    /// own.
    fn own_tolerances(&mut self) -> HashMap<PointId, &'r DraftTolerance> {
        let mut own = HashMap::new();
        for (name, tolerance) in &self.draft.tolerances.points {
            let Some(point) = self.point("[tolerances]", name) else {
                continue;
            };
            let mut lengths = self.mechanism.lengths().into_iter();
            if !lengths.any(|length| placed(length) == Some(point)) {
                let what = words().tolerance_of_point(&name.to_string());
                self.reader.report(
                    Diagnostic::new(words().point_has_no_coordinates(&what))
                        .at(name.span.clone(), words().nothing_to_be_off())
                        .help(words().give_link_a_tolerance()),
                );
            }
            own.insert(point, tolerance);
        }
        own
    }

    fn point(&mut self, section: &str, name: &Name<'_>) -> Option<PointId> {
        self.names
            .find(self.reader, section, name, NameKind::Point)?;
        self.points.get(name.text).copied()
    }

    /// Returns the most specific tolerance of a length, if any: of its point, its element or the
    /// scene.
    fn of(
        &self,
        length: Length,
        own: &HashMap<PointId, &'r DraftTolerance>,
    ) -> Option<&'r DraftTolerance> {
        let draft = self.draft;
        let owner = match length {
            Length::Link(link)
            | Length::Local(link, ..)
            | Length::Arm(link, _)
            | Length::Across(link, _) => draft.links[link.index()].tolerance.as_ref(),
            Length::Through(slide, _) => self.slides[slide.index()].tolerance.as_ref(),
            Length::Ground(..) => None,
        };
        let point = placed(length).and_then(|point| own.get(&point).copied());
        point.or(owner).or(draft.tolerances.general.as_ref())
    }

    /// Returns the deviation of a length, in the scene's unit.
    fn size(&mut self, length: Length, tolerance: &DraftTolerance) -> f64 {
        let nominal = self.mechanism.given(length).abs();
        let mm = self.draft.unit.in_units_of(Unit::Millimetre);
        let size = tolerance.size.of(nominal, mm).unwrap_or_else(|class| {
            self.report_unsized(length, tolerance, class, nominal * mm);
            0.0
        });
        if is_beyond(length, nominal, size) {
            let what = self.called(length);
            let literal = self.reader.literal(&tolerance.span);
            self.reader.report(
                Diagnostic::new(words().tolerance_beyond_length(&what, nominal, &literal))
                    .at(tolerance.span.clone(), words().is_too_large())
                    .and(self.place(length), words().of_this_length())
                    .help(words().give_it_its_own_tolerance()),
            );
        }
        size
    }

    fn report_unsized(
        &mut self,
        length: Length,
        tolerance: &DraftTolerance,
        class: GeneralTolerance,
        mm: f64,
    ) {
        let what = self.called(length);
        self.reader.report(
            Diagnostic::new(unsized_by(class, &what, mm))
                .at(self.place(length), words().of_this_length())
                .and(tolerance.span.clone(), words().by_this_class())
                .help(words().give_it_its_own_tolerance()),
        );
    }

    /// Returns the name of a length in messages.
    fn called(&self, length: Length) -> String {
        let point = |point: PointId| {
            let name = self.point_names[point.index()].as_deref();
            quoted(name.unwrap_or_default())
        };
        let link =
            |link: LinkId| words().link_called(&self.draft.links[link.index()].name.to_string());
        match length {
            Length::Link(id) => words().key_of("length", &link(id)),
            Length::Local(id, of, _) | Length::Arm(id, of) | Length::Across(id, of) => {
                format!("{} {}", words().point_in(&link(id)), point(of))
            }
            Length::Ground(of, _) => format!("{} {}", words().ground_point(), point(of)),
            Length::Through(slide, _) => {
                let name = self.slides[slide.index()].name.to_string();
                words().key_of("through", &words().slide_called(&name))
            }
        }
    }

    /// Returns the place in the text of the element that a length belongs to.
    fn place(&self, length: Length) -> ByteSpan {
        match length {
            Length::Link(link)
            | Length::Local(link, ..)
            | Length::Arm(link, _)
            | Length::Across(link, _) => self.draft.links[link.index()].name.span.clone(),
            Length::Through(slide, _) => self.slides[slide.index()].name.span.clone(),
            Length::Ground(point, _) => {
                let name = self.point_names[point.index()].as_deref();
                let mut all = self.draft.ground.iter();
                let found = all.find(|place| Some(place.name.text) == name);
                found
                    .map(|place| place.name.span.clone())
                    .unwrap_or_default()
            }
        }
    }

    /// Returns the clearance of every pin, once for each link with play.
    fn clearances(&mut self) -> Vec<(LinkId, PointId, f64)> {
        let mut own: HashMap<PointId, &DraftClearance> = HashMap::new();
        for (name, size) in &self.draft.tolerances.pins {
            let Some(point) = self.point("[clearances]", name) else {
                continue;
            };
            if links_with_play(self.mechanism, point).is_empty() {
                let what = words().clearance_of_pin(&name.to_string());
                self.reader.report(
                    Diagnostic::new(words().is_no_pin(&what))
                        .at(name.span.clone(), words().joins_nothing())
                        .help(words().pins_join()),
                );
            }
            own.insert(point, size);
        }
        let all = self.draft.tolerances.clearance.as_ref();
        let mut clearances = Vec::new();
        for point in self.mechanism.point_ids() {
            let Some(given) = own
                .get(&point)
                .copied()
                .or(all)
                .filter(|given| given.size > 0.0)
            else {
                continue;
            };
            let links = links_with_play(self.mechanism, point);
            if !links.is_empty() {
                self.shorter_than(point, given);
            }
            clearances.extend(links.into_iter().map(|link| (link, point, given.size)));
        }
        clearances
    }

    /// Reports a pin whose clearance is not smaller than a length that ends there: the link could
    /// have any angle.
    fn shorter_than(&mut self, pin: PointId, clearance: &DraftClearance) {
        let ends_there = |length: &Length| match *length {
            Length::Link(link) => {
                let ends = self.mechanism.link(link).ends;
                ends.is_some_and(|(from, to)| from == pin || to == pin)
            }
            Length::Arm(_, point) => point == pin,
            _ => false,
        };
        let sized = |length: Length| (length, self.mechanism.given(length).abs());
        let lengths = self.mechanism.lengths().into_iter();
        let shortest = lengths.filter(ends_there).map(sized);
        let shortest = shortest.min_by(|(_, a), (_, b)| a.total_cmp(b));
        let Some((length, nominal)) = shortest.filter(|(_, nominal)| clearance.size >= *nominal)
        else {
            return;
        };
        let name = self.point_names[pin.index()].as_deref();
        let what = words().clearance_of_pin(&quoted(name.unwrap_or_default()));
        let literal = self.reader.literal(&clearance.span);
        let of = self.called(length);
        self.reader.report(
            Diagnostic::new(words().clearance_beyond_length(&what, &of, nominal, &literal))
                .at(clearance.span.clone(), words().is_too_large())
                .and(self.place(length), words().of_this_length())
                .help(words().give_it_its_own_clearance()),
        );
    }
}

/// Returns the point whose coordinate or arm a length is; `None` for other lengths.
fn placed(length: Length) -> Option<PointId> {
    match length {
        Length::Ground(point, _)
        | Length::Local(_, point, _)
        | Length::Arm(_, point)
        | Length::Across(_, point) => Some(point),
        Length::Link(_) | Length::Through(..) => None,
    }
}

/// Returns the links with play at a pin. A pin fixed to the ground or moving in a slot has play in
/// each of its links. Any other pin is fixed in one link. That is a sliding link with its origin at
/// the pin, since the slide is measured from there; if there is none, the link of the lowest rank.
fn links_with_play(mechanism: &Mechanism, point: PointId) -> Vec<LinkId> {
    let mut links = mechanism.point(point).links.clone();
    links.sort_by_key(|&link| mechanism.link_rank(link));
    let sliders = || mechanism.slides().iter().map(|slide| slide.slider);
    let in_slot = |slider: Slider| matches!(slider, Slider::Pin(pin) if pin == point);
    if mechanism.point(point).ground.is_some() || sliders().any(in_slot) {
        return links;
    }
    let is_origin = |of: LinkId| {
        let is_its = |slider| matches!(slider, Slider::Link { link, origin, .. } if (link, origin) == (of, point));
        sliders().any(is_its)
    };
    let rank = |&link: &LinkId| (Reverse(is_origin(link)), mechanism.link_rank(link));
    let holder = links.iter().copied().min_by_key(rank);
    links.retain(|&link| Some(link) != holder);
    links
}

#[cfg(test)]
mod tests {
    use crate::scene::Scene;

    /// The coarsest class starts above 3 mm. It has no value for 3 mm itself, and the message says
    /// so.
    #[test]
    fn very_coarse_class_reports_open_lower_limit() {
        let text = SCENE
            .replace("ISO 2768-m", "ISO 2768-v")
            .replace("[40, 0.2]", "[40, 0.3]");
        let shown_text = Scene::parse(&text, "t.toml").unwrap_err().to_string();
        assert!(
            shown_text.contains("it covers over 3 up to 4000 mm"),
            "{shown_text}"
        );
    }

    const SCENE: &str = r#"
unit = "cm"
tolerance = "ISO 2768-m"
clearance = 0.002
[ground]
A = [0, 0]
D = [40, 0.2]
[driver]
link = "crank"
angle = 60
speed = "1 rad/s"
[links]
crank = { from = "A", to = "B", length = 10 }
coupler = { from = "B", to = "C", length = 30, tolerance = 0.03, points = { P = [15, 8], Q = [5, 0] } }
rocker = { from = "C", to = "D", length = 25, tolerance = "ISO 2768-f" }
rod = { from = "P", to = "E", length = 12 }
[slides]
ram = { point = "E", on = "ground", through = [30, -20], angle = 90, tolerance = 0.05 }
[start]
C = [31, 23]
E = [30, 20]
[tolerances]
P = 0.001
A = 0
[clearances]
C = 0
P = 0.004
"#;

    /// Classes use the table of the standard. Every length has the most specific tolerance given
    /// for it.
    #[test]
    fn each_length_uses_most_specific_tolerance() {
        let scene = Scene::parse(SCENE, "t.toml").unwrap();
        let text = scene.tolerances().lengths.iter();
        let text = text.map(|&(length, by)| (scene.mechanism.given(length), by));
        let found: Vec<(f64, f64)> = text.collect();
        // Ordered by kind, then by name.
        let expected = [
            // Ground: A has its own; 400 mm are +-0.5 mm, 2 mm are +-0.1 mm.
            (0.0, 0.0),
            (40.0, 0.05),
            (0.0, 0.0),
            (0.2, 0.01),
            // The coupler has its own.
            (30.0, 0.03),
            // 100 mm: +-0.3 mm.
            (10.0, 0.03),
            // 250 mm, fine: +-0.2 mm.
            (25.0, 0.02),
            // 120 mm: +-0.3 mm.
            (12.0, 0.03),
            // P has its own; Q has that of the coupler.
            (15.0, 0.001),
            (5.0, 0.03),
            (8.0, 0.001),
            (0.0, 0.03),
            (30.0, 0.05),
            (-20.0, 0.05),
        ];
        assert_eq!(found, expected);
    }

    /// Each pin appears once: those on the ground, between two links and in a slot. C has no
    /// clearance.
    #[test]
    fn each_joint_pin_has_one_clearance() {
        let scene = Scene::parse(SCENE, "t.toml").unwrap();
        let text = scene.tolerances().clearances.iter();
        let text = text.map(|&(link, point, by)| {
            let point = scene.point_name(point).unwrap();
            (point, scene.link_name(link), by)
        });
        let found: Vec<(&str, &str, f64)> = text.collect();
        let expected = [
            ("A", "crank", 0.002),
            ("B", "crank", 0.002),
            ("D", "rocker", 0.002),
            ("E", "rod", 0.002),
            ("P", "rod", 0.004),
        ];
        assert_eq!(found, expected);
    }
}
