//! Limits the rate and length of frames to the capacity of the line.
//!
//! The kernel does not report the capacity: a pseudo-terminal buffers 19 kB before it stops being
//! writable, which is 20 s on a line of 9,600 baud. The terminal itself reveals it: each frame is
//! followed by a status query, which the terminal answers once the frame is drawn. Until then no
//! other frame is sent. So at most one frame is in flight, and the time to its answer determines
//! the length of the next one.
//!
//! The first frame is short, to distinguish slow lines from fast ones before a whole screen is
//! sent. Its answer is not awaited long: a terminal that does not answer gets whole frames at a
//! fixed pace. The speed of a real serial line is known.

use std::time::{Duration, Instant};

/// Device status report: every terminal since the VT100 answers with [`ANSWER`].
pub(super) const QUESTION: &[u8] = b"\x1b[5n";
/// The answer that reports no malfunction.
pub(super) const ANSWER: &[u8] = b"\x1b[0n";

/// Time on the line for one frame. A key waits at most for the frame in flight, and then as long
/// again for its own first line.
const FRAME: Duration = Duration::from_millis(250);
/// Length of the first frame in bytes: the last line and the title, an eighth of a second at 9,600
/// baud.
const PROBE: usize = 128;
/// Minimum length limit of a frame in bytes, even on the slowest line.
const MIN_VALUE: f64 = 64.0;
/// Maximum wait for the first answer: twice its duration at 9,600 baud.
const FIRST_TIMEOUT: Duration = Duration::from_millis(400);
/// Pause between frames while it is unknown whether the terminal answers.
const UNKNOWN_TERMINAL_PAUSE: Duration = Duration::from_millis(200);
/// Pause between frames for a terminal that does not answer.
const MUTE: Duration = Duration::from_millis(100);
/// Time without an answer after which the terminal counts as mute. An abandoned answer may still
/// arrive.
const PATIENCE: Duration = Duration::from_secs(4);
/// Factor over the expected time after which an answer counts as lost, because of typed input or
/// line noise.
const LOST_ANSWER_FACTOR: f64 = 4.0;
/// Minimum wait for an answer, because a terminal may be briefly busy even on a fast line.
const MIN_TIMEOUT: Duration = Duration::from_millis(200);
/// Maximum wait for a lost answer, whatever rate was measured while the machine was busy.
const MAX_TIMEOUT: Duration = Duration::from_secs(1);
/// Number of consecutive lost answers after which no more queries are sent.
const MAX_LOST: u32 = 3;
/// Maximum age of an answer for measuring the line. A later one may belong to another query or to
/// none.
const MAX_TRAVEL_TIME: Duration = Duration::from_secs(2);
/// Maximum wait for an answer at exit, because the shell would take it for typed text.
const EXIT_ANSWER_TIMEOUT: Duration = Duration::from_millis(800);

/// Minimum time of an answer in seconds; shorter times say nothing about the line.
const MIN_ANSWER_TIME: f64 = 0.001;
/// Minimum lateness of an answer, in seconds, to assume a slower line.
const MIN_LATENESS: f64 = 0.125;
/// Minimum excess length over the shortest frame, in bytes, to compute the rate from the
/// difference.
const LONGER: f64 = 64.0;

/// Maximum rate in bytes per second: enough for any screen, while a line that becomes slow is
/// noticed soon.
const MAX_BYTE_RATE: f64 = 1e6;
/// Factor over the quickest answer up to which an answer is punctual.
const PUNCTUAL_FACTOR: f64 = 1.1;
/// Tolerance of the expected time, as a share of it and in seconds, within which an answer belongs
/// to the last query and not to an abandoned one.
const PUNCTUAL_SHARE: f64 = 0.25;
const PUNCTUAL_TIME: f64 = 0.005;
/// Fraction of the maximum length from which a frame counts as full.
const FILLED: f64 = 0.8;

/// The terminal's behaviour as known so far.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum TerminalBehaviour {
    /// No query has been sent or answered yet.
    Unknown,
    /// The terminal answers.
    Answers,
    /// The terminal does not answer.
    Mute,
}

/// A frame in flight.
#[derive(Clone, Copy, Debug)]
struct FrameInFlight {
    at: Instant,
    bytes: usize,
    /// `true` if the answer measures the line: all bytes were sent together and no older answer is
    /// pending. Other output sent before may already be drawn.
    is_whole: bool,
}

