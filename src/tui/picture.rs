//! Renders the workbench's screen as text, without a terminal.

use super::{Colours, OpenedScene, Options, Workbench};
use crate::capability::{Capability, TerminalProfile};
use crate::drawing::Glyphs;
use ratatui::layout::Size;

/// Returns the initial screen, `cols` x `rows` characters, as text. Neither needs nor queries a
/// terminal. Timed measurements are completed first.
///
/// Glyphs follow from the environment, as for the workbench itself, or are ASCII if the workbench
/// would not open there.
#[must_use]
pub fn picture(opened: OpenedScene, options: &Options, cols: u16, rows: u16) -> String {
    let judgement = TerminalProfile::of(|name| std::env::var(name).ok());
    // Text has no colours, so the drawing must express them in another form.
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
        .with_view(options.view.unwrap_or_default());
    workbench.finish();
    workbench.text()
}
