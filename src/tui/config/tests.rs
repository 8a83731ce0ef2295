use super::*;
use crate::tui::app::View;
use crate::tui::commands::action::{Action, entries};
use crate::tui::commands::key::Key;

/// Returns the text with every commented-out setting activated.
fn uncommented(text: &str) -> String {
    let live = |line: &str| match line.strip_prefix('#') {
        Some(rest) if !rest.starts_with(' ') && !rest.is_empty() => rest.to_owned(),
        _ => line.to_owned(),
    };
    text.lines().map(|line| live(line) + "\n").collect()
}

#[test]
fn template_parses_to_default_configuration() {
    let text = template();
    assert!(text.is_ascii());
    assert!(text.lines().all(|line| line.len() <= 100), "{text}");
    assert_eq!(Config::parse(&text, "t").unwrap(), Config::default());
    let live = uncommented(&text);
    assert!(live.matches('=').count() > 60, "{live}");
    assert_eq!(Config::parse(&live, "t").unwrap(), Config::default());
    for known in KEYS {
        assert!(live.contains(&format!("{known} = ")) || live.contains(&format!("[{known}]")));
    }
}

#[test]
fn given_settings_override_defaults() {
    let text = "glyphs = 'ascii'\ncolour = \"256\"\ntour = false\n[keys]\nplay = [\"F5\", \"space\"]\nnext = []\nstep = \"n\"\n";
    let config = Config::parse(text, "t").unwrap();
    assert_eq!(config.glyphs, Some(Glyphs::Ascii));
    assert_eq!(config.colours, Some(Colours::Indexed));
    assert!(!config.tour);
    let action = |key| config.keymap.action(key, View::Motion);
    assert_eq!(action(Key::Function(5)), Some(Action::Play));
    assert_eq!(action(Key::Char(' ')), Some(Action::Play));
    assert_eq!(action(Key::Char('n')), Some(Action::StepForward));
    assert_eq!(action(Key::Char('.')), None);
    assert_eq!(config.keymap.key(Action::NextPreset), None);
    assert_eq!(Config::parse("\u{feff}", "t"), Ok(Config::default()));
}

#[test]
fn every_action_can_be_bound_by_its_name() {
    for entry in entries().filter(|entry| keys::is_free(entry)) {
        let text = format!("[keys]\n{} = \"F12\"\n", entry.name);
        let keymap = Config::parse(&text, "t").unwrap().keymap;
        let bound = entries().filter(|of| keymap.keys(of.action) == [Key::Function(12)]);
        let bound: Vec<Action> = bound.map(|of| of.action).collect();
        assert_eq!(bound, [entry.action], "{}", entry.name);
    }
}

