//! Files: reading, writing and external changes.

use super::{Turkish, parser};
use crate::wording::english::FilesWords;
use std::fmt::Display;

catalogue! {
    impl FilesWords for Turkish {
        // Paths that are not files.
        is_a_folder = "bir klasör";
        pipe_without_writer = "kimsenin yazmadığı bir boru";
        is_a_pipe = "bir boru, dosya değil";
        is_a_socket = "bir soket, dosya değil";
        is_a_device = "bir aygıt, dosya değil";
        is_no_file_of_its_own = "açık bir dosya tanıtıcısı, dosya değil";
        is_no_name_of_a_file = "bir dosya adı değil";
        was_cut_while_read = "okunurken kısaldı";
        is_no_record = "krank'ın kaydı değil";

        // Reasons why a file is not written.
        exists_already = "dosya zaten var";
        changed_on_disk = "diskte değişmiş";
        changed_while_it_grew =
            "satırlar yazılırken silindi, değiştirildi ya da yerine başka dosya kondu; başka satır yazılmadı";
        is_read_only = "salt okunur";
        another_is_writing = "başka bir program ona yazıyor";
        no_journal = "yerine yenisi konamıyor ve yedek için durum klasörü yok";
        disk_full = "disk dolu";
        file_too_large = "dosya çok büyük";
        no_permission = "izin yok";
        disk_read_only = "disk salt okunur";
        no_such_folder = "böyle bir klasör yok";
        add_a_name = "o bir klasör: bir ad ekleyin";
        not_written(why: &str) = {
            format!("yazılmadı: {}", parser::of_system(&why))
        };
        not_written_to(name: &str, why: &str) = {
            format!("yazılmadı, {}: {name}", parser::of_system(&why))
        };
        not_written_without_start = "yazılmadı: hiçbir başlangıç konumu bu montaj biçimini belirlemiyor";

        // Questions before writing.
        write_over(name: &str) = "{name} üstüne yazılsın mı?";
        write_over_changed(name: &str) = "{name} diskte değişmiş: üstüne yazılsın mı?";
        write_over_newer(name: &str) = "{name} bu değişikliklerden yeni: üstüne yazılsın mı?";
        write_read_only(name: &str) = "{name} salt okunur: yazılsın mı?";

        // Writing.
        unchanged_since_saved = "kaydedilecek değişiklik yok";
        still_writing = "başka bir dosya hâlâ yazılıyor";
        writing_to(name: &dyn Display) = "yazılıyor: {name}";
        written_to(name: &dyn Display) = "yazıldı: {name}";
        all_written_to(what: &str, name: &dyn Display) = "{what} yazıldı: {name}";
        or_save_elsewhere(why: &str, key: &str) = "{why}; {key} başka yere kaydeder";
        broken_there = "iç hata";

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

        // External changes.
        file_changed(name: &str, reload: &str, elsewhere: &str) =
            "{name} diskte değişti: {reload} okur, {elsewhere} başka yere kaydeder";
        no_file_to_read = "bu sahnenin yeniden okunacak dosyası yok";
        file_is_gone(name: &str, key: &str) = "{name} silinmiş: {key} yeniden kaydeder";
        was_read_again(name: &str) = "{name} yeniden okundu";
        is_broken_not_shown(name: &str, fault: &str) = "{name} hatalı, gösterilmiyor: {fault}";
    }
}
