//! Values in tables, their derivatives by lengths, and reasons for missing values.

use super::English;

catalogue! {
    /// Tables of values.
    trait FiguresWords for English {
        // Reasons for values that are not shown.
        forces_disagree(at: &str, residual: &str, missed: &str, most: &str) =
            "the forces at {at} are not shown: {residual} is {missed}, but rounding explains at most {most}; \
             two methods disagree, which is an error in krank, not in the scene: please report it";
        forces_too_large(at: &str) =
            "the forces at {at} are not shown: some are too large for a double; use smaller speeds, masses and \
             loads";
        figure_too_large(figure: &str, at: &str) =
            "{figure} at {at} is too large for a double; use smaller lengths and speeds";

        // Tables.
        vector = "vector";
        point = "point";
        given = "given";
        position = "position";
        velocity = "velocity";
        acceleration = "acceleration";
        of_points(figure: &str) = "{figure} of points";
        direction = "direction";
        direction_r = "dir r";
        direction_v = "dir v";
        direction_a = "dir a";
        driver_at(driver: &str, at: &str, speed: &str, acceleration: &str) =
            "driver {driver} at {at}, {speed}, {acceleration}";
        state_is(state: &str) = "state {state}";
        stars_are_found = "* computed; entries without a star are given";
        bounds_are = "+- bound of the error; ? no bound is proved";

        // Derivatives by lengths.
        no_derivatives_by_lengths =
            "no derivatives by the lengths exist here: the motion ends or branches, or almost does, or a wrong \
             length jams the mechanism";
        per(figure: &str, length: &str) = "{figure} per {length}";
        change_for_one(unit: &str) = "change for 1 {unit}";
        change_for_length = "change for a length of 1";
        without_change(change: &str, why: &str) = "{change}: {why}";
        in_every_length = "in every length";
        in_one = "in one";
        in_which = "in which";
        most_in = "most in";
    }
}
