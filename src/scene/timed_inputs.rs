//! Reads the inputs that follow the driver.

use super::input::{DraftInput, seat};
use super::rate::RateKind;
use super::reader::{Name, Reader};
use super::resolve::Resolver;
use crate::document::{Diagnostic, Entries, Lenient};
use crate::wording::words;
use crate::{Input, TimedInput};
use serde::Deserialize;

const INPUT: &str = "r7 = { ratio = 1, phase = 30 }";

/// The section `[inputs]` as it is written.
pub(super) type TimedInputs = Lenient<Entries<Lenient<TimedTable>>>;

/// An input as it is written.
#[derive(Debug, Deserialize)]
pub(super) struct TimedTable {
    ratio: Option<Lenient<f64>>,
    phase: Option<Lenient<f64>>,
    from: Option<Lenient<String>>,
}

#[derive(Debug)]
pub(super) struct DraftTimed<'t> {
    /// The link or the slide that is driven.
    pub(super) name: Name<'t>,
    ratio: f64,
    phase: f64,
    /// The link that its motor sits on, as it is written; none on the ground.
    from: Option<&'t Lenient<String>>,
}

/// Reads the section.
pub(super) fn read<'v>(reader: &mut Reader<'_>, value: &'v TimedInputs) -> Vec<DraftTimed<'v>> {
    reader.table("[inputs]", INPUT, value);
    let read = |(name, value)| input(reader, name, value);
    value.entries().filter_map(read).collect()
}

fn input<'v>(
    reader: &mut Reader<'_>,
    name: Name<'v>,
    value: &'v Lenient<TimedTable>,
) -> Option<DraftTimed<'v>> {
    let of = words().input_called(&name.to_string());
    let table = reader.table(&of, INPUT, value)?;
    reader.only(&of, value);
    let mut number = |key: &str, given: Option<&Lenient<f64>>, default| match given {
        None => Some(default),
        Some(given) => reader.number(&words().key_of(key, &of), given),
    };
    let ratio = number("ratio", table.ratio.as_ref(), 1.0);
    let phase = number("phase", table.phase.as_ref(), 0.0);
    Some(DraftTimed {
        ratio: ratio?,
        phase: phase?,
        from: table.from.as_ref(),
        name,
    })
}

impl<'t> Resolver<'_, '_, 't> {
    pub(super) fn timed_inputs(&mut self) {
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
            if let Some(input) = input {
                self.builder.timed(TimedInput {
                    input,
                    ratio: timed.ratio,
                    phase: timed.phase,
                });
            }
        }
    }

    /// Reports an input that drives what the driver does.
    fn is_the_driver(&mut self, name: &Name<'t>) -> bool {
        let driver = self.draft.driver.as_ref().map(|driver| &driver.input);
        let (Some(DraftInput::Link(driven)) | Some(DraftInput::Slide(driven))) = driver else {
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
