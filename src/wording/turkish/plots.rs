//! Figures over the motion.

use super::Turkish;
use crate::wording::english::PlotsWords;

catalogue! {
    impl PlotsWords for Turkish {
        over(name: &str) = "yatay: {name}";
        extremum(value: &str, place: &str) = "{value} ({place})";
        over_time = "zamana karşı: 0 s sahnenin açıldığı yer";
        extrema_marked = "en büyük ve en küçük değerler işaretli";
        extrema_not_marked = "en büyük ve en küçük değerler işaretsiz";
        band_drawn = "toleransların yaptığı çiziliyor";
        band_not_drawn = "toleransların yaptığı çizilmiyor";
        nothing_plotted = "henüz çizilen bir şey yok";
        nothing_plotted_to_write = "çizilmiş, yazılabilecek bir şey yok";
        no_value_anywhere(names: &str) = "bu hareketin hiçbir yerinde değeri yok: {names}";
        no_value_anywhere_because(names: &str, why: &str) =
            "bu hareketin hiçbir yerinde değeri yok: {names}; {why}";
        put_something_else_along_x = "x eksenine başka bir şey koy";
        plot_what = "ne çizilsin?";
        the_whole_cycle = "döngü";
        no_figure_has_that = "hiçbir büyüklükte bu yok";
        measured_of(figure: &str) = "ölçülen {figure}";
    }
}
