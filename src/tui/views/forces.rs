//! Forces: their place is kept. What the scene gives for them is counted, so that nobody takes loads
//! that were read for loads that act.

use super::print;
use crate::tui::app::App;
use crate::tui::theme::{self, Part};
use crate::{Load, Mechanism, Vec2};
use ratatui::buffer::Buffer;
use ratatui::layout::Rect;

pub(super) fn render(app: &App, area: Rect, buffer: &mut Buffer) {
    let given = given(&app.stage().scene().mechanism);
    let lines = [
        "Forces are not computed yet.",
        "",
        given.as_str(),
        "No other figure depends on them.",
    ];
    for (y, line) in (area.top()..area.bottom()).zip(lines) {
        let style = theme::part(Part::Text);
        print(buffer, area.x, y, area.width, line, style);
    }
}

/// What the scene has that forces would follow from.
fn given(mechanism: &Mechanism) -> String {
    let masses = mechanism.links().iter().filter(|l| l.mass > 0.0).count();
    let is_force = |load: &&Load| matches!(load, Load::Force { .. });
    let forces = mechanism.loads().iter().filter(is_force).count();
    let torques = mechanism.loads().len() - forces;
    let gravity = usize::from(mechanism.gravity() != Vec2::ZERO);
    let kinds = [
        (forces, "force"),
        (torques, "torque"),
        (masses, "mass"),
        (gravity, "gravity"),
    ];
    let told: Vec<String> = kinds
        .into_iter()
        .filter(|(count, _)| *count > 0)
        .map(|(count, what)| match (what, count) {
            ("gravity", _) => what.to_owned(),
            (_, 1) => format!("1 {what}"),
            ("mass", _) => format!("{count} masses"),
            _ => format!("{count} {what}s"),
        })
        .collect();
    if told.is_empty() {
        "The scene has no loads and no masses.".into()
    } else {
        format!("The scene gives: {}.", told.join(", "))
    }
}
