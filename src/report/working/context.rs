//! The context from which every part of the working (the worked solution) is written, and the page
//! under construction.

use super::equations::LoopSide;
use super::expression::Expression;
use super::figures::Figures;
use super::loops::group_unknowns::{LoopUnknown, Schedule, Stage};
use super::loops::polygon::{Loop, Polygon, Term};
use super::loops::sides::{SideReading, SideShape, Turns};
use super::symbols::{self, WorkingNotation};
use crate::page::{Block, Content, Formula, Head, Page, Setting, Symbol, Table, Units};
use crate::scene::Scene;
use crate::solver::{Condition, Group, Known, Order, Solver};
use crate::wording::words;
use crate::{Input, LinkId, Mechanism, angle};

/// The context of a worked solution.
pub(super) struct Context<'a> {
    pub scene: &'a Scene,
    pub solver: &'a Solver,
    pub state: Known<'a>,
    pub polygon: &'a Polygon,
    pub schedule: &'a Schedule,
    pub stages: &'a [Stage],
    pub figures: Figures,
    pub notation: WorkingNotation,
    /// The data of every side in this state.
    pub readings: Vec<SideReading>,
    /// The length of the longest side in this state.
    pub longest: f64,
    /// The maximum velocity and acceleration of all points; smaller ones have rounding errors of
    /// this magnitude.
    pub fastest: [f64; 2],
}

/// The page under construction, and the differences between calculated values and the solver's
/// state.
#[derive(Debug, Default)]
pub(super) struct Draft {
    pub page: Page,
    pub agreements: Vec<Agreement>,
}

/// A value calculated by the printed formula, and the solver's.
#[derive(Clone, Debug, PartialEq)]
pub struct Agreement {
    /// The symbol.
    pub symbol: String,
    /// The value of the printed formula.
    pub worked: f64,
    /// The value of the solver.
    pub solved: f64,
    /// The magnitude by which the difference is judged, in the same unit: that of the formula's
    /// terms, divided by its divisor.
    pub size: f64,
}

impl Agreement {
    /// Returns the difference relative to the magnitude.
    #[must_use]
    pub fn part(&self) -> f64 {
        (self.worked - self.solved).abs() / self.size.max(f64::MIN_POSITIVE)
    }
}

impl<'a> Context<'a> {
    /// Returns `true` if there is an assembly here.
    pub(super) fn has_positions(&self) -> bool {
        self.state.condition() != Condition::NoAssembly
    }

    /// Returns `true` if velocities and accelerations exist.
    pub(super) fn has_rates(&self) -> bool {
        self.state.has(Order::Acceleration)
    }

    /// Evaluates every side; without an assembly, from the data of the scene and the driver.
    pub(super) fn read_sides(&mut self) {
        let mechanism = &self.scene.mechanism;
        let sides = self.polygon.sides.iter();
        let mut readings: Vec<SideReading> = if self.has_positions() {
            sides.map(|side| side.read(mechanism, self.state)).collect()
        } else {
            sides
                .map(|side| side.given(mechanism, self.given_at(side)))
                .collect()
        };
        // The rates of a driven slide are given, so they have no rounding errors. A link turned by
        // the driver has its rates even if no other link has any.
        let rates = [self.state.driver_speed(), self.state.driver_acceleration()];
        for (side, reading) in self.polygon.sides.iter().zip(&mut readings) {
            let Some(input) = self.schedule.input(side) else {
                continue;
            };
            let timed = mechanism.timed_input(input);
            let rates = timed.map_or(rates, |timed| {
                let [first, second] = timed.rates(self.state.at(), mechanism.driver().input);
                let [speed, acceleration] = rates;
                [first * speed, first * acceleration + second * speed * speed]
            });
            match input {
                Input::Push(_) => [reading.rate, reading.accel] = rates,
                Input::Turn(_) if !self.has_rates() => [reading.omega, reading.alpha] = rates,
                Input::Turn(_) => {}
            }
        }
        let sides = readings.iter().map(|reading| reading.r.abs());
        self.longest = sides
            .filter(|r| r.is_finite())
            .fold(f64::MIN_POSITIVE, f64::max);
        self.readings = readings;
    }

    /// Returns the coordinate of the input that drives a side, or else the driver's.
    fn given_at(&self, side: &super::loops::sides::Side) -> f64 {
        let mechanism = &self.scene.mechanism;
        let input = self.schedule.input(side);
        let timed = input.and_then(|input| mechanism.timed_input(input));
        timed.map_or(self.state.at(), |timed| timed.coordinate(self.state.at()))
    }