/// Decides when the next frame may be sent, its maximum length, and whether to send a query after
/// it.
#[derive(Debug)]
pub(super) struct RateLimit {
    manner: TerminalBehaviour,
    /// The frame whose answer is pending.
    asked: Option<FrameInFlight>,
    last: Option<Instant>,
    /// The time of the last answer.
    drawn: Option<Instant>,
    /// The bytes sent since the last query, and whether they include output outside frames.
    bytes_since_query: usize,
    has_other_output: bool,
    /// The number of answers lost since the last one that arrived in time.
    lost: u32,
    /// The oldest abandoned query, whose answer may still arrive, and the number of such queries.
    late: Option<FrameInFlight>,
    abandoned: u32,
    /// The time until which an answer may belong to an abandoned query and so does not measure the
    /// line.
    doubtful_until: Option<Instant>,
    /// The time until which no frame is sent, so that abandoned answers arrive before the next query.
    silent_until: Option<Instant>,
    rate: LineRate,
}

/// The rate of the line in bytes per second: the measured one, but at most the configured one.
#[derive(Clone, Copy, Debug)]
struct LineRate {
    set: Option<f64>,
    measured: Option<f64>,
    /// The quickest answer so far: bytes and seconds. Most of the time is the round trip.
    quickest_answer: Option<(f64, f64)>,
}

impl RateLimit {
    /// Creates a limit for an unknown terminal. `set` is the configured speed of its line in bytes
    /// per second, if known.
    pub(super) fn new(set: Option<f64>) -> Self {
        RateLimit {
            manner: TerminalBehaviour::Unknown,
            asked: None,
            last: None,
            drawn: None,
            bytes_since_query: 0,
            has_other_output: false,
            lost: 0,
            late: None,
            abandoned: 0,
            doubtful_until: None,
            silent_until: None,
            rate: LineRate {
                set,
                measured: None,
                quickest_answer: None,
            },
        }
    }

    /// Records a frame of a number of bytes sent at `now`. Returns `true` if a query should follow
    /// it.
    pub(super) fn send(&mut self, bytes: usize, now: Instant) -> bool {
        self.give_up(now);
        if self.silent_until.take().is_some_and(|until| until <= now) {
            // What has not arrived by now is lost.
            (self.abandoned, self.doubtful_until) = (0, None);
        }
        self.last = Some(now);
        self.bytes_since_query = self.bytes_since_query.saturating_add(bytes);
        let ask = self.manner != TerminalBehaviour::Mute && self.asked.is_none();
        if ask {
            let bytes = std::mem::take(&mut self.bytes_since_query) + QUESTION.len();
            let is_doubtful = self.doubtful_until.is_some();
            let is_whole = !std::mem::take(&mut self.has_other_output) && !is_doubtful;
            self.asked = Some(FrameInFlight {
                at: now,
                bytes,
                is_whole,
            });
        }
        ask
    }

    /// Returns `true` if the terminal is known to answer queries.
    pub(super) fn is_answered(&self) -> bool {
        self.manner == TerminalBehaviour::Answers
    }

    /// Records bytes sent outside frames.
    pub(super) fn record_sent(&mut self, bytes: usize) {
        self.has_other_output = true;
        self.bytes_since_query = self.bytes_since_query.saturating_add(bytes);
    }

    /// Records an answer at `now`, which may be late.
    pub(super) fn answered(&mut self, now: Instant) {
        self.manner = TerminalBehaviour::Answers;
        self.drawn = Some(now);
        let late = self.late.take();
        let late = late.filter(|late| now.saturating_duration_since(late.at) <= PATIENCE);
        if let Some(late) = late
            && !self.asked.is_some_and(|asked| self.is_punctual(asked, now))
        {
            // The line has become slow. The answer to the pending query is still to come.
            self.abandoned = self.abandoned.saturating_sub(1);
            self.rate.slow_down(late, now);
            return;
        }
        self.lost = 0;
        if self.asked.is_none() {
            self.abandoned = self.abandoned.saturating_sub(1);
        }
        if self.abandoned == 0 {
            (self.doubtful_until, self.silent_until) = (None, None);
        } else if self.doubtful_until.is_some_and(|until| until <= now) {
            // Each answer may be that to the query before.
            self.silent_until = Some(now + 2 * FRAME);
        }
        if let Some(requested) = self.asked.take() {
            #[expect(clippy::cast_precision_loss, reason = "no frame has 2^52 bytes")]
            let bytes = requested.bytes as f64;
            let took = now.saturating_duration_since(requested.at);
            if took <= MAX_TRAVEL_TIME && requested.is_whole {
                self.rate.learn(bytes, took.as_secs_f64());
            }
        }
    }

