//! Computes the playback position at a time, along the driver coordinate or the time of its motion.
//!
//! Positions depend only on the wall clock, never on the number of drawn frames, so dropped frames
//! do not slow the motion down. The time is passed in, so that tests control it.

use std::time::Duration;

/// Seconds per sweep: a full turn, or the travel of a slide. The slowest pace comes first.
const PACES: [f64; 11] = [120.0, 60.0, 30.0, 20.0, 12.0, 8.0, 4.0, 2.0, 1.0, 0.5, 0.25];
/// Index of the initial pace: one turn in 4 s, independent of the driver's speed.
const OPENING_PACE: usize = 6;

/// The coordinate that playback varies: the driver's, or the time of its motion.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Track {
    /// The length of one sweep: a full turn, the travel of a slide, or a period.
    pub(crate) span: f64,
    /// The limits between which playback oscillates; `None` if it continues without limits.
    pub(crate) oscillation: Option<(f64, f64)>,
    /// The magnitude of the scene's own speed along the track, per second.
    pub(crate) speed: f64,
}

/// The state of playback: running or paused, its pace and its direction.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Playback {
    /// The start time and start position of the current motion; `None` while paused.
    started: Option<(Duration, f64)>,
    backwards: bool,
    pace: usize,
}

impl Playback {
    /// Creates a paused playback, forwards and at the default pace.
    pub(crate) fn new() -> Self {
        Playback {
            started: None,
            backwards: false,
            pace: OPENING_PACE,
        }
    }

    pub(crate) fn is_playing(&self) -> bool {
        self.started.is_some()
    }

    pub(crate) fn is_backwards(&self) -> bool {
        self.backwards
    }

    /// Returns the seconds per sweep.
    pub(crate) fn seconds(&self) -> f64 {
        PACES[self.pace]
    }

    /// Returns the ratio of the playback speed to the scene's speed; `None` if the latter is zero.
    pub(crate) fn ratio(&self, track: &Track) -> Option<f64> {
        let ratio = track.span / self.seconds() / track.speed;
        (ratio.is_finite() && ratio > 0.0).then_some(ratio)
    }

    /// Starts or restarts playback from `at`.
    pub(crate) fn play(&mut self, now: Duration, at: f64) {
        self.started = Some((now, at));
    }

    /// Pauses playback.
    pub(crate) fn pause(&mut self) {
        self.started = None;
    }

    /// Reverses the direction, and continues from `at` if playing.
    pub(crate) fn reverse(&mut self, now: Duration, at: f64) {
        self.backwards = !self.backwards;
        self.rebase(now, at);
    }

    /// Selects the next faster pace, if there is one.
    pub(crate) fn faster(&mut self, now: Duration, at: f64) {
        self.pace = (self.pace + 1).min(PACES.len() - 1);
        self.rebase(now, at);
    }

    /// Selects the next slower pace, if there is one.
    pub(crate) fn slower(&mut self, now: Duration, at: f64) {
        self.pace = self.pace.saturating_sub(1);
        self.rebase(now, at);
    }

    /// Continues from `at` if playing: after a jump, a change of pace, or a suspension.
    pub(crate) fn rebase(&mut self, now: Duration, at: f64) {
        if self.is_playing() {
            self.play(now, at);
        }
    }

    /// Returns the position on the track at `now`; `None` while paused. Reverses at the ends of a
    /// limited range.
    pub(crate) fn position(&mut self, now: Duration, track: &Track) -> Option<f64> {
        let (since, from) = self.started?;
        let passed = now.saturating_sub(since).as_secs_f64();
        let moved = passed * track.span / self.seconds();
        let Some((low, high)) = track.oscillation else {
            let signed = if self.backwards { -moved } else { moved };
            return Some(from + signed);
        };
        let span = high - low;
        if span <= 0.0 {
            return Some(from);
        }
        // Unrolled: 0 to `span` goes up the range, and `span` to `2 * span` goes down again.
        let up = (from - low).clamp(0.0, span);
        let phase = if self.backwards { 2.0 * span - up } else { up };
        let unrolled = (phase + moved) % (2.0 * span);
        self.backwards = unrolled >= span;
        let at = if self.backwards {
            low + (2.0 * span - unrolled)
        } else {
            low + unrolled
        };
        // Stores direction and phase together after a reversal.
        self.started = Some((now, at));
        Some(at)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::scene::{Scene, presets};
    use crate::solver::Solver;
    use crate::tui::player::driver_range::DriverRange;

    fn track(preset: &str) -> Track {
        let preset = presets::find(preset).unwrap();
        let scene = Scene::parse(preset.text, preset.name).unwrap();
        DriverRange::new(&scene, &Solver::new(&scene.mechanism).unwrap()).track()
    }

    fn seconds(s: f64) -> Duration {
        Duration::from_secs_f64(s)
    }

    #[test]
    fn turn_takes_four_seconds_at_any_driver_speed() {
        let (track, mut playback) = (track("four-bar"), Playback::new());
        assert_eq!(playback.position(seconds(9.0), &track), None);
        playback.play(seconds(10.0), 60.0);
        assert_eq!(playback.position(seconds(11.0), &track), Some(150.0));
        assert_eq!(playback.position(seconds(22.0), &track), Some(1140.0));
        // 15 rad/s is 859.4 deg/s; a turn in 4 s is 90 deg/s.
        let ratio = playback.ratio(&track).unwrap();
        assert!((1.0 / ratio - 9.549).abs() < 1e-3, "{ratio}");
    }

    #[test]
    fn changing_speed_or_direction_keeps_position() {
        let (track, mut playback) = (track("four-bar"), Playback::new());
        playback.play(seconds(0.0), 60.0);
        playback.faster(seconds(1.0), 150.0);
        assert_eq!(playback.position(seconds(1.0), &track), Some(150.0));
        assert_eq!(playback.position(seconds(2.0), &track), Some(330.0));
        playback.reverse(seconds(2.0), 330.0);
        assert_eq!(playback.position(seconds(2.5), &track), Some(240.0));
        // While paused, changing the speed does not start playback.
        playback.pause();
        playback.slower(seconds(3.0), 240.0);
        assert_eq!(playback.position(seconds(4.0), &track), None);
    }

    #[test]
    fn slide_sweeps_its_travel_back_and_forth() {
        let (track, mut playback) = (track("excavator-boom"), Playback::new());
        let (low, high) = track.oscillation.unwrap();
        let span = high - low;
        playback.play(seconds(0.0), low);
        for (time, share) in [
            (1.0, 0.25),
            (4.0, 1.0),
            (5.0, 0.75),
            (8.0, 0.0),
            (41.0, 0.25),
        ] {
            let at = playback.position(seconds(time), &track).unwrap();
            assert!(
                (at - (low + share * span)).abs() < 1e-9 * span,
                "{time} s: {at}"
            );
        }
        // Playback starts at the end and backwards, as after a step to the limit.
        playback.play(seconds(0.0), high);
        playback.reverse(seconds(0.0), high);
        let at = playback.position(seconds(1.0), &track).unwrap();
        assert!((at - (low + 0.75 * span)).abs() < 1e-9 * span, "{at}");
    }
}
