//! The reference of a scene's keys: what each is, and what holds where it is left out.

use super::English;

catalogue! {
    /// What the keys of a scene are, and what holds where one is left out.
    trait SceneKeysWords for English {
        heads_of_keys = "key | what it is | default";
        // What each is.
        the_title = "the title";
        where_it_comes_from = "where the mechanism comes from";
        what_there_is_to_see = "what there is to see";
        unit_of_every_length = "of every length: `\"mm\"`, `\"cm\"`, `\"m\"` or `\"in\"`";
        numbers_with_names = "numbers with names, of which formulas make others: `a = 100`, `b = \"2 * a + 5\"`";
        points_fixed_in_frame = "points fixed in the frame: `A = [x, y]`";
        points_only_shown = "points that are only shown, and may stand in formulas: `T1 = [x, y]`";
        the_input = "the input: a link that is turned or a slide that is pushed";
        inputs_that_follow = "more inputs, which follow the driver, each by the name of its link or slide: `r7 = { ... }`";
        rigid_links = "rigid links, each a table: `r2 = { ... }`";
        guides_and_sliders = "guides and what moves along them, each a table: `r4 = { ... }`";
        rough_positions = "rough positions of moving points where the scene opens: `C = [x, y]`";
        further_vectors = "more vectors for the tables, tail and head: `r1 = [\"D\", \"A\"]`";
        coordinates_between_stops = "coordinates between two stops, at which the motion ends: a slide's position `rod = [120, 200]`, a link's angle in the frame `r4 = [30, 150]`, or a table";
        any_number_of_loads = "any number of loads, each a force, a torque or a press";
        any_number_of_springs = "any number of springs and dampers: between points, or torsion springs between links";
        acceleration_of_fall = "acceleration of free fall `[x, y]` in m/s^2";
        figures_by_formulas = "figures made of others, by formulas: `swing = \"r4.angle - r3.angle\"`";
        what_is_to_drive = "what is to drive the scene; it changes no motion";
        constraints_that_repeat = "what is asked of constraints that repeat others";
        the_turning_link = "the link that turns about its ground point";
        the_pushed_slide = "or: the slide that is pushed";
        opening_angle = "direction of the driven link's x axis where the scene opens, in deg";
        opening_position = "of a driven slide where the scene opens: along the guide from `through`";
        ratio_of_input = "what its coordinate grows by for 1 of the driver's: degrees or the scene's `unit`, each";
        phase_of_input = "its coordinate where the driver's is 0: the direction of a link's x axis in deg, or the position of a slide";
        table_of_input = "instead of both, a table: knots of the driver's coordinate and its own, a smooth curve between; \
             the motion ends with it, or it spans whole turns of the driver, comes back to its first value and repeats";
        seat_of_driver = "the link that the motor sits on, if not the ground: the angle is then the turned link's from that one's, and the torque acts between the two";
        range_of_driver = "the stops of the driver `[low, high]`, in deg or of a driven slide in the scene's `unit`";
        link_and_from_where = "the link whose angle is limited, and the link from which it is seen";
        ends_of_an_angle = "its ends `[low, high]` in deg, less than a turn apart";
        speed_of_driver = "`\"15 rad/s\"`, `\"90 deg/s\"`, `\"143.2 rpm\"` or `\"143.2 d/dk\"`; of a slide `\"50 mm/s\"` (`cm/s`, `m/s`, `in/s`)";
        acceleration_of_driver = "`\"2 rad/s^2\"`, `\"90 deg/s^2\"`; of a slide `\"5 mm/s^2\"` (`cm/s^2`, `m/s^2`, `in/s^2`)";
        motion_of_driver = "or how it moves over time, step by step: `[{ law = \"cycloidal\", to = 120, time = 0.5 }, { dwell = 0.2 }, { law = \"harmonic\", to = 0, time = 0.4 }]`";
        law_of_step = "`\"constant\"`, `\"harmonic\"`, `\"cycloidal\"`, `\"trapezoid\"` or `\"table\"`";
        end_of_step = "the driver's coordinate at the end of the step";
        time_of_step = "how long it takes, in s";
        ramp_of_step = "of a trapezoid the part of the time in which its speed grows, and falls again";
        knots_of_step = "of a table: `[[0, 0], [0.2, 40], [0.5, 120]]`, in s from its beginning";
        dwell_of_step = "or: how long the driver stands, in s";
        ends_and_their_distance = "the two ends of a link and their distance: its vector in the loop equation";
        points_in_link_frame = "further points in the link's frame: `{ P = [150, 80] }`, or by length and angle `{ P = { from = \"D\", length = 170, angle = 28 } }`; alone for a link without two natural ends";
        centre_in_link_frame = "centre of mass in the link's frame, `[x, y]` or by length and angle";
        point_that_sees = "the point of the link from which a place is seen";
        origin_by_default = "the origin of the link's frame";
        distance_of_place = "how far it is";
        direction_of_place = "in which direction, in deg from the link's x axis";
        mass_of_link = "in kg; needs `com`";
        inertia_of_link = "about the centre of mass in kg m^2; needs `com`";
        pin_in_the_slot = "the pin that moves in the slot, free to turn";
        link_without_turning = "or: the link that slides without turning, its origin on the guide";
        what_carries_the_guide = "what carries the guide: `\"ground\"` or a link";
        point_of_the_guide = "a point of the guide: a point of `on` by its name, or `[x, y]` in the frame of `on`";
        angle_of_guide = "of the guide against the x axis of `on`, in deg";
        turn_of_slider = "of a sliding link's x axis against the guide, in deg";
        force_at_a_point = "a force `[x, y]` in N at a point";
        frame_of_a_force = "the link in whose frame a force is given: it turns with it";
        torque_on_a_link = "or: a torque in N m on a link, counter-clockwise";
        factor_over_driver = "the part of a force or a torque that acts, over the driver's coordinate: knots \
             `[[0, 0.2], [15, 1], [360, 0.2]]` in deg, or in the unit of a driven slide";
        press_of_a_slide = "or: a force in N against a slide that closes, over the distance before the end of its stroke: knots \
             `[[12, 0], [4, 200e3], [0, 350e3]]`";
        end_of_a_press = "where a press works: the `\"least\"` or the `\"greatest\"` position along the guide; must be given \
             where that is horizontal";
        ends_of_a_spring = "the two points, on different bodies";
        stiffness_of_spring = "in N/m; of a torsion spring in N m/rad";
        free_length = "at which it pulls with its preload alone, in the scene's `unit`";
        force_of_gas_spring = "instead, of a gas spring: what it pushes with in N over the distance of its ends, knots \
             `[[200, 900], [300, 700]]`";
        link_of_torsion_spring = "or: the link that a torsion spring turns back; `to` is the link to which it is fixed, the \
             ground where it is left out";
        free_angle = "of a torsion spring: from the x axis of `to` to that of `link` where it is free, in deg";
        preload_of_spring = "what it pulls with at its free length, in N; of a torsion spring what turns the link at its free angle, \
             in N m, counter-clockwise";
        damping_of_spring = "in N s/m, of the rate of the distance; of a torsion spring in N m s/rad";
        rated_torque = "rated torque in N m";
        rated_force = "of a driven slide instead: rated force in N";
        peak_of_motor = "what the motor gives for a short while, in N m or N";
        rated_speed = "its rated speed, written as the driver's";
        flywheel_of_motor = "moment of inertia on the driver's shaft in kg m^2";
        fluctuation_wished = "wished of the driver's speed, (greatest - least) / mean";
        rest_of_ram = "how far from the end of its stroke a ram still counts as at rest; `tolerance` is its old name";
        tolerance_of_lengths = "how far every given length and coordinate may be off to either side, in the scene's `unit`, or by a class, `\"ISO 2768-m\"` (`f`, `m`, `c`, `v`); a coordinate of 0 is exact under a class";
        exact_by_default = "exact";
        clearance_of_pins = "how far each pin can be from the middle of its hole: half of its play in diameter";
        tolerance_of_link = "how far its length and the places of its points may be off";
        tolerance_of_guide = "how far the coordinates of `through` may be off";
        tolerance_of_scene = "that of the scene";
        tolerance_of_link_or_scene = "that of the link or the scene";
        tolerances_of_points = "how far both coordinates of a point may be off, on the ground or on a link: `A = 0.05`";
        clearances_of_pins = "how far a pin can be from the middle of its hole: `B = 0.02`";
        misfit_accepted = "by how much they may disagree over the motion, in the scene's `unit`: for drawings of few digits";
        // What holds where one is left out.
        name_of_the_file = "the file's name";
        no_default = "none";
        unit_speed = "1 rad/s, or 1 unit/s";
        no_vector_by_default = "no vector";
        the_lower_end = "the lower end";
        unknown_by_default = "unknown";
    }
}
