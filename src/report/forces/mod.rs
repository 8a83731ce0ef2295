//! Collects the forces of one state: the driver's effort, reactions of joints and guides, the load
//! on the frame, and the residuals of two checks.

pub(in crate::report) mod least_norm;
pub(in crate::report) mod page;

use crate::quantity::{Aspect, Catalogue, Hidden, Share, Subject, value};
use crate::report::forces::least_norm::LeastNormReactions;
use crate::report::tables::ProvedState;
use crate::report::tables::entry::{Entry, PlaneVector};
use crate::scene::Scene;
use crate::solver::{Condition, Indeterminate, Solver, State};
use crate::wording::{Language, words};
use crate::{Ball, Body, SlideId, Slider, Vec2};

/// The effort of the driver in N m, or in N for a driven slide.
#[derive(Clone, Debug)]
pub struct Drive {
    /// The driven link or slide.
    pub name: String,
    /// [`Aspect::Torque`], or [`Aspect::Force`] for a driven slide.
    pub aspect: Aspect,
    /// The total effort.
    pub total: Entry,
    /// The parts against loads and springs, weights, and inertia; they sum to the total.
    pub parts: [Entry; 3],
    /// The effort of each input if there are several: name, and torque or force.
    pub own: Vec<(String, Aspect, Entry)>,
    /// The power in W, positive if the driver supplies energy to the linkage.
    pub power: Entry,
}

/// The force on a link at a joint.
#[derive(Clone, Debug)]
pub struct JointRow {
    /// The link.
    pub link: String,
    /// The joint.
    pub point: String,
    /// The body that exerts the force, if the pin joins only two bodies and has no load.
    pub by: Option<String>,
    /// Whether an earlier row has the opposite force.
    pub repeats: bool,
    /// The force in N, in the ground's frame; `None` if it does not exist or is indeterminate.
    pub force: Option<PlaneVector>,
}

/// The force of a guide on its slider.
#[derive(Clone, Debug)]
pub struct GuideRow {
    /// The slide.
    pub name: String,
    /// The sliding point or link.
    pub slider: String,
    /// The normal force in N, along the guide's direction turned by +90 degrees.
    pub normal: Entry,
    /// The moment on a sliding link, in N m about its origin; `None` for a pin, which has none.
    pub moment: Option<Entry>,
    /// The intersection of the normal force's line of action with the guide, measured from the
    /// link's origin along the guide, in the scene's unit. A couple without a force has none.
    pub at: Option<Entry>,
}

/// The load on the frame: the shaking force and moment.
#[derive(Clone, Debug)]
pub struct Shaking {
    /// The shaking force in N.
    pub force: Option<PlaneVector>,
    /// The shaking moment in N m about the scene's origin, including the driver's.
    pub moment: Entry,
}

/// The residuals of the checks, which are rounding errors only.
#[derive(Clone, Copy, Debug)]
pub struct Checks {
    /// The driver's effort minus the result of virtual work, in N m or N.
    pub drive: Entry,
    /// The force on the frame minus the sum of all loads, in N; and the moments, in N m.
    pub frame: [Entry; 3],
}

/// The forces of one state.
#[derive(Clone, Debug)]
pub struct Forces {
    /// The condition of the state.
    pub condition: Condition,
    /// The symbol of the scene's unit of length.
    pub unit: &'static str,
    /// The effort of the driver.
    pub drive: Drive,
    /// The joints of every link, in the order of the file.
    pub joints: Vec<JointRow>,
    /// The guides.
    pub guides: Vec<GuideRow>,
    /// The load on the frame.
    pub frame: Shaking,
    /// The residuals of the two checks.
    pub checks: Checks,
    /// The reason why the forces are not shown although they were computed; then only the checks
    /// are shown.
    pub withheld: Option<String>,
    /// Reactions that a redundant linkage leaves indeterminate, as named in columns: `r5.D`,
    /// `r6.normal`.
    pub indeterminate: Vec<String>,
    /// The indeterminate reactions of least norm.
    pub least: Option<LeastNormReactions>,
}

