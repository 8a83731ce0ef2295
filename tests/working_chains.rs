//! Every chain of equal sides with numbers in it is true as it stands on the page.
#![allow(clippy::unwrap_used, reason = "a test fails by panicking")]

use krank::report::{Block, Document, Working};
use krank::scene::{Scene, presets};
use krank::solver::{Order, Range, Solver};

/// A reader of printed numbers: sums, products, squares, roots, sines and cosines of degrees.
struct Reader<'a> {
    rest: &'a str,
    /// The largest number that was read: what a side is rounded by.
    largest: f64,
}

impl<'a> Reader<'a> {
    /// The value of a side, and the largest of its parts; `None` where it has a symbol in it.
    fn side(text: &'a str) -> Option<(f64, f64)> {
        let mut reader = Reader {
            rest: text,
            largest: 0.0,
        };
        let value = reader.sum()?;
        // A unit may stand behind a figure, and then its direction.
        let is_over = reader.rest.is_empty() || reader.rest.starts_with(' ');
        is_over.then_some((value, reader.largest))
    }

    fn takes(&mut self, text: &str) -> bool {
        let rest = self.rest.strip_prefix(text);
        self.rest = rest.unwrap_or(self.rest);
        rest.is_some()
    }

    fn sum(&mut self) -> Option<f64> {
        let mut sum = self.product()?;
        loop {
            let sign = match () {
                () if self.takes(" + ") => 1.0,
                () if self.takes(" - ") => -1.0,
                () => return Some(sum),
            };
            sum += sign * self.product()?;
        }
    }

    fn product(&mut self) -> Option<f64> {
        let sign = if self.takes("-") { -1.0 } else { 1.0 };
        let mut product = sign * self.power()?;
        loop {
            match () {
                () if self.takes("·") => product *= self.power()?,
                () if self.takes("/") => product /= self.power()?,
                () => break,
            }
        }
        self.largest = self.largest.max(product.abs());
        Some(product)
    }

    fn power(&mut self) -> Option<f64> {
        let base = self.factor()?;
        Some(if self.takes("^2") { base * base } else { base })
    }

    fn factor(&mut self) -> Option<f64> {
        let functions: [(&str, fn(f64) -> f64); 4] = [
            ("sqrt(", f64::sqrt),
            ("cos(", |degrees| degrees.to_radians().cos()),
            ("sin(", |degrees| degrees.to_radians().sin()),
            ("(", |value| value),
        ];
        for (name, function) in functions {
            if self.takes(name) {
                let value = self.sum()?;
                return self.takes(")").then(|| function(value));
            }
        }
        let part = |c: char| c.is_ascii_digit() || c == '.';
        let end = self.rest.find(|c| !part(c)).unwrap_or(self.rest.len());
        let mut end = end;
        // A power of ten.
        if let Some(power) = self.rest[end..].strip_prefix('e') {
            let digits = power.trim_start_matches('-');
            let last = digits.find(|c: char| !c.is_ascii_digit());
            end = self.rest.len() - digits.len() + last.unwrap_or(digits.len());
        }
        let (number, rest) = self.rest.split_at(end);
        self.rest = rest;
        number.parse().ok()
    }
}

/// Counts the chains of points and forces, each of which must be true to its printed digits.
fn hold(document: &Document, context: &str) -> usize {
    let begins = |block: &Block| matches!(block, Block::Heading(1, text) if text.starts_with("7 "));
    let ends = |block: &Block| matches!(block, Block::Heading(1, text) if text.ends_with("Check"));
    let blocks = document.blocks.iter().skip_while(|b| !begins(b));
    let mut count = 0;
    for block in blocks.take_while(|b| !ends(b)) {
        let Block::Equations(equations) = block else {
            continue;
        };
        for equation in equations {
            let sides = equation.sides.iter();
            let values: Vec<(f64, f64)> = sides.filter_map(|side| Reader::side(side)).collect();
            for pair in values.windows(2) {
                let size = pair[0].1.max(pair[1].1).max(f64::MIN_POSITIVE);
                let off = (pair[0].0 - pair[1].0).abs() / size;
                assert!(off < 1e-8, "{context}: {:?}: {off:e}", equation.sides);
                count += 1;
            }
        }
    }
    count
}

fn follow(name: &str, text: &str) {
    let scene = Scene::parse(text, name).unwrap();
    let solver = Solver::new(&scene.mechanism).unwrap();
    let working = Working::new(&scene, &solver);
    let mut state = solver.state();
    let (low, high) = match solver.motion().range {
        Range::Full { period } => (0.0, period),
        Range::Limited { low, high } => (low, high),
    };
    let mut count = 0;
    for k in 1..24 {
        let at = low + (high - low) * f64::from(k) / 24.0 + 0.01;
        solver.solve(at, Order::Force, &mut state);
        let worked = working.of(&scene, &solver, &state, 12);
        count += hold(&worked.document, &format!("{name} at {at}"));
    }
    assert!(count > 23, "{name}: {count}");
}

#[test]
fn every_chain_of_every_preset_is_true_as_it_stands() {
    for preset in presets::all() {
        follow(preset.name, preset.text);
    }
}

#[test]
fn the_reader_knows_a_lost_sign() {
    assert_eq!(Reader::side("(-3.5)·2"), Some((-7.0, 7.0)));
    assert_eq!(Reader::side("7.00 mm/s at 90 deg"), Some((7.0, 7.0)));
    assert_eq!(Reader::side("sqrt(3^2 + (-4)^2)").unwrap().0, 5.0);
    assert_eq!(
        Reader::side("2·cos(60) - 1e-3").unwrap().0,
        2.0 * 60_f64.to_radians().cos() - 1e-3
    );
    assert_eq!(Reader::side("|ω3| r"), None);
}
