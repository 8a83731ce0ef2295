//! How fast frames may follow each other, and how long they may be: no more than the line takes.
//!
//! The kernel does not tell: a pseudo-terminal swallows 19 kB before it stops being writable, which is
//! 20 s of a line of 9,600 baud. The terminal itself does: each frame is followed by the question for
//! its status, whose answer comes when the frame has been drawn, and until then no other is sent. So
//! at most one frame is on its way, and how long its answer took tells what the next one may cost.
//!
//! The first frame is a short one, which tells a slow line from a fast one before a whole screen is
//! on its way. Nobody waits long for its answer: a terminal that does not answer gets whole frames,
//! at a fixed pace. A real serial line tells its speed by itself.

use std::time::{Duration, Instant};

/// Device status report: every terminal since the VT100 answers with [`ANSWER`].
pub(super) const QUESTION: &[u8] = b"\x1b[5n";
/// All is well.
pub(super) const ANSWER: &[u8] = b"\x1b[0n";

/// What the line may take for one frame. A key waits for the frame on its way at the most, and then
/// its own first line takes as long again.
const FRAME: Duration = Duration::from_millis(250);
/// The first frame: the last line and the title, an eighth of a second at 9,600 baud.
const PROBE: usize = 128;
/// However slow a line is, a frame has room for this.
const LEAST: f64 = 64.0;
/// How long the first frame is waited for: twice what it takes at 9,600 baud.
const FIRST_PATIENCE: Duration = Duration::from_millis(400);
/// Between frames while it is not known whether the terminal answers.
const CAREFUL: Duration = Duration::from_millis(200);
/// Between frames where it does not.
const MUTE: Duration = Duration::from_millis(100);
/// A terminal that has not answered for so long does not answer at all. An answer that was given up may still come.
const PATIENCE: Duration = Duration::from_secs(4);
/// An answer that takes so many times what it should is lost: somebody typed into it, or the line is noisy.
const TOO_LATE: f64 = 4.0;
/// However quick a line is, a terminal may have something else to do for a moment.
const LEAST_PATIENCE: Duration = Duration::from_millis(200);
/// No lost answer stops the screen for longer, whatever the line was found to take while the machine was busy.
const MOST_PATIENCE: Duration = Duration::from_secs(1);
/// After so many lost answers one after the other no more is asked.
const MOST_LOST: u32 = 3;
/// An answer that comes later tells nothing of the line: it may be to another question, or to none.
const LONGEST_WAY: Duration = Duration::from_secs(2);
/// How long leaving waits for an answer, which would otherwise be typed into the shell.
const FAREWELL: Duration = Duration::from_millis(800);

/// Answers take at least so long: a shorter time says nothing about the line.
const QUICK: f64 = 0.001;
/// What an answer is late by must be worth mentioning before the line is thought to be slower.
const LATE: f64 = 0.125;
/// Frames this much longer than the shortest tell the rate of the line by the difference.
const LONGER: f64 = 64.0;

/// Room for any screen; a line that becomes slow is the sooner noticed.
const FASTEST: f64 = 1e6;
/// An answer is punctual up to so many times the quickest,
const PUNCTUAL: f64 = 1.1;
/// and a frame as long as may be from this part of it on.
const FILLED: f64 = 0.8;

/// What is known of the terminal at the other end.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Manner {
    /// Nothing has been asked so far, or nothing answered yet.
    Unknown,
    /// It answers.
    Answers,
    /// It does not.
    Mute,
}

/// A frame on its way.
#[derive(Clone, Copy, Debug)]
struct FrameInFlight {
    at: Instant,
    bytes: usize,
    /// Whether its answer tells of the line: all of them were sent then, and no older answer is to come. What was said
    /// before it may be drawn already.
    is_whole: bool,
}

/// Decides when the next frame may be sent, how long it may be, and whether to ask behind it.
#[derive(Debug)]
pub(super) struct RateLimit {
    manner: Manner,
    /// The frame whose answer is awaited.
    asked: Option<FrameInFlight>,
    last: Option<Instant>,
    /// When the terminal has answered last.
    drawn: Option<Instant>,
    /// Bytes sent since the last question, and whether some of them are no frame.
    unasked: usize,
    has_said: bool,
    /// Answers that were lost since the last one that came.
    lost: u32,
    /// Until when an answer may be to a question that was given up: it tells nothing of the line.
    doubtful: Option<Instant>,
    rate: LineRate,
}

