//! Tests the other dyads, and six-bars of two dyads, with known solutions.

use crate::four_bar::pose;
use crate::plant::*;
use crate::support::U;
use krank::solver::{Order, Solver};
use krank::{Body, Driver, Input, Mechanism, Vec2};
use proptest::prelude::*;

proptest! {
    #[test]
    fn planted_slider_crank_is_recovered(
        crank in crank(),
        rod in (length(), angle()),
        guide in (prop_oneof![2 => angle(), 1 => Just(0.0), 1 => Just(90.0)], -2.0..2.0_f64),
        lean in prop_oneof![1 => Just(None), 1 => tiny().prop_map(Some)],
    ) {
        let along = unit(guide.0);
        // Near its toggle the rod is nearly perpendicular to the guide.
        let rod_direction = match lean {
            None => unit(rod.1),
            Some(lean) => along.perp() + along * lean,
        };
        let joint_at = crank.pin() + rod_direction * rod.0;
        let through = joint_at - along * guide.1;
        let mut builder = Mechanism::builder();
        let pin = crank.build(&mut builder);
        let joint = builder.moving_point();
        let length = (joint_at - crank.pin()).norm();
        builder.link(pin, joint, length);
        let slide = builder.pin_in_slot(joint, Body::Ground, through, guide.0);
        builder.start(joint, joint_at);
        let mechanism = builder.build().expect("a sound slider-crank");
        let scale = length.max(crank.length).max(through.norm()).max(guide.1.abs());
        let sin_mu = sine(joint_at - crank.pin(), along.perp());
        if let Some(solver) = open(&mechanism, scale, sin_mu, ROUNDINGS * scale / length) {
            let state = at_start(&solver, &mechanism, Order::Position);
            let allowed = allowance(ROUNDINGS, sin_mu) * scale;
            let off = (state.position(joint).unwrap() - joint_at).norm();
            prop_assert!(off <= allowed, "{off:e} > {allowed:e}, sin mu {sin_mu:e}");
            let off = (state.travel(slide).unwrap().position - guide.1).abs();
            prop_assert!(off <= 2.0 * allowed, "travel {off:e} > {allowed:e}");
            closes(&solver, &mechanism, scale);
        }
    }

    #[test]
    fn planted_inverted_slider_crank_is_recovered(
        crank in crank(),
        lever in angle(),
        along in prop_oneof![1 => length(), 1 => tiny().prop_map(f64::abs)],
        forward in sign(),
        offset in (prop_oneof![2 => Just(0.0), 1 => length()], sign()),
    ) {
        // The slot lies `offset` to the left of the lever's x axis; the pin is at `reach` along it.
        let reach = along * forward;
        // Pin and pivot must not coincide, so that a short reach needs an offset.
        let offset = offset.1 * if along < 0.1 { offset.0.max(0.1) } else { offset.0 };
        let direction = unit(lever);
        let pivot_at = crank.pin() - Vec2::new(reach, offset).turned(direction);
        let mut builder = Mechanism::builder();
        let pin = crank.build(&mut builder);
        let pivot = builder.ground_point(pivot_at.x, pivot_at.y);
        let tip = builder.moving_point();
        let link = builder.link(pivot, tip, 1.0);
        let slide = builder.pin_in_slot(pin, Body::Link(link), Vec2::new(0.0, offset), 0.0);
        builder.start(tip, pivot_at + direction);
        let mechanism = builder.build().expect("a sound inverted slider-crank");
        let scale = crank.length.max(pivot_at.norm()).max(reach.abs()).max(offset.abs()).max(1.0);
        // The reach follows from distance and offset by a square root, which is the measure.
        let distance = (pivot_at - crank.pin()).norm();
        let sin_mu = (reach / distance).abs();
        if let Some(solver) = open(&mechanism, scale, sin_mu, ROUNDINGS * scale / distance) {
            let state = at_start(&solver, &mechanism, Order::Position);
            let allowed = allowance(ROUNDINGS, sin_mu) * scale / distance;
            let off = (state.direction(link).unwrap() - direction).norm();
            prop_assert!(off <= allowed, "{off:e} > {allowed:e}, s / D {sin_mu:e}");
            let off = (state.travel(slide).unwrap().position - reach).abs();
            prop_assert!(off <= allowed * distance, "travel {off:e}");
            closes(&solver, &mechanism, scale);
        }
    }

    #[test]
    fn planted_pin_in_two_slots_is_recovered(
        angle_of_crank in angle(),
        first in (angle(), -2.0..2.0_f64),
        crossing in crossing(),
        second in -2.0..2.0_f64,
        joint_at in (-2.0..2.0_f64, -2.0..2.0_f64),
    ) {
        // A slot in the crank and one in the ground: the dyad of two guides, PRP.
        let joint_at = Vec2::new(joint_at.0, joint_at.1);
        let turned = unit(angle_of_crank);
        let slot = unit(first.0).turned(turned);
        let guide_angle = angle_of_crank + first.0 + crossing;
        let guide = unit(guide_angle);
        let through = (joint_at - slot * first.1).turned(turned.conj());
        let through_ground = joint_at - guide * second;
        let mut builder = Mechanism::builder();
        let crank = builder.free_link();
        let pivot = builder.ground_point(0.0, 0.0);
        builder.carry(crank, pivot, Vec2::ZERO);
        builder.driver(Driver {
            input: Input::Turn(crank),
            start: angle_of_crank,
            speed: 1.0,
            acceleration: 0.0,
        });
        let joint = builder.moving_point();
        builder.pin_in_slot(joint, Body::Link(crank), through, first.0);
        builder.pin_in_slot(joint, Body::Ground, through_ground, guide_angle);
        builder.start(joint, joint_at);
        let mechanism = builder.build().expect("a sound tangent mechanism");
        let solver = Solver::new(&mechanism).expect("crossing slots");
        let state = at_start(&solver, &mechanism, Order::Position);
        let scale = 8.0;
        // Two lines: without a square root the error stays proportional to 1 / sin(mu). The angles of
        // the slots are sums of degrees up to 900, with 2^-44 deg of rounding each.
        let sin_mu = sine(slot, guide);
        let allowed = 4.0 * ROUNDINGS * U * scale / sin_mu;
        let off = (state.position(joint).unwrap() - joint_at).norm();
        prop_assert!(off <= allowed, "{off:e} > {allowed:e}, sin mu {sin_mu:e}");
    }

    #[test]
    fn planted_yoke_is_recovered(
        crank in crank(),
        guide in (angle(), -2.0..2.0_f64),
        turn in prop_oneof![2 => Just(0.0), 1 => angle()],
        slot in (crossing(), -2.0..2.0_f64),
        travel in -2.0..2.0_f64,
    ) {
        // A yoke that does not turn against its guide, with a slot for the crank's pin: RPP.
        let along = unit(guide.0);
        let yoke_axis = unit(turn).turned(along);
        let slot_in_yoke = slot.0 - turn;
        let slot_axis = unit(slot_in_yoke).turned(yoke_axis);
        // The slot passes through the pin; the yoke's origin is arbitrary.
        let origin_at = crank.pin() - slot_axis * slot.1;
        let through = origin_at - along * travel;
        let mut builder = Mechanism::builder();
        let pin = crank.build(&mut builder);
        let yoke = builder.free_link();
        let origin = builder.moving_point();
        builder.carry(yoke, origin, Vec2::ZERO);
        let guide_slide = builder.sliding_link(yoke, turn, Body::Ground, through, guide.0);
        let slot_slide = builder.pin_in_slot(pin, Body::Link(yoke), Vec2::ZERO, slot_in_yoke);
        builder.start(origin, origin_at);
        let mechanism = builder.build().expect("a sound yoke");
        let solver = Solver::new(&mechanism).expect("crossing guides");
        let state = at_start(&solver, &mechanism, Order::Acceleration);
        let scale = crank.length.max(through.norm()).max(4.0);
        let sin_mu = sine(along, slot_axis);
        let allowed = 4.0 * ROUNDINGS * U * scale / sin_mu;
        let off = (state.position(origin).unwrap() - origin_at).norm();
        prop_assert!(off <= allowed, "{off:e} > {allowed:e}, sin mu {sin_mu:e}");
        let off = (state.travel(guide_slide).unwrap().position - travel).abs();
        prop_assert!(off <= allowed, "travel {off:e} > {allowed:e}");
        let off = (state.travel(slot_slide).unwrap().position - slot.1).abs();
        prop_assert!(off <= 2.0 * allowed, "slot {off:e} > {allowed:e}");
        prop_assert_eq!(state.omega(yoke).unwrap(), 0.0);
        prop_assert_eq!(state.alpha(yoke).unwrap(), 0.0);
    }

    #[test]
    fn planted_six_bar_is_recovered(
        pose in pose(open_apex()),
        bodies in prop_oneof![Just((0, 1)), Just((0, 2)), Just((1, 2)), Just((2, 0))],
        locals in [(-1.5..1.5_f64, -1.5..1.5_f64), (-1.5..1.5_f64, -1.5..1.5_f64)],
        apex in apex(),
    ) {
        // The second dyad is attached to two different bodies of: coupler, rocker, ground.
        let (first, second) = ((bodies.0, locals[0]), (bodies.1, locals[1]));
        let pin = pose.crank.pin();
        let (b, c) = pose.lengths();
        let (u, v) = ((pose.joint - pin) / b, (pose.pivot - pose.joint) / c);
        let anchor = |(body, local): (usize, (f64, f64))| {
            let local = Vec2::new(local.0, local.1);
            match body {
                0 => pin + local.turned(u),
                1 => pose.joint + local.turned(v),
                _ => local,
            }
        };
        let (e_at, f_at) = (anchor(first), anchor(second));
        if (f_at - e_at).norm() < 0.05 {
            return Ok(());
        }
        let apex_at = apex.place(e_at, f_at);
        let mut builder = Mechanism::builder();
        let b_pin = pose.crank.build(&mut builder);
        let d = builder.ground_point(pose.pivot.x, pose.pivot.y);
        let joint = builder.moving_point();
        let coupler = builder.link(b_pin, joint, b);
        let rocker = builder.link(joint, d, c);
        let mut carry = |(body, local): (usize, (f64, f64))| {
            let local = Vec2::new(local.0, local.1);
            match body {
                0 | 1 => {
                    let point = builder.moving_point();
                    builder.carry(if body == 0 { coupler } else { rocker }, point, local);
                    point
                }
                _ => builder.ground_point(local.x, local.y),
            }
        };
        let (e, f) = (carry(first), carry(second));
        let apex_point = builder.moving_point();
        builder.link(e, apex_point, (apex_at - e_at).norm());
        builder.link(apex_point, f, (apex_at - f_at).norm());
        builder.start(joint, pose.joint);
        builder.start(apex_point, apex_at);
        let mechanism = builder.build().expect("a sound six-bar");
        let scale = pose.scale().max((apex_at - e_at).norm()).max((apex_at - f_at).norm()).max(3.0);
        // The first dyad's error, amplified by the lever of its links, enters the second.
        let lever = 1.0 + 3.0 / b.min(c);
        let before = allowance(pose.roundings(), pose.sin_mu()) * lever;
        let sin_mu = sine(apex_at - e_at, apex_at - f_at);
        let roundings = before / U + ROUNDINGS;
        let shortest = (apex_at - e_at).norm().min((apex_at - f_at).norm());
        let Some(solver) = open(&mechanism, scale, sin_mu, roundings * scale / shortest) else { return Ok(()) };
        let state = at_start(&solver, &mechanism, Order::Position);
        let off = (state.position(apex_point).unwrap() - apex_at).norm();
        let allowed = roundings * U * scale / sin_mu.max((roundings * U).sqrt());
        prop_assert!(off <= allowed, "{off:e} > {allowed:e}, sin mu {sin_mu:e}");
        closes(&solver, &mechanism, scale);
    }
}
