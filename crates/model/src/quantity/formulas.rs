//! Defines quantities by formulas, in a scene or in `--columns`.

use super::derived::Leaf;
use super::{Catalogue, Derived, Quantity, QuantitySource, magnitude};
use crate::document::{Diagnostic, Diagnostics};
use crate::expression::{self, ExpressionTree, FormulaError, compile};
use crate::nearest::did_you_mean;
use crate::scene::{NamedFormula, Scene, is_figure_name, reserved_for_figures};
use crate::wording::words;
use std::collections::HashMap;
use std::sync::Arc;

/// Checks the quantities that a scene defines by formulas.
///
/// # Errors
/// All faults found, with their positions in the file.
pub fn check_figures(scene: &Scene) -> Result<(), Diagnostics> {
    if scene.figures.is_empty() {
        return Ok(());
    }
    let mut catalogue = Catalogue::without_formulas(scene);
    let faults = catalogue.define_all(&scene.figures);
    match faults.is_empty() {
        true => Ok(()),
        false => Err(scene.diagnostics(faults)),
    }
}

impl Catalogue {
    /// Adds a quantity by its definition, such as `swing = armL.angle - armR.angle`. It can be
    /// found by name afterwards.
    ///
    /// # Errors
    /// A message describing the fault.
    pub fn define(&mut self, definition: &str) -> Result<Quantity, String> {
        let (name, text) = definition.split_once('=').unwrap_or(("", definition));
        let (name, text) = (name.trim(), text.trim());
        if name.is_empty() {
            return Err(words().name_of_figure_missing().into());
        }
        if let Some(reserved) = reserved_for_figures(name) {
            let of_its_own = words().columns_use(&reserved);
            return Err(words().name_is_reserved(&format!("`{name}`")) + "; " + &of_its_own);
        }
        if !is_figure_name(name) {
            return Err(words().name_of_figure_bad(name));
        }
        if self.is_taken(name) {
            return Err(words().name_of_figure_taken(name));
        }
        let of_formula =
            |fault: FormulaError| format!("{}: {}", words().in_formula_of(name), fault.words());
        let tree = expression::parse(text).map_err(of_formula)?;
        let derived = self.derived(text, &tree, &self.index());
        let derived = derived.map_err(of_formula)?;
        Ok(self.keep(name, derived))
    }

    /// Returns `true` if a quantity or a parameter has this name, or if it is the first part of a
    /// name.
    fn is_taken(&self, name: &str) -> bool {
        let is_of = |quantity: &Quantity| {
            let rest = quantity.name.strip_prefix(name);
            rest.is_some_and(|rest| rest.is_empty() || rest.starts_with('.'))
        };
        let is_parameter = self
            .parameters
            .iter()
            .any(|(parameter, _)| parameter == name);
        is_parameter || self.all().iter().chain(&self.defined).any(is_of)
    }

    /// Adds the quantities of a scene in any order. Returns the faults of those that could not be
    /// added.
    pub(super) fn define_all(&mut self, figures: &[NamedFormula]) -> Vec<Diagnostic> {
        let mut faults = Vec::new();
        if figures.is_empty() {
            return faults;
        }
        let index = self.index();
        let order = in_order(figures);
        for &number in &order {
            let figure = &figures[number];
            match self.derived(&figure.text, &figure.tree, &index) {
                Ok(derived) => drop(self.keep(&figure.name, derived)),
                Err(fault) => faults.push(figure.place.diagnostic(&figure.name, &fault)),
            }
        }
        let rest = (0..figures.len()).filter(|number| !order.contains(number));
        for figure in rest.map(|number| &figures[number]) {
            let fault = FormulaError {
                span: figure.tree.span.clone(),
                message: words().formula_uses_itself(&figure.name),
                help: None,
            };
            faults.push(figure.place.diagnostic(&figure.name, &fault));
        }
        faults
    }

    /// Returns the index of every solver quantity by name.
    fn index(&self) -> HashMap<String, usize> {
        let names = self.all().iter().enumerate();
        names.map(|(i, q)| (q.name.clone(), i)).collect()
    }

