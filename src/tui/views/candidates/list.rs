//! The candidates of a task: being looked for, then in a list, the one under the cursor on its way.

use super::shown::ShownCandidate;
use super::walk::CurveWalk;
use crate::report::{CandidateRow, SynthesisReport};
use crate::synthesis::{
    Candidate, Partner, PosedDyad, SceneTitles, Synthesis, SynthesisOrder, scene_text,
};
use crate::tui::TaskOrder;
use crate::tui::document::search_progress::SearchProgress;
use crate::{Vec2, angle, parallel};
use std::sync::Arc;
use std::time::Duration;

/// How long the way from point to point takes while it is played, in seconds; and the shortest and longest whole way.
const STRETCH: f64 = 0.8;
const SHORTEST_WAY: f64 = 1.6;
const LONGEST_WAY: f64 = 6.0;

/// A search, as both who searches and who waits see it.
#[derive(Debug, Default)]
pub(crate) struct TaskSearch {
    progress: SearchProgress,
}

impl TaskSearch {
    /// Looks for linkages, which may take long.
    pub(crate) fn run(&self, order: &TaskOrder) -> FoundCandidates {
        let threads = parallel::cores();
        let how = SynthesisOrder {
            seed: order.seed,
            threads,
        };
        let tell = &mut |part| self.progress.tell(part);
        let synthesis = Synthesis::run(&order.file.task, how, tell);
        FoundCandidates::of(order, synthesis)
    }
}

/// What is looked at of the candidates.
#[derive(Debug, Default)]
pub(crate) enum CandidatesPage {
    /// All of them.
    #[default]
    List,
    /// The one under the cursor alone, where there is no room for both.
    Alone,
    /// Of four poses the curves of pivots and their pins.
    Curves(Box<CurveWalk>),
}

/// What a search has found, as it is listed.
#[derive(Debug)]
pub(crate) struct FoundCandidates {
    pub(super) synthesis: Synthesis,
    rows: Vec<CandidateRow>,
    verdict: String,
    /// That nothing does the task, and why.
    nothing: String,
    /// The unit of what is missed.
    miss_unit: &'static str,
    /// Of four poses, where pivots may stand.
    pivots: Vec<Arc<[Vec2]>>,
    /// And where their pins lie at the first point.
    pins: Vec<Arc<[Vec2]>>,
}

impl FoundCandidates {
    fn of(order: &TaskOrder, synthesis: Synthesis) -> FoundCandidates {
        let curve = |place: fn(&PosedDyad) -> Option<Vec2>| {
            let pieces = synthesis.curves.iter();
            let pieces = pieces.map(|piece| piece.iter().filter_map(place).collect());
            pieces.collect()
        };
        let pivot = |dyad: &PosedDyad| match dyad.held {
            Partner::Rocker(pivot) => Some(pivot),
            Partner::Slide(_) => None,
        };
        let mut found = FoundCandidates {
            rows: Vec::new(),
            verdict: String::new(),
            nothing: String::new(),
            miss_unit: "",
            pivots: curve(pivot),
            pins: curve(|dyad| Some(dyad.pin)),
            synthesis,
        };
        found.say(order);
        found
    }

    /// Says what it is in the language that is spoken.
    pub(super) fn say(&mut self, order: &TaskOrder) {
        let found = &self.synthesis;
        let report = report_of(found, order);
        let all = found.good.iter().chain(&found.defective);
        self.rows = all.map(|candidate| report.row(candidate)).collect();
        (self.verdict, self.miss_unit) = (report.verdict(), report.miss_unit());
        self.nothing = report.nothing();
    }

    /// All that does the task is told.
    pub(super) fn report<'a>(&'a self, order: &'a TaskOrder) -> SynthesisReport<'a> {
        report_of(&self.synthesis, order)
    }
}

fn report_of<'a>(found: &'a Synthesis, order: &'a TaskOrder) -> SynthesisReport<'a> {
    SynthesisReport {
        file: &order.file,
        found,
        top: found.good.len(),
    }
}

/// The candidates of a task.
#[derive(Debug)]
pub(crate) struct CandidateList {
    pub(super) order: TaskOrder,
    search: Arc<TaskSearch>,
    pub(super) found: Option<FoundCandidates>,
    /// Which candidate it is on, the defective ones behind the others.
    pub(super) cursor: usize,
    pub(super) page: CandidatesPage,
    way: WayPlayed,
    /// What is drawn; `None` where that is still to be built.
    shown: Option<ShownCandidate>,
    /// As which of the scenes that were shown one was taken last.
    pub(crate) taken: Option<usize>,
}

