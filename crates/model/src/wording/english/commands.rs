//! Errors and notes of commands.

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
        file_was_mended(name: &dyn Display) = "`{name}`: completed an interrupted save";
        output_is_the_scene =
            "the output file is the input scene, which would be lost: write to another file";
        output_is_read(file: &str) =
            "the output file is the input file `{file}`, which would be lost: write to another file";
        no_pictures =
            "this krank was built without the feature `pictures`; install it with: cargo install --path . \
             --features pictures";
        picture_too_large(width: u32, height: u32) =
            "a picture of {width} x {height} pixels is too large";
        turn_too_large(pictures: usize) = "{pictures} pictures of this size are too many";
        smaller_has_room(why: &str) = "{why}: choose a smaller `--width` or fewer `--seconds`";
        format_takes_no(format: &str, option: &str, others: &str) =
            "`{option}` does not work with `--format {format}`; use {others}";
        no_format_of_extension(extension: &str, known: &str) =
            "no picture has the extension `{extension}`; use {known}, or name the format with `--format`";
        no_text(format: &str) = "{format} is a binary format: write it to a file with `-o FILE`";
        no_workbench(scene: &dyn Display) =
            "this krank was built without the workbench (feature `tui`); print tables with `krank table \
             {scene}`";

        // Suggestions.
        did_you_mean(name: &str) = "did you mean `{name}`?";
        did_you_mean_command(name: &str) = "did you mean the command `{name}`?";
        did_you_mean_preset(name: &str) = "did you mean the preset `{name}`?";
        list_names_presets = "list the presets with `krank list`";
        no_preset_and_no_file(name: &str, mend: &str) = "no preset or file is named `{name}`; {mend}";
        command_comes_first(command: &str) = "put the command first: `krank {command} SCENE`";
        no_such_command(name: &str, meant: &str) =
            "unknown command `{name}`; did you mean the command `{meant}`?";
        one_scene_alone(extra: &str) =
            "unexpected argument `{extra}`: krank opens one scene at a time; list the commands with `krank \
             --help`";
        krank_has_no_command(name: &str) = "unknown command `{name}`";
        no_topic_and_no_command(word: &str, topics: &str) =
            "no topic or command is named `{word}`; the topics are {topics}";
        no_topic_but_near(word: &str, near: &str, topics: &str) =
            "no topic or command is named `{word}`; did you mean `{near}`? the topics are {topics}";
        word_occurs(word: &str) = "no topic or command is named `{word}`; it occurs in:";
        word_occurs_but_near(word: &str, near: &str) =
            "no topic or command is named `{word}`; did you mean `{near}`? it occurs in:";
        html_needs_folder = "`--format html` writes a web site: add `-o DIR`";
        html_has_all_topics(word: &str) = "`--format html` writes all topics: remove `{word}`";
        folder_needs_html = "`-o DIR` needs `--format html`";
        check_names_points = "list the points with `krank check SCENE`";
        no_point(option: &str, name: &str, mend: &str) =
            "{option}: the scene has no point `{name}`; {mend}";
        there_are(names: &str) = "there are {names}";

        // Values of options.
        must_be_positive = "it must be greater than 0";
        must_be_a_number = "it must be a number";
        must_not_be_negative = "it must be a finite number, not negative";
        size_is_meant(largest: &dyn Display) =
            "write columns x rows, such as 80x24, each from 1 to {largest}";
        comma_for_both =
            "--decimal comma and --separator comma cannot be combined: use --separator semicolon";
        for_csv_alone(option: &str) = "{option} needs CSV: add --format csv";

        // The driver and the motion.
        taken_within(typed: &dyn Display, at: &dyn Display, unit: &str, covered: &str) =
            "using {at} {unit} instead of {typed} {unit}: the driver covers {covered}";
        cannot_be_assembled(at: &dyn Display, unit: &str, covered: &str) =
            "the mechanism cannot be assembled at {at} {unit}: the driver covers {covered}";
        stopped_before(at: &dyn Display, unit: &str, name: &str, covered: &str) =
            "the stop of {name} ends the motion before {at} {unit}: the driver covers {covered}";
        table_ends_before(at: &dyn Display, unit: &str, name: &str, covered: &str) =
            "the motion ends before {at} {unit}, with the table of {name}: the driver covers {covered}";
        no_start_tells_assembly = "no start positions identify this assembly where the scene opens, with all links as they are";
        no_finite_limits = "the motion has no finite limits";
        leads_out_of_motion(from: f64, to: f64, covered: &str) =
            "--from {from} --to {to} leaves the motion: the driver covers {covered}";
        must_go_from_one_to_another =
            "--from and --to must be finite and different: the driver moves between them and back";

        // Values.
        too_many_sensitivities(figures: usize, lengths: usize) =
            "--sensitivity: {figures} values by {lengths} lengths are too many: choose fewer with `krank sweep \
             --columns`";
        unproved(some: &dyn Display, figures: &dyn Display) =
            "{some} of {figures} values have no error bound: a dead point or change point is too close, or a \
             formula may be undefined";
        no_arrows = "no arrows: velocities and accelerations do not exist at a dead point";
        no_row_in_motion(covered: &str) =
            "no row of the sweep is within the motion: the driver covers {covered}";
        rows_outside(some: u64, rows: u64, covered: &str) =
            "{some} of {rows} rows are outside the motion and have no values: the driver covers {covered}";
        rows_withheld(some: u64, rows: u64, why: &str) =
            "{some} of {rows} rows have values that are not shown: {why}";
        rows_without_answer(some: u64, rows: u64, what: &str) = "in {some} of {rows} rows {what}";
        figures_without_answer(some: u64, figures: u64) =
            "{some} of {figures} values have no derivatives by the lengths: a formula has a kink or a jump \
             there, or the direction of a zero vector";

        // Plots.
        no_figures_to_plot = "--columns: nothing to plot: name at least one column, such as C.vx or r4.omega";
        too_small_for_plot(columns: u16, rows: u16) =
            "--size: {columns}x{rows} is too small for a plot: use at least 40x12 for one panel";
        panels_without_room(count: usize, columns: u16, rows: u16) =
            "{count} more panels do not fit: show all with --size {columns}x{rows}";
        one_along_x(name: &str, count: usize) =
            "--against: `{name}` names {count} quantities: choose one for the x axis";
        no_way_between(at: f64) = "--from and --to are both {at}: choose two different positions";
        plot_outside(covered: &str) = "no part of the plot is within the motion: the driver covers {covered}";
        plot_partly_outside(covered: &str) =
            "part of the plot is outside the motion: the driver covers {covered}";
        has_no_value_anywhere(name: &str) = "{name} has no value anywhere";

        // The motor.
        peak_less_than_rated(peak: f64, rated: f64) =
            "--peak: {peak} is less than the rated {rated}: give the peak of the motor, at least its rated \
             value";
        fluctuation_above_one(share: f64) =
            "--fluctuation: {share} is above 1: give (maximum - minimum) / mean of the speed; 0.02 is 2 %";
        fluctuation_above_two(share: f64) =
            "--fluctuation: {share} is impossible: at 2 the driver stops once per cycle; 0.02 is 2 %";
        guide_of_ram_moves(name: &str) =
            "--ram: the guide of `{name}` is not on the ground: name a slide whose guide is";
        no_slide_on_ground = "no slide has its guide on the ground";
        no_slide_named(name: &str, mend: &str) = "--ram: no slide is named `{name}`; {mend}";
        no_ram(why: &dyn Display) = "no ram: {why}; name one with --ram";
        nothing_acts_on_it = "the scene has no loads, springs or masses: add [[loads]], or `mass` to a link";
        no_believable_integrals = "the integrals of the driver's effort do not converge over this cycle";

        // Progress.
        parts = "parts";
        rows = "rows";
        best_so_far(value: &str) = "best {value}";
        done_of(done: &str, total: &str, what: &str) = "{done} of {total} {what}";
        seconds_left(seconds: f64) = "{seconds} s left";
        minutes_left(minutes: f64, seconds: f64) = "{minutes} min {seconds} s left";
        hours_left(hours: f64, minutes: f64) = "{hours} h {minutes} min left";

        // The version.
        build_details(features: &str, target: &str, profile: &str, licence: &str) =
            "features  {features}\ntarget    {target}\nprofile   {profile}\nlicence   {licence}";

        // The contents of the manual.
        topics_heading = "Topics: krank help TOPIC";
        keys_heading = "Keys of the workbench: krank help keys";
        columns_heading = "Columns: krank help columns";
        commands_heading = "Commands: krank help COMMAND";
        help_of_workbench = "The workbench and its options: `krank --help`.";
    }
}
