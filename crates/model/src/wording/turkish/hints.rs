//! The status line: modes, prompts and key hints.

use super::Turkish;
use crate::wording::english::HintsWords;

catalogue! {
    impl HintsWords for Turkish {
        // Modes.
        choosing = "seç";
        writing = "yaz";
        recovering = "kurtar";

        // Key hints.
        again = "yine";
        all = "hepsi";
        all_keys = "bütün tuşlar";
        along_x = "x ekseni";
        cancel = "vazgeç";
        do_it = "yap";
        done = "bitti";
        drop_and_open = "bırak, aç";
        drop_and_quit = "bırak, çık";
        end = "bitir";
        go = "git";
        go_on = "sürdür";
        keep = "sakla";
        less = "azalt";
        look_inside = "göz at";
        manual = "el kitabı";
        more = "artır";
        next_topic = "sonraki konu";
        none = "yok";
        pause = "durdur";
        plot = "çiz";
        plot_it_or_not = "çiz/kaldır";
        read = "oku";
        row = "satır";
        stay = "kal";
        stop = "dur";
        table = "tablo";
        take = "al";
        value = "değer";

        // Prompts.
        character_not_taken(c: char) = {
            format!("{c} (U+{:04X}) burada geçersiz", u32::from(c))
        };
        no_more_characters(most: usize) = "burada en çok {most} karakter yazılabilir";
        angle_in(unit: &str) = "açı [{unit}]: ";
        position_in(unit: &str) = "konum [{unit}]: ";
        write_to = "dosya: ";
        name = "ad: ";
        value_in(name: &str, units: &str) = {
            match units {
                "" => name.to_owned(),
                units => format!("{name} [{units}]"),
            }
        };
        unsaved_edits = "kaydedilmemiş değişiklik";
        in_no_file_yet = "bu mekanizma henüz kaydedilmedi";
        read_over_edits = "kaydedilmemiş değişiklikler silinip okunsun mu?";
    }
}
