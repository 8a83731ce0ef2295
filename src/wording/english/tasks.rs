//! Tasks: motions that are wanted.

use super::{English, counted};

catalogue! {
    /// Faults of task files.
    trait TasksWords for English {
        the_task_itself = "the task itself";
        task_for_a_scene = "this is a task, not a scene";
        synthesize_does_tasks = "`krank synthesize` looks for linkages that do it: each becomes a scene";
        scene_for_a_task = "this is a scene, not a task";
        synthesize_reads_tasks = "a task says what motion is wanted (krank help synthesis); `krank check` and `krank FILE` open scenes";
        task_without_kind = "the task has no `kind`";
        these_are_known(words: &str) = "there are `{words}`";
        not_known_here = "not known";
        no_kind_of_task(kind: &str) = "{kind} is no kind of task";
        key_of_another_kind(key: &str, kind: &str) = "`{key}` does not belong to a task of the kind `{kind}`";
        belongs_to_another_kind = "of another kind of task";
        no_form_of_linkage(form: &str) = "{form} is no linkage that is looked for";
        no_linkage_wanted = "`linkages` names none";
        item_of(number: usize, key: &str) = "number {number} of `{key}`";
        must_be_row(what: &str, form: &str, count: usize) = "{what} must be {form}, not a list of {count}";
        task_lacks(of: &str, key: &str) = "`{of}` lacks `{key}`";
        told_twice(first: usize, again: usize) = "number {again} is number {first} again";
        the_same_again = "the same again";
        first_told_here = "told here";
        take_out_one_pose = "take one of them out: a body that comes to one pose twice has one pose less";
        take_out_one_point = "take one of them out, or write `closed = true` where the path comes back to its first point";
        count_of_poses(count: usize) = "a task of poses has three to five of them, not {count}";
        poses_that_methods_take = "three leave much open, four leave curves, five leave a few linkages";
        too_much_given(poses: usize, given: usize) = {
            let given = counted(given, "given pivot or pin", "given pivots and pins");
            format!("with {poses} poses there is no room for {given}")
        };
        one_too_many = "one too many";
        what_poses_leave_free = "with three poses two of pivots and pins may be given, with more none";
        take_out_last_point = "take the last one out: `closed = true` says that the path comes back to its first point";
        slider_crank_has_one_pivot = "a slider-crank has one pivot on the ground, the crank's";
        slider_cranks_alone = "slider-cranks alone are looked for";
        take_out_one_pivot = "give one pivot, or add \"four-bar\" to `linkages`";
        count_of_points(count: usize, most: usize) = "a path has 2 to {most} points, not {count}";
        more_than_two_pivots = "a four-bar has two pivots";
        weights_are_positive = "every weight must be more than 0";
        one_for_each_point(key: &str, points: usize, found: usize) = "`{key}` has {found} numbers for {points} points";
        turns_begin_at_nought = "`turns` count from the first point: the first is 0";
        turns_go_one_way = "`turns` must grow from point to point, or fall";
        links_have_their_own_ends = "two links that hang on one place are one";
        turns_end_within_one = "of a closed path all `turns` lie within one turn: the last comes back to the first point";
        direction_wants_order = "`order = false` and a `direction` contradict each other: points in any order are come to from either side";
        one_output = "a function has one output: of `linkages` name one";
        angle_below_90 = "from 0 to below 90";
        at_least_1 = "at least 1";
        inside_is_a_box = "`inside` must be two opposite corners of a box";
        no_turning_direction(name: &str) = "{name} is no direction of turning";
        given_pivot_outside = "a given pivot lies outside of the box in which pivots are to lie";
        outside_the_box = "outside of `inside`";
        widen_the_box = "widen `inside`, or leave one of both out";
        turns_against_direction = "`turns` go one way round and `direction` the other: change the sign of `turns`, or the wish";
        crank_against_direction = "the crank's `swing` or `scale` goes one way round and `direction` the other: where nothing is said it is counter-clockwise; change the sign, or the wish";
        pivot_of_function_outside(place: &str) = "a function's pivot at {place} lies outside of the box in which pivots are to lie";
        widen_for_function = "the crank's pivot is at [0, 0], the other one of a four-bar at [size, 0]: widen `inside`, or leave it out";
        pairs_and_function = "pairs are given twice: by `pairs` and by `function`";
        positive_number = "a positive number";
        count_of_pairs(count: usize, most: usize) = "a function has 3 to {most} pairs, not {count}";
        pairs_not_in_order(number: usize) = "pair {number} does not lie further on than the one before it";
        not_further_on = "x does not grow";
        pairs_by_growing_x = "write pairs by growing x, each x once";
        range_of_function(most: usize) = "`function` must go from a smaller x to a larger one, in 3 to {most} points";
        swing_and_scale = "`swing` and `scale` say the same: give one of both";
        start_wants_scale = "`start` is where x is least: it needs a `scale` or a `swing` that is given";
        scale_is_nought = "what does not move follows no function: its scale must be a number other than 0";
        output_stands_still(y: &str) = "y is {y} at every x: an output that stands still follows no function";
        let_y_change = "write a function, or pairs, in which y changes; a dwell is only a part of a function";

        // What came of a task.
        wanted_motion = "wanted";
        poses_wanted(count: usize) = "a body in {count} poses";
        pairs_wanted(count: usize) = "a function through {count} pairs";
        points_wanted(count: usize, closed: bool) = {
            let form = if closed { "a closed path" } else { "a path" };
            format!("{form} through {count} points")
        };
        candidates_found(good: usize, told: usize, defective: usize, complete: bool, reason: &str) = {
            let most = match good > told {
                true => format!(", the best {told} of them below"),
                false => String::new(),
            };
            let others = match defective {
                0 => String::new(),
                1 if good == 0 => "; one that does not".into(),
                count if good == 0 => format!("; {count} that do not"),
                1 => "; one more that does not".into(),
                count => format!("; {count} more that do not"),
            };
            let proof = match (complete, reason) {
                (true, "") => "; there are no others".into(),
                (true, reason) => format!("; there are no others: {reason}"),
                (false, "") => "; a search, which proves nothing of others".into(),
                (false, reason) => format!("; {reason}"),
            };
            let good = counted(good, "linkage that does it", "linkages that do it");
            format!("{good}{most}{others}{proof}")
        };
        poses_out_of_range = "the coordinates are too large or too small to be computed with: write the task in another unit";
        poses_turn_about(x: &str, y: &str) =
            "all poses are turns about one point, ({x}, {y}): a pivot there leads the body, and no linkage does";
        poses_only_shift = "the body does not turn, and its places lie on no circle on which equal links could lead it";
        given_leads_nowhere = "no link and no slide holds what is given in all poses";
        no_pair_of_dyads = "no two of the links and slides through these poses make such a linkage";
        dyads_out_of_reach = "what leads through these poses lies far away, or has lengths out of all proportion";
        poses_nearly_repeat = "the poses nearly repeat, and their rounding leaves open whether there are others";
        head_transmission = "transm.";
        head_miss = "miss";
        head_turns = "crank";
        head_lacks = "wish missed";
        turns_fully_shortly = "turns";
        swings_shortly = "swings";
        defective_ones = "defective";
        stands_in_dead_point = "it cannot be opened at the first point: it stands in a dead point there";
        branch_between(from: usize, to: usize) = "branch: a dead point lies between points {from} and {to}";
        circuit_between(from: usize, to: usize) =
            "circuit: points {from} and {to} lie on different ones, it would have to be taken apart";
        order_between(from: usize, to: usize) = "order: the crank turns back from point {from} to {to}";
        short_of_range = "it comes to every pair, but does not close over the whole range";
        misses_its_function = "structural error: it misses the function by more than a tenth of the output's swing (rms)";
        structural_error = "structural error of 1";
        point_missed(point: usize) = "it does not come to point {point}";
        point_far_off(point: usize) = "far off: it passes point {point} at more than 5 % of the path's size";
        candidate_called(task: &str, number: usize) = "{task}, candidate {number}";
        candidate_made_by(task: &str) = "krank synthesize, from the task: {task}";
        driven_as_written(miss: &str, unit: &str) =
            "As written by krank synthesize it was driven through its task, which it misses by {miss} {unit} at most.";
        transmission_as_written(way: &str, whole: &str) = {
            match way == whole {
                true => format!("The transmission angle is at least {way} deg, on the way through the task and elsewhere."),
                false => format!(
                    "The transmission angle is at least {way} deg on the way through the task; over the whole motion, as `krank check` and goals count it, {whole} deg."
                ),
            }
        };
        solved_with_goals(vary: &str) = "  krank solve SCENE --vary {vary} \\";
        kept_by_goals = "With other numbers it does its task only where that is asked for:";

        // The list of what came of it.
        linkages = "linkages";
        linkages_for(task: &str) = "Linkages for {task}";
        good_and_defective(good: usize, defective: usize) = {
            match defective {
                0 => format!("{good} found"),
                _ => format!("{good} found, {defective} defective"),
            }
        };
        looking_for_linkages(percent: u32) = "looking for linkages: {percent} %";
        at_point_of_task(point: usize, points: usize, crank: &str) =
            "point {point} of {points}, crank at {crank} deg";
        point_by_point = "from point to point";
        dyads_walked(dyad: usize, dyads: usize, curve: usize, curves: usize) =
            "Pivot and pin {dyad} of {dyads} on curve {curve} of {curves}";
        pin_on_pivot(pivot: &str, pin: &str, link: &str, unit: &str) =
            "pivot at {pivot}, pin at {pin}, link {link} {unit}";
        pin_on_slide(angle: &str, pin: &str, unit: &str) = "slide at {angle} deg, pin at {pin} {unit}";
        dyad_picked(dyad: &str) = "with the {dyad}";
        pick_the_second = "Enter picks it; with a second one it makes a linkage.";
        dyads_make_nothing = "The two make no linkage.";
        transmission_on_the_way(angle: &str) = "transmission {angle} deg";
        dotted_curves = "Dotted: where pivots may stand, and their pins in the first pose.";
        walk = "walk";
        next_curve = "next curve";
        curves_of_dyads = "curves";
        linkage_alone = "drawing";
        all_linkages = "list";
        pick = "pick";
        put_into_list = "put into the list";
        task_in_preview(wanted: &str) = "a task: {wanted}; Enter looks for linkages that do it";
        found_before = "found before: Enter lists them";
        task_is_no_scene = "this is a task, and no scene";

        // The command.
        search_was_stopped = "stopped: what was found until then follows; Ctrl-C again ends it";
        does_synthesize = "Find linkages that do a task: poses, a function or a path";
        task_to_do = "A task file, `-` for standard input, or an example: wiper, hatch, logarithm, straight-line, stirrer (krank help synthesis)";
        candidates_to_tell = "How many linkages are told, the best first";
        tolerance_of_candidates = "How far each length may be off: it is written into the scenes";
        candidates_in_workbench = "Go through the linkages in the workbench, each on its way, and take one as a scene";
        folder_of_candidates = "A folder for a scene of each linkage that is told";
        tolerance_is_no_length = "--tolerance must be a length, and not negative";
        nothing_does_the_task(reason: &str) = {
            match reason {
                "" => "no linkage was found that does the task".into(),
                reason => format!("no linkage was found that does the task: {reason}"),
            }
        };
        no_task_and_no_file(name: &str, meant: &str) = "there is no task and no file `{name}`; there is {meant}";
        example_is_a_task(name: &str) = "it is a task: krank synthesize {name}";
        preset_is_no_task(name: &str) = "`{name}` is a preset, not a task: krank {name} opens it (krank help synthesis)";
        scene_would_be_lost(file: &str) =
            "`{file}` holds something else, which would be lost; write to another folder, or move it away";
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
