//! Errors of the library shown to the user.

use super::{Turkish, parser};
use crate::wording::english::ErrorsWords;
use std::fmt::Display;

catalogue! {
    impl ErrorsWords for Turkish {
        // The terminal.
        output_is_no_terminal =
            "standart çıktı bir terminal değil, tezgâh için terminal gerekir: tabloları `krank table SCENE` ile \
             yazdırın";
        no_keys_to_read =
            "tuşların okunacağı bir terminal yok, tezgâh için terminal gerekir: tabloları `krank table SCENE` \
             ile yazdırın";
        terminal_is_dumb = "TERM=dumb tezgâhı gösteremez: tabloları `krank table SCENE` ile yazdırın";
        terminal_failed(why: &dyn Display) = {
            format!("terminal hata verdi: {}", parser::of_system(why))
        };
        krank_is_broken(what: &str) = "iç hata: {what}; lütfen bildirin";

        // Quantities and sweeps.
        no_time_passes = "tahrikin hızı yok, bu yüzden zaman da yok: tahrike bir hız verin";
        driver_turns_back(at: f64) = "tahrik {at} konumuna ulaşmadan geri döner";
        no_quantity(pattern: &str, mend: &str) = "`{pattern}` adında bir büyüklük yok{mend}";
        nothing_acts_on_scene = "; bu sahnede yük, yay ya da kütle yok";
        option_puts_behind(name: &str, option: &str, kind: &str) =
            "; `{name}` yazın: {option}, `{name}.{kind}` sütununu ekler";
        or_meant(mend: &str) = "; {mend}";
        not_a_decimal = "bir sayı olmalı, 60 ya da -0.5 gibi";
        decimal_not_finite = "sonlu bir sayı olmalı";
        step_is_zero = "adım 0 olamaz";
        step_leads_away(step: f64, from: f64, to: f64, other: f64) =
            "{step} adımı {from} değerinden {to} değerine götürmez: {other} kullanın";
        sweep_too_long(from: f64, to: f64, step: f64) =
            "{from} ile {to} arasında {step} adımlı tarama 10^9'dan çok satır verir: daha büyük bir adım \
             kullanın";

        // Assemblies.
        how_wishes_are_written = "NAME=+ ya da NAME=- yazın, bağlaşık grup için NAME=NUMBER";
        no_group_with_choice(name: &str, mend: &str) =
            "montaj biçimi seçilebilen `{name}` adlı bir grup yok; {mend}";
        chosen_by(name: &str, options: &str) = "`{name}` için gereken: {options}";
        group_given_twice(name: &str) = "`{name}` iki kez verilmiş";
        chosen_by_number(name: &str) =
            "bir sayı, örneğin `{name}=1`: bu bir bağlaşık grup; montaj biçimlerini `krank check` ile \
             listeleyin";
        chosen_by_sign(name: &str) = "bir işaret, `{name}=+` ya da `{name}=-`: bu bir ikili grup";
        no_group_in_scene = "bu sahnede hiç yok";
        the_only_group(one: &str) = "tek olan {one}";
        there_are_and_more(names: &str, more: usize) = "olanlar: {names} ve {more} tane daha";

        // Typed values.
        no_number_typed(typed: &str, units: &str) = {
            match units {
                "" => format!("sayı değil: {typed}; bir sayı yazın"),
                units => format!("sayı değil: {typed}; birimsiz ya da şu birimlerle yazın: {units}"),
            }
        };
        unit_does_not_fit(unit: &str, units: &str) = {
            match units {
                "" => format!("{unit} buraya uymaz: birimsiz yazın"),
                units => format!("{unit} buraya uymaz: {units}"),
            }
        };
        typed_two_marks(typed: &str) = "{typed}: binlik ayırıcısını yazmayın: 1234.5 ya da 1234,5";
        typed_too_large(typed: &str) = "çok büyük: {typed}";
        no_speed_of_driver(typed: &str, units: &str) =
            "`{typed}` bu tahrik için bir hız değil: bir sayı ve şu birimlerden birini yazın: {units}";
    }
}
