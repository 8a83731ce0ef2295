//! The command line as its users write it.

mod figures;
mod motor;
mod pictures;
mod workbench;

pub(super) use figures::{AccuracyArgs, ExplainArgs, Format, SweepArgs, TableArgs, TextFormat};
pub(super) use motor::MotorArgs;
pub(super) use pictures::{DrawArgs, Glyphs, Names, PictureFormat, PlotArgs, Size};
#[cfg(feature = "tui")]
pub(super) use workbench::{Colour, Theme};
pub(super) use workbench::{USUAL_SCENE, WorkbenchArgs};

use crate::assembly::Wish;
use crate::report::Decimal;
use clap::{Args, Parser, Subcommand, ValueEnum};
use clap_complete::Shell;
use std::path::PathBuf;

/// The keys that one cannot do without, where there is a workbench.
#[cfg(feature = "tui")]
macro_rules! keys_help {
    () => {
        "\
Keys of the workbench:
  space play or pause   . one step on   , one step back   r the other way
  g type where to go    2 all tables    n the next preset t other characters
  a other assemblies    ? all keys        q leave

"
    };
}
#[cfg(not(feature = "tui"))]
macro_rules! keys_help {
    () => {
        ""
    };
}

/// What stands for a scene on the command line.
const SCENE_HELP: &str = "A file, a preset's name, or - for standard input";

/// A terminal workbench for planar linkages.
#[derive(Debug, Parser)]
#[command(
    name = "krank",
    version,
    about = "A terminal workbench for planar linkages",
    long_about = "A terminal workbench for planar linkages: position, velocity and acceleration \
                  of any mechanism with one input, and the forces where anything acts, drawn \
                  and in tables.",
    args_conflicts_with_subcommands = true,
    disable_help_subcommand = true,
    after_help = concat!(
        keys_help!(),
        "\
Examples:
  krank                          open the four-bar of the lectures
  krank slider-crank --at 30     open a preset at 30 degrees
  krank my-press.toml            open a scene file
  krank press --view tables      open a preset with all its tables
  krank press --print            print the screen that opens, and leave
  krank sweep four-bar -o four-bar.csv

SCENE is a file, a preset's name (krank list) or - for standard input. A name
with a slash or ending in .toml is always a file: ./four-bar.

krank help lists the topics of the manual: the scene file, keys, columns and more.
krank completions SHELL and krank man print a completion script and a man page.

Exit codes: 0 done; 1 the mechanism cannot do what was asked, or the output
cannot be written; 2 the command line or the scene is wrong."
    )
)]
pub(super) struct Cli {
    #[command(subcommand)]
    pub(super) command: Option<Command>,
    #[command(flatten)]
    pub(super) workbench: WorkbenchArgs,
}

