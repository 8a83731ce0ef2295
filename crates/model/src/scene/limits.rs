//! Reads limits: minimum and maximum of coordinates.
//!
//! ```toml
//! [limits]
//! rod = [120, 200]
//! elbow = { link = "r4", from = "r3", angle = [20, 160] }
//! ```

use super::draft::SceneDraft;
use super::names::Sort;
use super::reader::{ByteSpan, CoordinatePair, Name, Reader};
use super::resolve::Resolver;
use crate::angle::TURN;
use crate::document::{Diagnostic, Entries, Lenient, Misplaced, meant};
use crate::mechanism::MAX_TURNS;
use crate::nearest::did_you_mean;
use crate::wording::words;
use crate::{Body, Limit, LimitOf, LinkId};
use serde::de::{IgnoredAny, MapAccess, SeqAccess, Visitor};
use serde::{Deserialize, Deserializer};
use std::fmt;

/// The keys of a limited angle.
pub(super) const ANGLE_KEYS: [&str; 3] = ["link", "from", "angle"];
const ANGLE: &str = r#"{ link = "r4", from = "r3", angle = [20, 160] }"#;
const PAIR: (&str, &str) = ("[low, high]", "[120, 200]");

/// The section `[limits]` as written.
pub(super) type LimitEntries = Lenient<Entries<Lenient<WrittenLimit>>>;

/// A limit of the element with its name, or of the angle of a link.
#[derive(Debug)]
pub(super) enum WrittenLimit {
    Pair(Vec<Lenient<f64>>),
    Angle(Box<AngleTable>),
}

/// A limited angle as written.
#[derive(Debug, Default)]
pub(super) struct AngleTable {
    link: Option<Lenient<String>>,
    from: Option<Lenient<String>>,
    angle: Option<CoordinatePair>,
}

impl<'de> Deserialize<'de> for WrittenLimit {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        deserializer.deserialize_any(PairOrAngle)
    }
}

/// Accepts a list or a table only.
struct PairOrAngle;

impl<'de> Visitor<'de> for PairOrAngle {
    type Value = WrittenLimit;

    fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str("a list or a table")
    }

    fn visit_seq<A: SeqAccess<'de>>(self, mut list: A) -> Result<WrittenLimit, A::Error> {
        let mut items = Vec::new();
        while let Some(item) = list.next_element()? {
            items.push(item);
        }
        Ok(WrittenLimit::Pair(items))
    }

    fn visit_map<A: MapAccess<'de>>(self, mut map: A) -> Result<WrittenLimit, A::Error> {
        let mut table = AngleTable::default();
        while let Some(key) = map.next_key::<String>()? {
            match key.as_str() {
                "link" => table.link = Some(map.next_value()?),
                "from" => table.from = Some(map.next_value()?),
                "angle" => table.angle = Some(map.next_value()?),
                // The key is reported as unknown, so its value does not matter.
                _ => drop(map.next_value::<Lenient<IgnoredAny>>()?),
            }
        }
        Ok(WrittenLimit::Angle(Box::new(table)))
    }
}

/// The two ends of a range in ascending order, with their place in the file.
#[derive(Debug)]
pub(super) struct DraftEnds {
    pub(super) low: f64,
    pub(super) high: f64,
    pub(super) place: ByteSpan,
}

#[derive(Debug)]
pub(super) struct DraftLimit<'t> {
    pub(super) name: Name<'t>,
    /// The link and its reference body; `None` if the limit has the name of the element that it
    /// limits.
    pub(super) angle: Option<(Name<'t>, Option<Name<'t>>)>,
    ends: DraftEnds,
}

/// Reads the section. Reports and omits limits that could not be read.
pub(super) fn limits<'v>(reader: &mut Reader<'_>, value: &'v LimitEntries) -> Vec<DraftLimit<'v>> {
    reader.table("[limits]", "{ r4 = [30, 150] }", value);
    let read = |(name, value)| limit(reader, name, value);
    value.entries().filter_map(read).collect()
}

