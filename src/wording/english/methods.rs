//! Methods that could solve a scene: speed against error.

use super::{English, counted};
use std::fmt::Display;

catalogue! {
    /// What a study of methods has found.
    trait MethodsWords for English {
        // The methods.
        method = "method";
        closed_and_polished = "closed and polished";
        newton_from_anchors = "Newton from anchors";
        with_bounds = "with bounds";
        single_precision = "single precision";
        newton_warm(tolerance: f64) = "Newton {tolerance:e} warm";
        newton_cold(tolerance: f64) = "Newton {tolerance:e} cold";
        bisection = "bisection";
        runge_kutta(steps: &dyn Display, turns: &dyn Display) = "RK4 {steps} x {turns}";

        // Why one cannot be used.
        a_group = "a group";
        the_group_at(point: &str) = "the group at {point}";
        has_no_closed_form(group: &str) = "{group} has no closed form";
        not_needed = "not needed: every group has a closed form";
        closes_by_conditions(group: &str, count: usize) = "{group} closes by {count} conditions at once";
        cannot_turn_fully = "the driver has limits, and cannot turn fully";
        gives_no_rows = "the constraints of a group give no rows of their own";
        not_measured = "not measured";

        // Figures.
        positions_over_cycle(positions: &dyn Display, longest: &str, unit: &str) =
            "{positions} positions over the cycle; the longest length is {longest} {unit}";
        time = "time";
        quartiles = "quartiles";
        error_of_positions = "pos";
        error_of_velocities = "vel";
        error_of_accelerations = "acc";
        failures = "fail";
        iterations = "iter";

        // How they are meant.
        of_time_is =
            "of one position with its velocities and accelerations: the median, and between what half \
             of all samples lie; of RK4, of a step";
        errors_of_three = "pos vel acc";
        errors_are =
            "the largest errors against a run in twice the precision: of points, over the longest \
             length, and over the largest velocity and acceleration of the cycle";
        failures_are =
            "positions at which nothing was found, or another assembly; they count in no error";
        iterations_are =
            "steps of Newton's method, or halvings, that a position takes, of all groups together: the \
             median and the most";
        closed_form_is = "every dyad by its formula, without any iteration: what krank does";
        anchors = "anchors";
        newton_from_anchors_is =
            "Newton's method from the nearest of many states kept: what krank does for coupled groups";
        polished = "polished";
        polished_is = "the closed form, and one correction from residuals of twice the precision";
        single = "single";
        single_precision_is = "the closed form in numbers of half the digits";
        newton_at_tolerance = "Newton";
        newton_is = "the loop equations made linear, solved and made linear again: full steps";
        bisection_is =
            "of each group half a turn that holds one root, halved until no number lies between its ends";
        best_are = "the best front: never fails, and no other such method is both faster and nearer";
        with_bounds_is =
            "as krank solves it, and a proven bound of every figure; fails where none is proved";
        warm_or_cold = "warm, cold";
        warm_or_cold_is =
            "Newton's method begins at the position before, a degree or a 360th of the range away, or \
             where the scene opens; it ends with a step below the tolerance, in radians and parts of \
             the longest length";
        runge_kutta_n_by_m = "RK4 n x m";
        runge_kutta_is =
            "the velocities integrated by Runge and Kutta, n steps in 360 deg, looked at in the m-th \
             cycle";

        // A method by hand.
        watch_a_method = "watch a method by hand";
        guess = "guess";
        type_where_it_begins = "where a method begins";
        guesses_are_typed = "r3=20, r4=280, or to halve r3=0..90; nothing for the sketch";
        no_method_watched(key: &str) = "No method is watched; press {key} for the first";
        begins_at_no_guess = "This method begins at no guess";
        newton_raphson = "Newton-Raphson";
        bisection_title = "Bisection";
        by_drawing = "By compass and ruler";
        newton_how =
            "From a guess x the next one is x + dx with J dx = -f: f what is left of the loop equations, J \
             their derivatives by what is sought. Full steps, as a program of a lecture makes them, until one \
             is below 1e-12. Errors are against krank's own solution: angles in rad, lengths in parts of \
             the longest.";
        bisection_how =
            "One unknown is removed by the length of its arm, so that one equation f = 0 of the other is \
             left. The interval in which f changes its sign is halved, and the half kept in which it still \
             does. Errors are those of the middles: angles in rad, lengths in parts of the longest.";
        drawing_how =
            "The same on paper: circles with the compass, guides with the ruler, angles read off with the \
             protractor.";
        error_of_iteration = "error";
        iteration = "iteration";
        errors_by_iteration = "Errors by iteration";
        begins_at_guess(values: &str) = "From the guess {values}:";
        begins_at_start(values: &str) =
            "From {values}, as one reads it off a sketch of where the scene opens:";
        not_square(equations: usize, unknowns: usize) =
            "{equations} equations for {unknowns} unknowns: J is not square, and no step follows from it.";
        jacobians(unit: &str) = "J, a line for every iteration, in {unit}, for an angle in {unit}/rad:";
        first_jacobian(unit: &str) = "J at the guess, in {unit}, for an angle in {unit}/rad:";
        largest_step = "step";
        newton_found(steps: usize) = {
            format!("It converges in {}, to the assembly that is meant.", counted(steps, "step", "steps"))
        };
        errors_are_squared = "Near the end each error is about the square of the one before.";
        newton_other(steps: usize) = {
            let steps = counted(steps, "step", "steps");
            format!("It converges in {steps}, to another assembly: the loops close, but this is not the \
                 position that the motion has here. The guess decides, and nothing tells that it was \
                 wrong.")
        };
        newton_closes(steps: usize) = {
            let steps = counted(steps, "step", "steps");
            format!("It converges in {steps}: the loop would close, but the motion that starts at the scene's \
                 assembly does not come here.")
        };
        newton_diverged(steps: usize) = {
            let steps = counted(steps, "step", "steps");
            format!("It diverges: after {steps} an angle is more than 100 turns from its guess, or a length \
                 beyond all others. J was nearly singular, so that its step was far too long.")
        };
        newton_singular(steps: usize) = {
            let steps = counted(steps, "step", "steps");
            format!("It ends after {steps}: J is singular there, det J = 0, and no step exists. Two vectors \
                 are parallel whose angles are sought, or the like.")
        };
        newton_unsettled(steps: usize) = {
            let steps = counted(steps, "step", "steps");
            format!("It does not converge in {steps}: they do not become small.")
        };
        newton_at_dead_point(steps: usize) = {
            let steps = counted(steps, "step", "steps");
            format!("It ends after {steps}: at a dead point J is singular at the solution itself, so that each \
                 step does no more than halve the error, and rounding leaves half of the digits.")
        };

        // Halving.
        known_sides_are_k = "With K the sum of the known sides:";
        between_ends(symbol: &str, from: &str, to: &str) = "{symbol} between {from} and {to}:";
        least_along(m: &str, symbol: &str, at: &str) =
            "f is least where the arm lies along {m}, at {symbol} = {at}, and greatest opposite to that: one root \
             lies on either side of {m}. Of the two halves of the turn the one with the assembly is halved.";
        least_at(symbol: &str, at: &str) =
            "f is least at {symbol} = {at}: one root lies on either side of it, and the side with the assembly is \
             halved.";
        halved_until(finest: &str) =
            "Halved until the interval is no longer than {finest}, or f is 0 in its middle:";
        root_at_an_end(end: &str) =
            "{end} is the root itself; f only touches 0 there, and bisection has nothing to halve.";
        no_change_of_sign =
            "f has the same sign at both ends: they enclose no root, or two, and there is nothing to halve.";
        middle_of_interval = "middle";
        halved(count: usize) = {
            format!("After {}:", counted(count, "halving", "halvings"))
        };
        holds_the_assembly(from: &str, to: &str) =
            "This root is the assembly that is meant. The other one lies between {from} and {to}.";
        holds_the_other(from: &str, to: &str) =
            "This root is the other assembly. The one that is meant lies between {from} and {to}.";
        assemblies_are_one =
            "Both assemblies are one here: two roots lie in the same place.";
        guess_of_removed(symbol: &str) =
            "Only {symbol} is halved: what was guessed of what is removed is not used.";
        nothing_to_halve(unknowns: usize) =
            "Not by bisection: it seeks {unknowns} unknowns at once, of which none can be removed alone, so \
             that no single equation is left whose sign could change.";
        two_guides_are_linear =
            "Not by bisection: both unknowns are positions along guides, the equations are linear, and one \
             step of Newton-Raphson solves them.";

        // By compass and ruler.
        no_assembly_to_draw = "Without an assembly the circles do not meet: there is nothing to draw.";
        scale_of_sheet(scale: &str) =
            "All points have room on an A4 sheet at {scale}. A point is drawn and seen to 0.2 mm on paper.";
        points_to_begin_with = "The ground, and what the driver places:";
        on_paper(axis: &str) = "{axis} on paper [mm]";
        which_it_is = "which";
        also_on_paper(length: &str, unit: &str, paper: &str) = "{length} {unit} ({paper} mm on paper)";
        draw_a_circle(centre: &str, arm: &str, radius: &str) =
            "Draw a circle about {centre} with {arm} = {radius}.";
        draw_a_line(through: &str, theta: &str, direction: &str) =
            "Draw a line through {through} at {theta} = {direction} deg.";
        draw_through(one: &str, other: &str) = "Draw the line through {one} and {other}.";
        draw_a_tangent(centre: &str, from: &str, radius: &str) =
            "Draw a circle about {centre} with {radius}, and a tangent to it from {from}.";
        leave_out_beyond(name: &str, length: &str) =
            "What is measured along it is {name} and {length}, which belongs to the link.";
        they_meet_in_two = "They meet in two points:";
        the_assembly = "the assembly";
        the_other = "the other";
        they_cross_at(degrees: &str, point: &str, off: &str, unit: &str) =
            "They cross at {degrees} deg, so that {point} is known to {off} {unit}.";
        they_touch_in(point: &str) =
            "They touch in {point}; the drawing cannot tell where exactly:";
        lines_meet_in(point: &str) = "They meet in {point}.";
        read_off_sheet = "Read off, beside what is calculated:";
        sought_here = "sought";
        as_read = "read";
        as_solved = "calculated";
        not_by_compass(unknowns: usize) =
            "Not by compass and ruler: it seeks {unknowns} unknowns at once, and no point of it lies on two \
             lines that are known. One would try positions until the last length fits.";

        // What is guessed.
        guess_is_written =
            "write NAME=VALUE, with deg, rad or a unit of length behind it where that is not plain, and for \
             bisection NAME=FROM..TO";
        guess_of_nothing(name: &str, mend: &str) = "no vector is named `{name}`; {mend}";
        sought_are(names: &str) = "sought are {names}";
        not_sought(name: &str, names: &str) =
            "`{name}` is given, or goes with the driver; sought are {names}";
        other_unit(name: &str, unit: &str) = "of `{name}` the {unit} are sought";
        unit_missing(name: &str, unit: &str) =
            "of `{name}` both length and angle are sought; write {name}=VALUE{unit} or {name}=VALUEdeg";
        guessed_twice(name: &str) = "what `{name}` says is given twice";
        guess_is_one_value(name: &str) =
            "Newton-Raphson begins at one value; {name}=FROM..TO is for bisection";
        needs_no_guess(name: &str) =
            "`{name}` is guessed for nothing; Newton-Raphson and bisection begin at a guess";
    }
}
