//! The tour of the first start.

use super::Turkish;
use crate::wording::english::TourWords;

catalogue! {
    impl TourWords for Turkish {
        tour_title(page: usize, pages: usize, title: &str) = "Tur {page}/{pages}: {title}";
        tour_keys(next: &str) = "Enter {next}  Left geri  Esc bitir";

        tour_of_the_screen = "krank'ın gösterdikleri";
        tour_of_the_screen_text =
            "Krank mekanizmayı sürer. Çizim ölçeklidir; tablolar her parçanın konumunu, hızını ve ivmesini \
             gösterir, * hesaplanan değerdir.\nSon satır krank açısını ve en yararlı tuşları gösterir.";
        tour_of_the_crank = "Krankı çevirmek";
        tour_of_the_crank_text(keys: &[String; 10]) = {
            let [step, step_back, play, smaller, larger, slower, faster, reverse, go_to, opening] =
                keys;
            format!(
                "{step} ve {step_back} adım atar: şimdi deneyin. {play} tur bitince oynatır.\n\
                 {smaller} ve {larger} adımı, {slower} ve {faster} hızı, {reverse} yönü değiştirir. \
                 {go_to} yazdığınız yere, {opening} açılışa gider."
            )
        };
        tour_of_figures = "Tablolar, grafikler, güven";
        tour_of_figures_text(views: &[String; 9]) = {
            let [motion, tables, plots, accuracy, forces, working, motor, lengths, polygons] = views;
            format!(
                "{tables} tablo, {plots} grafik, {forces} kuvvet, {working} çözüm, {motor} motor, {polygons} poligon, \
                 {motion} yine hareket.\nDeğerlerin, olabildiğinde, kanıtlı hata sınırı vardır: ötesindeki haneler soluk ya da \
                 noktadır. - değer yok demektir. {accuracy} yöntemleri, {lengths} boyların etkisini gösterir."
            )
        };
        tour_of_editing = "Düzenlemek ve kaydetmek";
        tour_of_editing_text(open: &str, next: &str, scene: &str, undo: &str, save: &str) =
            "{open} hazır sahne ya da dosya açar; {next} sonraki hazır sahnedir.\n{scene} sahnenin bütün \
             sayılarını düzenlemek için listeler, mekanizma izler. {undo} geri alır. {save} basılmadan hiçbir şey \
             yazılmaz.";
        tour_of_help = "Yardım almak";
        tour_of_help_text(help: &str, search: &str, back: &str, quit: &str, tour: &str) =
            "{help} görünümün tuşlarını, sonra ötekileri listeler; {search} arar. {back} bir düzey geri gider, \
             {quit} çıkar.\n{tour} bu turu yine gösterir. Terminalsiz: krank --help, krank man.";
    }
}