fn limit<'v>(
    reader: &mut Reader<'_>,
    name: Name<'v>,
    value: &'v Lenient<WrittenLimit>,
) -> Option<DraftLimit<'v>> {
    let what = words().limit_called(&name.to_string());
    let (angle, ends) = match &value.read {
        Ok(WrittenLimit::Pair(items)) => (None, ends(reader, &what, items, &value.span)),
        Ok(WrittenLimit::Angle(table)) => {
            reader.only_these(&what, &value.keys, &ANGLE_KEYS);
            let (link, from, ends) = limited_angle(reader, &what, &name, value, table)?;
            (Some((link, from)), Some(ends))
        }
        Err(found) => {
            not_a_limit(reader, &what, found, &value.span);
            return None;
        }
    };
    let ends = ends?;
    Some(DraftLimit { name, angle, ends })
}

fn not_a_limit(reader: &mut Reader<'_>, what: &str, found: &Misplaced, place: &ByteSpan) {
    let fault = reader.wrong_type(what, &words().a_pair(PAIR.0), found, place);
    let fault = fault.help(words().for_example(PAIR.1));
    reader.report(fault.help(words().or_angle_of_link(ANGLE)));
}

type LimitedAngle<'v> = (Name<'v>, Option<Name<'v>>, DraftEnds);

fn limited_angle<'v>(
    reader: &mut Reader<'_>,
    what: &str,
    owner: &Name<'_>,
    value: &Lenient<WrittenLimit>,
    table: &'v AngleTable,
) -> Option<LimitedAngle<'v>> {
    for (key, is_given) in [
        ("link", table.link.is_some()),
        ("angle", table.angle.is_some()),
    ] {
        // A misspelt key was already reported; do not report the missing key as well.
        if !is_given && !meant(&value.keys, &ANGLE_KEYS, key) {
            reader.report(
                Diagnostic::new(words().of_has_no(what, key))
                    .at(owner.span.clone(), words().is_missing(key))
                    .help(words().for_example(ANGLE)),
            );
        }
    }
    let link = reader.text_of("link", what, table.link.as_ref());
    let from = reader.text_of("from", what, table.from.as_ref());
    let is_lost = table.from.is_some() && from.is_none();
    let key = words().key_of("angle", what);
    let ends = range(reader, &key, table.angle.as_ref()?);
    (!is_lost).then_some((link?, from, ends?))
}

/// Reads the two ends of a range.
pub(super) fn range(
    reader: &mut Reader<'_>,
    what: &str,
    value: &CoordinatePair,
) -> Option<DraftEnds> {
    match &value.read {
        Ok(items) => ends(reader, what, items, &value.span),
        Err(found) => {
            let fault = reader.wrong_type(what, &words().a_pair(PAIR.0), found, &value.span);
            reader.report(fault.help(words().for_example(PAIR.1)));
            None
        }
    }
}

fn ends(
    reader: &mut Reader<'_>,
    what: &str,
    items: &[Lenient<f64>],
    place: &ByteSpan,
) -> Option<DraftEnds> {
    let [low, high] = reader.two_of(what, PAIR, items, place)?;
    let low = reader.number(&words().low_end_of(what), low);
    let high = reader.number(&words().high_end_of(what), high);
    let (low, high) = (low?, high?);
    let place = place.clone();
    if low < high {
        return Some(DraftEnds { low, high, place });
    }
    let literal = reader.literal(&place);
    let help = match low == high {
        true => words().nothing_moves_between().to_owned(),
        false => words().ends_the_other_way(&format!("[{high}, {low}]")),
    };
    reader.report(
        Diagnostic::new(words().ends_must_rise(what, &literal))
            .at(place, words().lower_end_first())
            .help(help),
    );
    None
}

/// Reports a driver's range with more turns than can be listed.
pub(super) fn check_turns(reader: &mut Reader<'_>, what: &str, ends: &DraftEnds) {
    let most = MAX_TURNS * TURN;
    // Negated, so that an overflow is rejected too.
    if !(ends.high - ends.low < most) {
        reader.report(
            Diagnostic::new(words().range_of_too_many_turns(what, most))
                .at(ends.place.clone(), words().is_too_wide())
                .help(words().leave_range_out()),
        );
    }
}

