//! Computes the motor's duty of the open scene, over a cycle or over a period of a motion over
//! time. It is computed once per scene revision; a frame only evaluates the driver's current
//! position.

use crate::Vec2;
use crate::drawing::effort;
use crate::drawing::plot::Plot;
use crate::page::Page;
use crate::quantity::{Abscissa, Catalogue, Clock, Curves, StateValues};
use crate::report::{CsvDialect, MotorReport, MotorRequest, TimedMotorReport, curves_csv};
use crate::scene::Scene;
use crate::solver::{Order, Solver};
use crate::study::motor::{NoTimedDuty, TimedDuty};
use crate::tui::player::open_scene::OpenScene;
use crate::tui::player::scene_version::SceneRevision;

/// The motor study of a scene, empty until the view is shown.
#[derive(Debug, Default)]
pub(crate) struct MotorStudy {
    studied: Option<MotorResult>,
}

#[derive(Debug)]
struct MotorResult {
    /// The revision of the scene.
    of: SceneRevision,
    found: FoundMotor,
    page: Page,
    /// The curve; `None` if there are no forces.
    plot: Option<Plot>,
}

/// The result of a motor study.
#[derive(Debug)]
enum FoundMotor {
    Cycle(Box<MotorReport>),
    Period(Box<Period>),
    /// The reason why there is no duty over a period.
    Nothing(String),
}

/// The duty over a period of a motion over time.
#[derive(Debug)]
struct Period {
    report: TimedMotorReport,
    curves: Curves,
}

/// The size of an SVG in its own units.
const PAPER: Vec2 = Vec2 { x: 800.0, y: 400.0 };

impl FoundMotor {
    fn of(scene: &Scene, solver: &Solver) -> FoundMotor {
        if let Some(clock) = Clock::of(scene).filter(|_| scene.motion.is_some()) {
            return match Period::new(scene, solver, &clock) {
                Ok(period) => FoundMotor::Period(Box::new(period)),
                Err(why) => FoundMotor::Nothing(TimedMotorReport::nothing(scene, &why)),
            };
        }
        let preferences = MotorRequest {
            motor: scene.motor.unwrap_or_default(),
            ..MotorRequest::default()
        };
        FoundMotor::Cycle(Box::new(MotorReport::new(scene, solver, preferences)))
    }

    fn page(&self) -> Page {
        match self {
            FoundMotor::Cycle(report) => report.page(),
            FoundMotor::Period(period) => period.report.page(),
            FoundMotor::Nothing(why) => {
                let mut page = Page::default();
                page.text_below(why.clone());
                page
            }
        }
    }

    fn plot(&self, scene: &Scene) -> Option<Plot> {
        match self {
            FoundMotor::Cycle(report) => {
                let catalogue = Catalogue::new(scene);
                let coordinate = catalogue.driver();
                let names = [coordinate.name.as_str(), coordinate.unit.as_str()];
                let duty = report.duty.as_ref().ok()?;
                Some(effort(duty, names, report.effort_name()))
            }
            FoundMotor::Period(period) => Some(Plot::of(&period.curves)),
            FoundMotor::Nothing(_) => None,
        }
    }
}

impl Period {
    fn new(scene: &Scene, solver: &Solver, clock: &Clock) -> Result<Period, NoTimedDuty> {
        let duty = TimedDuty::new(clock, solver)?;
        let catalogue = Catalogue::new(scene);
        let efforts = ["driver.torque", "driver.force"];
        let effort = efforts.iter().find_map(|name| catalogue.find(name));
        let curves = Curves::new(scene, solver, effort.as_slice(), Abscissa::Time, None);
        Ok(Period {
            report: TimedMotorReport::new(scene, duty, &scene.motor.unwrap_or_default()),
            curves: curves.map_err(|_| NoTimedDuty::NothingActs)?,
        })
    }
}

impl MotorStudy {
    /// Computes the study of the scene unless it is cached.
    pub(crate) fn study(&mut self, open_scene: &OpenScene) {
        if self
            .studied
            .as_ref()
            .is_some_and(|s| s.of == *open_scene.edition())
        {
            return;
        }
        let scene = open_scene.scene();
        let found = FoundMotor::of(scene, open_scene.solver());
        self.studied = Some(MotorResult {
            of: open_scene.edition().clone(),
            page: found.page(),
            plot: found.plot(scene),
            found,
        });
    }

    /// Returns the results as a page.
    pub(crate) fn page(&self) -> Option<&Page> {
        self.studied.as_ref().map(|studied| &studied.page)
    }

    /// Returns the reason why there are neither curve nor values.
    pub(crate) fn nothing(&self) -> String {
        match self.studied.as_ref().map(|studied| &studied.found) {
            Some(FoundMotor::Cycle(report)) => {
                let why = report.duty.as_ref().err();
                why.map(|why| report.nothing(why)).unwrap_or_default()
            }
            Some(FoundMotor::Nothing(why)) => why.clone(),
            Some(FoundMotor::Period(_)) | None => String::new(),
        }
    }

    /// Returns the curve over the cycle; `None` if there are no forces.
    pub(crate) fn plot(&self) -> Option<&Plot> {
        self.studied.as_ref()?.plot.as_ref()
    }

    /// Returns the driver's position in the cycle or period, with its effort there.
    pub(crate) fn here(&self, open_scene: &OpenScene) -> Option<StateValues> {
        let report = match &self.studied.as_ref()?.found {
            FoundMotor::Cycle(report) => report,
            FoundMotor::Period(period) => {
                let time = open_scene.time()?;
                let mut state = open_scene.solver().state();
                let driver_state = open_scene.driver_state();
                let _ = driver_state.solve(open_scene.solver(), Order::Force, &mut state);
                return Some(period.curves.here_at(time, &state));
            }
            FoundMotor::Nothing(_) => return None,
        };
        let duty = report.duty.as_ref().ok()?;
        let (course, at) = (&duty.cycle.course, open_scene.at());
        let along = if course.is_periodic {
            duty.cycle.coordinate(course.way(at)?)
        } else {
            at
        };
        // The torque solved at this position, as in the forces view, not the one of the sums over
        // the cycle.
        Some(StateValues {
            along: Some(along),
            values: vec![duty.step(along).torque],
        })
    }

    /// Returns the curve as an SVG document.
    pub(crate) fn svg(&self, open_scene: &OpenScene) -> Option<String> {
        let here = self.here(open_scene);
        Some(
            self.plot()?
                .svg(&open_scene.scene().title(), PAPER, true, here.as_ref()),
        )
    }

    /// Returns the steps of the cycle as CSV.
    pub(crate) fn csv(&self, dialect: CsvDialect) -> Option<String> {
        let report = match &self.studied.as_ref()?.found {
            FoundMotor::Cycle(report) => report,
            FoundMotor::Period(period) => return Some(curves_csv(&period.curves, dialect)),
            FoundMotor::Nothing(_) => return None,
        };
        report.duty.as_ref().ok()?;
        let mut text = Vec::new();
        report.write_csv(dialect, &mut text).ok()?;
        String::from_utf8(text).ok()
    }

    /// Returns the results as text.
    pub(crate) fn text(&self, ascii: bool) -> Option<String> {
        Some(match &self.studied.as_ref()?.found {
            FoundMotor::Cycle(report) => report.to_text(ascii),
            FoundMotor::Period(period) => period.report.to_text(ascii),
            FoundMotor::Nothing(why) => why.clone(),
        })
    }
}
