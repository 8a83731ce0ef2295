//! Tests the list of candidates in both languages and with a simulated clock.

use crate::capability::{Capability, Colours};
use crate::drawing::Glyphs;
use crate::scene::presets;
use crate::task_file::{ExampleTask, TaskFile};
use crate::tui::document::opening;
use crate::tui::{TaskOrder, Workbench};
use crate::wording::Language;
use ratatui::layout::Size;

/// Opens the four-bar and searches linkages for the hatch task.
fn search_hatch(size: Size) -> Workbench {
    let text = ExampleTask::find("hatch").unwrap().text;
    search_linkages(text, "hatch", size)
}

/// Searches linkages for the first four poses of the hatch, which leave curves of solutions.
fn search_four_poses(size: Size) -> Workbench {
    let text = ExampleTask::find("hatch").unwrap().text;
    let text = text.replace(", [-250, 26.9, -24.3]]", "]");
    search_linkages(&text, "four", size)
}

fn search_linkages(text: &str, name: &str, size: Size) -> Workbench {
    let capability = Capability {
        glyphs: Glyphs::Ascii,
        colours: Colours::None,
        modern: false,
    };
    let opened = opening::preset(presets::find("four-bar").unwrap()).unwrap();
    let file = TaskFile::parse(text, name).unwrap();
    let workbench = Workbench::on(opened, None, capability, size);
    workbench.synthesizing(TaskOrder::new(file, name.into()))
}

#[test]
fn candidate_list_uses_current_language() {
    for size in [Size::new(40, 12), Size::new(80, 24), Size::new(120, 40)] {
        Language::English.speak();
        let mut changed = search_hatch(size);
        let english = changed.text();
        Language::Turkish.speak();
        let turkish = search_hatch(size).text();
        Language::English.speak();
        for shown_text in ["hatch icin meka", "sapma mm baglama krank", "kusurlu"] {
            let text = turkish.split_whitespace().collect::<Vec<_>>().join(" ");
            assert!(text.contains(shown_text), "{shown_text}\n{turkish}");
        }
        assert_ne!(english, turkish);
        // Candidates found before the change are translated.
        changed.press("Esc B o Home Enter");
        assert_eq!(changed.text(), turkish, "{size}");
        Language::English.speak();
    }
}

/// Frames are requested only during playback.
#[test]
fn paused_candidate_requests_no_frame() {
    let mut workbench = search_hatch(Size::new(80, 24));
    assert_eq!(workbench.app().next_frame(), None);
    workbench.press("space");
    assert!(workbench.app().next_frame().is_some());
    workbench.press("Right");
    assert_eq!(workbench.app().next_frame(), None);
}

/// With four poses the cursor moves along curves. Picking two pivots with their pins makes a
/// linkage, which is added to the list at its rank.
#[test]
fn two_picks_on_curves_add_a_candidate() {
    for size in [Size::new(40, 12), Size::new(80, 24), Size::new(120, 40)] {
        let mut workbench = search_four_poses(size);
        let before = workbench.app().candidates().unwrap().rows().len();
        // On a narrow screen the drawing is between the list and the curves.
        let way = if size.width < 80 { "Tab Tab" } else { "Tab" };
        workbench.press(way);
        let place = |workbench: &mut Workbench| {
            let place = workbench.app().candidates().unwrap().walked_place();
            place.expect("a curve is walked")
        };
        let [(started, _), _] = place(&mut workbench);
        workbench.press("Right Right");
        assert_eq!(place(&mut workbench)[0].0, started + 2);
        workbench.press("Enter PgDn");
        let text = workbench.text();
        assert!(text.contains("on curve 2 of"), "{text}");
        // A linkage from two picks is evaluated like any candidate and shown at once.
        let shown_text = |list: &crate::tui::views::candidates::list::CandidateList| {
            list.chosen().map(|(candidate, _)| candidate.clone())
        };
        let mut made = shown_text(workbench.app().candidates().unwrap());
        for _ in 0..200 {
            if made.is_some() {
                break;
            }
            workbench.press("Right");
            made = shown_text(workbench.app().candidates().unwrap());
        }
        let made = made.expect("some two of them make a linkage");
        workbench.press("Enter");
        let list = workbench.app().candidates().unwrap();
        assert_eq!(list.rows().len(), before + 1, "{size}");
        let (chosen, _) = list.chosen().unwrap();
        assert_eq!(*chosen, made, "the cursor is on it");
        assert_eq!(list.cursor() < list.count().0, made.meets_task());
    }
}

/// From the second pick to the first, to the list, and out of it.
#[test]
fn escape_goes_back_one_step_at_a_time() {
    let mut workbench = search_four_poses(Size::new(80, 24));
    workbench.press("Tab Enter Right Esc");
    assert!(
        workbench.text().contains("Enter selects it"),
        "{}",
        workbench.text()
    );
    workbench.press("Esc");
    assert!(
        !workbench.text().contains("Pivot and pin"),
        "{}",
        workbench.text()
    );
    assert!(
        workbench.text().contains("Linkages for"),
        "{}",
        workbench.text()
    );
    workbench.press("Esc");
    assert!(
        !workbench.text().contains("Linkages for"),
        "{}",
        workbench.text()
    );
}

/// The help is shown over the list, and closing it returns to the list.
#[test]
fn closing_help_returns_to_candidate_list() {
    let mut workbench = search_hatch(Size::new(80, 24));
    let list = workbench.text();
    for leave in ["Esc", "?"] {
        workbench.press("?");
        let screen = workbench.text();
        for shown in ["Linkages for", "In the list of linkages"] {
            assert!(screen.contains(shown), "{screen}");
        }
        workbench.press(leave);
        assert_eq!(workbench.text(), list);
    }
}
