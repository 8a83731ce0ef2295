//! The selected quantities of the plots and their samples.
//!
//! Samples are solved once per scene and selection; a frame only evaluates the driver's current
//! position.

use crate::Vec2;
use crate::drawing::Raster;
use crate::drawing::plot::{Plot, PlotCanvas, PlotStyle};
use crate::page::Page;
use crate::quantity::{Abscissa, Catalogue, Clock, Curve, Curves, Quantity, StateValues};
use crate::report::{CsvDialect, curves_csv};
use crate::scene::Scene;
use crate::solver::{Order, Solver};
use crate::study::ToleranceStudy;
use crate::tui::player::compared_scene::ComparedScene;
use crate::tui::player::open_scene::OpenScene;
use crate::tui::player::scene_version::SceneRevision;
use crate::tui::views::plots::excursion_note::ExcursionNote;
use crate::wording::words;
use std::cell::RefCell;

/// The x axis of the plots. A quantity is identified by its name, because another scene has other
/// quantities.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) enum PlotAxis {
    /// The driver coordinate.
    Driver,
    /// Time.
    Time,
    /// A chosen quantity, against which the others are plotted.
    Figure(String),
}

/// The plots of a scene.
#[derive(Debug)]
pub(crate) struct Plots {
    /// The names of the quantities in the order of their selection; `None` means the default ones.
    chosen: Option<Vec<String>>,
    /// The x axis; `None` means the time of a motion over time, or else the driver coordinate.
    along: Option<PlotAxis>,
    /// Whether extrema are marked.
    extrema: bool,
    /// Whether tolerance bands are drawn.
    band: bool,
    /// The summary of the quantity under the list's cursor.
    note: ExcursionNote,
    /// The samples; `None` until they are needed and after a change of the selection.
    sampled: Option<Sampled>,
}

/// The samples of a scene.
#[derive(Debug)]
struct Sampled {
    /// The revisions of the scene and of the compared scene.
    of: (SceneRevision, Option<SceneRevision>),
    /// The plotted quantities, in the order of the panels.
    names: Vec<String>,
    outcome: SamplingOutcome,
    /// The plot without the cursor, in the style of the last frame.
    canvas: RefCell<Option<PlotCanvas>>,
}

/// The result of sampling.
#[derive(Debug)]
enum SamplingOutcome {
    Plot(Box<Curves>, Plot),
    /// The reason why there is no plot.
    Nothing(String),
}

impl Default for Plots {
    fn default() -> Self {
        Plots {
            chosen: None,
            along: None,
            extrema: true,
            band: true,
            note: ExcursionNote::default(),
            sampled: None,
        }
    }
}

impl Plots {
    /// Samples the selected quantities, unless the samples for this scene and the compared scene
    /// are cached.
    pub(crate) fn sample(&mut self, open_scene: &OpenScene, compared: Option<&ComparedScene>) {
        let of = (
            open_scene.edition().clone(),
            compared.map(|compared| compared.edition().clone()),
        );
        if self.sampled.as_ref().is_some_and(|s| s.of == of) {
            return;
        }
        let names = self.names(open_scene.scene());
        let along = self.along(open_scene.scene());
        let outcome = match sampled(open_scene.scene(), open_scene.solver(), &names, &along) {
            Ok(curves) => {
                let plot = Plot::of(&curves);
                // In a comparison, hues distinguish the scenes and not the links.
                let plot = match compared {
                    Some(_) => plot,
                    None => {
                        let mut plot = plot.in_hues_of(&open_scene.scene().mechanism, &curves);
                        if self.band {
                            add_bands(&mut plot, &curves, open_scene);
                        }
                        plot
                    }
                };
                SamplingOutcome::Plot(Box::new(curves), plot)
            }
            Err(why) => SamplingOutcome::Nothing(why),
        };
        self.sampled = Some(Sampled {
            of,
            names,
            outcome,
            canvas: RefCell::default(),
        });
        if let Some(compared) = compared {
            self.compare(compared, open_scene.scene().unit.symbol(), &along);
        }
    }

