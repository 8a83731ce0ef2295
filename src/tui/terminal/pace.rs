//! How fast frames may follow each other: no faster than the line takes them.
//!
//! The kernel does not tell: a pseudo-terminal swallows 19 kB before it stops being writable, which is
//! 20 s of a line of 9,600 baud. The terminal itself does: each frame is followed by the question for
//! its status, whose answer comes when the frame has been drawn, and until then no other is sent. So
//! at most one frame is on its way, and keys show at once. The first frame asks nothing, since a
//! terminal that never answers must not hold up the start; nor is such a terminal waited for later.

use std::time::{Duration, Instant};

/// Device status report: every terminal since the VT100 answers with [`ANSWER`].
pub(super) const QUESTION: &[u8] = b"\x1b[5n";
/// All is well.
pub(super) const ANSWER: &[u8] = b"\x1b[0n";

/// Between frames while it is not known whether the terminal answers.
const CAREFUL: Duration = Duration::from_millis(200);
/// An answer that takes longer will not come, or the line is too slow for anything.
const PATIENCE: Duration = Duration::from_secs(4);
/// How long leaving waits for an answer, which would otherwise be typed into the shell.
const FAREWELL: Duration = Duration::from_millis(800);

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

/// Decides when the next frame may be sent, and whether to ask behind it.
#[derive(Debug)]
pub(super) struct Pace {
    manner: Manner,
    /// Since when an answer is awaited.
    asked: Option<Instant>,
    last: Option<Instant>,
}

impl Pace {
    /// For a terminal of which nothing is known.
    pub(super) fn new() -> Self {
        Pace {
            manner: Manner::Unknown,
            asked: None,
            last: None,
        }
    }

    /// A frame is sent `now`; whether to ask behind it.
    pub(super) fn send(&mut self, now: Instant) -> bool {
        self.give_up(now);
        let first = self.last.replace(now).is_none();
        let ask = !first && self.manner != Manner::Mute && self.asked.is_none();
        if ask {
            self.asked = Some(now);
        }
        ask
    }

    /// The terminal answered, late perhaps.
    pub(super) fn answered(&mut self) {
        self.manner = Manner::Answers;
        self.asked = None;
    }

    /// From when on another frame may be sent, if no answer comes before; `None` if at once.
    pub(super) fn ready_at(&self) -> Option<Instant> {
        let asked = self.asked?;
        match self.manner {
            Manner::Unknown => {
                let careful = self.last.map_or(asked, |last| last + CAREFUL);
                Some(careful.min(asked + PATIENCE))
            }
            Manner::Answers => Some(asked + PATIENCE),
            Manner::Mute => None,
        }
    }

    /// Until when to wait for an answer before leaving, if one may still come.
    pub(super) fn farewell(&self, now: Instant) -> Option<Instant> {
        self.asked.map(|_| now + FAREWELL)
    }

    fn give_up(&mut self, now: Instant) {
        if self.asked.is_some_and(|asked| now >= asked + PATIENCE) {
            self.manner = Manner::Mute;
            self.asked = None;
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const MOMENT: Duration = Duration::from_millis(1);

    #[test]
    fn the_first_frame_asks_nothing_and_the_second_does() {
        let (mut pace, now) = (Pace::new(), Instant::now());
        assert!(!pace.send(now));
        assert_eq!(pace.ready_at(), None);
        assert!(pace.send(now));
        assert_eq!(pace.ready_at(), Some(now + CAREFUL));
    }

    #[test]
    fn one_frame_is_on_its_way_where_the_terminal_answers() {
        let (mut pace, now) = (Pace::new(), Instant::now());
        pace.send(now);
        pace.send(now);
        pace.answered();
        assert_eq!(pace.ready_at(), None);
        assert!(pace.send(now));
        assert_eq!(pace.ready_at(), Some(now + PATIENCE));
        assert!(pace.farewell(now).is_some());
        pace.answered();
        assert_eq!(pace.farewell(now), None);
    }

    #[test]
    fn a_mute_terminal_is_no_longer_asked_until_it_speaks() {
        let (mut pace, now) = (Pace::new(), Instant::now());
        pace.send(now);
        assert!(pace.send(now));
        assert!(!pace.send(now + CAREFUL), "one question is enough");
        assert!(!pace.send(now + PATIENCE));
        assert_eq!(pace.ready_at(), None);
        assert_eq!(pace.farewell(now), None);
        pace.answered();
        assert!(pace.send(now + PATIENCE + MOMENT));
    }
}
