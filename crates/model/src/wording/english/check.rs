//! The facts that `krank check` prints.

use super::{English, counted};
use std::fmt::Display;

catalogue! {
    /// Facts of a mechanism.
    trait CheckingWords for English {
        // Labels.
        fact_source = "source";
        fact_note = "note";
        fact_unit = "unit";
        fact_parameters = "parameters";
        fact_parts = "parts";
        fact_driver = "driver";
        fact_motion = "motion";
        fact_links = "links";
        fact_joints = "joints";
        fact_slides = "slides";
        knots_outside(of: &str, at: &str) = "`over` of {of}: the motion never reaches the knots at {at}";
        fact_mobility = "mobility";
        fact_redundant = "redundant";
        fact_groups = "groups";
        fact_choices = "choices";
        fact_assemblies = "assemblies";
        fact_loop = "loop";
        fact_range = "range";
        fact_stops = "stops";
        fact_change = "change";
        fact_near_miss = "near miss";
        fact_figures = "strokes";
        fact_transmission = "angle";
        fact_condition = "condition";
        fact_forces = "forces";
        fact_open = "open";

        // Parts.
        parts_and_ground(links: usize, pins: usize, slides: usize) = {
            format!(
                "{} and the ground, {}, {}",
                some(links, "link"),
                some(pins, "pin joint"),
                some(slides, "slide")
            )
        };
        driven_link(name: &str) = "link {name}";
        turned_from(name: &str, from: &str) = "{name} from {from}";
        driven_slide(name: &str) = "slide {name}";
        driver_opens(driven: &str, at: &str, speed: &str, acceleration: &str) =
            "{driven}, opens at {at}, {speed}, {acceleration}";
        driver_opens_at(driven: &str, at: &str) = "{driven}, opens at {at}";
        motion_in_time(laws: &str, period: &str) = "{laws}, in {period} s";
        motion_rests(rest: &str) = ", of which {rest} s at rest";
        motion_at_most(speed: &str, acceleration: &str) = "; at most {speed} and {acceleration}";
        motion_jumps(time: &str) = "; the speed jumps at {time} s";
        motion_verdict(period: &str, speed: &str, acceleration: &str) =
            "{period} s, at most {speed} and {acceleration}";
        motion_in_short(period: &str, speed: &str) = "{period} s, {speed}";
        input_follows(driven: &str, ratio: &str, phase: &str) =
            "{driven} follows: {ratio} times the driver's coordinate plus {phase}";
        input_follows_table(driven: &str, knots: usize, ends: [&str; 2], unit: &str) = {
            let [first, last] = ends;
            format!("{driven} follows a table: {knots} knots, the driver from {first} to {last} {unit}")
        };
        table_repeats(period: &str) = ", which repeats after {period} deg";
        knots_beyond_motion(knots: usize) = {
            match knots {
                1 => "; 1 of them is outside the motion".into(),
                _ => format!("; {knots} of them are outside the motion"),
            }
        };
        input_given_by_table(driven: &str, knots: &str, units: [&str; 2], closes: bool) = {
            let [driver, own] = units;
            let ends = match closes {
                true => "periodic",
                false => "at rest at both ends",
            };
            format!(
                "{driven} follows a cubic spline, {ends}, through [driver in {driver}, own coordinate in {own}]: {knots}"
            )
        };
        pin_in_slot(name: &str, pin: &str, of: &str) = "{name}: pin {pin} in a slot of {of}";
        link_along(name: &str, link: &str, guide: &str) =
            "{name}: link {link} along {guide}, without relative rotation";
        slide_counts_backwards(name: &str, r: &str, unit: &str, angles: [&str; 2], theta: Option<&String>) = {
            let [angle, other] = angles;
            let at = theta.map(|theta| format!(", at theta {theta} deg")).unwrap_or_default();
            format!(
                "{name} is negative where the scene opens, {r} {unit}: it is measured from `through` along \
                 `angle = {angle}`, and its vector points back; set `angle = {other}` to make it positive{at}, as \
                 in lecture notes"
            )
        };

        // Mobility and groups.
        mobility_set_aside(mobility: &dyn Display, count: usize, which: &str) = {
            let count = some(count, "redundant constraint");
            format!("{mobility}, not counting {count}: {which}")
        };
        mobility_not_certain = "almost 2 or more: with slightly different dimensions a link would be free";
        mobility_more_at_opening =
            "higher at the initial position: a change point or dead point of a coupled group";
        repeats_others(part: &str) = "{part} repeats other constraints";
        repeats(part: &str, others: &str) = "{part} repeats {others}";
        disagree_by(what: &str, misfit: &str) = "{what}; they differ by at most {misfit}";
        some_and_more(some: &str, more: usize) = "{some} and {more} more";
        dyad(class: &str) = "dyad {class}";
        dyad_at(class: &str, point: &str) = "dyad {class} at {point}";
        coupled_group(unknowns: usize) = {
            format!("coupled group, {}", some(unknowns, "unknown"))
        };
        coupled_group_at(point: &str, unknowns: usize) = {
            format!("coupled group at {point}, {}", some(unknowns, "unknown"))
        };
        closed_form = "closed form";
        by_newton = "by Newton";
        group_of_driver(driven: &str) = "driver: {driven}";
        group_of_nothing(group: &str, how: &str) = "{group} ({how})";
        group_of_link(group: &str, link: &str, how: &str) = "{group}: link {link} ({how})";
        group_of_links(group: &str, links: &str, how: &str) = "{group}: links {links} ({how})";

        // Assemblies.
        those_of_more(count: usize) = "and {count} more";
        more_than(count: usize) = "more than {count}";
        chosen_now(choice: &str) = "{choice} now";
        rest_open(choice: &str) = "{choice} (the rest does not close)";
        at_place(choice: &str, x: &str, y: &str) = "{choice} at ({x}, {y})";

        // The first loop.
        driven_coupler_follower_frame(lengths: &[String; 4], unit: &str) = {
            let [driven, coupler, follower, frame] = lengths;
            format!("driven {driven}, coupler {coupler}, follower {follower}, frame {frame} {unit}")
        };
        crank_rod_offset(lengths: &[String; 3], unit: &str) = {
            let [crank, rod, offset] = lengths;
            format!("crank {crank}, rod {rod}, offset {offset} {unit}")
        };
        four_bar(inversion: &str, grashof: &str) = "four-bar, {inversion}: {grashof}";
        slider_crank(what: &str) = "slider-crank, {what}";
        slider_crank_alone = "slider-crank";
        crank_turns_fully = "the crank turns fully: rod > crank + offset";
        rod_is_crank_and_offset = "change point: rod = crank + offset";
        crank_rocks = "the crank does not turn fully: rod < crank + offset";
        grashof = "Grashof, s + l < p + q";
        grashof_change_point = "change point, s + l = p + q";
        not_grashof = "not Grashof, s + l > p + q";
        crank_rocker = "crank-rocker";
        rocker_crank = "rocker-crank";
        double_crank = "double crank";
        drag_link = "double crank (drag link)";
        double_rocker = "double rocker";
        triple_rocker = "triple rocker";

        // The motion.
        range_full(period: &dyn Display, unit: &str) =
            "turns fully; the motion repeats after {period} {unit}";
        range_limited(low: &str, high: &str, unit: &str) = "{low} to {high} {unit}";
        range_errors(low: &str, high: &str) = "error of the lower end {low}, of the upper end {high}";
        end_error(bound: &str, unit: &str) = "at most {bound} {unit}";
        end_error_not_proved = "not proved";
        never_met(name: &str, low: &str, high: &str, unit: &str) =
            "never reached: {name} from {low} to {high} {unit}";
        stop_at(at: &str, unit: &str, name: &str, value: &str) =
            "{at} {unit}: {name} at {value}";
        table_ends_at(at: &str, unit: &str, name: &str) = "{at} {unit}: the table of {name} ends";
        table_named(name: &str) = "the table of {name}";
        change_points_at(places: &str, unit: &str) = "at {places} {unit}, passed smoothly";
        equal_as_typed = "lengths count as equal if their written values are equal";
        equal_within(tolerance: &str, unit: &str) =
            "lengths count as equal if they differ by at most {tolerance} {unit}: coordinates are rounded";
        ends_lined_up(at: &str, unit: &str, group: &str) =
            "the links at {group} line up at {at} {unit}, the end of the range: how the motion continues is not \
             proved";
        near_miss(at: &str, unit: &str, sine: &str, group: &str) =
            "almost a change point or dead point at {at} {unit}: the sine of the transmission angle at {group} \
             is {sine}; the motion keeps its assembly";
        transmission_throughout(group: &str, angle: &str) =
            "transmission angle at {group}: {angle} deg throughout";
        transmission_between(group: &str, angles: [&str; 4], unit: &str) = {
            let [minimum, at_least, maximum, at_most] = angles;
            format!(
                "transmission angle at {group}: smallest {minimum} deg, at {at_least} {unit}; largest \
                 {maximum} deg, at {at_most} {unit}"
            )
        };

        // The verdict.
        range_whole = "turns fully";
        range_between(low: &str, high: &str, unit: &str) = "{low}..{high} {unit}";
        stop_in_verdict(name: &str, at: &str) = "stop of {name} at {at}";
        stops_of(names: &[String]) = { format!("stops of {}", names.join(" and ")) };
        some_change_points(count: usize) = { counted(count, "change point", "change points") };
        transmission_worst(group: Option<&str>, off: &str, at: &str, unit: &str) = {
            let group = group.map(|group| format!(" at {group}")).unwrap_or_default();
            format!("transmission{group} {off} deg off 90 at {at} {unit}")
        };
        transmission_off(off: &str) = "{off} off 90";
        nothing_of_it = "none";
        became(old: &str, new: &str) = "{old} -> {new}";

        // Loads.
        count_of_forces(count: usize) = { counted(count, "force", "forces") };
        count_of_torques(count: usize) = { counted(count, "torque", "torques") };
        count_of_presses(count: usize) = { counted(count, "press", "presses") };
        count_of_springs(count: usize) = { counted(count, "spring", "springs") };
        count_of_masses(count: usize) = { counted(count, "link with a mass", "links with a mass") };
        gravity = "gravity";
        repeated_after(what: &str, period: &dyn Display) = "{what}; repeated after {period} deg";
        not_settled(reactions: &str) = "reactions not determined by equilibrium: {reactions}";
    }
}

/// Formats a count with its noun: `no slide`, `1 slide`, `2 slides`.
fn some(count: usize, one: &str) -> String {
    match count {
        0 => format!("no {one}"),
        1 => format!("1 {one}"),
        _ => format!("{count} {one}s"),
    }
}