    /// Returns the rate of the line in bytes per second, if known.
    pub(super) fn rate(&self) -> Option<f64> {
        self.rate.known()
    }

    /// Returns the maximum length of the next frame in bytes.
    pub(super) fn max_frame_len(&self) -> usize {
        match (self.rate.known(), self.last) {
            // While an answer is missing, the line may have become slow.
            (Some(rate), _) if self.lost > 0 => bytes(rate).min(PROBE),
            (Some(rate), _) => bytes(rate),
            (None, None) => PROBE,
            (None, Some(_)) => usize::MAX,
        }
    }

    /// Returns the earliest time of the next frame if no answer arrives before; `None` if it may be
    /// sent at once.
    pub(super) fn ready_at(&self) -> Option<Instant> {
        let last = self.last?;
        match (self.manner, self.asked) {
            (TerminalBehaviour::Unknown, Some(requested)) if requested.at == last => {
                Some(last + FIRST_TIMEOUT)
            }
            (TerminalBehaviour::Unknown, Some(requested)) => {
                Some((last + self.fixed(UNKNOWN_TERMINAL_PAUSE)).min(requested.at + PATIENCE))
            }
            (TerminalBehaviour::Answers, Some(requested)) => {
                Some(requested.at + self.patience(requested))
            }
            (TerminalBehaviour::Answers, None) => self.silent_until,
            (TerminalBehaviour::Unknown, None) => None,
            (TerminalBehaviour::Mute, _) => Some(last + self.fixed(MUTE)),
        }
    }

    /// Returns the time since which the last frame is visible: of its answer, or of sending for a
    /// terminal without answers. `None` if the frame is still in flight.
    pub(super) fn drawn_at(&self, now: Instant) -> Option<Instant> {
        match (self.manner, self.asked) {
            (TerminalBehaviour::Answers, Some(requested)) => {
                let lost = requested.at + self.patience(requested);
                (now >= lost).then_some(lost)
            }
            (TerminalBehaviour::Answers, None) => self.drawn,
            (TerminalBehaviour::Unknown | TerminalBehaviour::Mute, _) => self.last,
        }
    }

    /// Returns the time until which to wait for an answer at exit, if one is pending.
    pub(super) fn farewell(&self, now: Instant) -> Option<Instant> {
        let patience = |requested| match self.manner {
            TerminalBehaviour::Answers => self.patience(requested),
            TerminalBehaviour::Unknown | TerminalBehaviour::Mute => EXIT_ANSWER_TIMEOUT,
        };
        self.asked
            .map(|requested| now + patience(requested).min(EXIT_ANSWER_TIMEOUT))
    }

    /// Returns a pause, or the duration of a frame if that is longer and the line's rate is known.
    fn fixed(&self, pause: Duration) -> Duration {
        self.rate.known().map_or(pause, |_| pause.max(FRAME))
    }

    /// Returns the maximum wait for the answer to a query, from the measured rate. It doubles with
    /// each consecutive lost answer.
    fn patience(&self, requested: FrameInFlight) -> Duration {
        #[expect(clippy::cast_precision_loss, reason = "no frame has 2^52 bytes")]
        let bytes = requested.bytes as f64;
        let Some(expected) = self.rate.expected(bytes) else {
            return FIRST_TIMEOUT;
        };
        let patience = (LOST_ANSWER_FACTOR * expected).max(MIN_TIMEOUT.as_secs_f64());
        let patience = patience * f64::from(1 << self.lost.min(MAX_LOST));
        Duration::from_secs_f64(patience.min(MAX_TIMEOUT.as_secs_f64()))
    }