    fn keep(&mut self, name: &str, derived: Derived) -> Quantity {
        let quantity = Quantity {
            name: name.to_owned(),
            unit: derived.kind().dimension.symbol(self.length.symbol),
            source: QuantitySource::Derived(Arc::new(derived)),
        };
        self.defined.push(quantity.clone());
        quantity
    }

    fn derived(
        &self,
        text: &str,
        tree: &ExpressionTree,
        index: &HashMap<String, usize>,
    ) -> Result<Derived, FormulaError> {
        let mut leaves: Vec<Leaf> = Vec::new();
        let mut names = |name: &str| {
            let mut parameters = self.parameters.iter();
            if let Some((_, part)) = parameters.find(|(parameter, _)| parameter == name) {
                return Ok(part.clone());
            }
            let solved = index.get(name).and_then(|&i| self.all().get(i));
            let found = match solved {
                Some(quantity) => quantity.clone(),
                None => self.build_quantity(name).map_err(|why| {
                    let unlisted = self.unlisted();
                    let names = self.all().iter().chain(&unlisted);
                    let near = || did_you_mean(name, names.map(|q| q.name.as_str()));
                    why.or_else(|| self.difference(name)).or_else(near)
                })?,
            };
            Ok(magnitude::part(&found, &mut leaves))
        };
        let (code, kind) = compile(text, tree, self.length, &mut names)?;
        Derived::new(leaves, code, kind).map_err(|of| FormulaError {
            span: tree.span.clone(),
            message: words().no_rate_of(&of),
            help: None,
        })
    }

    /// Returns a hint if a name reads as a difference of two names.
    pub(super) fn difference(&self, name: &str) -> Option<String> {
        let is_known = |part: &str| {
            let mut parameters = self.parameters.iter();
            parameters.any(|(own, _)| own == part) || self.find(part).is_some()
        };
        let is_one = expression::is_difference(name, is_known);
        is_one.then(|| words().minus_between_blanks().to_owned())
    }

    /// Returns a quantity computed from others.
    ///
    /// # Errors
    /// The reason, if known.
    pub(super) fn build_quantity(&self, name: &str) -> Result<Quantity, Option<String>> {
        if let Some(defined) = self.defined.iter().find(|q| q.name == name) {
            return Ok(defined.clone());
        }
        if let Some(magnitude) = magnitude::find(self.all(), name) {
            return Ok(magnitude);
        }
        let (base, degree) = match name.rsplit_once('.') {
            Some((base, "rate")) => (base, 1),
            Some((base, "accel")) => (base, 2),
            _ => return Err(None),
        };
        let base = self.defined.iter().find(|q| q.name == base).ok_or(None)?;
        let rate = (0..degree).try_fold(base.clone(), |of, _| of.differentiated(self.length));
        match rate {
            Ok(rate) => Ok(Quantity {
                name: name.to_owned(),
                ..rate
            }),
            Err(of) => Err(Some(words().no_rate_of(&of))),
        }
    }
}

/// Returns the indices of formulas in an order in which each follows those that it uses. Formulas
/// that depend on themselves are left out.
fn in_order(figures: &[NamedFormula]) -> Vec<usize> {
    let numbers = figures.iter().enumerate();
    let numbers: HashMap<&str, usize> = numbers.map(|(i, f)| (f.name.as_str(), i)).collect();
    let number = |name: &str| {
        let base = name.split('.').next().unwrap_or(name);
        numbers.get(base).copied()
    };
    let mut users = vec![Vec::new(); figures.len()];
    let mut wanted = vec![0_usize; figures.len()];
    for (user, figure) in figures.iter().enumerate() {
        figure.tree.each_name(&mut |name| {
            if let Some(used) = number(name) {
                users[used].push(user);
                wanted[user] += 1;
            }
        });
    }
    let mut order: Vec<usize> = (0..figures.len()).filter(|&i| wanted[i] == 0).collect();
    let mut next = 0;
    while let Some(&done) = order.get(next) {
        next += 1;
        for &user in &users[done] {
            wanted[user] -= 1;
            if wanted[user] == 0 {
                order.push(user);
            }
        }
    }
    order
}
