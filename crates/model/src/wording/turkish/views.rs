//! The views: titles, headings and remarks.

use super::Turkish;
use crate::wording::english::ViewsWords;
use std::fmt::Display;

catalogue! {
    impl ViewsWords for Turkish {
        screen_too_small(width: u16, height: u16) = "krank için {width} x {height}";

        // The line of tabs, and panes.
        short_accuracy = "hata";
        means_nothing_here(key: &dyn Display, help: &str) = "{key} burada bir şey yapmaz; tuşlar: {help}";
        nothing_acts_in_short = "burada kuvvet yok: yük, yay ya da kütle yok";
        layout_is(name: &str) = {
            // Followed by the name in the configuration, which is never translated.
            let text = match name {
                "auto" => "yere göre",
                "one" => "tek",
                "two" => "iki",
                "three" => "üç",
                "lecture" => "ders",
                "design" => "tasarım",
                _ => return format!("düzen: {name}"),
            };
            format!("düzen: {text} ({name})")
        };
        no_other_pane = "başka bölme yok";
        no_split_here = "burada kaydırılacak bölme çizgisi yok";
        more_is_shown(width: u16, height: u16) = "{width} x {height} daha çok gösterir";

        drawing_with_live_tables = "Çizim, canlı tablolarla";
        tables_all = "Bütün tablolar";
        in_the_tables = "Tablolarda";
        plotted_over_the_motion = "Hareket boyunca değerler";
        in_the_plots = "Grafiklerde";
        accuracy_of_methods = "Süreye karşı hata";
        in_the_accuracy_view = "Doğruluk görünümünde";
        forces_everywhere = "Tahrikin torku ya da kuvveti, mafsal ve kılavuz kuvvetleri";
        in_the_forces_view = "Kuvvet görünümünde";
        what_the_scene_gives = "Sahnenin değerleri";
        in_the_scene_view = "Sahne görünümünde";
        working_line_by_line = "Çözüm, satır satır";
        in_the_working = "Çözümde";
        motor_over_a_cycle = "Bir döngüde motor";
        in_the_motor_view = "Motor görünümünde";
        lengths_and_figures = "Her boyun etkisi";
        in_the_lengths_view = "Boylar görünümünde";
        polygons_of_each_loop = "Her döngünün konum, hız ve ivme poligonu";
        in_the_polygons_view = "Poligon görünümünde";

        // Polygons.
        position_polygon = "konum";
        velocity_polygon = "hız";
        acceleration_polygon = "ivme";
        polygon_in_loop(order: &str, number: usize) = "{order}, {number}. döngü";

        // Tables.
        found = "bulunan";
        only_here = "yalnız burada";
        difference_of(title: &str) = "{title}, fark";

        // Accuracy.
        measuring(percent: &str) = "ölçülüyor % {percent}";
        stopped_at(percent: &dyn Display) = "durdu % {percent}";
        all_measured = "hepsi ölçüldü";

        // Forces.
        effort_without_bound(effort: &str) = "{effort}: sınırsız";
        nothing_acts_at_all = "Bu mekanizmaya kuvvet etki etmiyor: sahnede yük, yay ve kütle yok.";
        gravity_without_mass =
            "Bu mekanizmaya kuvvet etki etmiyor: sahnede yerçekimi var, ama hiçbir uzvun kütlesi yok.";
        how_forces_come =
            "Bir uzva mass ve com verin ya da dosyaya [[loads]] veya [[springs]] ekleyin. Bu görünüm o zaman tahrikin \
             torkunu ya da kuvvetini ve her mafsalın kuvvetini gösterir.";
        table_of_guides = "kılavuz";
        least_norm = "en küçük norm";
        force_on = "kuvvet";
        ground = "şase";
        ground_by_all = "şase, toplam";
        direction_of_force = "yön f";
        table_of_checks = "sağlama";
        off_by = "fark";

        // Limits.
        too_many_lengths = "çok fazla boy: krank table --sensitivity kullanın";
        too_many_links = "burada gösterilecek uzuv çok fazla: krank explain kullanın";
        the_curve = "eğri";
    }
}
