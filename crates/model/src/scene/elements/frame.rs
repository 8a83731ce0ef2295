//! Converts links that are the frame to vectors: `r1 = { from = "D", to = "A", length = 400 }`
//! between two points of the ground.
//!
//! Lecture notes count the frame as a link, so scene files may contain it as one. It carries
//! nothing and cannot move: as a link it would only repeat the ground. It becomes the vector that
//! `[vectors]` would define.

use crate::Vec2;
use crate::scene::elements::link::DraftLink;
use crate::scene::elements::points::DraftVector;
use crate::scene::elements::slide::DraftSlider;
use crate::scene::inputs::input::DraftDriver;
use crate::scene::loading::loads::DraftLoad;
use crate::scene::raw_elements::SceneDraft;
use std::collections::HashMap;
use std::collections::HashSet;

/// Maximum relative difference between a manually computed length and the distance of its ends.
const LENGTH_TOLERANCE: f64 = 1e-9;

/// Converts the links that are the frame to vectors. A link whose length differs from the distance
/// of its ends stays a link, and a later check reports that it does not fit.
pub(crate) fn as_vectors(draft: &mut SceneDraft<'_>) {
    let ground = draft.ground.iter();
    let ground: HashMap<&str, Vec2> = ground
        .filter_map(|point| Some((point.name.text, point.read?)))
        .collect();
    let carriers = carriers(draft);
    let is_frame = |link: &mut DraftLink<'_>| {
        let Some(ends) = &link.ends else { return false };
        let [from, to] = [&ends.from, &ends.to].map(|end| ground.get(end.text));
        let away = from.zip(to).map(|(from, to)| (*to - *from).norm());
        let fits = away.is_some_and(|away| (ends.length - away).abs() <= LENGTH_TOLERANCE * away);
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

/// Returns the names of the links used as links: driven, sliding, carrying a guide, or with a load.
fn carriers<'t>(draft: &SceneDraft<'t>) -> HashSet<&'t str> {
    let driven = draft.driver.iter().filter_map(DraftDriver::driven_link);
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
