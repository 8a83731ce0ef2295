//! Writes a placement in a script language: the parts around its steps.

use super::closure::{Closure, ScriptResidual};
use super::placement::{Assignment, ScriptPlacement, ScriptStep};
use super::terms::number;
use crate::scene::{Scene, sanitized};
use crate::wording::Words;
use crate::{Input, LinkId, PointId};
use std::fmt::Write as _;

/// A script language.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum ScriptLanguage {
    /// Python 3, without any package.
    Python,
    /// MATLAB and Octave.
    Matlab,
}

/// The frames of scripts: the formulas of groups, and the main program.
const PYTHON: &str = include_str!("python.txt");
const MATLAB: &str = include_str!("matlab.txt");

impl ScriptLanguage {
    pub(super) const ALL: [ScriptLanguage; 2] = [ScriptLanguage::Python, ScriptLanguage::Matlab];

    /// Returns the element of a list; `index` counts from 0.
    pub(super) fn element(self, list: &str, index: usize) -> String {
        match self {
            ScriptLanguage::Python => format!("{list}[{index}]"),
            ScriptLanguage::Matlab => format!("{list}({})", index + 1),
        }
    }

    fn comment(self) -> &'static str {
        match self {
            ScriptLanguage::Python => "#",
            ScriptLanguage::Matlab => "%",
        }
    }

    fn end(self) -> &'static str {
        match self {
            ScriptLanguage::Python => "",
            ScriptLanguage::Matlab => ";",
        }
    }

    pub(super) fn frame(self) -> &'static str {
        match self {
            ScriptLanguage::Python => PYTHON,
            ScriptLanguage::Matlab => MATLAB,
        }
    }

    fn quoted(self, text: &str) -> String {
        match self {
            ScriptLanguage::Python => format!("\"{text}\""),
            ScriptLanguage::Matlab => format!("'{}'", text.replace('\'', "''")),
        }
    }
}

/// The parts of a script.
pub(super) struct Writing<'a> {
    pub(super) scene: &'a Scene,
    pub(super) placement: &'a ScriptPlacement<'a>,
    pub(super) language: ScriptLanguage,
    /// The name of the file.
    pub(super) name: &'a str,
    /// The range of the driver's coordinate.
    pub(super) range: [f64; 2],
}

