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
.hue0{stroke:#0000ff;fill:none}
.hue1{stroke:#005f00;fill:none}
.hue2{stroke:#8700af;fill:none}
.hue3{stroke:#7d3e00;fill:none}
.hue4{stroke:#005a5a;fill:none}
.plate.hue0{stroke:none;fill:#0000ff}
.plate.hue1{stroke:none;fill:#005f00}
.plate.hue2{stroke:none;fill:#8700af}
.plate.hue3{stroke:none;fill:#7d3e00}
.plate.hue4{stroke:none;fill:#005a5a}
.plate.driven{stroke:none;fill:#a50e16}
.driver,.barrel{stroke:#a50e16}
.barrel{stroke-width:2}
.rod{stroke-width:3}
.spring{stroke:#845a00}
.barrel{fill:#fff}
.guide,.ground{stroke-width:1.2;stroke:#666}
.ghost{stroke-width:1.5;stroke:#888;stroke-dasharray:2 5}
.echo{stroke-width:1;stroke:#888;stroke-opacity:.6}
.trace{stroke-width:1.2;stroke:#546800}
.trail{stroke-width:2.4;stroke:#546800}
.velocity{stroke:#006e8c}
.force{stroke:#845a00;fill:none}
.acceleration{stroke:#b414a0;stroke-dasharray:7 4}
.head{stroke-dasharray:none}
.pin,.block{fill:#fff}
circle{stroke:#222;stroke-width:2}
.rider{fill:#222}
.core{stroke:none;fill:#a50e16}
.centre{fill:none;stroke-width:1.2}
.cross{stroke-width:1.2}
.halo{stroke:#fff;stroke-width:4;stroke-linejoin:round;fill:none}
",
    dark: "\
.hue0{stroke:#87d7ff}
.hue1{stroke:#87ff87}
.hue2{stroke:#ffafff}
.hue3{stroke:#ffd787}
.hue4{stroke:#5fffd7}
.plate.hue0{fill:#87d7ff}
.plate.hue1{fill:#87ff87}
.plate.hue2{fill:#ffafff}
.plate.hue3{fill:#ffd787}
.plate.hue4{fill:#5fffd7}
.plate.driven{fill:#ffaca4}
.driver,.barrel{stroke:#ffaca4}
.spring{stroke:#deb43c}
.barrel,.pin,.block{fill:#181818}
.guide,.ground{stroke:#999}
.trace{stroke:#acc43c}
.trail{stroke:#acc43c}
.velocity{stroke:#40b8e2}
.force{stroke:#deb43c}
.acceleration{stroke:#e888d8}
circle{stroke:#ddd}
.rider{fill:#ddd}
.core{fill:#ffaca4}
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
