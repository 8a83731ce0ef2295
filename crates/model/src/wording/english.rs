//! English messages that need grammar: plural forms, choices and lists. `english.txt` has all others.

use std::fmt::Display;

/// Formats a count with its noun: `1 link`, `3 links`.
fn counted(count: usize, one: &str, many: &str) -> String {
    format!("{count} {}", if count == 1 { one } else { many })
}

pub(super) fn parts_and_ground(links: usize, pins: usize, slides: usize) -> String {
    format!(
        "{} and the ground, {}, {}",
        some(links, "link"),
        some(pins, "pin joint"),
        some(slides, "slide")
    )
}

pub(super) fn input_follows_table(
    driven: &str,
    knots: usize,
    ends: [&str; 2],
    unit: &str,
) -> String {
    let [first, last] = ends;
    format!("{driven} follows a table: {knots} knots, the driver from {first} to {last} {unit}")
}

pub(super) fn knots_beyond_motion(knots: usize) -> String {
    match knots {
        1 => "; 1 of them is outside the motion".into(),
        _ => format!("; {knots} of them are outside the motion"),
    }
}

pub(super) fn input_given_by_table(
    driven: &str,
    knots: &str,
    units: [&str; 2],
    closes: bool,
) -> String {
    let [driver, own] = units;
    let ends = match closes {
        true => "periodic",
        false => "at rest at both ends",
    };
    format!(
        "{driven} follows a cubic spline, {ends}, through [driver in {driver}, own coordinate in {own}]: {knots}"
    )
}

pub(super) fn slide_counts_backwards(
    name: &str,
    r: &str,
    unit: &str,
    angles: [&str; 2],
    theta: Option<&String>,
) -> String {
    let [angle, other] = angles;
    let at = theta
        .map(|theta| format!(", at theta {theta} deg"))
        .unwrap_or_default();
    format!(
        "{name} is negative where the scene opens, {r} {unit}: it is measured from `through` along \
         `angle = {angle}`, and its vector points back; set `angle = {other}` to make it positive{at}, as \
         in lecture notes"
    )
}

pub(super) fn mobility_set_aside(mobility: &dyn Display, count: usize, which: &str) -> String {
    let count = some(count, "redundant constraint");
    format!("{mobility}, not counting {count}: {which}")
}

pub(super) fn coupled_group(unknowns: usize) -> String {
    format!("coupled group, {}", some(unknowns, "unknown"))
}

pub(super) fn coupled_group_at(point: &str, unknowns: usize) -> String {
    format!("coupled group at {point}, {}", some(unknowns, "unknown"))
}

pub(super) fn driven_coupler_follower_frame(lengths: &[String; 4], unit: &str) -> String {
    let [driven, coupler, follower, frame] = lengths;
    format!("driven {driven}, coupler {coupler}, follower {follower}, frame {frame} {unit}")
}

pub(super) fn crank_rod_offset(lengths: &[String; 3], unit: &str) -> String {
    let [crank, rod, offset] = lengths;
    format!("crank {crank}, rod {rod}, offset {offset} {unit}")
}

pub(super) fn transmission_between(group: &str, angles: [&str; 4], unit: &str) -> String {
    let [minimum, at_least, maximum, at_most] = angles;
    format!(
        "transmission angle at {group}: smallest {minimum} deg, at {at_least} {unit}; largest \
         {maximum} deg, at {at_most} {unit}"
    )
}

pub(super) fn stops_of(names: &[String]) -> String {
    format!("stops of {}", names.join(" and "))
}

pub(super) fn some_change_points(count: usize) -> String {
    counted(count, "change point", "change points")
}

pub(super) fn transmission_worst(group: Option<&str>, off: &str, at: &str, unit: &str) -> String {
    let group = group
        .map(|group| format!(" at {group}"))
        .unwrap_or_default();
    format!("transmission{group} {off} deg off 90 at {at} {unit}")
}

pub(super) fn count_of_forces(count: usize) -> String {
    counted(count, "force", "forces")
}

