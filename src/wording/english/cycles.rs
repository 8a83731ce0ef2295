//! What figures do over the whole motion.

use super::English;

catalogue! {
    /// Strokes, ratios, dwells and rates over a cycle, and why there are none.
    trait CyclesWords for English {
        // Names of such figures.
        no_cycle_figure(name: &str, mend: &str) = "no figure of the cycle is called `{name}`{mend}";
        column_can_be_asked(list: &str) = "; behind the name of a column may stand {list}";

        // Why there is none.
        no_value_at(at: &str) = "it has no value at {at}";
        turns_round = "it turns round";
        never_turns = "it never turns back";
        figure_stands = "it does not move";
        figure_rests = "it rests at an extreme";
        figure_leaps = "it jumps from one extreme to the other";
        there_and_back_alike = "the driver goes there and back by the same way";
        driver_has_no_speed = "the driver stands still";
        driver_does_not_come_round = "the driver turns back before it has gone round";
        no_rate_known = "its rate is no figure of a state";
        rate_unbounded(at: &str) = "it grows beyond all bounds towards {at}";
        figure_jumps(at: &str) = "it jumps at {at}, where a direction in its formula passes a full turn";
        no_limit = "the driver turns fully";
        no_dyad = "no dyad has a transmission angle";
        no_coupled_group = "no group is solved by iteration";
        motion_never_at(at: &str) = "the motion does not come to {at}";

        // The page.
        cycle_goes_round(speed: &str, range: &str) = "{range}; over one period at {speed}";
        cycle_of_range(speed: &str, range: &str) = "{range}; over this range at {speed}";
        cycle_leaves_motion_out =
            "rates and times are those of a driver that keeps this speed, not of its motion over time";
        nothing_to_follow =
            "nothing to follow: no slide, no rocker and no figure of its own; name columns with --columns";
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
        turns_round_times(times: &str) = "turns round {times} times in a period";
        turns_round_once = "turns round once in a period";
        value_at(value: &str, at: &str) = "{value} at {at}";
        peak_at(value: &str, at: &str) = "greatest {value} at {at}";
        dip_at(value: &str, at: &str) = "least {value} at {at}";
        peak_between(value: &str, from: &str, to: &str) = "greatest {value} from {from} to {to}";
        dip_between(value: &str, from: &str, to: &str) = "least {value} from {from} to {to}";
        limit_of_driver(turn: &str) = "{turn}, where the driver turns";
        slow_by_quick(ratio: &str, slow: &str, quick: &str, rises: bool) = {
            let way = if rises { "up" } else { "down" };
            format!("{ratio}: {slow} {way}, {quick} back")
        };
        way_there_and_back(way: &str) = "{way} there and back";
        stays_within(way: &str, from: &str, to: &str, tolerance: &str, of: &str) =
            "{way}: {from} to {to}, within {tolerance} of {of}";
        never_dwells = "nowhere";
        not_there(why: &str) = "none: {why}";
        off_the_best(group: &str, off: &str, least: &str, at: &str) =
            "at {group}: {least} deg, {off} deg off 90, at {at}";
        condition_at(group: &str, least: &str, at: &str) =
            "of the group at {group}: {least} at the worst, at {at}";
    }
}
