//! Another scene beside the open one, at the same coordinate of the driver: its ghost in the drawing, and
//! what the figures differ by.

use crate::drawing::{self, Figure, Reach};
use crate::quantity::DriverStand;
use crate::report::{Pairing, Tables};
use crate::scene::Scene;
use crate::solver::{Condition, Order, Solver, Workspace};
use crate::tui::Opened;
use crate::tui::figures::format::short;
use crate::tui::figures::sheet::Sheet;
use crate::tui::player::edition::Edition;
use crate::tui::player::open_scene::{OpenScene, solved};
use crate::wording::words;
use crate::{Ball, DriverMoment, Input};

/// Of the places that figures are fitted to, differences are fitted to one of so many.
const STRIDE: usize = 4;
/// Columns of a speed.
const SPEED: usize = 8;

/// A scene that the open one is held against.
#[derive(Debug)]
pub(crate) struct ComparedScene {
    edition: Edition,
    /// What it is fitted to.
    beside: Edition,
    /// As it is called.
    name: String,
    other: Other,
    /// The space that it needs, in its own unit.
    own: Reach,
    /// The space that both need, in the unit of the open scene.
    reach: Reach,
    pairing: Pairing,
    /// The columns of the differences.
    sheet: Sheet,
    /// What the figures of the open scene are more than its own.
    tables: Tables,
    stand: DriverStand,
}

/// The scene itself, solved where the open one is.
#[derive(Debug)]
struct Other {
    opened: Opened,
    state: Workspace,
    enclosure: Workspace<Ball>,
    /// How many units of the open scene one of its own is.
    scale: f64,
}

impl ComparedScene {
    /// Holds a scene against the open one; in words why that cannot be.
    pub(crate) fn new(
        name: String,
        opened: Opened,
        open_scene: &OpenScene,
    ) -> Result<ComparedScene, String> {
        comparable(&name, &opened.scene, open_scene.scene())?;
        let mut other = Other {
            state: opened.solver.state(),
            enclosure: opened.solver.enclosure(),
            scale: opened.scene.unit.in_units_of(open_scene.scene().unit),
            opened,
        };
        let own = Reach::of(&other.opened.scene, &other.opened.solver);
        let pairing = Pairing::of(open_scene.tables(), &other.tables(open_scene.stand()));
        let sheet = Sheet::of_differences(&samples(open_scene, &mut other, &pairing));
        let there = other.tables(open_scene.stand());
        Ok(ComparedScene {
            edition: Edition::default(),
            beside: open_scene.edition().clone(),
            name,
            reach: open_scene.reach().beside(&own, other.scale, other.driver()),
            tables: pairing.difference(open_scene.tables(), &there, other.scale),
            pairing,
            sheet,
            other,
            own,
            stand: *open_scene.stand(),
        })
    }

    /// Holds it against the open scene as that is now; in words why that cannot be any more.
    pub(crate) fn again(self, open_scene: &OpenScene) -> Result<ComparedScene, String> {
        ComparedScene::new(self.name, self.other.opened, open_scene)
    }

    /// Goes where the open scene is.
    pub(crate) fn follow(&mut self, open_scene: &OpenScene) {
        if self.stand == *open_scene.stand() {
            return;
        }
        self.stand = *open_scene.stand();
        let there = self.other.tables(&self.stand);
        self.tables = self
            .pairing
            .difference(open_scene.tables(), &there, self.other.scale);
    }

    /// Another one, another comparison.
    pub(crate) fn edition(&self) -> &Edition {
        &self.edition
    }

    /// Whether it is fitted to the scene in this form.
    pub(crate) fn fits(&self, open_scene: &OpenScene) -> bool {
        self.beside == *open_scene.edition()
    }

    pub(crate) fn name(&self) -> &str {
        &self.name
    }

    pub(crate) fn scene(&self) -> &Scene {
        &self.other.opened.scene
    }

    pub(crate) fn solver(&self) -> &Solver {
        &self.other.opened.solver
    }

    /// How many units of the open scene one of its own is.
    pub(crate) fn scale(&self) -> f64 {
        self.other.scale
    }