pub(super) fn count_of_torques(count: usize) -> String {
    counted(count, "torque", "torques")
}

pub(super) fn count_of_presses(count: usize) -> String {
    counted(count, "press", "presses")
}

pub(super) fn count_of_springs(count: usize) -> String {
    counted(count, "spring", "springs")
}

pub(super) fn count_of_masses(count: usize) -> String {
    counted(count, "link with a mass", "links with a mass")
}

/// Formats a count with its noun: `no slide`, `1 slide`, `2 slides`.
fn some(count: usize, one: &str) -> String {
    match count {
        0 => format!("no {one}"),
        1 => format!("1 {one}"),
        _ => format!("{count} {one}s"),
    }
}

pub(super) fn ignored(first: &str, more: usize) -> String {
    match more {
        0 => first.to_owned(),
        _ => format!("{first}, and {more} more"),
    }
}

pub(super) fn slow_by_quick(ratio: &str, slow: &str, quick: &str, rises: bool) -> String {
    let way = if rises { "up" } else { "down" };
    format!("{ratio}: {slow} {way}, {quick} back")
}

pub(super) fn unit_of_goal(figure: &str, unit: &str, found: &str) -> String {
    match unit {
        "" => format!("{figure} has no unit, not {found}: write the number alone"),
        unit => format!(
            "{figure} has the unit {unit}, not {found}: write the number alone, or with a unit of this kind"
        ),
    }
}

pub(super) fn none_meets_goals(starts: u32) -> String {
    format!(
        "no design meets all goals, from {}; the nearest is shown",
        counted(starts as usize, "start", "starts")
    )
}

pub(super) fn no_design_opens(starts: u32) -> String {
    format!(
        "no design from {} has all of these values",
        counted(starts as usize, "start", "starts")
    )
}

pub(super) fn one_design_meets(starts: u32) -> String {
    format!(
        "one design, from {}",
        counted(starts as usize, "start", "starts")
    )
}

pub(super) fn designs_meet(count: usize, shown: usize, starts: u32) -> String {
    let first = match count > shown {
        true => format!(", the nearest {shown} of them below"),
        false => ", the nearest first".into(),
    };
    format!(
        "{count} designs{first}, from {}",
        counted(starts as usize, "start", "starts")
    )
}

pub(super) fn family_of_designs(freedoms: usize) -> String {
    let freedoms = counted(freedoms, "degree of freedom", "degrees of freedom");
    format!("one of a family with {freedoms}: nearby designs also meet the goals")
}

pub(super) fn generations_made(generations: u32, settled: bool) -> String {
    let made = counted(generations as usize, "generation", "generations");
    match settled {
        true => format!("best of {made}; the search converged"),
        false => format!("best of {made}; the search did not converge"),
    }
}

pub(super) fn polished_best(stationary: bool) -> String {
    match stationary {
        true => "no small change within the limits improves it",
        false => "it is not certain that no small change improves it",
    }
    .to_owned()
}

pub(super) fn designs_from_to(figure: &str, minimum: [&str; 2], maximum: [&str; 2]) -> String {
    let ([minimum, low], [maximum, high]) = (minimum, maximum);
    format!("{figure}: minimum {minimum} at {low}; maximum {maximum} at {high}")
}

pub(super) fn goal_needs_opening(why: &str) -> String {
    match why.is_empty() {
        true => "no nearby design can be evaluated".to_owned(),
        false => format!("no nearby design can be evaluated; this one: {why}"),
    }
}

pub(super) fn gathering(count: usize) -> String {
    match count {
        0 => "edits are staged".to_owned(),
        1 => "1 edit staged".to_owned(),
        count => format!("{count} staged"),
    }
}

pub(super) fn gathered_made(count: usize) -> String {
    match count {
        0 => "edits apply immediately".to_owned(),
        1 => "1 edit applied".to_owned(),
        count => format!("{count} edits applied"),
    }
}