/// Every fault names its line, the cause and a fix.
#[test]
fn faults_report_line_and_fix() {
    for (text, line, message, fix) in [
        (
            "glyfs = \"ascii\"",
            1,
            "the configuration: unknown key `glyfs`",
            "did you mean `glyphs`?",
        ),
        // Help for scenes would be wrong here.
        (
            "bar = 1",
            1,
            "the configuration: unknown key `bar`",
            "known keys: `glyphs`",
        ),
        (
            "gears = 1",
            1,
            "the configuration: unknown key `gears`",
            "known keys: `glyphs`",
        ),
        (
            "\nglyphs = \"asci\"",
            2,
            "`glyphs` cannot be `asci`",
            "did you mean `ascii`?",
        ),
        (
            "colour = 16",
            1,
            "`colour` must be a text in quotes, not a number",
            "write it in quotes: \"16\"",
        ),
        (
            "tour = \"no\"",
            1,
            "`tour` must be true or false, not a text",
            "write it without quotes: false",
        ),
        (
            "keys = 1",
            1,
            "[keys] must be a table, not a number",
            "for example: play = ",
        ),
        (
            "[keys]\nplya = \"F5\"",
            2,
            "[keys]: unknown action `plya`",
            "did you mean `play`?",
        ),
        (
            "[keys]\ncoffee-with-milk = \"F5\"",
            2,
            "unknown action",
            "list the actions with `krank config`",
        ),
        (
            "[keys]\nplay = \"spcae\"",
            2,
            "no key is named `spcae`",
            "did you mean `space`?",
        ),
        (
            "[keys]\nplay = \"ctrl-p\"",
            2,
            "no key is named `ctrl-p`",
            "did you mean `Ctrl-P`?",
        ),
        (
            "[keys]\nplay = \"\u{e4}\"",
            2,
            "no key is named",
            "a printable ASCII character",
        ),
        (
            "[keys]\nplay = 5",
            2,
            "`play` must be a key or a list of keys, not a number",
            "for example: play = ",
        ),
        (
            "[keys]\nplay = [\n 5]",
            3,
            "`play` must be a key or a list of keys",
            "for example",
        ),
        (
            "[keys]\nquit = []",
            2,
            "`quit` must have a key",
            "default: q",
        ),
        (
            "[keys]\nhelp = []",
            2,
            "`help` must have a key",
            "default: ? F1",
        ),
        (
            "[keys]\nleave = \"F9\"",
            2,
            "[keys]: the key of `leave` is fixed",
            "Ctrl-C always quits",
        ),
        (
            "[keys]\nback = \"F9\"",
            2,
            "[keys]: the key of `back` is fixed",
            "Esc always goes back",
        ),
        (
            "[keys]\nplay = \"Ctrl-C\"",
            2,
            "Ctrl-C always quits",
            "choose another key",
        ),
        (
            "[keys]\nplay = \"Esc\"",
            2,
            "Esc always goes back",
            "choose another key",
        ),
        (
            "[keys]\nplay = \"Ctrl-I\"",
            2,
            "terminals send Ctrl-I as Tab",
            "choose another key",
        ),
        (
            "[keys]\nplay = \"n\"",
            2,
            "the key n is assigned to both `play` and `next`",
            "or none: next = []",
        ),
        (
            "[keys]\nplay = \"F5\"\nnext = \"F5\"",
            3,
            "the key F5 is assigned to both `play` and `next`",
            "",
        ),
        (
            "[keys]\nplay = [\"F5\", \"F5\"]",
            2,
            "the key F5 is assigned to `play` twice",
            "",
        ),
        (
            "[keys]\nsave = \"m\"",
            2,
            "the key m is assigned to both `extrema` and `save`",
            "extrema = []",
        ),
        (
            "[keys]\nplay = space",
            2,
            "not valid TOML",
            "quote texts and keys",
        ),
        (
            "[keys]\nplay = \"F5\"\nplay = \"F6\"",
            3,
            "`play` is given twice",
            "",
        ),
    ] {
        let (faults, can_start) = match Config::parse(text, "config.toml") {
            Ok(config) => (config.warnings.unwrap(), true),
            Err(faults) => (faults, false),
        };
        assert_eq!(faults.items.len(), 1, "{text:?}: {faults}");
        let fault = &faults.items[0];
        let is_unknown = message.contains("unknown") || message.contains("no key is named");
        assert_eq!(
            (fault.is_warning, can_start),
            (is_unknown, is_unknown),
            "{text:?}"
        );
        assert_eq!(
            faults.position(fault).map(|(line, _)| line),
            Some(line),
            "{faults}"
        );
        assert!(fault.message.contains(message), "{text:?}: {faults}");
        let mends = fault.suggestions.join("\n");
        assert!(mends.contains(fix), "{text:?}: {faults}");
        assert!(faults.to_string().contains("config.toml:"), "{faults}");
    }
}

/// An action whose configured keys are all unknown keeps its default keys.
#[test]
fn unknown_key_names_keep_known_bindings() {
    let text = "[keys]\nplay = \"F99\"\nnext = [\"F98\", \"F7\"]\nfly = \"F6\"\n";
    let config = Config::parse(text, "t").unwrap();
    let action = |key| config.keymap.action(key, View::Motion);
    assert_eq!(action(Key::Char(' ')), Some(Action::Play));
    assert_eq!(action(Key::Function(7)), Some(Action::NextPreset));
    assert_eq!(action(Key::Char('n')), None);
    assert_eq!(config.warnings.unwrap().items.len(), 3);
}

#[test]
fn config_path_follows_xdg_base_directories() {
    let env = |config: &'static str, home: &'static str| {
        Config::path(move |name| {
            let value = match name {
                "XDG_CONFIG_HOME" => config,
                "HOME" => home,
                _ => "",
            };
            (!value.is_empty()).then(|| value.into())
        })
    };
    let path = |text: &str| Some(PathBuf::from(text));
    assert_eq!(env("/c", "/h"), path("/c/krank/config.toml"));
    assert_eq!(env("", "/h"), path("/h/.config/krank/config.toml"));
    // The XDG specification ignores relative paths.
    assert_eq!(env("c", "/h"), path("/h/.config/krank/config.toml"));
    assert_eq!(env("", "h"), None);
    assert_eq!(env("", ""), None);
}
