//! The style sheet for drawings on paper.

use crate::drawing::figure::Role;
use crate::page::StyleSheet;
use std::borrow::Cow;

/// Paper, ink, and the hues of the workbench's palettes for a light and a dark background. Roles
/// also differ in dashes, line widths and heads.
pub(super) const STYLE: StyleSheet = StyleSheet {
    light: "\
.link,.driver{stroke-width:6}
.plate{stroke:none;fill-opacity:.14}
.hue0{stroke:#005fd7;fill:none}
.hue1{stroke:#005f00;fill:none}
.hue2{stroke:#8700d7;fill:none}
.hue3{stroke:#d75f00;fill:none}
.hue4{stroke:#005f5f;fill:none}
.plate.hue0{stroke:none;fill:#005fd7}
.plate.hue1{stroke:none;fill:#005f00}
.plate.hue2{stroke:none;fill:#8700d7}
.plate.hue3{stroke:none;fill:#d75f00}
.plate.hue4{stroke:none;fill:#005f5f}
.plate.driven{stroke:none;fill:#c81e24}
.driver,.barrel{stroke:#c81e24}
.barrel{stroke-width:2}
.rod{stroke-width:3}
.spring{stroke:#826901}
.barrel{fill:#fff}
.guide,.ground{stroke-width:1.2;stroke:#666}
.ghost{stroke-width:1.5;stroke:#888;stroke-dasharray:2 5}
.echo{stroke-width:1;stroke:#888;stroke-opacity:.6}
.trace{stroke-width:1.2;stroke:#607602}
.trail{stroke-width:2.4;stroke:#607602}
.velocity{stroke:#007590}
.force{stroke:#826901;fill:none}
.acceleration{stroke:#b81ea6;stroke-dasharray:7 4}
.head{stroke-dasharray:none}
.pin,.block{fill:#fff}
circle{stroke:#222;stroke-width:2}
.rider{fill:#222}
.core{stroke:none;fill:#c81e24}
.centre{fill:none;stroke-width:1.2}
.cross{stroke-width:1.2}
.halo{stroke:#fff;stroke-width:4;stroke-linejoin:round;fill:none}
",
    dark: "\
.hue0{stroke:#5f87ff}
.hue1{stroke:#5fd75f}
.hue2{stroke:#af87ff}
.hue3{stroke:#ffaf5f}
.hue4{stroke:#00d7af}
.plate.hue0{fill:#5f87ff}
.plate.hue1{fill:#5fd75f}
.plate.hue2{fill:#af87ff}
.plate.hue3{fill:#ffaf5f}
.plate.hue4{fill:#00d7af}
.plate.driven{fill:#ff6961}
.driver,.barrel{stroke:#ff6961}
.spring{stroke:#ebcb50}
.barrel,.pin,.block{fill:#181818}
.guide,.ground{stroke:#999}
.trace{stroke:#b0d048}
.trail{stroke:#b0d048}
.velocity{stroke:#56c4fa}
.force{stroke:#ebcb50}
.acceleration{stroke:#f472dc}
circle{stroke:#ddd}
.rider{fill:#ddd}
.core{fill:#ff6961}
.halo{stroke:#181818}
",
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
