//! The help window over the view.

use super::English;
use std::fmt::Display;

catalogue! {
    /// The help window and the manual.
    trait HelpingWords for English {
        help_title = "Help";
        help_topic(topic: &str, page: usize, pages: usize) = "Help: {topic}  {page}/{pages}";
        no_key_does_that = "no key does that";
        esc_shows_all_keys = "Esc shows all keys";
        turns_to_manual(key: &dyn Display) = "{key} manual";
        shows_more(key: &dyn Display) = "{key} for more";
        no_command_is_that = "no such command";
        save_and_quit = "save and quit";
        save_to(file: &str) = "save to {file}";
        open_named(name: &str) = "open {name}";
        go_to_coordinate(at: &str) = "go to {at}";
        theme_is(name: &str) = "theme: {name}; to keep it, set theme = \"{name}\" in config.toml";
        manual_of(topic: &str, about: &str) = "manual, {topic}: {about}";
        manual_tells_of_it(topics: &str) = "see the manual: {topics}";
        manual_title = "krank manual";
        topics_of_manual = "Topics";
        search_manual = "Search";
        nowhere = "no hits";
        marks_of_figures(found: char) = "{found} found, rest given";
        marks_of_figures_and_digits(found: char, unsure: char) =
            "{found} found, rest given; {unsure} for digits that are unproved";
        marks_of_figures_and_dim_digits(found: char) = "{found} found, rest given; dim digits are unproved";
    }
}
