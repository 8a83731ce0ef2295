//! Unsaved edits of earlier sessions: offered, restored, deleted.

use super::{Turkish, parser};
use crate::wording::english::OfferingWords;
use std::fmt::Display;

catalogue! {
    impl OfferingWords for Turkish {
        edits_kept_nowhere =
            "değişiklikler kurtarma için saklanmıyor: HOME ya da XDG_STATE_HOME değişkenine mutlak bir yol verin";
        edits_not_kept(folder: &dyn Display, why: &dyn Display) = {
            let why = parser::of_system(why);
            format!("değişiklikler kurtarma için saklanmıyor: {folder}: {why}")
        };
        others_have_edits = "bu sahneyi başka oturumlar değiştirdi: görmek için yeniden açın";
        edits_by_others = "bu sahnenin başka oturumlardaki değişiklikleri";
        older_edits_are_back(key: &str) = "geri yüklendi; dosya o zamandan beri değişmiş; {key} geri alır";
        edits_are_back(key: &str) = "kaydedilmemiş değişiklikler geri yüklendi; {key} geri alır";
        edits_cannot_be_shown(why: &str) = "değişiklikler gösterilemiyor: {why}";
        edits_deleted = "değişiklikler silindi";

        // The dialog.
        open_elsewhere = "Başka yerde de açık";
        unsaved_edits_here = "Bu sahnenin kaydedilmemiş değişiklikleri";
        the_edited_text = "Değiştirilmiş metin";
        edit_that_waits(name: &str, text: &str) = "bekliyor: {name} = {text}";
        what_the_edits_change = "Değişikliklerin etkisi";
        of_time(time: &str) = "zamanı {time}";
        older_than_file = "dosyadan eski";
        made_on_another_text = "dosya değişmiş";
        open_elsewhere_too(process: &dyn Display, host: &str, since: &str) =
            "krank'ta şurada da açık: süreç {process}, makine {host}, başlangıç {since}. Oradaki değişiklikler \
             saklanır; ikinci kaydedenden onay istenir.";

        // Keys of the dialog.
        look = "bak";
        later = "sonra";
        drop_them = "bırak";
        drops_for_ever = "yeniden basılırsa kalıcı siler,";
        any_other_key_does_not = "başka tuş silmez";
    }
}