/// The available part of the forces.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Existence {
    /// All forces.
    Everything,
    /// Only the driver's effort, without reactions.
    DriveAlone,
    /// Computed, but not shown; the checks say why.
    WithheldReason,
    /// No force.
    Nothing,
}

impl Forces {
    /// Collects the forces of a state solved to [`Order::Force`](crate::solver::Order::Force);
    /// returns `None` for a linkage without loads.
    #[must_use]
    pub fn new(
        scene: &Scene,
        solver: &Solver,
        state: &State,
        enclosure: Option<&State<Ball>>,
    ) -> Option<Forces> {
        if !scene.mechanism.has_forces() {
            return None;
        }
        let reading = ProvedState {
            mechanism: &scene.mechanism,
            state,
            enclosure,
            is_timed: scene.motion.is_some(),
        };
        let (joints, guides) = (joints(scene, &reading), guides(scene, &reading));
        Some(Forces {
            least: LeastNormReactions::new(scene, solver, state, (&joints, &guides)),
            condition: state.condition(),
            unit: scene.unit.symbol(),
            drive: drive(scene, &reading),
            joints,
            guides,
            frame: Shaking {
                force: plane(Subject::Frame, &reading),
                moment: found(Subject::Frame, Aspect::Moment, &reading),
            },
            checks: checks(scene, &reading),
            withheld: withheld(scene, state),
            indeterminate: indeterminate(scene, solver),
        })
    }

    /// Returns which forces are available.
    #[must_use]
    pub fn existence(&self) -> Existence {
        match (self.drive.total.value, self.frame.force) {
            _ if self.withheld.is_some() => Existence::WithheldReason,
            (None, _) => Existence::Nothing,
            (Some(_), None) => Existence::DriveAlone,
            (Some(_), Some(_)) => Existence::Everything,
        }
    }

    /// Returns sentences about missing values.
    #[must_use]
    pub fn remarks(&self) -> Vec<String> {
        let mut remarks: Vec<String> = Vec::new();
        match (self.existence(), self.condition) {
            (Existence::Everything, _) => {}
            (Existence::WithheldReason, _) => remarks.extend(self.withheld.clone()),
            (Existence::DriveAlone, _) => {
                remarks.push(words().driver_alone_has_value(self.effort()));
            }
            (Existence::Nothing, Condition::NoAssembly) => {
                remarks.push(words().nothing_to_balance().to_owned());
            }
            (Existence::Nothing, _) => remarks.push(words().no_effort_exists(self.effort())),
        }
        if !self.indeterminate.is_empty() {
            let reactions = self.indeterminate.join(", ");
            remarks.push(match self.least.is_some() {
                true => words().indeterminate_with_least(&reactions),
                false => words().indeterminate(&reactions),
            });
        }
        remarks
    }

    /// Returns the word for the driver's effort.
    fn effort(&self) -> &'static str {
        effort_word(self.drive.aspect)
    }

    /// Returns every value with its name and unit, in the order of the catalogue.
    pub(crate) fn figures(&self) -> Vec<(String, &'static str, Entry)> {
        let Forces { drive, frame, .. } = self;
        let (effort, unit) = (drive.aspect.name(), effort_unit(drive.aspect));
        let mut all = vec![
            (format!("driver.{effort}"), unit, drive.total),
            ("driver.power".to_owned(), "W", drive.power),
        ];
        let residual = [(RESIDUAL, self.checks.drive)];
        for (part, entry) in PARTS.into_iter().zip(drive.parts).chain(residual) {
            all.push((format!("driver.{effort}.{part}"), unit, entry));
        }
        for joint in &self.joints {
            let name = format!("{}.{}", joint.link, joint.point);
            all.extend(plane_figures(&name, joint.force));
        }
        for guide in &self.guides {
            let name = &guide.name;
            all.push((format!("{name}.normal"), "N", guide.normal));
            let moment = guide.moment.map(|m| (format!("{name}.moment"), "N m", m));
            all.extend(moment);
            all.extend(guide.at.map(|at| (format!("{name}.at"), self.unit, at)));
        }
        all.extend(plane_figures("ground", frame.force));
        all.push(("ground.moment".to_owned(), "N m", frame.moment));
        let frame = ["fx", "fy", "moment"].into_iter().zip(["N", "N", "N m"]);
        for ((figure, unit), entry) in frame.zip(self.checks.frame) {
            all.push((format!("ground.{figure}.{RESIDUAL}"), unit, entry));
        }
        all
    }
}