pub(super) fn no_number_typed(typed: &str, units: &str) -> String {
    match units {
        "" => format!("not a number: {typed}; type one"),
        units => format!("not a number: {typed}; type one, plain or in {units}"),
    }
}

pub(super) fn unit_does_not_fit(unit: &str, units: &str) -> String {
    match units {
        "" => format!("{unit} does not fit here: leave out the unit"),
        units => format!("{unit} does not fit here: {units}"),
    }
}

pub(super) fn either(places: &[String]) -> String {
    places.join(" or ")
}

pub(super) fn together(parts: &[String]) -> String {
    parts.join(" and ")
}

pub(super) fn constraints_repeat(count: usize) -> String {
    counted(
        count,
        "constraint is redundant",
        "constraints are redundant",
    )
}

pub(super) fn constraints_missing(count: usize) -> String {
    let missing = counted(count, "constraint is", "constraints are");
    format!("{missing} missing: connect a free link to another by a common point, or add a slide")
}

pub(super) fn give_one_position(lines: &[String]) -> String {
    format!(
        "give a rough position, one of:\n[start]\n{}",
        lines.join("   # or\n")
    )
}

pub(super) fn open_as_well(points: &[String]) -> String {
    format!("; open as well: {}", points.join(", "))
}

pub(super) fn one_of_lines(lines: &[String]) -> String {
    lines.join("   # or ")
}

pub(super) fn function_takes(name: &str, minimum: usize, maximum: usize, found: usize) -> String {
    let takes = match (minimum, maximum) {
        (1, 1) => "1 argument".to_owned(),
        (minimum, maximum) if minimum == maximum => format!("{minimum} arguments"),
        (minimum, maximum) => format!("{minimum} to {maximum} arguments"),
    };
    format!("{name}() takes {takes}, not {found}")
}

pub(super) fn measured_in(what: &str, unit: &str) -> String {
    match unit {
        "1" => format!("`{what}` is a plain number"),
        unit => format!("`{what}` is in {}", unit_word(unit)),
    }
}

pub(super) fn takes_an_angle(function: &str, unit: &str) -> String {
    match unit {
        "1" => format!("{function}() takes an angle, but this is a plain number"),
        unit => format!(
            "{function}() takes an angle, but this is in {}",
            unit_word(unit)
        ),
    }
}

pub(super) fn takes_a_number(function: &str, unit: &str) -> String {
    let unit = unit_word(unit);
    format!(
        "{function}() takes a plain number, but this is in {unit}: divide it by a value of that unit"
    )
}

pub(super) fn parameters_measured_in(named: &[(String, String)], wanted: &str) -> String {
    let named: Vec<_> = named
        .iter()
        .map(|(name, unit)| format!("`{name}` is in {}", unit_word(unit)))
        .collect();
    let wanted = match wanted {
        "1" => String::new(),
        wanted => format!("in {}, or ", unit_word(wanted)),
    };
    format!("{}: write it {wanted}as a plain number", named.join(", "))
}

pub(super) fn rate_of_units(key: &str, of: &str, formula: &str, found: &str) -> String {
    let found = unit_word(found);
    format!("`{key}` of {of} takes a plain number before its unit, but `{formula}` is in {found}")
}

pub(super) fn value_measures_other(value: &str, found: &str, wanted: &str) -> String {
    let [found, wanted] = [unit_word(found), unit_word(wanted)];
    format!("{value} is in {wanted}, but this is in {found}")
}

pub(super) fn no_value_named(name: &str, intended: Option<&str>) -> String {
    let intended = intended.map_or(String::new(), |intended| format!("; {intended}"));
    format!("the scene has no value `{name}`{intended}")
}

pub(super) fn no_input_named(name: &str, names: &str, meant: Option<&str>) -> String {
    let meant = meant.map_or(String::new(), |meant| format!("; {meant}"));
    format!("the scene has no input `{name}`; its inputs: {names}{meant}")
}

