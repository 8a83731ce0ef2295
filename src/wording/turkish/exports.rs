//! What is taken out of the workbench: copied, or written to a file.

use super::Turkish;
use crate::wording::english::ExportsWords;
use std::fmt::Display;

catalogue! {
    impl ExportsWords for Turkish {
        no_clipboard = "bu terminalin panosu yok";
        nothing_to_copy = "burada kopyalanacak bir şey yok; tablolarda hepsi var";
        no_value_to_copy = "kopyalanacak değer yok";
        sent_to_clipboard(bytes: usize) = "terminalin panosuna gönderildi: {bytes} B";
        too_much_to_copy(bytes: usize) = "kopyalamak için çok fazla, {bytes} B";
        use_instead(why: &str, key: &dyn Display) = "{why}: {key} kullan";
        no_figures_to_write = "burada yazılacak değer yok";
        no_drawing_here = "bu görünümde çizim yok";
        still_shown(bytes: usize) = "piksellerle, {bytes} B; herhangi bir tuş kaldırır";
        still_takes(bytes: usize, seconds: f64, key: &dyn Display) =
            "{bytes} B'lik resim bu hatta {seconds:.0} s sürer; yeniden {key} gönderir";
        the_figures = "değerler";
        the_working = "çözüm";
        the_screen = "ekran";
        the_drawing = "çizim";
        the_plot = "grafik";
    }
}
