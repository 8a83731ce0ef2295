//! Errors of the configuration, and the template of `krank config`.

use super::English;
use std::fmt::Display;

catalogue! {
    /// Errors of a configuration, and the text that `krank config` prints.
    trait ConfigurationWords for English {
        the_configuration = "the configuration";
        quote_texts_and_keys = "quote texts and keys: \"space\"";
        write_name_and_value = "write name = value";

        // Values.
        value_cannot_be(key: &str, given: &dyn Display) = "`{key}` cannot be {given}";
        unknown_value = "unknown value";
        known_values(quoted: &str) = "known values: {quoted}";
        separator_is_decimal = "`separator` and `decimal` cannot both be a comma";
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
        config_lists_actions = "list the actions with `krank config`";
        must_have_a_key(name: &str) = "{name} must have a key";
        no_key_here = "no key";
        by_default(keys: &str) = "default: {keys}";
        keeps_its_key(name: &str) = "[keys]: the key of {name} is fixed";
        cannot_be_changed = "cannot be changed";
        always_leaves(key: &dyn Display) = "{key} always quits";
        always_goes_back(key: &dyn Display) = "{key} always goes back";

        // Keys.
        a_key_or_keys = "a key or a list of keys";
        for_example_keys(name: &str) = "for example: {name} = [\"space\", \"F5\"]";
        no_key_called(name: &str) = "no key is named {name}";
        unknown_key = "unknown key";
        how_keys_are_called =
            "write a printable ASCII character, or the name of a key as in the help:\n\
             space, Enter, Tab, Shift-Tab, Backspace, Left, Right, Up, Down, Home, End,\n\
             PgUp, PgDn, F1 to F24, Ctrl-A to Ctrl-Z";
        cannot_be_given_away = "cannot be reassigned";
        choose_another_key = "choose another key";
        sent_as(key: &dyn Display, sent: &dyn Display) = "terminals send {key} as {sent}";
        never_seen = "never received";
        key_given_twice(key: &dyn Display, action: &str) = "the key {key} is assigned to `{action}` twice";
        key_given_to_both(key: &dyn Display, one: &str, other: &str) =
            "the key {key} is assigned to both `{one}` and `{other}`";
        once_more = "again";
        here = "here";
        here_too = "and here";
        has_it_by_default(action: &str) = "the default key of `{action}`";
        give_another_key(action: &str) = "assign another key to `{action}`, or none: {action} = []";

        // The template of `krank config`.
        template_head = "\
# The configuration of krank, read from $XDG_CONFIG_HOME/krank/config.toml, or from
# ~/.config/krank/config.toml if that is not set. krank never writes this file.
#
# Every line is a comment that shows a default: remove the # before a line to change it.
# krank reports errors with their line when it starts, and ignores unknown names.

";
        for_a_ground(values: &str) = "background: {values}";
        pictures_are_sent_by(values: &str) = "{values}";
        languages_are(values: &str) = "{values}";
        decimals_of_csv(values: &str) = "in CSV files: {values}";
        separators_of_csv(values: &str) = "{values}";
        panes_stand_as(values: &str) = "panes: {values}";
        mouse_from_the_start = "use the mouse from the start: true or false";
        tour_on_first_start = "show the tour on the first start: true or false";
        template_keys = "
[keys]
# A key or a list of keys for each action, named as in the help: \"g\", \"space\", \"F5\",
# \"Ctrl-R\", \"PgUp\". An empty list removes the keys. Ctrl-C always quits, and Esc always
# goes back.
";
    }
}
