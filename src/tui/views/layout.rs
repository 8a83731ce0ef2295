//! Which panes stand on the screen, and where: a pure function of the name of a layout, the size of the screen and
//! where the line between the panes was moved to.
//!
//! ```text
//! - four-bar ---------+- tables --+- scene -     the third column from 190 x 50 on
//!                     |           |
//!       drawing       |           |
//!                     |           |
//! - plots ------------+           |
//!                     |           |
//! ```
//!
//! The drawing stands at the upper left whatever the scene and the size; more rows and columns only add to what
//! is seen.

use crate::tui::commands::view::View;
use ratatui::layout::{Rect, Size};

/// A layout, by its name in the configuration.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(crate) enum LayoutName {
    /// One view, and from 110 x 34 on as `three`.
    #[default]
    Auto,
    /// The view that is looked at has the whole screen.
    One,
    /// The drawing, and tables.
    Two,
    /// The drawing, tables and a plot.
    Three,
    /// The drawing, tables and the working.
    Lecture,
    /// The drawing, the values of the scene and a plot.
    Design,
}

/// From so many columns and rows on, two, three and four panes stand.
const TWO: Size = Size::new(76, 20);
const THREE: Size = Size::new(110, 34);
const FOUR: Size = Size::new(190, 50);

/// The drawing has this part of the screen at least: alone beside one other pane, and beside more.
const SHARES: [f64; 2] = [0.5, 0.4];
/// Percent of the columns that stand beside the drawing: in one column beside it alone, above another pane, and each
/// of two.
const ASIDE: [u16; 3] = [40, 36, 22];
/// Such a column is not wider than this: tables use no more.
const WIDEST_ASIDE: u16 = 64;
/// No split leaves a pane fewer columns.
const NARROWEST: u16 = 24;
/// Rows that a pane below the drawing has at least, with its title.
const LOWEST_BELOW: u16 = 8;
/// Columns by which the split is moved at a time, and so often at the most.
const STEP: u16 = 4;
const MOST_STEPS: i8 = 8;

impl LayoutName {
    pub(crate) const ALL: [LayoutName; 6] = [
        LayoutName::Auto,
        LayoutName::One,
        LayoutName::Two,
        LayoutName::Three,
        LayoutName::Lecture,
        LayoutName::Design,
    ];

    /// As the configuration calls it: a promise.
    pub(crate) const fn name(self) -> &'static str {
        match self {
            LayoutName::Auto => "auto",
            LayoutName::One => "one",
            LayoutName::Two => "two",
            LayoutName::Three => "three",
            LayoutName::Lecture => "lecture",
            LayoutName::Design => "design",
        }
    }

    fn next(self) -> LayoutName {
        let mut names = LayoutName::ALL.into_iter().cycle();
        names.find(|name| *name == self);
        names.next().unwrap_or_default()
    }

    /// What stands on a screen: the drawing, what stands beside it, below it, and in a third column.
    fn views(self, screen: Size) -> &'static [View] {
        use View::{Motion, Plots, Scene, Tables, Working};
        let has = |least: Size| screen.width >= least.width && screen.height >= least.height;
        let is_auto = self == LayoutName::Auto;
        match self {
            LayoutName::One => &[],
            _ if !has(if is_auto { THREE } else { TWO }) => &[],
            LayoutName::Two => &[Motion, Tables],
            LayoutName::Lecture if has(FOUR) => &[Motion, Working, Plots, Tables],
            LayoutName::Lecture if has(THREE) => &[Motion, Working, Tables],
            LayoutName::Lecture => &[Motion, Working],
            LayoutName::Design if has(FOUR) => &[Motion, Scene, Plots, Tables],
            LayoutName::Design if has(THREE) => &[Motion, Scene, Plots],
            LayoutName::Design => &[Motion, Scene],
            LayoutName::Auto | LayoutName::Three if has(FOUR) => &[Motion, Tables, Plots, Scene],
            LayoutName::Auto | LayoutName::Three if has(THREE) => &[Motion, Tables, Plots],
            LayoutName::Auto | LayoutName::Three => &[Motion, Tables],
        }
    }
}

