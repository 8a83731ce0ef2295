//! Reads the section `[figures]`: values computed from others, by name and formula.

use crate::document::{Diagnostic, WrittenValue};
use crate::expression::{self, ExpressionTree, FormulaError};
use crate::scene::numbers::reader::{ByteSpan, Name, Reader, quoted};
use crate::wording::words;
use std::ops::Range;

const FIGURE: &str = r#"swing = "r4.angle - r3.angle""#;

/// A value that the scene computes from others, such as `swing = "armL.angle - armR.angle"`. The
/// caller that lists values resolves the names in the formula.
#[derive(Clone, Debug)]
pub struct NamedFormula {
    /// The name given by the scene.
    pub name: String,
    /// The formula as written.
    pub text: String,
    pub(crate) tree: ExpressionTree,
    pub(crate) place: FormulaPlace,
}

/// The place of a formula in the file.
#[derive(Clone, Debug)]
pub(crate) struct FormulaPlace {
    text: ByteSpan,
    /// Whether the bytes between the quotes equal the formula, without escapes.
    is_literal: bool,
}

impl FormulaPlace {
    pub(crate) fn of(reader: &Reader<'_>, formula: &Name<'_>) -> FormulaPlace {
        let Range { start, end } = formula.span;
        let within = reader.text().get(start + 1..end.saturating_sub(1));
        FormulaPlace {
            text: formula.span.clone(),
            is_literal: within == Some(formula.text),
        }
    }

    /// Returns the diagnostic of a fault in a value's formula, with its place in the file.
    pub(crate) fn diagnostic(&self, figure: &str, fault: &FormulaError) -> Diagnostic {
        self.fault(&words().figure_called(&quoted(figure)), fault)
    }

    /// Returns the diagnostic of a fault in any formula; `what` names the formula.
    pub(crate) fn fault(&self, what: &str, fault: &FormulaError) -> Diagnostic {
        let span = match self.is_literal {
            true => {
                let from = self.text.start + 1;
                from + fault.span.start..from + fault.span.end
            }
            false => self.text.clone(),
        };
        let message = format!("{what}: {}", fault.message);
        let diagnostic = Diagnostic::new(message).at(span, "");
        diagnostic.maybe_help(fault.help.clone())
    }
}

/// A named value, with its formula if that could be parsed.
#[derive(Debug)]
pub(crate) struct DraftFigure<'t> {
    pub(crate) name: Name<'t>,
    pub(crate) formula: Option<NamedFormula>,
}

/// Reads the section, and reports every text that is not a formula.
pub(crate) fn figures<'v>(
    reader: &mut Reader<'_>,
    value: &'v WrittenValue<'v>,
) -> Vec<DraftFigure<'v>> {
    let entries = reader.entries("[figures]", FIGURE, value);
    let read = |(name, value): (Name<'v>, &WrittenValue<'_>)| {
        let formula = formula(reader, &name, value);
        DraftFigure { name, formula }
    };
    entries.map(read).collect()
}

fn formula(
    reader: &mut Reader<'_>,
    name: &Name<'_>,
    value: &WrittenValue<'_>,
) -> Option<NamedFormula> {
    let written = reader.string(&words().figure_called(&name.to_string()), value)?;
    let place = FormulaPlace::of(reader, &written);
    match expression::parse(written.text) {
        Ok(tree) => Some(NamedFormula {
            name: name.text.to_owned(),
            text: written.text.to_owned(),
            tree,
            place,
        }),
        Err(fault) => {
            reader.report(place.diagnostic(name.text, &fault));
            None
        }
    }
}
