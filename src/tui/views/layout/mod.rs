//! Selects and places the panes: a pure function of the layout's name, the screen size and the
//! position of the split.
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
//! The drawing is always at the upper left; a larger screen only adds content.

pub(crate) mod placement;

use crate::tui::commands::view::View;
use ratatui::layout::{Rect, Size};

/// A layout, by its name in the configuration.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(crate) enum LayoutName {
    /// One view on small screens; like `Three` from 110 x 34 on.
    #[default]
    Auto,
    /// The current view fills the screen.
    One,
    /// The drawing and the tables.
    Two,
    /// The drawing, the tables and a plot.
    Three,
    /// The drawing, the tables and the working.
    Lecture,
    /// The drawing, the values of the scene and a plot.
    Design,
}

/// Minimum screen sizes for two, three and four panes.
const TWO: Size = Size::new(76, 20);
const THREE: Size = Size::new(110, 34);
const FOUR: Size = Size::new(190, 50);

/// The drawing's minimum share of the screen: with one other pane, and with more.
const SHARES: [f64; 2] = [0.5, 0.4];
/// Widths of the columns next to the drawing, in percent of the screen: a single column with two
/// panes, with three panes, and each of two columns.
const SIDE_COLUMN_PERCENT: [u16; 3] = [40, 36, 22];
/// Maximum width of such a column; tables use no more.
const MAX_SIDE_WIDTH: u16 = 64;
/// Minimum width that a split leaves to a pane, in columns.
const MIN_WIDTH: u16 = 24;
/// Minimum height of a pane below the drawing, with its title.
const MIN_HEIGHT_BELOW: u16 = 8;
/// Columns per step of the split, and the maximum number of steps to each side.
const STEP: u16 = 4;
const MAX_STEPS: i8 = 8;

impl LayoutName {
    pub(crate) const ALL: [LayoutName; 6] = [
        LayoutName::Auto,
        LayoutName::One,
        LayoutName::Two,
        LayoutName::Three,
        LayoutName::Lecture,
        LayoutName::Design,
    ];

    /// Returns the name in the configuration, which is stable.
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

    /// Returns the panes on a screen of this size: the drawing, the pane next to it, the one below
    /// it, and the one in a third column. Empty if the current view fills the screen.
    fn views(self, screen: Size) -> &'static [View] {
        use View::{Motion, Plots, Scene, Tables, Working};
        let has = |minimum: Size| screen.width >= minimum.width && screen.height >= minimum.height;
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

/// The space that the contents of panes need.
pub(crate) trait PaneNeeds {
    /// Returns the number of rows of a view at a width, without its title; `None` if it is unknown
    /// or has no limit.
    fn rows(&self, view: View, width: u16) -> Option<u16>;
}

/// The user's arrangement of the panes.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(crate) struct Composition {
    layout: LayoutName,
    /// Steps by which the split was moved to the right.
    split: i8,
    /// A view outside the layout, shown in the second pane's place next to the drawing.
    aside: Option<View>,
    /// `true` if the current view is maximized.
    alone: bool,
}

