//! The list of scenes, with a preview.

use super::Turkish;
use crate::wording::english::PickingWords;
use std::fmt::Display;

catalogue! {
    impl PickingWords for Turkish {
        open_a_scene = "Sahne aç";
        compare_with = "Karşılaştır";
        search_for = "ara: ";
        some_of(some: usize, all: usize) = "{some} / {all}";
        nothing_matches = "eşleşme yok; Ctrl-U aramayı siler";
        presets = "hazır sahneler";
        as_opened = "açıldığı gibi";
        folder_being_read = "klasör okunuyor";
        more_than_can_be_listed = "listelenemeyecek kadar çok";
        no_scene_file_here = "burada sahne dosyası yok";
        no_scene_in_it = "içinde sahne yok";
        a_folder = "bir klasör";

        // The preview.
        being_read = "okunuyor";
        too_large_for_preview(kib: u64) = "{kib} KiB: önizleme için çok büyük";
        cannot_be_opened = "açılamıyor";
        line_and_column(line: usize, column: usize) = "satır {line}, sütun {column}";
        more_below(count: usize) = "altında {count} tane daha";
        no_scene_file_in_it = "içinde sahne dosyası yok";
        and_more(count: usize) = "ve {count} tane daha";
        count_of_links(count: usize) = "{count} uzuv";
        count_of_slides(count: usize) = "{count} kızak";
        unit(symbol: &str) = "birim {symbol}";
        turns_fully(link: &str) = "{link} tam döner";
        turns_fully_and_repeats(link: &str, period: &dyn Display) =
            "{link} tam döner; hareket {period} deg sonra yinelenir";
        moves_between(name: &str, low: &str, high: &str, unit: &str) =
            "{name}: {low} ile {high} {unit} arasında";
    }
}