/// How a person has arranged the panes.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(crate) struct Composition {
    layout: LayoutName,
    /// Steps by which the line beside the drawing was moved to the right.
    split: i8,
    /// A view that was asked for and has no place of its own: it stands beside the drawing.
    aside: Option<View>,
    /// Whether what is looked at has the whole screen.
    alone: bool,
}

/// A pane: its title, unless it has the whole screen, and what it shows below.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct PlacedView {
    pub(crate) view: View,
    pub(crate) title: Option<Rect>,
    pub(crate) area: Rect,
}

impl Composition {
    pub(crate) fn of(layout: LayoutName) -> Composition {
        Composition {
            layout,
            ..Composition::default()
        }
    }

    /// What stands on a screen while a view is looked at, the drawing first.
    pub(crate) fn standing(&self, looked_at: View, screen: Size) -> Vec<View> {
        let mut views = self.layout.views(screen).to_vec();
        if self.alone || views.is_empty() {
            return vec![looked_at];
        }
        for asked in self.aside.into_iter().chain([looked_at]) {
            if !views.contains(&asked) {
                views[1] = asked;
            }
        }
        views
    }

    /// The same with their places in `body`, the part of the screen that panes have.
    pub(crate) fn placed(&self, looked_at: View, screen: Size, body: Rect) -> Vec<PlacedView> {
        let views = self.standing(looked_at, screen);
        if let [view] = *views {
            return vec![PlacedView {
                view,
                title: None,
                area: body,
            }];
        }
        let frames = frames(views.len(), screen, body, self.split).into_iter();
        let placed = views.into_iter().zip(frames);
        placed.map(|(view, frame)| titled(view, frame)).collect()
    }

    /// Looks at a view: one that does not stand yet gets the place beside the drawing.
    pub(crate) fn look(&mut self, view: View, before: View, screen: Size) {
        if !self.standing(before, screen).contains(&view) {
            self.aside = Some(view);
        }
    }

    /// The view that follows among those that stand; `None` where it stands alone.
    pub(crate) fn next_pane(&self, looked_at: View, screen: Size) -> Option<View> {
        let views = self.standing(looked_at, screen);
        let here = views.iter().position(|view| *view == looked_at)?;
        (views.len() > 1).then(|| views[(here + 1) % views.len()])
    }

    /// Gives what is looked at the whole screen, or shows the others again; false where there are no others.
    pub(crate) fn toggle_alone(&mut self, screen: Size) -> bool {
        let has_others = !self.layout.views(screen).is_empty();
        self.alone = has_others && !self.alone;
        has_others
    }

    /// Shows the others again, if what is looked at stands alone by choice; false where there are no others.
    pub(crate) fn leave_alone(&mut self, screen: Size) -> bool {
        std::mem::take(&mut self.alone) && !self.layout.views(screen).is_empty()
    }

    /// Goes on to the next layout, without what was changed in this one.
    pub(crate) fn next_layout(&mut self) -> LayoutName {
        *self = Composition::of(self.layout.next());
        self.layout
    }

    /// The screen or the layout is another one: what is looked at has a place in it still when another pane is.
    pub(crate) fn keep(&mut self, looked_at: View, screen: Size) {
        let views = self.layout.views(screen);
        if !views.is_empty() && !views.contains(&looked_at) {
            self.aside = Some(looked_at);
        }
    }

    /// Steps by which the line beside the drawing was moved to the right.
    pub(crate) fn split(&self) -> i8 {
        self.split
    }

    /// Moves the line beside the drawing; false where it stays.
    pub(crate) fn move_split(&mut self, by: i8) -> bool {
        let to = (self.split + by).clamp(-MOST_STEPS, MOST_STEPS);
        let moved = to != self.split;
        self.split = to;
        moved
    }
}

/// A width moved by so many steps, with at least so many columns at both sides.
pub(crate) fn moved(width: u16, whole: u16, split: i8) -> u16 {
    let by = STEP * u16::from(split.unsigned_abs());
    let to = match split < 0 {
        true => width.saturating_sub(by),
        false => width.saturating_add(by),
    };
    let most = whole.saturating_sub(NARROWEST + 1).max(NARROWEST);
    to.clamp(NARROWEST.min(width), most.max(width.min(whole)))
}

/// So many percent of a width.
pub(crate) fn percent_of(width: u16, percent: u16) -> u16 {
    // Whole hundreds first: no width is too large.
    width / 100 * percent + width % 100 * percent / 100
}