    /// Returns the quantity of the x axis.
    fn along(&self, scene: &Scene) -> PlotAxis {
        let usual = || match scene.motion {
            Some(_) => PlotAxis::Time,
            None => PlotAxis::Driver,
        };
        self.along.clone().unwrap_or_else(usual)
    }

    /// Summarizes the quantity under the list's cursor over the whole motion.
    pub(crate) fn note(&mut self, open_scene: &OpenScene, name: Option<&str>) {
        self.note.follow(open_scene, name);
    }

    /// Returns the summary in a few short lines.
    pub(crate) fn noted(&self) -> &[String] {
        self.note.lines()
    }

    /// Returns the full summary as a page.
    pub(crate) fn noted_page(&self) -> &Page {
        self.note.page()
    }

    /// Returns the plotted quantities: the selected ones that the scene has, or the default ones.
    fn names(&self, scene: &Scene) -> Vec<String> {
        let Some(chosen) = &self.chosen else {
            return usual(scene);
        };
        let catalogue = Catalogue::new(scene);
        let known = |name: &&String| catalogue.find(name).is_some();
        chosen.iter().filter(known).cloned().collect()
    }

    /// Returns `true` if a quantity is plotted or is on the x axis.
    pub(crate) fn is_chosen(&self, name: &str) -> bool {
        let names = self.sampled.as_ref().map(|s| &s.names);
        names.is_some_and(|names| names.iter().any(|n| n == name))
    }

    /// Returns the number of selected quantities.
    pub(crate) fn count(&self) -> usize {
        self.sampled.as_ref().map_or(0, |s| s.names.len())
    }

    /// Selects or deselects a quantity.
    pub(crate) fn toggle(&mut self, name: &str, scene: &Scene) {
        let mut names = self.names(scene);
        match names.iter().position(|n| n == name) {
            Some(at) => drop(names.remove(at)),
            None => names.push(name.to_owned()),
        }
        if self.along == Some(PlotAxis::Figure(name.to_owned())) {
            self.along = None;
        }
        self.chosen = Some(names);
        self.sampled = None;
    }

    /// Deselects all quantities.
    pub(crate) fn clear(&mut self) {
        self.chosen = Some(Vec::new());
        self.along = None;
        self.sampled = None;
    }

    /// Switches the x axis to the next of the driver coordinate, time, and each selected quantity.
    /// Returns a description of it.
    pub(crate) fn next_abscissa(&mut self, scene: &Scene) -> String {
        let names = self.names(scene);
        // A single quantity must stay on the y axis.
        let figures = names.iter().filter(|_| names.len() > 1);
        let time = Clock::of(scene).map(|_| PlotAxis::Time);
        let mut all = vec![PlotAxis::Driver];
        all.extend(time);
        all.extend(figures.cloned().map(PlotAxis::Figure));
        let along = self.along(scene);
        let here = all.iter().position(|other| *other == along);
        let next = here.map_or(0, |here| (here + 1) % all.len());
        let next = all.swap_remove(next);
        let text = match &next {
            PlotAxis::Driver => words().over(&Catalogue::new(scene).driver().name),
            PlotAxis::Time => words().over_time().into(),
            PlotAxis::Figure(name) => words().over(name),
        };
        self.along = Some(next);
        self.sampled = None;
        text
    }

    /// Toggles the marks of extrema and returns the new state.
    pub(crate) fn toggle_extrema(&mut self) -> bool {
        self.extrema = !self.extrema;
        self.extrema
    }

    /// Toggles the tolerance bands and returns the new state.
    pub(crate) fn toggle_band(&mut self) -> bool {
        self.band = !self.band;
        self.sampled = None;
        self.band
    }

    pub(crate) fn extrema(&self) -> bool {
        self.extrema
    }

    /// Returns the plot.
    ///
    /// # Errors
    /// Returns the reason why there is no plot.
    pub(crate) fn plot(&self) -> Result<&Plot, &str> {
        match self.sampled.as_ref().map(|s| &s.outcome) {
            None => Err(""),
            Some(SamplingOutcome::Nothing(why)) => Err(why),
            Some(SamplingOutcome::Plot(_, plot)) => Ok(plot),
        }
    }

