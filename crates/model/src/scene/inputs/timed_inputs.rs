//! Reads the inputs that follow the driver.

use crate::document::{Diagnostic, WrittenValue};
use crate::scene::inputs::input::{DraftDriver, seat};
use crate::scene::keys;
use crate::scene::loading::profile;
use crate::scene::numbers::rate::RateKind;
use crate::scene::numbers::reader::{ByteSpan, Name, Reader};
use crate::scene::resolve::Resolver;
use crate::scene::table::KeyTable;
use crate::wording::words;
use crate::{Input, InputLaw, InputTable, TimedInput};

const INPUT: &str = "r7 = { ratio = 1, phase = 30 }";
const HELD: &str = "r7 = { at = 30 }";
const TABLE: &str = "rod = { over = [[1.0, 0.2], [1.3, 0.35]] }";

#[derive(Debug)]
pub(crate) struct DraftTimed<'t> {
    /// The driven link or slide.
    pub(crate) name: Name<'t>,
    law: DraftInputLaw,
    /// The link that carries its motor, as written; `None` for the ground.
    from: Option<&'t WrittenValue<'t>>,
}

impl<'t> DraftTimed<'t> {
    /// Creates an input that follows the driver.
    pub(crate) fn following(name: Name<'t>, ratio: f64, phase: f64) -> Self {
        DraftTimed {
            name,
            law: DraftInputLaw::Ratio { ratio, phase },
            from: None,
        }
    }
}

#[derive(Debug)]
enum DraftInputLaw {
    Ratio {
        ratio: f64,
        phase: f64,
    },
    Table {
        knots: Vec<[f64; 2]>,
        span: ByteSpan,
    },
}

/// Reads the section.
pub(crate) fn read<'v>(
    reader: &mut Reader<'_>,
    value: &'v WrittenValue<'v>,
) -> Vec<DraftTimed<'v>> {
    let entries = reader.entries("[inputs]", INPUT, value);
    entries
        .filter_map(|(name, value)| input(reader, name, value))
        .collect()
}

fn input<'v>(
    reader: &mut Reader<'_>,
    name: Name<'v>,
    value: &'v WrittenValue<'v>,
) -> Option<DraftTimed<'v>> {
    let of = words().input_called(&name.to_string());
    let table = reader.open([&of, &of], keys::TIMED, INPUT, value)?;
    reader.only_known(&table);
    one_law(reader, &table)?;
    let law = match (table.get("over"), table.has("at")) {
        (Some(over), _) => by_table(reader, &table, over)?,
        (None, true) => DraftInputLaw::Ratio {
            ratio: 0.0,
            phase: reader.number_of(&table, "at")?,
        },
        (None, false) => {
            let ratio = reader.number_or(&table, "ratio", 1.0);
            let phase = reader.number_or(&table, "phase", 0.0);
            let (ratio, phase) = (ratio?, phase?);
            DraftInputLaw::Ratio { ratio, phase }
        }
    };
    let from = table.get("from");
    Some(DraftTimed { name, law, from })
}

/// Reports an input with two laws, and returns `None`.
fn one_law(reader: &mut Reader<'_>, table: &KeyTable<'_>) -> Option<()> {
    let find = |keys: &[&str]| table.names().find(|key| keys.contains(&key.text));
    let laws = [find(&["over"]), find(&["at"]), find(&["ratio", "phase"])];
    let mut laws = laws.into_iter().flatten();
    if let (Some(law), Some(other)) = (laws.next(), laws.next()) {
        reader.report(
            Diagnostic::new(words().input_has_two_laws(&table.of, law.text, other.text))
                .at(other.span, words().says_the_same_otherwise())
                .and(law.span, words().one_law())
                .help(words().for_example(HELD))
                .help(words().for_example(TABLE)),
        );
        return None;
    }
    Some(())
}

fn by_table(
    reader: &mut Reader<'_>,
    table: &KeyTable<'_>,
    over: &WrittenValue<'_>,
) -> Option<DraftInputLaw> {
    let span = over.span();
    let what = table.what(reader, "over");
    let knots = profile::over_driver(reader, &what, TABLE, over)?;
    Some(DraftInputLaw::Table { knots, span })
}

impl<'t> Resolver<'_, '_, 't> {
    pub(crate) fn timed_inputs(&mut self) {
        for timed in &self.draft.timed {
            let of = words().input_called(&timed.name.to_string());
            if self.is_the_driver(&timed.name) {
                continue;
            }
            let input = match self.slides.get(timed.name.text) {
                Some(&slide) => {
                    seat(
                        self.reader,
                        &of,
                        RateKind::Push(self.draft.unit),
                        timed.from,
                    );
                    Some(Input::Push(slide))
                }
                None => {
                    let from = seat(self.reader, &of, RateKind::Turn, timed.from);
                    if timed.from.is_some() && from.is_none() {
                        continue;
                    }
                    let seat = words().key_of("from", &of);
                    self.turned_link([&of, &seat], &timed.name, from.as_ref())
                        .map(Input::Turn)
                }
            };
            let Some(input) = input else { continue };
            let law = match &timed.law {
                DraftInputLaw::Ratio { ratio, phase } => Some(InputLaw::Ratio {
                    ratio: *ratio,
                    phase: *phase,
                }),
                DraftInputLaw::Table { knots, span } => {
                    self.table(&of, input, knots, span).map(InputLaw::Table)
                }
            };
            let Some(law) = law else { continue };
            if self.builder.timed(TimedInput { input, law }).is_some()
                && let DraftInputLaw::Table { span, .. } = &timed.law
            {
                // The ends of the table are a limit.
                let name = timed.name.text.to_owned();
                self.limit_places.push((name, span.clone()));
            }
        }
    }

    /// Creates the table of an input. A table over whole turns of a driven link must close, unless
    /// the driver has a range of its own. Reports one that does not, and returns `None`.
    fn table(
        &mut self,
        of: &str,
        input: Input,
        knots: &[[f64; 2]],
        span: &ByteSpan,
    ) -> Option<InputTable> {
        let driver = self.draft.driver.as_ref();
        let is_rotary = driver.is_some_and(|driver| driver.driven_link().is_some());
        let closed = InputTable::closed(knots.to_vec()).filter(|_| is_rotary);
        let Some(closed) = closed else {
            return InputTable::open(knots.to_vec());
        };
        let is_rotary = matches!(input, Input::Turn(_));
        if closed.is_closed(is_rotary) {
            return Some(closed);
        }
        if driver.is_some_and(|driver| driver.range.is_some()) {
            return InputTable::open(knots.to_vec());
        }
        let [[_, first], .., [_, last]] = knots else {
            return None;
        };
        let help = match is_rotary {
            true => words().table_of_link_closes(),
            false => words().table_of_slide_closes(),
        };
        self.reader.report(
            Diagnostic::new(words().table_does_not_close(of, *first, *last))
                .at(span.clone(), words().ends_elsewhere())
                .help(help)
                .help(words().or_table_is_shorter()),
        );
        None
    }

    /// Reports an input of the element that the driver itself drives; returns `true` for one.
    fn is_the_driver(&mut self, name: &Name<'t>) -> bool {
        let Some(driven) = self.draft.driver.as_ref().map(DraftDriver::driven) else {
            return false;
        };
        let is_same = driven.text == name.text;
        if is_same {
            self.reader.report(
                Diagnostic::new(words().input_is_the_driver(&name.to_string()))
                    .at(name.span.clone(), words().driven_again())
                    .and(driven.span.clone(), words().the_driver_itself())
                    .help(words().inputs_follow_the_driver()),
            );
        }
        is_same
    }
}