/// Returns a sentence on why the forces of a state are not shown; `None` if they are.
pub(in crate::report) fn withheld(scene: &Scene, state: &State) -> Option<String> {
    let hidden = Hidden::of_forces(state)?;
    Some(sentence(&hidden.text(&Catalogue::new(scene).driver().unit)))
}

/// Capitalizes a clause as a sentence of its own.
pub(in crate::report) fn sentence(text: &str) -> String {
    Language::current_language().capitalised(text) + "."
}

/// Returns the word for the driver's effort.
pub(crate) fn effort_word(effort: Aspect) -> &'static str {
    match effort {
        Aspect::Torque => words().torque(),
        _ => words().force(),
    }
}

/// Returns the unit of the driver's effort.
pub(in crate::report) fn effort_unit(effort: Aspect) -> &'static str {
    match effort {
        Aspect::Torque => "N m",
        _ => "N",
    }
}

/// The parts of the driver's effort, and the residual of the checks, as named in columns.
pub(in crate::report) const PARTS: [&str; 3] = ["load", "gravity", "inertia"];
const RESIDUAL: &str = "residual";

/// Returns a force by components, magnitude and direction.
pub(in crate::report) fn plane_figures(
    name: &str,
    force: Option<PlaneVector>,
) -> [(String, &'static str, Entry); 4] {
    let entries = force.map_or([Entry::NONE; 4], |force| force.entries(false));
    let named = [("fx", "N"), ("fy", "N"), ("f", "N"), ("f.angle", "deg")];
    std::array::from_fn(|i| {
        let (figure, unit) = named[i];
        (format!("{name}.{figure}"), unit, entries[i])
    })
}

/// Evaluates one value, which is never given by the scene.
fn found(subject: Subject, aspect: Aspect, reading: &ProvedState<'_>) -> Entry {
    Entry {
        value: value(subject, aspect, reading.state),
        given: false,
        bound: reading.bound(subject, aspect).filter(|b| b.is_finite()),
    }
}

fn plane(subject: Subject, reading: &ProvedState<'_>) -> Option<PlaneVector> {
    let [x, y] = [Aspect::Fx, Aspect::Fy].map(|aspect| found(subject, aspect, reading));
    let force = Vec2::new(x.value?, y.value?);
    let mut plane = PlaneVector::new(force, [x.bound, y.bound]);
    // Loads may be so large that the squares of forces overflow.
    for bound in &mut plane.bounds {
        *bound = bound.filter(|bound| bound.is_finite());
    }
    plane.magnitude.is_finite().then_some(plane)
}

fn drive(scene: &Scene, reading: &ProvedState<'_>) -> Drive {
    let input = scene.mechanism.driver().input;
    let aspect = Aspect::effort_of(input);
    let share = |share, aspect| found(Subject::Drive(share), aspect, reading);
    let parts = [Share::Load, Share::Gravity, Share::Inertia];
    Drive {
        name: scene.input_name(input).to_owned(),
        aspect,
        total: share(Share::Total, aspect),
        parts: parts.map(|part| share(part, aspect)),
        own: efforts(scene, reading),
        power: share(Share::Total, Aspect::Power),
    }
}

/// Returns the effort of each input, if there are several.
fn efforts(scene: &Scene, reading: &ProvedState<'_>) -> Vec<(String, Aspect, Entry)> {
    let mechanism = &scene.mechanism;
    let several = mechanism.inputs().filter(|_| !mechanism.timed().is_empty());
    let own = several.map(|input| {
        let aspect = Aspect::effort_of(input);
        let subject = match input {
            crate::Input::Turn(link) => Subject::Link(link),
            crate::Input::Push(slide) => Subject::Slide(slide),
        };
        let effort = found(subject, aspect, reading);
        (scene.input_name(input).to_owned(), aspect, effort)
    });
    own.collect()
}

fn checks(scene: &Scene, reading: &ProvedState<'_>) -> Checks {
    let aspect = Aspect::effort_of(scene.mechanism.driver().input);
    let frame = [Aspect::Fx, Aspect::Fy, Aspect::Moment];
    Checks {
        drive: found(Subject::Drive(Share::Residual), aspect, reading),
        frame: frame.map(|aspect| found(Subject::FrameResidual, aspect, reading)),
    }
}

fn joints(scene: &Scene, reading: &ProvedState<'_>) -> Vec<JointRow> {
    let mechanism = &scene.mechanism;
    let mut rows = Vec::new();
    for link in mechanism.link_ids() {
        for point in mechanism.pins(link) {
            let Some(name) = scene.point_name(point) else {
                continue;
            };
            let partner = mechanism.partner(link, point);
            rows.push(JointRow {
                link: scene.link_name(link).to_owned(),
                point: name.to_owned(),
                by: partner.map(|other| match other {
                    Body::Link(link) => scene.link_name(link).to_owned(),
                    Body::Ground => "ground".to_owned(),
                }),
                repeats: matches!(partner, Some(Body::Link(other)) if other < link),
                force: plane(Subject::Joint(link, point), reading),
            });
        }
    }
    rows
}

fn guides(scene: &Scene, reading: &ProvedState<'_>) -> Vec<GuideRow> {
    let mechanism = &scene.mechanism;
    let guide = |slide: SlideId| {
        let subject = Subject::Slide(slide);
        let normal = found(subject, Aspect::Normal, reading);
        let (slider, moment) = match mechanism.slide(slide).slider {
            Slider::Pin(point) => (scene.point_name(point).unwrap_or("?"), None),
            Slider::Link { link, .. } => (
                scene.link_name(link),
                Some(found(subject, Aspect::Moment, reading)),
            ),
        };
        GuideRow {
            name: scene.slide_name(slide).to_owned(),
            slider: slider.to_owned(),
            normal,
            moment,
            at: moment.map(|moment| arm(&moment, &normal, mechanism.metres())),
        }
    };
    mechanism.slide_ids().map(guide).collect()
}

/// Returns the arm x = M / N, since a force N at the distance x along the guide has the moment x N.
/// A normal force that may be zero has no line of action.
fn arm(moment: &Entry, normal: &Entry, metres: f64) -> Entry {
    let (Some(turning), Some(force)) = (moment.value, normal.value) else {
        return Entry::NONE;
    };
    if force.abs() <= normal.bound.unwrap_or(0.0) {
        return Entry::NONE;
    }
    let arm = turning / force;
    let bound = moment.bound.zip(normal.bound).map(|(of_moment, of_force)| {
        let off = (of_moment + arm.abs() * of_force) / (force.abs() - of_force);
        // The rounding errors of the two divisions, and of the bound itself.
        (off + 4.0 * f64::EPSILON * arm.abs()) / metres * (1.0 + 16.0 * f64::EPSILON)
    });
    Entry {
        value: Some(arm / metres).filter(|arm| arm.is_finite()),
        given: false,
        bound: bound.filter(|bound| bound.is_finite()),
    }
}

pub(in crate::report) fn indeterminate(scene: &Scene, solver: &Solver) -> Vec<String> {
    let name = |open: &Indeterminate| match *open {
        Indeterminate::Joint(link, point) => {
            let point = scene.point_name(point)?;
            Some(format!("{}.{point}", scene.link_name(link)))
        }
        Indeterminate::Normal(slide) => Some(format!("{}.normal", scene.slide_name(slide))),
        Indeterminate::Moment(slide) => Some(format!("{}.moment", scene.slide_name(slide))),
    };
    solver.indeterminate().iter().filter_map(name).collect()
}
