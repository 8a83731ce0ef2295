//! The last line: what is going on, what is asked, and what keys do now.

use super::Turkish;
use crate::wording::english::HintsWords;

catalogue! {
    impl HintsWords for Turkish {
        // What is going on.
        choosing = "seç";
        writing = "yaz";
        recovering = "kurtar";

        // What a key does now.
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
        less = "az";
        look_inside = "içine bak";
        manual = "el kitabı";
        more = "devamı";
        next_topic = "sonraki konu";
        none = "yok";
        pause = "durdur";
        plot = "çiz";
        plot_it_or_not = "çiz ya da çizme";
        read = "oku";
        row = "satır";
        stay = "kal";
        stop = "dur";
        table = "tablo";
        take = "al";
        value = "değer";

        // What is asked for.
        character_not_taken(c: char) = {
            format!("{c} (U+{:04X}) burada alınmaz", u32::from(c))
        };
        no_more_characters(most: usize) = "burada en çok {most} karakter alınır";
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
        in_no_file_yet = "bu mekanizma henüz hiçbir dosyada yok";
        read_over_edits = "kaydedilmemiş değişikliklerin üstüne okunsun mu?";
    }
}
