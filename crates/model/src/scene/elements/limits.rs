//! Reads limits: minimum and maximum of coordinates.
//!
//! ```toml
//! [limits]
//! rod = [120, 200]
//! elbow = { link = "r4", from = "r3", angle = [20, 160] }
//! ```

use crate::angle::TURN;
use crate::document::{Diagnostic, WrittenValue, items};
use crate::mechanism::MAX_TURNS;
use crate::nearest::did_you_mean;
use crate::scene::keys;
use crate::scene::numbers::reader::{ByteSpan, Name, Reader};
use crate::scene::raw_elements::SceneDraft;
use crate::scene::resolve::Resolver;
use crate::scene::table::KeyTable;
use crate::wording::words;
use crate::{Body, Limit, LimitOf, LinkId};

const ANGLE: &str = r#"{ link = "r4", from = "r3", angle = [20, 160] }"#;
const PAIR: (&str, &str) = ("[low, high]", "[120, 200]");

/// The two ends of a range in ascending order, with their place in the file.
#[derive(Debug)]
pub(crate) struct DraftEnds {
    pub(crate) low: f64,
    pub(crate) high: f64,
    pub(crate) span: ByteSpan,
}

#[derive(Debug)]
pub(crate) struct DraftLimit<'t> {
    pub(crate) name: Name<'t>,
    /// The link and its reference body; `None` if the limit has the name of the element that it
    /// limits.
    pub(crate) angle: Option<(Name<'t>, Option<Name<'t>>)>,
    ends: DraftEnds,
}

/// Reads the section. Reports and omits limits that could not be read.
pub(crate) fn limits<'v>(
    reader: &mut Reader<'_>,
    value: &'v WrittenValue<'v>,
) -> Vec<DraftLimit<'v>> {
    let entries = reader.entries("[limits]", "{ r4 = [30, 150] }", value);
    entries
        .filter_map(|(name, value)| limit(reader, name, value))
        .collect()
}

fn limit<'v>(
    reader: &mut Reader<'_>,
    name: Name<'v>,
    value: &'v WrittenValue<'v>,
) -> Option<DraftLimit<'v>> {
    let what = words().limit_called(&name.to_string());
    let (angle, ends) = if let Some(entries) = value.get_ref().as_table() {
        let table = KeyTable::new(&what, keys::LIMIT, entries, value.span());
        let (link, from, ends) = limited_angle(reader, &name, &table)?;
        (Some((link, from)), ends)
    } else if items(value).is_some() {
        (None, range(reader, &what, value)?)
    } else {
        let fault = no_range(reader, &what, value);
        reader.report(fault.help(words().or_angle_of_link(ANGLE)));
        return None;
    };
    Some(DraftLimit { name, angle, ends })
}

type LimitedAngle<'v> = (Name<'v>, Option<Name<'v>>, DraftEnds);

fn limited_angle<'v>(
    reader: &mut Reader<'_>,
    owner: &Name<'_>,
    table: &KeyTable<'v>,
) -> Option<LimitedAngle<'v>> {
    reader.only_known(table);
    for key in ["link", "angle"] {
        reader.require(table, key, &owner.span, ANGLE);
    }
    let link = reader.text_of(table, "link");
    let from = reader.text_of(table, "from");
    let is_lost = table.has("from") && from.is_none();
    let what = table.what(reader, "angle");
    let ends = range(reader, &what, table.get("angle")?);
    (!is_lost).then_some((link?, from, ends?))
}

fn no_range(reader: &Reader<'_>, what: &str, value: &WrittenValue<'_>) -> Diagnostic {
    let fault = reader.mistyped(what, &words().a_pair(PAIR.0), value);
    fault.help(words().for_example(PAIR.1))
}

/// Reads the two ends of a range.
pub(crate) fn range(
    reader: &mut Reader<'_>,
    what: &str,
    value: &WrittenValue<'_>,
) -> Option<DraftEnds> {
    let [low, high] = reader.two(what, PAIR.0, PAIR.1, value)?;
    let low = reader.number(&words().low_end_of(what), low);
    let high = reader.number(&words().high_end_of(what), high);
    let (low, high) = (low?, high?);
    let span = value.span();
    if low < high {
        return Some(DraftEnds { low, high, span });
    }
    let literal = reader.literal(&span);
    let help = match low == high {
        true => words().nothing_moves_between().to_owned(),
        false => words().ends_the_other_way(&format!("[{high}, {low}]")),
    };
    reader.report(
        Diagnostic::new(words().ends_must_rise(what, &literal))
            .at(span, words().lower_end_first())
            .help(help),
    );
    None
}

/// Reports a driver's range with more turns than can be listed.
pub(crate) fn check_turns(reader: &mut Reader<'_>, what: &str, ends: &DraftEnds) {
    let maximum = MAX_TURNS * TURN;
    // Negated, so that an overflow is rejected too.
    if !(ends.high - ends.low < maximum) {
        reader.report(
            Diagnostic::new(words().range_of_too_many_turns(what, maximum))
                .at(ends.span.clone(), words().is_too_wide())
                .help(words().leave_range_out()),
        );
    }
}

/// The names and places of the limits, in the order of the mechanism's ids.
pub(crate) type LimitPlaces = Vec<(String, ByteSpan)>;

impl<'t> Resolver<'_, '_, 't> {
    /// Adds the driver's range and the limits of `[limits]` to the builder.
    pub(crate) fn limits(&mut self) {
        let draft: &SceneDraft<'t> = self.draft;
        if let Some(ends) = draft.driver.as_ref().and_then(|d| d.range.as_ref()) {
            self.push_limit("driver".to_owned(), LimitOf::Driver, ends);
        }
        for limit in &draft.limits {
            let of = match &limit.angle {
                None => self.named(limit),
                Some((link, from)) => self.relative_angle(limit, link, from.as_ref()),
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
        self.limit_places.push((name, ends.span.clone()));
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
    fn relative_angle(
        &mut self,
        limit: &DraftLimit<'t>,
        link: &Name<'t>,
        from: Option<&Name<'t>>,
    ) -> Option<LimitOf> {
        let what = words().limit_called(&limit.name.to_string());
        let seen = self.link(&words().key_of("link", &what), link);
        let body = match from {
            None => Some(Body::Ground),
            Some(from) => self.body(&words().key_of("from", &what), from),
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

    fn too_wide(&mut self, limit: &DraftLimit<'t>) {
        let what = words().limit_called(&limit.name.to_string());
        self.reader.report(
            Diagnostic::new(words().limit_of_a_turn(&what))
                .at(limit.ends.span.clone(), words().is_too_wide())
                .help(words().driver_has_range()),
        );
    }
}
