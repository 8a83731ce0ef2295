//! The visible part of the drawing: its framing, its magnification and its shift by the user.

use crate::drawing::{Extents, WorldView};
use crate::scene::Scene;
use crate::tui::player::open_scene::OpenScene;
use crate::tui::views::motion::tracked_points::same_point;
use crate::wording::words;
use crate::{PointId, Vec2};

/// The visible part of the drawing: magnification and shift.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
struct Window {
    /// Zoom level; the magnification is `2^(level / 2)`.
    level: i8,
    /// Shift from the middle of the whole motion, in the scene's length unit.
    shift: Vec2,
}

/// Zoom levels: from a quarter of the size to 64 times.
const LEVELS: std::ops::RangeInclusive<i8> = -4..=12;
/// One step of panning, as a fraction of the visible diagonal.
const PAN: f64 = 0.1;

impl Window {
    fn zoom(self) -> f64 {
        2.0_f64.powf(f64::from(self.level) / 2.0)
    }
}

/// The subject that the window is fitted to before it is zoomed and panned.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
enum Framing {
    /// The whole motion, so that ground and scale stay fixed.
    #[default]
    Motion,
    /// The whole motion, or closer to the linkage if it would be small.
    PlotAxis,
    /// The linkage in its current pose.
    Pose,
    /// A point and its surroundings; the point stays in the middle.
    Point(PointId),
}

/// The framing with the user's zoom and pan. A change of it requires a new drawing.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(crate) struct ViewportState {
    framing: Framing,
    window: Window,
    /// The pinned window, which does not follow the motion. A window is pinned when it is panned or
    /// zoomed, and during a drag.
    held: Option<PinnedViewport>,
}

/// The window at a fixed driver coordinate, with the followed point's position there.
#[derive(Clone, Copy, Debug, PartialEq)]
struct PinnedViewport {
    at: f64,
    point: Option<Vec2>,
    /// The exact window during a drag, which keeps it even if the scene's extents change.
    seen: Option<WorldView>,
}

impl ViewportState {
    /// Returns a copy without the pinned window. Pinning alone does not change the drawing.
    pub(super) fn without_pin(self) -> ViewportState {
        ViewportState { held: None, ..self }
    }

    /// Restores the default window, which shows the whole motion.
    pub(crate) fn reset(&mut self) {
        self.frame(Framing::default());
    }

    /// Restores the default window; if it is the default already, lets the window move along.
    pub(super) fn fit(&mut self) {
        self.frame(match self.fits() {
            true => Framing::PlotAxis,
            false => Framing::default(),
        });
    }

