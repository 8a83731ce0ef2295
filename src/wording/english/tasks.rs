//! Tasks: motions that are wanted.

use super::English;

catalogue! {
    /// Faults of task files.
    trait TasksWords for English {
        the_task_itself = "the task itself";
        task_without_kind = "the task has no `kind`";
        kinds_of_tasks(kinds: &str) = "there are `{kinds}`";
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
        too_much_given(poses: usize, given: usize) = "with {poses} poses there is no room for {given} given pivots and pins";
        one_too_many = "one too many";
        what_poses_leave_free = "with three poses two of pivots and pins may be given, with more none";
        count_of_points(count: usize, most: usize) = "a path has 2 to {most} points, not {count}";
        more_than_two_pivots = "a four-bar has two pivots";
        weights_are_positive = "every weight must be more than 0";
        one_for_each_point(key: &str, points: usize, found: usize) = "`{key}` has {found} numbers for {points} points";
        turns_begin_at_nought = "`turns` count from the first point: the first is 0";
        turns_go_one_way = "`turns` must grow from point to point, or fall";
        from_0_to_90 = "from 0 to below 90";
        at_least_1 = "at least 1";
        inside_is_a_box = "`inside` must be two opposite corners of a box";
        no_turning_direction(name: &str) = "{name} is no direction of turning";
        given_pivot_outside = "a given pivot lies outside of the box in which pivots are to lie";
        outside_the_box = "outside of `inside`";
        widen_the_box = "widen `inside`, or leave one of both out";
        turns_against_direction = "`turns` go one way round and `direction` the other: change the sign of `turns`, or the wish";
        pairs_and_function = "pairs are given twice: by `pairs` and by `function`";
        positive_number = "a positive number";
        count_of_pairs(count: usize, most: usize) = "a function has 3 to {most} pairs, not {count}";
        pairs_not_in_order(number: usize) = "pair {number} does not lie further on than the one before it";
        not_further_on = "x does not grow";
        pairs_by_growing_x = "write pairs by growing x, each x once";
        range_of_function(most: usize) = "`function` must go from a smaller x to a larger one, in 3 to {most} points";
        swing_and_scale = "`swing` and `scale` say the same: give one of both";
        start_wants_scale = "`start` is where x is least: it needs a `scale` or a `swing` that is given";
        scale_is_nought = "what does not turn follows no function: the scale is 0";
    }
}