    /// Renders the plot with the cursor at the driver's position; `None` if there is no plot. All
    /// but the cursor is rendered once per style.
    pub(crate) fn render(&self, style: &PlotStyle, open_scene: &OpenScene) -> Option<Raster> {
        let plot = self.plot().ok()?;
        let mut canvas = self.sampled.as_ref()?.canvas.borrow_mut();
        let known = canvas.take().filter(|canvas| canvas.style() == style);
        let canvas = canvas.insert(known.unwrap_or_else(|| plot.canvas(style)));
        Some(plot.with_cursor(canvas, self.here(open_scene).as_ref()))
    }

    /// Adds the dotted curves of the compared scene, in the open scene's unit.
    fn compare(&mut self, compared: &ComparedScene, unit: &str, along: &PlotAxis) {
        let Some(Sampled { names, outcome, .. }) = &mut self.sampled else {
            return;
        };
        let (scene, solver) = (compared.scene(), compared.solver());
        let catalogue = Catalogue::new(scene);
        let known = |name: &String| catalogue.find(name).is_some();
        let has_it = match along {
            PlotAxis::Driver | PlotAxis::Time => true,
            PlotAxis::Figure(name) => known(name),
        };
        let names: Vec<String> = names.iter().filter(|name| known(name)).cloned().collect();
        if let (true, SamplingOutcome::Plot(_, plot), Ok(curves)) =
            (has_it, outcome, sampled(scene, solver, &names, along))
        {
            let other = Plot::of(&curves).in_unit(scene.unit.symbol(), unit, compared.scale());
            plot.compare(&other, compared.name());
        }
    }

    /// Returns the plotted values at the driver's current position. Unless time is on the x axis,
    /// rates are those at the scene's speed, as in the curves.
    pub(crate) fn here(&self, open_scene: &OpenScene) -> Option<StateValues> {
        let curves = self.curves()?;
        if open_scene.timetable().is_none() {
            return Some(curves.here(open_scene.state()));
        }
        if curves.abscissa != Abscissa::Time {
            return Some(curves.here(&open_scene.state_by_speed()));
        }
        let time = open_scene.time()?;
        Some(curves.here_at(time, open_scene.state()))
    }

    /// Returns `true` if the plotted rates are those of the scene's motion over time, if it has
    /// one.
    pub(crate) fn is_timed(&self) -> bool {
        let curves = self.curves();
        curves.is_none_or(|curves| curves.abscissa == Abscissa::Time)
    }

    /// Returns the reason why some of the curves are hidden, if any.
    pub(crate) fn hidden(&self) -> Option<String> {
        let curves = self.curves()?;
        let hidden = curves.hidden.as_ref()?;
        Some(hidden.text(&curves.driver.unit))
    }

    /// Returns the sampled curves; `None` if there are none.
    pub(crate) fn curves(&self) -> Option<&Curves> {
        match self.sampled.as_ref().map(|s| &s.outcome) {
            Some(SamplingOutcome::Plot(curves, _)) => Some(curves),
            Some(SamplingOutcome::Nothing(_)) | None => None,
        }
    }

    /// Returns the plot as an SVG document with the cursor at the driver's position; `None` if
    /// there is no plot.
    pub(crate) fn svg(&self, open_scene: &OpenScene) -> Option<String> {
        let plot = self.plot().ok()?;
        let here = self.here(open_scene);
        let title = &open_scene.scene().title();
        Some(plot.svg(title, PAPER, self.extrema, here.as_ref()))
    }

    /// Returns the plotted curves as CSV; `None` if there are none.
    pub(crate) fn csv(&self, dialect: CsvDialect) -> Option<String> {
        Some(curves_csv(self.curves()?, dialect))
    }
}

/// Adds the tolerance bands of all values except forces, if the scene has tolerances.
fn add_bands(plot: &mut Plot, curves: &Curves, open_scene: &OpenScene) {
    let (scene, solver) = (open_scene.scene(), open_scene.solver());
    let text = |(_, curve): &(usize, &Curve)| curve.quantity.order() != Order::Force;
    let curves_told = curves.curves.iter().enumerate().filter(text);
    let (places, quantities): (Vec<usize>, Vec<Quantity>) = curves_told
        .map(|(i, curve)| (i, curve.quantity.clone()))
        .unzip();
    let study = ToleranceStudy::new(scene, solver, scene.tolerances(), &quantities);
    // Without tolerances, or without a quantity that can have a band, the curves are drawn alone.
    let Ok(mut study) = study else { return };
    let (kind, bands) = study.quick_band(&curves.at);
    for ((index, quantity), offsets) in places.into_iter().zip(&quantities).zip(bands) {
        let name = format!("{} {}", quantity.name, kind.word());
        plot.add_band(curves, index, &offsets, name);
    }
}

