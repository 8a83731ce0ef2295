//! Text below the options in the help of each command: examples and notes.

use super::English;

catalogue! {
    /// Examples and notes.
    trait ExamplesWords for English {
        keys_of_workbench = "\
Keys of the workbench:
  space play or pause   . one step forward  , one step back   r play in reverse
  g go to a position    2 all tables        n the next preset t other characters
  a other assemblies    ? all keys          q quit

";
        examples_of_krank = "\
Examples:
  krank                          open the four-bar of the lectures
  krank slider-crank --at 30     open a preset at 30 degrees
  krank my-press.toml            open a scene file
  krank press --view tables      open a preset with all its tables
  krank press --print            print the first screen and exit
  krank sweep four-bar -o four-bar.csv

SCENE is a file, a preset's name (krank list) or - for standard input. A name
with a slash or ending in .toml is always a file: ./four-bar.

krank help lists the topics of the manual: scene files, keys, columns and more.
krank completions SHELL and krank man print a completion script and a man page.

Exit codes: 0 success; 1 the mechanism cannot do what was asked, or the output
cannot be written; 2 the command line or the scene is invalid.";
        examples_of_list = "\
Example:
  krank list                     names and titles of the presets";
        examples_of_check = "\
Examples:
  krank check four-bar
  krank check four-bar --assembly C=-
  krank check my-press.toml --format json
  krank check - < my-press.toml";
        examples_of_table = "\
Examples:
  krank table four-bar --at 60
  krank table slider-crank --at 30 --digits 10
  krank table press --bounds --sensitivity
  krank table four-bar-load --bounds
  krank table four-bar --columns 'C.a*,swing = r4.angle - r3.angle' --bounds
  krank table four-bar --format json
  krank table four-bar --at 240 --assembly C=-";
        examples_of_explain = "\
Examples:
  krank explain four-bar --at 60
  krank explain slider-crank --at 30 --digits 9
  krank explain press -o press.md
  krank explain four-bar --method newton --guess r3=20,r4=280
  krank explain four-bar --method bisection --guess r3=0..90

First come vector polygons, the position table, and loop equations in components
and projected. The solution of every group follows, then velocities and
accelerations from the differentiated equations. Joints and centres of mass have
their tangential and normal components. The page ends with a check. Each value
is computed by the formula in its line from values in earlier lines. For a coupled
group the equations and the solution are shown, but not the elimination. With loads,
springs or masses the equilibrium of every link and loaded pin follows with its
reactions. Virtual work checks the force or torque of the driver. At a dead point
only positions exist. Outside the range only the loops and the given values are
printed, and the exit code is 1. Greek letters are spelled out if the terminal or
the locale does not have them.";
        examples_of_draw = "\
Examples:
  krank draw four-bar --at 60
  krank draw hoecken --traces
  krank draw four-bar --velocities --accelerations C --size 120x40
  krank draw jansen-leg --traces T --ghosts 6 -o leg.svg
  krank draw slider-crank --scale 1:2 -o print.svg
  krank draw four-bar --traces C -o four-bar.dxf

POINTS are names of points separated by commas, or all. Without names --traces
draws all curves except circles around a ground pin, or these if there are no
others. --velocities and --accelerations draw the arrows of all joints and points
on links. --forces draws the forces of loads, joints, guides and the driver with
their values. Arrows of one kind have one scale over the whole motion, shown in
the line below. An arrow with a broken shaft is longer than drawn.";
        examples_of_export = "\
Examples:
  krank export four-bar -o four_bar.py
  python3 four_bar.py 0 360 10
  krank export press-ram -o press_ram.m
  octave --eval 'press_ram(0, 360, 10)'

The script defines every length by name, solves each group in one line with full
formulas, and does not need krank. Its arguments are the start, the end and the
step; it prints the columns of krank sweep. In MATLAB and Octave
[rows, heads] = press_ram(0, 360, 10) returns them instead. You can change a
length in the script as long as each group keeps its assembly. For a CAD drawing
use krank draw --format dxf; for values use krank sweep.";
        examples_of_import = "\
Examples:
  krank import fourbar.txt -o fourbar.toml
  krank import leg.linkage2 | krank check -
  krank leg.linkage2
  krank import 'https://designengrlab.github.io/PMKS/pmks.html?mech=...' -o bar.toml

The format is recognised by the contents: text or an address of PMKS, an address
of PMKS+ with j= and l=, the XML of Linkage, an expression of Pyslvs, or the JSON
of pylinkage. Every command that takes a scene reads such a file directly. Gears
and other parts that krank does not model are reported with their place in the
file; the rest is kept. The scene opens in the pose of the drawing.";
        examples_of_sweep = "\
Examples:
  krank sweep four-bar --from 0 --to 360 --step 1 --columns C.x,C.vx,r4.omega
  krank sweep four-bar --columns 'C.*,*.omega' --format json
  krank sweep press-ram --step 0.1 -o press.csv
  krank sweep four-bar --columns 'C.v,C.a.t,swing = r4.angle - r3.angle,swing.rate'

Columns are named C.x, C.vy, r3.angle, r3.omega, r4.length, r3.com.ax and so on;
krank sweep SCENE | head -n 1 lists all columns of a scene. With loads, springs or
masses there are also driver.torque, driver.power, r3.B.fx (the force on link r3
at pin B), r4.normal, r6.moment and ground.fx. The residuals of two checks are
zero except for rounding. C.v, C.a.angle, C.a.t, r3.B.f and others appear only if
they are named; NAME = FORMULA defines a column (krank help columns). The first
column is always the coordinate of the driver, the last one the state: ok,
change-point, dead-point or no-assembly. A value that does not exist is an empty
cell (null in JSON). --bounds adds C.x.bound after each C.x, in the same unit: a
bound of the error of solving the scene as given. --sensitivity adds
C.x.sensitivity: the largest change of C.x if every given length is wrong by one
unit. Without --from and --to a sweep covers the range of the motion up to its
limits, or one period; with forces, the period of the loads.";
        examples_of_plot = "\
Examples:
  krank plot four-bar --columns r4.omega
  krank plot four-bar --columns 'C.v*,r4.alpha' --size 120x40
  krank plot slider-crank --columns C.vx --against C.x
  krank plot hoecken --columns P.y --against P.x -o curve.svg

Columns are named as in krank sweep; every unit has a panel of its own. Over
time, 0 s is the position where the scene opens, and the driver continues with its
speed and acceleration. Maxima and minima are marked with their value and position.
Both are computed, not read from the picture: the value to rounding, the position
to about 1e-5 deg. There is a gap where no value exists.";
        examples_of_cycle = "\
Examples:
  krank cycle whitworth
  krank cycle four-bar --columns C.x,r4.angle
  krank cycle toggle-press --columns S.y --dwell 0.5
  krank cycle slider-crank --columns 'F = C.x * cos(30 deg) + C.y * sin(30 deg)'
  krank cycle jansen-leg -o cycle.csv

For each quantity: its stroke, or the swing of an angle; every maximum and minimum;
the time ratio, slow to fast, between its extremes; the intervals within --dwell
of an extreme; the maximum of its first and second derivative at the speed of the
scene. Then, for every dyad, the transmission angle furthest from 90 deg, and,
for every coupled group, its worst condition. A missing value has a reason.";
        examples_of_study = "\
Examples:
  krank study four-bar --vary r2.length=90..110/21 --columns r4.angle.swing
  krank study four-bar --vary r2.length=90..110/21,r3.length=280..320/9 \\
    --columns r4.angle.swing,transmission -o designs.csv
  krank study four-bar --vary r2.length=60..140,r3.length=200..320 \\
    --columns r4.angle.swing --format chart
  krank study press --vary r2.length=80..120,r3.length=250..330 --latin 1000 \\
    --seed 7 --columns r6.angle.swing --format text

Values are named as in krank check and in the workbench, with dots for the blanks:
r3.length, A.x, driver.angle, and parameters by their own names. The last value
varies fastest. Every design is the scene with these values, opened in the assembly
of the scene. The last columns are its state (ok, no-assembly, or unreadable if the
values do not give a valid scene) and the reason for missing values. A CSV file is
written row by row: after Ctrl-C, --resume continues it. See krank help designs.";
        examples_of_motor = "\
Examples:
  krank motor four-bar-load
  krank motor four-bar-load --rated 30 --peak 75 --fluctuation 0.02
  krank motor press-ram --height 6 --torque 500 --rest 0.5
  krank motor excavator-boom --from 1.8 --to 2.8
  krank motor engine --format csv -o engine.csv

Torque and power with their peaks and means, and the energy supplied and returned,
split into loads, gravity and inertia; the fluctuation of the speed and the
flywheel that limits it; the shaking force on the frame; the shortfall of a motor.
For a ram: stroke, dead centres, time ratio, dwell, and speed and force at a height
above the bottom. A cycle is the period of the motion, or of the loads if theirs is
longer; a limited range is travelled back and forth. Options replace the values in
[motor] of the scene. Friction is not modelled.";
        examples_of_tolerance = "\
Examples:
  krank tolerance four-bar --tolerance 0.1 --columns C.x,r4.angle --at 60
  krank tolerance press.toml --columns F.y
  krank tolerance press.toml --columns F.y --samples 10000 --format csv -o off.csv

For each quantity: its value as given; the worst case within all tolerances; and
the root sum square of the effects of the single lengths. At one position also the
values of random samples and the contribution of each length. The worst case is
solved at every corner of the tolerances of up to 16 lengths, of a stroke up to 12.
For more lengths, and for pins with clearance, it is enclosed; otherwise it is
marked as estimated, with the method. The tolerances are those of the scene:
tolerance, clearance, [tolerances], [clearances].";
        examples_of_start = "\
Examples:
  krank start four-bar --assembly C=- > crossed.toml
  krank start my-press.toml --assembly C=-,F=+ -o my-press.toml

Only [start] changes: comments, order and everything else stay as they are. The
file is written completely or not at all, and may be the scene itself. If the
motion of the assembly does not reach the position where the scene opens, that
position changes too.";
        examples_of_accuracy = "\
Examples:
  krank accuracy                 the four-bar of the lectures
  krank accuracy jansen-leg -o jansen.csv
  krank accuracy my-press.toml --positions 36000

Every method computes positions, velocities and accelerations, and is compared with
a computation in doubled precision. Methods that do not work for a scene are listed
with the reason. Times are measured on this machine: keep it idle meanwhile.
Ctrl-C stops the measurement.";
        examples_of_config = "\
Example:
  krank config > ~/.config/krank/config.toml

The workbench reads $XDG_CONFIG_HOME/krank/config.toml, or ~/.config/krank/config.toml
if that is not set, and never writes it: characters, colours, keys.";
        examples_of_help = "\
Examples:
  krank help                     the topics
  krank help scene               every key of a scene file
  krank help sweep               the same as krank sweep --help
  krank help 'time ratio'        where these words occur: topics, keys, columns, commands
  krank help --format html -o manual   the manual as a web site

On a terminal the text is shown with $PAGER, or with less or more.";
        examples_of_completions = "\
Example:
  krank completions bash > ~/.local/share/bash-completion/completions/krank";
        examples_of_man = "\
Examples:
  krank man > krank.1
  krank man sweep > krank-sweep.1";
    }
}
