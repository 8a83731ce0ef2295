//! The hues of a drawing's roles: one table for all terminals and for recordings.

use super::figure::Role;

/// A hue that is distinguishable from the others at a glance.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Hue {
    Red,
    Orange,
    /// Orange for text: an orange for drawings is too light for letters.
    Brown,
    Yellow,
    Lime,
    /// A fainter lime.
    Moss,
    Green,
    Teal,
    Cyan,
    Blue,
    Violet,
    Magenta,
    /// For parts in the background.
    Grey,
}

/// The hues of links, by number. Neighbours differ clearly, and none is close to the driver's.
const LINKS: [Hue; 5] = [Hue::Blue, Hue::Green, Hue::Violet, Hue::Orange, Hue::Teal];

impl Hue {
    /// Returns the hue of a role; `None` for roles in the text colour.
    pub(crate) fn of(role: Role) -> Option<Hue> {
        Some(match role {
            Role::Link(hue) | Role::Plate(hue) => LINKS[usize::from(hue) % LINKS.len()],
            Role::LinkName(hue) => match LINKS[usize::from(hue) % LINKS.len()] {
                Hue::Orange => Hue::Brown,
                bar => bar,
            },
            Role::Driver | Role::DriverPlate | Role::DriverPin | Role::Second => Hue::Red,
            Role::Ground | Role::Guide | Role::Ghost | Role::Echo | Role::Axis => Hue::Grey,
            Role::Trail => Hue::Lime,
            Role::Trace => Hue::Moss,
            Role::Spring | Role::Force => Hue::Yellow,
            Role::Velocity => Hue::Cyan,
            Role::Acceleration | Role::Third => Hue::Magenta,
            Role::Joint
            | Role::GroundPin
            | Role::Slider
            | Role::Rider
            | Role::CentreOfMass
            | Role::Front
            | Role::Lit
            | Role::Empty
            | Role::Label
            | Role::Datum => return None,
        })
    }

    /// Returns the hue's number in the fixed palette of 256 colours. All have a middle luminance,
    /// with similar contrast against black and white.
    pub(crate) fn on_any_ground(self) -> u8 {
        match self {
            Hue::Red => 131,
            Hue::Orange => 166,
            Hue::Brown => 130,
            Hue::Yellow => 130,
            Hue::Lime => 64,
            Hue::Moss => 65,
            Hue::Green => 28,
            Hue::Teal => 29,
            Hue::Cyan => 30,
            Hue::Blue => 63,
            Hue::Violet => 98,
            Hue::Magenta => 163,
            Hue::Grey => 243,
        }
    }
}

/// Returns `true` if a part of the drawing is bold.
pub(crate) fn is_bold(role: Role) -> bool {
    let stands_out = matches!(role, Role::Velocity | Role::Force | Role::Lit | Role::Front);
    stands_out || role.is_mark()
}

#[cfg(test)]
mod tests {
    use super::super::LINK_HUES;
    use super::*;

    /// Links differ from each other, from the driver, and from arrows and traces; these differ from
    /// each other.
    #[test]
    fn roles_have_distinct_hues() {
        assert_eq!(usize::from(LINK_HUES), LINKS.len());
        let mut links: Vec<_> = (0..LINK_HUES).map(|k| Hue::of(Role::Link(k))).collect();
        links.push(Hue::of(Role::Driver));
        let others = [
            Role::Velocity,
            Role::Acceleration,
            Role::Force,
            Role::Trace,
            Role::Ghost,
        ];
        let others = others.map(Hue::of);
        for set in [&links[..], &others[..]] {
            for (k, one) in set.iter().enumerate() {
                assert!(!set[k + 1..].contains(one), "{one:?}");
            }
        }
        assert!(links.iter().all(|link| !others.contains(link)));
    }
}
