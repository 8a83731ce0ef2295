//! The candidates of a task: the running search, the list, and the motion of the candidate under
//! the cursor.

use super::curve_cursor::CurveWalk;
use super::display::ShownCandidate;
use crate::report::{CandidateRow, SynthesisReport};
use crate::synthesis::{
    Candidate, PosedDyad, SceneTitles, Synthesis, SynthesisSettings, scene_text,
};
use crate::tui::TaskOrder;
use crate::tui::commands::list::moved;
use crate::tui::document::job::{BackgroundJob, JobProgress};
use crate::{Vec2, angle, parallel};
use std::sync::Arc;
use std::time::Duration;

/// Playing time between two points of the task, in seconds; the next two limit the time of the
/// whole motion.
const PLAYING_TIME: f64 = 0.8;
const MIN_TRAVEL_TIME: f64 = 1.6;
const MAX_TRAVEL_TIME: f64 = 6.0;

/// The page of the candidates' view.
#[derive(Debug, Default)]
pub(crate) enum CandidatesPage {
    /// The list of all candidates.
    #[default]
    List,
    /// The candidate under the cursor alone, on a screen too small for both.
    Alone,
    /// The curves of pivots and their pins, for a task of four poses.
    Curves(Box<CurveWalk>),
}

/// The results of a search, as listed.
#[derive(Debug)]
pub(crate) struct FoundCandidates {
    pub(super) synthesis: Synthesis,
    rows: Vec<CandidateRow>,
    verdict: String,
    /// The reason why no linkage does the task.
    no_result_reason: String,
    /// The unit of the miss.
    miss_unit: &'static str,
    /// The possible pivots, curve by curve, for a task of four poses.
    pivots: Vec<Arc<[Vec2]>>,
    /// The positions of the pivots' pins at the first pose, for a task of four poses.
    pins: Vec<Arc<[Vec2]>>,
}

impl FoundCandidates {
    /// Searches for linkages, which may take long.
    pub(crate) fn search(order: &TaskOrder, progress: &JobProgress) -> FoundCandidates {
        let how = SynthesisSettings {
            seed: order.seed,
            threads: parallel::cores(),
        };
        let tell = &mut |part| progress.report(part);
        FoundCandidates::of(order, Synthesis::run(&order.file.task, how, tell))
    }

    fn of(order: &TaskOrder, synthesis: Synthesis) -> FoundCandidates {
        let curve = |place: fn(&PosedDyad) -> Option<Vec2>| {
            let pieces = synthesis.curves.iter();
            let pieces = pieces.map(|piece| piece.iter().filter_map(place).collect());
            pieces.collect()
        };
        let mut found = FoundCandidates {
            rows: Vec::new(),
            verdict: String::new(),
            no_result_reason: String::new(),
            miss_unit: "",
            pivots: curve(|dyad| dyad.held.pivot()),
            pins: curve(|dyad| Some(dyad.pin)),
            synthesis,
        };
        found.rebuild_texts(order);
        found
    }

    /// Writes all texts in the current language.
    pub(super) fn rebuild_texts(&mut self, order: &TaskOrder) {
        let found = &self.synthesis;
        let report = report_of(found, order);
        let all = found.good.iter().chain(&found.defective);
        self.rows = all.map(|candidate| report.row(candidate)).collect();
        (self.verdict, self.miss_unit) = (report.verdict(), report.miss_unit());
        self.no_result_reason = report.nothing();
    }

    /// Returns the report on all candidates that do the task.
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
    pub(crate) job: BackgroundJob<FoundCandidates>,
    /// Index of the selected candidate; defective ones follow the others.
    pub(super) cursor: usize,
    pub(super) page: CandidatesPage,
    way: CandidatePlayback,
    /// The drawn candidate; `None` if it must still be built.
    shown: Option<ShownCandidate>,
    /// Serial number of the scene last opened from this list.
    pub(crate) taken: Option<usize>,
}

