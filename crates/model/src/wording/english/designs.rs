//! Studies of many designs of a scene: ranges, goals and results.

use super::{English, counted};

catalogue! {
    /// Ranges of values, goals and results.
    trait DesignsWords for English {
        no_axis(text: &str) =
            "`{text}` is not a valid range: write `r3.length` (free), `r3.length=280..320` or \
             `r3.length=280..320/9` (9 values)";
        no_goal(text: &str) =
            "`{text}` is not a goal: write a quantity, a sign and a number, such as `C.x.stroke = 120`, \
             `transmission >= 40` or `r4.angle.swing <= 75`";
        unit_of_goal(figure: &str, unit: &str, found: &str) = {
            match unit {
                "" => format!("{figure} has no unit, not {found}: write the number alone"),
                unit => format!("{figure} has the unit {unit}, not {found}: write the number alone, or with a unit of this kind"),
            }
        };

        // Goals and optimization.
        to_be_met = "goals";
        to_be_best = "optimize";
        to_be_kept = "keep";
        designs_found = "found";
        given_design = "given";
        nearest_design = "nearest";
        best_design = "best";
        kind_of_motion = "motion";
        motion_of_design(design: &str, motion: &str) = "{design}: {motion}";
        moves_otherwise = "this design moves differently from the given one";
        greatest_wished(figure: &str) = "maximum {figure}";
        least_wished(figure: &str) = "minimum {figure}";
        none_meets_goals(starts: u32) = {
            format!("no design meets all goals, from {}; the nearest is shown", counted(starts as usize, "start", "starts"))
        };
        no_design_opens(starts: u32) = {
            format!("no design from {} has all of these values", counted(starts as usize, "start", "starts"))
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
            let freedoms = counted(freedoms, "degree of freedom", "degrees of freedom");
            format!("one of a family with {freedoms}: nearby designs also meet the goals")
        };
        generations_made(generations: u32, settled: bool) = {
            let made = counted(generations as usize, "generation", "generations");
            match settled {
                true => format!("best of {made}; the search converged"),
                false => format!("best of {made}; the search did not converge"),
            }
        };
        polished_best(stationary: bool) = {
            match stationary {
                true => "no small change within the limits improves it",
                false => "it is not certain that no small change improves it",
            }
            .to_owned()
        };
        no_goal_given = "nothing to solve for: give --goal, --minimize or --maximize";
        goals_and_best = "--goal cannot be combined with --minimize or --maximize: write limits with --keep";
        free_without_ends(name: &str) = "`{name}` needs limits here: write `{name}=LOW..HIGH`";
        no_such_design(number: usize, count: usize) = "no design {number}: only {count} were found";
        given_lacks = "given lacks";
        goals_not_met = "no design meets all goals";
        keeps_nothing = "no design meets all limits";
        value_misses_limits(value: &str) = "{value}, limits not met";
        start_was_written = "wrote a new [start]: without it the scene would open in another assembly";

        // The command.
        does_solve = "Find values of a scene that meet goals, or that minimize or maximize a quantity";
        values_to_vary =
            "Values to vary, named as in the scene view with dots: r3.length, A.x, a parameter; with limits: \
             r3.length=280..320";
        goal_to_meet =
            "A goal to meet: C.x.stroke = 120, r4.angle.swing <= 75, C.x@60 = 310 (krank help designs); may be \
             repeated";
        limit_to_keep =
            "A limit to keep, with >=, <= or =: transmission >= 40, r4.angle.swing = 75; may be repeated";
        figure_to_minimize = "The quantity to minimize within the limits";
        figure_to_maximize = "The quantity to maximize within the limits";
        starts_of_search = "Number of random starts in addition to the given design";
        generations_of_search = "Maximum number of generations of the search";
        seed_of_search = "Seed of the random numbers: the same seed finds the same designs";
        design_to_write = "Number of the design to write to -o";
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

Every design keeps the assembly of the scene. If no design meets the goals, krank
prints the nearest one and the exit code is 1. A search from many starts does not
prove that there are no other designs.";
        // Ranges.
        value_twice(name: &str) = "{name} is given twice: name each value once";
        axis_without_ends(name: &str) =
            "{name} has no limits: write {name}=280..320, or {name}=280..320/9 for 9 values";
        hypercube_has_places(name: &str) =
            "{name} has its own number of values, but with --latin each value has as many as there are designs: \
             remove / and the number";
        too_many_designs(most: &str) = "the grid has more than {most} designs: use fewer values, or --latin";
        no_part(text: &str) = "`{text}` is not a part: write 3/64 for the third of 64";
        disk_without_locks(file: &str) =
            "{file}: this disk has no file locks; do not start a second study with this file";
        resume_needs_file = "--resume needs a CSV file: name it with -o";
        chart_needs_grid(most: &str) =
            "a chart needs a grid of one or two values with all parts, and at most {most} designs";

        // Results.
        designs = "designs";
        file_of_other_study(file: &str, line: u64) =
            "{file} belongs to another study: line {line} differs. Leave out --resume to write the file anew";
        row_was_changed(file: &str, line: u64) =
            "line {line} of {file} was changed after this study wrote it. Restore it, or leave out --resume to \
             write the file anew";
        file_goes_on(file: &str, done: u64, all: u64) = "{file} already has {done} of {all} designs";
        designs_left_out(open: u64, unreadable: u64, all: u64) =
            "{open} of {all} designs cannot be assembled like the scene, and {unreadable} are not valid scenes: \
             their rows say why";
        no_design_has_figures(why: &str) = "none of the values exists in any design: {why}";
        has_no_value_in_designs(figure: &str) = "{figure} has no value in any design";
        designs_from_to(figure: &str, minimum: [&str; 2], maximum: [&str; 2]) = {
            let ([minimum, low], [maximum, high]) = (minimum, maximum);
            format!("{figure}: minimum {minimum} at {low}; maximum {maximum} at {high}")
        };
        blank_is_no_design = "blank: no value";
        axes_of_map(up: &str, along: &str) = "up: {up}; along: {along}";

        // In the workbench.
        goal = "goal";
        find_values_for_a_goal = "values for a goal";
        goals_are_typed(value: &str) = "C.x.stroke = 120 by {value}";
        goal_not_met(nearest: &str, values: &str) =
            "no nearby design meets it; the nearest has {nearest} ({values})";
        goal_is_met(values: &str) = "{values} meets it";
        goal_needs_opening(why: &str) = {
            match why.is_empty() {
                true => "no nearby design can be evaluated".to_owned(),
                false => format!("no nearby design can be evaluated; this one: {why}"),
            }
        };
        looking_for_designs(percent: u32) = "searching for designs: {percent} %";
        design_of(number: usize, count: usize, values: &str) = "{number} of {count}: {values}";
        moves_otherwise_as(motion: &str) = "it moves differently: {motion}";
    }
}