    /// Describes the framing in words.
    pub(super) fn describe(&self) -> &'static str {
        match self.framing {
            Framing::PlotAxis => words().window_goes_along(),
            Framing::Motion | Framing::Point(_) => words().the_whole_motion(),
            Framing::Pose => words().the_linkage_as_it_stands(),
        }
    }

    /// Fits the window to the linkage's current pose, or returns to the default.
    pub(super) fn fit_pose(&mut self) {
        self.frame(match self.framing == Framing::Pose && self.is_whole() {
            true => Framing::default(),
            false => Framing::Pose,
        });
    }

    /// Centres the window on the next of the points, starting with the first; after the last one,
    /// returns to the default.
    pub(super) fn follow(&mut self, points: &[PointId]) -> Option<PointId> {
        let next = match self.framing {
            Framing::Point(last) => points.iter().skip_while(|&&p| p != last).nth(1),
            Framing::Motion | Framing::PlotAxis | Framing::Pose => points.first(),
        };
        let Some(&point) = next else {
            self.reset();
            return None;
        };
        self.framing = Framing::Point(point);
        self.window.shift = Vec2::ZERO;
        self.held = None;
        Some(point)
    }

    /// Moves to an edited scene: the followed point is identified by its name, and dropped if it is
    /// gone.
    pub(crate) fn move_to(&mut self, before: &Scene, after: &Scene) {
        if let Framing::Point(point) = self.framing {
            match same_point(point, before, after) {
                Some(point) => self.framing = Framing::Point(point),
                None => self.reset(),
            }
        }
    }

    fn frame(&mut self, framing: Framing) {
        self.framing = framing;
        self.window = Window::default();
        self.held = None;
    }

    /// Starts a drag in the drawing: pins the visible window.
    pub(crate) fn hold(&mut self, open_scene: &OpenScene, seen: WorldView) {
        self.stay(open_scene);
        if let Some(held) = &mut self.held {
            held.seen = Some(seen);
        }
    }

    /// Pins the window to the current driver coordinate.
    fn stay(&mut self, open_scene: &OpenScene) {
        let point = match self.framing {
            Framing::Point(point) => open_scene.state().position(point),
            Framing::Motion | Framing::PlotAxis | Framing::Pose => None,
        };
        let at = open_scene.at();
        self.held.get_or_insert(PinnedViewport {
            at,
            point,
            seen: None,
        });
    }

    /// Sets the window after a zoom or pan and pins it. A window that follows a point is not
    /// pinned.
    fn put(&mut self, open_scene: &OpenScene, window: Window) {
        self.window = window;
        match self.framing {
            Framing::Point(_) => {}
            Framing::Motion | Framing::PlotAxis | Framing::Pose => self.stay(open_scene),
        }
        self.end_drag();
    }

    /// Ends a drag.
    pub(crate) fn end_drag(&mut self) {
        if let Some(held) = &mut self.held {
            held.seen = None;
        }
        if self.is_whole() || matches!(self.framing, Framing::Point(_)) {
            self.held = None;
        }
    }

    /// Describes the magnification in words; `None` if it is the default. The legend has no line
    /// for it, because such a line would move the drawing under the pointer.
    pub(crate) fn enlarged(&self) -> Option<String> {
        (!self.is_whole()).then(|| words().zoomed(&times(self.zoom())))
    }

    /// Returns `true` if the window stays in place while the linkage moves.
    pub(in crate::tui::views) fn is_fixed(&self) -> bool {
        self.framing == Framing::Motion || self.held.is_some()
    }

    /// Returns `true` if the window is the default one.
    pub(crate) fn fits(&self) -> bool {
        self.framing == Framing::default() && self.is_whole()
    }

    /// Returns `true` if the window is neither zoomed nor panned.
    fn is_whole(&self) -> bool {
        self.window == Window::default()
    }

    /// Zooms in by `steps` levels; returns `false` at the limit.
    pub(crate) fn enlarge(&mut self, open_scene: &OpenScene, steps: i8) -> bool {
        let level = self.window.level.saturating_add(steps);
        let possible = LEVELS.contains(&level);
        if possible {
            let window = self.window;
            self.put(open_scene, Window { level, ..window });
        }
        possible
    }

    /// Zooms about a place given by its distance from the window's middle, so that the place nearly
    /// keeps its position on the screen.
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
            // Limits the shift, so that the drawing stays visible.
            let maximum = open_scene.extents().bounds().size().norm();
            let shift = match by.is_finite() {
                true => (shift + by).map(|along| along.clamp(-maximum, maximum)),
                false => shift,
            };
            self.put(open_scene, Window { level, shift });
        }
        possible
    }

    /// Pans the window by a step to the right and upwards within the drawing's extents; returns
    /// `true` if it moves.
    pub(crate) fn pan(&mut self, open_scene: &OpenScene, right: f64, up: f64) -> bool {
        let size = open_scene.extents().bounds().size();
        let step = PAN * size.norm() / self.zoom();
        self.shift_to(open_scene, self.window.shift + Vec2::new(right, up) * step)
    }

    /// Shifts the window within the drawing's extents; returns `true` if it moves.
    fn shift_to(&mut self, open_scene: &OpenScene, wanted: Vec2) -> bool {
        let size = open_scene.extents().bounds().size();
        // A zoom about a place may have moved the window beyond these limits already.
        let here = self.window.shift;
        let within = |wanted: f64, size: f64, here: f64| {
            let maximum = (size / 2.0).max(here.abs());
            wanted.clamp(-maximum, maximum)
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

    /// Returns the view of `cols` by `rows` cells on a drawing with these extents.
    pub(super) fn view(
        &self,
        open_scene: &OpenScene,
        extents: &Extents,
        (cols, rows): (u16, u16),
        aspect: f64,
    ) -> WorldView {
        let held = self.held;
        let is_it = |seen: &WorldView| (seen.cols(), seen.rows()) == (cols, rows);
        if let Some(seen) = held.and_then(|held| held.seen).filter(is_it) {
            return seen;
        }
        let at = held.map_or(open_scene.at(), |held| held.at);
        let view = match self.framing {
            Framing::Motion => WorldView::fit(extents, cols, rows, aspect),
            Framing::PlotAxis => WorldView::along(extents, at, cols, rows, aspect),
            Framing::Pose => WorldView::pose(extents, at, cols, rows, aspect),
            Framing::Point(point) => {
                let complete = WorldView::fit(extents, cols, rows, aspect);
                let here = held.and_then(|held| held.point);
                match here.or_else(|| open_scene.state().position(point)) {
                    Some(position) => complete.centred_on(position),
                    None => complete,
                }
            }
        };
        view.zoomed(self.zoom(), self.window.shift)
    }
}

/// Formats a magnification, such as `2x` or `1.4x`.
fn times(zoom: f64) -> String {
    let text = format!("{zoom:.2}");
    let text = if zoom < 1.0 {
        text
    } else {
        format!("{zoom:.1}")
    };
    format!("{}x", text.trim_end_matches('0').trim_end_matches('.'))
}
