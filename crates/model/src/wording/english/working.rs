//! The working: loops, positions and rates, step by step.

use super::English;
use std::fmt::Display;

catalogue! {
    /// The text between the equations of the working.
    trait WorkingWords for English {
        // The beginning.
        driver_turns(state: &str, driver: &str, at: &str, speed: &str, acceleration: &str) =
            "State: {state}. The driver {driver} turns: at {at}, with {speed} and {acceleration}.";
        driver_slides(state: &str, driver: &str, at: &str, speed: &str, acceleration: &str) =
            "State: {state}. The driver {driver} slides: at {at}, with {speed} and {acceleration}.";
        inputs_are_given = "The other inputs follow the driver: their coordinates are given, as its own is.";
        inputs_have_tables(names: &str) = "From the cubic spline of its table in the scene, {names} has here:";
        forces_of_inputs_in_tables = "With several inputs, forces are not derived here: see the force table.";
        dead_point_explained =
            "A dead point: the motion ends here. Positions exist; velocities and accelerations do not, since their \
             equations would divide by a sine that is 0.";
        change_point_explained =
            "A change point: two assemblies meet here. The velocity and acceleration equations are singular at this position; \
             the given velocities and accelerations are the limits along the motion.";
        no_assembly_explained(covered: &str) =
            "The mechanism cannot be assembled here: the driver covers {covered}. The following uses only values \
             of the scene and the driver.";

        // Vector polygons and the position table.
        vector_polygons = "Vector polygons";
        loop_is(number: usize, what: &str) = "Loop {number}: {what}";
        solved_by_group(walk: &str, group: usize) = "{walk} (group {group})";
        tells_further_vector(walk: &str) = "{walk} (determines a further vector)";
        no_closed_loop = "There is no closed loop: the driver alone determines all positions.";
        vector_on(vector: &str, tail: &str, head: &str, body: &str) =
            "{vector} from {tail} to {head} on {body}";
        the_ground = "the ground";
        beside_vectors_of_scene(vectors: &str) = "In addition to the scene's vectors: {vectors}.";
        in_no_loop(vectors: &str) = "Not part of a loop: {vectors}.";
        position_table = "Position table";
        column_ends = "from, to";
        column_is(symbol: &str) = "{symbol} is";
        is_sought = "unknown";
        vectors_by_coordinates =
            "Vectors between points of one body, from the coordinates of the points in its frame:";

        // Loop equations.
        loop_equations = "Loop equations";
        multiplied_by(vector: &str, removed: &str) =
            "Multiplied by {vector}, which removes {removed}:";
        multiplied_across(vector: &str, side: &str) =
            "Multiplied by {vector}, at right angles to {side}, which removes {side}:";
        collected_by(one: &str, other: &str) =
            "Multiplied by {one} and by {other}, expanded and collected, so that the unknowns have numbers as \
             coefficients:";
        collected_with_letters = "Expanded and collected, so that the unknowns have numbers as coefficients:";
        collected_with_numbers = "With numbers:";
        collected_equation(number: usize) = "the collected equations of loop {number}";
        squared_and_added(arm: &str, lost: &str, kept: &str) =
            "With {arm} alone on one side, both components squared and added: {lost} is eliminated, {kept} remains:";

        // Positions.
        positions_by_groups = "Positions, group by group";
        the_vector(names: &str) = "The vector {names}";
        group_in_words(number: usize, kind: &str) = "Group {number}, {kind}";
        group_of_one_link(number: usize, kind: &str, link: &str) = "Group {number}, {kind}: link {link}";
        group_of_many_links(number: usize, kind: &str, links: &str) =
            "Group {number}, {kind}: links {links}";
        coupled_of_unknowns(count: usize) = "coupled group of {count} unknowns";
        not_without_groups_before = "The positions of the groups before it are needed first.";
        loop_repeats_others = "Its loop is redundant: it has no unknowns.";
        nothing_sought = "There are no unknowns.";
        driver_places = "The driver determines:";

        // Two arms.
        with_m_between(m: &str, from: &str, to: &str, joint: &str) =
            "With {m} from {from} to {to}, and {joint} where the two arms meet:";
        lies_to_the_left(joint: &str, from: &str, to: &str) =
            "{joint} lies to the left of {from} → {to} in this assembly:";
        lies_to_the_right(joint: &str, from: &str, to: &str) =
            "{joint} lies to the right of {from} → {to} in this assembly:";
        lies_on_the_line(joint: &str, from: &str, to: &str) =
            "{joint} lies on the line {from} → {to}: both assemblies coincide:";
        pivots_coincide(one: &str, other: &str) =
            "{one} and {other} coincide: there is no triangle, and the angles are the limits along the motion:";
        arms_too_short(m: &str, one: &str, other: &str, sum: &str) =
            "{m} is longer than {one} + {other} = {sum}: the arms do not reach each other.";
        arms_too_unlike(m: &str, one: &str, other: &str, difference: &str) =
            "{m} is shorter than |{one} - {other}| = {difference}: the arms cannot close the \
             triangle.";
        triangle_would_close =
            "This triangle closes, but the motion from the scene's assembly does not reach this position.";

        // Guides.
        quadratic_in(arm: &str, sum: &str, name: &str) =
            "With K, the sum of the known sides, the loop requires {arm} = |{sum}|; squared, this is a quadratic \
             equation for {name}.";
        either_or(one: &str, other: &str) = "{one} or {other}";
        by_the_assembly = "In this assembly:";
        angle_of_minus(what: &str) = "angle of -({what})";
        others_turn_with(name: &str, along: &str, left: &str) =
            "The other sides that turn with {name} lie t = {along} along it and e = {left} to its left:";
        does_not_reach_guide(arm: &str) = "It is negative: {arm} does not reach the guide.";
        root_would_close =
            "The loop closes, but the motion from the scene's assembly does not reach this position.";

        // Coupled groups.
        solved_at_once = "Where it can be assembled, it is solved as a whole by Newton's method.";
        no_part_alone =
            "No part of it can be solved alone: all equations f(z) = 0 are solved together by Newton's method, z - \
             dz with J dz = f, J the derivatives of f with respect to z. The final state:";
        equations_left = "The equations and their residuals:";
        jacobian_too_large(n: usize) = "J has {n} x {n} entries, too many to print.";
        jacobian_rows = "J, one row per equation; the unit of an entry is that of its row over that of its column:";
        sides_by_joints = "The unknowns of the vectors between the joints:";
        joint = "joint";
        two_ways(coordinate: &str, point: &str) = "{coordinate} of {point} two ways";
        distance_from_guide(point: &str) = "distance of {point} from its guide";
        found_together = "Found together:";

        // Rates.
        velocities_part = "Velocities";
        accelerations_part = "Accelerations";
        differentiated = "The time derivative of the loop equations:";
        differentiated_again = "Differentiated once more:";
        rates_are_limits =
            "The equations are singular here; the values are limits along the motion.";
        no_rates_at_dead_point = "They do not exist at a dead point. The equations, which have no solution here:";
        do_not_exist_either = "They do not exist here either.";
        none_without_assembly = "Without an assembly there are none. The equations:";
        nothing_sought_in_it = "It has no unknowns.";
        factor_vanishes(symbol: &str) = "The coefficient of {symbol} is 0; the limit along the motion is:";
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
        lies_on(base: &str) = "It coincides with {base} and moves with it.";
        does_not_turn(link: &str, base: &str) = "{link} does not turn: every point of it moves as {base} does.";
        at_degrees(figure: &str, direction: &str) = "{figure} at {direction} deg";
        between_normal_part(angle: &str, symbol: &str) =
            "{angle} deg, between {symbol} and its normal component";
        along_guide_of(point: &str, slide: &str, body: &str) =
            "{point} along the guide of {slide} on {body}";
        of_under(symbol: &str, body: &str, point: &str) = "{symbol} of {body} under {point}";

        // Instant centres.
        instant_centres = "Instant centres";
        instant_centre = "instant centre";
        instant_centre_is =
            "The instant centre of a link is the point of the link that is at rest relative to the frame at this \
             instant. Every other point has v = |ω| times its distance from there. By Kennedy's theorem, the three \
             centres of three links are collinear.";
        common_centres(joints: &str) = "The common centre of two pinned links is their joint: {joints}.";
        centre_of_link(centre: &str, link: &str) = "{centre} of {link}";
        on_two_lines(centre: &str, one: &str, other: &str) =
            "{centre} lies on {one}, at β, and on {other}, at γ:";
        line_through(one: &str, other: &str) = "the line through {one} and {other}";
        line_across(joint: &str) = "the line through {joint} at right angles to its path";
        centre_by_velocity(centre: &str, point: &str, omega: &str) =
            "No two known lines cross clearly at {centre}; from the velocity of {point} and {omega}:";
        centre_of_guided(link: &str, direction: &str) =
            "{link} does not turn: its centre lies at infinity, perpendicular to its velocity, at {direction} deg \
             and in the opposite direction.";
        centre_far(link: &str, direction: &str) =
            "To the precision of its digits, {link} does not turn at this instant: its centre lies at infinity, \
             perpendicular to its velocity, at {direction} deg and in the opposite direction.";
        link_is_at_rest(link: &str) = "{link} is at rest at this instant: every point of it is a centre.";
        centre_is_blurred(link: &str, digits: usize) =
            "{link} hardly turns, and its centre is far away; {digits} of its digits are known:";
        at_infinity = "at infinity";

        // The check.
        check_part = "Check";
        nothing_to_check = "Without an assembly there is nothing to check.";
        figures_do_not_differ = "The values above and those of the solver do not differ.";
        figures_differ(part: &str, symbol: &str) =
            "The values above and those of the solver differ by at most {part} of their size (at {symbol}).";
        left_of_loops = "The residuals of the loop equations with all numbers inserted:";
        loop_component(number: usize, axis: &dyn Display) = "loop {number} {axis}";
    }
}