/// Bytes a second that the line takes: what was measured, and never more than the line is set to.
#[derive(Clone, Copy, Debug)]
struct LineRate {
    set: Option<f64>,
    measured: Option<f64>,
    /// The quickest answer so far: bytes and seconds. Most of its time is the way there and back.
    quickest: Option<(f64, f64)>,
}

impl RateLimit {
    /// For a terminal of which nothing is known but the speed that its line may be set to, in bytes a
    /// second.
    pub(super) fn new(set: Option<f64>) -> Self {
        RateLimit {
            manner: Manner::Unknown,
            asked: None,
            last: None,
            drawn: None,
            unasked: 0,
            has_said: false,
            lost: 0,
            doubtful: None,
            rate: LineRate {
                set,
                measured: None,
                quickest: None,
            },
        }
    }

    /// A frame of so many bytes is sent `now`; whether to ask behind it.
    pub(super) fn send(&mut self, bytes: usize, now: Instant) -> bool {
        self.give_up(now);
        self.last = Some(now);
        self.unasked = self.unasked.saturating_add(bytes);
        let ask = self.manner != Manner::Mute && self.asked.is_none();
        if ask {
            let bytes = std::mem::take(&mut self.unasked) + QUESTION.len();
            let is_doubtful = self.doubtful.is_some_and(|until| now < until);
            let is_whole = !std::mem::take(&mut self.has_said) && !is_doubtful;
            self.asked = Some(FrameInFlight {
                at: now,
                bytes,
                is_whole,
            });
        }
        ask
    }

    /// Bytes are sent that are no frame.
    pub(super) fn say(&mut self, bytes: usize) {
        self.has_said = true;
        self.unasked = self.unasked.saturating_add(bytes);
    }

    /// The terminal answered `now`, late perhaps.
    pub(super) fn answered(&mut self, now: Instant) {
        self.manner = Manner::Answers;
        self.drawn = Some(now);
        self.lost = 0;
        if let Some(asked) = self.asked.take() {
            #[expect(clippy::cast_precision_loss, reason = "no frame has 2^52 bytes")]
            let bytes = asked.bytes as f64;
            let took = now.saturating_duration_since(asked.at);
            if took <= LONGEST_WAY && asked.is_whole {
                self.rate.learn(bytes, took.as_secs_f64());
            }
        }
    }

    /// Bytes a second that the line takes, where that is known.
    pub(super) fn rate(&self) -> Option<f64> {
        self.rate.known()
    }

    /// So many bytes the next frame may have.
    pub(super) fn room(&self) -> usize {
        match (self.rate.known(), self.last) {
            (Some(rate), _) => bytes(rate),
            (None, None) => PROBE,
            (None, Some(_)) => usize::MAX,
        }
    }

    /// From when on another frame may be sent, if no answer comes before; `None` if at once.
    pub(super) fn ready_at(&self) -> Option<Instant> {
        let last = self.last?;
        match (self.manner, self.asked) {
            (Manner::Unknown, Some(asked)) if asked.at == last => Some(last + FIRST_PATIENCE),
            (Manner::Unknown, Some(asked)) => {
                Some((last + self.fixed(CAREFUL)).min(asked.at + PATIENCE))
            }
            (Manner::Answers, Some(asked)) => Some(asked.at + self.patience(asked)),
            (Manner::Unknown | Manner::Answers, None) => None,
            (Manner::Mute, _) => Some(last + self.fixed(MUTE)),
        }
    }

    /// Since when the last frame has been seen: since its answer, or since it was sent, where none comes;
    /// `None` if it is still on its way.
    pub(super) fn drawn_at(&self, now: Instant) -> Option<Instant> {
        match (self.manner, self.asked) {
            (Manner::Answers, Some(asked)) => {
                let lost = asked.at + self.patience(asked);
                (now >= lost).then_some(lost)
            }
            (Manner::Answers, None) => self.drawn,
            (Manner::Unknown | Manner::Mute, _) => self.last,
        }
    }

