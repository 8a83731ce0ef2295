//! What every part of the working is written from, and onto.

use super::equations::LoopSide;
use super::expression::Expression;
use super::figures::Figures;
use super::polygon::{Loop, Polygon, Term};
use super::sides::{SideReading, SideShape, Turns};
use super::stages::{Schedule, Stage};
use super::symbols::WorkingNotation;
use crate::page::{Block, Content, Head, Page, Setting, Table, Units};
use crate::scene::Scene;
use crate::solver::{Condition, Group, Known, Order, Solver};
use crate::wording::words;
use crate::{Input, Mechanism, angle};

/// What the working is written from.
pub(super) struct Context<'a> {
    pub scene: &'a Scene,
    pub solver: &'a Solver,
    pub state: Known<'a>,
    pub polygon: &'a Polygon,
    pub schedule: &'a Schedule,
    pub stages: &'a [Stage],
    pub figures: Figures,
    pub notation: WorkingNotation,
    /// Every side in this state.
    pub readings: Vec<SideReading>,
    /// The largest velocity and the largest acceleration of all points: smaller ones are rounded by these.
    pub fastest: [f64; 2],
}

/// The page as it grows, and how far what it works out is from the solver's state.
#[derive(Debug, Default)]
pub(super) struct Draft {
    pub page: Page,
    pub agreements: Vec<Agreement>,
}

/// A figure that was worked out by the formula above it, and the solver's.
#[derive(Clone, Debug, PartialEq)]
pub struct Agreement {
    /// Its symbol.
    pub symbol: String,
    /// By the printed formula.
    pub worked: f64,
    /// The solver's.
    pub solved: f64,
    /// The size by which their difference is judged, in the same unit: that of the terms of the formula,
    /// divided by what the formula divides by.
    pub size: f64,
}

impl Agreement {
    /// The difference in parts of the size.
    #[must_use]
    pub fn part(&self) -> f64 {
        (self.worked - self.solved).abs() / self.size.max(f64::MIN_POSITIVE)
    }
}

impl<'a> Context<'a> {
    /// Whether there is an assembly here.
    pub(super) fn has_positions(&self) -> bool {
        self.state.condition() != Condition::NoAssembly
    }

    /// Whether velocities and accelerations exist.
    pub(super) fn has_rates(&self) -> bool {
        self.state.has(Order::Acceleration)
    }

    /// Reads every side; without an assembly what the scene and the driver give.
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
        // The rates of a driven slide are given, not found: none of them is rounding. What the driver turns has
        // its rates where nothing else has any.
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
        self.readings = readings;
    }

    /// The coordinate of the input that a side goes with; the driver's, where none is its own.
    fn given_at(&self, side: &super::sides::Side) -> f64 {
        let mechanism = &self.scene.mechanism;
        let input = self.schedule.input(side);
        let timed = input.and_then(|input| mechanism.timed_input(input));
        timed.map_or(self.state.at(), |timed| timed.coordinate(self.state.at()))
    }

    /// The longest side in this state.
    pub(super) fn longest(&self) -> f64 {
        let sides = self.readings.iter().map(|reading| reading.r.abs());
        sides
            .filter(|r| r.is_finite())
            .fold(f64::MIN_POSITIVE, f64::max)
    }

    /// Finds how fast the fastest points are.
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

    /// A term of a loop as a group sees it: what it and later groups find is sought.
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

    /// A group in words: `group 2, dyad RRR at C: links r3, r4`.
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

impl super::sides::Side {
    /// What the scene and the driver give of a side, where nothing else is known.
    fn given(&self, mechanism: &Mechanism, at: f64) -> SideReading {
        let theta = match (self.turns, self.shape) {
            // Of what turns, the driver's angle alone is given.
            (Turns::With(_, offset), _) => angle::wrapped(at + offset),
            (Turns::Never, SideShape::Slide(slide)) => {
                angle::wrapped(mechanism.slide(slide).angle + angle::TURN / 2.0)
            }
            (Turns::Never, SideShape::Rigid(_, local)) => angle::degrees(local),
            (Turns::Never, SideShape::Link(_) | SideShape::Free(..)) | (Turns::Freely, _) => 0.0,
        };
        let r = match self.shape {
            SideShape::Link(link) => super::sides::length(mechanism, link),
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

/// Blanks before a table, as before a formula.
const INDENT: usize = 2;

impl Draft {
    pub(super) fn table<const N: usize>(&mut self, head: [&str; N], rows: Vec<[String; N]>) {
        let rows = rows.into_iter().map(Into::into).collect();
        self.wide_table(head.map(str::to_owned).into(), rows);
    }

    /// A table of any number of columns.
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

    /// The same with units in a line of their own below the names, where both would be too wide.
    pub(super) fn table_of_units(&mut self, title: &str, heads: Vec<Head>, rows: Vec<Vec<String>>) {
        self.wide_table(vec![title.to_owned()], rows);
        if let Some(Block {
            content: Content::Table(table),
            ..
        }) = self.page.blocks.last_mut()
        {
            table.heads = heads;
            table.setting.units = Units::Below;
        }
    }

    /// `symbol = formula = value`: what comes out.
    pub(super) fn found(
        &mut self,
        symbol: &str,
        formula: &Expression,
        figure: impl FnOnce(f64) -> String,
    ) -> f64 {
        self.work(symbol, vec![formula.symbols()], formula, figure)
    }

    /// `symbol = numbers = value`: what comes out.
    pub(super) fn reckoned(
        &mut self,
        symbol: &str,
        formula: &Expression,
        figure: impl FnOnce(f64) -> String,
    ) -> f64 {
        self.work(symbol, vec![formula.numbers()], formula, figure)
    }

    /// `symbol = formula = numbers = value`: what comes out.
    pub(super) fn worked(
        &mut self,
        symbol: &str,
        formula: &Expression,
        figure: impl FnOnce(f64) -> String,
    ) -> f64 {
        let both = vec![formula.symbols(), formula.numbers()];
        self.work(symbol, both, formula, figure)
    }

    fn work(
        &mut self,
        symbol: &str,
        forms: Vec<String>,
        formula: &Expression,
        figure: impl FnOnce(f64) -> String,
    ) -> f64 {
        let value = formula.value();
        let sides = std::iter::once(symbol.to_owned()).chain(forms);
        self.page.equation(sides.chain([figure(value)]));
        value
    }

    /// Notes a figure that was worked out beside the solver's.
    pub(super) fn agree(&mut self, symbol: &str, worked: f64, solved: f64, size: f64) {
        self.agreements.push(Agreement {
            symbol: symbol.to_owned(),
            worked,
            solved,
            size,
        });
    }

    /// The same for angles in degrees, which count modulo a turn; `loss` is what the formula loses, in
    /// radians.
    pub(super) fn agree_angle(&mut self, symbol: &str, worked: f64, solved: f64, loss: f64) {
        let away = angle::wrapped(worked - solved + angle::TURN / 2.0) - angle::TURN / 2.0;
        self.agree(symbol, solved + away, solved, loss.to_degrees());
    }
}
