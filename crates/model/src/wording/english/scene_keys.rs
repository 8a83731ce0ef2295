//! The reference of a scene's keys: descriptions and defaults.

use super::English;

catalogue! {
    /// Descriptions and defaults of the keys of a scene.
    trait SceneKeysWords for English {
        heads_of_keys = "key | meaning | default";
        // Descriptions.
        the_title = "the title";
        where_it_comes_from = "the source of the mechanism";
        what_there_is_to_see = "a description of the scene";
        unit_of_every_length = "unit of every length: `\"mm\"`, `\"cm\"`, `\"m\"` or `\"in\"`";
        numbers_with_names = "named numbers for use in formulas: `a = 100`, `b = \"2 * a + 5\"`";
        points_fixed_in_frame = "points fixed in the frame: `A = [x, y]`";
        points_only_shown = "points for display and formulas only: `T1 = [x, y]`";
        the_input = "the input: a driven link or a driven slide";
        inputs_that_follow =
            "further inputs, which follow the driver, each under the name of its link or slide: `r7 = { ... }`";
        rigid_links = "rigid links, each a table: `r2 = { ... }`";
        guides_and_sliders = "guides and what moves along them, each a table: `r4 = { ... }`";
        rough_positions = "rough positions of moving points where the scene opens: `C = [x, y]`; exact for links as drawn";
        copies_of_groups =
            "copies and mirror images of links and slides, each under the ending of its names: `left = { ... }`";
        further_vectors = "further vectors for the tables, tail and head: `r1 = [\"D\", \"A\"]`";
        coordinates_between_stops =
            "coordinates with two stops, at which the motion ends: a slide's position `rod = [120, 200]`, a link's \
             angle in the frame `r4 = [30, 150]`, or a table";
        any_number_of_loads = "any number of loads, each a force, a torque or a press";
        any_number_of_springs = "any number of springs and dampers: between points, or torsion springs between links";
        acceleration_of_fall = "gravitational acceleration `[x, y]` in m/s^2";
        figures_by_formulas = "named values by formulas of others: `swing = \"r4.angle - r3.angle\"`";
        what_is_to_drive = "the motor of the scene; it does not change the motion";
        constraints_that_repeat = "how closely redundant constraints must agree";
        what_views_show_first = "what drawings show when the scene opens";
        the_turning_link = "the link that turns about its ground point";
        the_pushed_slide = "or: the slide that is driven";
        opening_angle =
            "direction of the driven link's x axis where the scene opens, in deg; required unless `points` is a list";
        opening_position = "position of a driven slide where the scene opens: along the guide from `through`";
        where_an_input_is_held =
            "instead of all others: the coordinate at which the input is held, in deg or, for a slide, in the scene's `unit`";
        ratio_of_input = "change of its coordinate per 1 of the driver's, each in degrees or the scene's `unit`";
        phase_of_input = "its coordinate where the driver's is 0: the direction of a link's x axis in deg, or the position of a slide";
        table_of_input =
            "instead of both, a table: knots of the driver's coordinate and its own, joined by a smooth curve; the \
             motion ends with it, or it spans whole turns of the driver, returns to its first value and repeats";
        seat_of_driver =
            "the link that carries the motor, if not the ground: the angle is then relative to that link, and the \
             torque acts between the two";
        range_of_driver =
            "the stops of the driver `[low, high]`, in deg or, for a driven slide, in the scene's `unit`";
        link_and_from_where = "the link whose angle is limited, and the link from which it is measured";
        ends_of_an_angle = "its ends `[low, high]` in deg, less than a turn apart";
        speed_of_driver =
            "`\"15 rad/s\"`, `\"90 deg/s\"`, `\"143.2 rpm\"` or `\"143.2 d/dk\"`; for a slide `\"50 mm/s\"` \
             (`cm/s`, `m/s`, `in/s`)";
        acceleration_of_driver =
            "`\"2 rad/s^2\"`, `\"90 deg/s^2\"`; for a slide `\"5 mm/s^2\"` (`cm/s^2`, `m/s^2`, `in/s^2`)";
        motion_of_driver =
            "or its motion over time, in steps: `[{ law = \"cycloidal\", to = 120, time = 0.5 }, { dwell = 0.2 }, \
             { law = \"harmonic\", to = 0, time = 0.4 }]`";
        law_of_step = "`\"constant\"`, `\"harmonic\"`, `\"cycloidal\"`, `\"trapezoid\"`, `\"table\"` or `\"sine\"`";
        end_of_step = "the driver's coordinate at the end of the step";
        time_of_step = "the duration, in s";
        amplitude_of_step = "for a sine, the largest distance from the middle position";
        phase_of_step = "for a sine, the phase at its beginning, in degrees: 0 in the middle, 90 at the maximum";
        ramp_of_step = "for a trapezoid, the fraction of the time for speeding up, and the same again for slowing down";
        knots_of_step = "for a table: `[[0, 0], [0.2, 40], [0.5, 120]]`, in s from its beginning";
        dwell_of_step = "or: how long the driver dwells, in s";
        ends_and_their_distance = "the two ends of a link and their distance: its vector in the loop equation";
        points_in_link_frame =
            "further points in the link's frame: `{ P = [150, 80] }`, or by length and angle `{ P = { from = \
             \"D\", length = 170, angle = 28 } }`, or by two distances `from = [\"D\", \"E\"], distances = \
             [120, 90]`; only these for a link without two natural ends; or a list alone, `[\"B\", \"C\", \
             \"P\"]`: a link from B to C with the shape that `[ground]` and `[start]` give it";
        centre_in_link_frame = "centre of mass in the link's frame, in the same forms as a point";
        point_that_sees =
            "the point of the link from which a position is measured; for `distances` the two points: `[\"D\", \"E\"]`";
        origin_by_default = "the origin of the link's frame";
        distance_of_place = "its distance";
        direction_of_place = "its direction in deg, from the link's x axis";
        distances_of_place = "or: its distances from two points, as the sides of a triangle";
        side_of_place = "its side of the line from the first of the two points to the second: `\"left\"` or `\"right\"`";
        mass_of_link = "in kg; needs `com`";
        inertia_of_link = "about the centre of mass in kg m^2; needs `com`";
        pin_in_the_slot = "the pin that moves in the slot, free to turn";
        link_without_turning = "or: the link that slides without turning, its origin on the guide";
        what_carries_the_guide = "the body that carries the guide: `\"ground\"` or a link";
        point_of_the_guide = "a point of the guide: a point of `on` by its name, or `[x, y]` in the frame of `on`";
        angle_of_guide = "angle of the guide from the x axis of `on`, in deg";
        turn_of_slider = "angle of a sliding link's x axis from the guide, in deg";
        group_that_is_copied =
            "the links and slides to copy, and points that the copy must not share: `[\"b\", \"c\"]`";
        number_of_copies = "number of copies, each placed relative to the one before";
        mirror_axis_of_copy = "the axis of a mirror image, `\"x\"` or `\"y\"`, through `about`";
        turn_of_copy = "rotation about `about` in deg, counter-clockwise, after mirroring";
        centre_of_copy = "the centre of `mirror` and `turn`: a ground point by its name, or `[x, y]`";
        shift_of_copy = "displacement `[x, y]`, after turning";
        phase_of_copy =
            "angle in deg between the original's points on other links, such as a crank, and those of the copy";
        points_joined_by_copy =
            "points of the copy by other names: with `{ O = \"L\" }` it has L, or the L of the copy before, where \
             the original has O";
        force_at_a_point = "a force `[x, y]` in N at a point";
        frame_of_a_force = "the link in whose frame a force is given: the force turns with it";
        torque_on_a_link = "or: a torque in N m on a link, counter-clockwise";
        factor_over_driver =
            "a factor of the force or torque, over the driver's coordinate: knots `[[0, 0.2], [15, 1], [360, \
             0.2]]` in deg, or in the unit of a driven slide";
        press_of_a_slide =
            "or: a force in N against a closing slide, over the distance before the end of its stroke: knots \
             `[[12, 0], [4, 200e3], [0, 350e3]]`";
        end_of_a_press =
            "where a press works: the `\"least\"` or the `\"greatest\"` position along the guide; required for a \
             horizontal guide";
        ends_of_a_spring = "its two points, on different bodies";
        stiffness_of_spring = "in N/m; for a torsion spring in N m/rad";
        free_length = "the length at which only its preload pulls, in the scene's `unit`";
        force_of_gas_spring =
            "for a gas spring instead: its push in N over the distance of its ends, knots `[[200, 900], [300, \
             700]]`";
        link_of_torsion_spring =
            "or: the link on which a torsion spring acts; `to` is the link to which it is fixed, by default the \
             ground";
        free_angle =
            "for a torsion spring: the angle from the x axis of `to` to that of `link` where it is free, in deg";
        preload_of_spring =
            "its pull at its free length, in N; for a torsion spring its torque on the link at the free angle, in \
             N m, counter-clockwise";
        damping_of_spring = "in N s/m, for the rate of the distance; for a torsion spring in N m s/rad";
        rated_torque = "rated torque in N m";
        rated_force = "for a driven slide instead: rated force in N";
        peak_of_motor = "maximum for a short time, in N m or N";
        rated_speed = "its rated speed, in the units of the driver's speed";
        flywheel_of_motor = "moment of inertia on the driver's shaft in kg m^2";
        fluctuation_wished = "desired fluctuation of the driver's speed, (maximum - minimum) / mean";
        rest_of_ram =
            "distance from the end of the stroke within which a ram counts as at rest; `tolerance` is its old name";
        tolerance_of_lengths =
            "tolerance of every given length and coordinate to either side, in the scene's `unit`, or by a class, \
             `\"ISO 2768-m\"` (`f`, `m`, `c`, `v`); a coordinate of 0 is exact under a class";
        exact_by_default = "exact";
        clearance_of_pins =
            "largest distance of each pin from the centre of its hole: half of its play in diameter";
        tolerance_of_link = "tolerance of its length and of the positions of its points";
        tolerance_of_guide = "tolerance of the coordinates of `through`";
        tolerance_of_scene = "that of the scene";
        tolerance_of_link_or_scene = "that of the link or the scene";
        tolerances_of_points = "tolerance of both coordinates of a point, on the ground or on a link: `A = 0.05`";
        clearances_of_pins = "largest distance of a pin from the centre of its hole: `B = 0.02`";
        misfit_accepted =
            "how far they may disagree over the motion, in the scene's `unit`: for drawings with few digits";
        points_traced_first = "points whose paths are drawn: `[\"T\"]`";
        // Defaults.
        name_of_the_file = "the file's name";
        no_default = "none";
        direction_if_drawn = "as drawn";
        unit_speed = "1 rad/s, or 1 unit/s";
        no_vector_by_default = "no vector";
        the_lower_end = "the lower end";
        unknown_by_default = "unknown";
    }
}
