//! Abstracts the terminal and clock of a session, so that tests can simulate them.

use super::image_escapes::StillSequence;
use super::tty::{Tty, Wake};
use ratatui::layout::Size;
use std::io;
use std::os::fd::BorrowedFd;
use std::path::Path;
use std::time::Instant;

/// A terminal with its clock. Its methods are documented at [`Tty`].
pub(crate) trait Console {
    /// Returns the current time.
    fn now(&self) -> Instant;
    fn enter(&mut self) -> io::Result<()>;
    fn suspend(&mut self) -> io::Result<()>;
    fn size(&self) -> Size;
    fn aspect(&self) -> Option<f64>;
    fn cell(&self) -> Option<(u16, u16)>;
    fn rate(&self) -> Option<f64>;
    fn max_frame_len(&self) -> usize;
    fn ready_at(&self) -> Option<Instant>;
    fn drawn_at(&self) -> Option<Instant>;
    fn send(&mut self, frame: &[u8]) -> io::Result<()>;
    fn write_outside_frames(&mut self, bytes: &[u8]) -> io::Result<()>;
    fn write_image(&mut self, still: &StillSequence) -> io::Result<()>;
    fn handle_mouse(&mut self, wanted: bool) -> io::Result<()>;
    fn follow(&mut self, file: Option<&Path>) -> bool;
    fn wait(
        &mut self,
        deadline: Option<Instant>,
        bell: Option<BorrowedFd<'_>>,
    ) -> io::Result<Vec<Wake>>;
}

impl Console for Tty {
    fn now(&self) -> Instant {
        Instant::now()
    }

    fn enter(&mut self) -> io::Result<()> {
        self.enter()
    }

    fn suspend(&mut self) -> io::Result<()> {
        self.suspend()
    }

    fn size(&self) -> Size {
        self.size()
    }

    fn aspect(&self) -> Option<f64> {
        self.aspect()
    }

    fn cell(&self) -> Option<(u16, u16)> {
        self.cell()
    }

    fn rate(&self) -> Option<f64> {
        self.rate()
    }

    fn max_frame_len(&self) -> usize {
        self.max_frame_len()
    }

    fn ready_at(&self) -> Option<Instant> {
        self.ready_at()
    }

    fn drawn_at(&self) -> Option<Instant> {
        self.drawn_at()
    }

    fn send(&mut self, frame: &[u8]) -> io::Result<()> {
        self.send(frame)
    }

    fn write_outside_frames(&mut self, bytes: &[u8]) -> io::Result<()> {
        self.write_outside_frames(bytes)
    }

    fn write_image(&mut self, still: &StillSequence) -> io::Result<()> {
        self.write_image(still)
    }

    fn handle_mouse(&mut self, wanted: bool) -> io::Result<()> {
        self.handle_mouse(wanted)
    }

    fn follow(&mut self, file: Option<&Path>) -> bool {
        self.follow(file)
    }

    fn wait(
        &mut self,
        deadline: Option<Instant>,
        bell: Option<BorrowedFd<'_>>,
    ) -> io::Result<Vec<Wake>> {
        self.wait(deadline, bell)
    }
}
