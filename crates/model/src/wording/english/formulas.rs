//! Formulas and their errors.

use super::English;

catalogue! {
    /// Errors of formulas.
    trait FormulasWords for English {
        // Syntax.
        formula_too_long(maximum: usize) = "the formula is too long: use at most {maximum} characters";
        formula_too_deep(maximum: usize) = "brackets and signs are nested more than {maximum} deep";
        no_part_of_a_formula(character: &str) = "`{character}` is not allowed in a formula";
        minus_without_blank(word: &str) = "`{word}` may be a name or a subtraction";
        minus_between_blanks = "put blanks around `-` to subtract: names may contain it";
        formula_ends_early(wanted: &str) = "the formula ends, but {wanted} must follow";
        expected_in_formula(wanted: &str, found: &str) = "expected {wanted}, found `{found}`";
        operator_or_end = "`+`, `-`, `*`, `/`, `^` or the end";
        number_or_name = "a number, a name or a bracket";
        closing_bracket = "`)`";
        exponent_must_be_number = "an exponent must be a number other than 0";
        exponents_go_to(maximum: usize) =
            "`^` takes numbers from -{maximum} to {maximum}: use exp() and ln() for others";
        of_plain_numbers_only(name: &str) =
            "`{name}` takes only plain numbers, as in [parameters]: it has no rate";
        no_function(name: &str) = "unknown function `{name}`";
        functions_are(names: &str) = "functions: {names}";
        function_takes(name: &str, minimum: usize, maximum: usize, found: usize) = {
            let takes = match (minimum, maximum) {
                (1, 1) => "1 argument".to_owned(),
                (minimum, maximum) if minimum == maximum => format!("{minimum} arguments"),
                (minimum, maximum) => format!("{minimum} to {maximum} arguments"),
            };
            format!("{name}() takes {takes}, not {found}")
        };

        number_too_large(number: &str) = "the number {number} is too large";
        number_too_small(number: &str) = "the number {number} is too small";
        number_with_comma(head: &str, tail: &str) =
            "a comma separates arguments: write the number with a point, `{head}.{tail}`";

        at_character(at: usize, why: &str) = "character {at}: {why}";

        // Units.
        blank_before_unit(number: &str, unit: &str) =
            "put a blank between a number and its unit: `{number} {unit}`";
        measured_in(what: &str, unit: &str) = {
            match unit {
                "1" => format!("`{what}` is a plain number"),
                unit => format!("`{what}` is in {}", unit_word(unit)),
            }
        };
        do_not_go_together(one: &str, other: &str) = "{one} and {other}: the units do not match";
        numbers_need_units = "write a unit after the number: `90 deg`, `10 mm/s`";
        takes_an_angle(function: &str, unit: &str) = {
            match unit {
                "1" => format!("{function}() takes an angle, but this is a plain number"),
                unit => format!("{function}() takes an angle, but this is in {}", unit_word(unit)),
            }
        };
        angles_have_units = "give the angle a unit: `30 deg`, `0.5 rad`";
        takes_a_number(function: &str, unit: &str) = {
            let unit = unit_word(unit);
            format!("{function}() takes a plain number, but this is in {unit}: divide it by a value of that unit")
        };
        no_root_of(unit: &str) = "the square root of {unit} is not a unit";
        unit_beyond_use = "this unit has too large an exponent";
        formula_has_too_many_steps = "the formula is too long, including those it uses";
        formula_has_no_such_rate = "only first and second rates are available";

        // Evaluation and parameters.
        has_no_worth(of: &str) = "`{of}` has no value";
        divided_by_nothing(by: &str) = "`{by}` is 0: division by zero";
        no_parameter(name: &str) = "unknown parameter `{name}`";
        parameters_are(names: &str) = "parameters: {names}";
        scene_has_no_parameters = "define named numbers in `[parameters]`: `a = 100`";
        units_stand_alone = "add only values of the same unit; multiply a unit only by plain numbers";
        units_multiplied(formula: &str) = "`{formula}` multiplies one unit by another";
        units_divided(formula: &str) = "`{formula}` divides a unit by another, or a number by a unit";
        units_divide_their_like =
            "divide a unit only by a plain number or by a value of the same unit: `10 cm / (2 mm)`";
        parameter_called(name: &str) = "parameter {name}";
        parameters_in_a_circle(name: &str, circle: &str) = "parameter {name} depends on itself: {circle}";
        follows_from_itself = "depends on itself";
        give_one_a_number = "give one of them a number";
        parameter_reads_as_number(name: &str) = "the name {name} can be read as a number";
        begin_it_with_a_letter = "start it with a letter";
        formulas_read_a_unit(name: &str) =
            "`{name}` is a unit in formulas: choose another name, such as `{name}1`";
        formulas_read_a_function(name: &str) =
            "`{name}` is a function in formulas: choose another name, such as `{name}1`";
        parameters_measured_in(named: &[(String, String)], wanted: &str) = {
            let named: Vec<_> = named.iter().map(|(name, unit)| format!("`{name}` is in {}", unit_word(unit))).collect();
            let wanted = match wanted {
                "1" => String::new(),
                wanted => format!("in {}, or ", unit_word(wanted)),
            };
            format!("{}: write it {wanted}as a plain number", named.join(", "))
        };
        rate_of_units(key: &str, of: &str, formula: &str, found: &str) = {
            let found = unit_word(found);
            format!("`{key}` of {of} takes a plain number before its unit, but `{formula}` is in {found}")
        };
        rate_brings_its_unit(formula: &str, unit: &str) =
            "`{unit}` is the unit of the whole value: use plain numbers for the parameters in `{formula}`";
        value_measures_other(value: &str, found: &str, wanted: &str) = {
            let [found, wanted] = [unit_word(found), unit_word(wanted)];
            format!("{value} is in {wanted}, but this is in {found}")
        };
        no_value_named(name: &str, intended: Option<&str>) = {
            let intended = intended.map_or(String::new(), |intended| format!("; {intended}"));
            format!("the scene has no value `{name}`{intended}")
        };
        edit_the_original(copy: &str, original: &str) = "{copy} is a copy; change {original} instead";
        input_is_held(name: &str, at: &str, unit: &str) = "{name} is held at {at} {unit}";
        no_held_inputs = "the scene holds no input; `r7 = { at = 30 }` in [inputs] holds one";
        keys_step_the_driver(name: &str) = "the step keys move the driver, {name}";
        keys_step_an_input(name: &str, at: &str, unit: &str) = "the step keys move {name}, held at {at} {unit}";
        input_is_not_held(name: &str) = "{name} follows the driver; give it `at` in [inputs] to hold it";
        path_too_long(most: usize) = "more than {most} rows";
        path_is_empty = "no row of numbers below the names of the inputs";
        path_has_other_unit(name: &str, unit: &str, own: &str) =
            "the column `{name}` is in {unit}; write its numbers in {own}";
        path_names_twice(name: &str) = "two columns are called `{name}`";
        path_row_has_cells(line: u64, cells: usize, names: usize) =
            "line {line} has {cells} cells, and the first one {names}";
        path_cell(line: u64, name: &str, cell: &str) =
            "line {line}: `{cell}` below `{name}` is not a number without a unit";
        path_has_no_rates(name: &str) = "`{name}` needs a speed, and the rows of `--path` have no times; name positions only";
        path_leads_other_number(leading: usize, free: usize, names: &str) =
            "the file has {leading} coordinates of points, and {free} inputs without a column ({names}); \
             as many inputs must follow as coordinates lead";
        rows_are_singular(singular: u64, rows: u64) =
            "{singular} of {rows} rows are singular: the inputs cannot move the point in every direction there";
        poses_out_of_reach(outside: u64, rows: u64) = "{outside} of {rows} rows cannot be reached by the inputs";
        no_input_named(name: &str, names: &str, meant: Option<&str>) = {
            let meant = meant.map_or(String::new(), |meant| format!("; {meant}"));
            format!("the scene has no input `{name}`; its inputs: {names}{meant}")
        };
        follows_from_formula(value: &str, formula: &str) =
            "{value} is given by {formula}: press Enter to edit";
        follows_from_parameters(value: &str, formula: &str, names: &str) =
            "{value} is given by {formula}: change {names}, or press Enter to edit";

        // Named quantities.
        formula_uses_itself(name: &str) = "{name} depends on itself";
        no_rate_of(of: &str) = "the rate of {of} is not known";
        name_of_figure_missing = "write a name and `=` before the formula: `swing = r4.angle - r3.angle`";
        name_of_figure_bad(name: &str) =
            "`{name}` is not a valid name: use ASCII letters, digits, `_`, `-` and `'`, at most 64";
        name_of_figure_taken(name: &str) = "`{name}` is already in use: choose another name";
        in_formula_of(name: &str) = "formula of {name}";
    }
}

/// Returns a unit for use after a preposition: `in` becomes `inch`.
fn unit_word(unit: &str) -> String {
    let is_inch = unit
        .strip_prefix("in")
        .is_some_and(|rest| !rest.starts_with(|c: char| c.is_alphanumeric()));
    match is_inch {
        true => format!("inch{}", &unit["in".len()..]),
        false => unit.to_owned(),
    }
}