impl CandidateList {
    /// Of a task whose linkages are still to be looked for.
    pub(crate) fn new(order: TaskOrder) -> CandidateList {
        CandidateList {
            order,
            search: Arc::default(),
            found: None,
            cursor: 0,
            page: CandidatesPage::default(),
            way: WayPlayed::default(),
            shown: None,
            taken: None,
        }
    }

    pub(crate) fn order(&self) -> &TaskOrder {
        &self.order
    }

    pub(crate) fn search(&self) -> &Arc<TaskSearch> {
        &self.search
    }

    /// The search has come to its end.
    pub(crate) fn take(&mut self, found: FoundCandidates) {
        self.found = Some(found);
    }

    /// Another language is spoken.
    pub(crate) fn say_again(&mut self) {
        if let Some(found) = &mut self.found {
            found.say(&self.order);
        }
    }

    /// Nobody waits for what is still looked for.
    pub(crate) fn leave(&self) {
        self.search.progress.leave();
    }

    /// What of the search is done, in percent; `None` where it has come to its end.
    pub(crate) fn percent(&self) -> Option<u32> {
        let progress = &self.search.progress;
        self.found.is_none().then(|| progress.percent())
    }

    /// How many do the task, and how many do not.
    pub(crate) fn count(&self) -> (usize, usize) {
        let found = self.found.as_ref().map(|found| &found.synthesis);
        found.map_or((0, 0), |found| (found.good.len(), found.defective.len()))
    }

    /// The rows, the defective ones behind the others.
    pub(crate) fn rows(&self) -> &[CandidateRow] {
        self.found.as_ref().map_or(&[], |found| &found.rows)
    }

    /// How many were found, and whether there are others.
    pub(crate) fn verdict(&self) -> &str {
        self.found.as_ref().map_or("", |found| &found.verdict)
    }

    /// That nothing does the task, and why.
    pub(crate) fn nothing(&self) -> &str {
        self.found.as_ref().map_or("", |found| &found.nothing)
    }

    /// The unit of what is missed.
    pub(crate) fn miss_unit(&self) -> &'static str {
        self.found.as_ref().map_or("", |found| found.miss_unit)
    }

    /// Where pivots and pins may be, of four poses.
    pub(crate) fn curves(&self) -> impl Iterator<Item = &Arc<[Vec2]>> {
        let found = self.found.iter();
        let at_first = self.way.place == 0.0;
        found.flat_map(move |found| {
            let pins = found.pins.iter().filter(move |_| at_first);
            found.pivots.iter().chain(pins)
        })
    }

    pub(crate) fn cursor(&self) -> usize {
        self.cursor
    }

    /// Moves the cursor by so many candidates, as far as there are any; the next one begins at its first point.
    pub(crate) fn move_by(&mut self, rows: isize) {
        let most = self.rows().len().saturating_sub(1);
        let cursor = self.cursor.saturating_add_signed(rows).min(most);
        if cursor != self.cursor {
            self.cursor = cursor;
            self.change_drawing();
        }
    }

    /// Another linkage is drawn, from its first point on.
    pub(super) fn change_drawing(&mut self) {
        self.shown = None;
        self.way.rewind();
    }

    /// What is looked at.
    pub(crate) fn page(&self) -> &CandidatesPage {
        &self.page
    }

    /// The candidate under the cursor, or the one that is being made on the curves, and its row.
    pub(crate) fn chosen(&self) -> Option<(&Candidate, &CandidateRow)> {
        if let CandidatesPage::Curves(walk) = &self.page {
            return walk.linkage();
        }
        let found = self.found.as_ref()?;
        let Synthesis {
            good, defective, ..
        } = &found.synthesis;
        let candidate = good.iter().chain(defective).nth(self.cursor)?;
        Some((candidate, found.rows.get(self.cursor)?))
    }

    /// The one under the cursor as a scene, and what it is called; `None` where it does not do the task.
    pub(crate) fn scene(&self) -> Option<(String, String)> {
        let found = self.found.as_ref()?;
        let candidate = found.synthesis.good.get(self.cursor)?;
        let report = found.report(&self.order);
        let number = self.cursor + 1;
        let titles = report.titles(number, candidate, self.order.tolerance);
        let text = scene_text(&candidate.proposal, &self.order.file.task, &titles)?;
        Some((text, format!("{}-{number}", self.order.name)))
    }

    // ---- on its way

    /// As far as it can be shown.
    pub(crate) fn shown(&self) -> Option<&ShownCandidate> {
        self.shown.as_ref().filter(|_| self.chosen().is_some())
    }

    /// The point of the task that it is at or nearest to, from 1, of how many; and the crank's angle there in degrees.
    pub(crate) fn stand(&self) -> Option<(usize, usize, f64)> {
        let (candidate, _) = self.chosen()?;
        let at = self.crank(&candidate.at)?;
        let point = self.way.place.round() as usize + 1;
        Some((point, candidate.at.len(), at.rem_euclid(angle::TURN)))
    }

    pub(crate) fn is_playing(&self) -> bool {
        self.way.since.is_some()
    }

    /// Plays the way to and fro, or stops.
    pub(crate) fn toggle(&mut self, now: Duration) {
        self.way.since = match self.way.since {
            Some(_) => None,
            None => (self.stretches() > 0).then_some(now),
        };
    }

    /// Goes to the next point of the task, or to the one before.
    pub(crate) fn step(&mut self, forward: bool) {
        let most = self.stretches() as f64;
        self.way.step(forward, most);
    }

    /// Time has passed.
    pub(crate) fn follow(&mut self, now: Duration) {
        let most = self.stretches();
        self.way.follow(now, most);
    }

    /// It is `now`, but the time since has not been seen.
    pub(crate) fn rebase(&mut self, now: Duration) {
        self.way.since = self.way.since.map(|_| now);
    }

    /// Builds and solves what is drawn, where that is another than before.
    pub(crate) fn draw(&mut self) {
        let Some((candidate, _)) = self.chosen() else {
            return;
        };
        let at = self.crank(&candidate.at);
        if self.shown().is_none() {
            let titles = SceneTitles {
                unit: self.order.file.unit.symbol().to_owned(),
                ..SceneTitles::default()
            };
            let text = scene_text(&candidate.proposal, &self.order.file.task, &titles);
            let shown = text.and_then(|text| ShownCandidate::of(&text, &candidate.at));
            self.shown = shown;
        }
        if let (Some(shown), Some(at)) = (&mut self.shown, at) {
            shown.turn_to(at);
        }
    }

    /// From how many points of the task it goes on to the next.
    fn stretches(&self) -> usize {
        let points = self.chosen().map_or(0, |(c, _)| c.at.len());
        points.saturating_sub(1)
    }

    /// The crank's angle now, in degrees, by its angles at the points.
    fn crank(&self, at: &[f64]) -> Option<f64> {
        let from = self.way.place.floor();
        let before = *at.get(from as usize)?;
        let behind = at.get(from as usize + 1).copied().unwrap_or(before);
        Some(before + (behind - before) * (self.way.place - from))
    }
}

