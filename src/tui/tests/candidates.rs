//! The list of candidates as it is said in another language, and without a clock of its own.

use crate::capability::{Capability, Colours};
use crate::drawing::Glyphs;
use crate::scene::presets;
use crate::task_file::{ExampleTask, TaskFile};
use crate::tui::document::opening;
use crate::tui::{TaskOrder, Workbench};
use crate::wording::Language;
use ratatui::layout::Size;

/// The four-bar, and over it the linkages for the hatch.
fn looking_for_hatch(size: Size) -> Workbench {
    let capability = Capability {
        glyphs: Glyphs::Ascii,
        colours: Colours::None,
        modern: false,
    };
    let opened = opening::preset(presets::find("four-bar").unwrap()).unwrap();
    let file = TaskFile::parse(ExampleTask::find("hatch").unwrap().text, "hatch").unwrap();
    let workbench = Workbench::on(opened, None, capability, size);
    workbench.synthesizing(TaskOrder::new(file, "hatch".into()))
}

#[test]
fn candidates_are_told_in_the_language_that_is_spoken() {
    for size in [Size::new(40, 12), Size::new(80, 24), Size::new(120, 40)] {
        Language::English.speak();
        let mut changed = looking_for_hatch(size);
        let english = changed.text();
        Language::Turkish.speak();
        let turkish = looking_for_hatch(size).text();
        Language::English.speak();
        for told in ["hatch icin meka", "sapma mm baglama krank", "kusurlu"] {
            let said = turkish.split_whitespace().collect::<Vec<_>>().join(" ");
            assert!(said.contains(told), "{told}\n{turkish}");
        }
        assert_ne!(english, turkish);
        // What was found before says itself again.
        changed.press("Esc B o Home Enter");
        assert_eq!(changed.text(), turkish, "{size}");
        Language::English.speak();
    }
}

/// Frames come while it is played, and none where it stands.
#[test]
fn a_candidate_that_stands_asks_for_no_frame() {
    let mut workbench = looking_for_hatch(Size::new(80, 24));
    assert_eq!(workbench.app().next_frame(), None);
    workbench.press("space");
    assert!(workbench.app().next_frame().is_some());
    workbench.press("Right");
    assert_eq!(workbench.app().next_frame(), None);
}