    /// Computes the maximum velocity and acceleration.
    pub(super) fn find_fastest(&mut self) {
        if !self.has_rates() {
            return;
        }
        let state = self.state;
        let points = || self.scene.mechanism.point_ids();
        self.fastest = [
            points()
                .map(|p| state.velocity(p).norm())
                .fold(0.0, f64::max),
            points()
                .map(|p| state.acceleration(p).norm())
                .fold(0.0, f64::max),
        ];
    }

    /// Returns a term of a loop as seen by a group: values found by it or later groups are unknown.
    pub(super) fn member(&self, term: Term, stage: &Stage) -> LoopSide<'_> {
        let side = &self.polygon.sides[term.side];
        let is_sought = |group: Option<usize>| match (group, stage.group) {
            (None, _) => false,
            (Some(_), _) if !self.has_positions() => true,
            (Some(group), Some(own)) => group >= own,
            (Some(group), None) => group == usize::MAX,
        };
        LoopSide {
            side,
            reversed: term.reversed,
            reading: self.readings[term.side],
            turner: side.turner(self.scene),
            driven: self.schedule.is_driven(side) || self.schedule.is_pushed(side),
            sought: [
                is_sought(self.schedule.length_group(side)),
                is_sought(self.schedule.angle_group(side)),
            ],
        }
    }

    pub(super) fn members(&self, of: &Loop, stage: &Stage) -> Vec<LoopSide<'_>> {
        of.terms
            .iter()
            .map(|&term| self.member(term, stage))
            .collect()
    }

    /// Returns the symbol of a link's angle.
    pub(super) fn theta(&self, link: LinkId) -> Symbol {
        symbols::theta(self.scene.link_name(link))
    }

    /// Returns the angle of a link, plus the angle by which a vector leads it.
    pub(super) fn leading_angle(&self, link: LinkId, ahead: f64) -> Formula {
        let theta = Expression::symbol(self.theta(link));
        match self.figures.direction(ahead) {
            by if by == "0" => theta.symbols(),
            by => (theta + Expression::figure(by, ahead)).symbols(),
        }
    }

    /// Returns the symbol of an unknown, or of its rate of an order.
    pub(super) fn symbol(&self, unknown: LoopUnknown, order: Order) -> Symbol {
        let side = |side: usize| &self.polygon.sides[side].name;
        match unknown {
            LoopUnknown::Angle(link) => symbols::angle(self.scene.link_name(link), order),
            LoopUnknown::Travel(slide) => symbols::length(self.scene.slide_name(slide), order),
            LoopUnknown::Length(of) => symbols::length(side(of), order),
            LoopUnknown::Direction(of) => symbols::angle(side(of), order),
        }
    }

    /// Describes a group: `group 2, dyad RRR at C: links r3, r4`.
    pub(super) fn group_text(&self, number: usize) -> String {
        let Some(group) = self.solver.plan().groups.get(number) else {
            return String::new();
        };
        let what = self.kind_text(group);
        let links: Vec<&str> = group
            .links
            .iter()
            .map(|&l| self.scene.link_name(l))
            .collect();
        match links[..] {
            [] => words().group_in_words(number + 1, &what),
            [link] => words().group_of_one_link(number + 1, &what, link),
            _ => words().group_of_many_links(number + 1, &what, &links.join(", ")),
        }
    }

    fn kind_text(&self, group: &Group) -> String {
        let at = group.point.and_then(|point| self.scene.point_name(point));
        match (group.kind.class(), group.kind.unknowns()) {
            (Some(class), _) => match at {
                Some(point) => words().dyad_at(class, point),
                None => words().dyad(class),
            },
            (None, Some(unknowns)) => words().coupled_of_unknowns(unknowns),
            (None, None) => words().driver().into(),
        }
    }
}

impl super::loops::sides::Side {
    /// Evaluates a side from the scene and the driver only.
    fn given(&self, mechanism: &Mechanism, at: f64) -> SideReading {
        let theta = match (self.turns, self.shape) {
            // Among angles, only the driver's is given.
            (Turns::With(_, offset), _) => angle::wrapped(at + offset),
            (Turns::Never, SideShape::Slide(slide)) => {
                angle::wrapped(mechanism.slide(slide).angle + angle::TURN / 2.0)
            }
            (Turns::Never, SideShape::Rigid(_, local)) => angle::degrees(local),
            (Turns::Never, SideShape::Link(_) | SideShape::Free(..)) | (Turns::Freely, _) => 0.0,
        };
        let r = match self.shape {
            SideShape::Link(link) => super::loops::sides::length(mechanism, link),
            SideShape::Rigid(_, local) => local.norm(),
            SideShape::Slide(_) => at,
            SideShape::Free(..) => 0.0,
        };
        SideReading {
            r,
            theta,
            u: angle::unit(theta),
            ..SideReading::default()
        }
    }
}

