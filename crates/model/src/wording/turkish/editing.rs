//! Edits of the scene, and the comparison with another scene.

use super::Turkish;
use crate::wording::english::EditingWords;

catalogue! {
    impl EditingWords for Turkish {
        // Values.
        no_numbers = "sahnede değer yok";
        nudge_by(step: &str, unit: &str) = "adım {step} {unit}";
        value_in_file(value: &str) = "dosyada: {value}";
        in_the_file = "dosyada";
        values_changed(count: usize) = "{count} değişti";
        gathering(count: usize) = {
            match count {
                0 => "değişiklikler bekler".to_owned(),
                count => format!("{count} değişiklik bekliyor"),
            }
        };
        edits_wait(key: &str) = "bekleyen değişiklikler: {key} uygular, Esc siler";
        make_gathered = "uygula";
        drop_staged = "sil";
        gathered_made(count: usize) = {
            match count {
                0 => "değişiklikler hemen uygulanır".to_owned(),
                count => format!("{count} değişiklik uygulandı"),
            }
        };
        gathered_dropped(key: &str) = "bekleyen değişiklikler silindi; {key} geri getirir";
        start_follows = "[start] değişti, montaj biçimi korundu";

        // Reasons why an edit cannot be shown.
        this_assembly(why: &str) = "bu montaj biçimi {why}";
        no_start_tells_it = "hiçbir [start] bu montaj biçimini belirleyip bütün uzuvları korumuyor";
        a_joint = "bir mafsal";
        joint_out_of_reach(joint: &str, gap: &str, unit: &str) = "{joint} erişim dışında: {gap} {unit}";

        // Undo and redo.
        assembly = "montaj biçimi";
        reading_the_file = "yeniden okuma";
        recovered_edits = "kurtarılan değişiklikler";
        nothing_to_undo = "geri alınacak değişiklik yok";
        nothing_to_redo = "yinelenecek değişiklik yok";
        undone(edit: &str) = "{edit} geri alındı";
        redone(edit: &str) = "{edit} yinelendi";

        // Comparison.
        esc_ends_comparison = "Esc karşılaştırmayı bitirir";
        no_longer_compared = "karşılaştırma bitti";
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
        against(scene: &str) = "{scene} ile karşılaştırma";
        against_without_assembly(scene: &str) = "{scene} ile karşılaştırma: burada kurulamaz";
    }
}