/// The names and places of the limits, in the order of the mechanism's ids.
pub(super) type LimitPlaces = Vec<(String, ByteSpan)>;

impl<'t> Resolver<'_, '_, 't> {
    /// Adds the driver's range and the limits of `[limits]` to the builder.
    pub(super) fn limits(&mut self) {
        let draft: &SceneDraft<'t> = self.draft;
        if let Some(ends) = draft.driver.as_ref().and_then(|d| d.range.as_ref()) {
            self.push_limit("driver".to_owned(), LimitOf::Driver, ends);
        }
        for limit in &draft.limits {
            let of = match &limit.angle {
                None => self.named(limit),
                Some((link, from)) => self.seen(limit, link, from.as_ref()),
            };
            let Some(of) = of else { continue };
            if let LimitOf::Angle { .. } = of
                && !(limit.ends.high - limit.ends.low < TURN)
            {
                self.too_wide(limit);
            }
            self.push_limit(limit.name.text.to_owned(), of, &limit.ends);
        }
    }

    fn push_limit(&mut self, name: String, of: LimitOf, ends: &DraftEnds) {
        let (low, high) = (ends.low, ends.high);
        self.builder.limit(Limit { of, low, high });
        self.limit_places.push((name, ends.place.clone()));
    }

    /// Returns the element that a limit is named after: a slide, or a link relative to the ground.
    /// Reports an unknown name, and returns `None`.
    fn named(&mut self, limit: &DraftLimit<'t>) -> Option<LimitOf> {
        let name = limit.name.text;
        if let Some(&slide) = self.slides.get(name) {
            return Some(LimitOf::Slide(slide));
        }
        let links = &self.draft.links;
        if let Some(link) = links.iter().position(|l| l.name.text == name) {
            let (link, from) = (LinkId::new(link), Body::Ground);
            return Some(LimitOf::Angle { link, from });
        }
        let slides = &self.draft.slides;
        if slides.iter().any(|s| s.name.text == name) {
            // The unreadable slide was already reported.
            return None;
        }
        let known = links.iter().map(|l| l.name.text);
        let known = known.chain(slides.iter().map(|s| s.name.text));
        let fault = Diagnostic::new(words().limit_of_nothing(&limit.name.to_string()))
            .at(limit.name.span.clone(), words().neither_link_nor_slide())
            .maybe_help(did_you_mean(name, known));
        self.reader
            .report(fault.help(words().or_angle_of_link(ANGLE)));
        None
    }

    /// Returns the angle of a link relative to another link or the ground. Reports invalid links,
    /// and returns `None`.
    fn seen(
        &mut self,
        limit: &DraftLimit<'t>,
        link: &Name<'t>,
        from: Option<&Name<'t>>,
    ) -> Option<LimitOf> {
        let what = words().limit_called(&limit.name.to_string());
        let seen = self.limited_link(&what, "link", link);
        let body = match from {
            None => Some(Body::Ground),
            Some(from) if from.text == "ground" => Some(Body::Ground),
            Some(from) => self.limited_link(&what, "from", from).map(Body::Link),
        };
        let (link_id, body) = (seen?, body?);
        if body == Body::Link(link_id) {
            self.reader.report(
                Diagnostic::new(words().angle_to_itself(&what, &link.to_string()))
                    .at(link.span.clone(), words().always_zero())
                    .help(words().for_example(ANGLE)),
            );
            return None;
        }
        Some(LimitOf::Angle {
            link: link_id,
            from: body,
        })
    }

    fn limited_link(&mut self, what: &str, key: &str, name: &Name<'t>) -> Option<LinkId> {
        let what = words().key_of(key, what);
        let found = self.names.find(self.reader, &what, name, Sort::Link);
        found.map(LinkId::new)
    }

    fn too_wide(&mut self, limit: &DraftLimit<'t>) {
        let what = words().limit_called(&limit.name.to_string());
        self.reader.report(
            Diagnostic::new(words().limit_of_a_turn(&what))
                .at(limit.ends.place.clone(), words().is_too_wide())
                .help(words().driver_has_range()),
        );
    }
}