/// A placed pane: its view, its title (`None` if it fills the screen) and its area.
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

    /// Returns the panes shown on a screen of this size, the drawing first.
    pub(crate) fn visible_views(&self, looked_at: View, screen: Size) -> Vec<View> {
        let mut views = self.layout.views(screen).to_vec();
        if self.alone || views.is_empty() {
            return vec![looked_at];
        }
        for requested in self.aside.into_iter().chain([looked_at]) {
            if !views.contains(&requested) {
                views[1] = requested;
            }
        }
        views
    }

    /// Returns the shown panes with their areas in `body`.
    pub(crate) fn placed(
        &self,
        looked_at: View,
        screen: Size,
        body: Rect,
        needs: &impl PaneNeeds,
    ) -> Vec<PlacedView> {
        let views = self.visible_views(looked_at, screen);
        if let [view] = *views {
            // A maximized drawing has its title, and no tables next to it.
            return vec![match self.is_alone(view, screen) && view == View::Motion {
                true => titled(view, body),
                false => PlacedView {
                    view,
                    title: None,
                    area: body,
                },
            }];
        }
        let frames = frames(&views, screen, body, self.split, needs).into_iter();
        let placed = views.into_iter().zip(frames);
        placed.map(|(view, frame)| titled(view, frame)).collect()
    }

    /// Shows a view: if no pane has it yet, it gets the place next to the drawing.
    pub(crate) fn show_view(&mut self, view: View, before: View, screen: Size) {
        if !self.visible_views(before, screen).contains(&view) {
            self.aside = Some(view);
        }
    }

    /// Returns the next pane in order; `None` if only one is shown.
    pub(crate) fn next_pane(&self, looked_at: View, screen: Size) -> Option<View> {
        let views = self.visible_views(looked_at, screen);
        let here = views.iter().position(|view| *view == looked_at)?;
        (views.len() > 1).then(|| views[(here + 1) % views.len()])
    }

    /// Maximizes the current view or restores what was next to it; returns `false` if that is
    /// nothing.
    pub(crate) fn toggle_alone(&mut self, looked_at: View, screen: Size) -> bool {
        let has_others = self.has_others(looked_at, screen);
        self.alone = has_others && !self.alone;
        has_others
    }

    /// Returns `true` if the current view is maximized and hides other panes or tables.
    pub(crate) fn is_alone(&self, looked_at: View, screen: Size) -> bool {
        self.alone && self.has_others(looked_at, screen)
    }

    /// Returns `true` if the layout has other panes. A drawing that fills the screen has tables.
    fn has_others(&self, looked_at: View, screen: Size) -> bool {
        looked_at == View::Motion || !self.layout.views(screen).is_empty()
    }

    /// Restores the panes.
    pub(crate) fn restore_panes(&mut self) {
        self.alone = false;
    }

    /// Switches to the next layout and resets all changes to the arrangement.
    pub(crate) fn next_layout(&mut self) -> LayoutName {
        *self = Composition::of(self.layout.next());
        self.layout
    }

    /// Keeps the current view on the screen after a change of the size or layout, even if another
    /// pane is selected next.
    pub(crate) fn keep(&mut self, looked_at: View, screen: Size) {
        let views = self.layout.views(screen);
        if !views.is_empty() && !views.contains(&looked_at) {
            self.aside = Some(looked_at);
        }
    }

    /// Returns the steps by which the split was moved to the right.
    pub(crate) fn split(&self) -> i8 {
        self.split
    }

    /// Moves the split; returns `false` if it is at its limit already.
    pub(crate) fn move_split(&mut self, by: i8) -> bool {
        let to = (self.split + by).clamp(-MAX_STEPS, MAX_STEPS);
        let moved = to != self.split;
        self.split = to;
        moved
    }
}

/// Moves a width by `split` steps and keeps a minimum width on both sides.
pub(crate) fn moved(width: u16, integer: u16, split: i8) -> u16 {
    let by = STEP * u16::from(split.unsigned_abs());
    let to = match split < 0 {
        true => width.saturating_sub(by),
        false => width.saturating_add(by),
    };
    let maximum = integer.saturating_sub(MIN_WIDTH + 1).max(MIN_WIDTH);
    to.clamp(MIN_WIDTH.min(width), maximum.max(width.min(integer)))
}

/// Returns `percent` percent of a width.
pub(crate) fn percent_of(width: u16, percent: u16) -> u16 {
    // Divides hundreds and remainder separately to avoid an overflow.
    width / 100 * percent + width % 100 * percent / 100
}

/// Splits a pane's frame into its title line and the area below.
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

/// The columns next to the drawing.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum SideColumns {
    /// One column with one pane.
    One(u16),
    /// One column with two panes, of which the upper one has this height.
    Stacked(u16, u16),
    /// Two columns.
    Two(u16, u16),
}

