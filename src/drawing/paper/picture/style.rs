//! The style sheet for drawings on paper.

use crate::drawing::figure::Role;
use crate::page::StyleSheet;
use std::borrow::Cow;

/// Paper, ink, and the hues of the workbench's palettes for a light and a dark background. Roles
/// also differ in dashes, line widths and heads.
pub(super) const STYLE: StyleSheet = StyleSheet {
    light: include_str!("light.css"),
    dark: include_str!("dark.css"),
};

pub(super) fn class(role: Role) -> Cow<'static, str> {
    let class = match role {
        Role::Link(hue) => return Cow::Owned(format!("link hue{hue}")),
        Role::Plate(hue) => return Cow::Owned(format!("plate hue{hue}")),
        Role::DriverPlate => "plate driven",
        Role::Ground => "ground",
        Role::Guide => "guide",
        Role::Driver => "driver",
        Role::Spring => "spring",
        Role::Ghost => "ghost",
        Role::Echo => "echo",
        Role::Trace => "trace",
        Role::Trail => "trail",
        Role::Velocity => "velocity",
        Role::Acceleration => "acceleration",
        Role::Force => "force",
        Role::Empty
        | Role::DriverPin
        | Role::Joint
        | Role::GroundPin
        | Role::Slider
        | Role::Rider
        | Role::CentreOfMass
        | Role::Lit
        | Role::Label
        | Role::LinkName(_)
        | Role::Axis
        | Role::Datum
        | Role::Second
        | Role::Third
        | Role::Front => "link",
    };
    Cow::Borrowed(class)
}
