//! Converts the loop equations of a scene to a chain of dependent values.

use super::group_unknowns::LoopUnknown;
use super::polygon::Term;
use super::sides::{Locks, SideShape, Turns};
use crate::report::working::Working;
use crate::report::working::context::Context;
use crate::report::working::methods;
use crate::scene::Scene;
use crate::solver::{Order, Solver, State};
use crate::study::{ChainGroup, LoopSum, SolutionChain, UnknownKind, UnknownVector, VectorPart};
use crate::{Body, Input, LinkId, Mechanism, PointId, SlideId, Vec2, angle};

impl Working {
    /// Returns the dependencies between the values of a state. Returns `None` if it has no rates,
    /// or if the loops do not determine all unknowns.
    #[must_use]
    pub fn chain(&self, scene: &Scene, solver: &Solver, state: &State) -> Option<SolutionChain> {
        // An angle between two links is not a side of a loop.
        if !state.has(Order::Acceleration) || scene.mechanism.elbows().next().is_some() {
            return None;
        }
        let context = self.context(scene, solver, state, DIGITS);
        Variables::new(&context).chain(&context)
    }

    /// Returns the values of the chain's variables in another state, possibly of another assembly;
    /// angles in rad. Returns `None` if the state lacks one.
    #[must_use]
    pub fn positions(&self, scene: &Scene, solver: &Solver, state: &State) -> Option<Vec<f64>> {
        let context = self.context(scene, solver, state, DIGITS);
        let position = |unknown: &LoopUnknown| match *unknown {
            LoopUnknown::Angle(link) => state.angle(link).map(angle::radians),
            LoopUnknown::Travel(slide) => Some(state.travel(slide)?.position),
            LoopUnknown::Length(_) | LoopUnknown::Direction(_) => None,
        };
        let variables = Variables::new(&context);
        variables.list.iter().map(position).collect()
    }
}

/// Number of digits passed to the context; nothing is formatted with it.
const DIGITS: usize = 6;

/// The variables of the loops, the driver's coordinate first.
struct Variables {
    list: Vec<LoopUnknown>,
}

impl Variables {
    fn new(context: &Context<'_>) -> Variables {
        let driver = match context.scene.mechanism.driver().input {
            Input::Turn(link) => LoopUnknown::Angle(link),
            Input::Push(slide) => LoopUnknown::Travel(slide),
        };
        let groups = context.stages.iter().filter(|stage| stage.group.is_some());
        let unknowns = groups.flat_map(|stage| stage.unknowns.iter().copied());
        Variables {
            list: std::iter::once(driver).chain(unknowns).collect(),
        }
    }

    fn find(&self, unknown: LoopUnknown) -> Option<usize> {
        self.list.iter().position(|own| *own == unknown)
    }

    fn chain(&self, context: &Context<'_>) -> Option<SolutionChain> {
        let mechanism = &context.scene.mechanism;
        let mut groups = Vec::new();
        for stage in context.stages.iter().filter(|stage| stage.group.is_some()) {
            let loops = stage.loops.iter().map(|&number| {
                let terms = &context.polygon.loops.get(number)?.terms;
                self.sum(context, terms)
            });
            let unknowns = stage.unknowns.iter().map(|&unknown| self.find(unknown));
            groups.push(ChainGroup {
                loops: loops.collect::<Option<_>>()?,
                sought: unknowns.collect::<Option<_>>()?,
            });
        }
        let links = mechanism.link_ids();
        let links: Option<Vec<_>> = links.map(|link| self.angle(context, link)).collect();
        let links = links?;
        let slides = mechanism.slide_ids();
        let slides: Option<Vec<_>> = slides
            .map(|slide| {
                Some([
                    self.travel(context, slide)?,
                    guide(mechanism, slide, &links)?,
                ])
            })
            .collect();
        let slides = slides?;
        Some(SolutionChain {
            kinds: self.list.iter().map(|unknown| kind(*unknown)).collect(),
            exact: self
                .list
                .iter()
                .map(|unknown| exact(context, *unknown))
                .collect::<Option<_>>()?,
            groups,
            points: ways(mechanism, &links, &slides),
            links,
            slides,
        })
    }

