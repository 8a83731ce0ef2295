//! The state of the views: their cursors, settings and results. Each view's own module defines it
//! and brings it up to date.

use super::accuracy::MethodWatch;
use super::accuracy::study_run::{StudyRun, Ticker};
use super::layout::placement::Placement;
use super::lengths::LengthsStudy;
use super::motion::tracked_points::FollowedPoints;
use super::motion::viewport::Viewport;
use super::motor::study::MotorStudy;
use super::plots::curves::Plots;
use super::polygons::LoopPolygons;
use super::{View, forces};
use crate::tui::figures::cursor::Cursor;
use crate::tui::figures::force_figures::ForceFigures;
use crate::tui::figures::search::FoundLine;
use crate::tui::player::current_results::LiveResult;
use crate::tui::player::open_scene::OpenScene;
use crate::tui::player::solution_cache::Explained;
use crate::tui::views::page::LineCache;

/// The state of all views.
#[derive(Debug)]
pub(crate) struct ViewStates {
    /// The drawing's layers and window.
    pub(crate) viewport: Viewport,
    /// The points marked in the tables and traced in the drawing.
    pub(crate) followed: FollowedPoints,
    /// The cursor of the tables.
    pub(crate) cursor: Cursor,
    pub(crate) plots: Plots,
    pub(crate) motor: MotorStudy,
    pub(crate) study_run: StudyRun,
    pub(crate) method: MethodWatch,
    pub(crate) forces: LiveResult<ForceFigures>,
    pub(crate) lengths: LiveResult<LengthsStudy>,
    pub(crate) working: LiveResult<Explained>,
    pub(crate) polygons: LiveResult<LoopPolygons>,
    /// The lines of the pages in the last frames.
    pub(crate) page_lines: LineCache,
    /// The placed panes.
    pub(crate) placement: Placement,
    /// The lines by which each view is scrolled.
    pub(crate) scroll: [usize; View::ALL.len()],
    /// The last search text.
    pub(crate) sought: String,
    /// The view in which `n` and `N` repeat the last search, until the search ends.
    pub(crate) searched: Option<View>,
    /// The line with the last match, in a view of text lines.
    pub(crate) found: Option<FoundLine>,
}

impl ViewStates {
    pub(crate) fn new(clock: Ticker) -> ViewStates {
        ViewStates {
            viewport: Viewport::default(),
            followed: FollowedPoints::default(),
            cursor: Cursor::default(),
            plots: Plots::default(),
            motor: MotorStudy::default(),
            study_run: StudyRun::new(clock),
            method: MethodWatch::default(),
            forces: LiveResult::default(),
            lengths: LiveResult::default(),
            working: LiveResult::default(),
            polygons: LiveResult::default(),
            page_lines: LineCache::default(),
            placement: Placement::default(),
            scroll: [0; View::ALL.len()],
            sought: String::new(),
            searched: None,
            found: None,
        }
    }

    /// Resets all that belongs to the scene, because another one is shown.
    pub(crate) fn open(&mut self) {
        self.study_run.forget();
        self.plots = Plots::default();
        self.scroll = [0; View::ALL.len()];
        self.followed = FollowedPoints::default();
        self.viewport.lens.reset();
        self.cursor = Cursor::default();
        self.searched = None;
    }

    /// Computes the results of the visible views at the driver's position, and drops those of all
    /// others.
    pub(crate) fn refresh(&mut self, visible: &[View], open_scene: &mut OpenScene) {
        let shows = |view| visible.contains(&view);
        let wants_forces = shows(View::Forces) || self.viewport.shows_forces();
        open_scene.solve_forces(wants_forces);
        self.forces
            .refresh(wants_forces, open_scene, forces::balance, forces::follow);
        self.lengths.refresh(
            shows(View::Lengths),
            open_scene,
            LengthsStudy::new,
            LengthsStudy::go,
        );
        self.working.refresh(
            shows(View::Working),
            open_scene,
            Explained::new,
            Explained::go,
        );
        self.polygons.refresh(
            shows(View::Polygons),
            open_scene,
            LoopPolygons::new,
            LoopPolygons::go,
        );
        self.method.refresh(shows(View::Accuracy), open_scene);
        self.viewport.focus(open_scene, &self.followed);
    }
}
