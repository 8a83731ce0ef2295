//! Methods that could solve a scene: speed against error.

use super::English;
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
    }
}
