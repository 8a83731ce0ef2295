//! What stands below the help of each command: examples, and what is to be known.

use super::English;

catalogue! {
    /// Examples, and more than an option's line can tell.
    trait ExamplesWords for English {
        keys_of_workbench = "\
Keys of the workbench:
  space play or pause   . one step on   , one step back   r the other way
  g type where to go    2 all tables    n the next preset t other characters
  a other assemblies    ? all keys        q leave

";
        examples_of_krank = "\
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
cannot be written; 2 the command line or the scene is wrong.";
        examples_of_list = "\
Example:
  krank list                     their names and titles";
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
  krank explain press --format markdown -o press.md
  krank explain four-bar --method newton --guess r3=20,r4=280
  krank explain four-bar --method bisection --guess r3=0..90

Vector polygons, position table, loop equations in components and projected,
the solution of every group, velocities and accelerations by the differentiated
equations, joints and centres of mass by their tangential and normal parts, and
the check. They are worked out by the formula in their line, from figures that
the lines before it have; of a coupled group equations and solution are shown,
not the elimination. Where something acts, the balance of every link and loaded
pin follows with its reactions, and virtual work checks the driver's
effort. At a dead point positions alone exist; outside the range the loops and
what is given are told, and the exit code is 1. Greek letters are
spelled where the terminal or the locale has none.";
        examples_of_draw = "\
Examples:
  krank draw four-bar --at 60
  krank draw hoecken --traces
  krank draw four-bar --velocities --accelerations C --size 120x40
  krank draw jansen-leg --traces T --ghosts 6 --format svg -o leg.svg
  krank draw slider-crank --format svg --scale 1:2 -o print.svg
  krank draw four-bar --traces C --format dxf -o four-bar.dxf

POINTS are names of points separated by commas, or all. Without them --traces
draws the curves that are no circles about a ground pin (or these, where there
is nothing else), --velocities and --accelerations the arrows of all joints and
riders, --forces those of loads, joints, guides and the driver, each with its
size. Arrows of one kind have one scale over the whole motion; the line below
tells it. One whose shaft is broken is longer than it is drawn.";
        examples_of_export = "\
Examples:
  krank export four-bar --format python -o four_bar.py
  python3 four_bar.py 0 360 10
  krank export press-ram --format matlab -o press_ram.m
  octave --eval 'press_ram(0, 360, 10)'

The script has every length by its name, a line for each group and the formulas
of groups in full; nothing of krank is in it. It takes where to begin, where to
end and the step, and prints the columns of krank sweep; in MATLAB and Octave
[rows, heads] = press_ram(0, 360, 10) hands them over instead. A length that is
changed in it changes the motion as long as each group keeps its assembly.
A drawing for CAD is krank draw --format dxf; figures are krank sweep.";
        examples_of_sweep = "\
Examples:
  krank sweep four-bar --from 0 --to 360 --step 1 --columns C.x,C.vx,r4.omega
  krank sweep four-bar --columns 'C.*,*.omega' --format json
  krank sweep press-ram --step 0.1 -o press.csv
  krank sweep four-bar --columns 'C.v,C.a.t,swing = r4.angle - r3.angle,swing.rate'

Columns are named C.x, C.vy, r3.angle, r3.omega, r4.length, r3.com.ax and so on;
krank sweep SCENE | head -n 1 shows all of a scene's. Where anything acts there
are driver.torque, driver.power, r3.B.fx (the force on link r3 at pin B),
r4.normal, r6.moment, ground.fx, and the residuals of two checks, which would be
zero but for rounding. C.v, C.a.angle, C.a.t, r3.B.f and the like come when they
are named, and behind = stands a formula (krank help columns). The driver's coordinate always comes first and the state
last: ok, change-point, dead-point or no-assembly. A value that does not exist
is an empty cell (null in JSON).
--bounds puts C.x.bound behind each C.x, in the same unit: what the error of
solving the scene as it is given does not exceed. --sensitivity puts
C.x.sensitivity there: the change of C.x where every given length is off by one
unit, at the worst.
Without --from and --to a sweep covers the motion range and ends on its limits,
or after one period; with forces among the figures, that of the loads.";
        examples_of_plot = "\
Examples:
  krank plot four-bar --columns r4.omega
  krank plot four-bar --columns 'C.v*,r4.alpha' --size 120x40
  krank plot slider-crank --columns C.vx --against C.x
  krank plot hoecken --columns P.y --against P.x --format svg -o curve.svg

Columns are named as in krank sweep; every unit has a panel of its own. Over
time, 0 s is where the scene opens, and the driver goes on from there with its
speed and acceleration. Maxima and minima are marked with their value and place,
which are solved for, not read from the picture: the value to rounding, the
place to about 1e-5 deg. Where no value exists there is a gap.";
        examples_of_cycle = "\
Examples:
  krank cycle whitworth
  krank cycle four-bar --columns C.x,r4.angle
  krank cycle toggle-press --columns S.y --dwell 0.5
  krank cycle slider-crank --columns 'F = C.x * cos(30 deg) + C.y * sin(30 deg)'
  krank cycle jansen-leg --format csv -o cycle.csv

Of each figure its stroke, or of an angle its swing; every place where it turns,
solved for; the time ratio, slow over quick, between its extremes; where it stays
within --dwell of a turning place; its greatest rate and the greatest rate of that
at the scene's speed. Then the transmission angle of every dyad where it is furthest
from 90 deg, and every coupled group where its equations tell least. A figure that
does not exist has a reason.";
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
goes first. Every design is the scene with these numbers, opened in the assembly
of the scene; the last columns are its state (ok, no-assembly, or unreadable
where the numbers make no scene) and the reason why something is missing.
A file of CSV grows while the command runs: after Ctrl-C --resume goes on with
it. krank help designs tells more.";
        examples_of_motor = "\
Examples:
  krank motor four-bar-load
  krank motor four-bar-load --rated 30 --peak 75 --fluctuation 0.02
  krank motor press-ram --height 6 --torque 500 --rest 0.5
  krank motor excavator-boom --from 1.8 --to 2.8
  krank motor engine --format csv -o engine.csv

Torque and power with their peaks, which are solved for, means, and the energy put
in and given back, split into loads, gravity and inertia; how uneven the speed is
and the flywheel against it; what shakes the frame; what a motor lacks; and of a
ram stroke, dead centres, time ratio, dwell, and speed and force at a height above
the bottom. A cycle is the period of the motion, or of loads that take longer; a
limited range is gone through there and back. Options stand for what the scene's
[motor] has. Friction is not modelled.";
        examples_of_tolerance = "\
Examples:
  krank tolerance four-bar --tolerance 0.1 --columns C.x,r4.angle --at 60
  krank tolerance press.toml --columns F.y
  krank tolerance press.toml --columns F.y --samples 10000 --format csv -o off.csv

Of each figure: as it was given; the worst case within all tolerances; the root
sum square of what each length does by itself; at one place also the figures of
machines made by chance, and who contributes how much. The worst case is solved
at every corner of the tolerances of up to 16 lengths, of a stroke up to 12. Of
more lengths, and of loose pins, it is enclosed; what is neither is told to be
estimated, and how it was found. The tolerances are the scene's: tolerance,
clearance, [tolerances], [clearances].";
        examples_of_start = "\
Examples:
  krank start four-bar --assembly C=- > crossed.toml
  krank start my-press.toml --assembly C=-,F=+ -o my-press.toml

Only [start] changes: comments, order and everything else stay as they are. The
file is written at once or not at all, and may be the scene itself. Where the
motion of the assembly does not come to where the scene opens, the opening of
the driver changes too.";
        examples_of_accuracy = "\
Examples:
  krank accuracy                 the four-bar of the lectures
  krank accuracy jansen-leg --format csv -o jansen.csv
  krank accuracy my-press.toml --positions 36000

Every method gives positions, velocities and accelerations, and is held against
a run in doubled precision. Methods that a scene does not allow are listed with
the reason. Times are this machine's: let it rest meanwhile. Ctrl-C ends it.";
        examples_of_config = "\
Example:
  krank config > ~/.config/krank/config.toml

The workbench reads $XDG_CONFIG_HOME/krank/config.toml, or ~/.config/krank/config.toml
where that is not set, and never writes it: characters, colours, keys.";
        examples_of_help = "\
Examples:
  krank help                     the topics
  krank help scene               every key of a scene file
  krank help sweep               as krank sweep --help

On a terminal it is shown by $PAGER, or by less or more.";
        examples_of_completions = "\
Example:
  krank completions bash > ~/.local/share/bash-completion/completions/krank";
        examples_of_man = "\
Examples:
  krank man > krank.1
  krank man sweep > krank-sweep.1";
    }
}
