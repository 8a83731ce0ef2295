//! `krank draw`: draws the linkage at one driver coordinate, or along its motion, in one of several
//! formats.

mod cast;
mod dxf;
mod format;
mod gif;
mod png;
mod svg;
mod text;
mod turn;

use format::FormatOption;
pub(in crate::cli) use format::{DrawFormat, FORMATS};

use super::args::{DrawArgs, NamesChoice, Size};
use super::commands::{nothing_hidden, out_of_reach, place};
use super::failure::{Failure, note};
use super::output::{goes_to_terminal, write_to};
use super::picture::ASPECT;
use super::screen::TextScreen;
use super::source::SolvableScene;
use crate::drawing::{
    self, Glyphs, Labels, Layers, Overlay, Raster, Reach, SvgGround, Wanted, WorldView,
};
use crate::nearest::nearest;
use crate::quantity::Catalogue;
use crate::scene::Scene;
use crate::solver::{Condition, Order, Solver, State, Workspace};
use crate::wording::words;
use crate::{Mechanism, PointId};

/// Columns of a document, and its maximum number of rows.
const DOCUMENT_COLUMNS: u16 = 100;
const DOCUMENT_ROWS: u16 = 50;
/// Maximum number of lines of a legend.
const MAX_LEGEND: usize = 2;

pub(super) fn draw(args: &DrawArgs, screen: TextScreen) -> Result<(), Failure> {
    args.format.check(args)?;
    if args.format.is_binary && goes_to_terminal(args.output.output.as_deref()) {
        return Err(Failure::Usage(words().no_text(args.format.name)));
    }
    let SolvableScene { scene, solver } = args.scene.open_for(&args.output)?;
    let at = place(&args.place, &scene, &solver, screen);
    let wanted = wanted(args, &scene)?;
    let mut state = solver.state();
    match solver.solve(at, order(args), &mut state) {
        Condition::NoAssembly => return Err(out_of_reach(&scene, &solver, at)),
        Condition::DeadPoint
            if args.forces || args.velocities.is_some() || args.accelerations.is_some() =>
        {
            note(words().no_arrows(), screen);
        }
        Condition::DeadPoint | Condition::Ok | Condition::ChangePoint => {}
    }
    if args.forces && !solver.has_forces() {
        note(words().nothing_acts_in_short(), screen);
    }
    let drawn = DrawnScene::new(args, &scene, &solver, &state, &wanted);
    let bytes = (args.format.write)(&drawn)?;
    write_to(args.output.output.as_deref(), |out| out.write_all(&bytes))?;
    nothing_hidden(&scene, &state)
}

/// A scene with everything needed to draw it at any driver coordinate.
struct DrawnScene<'a> {
    args: &'a DrawArgs,
    scene: &'a Scene,
    solver: &'a Solver,
    /// The state at the requested coordinate.
    state: &'a State,
    overlay: Overlay,
    /// The extents of the linkage, and those including the tips of arrows.
    links: Reach,
    reach: Reach,
    /// `true` if the drawing shows parts of the whole motion.
    whole: bool,
}

impl<'a> DrawnScene<'a> {
    fn new(
        args: &'a DrawArgs,
        scene: &'a Scene,
        solver: &'a Solver,
        state: &'a State,
        wanted: &Wanted,
    ) -> Self {
        let links = Reach::of(scene, solver);
        let overlay = Overlay::of(scene, solver, &links, wanted);
        DrawnScene {
            args,
            scene,
            solver,
            state,
            reach: overlay.reach(&links).unwrap_or_else(|| links.clone()),
            links,
            overlay,
            whole: wanted.ghosts > 0 || !wanted.traces.is_empty(),
        }
    }

    /// Returns the linkage in a state, with its overlay.
    fn figure(&self, state: &State) -> drawing::Figure {
        let mut figure = drawing::linkage(self.scene, &self.links, state, layers(self.args));
        self.overlay
            .add_to(&mut figure, self.scene, self.solver, state, 1.0);
        figure
    }

    /// Returns the linkage with its overlay at another coordinate, solved in `state`.
    fn figure_at(&self, at: f64, state: &mut Workspace) -> drawing::Figure {
        // Coordinates of the motion have a state. If one had none, the drawing would omit what is
        // undefined.
        let _ = self.solver.solve(at, order(self.args), state);
        self.figure(state.state())
    }

