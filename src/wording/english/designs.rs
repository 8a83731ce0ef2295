//! Many designs of a scene: what varies, and what is wished.

use super::{English, counted};

catalogue! {
    /// Designs: values that vary, goals, and what came of them.
    trait DesignsWords for English {
        no_axis(text: &str) =
            "`{text}` does not say how a value varies: write `r3.length` (it is free), `r3.length=280..320` or \
             `r3.length=280..320/9` (in 9 places)";
        no_goal(text: &str) =
            "`{text}` is no goal: write a figure, a sign and a number, as `C.x.stroke = 120`, `transmission >= 40` or \
             `r4.angle.swing <= 75`";
        unit_of_goal(figure: &str, unit: &str, found: &str) = {
            match unit {
                "" => format!("{figure} is a plain number, not in {found}: write the number alone"),
                unit => format!("{figure} has the unit {unit}, not {found}: write the number alone, or with a unit of that kind"),
            }
        };

        // Goals and the best.
        to_be_met = "to meet";
        to_be_best = "to be best";
        to_be_kept = "kept";
        designs_found = "found";
        given_design = "given";
        nearest_design = "nearest";
        best_design = "best";
        kind_of_motion = "motion";
        motion_of_design(design: &str, motion: &str) = "{design}: {motion}";
        moves_otherwise = "this design does not move as the given one does";
        greatest_wished(figure: &str) = "the greatest {figure}";
        least_wished(figure: &str) = "the least {figure}";
        none_meets_goals(starts: u32) = {
            format!("no design meets all of that, from {}; the nearest misses it", counted(starts as usize, "start", "starts"))
        };
        no_design_opens(starts: u32) = {
            format!("no design of {} has all of these figures", counted(starts as usize, "start", "starts"))
        };
        one_design_meets(starts: u32) = {
            format!("one design, from {}", counted(starts as usize, "start", "starts"))
        };
        designs_meet(count: usize, shown: usize, starts: u32) = {
            let first = match count > shown {
                true => format!(", the nearest {shown} of them below"),
                false => ", the nearest first".into(),
            };
            format!("{count} designs{first}, from {}", counted(starts as usize, "start", "starts"))
        };
        family_of_designs(freedoms: usize) = {
            let freedoms = counted(freedoms, "freedom", "freedoms");
            format!("of a family with {freedoms}: designs beside these meet the goals too")
        };
        generations_made(generations: u32, settled: bool) = {
            let made = counted(generations as usize, "generation", "generations");
            match settled {
                true => format!("the best of {made}, all of which came to one place"),
                false => format!("the best of {made}; they did not come to one place"),
            }
        };
        polished_best(stationary: bool) = {
            match stationary {
                true => "no small step that keeps all of that betters it",
                false => "whether a small step betters it is not certain",
            }
            .to_owned()
        };
        no_goal_given = "say what is to be met with --goal, or what is to be the best with --minimize or --maximize";
        goals_and_best = "a goal is met, or a figure is the best: give --goal, or --minimize or --maximize with --keep";
        free_without_ends(name: &str) = "`{name}` needs ends here: write `{name}=LOW..HIGH`";
        no_such_design(number: usize, count: usize) = "there is no design {number}: {count} were found";
        given_lacks = "given has no";
        goals_not_met = "no design was found that meets all goals";
        keeps_nothing = "no design was found that keeps all of that";
        start_was_written = "the text alone would open in another assembly: its [start] was written anew";

        // The command.
        does_solve = "Find the numbers of a scene that meet goals, or with which a figure is the best";
        values_to_vary = "Values that vary, as the scene view names them with dots: r3.length, A.x, a parameter; with ends as r3.length=280..320";
        goal_to_meet = "What is to be met: C.x.stroke = 120, r4.angle.swing <= 75, C.x@60 = 310 (krank help designs); as often as there are goals";
        limit_to_keep = "What is to be kept besides, with >=, <= or =: transmission >= 40, r4.angle.swing = 75";
        figure_to_minimize = "The figure that is to be the least, between the ends of the values, with everything kept";
        figure_to_maximize = "The figure that is to be the greatest";
        starts_of_search = "From how many places beside the given one designs are looked for";
        generations_of_search = "For how many generations the best is looked for, at the most";
        seed_of_search = "From which chance follows: the same seed finds the same";
        design_to_write = "Which of the designs is written to -o";
        starts_counted = "starts";
        generations_counted = "generations";
        examples_of_solve = "\
Examples:
  krank solve slider-crank --vary r2.length --goal 'r4.length.stroke = 13'
  krank solve offset-slider-crank --vary r2.length,r4.through.y \\
      --goal 'r4.length.stroke = 120' --goal 'r4.length.ratio = 1.1' \\
      --keep 'transmission >= 40' -o found.toml
  krank solve four-bar --vary r2.length=60..140,r4.length=200..320 \\
      --maximize r4.angle.swing --keep 'transmission >= 45'

Every design is opened in the assembly of the scene, or not at all. Where no design
meets the goals the nearest is told, and the exit code is 1. A search from many
starts proves nothing of designs that it has not found.";
        // What varies.
        value_twice(name: &str) = "{name} varies twice";
        axis_without_ends(name: &str) =
            "{name} has no ends: write {name}=280..320, or {name}=280..320/9 for 9 places";
        hypercube_has_places(name: &str) =
            "{name} has places of its own, but with --latin every value has as many as there are designs: leave the \
             number behind / out";
        too_many_designs(most: &str) = "the grid has more than {most} designs: take fewer places, or --latin";
        no_part(text: &str) = "`{text}` is no part: write 3/64 for the third of 64";
        disk_without_locks(file: &str) =
            "{file}: this disk has no file locks; do not start a second study on it";
        resume_needs_file = "--resume goes on with a file of CSV: name it with -o";
        chart_needs_grid(most: &str) =
            "a chart is of a grid of one or two values, all of its parts, and at most {most} designs";

        // What came of it.
        designs = "designs";
        file_of_other_study(file: &str, line: u64) =
            "{file} is not of this study: line {line} is another one. Leave --resume out to write it anew";
        row_was_changed(file: &str, line: u64) =
            "line {line} of {file} is not what this study writes there: it was changed. Restore it, or leave \
             --resume out to write the file anew";
        file_goes_on(file: &str, done: u64, all: u64) = "{file} has {done} of {all} designs already";
        designs_left_out(open: u64, unreadable: u64, all: u64) =
            "of {all} designs {open} do not assemble as the scene does, and {unreadable} make no scene: their rows say why";
        no_design_has_figures(why: &str) = "no design has any of the figures: {why}";
        has_no_value_in_designs(figure: &str) = "{figure} has no value in any design";
        designs_from_to(figure: &str, least: [&str; 2], greatest: [&str; 2]) = {
            let ([least, low], [greatest, high]) = (least, greatest);
            format!("{figure}: least {least} at {low}; greatest {greatest} at {high}")
        };
        blank_is_no_design = "blank: no value";
        axes_of_map(up: &str, along: &str) = "up: {up}; along: {along}";

        // In the workbench.
        goal = "goal";
        find_values_for_a_goal = "values for a goal";
        goals_are_typed(value: &str) = "C.x.stroke = 120 by {value}";
        goal_not_met(nearest: &str, values: &str) =
            "no design near this one meets that; the nearest has {nearest} ({values})";
        goal_is_met(values: &str) = "{values} meets it";
        goal_needs_opening(why: &str) = {
            match why.is_empty() {
                true => "no design near this one can be told of".to_owned(),
                false => format!("no design near this one can be told of; this one: {why}"),
            }
        };
        looking_for_designs(percent: u32) = "looking for designs: {percent} %";
        design_of(number: usize, count: usize, values: &str) = "{number} of {count}: {values}";
        moves_otherwise_as(motion: &str) = "it moves otherwise: {motion}";
    }
}
