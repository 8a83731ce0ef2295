//! `krank draw`: draws the linkage at one driver coordinate, or along its motion, in one of several
//! formats.

mod animation_steps;
mod asciicast;
mod dxf;
mod format;
mod gif;
mod png;
mod svg;
mod text;

use crate::PointId;
use crate::cli::choice::{OrAuto, one_of};
use crate::cli::failure::{Failure, note};
use crate::cli::lead::LeadArgs;
use crate::cli::output::{OutputArgs, write_to, writes_to_terminal};
use crate::cli::picture::{ASPECT, Size, glyph_choices};
use crate::cli::place::{PlaceArgs, check_nothing_hidden, out_of_reach, place};
use crate::cli::screen::TextScreen;
use crate::cli::source::{SceneArgs, SolvableScene};
use crate::drawing::{
    self, Extents, Glyphs, Labels, Layers, Overlay, OverlayRequest, SvgGround, WorldView,
};
use crate::nearest::nearest;
use crate::quantity::Catalogue;
use crate::scene::{Scene, with_point};
use crate::solver::{Condition, Order, Solver, State, Workspace};
use crate::wording::words;
use clap::builder::PossibleValue;
use clap::{Args, ValueEnum};
use format::{DrawFormat, requested};
use std::str::FromStr;

/// The scale of a drawing on paper: `1:2` is half as large as the linkage.
#[derive(Clone, Copy, Debug, PartialEq)]
struct PaperScale(f64);

impl PaperScale {
    /// Returns the ratio of lengths on paper to lengths of the linkage.
    fn factor(self) -> f64 {
        self.0
    }
}

impl FromStr for PaperScale {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        let sides = text.split_once(':');
        let side = |text: &str| {
            let number = with_point(text)?.parse().ok();
            number.filter(|n: &f64| n.is_normal() && *n > 0.0)
        };
        let factor = sides.and_then(|(paper, linkage)| Some(side(paper)? / side(linkage)?));
        let factor = factor.filter(|factor| (1.0 / MAX_SCALE..=MAX_SCALE).contains(factor));
        factor
            .map(PaperScale)
            .ok_or_else(|| words().scale_is_meant(MAX_SCALE))
    }
}

/// Maximum enlargement and reduction: the scales of ISO 5455 end at 1:10000.
const MAX_SCALE: f64 = 10_000.0;

/// The value of `--traces` for no traces at all.
const NONE: &str = "none";

/// Maximum number of ghosts; more would hide each other.
const MAX_GHOSTS: i64 = 360;

/// Maximum width of an image, in pixels; screens are not wider.
const MAX_PIXELS: i64 = 8192;
/// Maximum duration of a turn, in seconds; nobody watches it for longer.
const MAX_SECONDS: i64 = 60;

#[derive(Debug, Args)]
pub(in crate::cli) struct DrawArgs {
    #[command(flatten)]
    scene: SceneArgs,
    #[command(flatten)]
    lead: LeadArgs,
    #[command(flatten)]
    place: PlaceArgs,
    #[arg(help = words().trace_points())]
    #[arg(long, value_name = "POINTS", value_delimiter = ',', num_args = 0..=1)]
    traces: Option<Vec<String>>,
    #[arg(help = words().draw_velocities())]
    #[arg(long, value_name = "POINTS", value_delimiter = ',', num_args = 0..=1)]
    velocities: Option<Vec<String>>,
    #[arg(help = words().draw_accelerations())]
    #[arg(long, value_name = "POINTS", value_delimiter = ',', num_args = 0..=1)]
    accelerations: Option<Vec<String>>,
    #[arg(help = words().draw_forces())]
    #[arg(long)]
    forces: bool,
    #[arg(help = words().draw_ghosts())]
    #[arg(long, value_name = "N", default_value_t = 0, value_parser = clap::value_parser!(u16).range(0..=MAX_GHOSTS))]
    ghosts: u16,
    #[arg(help = words().names_to_write())]
    #[arg(long, value_enum, default_value_t)]
    names: NamesChoice,
    #[arg(help = words().mark_centres())]
    #[arg(long)]
    centres: bool,
    #[arg(help = words().leave_guides_out())]
    #[arg(long)]
    no_guides: bool,
    #[arg(help = words().characters_to_draw_with())]
    #[arg(long, value_parser = one_of(glyph_choices()), default_value = "auto")]
    glyphs: OrAuto<Glyphs>,
    #[arg(help = words().size_of_drawing())]
    #[arg(long, value_name = "COLSxROWS")]
    size: Option<Size>,
    #[arg(help = words().format_of_output())]
    #[arg(long, value_enum, default_value = "text")]
    format: &'static DrawFormat,
    #[arg(help = words().scale_on_paper())]
    #[arg(long, value_name = "PAPER:LINKAGE")]
    scale: Option<PaperScale>,
    #[arg(help = words().width_in_pixels())]
    #[arg(long, value_name = "PIXELS", value_parser = clap::value_parser!(u16).range(16..=MAX_PIXELS))]
    width: Option<u16>,
    #[arg(help = words().on_a_dark_ground())]
    #[arg(long)]
    dark: bool,
    #[arg(help = words().seconds_of_turn())]
    #[arg(long, value_name = "SECONDS", value_parser = clap::value_parser!(u16).range(1..=MAX_SECONDS))]
    seconds: Option<u16>,
    #[command(flatten)]
    output: OutputArgs,
}