    /// Returns `true` if `now` is about the time at which the answer to a query is expected.
    fn is_punctual(&self, asked: FrameInFlight, now: Instant) -> bool {
        let took = now.saturating_duration_since(asked.at).as_secs_f64();
        #[expect(clippy::cast_precision_loss, reason = "no frame has 2^52 bytes")]
        let expected = self.rate.expected(asked.bytes as f64);
        let quickest = self.rate.quickest_answer.map(|(_, seconds)| seconds);
        expected.zip(quickest).is_some_and(|(expected, quickest)| {
            let latest = expected * (1.0 + PUNCTUAL_SHARE) + PUNCTUAL_TIME;
            (quickest * (1.0 - PUNCTUAL_SHARE)..=latest).contains(&took.max(MIN_ANSWER_TIME))
        })
    }

    fn give_up(&mut self, now: Instant) {
        let Some(requested) = self.asked else { return };
        let patience = match self.manner {
            TerminalBehaviour::Answers => self.patience(requested),
            TerminalBehaviour::Unknown | TerminalBehaviour::Mute => PATIENCE,
        };
        if now < requested.at + patience {
            return;
        }
        self.asked = None;
        if self.doubtful_until.is_none_or(|until| until <= now) {
            (self.late, self.abandoned) = (None, 0);
        }
        self.late.get_or_insert(requested);
        self.abandoned += 1;
        self.doubtful_until = Some(now + PATIENCE);
        self.lost += 1;
        // One answer may be lost; several are late.
        if self.lost > 1 && self.manner == TerminalBehaviour::Answers {
            self.rate.slow_down(requested, now);
        }
        if self.manner != TerminalBehaviour::Answers || self.lost >= MAX_LOST {
            self.manner = TerminalBehaviour::Mute;
        }
    }
}

/// Returns the maximum length of a frame on a line of this rate.
fn bytes(rate: f64) -> usize {
    let bytes = (rate * FRAME.as_secs_f64()).max(MIN_VALUE);
    #[expect(
        clippy::cast_possible_truncation,
        clippy::cast_sign_loss,
        reason = "at least LEAST; what is too large for a usize becomes its largest"
    )]
    let bytes = bytes as usize;
    bytes
}

impl LineRate {
    fn known(&self) -> Option<f64> {
        let of = |set: f64| self.measured.map_or(set, |measured| measured.min(set));
        self.set.map(of).or(self.measured)
    }

    /// Returns the expected time of an answer in seconds: the round trip plus the time for the
    /// bytes. `None` if unmeasured.
    fn expected(&self, bytes: f64) -> Option<f64> {
        let (_, way) = self.quickest_answer?;
        Some(way + bytes / self.known()?)
    }

    /// Lowers the rate after a frame whose answer is missing at `now`, or has just come late.
    fn slow_down(&mut self, frame: FrameInFlight, now: Instant) {
        let seconds = now.saturating_duration_since(frame.at).as_secs_f64();
        #[expect(clippy::cast_precision_loss, reason = "no frame has 2^52 bytes")]
        let maximum = frame.bytes as f64 / seconds.max(MIN_ANSWER_TIME);
        let maximum = maximum.max(MIN_VALUE / FRAME.as_secs_f64());
        self.measured = self.measured.map(|rate| rate.min(maximum));
    }

