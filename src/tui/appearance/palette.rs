//! Maps the colours named by views to those sent to the terminal.
//!
//! Views use the names of the terminal's own palette, one for each role. With 16 colours, names of
//! that palette are sent, so that the user's colours stay in force: the two that are legible on any
//! background, or better ones if the background is known. With more colours each name maps to a
//! selected colour: `auto` is legible on black as well as on white, because the background is
//! unknown; `light` and `dark` are better on a known background, and `auto` becomes one of them as
//! soon as the background is known. Faint text, which many terminals make too faint, then becomes a
//! grey of known contrast.
//!
//! On a known background there are three luminances. Links, pins and the driver are bright, with a
//! contrast of at least 7. Arrows, trails and names have at least 4.5. Guides, hatching, rules, axes
//! and traces are dim, with at least 2.5. With 16 colours, bold and faint text make the difference.
//! Text has the terminal's own colour, or the brightest one if the contrast of that is below 7.

use crate::capability::Colours;
use crate::drawing::Hue;
use crate::wording::words;
use ratatui::style::{Color, Modifier};

/// The set of colours for the names.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Theme {
    /// For the terminal's background if it is known, or else for any one.
    #[default]
    Auto,
    /// For a light background.
    Light,
    /// For a dark background.
    Dark,
    /// Without colours, but with bold, faint and reversed text.
    Plain,
}

impl Theme {
    /// All themes, the default one first.
    pub(crate) const ALL: [Theme; 4] = [Theme::Auto, Theme::Light, Theme::Dark, Theme::Plain];

    /// Returns the name in options and in the configuration.
    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            Theme::Auto => "auto",
            Theme::Light => "light",
            Theme::Dark => "dark",
            Theme::Plain => "plain",
        }
    }

    /// Returns the name in the user's language.
    pub(crate) fn shown_name(self) -> &'static str {
        let own = Theme::ALL.iter().position(|theme| *theme == self);
        let mut names = words().names_of_themes().split(' ');
        own.and_then(|at| names.nth(at)).unwrap_or(self.name())
    }
}

/// Minimum contrast of text.
const MIN_TEXT_CONTRAST: f64 = 7.0;

/// The name of the colour with the highest contrast.
pub(super) const INK: Color = Color::White;

/// The background of a terminal.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Ground {
    Light,
    /// Grey, on which dim colours vanish.
    Middle,
    Dark,
}

impl Ground {
    /// Returns the kind of a background by its colour. Black and white text have equal contrast on
    /// a relative luminance of 0.18, and dim text has about that of its own, 0.22. Its contrast is
    /// below 1.7 on luminances from 0.1 to 0.4.
    pub(crate) fn of(colour: [u8; 3]) -> Ground {
        match luminance(colour) {
            ..0.1 => Ground::Dark,
            0.1..0.4 => Ground::Middle,
            _ => Ground::Light,
        }
    }

    /// Returns the theme for this background.
    pub(crate) fn theme(self) -> Theme {
        match self {
            Ground::Light => Theme::Light,
            Ground::Middle => Theme::Plain,
            Ground::Dark => Theme::Dark,
        }
    }
}

/// Returns the relative luminance of a colour, from 0 to 1.
fn luminance(colour: [u8; 3]) -> f64 {
    let linear = colour.map(|c| (f64::from(c) / 255.0).powf(2.2));
    0.2126 * linear[0] + 0.7152 * linear[1] + 0.0722 * linear[2]
}

/// Returns `true` if the contrast of text on a background is below 7.
pub(crate) fn is_weak_text(text: [u8; 3], ground: [u8; 3]) -> bool {
    let [text, ground] = [text, ground].map(|colour| luminance(colour) + 0.05);
    text.max(ground) < MIN_TEXT_CONTRAST * text.min(ground)
}