/// The values of `--format` are the names and descriptions of the formats.
impl ValueEnum for &'static DrawFormat {
    fn value_variants<'a>() -> &'a [Self] {
        &FORMATS
    }

    fn to_possible_value(&self) -> Option<PossibleValue> {
        Some(PossibleValue::new(self.name).help((self.about)(words())))
    }
}

/// The names in a drawing.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, ValueEnum)]
enum NamesChoice {
    #[value(help = words().names_none())]
    None,
    #[value(help = words().names_of_points_alone())]
    #[default]
    Points,
    #[value(help = words().names_all())]
    All,
}

/// Columns of a document, and its maximum number of rows.
const DOCUMENT_COLUMNS: u16 = 100;
const DOCUMENT_ROWS: u16 = 50;
/// Maximum number of lines of a legend.
const MAX_LEGEND: usize = 2;

pub(in crate::cli) fn draw(args: &DrawArgs, screen: TextScreen) -> Result<(), Failure> {
    check_options(args)?;
    if args.format.is_binary && writes_to_terminal(args.output.output.as_deref()) {
        return Err(Failure::Usage(words().no_text(args.format.name)));
    }
    let opened = args.scene.open_for(&args.output)?;
    let SolvableScene { scene, solver } = args.lead.applied_to(opened)?;
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
    check_nothing_hidden(&scene, &state)
}

/// All formats, in the order of the help.
static FORMATS: [&DrawFormat; 6] = [
    &text::FORMAT,
    &svg::FORMAT,
    &dxf::FORMAT,
    &png::FORMAT,
    &self::gif::FORMAT,
    &asciicast::FORMAT,
];

/// Returns an error if the command line has an option that its format does not support.
fn check_options(args: &DrawArgs) -> Result<(), Failure> {
    match requested(args).find(|option| !args.format.takes_it(option)) {
        None => Ok(()),
        Some(option) => {
            let others = FORMATS.iter().filter(|f| f.takes_it(option));
            let others: Vec<&str> = others.map(|format| format.name).collect();
            Err(Failure::Usage(words().format_takes_no(
                args.format.name,
                option,
                &others.join(", "),
            )))
        }
    }
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
    links: Extents,
    reach: Extents,
    /// `true` if the drawing shows parts of the whole motion.
    whole: bool,
}

impl<'a> DrawnScene<'a> {
    fn new(
        args: &'a DrawArgs,
        scene: &'a Scene,
        solver: &'a Solver,
        state: &'a State,
        wanted: &OverlayRequest,
    ) -> Self {
        let links = Extents::of(scene, solver);
        let overlay = Overlay::of(scene, solver, &links, wanted);
        DrawnScene {
            args,
            scene,
            solver,
            state,
            reach: overlay.extents(&links).unwrap_or_else(|| links.clone()),
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

    /// Plans the sides of the labels over the whole motion.
    fn planned_labels(&self, view: &WorldView, glyphs: Glyphs) -> Labels {
        let mut labels = Labels::default();
        let mut state = self.solver.state();
        let mut figure_at = |at| self.figure_at(at, &mut state);
        let (links, share) = (&self.links, self.links.share(self.state.at()));
        let figures = links.steps().map(&mut figure_at);
        labels.plan(links.is_closed(), share, view, glyphs, figures);
        // On its side, a name stays where the frame before had it. After a turn, the first frame of
        // an animation equals its last one.
        let mut raster = drawing::Raster::new();
        for at in animation_steps::places(self) {
            labels.go(links.share(at));
            drawing::render_into(&figure_at(at), view, glyphs, &mut labels, &mut raster);
        }
        labels
    }

    /// Returns the view that shows the linkage as large as possible, including its overlay.
    fn view(&self, Size { cols, rows }: Size) -> WorldView {
        if self.whole {
            self.motion_view(Size { cols, rows })
        } else {
            WorldView::along(&self.reach, self.state.at(), cols, rows, ASPECT)
        }
    }

    /// Returns the view of the whole motion.
    fn motion_view(&self, Size { cols, rows }: Size) -> WorldView {
        WorldView::fit(&self.reach, cols, rows, ASPECT)
    }

    /// Returns the view of a document, in the requested or the required size.
    fn document_view(&self, view: impl Fn(Size) -> WorldView) -> WorldView {
        let cols = DOCUMENT_COLUMNS;
        match self.args.size {
            Some(size) => view(size),
            None => WorldView::lowest_window(DOCUMENT_ROWS, |rows| view(Size { cols, rows })),
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
        highlighted: None,
    }
}

fn wanted(args: &DrawArgs, scene: &Scene) -> Result<OverlayRequest, Failure> {
    let arrows = |scene: &Scene| drawing::usual_arrows(&scene.mechanism);
    // A picture shows the traces that the scene names; a drawing for CAD only those asked for.
    let traces = match args.traces.as_deref() {
        None if args.format.is_picture => scene.traces.clone(),
        Some([none]) if none == NONE => Vec::new(),
        names => points(scene, "--traces", names, drawing::usual_traces)?,
    };
    Ok(OverlayRequest {
        is_timed: false,
        traces,
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
    usual: impl Fn(&Scene) -> Vec<PointId>,
) -> Result<Vec<PointId>, Failure> {
    match names {
        None => Ok(Vec::new()),
        Some([]) => Ok(usual(scene)),
        Some([all]) if all == "all" => Ok(drawing::moving_points(&scene.mechanism).collect()),
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
        let fix = match nearest(name, names) {
            Some(intended) => words().did_you_mean(intended),
            None => words().check_names_points().into(),
        };
        Failure::Usage(words().no_point(option, name, &fix))
    })
}