    /// Converts a loop to a sum; returns `None` if it contains a vector between two bodies.
    fn sum(&self, context: &Context<'_>, terms: &[Term]) -> Option<LoopSum> {
        let mut sum = LoopSum::default();
        for term in terms {
            let side = context.polygon.sides.get(term.side)?;
            let reading = context.readings.get(term.side)?;
            let angle = match side.turns {
                Turns::Never => VectorPart::Known(angle::radians(reading.theta)),
                Turns::With(link, offset) => self.root(context, link, offset)?,
                Turns::Freely => return None,
            };
            let length = match side.shape {
                SideShape::Slide(slide) => self.travel(context, slide)?,
                SideShape::Link(_) | SideShape::Rigid(..) => VectorPart::Known(reading.r),
                SideShape::Free(..) => return None,
            };
            sum.sought.push(UnknownVector {
                sign: if term.reversed { -1.0 } else { 1.0 },
                length,
                angle,
            });
        }
        Some(sum)
    }

    /// Returns the direction at an angle, in degrees, to a link: known if an input holds the link.
    fn root(&self, context: &Context<'_>, link: LinkId, offset: f64) -> Option<VectorPart> {
        if let Some(index) = self.find(LoopUnknown::Angle(link)) {
            return Some(VectorPart::Sought(index, angle::radians(offset)));
        }
        let angle = context.state.angle(link) + offset;
        is_held(context, Input::Turn(link)).then(|| VectorPart::Known(angle::radians(angle)))
    }

    fn travel(&self, context: &Context<'_>, slide: SlideId) -> Option<VectorPart> {
        if let Some(index) = self.find(LoopUnknown::Travel(slide)) {
            return Some(VectorPart::Sought(index, 0.0));
        }
        let position = context.state.travel(slide).position;
        is_held(context, Input::Push(slide)).then_some(VectorPart::Known(position))
    }

    /// Returns the angle of a link: known, or that of the link with which it rotates plus a
    /// constant.
    fn angle(&self, context: &Context<'_>, link: LinkId) -> Option<VectorPart> {
        let locks: &Locks = &context.polygon.locks;
        Some(match locks.turns(Body::Link(link), 0.0) {
            Turns::With(root, offset) => self.root(context, root, offset)?,
            Turns::Never | Turns::Freely => {
                VectorPart::Known(angle::radians(context.state.angle(link)))
            }
        })
    }
}

/// Returns `true` if a further input stands still in the whole motion.
fn is_held(context: &Context<'_>, input: Input) -> bool {
    let timed = context.scene.mechanism.timed_input(input);
    timed.is_some_and(|timed| timed.law.is_held())
}

fn kind(unknown: LoopUnknown) -> UnknownKind {
    methods::kind(unknown)
}

/// Returns the value and the rates of a variable in the state; an angle in rad. Returns `None` for
/// the length or direction of a vector between two bodies.
fn exact(context: &Context<'_>, unknown: LoopUnknown) -> Option<[f64; 3]> {
    let state = context.state;
    Some(match unknown {
        LoopUnknown::Angle(link) => [
            angle::radians(state.angle(link)),
            state.omega(link),
            state.alpha(link),
        ],
        LoopUnknown::Travel(slide) => {
            let travel = state.travel(slide);
            [travel.position, travel.rate, travel.accel]
        }
        LoopUnknown::Length(_) | LoopUnknown::Direction(_) => return None,
    })
}

/// Returns the angle of a guide.
fn guide(mechanism: &Mechanism, slide: SlideId, links: &[VectorPart]) -> Option<VectorPart> {
    let slide = mechanism.slide(slide);
    let own = angle::radians(slide.angle);
    turned(slide.on, own, links)
}

/// Returns a direction at an angle to a body.
fn turned(body: Body, by: f64, links: &[VectorPart]) -> Option<VectorPart> {
    Some(match body {
        Body::Ground => VectorPart::Known(by),
        Body::Link(link) => match *links.get(link.index())? {
            VectorPart::Known(angle) => VectorPart::Known(angle + by),
            VectorPart::Sought(index, more) => VectorPart::Sought(index, more + by),
        },
    })
}

/// Finds the shortest path to every point, over links and guides.
fn ways(
    mechanism: &Mechanism,
    links: &[VectorPart],
    slides: &[[VectorPart; 2]],
) -> Vec<Option<LoopSum>> {
    let points = mechanism.points().iter();
    let mut paths: Vec<Option<LoopSum>> = points
        .map(|point| {
            Some(LoopSum {
                known: point.ground?,
                sought: Vec::new(),
            })
        })
        .collect();
    let mut waiting: Vec<PointId> = Vec::new();
    waiting.extend(mechanism.point_ids().filter(|p| has(&paths, *p)));
    let ground = mechanism.slide_ids();
    let ground = ground.filter(|slide| mechanism.slide(*slide).on == Body::Ground);
    for slide in ground.collect::<Vec<_>>() {
        let start = LoopSum {
            known: mechanism.slide(slide).through,
            sought: Vec::new(),
        };
        let point = mechanism.slide(slide).slider.point();
        if let Some(path) = along(slides, slide, start)
            && reach(&mut paths, point, path)
        {
            waiting.push(point);
        }
    }
    let mut next = 0;
    while let Some(&point) = waiting.get(next) {
        next += 1;
        for (reached, path) in steps(mechanism, links, slides, point, &paths) {
            if reach(&mut paths, reached, path) {
                waiting.push(reached);
            }
        }
    }
    paths
}