/// Indent of a table, as of a formula.
const INDENT: usize = 2;

impl Draft {
    pub(super) fn part(&mut self, text: &str) {
        self.page.part(text);
    }

    pub(super) fn section(&mut self, text: impl AsRef<str>) {
        self.page.section(text);
    }

    pub(super) fn text(&mut self, text: impl Into<String>) {
        self.page.text(text);
    }

    /// Writes equal sides.
    pub(super) fn equation(&mut self, sides: impl IntoIterator<Item = Formula>) {
        self.page.equation(sides);
    }

    /// Writes `formula = 0`.
    pub(super) fn write_zero(&mut self, formula: Formula) {
        self.equation([formula, Formula::zero()]);
    }

    pub(super) fn table<const N: usize>(&mut self, head: [&str; N], rows: Vec<[String; N]>) {
        let rows = rows.into_iter().map(Into::into).collect();
        self.wide_table(head.map(str::to_owned).into(), rows);
    }

    /// Adds a table with any number of columns.
    pub(super) fn wide_table(&mut self, head: Vec<String>, rows: Vec<Vec<String>>) {
        let mut head = head.into_iter();
        let mut table = Table::new(head.next().unwrap_or_default(), head).set(Setting {
            indent: INDENT,
            ..Setting::default()
        });
        for row in rows {
            let mut cells = row.into_iter();
            table.row(cells.next().unwrap_or_default(), cells);
        }
        self.page.table(table);
    }

    /// Adds a table with units in a separate line below the names, if both would be too wide.
    pub(super) fn table_of_units(
        &mut self,
        title: &str,
        headers: Vec<Head>,
        rows: Vec<Vec<String>>,
    ) {
        self.wide_table(vec![title.to_owned()], rows);
        if let Some(Block {
            content: Content::Table(table),
            ..
        }) = self.page.blocks.last_mut()
        {
            table.heads = headers;
            table.setting.units = Units::Below;
        }
    }

    /// Writes `symbol = formula = value` and returns the value.
    pub(super) fn found(
        &mut self,
        symbol: impl Into<Formula>,
        formula: &Expression,
        figure: impl FnOnce(f64) -> Formula,
    ) -> f64 {
        self.work(symbol.into(), vec![formula.symbols()], formula, figure)
    }

    /// Writes `symbol = numbers = value` and returns the value.
    pub(super) fn write_numbers(
        &mut self,
        symbol: impl Into<Formula>,
        formula: &Expression,
        figure: impl FnOnce(f64) -> Formula,
    ) -> f64 {
        self.work(symbol.into(), vec![formula.numbers()], formula, figure)
    }

    /// Writes `symbol = formula = numbers = value` and returns the value.
    pub(super) fn worked(
        &mut self,
        symbol: impl Into<Formula>,
        formula: &Expression,
        figure: impl FnOnce(f64) -> Formula,
    ) -> f64 {
        let both = vec![formula.symbols(), formula.numbers()];
        self.work(symbol.into(), both, formula, figure)
    }

    fn work(
        &mut self,
        symbol: Formula,
        forms: Vec<Formula>,
        formula: &Expression,
        figure: impl FnOnce(f64) -> Formula,
    ) -> f64 {
        let value = formula.value();
        let sides = std::iter::once(symbol).chain(forms);
        self.page.equation(sides.chain([figure(value)]));
        value
    }

    /// Records a calculated value together with the solver's.
    pub(super) fn agree(&mut self, symbol: impl ToString, computed: f64, solved: f64, size: f64) {
        self.agreements.push(Agreement {
            symbol: symbol.to_string(),
            worked: computed,
            solved,
            size,
        });
    }

    /// Records a calculated angle in degrees, modulo a turn; `loss` is the error of the formula in
    /// radians.
    pub(super) fn agree_angle(
        &mut self,
        symbol: impl ToString,
        computed: f64,
        solved: f64,
        loss: f64,
    ) {
        let away = angle::wrapped(computed - solved + angle::TURN / 2.0) - angle::TURN / 2.0;
        self.agree(symbol, solved + away, solved, loss.to_degrees());
    }
}
