//! Checks that every printed chain of equal numeric sides is true as printed.

use krank::page::{Block, Content, Page, TextStyle};
use krank::report::Working;
use krank::scene::{Scene, presets};
use krank::solver::{Order, Solver};

/// A function applied to the value in a pair of brackets.
type Function = fn(f64) -> f64;

/// A parser for printed expressions: sums, products, squares, roots, sines and cosines of degrees.
struct Reader<'a> {
    rest: &'a str,
    /// The largest number so far, which scales the rounding error of a side.
    largest: f64,
}

impl<'a> Reader<'a> {
    /// Returns the value of a side and its largest part; `None` if it contains a symbol.
    fn side(text: &'a str) -> Option<(f64, f64)> {
        let mut reader = Reader {
            rest: text,
            largest: 0.0,
        };
        let value = reader.sum()?;
        // A value may be followed by a unit, and then by a direction.
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
        let functions: [(&str, Function); 4] = [
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

/// Asserts that the chains of rates, points and forces are true to their printed digits, and
/// returns their number.
fn hold(page: &Page, context: &str) -> usize {
    let starts = |block: &Block| matches!(&block.content, Content::Heading(1, text) if text.starts_with("5 "));
    let ends = |block: &Block| matches!(&block.content, Content::Heading(1, text) if text.ends_with("Check"));
    let blocks = page.blocks.iter().skip_while(|b| !starts(b));
    let mut count = 0;
    for block in blocks.take_while(|b| !ends(b)) {
        let Content::Equations(equations) = &block.content else {
            continue;
        };
        for equation in equations {
            // An equation with unknowns is not a numeric chain.
            if (equation.sides.last()).is_some_and(|side| side.to_string() == "0") {
                continue;
            }
            let sides = equation.sides.iter();
            let values: Vec<(f64, f64)> = sides
                .filter_map(|side| Reader::side(&side.to_string()))
                .collect();
            for pair in values.windows(2) {
                let size = pair[0].1.max(pair[1].1).max(f64::MIN_POSITIVE);
                let off = (pair[0].0 - pair[1].0).abs() / size;
                assert!(off < 1e-8, "{context}: {equation}: {off:e}");
                count += 1;
            }
        }
    }
    count
}

fn follow(name: &str, text: &str) -> Vec<String> {
    let mut texts = Vec::new();
    let scene = Scene::parse(text, name).unwrap();
    let solver = Solver::new(&scene.mechanism).unwrap();
    let working = Working::new(&scene, &solver);
    let mut state = solver.state();
    let (low, high) = solver.motion().range.ends();
    let mut count = 0;
    for k in 1..24 {
        let at = low + (high - low) * f64::from(k) / 24.0 + 0.01;
        let _ = solver.solve(at, Order::Force, &mut state);
        let computed = working.of(&scene, &solver, &state, 12);
        for agreement in &computed.agreements {
            let off = agreement.part();
            assert!(off < 1e-13, "{name} at {at}: {agreement:?}: {off:e}");
        }
        let style = TextStyle {
            ascii: true,
            width: 10_000,
        };
        texts.push(computed.page.to_text(style));
        count += hold(&computed.page, &format!("{name} at {at}"));
    }
    assert!(count > 23, "{name}: {count}");
    texts
}

#[test]
fn equation_chains_of_every_preset_hold_as_printed() {
    for preset in presets::all() {
        follow(preset.name, preset.text);
    }
}

/// A load on a joint is in no link's table, but in the balance of the pin, with the guide of a
/// slot.
#[test]
fn loaded_joint_shows_balance_of_its_pin() {
    for (preset, point) in [
        ("four-bar", "C"),
        ("slider-crank", "C"),
        ("slotted-lever", "B"),
    ] {
        let given = presets::find(preset).unwrap().text;
        let load = format!("[[loads]]\npoint = \"{point}\"\nforce = [30, -500]\n");
        for text in follow(preset, &format!("{given}\n{load}")) {
            let (_, pin) = text.split_once(&format!(" Pin {point}\n")).unwrap();
            let rows: Vec<&str> = pin.lines().take(5).map(str::trim_start).collect();
            assert!(rows[1].starts_with("force  "), "{preset}: {rows:?}");
            assert!(rows[2].starts_with("-(r"), "{preset}: {rows:?}");
            assert!(pin.contains(" = 0 N\n"), "{preset}: {pin}");
            let has_guide = rows.iter().any(|row| row.starts_with("guide of "));
            assert_eq!(has_guide, preset != "four-bar", "{preset}: {rows:?}");
        }
    }
}

/// A force at every moving point and a torque on every link load every joint of every kind of
/// group. The reactions are found by one equation, by two, or by all at once, and agree with the
/// solver.
#[test]
fn joint_reactions_are_worked_out_for_every_kind_of_group() {
    let presets = presets::all().iter().map(|p| (p.name, p.text));
    let mut output = [0; 3];
    for (name, text) in presets.chain(crate::working::OTHERS) {
        let scene = Scene::parse(text, name).unwrap();
        let mechanism = &scene.mechanism;
        let mut loaded = text.to_owned();
        for id in mechanism.point_ids() {
            let at = scene.point_name(id).filter(|name| !name.contains('.'));
            if let (Some(point), None) = (at, mechanism.point(id).ground) {
                let [x, y] = [17 + 3 * id.index(), 40 + 11 * id.index()];
                loaded += &format!("\n[[loads]]\npoint = \"{point}\"\nforce = [{x}, -{y}]\n");
            }
        }
        for link in mechanism.link_ids() {
            let (link, torque) = (scene.link_name(link), 2 + link.index());
            loaded += &format!("\n[[loads]]\nlink = \"{link}\"\ntorque = {torque}.5\n");
        }
        for text in follow(name, &loaded) {
            let ways = [
                "sum does not contain ",
                "contain no outer reaction",
                "The equations of all links",
            ];
            for (count, way) in output.iter_mut().zip(ways) {
                *count += text.matches(way).count();
            }
        }
    }
    assert!(output.iter().all(|&count| count > 60), "{output:?}");
}

/// A spring's law and a load's factor are chains like any other.
#[test]
fn springs_and_load_factors_are_shown() {
    let given = presets::find("four-bar").unwrap().text;
    let loads = "[[springs]]\nfrom = \"A\"\nto = \"C\"\nstiffness = 1200\nlength = 80\ndamping = 5\n\
        [[loads]]\nlink = \"r4\"\ntorque = 12\nover = [[0, 0.2], [180, 1], [360, 0.2]]\n";
    for text in follow("four-bar", &format!("{given}\n{loads}")) {
        assert!(
            text.contains("pull = k (L - L0) + c dL/dt = 1200*("),
            "{text}"
        );
        assert!(text.contains("torque on r4 = factor*12 = "), "{text}");
        assert!(text.contains(" Pin C\n"), "{text}");
    }
}

#[test]
fn reader_evaluates_printed_expressions() {
    assert_eq!(Reader::side("(-3.5)·2"), Some((-7.0, 7.0)));
    assert_eq!(Reader::side("7.00 mm/s at 90 deg"), Some((7.0, 7.0)));
    assert_eq!(Reader::side("sqrt(3^2 + (-4)^2)").unwrap().0, 5.0);
    assert_eq!(
        Reader::side("2·cos(60) - 1e-3").unwrap().0,
        2.0 * 60_f64.to_radians().cos() - 1e-3
    );
    assert_eq!(Reader::side("|ω3| r"), None);
}
