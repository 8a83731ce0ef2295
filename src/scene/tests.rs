use super::Scene;
use super::presets::{all, find};
use crate::wording::Language;

/// Changing a word of a preset leaves its sentence without a translation.
#[test]
fn preset_texts_have_turkish_translations() {
    Language::Turkish.speak();
    for preset in all() {
        let scene = Scene::parse(preset.text, preset.name).unwrap();
        let texts = [
            Some(&scene.name),
            scene.source.as_ref(),
            scene.note.as_ref(),
        ];
        for text in texts.into_iter().flatten() {
            let message = crate::wording::words().translated_scene_text(text);
            assert_ne!(&message, text, "{}", preset.name);
            let figures = |text: &str| -> Vec<String> {
                let figures = text.split(|c: char| !c.is_ascii_digit() && c != '.');
                let figures = figures.map(|it| it.trim_matches('.').to_owned());
                let mut figures: Vec<String> = figures.filter(|it| !it.is_empty()).collect();
                figures.sort();
                figures
            };
            // Every number of the original is in the translation, except in words such as
            // "three legs".
            let (one, other) = (figures(text), figures(&message));
            let lost = one.iter().find(|it| !other.contains(it));
            assert_eq!(lost, None, "{message}");
        }
    }
}

#[test]
fn preset_title_follows_language() {
    let scene = Scene::parse(find("kite").unwrap().text, "kite").unwrap();
    assert_eq!(scene.title(), "Kite");
    Language::Turkish.speak();
    assert_eq!(scene.title(), "U\u{e7}urtma");
    let mut own = scene;
    own.name = "Mine".into();
    assert_eq!((own.title().as_str(), own.name.as_str()), ("Mine", "Mine"));
}
