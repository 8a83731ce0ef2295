//! The working: loops, positions and rates, step by step.

use super::English;
use std::fmt::Display;

catalogue! {
    /// What is said between the equations of the working.
    trait WorkingWords for English {
        // How it begins.
        driver_turns(state: &str, driver: &str, at: &str, speed: &str, acceleration: &str) =
            "State: {state}. The driver {driver} turns: at {at}, with {speed} and {acceleration}.";
        driver_slides(state: &str, driver: &str, at: &str, speed: &str, acceleration: &str) =
            "State: {state}. The driver {driver} slides: at {at}, with {speed} and {acceleration}.";
        inputs_are_given = "The other inputs follow the driver: their coordinates are given as its own is.";
        inputs_have_tables(names: &str) =
            "By its table in the scene, a cubic spline, {names} has here:";
        forces_of_inputs_in_tables =
            "Where several inputs share the work, forces are not written out: the table of forces has them.";
        dead_point_explained =
            "A dead point: the motion ends here. Positions exist; velocities and accelerations do \
             not, since their equations would be divided by a sine that is 0.";
        change_point_explained =
            "A change point: two assemblies meet here. The equations of the rates are singular at \
             this one place; the velocities and accelerations given are the limits along the motion.";
        no_assembly_explained(covered: &str) =
            "The mechanism cannot be assembled here: the driver covers {covered}. What follows is \
             what the scene and the driver give.";

        // Vector polygons and the position table.
        vector_polygons = "Vector polygons";
        loop_is(number: usize, what: &str) = "Loop {number}: {what}";
        solved_by_group(walk: &str, group: usize) = "{walk} (group {group})";
        tells_further_vector(walk: &str) = "{walk} (tells a further vector)";
        no_closed_loop = "There is no closed loop: the driver alone places everything.";
        vector_on(vector: &str, tail: &str, head: &str, body: &str) =
            "{vector} from {tail} to {head} on {body}";
        the_ground = "the ground";
        beside_vectors_of_scene(vectors: &str) = "Beside the scene's vectors: {vectors}.";
        in_no_loop(vectors: &str) = "In no loop: {vectors}.";
        position_table = "Position table";
        column_ends = "from, to";
        column_is(symbol: &str) = "{symbol} is";
        is_sought = "sought";
        vectors_by_coordinates =
            "Vectors between points of one body, by their places in the frame of that:";

        // Loop equations.
        loop_equations = "Loop equations";
        multiplied_by(vector: &str, removed: &str) =
            "Multiplied by {vector}, which removes {removed}:";
        multiplied_across(vector: &str, side: &str) =
            "Multiplied by {vector}, at right angles to {side}, which removes {side}:";
        collected_by(one: &str, other: &str) =
            "Multiplied by {one} and by {other}, multiplied out and collected, so that numbers \
             stand before what is sought:";
        collected_with_letters =
            "Multiplied out and collected, so that numbers stand before what is sought:";
        collected_with_numbers = "With their numbers:";
        collected_equation(number: usize) = "the collected equations of loop {number}";
        squared_and_added(arm: &str, lost: &str, kept: &str) =
            "{arm} alone on one side, both components squared and added: {lost} drops out; in {kept} alone:";

        // Positions.
        positions_by_groups = "Positions, group by group";
        the_vector(names: &str) = "The vector {names}";
        group_in_words(number: usize, kind: &str) = "Group {number}, {kind}";
        group_of_one_link(number: usize, kind: &str, link: &str) = "Group {number}, {kind}: link {link}";
        group_of_many_links(number: usize, kind: &str, links: &str) =
            "Group {number}, {kind}: links {links}";
        coupled_of_unknowns(count: usize) = "coupled group of {count} unknowns";
        not_without_groups_before = "Not without the positions of the groups before it.";
        loop_repeats_others = "Its loop repeats others: nothing is sought in it.";
        nothing_sought = "Nothing is sought.";
        driver_places = "The driver places:";

        // Two arms.
        with_m_between(m: &str, from: &str, to: &str, joint: &str) =
            "With {m} from {from} to {to}, and {joint} where the two arms meet:";
        lies_to_the_left(joint: &str, from: &str, to: &str) =
            "{joint} lies on the left of {from} → {to}, by the assembly:";
        lies_to_the_right(joint: &str, from: &str, to: &str) =
            "{joint} lies on the right of {from} → {to}, by the assembly:";
        lies_on_the_line(joint: &str, from: &str, to: &str) =
            "{joint} lies on the line {from} → {to}: both assemblies are one:";
        pivots_coincide(one: &str, other: &str) =
            "{one} and {other} lie on each other: there is no triangle, and the angles are the limits \
             along the motion:";
        arms_too_short(m: &str, one: &str, other: &str, sum: &str) =
            "{m} is longer than {one} + {other} = {sum}: the arms do not reach each other.";
        arms_too_unlike(m: &str, one: &str, other: &str, difference: &str) =
            "{m} is shorter than |{one} - {other}| = {difference}: the arms cannot close the \
             triangle.";
        triangle_would_close =
            "This triangle would close, but the motion that starts at the scene's assembly does not \
             come here.";

        // Guides.
        quadratic_in(arm: &str, sum: &str, name: &str) =
            "With K the sum of the known sides the loop asks that {arm} = |{sum}|; squared, this is a \
             quadratic equation for {name}.";
        either_or(one: &str, other: &str) = "{one} or {other}";
        by_the_assembly = "By the assembly:";
        angle_of_minus(what: &str) = "angle of -({what})";
        others_turn_with(name: &str, along: &str, left: &str) =
            "The other sides that turn with {name} lie t = {along} along it and e = {left} to its left:";
        does_not_reach_guide(arm: &str) = "It is negative: {arm} does not reach the guide.";
        root_would_close =
            "It would close, but the motion that starts at the scene's assembly does not come here.";

        // Coupled groups.
        solved_at_once = "It is solved at once, by Newton's method, where it can be assembled.";
        no_part_alone =
            "No part of it can be solved alone: all equations f(z) = 0 are solved at once, by \
             Newton's method, z - dz with J dz = f, J the derivatives of f by z. Where it stopped:";
        equations_left = "The equations, and what is left of them:";
        jacobian_too_large(n: usize) = "J has {n} x {n} entries, which nobody would read.";
        jacobian_rows =
            "J, a row for every equation; an entry has the unit of its row over that of its column:";
        sides_by_joints = "From the joints what is sought of the vectors between them:";
        joint = "joint";
        two_ways(coordinate: &str, point: &str) = "{coordinate} of {point} two ways";
        distance_from_guide(point: &str) = "distance of {point} from its guide";
        found_together = "Found together:";

        // Rates.
        velocities_part = "Velocities";
        accelerations_part = "Accelerations";
        differentiated = "The loop equations, differentiated by time:";
        differentiated_again = "Differentiated once more:";
        rates_are_limits =
            "The equations are singular here; the values are limits along the motion.";
        no_rates_at_dead_point =
            "They do not exist at a dead point. The equations, which nothing solves here:";
        do_not_exist_either = "They do not exist either.";
        none_without_assembly = "Without an assembly there are none. The equations:";
        nothing_sought_in_it = "Nothing is sought in it.";
        factor_vanishes(symbol: &str) =
            "The factor of {symbol} vanishes; along the motion the limit is:";
        equations_for_unknowns(equations: usize, unknowns: usize) =
            "{equations} equations for {unknowns} unknowns; solved together:";
        sliding = "sliding";
        turning = "turning";
        speeds_up = "speeds up";
        slows_down = "slows down";

        // Points.
        points_part = "Points";
        rates_of_points_missing = "Their velocities and accelerations do not exist here.";
        a_point = "a point";
        point_on_about(point: &str, link: &str, base: &str) = "{point} on {link} about {base}";
        lies_on(base: &str) = "It lies on {base} and moves as that does.";
        does_not_turn(link: &str, base: &str) =
            "{link} does not turn: all of it moves as {base} does.";
        at_degrees(figure: &str, direction: &str) = "{figure} at {direction} deg";
        between_normal_part(angle: &str, symbol: &str) =
            "{angle} deg, between {symbol} and its normal part";
        along_guide_of(point: &str, slide: &str, body: &str) =
            "{point} along the guide of {slide} on {body}";
        of_under(symbol: &str, body: &str, point: &str) = "{symbol} of {body} under {point}";

        // Instant centres.
        instant_centres = "Instant centres";
        instant_centre = "instant centre";
        instant_centre_is =
            "The instant centre of a link is the place of it that is at rest at this instant, against \
             the frame: every other point of it has v = |ω| times its distance from there. By \
             Kennedy's theorem the three centres of three links lie on one line.";
        common_centres(joints: &str) =
            "Two links that are pinned have their joint as common centre: {joints}.";
        centre_of_link(centre: &str, link: &str) = "{centre} of {link}";
        on_two_lines(centre: &str, one: &str, other: &str) =
            "{centre} lies on {one}, at β, and on {other}, at γ:";
        line_through(one: &str, other: &str) = "the line through {one} and {other}";
        line_across(joint: &str) = "the line through {joint} at right angles to its path";
        centre_by_velocity(centre: &str, point: &str, omega: &str) =
            "No two lines are known that cross clearly at {centre}; by the velocity of {point} and {omega}:";
        centre_of_guided(link: &str, direction: &str) =
            "{link} does not turn: its centre lies at infinity, at right angles to its velocity, at \
             {direction} deg and the other way.";
        centre_far(link: &str, direction: &str) =
            "As far as the digits tell, {link} does not turn at this instant: its centre lies at \
             infinity, at right angles to its velocity, at {direction} deg and the other way.";
        link_is_at_rest(link: &str) = "{link} is at rest at this instant: all of it is centre.";
        centre_is_blurred(link: &str, digits: usize) =
            "{link} hardly turns, and the centre lies far away: of it {digits} digits can be told:";
        at_infinity = "at infinity";

        // The check.
        check_part = "Check";
        nothing_to_check = "Without an assembly there is nothing to check.";
        figures_do_not_differ =
            "The figures worked out above and those of the solver do not differ.";
        figures_differ(part: &str, symbol: &str) =
            "The figures worked out above and those of the solver differ by {part} of their size at \
             the most (at {symbol}).";
        left_of_loops = "What is left of the loop equations with all numbers in place:";
        loop_component(number: usize, axis: &dyn Display) = "loop {number} {axis}";
    }
}
