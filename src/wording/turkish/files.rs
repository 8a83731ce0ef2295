//! Files: read, written, changed by others; edits that a session has left.

use super::{Turkish, parser};
use crate::wording::english::FilesWords;
use std::fmt::Display;

catalogue! {
    impl FilesWords for Turkish {
        // What stands where a file should.
        is_a_folder = "bu bir klasör";
        pipe_without_writer = "bu, kimsenin yazmadığı bir boru";
        is_a_pipe = "bu bir boru, dosya değil";
        is_a_socket = "bu bir soket, dosya değil";
        is_a_device = "bu bir aygıt, dosya değil";
        is_no_file_of_its_own = "zaten açık, kendi başına bir dosya değil";
        is_no_name_of_a_file = "bir dosya adı değil";
        was_cut_while_read = "okunurken kısaldı";
        is_no_record = "krank'ın kaydı değil";

        // Why a file is not written.
        exists_already = "böyle bir dosya zaten var";
        changed_on_disk = "diskte değişmiş";
        changed_while_it_grew =
            "satırlar eklenirken silindi, değiştirildi ya da yerine başka bir dosya kondu; başka satır yazılmadı";
        is_read_only = "salt okunur";
        another_is_writing = "oraya başka bir program yazıyor";
        no_journal = "değiştirilemiyor, yazılırken eski metnini saklayacak durum klasörü de yok";
        disk_full = "disk dolu";
        file_too_large = "bir dosya bu kadar büyük olamaz";
        no_permission = "izin yok";
        disk_read_only = "disk salt okunur";
        no_such_folder = "böyle bir klasör yok";
        add_a_name = "o bir klasör: bir ad ekle";
        not_written(why: &str) = {
            format!("yazılmadı: {}", parser::of_system(&why))
        };
        not_written_to(name: &str, why: &str) = {
            format!("yazılmadı, {}: {name}", parser::of_system(&why))
        };
        not_written_without_start =
            "yazılmadı: hiçbir başlangıç konumu bu montaj biçimini ötekilerden ayırmıyor";

        // What is asked before one is written.
        write_over(name: &str) = "{name} üstüne yazılsın mı?";
        write_over_changed(name: &str) = "{name} diskte değişmiş: üstüne yazılsın mı?";
        write_over_newer(name: &str) = "{name} bu değişikliklerden yeni: üstüne yazılsın mı?";
        write_read_only(name: &str) = "{name} salt okunur: yazılsın mı?";

        // Writing.
        unchanged_since_saved = "kaydedildiğinden beri bir şey değişmedi";
        still_writing = "başka bir dosya hâlâ yazılıyor";
        writing_to(name: &dyn Display) = "yazılıyor: {name}";
        written_to(name: &dyn Display) = "yazıldı: {name}";
        all_written_to(what: &str, name: &dyn Display) = "{what} yazıldı: {name}";
        or_save_elsewhere(why: &str, key: &str) = "{why}; {key} başka yere kaydeder";
        broken_there = "krank orada bozuldu";

        // Reading.
        reading(name: &str) = "okunuyor: {name}";
        cannot_be_read(why: &dyn Display) = {
            format!("okunamıyor: {}", parser::of_system(why))
        };
        name_cannot_be_read(name: &str, why: &dyn Display) = {
            format!("{name} okunamıyor: {}", parser::of_system(why))
        };
        is_folder(name: &dyn Display) = "{name} bir klasör";
        no_presets = "hazır sahne yok";
        no_preset(name: &str) = "{name} adında hazır sahne yok";
        preset_cannot_be_opened(name: &str, why: &dyn Display) =
            "hazır sahne {name} açılamıyor: {why}";

        // What others have done to the file.
        file_changed(name: &str, reload: &str, elsewhere: &str) =
            "{name} diskte değişti: {reload} okur, {elsewhere} başka yere kaydeder";
        no_file_to_read = "bu sahnenin yeniden okunacak dosyası yok";
        file_is_gone(name: &str, key: &str) = "{name} yok olmuş: {key} yeniden yazar";
        was_read_again(name: &str) = "{name} yeniden okundu";
        is_broken_not_shown(name: &str, fault: &str) = "{name} bozuk, gösterilmiyor: {fault}";
    }
}