impl Writing<'_> {
    /// Returns the script: the frame of its language, with each `<<...>>` replaced by the scene's
    /// own part.
    pub(super) fn text(&self, words: &dyn Words) -> String {
        let unit = self.scene.unit.symbol();
        let driver = match self.scene.mechanism.driver().input {
            Input::Turn(_) => "driver.angle [deg]".to_owned(),
            Input::Push(_) => format!("driver.position [{unit}]"),
        };
        let points = self.points();
        let comment = self.language.comment();
        let title = sanitized(&self.scene.title(), true);
        let headers = points.iter().flat_map(|&p| {
            let name = self.scene.point_name(p).unwrap_or_default();
            ["x", "y"].map(|axis| format!("{name}.{axis} [{unit}]"))
        });
        let headers: Vec<String> = std::iter::once(driver.clone()).chain(headers).collect();
        let headers: Vec<String> = headers.iter().map(|h| self.language.quoted(h)).collect();
        let names: Vec<&str> = points
            .iter()
            .map(|&p| self.placement.names.point(p))
            .collect();
        let about = words.about_script(&title, &driver, unit);
        let about: Vec<String> = about.lines().map(|l| format!("{comment} {l}")).collect();
        let [low, high] = self.range;
        let fillings = [
            ("about", about.join("\n")),
            ("name", self.name.to_owned()),
            ("constants", self.constants("")),
            ("constants_inside", self.constants("    ")),
            ("steps", self.steps(words)),
            ("points", names.join(", ")),
            ("heads", headers.join(", ")),
            ("low", number(low)),
            ("high", number(high)),
            ("step", number(self.step())),
            ("stride", number(self.stride())),
            ("opening", number(self.scene.mechanism.driver().start)),
            ("seeds", self.seeds()),
            ("turn", words.script_turn().to_owned()),
            ("circles", words.script_circles().to_owned()),
            ("circle_line", words.script_circle_line().to_owned()),
            ("lines", words.script_lines().to_owned()),
            ("swing", words.script_swing().to_owned()),
            ("side", words.script_side().to_owned()),
            ("follow", words.script_follow().to_owned()),
            ("newton", words.script_newton().to_owned()),
            ("positions", words.script_positions().to_owned()),
            ("given", words.script_given().to_owned()),
            ("table", words.script_table().to_owned()),
        ];
        let mut text = self.language.frame().to_owned();
        for (mark, filling) in fillings {
            text = text.replace(&format!("<<{mark}>>"), &filling);
        }
        text
    }

    /// Returns the points that the script places: moving points that are not centres of mass.
    fn points(&self) -> Vec<PointId> {
        let mechanism = &self.scene.mechanism;
        let moves = |p: &PointId| {
            mechanism.point(*p).ground.is_none()
                && self.placement.is_named(*p)
                && self.placement.is_known(*p)
        };
        mechanism.point_ids().filter(moves).collect()
    }

    fn constants(&self, indent: &str) -> String {
        let lines = self.placement.constants.iter();
        let lines: Vec<String> = lines.map(|it| self.line(indent, it)).collect();
        lines.join("\n")
    }

    fn line(&self, indent: &str, Assignment { name, term }: &Assignment) -> String {
        format!("{indent}{name} = {term}{}", self.language.end())
    }

    fn steps(&self, words: &dyn Words) -> String {
        let mut text = String::new();
        let mut closed = 0;
        for step in &self.placement.steps {
            let line = match step {
                ScriptStep::Assign(it) => self.line("    ", it),
                ScriptStep::Group(links) => {
                    let names: Vec<&str> = links.iter().map(|&l| self.link(l)).collect();
                    let group = words.script_group(&names.join(", "));
                    format!("    {} {group}", self.language.comment())
                }
                ScriptStep::Close(closure) => {
                    closed += 1;
                    self.closure(closure, closed - 1)
                }
            };
            let _ = writeln!(text, "{line}");
        }
        text.trim_end().to_owned()
    }

    fn link(&self, link: LinkId) -> &str {
        self.scene.link_name(link)
    }

    /// Returns the call that finds the unknowns; its result is the start of the next call.
    fn closure(&self, closure: &Closure, index: usize) -> String {
        let misfits: Vec<String> = closure.misfits.iter().map(|it| self.misfit(it)).collect();
        let misfits = misfits.join(", ");
        let name = &closure.name;
        match self.language {
            ScriptLanguage::Python => format!(
                "    {name}, seeds[{index}] = newton(lambda z: [{misfits}], seeds[{index}])"
            ),
            ScriptLanguage::Matlab => format!(
                "    [{name}, seeds{{{0}}}] = newton(@(z) [{misfits}], seeds{{{0}}});",
                index + 1
            ),
        }
    }

    fn misfit(&self, misfit: &ScriptResidual) -> String {
        match (misfit, self.language) {
            (ScriptResidual::Both(term), ScriptLanguage::Python) => format!("*both({term})"),
            (ScriptResidual::Both(term), ScriptLanguage::Matlab) => format!("both({term})"),
            (ScriptResidual::One(term), _) => term.to_string(),
        }
    }

    /// Returns the starts of Newton's method, one list per coupled group.
    fn seeds(&self) -> String {
        let closures = self.placement.steps.iter().filter_map(|step| match step {
            ScriptStep::Close(closure) => Some(closure),
            _ => None,
        });
        let lists: Vec<String> = closures
            .map(|closure| {
                let seeds: Vec<String> = closure.seeds.iter().map(|&s| number(s)).collect();
                format!("[{}]", seeds.join(", "))
            })
            .collect();
        lists.join(", ")
    }

    /// Returns the step of the driver from row to row.
    fn step(&self) -> f64 {
        match self.scene.mechanism.driver().input {
            Input::Turn(_) => 1.0,
            Input::Push(_) => self.stride(),
        }
    }

    /// Returns the maximum step of the driver if a group is coupled.
    fn stride(&self) -> f64 {
        match self.scene.mechanism.driver().input {
            Input::Turn(_) => 1.0,
            Input::Push(_) => (self.range[1] - self.range[0]) / 100.0,
        }
    }
}