fn has(paths: &[Option<LoopSum>], point: PointId) -> bool {
    paths.get(point.index()).is_some_and(Option::is_some)
}

/// Stores the first path to a point; returns `true` for a new point.
fn reach(paths: &mut [Option<LoopSum>], point: PointId, path: LoopSum) -> bool {
    match paths.get_mut(point.index()) {
        Some(place @ None) => {
            *place = Some(path);
            true
        }
        _ => false,
    }
}

/// Returns the paths that extend one along the links of a point, to their other points and along
/// the guides on them.
fn steps(
    mechanism: &Mechanism,
    links: &[VectorPart],
    slides: &[[VectorPart; 2]],
    from: PointId,
    paths: &[Option<LoopSum>],
) -> Vec<(PointId, LoopSum)> {
    let mut steps = Vec::new();
    let Some(Some(path)) = paths.get(from.index()) else {
        return steps;
    };
    for &link in &mechanism.point(from).links {
        let body = Body::Link(link);
        let Some(origin) = mechanism.link(link).local(from) else {
            continue;
        };
        let to = |local: Vec2| {
            let vector = local - origin;
            let mut path = path.clone();
            if vector != Vec2::ZERO {
                path.sought.push(UnknownVector {
                    sign: 1.0,
                    length: VectorPart::Known(vector.norm()),
                    angle: turned(body, vector.y.atan2(vector.x), links)?,
                });
            }
            Some(path)
        };
        for member in &mechanism.link(link).members {
            steps.extend(to(member.local).map(|path| (member.point, path)));
        }
        for slide in mechanism.slide_ids() {
            let given = mechanism.slide(slide);
            if given.on == body
                && let Some(path) = to(given.through).and_then(|path| along(slides, slide, path))
            {
                steps.push((given.slider.point(), path));
            }
        }
    }
    steps
}

/// Extends a path along a guide.
fn along(slides: &[[VectorPart; 2]], slide: SlideId, mut path: LoopSum) -> Option<LoopSum> {
    let [length, angle] = *slides.get(slide.index())?;
    path.sought.push(UnknownVector {
        sign: 1.0,
        length,
        angle,
    });
    Some(path)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::quantity::Catalogue;
    use crate::scene::presets;
    use crate::solver::Condition;

    /// If only the driver is given, the chain yields the solver's values.
    #[test]
    fn loop_chain_yields_solver_values_in_every_preset() {
        let mut without = Vec::new();
        for preset in presets::all() {
            let scene = Scene::parse(preset.text, preset.name).unwrap();
            let solver = Solver::new(&scene.mechanism).unwrap();
            let mut state = solver.state();
            let at = scene.mechanism.driver().start;
            assert_eq!(
                solver.solve(at, Order::Acceleration, &mut state),
                Condition::Ok
            );
            let working = Working::new(&scene, &solver);
            let Some(chain) = working.chain(&scene, &solver, &state) else {
                without.push(preset.name);
                continue;
            };
            let values = chain.follow(&|_| None).unwrap();
            let catalogue = Catalogue::new(&scene);
            let quantities = catalogue.figures();
            for quantity in quantities
                .iter()
                .filter(|f| f.order() <= Order::Acceleration)
            {
                let own = quantity.value(&state).unwrap();
                let found = chain.figure(quantity, &values);
                let found = found.unwrap_or_else(|| panic!("{} {}", preset.name, quantity.name));
                let mut distance = (found - own).abs();
                if quantity.is_direction() {
                    distance = distance.min(360.0 - distance);
                }
                let size = quantities
                    .iter()
                    .filter(|f| f.unit == quantity.unit)
                    .filter_map(|f| f.value(&state))
                    .fold(1.0, |maximum: f64, v| maximum.max(v.abs()));
                assert!(
                    distance <= 1e-9 * size,
                    "{} {}: {found} for {own}",
                    preset.name,
                    quantity.name
                );
            }
        }
        // The angle of a motor between two links is no side of a loop.
        assert_eq!(without, ["robot-arm"]);
    }
}
