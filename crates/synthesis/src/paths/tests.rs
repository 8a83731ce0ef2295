use super::*;
use crate::tests::planted::{KnownLinkage, tracer};
use kinematics::Vec2;
use kinematics::numeric::SeededRng;

fn task(points: Vec<Vec2>, closed: bool, turns: Option<Vec<f64>>) -> PathTask {
    PathTask {
        weights: vec![1.0; points.len()],
        points,
        closed,
        turns,
        pivots: Vec::new(),
    }
}

fn search(task: &PathTask) -> PathSearch<'_> {
    PathSearch {
        task,
        four_bars: true,
        slider_cranks: false,
        preferences: Preferences::default(),
        seed: 1,
        threads: 2,
        starts: 24,
    }
}

fn found(task: &PathTask) -> Vec<Proposal> {
    search(task).run(&mut |_| true).found
}

fn size(points: &[Vec2]) -> f64 {
    let corner = |of: fn(f64, f64) -> f64| {
        points
            .iter()
            .copied()
            .reduce(|p, q| Vec2::new(of(p.x, q.x), of(p.y, q.y)))
            .unwrap()
    };
    let box_ = corner(f64::max) - corner(f64::min);
    box_.x.max(box_.y)
}

/// Returns the root mean square of the misses, relative to the path's size.
fn rms(proposal: &Proposal, points: &[Vec2]) -> f64 {
    let squares: f64 = (0..points.len())
        .map(|j| (tracer(proposal, j) - points[j]).norm2())
        .sum();
    (squares / points.len() as f64).sqrt() / size(points)
}

/// Draws a linkage that reaches `count` points of a turn, or of a part of one, and returns it with
/// its turns and points.
fn planted(
    rng: &mut SeededRng,
    slides: bool,
    closed: bool,
    count: usize,
) -> (KnownLinkage, Vec<f64>, Vec<Vec2>) {
    loop {
        let planted = KnownLinkage::random(rng, slides);
        let span = if closed {
            360.0
        } else {
            140.0 + 60.0 * rng.even()
        };
        let intervals = if closed { count } else { count - 1 };
        let turns: Vec<f64> = (0..count)
            .map(|j| span * j as f64 / intervals as f64)
            .collect();
        let complete: Option<Vec<_>> = (0..=60)
            .map(|k| planted.at(span * f64::from(k) / 60.0))
            .collect();
        if complete.is_none() {
            continue;
        }
        let points: Vec<Vec2> = turns.iter().map(|t| planted.at(*t).unwrap()[2]).collect();
        if size(&points) > 0.2 {
            return (planted, turns, points);
        }
    }
}

/// Returns `true` if the tracer of a linkage passes within a distance of a point, at some angle of
/// its own crank in its own assembly. The crank's angles are sampled, and the best ones refined.
fn passes(proposal: &Proposal, position: Vec2, near: f64) -> bool {
    let (crank, coupler, rocker) = proposal.lengths().unwrap();
    let [b, c] = proposal.places[0];
    let k = c - b;
    let arm = (proposal.tracer.unwrap() - b).turned(k.conj()) * (1.0 / k.norm2());
    let PinConstraint::Rocker(d) = proposal.partner else {
        return false;
    };
    let bar = KnownLinkage {
        pivot: proposal.pivot,
        far: proposal.partner,
        crank,
        coupler,
        rocker: rocker.unwrap(),
        arm,
        start: 0.0,
        sign: (d - b).cross(c - b).signum(),
        across: 0.0,
    };
    let distance = |angle: f64| {
        let at = bar.at(angle).map(|[_, _, p]| (p - position).norm());
        at.unwrap_or(f64::INFINITY)
    };
    let mut step = 1.0;
    let mut starts: Vec<f64> = (0..360).map(f64::from).collect();
    starts.sort_by(|x, y| distance(*x).total_cmp(&distance(*y)));
    starts[..8].iter().any(|&start| {
        let mut angle = start;
        step = 1.0;
        while step > 1e-13 {
            let best = [angle - step, angle + step]
                .into_iter()
                .min_by(|x, y| distance(*x).total_cmp(&distance(*y)))
                .unwrap();
            if distance(best) < distance(angle) {
                angle = best;
            } else {
                step *= 0.5;
            }
        }
        distance(angle) < near
    })
}

