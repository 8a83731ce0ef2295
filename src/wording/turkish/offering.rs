//! Edits that sessions have left: offered, taken up, dropped.

use super::{Turkish, parser};
use crate::wording::english::OfferingWords;
use std::fmt::Display;

catalogue! {
    impl OfferingWords for Turkish {
        edits_kept_nowhere =
            "düzenlemeler kurtarma için saklanmıyor: HOME ya da XDG_STATE_HOME mutlak bir yol olmalı";
        edits_not_kept(folder: &dyn Display, why: &dyn Display) = {
            let why = parser::of_system(why);
            format!("değişiklikler kurtarma için saklanmıyor: {folder}: {why}")
        };
        others_have_edits = "bu sahnenin başkalarında değişiklikleri var: görmek için yeniden aç";
        edits_by_others = "bu sahnenin başka oturumlardaki değişiklikleri";
        older_edits_are_back(key: &str) =
            "geri geldi; dosyadakinden başka bir metinde yapılmış; {key} geri alır";
        edits_are_back(key: &str) = "kaydedilmemiş değişiklikler geri geldi; {key} geri alır";
        edits_cannot_be_shown(why: &str) = "gösterilemiyorlar: {why}";
        edits_deleted = "bu değişiklikler silindi";

        // The box in the middle of the screen.
        open_elsewhere = "Başka yerde de açık";
        unsaved_edits_here = "Bu sahnenin kaydedilmemiş değişiklikleri";
        the_edited_text = "Değiştirilmiş metin";
        edit_that_waits(name: &str, text: &str) = "bekliyor: {name} = {text}";
        what_the_edits_change = "Değişikliklerin yaptığı";
        of_time(time: &str) = "zamanı {time}";
        older_than_file = "dosyadan eski";
        made_on_another_text = "başka bir metinde yapılmış";
        open_elsewhere_too(process: &dyn Display, host: &str, since: &str) =
            "krank'ta şurada da açık: süreç {process}, makine {host}, başlangıç {since}. Oradaki \
             değişikliklere dokunulmaz; ikinci kaydedene sorulur.";

        // Its keys.
        look = "bak";
        later = "sonra";
        drop_them = "bırak";
        drops_for_ever = "yeniden basılırsa temelli siler,";
        any_other_key_does_not = "başka tuş silmez";
    }
}
