//! Tasks: descriptions of desired motions.

use super::{English, counted};

catalogue! {
    /// Errors in task files, and results of tasks.
    trait TasksWords for English {
        the_task_itself = "the task itself";
        task_for_a_scene = "this is a task, not a scene";
        synthesize_does_tasks = "run `krank synthesize` to find linkages for it: each becomes a scene";
        scene_for_a_task = "this is a scene, not a task";
        synthesize_reads_tasks =
            "a task describes a desired motion (krank help synthesis); `krank check` and `krank FILE` open scenes";
        task_without_kind = "the task has no `kind`";
        these_are_known(words: &str) = "use one of `{words}`";
        not_known_here = "unknown";
        no_kind_of_task(kind: &str) = "{kind} is not a kind of task";
        key_of_another_kind(key: &str, kind: &str) = "`{key}` does not belong to a task of the kind `{kind}`";
        belongs_to_another_kind = "of another kind of task";
        no_form_of_linkage(form: &str) = "{form} is not a supported linkage";
        no_linkage_wanted = "`linkages` is empty";
        item_of(number: usize, key: &str) = "number {number} of `{key}`";
        must_be_row(what: &str, form: &str, count: usize) = "{what} must be {form}, not a list of {count}";
        task_lacks(of: &str, key: &str) = "`{of}` lacks `{key}`";
        told_twice(first: usize, again: usize) = "number {again} repeats number {first}";
        the_same_again = "repeated here";
        first_told_here = "first given here";
        take_out_one_pose = "remove one of them: a repeated pose is not a further pose";
        take_out_one_point = "remove one of them, or write `closed = true` if the path returns to its first point";
        count_of_poses(count: usize) = "a task of poses has 3 to 5 of them, not {count}";
        poses_that_methods_take =
            "three poses leave much freedom, four leave curves of solutions, five leave a few linkages";
        too_much_given(poses: usize, given: usize) = {
            let given = counted(given, "given pivot or pin", "given pivots and pins");
            format!("{poses} poses do not allow {given}")
        };
        one_too_many = "one too many";
        what_poses_leave_free = "give at most two pivots and pins with three poses, and none with more";
        take_out_last_point = "remove the last one: with `closed = true` the path returns to its first point";
        slider_crank_has_one_pivot = "a slider-crank has one pivot on the ground, the crank's";
        slider_cranks_alone = "only slider-cranks are searched for";
        take_out_one_pivot = "give one pivot, or add \"four-bar\" to `linkages`";
        count_of_points(count: usize, maximum: usize) = "a path has 2 to {maximum} points, not {count}";
        more_than_two_pivots = "a four-bar has two pivots";
        weights_are_positive = "every weight must be more than 0";
        one_for_each_point(key: &str, points: usize, found: usize) = "`{key}` has {found} numbers for {points} points";
        turns_begin_at_nought = "`turns` count from the first point: the first must be 0";
        turns_go_one_way = "`turns` must increase from point to point, or decrease";
        links_have_their_own_ends = "two links with the same end are one: give two different points";
        turns_end_within_one =
            "on a closed path all `turns` must lie within one turn: the last point is followed by the first";
        direction_wants_order = "`order = false` and a `direction` contradict each other: remove one of the two";
        one_output = "a function has one output: name one of `linkages`";
        angle_below_90 = "at least 0 and below 90";
        at_least_1 = "at least 1";
        inside_is_a_box = "`inside` must be two opposite corners of a box";
        no_turning_direction(name: &str) = "{name} is not a direction of rotation";
        given_pivot_outside = "a given pivot lies outside the box for pivots";
        outside_the_box = "outside `inside`";
        widen_the_box = "enlarge `inside`, or remove one of the two";
        turns_against_direction =
            "`turns` and `direction` have opposite senses: change the sign of `turns`, or the preference";
        crank_against_direction =
            "the crank's `swing` or `scale` (counter-clockwise by default) and `direction` have opposite senses: \
             change the sign, or the preference";
        pivot_of_function_outside(place: &str) = "a function's pivot at {place} lies outside the box for pivots";
        widen_for_function =
            "the crank's pivot is at [0, 0], the other one of a four-bar at [size, 0]: enlarge `inside`, or remove \
             it";
        pairs_and_function = "pairs are given by both `pairs` and `function`: remove one";
        positive_number = "a positive number";
        count_of_pairs(count: usize, maximum: usize) = "a function has 3 to {maximum} pairs, not {count}";
        pairs_not_in_order(number: usize) = "the x of pair {number} is not larger than that of the pair before it";
        not_further_on = "x does not increase";
        pairs_by_growing_x = "sort the pairs by increasing x, each x once";
        range_of_function(maximum: usize) = "`function` must go from a smaller x to a larger one, in 3 to {maximum} points";
        swing_and_scale = "`swing` and `scale` mean the same: give one of them";
        start_wants_scale = "`start` belongs to the smallest x: give a `scale` or a `swing` with it";
        scale_is_nought = "`scale` must not be 0";
        output_stands_still(y: &str) = "y is {y} at every x: the output would not move";
        let_y_change = "write a function, or pairs, in which y changes; a dwell can only be part of a function";

        // Results of a task.
        wanted_motion = "wanted";
        poses_wanted(count: usize) = "a body in {count} poses";
        pairs_wanted(count: usize) = "a function through {count} pairs";
        points_wanted(count: usize, closed: bool) = {
            let form = if closed { "a closed path" } else { "a path" };
            format!("{form} through {count} points")
        };
        candidates_found(good: usize, told: usize, defective: usize, complete: bool, reason: &str) = {
            let maximum = match good > told {
                true => format!(", the best {told} listed below"),
                false => String::new(),
            };
            let others = match defective {
                0 => String::new(),
                1 if good == 0 => "; one defective".into(),
                count if good == 0 => format!("; {count} defective"),
                1 => "; one more defective".into(),
                count => format!("; {count} more defective"),
            };
            let proof = match (complete, reason) {
                (true, "") => "; there are no others".into(),
                (true, reason) => format!("; there are no others: {reason}"),
                (false, "") => "; found by a search, so others may exist".into(),
                (false, reason) => format!("; {reason}"),
            };
            let good = counted(good, "linkage for the task", "linkages for the task");
            format!("{good}{maximum}{others}{proof}")
        };
        poses_out_of_range =
            "the coordinates are too large or too small to compute with: write the task in another unit";
        poses_turn_about(x: &str, y: &str) =
            "all poses are rotations about one point, ({x}, {y}): a pivot there guides the body, and no linkage \
             does";
        poses_only_shift =
            "the body does not rotate, and no circle on which equal links could guide it contains its positions";
        given_leads_nowhere = "no link or slide fits the given values in all poses";
        no_pair_of_dyads = "no two of the links and slides through these poses form such a linkage";
        dyads_out_of_reach =
            "the links and slides through these poses are too far away, or their lengths are out of proportion";
        poses_nearly_repeat = "some poses nearly coincide: their rounding leaves open whether there are others";
        head_transmission = "transm.";
        head_miss = "miss";
        head_turns = "crank";
        head_lacks = "unmet";
        turns_fully_shortly = "turns";
        swings_shortly = "swings";
        defective_ones = "defective";
        stands_in_dead_point = "it cannot be opened at the first point, which is a dead point";
        branch_between(from: usize, to: usize) = "branch: a dead point lies between points {from} and {to}";
        circuit_between(from: usize, to: usize) =
            "circuit: points {from} and {to} lie on different circuits, it would have to be reassembled between \
             them";
        order_between(from: usize, to: usize) = "order: the crank turns back from point {from} to {to}";
        short_of_range = "it reaches every pair, but does not close over the whole range";
        misses_its_function =
            "structural error: its deviation from the function is above a tenth of the output's swing (rms)";
        structural_error = "structural error of 1";
        point_missed(point: usize) = "it does not reach point {point}";
        point_far_off(point: usize) = "far off: it passes point {point} at more than 5 % of the path's size";
        candidate_called(task: &str, number: usize) = "{task}, candidate {number}";
        candidate_made_by(task: &str) = "krank synthesize, from the task: {task}";
        driven_as_written(miss: &str, unit: &str) =
            "As written by krank synthesize, it was driven through its task: its largest error is {miss} {unit}.";
        transmission_as_written(way: &str, whole: &str) = {
            match way == whole {
                true => format!("The transmission angle is at least {way} deg, in the task and elsewhere."),
                false => format!(
                    "The transmission angle is at least {way} deg in the task; over the whole motion, as in `krank \
                     check` and in goals, {whole} deg."
                ),
            }
        };
        solved_with_goals(vary: &str) = "  krank solve SCENE --vary {vary} \\";
        kept_by_goals = "To change numbers and keep the task, use these goals:";

        // The list of results.
        linkages = "linkages";
        linkages_for(task: &str) = "Linkages for {task}";
        good_and_defective(good: usize, defective: usize) = {
            match defective {
                0 => format!("{good} found"),
                _ => format!("{good} found, {defective} defective"),
            }
        };
        looking_for_linkages(percent: u32) = "searching for linkages: {percent} %";
        at_point_of_task(point: usize, points: usize, crank: &str) =
            "point {point} of {points}, crank at {crank} deg";
        point_by_point = "from point to point";
        dyads_walked(dyad: usize, dyads: usize, curve: usize, curves: usize) =
            "Pivot and pin {dyad} of {dyads} on curve {curve} of {curves}";
        pin_on_pivot(pivot: &str, pin: &str, link: &str, unit: &str) =
            "pivot at {pivot}, pin at {pin}, link {link} {unit}";
        pin_on_slide(angle: &str, pin: &str, unit: &str) = "slide at {angle} deg, pin at {pin} {unit}";
        dyad_picked(dyad: &str) = "with the {dyad}";
        pick_the_second = "Enter selects it; two of them form a linkage.";
        dyads_make_nothing = "These two do not form a linkage.";
        transmission_on_the_way(angle: &str) = "transmission {angle} deg";
        dotted_curves = "Dotted: possible pivots, and their pins in the first pose.";
        walk = "walk";
        next_curve = "next curve";
        curves_of_dyads = "curves";
        linkage_alone = "drawing";
        all_linkages = "list";
        pick = "pick";
        put_into_list = "put into the list";
        task_in_preview(wanted: &str) = "a task: {wanted}; Enter searches for linkages";
        found_before = "found before: Enter lists them";
        task_is_no_scene = "this is a task, not a scene";

        // The command.
        search_was_stopped = "stopped: the results so far follow; Ctrl-C again quits";
        does_synthesize = "Find linkages for a task: poses, a function or a path";
        task_to_do = "A task file, `-` for standard input, or an example: wiper, hatch, logarithm, straight-line, stirrer (krank help synthesis)";
        candidates_to_tell = "Number of linkages to list, the best first";
        tolerance_of_candidates = "The tolerance of each length, written into the scenes";
        candidates_in_workbench =
            "Show the linkages in the workbench, moving through the task, and take one as a scene";
        folder_of_candidates = "A folder for a scene of each listed linkage";
        tolerance_is_no_length = "--tolerance must be a length of at least 0";
        nothing_does_the_task(reason: &str) = {
            match reason {
                "" => "no linkage was found for the task".into(),
                reason => format!("no linkage was found for the task: {reason}"),
            }
        };
        no_task_and_no_file(name: &str, meant: &str) = "there is no task or file `{name}`; available: {meant}";
        example_is_a_task(name: &str) = "it is a task: krank synthesize {name}";
        preset_is_no_task(name: &str) = "`{name}` is a preset, not a task: krank {name} opens it (krank help synthesis)";
        scene_would_be_lost(file: &str) =
            "`{file}` has other content, which would be lost; write to another folder, or move it away";
        candidates_written(count: usize, folder: &str) = {
            format!("{} in {folder}", counted(count, "scene", "scenes"))
        };
        examples_of_synthesize = "\
Examples:
  krank synthesize wiper
  krank synthesize wiper --view
  krank synthesize straight-line --top 3 -o found
  krank synthesize task.toml --format json --seed 7
";
    }
}
