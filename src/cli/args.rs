//! The command line as its users write it.

use crate::assembly::Wish;
use crate::report::Decimal;
use crate::study::USUAL_POSITIONS;
use clap::{Args, Parser, Subcommand, ValueEnum};
use clap_complete::Shell;
use std::path::PathBuf;
use std::str::FromStr;

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

/// The scene that opens where none is named.
pub(super) const USUAL_SCENE: &str = "four-bar";

/// A terminal workbench for planar linkages.
#[derive(Debug, Parser)]
#[command(
    name = "krank",
    version,
    about = "A terminal workbench for planar linkages",
    long_about = "A terminal workbench for planar linkages: position, velocity and acceleration \
                  of any mechanism with one input, drawn and in tables.",
    args_conflicts_with_subcommands = true,
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

krank completions SHELL and krank man print a completion script and the manual.

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

/// The workbench, which opens where no command is given.
#[derive(Debug, Args)]
pub(super) struct WorkbenchArgs {
    #[arg(help = format!("{SCENE_HELP} [default: {USUAL_SCENE}]"))]
    pub(super) scene: Option<PathBuf>,
    #[command(flatten)]
    pub(super) assembly: AssemblyArgs,
    /// Where to open: deg of the driven link, or the position of the driven slide
    #[cfg(feature = "tui")]
    #[arg(long, value_name = "COORDINATE", allow_hyphen_values = true)]
    pub(super) at: Option<Decimal>,
    /// The characters to draw with
    #[cfg(feature = "tui")]
    #[arg(long, value_enum, default_value_t)]
    pub(super) glyphs: Glyphs,
    /// The colours to draw with
    #[cfg(feature = "tui")]
    #[arg(long, visible_alias = "color", value_enum, default_value_t)]
    pub(super) colour: Colour,
    /// Which colours stand for the names of the palette [default: auto]
    #[cfg(feature = "tui")]
    #[arg(long, value_enum)]
    pub(super) theme: Option<Theme>,
    /// The view to open with
    #[cfg(feature = "tui")]
    #[arg(long, value_enum)]
    pub(super) view: Option<View>,
    /// Print the screen that opens as text, and leave: no terminal is needed
    #[cfg(feature = "tui")]
    #[arg(long)]
    pub(super) print: bool,
    /// The size of the screen that is printed [default: 80x24]
    #[cfg(feature = "tui")]
    #[arg(long, value_name = "COLSxROWS", requires = "print")]
    pub(super) size: Option<Size>,
    /// Tell what was found of the terminal, and why
    #[cfg(feature = "tui")]
    #[arg(long)]
    pub(super) diagnose: bool,
    /// The configuration [default: ~/.config/krank/config.toml]
    #[cfg(feature = "tui")]
    #[arg(long, value_name = "FILE")]
    pub(super) config: Option<PathBuf>,
}

/// A view of the workbench.
#[cfg(feature = "tui")]
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub(super) enum View {
    /// The drawing, with live tables
    Motion,
    /// All tables
    Tables,
    /// Figures over the motion
    Plots,
    /// Speed against error
    Accuracy,
    /// Forces
    Forces,
    /// What the scene gives
    Scene,
    /// What each length does
    Lengths,
}

/// The characters to draw with.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, ValueEnum)]
pub(super) enum Glyphs {
    /// As the locale and the terminal allow
    #[default]
    Auto,
    /// 7-bit characters
    Ascii,
    /// Box-drawing characters, which console fonts have too
    Line,
    /// Braille patterns
    Braille,
}

/// The colours that the workbench draws with.
#[cfg(feature = "tui")]
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, ValueEnum)]
pub(super) enum Colour {
    /// As the terminal and NO_COLOR allow
    #[default]
    Auto,
    /// No colour, but bold and reversed
    None,
    /// The 16 of the terminal's palette
    #[value(name = "16")]
    Palette,
    /// The fixed palette of 256
    #[value(name = "256")]
    Indexed,
    /// Any colour, in 24 bits
    True,
}

