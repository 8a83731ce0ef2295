//! The driver's motion over time.

use super::Turkish;
use crate::wording::english::CoursesWords;

catalogue! {
    impl CoursesWords for Turkish {
        a_list_of_steps = "adım listesi";
        no_steps = "adım yok";
        step_of_motion(number: usize) = "hareketin {number}. adımı";
        motion_does_not_close(start: f64, end: f64) =
            "hareket {start} konumunda başlıyor, {end} konumunda bitiyor: oradan yeniden başlayamaz";
        ends_elsewhere = "başladığı yerde bitmiyor";
        motion_of_link_closes =
            "son adım tahrikin `angle` açısında ya da ondan tam turlar ötede bitsin: hareket yinelenir";
        motion_of_slide_closes = "son adım tahrikin `position` konumunda bitsin: hareket yinelenir";
        step_leaves_range(number: usize, to: f64, low: f64, high: f64) =
            "hareketin {number}. adımı {to} konumuna gidiyor, tahrik ise {low} ve {high} konumlarında durur";
        beyond_a_stop = "bir dayamanın ötesinde";
        the_stops = "dayamalar";
        step_has_one_of(of: &str, one: &str, other: &str) =
            "{of}: `{one}` ile `{other}` anahtarlarından tam biri gerekir";
        how_does_it_move = "nasıl hareket ediyor?";
        no_law_of_motion(of: &str, name: &str) = "{of}: {name} bir hareket yasası değil";
        unknown_law = "bilinmeyen yasa";
        known_laws(list: &str) = "bilinen yasalar: {list}";
        step_has_no_key(of: &str, key: &str) = "{of}: bu tür adımda `{key}` olmaz";
        not_for_this_step = "bu adıma göre değil";
        keys_of_step(list: &str) = "anahtarları: {list}";
        at_most_a_half = "0'dan büyük ve en çok 0.5";
        time_and_coordinate = "[zaman, koordinat]";
        times_must_grow(what: &str, first: &str, second: &str) =
            "{what}: zamanlar düğümden düğüme büyümeli, oysa {first} ardından {second} geliyor";
        driver_and_input = "[tahrikin koordinatı, kendi koordinatı]";
        places_must_grow(what: &str, first: &str, second: &str) =
            "{what}: tahrikin koordinatları düğümden düğüme büyümeli, oysa {first} ardından {second} geliyor";
        table_beside(of: &str, key: &str) = "{of}: hem `over` tablosu hem `{key}` var";
        says_the_same_otherwise = "nasıl izlediğini başka türlü söylüyor";
        the_table = "tablo";
        table_does_not_close(of: &str, first: f64, last: f64) =
            "{of}: tablo tahrikin tam turlarını kapsıyor, ama {first} değerinde başlayıp {last} değerinde bitiyor: sonraki tur oradan süremez";
        table_of_link_closes = "son değer ilk değer ya da ondan tam turlar ötede olsun: tablo yinelenir";
        table_of_slide_closes = "son değer ilk değer olsun: tablo yinelenir";
        or_table_is_shorter = "ya da tablo hareketin bittiği yerde bitsin, ya da tahrike bir `range` ver";
        table_of_one_knot(what: &str) = "{what}: tek düğüm var, hiçbir şey hareket etmez";
        table_begins_elsewhere(of: &str, literal: &str) =
            "{of}: ilk düğüm, önceki adımın bittiği {literal} olmalı";
        the_first_knot_is(literal: &str) = "{literal} ile başlamalı";
        table_goes_on = "zamanlar adımın başından sayılır, koordinatlar tahrikin kendisininkidir";
        motion_beside(key: &str) = "tahrikin hem `motion` hem `{key}` değeri var";
        the_motion_says = "bunu hareket zaten söylüyor";
        leave_out_beside_motion(key: &str) =
            "`{key}` yazma; sabit hız da bir adımdır: {{ law = \"constant\", to = 360, time = 2 }}";

        // Figures over time.
        moment_of_motion = "Sahnenin açıldığı yerden s olarak zaman: tahrik, zamana göre hareketinin onu getirdiği \
             yerde, o hızda ve o ivmededir";
        rows_over_time = "Zamana göre satırlar: --from, --to ve --step, sahnenin açıldığı yerden s olaraktır; tahrik \
             sahnenin dediği gibi hareket eder";
        rates_by_coordinate(unit: &str) =
            "hızlar ve ivmeler 1 {unit} hızındaki bir tahrik içindir; zamana göre hareketteki değerler: --time";

        // The motor.
        over_a_period(seconds: &str) = "zamana göre hareketin {seconds} s süren bir periyodunda";
        at_a_time(value: &str, seconds: &str, place: &str) = "{value}, {seconds} s anında, {place}";
        part_between(least: &str, most: &str, rms: &str) = "{least} ile {most} arası, RMS {rms}";
        only_at_one_speed(option: &str) =
            "`{option}` tek hızdaki bir döngü içindir; bu sahnenin zamana göre bir hareketi var";
        motion_passes_stop(at: &str, unit: &str, time: &str, name: &str) =
            "zamana göre hareket dayamanın ({name}) ötesine geçiyor: {at} {unit}, {time} s anında";
        motion_passes_table(at: &str, unit: &str, time: &str, name: &str) =
            "zamana göre hareket {name} tablosunun sonunun ötesine geçiyor: {at} {unit}, {time} s anında";
        motion_passes_end(at: &str, unit: &str, time: &str) =
            "zamana göre hareket {time} s anında {at} {unit} konumunun ötesine geçiyor; mekanizma oradan ileri gidemez";
        no_torque_on_the_way(at: f64, unit: &str) =
            "zamana göre hareket {at} {unit} konumuna götürüyor; mekanizma orada olamaz ya da ölü konumdadır";
    }
}
