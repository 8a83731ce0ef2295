//! The window on the drawing: what it is fitted to, how much it is enlarged, and where a hand has put it.

use crate::drawing::{Reach, WorldView};
use crate::scene::Scene;
use crate::tui::player::open_scene::OpenScene;
use crate::tui::views::motion::followed::same_point;
use crate::wording::words;
use crate::{PointId, Vec2};

/// The part of the drawing that is seen: its magnification and where it was moved to.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
struct Window {
    /// Half steps of two from the whole motion.
    level: i8,
    /// From the middle of the whole motion, in the scene's length unit.
    shift: Vec2,
}

/// From a quarter of the size to 64 times.
const LEVELS: std::ops::RangeInclusive<i8> = -4..=12;
/// A pan goes so far, in diagonals of what is seen.
const PAN: f64 = 0.1;

impl Window {
    fn zoom(self) -> f64 {
        2.0_f64.powf(f64::from(self.level) / 2.0)
    }
}

/// What the window is fitted to before it is enlarged and moved.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
enum Framing {
    /// The whole motion, and nearer to the linkage where that would make it small.
    #[default]
    Along,
    /// The whole motion.
    Motion,
    /// The linkage as it stands.
    Pose,
    /// The surroundings of a point, which stays in the middle.
    Point(PointId),
}

/// What the window is fitted to, and what a person has made of it: another one, another drawing.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(crate) struct Lens {
    framing: Framing,
    window: Window,
    /// A window that was moved by hand, or under a hand that holds something, does not go along.
    held: Option<HeldWindow>,
}

/// The window of a coordinate of the driver, and the point that is followed as it was there.
#[derive(Clone, Copy, Debug, PartialEq)]
struct HeldWindow {
    at: f64,
    point: Option<Vec2>,
    /// As it is seen, while a hand holds something in it: what the scene needs by then does not move it either.
    seen: Option<WorldView>,
}

impl Lens {
    /// The same of which nothing is held: that shows nothing else.
    pub(super) fn at_rest(self) -> Lens {
        Lens { held: None, ..self }
    }

    /// Shows the linkage as it is shown first.
    pub(crate) fn reset(&mut self) {
        self.frame(Framing::Along);
    }

    /// Fits the window anew, and where it is fitted already, to the whole motion and back.
    pub(super) fn fit(&mut self) {
        self.frame(match self.fits() {
            true => Framing::Motion,
            false => Framing::Along,
        });
    }

