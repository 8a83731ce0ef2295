//! Layers and viewport of the motion view.
//!
//! Layers are toggled by keys and stay on for the next scenes; the window is fitted to each new
//! scene. Data on the whole motion is computed once per scene and selection, not once per frame.

use crate::PointId;
use crate::drawing::{
    self, Extents, Figure, Layers, LegendEntry, Overlay, OverlayRequest, WorldView,
};
use crate::quantity::Subject;
use crate::scene::Scene;
use crate::solver::{Order, State};
use crate::tui::player::open_scene::OpenScene;
use crate::tui::player::scene_version::SceneRevision;
use crate::tui::views::motion::framing::ViewportState;
use crate::tui::views::motion::tracked_points::FollowedPoints;
use crate::wording::words;

/// Number of ghosts, which show the linkage at other positions of its motion.
const GHOSTS: u16 = 6;

/// Minimum height for a drawing with room for arrow tips; in a lower one the linkage would be too
/// small.
const MIN_HEIGHT_WITH_ARROWS: u16 = 12;

/// Maximum number of traces that the legend names.
const MAX_NAMES: usize = 3;

/// Width and maximum height of an exported drawing, in character cells.
const PICTURE: (u16, u16) = (100, 50);
/// Ratio of height to width of such a cell.
const PICTURE_ASPECT: f64 = 2.0;

/// The names shown in the drawing.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(crate) enum ShownNames {
    #[default]
    Points,
    PointsAndLinks,
    None,
}

impl ShownNames {
    fn next(self) -> ShownNames {
        match self {
            ShownNames::Points => ShownNames::PointsAndLinks,
            ShownNames::PointsAndLinks => ShownNames::None,
            ShownNames::None => ShownNames::Points,
        }
    }

    /// Describes the setting in words.
    pub(crate) fn text(self) -> &'static str {
        match self {
            ShownNames::Points => words().names_of_points(),
            ShownNames::PointsAndLinks => words().names_of_points_and_links(),
            ShownNames::None => words().no_names(),
        }
    }
}

/// A layer that can be toggled.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Layer {
    Velocities,
    Accelerations,
    Forces,
    Traces,
    Ghosts,
    Centres,
    Guides,
}

/// The states of all layers. Each is a choice of the user; without one, a layer is in its usual
/// state.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
struct On([Option<bool>; 7]);

impl On {
    fn has(self, scene: &Scene, layer: Layer) -> bool {
        self.0[layer as usize].unwrap_or_else(|| On::usual(scene, layer))
    }

    /// Returns the state of a layer when a scene opens: guides are shown, and traces if the scene
    /// names their points or a point leads.
    fn usual(scene: &Scene, layer: Layer) -> bool {
        match layer {
            Layer::Guides => true,
            Layer::Traces => !scene.traces.is_empty() || scene.lead.is_some(),
            _ => false,
        }
    }

    /// Toggles a layer and returns its new state. A choice that equals the usual state is dropped,
    /// so that the next scene has its own.
    fn toggle(&mut self, scene: &Scene, layer: Layer) -> bool {
        let on = !self.has(scene, layer);
        self.0[layer as usize] = (on != On::usual(scene, layer)).then_some(on);
        on
    }
}

/// The user's settings of the viewport.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct ViewportSetting {
    names: ShownNames,
    on: On,
    lens: ViewportState,
}

/// The layers and the window of the motion view.
#[derive(Debug, Default)]
pub(crate) struct Viewport {
    names: ShownNames,
    on: On,
    /// The window on the drawing.
    pub(crate) lens: ViewportState,
    overlay: Overlay,
    /// The extents of the linkage with its arrows, if there are arrows.
    reach: Option<Extents>,
    /// The scene revision and the request for which the overlay was computed, and whether it is the
    /// motion of a leading point.
    computed_for: Option<(SceneRevision, OverlayRequest, bool)>,
    /// The legend's text on the traced points.
    traced: String,
}

impl Viewport {
    /// Returns the settings; a change of them requires a new drawing.
    pub(crate) fn setting(&self) -> ViewportSetting {
        ViewportSetting {
            names: self.names,
            on: self.on,
            lens: self.lens.without_pin(),
        }
    }

