//! From the colours that views ask for to those that a terminal gets.
//!
//! Views name colours as the terminal's own palette does, one name for each role. In 16 colours that
//! is what is sent, so that everybody's own palette stays in force. With more colours each name stands
//! for one that was chosen: `auto` for such as read on black as well as on white, since nobody can
//! know the ground without asking; `light` and `dark` for better ones where it is known. Faint text,
//! which many terminals make too faint, becomes a grey of known contrast there.

use crate::capability::Colours;
use ratatui::style::{Color, Modifier};

/// Which colours stand for the names.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Theme {
    /// On any ground.
    #[default]
    Auto,
    /// On a light ground.
    Light,
    /// On a dark ground.
    Dark,
    /// No colour, but bold, faint and reversed.
    Plain,
}

impl Theme {
    /// As the options and the configuration name it.
    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            Theme::Auto => "auto",
            Theme::Light => "light",
            Theme::Dark => "dark",
            Theme::Plain => "plain",
        }
    }
}

/// What a palette name stands for beyond its brightness.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Hue {
    Red,
    Green,
    Yellow,
    Blue,
    Magenta,
    Cyan,
    /// What is told quietly.
    Grey,
}

/// The colours of a hue: by number in the fixed palette, and exactly.
struct Shade {
    index: u8,
    exact: Color,
}

const fn both(index: u8) -> Shade {
    Shade {
        index,
        exact: Color::Indexed(index),
    }
}

const fn shade(index: u8, r: u8, g: u8, b: u8) -> Shade {
    Shade {
        index,
        exact: Color::Rgb(r, g, b),
    }
}

impl Hue {
    #[cfg(test)]
    const ALL: [Hue; 7] = [
        Hue::Red,
        Hue::Green,
        Hue::Yellow,
        Hue::Blue,
        Hue::Magenta,
        Hue::Cyan,
        Hue::Grey,
    ];

    fn of(colour: Color) -> Option<Hue> {
        Some(match colour {
            Color::Red | Color::LightRed => Hue::Red,
            Color::Green | Color::LightGreen => Hue::Green,
            Color::Yellow | Color::LightYellow => Hue::Yellow,
            Color::Blue | Color::LightBlue => Hue::Blue,
            Color::Magenta | Color::LightMagenta => Hue::Magenta,
            Color::Cyan | Color::LightCyan => Hue::Cyan,
            Color::Gray | Color::DarkGray => Hue::Grey,
            Color::Reset | Color::Black | Color::White | Color::Indexed(_) | Color::Rgb(..) => {
                return None;
            }
        })
    }

    /// Of the names of the palette, the one that reads better on a dark ground.
    fn bright(self) -> Color {
        match self {
            Hue::Red => Color::LightRed,
            Hue::Green => Color::LightGreen,
            Hue::Yellow => Color::LightYellow,
            Hue::Blue => Color::LightBlue,
            Hue::Magenta => Color::LightMagenta,
            Hue::Cyan => Color::LightCyan,
            Hue::Grey => Color::Gray,
        }
    }

    /// And the one that reads better on a light ground. Yellow is none there: it is brown at best.
    fn deep(self) -> Color {
        match self {
            Hue::Red => Color::Red,
            Hue::Green => Color::Green,
            Hue::Yellow => Color::Yellow,
            Hue::Blue => Color::Blue,
            Hue::Magenta => Color::Magenta,
            Hue::Cyan => Color::Cyan,
            Hue::Grey => Color::DarkGray,
        }
    }

