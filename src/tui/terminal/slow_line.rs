//! Simulates a terminal on a slow line, with a simulated clock: only waiting takes time.

use super::console::Console;
use super::image_escapes::StillSequence;
use super::rate_limit::{QUESTION, RateLimit};
use super::tty::Wake;
use ratatui::layout::Size;
use std::collections::VecDeque;
use std::io;
use std::os::fd::BorrowedFd;
use std::path::Path;
use std::time::{Duration, Instant};

/// A terminal on a line with a limited rate. It answers a query as soon as it arrives.
pub(crate) struct SlowLine {
    size: Size,
    byte: Duration,
    now: Instant,
    /// The time when the line has transmitted all bytes.
    free: Instant,
    /// The bytes in flight, with their arrival times.
    queue: VecDeque<(Instant, u8)>,
    /// The arrived bytes, with their times.
    arrived: Vec<(Instant, u8)>,
    /// The future keys, in order.
    keys: VecDeque<(Instant, &'static str)>,
    /// The maximum length of the queue so far.
    pub(crate) longest: usize,
    /// `true` if there is nothing left to wait for.
    pub(crate) idle: bool,
    /// `true` if queries are no longer answered.
    pub(crate) silent: bool,
    rate_limit: RateLimit,
}

impl SlowLine {
    pub(crate) fn new(bytes_per_second: u32, size: Size) -> Self {
        let now = Instant::now();
        SlowLine {
            size,
            byte: Duration::from_secs(1) / bytes_per_second,
            now,
            free: now,
            queue: VecDeque::new(),
            arrived: Vec::new(),
            keys: VecDeque::new(),
            longest: 0,
            idle: false,
            silent: false,
            rate_limit: RateLimit::new(None),
        }
    }

    /// Changes the rate for the bytes to come.
    pub(crate) fn set_rate(&mut self, bytes_per_second: u32) {
        self.byte = Duration::from_secs(1) / bytes_per_second;
        self.longest = self.queue.len();
    }

    /// Schedules a key after a pause.
    pub(crate) fn press_after(&mut self, key: &'static str, pause: Duration) {
        self.keys.push_back((self.now + pause, key));
        self.idle = false;
    }

    /// Returns the arrived bytes, with their times.
    pub(crate) fn arrived(&self) -> &[(Instant, u8)] {
        &self.arrived
    }

    fn receive(&mut self, bytes: &[u8]) {
        self.free = self.free.max(self.now);
        for &byte in bytes {
            self.free += self.byte;
            self.queue.push_back((self.free, byte));
        }
        self.longest = self.longest.max(self.queue.len());
    }

    /// Returns the time when the next query has completely arrived.
    fn next_answer(&self) -> Option<Instant> {
        let (front, back) = self.queue.as_slices();
        let bytes: Vec<u8> = front.iter().chain(back).map(|(_, byte)| *byte).collect();
        let mut windows = bytes.windows(QUESTION.len());
        let at = windows.position(|bytes| bytes == QUESTION)?;
        Some(self.queue[at + QUESTION.len() - 1].0)
    }

    /// Advances the clock and returns the events up to that time.
    fn advance(&mut self, to: Instant) -> Vec<Wake> {
        let mut events = Vec::new();
        self.now = self.now.max(to);
        if !self.silent && self.next_answer().is_some_and(|answer| answer <= self.now) {
            self.rate_limit.answered(self.now);
            events.push(Wake::Room);
        }
        while let Some(byte) = self.queue.pop_front_if(|(at, _)| *at <= self.now) {
            self.arrived.push(byte);
        }
        while let Some((_, key)) = self.keys.pop_front_if(|(at, _)| *at <= self.now) {
            let key = key.parse().expect("a key of the test");
            events.push(Wake::Key(key));
        }
        events
    }
}

impl Console for SlowLine {
    fn now(&self) -> Instant {
        self.now
    }

    fn enter(&mut self) -> io::Result<()> {
        Ok(())
    }

    fn suspend(&mut self) -> io::Result<()> {
        Ok(())
    }

    fn size(&self) -> Size {
        self.size
    }

    fn aspect(&self) -> Option<f64> {
        None
    }

    fn cell(&self) -> Option<(u16, u16)> {
        None
    }

    fn rate(&self) -> Option<f64> {
        self.rate_limit.rate()
    }

    fn max_frame_len(&self) -> usize {
        self.rate_limit.max_frame_len()
    }

    fn ready_at(&self) -> Option<Instant> {
        self.rate_limit.ready_at()
    }

    fn drawn_at(&self) -> Option<Instant> {
        self.rate_limit.drawn_at(self.now)
    }

    fn send(&mut self, frame: &[u8]) -> io::Result<()> {
        if frame.is_empty() {
            return Ok(());
        }
        self.receive(frame);
        if self.rate_limit.send(frame.len(), self.now) {
            self.receive(QUESTION);
        }
        Ok(())
    }

    fn write_outside_frames(&mut self, bytes: &[u8]) -> io::Result<()> {
        self.rate_limit.record_sent(bytes.len());
        self.receive(bytes);
        Ok(())
    }

    fn write_image(&mut self, still: &StillSequence) -> io::Result<()> {
        self.write_outside_frames(&still.bytes)
    }

    fn handle_mouse(&mut self, _wanted: bool) -> io::Result<()> {
        Ok(())
    }

    fn follow(&mut self, _file: Option<&Path>) -> bool {
        false
    }

    fn wait(
        &mut self,
        deadline: Option<Instant>,
        _bell: Option<BorrowedFd<'_>>,
    ) -> io::Result<Vec<Wake>> {
        let key = self.keys.front().map(|(at, _)| *at);
        let answer = self.next_answer().filter(|_| !self.silent);
        let next = [deadline, answer, key].into_iter().flatten().min();
        let last = self.queue.back().map(|(at, _)| *at);
        self.idle = next.or(last).is_none();
        Ok(match next.or(last) {
            Some(next) => self.advance(next),
            None => Vec::new(),
        })
    }
}
