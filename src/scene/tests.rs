//! The reading of good scenes.

use super::*;
use crate::{Body, Input, Load, Slider, Vec2};

fn preset(name: &str) -> Scene {
    let preset = presets::find(name).unwrap();
    Scene::parse(preset.text, name).unwrap_or_else(|faults| panic!("{faults}"))
}

fn point(scene: &Scene, name: &str) -> PointId {
    let mut ids = scene.mechanism.point_ids();
    let found = ids.find(|&id| scene.point_name(id) == Some(name));
    found.unwrap_or_else(|| panic!("no point {name}"))
}

#[test]
fn the_four_bar_is_what_its_file_says() {
    let scene = preset("four-bar");
    let m = &scene.mechanism;
    let names: Vec<_> = m
        .point_ids()
        .map(|id| scene.point_name(id).unwrap())
        .collect();
    assert_eq!(names, ["A", "D", "B", "C", "r2.com", "r3.com", "r4.com"]);
    assert_eq!(
        m.point(point(&scene, "D")).ground,
        Some(Vec2::new(400.0, 0.0))
    );
    let links: Vec<_> = m.link_ids().map(|id| scene.link_name(id)).collect();
    assert_eq!(links, ["r2", "r3", "r4"]);
    let rocker = &m.links()[2];
    assert_eq!(rocker.ends, Some((point(&scene, "C"), point(&scene, "D"))));
    assert_eq!(
        rocker.local(point(&scene, "D")),
        Some(Vec2::new(250.0, 0.0))
    );
    assert_eq!(rocker.com, Some(point(&scene, "r4.com")));
    assert_eq!(
        rocker.local(point(&scene, "r4.com")),
        Some(Vec2::new(125.0, 0.0))
    );
    let driver = m.driver();
    assert_eq!(driver.input, Input::Turn(m.link_ids().next().unwrap()));
    assert_eq!(
        (driver.start, driver.speed, driver.acceleration),
        (60.0, 15.0, 0.0)
    );
    assert_eq!(m.start(), [(point(&scene, "C"), Vec2::new(310.0, 230.0))]);
    let vectors: Vec<_> = scene.vectors.iter().map(|v| v.name.as_str()).collect();
    assert_eq!(vectors, ["r2", "r3", "r4", "r1"]);
    let frame = VectorKind::Between(point(&scene, "D"), point(&scene, "A"));
    assert_eq!(scene.vectors[3].kind, frame);
    assert_eq!(scene.unit, Unit::Millimetre);
}

#[test]
fn the_slider_crank_has_its_slide_as_a_vector() {
    let scene = preset("slider-crank");
    let slide = &scene.mechanism.slides()[0];
    assert_eq!(slide.slider, Slider::Pin(point(&scene, "C")));
    assert_eq!(slide.on, Body::Ground);
    assert_eq!((slide.through, slide.direction), (Vec2::ZERO, Vec2::X));
    assert!(matches!(scene.vectors[2].kind, VectorKind::Slide(_)));
    assert_eq!(scene.vectors[2].name, "r4");
    assert_eq!(scene.unit, Unit::Centimetre);
}

#[test]
fn every_preset_opens() {
    for preset in presets::all() {
        let scene =
            Scene::parse(preset.text, preset.name).unwrap_or_else(|faults| panic!("{faults}"));
        assert!(
            scene.source.is_some() && scene.note.is_some(),
            "{}",
            preset.name
        );
    }
}
