//! The forces of the current state, and their number formats over the motion.

use crate::report::{Entry, Forces};
use crate::tui::figures::format::Format;

/// Forces with the formats of their values.
#[derive(Debug)]
pub(crate) struct ForceFigures {
    forces: Forces,
    formats: Formats,
}

/// Number formats. Values of one kind share a format, so that they can be compared by eye.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Formats {
    /// The driver's effort and its parts.
    pub(crate) effort: Format,
    pub(crate) power: Format,
    /// Forces at joints, guides and the frame.
    pub(crate) force: Format,
    pub(crate) moment: Format,
    /// Distances along a guide.
    pub(crate) arm: Format,
}

impl ForceFigures {
    /// Creates the forces of a state, with formats that fit `samples` over the motion.
    pub(crate) fn new(forces: Forces, samples: &[Forces]) -> ForceFigures {
        ForceFigures {
            forces,
            formats: Formats::of(samples),
        }
    }

    /// Replaces the forces after the driver has moved in the same scene.
    pub(crate) fn follow(&mut self, forces: Option<Forces>) {
        if let Some(forces) = forces {
            self.forces = forces;
        }
    }

    pub(crate) fn forces(&self) -> &Forces {
        &self.forces
    }

    pub(crate) fn formats(&self) -> &Formats {
        &self.formats
    }
}

impl Formats {
    fn of(samples: &[Forces]) -> Formats {
        let format = |entries: fn(&Forces) -> Vec<Entry>| {
            let sizes = samples.iter().flat_map(entries);
            let sizes = sizes
                .filter_map(|entry| entry.display_value())
                .map(f64::abs);
            // Zeros are ignored: they say nothing about the magnitude of the other values.
            Format::of_sizes(sizes.filter(|size| *size > 0.0).collect())
        };
        Formats {
            effort: format(|forces| {
                let drive = &forces.drive;
                let own = drive.own.iter().map(|(.., effort)| *effort);
                own.chain([drive.total]).chain(drive.parts).collect()
            }),
            power: format(|forces| vec![forces.drive.power]),
            force: format(sizes_of_forces),
            moment: format(|forces| {
                let guides = forces.guides.iter().filter_map(|guide| guide.moment);
                guides.chain([forces.frame.moment]).collect()
            }),
            arm: format(|forces| forces.guides.iter().filter_map(|guide| guide.at).collect()),
        }
    }
}

/// Returns the magnitudes of all forces, which their components do not exceed.
fn sizes_of_forces(forces: &Forces) -> Vec<Entry> {
    let joints = forces.joints.iter().filter_map(|joint| joint.force);
    let planes = joints.chain(forces.frame.force);
    let sizes = planes.map(|plane| plane.entries(false)[2]);
    sizes
        .chain(forces.guides.iter().map(|guide| guide.normal))
        .collect()
}
