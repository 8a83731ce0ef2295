//! Collects krank's interpretation of a scene: parts, mobility, groups and range.

use super::choice_facts::ChoiceList;
use super::cycle_report::CycleReport;
use super::forces::indeterminate;
use super::input_facts::InputFacts;
use super::loop_facts::LoopFacts;
use super::motion_facts::MotionFacts;
use super::number::concise;
use super::range_text::{limit_text, range_text};
use super::slide_facts::SlideFacts;
use super::stop_facts::{StopFacts, UnmetLimit, stops, unmet_limits};
use crate::quantity::Catalogue;
use crate::scene::{Parameter, Scene, Unit};
use crate::solver::{Extreme, Group, GroupKind, NearMiss, Range, Solver, Transmission};
use crate::study::motor;
use crate::wording::words;
use crate::{Body, ElementId, Link, LinkId, Load, Mechanism, PointId, Vec2};
use serde::{Serialize, Serializer};
use serde_json::Value;

/// Significant digits of a coordinate in a sentence.
pub(super) const PLACES: usize = 9;
/// Significant digits of a sine in a sentence.
const DIGITS: usize = 3;

/// The kind of driven element.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
#[serde(rename_all = "lowercase")]
pub enum DriverKind {
    /// A turning link.
    Link,
    /// A pushed slide.
    Slide,
}

/// The driver.
#[derive(Clone, Debug, Serialize)]
pub struct DriverFacts {
    /// The kind of driven element.
    pub kind: DriverKind,
    /// The driven link or slide.
    pub name: String,
    /// The link that carries its motor, unless the ground does.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub from: Option<String>,
    /// The coordinate at which the scene opens, in deg or the scene's unit.
    #[serde(serialize_with = "unsigned_zero")]
    pub start: f64,
    /// The speed, in rad/s or the scene's unit per s.
    #[serde(serialize_with = "unsigned_zero")]
    pub speed: f64,
    /// The acceleration, in rad/s^2 or the scene's unit per s^2.
    #[serde(serialize_with = "unsigned_zero")]
    pub acceleration: f64,
}

/// A pin joint: a point shared by two or more bodies.
#[derive(Clone, Debug, Serialize)]
pub struct JointFacts {
    /// The point.
    pub point: String,
    /// The bodies joined there, including `ground`.
    pub bodies: Vec<String>,
}

/// A group of the solution plan.
#[derive(Clone, Debug, Serialize)]
pub struct GroupFacts {
    /// The kind: `driver`, `coupled`, or the class of the dyad, such as `RRR`.
    #[serde(serialize_with = "kind_word")]
    pub kind: GroupKind,
    /// The joint after which the group is named.
    pub point: Option<String>,
    /// The number of simultaneous unknowns of a coupled group.
    pub unknowns: Option<usize>,
    /// The links positioned by the group.
    pub links: Vec<String>,
    /// The named points positioned by the group.
    pub points: Vec<String>,
}

/// An extremum of a transmission angle.
#[derive(Clone, Debug, Serialize)]
pub struct ExtremeFacts {
    /// The angle in deg.
    pub angle: f64,
    /// The driver's coordinate, in deg or the scene's unit.
    #[serde(serialize_with = "unsigned_zero")]
    pub at: f64,
}

/// The transmission angle of a dyad over the motion.
#[derive(Clone, Debug, Serialize)]
pub struct TransmissionFacts {
    /// The joint after which the dyad is named, or its first link.
    pub group: String,
    /// The minimum of the angle.
    pub smallest: ExtremeFacts,
    /// The maximum of the angle.
    pub largest: ExtremeFacts,
    /// The maximum deviation from 90 deg.
    pub deviation: f64,
}

/// The worst condition of a coupled group.
#[derive(Clone, Debug, Serialize)]
pub struct ConditionFacts {
    /// The joint after which the group is named, or its first link.
    pub group: String,
    /// The ratio of the minimum to the maximum singular value: 1 at best, 0 at a dead point or a
    /// change point.
    pub least: f64,
    /// The driver's coordinate, in deg or the scene's unit.
    #[serde(serialize_with = "unsigned_zero")]
    pub at: f64,
}

