//! Computes the extents of a linkage over its whole motion, sampled once.

use super::poses::Poses;
use crate::drawing::bounds::Bounds;
use crate::drawing::view::WindowZoom;
use crate::scene::Scene;
use crate::solver::{Condition, Order, Range, Solver, State};
use crate::{Body, Link, Mechanism, SlideId, Vec2};
use std::sync::{Arc, Mutex, PoisonError};

/// Number of steps along the motion: 3 degrees in a motion of two turns. Between two states a
/// crank's pin then rises above both by less than 1e-3 of its radius, far less than a cell.
const SAMPLES: u16 = 240;

/// The extents of a linkage over its whole motion. Views are fitted to them, and they determine the
/// length of guides.
#[derive(Clone, Debug)]
pub struct Extents {
    /// The extents of all points in all states.
    moving: Bounds,
    /// The extents of the ground points.
    ground: Bounds,
    /// The extents of the ground's guides.
    guides: Bounds,
    /// The extents of arrow tips.
    arrows: Bounds,
    /// The extents of the poses along the motion.
    poses: Poses,
    /// The travel of each slide along its guide, in the scene's length unit.
    travel: Vec<Option<(f64, f64)>>,
    anchor: Vec2,
    /// The typical distance of neighbouring pins.
    pitch: f64,
    /// The length of the longest name, in cells.
    name: f64,
    /// The zoom of following windows, cached for each size.
    near: Arc<Mutex<Vec<WindowZoom>>>,
}

/// The cells to keep free around a part.
#[derive(Clone, Copy)]
pub(in crate::drawing) struct Margin {
    pub(in crate::drawing) left: f64,
    pub(in crate::drawing) right: f64,
    pub(in crate::drawing) above: f64,
    pub(in crate::drawing) below: f64,
}

/// Maximum number of window sizes in the cache.
const MAX_SIZES: usize = 64;

/// Maximum name length that margins allow for. Longer names may be cut at the edge, rather than
/// make the linkage small.
const MAX_NAME_LEN: f64 = 4.0;

impl Extents {
    /// Computes the extents of a scene, following its motion once.
    #[must_use]
    pub fn of(scene: &Scene, solver: &Solver) -> Extents {
        let mut extents = Extents::initial(scene);
        let mut state = solver.state();
        let mut met = Vec::new();
        let (low, high, closed) = ends(scene, solver);
        for at in samples(low, high, closed) {
            if solver.solve(at, Order::Position, &mut state) != Condition::NoAssembly {
                met.push((at, extents.include(scene, &state)));
            }
        }
        extents.include_guides(scene);
        extents.poses = Poses::new([low, high - low], closed, &met);
        extents
    }