/// Returns a unit for use after a preposition, with `in` as code.
fn unit_word(unit: &str) -> String {
    let is_inch = unit
        .strip_prefix("in")
        .is_some_and(|rest| !rest.starts_with(|c: char| c.is_alphanumeric()));
    match is_inch {
        true => format!("`{unit}`"),
        false => unit.to_owned(),
    }
}

pub(super) fn character_not_taken(c: char) -> String {
    format!("{c} (U+{:04X}) is not valid here", u32::from(c))
}

pub(super) fn value_in(name: &str, units: &str) -> String {
    match units {
        "" => name.to_owned(),
        units => format!("{name} [{units}]"),
    }
}

pub(super) fn import_unknown_attribute(name: &str, count: usize) -> String {
    match count {
        1 => format!("the attribute `{name}` is unknown; left out"),
        count => format!("the attribute `{name}` of {count} elements is unknown; left out"),
    }
}

pub(super) fn import_packed(version: &str) -> String {
    let of_version = match version {
        "" => String::new(),
        version => format!(" of version {version}"),
    };
    format!(
        "this address of PMKS+ is packed{of_version}, and krank reads only addresses with `j=` and `l=`; \
         write the joints as lines of PMKS"
    )
}

pub(super) fn newton_found(steps: usize) -> String {
    format!(
        "It converges in {}, to the assembly of this motion.",
        counted(steps, "step", "steps")
    )
}

pub(super) fn newton_other(steps: usize) -> String {
    let steps = counted(steps, "step", "steps");
    format!(
        "It converges in {steps}, to another assembly: the loops close, but the motion has another \
             position here. The result depends on the guess, and nothing shows that it is wrong."
    )
}

pub(super) fn newton_closes(steps: usize) -> String {
    let steps = counted(steps, "step", "steps");
    format!(
        "It converges in {steps}: the loop closes, but the motion from the scene's assembly does not \
             reach this position."
    )
}

pub(super) fn newton_diverged(steps: usize) -> String {
    let steps = counted(steps, "step", "steps");
    format!(
        "It diverges: after {steps} an angle is more than 100 turns from its guess, or a length \
             exceeds all others. J was nearly singular, so the step was far too long."
    )
}

pub(super) fn newton_singular(steps: usize) -> String {
    let steps = counted(steps, "step", "steps");
    format!(
        "It ends after {steps}: J is singular there, det J = 0, and no step exists. For example, two \
             vectors with unknown angles are parallel."
    )
}

pub(super) fn newton_unsettled(steps: usize) -> String {
    let steps = counted(steps, "step", "steps");
    format!("It does not converge in {steps}: the steps do not become small.")
}

pub(super) fn newton_at_dead_point(steps: usize) -> String {
    let steps = counted(steps, "step", "steps");
    format!(
        "It ends after {steps}: at a dead point J is singular at the solution itself. Each step at \
             most halves the error, and rounding leaves half of the digits."
    )
}

pub(super) fn halved(count: usize) -> String {
    format!("After {}:", counted(count, "halving", "halvings"))
}

pub(super) fn begins_a_frame(point: &str, link: &str) -> String {
    format!("{point} is the origin of {link}: change the length of {link} in the list")
}

pub(super) fn whole_turns(turns: &str, is_one: bool) -> String {
    format!("{turns} turn{}", if is_one { "" } else { "s" })
}

pub(super) fn plays_in(turns: bool, seconds: &dyn Display, backwards: bool) -> String {
    let sweep = if turns { "turn" } else { "sweep" };
    format!(
        "1 {sweep} in {seconds} s{}",
        if backwards { ", backwards" } else { "" }
    )
}

pub(super) fn plays_period_in(seconds: &dyn Display, backwards: bool) -> String {
    format!(
        "the motion in {seconds} s{}",
        if backwards { ", backwards" } else { "" }
    )
}

pub(super) fn assembly_now_untold(choice: &dyn Display) -> String {
    format!("{choice} now; no [start] selects it, so it cannot be saved")
}

pub(super) fn all_of(names: &[&str]) -> String {
    names.join(" and ")
}