    /// Until when to wait for an answer before leaving, if one may still come.
    pub(super) fn farewell(&self, now: Instant) -> Option<Instant> {
        let patience = |asked| match self.manner {
            Manner::Answers => self.patience(asked),
            Manner::Unknown | Manner::Mute => FAREWELL,
        };
        self.asked.map(|asked| now + patience(asked).min(FAREWELL))
    }

    /// A pause, or what a frame takes on a line whose speed is known.
    fn fixed(&self, pause: Duration) -> Duration {
        self.rate.known().map_or(pause, |_| pause.max(FRAME))
    }

    /// How long the answer to a question is waited for: as the line was found, and twice as long after each
    /// one that did not come.
    fn patience(&self, asked: FrameInFlight) -> Duration {
        #[expect(clippy::cast_precision_loss, reason = "no frame has 2^52 bytes")]
        let bytes = asked.bytes as f64;
        let Some(expected) = self.rate.expected(bytes) else {
            return FIRST_PATIENCE;
        };
        let patience = (TOO_LATE * expected).max(LEAST_PATIENCE.as_secs_f64());
        let patience = patience * f64::from(1 << self.lost.min(MOST_LOST));
        Duration::from_secs_f64(patience.min(MOST_PATIENCE.as_secs_f64()))
    }

    fn give_up(&mut self, now: Instant) {
        let Some(asked) = self.asked else { return };
        let patience = match self.manner {
            Manner::Answers => self.patience(asked),
            Manner::Unknown | Manner::Mute => PATIENCE,
        };
        if now < asked.at + patience {
            return;
        }
        self.asked = None;
        self.doubtful = Some(now + PATIENCE);
        self.lost += 1;
        if self.manner != Manner::Answers || self.lost >= MOST_LOST {
            self.manner = Manner::Mute;
        }
    }
}