    /// Returns the extents enlarged by some more states.
    #[must_use]
    pub fn with<'s>(&self, scene: &Scene, states: impl IntoIterator<Item = &'s State>) -> Extents {
        let points = || scene.mechanism.point_ids();
        let states = states.into_iter();
        self.with_points(states.flat_map(|s| points().map(|point| s.known().position(point))))
    }

    /// Returns the extents enlarged by some more points of the linkage's motion.
    #[must_use]
    pub fn with_points(&self, points: impl IntoIterator<Item = Vec2>) -> Extents {
        let mut space = Bounds::default();
        points.into_iter().for_each(|point| space.include(point));
        let mut extents = self.without_cache();
        extents.moving = extents.moving.with(space);
        extents.poses = extents.poses.with_extents(|_| space);
        extents
    }

    /// Returns a copy with an empty cache.
    fn without_cache(&self) -> Extents {
        Extents {
            near: Arc::default(),
            ..self.clone()
        }
    }

    /// Returns the extents enlarged by arrow tips. They belong to the drawing, not to the linkage,
    /// and are not part of [`Extents::bounds`].
    pub(in crate::drawing) fn with_arrows(&self, tips: &[(f64, Bounds)]) -> Extents {
        let mut extents = self.without_cache();
        let all = tips.iter().map(|(_, tips)| *tips);
        extents.arrows = all.fold(extents.arrows, Bounds::with);
        extents.poses = extents.poses.with_tips(tips);
        extents
    }

    /// Returns the extents enlarged by some points drawn at the driver's coordinate `at`.
    #[must_use]
    pub fn with_places(&self, at: f64, places: impl IntoIterator<Item = Vec2>) -> Extents {
        let mut space = Bounds::default();
        let mut count = 0;
        for position in places {
            space.include(position);
            count += 1;
        }
        match count {
            0 => self.clone(),
            _ => self.with_arrows(&[(at, space)]),
        }
    }

    /// Returns the extents enlarged by another scene at corresponding driver coordinates. `scale`
    /// converts its lengths to this scene's unit, and `driver` its driver coordinate.
    #[must_use]
    pub fn union(&self, other: &Extents, scale: f64, driver: f64) -> Extents {
        let scaled = |space: Bounds| Bounds {
            low: space.low * scale,
            high: space.high * scale,
        };
        let complete = scaled(other.bounds());
        let mut extents = self.without_cache();
        extents.moving = extents.moving.with(complete);
        extents.poses = extents.poses.with_extents(|at| {
            let space = other.poses.extents_at(at / driver);
            space.map_or(complete, |space| scaled(space.linkage))
        });
        extents
    }

    fn initial(scene: &Scene) -> Extents {
        let mechanism = &scene.mechanism;
        let mut ground = Bounds::default();
        let fixed = mechanism.points().iter().filter_map(|p| p.ground);
        fixed.clone().for_each(|p| ground.include(p));
        let names = mechanism.point_ids().filter_map(|p| scene.point_name(p));
        let longest = names.map(|n| n.chars().count()).max().unwrap_or(0);
        let on_ground = mechanism.slides().iter().find(|s| s.on == Body::Ground);
        let anchor = fixed.clone().next().or(on_ground.map(|s| s.through));
        Extents {
            moving: Bounds::default(),
            ground,
            guides: Bounds::default(),
            arrows: Bounds::default(),
            poses: Poses::default(),
            travel: vec![None; mechanism.slides().len()],
            anchor: anchor.unwrap_or(Vec2::ZERO),
            pitch: pitch(mechanism),
            name: (longest as f64).min(MAX_NAME_LEN),
            near: Arc::default(),
        }
    }

    /// Enlarges the extents by a state, and returns the extents of the state alone.
    fn include(&mut self, scene: &Scene, state: &State) -> Bounds {
        let mut pose = Bounds::default();
        for point in scene.mechanism.point_ids() {
            pose.include(state.known().position(point));
        }
        self.moving = self.moving.with(pose);
        for slide in scene.mechanism.slide_ids() {
            let at = state.known().travel(slide).position;
            if at.is_finite() {
                let (low, high) = self.travel[slide.index()].unwrap_or((at, at));
                self.travel[slide.index()] = Some((low.min(at), high.max(at)));
            }
        }
        pose
    }

    fn include_guides(&mut self, scene: &Scene) {
        for (slide, travel) in scene.mechanism.slides().iter().zip(&self.travel) {
            if let (Body::Ground, Some((low, high))) = (slide.on, *travel) {
                self.guides.include(slide.through + slide.direction() * low);
                self.guides
                    .include(slide.through + slide.direction() * high);
            }
        }
    }

    /// Returns the box around all points in all states.
    #[must_use]
    pub fn bounds(&self) -> Bounds {
        self.moving.with(self.ground).with(self.guides)
    }

    /// Returns the minimum and maximum position of a slide along its guide; `None` if it has no
    /// position in any state.
    #[must_use]
    pub fn travel(&self, slide: SlideId) -> Option<(f64, f64)> {
        self.travel[slide.index()]
    }

    /// Returns a point of the frame that views place in the middle of a cell.
    pub(in crate::drawing) fn anchor(&self) -> Vec2 {
        self.anchor
    }

    /// Returns the typical distance of neighbouring pins; infinity if there are none.
    pub(in crate::drawing) fn pitch(&self) -> f64 {
        self.pitch
    }

    /// Returns the extents that must be visible, with the cells for their names and symbols.
    pub(in crate::drawing) fn parts(&self) -> [(Bounds, Margin); 4] {
        // Half a cell more than names and supports need, because the window moves by up to half a
        // cell to align its anchor.
        self.parts_in([self.moving, self.guides, self.arrows], 0.5)
    }

    /// Returns the extents for a window that follows the linkage: those of one part of the motion
    /// with its arrow tips. Guides may end outside.
    pub(in crate::drawing) fn parts_near(
        &self,
        space: Bounds,
        tips: Bounds,
    ) -> [(Bounds, Margin); 4] {
        self.parts_in([space, self.guides.within(space), tips], 0.0)
    }

    fn parts_in(&self, [moving, guides, arrows]: [Bounds; 3], spare: f64) -> [(Bounds, Margin); 4] {
        let margin = |side, above, below| Margin {
            left: side,
            right: side,
            above: above + spare,
            below: below + spare,
        };
        [
            (moving, margin(self.name + 2.0, 1.5, 1.5)),
            (self.ground, margin(3.5, 1.5, 3.0)),
            (guides, margin(4.0, 1.5, 2.0)),
            (arrows, margin(1.0, 0.5, 0.5)),
        ]
    }

    /// Returns `true` if the motion ends where it begins.
    #[must_use]
    pub fn is_closed(&self) -> bool {
        self.poses.is_closed()
    }

    /// Returns driver coordinates at even steps along the motion; none without a motion.
    pub fn steps(&self) -> impl Iterator<Item = f64> {
        self.poses.steps(usize::from(SAMPLES))
    }

    /// Returns how much of the motion lies before a driver coordinate, from 0 to 1; `None` without a
    /// motion.
    #[must_use]
    pub fn share(&self, at: f64) -> Option<f64> {
        self.poses.share(at)
    }

    /// Returns the extents of the poses along the motion.
    pub(in crate::drawing) fn poses(&self) -> &Poses {
        &self.poses
    }

    /// Returns the zoom of a following window from the cache, or computes and stores it. The zoom
    /// depends on the window's size alone.
    pub(in crate::drawing) fn nearness(
        &self,
        is_it: impl Fn(&WindowZoom) -> bool,
        find: impl FnOnce() -> WindowZoom,
    ) -> WindowZoom {
        let near = || self.near.lock().unwrap_or_else(PoisonError::into_inner);
        if let Some(known) = near().iter().find(|known| is_it(known)) {
            return *known;
        }
        let found = find();
        let mut near = near();
        // A terminal that is resized all day must not fill the memory.
        if near.len() >= MAX_SIZES {
            near.clear();
        }
        near.push(found);
        found
    }
}

