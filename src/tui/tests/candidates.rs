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
    let text = ExampleTask::find("hatch").unwrap().text;
    looking_for(text, "hatch", size)
}

/// The same for its first four poses, which leave curves open.
fn looking_for_four_poses(size: Size) -> Workbench {
    let text = ExampleTask::find("hatch").unwrap().text;
    let text = text.replace(", [-250, 26.9, -24.3]]", "]");
    looking_for(&text, "four", size)
}

fn looking_for(text: &str, name: &str, size: Size) -> Workbench {
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

/// Four poses: the curves are walked, two pivots with their pins make a linkage, and it is put where it belongs.
#[test]
fn curves_are_walked_and_two_picks_make_a_linkage() {
    for size in [Size::new(40, 12), Size::new(80, 24), Size::new(120, 40)] {
        let mut workbench = looking_for_four_poses(size);
        let before = workbench.app().candidates().unwrap().rows().len();
        // Without room for both the drawing lies between the list and the curves.
        let way = if size.width < 80 { "Tab Tab" } else { "Tab" };
        workbench.press(way);
        let place = |workbench: &mut Workbench| {
            let place = workbench.app().candidates().unwrap().walked_place();
            place.expect("a curve is walked")
        };
        let [(begun, _), _] = place(&mut workbench);
        workbench.press("Right Right");
        assert_eq!(place(&mut workbench)[0].0, begun + 2);
        workbench.press("Enter PgDn");
        let text = workbench.text();
        assert!(text.contains("on curve 2 of"), "{text}");
        // What two picks make is judged as every candidate is, and told at once.
        let told = |list: &crate::tui::views::candidates::list::CandidateList| {
            list.chosen().map(|(candidate, _)| candidate.clone())
        };
        let mut made = told(workbench.app().candidates().unwrap());
        for _ in 0..200 {
            if made.is_some() {
                break;
            }
            workbench.press("Right");
            made = told(workbench.app().candidates().unwrap());
        }
        let made = made.expect("some two of them make a linkage");
        workbench.press("Enter");
        let list = workbench.app().candidates().unwrap();
        assert_eq!(list.rows().len(), before + 1, "{size}");
        let (chosen, _) = list.chosen().unwrap();
        assert_eq!(*chosen, made, "the cursor is on it");
        assert_eq!(list.cursor() < list.count().0, made.does_it());
    }
}

/// From the second pick back to the first, to the list, and out.
#[test]
fn one_step_back_at_a_time() {
    let mut workbench = looking_for_four_poses(Size::new(80, 24));
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

/// Help that was opened over the list leads back to it.
#[test]
fn help_over_the_list_leads_back() {
    let mut workbench = looking_for_hatch(Size::new(80, 24));
    let list = workbench.text();
    for leave in ["Esc", "?"] {
        workbench.press("?");
        assert!(!workbench.text().contains("Linkages for"));
        workbench.press(leave);
        assert_eq!(workbench.text(), list);
    }
}