/// Returns how many of `count` known four-bars are found; their curve between the points, too, must
/// agree to 1e-9.
fn recovered(closed: bool, timed: bool, count: u32) -> u32 {
    let mut rng = SeededRng::new(7 + u64::from(closed));
    (0..count)
        .map(|k| {
            let points = 12 + k as usize;
            let (planted, turns, points) = planted(&mut rng, false, closed, points);
            let between: Vec<Vec2> = turns
                .windows(2)
                .filter_map(|pair| planted.at(0.5 * (pair[0] + pair[1])))
                .map(|[_, _, p]| p)
                .collect();
            let near = 1e-9 * size(&points);
            let task = task(points, closed, timed.then_some(turns));
            let is_met = |p: &Proposal| {
                rms(p, &task.points) < 1e-9
                    && between.iter().all(|position| passes(p, *position, near))
            };
            u32::from(found(&task).iter().any(is_met))
        })
        .sum()
}

#[test]
fn planted_four_bars_with_times_are_recovered() {
    let shares = [recovered(false, true, 12), recovered(true, true, 12)];
    assert!(shares[0] >= 12 && shares[1] >= 12, "{shares:?}");
}

/// Without times, an open path has long valleys in which the descent does not converge: only some
/// are found.
#[test]
fn some_planted_four_bars_without_times_are_recovered() {
    let shares = [recovered(false, false, 12), recovered(true, false, 12)];
    assert!(shares[0] >= 4 && shares[1] >= 10, "{shares:?}");
}

#[test]
fn planted_slider_cranks_are_recovered() {
    let mut rng = SeededRng::new(3);
    let mut met = [0, 0];
    for k in 0..10 {
        for timed in [false, true] {
            let (_, turns, points) = planted(&mut rng, true, k % 2 == 0, 12 + k);
            let task = task(points, k % 2 == 0, timed.then_some(turns));
            let all = PathSearch {
                four_bars: false,
                slider_cranks: true,
                ..search(&task)
            }
            .run(&mut |_| true);
            let slides = |p: &Proposal| matches!(p.partner, PinConstraint::Slide(_));
            assert!(all.found.iter().all(slides) && !all.is_complete);
            met[usize::from(timed)] +=
                u32::from(all.found.iter().any(|p| rms(p, &task.points) < 1e-9));
        }
    }
    // Without times, most of the closed half are found, and few of the open half.
    assert!(met[0] >= 4 && met[1] >= 10, "{met:?}");
}

/// With noise of 1 % of the size, the linkages found miss by no more than the noise.
#[test]
fn misses_do_not_exceed_noise() {
    let mut rng = SeededRng::new(21);
    for k in 0..6 {
        let (_, turns, mut points) = planted(&mut rng, false, k % 2 == 0, 16 + k);
        let noise = 0.01 * size(&points);
        let mut missed = 0.0;
        for point in &mut points {
            let [x, y] = rng.normal();
            let shift = Vec2::new(x, y) * (noise * 0.5_f64.sqrt());
            missed += shift.norm2() / (16 + k) as f64;
            *point += shift;
        }
        for turns in [None, Some(turns)] {
            let task = task(points.clone(), k % 2 == 0, turns);
            let best = found(&task)
                .iter()
                .map(|p| rms(p, &points))
                .fold(f64::INFINITY, f64::min);
            assert!(best <= missed.sqrt() / size(&points), "{best} {missed}");
        }
    }
}

/// Two to six points on a line are met.
#[test]
fn few_points_on_line_are_met() {
    for count in 2..=6 {
        let points: Vec<Vec2> = (0..count)
            .map(|j| Vec2::new(20.0, 20.0 + 5.0 * f64::from(j)))
            .collect();
        let found = found(&task(points.clone(), false, None));
        assert!(found.len() > 3, "{count} points: {}", found.len());
        let squares = |p: &Proposal| -> f64 {
            (0..points.len())
                .map(|j| (tracer(p, j) - points[j]).norm2())
                .sum()
        };
        let met = found.iter().filter(|p| squares(p) < 1e-18).count();
        assert!(met > 3, "{count} points: {met} of {}", found.len());
    }
}

