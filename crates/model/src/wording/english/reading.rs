//! Errors in the keys, values and names of a scene or a configuration, and how to fix them.

use super::English;

catalogue! {
    /// Errors in a document, before a mechanism is built.
    trait ReadingWords for English {
        // The document.
        not_utf8(byte: u8, at: usize) = "the file is not UTF-8: byte 0x{byte:02x} at offset {at}";
        not_a_character = "not a character in UTF-8";
        save_as_utf8 = "save the file as UTF-8";
        not_valid_toml(message: &str) = "not valid TOML: {message}";
        more_faults(count: usize) = "{count} more faults are not shown";
        given_twice(key: &str) = "{key} is given twice";
        the_first_time = "the first time";
        the_second_time = "the second time";
        take_one_out = "remove one of them, or rename it";
        unknown_key_in(of: &str, key: &str) = "{of}: unknown key {key}";
        unknown_key_here = "unknown key";
        known_keys(names: &str) = "known keys: {names}";
        no_gears_yet = "krank does not model gears yet";
        no_cams_yet = "krank does not model cams yet";
        no_belts_yet = "krank does not model belts and chains yet";
        no_friction_yet = "krank does not model friction yet: its forces are those of frictionless joints";
        no_contacts_yet = "krank does not model contacts yet";
        motion_is_given =
            "krank does not compute a motion from a force or torque: give the speed, and write loads in [[loads]]";
        joints_are_points = "krank has no list of joints: a point that two links name, or a link and [ground], is a pin";
        sliders_are_slides = "a slider is an entry of [slides]: a pin in a slot, or a link that does not turn";
        motors_are_drivers = "the input is [driver], and further inputs are [inputs]; [motor] rates the drive";
        anchors_are_ground = "fixed points are in [ground]";
        bars_are_links = "rigid parts are in [links]";
        krank_reads_toml = "a scene is a TOML file: `krank help scene` describes it";
        is_an_address = "this is an internet address, not a scene";
        is_a_pmks_address = "this is the address of a PMKS+ mechanism, not a scene: convert it with `krank import`";
        is_json = "this is JSON, not TOML";
        is_json_of_pmks = "this is the JSON of a PMKS+ mechanism, which krank does not read; `krank import` reads its addresses";

        // Values.
        must_be(what: &str, wanted: &str, found: &str) = "{what} must be {wanted}, not {found}";
        expected(wanted: &str) = "expected {wanted}";
        for_example(example: &str) = "for example: {example}";
        write_in_quotes(literal: &str) = "write it in quotes: \"{literal}\"";
        write_without_quotes(literal: &str) = "write it without quotes: {literal}";
        a_quoted_text = "a text in quotes";
        a_text = "a text";
        a_number = "a number";
        a_truth = "true or false";
        a_date = "a date";
        a_list = "a list";
        a_table = "a table";
        key_of(key: &str, of: &str) = "`{key}` of {of}";
        part_of(part: &str, of: &str) = "{part} of {of}";

        // Numbers.
        a_finite_number = "a finite number";
        at_most_in_size = "at most 1e300 in size";
        is_not_a_number = "not a number";
        is_not_finite = "not finite in double precision";
        is_too_large = "too large";
        write_a_decimal = "write a decimal number, such as 12.5";
        choose_a_unit = "choose a `unit` in which the dimensions have an ordinary size";
        must_not_be_less_than_zero(what: &str, literal: &str) =
            "{what} must not be negative, but is {literal}";
        is_negative = "negative";
        leave_it_out(key: &str) = "omit `{key}` where it does not matter";
        a_pair(form: &str) = "a pair {form}";
        must_be_a_pair(what: &str, form: &str, count: usize) =
            "{what} must be a pair {form}, not {count} values";
        expected_two(count: usize) = "expected 2 values, found {count}";
        write_as_a_part(part: f64) = "write it as a fraction: {part}";
        is_no_unit(word: &str, units: &str) = "`{word}` is not a unit; use one of {units}";
        product_has_a_sign(number: &str, name: &str) = "write a product with its sign: `{number} * {name}`";

        // Common mistakes.
        comments_begin_with = "a comment begins with #";
        quote_the_name = "quote a name that contains ': \"B'\" = [0, 0]";
        has_decimal_comma(number: &str) = "the number `{number}` has a decimal comma";
        decimals_have_a_point(number: &str) = "write decimals with a point: {number}";
        write_key_and_value = "write key = value";
        quote_texts_and_names = "write texts and names in quotes: \"A\"";
        separate_by_commas = "separate the values of a list by commas: [0, 0]";
        quote_with_unit(number: &str, unit: &str) = "write a number with a unit in quotes: \"{number} {unit}\"";
        angle_alone(number: &str) = "angles are in degrees: write the number alone: {number}";
        number_alone_or_unit(number: &str) =
            "write the number alone: {number}; or in quotes, with a unit: \"{number} mm\"";

        // The driver.
        driver_has_both = "the driver has both `link` and `slide`";
        one_is_driven = "one of them is driven";
        driver_has_neither = "the driver has neither `link` nor `slide`";
        nothing_is_driven = "nothing is driven";
        how_a_link_is_driven(example: &str) = "a driven link: {example}";
        how_a_slide_is_driven(example: &str) = "a driven slide: {example}";
        driver_has_other(driven: &str, other: &str, coordinate: &str) =
            "the driver: a driven {driven} has `{coordinate}`, not `{other}`";
        coordinate_is_meant(coordinate: &str) = "use `{coordinate}`";
        driver_lacks(coordinate: &str) = "the driver has no `{coordinate}`";
        coordinate_is_missing(coordinate: &str) = "`{coordinate}` is missing: its value where the scene opens";

        // Rates.
        rate_is_no_number(key: &str, of: &str, typed: &str) =
            "`{key}` of {of} must be a number and a unit in quotes, not `{typed}`";
        rate_has_no_unit(key: &str, of: &str, typed: &str) = "`{key}` of {of} has no unit: `{typed}`";
        rate_has_other_unit(key: &str, of: &str, typed: &str) =
            "`{key}` of {of} has a unit that does not fit: `{typed}`";
        rate_has_two_marks(key: &str, of: &str, typed: &str) =
            "`{key}` of {of} has more than one decimal mark: `{typed}`";
        rate_is_too_large(key: &str, of: &str, typed: &str) = "`{key}` of {of} is too large: `{typed}`";
        digits_without_groups = "write digits without groups: 1234.5 or 1234,5";
        expected_a_rate = "expected a number and a unit, in quotes";
        possible_units(units: &str) = "possible units: {units}";

        // Names.
        noun_point = "point";
        noun_link = "link";
        noun_slide = "slide";
        noun_vector = "vector";
        noun_figure = "figure";
        noun_parameter = "parameter";
        noun_limit = "limit";
        names_both(name: &str, other: &str, one: &str) = "{name} names both a {other} and a {one}";
        named_here(noun: &str) = "a {noun} here";
        names_are_shared =
            "points, links, slides, vectors, figures and parameters share one set of names: rename one of them";
        is_another(what: &str, name: &str, other: &str, noun: &str) =
            "{what}: {name} is a {other}, not a {noun}";
        expected_name_of(noun: &str) = "expected the name of a {noun}";
        that_one(noun: &str) = "the {noun}";
        there_is_no(what: &str, noun: &str, name: &str) = "{what}: there is no {noun} {name}";
        unknown_noun(noun: &str) = "unknown {noun}";
        key_stands_above(key: &str) = "write the scene's `{key}` above the first [table]";
        scene_has_no(noun: &str) = "the scene has no {noun}";
        those_of_scene(noun: &str, names: &str) = "{noun}s of the scene: {names}";
        name_is_reserved(name: &str) = "the name {name} is reserved";
        is_reserved = "reserved";
        columns_use(names: &str) = "columns use {names} with a special meaning: choose another name";
        name_a_ground_point = "to join a link to the ground, name one of the points in [ground]";
        name_is_empty = "a name must not be empty";
        is_empty = "empty";
        name_is_too_long(name: &str, count: usize, most: usize) =
            "the name {name} has {count} characters; at most {most} are allowed";
        is_too_long = "too long";
        name_contains(name: &str, odd: &str) = "the name {name} contains {odd}";
        is_no_name = "not a name";
        names_are_made_of = "names are made of ASCII letters, digits, `_`, `-` and `'`";
    }
}
