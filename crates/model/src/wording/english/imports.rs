//! Comments and remarks of scenes that were made from other programs' files.

use super::English;

catalogue! {
    /// Imported files.
    trait ImportsWords for English {
        // Comments of the scene.
        import_about(program: &str) = "Imported from a file of {program}. The scene opens in the pose of its drawing.";
        import_a_file(program: &str, file: &str) = "{program}, {file}";
        import_an_address(program: &str) = "{program}, an internet address";
        import_no_unit = "the file has no unit";
        import_start = "the drawing";
        import_ratios = "per unit of the driver, as the speeds of the file";

        // Places in a file.
        import_line(line: usize) = "line {line}";
        import_element(line: u32, element: &str) = "line {line}, {element}";
        import_line_joint(line: usize, joint: usize) = "line {line}, joint {joint}";
        import_joint_row(row: usize) = "joint {row} of `j`";
        import_link_row(row: usize) = "link {row} of `l`";
        import_force_row(row: usize) = "force {row} of `f`";

        // Files that cannot be read.
        import_scene_made_from(file: &str) = "scene made from {file}";
        import_failed(file: &str, why: &str) = "`{file}`: {why}";
        import_unknown_format =
            "this is not a file of PMKS, PMKS+, Linkage, Pyslvs or pylinkage; `krank help import` describes them";
        import_packed(version: &str) = {
            let of_version = match version {
                "" => String::new(),
                version => format!(" of version {version}"),
            };
            format!(
                "this address of PMKS+ is packed{of_version}, and krank reads only addresses with `j=` and `l=`; \
                 write the joints as lines of PMKS"
            )
        };
        import_xml(why: &str) = "the XML is invalid: {why}";
        import_json(why: &str) = "the JSON is invalid: {why}";
        import_other_json = "this JSON is not a pylinkage mechanism: it has no lists `joints` and `links`";
        import_older_pylinkage =
            "this is the older JSON of pylinkage, which stores constraints; save it as a `Mechanism`";
        import_brackets(line: usize) = "line {line}: the brackets of the expression do not match";
        import_no_joints = "the file has no joint with coordinates";
        import_too_large(most: usize) =
            "the file is too large: krank imports at most {most} joints, {most} links and 1 MiB";

        // Parts that were not taken over.
        import_not_as_drawn = "the scene opens, but not in the pose of the drawing: the file contradicts itself";
        import_more_remarks(more: usize) = "{more} more remarks are not shown";
        import_renamed(name: &str, valid: &str) = "`{name}` is called `{valid}` here";
        import_not_a_joint = "not a joint with links, a type and coordinates; left out";
        import_joint_without_links = "the joint has no link; left out";
        import_other_addresses = "the file has further addresses; only the first one is read";
        import_gears = "krank does not model gears; left out";
        import_chain = "krank does not model belts and chains; left out";
        import_slider_of_many = "a slider joins two links; the others are left out";
        import_slider_on_frame = "the slider names no fixed link; its guide is on the frame";
        import_input_of_one_link = "the input joins no two links; left out";
        import_second_input = "an earlier part of the file is the input; left out";
        import_first_joint = "the file marks no input; this joint is the first one with the frame, and becomes the driver";
        import_no_input = "the file has no input: add [driver] to the scene";
        import_link_without_joints(link: &str) = "no joint has the link `{link}`; left out";
        import_unknown_joint(joint: &str) = "there is no joint `{joint}`; left out";
        import_not_a_force = "not a force on a link; left out";
        import_not_a_link = "not a link with an id and joints; left out";
        import_unknown_kind(kind: &str) = "unknown type `{kind}`; left out";
        import_not_a_connector = "the connector has no id or no coordinates; left out";
        import_same_id = "another element has this id, or it has none; left out";
        import_no_such_connector = "there is no connector with this id; left out";
        import_input_not_fixed = "the input is not an anchor; left out";
        import_input_turns_nothing = "the input turns no link; left out";
        import_input_is_fixed = "the input turns a fixed link; left out";
        import_input_twice = "another input moves the same link; left out";
        import_input_is_held =
            "the input does not move in a fixed ratio to the driver; it stands as drawn, with ratio 0";
        import_same_speed = "the file gives no speeds; the input turns as fast as the driver";
        import_actuator_of_two = "an actuator has two connectors; read as a rigid link";
        import_actuator_is_fixed = "both ends of the actuator are fixed or at one place; read as a rigid link";
        import_stroke_too_long = "the actuator would retract beyond its own length";
        import_fastened_to_nothing = "fastened to a link that does not exist; left out";
        import_fastened_to_connector = "fastened to a connector that is no input; left out";
        import_slot_without_ends = "the slot has no two ends; left out";
        import_slot_on_nothing = "no link has both ends of the slot; left out";
        import_pin_beside_arc(off: f64) = "the pin is drawn {off:.3} away from its arc; the scene keeps the drawn position";
        import_pin_beside_slot(name: &str, off: f64) =
            "`{name}` is drawn {off:.3} away from its slot; the scene keeps the drawn position";
        import_slide_is_fixed(name: &str) = "`{name}` slides on a part to which it is fastened; left out";
        import_link_of_one_point(name: &str) = "the link `{name}` has one point only, and moves nothing; left out";
    }
}
