//! Errors of the configuration, and the template of `krank config`.

use super::Turkish;
use crate::wording::english::ConfigurationWords;
use std::fmt::Display;

catalogue! {
    impl ConfigurationWords for Turkish {
        the_configuration = "ayar dosyası";
        quote_texts_and_keys = "metinleri ve tuşları tırnak içinde yazın: \"space\"";
        write_name_and_value = "ad = değer yazın";

        // Values.
        value_cannot_be(key: &str, given: &dyn Display) = "`{key}` değeri {given} olamaz";
        unknown_value = "bilinmeyen değer";
        known_values(quoted: &str) = "bilinen değerler: {quoted}";
        separator_is_decimal = "`separator` ve `decimal` birlikte virgül olamaz";
        take_a_semicolon = "\"semicolon\" ya da \"tab\" yazın";

        ignored(first: &str, more: usize) = {
            match more {
                0 => first.to_owned(),
                _ => format!("{first}, ve {more} tane daha"),
            }
        };

        // Actions.
        unknown_action(name: &str) = "[keys]: bilinmeyen eylem {name}";
        unknown_action_here = "bilinmeyen eylem";
        config_lists_actions = "eylemleri `krank config` ile listeleyin";
        must_have_a_key(name: &str) = "{name} eyleminin bir tuşu olmalı";
        no_key_here = "tuş yok";
        by_default(keys: &str) = "varsayılan: {keys}";
        keeps_its_key(name: &str) = "[keys]: {name} eyleminin tuşu sabittir";
        cannot_be_changed = "değiştirilemez";
        always_leaves(key: &dyn Display) = "{key} her zaman çıkar";
        always_goes_back(key: &dyn Display) = "{key} her zaman geri döner";

        // Keys.
        a_key_or_keys = "bir tuş ya da bir tuş listesi";
        for_example_keys(name: &str) = "örneğin: {name} = [\"space\", \"F5\"]";
        no_key_called(name: &str) = "{name} adında bir tuş yok";
        unknown_key = "bilinmeyen tuş";
        how_keys_are_called =
            "yazdırılabilir bir ASCII karakteri ya da yardımdaki tuş adını yazın:\n\
             space, Enter, Tab, Shift-Tab, Backspace, Left, Right, Up, Down, Home, End,\n\
             PgUp, PgDn, F1 .. F24, Ctrl-A .. Ctrl-Z";
        cannot_be_given_away = "başka eyleme atanamaz";
        choose_another_key = "başka bir tuş seçin";
        sent_as(key: &dyn Display, sent: &dyn Display) = "terminaller {key} yerine {sent} gönderir";
        never_seen = "hiç alınmaz";
        key_given_twice(key: &dyn Display, action: &str) = "{key} tuşu `{action}` eylemine iki kez atanmış";
        key_given_to_both(key: &dyn Display, one: &str, other: &str) =
            "{key} tuşu hem `{one}` hem `{other}` eylemine atanmış";
        once_more = "yine";
        here = "burada";
        here_too = "ve burada";
        has_it_by_default(action: &str) = "`{action}` eyleminin varsayılan tuşu";
        give_another_key(action: &str) =
            "`{action}` eylemine başka bir tuş atayın ya da boş bırakın: {action} = []";

        // The template of `krank config`.
        template_head = "\
# krank'ın ayarları; $XDG_CONFIG_HOME/krank/config.toml dosyasından, bu değişken yoksa
# ~/.config/krank/config.toml dosyasından okunur. krank bu dosyayı hiç yazmaz.
#
# Her satır, varsayılan değeri gösteren bir yorumdur: değiştirmek için baştaki #
# işaretini kaldırın. krank açılırken hataları satırlarıyla bildirir, tanımadığı
# adları yok sayar.

";
        for_a_ground(values: &str) = "arka plan: {values}";
        pictures_are_sent_by(values: &str) = "{values}";
        languages_are(values: &str) = "{values}";
        decimals_of_csv(values: &str) = "CSV dosyalarında: {values}";
        separators_of_csv(values: &str) = "{values}";
        panes_stand_as(values: &str) = "bölme düzeni: {values}";
        mouse_from_the_start = "fare baştan açık: true ya da false";
        tour_on_first_start = "ilk açılışta tanıtım turu: true ya da false";
        template_keys = "
[keys]
# Her eylem için bir tuş ya da bir tuş listesi, yardımdaki adıyla: \"g\", \"space\",
# \"F5\", \"Ctrl-R\", \"PgUp\". Boş liste tuşları kaldırır. Ctrl-C her zaman çıkar, Esc her
# zaman geri döner.
";
    }
}
