//! The motor over a cycle, as it is found of the open scene: once for a scene or an edit; a frame only
//! looks where the driver is.

use crate::Vec2;
use crate::drawing::effort;
use crate::drawing::plot::Plot;
use crate::page::Page;
use crate::quantity::{Catalogue, Here};
use crate::report::{CsvDialect, MotorReport, MotorWishes};
use crate::tui::player::edition::Edition;
use crate::tui::player::open_scene::OpenScene;

/// What was found of a scene, if it has been looked at.
#[derive(Debug, Default)]
pub(crate) struct MotorStudy {
    studied: Option<Studied>,
}

#[derive(Debug)]
struct Studied {
    /// Which scene, in which form.
    of: Edition,
    report: MotorReport,
    page: Page,
    /// `None` where nothing acts.
    plot: Option<Plot>,
}

/// The size of an SVG in its own units.
const PAPER: Vec2 = Vec2 { x: 800.0, y: 400.0 };

impl MotorStudy {
    /// Studies the scene, if that was not done yet.
    pub(crate) fn study(&mut self, open_scene: &OpenScene) {
        if self
            .studied
            .as_ref()
            .is_some_and(|s| s.of == *open_scene.edition())
        {
            return;
        }
        let scene = open_scene.scene();
        let wishes = MotorWishes {
            motor: scene.motor.unwrap_or_default(),
            ..MotorWishes::default()
        };
        let report = MotorReport::new(scene, open_scene.solver(), wishes);
        let catalogue = Catalogue::new(scene);
        let coordinate = catalogue.driver();
        let names = [coordinate.name.as_str(), coordinate.unit.as_str()];
        let what = report.effort_name();
        let plot = report
            .duty
            .as_ref()
            .ok()
            .map(|duty| effort(duty, names, what));
        self.studied = Some(Studied {
            of: open_scene.edition().clone(),
            page: report.page(),
            report,
            plot,
        });
    }

    /// All that was found.
    pub(crate) fn page(&self) -> Option<&Page> {
        self.studied.as_ref().map(|studied| &studied.page)
    }

    /// Why there is neither curve nor figures.
    pub(crate) fn nothing(&self) -> String {
        let report = self.studied.as_ref().map(|studied| &studied.report);
        let why = report.and_then(|report| Some(report.nothing(report.duty.as_ref().err()?)));
        why.unwrap_or_default()
    }

    /// The curve over the cycle; `None` where nothing acts.
    pub(crate) fn plot(&self) -> Option<&Plot> {
        self.studied.as_ref()?.plot.as_ref()
    }

    /// Where the driver is in the cycle, and what it must do there.
    pub(crate) fn here(&self, at: f64) -> Option<Here> {
        let duty = self.studied.as_ref()?.report.duty.as_ref().ok()?;
        let course = &duty.cycle.course;
        let along = if course.goes_round {
            duty.cycle.coordinate(course.way(at)?)
        } else {
            at
        };
        // As the view of forces has it, not as the sums over the cycle do.
        Some(Here {
            along: Some(along),
            values: vec![duty.step(along).torque],
        })
    }

    /// The curve as an SVG document.
    pub(crate) fn svg(&self, open_scene: &OpenScene) -> Option<String> {
        let here = self.here(open_scene.at());
        Some(
            self.plot()?
                .svg(&open_scene.scene().title(), PAPER, true, here.as_ref()),
        )
    }

    /// The cycle step by step as comma separated values.
    pub(crate) fn csv(&self, dialect: CsvDialect) -> Option<String> {
        let report = &self.studied.as_ref()?.report;
        report.duty.as_ref().ok()?;
        let mut text = Vec::new();
        report.write_csv(dialect, &mut text).ok()?;
        String::from_utf8(text).ok()
    }

    /// All that was found as text.
    pub(crate) fn text(&self, ascii: bool) -> Option<String> {
        Some(self.studied.as_ref()?.report.to_text(ascii))
    }
}
