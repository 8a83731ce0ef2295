//! The forces of one state: what the driver must do, what joints and guides carry, what the frame feels,
//! and how far the two checks miss.

use super::entry::{Entry, PlaneVector};
use super::least::Least;
use super::tables::ProvedState;
use crate::quantity::{Aspect, Catalogue, Hidden, Share, Subject, value};
use crate::scene::Scene;
use crate::solver::{Condition, Indeterminate, Solver, State};
use crate::wording::{Language, words};
use crate::{Ball, Body, SlideId, Slider, Vec2};

/// What the driver must do: figures in N m, or in N where a slide is driven.
#[derive(Clone, Debug)]
pub struct Drive {
    /// The driven link or slide.
    pub name: String,
    /// [`Aspect::Torque`], or [`Aspect::Force`] of a driven slide.
    pub aspect: Aspect,
    /// All of it.
    pub total: Entry,
    /// Against loads and springs, against weights, against inertia: together the total.
    pub parts: [Entry; 3],
    /// Where several inputs share the work what each does itself: its name, and its torque or its force.
    pub own: Vec<(String, Aspect, Entry)>,
    /// Its power in W, positive where it gives energy to the linkage.
    pub power: Entry,
}

/// The force on a link at a joint.
#[derive(Clone, Debug)]
pub struct JointRow {
    /// The link.
    pub link: String,
    /// The joint.
    pub point: String,
    /// The body that the force comes from, where the pin joins just two and nothing acts on it.
    pub by: Option<String>,
    /// Whether a row before it has the same force with the other sign.
    pub repeats: bool,
    /// In N, in the ground's frame; `None` where it does not exist or is left open.
    pub force: Option<PlaneVector>,
}

/// The force of a guide on what slides along it.
#[derive(Clone, Debug)]
pub struct GuideRow {
    /// The slide.
    pub name: String,
    /// The point or the link that slides.
    pub slider: String,
    /// In N, along the guide's direction turned by +90 degrees.
    pub normal: Entry,
    /// The moment on a link that does not turn, in N m about its origin; `None` for a pin, which bears
    /// none.
    pub moment: Option<Entry>,
    /// Where the line of action of the normal force crosses the guide: from the link's origin in the
    /// guide's direction, in the scene's unit. A couple without a force has no such line.
    pub at: Option<Entry>,
}

/// What the whole does to the frame: the shaking force and moment.
#[derive(Clone, Debug)]
pub struct Shaking {
    /// In N.
    pub force: Option<PlaneVector>,
    /// In N m about the scene's origin, the driver's included.
    pub moment: Entry,
}

/// How far the checks miss: nothing but rounding.
#[derive(Clone, Copy, Debug)]
pub struct Checks {
    /// What the driver does against the virtual work of all that acts, in N m or N.
    pub drive: Entry,
    /// The force on the frame against the sum of all that acts, in N; and the moments, in N m.
    pub frame: [Entry; 3],
}

/// The forces of one state.
#[derive(Clone, Debug)]
pub struct Forces {
    /// What the state is.
    pub condition: Condition,
    /// The symbol of the scene's length unit.
    pub unit: &'static str,
    /// What the driver must do.
    pub drive: Drive,
    /// The joints of every link, in the order of the file.
    pub joints: Vec<JointRow>,
    /// The guides.
    pub guides: Vec<GuideRow>,
    /// The frame.
    pub frame: Shaking,
    /// The two checks.
    pub checks: Checks,
    /// Why they are withheld, though they were found: then the checks are all that is shown.
    pub withheld: Option<String>,
    /// Reactions that a redundant linkage leaves open, as columns are named: `r5.D`, `r6.normal`.
    pub indeterminate: Vec<String>,
    /// Those of least norm in their stead.
    pub least: Option<Least>,
}

/// How much of the forces exists.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Existence {
    /// Everything.
    Everything,
    /// What the driver must do, and no reaction.
    DriveAlone,
    /// They were found and are withheld; the checks say why.
    Withheld,
    /// Nothing.
    Nothing,
}

impl Forces {
    /// Reads the forces of a state that was solved to [`Order::Force`](crate::solver::Order::Force);
    /// `None` where nothing acts on the linkage.
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
            least: Least::new(scene, solver, state, (&joints, &guides)),
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

