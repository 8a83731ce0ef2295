//! Reads the forces of a state.

use super::{Extent, ForceState, TorquePart, TorqueScale};
use crate::solver::state::State;
use crate::{Input, LinkId, Number, PointId, SlideId, Vec2};

/// The residuals of the force checks: zero except for rounding errors.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Residual<T = f64> {
    /// The difference between the driver's torque (N m) or force (N) and the value required by the
    /// virtual work of all loads.
    pub drive: T,
    /// The difference between the force on the frame and the sum of all loads, in N.
    pub force: Vec2<T>,
    /// The difference of the moments about the scene's origin, in N m.
    pub moment: T,
}

/// Equal if all readable values are.
impl<T: Number + PartialEq> PartialEq for ForceState<T> {
    fn eq(&self, other: &ForceState<T>) -> bool {
        let drive = || (&self.drive, &self.work) == (&other.drive, &other.work);
        let reactions = || {
            (&self.joints, &self.normals, &self.moments)
                == (&other.joints, &other.normals, &other.moments)
                && (&self.frame, &self.frame_moment) == (&other.frame, &other.frame_moment)
        };
        self.extent == other.extent
            && match self.extent {
                Extent::Nothing => true,
                Extent::Drive => self.work == other.work,
                Extent::WithheldReason(_) | Extent::All => drive() && reactions(),
            }
    }
}

impl<T: Number> State<T> {
    /// Clears the forces of a state solved without them.
    #[inline]
    pub(in crate::solver) fn forget_forces(&mut self) {
        if let Some(forces) = &mut self.forces {
            forces.extent = Extent::Nothing;
        }
    }

    fn balanced(&self) -> Option<&ForceState<T>> {
        self.forces.as_deref()?.all()
    }

    /// Returns the driver's torque in N m, or the force of a driven slide in N. `None` if it does
    /// not exist, if there are no loads, or if forces were not requested
    /// ([`Order::Force`](crate::solver::Order::Force)).
    #[must_use]
    pub fn drive(&self) -> Option<T> {
        let forces = self.forces.as_deref()?;
        if self.free.is_some() {
            return self.effort(*forces.inputs.first()?);
        }
        let is_known = matches!(forces.extent, Extent::Drive | Extent::All);
        // Subtracted, so that zero has no negative sign.
        let drive = T::default() - forces.virtual_work() * forces.scale.drive;
        is_known.then_some(drive).filter(|drive| drive.is_finite())
    }

    /// Returns the own torque of an input in N m, or its force in N. If further inputs follow the
    /// driver, [`State::drive`] does the work of all of them.
    #[must_use]
    pub fn effort(&self, input: Input) -> Option<T> {
        let forces = self.balanced()?;
        let number = forces.inputs.iter().position(|of| *of == input)?;
        let unit = match input {
            Input::Turn(_) => forces.scale.couple,
            Input::Push(_) => T::exactly(1.0),
        };
        let effort = match forces.efforts[..] {
            // The velocities are those for a unit rate of the driver, except of free inputs.
            [_] if self.free.is_none() => forces.virtual_work(),
            _ => forces.efforts[number],
        };
        // Subtracted, so that zero has no negative sign.
        let effort = T::default() - effort * unit;
        Some(effort).filter(|effort| effort.is_finite())
    }

    /// Returns the parts of the drive against loads (including springs), against gravity and
    /// against inertia. `None` if every input moves by itself: the work has no parts by input.
    #[must_use]
    pub fn drive_parts(&self) -> Option<[T; 3]> {
        let forces = self.forces.as_deref().filter(|_| self.free.is_none())?;
        let parts = [TorquePart::Load, TorquePart::Gravity, TorquePart::Inertia];
        let parts = parts.map(|part| forces.virtual_work_force(part));
        matches!(forces.extent, Extent::Drive | Extent::All).then_some(parts)
    }

    /// Returns the power of the driver in W: positive if it gives energy to the linkage. It includes
    /// that of further inputs.
    #[must_use]
    pub fn power(&self) -> Option<T> {
        let forces = self.forces.as_deref()?;
        if self.free.is_some() {
            let all = self.balanced()?.drive * forces.scale.couple;
            return Some(T::default() - all).filter(|power| power.is_finite());
        }
        let metres = forces.scale.couple.scaled(1.0 / self.frame.scale);
        let speed = self.driver_speed();
        let speed = if self.turns() { speed } else { speed * metres };
        Some(self.drive()? * speed)
    }

    /// Returns the force on a link at one of its joints, in N, in the ground's frame. It is the
    /// force of the pin; at the origin of a sliding link it excludes the force of the guide.
    #[must_use]
    pub fn joint_force(&self, link: LinkId, point: PointId) -> Option<Vec2<T>> {
        let forces = self.balanced()?;
        let slot = forces.slots.find(link, point)?;
        (!forces.open.joints[slot]).then(|| forces.joints[slot])
    }

    /// Returns the force of a guide on its slider, in N, positive along the guide's direction
    /// turned by +90 degrees.
    #[must_use]
    pub fn normal(&self, slide: SlideId) -> Option<T> {
        let forces = self.balanced()?;
        let is_open = forces.open.normals[slide.index()];
        (!is_open).then(|| forces.normals[slide.index()])
    }

    /// Returns the moment of a guide on a link that slides without turning, in N m,
    /// counter-clockwise, about the link's origin.
    #[must_use]
    pub fn moment(&self, slide: SlideId) -> Option<T> {
        let forces = self.balanced()?;
        let is_open = forces.open.moments[slide.index()];
        (!is_open).then(|| forces.moments[slide.index()] * forces.scale.couple)
    }

    /// Returns the shaking force: the total force on the frame, in N. It is the sum of all loads,
    /// which [`State::residual`] compares with the reactions on the frame.
    #[must_use]
    pub fn frame_force(&self) -> Option<Vec2<T>> {
        Some(self.balanced()?.sum)
    }

    /// Returns the shaking moment: the total moment on the frame, motor included, in N m about the
    /// scene's origin.
    #[must_use]
    pub fn frame_moment(&self) -> Option<T> {
        let forces = self.balanced()?;
        let TorqueScale { couple, origin, .. } = forces.scale;
        Some(forces.sum_moment * couple + origin.cross(forces.sum))
    }

    /// Returns the residuals of the checks, even if the forces are not shown because of them.
    #[must_use]
    pub fn residual(&self) -> Option<Residual<T>> {
        let forces = self.forces.as_deref()?;
        let scale = &forces.scale;
        let Residual {
            drive,
            force,
            moment,
        } = forces.misses();
        matches!(forces.extent, Extent::All | Extent::WithheldReason(_)).then(|| Residual {
            drive: -(drive * scale.drive),
            force,
            moment: moment * scale.couple + scale.origin.cross(force),
        })
    }
}