/// A near miss: the two assemblies of a group almost meet.
#[derive(Clone, Debug, Serialize)]
pub struct NearMissFacts {
    /// The joint after which the group is named, or its first link.
    pub group: String,
    /// The sine of the transmission angle at the near miss.
    pub sine: f64,
    /// The driver's coordinate, in deg or the scene's unit.
    #[serde(serialize_with = "unsigned_zero")]
    pub at: f64,
}

/// An end of the range at which two assemblies of a group meet.
#[derive(Clone, Debug, Serialize)]
pub struct LinedUpFacts {
    /// The joint after which the group is named, or its first link.
    pub group: String,
    /// The driver's coordinate, in deg or the scene's unit.
    #[serde(serialize_with = "unsigned_zero")]
    pub at: f64,
}

/// A redundant constraint.
#[derive(Clone, Debug, Serialize)]
pub struct RedundancyFacts {
    /// The link or the slide whose constraint was set aside.
    pub element: String,
    /// The number of its constraints that were set aside.
    pub constraints: usize,
    /// The elements whose constraints it repeats: any of them could have been set aside in its
    /// place. Empty if the mechanism is too large to determine them.
    pub repeats: Vec<String>,
    /// The maximum contradiction over the motion, in the scene's unit.
    pub misfit: f64,
}

/// The result of `krank check`.
#[derive(Clone, Debug, Serialize)]
pub struct Check {
    /// The title of the scene.
    pub scene: String,
    /// The origin of the mechanism.
    pub source: Option<String>,
    /// The note of the scene.
    pub note: Option<String>,
    /// The symbol of the unit of length.
    pub unit: &'static str,
    /// The driver.
    pub driver: DriverFacts,
    /// The motion over time, if the scene has one.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub motion: Option<MotionFacts>,
    /// The inputs that follow the driver.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub inputs: Vec<InputFacts>,
    /// The named numbers.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub parameters: Vec<ParameterFacts>,
    /// The moving links.
    pub links: Vec<String>,
    /// The pin joints.
    pub joints: Vec<JointFacts>,
    /// The slides.
    pub slides: Vec<SlideFacts>,
    /// The degrees of freedom, determined by rank.
    pub mobility: usize,
    /// The elements with a redundant constraint.
    pub redundant: Vec<String>,
    /// The redundant constraints one by one, with the elements that they repeat and their misfit.
    pub redundancies: Vec<RedundancyFacts>,
    /// Whether rounding errors, or the accepted misfit, could hide a motion that the driver does
    /// not determine.
    pub mobility_is_unclear: bool,
    /// Whether the mobility is higher where the scene opens than elsewhere.
    pub opens_at_change_point: bool,
    /// The groups in solution order.
    pub groups: Vec<GroupFacts>,
    /// The assemblies that each group, and the whole, could take where the scene opens.
    #[serde(flatten)]
    pub choices: ChoiceList,
    /// The minimum and maximum of the driver's range, in deg or the scene's unit.
    pub range: [f64; 2],
    /// The proved error bounds of these ends, in the same unit; `None` if not proved.
    pub range_bounds: [Option<f64>; 2],
    /// The period of the motion in degrees; `None` if the driver cannot turn fully.
    pub period: Option<f64>,
    /// The dead points at ends of the range, in deg or the scene's unit.
    pub dead_points: Vec<f64>,
    /// The stops at which the motion ends.
    pub stops: Vec<StopFacts>,
    /// Limits whose stops are never reached.
    pub unmet: Vec<UnmetLimit>,
    /// The change points through which the motion passes, within one period.
    pub change_points: Vec<f64>,
    /// Ends of the range at which two assemblies meet, without proof that the motion can pass.
    pub lined_up: Vec<LinedUpFacts>,
    /// The tolerance within which lengths count as equal there, in the scene's unit.
    pub tolerance: f64,
    /// Places where two assemblies almost meet, and the motion keeps its own.
    pub near_misses: Vec<NearMissFacts>,
    /// The minimum and maximum transmission angle of every dyad.
    pub transmission: Vec<TransmissionFacts>,
    /// The worst condition of every coupled group: the ratio of the minimum to the maximum singular
    /// value of its matrix.
    pub condition: Vec<ConditionFacts>,
    /// The loop of the driven link, a dyad and the ground, if there is one.
    #[serde(rename = "loop")]
    pub first_loop: Option<LoopFacts>,
    /// The default values of `krank cycle`: stroke or swing, turning places and time ratio. Empty
    /// for mechanisms with very many groups.
    pub figures: Vec<Value>,
    /// The number of loads of each kind, springs and masses, and whether there is gravity.
    pub acting: LoadCounts,
    /// Knots of loads at driver coordinates that the motion never reaches.
    pub dead_knots: Vec<DeadKnots>,
    /// Reactions not determined because of redundant constraints, by the names of their columns.
    pub indeterminate: Vec<String>,
    /// The range as text.
    #[serde(skip)]
    pub range_text: String,
    /// The values of the cycle as text.
    #[serde(skip)]
    pub(super) figure_lines: Vec<String>,
}

