//! The driver's position, the assembly, and the drawing of the motion.

use super::Turkish;
use crate::wording::english::MotionWords;
use std::fmt::Display;

catalogue! {
    impl MotionWords for Turkish {
        // The driver's position.
        motion_ends = "hareket burada biter";
        no_number_of(unit: &str, typed: &str) = "{unit} cinsinden bir sayı değil: {typed}";
        taken_as(at: &str, unit: &str) = "{at} {unit} olarak alındı";
        out_of_reach(low: &str, high: &str, unit: &str) = "erişim dışında: {low} .. {high} {unit}";
        no_longer_in_reach(at: &str, unit: &str) = "{at} {unit} artık erişim dışında";
        whole_turns(turns: &str, is_one: bool) = "{turns} tur";

        // Playback.
        step_of(step: &str, unit: &str) = "adım {step} {unit}";
        plays_in(turns: bool, seconds: &dyn Display, backwards: bool) = {
            let sweep = if turns { "tur" } else { "geçiş" };
            format!("1 {sweep} {seconds} s{}", if backwards { ", geri" } else { "" })
        };
        plays_period_in(seconds: &dyn Display, backwards: bool) = {
            format!("hareket {seconds} s{}", if backwards { ", geri" } else { "" })
        };
        time_of_motion(time: &str) = "t {time} s";
        at_driver_speed(unit: &str) = "1 {unit}/s ile";
        driver_stands_still = "tahrik duruyor";
        slower_than_real(times: &str) = "gerçek zamanın 1/{times} hızı";
        faster_than_real(times: &str) = "gerçek zamanın {times} katı";

        // The state of the mechanism.
        ok = "tamam";
        change_point = "değişim konumu";
        dead_point = "ölü konum";
        dead_point_without_rates = "ölü konum: hız, ivme yok";
        stop_of(name: &str) = "dayama ({name})";
        limit = "sınır";
        no_assembly = "kurulamaz";
        no_assembly_here = "burada kurulamaz";
        near_within(what: &str, distance: &str, unit: &str) = "{what}, uzaklığı {distance} {unit}";
        near_in(what: &str, distance: &str, unit: &str) = "{what}: {distance} {unit} sonra";
        no_bound = "sınır yok";

        // Assemblies.
        no_other_assembly = "burada başka montaj biçimi yok";
        rest_does_not_close(choice: &dyn Display) = "{choice} ile montaj yok";
        assembly_now(choice: &dyn Display) = "şimdi {choice}";
        assembly_now_untold(choice: &dyn Display) =
            "şimdi {choice}; hiçbir [start] onu seçmez, bu yüzden kaydedilemez";
        assembly_now_saved_by(choice: &dyn Display, key: &dyn Display) = "şimdi {choice}; {key} kaydeder";
        shown_now = "şimdi";
        does_not_close = "açık";
        degrees(figure: &str) = "{figure} deg";

        // The drawing.
        drawn_with(glyphs: &str) = "çizim: {glyphs}";
        glyphs_ascii = "ASCII";
        glyphs_lines = "çizgiler";
        glyphs_braille = "Braille";
        glyphs_quadrants = "dörtlü bloklar";
        glyphs_sextants = "altılı bloklar, yazı tipinde varsa";
        glyphs_octants = "sekizli bloklar, yazı tipinde varsa";
        no_colours = "renksiz";
        sixteen_colours = "terminalin 16 rengi";
        colours_of_256 = "256 renk";
        true_colours = "24 bit renk";
        switched_on(what: &str) = "{what}: açık";
        switched_off(what: &str) = "{what}: kapalı";
        the_whole_motion = "bütün hareket";
        window_goes_along = "görünüş birlikte gider";
        window_stays_with(point: &str) = "görünüş {point} noktasını izler";
        no_more_to_zoom = "yakınlaştırma sınırında";
        zoomed(times: &str) = "büyütme {times}";
        names_of_points = "nokta adları";
        names_of_points_and_links = "nokta ve uzuv adları";
        no_names = "adsız";
        trace_of(names: &str) = "iz {names}";
        traces_of(count: usize) = "{count} iz";
        ghost_positions(count: u16) = "{count} konum";
        a_centre_of_mass = "x ağırlık merkezi";
        arrows_without_scale(letter: &str) = "{letter} 0: tahrik duruyor";
        drawing_of(scene: &str, at: &dyn Display, unit: &str) = "{scene}, {at} {unit}";
        language_is = "dil: Türkçe";

        place_in_cycle(at: &str, whole: &str, unit: &str) = "{at} / {whole} {unit}";
        place_in_range(at: &str, low: &str, high: &str, unit: &str) = "{at} ({low}..{high} {unit})";

        // Lists, search and selection.
        nothing_at_the_side = "burada başka sütun yok";
        begins_a_frame(point: &str, link: &str) =
            "{point}, {link} uzvunun başlangıç noktası: boyunu listede değiştirin";
        no_further_part = "başka bölüm yok";
        nothing_to_search = "burada aranacak bir şey yok";
        never_moves(name: &str) = "{name} hiç hareket etmez: izlenecek bir şey yok";
        all_of(names: &[&str]) = { names.join(" ve ") };
        no_longer_chosen(names: &str) = "artık seçili değil: {names}";
        chosen_for_motion(names: &str) = "hareket görünümü için seçildi: {names}";
        no_row_named(typed: &str) = "adı {typed} olan satır yok";
    }
}
