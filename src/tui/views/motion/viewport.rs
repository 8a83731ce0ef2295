//! What the motion view shows beside the linkage, and which part of it how large.
//!
//! Layers are switched by keys and stay on from scene to scene; the window is fitted to each scene anew.
//! What follows from the whole motion is found once for a scene and a choice, not for every frame.

use crate::PointId;
use crate::drawing::{self, Figure, Layers, LegendEntry, Overlay, Reach, Wanted, WorldView};
use crate::quantity::Subject;
use crate::tui::player::edition::Edition;
use crate::tui::player::open_scene::OpenScene;
use crate::tui::views::motion::followed::FollowedPoints;
use crate::tui::views::motion::lens::Lens;
use crate::wording::words;

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

/// What a person has set.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct ViewportSetting {
    names: ShownNames,
    on: On,
    lens: Lens,
}

/// What the motion view shows, and how large.
#[derive(Debug)]
pub(crate) struct Viewport {
    names: ShownNames,
    on: On,
    /// The window on it.
    pub(crate) lens: Lens,
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
        Viewport {
            names: ShownNames::default(),
            on,
            lens: Lens::default(),
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
        ViewportSetting {
            names: self.names,
            on: self.on,
            lens: self.lens.at_rest(),
        }
    }

    /// Switches to the next names.
    pub(crate) fn next_names(&mut self) -> ShownNames {
        self.names = self.names.next();
        self.names
    }

    /// Switches a layer on or off, and says which.
    pub(crate) fn toggle(&mut self, layer: Layer) -> bool {
        let on = &mut self.on.0[layer as usize];
        *on = !*on;
        *on
    }

    /// Whether what acts is shown.
    pub(crate) fn shows_forces(&self) -> bool {
        self.on.has(Layer::Forces)
    }

    /// Fits the window anew, and where it is fitted already, to the whole motion and back.
    pub(crate) fn fit(&mut self) -> &'static str {
        self.lens.fit();
        self.lens.told(self.is_of_the_whole())
    }

    /// Fits the window to the linkage as it stands, or no longer.
    pub(crate) fn fit_pose(&mut self) -> &'static str {
        self.lens.fit_pose();
        self.lens.told(self.is_of_the_whole())
    }

    /// Keeps a point in the middle: the first that is followed, then the next; after the last none.
    pub(crate) fn follow(&mut self, open_scene: &OpenScene, followed: &FollowedPoints) -> String {
        let points = chosen(open_scene, followed, drawing::usual_traces);
        match self.lens.follow(&points) {
            Some(point) => {
                let name = open_scene.scene().point_name(point);
                words().window_stays_with(name.unwrap_or_default())
            }
            None => self.lens.told(self.is_of_the_whole()).to_owned(),
        }
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
            if self.on.has(layer) {
                chosen(open_scene, followed, usual)
            } else {
                Vec::new()
            }
        };
        Wanted {
            traces: points(Layer::Traces, drawing::usual_traces),
            velocities: points(Layer::Velocities, drawing::usual_arrows),
            accelerations: points(Layer::Accelerations, drawing::usual_arrows),
            forces: self.on.has(Layer::Forces),
            ghosts: if self.on.has(Layer::Ghosts) {
                GHOSTS
            } else {
                0
            },
            is_timed: true,
        }
    }

    /// The linkage as it is now, with all layers that are on, and what is lit up in it.
    pub(crate) fn figure(&self, open_scene: &OpenScene, lit: Option<Subject>) -> Figure {
        let layers = Layers {
            ground: self.on.has(Layer::Guides),
            points: self.names != ShownNames::None,
            links: self.names == ShownNames::PointsAndLinks,
            centres: self.on.has(Layer::Centres),
            lit,
        };
        let (scene, state) = (open_scene.scene(), open_scene.state());
        let mut figure = drawing::linkage(scene, open_scene.reach(), state, layers);
        let solver = open_scene.solver();
        self.overlay
            .add_to(&mut figure, scene, solver, state, self.lens.zoom());
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
        size: (u16, u16),
        aspect: f64,
    ) -> WorldView {
        let of_the_whole = self.is_of_the_whole();
        self.lens
            .view(open_scene, reach, size, aspect, of_the_whole)
    }

    /// Whether something is shown that belongs to the whole motion.
    fn is_of_the_whole(&self) -> bool {
        [Layer::Traces, Layer::Ghosts]
            .into_iter()
            .any(|layer| self.on.has(layer))
    }

    /// What is on that the drawing does not explain by itself, the most important first.
    pub(crate) fn legend(&self, view: &WorldView) -> Vec<LegendEntry> {
        let mut entries = self.overlay.legend(view, self.lens.zoom());
        let note = |text: &str| LegendEntry::Note(text.to_owned());
        if self.on.has(Layer::Traces) {
            entries.push(note(&self.traced));
        }
        if self.on.has(Layer::Ghosts) {
            entries.push(LegendEntry::Note(words().ghost_positions(GHOSTS)));
        }
        if self.on.has(Layer::Centres) {
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
        let title = words().drawing_of(&open_scene.scene().title(), &at, open_scene.unit());
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