/// The title of a pane above what it shows.
fn titled(view: View, frame: Rect) -> PlacedView {
    let title = Rect { height: 1, ..frame };
    let area = Rect {
        y: frame.y + 1,
        height: frame.height.saturating_sub(1),
        ..frame
    };
    PlacedView {
        view,
        title: Some(title),
        area,
    }
}

/// Where so many panes stand, two or more: a column beside another lies a line apart from it.
fn frames(count: usize, screen: Size, body: Rect, split: i8) -> Vec<Rect> {
    let asides: u16 = if count > 3 { 2 } else { 1 };
    let percent = ASIDE[count.clamp(2, 4) - 2];
    let aside = percent_of(body.width, percent).min(WIDEST_ASIDE);
    let drawing = body.width.saturating_sub(asides * (aside + 1));
    let rest = body.width.saturating_sub((asides - 1) * (aside + 1));
    let drawing = moved(drawing, rest, split);
    let beside = rest.saturating_sub(drawing + 1);
    let column = |x, width| Rect {
        x: body.x + x,
        width,
        ..body
    };
    let mut frames = vec![column(0, drawing), column(drawing + 1, beside)];
    if count > 2 {
        let height = drawing_rows(screen, drawing, body.height);
        frames[0].height = height;
        frames.push(Rect {
            y: body.y + height,
            height: body.height - height,
            ..column(0, drawing)
        });
    }
    if count > 3 {
        frames.push(column(drawing + beside + 2, aside));
    }
    frames
}

