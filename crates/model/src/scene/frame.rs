//! The frame written as a link: `r1 = { from = "D", to = "A", length = 400 }` between two points of the ground.
//!
//! Lecture notes count the frame among the links, and so it is written as one. It carries nothing and cannot move:
//! as a link it would only repeat what the ground says already. It is the vector that `[vectors]` would make of it.

use super::draft::SceneDraft;
use super::input::DraftInput;
use super::link::DraftLink;
use super::loads::DraftLoad;
use super::points::DraftVector;
use super::slide::DraftSlider;
use crate::Vec2;
use std::collections::HashMap;
use std::collections::HashSet;

/// What a length that was worked out by hand may miss of the distance: part of it.
const ROUNDED: f64 = 1e-9;

/// Makes vectors of the links that are the frame. One whose length is another than the distance of its ends stays a
/// link, which then does not fit and is told so.
pub(super) fn as_vectors(draft: &mut SceneDraft<'_>) {
    let ground = draft.ground.iter();
    let ground: HashMap<&str, Vec2> = ground
        .filter_map(|point| Some((point.name.text, point.read?)))
        .collect();
    let carriers = carriers(draft);
    let is_frame = |link: &mut DraftLink<'_>| {
        let Some(ends) = &link.ends else { return false };
        let [from, to] = [&ends.from, &ends.to].map(|end| ground.get(end.text));
        let away = from.zip(to).map(|(from, to)| (*to - *from).norm());
        let fits = away.is_some_and(|away| (ends.length - away).abs() <= ROUNDED * away);
        let carries = !link.points.is_empty() || link.com.is_some() || link.mass_key.is_some();
        fits && !carries && !link.broken && !carriers.contains(link.name.text)
    };
    let frames = draft.links.extract_if(.., is_frame);
    let of_frame = &mut draft.tolerances.of_frame;
    let vectors = frames.filter_map(|link| {
        let ends = link.ends?;
        let name = link.name.to_string();
        of_frame.extend(link.tolerance.map(|tolerance| (name, tolerance)));
        Some(DraftVector {
            name: link.name,
            tail: ends.from,
            head: ends.to,
        })
    });
    draft.vectors.extend(vectors);
}

/// The links that are spoken of as links: driven, sliding, with a guide or a load on them.
fn carriers<'t>(draft: &SceneDraft<'t>) -> HashSet<&'t str> {
    let driven = draft
        .driver
        .iter()
        .filter_map(|driver| match &driver.input {
            DraftInput::Link(name) => Some(name),
            DraftInput::Slide(_) => None,
        });
    let slides = draft.slides.iter().flat_map(|slide| {
        let sliding = match &slide.slider {
            Some(DraftSlider::Link { link, .. }) => Some(link),
            Some(DraftSlider::Pin(_)) | None => None,
        };
        sliding.into_iter().chain(&slide.on)
    });
    let loads = draft.loads.iter().filter_map(|load| match load {
        DraftLoad::Force { frame, .. } => frame.as_ref(),
        DraftLoad::Torque { link, .. } => Some(link),
        DraftLoad::Press { .. } => None,
    });
    let all = driven.chain(slides).chain(loads);
    all.map(|name| name.text).collect()
}