#[derive(Debug, Subcommand)]
pub(super) enum Command {
    /// List the presets
    #[command(after_help = "\
Example:
  krank list                     their names and titles")]
    List,
    /// Tell what krank understands of a scene: parts, mobility, groups, range
    #[command(after_help = "\
Examples:
  krank check four-bar
  krank check four-bar --assembly C=-
  krank check my-press.toml --format json
  krank check - < my-press.toml")]
    Check(CheckArgs),
    /// Print the position, velocity and acceleration tables at one angle, and the forces where anything acts
    #[command(after_help = "\
Examples:
  krank table four-bar --at 60
  krank table slider-crank --at 30 --digits 10
  krank table press --bounds --sensitivity
  krank table four-bar-load --bounds
  krank table four-bar --format json
  krank table four-bar --at 240 --assembly C=-")]
    Table(TableArgs),
    /// Show the working: loops, equations and every figure on the way to the tables of one angle
    #[command(after_help = "\
Examples:
  krank explain four-bar --at 60
  krank explain slider-crank --at 30 --digits 9
  krank explain press --format markdown -o press.md

Vector polygons, position table, loop equations in components and projected,
the solution of every group, velocities and accelerations by the differentiated
equations, joints and centres of mass by their tangential and normal parts, and
the check. They are worked out by the formula in their line, from figures that
the lines before it have; of a coupled group equations and solution are shown,
not the elimination. Where something acts, the balance of every link and loaded
pin follows with its reactions, and virtual work checks the driver's
effort. At a dead point positions alone exist; outside the range the loops and
what is given are told, and the exit code is 1. Greek letters are
spelled where the terminal or the locale has none.")]
    Explain(ExplainArgs),
    /// Draw the linkage at one angle: in characters, or as SVG
    #[command(after_help = "\
Examples:
  krank draw four-bar --at 60
  krank draw hoecken --traces
  krank draw four-bar --velocities --accelerations C --size 120x40
  krank draw jansen-leg --traces T --ghosts 6 --format svg -o leg.svg

POINTS are names of points separated by commas, or all. Without them --traces
draws the curves that are no circles about a ground pin (or these, where there
is nothing else), --velocities and --accelerations the arrows of all joints and
riders. Arrows of one kind have one scale over the whole motion; the line below
tells it. One whose shaft is broken is longer than it is drawn.")]
    Draw(DrawArgs),
    /// Write figures over the driver's angle, row by row
    #[command(after_help = "\
Examples:
  krank sweep four-bar --from 0 --to 360 --step 1 --columns C.x,C.vx,r4.omega
  krank sweep four-bar --columns 'C.*,*.omega' --format json
  krank sweep press-ram --step 0.1 -o press.csv

Columns are named C.x, C.vy, r3.angle, r3.omega, r4.length, r3.com.ax and so on;
krank sweep SCENE | head -n 1 shows all of a scene's. Where anything acts there
are driver.torque, driver.power, r3.B.fx (the force on link r3 at pin B),
r4.normal, r6.moment, ground.fx, and the residuals of two checks, which would be
zero but for rounding. The driver's coordinate always comes first and the state
last: ok, change-point, dead-point or no-assembly. A value that does not exist
is an empty cell (null in JSON).
--bounds puts C.x.bound behind each C.x, in the same unit: what the error of
solving the scene as it is given does not exceed. --sensitivity puts
C.x.sensitivity there: the change of C.x where every given length is off by one
unit, at the worst.
Without --from and --to a sweep covers the motion range and ends on its limits,
or after one period; with forces among the figures, that of the loads.")]
    Sweep(SweepArgs),
    /// Plot figures over the motion: in characters, or as SVG
    #[command(after_help = "\
Examples:
  krank plot four-bar --columns r4.omega
  krank plot four-bar --columns 'C.v*,r4.alpha' --size 120x40
  krank plot slider-crank --columns C.vx --against C.x
  krank plot hoecken --columns P.y --against P.x --format svg -o curve.svg

Columns are named as in krank sweep; every unit has a panel of its own. Over
time, 0 s is where the scene opens, and the driver goes on from there with its
speed and acceleration. Maxima and minima are marked with their value and place,
which are solved for, not read from the picture: the value to rounding, the
place to about 1e-5 deg. Where no value exists there is a gap.")]
    Plot(PlotArgs),
    /// What a scene asks of its motor over one cycle, and what a ram does
    #[command(after_help = "\
Examples:
  krank motor four-bar-load
  krank motor four-bar-load --rated 30 --peak 75 --fluctuation 0.02
  krank motor press-ram --height 6 --torque 500 --tolerance 0.5
  krank motor excavator-boom --from 1.8 --to 2.8
  krank motor engine --format csv -o engine.csv

Torque and power with their peaks, which are solved for, means, and the energy put
in and given back, split into loads, gravity and inertia; how uneven the speed is
and the flywheel against it; what shakes the frame; what a motor lacks; and of a
ram stroke, dead centres, time ratio, dwell, and speed and force at a height above
the bottom. A cycle is the period of the motion, or of loads that take longer; a
limited range is gone through there and back. Options stand for what the scene's
[motor] has. Friction is not modelled.")]
    Motor(MotorArgs),
    /// Print a scene with the [start] of another assembly
    #[command(after_help = "\
Examples:
  krank start four-bar --assembly C=- > crossed.toml
  krank start my-press.toml --assembly C=-,F=+ -o my-press.toml

Only [start] changes: comments, order and everything else stay as they are. The
file is written at once or not at all, and may be the scene itself. Where the
motion of the assembly does not come to where the scene opens, the opening of
the driver changes too.")]
    Start(StartArgs),
    /// Measure speed against error: every method that could solve a scene, in a table and a chart
    #[command(after_help = "\
Examples:
  krank accuracy                 the four-bar of the lectures
  krank accuracy jansen-leg --format csv -o jansen.csv
  krank accuracy my-press.toml --positions 36000

Every method gives positions, velocities and accelerations, and is held against
a run in doubled precision. Methods that a scene does not allow are listed with
the reason. Times are this machine's: let it rest meanwhile. Ctrl-C ends it.")]
    Accuracy(AccuracyArgs),
    /// Print a configuration to begin with: every key, and what is built in
    #[cfg(feature = "tui")]
    #[command(after_help = "\
Example:
  krank config > ~/.config/krank/config.toml

The workbench reads $XDG_CONFIG_HOME/krank/config.toml, or ~/.config/krank/config.toml
where that is not set, and never writes it: characters, colours, keys.")]
    Config,
    /// Read a topic of the manual, or the help of a command
    #[command(after_help = "\
Examples:
  krank help                     the topics
  krank help scene               every key of a scene file
  krank help sweep               as krank sweep --help

On a terminal it is shown by $PAGER, or by less or more.")]
    Help(HelpArgs),
    /// Print a completion script for a shell
    #[command(
        hide = true,
        after_help = "\
Example:
  krank completions bash > ~/.local/share/bash-completion/completions/krank"
    )]
    Completions {
        /// The shell
        shell: Shell,
    },
    /// Print the manual page
    #[command(
        hide = true,
        after_help = "\
Examples:
  krank man > krank.1
  krank man sweep > krank-sweep.1"
    )]
    Man {
        /// The command that the page is about; krank itself if left out
        command: Option<String>,
    },
}