/// The colours of a hue: an index into the fixed palette, and an exact colour.
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
    /// The hues of links and of the driver, which are the brightest.
    const OF_LINKS: [Hue; 6] = [
        Hue::Red,
        Hue::Blue,
        Hue::Green,
        Hue::Violet,
        Hue::Orange,
        Hue::Teal,
    ];

    /// Returns the hue of a palette name. Bright names have hues of their own.
    fn hue_of_name(named: Color) -> Option<Hue> {
        Some(match named {
            Color::Red => Hue::Red,
            Color::LightRed => Hue::Orange,
            Color::LightYellow => Hue::Brown,
            Color::Yellow => Hue::Yellow,
            Color::LightGreen => Hue::Lime,
            Color::DarkGray => Hue::Moss,
            Color::Green => Hue::Green,
            Color::LightCyan => Hue::Teal,
            Color::Cyan => Hue::Cyan,
            Color::Blue => Hue::Blue,
            Color::LightBlue => Hue::Violet,
            Color::Magenta | Color::LightMagenta => Hue::Magenta,
            Color::Gray => Hue::Grey,
            Color::Reset | Color::Black | Color::White | Color::Indexed(_) | Color::Rgb(..) => {
                return None;
            }
        })
    }

    /// Returns the palette name by which views refer to the hue.
    pub(super) fn named(self) -> Color {
        let [own, ..] = self.names();
        own
    }

    /// Returns the palette name to send with 16 colours.
    fn sixteen(self, theme: Theme) -> Color {
        let [_, plain, light, dark] = self.names();
        match theme {
            Theme::Auto | Theme::Plain => plain,
            Theme::Light => light,
            Theme::Dark => dark,
        }
    }

    /// Returns palette names: that of the views, and those to send with 16 colours on an unknown, a
    /// light and a dark background.
    ///
    /// Of xterm's palette, only two names are visible on any background; other hues are
    /// distinguished by shape. On a light background, only blue is dark enough for links, and only
    /// red for arrows and names. Red, blue and magenta are too dark for links and names on
    /// Solarized's dark background or on grey. In Solarized's own palette, most bright names are
    /// dark greys.
    fn names(self) -> [Color; 4] {
        use Color::{Blue, Cyan, DarkGray, Gray, Green, Magenta, Red, Reset, Yellow};
        use Color::{LightBlue, LightCyan, LightGreen, LightRed, LightYellow};
        match self {
            Hue::Red => [Red, LightRed, Blue, Yellow],
            Hue::Orange => [LightRed, Reset, Reset, Reset],
            Hue::Brown => [LightYellow, Reset, Reset, Reset],
            Hue::Yellow => [Yellow, Reset, Red, Reset],
            Hue::Lime => [LightGreen, Reset, Reset, Green],
            Hue::Moss => [DarkGray, Reset, Reset, Reset],
            Hue::Green => [Green, Reset, Reset, Reset],
            Hue::Teal => [LightCyan, Reset, Reset, Reset],
            Hue::Cyan => [Cyan, Reset, Red, Cyan],
            Hue::Blue => [Blue, Reset, Reset, LightCyan],
            Hue::Violet => [LightBlue, Reset, Reset, Reset],
            Hue::Magenta => [Magenta, Magenta, Red, Green],
            Hue::Grey => [Gray, DarkGray, DarkGray, Gray],
        }
    }

    /// Returns the shade for terminals with more than 16 colours.
    fn shade(self, theme: Theme) -> Shade {
        let [any, light, dark] = self.shades();
        match theme {
            Theme::Auto | Theme::Plain => any,
            Theme::Light => light,
            Theme::Dark => dark,
        }
    }

    /// Returns the shades on any background, on white and Solarized's light background, and on
    /// black, Solarized's dark background and dark grey. The hues of links always use the fixed
    /// palette: every row of a drawing has some of them, and an exact colour takes twice the bytes.
    fn shades(self) -> [Shade; 3] {
        let own = self.on_any_ground();
        let any = |r, g, b| shade(own, r, g, b);
        match self {
            Hue::Red => [
                any(228, 36, 36),
                shade(88, 165, 14, 22),
                shade(217, 255, 172, 164),
            ],
            Hue::Orange | Hue::Brown => [both(own), shade(52, 125, 62, 0), both(222)],
            Hue::Yellow => [
                any(139, 114, 21),
                shade(94, 132, 90, 0),
                shade(178, 222, 180, 60),
            ],
            Hue::Lime => [
                any(104, 127, 21),
                shade(58, 84, 104, 0),
                shade(148, 172, 196, 60),
            ],
            Hue::Moss => [both(own), both(65), both(65)],
            Hue::Green => [both(own), both(22), both(120)],
            Hue::Teal => [both(own), shade(17, 0, 90, 90), both(86)],
            Hue::Cyan => [
                any(16, 129, 158),
                shade(24, 0, 110, 140),
                shade(37, 64, 184, 226),
            ],
            Hue::Blue => [both(own), both(21), both(117)],
            Hue::Violet => [both(own), both(91), both(219)],
            Hue::Magenta => [
                any(200, 40, 200),
                shade(127, 180, 20, 160),
                shade(176, 232, 136, 216),
            ],
            Hue::Grey => [both(own), both(244), both(244)],
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

/// The number and the theme of the colours.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct Palette {
    pub(crate) colours: Colours,
    pub(crate) theme: Theme,
    /// `true` if the contrast of the terminal's own text is too low.
    pub(crate) has_weak_text: bool,
}

impl Palette {
    /// Returns the colour to send for a named one.
    pub(crate) fn colour(self, named: Color) -> Color {
        match (self.colours, Hue::hue_of_name(named)) {
            (Colours::None, _) => Color::Reset,
            (_, None) if named == INK => self.ink(),
            (_, None) => named,
            (Colours::Sixteen, Some(hue)) => match hue.sixteen(self.theme) {
                Color::Reset
                    if self.theme == Theme::Dark && self.has_weak_text && hue != Hue::Moss =>
                {
                    self.ink()
                }
                sent => sent,
            },
            (Colours::Indexed, Some(hue)) => hue.colour(self.theme, false),
            (Colours::True, Some(hue)) => hue.colour(self.theme, true),
        }
    }

    /// Returns the colour with the highest contrast; that of the terminal's text on an unknown
    /// background.
    fn ink(self) -> Color {
        let [light, dark] = match self.colours {
            // Bold black is grey in many terminals; the terminal's text is not.
            Colours::None | Colours::Sixteen => [Color::Reset, Color::White],
            Colours::Indexed | Colours::True => [Color::Indexed(16), Color::Indexed(231)],
        };
        match self.theme {
            Theme::Auto | Theme::Plain => Color::Reset,
            Theme::Light => light,
            Theme::Dark => dark,
        }
    }

    /// Returns `true` if a colour of the terminal's own palette must be bold where there is no faint
    /// text: links would look like guides and hatching.
    pub(crate) fn is_bold_without_faint(self, named: Color) -> bool {
        let is_link = |hue| Hue::OF_LINKS.contains(&hue);
        let few = matches!(self.colours, Colours::None | Colours::Sixteen);
        few && Hue::hue_of_name(named).is_some_and(is_link)
    }

    /// Removes bold from sent colours that many terminals show in their bright form then: it is too
    /// bright on a light background, and a grey in Solarized's palette.
    pub(crate) fn weight(self, sent: Color, modifier: Modifier) -> Modifier {
        let has_bright_form = matches!(
            sent,
            Color::Red | Color::Green | Color::Yellow | Color::Blue | Color::Cyan
        );
        let is_chosen = matches!(self.theme, Theme::Light | Theme::Dark);
        match self.colours == Colours::Sixteen && is_chosen && has_bright_form {
            true => modifier - Modifier::BOLD,
            false => modifier,
        }
    }

    /// Returns the colour of text: the brightest one instead of a weak one of the terminal. Faint text
    /// keeps its colour.
    pub(crate) fn of_text(self, colour: Color, modifier: Modifier) -> Color {
        let is_plain = colour == Color::Reset && !modifier.contains(Modifier::DIM);
        match is_plain && self.has_weak_text {
            true => INK,
            false => colour,
        }
    }

    /// Replaces faint text by a colour, if that is better than the terminal's own faint style.
    pub(crate) fn faint(self, colour: Color, modifier: Modifier) -> (Color, Modifier) {
        let is_faint = modifier.contains(Modifier::DIM) && !modifier.contains(Modifier::REVERSED);
        match self.colours {
            Colours::Indexed | Colours::True if is_faint && colour == Color::Reset => {
                let grey = Hue::Grey.colour(self.theme, self.colours == Colours::True);
                (grey, modifier - Modifier::DIM)
            }
            // Many terminals dim a colour towards black, which is no dimmer on a light background.
            Colours::Sixteen if is_faint && self.theme == Theme::Light => {
                (Hue::Grey.named(), modifier - Modifier::DIM)
            }
            // A selected colour must not be made fainter.
            Colours::Indexed | Colours::True => (colour, modifier - Modifier::DIM),
            Colours::None | Colours::Sixteen => (colour, modifier),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::super::theme::{self, ScreenPart};
    use super::*;
    use crate::drawing::{Extents, Figure, LINK_HUES, Role, WorldView, svg};
    use crate::scene::{Scene, presets};
    use crate::solver::Solver;

    const BLACK: Color = Color::Rgb(0, 0, 0);
    const WHITE: Color = Color::Rgb(255, 255, 255);
    /// The backgrounds of two widely used colour schemes.
    const SOFT_BLACK: Color = Color::Rgb(0x1e, 0x1e, 0x1e);
    const SOFT_WHITE: Color = Color::Rgb(0xfd, 0xf6, 0xe3);
    const SOLARIZED: Color = Color::Rgb(0, 0x2b, 0x36);
    const GREY: Color = Color::Rgb(0x33, 0x33, 0x33);
    const DARK: [Color; 4] = [BLACK, SOFT_BLACK, SOLARIZED, GREY];
    const LIGHT: [Color; 2] = [WHITE, SOFT_WHITE];

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

    /// Returns the relative luminance according to WCAG 2.2.
    fn luminance(colour: Color) -> f64 {
        let linear = linear(colour);
        0.2126 * linear[0] + 0.7152 * linear[1] + 0.0722 * linear[2]
    }

    fn linear(colour: Color) -> [f64; 3] {
        exact(colour).map(|c| {
            let c = f64::from(c) / 255.0;
            if c <= 0.04045 {
                c / 12.92
            } else {
                ((c + 0.055) / 1.055).powf(2.4)
            }
        })
    }

    fn contrast(a: Color, b: Color) -> f64 {
        let [a, b] = [luminance(a), luminance(b)];
        (a.max(b) + 0.05) / (a.min(b) + 0.05)
    }

    const ALL: [Hue; 13] = [
        Hue::Red,
        Hue::Orange,
        Hue::Brown,
        Hue::Yellow,
        Hue::Lime,
        Hue::Moss,
        Hue::Green,
        Hue::Teal,
        Hue::Cyan,
        Hue::Blue,
        Hue::Violet,
        Hue::Magenta,
        Hue::Grey,
    ];

    /// Returns the hues of drawn lines; brown is for text only, as a substitute of orange.
    fn drawn() -> Vec<Hue> {
        ALL.into_iter().filter(|hue| *hue != Hue::Brown).collect()
    }

    /// Returns the hues of text: names of links and of the driver, magnitudes of forces, notices
    /// and quiet text. Orange, lime and moss are for lines only.
    fn written() -> Vec<Hue> {
        let drawn_only = [Hue::Orange, Hue::Lime, Hue::Moss];
        ALL.into_iter()
            .filter(|hue| !drawn_only.contains(hue))
            .collect()
    }

    fn worst(hues: &[Hue], theme: Theme, exact: bool, grounds: &[Color]) -> f64 {
        let colours = hues.iter().map(|hue| hue.colour(theme, exact));
        let all = colours.flat_map(|c| grounds.iter().map(move |g| contrast(c, *g)));
        all.fold(f64::INFINITY, f64::min)
    }

    /// Returns the distance of two colours in Oklab (Ottosson 2020). A distance of 0.02 is barely
    /// visible side by side.
    fn distance(a: Color, b: Color) -> f64 {
        let [a, b] = [a, b].map(|colour| {
            let [r, g, b] = linear(colour);
            let l = (0.412_221_470_8 * r + 0.536_332_536_3 * g + 0.051_445_992_9 * b).cbrt();
            let m = (0.211_903_498_2 * r + 0.680_699_545_1 * g + 0.107_396_956_6 * b).cbrt();
            let s = (0.088_302_461_9 * r + 0.281_718_837_6 * g + 0.629_978_700_5 * b).cbrt();
            [
                0.210_454_255_3 * l + 0.793_617_785_0 * m - 0.004_072_046_8 * s,
                1.977_998_495_1 * l - 2.428_592_205_0 * m + 0.450_593_709_9 * s,
                0.025_904_037_1 * l + 0.782_771_766_2 * m - 0.808_675_766_0 * s,
            ]
        });
        let squares = (0..3).map(|k| (a[k] - b[k]) * (a[k] - b[k]));
        squares.sum::<f64>().sqrt()
    }

    #[test]
    fn contrast_matches_wcag_values() {
        assert!((contrast(BLACK, WHITE) - 21.0).abs() < 1e-9);
        assert!((contrast(Color::Rgb(0x76, 0x76, 0x76), WHITE) - 4.54).abs() < 0.01);
    }

    /// The written hues other than those of link names, which use the fixed palette like their
    /// bars.
    const EXACT: [Hue; 5] = [Hue::Red, Hue::Yellow, Hue::Cyan, Hue::Magenta, Hue::Grey];

    /// No colour has a contrast above 4.58 against both black and white, or above 3.9 against both
    /// softer backgrounds. Users with such a background can select the theme.
    #[test]
    fn colours_are_readable_on_any_background() {
        assert!(worst(&EXACT, Theme::Auto, true, &[BLACK, WHITE]) >= 4.5);
        let worst = |exact, grounds: &[Color]| worst(&written(), Theme::Auto, exact, grounds);
        assert!(worst(true, &[BLACK, WHITE]) >= 4.3);
        assert!(worst(false, &[BLACK, WHITE]) >= 4.3);
        assert!(worst(true, &[SOFT_BLACK, SOFT_WHITE]) >= 3.5);
        assert!(worst(false, &[SOFT_BLACK, SOFT_WHITE]) >= 3.5);
    }

    const BRIGHT: [Hue; 6] = Hue::OF_LINKS;
    const NORMAL: [Hue; 5] = [Hue::Yellow, Hue::Lime, Hue::Cyan, Hue::Magenta, Hue::Brown];
    const DIM: [Hue; 2] = [Hue::Grey, Hue::Moss];

    /// Every hue has one of three luminances on every known background: links and the driver,
    /// arrows and names, guides and traces.
    #[test]
    fn three_luminances_keep_their_contrast_on_every_known_ground() {
        assert_eq!(BRIGHT.len() + NORMAL.len() + DIM.len(), ALL.len());
        for exact in [false, true] {
            for (theme, grounds) in [(Theme::Light, &LIGHT[..]), (Theme::Dark, &DARK)] {
                for (hues, minimum) in [(&BRIGHT[..], 7.0), (&NORMAL, 4.5), (&DIM, 2.5)] {
                    let worst = worst(hues, theme, exact, grounds);
                    assert!(worst >= minimum, "{theme:?}, {exact}, {minimum}: {worst}");
                }
                // What is dim is dimmer than anything else, on every background.
                for ground in grounds {
                    let of = |hue: &Hue| contrast(hue.colour(theme, exact), *ground);
                    let maximum = DIM.iter().map(of).fold(0.0, f64::max);
                    let others = BRIGHT.iter().chain(&NORMAL).map(of);
                    let minimum = others.fold(f64::INFINITY, f64::min);
                    assert!(
                        maximum < minimum,
                        "{theme:?}, {exact}, {ground:?}: {maximum}, {minimum}"
                    );
                }
                let colours = if exact {
                    Colours::True
                } else {
                    Colours::Indexed
                };
                let has_weak_text = false;
                let palette = Palette {
                    colours,
                    theme,
                    has_weak_text,
                };
                let ink = palette.colour(INK);
                for ground in grounds {
                    assert!(contrast(ink, *ground) >= 7.0, "{ground:?}");
                }
            }
        }
    }

    /// Returns a colour of xterm's own palette, by its default resources.
    fn of_xterm(colour: Color) -> Color {
        let [r, g, b] = match colour {
            Color::Black => [0; 3],
            Color::Red => [205, 0, 0],
            Color::Green => [0, 205, 0],
            Color::Yellow => [205, 205, 0],
            Color::Blue => [0, 0, 238],
            Color::Magenta => [205, 0, 205],
            Color::Cyan => [0, 205, 205],
            Color::Gray => [229; 3],
            Color::DarkGray => [127; 3],
            Color::LightRed => [255, 0, 0],
            Color::LightGreen => [0, 255, 0],
            Color::LightYellow => [255, 255, 0],
            Color::LightBlue => [92, 92, 255],
            Color::LightMagenta => [255, 0, 255],
            Color::LightCyan => [0, 255, 255],
            Color::White => [255; 3],
            other => exact(other),
        };
        Color::Rgb(r, g, b)
    }

    /// Returns the colour that xterm displays for bold text in another one.
    fn in_bold(colour: Color) -> Color {
        match colour {
            Color::Black => Color::DarkGray,
            Color::Red => Color::LightRed,
            Color::Green => Color::LightGreen,
            Color::Yellow => Color::LightYellow,
            Color::Blue => Color::LightBlue,
            Color::Magenta => Color::LightMagenta,
            Color::Cyan => Color::LightCyan,
            Color::Gray => Color::White,
            other => other,
        }
    }

    /// Regression: bold names in magenta had a contrast of 3.1 on white, red bars of 3.2 on grey. Text
    /// in the terminal's own colour is left out.
    #[test]
    fn sixteen_colours_keep_their_contrast_on_every_ground() {
        let grounds = [BLACK, WHITE, SOLARIZED, SOFT_WHITE, GREY];
        let levels = [(&BRIGHT[..], 7.0), (&NORMAL[..], 4.5), (&DIM[..], 2.5)];
        for ground in grounds {
            let known = Ground::of(exact(ground)).theme();
            for (theme, (hues, minimum)) in [known, Theme::Auto]
                .into_iter()
                .flat_map(|theme| levels.map(|level| (theme, level)))
            {
                let palette = Palette {
                    colours: Colours::Sixteen,
                    theme,
                    has_weak_text: false,
                };
                // No red or magenta has a higher one on all backgrounds.
                let minimum = if theme == Theme::Auto { 2.5 } else { minimum };
                for named in hues.iter().map(|hue| hue.named()).chain([INK]) {
                    let sent = palette.colour(named);
                    let bold = palette.weight(sent, Modifier::BOLD) == Modifier::BOLD;
                    let shown = [Some(sent), bold.then(|| in_bold(sent))];
                    let shown = shown.into_iter().flatten();
                    for colour in shown.filter(|colour| *colour != Color::Reset) {
                        let contrast = contrast(of_xterm(colour), ground);
                        assert!(
                            contrast >= minimum,
                            "{named:?} as {colour:?} on {ground:?}, {theme:?}: {contrast}"
                        );
                    }
                }
            }
        }
    }

    /// The curves of a plot and the arrows of a drawing have different colours wherever there are
    /// enough.
    #[test]
    fn curves_differ_with_sixteen_colours() {
        for theme in [Theme::Auto, Theme::Light, Theme::Dark] {
            let palette = Palette {
                colours: Colours::Sixteen,
                theme,
                has_weak_text: false,
            };
            let curves = [Role::Datum, Role::Second, Role::Third];
            let sent = curves.map(|role| {
                let named = theme::role(role).fg.unwrap_or(Color::Reset);
                palette.colour(named)
            });
            assert!(
                sent[0] != sent[1] && sent[1] != sent[2] && sent[0] != sent[2],
                "{theme:?}"
            );
        }
    }

    /// The roles of the drawing have the luminances of their kinds.
    #[test]
    fn roles_have_luminances_of_their_kinds() {
        let hue = |role| theme::role(role).fg.and_then(Hue::hue_of_name);
        for role in (0..LINK_HUES).map(Role::Link).chain([Role::Driver]) {
            assert!(
                hue(role).is_some_and(|hue| BRIGHT.contains(&hue)),
                "{role:?}"
            );
        }
        for role in [Role::Joint, Role::GroundPin, Role::Slider] {
            assert_eq!(theme::role(role).fg, Some(INK), "{role:?}");
        }
        for role in [Role::Guide, Role::Ground, Role::Axis, Role::Ghost] {
            let style = theme::role(role);
            let is_faint = style.add_modifier.contains(Modifier::DIM) && style.fg.is_none();
            assert!(is_faint, "{role:?}: {style:?}");
        }
        assert_eq!(hue(Role::Trace), Some(Hue::Moss));
        assert_eq!(hue(Role::Trail), Some(Hue::Lime));
    }

    #[test]
    fn ground_is_judged_by_its_luminance() {
        for (colour, ground) in [
            ([0, 0, 0], Ground::Dark),
            ([0, 0x2b, 0x36], Ground::Dark),
            ([0x33, 0x33, 0x33], Ground::Dark),
            ([0x55, 0x55, 0x55], Ground::Dark),
            ([0x80, 0x80, 0x80], Ground::Middle),
            ([0xa0, 0xa0, 0xa0], Ground::Middle),
            ([0xfd, 0xf6, 0xe3], Ground::Light),
            ([255, 255, 255], Ground::Light),
            ([0xc0, 0xc0, 0xc0], Ground::Light),
        ] {
            assert_eq!(Ground::of(colour), ground, "{colour:?}");
        }
    }

    /// Regression: text had a contrast of 4.7 on Solarized's dark background and of 4.1 on the light
    /// one.
    #[test]
    fn text_has_contrast_7_on_every_known_background() {
        for (text, ground, is_weak) in [
            ([255; 3], [0; 3], false),
            ([0; 3], [255; 3], false),
            ([0x83, 0x94, 0x96], [0, 0x2b, 0x36], true),
            ([0x65, 0x7b, 0x83], [0xfd, 0xf6, 0xe3], true),
            ([0xd0; 3], [0x33; 3], false),
            ([0x90; 3], [0x33; 3], true),
        ] {
            assert_eq!(is_weak_text(text, ground), is_weak, "{text:?} {ground:?}");
            for colours in [Colours::Indexed, Colours::True] {
                let palette = Palette {
                    colours,
                    theme: Ground::of(ground).theme(),
                    has_weak_text: is_weak,
                };
                let [text, ground] = [text, ground].map(|[r, g, b]| Color::Rgb(r, g, b));
                for modifier in [Modifier::empty(), Modifier::BOLD, Modifier::REVERSED] {
                    let sent = palette.colour(palette.of_text(Color::Reset, modifier));
                    let shown = if sent == Color::Reset { text } else { sent };
                    assert!(contrast(shown, ground) >= 7.0, "{shown:?} on {ground:?}");
                }
            }
        }
    }

    /// Regression: on a grey background, guides, headings and rules had the colour of the ground.
    #[test]
    fn dim_text_is_legible_on_every_known_background() {
        for grey in 0..=255 {
            let theme = Ground::of([grey; 3]).theme();
            let dim = Hue::Grey.colour(theme, true);
            // Without colours, the terminal's own text is faint.
            let is_legible = || contrast(dim, Color::Rgb(grey, grey, grey)) >= 1.6;
            assert!(theme == Theme::Plain || is_legible(), "{grey}");
        }
    }

    /// WCAG 2.2 requires a contrast of 3 for graphics.
    #[test]
    fn lines_reach_contrast_3_on_unknown_background() {
        for exact in [false, true] {
            let grounds = [BLACK, WHITE, SOFT_BLACK, SOFT_WHITE];
            let worst = worst(&drawn(), Theme::Auto, exact, &grounds);
            assert!(worst >= 3.0, "{exact}: {worst}");
        }
    }

    #[test]
    fn drawn_hues_are_distinguishable() {
        let drawn = drawn();
        for theme in [Theme::Auto, Theme::Light, Theme::Dark] {
            for exact in [false, true] {
                for (k, a) in drawn.iter().enumerate() {
                    for b in &drawn[k + 1..] {
                        let separation = distance(a.colour(theme, exact), b.colour(theme, exact));
                        assert!(
                            separation >= 0.06,
                            "{a:?} and {b:?} in {theme:?}, {exact}: {separation}"
                        );
                    }
                }
            }
        }
    }

    /// Regression: link names were once written in the hues of bars, and this test omitted them.
    #[test]
    fn text_roles_use_readable_hues() {
        let links = (0..LINK_HUES).map(Role::Link).map(Role::of_name);
        let others = [Role::Driver, Role::Force, Role::Label, Role::Ground];
        let texts = links.chain(others).map(theme::role);
        for style in texts.chain([theme::part(ScreenPart::Warning)]) {
            let hue = style.fg.and_then(Hue::hue_of_name);
            assert!(hue.is_none_or(|hue| written().contains(&hue)), "{style:?}");
        }
    }

    /// Yellow, green and cyan are barely visible on white in most palettes.
    #[test]
    fn light_theme_uses_dark_ansi_colours_only() {
        for hue in ALL {
            let read = [Color::Reset, Color::Red, Color::Blue, Color::DarkGray];
            let sent = hue.sixteen(Theme::Light);
            assert!(read.contains(&sent), "{hue:?}: {sent:?}");
        }
    }

    /// Printed drawings use the hues of the screen.
    #[test]
    fn svg_links_have_hues_of_the_screen() {
        let preset = presets::find("four-bar").expect("it is there");
        let scene = Scene::parse(preset.text, preset.name).expect("it reads");
        let solver = Solver::new(&scene.mechanism).expect("it moves");
        let view = WorldView::fit(&Extents::of(&scene, &solver), 9, 4, 2.0);
        let document = svg(&Figure::new(), &view, "hues", &[]);
        for (theme, style) in [(Theme::Light, 0), (Theme::Dark, 1)] {
            let sheet = document.split("@media").nth(style).expect("there are two");
            for hue in 0..LINK_HUES {
                let named = theme::role(Role::Link(hue)).fg.and_then(Hue::hue_of_name);
                let [r, g, b] = exact(named.expect("links have hues").colour(theme, true));
                let rule = format!(".hue{hue}{{stroke:#{r:02x}{g:02x}{b:02x}");
                assert!(sheet.contains(&rule), "{theme:?}: {rule}");
            }
        }
    }

    #[test]
    fn hues_round_trip_through_named_colours() {
        for hue in ALL {
            assert_eq!(Hue::hue_of_name(hue.named()), Some(hue));
        }
    }

    #[test]
    fn sixteen_colours_follow_theme() {
        let sent = |theme, named| {
            let palette = Palette {
                colours: Colours::Sixteen,
                theme,
                has_weak_text: false,
            };
            palette.colour(named)
        };
        assert_eq!(sent(Theme::Auto, Color::Red), Color::LightRed);
        assert_eq!(sent(Theme::Auto, Color::Blue), Color::Reset);
        assert_eq!(sent(Theme::Dark, Color::Red), Color::Yellow);
        assert_eq!(sent(Theme::Light, Color::Cyan), Color::Red);
        assert_eq!(sent(Theme::Dark, Color::Reset), Color::Reset);
    }

    #[test]
    fn faint_text_is_grey_with_indexed_colours() {
        let faint = |colours, theme| {
            let palette = Palette {
                colours,
                theme,
                has_weak_text: false,
            };
            let (colour, modifier) = palette.faint(Color::Reset, Modifier::DIM | Modifier::BOLD);
            (palette.colour(colour), modifier)
        };
        let as_it_was = (Color::Reset, Modifier::DIM | Modifier::BOLD);
        for theme in [Theme::Auto, Theme::Dark] {
            assert_eq!(faint(Colours::Sixteen, theme), as_it_was);
        }
        // Regression: xterm dims towards black, so guides on white were as black as names.
        let grey = (Color::DarkGray, Modifier::BOLD);
        assert_eq!(faint(Colours::Sixteen, Theme::Light), grey);
        assert_eq!(
            faint(Colours::Indexed, Theme::Auto),
            (Color::Indexed(243), Modifier::BOLD)
        );
    }
}