/// Maximum number of groups for which the values of a cycle are computed.
const MAX_GROUPS: usize = 200;

/// Knots of a load without effect.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct DeadKnots {
    /// The element on which the load acts.
    pub on: String,
    /// The driver's coordinates of the knots.
    pub at: Vec<f64>,
}

/// Returns the knots of every load whose intervals lie outside the motion.
fn dead_knots(scene: &Scene, range: Range) -> Vec<DeadKnots> {
    let Range::Limited { low, high } = range else {
        return Vec::new();
    };
    let mechanism = &scene.mechanism;
    let turns = mechanism.driver().turns();
    let of_load = |load: &Load| {
        let (on, over) = match load {
            Load::Force { point, over, .. } => (scene.point_name(*point)?, over),
            Load::Torque { link, over, .. } => (scene.link_name(*link), over),
            _ => return None,
        };
        let at = over.unused_between(low, high, turns);
        let on = on.to_owned();
        (!at.is_empty()).then_some(DeadKnots { on, at })
    };
    mechanism.loads().iter().filter_map(of_load).collect()
}

/// A named number.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct ParameterFacts {
    /// The name given by the scene.
    pub name: String,
    /// The value.
    pub value: f64,
    /// The formula from which it is computed, if any.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub formula: Option<String>,
    /// The unit of the value, if any.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub unit: Option<String>,
}

impl ParameterFacts {
    fn of(parameter: &Parameter, length: Unit) -> ParameterFacts {
        let unit = parameter.dimension;
        ParameterFacts {
            name: parameter.name.clone(),
            value: parameter.number,
            formula: parameter.formula.clone(),
            unit: unit.map(|unit| unit.symbol(length.symbol())),
        }
    }

    /// Formats the name, the formula and the value in one line.
    pub(super) fn text(&self) -> String {
        let formula = self.formula.as_ref();
        let formula = formula.map_or(String::new(), |formula| format!("{formula} = "));
        let unit = self.unit.as_ref();
        let unit = unit.map_or(String::new(), |unit| format!(" {unit}"));
        format!("{} = {formula}{}{unit}", self.name, self.value)
    }
}

/// The loads on a mechanism, counted by kind.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize)]
pub struct LoadCounts {
    /// Forces at points.
    pub forces: usize,
    /// Torques on links.
    pub torques: usize,
    /// Presses.
    pub presses: usize,
    /// Springs and dampers.
    pub springs: usize,
    /// Links with a mass or an inertia.
    pub masses: usize,
    /// Whether the masses have weight.
    pub gravity: bool,
    /// The common period of loads and motion in degrees, if it is longer than that of the motion.
    pub period: Option<f64>,
}

impl LoadCounts {
    fn on(mechanism: &Mechanism, range: Range) -> LoadCounts {
        let repeats = motor::repeats(mechanism, range);
        let has_mass = |link: &&Link| link.mass > 0.0 || link.inertia > 0.0;
        let mut acting = LoadCounts {
            masses: mechanism.links().iter().filter(has_mass).count(),
            gravity: mechanism.gravity() != Vec2::ZERO,
            period: match (range, repeats) {
                (Range::Full { period }, Some(times @ 2..)) => Some(period * f64::from(times)),
                _ => None,
            },
            ..LoadCounts::default()
        };
        for load in mechanism.loads() {
            match load {
                Load::Force { .. } => acting.forces += 1,
                Load::Torque { .. } => acting.torques += 1,
                Load::Press { .. } => acting.presses += 1,
                Load::Spring { .. } | Load::GasSpring { .. } | Load::TorsionSpring { .. } => {
                    acting.springs += 1;
                }
            }
        }
        acting
    }
}

