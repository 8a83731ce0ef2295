//! The help window over the view.

use super::Turkish;
use crate::wording::english::HelpingWords;
use std::fmt::Display;

catalogue! {
    impl HelpingWords for Turkish {
        help_title = "Yardım";
        help_topic(topic: &str, page: usize, pages: usize) = "Yardım: {topic}  {page}/{pages}";
        no_key_does_that = "bunu yapan tuş yok";
        esc_shows_all_keys = "Esc bütün tuşları gösterir";
        turns_to_manual(key: &dyn Display) = "{key} el kitabı";
        shows_more(key: &dyn Display) = "{key} devamı";
        no_command_is_that = "böyle bir komut yok";
        save_and_quit = "kaydet ve çık";
        save_to(file: &str) = "{file} dosyasına kaydet";
        open_named(name: &str) = "{name} aç";
        go_to_coordinate(at: &str) = "{at} konumuna git";
        theme_is(name: &str) = "tema: {name}; kalıcı olması için config.toml dosyasına theme = \"{name}\" yazın";
        manual_of(topic: &str, about: &str) = "el kitabı, {topic}: {about}";
        manual_tells_of_it(topics: &str) = "el kitabına bakın: {topics}";
        manual_title = "krank el kitabı";
        topics_of_manual = "Konular";
        search_manual = "Ara";
        nowhere = "bulunamadı";
        marks_of_figures(found: char) = "{found} bulunan, gerisi verilen";
        marks_of_figures_and_digits(found: char, unsure: char) =
            "{found} bulunan, gerisi verilen; {unsure} kanıtlanmayan haneler";
        marks_of_figures_and_dim_digits(found: char) =
            "{found} bulunan, gerisi verilen; soluk haneler kanıtsız";
    }
}
