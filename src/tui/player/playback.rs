//! Slow motion: how far the driver is at what time, along its coordinate or along the time of its own motion.
//!
//! Positions follow from the wall clock alone, never from how many frames were drawn: a slow line
//! drops frames, not truth. Time comes in from outside, so a test can let it pass.

use std::time::Duration;

/// Seconds that a sweep takes: a turn, or the travel of a slide. Slower to the left.
const PACES: [f64; 11] = [120.0, 60.0, 30.0, 20.0, 12.0, 8.0, 4.0, 2.0, 1.0, 0.5, 0.25];
/// One turn in 4 s, whatever the driver's speed.
const OPENING_PACE: usize = 6;

/// What playing goes along: the driver's coordinate, or the time of its motion.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Track {
    /// What is covered in one sweep: a turn, the travel of a slide, or a period.
    pub(crate) span: f64,
    /// Between where and where it goes to and fro; `None` if it goes on for ever.
    pub(crate) shuttle: Option<(f64, f64)>,
    /// How fast the scene goes along it, per second, without its sign.
    pub(crate) speed: f64,
}

/// Whether, how fast and which way the driver moves on the screen.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Playback {
    /// When and where the motion that is going on began; `None` while paused.
    begun: Option<(Duration, f64)>,
    backwards: bool,
    pace: usize,
}

impl Playback {
    /// Paused, forwards, at the usual pace.
    pub(crate) fn new() -> Self {
        Playback {
            begun: None,
            backwards: false,
            pace: OPENING_PACE,
        }
    }

    pub(crate) fn is_playing(&self) -> bool {
        self.begun.is_some()
    }

    pub(crate) fn is_backwards(&self) -> bool {
        self.backwards
    }

    /// Seconds that a sweep takes.
    pub(crate) fn seconds(&self) -> f64 {
        PACES[self.pace]
    }

    /// How much faster than in the scene the driver moves; `None` if it stands still there.
    pub(crate) fn ratio(&self, track: &Track) -> Option<f64> {
        let ratio = track.span / self.seconds() / track.speed;
        (ratio.is_finite() && ratio > 0.0).then_some(ratio)
    }

    /// Begins to play, or begins anew, from `at`.
    pub(crate) fn play(&mut self, now: Duration, at: f64) {
        self.begun = Some((now, at));
    }

    /// Stops, wherever that is.
    pub(crate) fn pause(&mut self) {
        self.begun = None;
    }

    /// Turns round; `at` and `now` matter while playing.
    pub(crate) fn reverse(&mut self, now: Duration, at: f64) {
        self.backwards = !self.backwards;
        self.rebase(now, at);
    }

    /// The next faster pace, if there is one.
    pub(crate) fn faster(&mut self, now: Duration, at: f64) {
        self.pace = (self.pace + 1).min(PACES.len() - 1);
        self.rebase(now, at);
    }

    /// The next slower pace, if there is one.
    pub(crate) fn slower(&mut self, now: Duration, at: f64) {
        self.pace = self.pace.saturating_sub(1);
        self.rebase(now, at);
    }

    /// Goes on from `at`, if it is playing: after a jump, a change of pace, or a stopped program.
    pub(crate) fn rebase(&mut self, now: Duration, at: f64) {
        if self.is_playing() {
            self.play(now, at);
        }
    }

    /// Where on the track it is `now`; `None` while paused. Turns round at the ends of a limited range.
    pub(crate) fn position(&mut self, now: Duration, track: &Track) -> Option<f64> {
        let (since, from) = self.begun?;
        let passed = now.saturating_sub(since).as_secs_f64();
        let moved = passed * track.span / self.seconds();
        let Some((low, high)) = track.shuttle else {
            let signed = if self.backwards { -moved } else { moved };
            return Some(from + signed);
        };
        let span = high - low;
        if span <= 0.0 {
            return Some(from);
        }
        // Unrolled: up the range is 0 to span, down again is span to twice the span.
        let up = (from - low).clamp(0.0, span);
        let phase = if self.backwards { 2.0 * span - up } else { up };
        let unrolled = (phase + moved) % (2.0 * span);
        self.backwards = unrolled >= span;
        let at = if self.backwards {
            low + (2.0 * span - unrolled)
        } else {
            low + unrolled
        };
        // Keeps the direction and the phase together once it has turned round.
        self.begun = Some((now, at));
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
    fn a_turn_takes_four_seconds_whatever_the_drivers_speed() {
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
    fn a_change_of_pace_or_direction_does_not_jump() {
        let (track, mut playback) = (track("four-bar"), Playback::new());
        playback.play(seconds(0.0), 60.0);
        playback.faster(seconds(1.0), 150.0);
        assert_eq!(playback.position(seconds(1.0), &track), Some(150.0));
        assert_eq!(playback.position(seconds(2.0), &track), Some(330.0));
        playback.reverse(seconds(2.0), 330.0);
        assert_eq!(playback.position(seconds(2.5), &track), Some(240.0));
        // Paused: nothing begins by itself.
        playback.pause();
        playback.slower(seconds(3.0), 240.0);
        assert_eq!(playback.position(seconds(4.0), &track), None);
    }

    #[test]
    fn a_slide_sweeps_its_travel_to_and_fro() {
        let (track, mut playback) = (track("excavator-boom"), Playback::new());
        let (low, high) = track.shuttle.unwrap();
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
        // Begun at the end and backwards, as after a step to the limit.
        playback.play(seconds(0.0), high);
        playback.reverse(seconds(0.0), high);
        let at = playback.position(seconds(1.0), &track).unwrap();
        assert!((at - (low + 0.75 * span)).abs() < 1e-9 * span, "{at}");
    }
}
