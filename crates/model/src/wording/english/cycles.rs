//! Quantities over the whole motion.

use super::English;

catalogue! {
    /// Strokes, ratios, dwells and rates over a cycle, and reasons for missing ones.
    trait CyclesWords for English {
        // Names.
        no_cycle_figure(name: &str, mend: &str) = "no quantity over the cycle is named `{name}`{mend}";
        column_can_be_asked(list: &str) = "; append one of {list} to the name of a column";

        // Reasons for missing values.
        no_value_at(at: &str) = "it has no value at {at}";
        turns_round = "it turns fully";
        never_turns = "it never turns back";
        figure_stands = "it does not move";
        figure_rests = "it dwells at an extreme";
        figure_leaps = "it jumps from one extreme to the other";
        there_and_back_alike = "the driver moves back and forth on the same path";
        driver_has_no_speed = "the driver has no speed";
        driver_does_not_come_round = "the driver reverses before a full turn";
        no_rate_known = "its rate is not known";
        rate_unbounded(at: &str) = "it is unbounded near {at}";
        figure_jumps(at: &str) = "it jumps at {at}: a direction in its formula wraps around at a full turn";
        no_limit = "the driver turns fully";
        no_dyad = "no dyad has a transmission angle";
        no_coupled_group = "no group is solved by iteration";
        motion_never_at(at: &str) = "the motion does not reach {at}";

        // The page.
        cycle_goes_round(speed: &str, range: &str) = "{range}; one period at {speed}";
        cycle_of_range(speed: &str, range: &str) = "{range}; this range at {speed}";
        cycle_leaves_motion_out =
            "rates and times are for a driver at this constant speed, not for its motion over time";
        nothing_to_follow = "the scene has no slide, no rocker and no [figures] to report: name columns with --columns";
        label_stroke = "stroke";
        label_swing = "swing";
        label_turns = "turns";
        label_ratio = "time ratio";
        label_dwells = "dwells";
        label_fastest = "fastest";
        label_hardest = "hardest";
        label_transmission = "angle";
        label_condition = "condition";
        mechanism_as_a_whole = "mechanism";
        stays_at(value: &str) = "stays at {value}";
        turns_round_times(times: &str) = "turns {times} times per period";
        turns_round_once = "turns once per period";
        value_at(value: &str, at: &str) = "{value} at {at}";
        peak_at(value: &str, at: &str) = "maximum {value} at {at}";
        dip_at(value: &str, at: &str) = "minimum {value} at {at}";
        peak_between(value: &str, from: &str, to: &str) = "maximum {value} from {from} to {to}";
        dip_between(value: &str, from: &str, to: &str) = "minimum {value} from {from} to {to}";
        limit_of_driver(turn: &str) = "{turn}, where the driver reverses";
        slow_by_quick(ratio: &str, slow: &str, quick: &str, rises: bool) = {
            let way = if rises { "up" } else { "down" };
            format!("{ratio}: {slow} {way}, {quick} back")
        };
        way_there_and_back(way: &str) = "{way} there and back";
        stays_within(way: &str, from: &str, to: &str, tolerance: &str, of: &str) =
            "{way}: {from} to {to}, within {tolerance} of {of}";
        never_dwells = "none";
        not_there(why: &str) = "none: {why}";
        off_the_best(group: &str, off: &str, least: &str, at: &str) =
            "at {group}: {least} deg, {off} deg off 90, at {at}";
        condition_at(group: &str, least: &str, at: &str) = "group at {group}: {least} at worst, at {at}";
    }
}