impl CandidateList {
    /// Creates the list of a task whose search has just started.
    pub(crate) fn new(order: TaskOrder, job: BackgroundJob<FoundCandidates>) -> CandidateList {
        CandidateList {
            order,
            job,
            cursor: 0,
            page: CandidatesPage::default(),
            way: CandidatePlayback::default(),
            shown: None,
            taken: None,
        }
    }

    pub(crate) fn order(&self) -> &TaskOrder {
        &self.order
    }

    pub(super) fn found(&self) -> Option<&FoundCandidates> {
        self.job.result.as_ref()
    }

    /// Writes all texts again after a change of the language.
    pub(crate) fn rebuild_texts(&mut self) {
        if let Some(found) = &mut self.job.result {
            found.rebuild_texts(&self.order);
        }
    }

    /// Returns the search's progress in percent; `None` if it is complete.
    pub(crate) fn percent(&self) -> Option<u32> {
        self.job.percent()
    }

    /// Returns the numbers of candidates that do the task and of defective ones.
    pub(crate) fn count(&self) -> (usize, usize) {
        let found = self.found().map(|found| &found.synthesis);
        found.map_or((0, 0), |found| (found.good.len(), found.defective.len()))
    }

    /// Returns the rows; defective candidates follow the others.
    pub(crate) fn rows(&self) -> &[CandidateRow] {
        self.found().map_or(&[], |found| &found.rows)
    }

    /// Returns the sentence that says how many linkages were found and whether there may be others.
    pub(crate) fn verdict(&self) -> &str {
        self.found().map_or("", |found| &found.verdict)
    }

    /// Returns the reason why no linkage does the task.
    pub(crate) fn nothing(&self) -> &str {
        self.found().map_or("", |found| &found.no_result_reason)
    }

    /// Returns the unit of the miss.
    pub(crate) fn miss_unit(&self) -> &'static str {
        self.found().map_or("", |found| found.miss_unit)
    }

    /// Yields the curves of possible pivots of four poses and, while the motion is at its first
    /// point, those of the pins.
    pub(crate) fn curves(&self) -> impl Iterator<Item = &Arc<[Vec2]>> {
        let found = self.found().into_iter();
        let at_first = self.way.place == 0.0;
        found.flat_map(move |found| {
            let pins = found.pins.iter().filter(move |_| at_first);
            found.pivots.iter().chain(pins)
        })
    }

    pub(crate) fn cursor(&self) -> usize {
        self.cursor
    }

    /// Moves the cursor by `rows` candidates within the list. A newly selected candidate starts at
    /// its first point.
    pub(crate) fn move_by(&mut self, rows: isize) {
        let cursor = moved(self.cursor, rows, self.rows().len());
        if cursor != self.cursor {
            self.cursor = cursor;
            self.change_drawing();
        }
    }

    /// Discards the drawing and rewinds the motion to the first point.
    pub(super) fn change_drawing(&mut self) {
        self.shown = None;
        self.way.rewind();
    }

    /// Returns the current page.
    pub(crate) fn page(&self) -> &CandidatesPage {
        &self.page
    }

    /// Returns the candidate under the cursor, or the one built on the curves, with its row.
    pub(crate) fn chosen(&self) -> Option<(&Candidate, &CandidateRow)> {
        if let CandidatesPage::Curves(walk) = &self.page {
            return walk.linkage();
        }
        let found = self.found()?;
        let Synthesis {
            good, defective, ..
        } = &found.synthesis;
        let candidate = good.iter().chain(defective).nth(self.cursor)?;
        Some((candidate, found.rows.get(self.cursor)?))
    }

    /// Returns the text and the name of a scene of the candidate under the cursor; `None` if it
    /// does not do the task.
    pub(crate) fn scene(&self) -> Option<(String, String)> {
        let found = self.found()?;
        let candidate = found.synthesis.good.get(self.cursor)?;
        let report = found.report(&self.order);
        let number = self.cursor + 1;
        let titles = report.titles(number, candidate, self.order.tolerance);
        let text = scene_text(&candidate.proposal, &self.order.file.task, &titles)?;
        Some((text, format!("{}-{number}", self.order.name)))
    }

    // ---- its motion

    /// Returns the drawn candidate, if it could be built.
    pub(crate) fn shown(&self) -> Option<&ShownCandidate> {
        self.shown.as_ref().filter(|_| self.chosen().is_some())
    }

    /// Returns the number of the nearest point of the task, counted from 1, the number of points,
    /// and the crank's angle in degrees.
    pub(crate) fn nearest_point(&self) -> Option<(usize, usize, f64)> {
        let (candidate, _) = self.chosen()?;
        let at = self.crank(&candidate.at)?;
        let point = self.way.place.round() as usize + 1;
        Some((point, candidate.at.len(), at.rem_euclid(angle::TURN)))
    }

    pub(crate) fn is_playing(&self) -> bool {
        self.way.since.is_some()
    }

    /// Starts or pauses the motion, which plays forwards and backwards.
    pub(crate) fn toggle(&mut self, now: Duration) {
        self.way.since = match self.way.since {
            Some(_) => None,
            None => (self.stretches() > 0).then_some(now),
        };
    }

    /// Moves to the next or the previous point of the task.
    pub(crate) fn step(&mut self, forward: bool) {
        let maximum = self.stretches() as f64;
        self.way.step(forward, maximum);
    }

    /// Advances the motion to the time `now`.
    pub(crate) fn follow(&mut self, now: Duration) {
        let maximum = self.stretches();
        self.way.follow(now, maximum);
    }

    /// Sets the motion's clock to `now` without advancing it.
    pub(crate) fn rebase(&mut self, now: Duration) {
        self.way.since = self.way.since.map(|_| now);
    }

    /// Builds the selected candidate if it has changed, and solves its current position.
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

    /// Returns the number of intervals between the task's points.
    fn stretches(&self) -> usize {
        let points = self.chosen().map_or(0, |(c, _)| c.at.len());
        points.saturating_sub(1)
    }

    /// Returns the current angle of the crank in degrees, interpolated between its angles `at` at
    /// the task's points.
    fn crank(&self, at: &[f64]) -> Option<f64> {
        let from = self.way.place.floor();
        let before = *at.get(from as usize)?;
        let after = at.get(from as usize + 1).copied().unwrap_or(before);
        Some(before + (after - before) * (self.way.place - from))
    }
}

