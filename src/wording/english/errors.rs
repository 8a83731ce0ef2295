//! Errors of the library that a person is told as they are.

use super::English;
use std::fmt::Display;

catalogue! {
    /// Why something cannot be read, drawn or opened.
    trait ErrorsWords for English {
        // The terminal.
        output_is_no_terminal =
            "standard output is no terminal, and the workbench needs one; `krank table SCENE` prints \
             the tables";
        no_keys_to_read =
            "there is no terminal to read keys from, and the workbench needs one; `krank table SCENE` \
             prints the tables";
        terminal_is_dumb =
            "TERM=dumb cannot show the workbench; `krank table SCENE` prints the tables";
        terminal_failed(why: &dyn Display) = "the terminal failed: {why}";
        krank_is_broken(what: &str) = "krank is broken: {what}";

        // Figures and their rows.
        no_time_passes =
            "the scene gives its driver no speed, so no time passes: give the driver a speed";
        driver_turns_back(at: f64) = "the driver turns back before it comes to {at}";
        no_quantity(pattern: &str, mend: &str) = "no quantity is named `{pattern}`{mend}";
        nothing_acts_on_scene = "; nothing acts on this scene: it has no loads, springs or masses";
        option_puts_behind(name: &str, option: &str, kind: &str) =
            "; name `{name}`, and {option} puts `{name}.{kind}` behind it";
        or_meant(mend: &str) = "; {mend}";
        not_a_decimal = "must be a number, such as 60 or -0.5";
        decimal_not_finite = "must be a finite number";
        step_is_zero = "the step must not be 0";
        step_leads_away(step: f64, from: f64, to: f64, other: f64) =
            "a step of {step} never leads from {from} to {to}; a step of {other} does";
        sweep_too_long(from: f64, to: f64, step: f64) =
            "a sweep from {from} to {to} by {step} has more than 10^9 rows; take a larger step";

        // Assemblies.
        how_wishes_are_written = "write NAME=+ or NAME=-, and for a coupled group NAME=NUMBER";
        no_group_with_choice(name: &str, mend: &str) = "`{name}` names no group with a choice; {mend}";
        chosen_by(name: &str, options: &str) = "`{name}` is chosen by {options}";
        group_given_twice(name: &str) = "`{name}` is given twice";
        chosen_by_number(name: &str) =
            "a number, `{name}=1`: it is a coupled group, and `krank check` lists its assemblies";
        chosen_by_sign(name: &str) = "its sign, `{name}=+` or `{name}=-`: it is a dyad";
        no_group_in_scene = "there is none in this scene";
        the_only_group(one: &str) = "the only one is {one}";
        there_are_and_more(names: &str, more: usize) = "there are {names} and {more} more";

        // Values that are typed.
        no_number_typed(typed: &str, units: &str) = {
            match units {
                "" => format!("no number: {typed}; type one"),
                units => format!("no number: {typed}; type one, alone or with a unit: {units}"),
            }
        };
        unit_does_not_fit(unit: &str, units: &str) = {
            match units {
                "" => format!("{unit} does not fit here: this is a plain number"),
                units => format!("{unit} does not fit here: {units}"),
            }
        };
        typed_two_marks(typed: &str) = "{typed}: write digits without groups: 1234.5 or 1234,5";
        typed_too_large(typed: &str) = "too large: {typed}";
        no_speed_of_driver(typed: &str, units: &str) =
            "`{typed}` is no speed of this driver: a number with one of {units}";
    }
}
