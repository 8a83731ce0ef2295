//! Detected properties of the terminal, and the reasons for the chosen output.

use super::Turkish;
use crate::wording::english::TerminalsWords;

catalogue! {
    impl TerminalsWords for Turkish {
        // Rows.
        row_configuration = "ayarlar";
        row_state = "durum";
        standard_output = "standart çıktı";
        standard_error = "standart hata";
        row_screen = "ekran";
        row_cells = "hücreler";
        row_line = "hat";
        row_theme = "tema";
        row_frames = "kareler";
        row_locale = "yerel";
        row_language = "dil";

        // Values.
        not_set = "verilmemiş";
        a_terminal = "bir terminal";
        no_terminal = "terminal değil";
        no_screen = "yok, /dev/tty de yok";
        no_size_told = "boyut bilinmiyor; 80 x 24 varsayılır";
        size_in_characters(columns: u16, rows: u16) = "{columns} x {rows} karakter";
        size_in_pixels(width: u16, height: u16) = "{width} x {height} piksel";
        no_pixels_told = "piksel boyutu bilinmiyor; boyu eninin iki katı varsayılır";
        serial_line(baud: u32, bytes: u32) = "seri hat, {baud} baud: karede en çok {bytes} bayt";
        console_here = "yerel konsol";
        pseudo_terminal = "bir sözde terminal; hızı kareler gönderilirken ölçülür";
        frames_none = "yok: TERM=dumb tezgâhı gösteremez";
        frames_whole = "eşzamanlı (?2026), yapıştırma işaretli (?2004)";
        frames_plain = "düz; yapıştırılan metin yazılan tuşlar gibi görünür";
        asked_for(wish: &str, else_what: &str, why: &str) = "{wish}: istendi; yoksa {else_what}: {why}";
        nowhere_to_be(variable: &str) = "yok: {variable} de HOME da verilmemiş";
        there_is_none(path: &str) = "{path} (yok)";

        // Reasons.
        locale_not_utf8 = "yerel ayar UTF-8 değil";
        term_not_set = "TERM verilmemiş";
        term_has_no_others(term: &str) = "TERM={term} başkasını desteklemiyor";
        console_has_no_braille = "konsol yazı tiplerinde çizgi var, Braille yok";
        emulator_in_utf8 = "UTF-8 yerel ayarlı bir öykünücü";
        no_color_set = "NO_COLOR verilmiş";
        term_has_none(term: &str) = "TERM={term} hiçbirini desteklemiyor";
        pictures_asked_for = "istendi";
        pictures_unwanted = "resimler kapalı: picture = \"none\"";
        no_pictures_there(term: &str) = "TERM={term} resim desteklemiyor";
        pictures_behind_multiplexer = "çoklayıcılar en çok sixel destekler: --picture sixel kullanın";
        pictures_unknown(term: &str) = "TERM={term} ile bilinmiyor: --picture kitty, iterm ya da sixel kullanın";
        row_pictures = "resimler";
        promises_no_more(what: &str) = "{what} daha fazlasını göstermiyor";
    }
}