/// Colours that are chosen for a ground.
#[cfg(feature = "tui")]
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub(super) enum Theme {
    /// The palette's own, or such as read on any ground
    Auto,
    /// For a light ground
    Light,
    /// For a dark ground
    Dark,
    /// No colours
    Plain,
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
    /// Print the position, velocity and acceleration tables at one angle
    #[command(after_help = "\
Examples:
  krank table four-bar --at 60
  krank table slider-crank --at 30 --digits 10
  krank table press --bounds --sensitivity
  krank table four-bar --format json
  krank table four-bar --at 240 --assembly C=-")]
    Table(TableArgs),
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
krank sweep SCENE | head -n 1 shows all of a scene's. The driver's coordinate
always comes first and the state last: ok, change-point, dead-point or
no-assembly. A value that does not exist is an empty cell (null in JSON).
--bounds puts C.x.bound behind each C.x, in the same unit: what the error of
solving the scene as it is given does not exceed. --sensitivity puts
C.x.sensitivity there: the change of C.x where every given length is off by one
unit, at the worst.
Without --from and --to a sweep covers the motion range and ends on its limits,
or after one period.")]
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
pub(super) struct CheckArgs {
    #[arg(help = SCENE_HELP)]
    pub(super) scene: PathBuf,
    #[command(flatten)]
    pub(super) assembly: AssemblyArgs,
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

#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub(super) enum Format {
    /// Aligned columns, for a person
    Text,
    /// Comma separated values
    Csv,
    /// One object
    Json,
}

#[derive(Debug, Args)]
pub(super) struct TableArgs {
    #[arg(help = SCENE_HELP)]
    pub(super) scene: PathBuf,
    #[command(flatten)]
    pub(super) assembly: AssemblyArgs,
    /// The driver's angle in deg, or its position if it is a slide [default: where the scene opens]
    #[arg(long, value_name = "COORDINATE", allow_hyphen_values = true)]
    pub(super) at: Option<Decimal>,
    /// How to write it
    #[arg(long, value_enum, default_value_t = Format::Text)]
    pub(super) format: Format,
    #[command(flatten)]
    pub(super) figures: FigureArgs,
    #[command(flatten)]
    pub(super) output: OutputArgs,
}

/// How a drawing is written.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, ValueEnum)]
pub(super) enum PictureFormat {
    /// Characters
    #[default]
    Text,
    /// Scalable vector graphics, for a browser or a report
    Svg,
}

/// A size in characters.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct Size {
    pub(super) cols: u16,
    pub(super) rows: u16,
}

/// Nobody looks at more characters than this; memory is for something else.
const LARGEST_SIDE: u16 = 2000;

impl FromStr for Size {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        let sides = text.split_once(['x', 'X']);
        let side = |text: &str| text.parse().ok().filter(|n| (1..=LARGEST_SIDE).contains(n));
        let size = sides.and_then(|(cols, rows)| {
            Some(Size {
                cols: side(cols)?,
                rows: side(rows)?,
            })
        });
        size.ok_or_else(|| {
            format!("columns x rows are meant, such as 80x24, each 1 to {LARGEST_SIDE}")
        })
    }
}

#[derive(Debug, Args)]
pub(super) struct DrawArgs {
    #[arg(help = SCENE_HELP)]
    pub(super) scene: PathBuf,
    #[command(flatten)]
    pub(super) assembly: AssemblyArgs,
    /// The driver's angle in deg, or its position if it is a slide [default: where the scene opens]
    #[arg(long, value_name = "COORDINATE", allow_hyphen_values = true)]
    pub(super) at: Option<Decimal>,
    /// Trace points over the whole motion
    #[arg(long, value_name = "POINTS", value_delimiter = ',', num_args = 0..=1)]
    pub(super) traces: Option<Vec<String>>,
    /// Arrows of velocity
    #[arg(long, value_name = "POINTS", value_delimiter = ',', num_args = 0..=1)]
    pub(super) velocities: Option<Vec<String>>,
    /// Arrows of acceleration
    #[arg(long, value_name = "POINTS", value_delimiter = ',', num_args = 0..=1)]
    pub(super) accelerations: Option<Vec<String>>,
    /// Show the linkage at so many places of its motion
    #[arg(long, value_name = "N", default_value_t = 0, value_parser = clap::value_parser!(u16).range(0..=MOST_GHOSTS))]
    pub(super) ghosts: u16,
    /// Which names to write
    #[arg(long, value_enum, default_value_t)]
    pub(super) names: Names,
    /// Mark centres of mass
    #[arg(long)]
    pub(super) centres: bool,
    /// Leave out guides and supports
    #[arg(long)]
    pub(super) no_guides: bool,
    /// The characters to draw with
    #[arg(long, value_enum, default_value_t)]
    pub(super) glyphs: Glyphs,
    /// How large; a character is 8 x 16 units of an SVG [default: the terminal's size, or 80x24; 100 wide for an SVG]
    #[arg(long, value_name = "COLSxROWS")]
    pub(super) size: Option<Size>,
    /// How to write it
    #[arg(long, value_enum, default_value_t)]
    pub(super) format: PictureFormat,
    #[command(flatten)]
    pub(super) output: OutputArgs,
}

/// More positions would hide each other.
const MOST_GHOSTS: i64 = 360;

/// The names in a drawing.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, ValueEnum)]
pub(super) enum Names {
    /// None
    None,
    /// Of points
    #[default]
    Points,
    /// Of points and links
    All,
}