impl SideColumns {
    /// Returns the columns in which as many panes as possible show all of their lines. Wider columns
    /// leave the drawing its share of the screen.
    fn of(views: &[View], screen: Size, body: Rect, needs: &impl PaneNeeds) -> SideColumns {
        let percent = SIDE_COLUMN_PERCENT[views.len().clamp(2, 4) - 2];
        let usual = percent_of(body.width, percent).min(MAX_SIDE_WIDTH);
        let share = SHARES[usize::from(views.len() > 2)];
        let cells = share * f64::from(screen.width) * f64::from(screen.height);
        // On a middle screen the tables are more important than a second plot.
        let below = match *views {
            [_, _, plot, _] => height_below(plot, usual, needs),
            [_, _, _] => MIN_HEIGHT_BELOW,
            _ => 0,
        };
        let rows = f64::from(body.height.saturating_sub(below).max(1));
        // The separator counts as part of the drawing. The cast saturates.
        let room = body.width.saturating_sub((cells / rows).ceil() as u16);
        let widths = usual..=MAX_SIDE_WIDTH.min(room).max(usual);
        let height = body.height.saturating_sub(1);
        let rows = |at: usize, width| needs.rows(views[at], width);
        let fits = |at: usize, width| rows(at, width).is_some_and(|rows| rows <= height);
        if views.len() < 4 {
            let width = widths.clone().find(|width| fits(1, *width));
            return SideColumns::One(width.unwrap_or(usual));
        }
        // A pane without a limit takes all rows.
        let both = |width| {
            let wanted = |at| rows(at, width).unwrap_or(u16::MAX);
            (wanted(1), wanted(3))
        };
        let stacked = widths.clone().find_map(|width| {
            let (upper, lower) = both(width);
            let spare = height.checked_sub(upper.checked_add(lower)?.checked_add(1)?)?;
            // Each pane gets its part of the spare rows.
            let share = f64::from(upper) / f64::from((upper + lower).max(1));
            let more = (f64::from(spare) * share).floor() as u16;
            Some(SideColumns::Stacked(width, 1 + upper + more))
        });
        if let Some(stacked) = stacked {
            return stacked;
        }
        let most = room.saturating_sub(usual + 1).min(MAX_SIDE_WIDTH);
        let mut wider = (usual..=most).filter(|_| fits(3, usual));
        if let Some(width) = wider.find(|width| fits(1, *width)) {
            return SideColumns::Two(width, usual);
        }
        let is_short = |rows: u16| height.saturating_sub(rows) > height / 3;
        let width = *widths.end();
        match (both(usual), both(width)) {
            // A short pane next to a scrolling one gives it its spare rows.
            ((1.., lower), (upper, _)) if is_short(upper) && lower > height => {
                SideColumns::Stacked(width, 1 + upper)
            }
            ((upper, _), (_, lower)) if upper > height && is_short(lower) => {
                SideColumns::Stacked(width, height.saturating_sub(lower))
            }
            _ => SideColumns::Two(usual, usual),
        }
    }
}

/// Returns the frames of two or more panes; adjacent columns are separated by a line.
fn frames(
    views: &[View],
    screen: Size,
    body: Rect,
    split: i8,
    needs: &impl PaneNeeds,
) -> Vec<Rect> {
    let columns = SideColumns::of(views, screen, body, needs);
    let (aside, third) = match columns {
        SideColumns::One(width) | SideColumns::Stacked(width, _) => (width, 0),
        SideColumns::Two(width, third) => (width, third + 1),
    };
    let rest = body.width.saturating_sub(third);
    let drawing = moved(rest.saturating_sub(aside + 1), rest, split);
    let side = rest.saturating_sub(drawing + 1);
    let column = |x, width| Rect {
        x: body.x + x,
        width,
        ..body
    };
    let below = |frame: Rect, height: u16| Rect {
        y: frame.y + height,
        height: frame.height.saturating_sub(height),
        ..frame
    };
    let mut frames = vec![column(0, drawing), column(drawing + 1, side)];
    if views.len() > 2 {
        let wanted = height_below(views[2], drawing, needs);
        let height = drawing_rows(screen, drawing, body.height, wanted);
        frames[0].height = height;
        frames.push(below(column(0, drawing), height));
    }
    match columns {
        SideColumns::One(_) => {}
        SideColumns::Stacked(_, height) => {
            frames[1].height = height;
            frames.push(below(column(drawing + 1, side), height));
        }
        SideColumns::Two(_, third) => frames.push(column(drawing + side + 2, third)),
    }
    frames
}

/// Returns the height with the title that a pane below the drawing should have: a plot as much as
/// its panels need.
fn height_below(view: View, width: u16, needs: &impl PaneNeeds) -> u16 {
    let rows = needs.rows(view, width).filter(|_| view == View::Plots);
    rows.map_or(0, |rows| rows.saturating_add(1))
        .max(MIN_HEIGHT_BELOW)
}

