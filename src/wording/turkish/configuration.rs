//! The configuration: what is wrong with it, and how it begins.

use super::Turkish;
use crate::wording::english::ConfigurationWords;
use std::fmt::Display;

catalogue! {
    impl ConfigurationWords for Turkish {
        the_configuration = "ayar dosyası";
        quote_texts_and_keys = "metinler ve tuşlar tırnak içinde yazılır: \"space\"";
        write_name_and_value = "ad = değer yaz";

        // Values.
        value_cannot_be(key: &str, given: &dyn Display) = "`{key}` şu olamaz: {given}";
        unknown_value = "bilinmeyen değer";
        known_values(quoted: &str) = "bilinen değerler: {quoted}";
        separator_is_decimal = "`decimal` virgülken `separator` virgül olamaz";
        take_a_semicolon = "\"semicolon\" ya da \"tab\" yaz";

        ignored(first: &str, more: usize) = {
            match more {
                0 => first.to_owned(),
                _ => format!("{first}, ve {more} tane daha"),
            }
        };

        // Actions.
        unknown_action(name: &str) = "[keys]: bilinmeyen eylem {name}";
        unknown_action_here = "bilinmeyen eylem";
        config_lists_actions = "`krank config` bütün eylemleri sayar";
        must_have_a_key(name: &str) = "{name} için bir tuş olmalı";
        no_key_here = "tuş yok";
        by_default(keys: &str) = "yerleşik tuşu {keys}";
        keeps_its_key(name: &str) = "[keys]: {name} kendi tuşunda kalır";
        cannot_be_changed = "değiştirilemez";
        always_leaves(key: &dyn Display) = "{key} her zaman çıkar";
        always_goes_back(key: &dyn Display) = "{key} her zaman geri döner";

        // Keys.
        a_key_or_keys = "bir tuş ya da bir tuş listesi";
        for_example_keys(name: &str) = "örneğin: {name} = [\"space\", \"F5\"]";
        no_key_called(name: &str) = "{name} adında bir tuş yok";
        unknown_key = "bilinmeyen tuş";
        how_keys_are_called =
            "tuş, yazılabilir bir ASCII karakteridir ya da yardımda göründüğü gibi\n\
             adlandırılır: space, Enter, Tab, Shift-Tab, Backspace, Left, Right, Up, Down,\n\
             Home, End, PgUp, PgDn, F1 .. F24, Ctrl-A .. Ctrl-Z";
        cannot_be_given_away = "başka işe verilemez";
        choose_another_key = "başka bir tuş seç";
        sent_as(key: &dyn Display, sent: &dyn Display) = "terminaller {key} yerine {sent} gönderir";
        never_seen = "hiç görülmez";
        key_given_twice(key: &dyn Display, action: &str) = "{key} tuşu `{action}` eylemine iki kez verilmiş";
        key_given_to_both(key: &dyn Display, one: &str, other: &str) =
            "{key} tuşu hem `{one}` hem `{other}` eylemine verilmiş";
        once_more = "bir kez daha";
        here = "burada";
        here_too = "burada da";
        has_it_by_default(action: &str) = "yerleşik olarak `{action}` eyleminde";
        give_another_key(action: &str) =
            "`{action}` eylemine başka bir tuş ver ya da hiç verme: {action} = []";

        // What `krank config` prints.
        template_head = "\
# krank'ın ayarları; $XDG_CONFIG_HOME/krank/config.toml dosyasından, bu değişken yoksa
# ~/.config/krank/config.toml dosyasından okunur. krank onu hiç yazmaz.
#
# Buradaki her satır kapalıdır ve yerleşik olanı söyler: değiştirmek için satırın
# başındaki # işaretini kaldır. Yanlış olan, krank açılırken satırıyla söylenir; krank'ın
# tanımadığı adlar atlanır.

";
        for_a_ground(values: &str) = "zemine göre: {values}";
        pictures_are_sent_by(values: &str) = "{values}";
        languages_are(values: &str) = "{values}";
        decimals_of_csv(values: &str) = "CSV dosyalarında: {values}";
        separators_of_csv(values: &str) = "{values}";
        panes_stand_as(values: &str) = "bölmeler: {values}";
        mouse_from_the_start = "fare baştan krank'ın: true ya da false";
        tour_on_first_start = "ilk açılışta tur: true ya da false";
        template_keys = "
[keys]
# Her eylem için bir tuş ya da bir tuş listesi, yardımda göründüğü gibi: \"g\", \"space\",
# \"F5\", \"Ctrl-R\", \"PgUp\". Boş liste tuşları kaldırır. Ctrl-C her zaman çıkar, Esc her
# zaman geri döner.
";
    }
}