    /// In more than 16 colours.
    fn shade(self, theme: Theme) -> Shade {
        match (theme, self) {
            // Of middle luminance: the contrasts against black and against white are alike. The fixed
            // palette has few such colours, so that exact ones are worth their bytes.
            (Theme::Auto | Theme::Plain, Hue::Red) => shade(131, 228, 36, 36),
            (Theme::Auto | Theme::Plain, Hue::Green) => shade(28, 14, 136, 34),
            (Theme::Auto | Theme::Plain, Hue::Yellow) => shade(130, 153, 110, 0),
            (Theme::Auto | Theme::Plain, Hue::Blue) => shade(63, 63, 115, 209),
            (Theme::Auto | Theme::Plain, Hue::Magenta) => shade(163, 200, 40, 200),
            (Theme::Auto | Theme::Plain, Hue::Cyan) => shade(30, 0, 131, 131),
            (Theme::Auto | Theme::Plain, Hue::Grey) => both(243),
            (Theme::Light, Hue::Red) => both(160),
            (Theme::Light, Hue::Green) => both(22),
            (Theme::Light, Hue::Yellow) => both(94),
            (Theme::Light, Hue::Blue) => both(26),
            (Theme::Light, Hue::Magenta) => both(127),
            (Theme::Light, Hue::Cyan) => both(24),
            (Theme::Light, Hue::Grey) => both(242),
            (Theme::Dark, Hue::Red) => both(203),
            (Theme::Dark, Hue::Green) => both(77),
            (Theme::Dark, Hue::Yellow) => both(179),
            (Theme::Dark, Hue::Blue) => both(75),
            (Theme::Dark, Hue::Magenta) => both(176),
            (Theme::Dark, Hue::Cyan) => both(80),
            (Theme::Dark, Hue::Grey) => both(247),
        }
    }

    fn colour(self, theme: Theme, exact: bool) -> Color {
        let shade = self.shade(theme);
        if exact {
            shade.exact
        } else {
            Color::Indexed(shade.index)
        }
    }
}

/// How colours are sent.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct Palette {
    pub(crate) colours: Colours,
    pub(crate) theme: Theme,
}

impl Palette {
    /// The colour that is sent for the one that a view names.
    pub(crate) fn colour(self, named: Color) -> Color {
        match (self.colours, Hue::of(named)) {
            (Colours::None, _) => Color::Reset,
            (_, None) => named,
            (Colours::Sixteen, Some(hue)) => match self.theme {
                Theme::Auto | Theme::Plain => named,
                Theme::Light => hue.deep(),
                Theme::Dark => hue.bright(),
            },
            (Colours::Indexed, Some(hue)) => hue.colour(self.theme, false),
            (Colours::True, Some(hue)) => hue.colour(self.theme, true),
        }
    }