    /// The speeds of both drivers, where they differ: then every rate does. By a motion over time both pass alike.
    pub(crate) fn speeds(&self, open_scene: &OpenScene) -> Option<String> {
        if open_scene.timetable().is_some() {
            return None;
        }
        let driver = open_scene.scene().mechanism.driver();
        let other = self.other.opened.scene.mechanism.driver();
        let (scale, unit) = match driver.input {
            Input::Turn(_) => (1.0, "rad"),
            Input::Push(_) => (self.other.scale, open_scene.scene().unit.symbol()),
        };
        let [this, other] = [driver.speed, other.speed * scale].map(|speed| short(speed, SPEED));
        (this != other).then(|| words().this_and_other(&this, &format!("{other} {unit}/s")))
    }

    /// Whether it can be where the open scene is.
    pub(crate) fn is_assembled(&self) -> bool {
        self.other.state.condition() != Condition::NoAssembly
    }

    /// Adds it to a figure of the open scene, below everything; nothing where it cannot be.
    pub(crate) fn add_ghost(&self, figure: &mut Figure) {
        let Other {
            opened,
            state,
            scale,
            ..
        } = &self.other;
        drawing::add_other(figure, &opened.scene, state, *scale);
    }

    /// The space that both scenes need, in the unit of the open one.
    pub(crate) fn reach(&self) -> &Reach {
        &self.reach
    }

    /// The same with room for whatever the drawing of the open scene needs beside that.
    pub(crate) fn reach_beside(&self, reach: &Reach) -> Reach {
        reach.beside(&self.own, self.other.scale, self.other.driver())
    }

    /// Which rows have a partner.
    pub(crate) fn pairing(&self) -> &Pairing {
        &self.pairing
    }

    /// The columns of the differences.
    pub(crate) fn sheet(&self) -> &Sheet {
        &self.sheet
    }

    /// The differences.
    pub(crate) fn tables(&self) -> &Tables {
        &self.tables
    }
}

impl Other {
    /// How many units of the coordinate of the open scene one of its own is.
    fn driver(&self) -> f64 {
        match self.opened.scene.mechanism.driver().input {
            Input::Turn(_) => 1.0,
            Input::Push(_) => self.scale,
        }
    }

    /// Its tables where the driver of the open scene is, which it passes in the same way if that has a motion over time.
    fn tables(&mut self, stand: &DriverStand) -> Tables {
        let unit = self.driver();
        let pace = stand.pace.map(|moment| DriverMoment {
            at: moment.at / unit,
            speed: moment.speed / unit,
            acceleration: moment.acceleration / unit,
            off: moment.off.map(|off| off / unit),
        });
        let at = stand.at / unit;
        solved(
            &self.opened,
            &DriverStand { at, pace },
            Order::Acceleration,
            &mut self.state,
            &mut self.enclosure,
        )
    }
}

/// The differences spread over the motion of the open scene.
fn samples(open_scene: &OpenScene, other: &mut Other, pairing: &Pairing) -> Vec<Tables> {
    let (mut state, mut enclosure) = (open_scene.solver().state(), open_scene.solver().enclosure());
    // Fewer places than for figures: they tell the digits well enough, and an edit has to wait for them.
    let places = open_scene.places().into_iter().step_by(STRIDE);
    let differences = places.map(|stand| {
        let here = open_scene.tables_at(&stand, &mut state, &mut enclosure);
        pairing.difference(&here, &other.tables(&stand), other.scale)
    });
    differences.collect()
}

/// Two scenes are held against each other at the same coordinate: they need one of the same kind.
fn comparable(name: &str, other: &Scene, this: &Scene) -> Result<(), String> {
    let driven = |scene: &Scene| match scene.mechanism.driver().input {
        Input::Turn(_) => words().a_link_that_turns(),
        Input::Push(_) => words().a_slide(),
    };
    let [other, this] = [other, this].map(driven);
    if other == this {
        Ok(())
    } else {
        Err(words().no_common_coordinate(name, other, this))
    }
}
