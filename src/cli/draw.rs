//! `krank draw`: the linkage at one coordinate of its driver, in characters or as SVG.

use super::args::{DrawArgs, NamesChoice, PictureFormat, Size};
use super::commands::{nothing_hidden, out_of_reach, place};
use super::failure::{Failure, note};
use super::output::write_text;
use super::picture::{ASPECT, glyphs, size};
use super::screen::TextScreen;
use super::source::SolvableScene;
use crate::drawing::{self, Layers, Overlay, Reach, Wanted, WorldView};
use crate::nearest::nearest;
use crate::quantity::Catalogue;
use crate::scene::Scene;
use crate::solver::{Condition, Order, Solver, State};
use crate::wording::words;
use crate::{Mechanism, PointId};

/// Columns of an SVG, and the rows that it has at most.
const SVG_COLUMNS: u16 = 100;
const SVG_ROWS: u16 = 50;
/// Lines of a legend.
const MOST_LEGEND: usize = 2;

pub(super) fn draw(args: &DrawArgs, screen: TextScreen) -> Result<(), Failure> {
    let SolvableScene { scene, solver } = args.scene.open_for(&args.output)?;
    let at = place(&args.place, &scene, &solver, screen);
    let wanted = wanted(args, &scene)?;
    let mut state = solver.state();
    match solver.solve(at, Order::Acceleration, &mut state) {
        Condition::NoAssembly => return Err(out_of_reach(&scene, &solver, at)),
        Condition::DeadPoint if args.velocities.is_some() || args.accelerations.is_some() => {
            note(words().no_arrows(), screen);
        }
        Condition::DeadPoint | Condition::Ok | Condition::ChangePoint => {}
    }
    let picture = DrawnScene::new(args, &scene, &solver, &state, &wanted);
    let text = match args.format {
        PictureFormat::Text => picture.text(
            glyphs(args.glyphs),
            size(args.size, args.output.output.as_deref()),
        ),
        PictureFormat::Svg => picture.svg(args.size, at),
    };
    write_text(args.output.output.as_deref(), &text)?;
    nothing_hidden(&scene, &state)
}

/// A scene in a state, ready to be drawn.
struct DrawnScene<'a> {
    scene: &'a Scene,
    figure: drawing::Figure,
    overlay: Overlay,
    reach: Reach,
    /// Where the driver is.
    at: f64,
    /// Whether something is shown that belongs to the whole motion.
    whole: bool,
}

impl<'a> DrawnScene<'a> {
    fn new(
        args: &DrawArgs,
        scene: &'a Scene,
        solver: &Solver,
        state: &State,
        wanted: &Wanted,
    ) -> Self {
        let reach = Reach::of(scene, solver);
        let overlay = Overlay::of(scene, solver, &reach, wanted);
        let mut figure = drawing::linkage(scene, &reach, state, layers(args));
        overlay.add_to(&mut figure, scene, state, 1.0);
        DrawnScene {
            scene,
            figure,
            reach: overlay.reach(&reach).unwrap_or(reach),
            overlay,
            at: state.at(),
            whole: wanted.ghosts > 0 || !wanted.traces.is_empty(),
        }
    }

    /// The window in which the linkage is large, and what else is shown is seen.
    fn view(&self, cols: u16, rows: u16) -> WorldView {
        if self.whole {
            WorldView::fit(&self.reach, cols, rows, ASPECT)
        } else {
            WorldView::along(&self.reach, self.at, cols, rows, ASPECT)
        }
    }

    fn text(&self, glyphs: drawing::Glyphs, Size { cols, rows }: Size) -> String {
        let view = |rows| self.view(cols, rows);
        let legend = |view: &WorldView| {
            let entries = self.overlay.legend(view, 1.0);
            drawing::legend_lines(&entries, glyphs, usize::from(cols), MOST_LEGEND)
        };
        // How many lines it takes hardly depends on their number.
        let lines = u16::try_from(legend(&view(rows)).len()).unwrap_or(0);
        let view = view(rows.saturating_sub(lines).max(1));
        let mut text = drawing::render(&self.figure, &view, glyphs).text();
        for line in legend(&view) {
            text.extend(line.into_iter().map(|piece| piece.text));
            text.push('\n');
        }
        text
    }

    fn svg(&self, size: Option<Size>, at: f64) -> String {
        let view = match size {
            Some(Size { cols, rows }) => self.view(cols, rows),
            None => {
                let snug = WorldView::snug(&self.reach, SVG_COLUMNS, SVG_ROWS, ASPECT);
                self.view(snug.cols(), snug.rows())
            }
        };
        let catalogue = Catalogue::new(self.scene);
        let unit = &catalogue.driver().unit;
        let title = words().drawing_of(&self.scene.name, &at, unit);
        drawing::svg(
            &self.figure,
            &view,
            &title,
            &self.overlay.legend(&view, 1.0),
        )
    }
}

fn layers(args: &DrawArgs) -> Layers {
    Layers {
        ground: !args.no_guides,
        points: args.names != NamesChoice::None,
        links: args.names == NamesChoice::All,
        centres: args.centres,
    }
}

fn wanted(args: &DrawArgs, scene: &Scene) -> Result<Wanted, Failure> {
    let (traces, arrows) = (drawing::usual_traces, drawing::usual_arrows);
    Ok(Wanted {
        traces: points(scene, "--traces", args.traces.as_deref(), traces)?,
        velocities: points(scene, "--velocities", args.velocities.as_deref(), arrows)?,
        accelerations: points(
            scene,
            "--accelerations",
            args.accelerations.as_deref(),
            arrows,
        )?,
        ghosts: args.ghosts,
    })
}

/// The points that an option names; without names the usual ones.
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
