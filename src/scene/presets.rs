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