    /// Updates the rate from an answer to `bytes` bytes after `seconds` seconds.
    ///
    /// The time consists of the round trip, which does not limit the rate, and of the transmission,
    /// which does. Two frames of different lengths separate the two. Until then, all of the time
    /// counts as transmission, which errs on the safe side.
    fn learn(&mut self, bytes: f64, seconds: f64) {
        let seconds = seconds.max(MIN_ANSWER_TIME);
        // A lower bound of the line's rate.
        let minimum = bytes / seconds;
        let (Some((fewest, quickest)), Some(rate)) = (self.quickest_answer, self.measured) else {
            self.quickest_answer = Some((bytes, seconds));
            self.measured = Some(minimum.min(MAX_BYTE_RATE));
            return;
        };
        // A frame of maximum length that is no later than any other: the next may be longer.
        let filled = bytes >= FILLED * rate * FRAME.as_secs_f64();
        let rate = if filled && seconds <= PUNCTUAL_FACTOR * quickest {
            2.0 * rate
        } else {
            rate
        };
        if seconds <= quickest {
            self.quickest_answer = Some((bytes, seconds));
            self.measured = Some(rate.max(minimum).min(MAX_BYTE_RATE));
            return;
        }
        let late = seconds - quickest;
        let value = if bytes >= fewest + LONGER {
            (bytes - fewest) / late
        } else if late > MIN_LATENESS {
            bytes / late
        } else {
            rate
        };
        // A single late answer may have another cause, and a single early answer proves nothing.
        let value = value.clamp(rate / 2.0, rate * 4.0);
        self.measured = Some(value.max(minimum).min(MAX_BYTE_RATE));
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const MOMENT: Duration = Duration::from_millis(1);

    /// A line with a rate in bytes per second and a round-trip time in seconds.
    struct Line {
        rate: f64,
        way: f64,
    }

    impl Line {
        fn time(&self, bytes: usize) -> f64 {
            self.way + bytes as f64 / self.rate
        }

        /// Sends `count` frames of the permitted length, up to `maximum` bytes, each after the
        /// previous answer. Returns the longest transmission time and the final length limit.
        fn frames(&self, rate_limit: &mut RateLimit, count: usize, maximum: usize) -> (f64, usize) {
            let mut now = Instant::now();
            let mut longest: f64 = 0.0;
            for _ in 0..count {
                let bytes = rate_limit.max_frame_len().min(maximum);
                assert!(rate_limit.send(bytes, now));
                let bytes = bytes + QUESTION.len();
                longest = longest.max(bytes as f64 / self.rate);
                now += Duration::from_secs_f64(self.time(bytes));
                rate_limit.answered(now);
            }
            (longest, rate_limit.max_frame_len())
        }
    }

    #[test]
    fn frames_at_9600_baud_take_quarter_of_a_second() {
        for way in [0.0, 0.002, 0.05] {
            let line = Line { rate: 960.0, way };
            let mut rate_limit = RateLimit::new(None);
            let (longest, space) = line.frames(&mut rate_limit, 200, 3000);
            assert!(longest <= 0.5, "{way}: {longest}");
            assert!((150..=300).contains(&space), "{way}: {space}");
        }
    }

    #[test]
    fn fast_line_gets_whole_screens_after_one_frame() {
        let mut rate_limit = RateLimit::new(None);
        let local = Line {
            rate: 1e7,
            way: 3e-4,
        };
        local.frames(&mut rate_limit, 1, 3000);
        assert!(
            rate_limit.max_frame_len() > 20_000,
            "{}",
            rate_limit.max_frame_len()
        );
    }

    /// The bytes of an image drawn before the query say nothing about the line's speed.
    #[test]
    fn bytes_between_frames_do_not_raise_limit() {
        let line = Line {
            rate: 960.0,
            way: 0.01,
        };
        let mut rate_limit = RateLimit::new(None);
        line.frames(&mut rate_limit, 20, 3000);
        let space = rate_limit.max_frame_len();
        rate_limit.record_sent(18_000);
        let now = Instant::now();
        assert!(rate_limit.send(100, now));
        rate_limit.answered(now + Duration::from_millis(120));
        assert_eq!(rate_limit.max_frame_len(), space);
    }

    /// High latency does not mean low speed: the round-trip time does not shorten frames.
    #[test]
    fn high_latency_line_gets_whole_screens_soon() {
        for way in [0.03, 0.1, 0.4] {
            let line = Line { rate: 1e6, way };
            let mut rate_limit = RateLimit::new(None);
            line.frames(&mut rate_limit, 6, 3000);
            assert!(
                rate_limit.max_frame_len() > 3000,
                "{way}: {}",
                rate_limit.max_frame_len()
            );
            // Nor do many short frames.
            line.frames(&mut rate_limit, 50, 40);
            assert!(
                rate_limit.max_frame_len() > 3000,
                "{way}: {}",
                rate_limit.max_frame_len()
            );
        }
    }

    #[test]
    fn limit_follows_changes_of_line_speed() {
        let mut rate_limit = RateLimit::new(None);
        let fast = Line {
            rate: 1e5,
            way: 0.02,
        };
        fast.frames(&mut rate_limit, 20, 400);
        let slow = Line {
            rate: 960.0,
            way: 0.02,
        };
        slow.frames(&mut rate_limit, 20, 400);
        assert!(
            rate_limit.max_frame_len() < 400,
            "{}",
            rate_limit.max_frame_len()
        );
        fast.frames(&mut rate_limit, 20, 400);
        assert!(
            rate_limit.max_frame_len() > 3000,
            "{}",
            rate_limit.max_frame_len()
        );
    }

    #[test]
    fn serial_line_speed_sets_limit() {
        let mut rate_limit = RateLimit::new(Some(240.0));
        assert_eq!(rate_limit.max_frame_len(), 64);
        let mut pace_of_line = RateLimit::new(Some(11_520.0));
        assert_eq!(pace_of_line.max_frame_len(), 2880);
        let line = Line {
            rate: 11_520.0,
            way: 0.001,
        };
        let (longest, _) = line.frames(&mut pace_of_line, 50, 5000);
        assert!(longest < 0.3, "{longest}");
        // Without answers only the configured speed is known.
        let now = Instant::now();
        rate_limit.send(64, now);
        assert!(!rate_limit.send(64, now + PATIENCE));
        assert_eq!(rate_limit.ready_at(), Some(now + PATIENCE + FRAME));
        assert_eq!(rate_limit.max_frame_len(), 64);
    }

    #[test]
    fn first_frame_is_short_and_has_short_timeout() {
        let (mut rate_limit, now) = (RateLimit::new(None), Instant::now());
        assert_eq!(
            (rate_limit.ready_at(), rate_limit.max_frame_len()),
            (None, PROBE)
        );
        assert!(rate_limit.send(PROBE, now));
        assert_eq!(rate_limit.ready_at(), Some(now + FIRST_TIMEOUT));
        assert_eq!(rate_limit.max_frame_len(), usize::MAX);
    }

    #[test]
    fn answering_terminal_has_one_frame_in_flight() {
        let (mut rate_limit, now) = (RateLimit::new(None), Instant::now());
        rate_limit.send(100, now);
        rate_limit.answered(now + MOMENT);
        assert_eq!(rate_limit.ready_at(), None);
        assert!(rate_limit.send(100, now + MOMENT));
        assert!(rate_limit.ready_at() > Some(now + MOMENT));
        assert!(rate_limit.farewell(now).is_some());
        rate_limit.answered(now + MOMENT);
        assert_eq!(rate_limit.farewell(now), None);
    }

    /// Regression: a lost answer stopped the screen for 4 s.
    #[test]
    fn timeout_of_lost_answer_follows_line_speed() {
        let mut now = Instant::now();
        for (way, maximum) in [(3e-4, 0.25), (0.1, 1.0), (0.4, 3.5)] {
            let line = Line { rate: 1e6, way };
            let mut rate_limit = RateLimit::new(None);
            line.frames(&mut rate_limit, 20, 3000);
            assert!(rate_limit.send(100, now));
            let ready = rate_limit.ready_at().unwrap();
            assert!(
                ready - now < Duration::from_secs_f64(maximum),
                "{:?}",
                ready - now
            );
            // The query is repeated, and an answer resets the timeout.
            assert!(rate_limit.send(100, ready));
            let later = rate_limit.ready_at().unwrap() - ready;
            assert!(later >= (ready - now).min(MAX_TIMEOUT), "{later:?}");
            let answer = ready + Duration::from_secs_f64(line.time(100));
            rate_limit.answered(answer);
            assert_eq!(rate_limit.ready_at(), None);
            now = answer;
        }
        // A slow line needs more time for the bytes sent.
        let line = Line {
            rate: 960.0,
            way: 0.002,
        };
        let mut rate_limit = RateLimit::new(None);
        line.frames(&mut rate_limit, 20, 3000);
        assert!(rate_limit.send(240, now));
        assert!(rate_limit.ready_at().unwrap() - now > Duration::from_millis(500));
    }

    /// On a busy machine an answer takes a second. Regression: an answer lost after that stopped
    /// the screen for 4 s.
    #[test]
    fn timeout_of_lost_answer_is_limited_on_busy_machine() {
        let mut rate_limit = RateLimit::new(None);
        let mut now = Instant::now();
        for _ in 0..3 {
            rate_limit.send(PROBE, now);
            now += Duration::from_millis(1500);
            rate_limit.answered(now);
        }
        for _ in 0..5 {
            rate_limit.send(100, now);
            let ready = rate_limit.ready_at().unwrap_or(now);
            assert!(ready - now <= MAX_TIMEOUT, "{:?}", ready - now);
            now = ready;
        }
    }

    /// The late answer to an abandoned query does not count as an answer to the next. Regression:
    /// the line was then considered fast.
    #[test]
    fn late_answer_does_not_raise_limit() {
        let line = Line {
            rate: 960.0,
            way: 0.01,
        };
        let mut rate_limit = RateLimit::new(None);
        line.frames(&mut rate_limit, 20, 3000);
        let space = rate_limit.max_frame_len();
        let mut now = Instant::now();
        rate_limit.send(240, now);
        now = rate_limit.ready_at().unwrap();
        assert!(rate_limit.send(240, now));
        rate_limit.answered(now + MOMENT);
        assert!(rate_limit.max_frame_len() <= space);
        rate_limit.answered(now + Duration::from_millis(300));
        // Later answers count again.
        now += PATIENCE;
        rate_limit.send(240, now);
        rate_limit.answered(now + Duration::from_millis(20));
        assert!(rate_limit.max_frame_len() > space);
    }

    /// Regression: after a stall each answer was that to the query before. Four seconds later they
    /// counted again, and a long frame seemed to take as long as a short one.
    #[test]
    fn stalled_line_does_not_raise_limit() {
        for stall in 1..30 {
            let line = Line {
                rate: 960.0,
                way: 0.0,
            };
            let mut rate_limit = RateLimit::new(None);
            line.frames(&mut rate_limit, 20, 3000);
            let start = Instant::now();
            let (mut now, mut answers) = (start, std::collections::VecDeque::new());
            let mut free = start + stall * Duration::from_millis(100);
            while now < start + Duration::from_secs(12) {
                let is_due = rate_limit.ready_at().is_none_or(|at| at <= now);
                if answers.front().is_some_and(|at| *at <= now) {
                    answers.pop_front();
                    rate_limit.answered(now);
                } else if is_due {
                    let is_short = now < start + Duration::from_secs(7);
                    let bytes = rate_limit
                        .max_frame_len()
                        .min(if is_short { 24 } else { 220 });
                    let is_asked = rate_limit.send(bytes, now);
                    let sent = bytes + if is_asked { QUESTION.len() } else { 0 };
                    free = free.max(now) + Duration::from_secs_f64(line.time(sent));
                    answers.extend(is_asked.then_some(free));
                } else {
                    let next = [rate_limit.ready_at(), answers.front().copied()];
                    now = next.into_iter().flatten().min().unwrap();
                }
                let space = rate_limit.max_frame_len();
                assert!(space <= 480, "{stall}: {space} after {:?}", now - start);
            }
        }
    }

    #[test]
    fn silent_terminal_is_no_longer_queried() {
        let mut now = Instant::now();
        let mut rate_limit = RateLimit::new(None);
        rate_limit.send(100, now);
        rate_limit.answered(now + MOMENT);
        let started = now;
        while rate_limit.manner != TerminalBehaviour::Mute {
            rate_limit.send(100, now);
            now = rate_limit.ready_at().unwrap().max(now + MOMENT);
        }
        assert!(
            now - started < Duration::from_secs(4),
            "{:?}",
            now - started
        );
        assert!(!rate_limit.send(100, now));
    }

    #[test]
    fn mute_terminal_is_queried_again_once_it_answers() {
        let (mut rate_limit, now) = (RateLimit::new(None), Instant::now());
        assert!(rate_limit.send(100, now));
        assert!(
            !rate_limit.send(100, now + UNKNOWN_TERMINAL_PAUSE),
            "one question is enough"
        );
        assert_eq!(
            rate_limit.ready_at(),
            Some(now + 2 * UNKNOWN_TERMINAL_PAUSE)
        );
        assert!(!rate_limit.send(100, now + PATIENCE));
        assert_eq!(rate_limit.ready_at(), Some(now + PATIENCE + MUTE));
        assert_eq!(rate_limit.farewell(now), None);
        rate_limit.answered(now + PATIENCE);
        assert!(rate_limit.send(100, now + PATIENCE + MOMENT));
    }
}