/// The result contains given pivots bit for bit, on either side.
#[test]
fn given_pivots_are_kept() {
    let mut rng = SeededRng::new(33);
    let (planted, _, points) = planted(&mut rng, false, true, 14);
    let PinConstraint::Rocker(d) = planted.far else {
        panic!("a four-bar")
    };
    for pivots in [
        vec![planted.pivot],
        vec![d],
        vec![planted.pivot, d],
        vec![d, planted.pivot],
    ] {
        let task = PathTask {
            pivots: pivots.clone(),
            ..task(points.clone(), true, None)
        };
        let found = found(&task);
        assert!(found.iter().any(|p| rms(p, &points) < 1e-9), "{pivots:?}");
        for proposal in &found {
            let PinConstraint::Rocker(far) = proposal.partner else {
                panic!("a four-bar")
            };
            assert!(pivots.iter().all(|p| [proposal.pivot, far].contains(p)));
            let (crank, coupler, rocker) = proposal.lengths().unwrap();
            let near = 1e-12 * crank.max(coupler).max(far.norm()).max(1.0);
            for [b, c] in &proposal.places {
                assert!(((*b - proposal.pivot).norm() - crank).abs() < near);
                assert!(((*c - far).norm() - rocker.unwrap()).abs() < near);
            }
        }
    }
    // A slider-crank has one pivot, and no linkage has three.
    for pivots in [
        vec![planted.pivot, d],
        vec![planted.pivot, d, Vec2::ZERO],
        vec![d, d],
    ] {
        let task = PathTask {
            pivots,
            ..task(points.clone(), true, None)
        };
        let all = PathSearch {
            four_bars: task.pivots.len() != 2 || d == task.pivots[0],
            slider_cranks: true,
            ..search(&task)
        };
        assert_eq!(all.run(&mut |_| true).found, []);
    }
}

/// A point of zero weight has no influence, and one of very large weight is met.
#[test]
fn weights_control_misses() {
    let mut rng = SeededRng::new(8);
    let (_, turns, mut points) = planted(&mut rng, false, true, 14);
    let shift = Vec2::new(0.5, 0.3) * size(&points);
    points[4] += shift;
    let mut task = task(points.clone(), true, Some(turns));
    let miss = |p: &Proposal, j: usize| (tracer(p, j) - points[j]).norm() / size(&points);
    let even = found(&task);
    assert!(miss(&even[0], 0) > 1e-4);
    task.weights[4] = 0.0;
    let without = found(&task);
    let others = |p: &Proposal| (0..14).filter(|j| *j != 4).all(|j| miss(p, j) < 1e-9);
    assert!(without.iter().any(others));
    task.weights[4] = 1e6;
    assert!(miss(&found(&task)[0], 4) < 1e-3 * miss(&even[0], 4));
}

#[test]
fn same_seed_gives_same_linkages_for_any_thread_count() {
    let mut rng = SeededRng::new(2);
    let (_, _, points) = planted(&mut rng, false, false, 11);
    let task = task(points, false, None);
    let run = |threads, seed| {
        PathSearch {
            threads,
            seed,
            ..search(&task)
        }
        .run(&mut |_| true)
    };
    let one = run(1, 4);
    assert!(!one.found.is_empty());
    assert_eq!(one, run(3, 4));
    assert_eq!(one, run(0, 4));
    assert_ne!(one, run(2, 5));
}

#[test]
fn search_reports_progress_and_can_be_stopped() {
    let mut rng = SeededRng::new(2);
    let (_, _, points) = planted(&mut rng, false, false, 11);
    let task = task(points, false, None);
    let mut parts = Vec::new();
    let _ = search(&task).run(&mut |part| {
        parts.push(part);
        true
    });
    assert!(parts.windows(2).all(|pair| pair[0] <= pair[1]));
    assert_eq!(parts.last(), Some(&1.0));
    let mut requested = 0;
    let _ = PathSearch {
        starts: 100_000,
        ..search(&task)
    }
    .run(&mut |_| {
        requested += 1;
        requested < 3
    });
    assert!(requested < 100, "{requested}");
}

/// The linkages found are all different.
#[test]
fn results_are_distinct() {
    let points: Vec<Vec2> = (0..5)
        .map(|j| Vec2::new(f64::from(j), f64::from(j * j) * 0.1))
        .collect();
    let found = found(&task(points, false, None));
    assert!(found.len() > 5);
    for (i, p) in found.iter().enumerate() {
        for q in &found[..i] {
            assert!(p.places[0] != q.places[0] || p.pivot != q.pivot);
            let lengths = [p.lengths().unwrap(), q.lengths().unwrap()];
            let [(a, b, _), (c, d, _)] = lengths;
            let pivots = (p.pivot - q.pivot).norm();
            assert!((a - c).abs() + (b - d).abs() + pivots > 1e-6, "{p:?} {q:?}");
        }
    }
}

