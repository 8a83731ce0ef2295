//! Texts of the clipboard, of exported files and of scripts.

use super::Turkish;
use crate::wording::english::ExportsWords;
use std::fmt::Display;

catalogue! {
    impl ExportsWords for Turkish {
        no_clipboard = "bu terminalin panosu yok";
        nothing_to_copy = "burada kopyalanacak bir şey yok: tablolara bakın";
        no_value_to_copy = "kopyalanacak değer yok";
        sent_to_clipboard(bytes: usize) = "terminalin panosuna gönderildi: {bytes} B";
        too_much_to_copy(bytes: usize) = "kopyalamak için çok fazla, {bytes} B";
        use_instead(why: &str, key: &dyn Display) = "{why}: {key} kullanın";
        no_figures_to_write = "burada yazılacak bir şey yok";
        no_drawing_here = "bu görünümde çizim yok";
        still_shown(bytes: usize) = "piksellerle, {bytes} B; bir tuş kapatır";
        still_takes(bytes: usize, seconds: f64, key: &dyn Display) =
            "{bytes} B'lik resim bu hatta {seconds:.0} s sürer; göndermek için yine {key}";
        the_figures = "değerler";
        the_working = "çözüm";
        the_screen = "ekran";
        the_drawing = "çizim";
        // Scripts.
        about_script(title: &str, driver: &str, unit: &str) =
            "{title}: noktaların konumları, grup grup hesaplanır.\n\
             Noktalar {unit} cinsinden x + i y karmaşık sayılarıdır, doğrultular birim vektördür; q, \
             {driver}.\n\
             Yan 1 ya da -1'dir: grubun iki montaj biçiminden hangisinde olduğu.";
        script_turn = "x ekseninden derece cinsinden açıdaki birim vektör.";
        script_circles =
            "P ve Q merkezli çemberlerin kesişimi: P'den Q'ya giden doğrunun solunda ya da sağında.";
        script_circle_line =
            "P merkezli çemberin, Z'den t yönünde geçen doğruyla kesişimi: P'nin dikme ayağından sonra ya da \
             önce.";
        script_lines = "İki doğrunun kesişimi.";
        script_swing =
            "Mesnedinden belli bir uzaklıkta geçen ve mesnetten görülen noktadan giden kılavuzun doğrultusu.";
        script_side = "q'daki yan; bazı konumlarda değişir.";
        script_follow = "Bir girişin tablosuna göre koordinatı: düğümlerdeki ikinci türevlerle kübik spline.";
        script_newton =
            "Artığı sıfır yapan bilinmeyenler: bir başlangıçtan Newton yöntemi, merkezi farklarla.";
        script_given = "Sahnede verilenler.";
        script_positions = "Noktaların q'daki konumları.";
        script_table = "Her q için bir satır.";
        script_group(links: &str) = "{links}";
        the_plot = "grafik";
    }
}