#[derive(Debug, Args)]
pub(super) struct HelpArgs {
    /// A topic or a command; what there is if left out
    pub(super) topic: Option<String>,
    /// Write it all at once
    #[arg(long)]
    pub(super) no_pager: bool,
}

#[derive(Debug, Args)]
pub(super) struct CheckArgs {
    #[command(flatten)]
    pub(super) scene: SceneArgs,
    /// How to write it
    #[arg(long, value_enum, default_value_t = CheckFormat::Text)]
    pub(super) format: CheckFormat,
    #[command(flatten)]
    pub(super) output: OutputArgs,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub(super) enum CheckFormat {
    /// For a person
    Text,
    /// One object
    Json,
}

/// A scene, in the assembly that is meant.
#[derive(Debug, Args)]
pub(super) struct SceneArgs {
    #[arg(help = SCENE_HELP)]
    pub(super) scene: PathBuf,
    #[command(flatten)]
    pub(super) assembly: AssemblyArgs,
}

/// One place of the motion.
#[derive(Debug, Args)]
pub(super) struct PlaceArgs {
    /// The driver's angle in deg, or its position if it is a slide [default: where the scene opens]
    #[arg(long, value_name = "COORDINATE", allow_hyphen_values = true)]
    at: Option<Decimal>,
}

impl PlaceArgs {
    /// The driver's coordinate as it was typed.
    pub(super) fn typed(&self) -> Option<f64> {
        self.at.map(|at| at.value())
    }
}

/// The assembly that is meant.
#[derive(Debug, Args)]
pub(super) struct AssemblyArgs {
    /// The assembly of a group where the scene opens, as check lists them; separated by commas
    #[arg(long = "assembly", value_name = "GROUP=CHOICE", value_delimiter = ',')]
    pub(super) wishes: Vec<Wish>,
}

#[derive(Debug, Args)]
pub(super) struct StartArgs {
    #[command(flatten)]
    pub(super) scene: SceneArgs,
    #[command(flatten)]
    pub(super) output: OutputArgs,
}

#[derive(Debug, Args)]
pub(super) struct OutputArgs {
    /// Write to a file instead of standard output, whole or not at all
    #[arg(short, long, value_name = "FILE")]
    pub(super) output: Option<PathBuf>,
}