/// Returns the height of the drawing above another pane, such that it gets its share of the screen,
/// and at least half of the height if the other pane then has the rows that it wants.
fn drawing_rows(screen: Size, width: u16, height: u16, wanted_below: u16) -> u16 {
    let cells = SHARES[1] * f64::from(screen.width) * f64::from(screen.height);
    let rows = (1..height).find(|rows| f64::from(*rows) * f64::from(width) >= cells);
    let maximum = height.saturating_sub(MIN_HEIGHT_BELOW);
    let half = (height / 2).min(height.saturating_sub(wanted_below));
    rows.unwrap_or(height).max(half).min(maximum)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Returns the screen without its first line and its last two.
    fn body(screen: Size) -> Rect {
        Rect::new(0, 1, screen.width, screen.height.saturating_sub(3))
    }

    /// Panes whose needs are unknown.
    struct Unknown;

    impl PaneNeeds for Unknown {
        fn rows(&self, _view: View, _width: u16) -> Option<u16> {
            None
        }
    }

    /// Panes with these numbers of cells in the tables and of rows in the scene.
    struct Known {
        table_cells: u16,
        scene_rows: u16,
    }

    impl PaneNeeds for Known {
        fn rows(&self, view: View, width: u16) -> Option<u16> {
            match view {
                View::Tables => Some(self.table_cells.div_ceil(width)),
                View::Scene => Some(self.scene_rows),
                _ => None,
            }
        }
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
    fn panes_return_after_small_screen() {
        let (small, large) = (Size::new(40, 12), Size::new(120, 40));
        let mut composition = Composition::default();
        composition.show_view(View::Working, View::Motion, large);
        let before = composition.visible_views(View::Motion, large);
        assert!(before.contains(&View::Working));
        composition.keep(View::Motion, small);
        composition.keep(View::Motion, large);
        assert_eq!(composition.visible_views(View::Motion, large), before);
    }

    #[test]
    fn layouts_show_their_panes() {
        use View::{Forces, Motion, Plots, Scene, Tables, Working};
        let standing = |layout, size, view| Composition::of(layout).visible_views(view, size);
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
        // The focused view is visible in every layout.
        for (layout, size) in all() {
            for view in View::ALL {
                assert!(standing(layout, size, view).contains(&view));
            }
        }
    }

    #[test]
    fn chosen_pane_stays_while_focus_moves() {
        let size = Size::new(120, 40);
        let mut composition = Composition::default();
        composition.show_view(View::Forces, View::Motion, size);
        let with_forces = [View::Motion, View::Forces, View::Plots];
        for view in with_forces {
            assert_eq!(composition.visible_views(view, size), with_forces);
        }
        let next = |view| composition.next_pane(view, size);
        assert_eq!(next(View::Motion), Some(View::Forces));
        assert_eq!(next(View::Plots), Some(View::Motion));
        composition.show_view(View::Tables, View::Plots, size);
        let tables = composition.visible_views(View::Tables, size);
        assert_eq!(tables, [View::Motion, View::Tables, View::Plots]);
    }

    #[test]
    fn panes_fill_body_without_overlap() {
        for (layout, size) in all() {
            for split in [-8, 0, 8] {
                let mut composition = Composition::of(layout);
                composition.split = split;
                let body = body(size);
                let placed = composition.placed(View::Motion, size, body, &Unknown);
                let mut cells = 0;
                for (n, pane) in placed.iter().enumerate() {
                    let frame = pane.title.map_or(pane.area, |title| title.union(pane.area));
                    assert_eq!(frame.intersection(body), frame, "{layout:?} {size} {split}");
                    assert!(
                        pane.area.height >= 5 && pane.area.width >= MIN_WIDTH,
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

    /// Half of the screen next to one pane, two fifths with more panes.
    #[test]
    fn drawing_has_its_share_of_screen() {
        for (layout, size) in all() {
            let placed = Composition::of(layout).placed(View::Motion, size, body(size), &Unknown);
            let share = match placed.len() {
                1 => continue,
                2 => SHARES[0],
                _ => SHARES[1],
            };
            let pane = placed[0];
            let frame = pane.title.unwrap().union(pane.area);
            // The separator counts as part of the drawing.
            let cells = f64::from(frame.width + 1) * f64::from(frame.height);
            let screen = f64::from(size.width) * f64::from(size.height);
            assert!(
                cells >= share * screen,
                "{layout:?} {size}: {}",
                cells / screen
            );
        }
    }

    /// Regression: a taller screen showed five rows of the tables although a lower one showed all.
    #[test]
    fn taller_screens_never_remove_or_shrink_panes() {
        for layout in LayoutName::ALL {
            for width in 110..=240 {
                let mut before: Vec<PlacedView> = Vec::new();
                for height in 34..=90 {
                    let size = Size::new(width, height);
                    let placed =
                        Composition::of(layout).placed(View::Motion, size, body(size), &Unknown);
                    // A plot gets the space that the drawing leaves.
                    for pane in before.iter().filter(|pane| pane.view != View::Plots) {
                        let now = placed.iter().find(|now| now.view == pane.view).unwrap();
                        assert!(now.area.height >= pane.area.height, "{layout:?} {size}");
                    }
                    before = placed;
                }
            }
        }
    }

    /// No pane is more than one third empty while another one scrolls, and everything that fits into
    /// some arrangement is shown.
    #[test]
    fn spare_rows_go_to_panes_that_need_them() {
        let size = Size::new(200, 60);
        for table_cells in (400..=6000).step_by(200) {
            for scene_rows in (5..=120).step_by(5) {
                let needs = Known {
                    table_cells,
                    scene_rows,
                };
                let placed = Composition::default().placed(View::Motion, size, body(size), &needs);
                let panes = [&placed[1], &placed[3]].map(|pane| {
                    let rows = needs.rows(pane.view, pane.area.width).unwrap();
                    let height = pane.area.height;
                    (rows > height, height.saturating_sub(rows) > height / 3)
                });
                let scrolls = panes.iter().any(|(scrolls, _)| *scrolls);
                let is_empty = panes.iter().any(|(_, is_empty)| *is_empty);
                assert!(
                    !(scrolls && is_empty),
                    "{table_cells} {scene_rows}: {placed:?}"
                );
                let fits = table_cells.div_ceil(44) + scene_rows < 56;
                assert!(!(fits && scrolls), "{table_cells} {scene_rows}: {placed:?}");
            }
        }
    }

    #[test]
    fn tables_widen_until_all_rows_fit() {
        let size = Size::new(120, 40);
        let width = |table_cells| {
            let needs = Known {
                table_cells,
                scene_rows: 0,
            };
            let placed = Composition::default().placed(View::Motion, size, body(size), &needs);
            // The drawing keeps its share of the screen.
            assert!(placed[0].area.height < 30 && placed[2].area.height >= 7);
            placed[1].area.width
        };
        assert_eq!(width(30 * 43), 43);
        assert_eq!(width(36 * 48), 48);
        assert_eq!(width(36 * 90), 43, "no width is enough");
    }

    #[test]
    fn maximized_pane_is_alone_and_has_its_title() {
        let size = Size::new(120, 40);
        let mut composition = Composition::default();
        assert!(composition.toggle_alone(View::Motion, size));
        let placed = composition.placed(View::Motion, size, body(size), &Unknown);
        assert_eq!(placed.len(), 1);
        assert!(placed[0].title.is_some() && placed[0].area.width == 120);
    }

    /// Regression: without panes, the drawing could not be maximized over its tables.
    #[test]
    fn drawing_that_fills_the_screen_is_maximized_over_its_tables() {
        let size = Size::new(80, 24);
        let mut composition = Composition::default();
        let has_title = |composition: &Composition, view| {
            let placed = composition.placed(view, size, body(size), &Unknown);
            assert_eq!(placed.len(), 1);
            placed[0].title.is_some()
        };
        assert!(!has_title(&composition, View::Motion));
        assert!(composition.toggle_alone(View::Motion, size));
        assert!(has_title(&composition, View::Motion));
        // Views without tables look the same.
        assert!(!has_title(&composition, View::Plots));
        assert!(!composition.toggle_alone(View::Plots, size));
    }

    #[test]
    fn split_moves_within_screen() {
        let size = Size::new(120, 40);
        let mut composition = Composition::default();
        let width = |composition: &Composition| {
            composition.placed(View::Motion, size, body(size), &Unknown)[0]
                .area
                .width
        };
        let before = width(&composition);
        assert!(composition.move_split(1));
        assert_eq!(width(&composition), before + STEP);
        while composition.move_split(1) {}
        assert!(width(&composition) < 120 - MIN_WIDTH);
        while composition.move_split(-1) {}
        assert!(width(&composition) >= MIN_WIDTH);
    }

    #[test]
    fn layouts_cycle() {
        let mut composition = Composition::default();
        let names = LayoutName::ALL.map(|_| composition.next_layout());
        assert_eq!(names[5], LayoutName::Auto);
        assert_eq!(names[..5], LayoutName::ALL[1..]);
    }
}