#[derive(Debug, Args)]
pub(super) struct SweepArgs {
    #[arg(help = SCENE_HELP)]
    pub(super) scene: PathBuf,
    #[command(flatten)]
    pub(super) assembly: AssemblyArgs,
    /// The first row [default: the beginning of the motion range]
    #[arg(long, value_name = "COORDINATE", allow_hyphen_values = true)]
    pub(super) from: Option<Decimal>,
    /// The last row, where the step hits it [default: the end of the motion range]
    #[arg(long, value_name = "COORDINATE", allow_hyphen_values = true)]
    pub(super) to: Option<Decimal>,
    /// From row to row, negative to go down [default: 1 deg; for a slide, 100 to 250 rows]
    #[arg(long, value_name = "STEP", allow_hyphen_values = true)]
    pub(super) step: Option<Decimal>,
    /// Names of figures, * for any characters; separated by commas [default: all vectors and points]
    #[arg(long, value_name = "PATTERNS", value_delimiter = ',')]
    pub(super) columns: Vec<String>,
    /// How to write it
    #[arg(long, value_enum, default_value_t = Format::Csv)]
    pub(super) format: Format,
    #[command(flatten)]
    pub(super) figures: FigureArgs,
    #[command(flatten)]
    pub(super) output: OutputArgs,
}

#[derive(Debug, Args)]
pub(super) struct PlotArgs {
    #[arg(help = SCENE_HELP)]
    pub(super) scene: PathBuf,
    #[command(flatten)]
    pub(super) assembly: AssemblyArgs,
    /// Names of figures, * for any characters; separated by commas
    #[arg(long, value_name = "PATTERNS", value_delimiter = ',', required = true)]
    pub(super) columns: Vec<String>,
    /// What stands along x: driver, time, or the name of a figure
    #[arg(long, value_name = "NAME", default_value = "driver")]
    pub(super) against: String,
    /// Where the driver begins [default: the beginning of the motion range]
    #[arg(long, value_name = "COORDINATE", allow_hyphen_values = true)]
    pub(super) from: Option<Decimal>,
    /// Where the driver ends [default: the end of the motion range]
    #[arg(long, value_name = "COORDINATE", allow_hyphen_values = true)]
    pub(super) to: Option<Decimal>,
    /// Leave out the marks at maxima and minima
    #[arg(long)]
    pub(super) no_extrema: bool,
    /// The characters to draw with
    #[arg(long, value_enum, default_value_t)]
    pub(super) glyphs: Glyphs,
    /// How large; a character is 8 x 16 units of an SVG [default: the terminal's size, or 80x24; 100x40 for an SVG]
    #[arg(long, value_name = "COLSxROWS")]
    pub(super) size: Option<Size>,
    /// How to write it
    #[arg(long, value_enum, default_value_t)]
    pub(super) format: PictureFormat,
    #[command(flatten)]
    pub(super) output: OutputArgs,
}

#[derive(Debug, Args)]
pub(super) struct AccuracyArgs {
    #[arg(help = SCENE_HELP, default_value = "four-bar")]
    pub(super) scene: PathBuf,
    /// Positions to compare at, in 360 deg or over the range, by the 360
    #[arg(long, value_name = "N", default_value_t = USUAL_POSITIONS, value_parser = clap::value_parser!(u32).range(1..=MOST_POSITIONS))]
    pub(super) positions: u32,
    /// How to write it
    #[arg(long, value_enum, default_value_t = Format::Text)]
    pub(super) format: Format,
    #[command(flatten)]
    pub(super) assembly: AssemblyArgs,
    #[command(flatten)]
    pub(super) output: OutputArgs,
}

/// More positions take minutes and find no larger error.
const MOST_POSITIONS: i64 = 1_000_000;

#[derive(Debug, Args)]
pub(super) struct FigureArgs {
    /// Significant digits of text tables; CSV and JSON always carry all
    #[arg(long, value_name = "N", default_value_t = 6, value_parser = clap::value_parser!(u8).range(1..=17))]
    pub(super) digits: u8,
    /// Leave the units out
    #[arg(long)]
    pub(super) no_units: bool,
    /// Add what the error of each figure does not exceed; nothing where no bound can be proved
    #[arg(long)]
    pub(super) bounds: bool,
    /// Add what the given lengths do to each figure: by how much it changes for one unit of length
    #[arg(long)]
    pub(super) sensitivity: bool,
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
    #[arg(help = SCENE_HELP)]
    pub(super) scene: PathBuf,
    #[command(flatten)]
    pub(super) assembly: AssemblyArgs,
    #[command(flatten)]
    pub(super) output: OutputArgs,
}

#[derive(Debug, Args)]
pub(super) struct OutputArgs {
    /// Write to a file instead of standard output
    #[arg(short, long, value_name = "FILE")]
    pub(super) output: Option<PathBuf>,
}
