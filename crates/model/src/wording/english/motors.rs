//! The motor's demand over a cycle, and the motion of the ram.

use super::English;
use std::fmt::Display;

catalogue! {
    /// The demand on a scene's motor, and the ram's motion.
    trait MotorsWords for English {
        // The driver's effort over the cycle.
        torque = "torque";
        force = "force";
        over_a_turn(speed: &str) = "over a turn at {speed}";
        over_turns(turns: f64, speed: &str) = "over {turns} turns at {speed}";
        there_and_back(low: &str, high: &str, unit: &str, speed: &str) =
            "from {low} to {high} {unit} and back at {speed}";
        driver_asks(course: &str, driver: &str, asked: &str) = "{course}, {driver} {asked}";
        asks_throughout(effort: &str) = "needs {effort} throughout";
        asks_at_worst(effort: &str, place: &str, rms: &str) =
            "needs {effort} at {place}, the worst instant; {rms} RMS";
        asks_too_much(effort: &str) = "needs a {effort} without bound: its maximum and its RMS do not exist";
        on_the_way_back(place: &str) = "{place} on the way back";
        back_at(place: &str) = "{place} back";
        places_of(places: &[String], unit: &str) = {
            format!("{} {unit}", places.join(" and "))
        };

        // Remarks on the values.
        nothing_acts = "the scene has no load and no mass, so the driver does no work";
        no_figures(why: &str) = "no values: {why}";
        mechanism_drives(driver: &str, work: &str) = "the mechanism drives {driver}: it returns {work} J per cycle";
        dead_points_run_into(places: &str) =
            "dead points at {places}: towards them accelerations grow without bound, and a driver at constant \
             speed never reaches them. Means and energies include only loads and gravity; choose part of the \
             motion to get all values";
        dead_points_passed(places: &str) =
            "dead points at {places}: towards them the driver's effort can grow without bound. Work and mean exist, \
             peak and RMS do not. Choose part of the motion to get all values";
        change_points_passed(places: &str) =
            "change points at {places}: the torque is continuous there, joint forces may not be";
        not_converged(error: &str, effort: &str) =
            "the integrals have not converged: the error may reach {error} of the largest {effort}";
        does_not_repeat(numbers: &[String], from: &str, to: &str, unit: &str) = {
            let (loads, does) = match numbers.len() {
                1 => ("load", "does"),
                _ => ("loads", "do"),
            };
            let numbers = numbers.join(" and ");
            format!("`over` of {loads} {numbers} {does} not repeat: this is the cycle from {from} to {to} {unit}")
        };
        repeats_late =
            "the loads repeat only after more than 64 turns: these values are for one period of the motion";
        speed_not_kept = "the driver's speed is not constant: the effort of its acceleration is part of inertia";
        no_power = "the driver stands still: there is no power, and time does not pass";
        trapezoids(places: &dyn Display, error: &str, effort: &str) =
            "trapezoidal rule at {places} points, error {error} of the largest {effort}";
        polynomials(pieces: &dyn Display, error: &str, effort: &str) =
            "polynomials on {pieces} pieces, error {error} of the largest {effort}";

        // Labels of values.
        label_all = "all";
        label_largest = "largest";
        label_least = "smallest";
        label_mean = "mean";
        label_rms = "RMS";
        label_energy = "energy";
        label_put_in = "supplied";
        label_given_back = "returned";
        label_work = "work";
        label_integrals = "integrals";

        // The motor.
        motor_is(verdict: &str) = "motor: {verdict}";
        enough = "enough";
        enough_with_flywheel = "enough, with the flywheel";
        enough_but_the_flywheel = "enough, but the flywheel is too small";
        not_enough = "not enough";
        not_judged(effort: &str) = "not compared: the maximum {effort} does not exist";
        rated_for_rms = "rated for RMS";
        peak = "peak";
        speed = "speed";
        with_flywheel = "with flywheel";
        with_a_gear = "with a gear";
        about_the_mean(verdict: &str) = "about the mean: {verdict}";
        gear_enough(ratio: &str) = "{ratio} to 1 reduces it to the driver's speed: it would be enough";
        gear_not_enough(ratio: &str) = "{ratio} to 1 reduces it to the driver's speed: still not enough";
        has_left_by_times(has: &str, wants: &str, left: &str, times: &str) =
            "{has} for {wants}: {left} left ({times} times what is needed)";
        has_left(has: &str, wants: &str, left: &str) = "{has} for {wants}: {left} left";
        has_a_share(has: &str, wants: &str, percent: &str) = "{has} for {wants}: only {percent} % of it";

        // Evenness.
        evenness = "evenness";
        flywheel = "flywheel";
        fluctuation = "fluctuation";
        energy_up_and_down(energy: &str, slowest: &str, fastest: &str) =
            "{energy} J: slowest at {slowest}, fastest at {fastest}";
        flywheel_leaves(inertia: &str, fluctuation: &str) =
            "of {inertia} kg m^2 leaves a fluctuation of {fluctuation}";
        takes_a_flywheel(fluctuation: &str, inertia: &str) =
            "of {fluctuation} needs a flywheel of {inertia} kg m^2";
        impossible(what: &str) =
            "{what}: impossible, since at 2 the driver stops once per cycle; use a larger flywheel";
        roughly(what: &str) = "{what}, a rough value: energy is proportional to fluctuation only while it is small";

        // Forces on the frame.
        on_frame_with_loads = "on the frame, loads included";
        moment = "moment";
        no_joint_forces = "no value: joint forces do not exist everywhere";
        force_throughout(force: &str, x: &str, y: &str) = "{force} N throughout ({x}, {y})";
        force_at(force: &str, place: &str, x: &str, y: &str, rms: &str) =
            "{force} N at {place} ({x}, {y}); {rms} N RMS";
        moment_throughout(moment: &str) = "{moment} N m throughout about the origin";
        moment_at(moment: &str, place: &str, rms: &str) =
            "{moment} N m at {place} about the origin; {rms} N m RMS";

        // The ram.
        several_rams(names: &str) = "several slides can be the ram, choose one: {names}";
        ram_named(name: &str) = "ram {name}";
        ram_works = "works";
        works_at(end: &str) = "at its {end} position";
        works_at_by_convention(end: &str) = "at its {end} position, by convention";
        stroke = "stroke";
        bottom = "bottom";
        top = "top";
        turns_too = "reverses";
        centre_at(at: &str, unit: &str, position: &str, length: &str) =
            "{at} {unit}, position {position} {length}";
        closes_in = "closes in";
        opens_in = "opens in";
        in_seconds(way: &str, seconds: &str) = "{way}, {seconds} s";
        time_ratio = "time ratio";
        closing_to_opening(ratio: &str) = "{ratio}, closing to opening";
        strokes = "strokes";
        a_minute(count: &str) = "{count} a minute";
        dwells = "dwells";
        dwells_within(way: &str, from: &str, to: &str, tolerance: &str) =
            "{way}: from {from} to {to}; within {tolerance} of the bottom";
        at_height(height: &str, unit: &str) = "at {height} {unit}";
        ram_never_there(stroke: &str, unit: &str) = "the ram never reaches it: its stroke is {stroke} {unit}";
        closing = "closing";
        opening_way = "opening";
        label_place = "place";
        newtons_per(unit: &str) = "N per {unit}";
        force_held_by(effort: &str) = "force: held by {effort} of the driver, without friction";
        force_unbounded = "a dead centre: the force has no bound";
    }
}
