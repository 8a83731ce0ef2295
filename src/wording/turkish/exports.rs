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
        // Scripts.
        about_script(title: &str, driver: &str, unit: &str) =
            "{title}: noktalarının yeri, grup grup yeniden hesaplanır.\n\
             Yerler {unit} olarak x + i y karmaşık sayılarıdır, doğrultuların boyu 1'dir; q, {driver}.\n\
             Yan 1 ya da -1'dir: bir grubun iki montajından hangisinde olduğu.";
        script_turn = "x ekseninden bu kadar derece dönmüş doğrultu.";
        script_circles = "P ve Q çevresindeki çemberlerin kesiştiği yer: P'den Q'ya giden doğrunun solunda ya da sağında.";
        script_circle_line = "P çevresindeki çemberin, Z'den geçen ve t boyunca uzanan doğruyu kestiği yer: P'nin dikme ayağının önünde ya da arkasında.";
        script_lines = "İki doğrunun kesiştiği yer.";
        script_swing = "Mafsalının belli bir uzağından geçip oradan görülen yere varan kızağın doğrultusu.";
        script_side = "Yol boyunca değişen yanın q'daki değeri.";
        script_follow = "Bir girişin tablosuna göre koordinatı: her iki düğüm arasında, uçlardaki ikinci türevlerle bir kübik.";
        script_newton = "Sapmayı sıfır yapan bilinmeyenler: bir başlangıçtan Newton yöntemi, merkezi farklarla.";
        script_given = "Sahnede verilenler.";
        script_positions = "Noktaların q'daki yerleri.";
        script_table = "Her q için bir satır.";
        script_group(links: &str) = "{links}";
        the_plot = "grafik";
    }
}