/// What a line of this rate takes for one frame.
fn bytes(rate: f64) -> usize {
    let bytes = (rate * FRAME.as_secs_f64()).max(LEAST);
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

    /// What the way there and back takes, and so many bytes on the line: seconds, where that was measured.
    fn expected(&self, bytes: f64) -> Option<f64> {
        let (_, way) = self.quickest?;
        Some(way + bytes / self.known()?)
    }

    /// An answer to so many bytes came after so many seconds.
    ///
    /// The time is the way there and back, which does not limit how much may be sent, and what the
    /// line took for the bytes, which does. Two frames of different length tell the one from the
    /// other; until then all of it is put down to the line, which errs on the safe side.
    fn learn(&mut self, bytes: f64, seconds: f64) {
        let seconds = seconds.max(QUICK);
        // The line takes at least this.
        let least = bytes / seconds;
        let (Some((fewest, quickest)), Some(rate)) = (self.quickest, self.measured) else {
            self.quickest = Some((bytes, seconds));
            self.measured = Some(least.min(FASTEST));
            return;
        };
        // As long a frame as may be, and no later than any other: it may as well be longer.
        let filled = bytes >= FILLED * rate * FRAME.as_secs_f64();
        let rate = if filled && seconds <= PUNCTUAL * quickest {
            2.0 * rate
        } else {
            rate
        };
        if seconds <= quickest {
            self.quickest = Some((bytes, seconds));
            self.measured = Some(rate.max(least).min(FASTEST));
            return;
        }
        let late = seconds - quickest;
        let told = if bytes >= fewest + LONGER {
            (bytes - fewest) / late
        } else if late > LATE {
            bytes / late
        } else {
            rate
        };
        // One late answer may have another reason; one early answer is no proof either.
        let told = told.clamp(rate / 2.0, rate * 4.0);
        self.measured = Some(told.max(least).min(FASTEST));
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const MOMENT: Duration = Duration::from_millis(1);

    /// A line that takes so many bytes a second, with its way there and back.
    struct Line {
        rate: f64,
        way: f64,
    }

    impl Line {
        fn time(&self, bytes: usize) -> f64 {
            self.way + bytes as f64 / self.rate
        }

        /// Sends what there is room for, up to `most` bytes, so many times, each after its answer;
        /// the longest that one took on the line, and the room that there is at last.
        fn frames(&self, rate_limit: &mut RateLimit, count: usize, most: usize) -> (f64, usize) {
            let mut now = Instant::now();
            let mut longest: f64 = 0.0;
            for _ in 0..count {
                let bytes = rate_limit.room().min(most);
                assert!(rate_limit.send(bytes, now));
                let bytes = bytes + QUESTION.len();
                longest = longest.max(bytes as f64 / self.rate);
                now += Duration::from_secs_f64(self.time(bytes));
                rate_limit.answered(now);
            }
            (longest, rate_limit.room())
        }
    }

    #[test]
    fn a_line_of_9600_baud_gets_a_quarter_of_a_second() {
        for way in [0.0, 0.002, 0.05] {
            let line = Line { rate: 960.0, way };
            let mut rate_limit = RateLimit::new(None);
            let (longest, room) = line.frames(&mut rate_limit, 200, 3000);
            assert!(longest <= 0.5, "{way}: {longest}");
            assert!((150..=300).contains(&room), "{way}: {room}");
        }
    }

    #[test]
    fn a_fast_line_gets_whole_screens_at_once() {
        let mut rate_limit = RateLimit::new(None);
        let local = Line {
            rate: 1e7,
            way: 3e-4,
        };
        local.frames(&mut rate_limit, 1, 3000);
        assert!(rate_limit.room() > 20_000, "{}", rate_limit.room());
    }

    /// A picture that was drawn before the question was asked says nothing of the line by its bytes.
    #[test]
    fn what_was_said_between_frames_makes_no_line_faster() {
        let line = Line {
            rate: 960.0,
            way: 0.01,
        };
        let mut rate_limit = RateLimit::new(None);
        line.frames(&mut rate_limit, 20, 3000);
        let room = rate_limit.room();
        rate_limit.say(18_000);
        let now = Instant::now();
        assert!(rate_limit.send(100, now));
        rate_limit.answered(now + Duration::from_millis(120));
        assert_eq!(rate_limit.room(), room);
    }

    /// A far terminal is not a slow one: the way there and back is no reason for short frames.
    #[test]
    fn a_far_terminal_gets_whole_screens_soon() {
        for way in [0.03, 0.1, 0.4] {
            let line = Line { rate: 1e6, way };
            let mut rate_limit = RateLimit::new(None);
            line.frames(&mut rate_limit, 6, 3000);
            assert!(rate_limit.room() > 3000, "{way}: {}", rate_limit.room());
            // Nor do many short frames make it one.
            line.frames(&mut rate_limit, 50, 40);
            assert!(rate_limit.room() > 3000, "{way}: {}", rate_limit.room());
        }
    }

    #[test]
    fn a_line_that_becomes_slow_is_noticed() {
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
        assert!(rate_limit.room() < 400, "{}", rate_limit.room());
        fast.frames(&mut rate_limit, 20, 400);
        assert!(rate_limit.room() > 3000, "{}", rate_limit.room());
    }

    #[test]
    fn a_serial_line_tells_its_speed() {
        let mut rate_limit = RateLimit::new(Some(240.0));
        assert_eq!(rate_limit.room(), 64);
        let mut pace_of_line = RateLimit::new(Some(11_520.0));
        assert_eq!(pace_of_line.room(), 2880);
        let line = Line {
            rate: 11_520.0,
            way: 0.001,
        };
        let (longest, _) = line.frames(&mut pace_of_line, 50, 5000);
        assert!(longest < 0.3, "{longest}");
        // Where nobody answers, the speed is all that is known.
        let now = Instant::now();
        rate_limit.send(64, now);
        assert!(!rate_limit.send(64, now + PATIENCE));
        assert_eq!(rate_limit.ready_at(), Some(now + PATIENCE + FRAME));
        assert_eq!(rate_limit.room(), 64);
    }

    #[test]
    fn the_first_frame_is_short_and_not_waited_for_long() {
        let (mut rate_limit, now) = (RateLimit::new(None), Instant::now());
        assert_eq!((rate_limit.ready_at(), rate_limit.room()), (None, PROBE));
        assert!(rate_limit.send(PROBE, now));
        assert_eq!(rate_limit.ready_at(), Some(now + FIRST_PATIENCE));
        assert_eq!(rate_limit.room(), usize::MAX);
    }

    #[test]
    fn one_frame_is_on_its_way_where_the_terminal_answers() {
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

    /// One that was lost used to stop the screen for 4 s.
    #[test]
    fn a_lost_answer_is_waited_for_as_the_line_was_found() {
        let mut now = Instant::now();
        for (way, most) in [(3e-4, 0.25), (0.1, 1.0), (0.4, 3.5)] {
            let line = Line { rate: 1e6, way };
            let mut rate_limit = RateLimit::new(None);
            line.frames(&mut rate_limit, 20, 3000);
            assert!(rate_limit.send(100, now));
            let ready = rate_limit.ready_at().unwrap();
            assert!(
                ready - now < Duration::from_secs_f64(most),
                "{:?}",
                ready - now
            );
            // It is asked again, and one that comes makes all good.
            assert!(rate_limit.send(100, ready));
            let later = rate_limit.ready_at().unwrap() - ready;
            assert!(later >= (ready - now).min(MOST_PATIENCE), "{later:?}");
            rate_limit.answered(ready + MOMENT);
            assert_eq!(rate_limit.ready_at(), None);
            now = ready + MOMENT;
        }
        // A slow line takes its time for what was sent.
        let line = Line {
            rate: 960.0,
            way: 0.002,
        };
        let mut rate_limit = RateLimit::new(None);
        line.frames(&mut rate_limit, 20, 3000);
        assert!(rate_limit.send(240, now));
        assert!(rate_limit.ready_at().unwrap() - now > Duration::from_millis(500));
    }

    /// On a busy machine an answer takes a second, and one that was then lost used to stop the screen for 4 s.
    #[test]
    fn lost_answer_stops_no_busy_screen_for_long() {
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
            assert!(ready - now <= MOST_PATIENCE, "{:?}", ready - now);
            now = ready;
        }
    }

    /// The answer to a question that was given up is none to the next: the line used to be thought a fast one.
    #[test]
    fn late_answer_makes_no_line_faster() {
        let line = Line {
            rate: 960.0,
            way: 0.01,
        };
        let mut rate_limit = RateLimit::new(None);
        line.frames(&mut rate_limit, 20, 3000);
        let room = rate_limit.room();
        let mut now = Instant::now();
        rate_limit.send(240, now);
        now = rate_limit.ready_at().unwrap();
        assert!(rate_limit.send(240, now));
        rate_limit.answered(now + MOMENT);
        assert_eq!(rate_limit.room(), room);
        // What comes after that is to be believed again.
        now += PATIENCE;
        rate_limit.send(240, now);
        rate_limit.answered(now + Duration::from_millis(20));
        assert!(rate_limit.room() > room);
    }

    #[test]
    fn a_terminal_that_falls_silent_is_asked_no_more() {
        let mut now = Instant::now();
        let mut rate_limit = RateLimit::new(None);
        rate_limit.send(100, now);
        rate_limit.answered(now + MOMENT);
        let begun = now;
        while rate_limit.manner != Manner::Mute {
            rate_limit.send(100, now);
            now = rate_limit.ready_at().unwrap().max(now + MOMENT);
        }
        assert!(now - begun < Duration::from_secs(4), "{:?}", now - begun);
        assert!(!rate_limit.send(100, now));
    }

    #[test]
    fn a_mute_terminal_is_no_longer_asked_until_it_speaks() {
        let (mut rate_limit, now) = (RateLimit::new(None), Instant::now());
        assert!(rate_limit.send(100, now));
        assert!(
            !rate_limit.send(100, now + CAREFUL),
            "one question is enough"
        );
        assert_eq!(rate_limit.ready_at(), Some(now + 2 * CAREFUL));
        assert!(!rate_limit.send(100, now + PATIENCE));
        assert_eq!(rate_limit.ready_at(), Some(now + PATIENCE + MUTE));
        assert_eq!(rate_limit.farewell(now), None);
        rate_limit.answered(now + PATIENCE);
        assert!(rate_limit.send(100, now + PATIENCE + MOMENT));
    }
}