pub(super) fn places_of(places: &[String], unit: &str) -> String {
    format!("{} {unit}", places.join(" and "))
}

pub(super) fn does_not_repeat(numbers: &[String], from: &str, to: &str, unit: &str) -> String {
    let (loads, does) = match numbers.len() {
        1 => ("load", "does"),
        _ => ("loads", "do"),
    };
    let numbers = numbers.join(" and ");
    format!(
        "`over` of {loads} {numbers} {does} not repeat: this is the cycle from {from} to {to} {unit}"
    )
}

pub(super) fn dyad_by_two_sums(point: &str, first: &str, sums: [&str; 2], second: &str) -> String {
    let [one, other] = sums;
    format!(
        "F is the force at {point} on {first}; -F acts on {second}, with any load on the pin itself. \
             Two sums contain no outer reaction: for {first} {one}, and for {second} {other}."
    )
}

pub(super) fn cells_left_out(cells: &[(u64, &str, String)], more: usize) -> String {
    let cell =
        |(line, column, cell): &(u64, &str, String)| format!("line {line}, {column}: {cell}");
    let mut text: Vec<String> = cells.iter().map(cell).collect();
    if more > 0 {
        text.push(format!("and {more} more"));
    }
    format!("Left out, since they are not numbers: {}.", text.join("; "))
}

pub(super) fn count_of_links(count: usize) -> String {
    counted(count, "link", "links")
}

pub(super) fn count_of_slides(count: usize) -> String {
    counted(count, "slide", "slides")
}

pub(super) fn too_much_given(poses: usize, given: usize) -> String {
    let given = counted(given, "given pivot or pin", "given pivots and pins");
    format!("{poses} poses do not allow {given}")
}

pub(super) fn points_wanted(count: usize, closed: bool) -> String {
    let form = if closed { "a closed path" } else { "a path" };
    format!("{form} through {count} points")
}

pub(super) fn candidates_found(
    good: usize,
    told: usize,
    defective: usize,
    complete: bool,
    reason: &str,
) -> String {
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
}

pub(super) fn transmission_as_written(way: &str, whole: &str) -> String {
    match way == whole {
        true => format!("The transmission angle is at least {way} deg, in the task and elsewhere."),
        false => format!(
            "The transmission angle is at least {way} deg in the task; over the whole motion, as in `krank \
             check` and in goals, {whole} deg."
        ),
    }
}

pub(super) fn good_and_defective(good: usize, defective: usize) -> String {
    match defective {
        0 => format!("{good} found"),
        _ => format!("{good} found, {defective} defective"),
    }
}

pub(super) fn nothing_does_the_task(reason: &str) -> String {
    match reason {
        "" => "no linkage was found for the task".into(),
        reason => format!("no linkage was found for the task: {reason}"),
    }
}

pub(super) fn candidates_written(count: usize, folder: &str) -> String {
    format!("{} in {folder}", counted(count, "scene", "scenes"))
}

pub(super) fn tour_of_the_crank_text(keys: &[String; 10]) -> String {
    let [
        step,
        step_back,
        play,
        smaller,
        larger,
        slower,
        faster,
        reverse,
        go_to,
        opening,
    ] = keys;
    format!(
        "{step} and {step_back} step: try it now. {play} plays, once the tour is over.\n{smaller} and \
         {larger} change the step, {slower} and {faster} the speed, {reverse} the direction. {go_to} goes \
         to a typed value, {opening} to the opening."
    )
}

pub(super) fn tour_of_figures_text(views: &[String; 9]) -> String {
    let [
        motion,
        tables,
        plots,
        accuracy,
        forces,
        working,
        motor,
        lengths,
        polygons,
    ] = views;
    format!(
        "{tables} tables, {plots} plots, {forces} forces, {working} the working, {motor} the motor, \
         {polygons} polygons, {motion} motion.\nMost values have a proved bound; digits beyond it are dim or \
         dots. - means no value. {accuracy} compares methods, {lengths} shows the effect of each length."
    )
}
