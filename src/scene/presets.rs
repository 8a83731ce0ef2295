//! The built-in scenes.

/// A scene built into the program.
#[derive(Clone, Copy, Debug)]
pub struct Preset {
    /// The name on the command line.
    pub name: &'static str,
    /// The scene file's text.
    pub text: &'static str,
}

macro_rules! presets {
    ($($name:literal)*) => {
        &[$(Preset {
            name: $name,
            text: include_str!(concat!("../../presets/", $name, ".toml")),
        }),*]
    };
}

static PRESETS: &[Preset] = presets! {
    "four-bar"
    "slider-crank"
    "press"
    "press-ram"
    "four-bar-load"
    "engine"
    "offset-slider-crank"
    "slotted-lever"
    "whitworth"
    "scotch-yoke"
    "double-rocker"
    "drag-link"
    "watt-six-bar"
    "stephenson-six-bar"
    "jansen-leg"
    "klann-leg"
    "peaucellier"
    "hoecken"
    "toggle-press"
    "scissor-lift"
    "excavator-boom"
    "parallelogram"
    "antiparallelogram"
    "kite"
    "triple-parallelogram"
    "shaper"
    "knuckle-press"
    "drag-link-press"
    "v-twin"
    "radial-engine"
    "wiper"
    "double-wishbone"
    "ackermann"
    "backhoe"
    "lift-table"
    "five-bar"
    "robot-arm"
    "plotter"
    "excavator"
};

/// Returns all presets, in their order in lists.
#[must_use]
pub fn all() -> &'static [Preset] {
    PRESETS
}

/// Returns the preset of this name.
#[must_use]
pub fn find(name: &str) -> Option<&'static Preset> {
    PRESETS.iter().find(|preset| preset.name == name)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::scene::Scene;
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
}
