//! Compares another scene with the open one at the same driver coordinate: its ghost in the
//! drawing, and the differences in the tables.

use crate::drawing::{self, Extents, Figure};
use crate::quantity::DriverState;
use crate::report::{Pairing, Tables};
use crate::scene::Scene;
use crate::solver::{Condition, Order, Solver, Workspace};
use crate::tui::OpenedScene;
use crate::tui::figures::format::short;
use crate::tui::figures::sheet::Sheet;
use crate::tui::player::open_scene::{OpenScene, solved};
use crate::tui::player::scene_version::SceneRevision;
use crate::wording::words;
use crate::{Ball, DriverMoment, Input};

/// Only every fourth sample position is used to size the columns of differences.
const STRIDE: usize = 4;
/// Width of a speed, in columns.
const SPEED: usize = 8;

/// A scene compared with the open one.
#[derive(Debug)]
pub(crate) struct ComparedScene {
    edition: SceneRevision,
    /// The revision of the open scene that the comparison belongs to.
    base_revision: SceneRevision,
    /// The display name.
    name: String,
    other: Other,
    /// The extents of this scene, in its own unit.
    own: Extents,
    /// The extents of both scenes, in the unit of the open scene.
    reach: Extents,
    pairing: Pairing,
    /// The columns of the differences.
    sheet: Sheet,
    /// The differences: the values of the open scene minus those of this scene.
    tables: Tables,
    driver_state: DriverState,
}

/// The scene itself, solved at the open scene's coordinate.
#[derive(Debug)]
struct Other {
    opened: OpenedScene,
    state: Workspace,
    enclosure: Workspace<Ball>,
    /// The length unit of this scene, in units of the open scene.
    scale: f64,
}

impl ComparedScene {
    /// Compares a scene with the open one. Returns a message if they are not comparable.
    pub(crate) fn new(
        name: String,
        opened: OpenedScene,
        open_scene: &OpenScene,
    ) -> Result<ComparedScene, String> {
        comparable(&name, &opened.scene, open_scene.scene())?;
        let mut other = Other {
            state: opened.solver.state(),
            enclosure: opened.solver.enclosure(),
            scale: opened.scene.unit.in_units_of(open_scene.scene().unit),
            opened,
        };
        let own = Extents::of(&other.opened.scene, &other.opened.solver);
        let pairing = Pairing::of(
            open_scene.tables(),
            &other.tables(open_scene.driver_state()),
        );
        let sheet = Sheet::of_differences(&samples(open_scene, &mut other, &pairing));
        let there = other.tables(open_scene.driver_state());
        Ok(ComparedScene {
            edition: SceneRevision::default(),
            base_revision: open_scene.edition().clone(),
            name,
            reach: open_scene
                .extents()
                .union(&own, other.scale, other.driver()),
            tables: pairing.difference(open_scene.tables(), &there, other.scale),
            pairing,
            sheet,
            other,
            own,
            driver_state: *open_scene.driver_state(),
        })
    }

    /// Compares the scene with the current form of the open scene. Returns a message if they are no
    /// longer comparable.
    pub(crate) fn again(self, open_scene: &OpenScene) -> Result<ComparedScene, String> {
        ComparedScene::new(self.name, self.other.opened, open_scene)
    }

    /// Solves the scene at the open scene's coordinate.
    pub(crate) fn follow(&mut self, open_scene: &OpenScene) {
        if self.driver_state == *open_scene.driver_state() {
            return;
        }
        self.driver_state = *open_scene.driver_state();
        let there = self.other.tables(&self.driver_state);
        self.tables = self
            .pairing
            .difference(open_scene.tables(), &there, self.other.scale);
    }

    /// Returns the revision, which identifies this comparison.
    pub(crate) fn edition(&self) -> &SceneRevision {
        &self.edition
    }

    /// Returns `true` if the comparison belongs to this revision of the open scene.
    pub(crate) fn fits(&self, open_scene: &OpenScene) -> bool {
        self.base_revision == *open_scene.edition()
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

    /// Returns the length unit of this scene, in units of the open scene.
    pub(crate) fn scale(&self) -> f64 {
        self.other.scale
    }

    /// Returns both drivers' speeds if they differ, because all rates then differ too. Motions over
    /// time have equal speeds.
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

    /// Returns `true` if the scene has an assembly at the open scene's coordinate.
    pub(crate) fn is_assembled(&self) -> bool {
        self.other.state.condition() != Condition::NoAssembly
    }

    /// Adds the scene below a figure of the open scene; adds nothing without an assembly.
    pub(crate) fn add_ghost(&self, figure: &mut Figure) {
        let Other {
            opened,
            state,
            scale,
            ..
        } = &self.other;
        drawing::add_other(figure, &opened.scene, state, *scale);
    }

    /// Returns the extents of both scenes, in the unit of the open one.
    pub(crate) fn extents(&self) -> &Extents {
        &self.reach
    }

    /// Returns the union of `reach` and this scene's extents, in the unit of the open scene.
    pub(crate) fn union_of_extents(&self, extents: &Extents) -> Extents {
        extents.union(&self.own, self.other.scale, self.other.driver())
    }

    /// Returns the pairing of the two scenes' rows.
    pub(crate) fn pairing(&self) -> &Pairing {
        &self.pairing
    }

    /// Returns the columns of the differences.
    pub(crate) fn sheet(&self) -> &Sheet {
        &self.sheet
    }

    /// Returns the tables of the differences.
    pub(crate) fn tables(&self) -> &Tables {
        &self.tables
    }
}

impl Other {
    /// Returns the unit of this scene's driver coordinate, in units of the open scene's coordinate.
    fn driver(&self) -> f64 {
        match self.opened.scene.mechanism.driver().input {
            Input::Turn(_) => 1.0,
            Input::Push(_) => self.scale,
        }
    }

    /// Computes this scene's tables at the driver state of the open scene, with the same speed if
    /// that has a motion over time.
    fn tables(&mut self, driver_state: &DriverState) -> Tables {
        let unit = self.driver();
        let pace = driver_state.pace.map(|moment| DriverMoment {
            at: moment.at / unit,
            speed: moment.speed / unit,
            acceleration: moment.acceleration / unit,
            off: moment.off.map(|off| off / unit),
        });
        let at = driver_state.at / unit;
        solved(
            &self.opened,
            &DriverState { at, pace },
            Order::Acceleration,
            &mut self.state,
            &mut self.enclosure,
        )
    }
}

/// Computes the differences at positions over the open scene's whole motion.
fn samples(open_scene: &OpenScene, other: &mut Other, pairing: &Pairing) -> Vec<Tables> {
    let (mut state, mut enclosure) = (open_scene.solver().state(), open_scene.solver().enclosure());
    // Fewer positions than for the values suffice for the digits, and an edit has to wait for them.
    let places = open_scene.places().into_iter().step_by(STRIDE);
    let differences = places.map(|driver_state| {
        let here = open_scene.tables_at(&driver_state, &mut state, &mut enclosure);
        pairing.difference(&here, &other.tables(&driver_state), other.scale)
    });
    differences.collect()
}

/// Checks that both drivers are of the same kind, because the scenes share the driver coordinate.
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
