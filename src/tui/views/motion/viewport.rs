//! What the motion view shows beside the linkage, and which part of it how large.
//!
//! Layers are switched by keys and stay on from scene to scene; the window is fitted to each scene anew.
//! What follows from the whole motion is found once for a scene and a choice, not for every frame.

use crate::drawing::{self, Figure, Layers, LegendEntry, Overlay, Reach, Wanted, WorldView};
use crate::quantity::Subject;
use crate::scene::Scene;
use crate::tui::player::edition::Edition;
use crate::tui::player::open_scene::OpenScene;
use crate::tui::views::motion::followed::{FollowedPoints, same_point};
use crate::wording::words;
use crate::{PointId, Vec2};

/// Positions of the linkage that are shown elsewhere in its motion.
const GHOSTS: u16 = 6;

/// A lower drawing leaves no room for the tips of arrows: the linkage would be too small to see.
const ROOM_FOR_ARROWS: u16 = 12;

/// Traces are named while they are so few.
const MOST_NAMES: usize = 3;

/// A picture of its own is so many columns wide, and so many rows high at the most.
const PICTURE: (u16, u16) = (100, 50);
/// The height of its characters for their width.
const PICTURE_ASPECT: f64 = 2.0;

/// Which names are shown.
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

    /// In words.
    pub(crate) fn text(self) -> &'static str {
        match self {
            ShownNames::Points => words().names_of_points(),
            ShownNames::PointsAndLinks => words().names_of_points_and_links(),
            ShownNames::None => words().no_names(),
        }
    }
}

/// A layer that is on or off.
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

/// Which of the layers are on.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
struct On([bool; 7]);

impl On {
    fn has(self, layer: Layer) -> bool {
        self.0[layer as usize]
    }
}

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

/// What a person has set.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct ViewportSetting {
    names: ShownNames,
    on: On,
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

/// What the motion view shows, and how large.
#[derive(Debug)]
pub(crate) struct Viewport {
    setting: ViewportSetting,
    overlay: Overlay,
    /// The space that the linkage needs with its arrows, where there are any.
    reach: Option<Reach>,
    /// For which scene, and what, the overlay was made.
    made: Option<(Edition, Wanted)>,
    /// Which points leave traces, in words.
    traced: String,
}

impl Default for Viewport {
    fn default() -> Self {
        let mut on = On([false; 7]);
        on.0[Layer::Guides as usize] = true;
        let setting = ViewportSetting {
            names: ShownNames::default(),
            on,
            framing: Framing::default(),
            window: Window::default(),
            held: None,
        };
        Viewport {
            setting,
            overlay: Overlay::default(),
            reach: None,
            made: None,
            traced: String::new(),
        }
    }
}

impl Viewport {
    /// What is set: another one, another drawing.
    pub(crate) fn setting(&self) -> ViewportSetting {
        // What is held shows nothing else.
        let held = None;
        ViewportSetting {
            held,
            ..self.setting
        }
    }

    /// Switches to the next names.
    pub(crate) fn next_names(&mut self) -> ShownNames {
        self.setting.names = self.setting.names.next();
        self.setting.names
    }

    /// Switches a layer on or off, and says which.
    pub(crate) fn toggle(&mut self, layer: Layer) -> bool {
        let on = &mut self.setting.on.0[layer as usize];
        *on = !*on;
        *on
    }

    /// Whether what acts is shown.
    pub(crate) fn shows_forces(&self) -> bool {
        self.setting.on.has(Layer::Forces)
    }

    /// Shows the linkage as it is shown first.
    pub(crate) fn reset(&mut self) {
        self.frame(Framing::Along);
    }

