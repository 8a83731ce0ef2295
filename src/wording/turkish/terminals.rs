//! What was found of the terminal, and why it is drawn on as it is.

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

        // What they say.
        not_set = "verilmemiş";
        a_terminal = "bir terminal";
        no_terminal = "terminal değil";
        no_screen = "yok, /dev/tty de yok";
        no_size_told = "boy söylenmiyor; 80 x 24 varsayılır";
        size_in_characters(columns: u16, rows: u16) = "{columns} x {rows} karakter";
        size_in_pixels(width: u16, height: u16) = "{width} x {height} piksel";
        no_pixels_told = "piksel söylenmiyor; boyu eninin iki katı varsayılır";
        serial_line(baud: u32, bytes: u32) = "seri hat, {baud} baud: karede en çok {bytes} bayt";
        console_here = "bu makinenin bir konsolu";
        pseudo_terminal = "bir sözde terminal; hızı kareler gönderilirken ölçülür";
        frames_none = "yok: TERM=dumb tezgâhı gösteremez";
        frames_whole = "bir kerede (?2026), yapıştırılan metin işaretli (?2004)";
        frames_plain = "düz; yapıştırılan metin tuşlardan ayrılamaz";
        asked_for(wish: &str, else_what: &str, why: &str) = "{wish}: istendi; yoksa {else_what}: {why}";
        nowhere_to_be(variable: &str) = "hiçbir yerde: {variable} de HOME da verilmemiş";
        there_is_none(path: &str) = "{path} (yok)";

        // Why.
        locale_not_utf8 = "yerel UTF-8 değil";
        term_not_set = "TERM verilmemiş";
        term_has_no_others(term: &str) = "TERM={term} başkasını bilmez";
        console_has_no_braille = "konsol yazı tiplerinde çizgi var, Braille yok";
        emulator_in_utf8 = "UTF-8 yerelinde bir öykünücü";
        no_color_set = "NO_COLOR verilmiş";
        term_has_none(term: &str) = "TERM={term} renk bilmez";
        pictures_asked_for = "istendi";
        pictures_unwanted = "burada resim istenmiyor: picture = \"none\"";
        no_pictures_there(term: &str) = "TERM={term} resim göstermez";
        pictures_behind_multiplexer =
            "çoklayıcılar en çok sixel alır; --picture sixel gönderir";
        pictures_unknown(term: &str) =
            "TERM={term} söylemiyor; --picture kitty, iterm ya da sixel söyler";
        row_pictures = "resimler";
        promises_no_more(what: &str) = "{what} daha fazlasına söz vermiyor";
    }
}
