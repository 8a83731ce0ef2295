//! Errors of the library that a person is told as they are.

use super::{Turkish, parser};
use crate::wording::english::ErrorsWords;
use std::fmt::Display;

catalogue! {
    impl ErrorsWords for Turkish {
        // The terminal.
        output_is_no_terminal =
            "standart çıktı terminal değil, tezgâha ise terminal gerekir; `krank table SCENE` tabloları \
             yazar";
        no_keys_to_read =
            "tuşların okunacağı bir terminal yok, tezgâha ise terminal gerekir; `krank table SCENE` \
             tabloları yazar";
        terminal_is_dumb =
            "TERM=dumb tezgâhı gösteremez; `krank table SCENE` tabloları yazar";
        terminal_failed(why: &dyn Display) = {
            format!("terminal hata verdi: {}", parser::of_system(why))
        };
        krank_is_broken(what: &str) = "krank bozuldu: {what}";

        // Figures and their rows.
        no_time_passes =
            "sahne tahrike hız vermiyor, zaman geçmiyor: tahrike bir hız ver";
        driver_turns_back(at: f64) = "tahrik {at} konumuna varmadan geri döner";
        no_quantity(pattern: &str, mend: &str) = "`{pattern}` adında bir büyüklük yok{mend}";
        nothing_acts_on_scene = "; bu sahneye bir şey etki etmiyor: yük, yay ya da kütle yok";
        option_puts_behind(name: &str, option: &str, kind: &str) =
            "; `{name}` yaz, {option} ardına `{name}.{kind}` koyar";
        or_meant(mend: &str) = "; {mend}";
        not_a_decimal = "bir sayı olmalı, 60 ya da -0.5 gibi";
        decimal_not_finite = "sonlu bir sayı olmalı";
        step_is_zero = "adım 0 olamaz";
        step_leads_away(step: f64, from: f64, to: f64, other: f64) =
            "{step} adımı hiçbir zaman {from} ile başlayıp {to} değerine varmaz; {other} adımı varır";
        sweep_too_long(from: f64, to: f64, step: f64) =
            "{from} ile {to} arasında {step} adımlı taramanın 10^9'dan çok satırı var; daha büyük adım al";

        // Assemblies.
        how_wishes_are_written = "NAME=+ ya da NAME=- yaz, bağlı grup için NAME=NUMBER";
        no_group_with_choice(name: &str, mend: &str) = "`{name}` adında seçimi olan bir grup yok; {mend}";
        chosen_by(name: &str, options: &str) = "`{name}` şununla seçilir: {options}";
        group_given_twice(name: &str) = "`{name}` iki kez verilmiş";
        chosen_by_number(name: &str) =
            "bir sayı, `{name}=1`: bağlı bir grup, montaj biçimlerini `krank check` sıralar";
        chosen_by_sign(name: &str) = "işareti, `{name}=+` ya da `{name}=-`: bir diad";
        no_group_in_scene = "bu sahnede hiç yok";
        the_only_group(one: &str) = "tek olan {one}";
        there_are_and_more(names: &str, more: usize) = "olanlar: {names} ve {more} tane daha";

        // Values that are typed.
        no_number_typed(typed: &str, units: &str) = {
            match units {
                "" => format!("sayı değil: {typed}; bir sayı yaz"),
                units => format!("sayı değil: {typed}; bir sayı yaz, yalın ya da birimle: {units}"),
            }
        };
        unit_does_not_fit(unit: &str, units: &str) = {
            match units {
                "" => format!("{unit} buraya uymaz: burada birimsiz bir sayı durur"),
                units => format!("{unit} buraya uymaz: {units}"),
            }
        };
        typed_two_marks(typed: &str) = "{typed}: haneleri gruplamadan yaz: 1234.5 ya da 1234,5";
        typed_too_large(typed: &str) = "çok büyük: {typed}";
        no_speed_of_driver(typed: &str, units: &str) =
            "`{typed}` bu tahrikin hızı olamaz: sayı ve şunlardan bir birim: {units}";
    }
}