    /// What is seen; the whole motion where something is shown that belongs to all of it.
    pub(super) fn told(&self, of_the_whole: bool) -> &'static str {
        match self.framing {
            Framing::Along if !of_the_whole => words().window_goes_along(),
            Framing::Along | Framing::Motion | Framing::Point(_) => words().the_whole_motion(),
            Framing::Pose => words().the_linkage_as_it_stands(),
        }
    }

    /// Fits the window to the linkage as it stands, or no longer.
    pub(super) fn fit_pose(&mut self) {
        self.frame(match self.framing == Framing::Pose && self.is_whole() {
            true => Framing::Along,
            false => Framing::Pose,
        });
    }

    /// Keeps the next of some points in the middle, from the first on; after the last none.
    pub(super) fn follow(&mut self, points: &[PointId]) -> Option<PointId> {
        let next = match self.framing {
            Framing::Point(last) => points.iter().skip_while(|&&p| p != last).nth(1),
            Framing::Along | Framing::Motion | Framing::Pose => points.first(),
        };
        let Some(&point) = next else {
            self.frame(Framing::Along);
            return None;
        };
        self.framing = Framing::Point(point);
        self.window.shift = Vec2::ZERO;
        self.held = None;
        Some(point)
    }

    /// The scene was changed: the point that is followed is the one of that name, if it is still there.
    pub(crate) fn move_to(&mut self, before: &Scene, after: &Scene) {
        if let Framing::Point(point) = self.framing {
            match same_point(point, before, after) {
                Some(point) => self.framing = Framing::Point(point),
                None => self.frame(Framing::Along),
            }
        }
    }

    fn frame(&mut self, framing: Framing) {
        self.framing = framing;
        self.window = Window::default();
        self.held = None;
    }

    /// A hand holds something in the drawing: the window that is seen stays under it.
    pub(crate) fn hold(&mut self, open_scene: &OpenScene, seen: WorldView) {
        self.stay(open_scene);
        if let Some(held) = &mut self.held {
            held.seen = Some(seen);
        }
    }

    /// The window no longer goes along.
    fn stay(&mut self, open_scene: &OpenScene) {
        let point = match self.framing {
            Framing::Point(point) => open_scene.state().position(point),
            Framing::Along | Framing::Motion | Framing::Pose => None,
        };
        let at = open_scene.at();
        self.held.get_or_insert(HeldWindow {
            at,
            point,
            seen: None,
        });
    }

    /// What was moved by hand stays where it was put; a point that is followed stays in its place there.
    fn put(&mut self, open_scene: &OpenScene, window: Window) {
        self.window = window;
        match self.framing {
            Framing::Point(_) => {}
            Framing::Along | Framing::Motion | Framing::Pose => self.stay(open_scene),
        }
        self.let_go();
    }

    /// The hand has let go.
    pub(crate) fn let_go(&mut self) {
        if let Some(held) = &mut self.held {
            held.seen = None;
        }
        if self.is_whole() || matches!(self.framing, Framing::Point(_)) {
            self.held = None;
        }
    }

    /// How much larger than at first the drawing is, unless it is as large: in words. (No line of the legend tells
    /// it: such a line would move what was put under a pointer.)
    pub(crate) fn enlarged(&self) -> Option<String> {
        (!self.is_whole()).then(|| words().zoomed(&times(self.zoom())))
    }

    /// Whether the window is as it is at first.
    pub(crate) fn fits(&self) -> bool {
        self.framing == Framing::Along && self.is_whole()
    }

    /// Whether it is neither enlarged nor moved.
    fn is_whole(&self) -> bool {
        self.window == Window::default()
    }

    /// Enlarges by so many steps; false at the end of what is sensible.
    pub(crate) fn enlarge(&mut self, open_scene: &OpenScene, steps: i8) -> bool {
        let level = self.window.level.saturating_add(steps);
        let possible = LEVELS.contains(&level);
        if possible {
            let window = self.window;
            self.put(open_scene, Window { level, ..window });
        }
        possible
    }

    /// The same about a place that is seen so far from the middle of the window: it all but stays where it is.
    pub(crate) fn enlarge_at(
        &mut self,
        open_scene: &OpenScene,
        from_middle: Vec2,
        steps: i8,
    ) -> bool {
        let before = self.zoom();
        let possible = self.enlarge(open_scene, steps);
        if possible {
            let by = from_middle * (1.0 - before / self.zoom());
            let Window { level, shift } = self.window;
            // Not so far that nothing is seen any more.
            let most = open_scene.reach().bounds().size().norm();
            let shift = match by.is_finite() {
                true => (shift + by).map(|along| along.clamp(-most, most)),
                false => shift,
            };
            self.put(open_scene, Window { level, shift });
        }
        possible
    }

    /// Moves the window by a step to the right and upwards, as far as there is something to see.
    pub(crate) fn pan(&mut self, open_scene: &OpenScene, right: f64, up: f64) -> bool {
        let size = open_scene.reach().bounds().size();
        let step = PAN * size.norm() / self.zoom();
        self.shift_to(open_scene, self.window.shift + Vec2::new(right, up) * step)
    }

    /// Moves the window, as far as there is something to see; whether it moves.
    fn shift_to(&mut self, open_scene: &OpenScene, wanted: Vec2) -> bool {
        let size = open_scene.reach().bounds().size();
        // A place that was enlarged may lie farther out already.
        let here = self.window.shift;
        let within = |wanted: f64, size: f64, here: f64| {
            let most = (size / 2.0).max(here.abs());
            wanted.clamp(-most, most)
        };
        let shift = Vec2::new(
            within(wanted.x, size.x, here.x),
            within(wanted.y, size.y, here.y),
        );
        let moved = shift.is_finite() && shift != here;
        if moved {
            let window = self.window;
            self.put(open_scene, Window { shift, ..window });
        }
        moved
    }

    pub(super) fn zoom(&self) -> f64 {
        self.window.zoom()
    }

    /// The window of so many cells on a drawing that needs this space.
    pub(super) fn view(
        &self,
        open_scene: &OpenScene,
        reach: &Reach,
        (cols, rows): (u16, u16),
        aspect: f64,
        of_the_whole: bool,
    ) -> WorldView {
        let held = self.held;
        let is_it = |seen: &WorldView| (seen.cols(), seen.rows()) == (cols, rows);
        if let Some(seen) = held.and_then(|held| held.seen).filter(is_it) {
            return seen;
        }
        let at = held.map_or(open_scene.at(), |held| held.at);
        let view = match self.framing {
            Framing::Along if !of_the_whole => WorldView::along(reach, at, cols, rows, aspect),
            Framing::Along | Framing::Motion => WorldView::fit(reach, cols, rows, aspect),
            Framing::Pose => WorldView::pose(reach, at, cols, rows, aspect),
            Framing::Point(point) => {
                let whole = WorldView::fit(reach, cols, rows, aspect);
                let here = held.and_then(|held| held.point);
                match here.or_else(|| open_scene.state().position(point)) {
                    Some(place) => whole.centred_on(place),
                    None => whole,
                }
            }
        };
        view.zoomed(self.zoom(), self.window.shift)
    }
}

/// `2x`, `1.4x`.
fn times(zoom: f64) -> String {
    let text = format!("{zoom:.2}");
    let text = if zoom < 1.0 {
        text
    } else {
        format!("{zoom:.1}")
    };
    format!("{}x", text.trim_end_matches('0').trim_end_matches('.'))
}