/// The state of a candidate's playback.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
struct CandidatePlayback {
    /// The position in the motion: 0 at the first point, 1 at the second.
    place: f64,
    is_back: bool,
    /// The time of the last advance; `None` if paused.
    since: Option<Duration>,
}

impl CandidatePlayback {
    /// Rewinds to the first point; a running playback continues from there.
    fn rewind(&mut self) {
        (self.place, self.is_back) = (0.0, false);
    }

    fn step(&mut self, forward: bool, maximum: f64) {
        self.since = None;
        self.is_back = !forward;
        self.place = match forward {
            true => (self.place.floor() + 1.0).min(maximum),
            false => (self.place.ceil() - 1.0).max(0.0),
        };
    }

    /// Advances the playback, forwards and backwards over `stretches` intervals.
    fn follow(&mut self, now: Duration, stretches: usize) {
        let Some(since) = self.since.filter(|_| stretches > 0) else {
            return;
        };
        let maximum = stretches as f64;
        let complete = (maximum * PLAYING_TIME).clamp(MIN_TRAVEL_TIME, MAX_TRAVEL_TIME);
        let by = now.saturating_sub(since).as_secs_f64() * maximum / complete;
        // One round goes to the end and back.
        let before = if self.is_back {
            2.0 * maximum - self.place
        } else {
            self.place
        };
        let round = (before + by).rem_euclid(2.0 * maximum);
        self.is_back = round > maximum;
        self.place = if self.is_back {
            2.0 * maximum - round
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
    fn path_is_played_back_and_forth() {
        let mut way = CandidatePlayback {
            since: Some(Duration::ZERO),
            ..CandidatePlayback::default()
        };
        // Two sections take 1.6 s.
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
