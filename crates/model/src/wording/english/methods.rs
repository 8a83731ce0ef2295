//! Comparison of the methods that can solve a scene: speed against error.

use super::{English, counted};
use std::fmt::Display;

catalogue! {
    /// The results of a study of methods.
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

        // Reasons why a method is not applicable.
        a_group = "a group";
        the_group_at(point: &str) = "the group at {point}";
        has_no_closed_form(group: &str) = "{group} has no closed form";
        not_needed = "not needed: every group has a closed form";
        closes_by_conditions(group: &str, count: usize) = "{group}: {count} equations must be solved together";
        cannot_turn_fully = "the driver has limits and cannot turn fully";
        gives_no_rows = "a group has no separate equations for its constraints";
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

        // Explanations.
        of_time_is =
            "time for one position with velocities and accelerations: median and quartiles; for RK4, the time of a \
             step";
        errors_of_three = "pos vel acc";
        errors_are =
            "the largest errors against a run in twice the precision: points relative to the longest length, rates \
             to the largest velocity and acceleration of the cycle";
        failures_are = "positions with no solution, or with another assembly; the errors do not include them";
        iterations_are = "Newton steps or halvings per position, over all groups: median and maximum";
        closed_form_is = "every dyad by its formula, without iteration: the method of krank";
        anchors = "anchors";
        newton_from_anchors_is =
            "Newton's method from the nearest of many stored states: krank's method for coupled groups";
        polished = "polished";
        polished_is = "the closed form, and one correction from residuals in twice the precision";
        single = "single";
        single_precision_is = "the closed form in single precision";
        newton_at_tolerance = "Newton";
        newton_is = "solves the linearized loop equations repeatedly, with full steps";
        bisection_is =
            "halves, for each group, a half turn that contains one root, until no number lies between its ends";
        best_are = "the Pareto front: never fails, and no other such method is both faster and more accurate";
        with_bounds_is = "krank's solution with a proved bound of every value; fails where no bound is proved";
        warm_or_cold = "warm, cold";
        warm_or_cold_is =
            "Newton's method starts from the position before (warm), a degree or a 360th of the range away, or \
             from the opening position (cold); it ends when a step is below the tolerance, in radians and \
             fractions of the longest length";
        runge_kutta_n_by_m = "RK4 n x m";
        runge_kutta_is =
            "velocities integrated by the Runge-Kutta method, n steps per 360 deg, compared in the m-th cycle";

        // Methods worked out step by step.
        watch_a_method = "step through a method";
        guess = "guess";
        type_where_it_begins = "the initial guess";
        guesses_are_typed = "r3=20, r4=280; bisection: r3=0..90; empty: sketch values";
        no_method_watched(key: &str) = "No method is selected; press {key} for the first";
        begins_at_no_guess = "This method uses no guess";
        newton_raphson = "Newton-Raphson";
        bisection_title = "Bisection";
        by_drawing = "By compass and ruler";
        newton_how =
            "From a guess x, the next is x + dx with J dx = -f. f is the residual of the loop equations, J its \
             derivatives with respect to the unknowns. Full steps are taken until one is below 1e-12. Errors are \
             differences from krank's own solution: angles in rad, lengths as fractions of the longest.";
        bisection_how =
            "The length of its arm eliminates one unknown, and one equation f = 0 for the other is left. The \
             interval in which f changes its sign is halved, and the half with the change of sign is kept. Errors \
             are those of the midpoints: angles in rad, lengths as fractions of the longest.";
        drawing_how =
            "The same on paper: circles with the compass, guides with the ruler, angles read with the protractor.";
        error_of_iteration = "error";
        iteration = "iteration";
        errors_by_iteration = "Errors by iteration";
        begins_at_guess(values: &str) = "From the guess {values}:";
        begins_at_start(values: &str) = "From {values}, as read from a sketch of the opening position:";
        not_square(equations: usize, unknowns: usize) =
            "{equations} equations for {unknowns} unknowns: J is not square, so it gives no step.";
        jacobians(unit: &str) = "J, one line per iteration, in {unit}, for an angle in {unit}/rad:";
        first_jacobian(unit: &str) = "J at the guess, in {unit}, for an angle in {unit}/rad:";
        largest_step = "step";
        newton_found(steps: usize) = {
            format!("It converges in {}, to the assembly of this motion.", counted(steps, "step", "steps"))
        };
        errors_are_squared = "Near the end, each error is about the square of the previous one.";
        newton_other(steps: usize) = {
            let steps = counted(steps, "step", "steps");
            format!("It converges in {steps}, to another assembly: the loops close, but the motion has another \
                     position here. The result depends on the guess, and nothing shows that it is wrong.")
        };
        newton_closes(steps: usize) = {
            let steps = counted(steps, "step", "steps");
            format!("It converges in {steps}: the loop closes, but the motion from the scene's assembly does not \
                     reach this position.")
        };
        newton_diverged(steps: usize) = {
            let steps = counted(steps, "step", "steps");
            format!("It diverges: after {steps} an angle is more than 100 turns from its guess, or a length \
                     exceeds all others. J was nearly singular, so the step was far too long.")
        };
        newton_singular(steps: usize) = {
            let steps = counted(steps, "step", "steps");
            format!("It ends after {steps}: J is singular there, det J = 0, and no step exists. For example, two \
                     vectors with unknown angles are parallel.")
        };
        newton_unsettled(steps: usize) = {
            let steps = counted(steps, "step", "steps");
            format!("It does not converge in {steps}: the steps do not become small.")
        };
        newton_at_dead_point(steps: usize) = {
            let steps = counted(steps, "step", "steps");
            format!("It ends after {steps}: at a dead point J is singular at the solution itself. Each step at \
                     most halves the error, and rounding leaves half of the digits.")
        };

        // Bisection.
        known_sides_are_k = "K is the sum of the known sides:";
        between_ends(symbol: &str, from: &str, to: &str) = "{symbol} between {from} and {to}:";
        least_along(m: &str, symbol: &str, at: &str) =
            "f has its minimum where the arm lies along {m}, at {symbol} = {at}, and its maximum opposite to that: \
             one root lies on either side of {m}. The half turn that contains the assembly is halved.";
        least_at(symbol: &str, at: &str) =
            "f has its minimum at {symbol} = {at}: one root lies on either side of it, and the side of the \
             assembly is halved.";
        halved_until(finest: &str) = "Halved until the interval is at most {finest}, or f is 0 in its middle:";
        root_at_an_end(end: &str) =
            "{end} is the root itself; f only touches 0 there, so bisection is impossible.";
        no_change_of_sign =
            "f has the same sign at both ends: the interval contains no root or two, so bisection is impossible.";
        middle_of_interval = "middle";
        halved(count: usize) = {
            format!("After {}:", counted(count, "halving", "halvings"))
        };
        holds_the_assembly(from: &str, to: &str) =
            "This root is the assembly of this motion. The other lies between {from} and {to}.";
        holds_the_other(from: &str, to: &str) =
            "This root is the other assembly. The one of this motion lies between {from} and {to}.";
        assemblies_are_one = "The two assemblies coincide here: both roots are equal.";
        guess_of_removed(symbol: &str) =
            "Only {symbol} is halved; the guess of the eliminated unknown is not used.";
        nothing_to_halve(unknowns: usize) =
            "Not by bisection: it has {unknowns} coupled unknowns, and none can be eliminated alone, so no single \
             equation is left whose sign could change.";
        two_guides_are_linear =
            "Not by bisection: both unknowns are positions along guides, the equations are linear, and one step of \
             Newton-Raphson solves them.";

        // Graphical constructions.
        no_assembly_to_draw = "There is no assembly, so the circles do not meet: there is nothing to draw.";
        scale_of_sheet(scale: &str) =
            "All points fit on an A4 sheet at {scale}. A point can be drawn and read to 0.2 mm on paper.";
        points_to_begin_with = "Points of the ground, and points placed by the driver:";
        on_paper(axis: &str) = "{axis} on paper [mm]";
        which_it_is = "which";
        also_on_paper(length: &str, unit: &str, paper: &str) = "{length} {unit} ({paper} mm on paper)";
        draw_a_circle(centre: &str, arm: &str, radius: &str) =
            "Draw a circle about {centre} with {arm} = {radius}.";
        draw_a_line(through: &str, theta: &str, direction: &str) =
            "Draw a line through {through} at {theta} = {direction} deg.";
        draw_through(one: &str, other: &str) = "Draw the line through {one} and {other}.";
        draw_a_tangent(centre: &str, from: &str, radius: &str) =
            "Draw a circle about {centre} with radius {radius}, and a tangent to it from {from}.";
        leave_out_beyond(name: &str, length: &str) =
            "The distance measured along it consists of {name} and {length}; the latter belongs to the link.";
        they_meet_in_two = "They meet in two points:";
        the_assembly = "the assembly";
        the_other = "the other";
        they_cross_at(degrees: &str, point: &str, off: &str, unit: &str) =
            "They cross at {degrees} deg, so {point} is known to {off} {unit}.";
        they_touch_in(point: &str) = "They touch in {point}; the drawing cannot show exactly where:";
        lines_meet_in(point: &str) = "They meet in {point}.";
        read_off_sheet = "Values read from the sheet, beside the calculated ones:";
        sought_here = "unknown";
        as_read = "read";
        as_solved = "calculated";
        not_by_compass(unknowns: usize) =
            "Not by compass and ruler: it has {unknowns} coupled unknowns, and none of its points lies on two \
             known lines. The only way by hand is to try positions until the last length fits.";

        // Guesses.
        guess_is_written =
            "write NAME=VALUE, followed by deg, rad or a unit of length if it is not clear, and for bisection \
             NAME=FROM..TO";
        guess_of_nothing(name: &str, mend: &str) = "no vector is named `{name}`; {mend}";
        sought_are(names: &str) = "the unknowns are {names}";
        not_sought(name: &str, names: &str) =
            "`{name}` is given, or follows from the driver; the unknowns are {names}";
        other_unit(name: &str, unit: &str) = "write the guess of `{name}` in {unit}";
        unit_missing(name: &str, unit: &str) =
            "both length and angle of `{name}` are unknown; write {name}=VALUE{unit} or {name}=VALUEdeg";
        guessed_twice(name: &str) = "the unknown of `{name}` is given twice; remove one guess";
        guess_is_one_value(name: &str) = "Newton-Raphson starts from one value; {name}=FROM..TO is for bisection";
        needs_no_guess(name: &str) = "`{name}`: this method uses no guess; use Newton-Raphson or bisection";
    }
}