/// Returns the near misses of assemblies during the motion.
#[must_use]
pub fn near_misses(scene: &Scene, solver: &Solver) -> Vec<NearMissFacts> {
    let names = ElementNames { scene };
    let facts = |miss: &NearMiss| {
        let group = solver.plan().group(miss.group)?;
        Some(NearMissFacts {
            group: names.group_name(group),
            sine: miss.sine,
            at: miss.at,
        })
    };
    solver
        .motion()
        .near_misses
        .iter()
        .filter_map(facts)
        .collect()
}

/// Returns the ends of the range at which groups are aligned.
fn lined_up(scene: &Scene, solver: &Solver) -> Vec<LinedUpFacts> {
    let names = ElementNames { scene };
    let ends = solver.motion().lined_up.iter();
    let facts = ends.filter_map(|end| {
        let group = names.group_name(solver.plan().group(end.group)?);
        Some(LinedUpFacts { group, at: end.at })
    });
    facts.collect()
}

impl LinedUpFacts {
    /// Formats the end as a sentence; `unit` is that of the driver's coordinate.
    pub(super) fn text(&self, unit: &str) -> String {
        words().ends_lined_up(&limit_text(self.at), unit, &self.group)
    }
}

impl NearMissFacts {
    /// Formats the near miss as a sentence; `unit` is that of the driver's coordinate.
    #[must_use]
    pub fn text(&self, unit: &str) -> String {
        let (at, sine) = (concise(self.at, PLACES), concise(self.sine, DIGITS));
        words().near_miss(&at, unit, &sine, &self.group)
    }
}

impl Check {
    /// Collects the facts.
    #[must_use]
    pub fn new(scene: &Scene, solver: &Solver) -> Self {
        let names = ElementNames { scene };
        let mechanism = &scene.mechanism;
        let plan = solver.plan();
        let (range, period) = match solver.motion().range {
            Range::Full { period } => ([0.0, period], Some(period)),
            Range::Limited { low, high } => ([low, high], None),
        };
        let followed =
            (plan.groups.len() <= MAX_GROUPS).then(|| CycleReport::strokes(scene, solver));
        let followed = followed.as_ref();
        Check {
            figures: followed.map_or_else(Vec::new, CycleReport::strokes_json),
            figure_lines: followed.map_or_else(Vec::new, |found| found.lines().collect()),
            scene: scene.name.clone(),
            source: scene.source.clone(),
            note: scene.note.clone(),
            unit: scene.unit.symbol(),
            driver: names.driver(),
            motion: MotionFacts::of(scene, solver),
            inputs: InputFacts::of(scene, solver.motion().range),
            parameters: (scene.parameters.iter())
                .map(|parameter| ParameterFacts::of(parameter, scene.unit))
                .collect(),
            links: names.links(mechanism.link_ids()),
            joints: mechanism
                .point_ids()
                .filter_map(|p| names.joint(p))
                .collect(),
            slides: names.slides(solver),
            mobility: plan.mobility,
            redundant: plan.redundant.iter().map(|&e| names.element(e)).collect(),
            redundancies: names.redundancies(solver),
            mobility_is_unclear: solver.rank().is_unclear,
            opens_at_change_point: solver.rank().is_lower_at_start,
            groups: plan.groups.iter().map(|g| names.group(g)).collect(),
            choices: ChoiceList::new(scene, solver),
            range,
            range_bounds: solver.motion().range_bounds,
            period,
            dead_points: solver.motion().dead_points.clone(),
            stops: stops(scene, solver),
            unmet: unmet_limits(scene, solver),
            change_points: solver.motion().change_points.clone(),
            lined_up: lined_up(scene, solver),
            tolerance: solver.motion().tolerance,
            near_misses: near_misses(scene, solver),
            transmission: names.transmission(solver),
            condition: names.condition(solver),
            first_loop: solver.first_loop().map(LoopFacts::new),
            dead_knots: dead_knots(scene, solver.motion().range),
            acting: LoadCounts::on(mechanism, solver.motion().range),
            indeterminate: indeterminate(scene, solver),
            range_text: range_text(solver.motion().range, Catalogue::new(scene).driver()),
        }
    }

    /// Returns the facts as JSON.
    #[must_use]
    pub fn to_json(&self) -> Value {
        // Names and finite numbers always have a JSON form.
        serde_json::to_value(self).unwrap_or(Value::Null)
    }
}

