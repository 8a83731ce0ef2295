//! The working of the forces: free bodies, pins and the driver.

use super::English;

catalogue! {
    /// The text between the equations of the forces.
    trait ReactionsWords for English {
        forces_part = "Forces";
        reactions_need_not_exist =
            "The reactions may not exist at this position; the driver's torque follows from the virtual work.";
        reactions_open(links: &str) =
            "The linkage is statically indeterminate: equilibrium alone does not determine the reactions of \
             {links}.";
        order_of_groups(groups: &str) =
            "The reactions are the unknowns in the equations of motion of the links below. Groups are solved in \
             reverse order, since each transmits its load to those before it: {groups}. The driver comes last.";
        dyad_by_two_sums(point: &str, first: &str, sums: [&str; 2], second: &str) = {
            let [one, other] = sums;
            format!("F is the force at {point} on {first}; -F acts on {second}, with any load on the pin itself. \
                     Two sums contain no outer reaction: for {first} {one}, and for {second} {other}.")
        };
        one_sum(sum: &str, reaction: &str) = "One sum does not contain {reaction}: {sum}.";
        reaction_at(point: &str) = "the reaction at {point}";
        reaction_of_guide(slide: &str) = "the guide force of {slide}";
        vector_is(letter: char, vector: &str) = "{letter} is {vector}.";
        arm_from_to(from: &str, to: &str) = "the arm from {from} to {to} in m; x and y are measured from {from}";
        unit_vector_along(at: &str) = "the unit vector at {at} deg";
        moments_about(point: &str) = "the moments about {point}";
        forces_along_guide(slide: &str, at: &str) = "the forces along the guide of {slide}, at {at} deg";
        moment_about(point: &str) = "about {point}";
        force_along = "along it";
        known_on(link: &str) = "known on {link}";
        so_that = "Both sums are 0:";
        part_at(part: &str, link: &str, point: &str) = "{part} on {link} at {point}";
        across(name: &str) = "{name}, across";
        along(name: &str) = "{name}, along";
        moment_of(name: &str) = "{name}, moment";
        reactions_at_once(unknowns: usize) =
            "The equations of all links, for {unknowns} unknowns; they include the balance of each loaded pin, \
             below:";
        reactions_too_many(links: usize) =
            "The reactions of {links} links are solved together: too many equations to print.";
        sought_reaction = "unknown";
        what_it_is = "meaning";
        sums_of_link(link: &str, about: &str) =
            "The sums of {link}: forces along x and y, and moments about {about} in N m, arms in m:";
        solved_one_by_one =
            "A sum with one remaining unknown gives its value, which is inserted into the other sums:";
        others_at_once(names: &str) = "The other unknowns are coupled and solved together: {names}.";
        sum_on(what: &str, link: &str) = "sum of {what} on {link}";
        no_balance_at_dead_point =
            "At a dead point the mechanical advantage is infinite: no driver torque balances the loads, and the \
             reactions do not exist.";
        no_forces_without_assembly = "Without an assembly there are no forces.";
        no_forces_here = "Forces do not exist here.";
        loads_here = "The loads here:";

        // Loads.
        kind_press = "press";
        kind_spring = "spring";
        acts_at(what: &str, point: &str) = "{what} at {point}";
        acts_on(what: &str, link: &str) = "{what} on {link}";
        spring_between(from: &str, to: &str) = "L from {from} to {to}";
        pull_of_spring = "The pull of a spring, with lengths in m:";
        pull_of_gas_spring = "A gas spring pushes with the force p, given over its length L:";
        push_by_line = "Interpolated linearly between the knots (L1, p1) and (L2, p2):";
        push_beyond_knots = "Beyond the knots, the force is that of the nearest knot:";
        torque_of_torsion_spring(link: &str) =
            "A torsion spring acts on {link}; θ is the angle from its free angle θ0:";
        distance_of_press(slide: &str) =
            "The press is at the distance d from the end of its stroke, where {slide} is r0:";
        press_by_line = "Its force p is interpolated linearly between the knots (d1, p1) and (d2, p2):";
        press_opens = "The slide opens, so the press exerts no force.";
        press_has_not_begun(reach: &str) =
            "The press acts only within {reach} of the end of its stroke, so it exerts no force yet.";
        pull = "pull";
        factor = "factor";
        weight = "weight";
        weight_of(link: &str) = "weight of {link}";
        inertia_of(link: &str) = "inertia of {link}";
        column_of = "of";
        column_formula = "formula";
        column_load = "load";
        symbols_of(symbols: &str, link: &str) = "{symbols} of {link}";

        // A free body.
        link_part(name: &str) = "Link {name}";
        on_it = "on it";
        motion_about(point: &str) =
            "x and y from {point}, moments about it. The equations of motion:";
        motion_about_accelerated(point: &str) =
            "x and y from {point}, moments about it. The equations of motion, with the acceleration \
             of {point} in \u{e000}m/s^2:";
        guide_of(slide: &str) = "guide of {slide}";
        slider_of(slide: &str) = "slider of {slide}";
        pin_by(link: &str, point: &str, by: &str) = "{link} at {point} by {by}";
        pin_by_ground(link: &str, point: &str) = "{link} at {point} by ground";

        // A pin.
        pin_part(name: &str) = "Pin {name}";
        load_at_pin =
            "A load at a pin acts on the pin, which has no mass; the links balance it with their forces there:";
        forces_along(axis: &str, point: &str) = "forces along {axis} at {point}";

        // The driver.
        torque_of_driver = "The driver's torque";
        force_of_driver = "The driver's force";
        torque_checked_by_work(torque: &str) =
            "The driver's torque of {torque} follows from the balance of the links. As a check, the virtual work \
             of the loads, of gravity and of inertia must give the same. Each share is the negative power of its \
             forces, divided by the driver's speed.";
        force_checked_by_work(force: &str) =
            "The driver's force of {force} follows from the balance of the links. As a check, the virtual work of \
             the loads, of gravity and of inertia must give the same. Each share is the negative power of its \
             forces, divided by the driver's speed.";
        effort_by_work =
            "From the virtual work of the loads, of gravity and of inertia. Each share is the negative power of \
             its forces, divided by the driver's speed.";
        frame_feels(x: &str, y: &str, moment: &str) =
            "The frame carries {x} N along x, {y} N along y and a moment of {moment} N m about the origin. \
             Residuals of the power balance and of the equilibrium of the whole, each computed independently:";
        virtual_work = "virtual work";
        forces_in(axis: &str) = "forces, {axis}";
        moments = "moments";
    }
}