/// Where on its way a candidate is.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
struct WayPlayed {
    /// 0 at the first point, 1 at the second.
    place: f64,
    is_back: bool,
    /// Until when it was played; `None` where it stands.
    since: Option<Duration>,
}

impl WayPlayed {
    /// To the first point; what is played goes on from there.
    fn rewind(&mut self) {
        (self.place, self.is_back) = (0.0, false);
    }

    fn step(&mut self, forward: bool, most: f64) {
        self.since = None;
        self.is_back = !forward;
        self.place = match forward {
            true => (self.place.floor() + 1.0).min(most),
            false => (self.place.ceil() - 1.0).max(0.0),
        };
    }

    /// To and fro over so many stretches.
    fn follow(&mut self, now: Duration, stretches: usize) {
        let Some(since) = self.since.filter(|_| stretches > 0) else {
            return;
        };
        let most = stretches as f64;
        let whole = (most * STRETCH).clamp(SHORTEST_WAY, LONGEST_WAY);
        let by = now.saturating_sub(since).as_secs_f64() * most / whole;
        // There and back is one round.
        let before = if self.is_back {
            2.0 * most - self.place
        } else {
            self.place
        };
        let round = (before + by).rem_euclid(2.0 * most);
        self.is_back = round > most;
        self.place = if self.is_back {
            2.0 * most - round
        } else {
            round
        };
        self.since = Some(now);
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_way_is_played_to_and_fro() {
        let mut way = WayPlayed {
            since: Some(Duration::ZERO),
            ..WayPlayed::default()
        };
        // Two stretches take 1.6 s.
        for (milliseconds, place) in [
            (800, 1.0),
            (1200, 1.5),
            (2000, 1.5),
            (3200, 0.0),
            (4000, 1.0),
        ] {
            way.follow(Duration::from_millis(milliseconds), 2);
            assert!((way.place - place).abs() < 1e-9, "{milliseconds}: {way:?}");
        }
        way.step(true, 2.0);
        assert_eq!((way.place, way.since), (2.0, None));
        way.step(true, 2.0);
        assert_eq!(way.place, 2.0);
        way.place = 1.25;
        way.step(false, 2.0);
        assert_eq!(way.place, 1.0);
        way.follow(Duration::from_secs(9), 2);
        assert_eq!(way.place, 1.0, "it stands");
    }
}