/// For any points, nothing panics and all results are finite.
#[test]
fn degenerate_points_give_finite_linkages() {
    let circle = |count: u32| -> Vec<Vec2> {
        let step = 360.0 / f64::from(count);
        (0..count)
            .map(|j| Vec2::new(1e3, 5.0) + angle::unit(step * f64::from(j)))
            .collect()
    };
    let line = |count: u32| {
        (0..count)
            .map(|j| Vec2::new(f64::from(j), 0.0))
            .collect::<Vec<_>>()
    };
    let near = vec![
        Vec2::ZERO,
        Vec2::new(1e-13, 0.0),
        Vec2::X,
        Vec2::new(1.0, 1e-15),
        Vec2::new(2.0, 1.0),
    ];
    let there_and_back: Vec<Vec2> = line(6)
        .into_iter()
        .chain(line(6).into_iter().rev())
        .collect();
    let far: Vec<Vec2> = circle(8)
        .iter()
        .map(|p| *p * 1e-9 + Vec2::new(1.0, 1.0))
        .collect();
    let huge: Vec<Vec2> = circle(8).iter().map(|p| *p * 1e150).collect();
    let all = [
        circle(12),
        line(9),
        near,
        there_and_back,
        far,
        huge,
        vec![Vec2::ZERO; 4],
        vec![Vec2::X],
        Vec::new(),
        vec![Vec2::ZERO, Vec2::X],
        vec![Vec2::ZERO, Vec2::new(f64::NAN, 0.0), Vec2::X],
        vec![
            Vec2::ZERO,
            Vec2::new(f64::MAX, 0.0),
            Vec2::new(-f64::MAX, 0.0),
        ],
    ];
    for points in all {
        for closed in [false, true] {
            let equal = vec![0.0; points.len()];
            for turns in [None, Some(equal), Some(vec![1.0])] {
                let task = task(points.clone(), closed, turns);
                let found = PathSearch {
                    slider_cranks: true,
                    starts: 8,
                    ..search(&task)
                }
                .run(&mut |_| true);
                for p in &found.found {
                    let pins = p.places.iter().flatten().chain(&p.tracer);
                    assert!(pins.chain([&p.pivot]).all(|v| v.is_finite()), "{p:?}");
                    assert_eq!(p.places.len(), points.len());
                }
            }
        }
    }
    // A crank draws a circle, and a slide a line.
    for points in [circle(12), line(9)] {
        let task = task(points.clone(), false, None);
        let found = PathSearch {
            slider_cranks: true,
            ..search(&task)
        }
        .run(&mut |_| true)
        .found;
        assert!(found.iter().any(|p| rms(p, &points) < 1e-9));
    }
}

/// Compares the derivatives of the coupler's angle with difference quotients.
#[test]
fn coupler_rates_match_difference_quotients() {
    use super::shape::LinkageShape;
    let mut rng = SeededRng::new(6);
    let mut held = 0;
    for k in 0..200 {
        let form = if k % 2 == 0 {
            LinkageForm::FourBar
        } else {
            LinkageForm::SliderCrank
        };
        let shape = LinkageShape {
            form,
            sign: rng.even().signum(),
            crank: 0.7 + 0.5 * rng.even(),
            far: if k % 2 == 0 {
                1.0 + 0.5 * rng.even()
            } else {
                0.3 * rng.even()
            },
            ground: if k % 2 == 0 {
                1.2 + 0.5 * rng.even()
            } else {
                0.0
            },
        };
        let degrees = 180.0 * rng.even();
        let psi = |shape: &LinkageShape, degrees: f64| {
            let at = shape.coupling(angle::unit(degrees));
            (at.short == 0.0 && shape.transmission(&at) > 0.2).then(|| at.u.angle())
        };
        let h = 1e-5;
        let slope = |change: &dyn Fn(f64) -> Option<f64>| {
            let difference = change(h)? - change(-h)?;
            (difference.abs() < 1.0).then_some(difference / (2.0 * h))
        };
        let rates = shape.rates(angle::unit(degrees), &shape.coupling(angle::unit(degrees)));
        let pairs = [
            (
                slope(&|h| psi(&shape, degrees + h.to_degrees())),
                rates.by_angle,
            ),
            (
                slope(&|h| {
                    psi(
                        &LinkageShape {
                            crank: shape.crank + h,
                            ..shape
                        },
                        degrees,
                    )
                }),
                rates.by_crank,
            ),
            (
                slope(&|h| {
                    psi(
                        &LinkageShape {
                            far: shape.far + h,
                            ..shape
                        },
                        degrees,
                    )
                }),
                rates.by_far,
            ),
            (
                slope(&|h| {
                    psi(
                        &LinkageShape {
                            ground: shape.ground + h,
                            ..shape
                        },
                        degrees,
                    )
                }),
                rates.by_ground,
            ),
        ];
        let lengths = if form == LinkageForm::FourBar { 4 } else { 3 };
        for (slope, rate) in &pairs[..lengths] {
            if let Some(slope) = slope {
                assert!(
                    (slope - rate).abs() < 1e-7 * (1.0 + rate.abs()),
                    "{slope} {rate}"
                );
                held += 1;
            }
        }
    }
    assert!(held > 200, "{held}");
}

