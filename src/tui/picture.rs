//! The screen of the workbench without a terminal.

use super::{Colours, Opened, Options, Workbench};
use crate::capability::{Capability, Judgement};
use crate::drawing::Glyphs;
use ratatui::layout::Size;

/// The screen that opens, of `cols` x `rows` characters, as text; no terminal is needed, and nothing is
/// asked of one. What is measured by time is measured to its end.
///
/// Glyphs follow from the environment, as for the workbench itself; where that would not open they are
/// ASCII.
#[must_use]
pub fn picture(opened: Opened, options: &Options, cols: u16, rows: u16) -> String {
    let judgement = Judgement::of(|name| std::env::var(name).ok());
    // Text has no colours: what they say is said in another way.
    let colours = Colours::None;
    let capability = judgement.capability(options.glyphs, Some(colours));
    let capability = capability.unwrap_or(Capability {
        glyphs: options.glyphs.unwrap_or(Glyphs::Ascii),
        colours,
        modern: false,
    });
    let size = Size::new(cols, rows);
    let workbench = Workbench::on(opened, options.at, capability, size);
    let mut workbench = workbench
        .configured(&options.config)
        .looking_at(options.view.unwrap_or_default());
    workbench.finish();
    workbench.text()
}
