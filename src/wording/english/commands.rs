//! Commands on the command line: what they cannot do, and what a reader of their results should know.

use super::English;
use std::fmt::Display;

catalogue! {
    /// Messages of commands.
    trait CommandsWords for English {
        error(message: &str) = "error: {message}";
        note(message: &str) = "note: {message}";
        of_option(option: &str, what: &dyn Display) = "{option}: {what}";

        of_parser(text: &str) = "{text}";

        // Files and results.
        cannot_read(name: &str, why: &dyn Display) = "cannot read {name}: {why}";
        standard_input = "standard input";
        cannot_write_results(why: &dyn Display) = "cannot write the results: {why}";
        cannot_write(name: &dyn Display, why: &dyn Display) = "cannot write `{name}`: {why}";
        file_was_mended(name: &dyn Display) =
            "`{name}` was cut off while it was written, and is whole again";
        output_is_the_scene =
            "the output is the scene that is read: it would be lost; write to another file";
        output_is_read(file: &str) =
            "the output is `{file}`, which is read: it would be lost; write to another file";
        no_pictures =
            "this krank was built without pictures (the feature `pictures`); to have them: \
             cargo install --path . --features pictures";
        #[cfg(feature = "pictures")]
        picture_too_large(width: u32, height: u32) =
            "a picture of {width} x {height} pixels is too large";
        #[cfg(feature = "pictures")]
        turn_too_large(pictures: usize) =
            "{pictures} pictures of that size are too many";
        #[cfg(feature = "pictures")]
        smaller_has_room(why: &str) = "{why}; a smaller `--width` or fewer `--seconds` have room";
        format_takes_no(format: &str, option: &str, others: &str) =
            "a drawing as {format} takes no `{option}`: that is for {others}";
        no_text(format: &str) =
            "a {format} is no text that a terminal shows; `-o FILE` writes it to a file";
        #[cfg(not(feature = "tui"))]
        no_workbench(scene: &dyn Display) =
            "this krank was built without the workbench (the feature `tui`); `krank table {scene}` \
             prints the tables";

        // What was meant.
        did_you_mean(name: &str) = "did you mean `{name}`?";
        did_you_mean_command(name: &str) = "did you mean the command `{name}`?";
        did_you_mean_preset(name: &str) = "did you mean the preset `{name}`?";
        list_names_presets = "`krank list` names the presets";
        no_preset_and_no_file(name: &str, mend: &str) = "there is no preset and no file `{name}`; {mend}";
        command_comes_first(command: &str) = "the command comes first: `krank {command} SCENE`";
        no_such_command(name: &str, meant: &str) =
            "there is no command `{name}`; did you mean the command `{meant}`?";
        one_scene_alone(extra: &str) =
            "`{extra}` is too much: krank opens one scene, and `krank --help` names its commands";
        krank_has_no_command(name: &str) = "krank has no command `{name}`";
        no_topic_and_no_command(word: &str, topics: &str) =
            "there is no topic and no command `{word}`; the topics are {topics}";
        no_topic_but_near(word: &str, near: &str, topics: &str) =
            "there is no topic and no command `{word}`; did you mean `{near}`? the topics are {topics}";
        check_names_points = "`krank check SCENE` names the points";
        no_point(option: &str, name: &str, mend: &str) =
            "{option}: the scene has no point `{name}`; {mend}";
        there_are(names: &str) = "there are {names}";

        // Values of options.
        must_be_positive = "it must be greater than 0";
        must_be_a_number = "it must be a number";
        must_not_be_negative = "it must be a finite number that is not negative";
        size_is_meant(largest: &dyn Display) =
            "columns x rows are meant, such as 80x24, each 1 to {largest}";
        comma_for_both =
            "--decimal comma with --separator comma: a comma cannot be both; --separator semicolon \
             keeps them apart";
        for_csv_alone(option: &str) = "{option} is for CSV alone: add --format csv";

        // The driver and the motion.
        taken_within(typed: &dyn Display, at: &dyn Display, unit: &str, covered: &str) =
            "{typed} {unit} is taken as {at} {unit}: the driver covers {covered}";
        cannot_be_assembled(at: &dyn Display, unit: &str, covered: &str) =
            "the mechanism cannot be assembled at {at} {unit}: the driver covers {covered}";
        stopped_before(at: &dyn Display, unit: &str, name: &str, covered: &str) =
            "a stop of {name} ends the motion before {at} {unit}: the driver covers {covered}";
        table_ends_before(at: &dyn Display, unit: &str, name: &str, covered: &str) =
            "the table of {name} ends, and the motion with it, before {at} {unit}: the driver covers {covered}";
        no_start_tells_assembly =
            "no start positions tell this assembly from the others where the scene opens";
        no_finite_limits = "the motion has no finite limits";
        leads_out_of_motion(from: f64, to: f64, covered: &str) =
            "--from {from} --to {to} leads out of the motion: the driver covers {covered}";
        must_go_from_one_to_another =
            "--from and --to must be finite and differ: the driver goes from one to the other and back";

        // Figures.
        too_many_sensitivities(figures: usize, lengths: usize) =
            "--sensitivity: {figures} figures by {lengths} lengths are too many; `krank sweep \
             --columns` names fewer";
        unproved(some: &dyn Display, figures: &dyn Display) =
            "{some} of {figures} figures have no bound: too close to a dead point or a change point \
             for a proof, or by a formula where a figure may not exist";
        no_arrows = "there are no arrows: at a dead point there are no rates";
        no_row_in_motion(covered: &str) =
            "no row of the sweep lies within the motion: the driver covers {covered}";
        rows_outside(some: u64, rows: u64, covered: &str) =
            "{some} of {rows} rows lie outside the motion and have no values: the driver covers {covered}";
        rows_withheld(some: u64, rows: u64, why: &str) =
            "in {some} of {rows} rows figures are withheld; {why}";
        rows_without_answer(some: u64, rows: u64, what: &str) = "in {some} of {rows} rows {what}";
        figures_without_answer(some: u64, figures: u64) =
            "{some} of {figures} figures have no derivatives by the lengths: within rounding a formula \
             turns over there and its sides answer differently, or a direction is one of nothing";

        // Plots.
        no_figures_to_plot =
            "--columns: these are no figures to plot; C.vx or r4.omega would be";
        too_small_for_plot(columns: u16, rows: u16) =
            "--size: {columns}x{rows} is too small for a plot; 40x12 is enough for one panel";
        panels_without_room(count: usize, columns: u16, rows: u16) =
            "{count} more panels have no room: --size {columns}x{rows} shows all";
        one_along_x(name: &str, count: usize) =
            "--against: `{name}` names {count} figures, and one stands along x";
        no_way_between(at: f64) = "--from and --to are both {at}: there is no way between to plot over";
        plot_outside(covered: &str) =
            "no place of the plot lies within the motion: the driver covers {covered}";
        plot_partly_outside(covered: &str) =
            "a part of the plot lies outside the motion: the driver covers {covered}";
        has_no_value_anywhere(name: &str) = "{name} has no value anywhere";

        // The motor.
        peak_less_than_rated(peak: f64, rated: f64) =
            "--peak: {peak} is less than the rated {rated}; the peak is what the motor gives for a \
             short while, at least as much as without end";
        fluctuation_above_one(share: f64) =
            "--fluctuation: {share} is above 1; it is (greatest - least) / mean of the speed: 0.02 \
             is 2 %";
        fluctuation_above_two(share: f64) =
            "--fluctuation: {share} is impossible: at 2 the driver stands still once a cycle; 0.02 is 2 %";
        guide_of_ram_moves(name: &str) = "--ram: the guide of `{name}` is not on the ground; a ram's is";
        no_slide_on_ground = "no slide has its guide on the ground";
        no_slide_named(name: &str, mend: &str) = "--ram: no slide is named `{name}`; {mend}";
        no_ram(why: &dyn Display) = "no ram: {why}; --ram names one";
        nothing_acts_on_it =
            "nothing acts on the mechanism: it has no load, spring or mass; [[loads]] in the scene, \
             or `mass` of a link, would";
        no_believable_integrals =
            "what the driver must do has no integrals that can be believed over this cycle";

        // How far a command has come.
        parts = "parts";
        rows = "rows";
        best_so_far(value: &str) = "best {value}";
        done_of(done: &str, total: &str, what: &str) = "{done} of {total} {what}";
        seconds_left(seconds: f64) = "{seconds} s left";
        minutes_left(minutes: f64, seconds: f64) = "{minutes} min {seconds} s left";
        hours_left(hours: f64, minutes: f64) = "{hours} h {minutes} min left";

        // The contents of the manual.
        topics_heading = "Topics: krank help TOPIC";
        commands_heading = "Commands: krank help COMMAND";
        help_of_workbench = "`krank --help` tells of the workbench and its options.";
    }
}
