//! Figures in tables, what lengths do to them, and why some are not shown.

use super::English;

catalogue! {
    /// Figures by name.
    trait FiguresWords for English {
        // Why some are not shown.
        forces_disagree(at: &str, residual: &str, missed: &str, most: &str) =
            "the forces at {at} are withheld: {residual} is {missed}, and rounding explains no more \
             than {most}; two ways to find them disagree, which is a fault of krank and not of the \
             scene: please report it";
        forces_too_large(at: &str) =
            "the forces at {at} are withheld: some are too large for a number; choose ordinary \
             speeds, masses and loads";
        figure_too_large(figure: &str, at: &str) =
            "{figure} at {at} is too large for a number; choose ordinary lengths and speeds";

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
        stars_are_found = "* found; entries without a star are given";
        bounds_are = "+- what the error does not exceed; ? where nothing was proved";

        // What lengths do to them.
        no_derivatives_by_lengths =
            "the figures have no derivatives by the lengths here: the motion ends or branches, or as \
             good as does, or a length that is off jams the mechanism";
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