    /// How much of them exists.
    #[must_use]
    pub fn existence(&self) -> Existence {
        match (self.drive.total.value, self.frame.force) {
            _ if self.withheld.is_some() => Existence::Withheld,
            (None, _) => Existence::Nothing,
            (Some(_), None) => Existence::DriveAlone,
            (Some(_), Some(_)) => Existence::Everything,
        }
    }

    /// What is to be said about figures that are missing, in whole sentences.
    #[must_use]
    pub fn remarks(&self) -> Vec<String> {
        let mut remarks: Vec<String> = Vec::new();
        match (self.existence(), self.condition) {
            (Existence::Everything, _) => {}
            (Existence::Withheld, _) => remarks.extend(self.withheld.clone()),
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

    /// What the driver does.
    fn effort(&self) -> &'static str {
        match self.drive.aspect {
            Aspect::Force => words().force(),
            _ => words().torque(),
        }
    }

    /// Every figure with its name and its unit, in the order of the catalogue.
    pub(crate) fn figures(&self) -> Vec<(String, &'static str, Entry)> {
        let Forces { drive, frame, .. } = self;
        let effort = drive.aspect.name();
        let unit = match drive.aspect {
            Aspect::Force => "N",
            _ => "N m",
        };
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

/// Why the forces of a state are withheld, in a whole sentence.
pub(super) fn withheld(scene: &Scene, state: &State) -> Option<String> {
    let hidden = Hidden::of_forces(state)?;
    Some(sentence(&hidden.text(&Catalogue::new(scene).driver().unit)))
}

/// A clause as a sentence of its own.
pub(super) fn sentence(text: &str) -> String {
    Language::spoken().capitalised(text) + "."
}

/// What the driver must do, as a person calls it.
pub(crate) fn effort_word(effort: Aspect) -> &'static str {
    match effort {
        Aspect::Torque => words().torque(),
        _ => words().force(),
    }
}

/// The parts of what the driver must do, and what the checks miss, as columns name them.
pub(super) const PARTS: [&str; 3] = ["load", "gravity", "inertia"];
const RESIDUAL: &str = "residual";

/// A force by components, size and direction.
pub(super) fn plane_figures(
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

/// One figure, which no scene gives.
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
    let (name, aspect) = match scene.mechanism.driver().input {
        crate::Input::Turn(link) => (scene.link_name(link), Aspect::Torque),
        crate::Input::Push(slide) => (scene.slide_name(slide), Aspect::Force),
    };
    let share = |share, aspect| found(Subject::Drive(share), aspect, reading);
    let parts = [Share::Load, Share::Gravity, Share::Inertia];
    Drive {
        name: name.to_owned(),
        aspect,
        total: share(Share::Total, aspect),
        parts: parts.map(|part| share(part, aspect)),
        own: efforts(scene, reading),
        power: share(Share::Total, Aspect::Power),
    }
}

/// What each of several inputs does itself.
fn efforts(scene: &Scene, reading: &ProvedState<'_>) -> Vec<(String, Aspect, Entry)> {
    let mechanism = &scene.mechanism;
    let several = mechanism.inputs().filter(|_| !mechanism.timed().is_empty());
    let own = several.map(|input| {
        let (name, aspect, subject) = match input {
            crate::Input::Turn(link) => {
                (scene.link_name(link), Aspect::Torque, Subject::Link(link))
            }
            crate::Input::Push(slide) => (
                scene.slide_name(slide),
                Aspect::Force,
                Subject::Slide(slide),
            ),
        };
        (name.to_owned(), aspect, found(subject, aspect, reading))
    });
    own.collect()
}

fn checks(scene: &Scene, reading: &ProvedState<'_>) -> Checks {
    let aspect = match scene.mechanism.driver().input {
        crate::Input::Turn(_) => Aspect::Torque,
        crate::Input::Push(_) => Aspect::Force,
    };
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

/// A force N at the distance x along the guide turns by x N: x = M / N. Of a normal force that may be
/// nothing there is no line.
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
        // The roundings of the two divisions, and of the bound itself.
        (off + 4.0 * f64::EPSILON * arm.abs()) / metres * (1.0 + 16.0 * f64::EPSILON)
    });
    Entry {
        value: Some(arm / metres).filter(|arm| arm.is_finite()),
        given: false,
        bound: bound.filter(|bound| bound.is_finite()),
    }
}

pub(super) fn indeterminate(scene: &Scene, solver: &Solver) -> Vec<String> {
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