    /// Fits the window anew, and where it is fitted already, to the whole motion and back.
    pub(crate) fn fit(&mut self) -> &'static str {
        self.frame(match self.fits() {
            true => Framing::Motion,
            false => Framing::Along,
        });
        self.told()
    }

    /// What is seen.
    fn told(&self) -> &'static str {
        match self.setting.framing {
            Framing::Along if !self.is_of_the_whole() => words().window_goes_along(),
            Framing::Along | Framing::Motion | Framing::Point(_) => words().the_whole_motion(),
            Framing::Pose => words().the_linkage_as_it_stands(),
        }
    }

    /// Fits the window to the linkage as it stands, or no longer.
    pub(crate) fn fit_pose(&mut self) -> &'static str {
        self.frame(
            match self.setting.framing == Framing::Pose && self.is_whole() {
                true => Framing::Along,
                false => Framing::Pose,
            },
        );
        self.told()
    }

    /// Keeps a point in the middle: the first that is followed, then the next; after the last none.
    pub(crate) fn follow(&mut self, open_scene: &OpenScene, followed: &FollowedPoints) -> String {
        let scene = open_scene.scene();
        let points = chosen(open_scene, followed, drawing::usual_traces);
        let next = match self.setting.framing {
            Framing::Point(last) => points.iter().skip_while(|&&p| p != last).nth(1),
            Framing::Along | Framing::Motion | Framing::Pose => points.first(),
        };
        match next {
            Some(&point) => {
                self.setting.framing = Framing::Point(point);
                self.setting.window.shift = Vec2::ZERO;
                self.setting.held = None;
                words().window_stays_with(scene.point_name(point).unwrap_or_default())
            }
            None => {
                self.frame(Framing::Along);
                self.told().to_owned()
            }
        }
    }

    /// The scene was changed: the point that is followed is the one of that name, if it is still there.
    pub(crate) fn move_to(&mut self, before: &Scene, after: &Scene) {
        if let Framing::Point(point) = self.setting.framing {
            match same_point(point, before, after) {
                Some(point) => self.setting.framing = Framing::Point(point),
                None => self.frame(Framing::Along),
            }
        }
    }

    fn frame(&mut self, framing: Framing) {
        self.setting.framing = framing;
        self.setting.window = Window::default();
        self.setting.held = None;
    }

    /// A hand holds something in the drawing: the window that is seen stays under it.
    pub(crate) fn hold(&mut self, open_scene: &OpenScene, seen: WorldView) {
        self.stay(open_scene);
        if let Some(held) = &mut self.setting.held {
            held.seen = Some(seen);
        }
    }

    /// The window no longer goes along.
    fn stay(&mut self, open_scene: &OpenScene) {
        let point = match self.setting.framing {
            Framing::Point(point) => open_scene.state().position(point),
            Framing::Along | Framing::Motion | Framing::Pose => None,
        };
        let at = open_scene.at();
        self.setting.held.get_or_insert(HeldWindow {
            at,
            point,
            seen: None,
        });
    }

    /// What was moved by hand stays where it was put; a point that is followed stays in its place there.
    fn put(&mut self, open_scene: &OpenScene, window: Window) {
        self.setting.window = window;
        match self.setting.framing {
            Framing::Point(_) => {}
            Framing::Along | Framing::Motion | Framing::Pose => self.stay(open_scene),
        }
        self.let_go();
    }

    /// The hand has let go.
    pub(crate) fn let_go(&mut self) {
        if let Some(held) = &mut self.setting.held {
            held.seen = None;
        }
        if self.is_whole() || matches!(self.setting.framing, Framing::Point(_)) {
            self.setting.held = None;
        }
    }

    /// How much larger than at first the drawing is, unless it is as large: in words. (No line of the legend tells
    /// it: such a line would move what was put under a pointer.)
    pub(crate) fn enlarged(&self) -> Option<String> {
        (!self.is_whole()).then(|| words().zoomed(&times(self.zoom())))
    }

    /// Whether the window is as it is at first.
    pub(crate) fn fits(&self) -> bool {
        self.setting.framing == Framing::Along && self.is_whole()
    }

    /// Whether it is neither enlarged nor moved.
    fn is_whole(&self) -> bool {
        self.setting.window == Window::default()
    }

    /// Enlarges by so many steps; false at the end of what is sensible.
    pub(crate) fn enlarge(&mut self, open_scene: &OpenScene, steps: i8) -> bool {
        let level = self.setting.window.level.saturating_add(steps);
        let possible = LEVELS.contains(&level);
        if possible {
            let window = self.setting.window;
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
            let Window { level, shift } = self.setting.window;
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
        self.shift_to(
            open_scene,
            self.setting.window.shift + Vec2::new(right, up) * step,
        )
    }

    /// Moves the window, as far as there is something to see; whether it moves.
    fn shift_to(&mut self, open_scene: &OpenScene, wanted: Vec2) -> bool {
        let size = open_scene.reach().bounds().size();
        // A place that was enlarged may lie farther out already.
        let here = self.setting.window.shift;
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
            let window = self.setting.window;
            self.put(open_scene, Window { shift, ..window });
        }
        moved
    }

    fn zoom(&self) -> f64 {
        self.setting.window.zoom()
    }

    /// Need what is wanted of the motion, unless it is known already.
    pub(crate) fn focus(&mut self, open_scene: &OpenScene, followed: &FollowedPoints) {
        let wanted = self.wanted(open_scene, followed);
        if wanted.is_empty() && self.made.is_none() {
            return;
        }
        if self
            .made
            .as_ref()
            .is_some_and(|(scene, made)| scene == open_scene.edition() && *made == wanted)
        {
            return;
        }
        let (scene, reach) = (open_scene.scene(), open_scene.reach());
        self.overlay = Overlay::of(scene, open_scene.solver(), reach, &wanted);
        self.reach = self.overlay.reach(reach);
        let names = wanted.traces.iter().filter_map(|&p| scene.point_name(p));
        let names: Vec<&str> = names.collect();
        self.traced = match names.len() {
            0..=MOST_NAMES => words().trace_of(&names.join(",")),
            more => words().traces_of(more),
        };
        self.made = (!wanted.is_empty()).then_some((open_scene.edition().clone(), wanted));
    }

    fn wanted(&self, open_scene: &OpenScene, followed: &FollowedPoints) -> Wanted {
        let points = |layer, usual: fn(&crate::Mechanism) -> Vec<PointId>| {
            if self.setting.on.has(layer) {
                chosen(open_scene, followed, usual)
            } else {
                Vec::new()
            }
        };
        Wanted {
            traces: points(Layer::Traces, drawing::usual_traces),
            velocities: points(Layer::Velocities, drawing::usual_arrows),
            accelerations: points(Layer::Accelerations, drawing::usual_arrows),
            forces: self.setting.on.has(Layer::Forces),
            ghosts: if self.setting.on.has(Layer::Ghosts) {
                GHOSTS
            } else {
                0
            },
        }
    }

    /// The linkage as it is now, with all layers that are on, and what is lit up in it.
    pub(crate) fn figure(&self, open_scene: &OpenScene, lit: Option<Subject>) -> Figure {
        let layers = Layers {
            ground: self.setting.on.has(Layer::Guides),
            points: self.setting.names != ShownNames::None,
            links: self.setting.names == ShownNames::PointsAndLinks,
            centres: self.setting.on.has(Layer::Centres),
            lit,
        };
        let (scene, state) = (open_scene.scene(), open_scene.state());
        let mut figure = drawing::linkage(scene, open_scene.reach(), state, layers);
        let solver = open_scene.solver();
        self.overlay
            .add_to(&mut figure, scene, solver, state, self.zoom());
        figure
    }

    /// The space that a drawing of so many rows is fitted to before it is enlarged.
    pub(crate) fn reach<'s>(&'s self, open_scene: &'s OpenScene, rows: u16) -> &'s Reach {
        let with_arrows = self.reach.as_ref().filter(|_| rows >= ROOM_FOR_ARROWS);
        with_arrows.unwrap_or(open_scene.reach())
    }

    /// The window of so many cells on a drawing that needs this space.
    pub(crate) fn view(
        &self,
        open_scene: &OpenScene,
        reach: &Reach,
        (cols, rows): (u16, u16),
        aspect: f64,
    ) -> WorldView {
        let held = self.setting.held;
        let is_it = |seen: &WorldView| (seen.cols(), seen.rows()) == (cols, rows);
        if let Some(seen) = held.and_then(|held| held.seen).filter(is_it) {
            return seen;
        }
        let at = held.map_or(open_scene.at(), |held| held.at);
        let view = match self.setting.framing {
            Framing::Along if !self.is_of_the_whole() => {
                WorldView::along(reach, at, cols, rows, aspect)
            }
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
        view.zoomed(self.zoom(), self.setting.window.shift)
    }

    /// Whether something is shown that belongs to the whole motion.
    fn is_of_the_whole(&self) -> bool {
        [Layer::Traces, Layer::Ghosts]
            .into_iter()
            .any(|layer| self.setting.on.has(layer))
    }

    /// What is on that the drawing does not explain by itself, the most important first.
    pub(crate) fn legend(&self, view: &WorldView) -> Vec<LegendEntry> {
        let mut entries = self.overlay.legend(view, self.zoom());
        let note = |text: &str| LegendEntry::Note(text.to_owned());
        if self.setting.on.has(Layer::Traces) {
            entries.push(note(&self.traced));
        }
        if self.setting.on.has(Layer::Ghosts) {
            entries.push(LegendEntry::Note(words().ghost_positions(GHOSTS)));
        }
        if self.setting.on.has(Layer::Centres) {
            entries.push(note(words().a_centre_of_mass()));
        }
        entries
    }

    /// The drawing as an SVG document, as it is seen now.
    pub(crate) fn svg(&self, open_scene: &OpenScene) -> String {
        let (cols, most) = PICTURE;
        let reach = self.reach(open_scene, most);
        let of_rows = |rows| self.view(open_scene, reach, (cols, rows), PICTURE_ASPECT);
        let view = WorldView::snug(most, of_rows);
        let at = open_scene.driver_range().on_grid(open_scene.at());
        let title = words().drawing_of(&open_scene.scene().name, &at, open_scene.unit());
        drawing::svg(
            &self.figure(open_scene, None),
            &view,
            &title,
            &self.legend(&view),
        )
    }
}

/// The points that are followed; where there are none, the usual ones.
fn chosen(
    open_scene: &OpenScene,
    followed: &FollowedPoints,
    usual: fn(&crate::Mechanism) -> Vec<PointId>,
) -> Vec<PointId> {
    let mechanism = &open_scene.scene().mechanism;
    // After an edit a point may be gone.
    let count = mechanism.points().len();
    let there = followed.points().iter().filter(|p| p.index() < count);
    let there: Vec<PointId> = there.copied().collect();
    if there.is_empty() {
        usual(mechanism)
    } else {
        there
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