    /// Switches to the next setting of names.
    pub(crate) fn next_names(&mut self) -> ShownNames {
        self.names = self.names.next();
        self.names
    }

    /// Toggles a layer and returns its new state.
    pub(crate) fn toggle(&mut self, scene: &Scene, layer: Layer) -> bool {
        self.on.toggle(scene, layer)
    }

    /// Returns `true` if loads are shown.
    pub(crate) fn shows_forces(&self) -> bool {
        self.on.0[Layer::Forces as usize] == Some(true)
    }

    /// Restores the default window; if it is the default already, lets the window move along.
    /// Returns the description of the framing.
    pub(crate) fn fit(&mut self) -> &'static str {
        self.lens.fit();
        self.lens.describe()
    }

    /// Fits the window to the linkage's current pose, or returns to the default. Returns the
    /// description of the framing.
    pub(crate) fn fit_pose(&mut self) -> &'static str {
        self.lens.fit_pose();
        self.lens.describe()
    }

    /// Centres the window on the first of the followed points, then on the next; after the last
    /// one, returns to the default. Returns the description of the framing.
    pub(crate) fn follow(&mut self, open_scene: &OpenScene, followed: &FollowedPoints) -> String {
        let points = chosen(open_scene, followed, drawing::usual_traces);
        match self.lens.follow(&points) {
            Some(point) => {
                let name = open_scene.scene().point_name(point);
                words().window_stays_with(name.unwrap_or_default())
            }
            None => self.lens.describe().to_owned(),
        }
    }

    /// Computes the overlay for the scene and the layers, unless it is cached.
    pub(crate) fn focus(&mut self, open_scene: &OpenScene, followed: &FollowedPoints) {
        let wanted = self.wanted(open_scene, followed);
        if wanted.is_empty() && self.computed_for.is_none() {
            return;
        }
        let is_led = open_scene.led().is_some();
        if self
            .computed_for
            .as_ref()
            .is_some_and(|(scene, made, led)| {
                scene == open_scene.edition() && *made == wanted && *led == is_led
            })
        {
            return;
        }
        let (scene, extents) = (open_scene.scene(), open_scene.extents());
        self.overlay = match open_scene.led() {
            None => Overlay::of(scene, open_scene.solver(), extents, &wanted),
            Some(led) => Overlay::along(
                (scene, open_scene.solver()),
                led.states(),
                (led.lead().point, led.planned()),
                extents,
                &wanted,
            ),
        };
        self.reach = self.overlay.extents(extents);
        let names = wanted.traces.iter().filter_map(|&p| scene.point_name(p));
        let names: Vec<&str> = names.collect();
        self.traced = match names.len() {
            0..=MAX_NAMES => words().trace_of(&names.join(",")),
            more => words().traces_of(more),
        };
        self.computed_for =
            (!wanted.is_empty()).then_some((open_scene.edition().clone(), wanted, is_led));
    }

    fn wanted(&self, open_scene: &OpenScene, followed: &FollowedPoints) -> OverlayRequest {
        let arrows: fn(&Scene) -> _ = |scene| drawing::usual_arrows(&scene.mechanism);
        let points = |layer, usual: fn(&Scene) -> Vec<PointId>| {
            if self.on.has(open_scene.scene(), layer) {
                chosen(open_scene, followed, usual)
            } else {
                Vec::new()
            }
        };
        OverlayRequest {
            traces: points(Layer::Traces, drawing::usual_traces),
            velocities: points(Layer::Velocities, arrows),
            accelerations: points(Layer::Accelerations, arrows),
            forces: self.on.has(open_scene.scene(), Layer::Forces),
            ghosts: if self.on.has(open_scene.scene(), Layer::Ghosts) {
                GHOSTS
            } else {
                0
            },
            is_timed: true,
        }
    }

    /// Returns the linkage's current state with all active layers; `lit` is highlighted.
    pub(crate) fn figure(&self, open_scene: &OpenScene, highlighted: Option<Subject>) -> Figure {
        self.figure_in(open_scene, open_scene.state(), highlighted)
    }

    /// Adds the part of each trace that its point has just left behind.
    pub(super) fn add_trails(&self, figure: &mut Figure, state: &State, backwards: bool) {
        self.overlay.add_trails(figure, state, backwards);
    }

    /// Returns the linkage in a state with all active layers; `lit` is highlighted.
    pub(super) fn figure_in(
        &self,
        open_scene: &OpenScene,
        state: &State,
        highlighted: Option<Subject>,
    ) -> Figure {
        let layers = Layers {
            ground: self.on.has(open_scene.scene(), Layer::Guides),
            points: self.names != ShownNames::None,
            links: self.names == ShownNames::PointsAndLinks,
            centres: self.on.has(open_scene.scene(), Layer::Centres),
            highlighted,
        };
        let scene = open_scene.scene();
        let mut figure = drawing::linkage(scene, open_scene.extents(), state, layers);
        let solver = open_scene.solver();
        self.overlay
            .add_to(&mut figure, scene, solver, state, self.lens.zoom());
        figure
    }

    /// Returns the order to which a state must be solved for the active layers.
    pub(super) fn order(&self, open_scene: &OpenScene) -> Order {
        let has_arrows = self.on.has(open_scene.scene(), Layer::Velocities)
            || self.on.has(open_scene.scene(), Layer::Accelerations);
        match (self.on.has(open_scene.scene(), Layer::Forces), has_arrows) {
            (true, _) => Order::Force,
            (false, true) => Order::Acceleration,
            (false, false) => Order::Position,
        }
    }

    /// Returns the extents to which a drawing of this height is fitted.
    pub(crate) fn extents<'s>(&'s self, open_scene: &'s OpenScene, rows: u16) -> &'s Extents {
        let with_arrows = self
            .reach
            .as_ref()
            .filter(|_| rows >= MIN_HEIGHT_WITH_ARROWS);
        with_arrows.unwrap_or(open_scene.extents())
    }

    /// Returns the view of a number of cells on a drawing with these extents.
    pub(crate) fn view(
        &self,
        open_scene: &OpenScene,
        extents: &Extents,
        size: (u16, u16),
        aspect: f64,
    ) -> WorldView {
        self.lens.view(open_scene, extents, size, aspect)
    }

    /// Returns the legend of the active layers, the most important entries first.
    pub(crate) fn legend(&self, open_scene: &OpenScene, view: &WorldView) -> Vec<LegendEntry> {
        let mut entries = self.overlay.legend(view, self.lens.zoom());
        let note = |text: &str| LegendEntry::Note(text.to_owned());
        if self.on.has(open_scene.scene(), Layer::Traces) {
            entries.push(note(&self.traced));
        }
        if self.on.has(open_scene.scene(), Layer::Ghosts) {
            entries.push(LegendEntry::Note(words().ghost_positions(GHOSTS)));
        }
        if self.on.has(open_scene.scene(), Layer::Centres) {
            entries.push(note(words().a_centre_of_mass()));
        }
        entries
    }

    /// Returns the visible part of the drawing as an SVG document.
    pub(crate) fn svg(&self, open_scene: &OpenScene) -> String {
        let (cols, maximum) = PICTURE;
        let extents = self.extents(open_scene, maximum);
        let of_rows = |rows| self.view(open_scene, extents, (cols, rows), PICTURE_ASPECT);
        let view = WorldView::lowest_window(maximum, of_rows);
        let (at, unit) = match open_scene.led() {
            Some(led) => (led.time(), "s"),
            None => {
                let at = open_scene.driver_range().on_grid(open_scene.at());
                (at, open_scene.unit())
            }
        };
        let title = words().drawing_of(&open_scene.scene().title(), &at, unit);
        drawing::svg(
            &self.figure(open_scene, None),
            &view,
            &title,
            &self.legend(open_scene, &view),
        )
    }
}

/// Returns the followed points, or the default ones if there are none.
fn chosen(
    open_scene: &OpenScene,
    followed: &FollowedPoints,
    usual: fn(&Scene) -> Vec<PointId>,
) -> Vec<PointId> {
    let scene = open_scene.scene();
    // An edit may have removed points.
    let count = scene.mechanism.points().len();
    let there = followed.points().iter().filter(|p| p.index() < count);
    let there: Vec<PointId> = there.copied().collect();
    if there.is_empty() {
        usual(scene)
    } else {
        there
    }
}
