//! The working of forces: free bodies, pins and the driver.

use super::English;

catalogue! {
    /// What is said between the equations of forces.
    trait ReactionsWords for English {
        forces_part = "Forces";
        reactions_need_not_exist =
            "The reactions need not exist at this place; the driver's torque follows from the \
             virtual work.";
        reactions_open(links: &str) =
            "A redundant linkage leaves reactions open of {links}: equilibrium alone does not tell \
             them.";
        order_of_groups(groups: &str) =
            "The reactions are the unknowns in the equations of motion of the links below. They are \
             found group by group, the last first, since a group hands on what it bears to those \
             before it: {groups}. The driver's own comes last.";
        dyad_by_two_sums(point: &str, first: &str, sums: [&str; 2], second: &str) = {
            let [one, other] = sums;
            format!("F is the force at {point} on {first}; -F acts on {second}, and what acts on the pin itself is \
                     counted there. The outer reactions have no share in two sums: of {first} {one}, and of \
                     {second} {other}.")
        };
        one_sum(sum: &str, reaction: &str) = "One sum is free of {reaction}: {sum}.";
        reaction_at(point: &str) = "the reaction at {point}";
        reaction_of_guide(slide: &str) = "what the guide of {slide} bears";
        vector_is(letter: char, vector: &str) = "{letter} is {vector}.";
        arm_from_to(from: &str, to: &str) = "the arm from {from} to {to} in m; x and y count from {from}";
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
            "The equations of all links, for {unknowns} unknowns; where a load acts on a pin, the balance of that pin, \
             below, is one of them:";
        reactions_too_many(links: usize) =
            "The reactions of {links} links are found at once: too many equations to be read.";
        sought_reaction = "unknown";
        what_it_is = "what it is";
        sums_of_link(link: &str, about: &str) =
            "The sums of {link} along x and y, and of the moments about {about} in N m, arms in m:";
        solved_one_by_one = "Where one unknown is left in a sum it is found, and put into the others:";
        others_at_once(names: &str) = "The others depend on one another, and are found at once: {names}.";
        sum_on(what: &str, link: &str) = "sum of {what} on {link}";
        no_balance_at_dead_point =
            "At a dead point the mechanical advantage is infinite: no torque of the driver balances \
             the loads, and the reactions do not exist.";
        no_forces_without_assembly = "Without an assembly there are none.";
        no_forces_here = "They do not exist here.";
        loads_here = "The loads here:";

        // What acts.
        kind_press = "press";
        kind_spring = "spring";
        acts_at(what: &str, point: &str) = "{what} at {point}";
        acts_on(what: &str, link: &str) = "{what} on {link}";
        spring_between(from: &str, to: &str) = "L from {from} to {to}";
        pull_of_spring = "Of a spring, its pull with the lengths in m:";
        pull_of_gas_spring = "A gas spring pushes with the force p that is given over its length L:";
        push_by_line = "By the line of its curve between the knots (L1, p1) and (L2, p2):";
        push_beyond_knots = "Beyond the knots of its curve the force stays as it is at the nearest of them:";
        torque_of_torsion_spring(link: &str) =
            "A torsion spring turns {link} back, by the angle θ from its free angle θ0:";
        distance_of_press(slide: &str) =
            "The press stands at the distance d from the end of its stroke, where {slide} is r0:";
        press_by_line =
            "It presses with p, by the line of its curve from the knot (d1, p1) to the knot (d2, p2):";
        press_opens = "It goes back, and does not press.";
        press_has_not_begun(reach: &str) = "It presses from {reach} before the end on, and not yet.";
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
            "A load at a pin acts on the pin, which has no mass; it acts on the links against what \
             they bear there:";
        forces_along(axis: &str, point: &str) = "forces along {axis} at {point}";

        // The driver.
        torque_of_driver = "The driver's torque";
        force_of_driver = "The driver's force";
        torque_checked_by_work(torque: &str) =
            "The driver's torque of {torque} follows from the balance of the links. The virtual work \
             of the loads, of gravity and of inertia must give the same, and is its check. Each share \
             is the power of its forces, with the other sign, divided by the driver's speed.";
        force_checked_by_work(force: &str) =
            "The driver's force of {force} follows from the balance of the links. The virtual work \
             of the loads, of gravity and of inertia must give the same, and is its check. Each share \
             is the power of its forces, with the other sign, divided by the driver's speed.";
        effort_by_work =
            "By the virtual work of the loads, of gravity and of inertia. Each share is the power of \
             its forces, with the other sign, divided by the driver's speed.";
        frame_feels(x: &str, y: &str, moment: &str) =
            "The frame feels {x} N along x, {y} N along y and a moment of {moment} N m about the \
             origin. What is left of the balance of power and of the equilibrium of the whole, each \
             found by a way of its own:";
        virtual_work = "virtual work";
        forces_in(axis: &str) = "forces, {axis}";
        moments = "moments";
    }
}
