//! Errors of the library shown to the user.

use super::English;
use std::fmt::Display;

catalogue! {
    /// Errors of reading, drawing and opening.
    trait ErrorsWords for English {
        // The terminal.
        output_is_no_terminal =
            "standard output is not a terminal, but the workbench needs one: print tables with `krank table \
             SCENE`";
        no_keys_to_read =
            "there is no terminal to read keys from, but the workbench needs one: print tables with `krank \
             table SCENE`";
        terminal_is_dumb = "TERM=dumb cannot show the workbench: print tables with `krank table SCENE`";
        terminal_failed(why: &dyn Display) = "the terminal failed: {why}";
        krank_is_broken(what: &str) = "internal error: {what}; please report it";

        // Quantities and sweeps.
        no_time_passes = "the driver has no speed, so there is no time: give the driver a speed";
        driver_turns_back(at: f64) = "the driver reverses before it reaches {at}";
        no_quantity(pattern: &str, mend: &str) = "no quantity is named `{pattern}`{mend}";
        nothing_acts_on_scene = "; this scene has no loads, springs or masses";
        option_puts_behind(name: &str, option: &str, kind: &str) =
            "; name `{name}`: {option} adds `{name}.{kind}`";
        or_meant(mend: &str) = "; {mend}";
        not_a_decimal = "must be a number, such as 60 or -0.5";
        decimal_not_finite = "must be a finite number";
        step_is_zero = "the step must not be 0";
        step_leads_away(step: f64, from: f64, to: f64, other: f64) =
            "a step of {step} does not lead from {from} to {to}: use {other}";
        sweep_too_long(from: f64, to: f64, step: f64) =
            "a sweep from {from} to {to} by {step} has more than 10^9 rows: use a larger step";

        // Assemblies.
        how_wishes_are_written = "write NAME=+ or NAME=-, and for a coupled group NAME=NUMBER";
        no_group_with_choice(name: &str, mend: &str) = "no group `{name}` has a choice of assemblies; {mend}";
        chosen_by(name: &str, options: &str) = "`{name}` needs {options}";
        group_given_twice(name: &str) = "`{name}` is given twice";
        chosen_by_number(name: &str) =
            "a number, such as `{name}=1`: it is a coupled group; list its assemblies with `krank check`";
        chosen_by_sign(name: &str) = "a sign, `{name}=+` or `{name}=-`: it is a dyad";
        no_group_in_scene = "this scene has none";
        the_only_group(one: &str) = "the only one is {one}";
        there_are_and_more(names: &str, more: usize) = "there are {names} and {more} more";

        // Typed values.
        no_number_typed(typed: &str, units: &str) = {
            match units {
                "" => format!("not a number: {typed}; type one"),
                units => format!("not a number: {typed}; type one, plain or in {units}"),
            }
        };
        unit_does_not_fit(unit: &str, units: &str) = {
            match units {
                "" => format!("{unit} does not fit here: leave out the unit"),
                units => format!("{unit} does not fit here: {units}"),
            }
        };
        typed_two_marks(typed: &str) = "{typed}: leave out the thousands separator: 1234.5 or 1234,5";
        typed_too_large(typed: &str) = "too large: {typed}";
        no_speed_of_driver(typed: &str, units: &str) =
            "`{typed}` is not a speed of this driver: write a number with one of {units}";
    }
}