    /// Places the labels for a whole motion: each keeps the side that suits it, and ends where it
    /// began.
    fn settled_labels(&self, places: &[f64], view: &WorldView) -> Labels {
        let (mut labels, mut raster) = (Labels::default(), Raster::new());
        let mut state = self.solver.state();
        for &at in places {
            let figure = self.figure_at(at, &mut state);
            drawing::render_into(&figure, view, Glyphs::Braille, &mut labels, &mut raster);
        }
        labels
    }

    /// Returns the view that shows the linkage as large as possible, including its overlay.
    fn view(&self, Size { cols, rows }: Size) -> WorldView {
        if self.whole {
            self.whole_view(Size { cols, rows })
        } else {
            WorldView::along(&self.reach, self.state.at(), cols, rows, ASPECT)
        }
    }

    /// Returns the view of the whole motion.
    fn whole_view(&self, Size { cols, rows }: Size) -> WorldView {
        WorldView::fit(&self.reach, cols, rows, ASPECT)
    }

    /// Returns the view of a document, in the requested or the required size.
    fn document_view(&self, view: impl Fn(Size) -> WorldView) -> WorldView {
        let cols = DOCUMENT_COLUMNS;
        match self.args.size {
            Some(size) => view(size),
            None => WorldView::snug(DOCUMENT_ROWS, |rows| view(Size { cols, rows })),
        }
    }

    /// Returns the background of documents and images.
    fn ground(&self) -> SvgGround {
        match self.args.dark {
            true => SvgGround::Dark,
            false => SvgGround::Preferred,
        }
    }

    /// Returns the drawing's title.
    fn title(&self) -> String {
        let catalogue = Catalogue::new(self.scene);
        let unit = &catalogue.driver().unit;
        words().drawing_of(&self.scene.title(), &self.state.at(), unit)
    }
}

/// Returns the order to which the scene must be solved.
fn order(args: &DrawArgs) -> Order {
    match args.forces {
        true => Order::Force,
        false => Order::Acceleration,
    }
}

fn layers(args: &DrawArgs) -> Layers {
    Layers {
        ground: !args.no_guides,
        points: args.names != NamesChoice::None,
        links: args.names == NamesChoice::All,
        centres: args.centres,
        lit: None,
    }
}

fn wanted(args: &DrawArgs, scene: &Scene) -> Result<Wanted, Failure> {
    let (traces, arrows) = (drawing::usual_traces, drawing::usual_arrows);
    Ok(Wanted {
        is_timed: false,
        traces: points(scene, "--traces", args.traces.as_deref(), traces)?,
        velocities: points(scene, "--velocities", args.velocities.as_deref(), arrows)?,
        accelerations: points(
            scene,
            "--accelerations",
            args.accelerations.as_deref(),
            arrows,
        )?,
        forces: args.forces,
        ghosts: args.ghosts,
    })
}

/// Returns the points named by an option, or default points if it has no names.
fn points(
    scene: &Scene,
    option: &str,
    names: Option<&[String]>,
    usual: impl Fn(&Mechanism) -> Vec<PointId>,
) -> Result<Vec<PointId>, Failure> {
    let mechanism = &scene.mechanism;
    match names {
        None => Ok(Vec::new()),
        Some([]) => Ok(usual(mechanism)),
        Some([all]) if all == "all" => Ok(drawing::moving_points(mechanism).collect()),
        Some(names) => names
            .iter()
            .map(|name| point(scene, option, name))
            .collect(),
    }
}

fn point(scene: &Scene, option: &str, name: &str) -> Result<PointId, Failure> {
    let named = |id: &PointId| scene.point_name(*id) == Some(name);
    scene.mechanism.point_ids().find(named).ok_or_else(|| {
        let names = scene.mechanism.point_ids();
        let names = names.filter_map(|id| scene.point_name(id));
        let mend = match nearest(name, names) {
            Some(meant) => words().did_you_mean(meant),
            None => words().check_names_points().into(),
        };
        Failure::Usage(words().no_point(option, name, &mend))
    })
}
