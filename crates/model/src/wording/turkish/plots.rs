//! Plots of values over the motion.

use super::Turkish;
use crate::wording::english::PlotsWords;

catalogue! {
    impl PlotsWords for Turkish {
        over(name: &str) = "yatay: {name}";
        extremum(value: &str, place: &str) = "{value} ({place})";
        over_time = "zamana göre: 0 s sahnenin açıldığı an";
        extrema_marked = "en büyük ve en küçük değerler işaretli";
        extrema_not_marked = "en büyük ve en küçük değerler işaretsiz";
        band_drawn = "tolerans bantları gösteriliyor";
        band_not_drawn = "tolerans bantları gizli";
        nothing_plotted = "henüz çizilen bir şey yok";
        nothing_plotted_to_write = "yazılacak grafik yok";
        no_value_anywhere(names: &str) = "bu hareketin hiçbir yerinde değeri yok: {names}";
        no_value_anywhere_because(names: &str, why: &str) =
            "bu hareketin hiçbir yerinde değeri yok: {names}; {why}";
        put_something_else_along_x = "başka bir x ekseni seçin";
        plot_what = "ne çizilsin?";
        the_whole_cycle = "döngü";
        no_figure_has_that = "eşleşen sütun yok";
        measured_of(figure: &str) = "ölçülen {figure}";
    }
}