/// Returns the median over the links of the shortest distance of two consecutive points.
fn pitch(mechanism: &Mechanism) -> f64 {
    let shortest = |link: &Link| {
        let members = link.members.iter().filter(|m| link.com != Some(m.point));
        let (from, to) = (members.clone(), members.skip(1));
        let distances = from.zip(to).map(|(a, b)| (b.local - a.local).norm());
        distances.filter(|&d| d > 0.0).min_by(f64::total_cmp)
    };
    let mut pitches: Vec<f64> = mechanism.links().iter().filter_map(shortest).collect();
    pitches.sort_by(f64::total_cmp);
    let middle = pitches.get(pitches.len() / 2);
    middle.copied().unwrap_or(f64::INFINITY)
}

/// Returns the start and end of the motion, and whether it is closed.
fn ends(scene: &Scene, solver: &Solver) -> (f64, f64, bool) {
    let start = scene.mechanism.driver().start;
    match solver.motion().range {
        Range::Full { period } => (start, start + period, true),
        Range::Limited { low, high } => (low, high, false),
    }
}

/// Returns the driver's coordinates to sample.
fn samples(low: f64, high: f64, closed: bool) -> impl Iterator<Item = f64> {
    (0..=SAMPLES).map(move |k| {
        let share = f64::from(k) / f64::from(SAMPLES);
        // Closer towards the ends, where a motion between dead points changes fastest.
        let share = if closed {
            share
        } else {
            (1.0 - (std::f64::consts::PI * share).cos()) / 2.0
        };
        low + (high - low) * share
    })
}

impl Extents {
    /// Creates the extents of fixed points and of one point that takes the places `moving` over a
    /// turn, without a linkage.
    pub(crate) fn of_places(moving: &[Vec2], ground: &[Vec2]) -> Extents {
        let around = |points: &[Vec2]| {
            let mut bounds = Bounds::default();
            points.iter().for_each(|&p| bounds.include(p));
            bounds
        };
        let poses = moving.iter().zip(0..).map(|(&at, k)| {
            let driver = 360.0 * f64::from(k) / moving.len() as f64;
            (driver, around(&[at]))
        });
        let poses: Vec<(f64, Bounds)> = poses.collect();
        Extents {
            moving: around(moving),
            ground: around(ground),
            guides: Bounds::default(),
            arrows: Bounds::default(),
            poses: Poses::new([0.0, 360.0], true, &poses),
            travel: Vec::new(),
            anchor: ground.first().copied().unwrap_or(Vec2::ZERO),
            pitch: f64::INFINITY,
            name: 1.0,
            near: Arc::default(),
        }
    }
}
