//! The configuration: what is wrong with it, and how it begins.

use super::English;
use std::fmt::Display;

catalogue! {
    /// Faults of a configuration, and the text that `krank config` prints.
    trait ConfigurationWords for English {
        the_configuration = "the configuration";
        quote_texts_and_keys = "texts and keys are quoted: \"space\"";
        write_name_and_value = "write name = value";

        // Values.
        value_cannot_be(key: &str, given: &dyn Display) = "`{key}` cannot be {given}";
        unknown_value = "unknown value";
        known_values(quoted: &str) = "known values: {quoted}";
        separator_is_decimal = "`separator` cannot be a comma where `decimal` is one";
        take_a_semicolon = "write \"semicolon\" or \"tab\"";

        ignored(first: &str, more: usize) = {
            match more {
                0 => first.to_owned(),
                _ => format!("{first}, and {more} more"),
            }
        };

        // Actions.
        unknown_action(name: &str) = "[keys]: unknown action {name}";
        unknown_action_here = "unknown action";
        config_lists_actions = "`krank config` lists all actions";
        must_have_a_key(name: &str) = "{name} must have a key";
        no_key_here = "no key";
        by_default(keys: &str) = "by default it has {keys}";
        keeps_its_key(name: &str) = "[keys]: {name} keeps its key";
        cannot_be_changed = "cannot be changed";
        always_leaves(key: &dyn Display) = "{key} always leaves";
        always_goes_back(key: &dyn Display) = "{key} always goes back";

        // Keys.
        a_key_or_keys = "a key or a list of keys";
        for_example_keys(name: &str) = "for example: {name} = [\"space\", \"F5\"]";
        no_key_called(name: &str) = "no key is called {name}";
        unknown_key = "unknown key";
        how_keys_are_called =
            "a key is a printable ASCII character, or is called as the help shows it:\n\
             space, Enter, Tab, Shift-Tab, Backspace, Left, Right, Up, Down, Home, End,\n\
             PgUp, PgDn, F1 to F24, Ctrl-A to Ctrl-Z";
        cannot_be_given_away = "cannot be given away";
        choose_another_key = "choose another key";
        sent_as(key: &dyn Display, sent: &dyn Display) = "terminals send {key} as {sent}";
        never_seen = "never seen";
        key_given_twice(key: &dyn Display, action: &str) = "the key {key} is given to `{action}` twice";
        key_given_to_both(key: &dyn Display, one: &str, other: &str) =
            "the key {key} is given to `{one}` and to `{other}`";
        once_more = "once more";
        here = "here";
        here_too = "here too";
        has_it_by_default(action: &str) = "`{action}` has it by default";
        give_another_key(action: &str) =
            "give `{action}` another key, or none: {action} = []";

        // What `krank config` prints.
        template_head = "\
# The configuration of krank, read from $XDG_CONFIG_HOME/krank/config.toml, or from
# ~/.config/krank/config.toml where that is not set. krank never writes it.
#
# Everything here is commented out and says what is built in: take away the # before a
# line to change it. What is wrong is told with its line when krank starts; names that it
# does not know are left out.

";
        for_a_ground(values: &str) = "for a ground: {values}";
        pictures_are_sent_by(values: &str) = "{values}";
        languages_are(values: &str) = "{values}";
        decimals_of_csv(values: &str) = "in CSV files: {values}";
        separators_of_csv(values: &str) = "{values}";
        panes_stand_as(values: &str) = "panes: {values}";
        mouse_from_the_start = "the mouse is krank's from the start: true or false";
        tour_on_first_start = "the tour is shown on the first start: true or false";
        template_keys = "
[keys]
# A key or a list of keys for each action, written as the help shows them: \"g\", \"space\",
# \"F5\", \"Ctrl-R\", \"PgUp\". An empty list takes the keys away. Ctrl-C always leaves, and Esc
# always goes back.
";
    }
}
