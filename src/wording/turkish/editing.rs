//! Edits of the scene, and another scene beside it.

use super::Turkish;
use crate::wording::english::EditingWords;

catalogue! {
    impl EditingWords for Turkish {
        // Values.
        no_numbers = "sahnede sayı yok";
        nudge_by(step: &str, unit: &str) = "adım {step} {unit}";
        value_in_file(value: &str) = "dosyada: {value}";
        in_the_file = "dosyada";
        values_changed(count: usize) = "{count} değişti";
        gathering(count: usize) = {
            match count {
                0 => "değişiklikler artık bekler".to_owned(),
                count => format!("{count} değişiklik bekliyor"),
            }
        };
        edits_wait(key: &str) = "değişiklikler bekliyor: {key} birlikte yapar, Esc bırakır";
        make_gathered = "uygula";
        drop_gathered = "vazgeç";
        gathered_made(count: usize) = {
            match count {
                0 => "değişiklikler yine hemen yapılır".to_owned(),
                count => format!("{count} değişiklik birlikte yapıldı"),
            }
        };
        gathered_dropped(key: &str) = "bekleyen değişikliklerden vazgeçildi; {key} onları geri getirir";
        start_follows = "[start] da değişir, bu montaj biçimi kalsın diye";

        // Why an edit cannot be shown.
        this_assembly(why: &str) = "bu montaj biçimi {why}";
        no_start_tells_it = "hiçbir [start] bu montaj biçimini ötekilerden ayıramaz";
        a_joint = "bir mafsal";
        joint_out_of_reach(joint: &str, gap: &str, unit: &str) = "{joint} erişim dışında: {gap} {unit}";

        // Edits, and the way back.
        assembly = "montaj biçimi";
        reading_the_file = "dosyanın okunması";
        recovered_edits = "kurtarılan değişiklikler";
        nothing_to_undo = "geri alınacak değişiklik yok";
        nothing_to_redo = "yinelenecek değişiklik yok";
        undone(edit: &str) = "{edit}: geri alındı";
        redone(edit: &str) = "{edit}: yinelendi";

        // Beside another scene.
        esc_ends_comparison = "Esc karşılaştırmayı bitirir";
        no_longer_compared = "artık karşılaştırılmıyor";
        has_no_assembly_here(scene: &str) = "{scene} burada kurulamaz";
        this_less(scene: &str) = "bu - {scene}";
        difference_from(scene: &str) = "fark: bu - {scene}";
        driven_at(speed: &str) = "tahrik hızı {speed}";
        this_and_other(this: &str, other: &str) = "{this} ve {other}";
        only_there(names: &str) = "yalnız orada: {names}";
        a_link_that_turns = "dönen bir uzuv";
        a_slide = "bir kızak";
        no_common_coordinate(scene: &str, by: &str, this_by: &str) =
            "{scene} sahnesinin tahriki {by}, bu sahneninki {this_by}: ortak koordinat yok";
        against(scene: &str) = "karşısında {scene}";
        against_without_assembly(scene: &str) = "karşısında {scene}: burada kurulamaz";
    }
}