/// The size of an SVG in its own units.
const PAPER: Vec2 = Vec2 { x: 800.0, y: 640.0 };

/// Samples the named quantities.
///
/// # Errors
/// Returns the reason why there are no curves.
fn sampled(
    scene: &Scene,
    solver: &Solver,
    names: &[String],
    along: &PlotAxis,
) -> Result<Curves, String> {
    let catalogue = Catalogue::new(scene);
    let find = |name: &String| catalogue.find(name);
    let mut quantities: Vec<Quantity> = names.iter().filter_map(find).collect();
    let abscissa = match along {
        PlotAxis::Driver => Abscissa::Driver,
        PlotAxis::Time => Abscissa::Time,
        PlotAxis::Figure(name) => {
            quantities.retain(|q| q.name != *name);
            find(name).map_or(Abscissa::Driver, Abscissa::Figure)
        }
    };
    if quantities.is_empty() {
        return Err(words().nothing_plotted().into());
    }
    let curves =
        Curves::new(scene, solver, &quantities, abscissa, None).map_err(|e| e.to_string())?;
    if curves
        .curves
        .iter()
        .all(|curve| curve.values.iter().all(Option::is_none))
    {
        let names: Vec<&str> = quantities.iter().map(|q| q.name.as_str()).collect();
        let hidden = curves.hidden.as_ref();
        let names = names.join(", ");
        return Err(match hidden {
            Some(hidden) => {
                let why = hidden.text(&curves.driver.unit);
                words().no_value_anywhere_because(&names, &why)
            }
            None => words().no_value_anywhere(&names),
        });
    }
    Ok(curves)
}

/// Maximum number of the scene's own quantities in a default plot.
const OWN: usize = 2;

/// Returns the quantities plotted by default. The scene's own ones come first; if it has none, the
/// angular rates of the last undriven link on the ground. Without such a link, the position and
/// rate of the last undriven slide there are plotted, and without a slide the velocity of the last
/// moving point.
fn usual(scene: &Scene) -> Vec<String> {
    let own = scene.figures.iter().take(OWN);
    let own: Vec<String> = own.map(|figure| figure.name.clone()).collect();
    if !own.is_empty() {
        return own;
    }
    let mechanism = &scene.mechanism;
    let catalogue = Catalogue::new(scene);
    let has = |name: &String| catalogue.all().iter().any(|q| q.name == *name);
    let named = |name: &str, aspects: [&str; 2]| -> Option<Vec<String>> {
        let names = aspects.map(|aspect| format!("{name}.{aspect}"));
        names.iter().all(has).then(|| names.to_vec())
    };
    let on_ground = |&link: &crate::LinkId| {
        let members = &mechanism.link(link).members;
        let grounded = |m: &crate::Member| mechanism.point(m.point).ground.is_some();
        !mechanism.is_directed(link) && members.iter().any(grounded)
    };
    let rocker = mechanism.link_ids().filter(on_ground).last();
    let rocker = rocker.and_then(|link| named(scene.link_name(link), ["omega", "alpha"]));
    let slide = || {
        let pushed = |&slide: &crate::SlideId| {
            !mechanism.is_pushed(slide) && mechanism.slide(slide).on == crate::Body::Ground
        };
        let slide = mechanism.slide_ids().filter(pushed).last()?;
        named(scene.slide_name(slide), ["length", "rate"])
    };
    let point = || {
        let moving = |&id: &crate::PointId| mechanism.point(id).ground.is_none();
        let points = mechanism.point_ids().filter(moving);
        let names = points.filter_map(|id| scene.point_name(id));
        named(names.last()?, ["vx", "vy"])
    };
    rocker.or_else(slide).or_else(point).unwrap_or_default()
}