    /// Faint text as a colour, where there is a better one than the terminal's own.
    pub(crate) fn faint(self, colour: Color, modifier: Modifier) -> (Color, Modifier) {
        let is_faint = modifier.contains(Modifier::DIM) && !modifier.contains(Modifier::REVERSED);
        match self.colours {
            Colours::Indexed | Colours::True if is_faint && colour == Color::Reset => {
                let grey = Hue::Grey.colour(self.theme, self.colours == Colours::True);
                (grey, modifier - Modifier::DIM)
            }
            // A chosen colour made fainter is one that nobody chose.
            Colours::Indexed | Colours::True => (colour, modifier - Modifier::DIM),
            Colours::None | Colours::Sixteen => (colour, modifier),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const BLACK: Color = Color::Rgb(0, 0, 0);
    const WHITE: Color = Color::Rgb(255, 255, 255);
    /// The grounds of two schemes that many people use.
    const SOFT_BLACK: Color = Color::Rgb(0x1e, 0x1e, 0x1e);
    const SOFT_WHITE: Color = Color::Rgb(0xfd, 0xf6, 0xe3);

    fn exact(colour: Color) -> [u8; 3] {
        let level = |n: u8| if n == 0 { 0 } else { 55 + 40 * n };
        match colour {
            Color::Rgb(r, g, b) => [r, g, b],
            Color::Indexed(i @ 16..=231) => {
                let n = i - 16;
                [level(n / 36), level(n / 6 % 6), level(n % 6)]
            }
            Color::Indexed(i @ 232..) => [8 + 10 * (i - 232); 3],
            other => panic!("{other:?} depends on the terminal"),
        }
    }

    /// WCAG 2.2, relative luminance.
    fn luminance(colour: Color) -> f64 {
        let linear = exact(colour).map(|c| {
            let c = f64::from(c) / 255.0;
            if c <= 0.04045 {
                c / 12.92
            } else {
                ((c + 0.055) / 1.055).powf(2.4)
            }
        });
        0.2126 * linear[0] + 0.7152 * linear[1] + 0.0722 * linear[2]
    }

    fn contrast(a: Color, b: Color) -> f64 {
        let [a, b] = [luminance(a), luminance(b)];
        (a.max(b) + 0.05) / (a.min(b) + 0.05)
    }

    fn worst(theme: Theme, exact: bool, grounds: &[Color]) -> f64 {
        let colours = Hue::ALL.map(|hue| hue.colour(theme, exact));
        let all = colours
            .iter()
            .flat_map(|c| grounds.iter().map(|g| contrast(*c, *g)));
        all.fold(f64::INFINITY, f64::min)
    }

    #[test]
    fn contrast_is_what_the_standard_says() {
        assert!((contrast(BLACK, WHITE) - 21.0).abs() < 1e-9);
        assert!((contrast(Color::Rgb(0x76, 0x76, 0x76), WHITE) - 4.54).abs() < 0.01);
    }

    /// 4.58 is the most that any colour has against both black and white; against two softer grounds
    /// it is 3.9, so that those who have one name it.
    #[test]
    fn colours_read_well_on_any_ground() {
        assert!(worst(Theme::Auto, true, &[BLACK, WHITE]) >= 4.5);
        assert!(worst(Theme::Auto, false, &[BLACK, WHITE]) >= 4.3);
        assert!(worst(Theme::Auto, true, &[SOFT_BLACK, SOFT_WHITE]) >= 3.5);
        assert!(worst(Theme::Auto, false, &[SOFT_BLACK, SOFT_WHITE]) >= 3.5);
    }

    #[test]
    fn colours_read_better_on_a_ground_that_is_known() {
        for exact in [false, true] {
            assert!(worst(Theme::Light, exact, &[WHITE, SOFT_WHITE]) >= 4.5);
            assert!(worst(Theme::Dark, exact, &[BLACK, SOFT_BLACK]) >= 4.5);
        }
    }

    #[test]
    fn hues_differ() {
        for theme in [Theme::Auto, Theme::Light, Theme::Dark] {
            for exact in [false, true] {
                let mut colours = Hue::ALL.map(|hue| format!("{:?}", hue.colour(theme, exact)));
                colours.sort();
                assert!(colours.windows(2).all(|pair| pair[0] != pair[1]));
            }
        }
    }

    #[test]
    fn sixteen_colours_are_names_of_the_palette() {
        let sent = |theme, named| {
            let colours = Colours::Sixteen;
            Palette { colours, theme }.colour(named)
        };
        assert_eq!(sent(Theme::Auto, Color::Red), Color::Red);
        assert_eq!(sent(Theme::Dark, Color::Red), Color::LightRed);
        assert_eq!(sent(Theme::Light, Color::LightCyan), Color::Cyan);
        assert_eq!(sent(Theme::Dark, Color::Reset), Color::Reset);
    }

    #[test]
    fn faint_text_is_grey_where_greys_are_known() {
        let faint = |colours| {
            let palette = Palette {
                colours,
                theme: Theme::Auto,
            };
            palette.faint(Color::Reset, Modifier::DIM | Modifier::BOLD)
        };
        let as_it_was = (Color::Reset, Modifier::DIM | Modifier::BOLD);
        assert_eq!(faint(Colours::Sixteen), as_it_was);
        assert_eq!(
            faint(Colours::Indexed),
            (Color::Indexed(243), Modifier::BOLD)
        );
    }
}
