//! Formulas, and what is wrong with them.

use super::English;

catalogue! {
    /// Formulas that a person writes.
    trait FormulasWords for English {
        // How they are written.
        formula_too_long(most: usize) = "the formula is too long: at most {most} characters are allowed";
        formula_too_deep(most: usize) = "brackets and signs stand in one another more than {most} deep";
        no_part_of_a_formula(character: &str) = "`{character}` is no part of a formula";
        minus_without_blank(word: &str) = "`{word}`: is this a name, or subtracted?";
        minus_between_blanks = "`-` subtracts where it stands between blanks: it is legal in names";
        formula_ends_early(wanted: &str) = "the formula ends where {wanted} should follow";
        expected_in_formula(wanted: &str, found: &str) = "expected {wanted}, found `{found}`";
        operator_or_end = "`+`, `-`, `*`, `/`, `^` or the end";
        number_or_name = "a number, a name or a bracket";
        closing_bracket = "`)`";
        exponent_must_be_number = "an exponent must be a number and not 0";
        exponents_go_to(most: usize) = "`^` takes numbers up to {most} and down to -{most}; of others write exp() and ln()";
        of_plain_numbers_only(name: &str) =
            "`{name}` takes plain numbers only, as in [parameters]: of what moves it has no rate";
        no_function(name: &str) = "there is no function `{name}`";
        functions_are(names: &str) = "functions: {names}";
        function_takes(name: &str, least: usize, most: usize, found: usize) = {
            let takes = match (least, most) {
                (1, 1) => "1 figure".to_owned(),
                (least, most) if least == most => format!("{least} figures"),
                (least, most) => format!("{least} to {most} figures"),
            };
            format!("{name}() takes {takes}, not {found}")
        };

        number_too_large(number: &str) = "the number {number} is too large";
        number_too_small(number: &str) = "the number {number} is too small";
        number_with_comma(head: &str, tail: &str) =
            "a comma stands between figures, and in a formula a number has a point: `{head}.{tail}`";

        at_character(at: usize, why: &str) = "character {at}: {why}";

        // What they are about.
        blank_before_unit(number: &str, unit: &str) =
            "a blank stands between a number and its unit: `{number} {unit}`";
        measured_in(what: &str, unit: &str) = {
            match unit {
                "1" => format!("`{what}` is a plain number"),
                unit => format!("`{what}` is in {}", told(unit)),
            }
        };
        do_not_go_together(one: &str, other: &str) = "{one} and {other}: these do not go together";
        numbers_need_units = "write a unit behind the number: `90 deg`, `10 mm/s`";
        takes_an_angle(function: &str, unit: &str) = {
            match unit {
                "1" => format!("{function}() takes an angle, and this is a plain number"),
                unit => format!("{function}() takes an angle, and this is in {}", told(unit)),
            }
        };
        angles_have_units = "angles have a unit: `30 deg`, `0.5 rad`";
        takes_a_number(function: &str, unit: &str) = {
            let unit = told(unit);
            format!("{function}() takes a plain number, and this is in {unit}: divide it by a figure of that unit")
        };
        no_root_of(unit: &str) = "no figure is measured in the root of {unit}";
        unit_beyond_use = "the unit of this is beyond all use";
        formula_has_too_many_steps = "the formula is too long, with those that it uses";
        formula_has_no_such_rate = "only the first and the second rate are known";

        // Numbers that are worked out.
        has_no_worth(of: &str) = "`{of}` is no number";
        divided_by_nothing(by: &str) = "`{by}` is 0, and nothing is divided by that";
        no_parameter(name: &str) = "there is no parameter `{name}`";
        parameters_are(names: &str) = "parameters: {names}";
        scene_has_no_parameters = "numbers with names stand in `[parameters]`: `a = 100`";
        units_stand_alone = "units are added to their like, and multiplied by plain numbers alone";
        units_multiplied(formula: &str) = "`{formula}` multiplies one unit by another";
        units_divided(formula: &str) = "`{formula}` divides a unit by another, or a number by a unit";
        units_divide_their_like =
            "a unit is multiplied and divided by plain numbers, and divided by its like: `10 cm / (2 mm)`";
        parameter_called(name: &str) = "parameter {name}";
        parameters_in_a_circle(name: &str, circle: &str) = "parameter {name} follows from itself: {circle}";
        follows_from_itself = "follows from itself";
        give_one_a_number = "give one of them a number";
        parameter_reads_as_number(name: &str) = "the name {name} would be read as a number";
        begin_it_with_a_letter = "begin it with a letter";
        formulas_read_a_unit(name: &str) =
            "formulas read `{name}` as a unit: choose another name, as `{name}1`";
        formulas_read_a_function(name: &str) =
            "formulas read `{name}` as a function: choose another name, as `{name}1`";
        parameters_measured_in(named: &[(String, String)], wanted: &str) = {
            let named: Vec<_> = named.iter().map(|(name, unit)| format!("`{name}` is in {}", told(unit))).collect();
            let wanted = match wanted {
                "1" => String::new(),
                wanted => format!("in {}, or ", told(wanted)),
            };
            format!("{}: write it {wanted}as a plain number, which takes the unit of its place", named.join(", "))
        };
        rate_of_units(key: &str, of: &str, formula: &str, found: &str) = {
            let found = told(found);
            format!("`{key}` of {of} takes a plain number in front of its unit, and `{formula}` is in {found}")
        };
        rate_brings_its_unit(formula: &str, unit: &str) =
            "`{unit}` is the unit of the whole: give the parameters in `{formula}` as plain numbers";
        value_measures_other(value: &str, found: &str, wanted: &str) = {
            let [found, wanted] = [told(found), told(wanted)];
            format!("{value} is measured in {wanted}, and this is in {found}")
        };
        no_value_named(name: &str, meant: Option<&str>) = {
            let meant = meant.map_or(String::new(), |meant| format!("; {meant}"));
            format!("the scene has no value `{name}`{meant}")
        };
        follows_from_formula(value: &str, formula: &str) = "{value} follows from {formula}: Enter types another";
        follows_from_parameters(value: &str, formula: &str, names: &str) =
            "{value} follows from {formula}: change {names}, or type another by Enter";

        // Figures that are defined.
        formula_uses_itself(name: &str) = "{name} is made of itself";
        no_rate_of(of: &str) = "no rate of {of} is known";
        name_of_figure_missing = "a formula stands behind a name and `=`: `swing = r4.angle - r3.angle`";
        name_of_figure_bad(name: &str) =
            "`{name}` is no name for a figure: ASCII letters, digits, `_`, `-` and `'`, at most 64";
        name_of_figure_taken(name: &str) = "`{name}` names something else already: choose another name";
        in_formula_of(name: &str) = "formula of {name}";
    }
}

/// A unit behind a preposition that one of them is written like.
fn told(unit: &str) -> String {
    let is_inch = unit
        .strip_prefix("in")
        .is_some_and(|rest| !rest.starts_with(|c: char| c.is_alphanumeric()));
    match is_inch {
        true => format!("inch{}", &unit["in".len()..]),
        false => unit.to_owned(),
    }
}