/// Rows of the drawing above another pane: as many as give it its share of the screen.
fn drawing_rows(screen: Size, width: u16, height: u16) -> u16 {
    let cells = SHARES[1] * f64::from(screen.width) * f64::from(screen.height);
    let rows = (1..height).find(|rows| f64::from(*rows) * f64::from(width) >= cells);
    let most = height.saturating_sub(LOWEST_BELOW);
    rows.unwrap_or(height).max(height / 2).min(most)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A screen without its first line and its last two.
    fn body(screen: Size) -> Rect {
        Rect::new(0, 1, screen.width, screen.height.saturating_sub(3))
    }

    fn sizes() -> impl Iterator<Item = Size> {
        let columns = (40..=260).step_by(3);
        columns.flat_map(|cols| (12..=90).step_by(2).map(move |rows| Size::new(cols, rows)))
    }

    fn all() -> impl Iterator<Item = (LayoutName, Size)> {
        LayoutName::ALL
            .into_iter()
            .flat_map(|layout| sizes().map(move |size| (layout, size)))
    }

    #[test]
    fn what_stands_beside_the_drawing_outlives_a_small_screen() {
        let (small, large) = (Size::new(40, 12), Size::new(120, 40));
        let mut composition = Composition::default();
        composition.look(View::Working, View::Motion, large);
        let before = composition.standing(View::Motion, large);
        assert!(before.contains(&View::Working));
        composition.keep(View::Motion, small);
        composition.keep(View::Motion, large);
        assert_eq!(composition.standing(View::Motion, large), before);
    }

    #[test]
    fn names_bring_what_they_say() {
        use View::{Forces, Motion, Plots, Scene, Tables, Working};
        let standing = |layout, size, view| Composition::of(layout).standing(view, size);
        let (small, middle, large) = (Size::new(80, 24), Size::new(120, 40), Size::new(200, 60));
        let auto = LayoutName::Auto;
        assert_eq!(standing(auto, small, Motion), [Motion]);
        assert_eq!(standing(auto, middle, Motion), [Motion, Tables, Plots]);
        assert_eq!(
            standing(auto, large, Motion),
            [Motion, Tables, Plots, Scene]
        );
        let lecture = standing(LayoutName::Lecture, middle, Motion);
        assert_eq!(lecture, [Motion, Working, Tables]);
        let design = standing(LayoutName::Design, middle, Motion);
        assert_eq!(design, [Motion, Scene, Plots]);
        assert_eq!(standing(LayoutName::Two, small, Forces), [Motion, Forces]);
        assert_eq!(standing(LayoutName::One, large, Forces), [Forces]);
        // What is looked at stands, whatever the layout.
        for (layout, size) in all() {
            for view in View::ALL {
                assert!(standing(layout, size, view).contains(&view));
            }
        }
    }

    #[test]
    fn what_was_asked_for_stays_while_another_pane_is_looked_at() {
        let size = Size::new(120, 40);
        let mut composition = Composition::default();
        composition.look(View::Forces, View::Motion, size);
        let with_forces = [View::Motion, View::Forces, View::Plots];
        for view in with_forces {
            assert_eq!(composition.standing(view, size), with_forces);
        }
        let next = |view| composition.next_pane(view, size);
        assert_eq!(next(View::Motion), Some(View::Forces));
        assert_eq!(next(View::Plots), Some(View::Motion));
        composition.look(View::Tables, View::Plots, size);
        let tables = composition.standing(View::Tables, size);
        assert_eq!(tables, [View::Motion, View::Tables, View::Plots]);
    }

    #[test]
    fn panes_fill_the_body_and_none_covers_another() {
        for (layout, size) in all() {
            for split in [-8, 0, 8] {
                let mut composition = Composition::of(layout);
                composition.split = split;
                let body = body(size);
                let placed = composition.placed(View::Motion, size, body);
                let mut cells = 0;
                for (n, pane) in placed.iter().enumerate() {
                    let frame = pane.title.map_or(pane.area, |title| title.union(pane.area));
                    assert_eq!(frame.intersection(body), frame, "{layout:?} {size} {split}");
                    assert!(
                        pane.area.height >= 5 && pane.area.width >= NARROWEST,
                        "{pane:?}"
                    );
                    for other in &placed[..n] {
                        assert!(!other.area.intersects(frame), "{layout:?} {size} {split}");
                    }
                    cells += frame.area();
                }
                let lines = match placed.len() {
                    1 => 0,
                    4 => 2,
                    _ => 1,
                };
                assert_eq!(cells + lines * u32::from(body.height), body.area());
            }
        }
    }

    /// Half of the screen beside one pane, two fifths where three stand.
    #[test]
    fn the_drawing_has_its_share() {
        for (layout, size) in all() {
            let placed = Composition::of(layout).placed(View::Motion, size, body(size));
            let share = match placed.len() {
                1 => continue,
                2 => SHARES[0],
                _ => SHARES[1],
            };
            let pane = placed[0];
            let frame = pane.title.unwrap().union(pane.area);
            // The line beside it is the drawing's too.
            let cells = f64::from(frame.width + 1) * f64::from(frame.height);
            let screen = f64::from(size.width) * f64::from(size.height);
            assert!(
                cells >= share * screen,
                "{layout:?} {size}: {}",
                cells / screen
            );
        }
    }

    /// A taller screen used to show five rows of the tables where a lower one showed all.
    #[test]
    fn more_rows_and_columns_never_take_a_pane_away_or_make_it_lower() {
        for layout in LayoutName::ALL {
            for width in 110..=240 {
                let mut before: Vec<PlacedView> = Vec::new();
                for height in 34..=90 {
                    let size = Size::new(width, height);
                    let placed = Composition::of(layout).placed(View::Motion, size, body(size));
                    // A plot has what the drawing leaves it.
                    for pane in before.iter().filter(|pane| pane.view != View::Plots) {
                        let now = placed.iter().find(|now| now.view == pane.view).unwrap();
                        assert!(now.area.height >= pane.area.height, "{layout:?} {size}");
                    }
                    before = placed;
                }
            }
        }
    }

    #[test]
    fn the_split_is_moved_and_kept_within_the_screen() {
        let size = Size::new(120, 40);
        let mut composition = Composition::default();
        let width = |composition: &Composition| {
            composition.placed(View::Motion, size, body(size))[0]
                .area
                .width
        };
        let before = width(&composition);
        assert!(composition.move_split(1));
        assert_eq!(width(&composition), before + STEP);
        while composition.move_split(1) {}
        assert!(width(&composition) < 120 - NARROWEST);
        while composition.move_split(-1) {}
        assert!(width(&composition) >= NARROWEST);
    }

    #[test]
    fn the_names_follow_each_other_in_a_ring() {
        let mut composition = Composition::default();
        let names = LayoutName::ALL.map(|_| composition.next_layout());
        assert_eq!(names[5], LayoutName::Auto);
        assert_eq!(names[..5], LayoutName::ALL[1..]);
    }
}