fn kind_word<S: Serializer>(kind: &GroupKind, to: S) -> Result<S::Ok, S::Error> {
    let other = match kind {
        GroupKind::Driver => "driver",
        _ => "coupled",
    };
    to.serialize_str(kind.class().unwrap_or(other))
}

pub(super) fn unsigned_zero<S: Serializer>(value: &f64, to: S) -> Result<S::Ok, S::Error> {
    to.serialize_f64(value + 0.0)
}

/// Resolves the names of elements.
pub(super) struct ElementNames<'a> {
    pub(super) scene: &'a Scene,
}

impl ElementNames<'_> {
    fn links(&self, links: impl IntoIterator<Item = LinkId>) -> Vec<String> {
        let name = |link| self.scene.link_name(link).to_owned();
        links.into_iter().map(name).collect()
    }

    pub(super) fn point(&self, point: PointId) -> Option<String> {
        self.scene.point_name(point).map(str::to_owned)
    }

    pub(super) fn body(&self, body: Body) -> String {
        match body {
            Body::Ground => "ground".into(),
            Body::Link(link) => self.scene.link_name(link).to_owned(),
        }
    }

    fn element(&self, element: ElementId) -> String {
        match element {
            ElementId::Point(point) => self.point(point).unwrap_or_else(|| "a point".into()),
            ElementId::Link(link) => self.scene.link_name(link).to_owned(),
            ElementId::Slide(slide) => self.scene.slide_name(slide).to_owned(),
            ElementId::Driver => "driver".into(),
        }
    }

    fn redundancies(&self, solver: &Solver) -> Vec<RedundancyFacts> {
        let found = solver.rank().redundancies.iter();
        let facts = found.map(|r| RedundancyFacts {
            element: self.element(r.element),
            constraints: r.constraints,
            repeats: r.repeats.iter().map(|&e| self.element(e)).collect(),
            misfit: r.misfit,
        });
        facts.collect()
    }

    fn driver(&self) -> DriverFacts {
        let driver = self.scene.mechanism.driver();
        let (kind, name) = DriverKind::of(self.scene, driver.input);
        DriverFacts {
            kind,
            name,
            from: self.scene.seat_name(driver.input).map(str::to_owned),
            start: driver.start,
            speed: driver.speed,
            acceleration: driver.acceleration,
        }
    }

    fn joint(&self, id: PointId) -> Option<JointFacts> {
        let point = self.scene.mechanism.point(id);
        let ground = point.ground.map(|_| Body::Ground);
        let links = point.links.iter().map(|&link| Body::Link(link));
        let bodies: Vec<_> = ground.into_iter().chain(links).collect();
        (bodies.len() > 1).then(|| JointFacts {
            point: self.point(id).unwrap_or_default(),
            bodies: bodies.into_iter().map(|b| self.body(b)).collect(),
        })
    }

    /// Returns the joint after which a group is named, or its first link.
    pub(super) fn group_name(&self, group: &Group) -> String {
        let point = group.point.and_then(|p| self.point(p));
        let link = || group.links.first().map(|&l| self.scene.link_name(l).into());
        point.or_else(link).unwrap_or_else(|| "a group".into())
    }

    pub(super) fn condition(&self, solver: &Solver) -> Vec<ConditionFacts> {
        let found = solver.conditioning().into_iter();
        let facts = found.filter_map(|found| {
            Some(ConditionFacts {
                group: self.group_name(solver.plan().group(found.group)?),
                least: found.least,
                at: found.at,
            })
        });
        facts.collect()
    }

    fn transmission(&self, solver: &Solver) -> Vec<TransmissionFacts> {
        let facts = |found: Transmission| {
            let group = solver.plan().group(found.group)?;
            let extreme = |Extreme { angle, at }| ExtremeFacts { angle, at };
            Some(TransmissionFacts {
                group: self.group_name(group),
                smallest: extreme(found.smallest),
                largest: extreme(found.largest),
                deviation: found.deviation(),
            })
        };
        solver
            .transmission()
            .into_iter()
            .filter_map(facts)
            .collect()
    }

    fn group(&self, group: &Group) -> GroupFacts {
        GroupFacts {
            kind: group.kind,
            point: group.point.and_then(|p| self.point(p)),
            unknowns: group.kind.unknowns(),
            links: self.links(group.links.iter().copied()),
            points: group.points.iter().filter_map(|&p| self.point(p)).collect(),
        }
    }
}