/// Noise along a curve changes the order of neighbours; the crank still turns one way and misses
/// little more.
#[test]
fn points_out_of_order_by_noise_are_met_in_order() {
    let turns: Vec<f64> = (0..120).map(|k| 1.5 * f64::from(k)).collect();
    let mut rng = SeededRng::new(11);
    let planted = loop {
        let planted = KnownLinkage::random(&mut rng, false);
        if let Some(proposal) = planted.proposal(&turns) {
            break proposal;
        }
    };
    let exact: Vec<Vec2> = (0..turns.len()).map(|j| tracer(&planted, j)).collect();
    let noise = 0.02 * size(&exact);
    let points = exact
        .iter()
        .map(|p| *p + Vec2::new(rng.even(), rng.even()) * noise)
        .collect();
    let task = task(points, false, None);
    let with = |ordered: bool| {
        let preferences = Preferences {
            ordered,
            ..Preferences::default()
        };
        let search = PathSearch {
            preferences,
            ..search(&task)
        };
        search.run(&mut |_| true).found
    };
    let is_ordered = |p: &Proposal| {
        let angles = p.places.iter().map(|[b, _]| angle::degrees(*b - p.pivot));
        let angles: Vec<f64> = angles.collect();
        let steps = angles
            .windows(2)
            .map(|two| angle::wrapped(two[1] - two[0] + 180.0) - 180.0);
        let steps: Vec<f64> = steps.collect();
        steps.iter().all(|step| *step >= -1e-9) || steps.iter().all(|step| *step <= 1e-9)
    };
    let near = |p: &Proposal| rms(p, &task.points) < noise;
    let count = |found: &[Proposal]| found.iter().filter(|p| near(p) && is_ordered(p)).count();
    let (free, ordered) = (with(false), with(true));
    assert!(free.iter().any(near), "nothing is found at all");
    assert_eq!(count(&free), 0, "the noise puts nothing out of order");
    assert!(count(&ordered) > 0);
}

/// A search with preferences finds linkages that meet them, if these exist; a search without them
/// finds none here.
#[test]
fn search_finds_linkages_with_wanted_properties() {
    let points: Vec<Vec2> = (0..6)
        .map(|k| Vec2::new(20.0, 20.0 + 5.0 * f64::from(k)))
        .collect();
    let task = task(points, false, None);
    let requested = Preferences {
        full_turn: true,
        transmission: Some(45.0),
        inside: Some([Vec2::new(-60.0, -20.0), Vec2::new(100.0, 60.0)]),
        ratio: Some(4.0),
        ..Preferences::default()
    };
    let corners = requested.inside.unwrap();
    let keeps = |p: &Proposal| {
        let PinConstraint::Rocker(d) = p.partner else {
            return false;
        };
        let is_inside = [p.pivot, d].iter().all(|at| crate::is_inside(corners, *at));
        is_inside && p.ratio() <= 4.0 && rms(p, &task.points) < 1e-6
    };
    let count = |preferences: Preferences| {
        let search = PathSearch {
            preferences,
            ..search(&task)
        };
        search
            .run(&mut |_| true)
            .found
            .iter()
            .filter(|p| keeps(p))
            .count()
    };
    assert_eq!(count(Preferences::default()), 0);
    assert!(count(requested) > 0);
}
