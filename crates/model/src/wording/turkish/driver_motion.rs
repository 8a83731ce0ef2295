//! The driver's motion over time.

use super::Turkish;
use crate::wording::english::CoursesWords;

catalogue! {
    impl CoursesWords for Turkish {
        a_list_of_steps = "adım listesi";
        no_steps = "adım yok";
        step_of_motion(number: usize) = "hareketin {number}. adımı";
        motion_does_not_close(start: f64, end: f64) =
            "hareket {start} konumunda başlayıp {end} konumunda bitiyor, bu yüzden yinelenemez";
        ends_elsewhere = "başladığı yerde bitmiyor";
        motion_of_link_closes =
            "hareketin yinelenmesi için son adımı tahrikin `angle` açısında ya da ondan tam turlar ötede \
             bitirin";
        motion_of_slide_closes = "hareketin yinelenmesi için son adımı tahrikin `position` konumunda bitirin";
        step_leaves_range(number: usize, to: f64, low: f64, high: f64) =
            "hareketin {number}. adımı {to} konumunda bitiyor, ama tahrikin dayamaları {low} ve {high} \
             konumlarında";
        beyond_a_stop = "bir dayamanın ötesinde";
        the_stops = "dayamalar";
        step_has_one_of(of: &str, one: &str, other: &str) =
            "{of}: `{one}` ile `{other}` anahtarlarından tam biri gerekir";
        how_does_it_move = "hareket yasası eksik";
        no_law_of_motion(of: &str, name: &str) = "{of}: {name} bir hareket yasası değil";
        unknown_law = "bilinmeyen yasa";
        known_laws(list: &str) = "bilinen yasalar: {list}";
        step_has_no_key(of: &str, key: &str) = "{of}: bu tür adımda `{key}` olmaz";
        not_for_this_step = "bu adım için geçerli değil";
        keys_of_step(list: &str) = "anahtarları: {list}";
        at_most_a_half = "0'dan büyük ve en çok 0.5";
        time_and_coordinate = "[zaman, koordinat]";
        times_must_grow(what: &str, first: &str, second: &str) =
            "{what}: zamanlar düğümden düğüme artmalı, ama {first} değerinden sonra {second} geliyor";
        driver_and_input = "[tahrikin koordinatı, kendi koordinatı]";
        places_must_grow(what: &str, first: &str, second: &str) =
            "{what}: tahrikin koordinatları düğümden düğüme artmalı, ama {first} değerinden sonra {second} \
             geliyor";
        input_has_two_laws(of: &str, one: &str, other: &str) = "{of}: hem `{one}` hem `{other}` var: birini bırakın";
        says_the_same_otherwise = "aynı giriş için ikinci bir kural";
        one_law = "ilk kural";
        table_does_not_close(of: &str, first: f64, last: f64) =
            "{of}: tablo tahrikin tam turlarını kapsıyor, ama {first} değerinde başlayıp {last} değerinde \
             bitiyor, bu yüzden yinelenemez";
        table_of_link_closes =
            "son değeri ilk değere eşit ya da ondan tam turlar ötede yapın: tablo yinelenir";
        table_of_slide_closes = "son değeri ilk değere eşit yapın: tablo yinelenir";
        or_table_is_shorter =
            "ya da tabloyu hareketin bittiği yerde bitirin, ya da tahrike bir `range` verin";
        table_of_one_knot(what: &str) = "{what}: tek düğüm var, hiçbir şey hareket etmez";
        table_begins_elsewhere(of: &str, literal: &str) =
            "{of}: ilk düğüm, önceki adımın sonu olan {literal} olmalı";
        the_first_knot_is(literal: &str) = "{literal} ile başlamalı";
        table_goes_on = "zamanlar adımın başından ölçülür; koordinatlar tahrikin koordinatlarıdır";
        motion_beside(key: &str) = "tahrikte hem `motion` hem `{key}` var";
        the_motion_says = "bunu `motion` zaten belirliyor";
        leave_out_beside_motion(key: &str) =
            "`{key}` anahtarını silin; sabit hızı bir adım olarak yazın: {{ law = \"constant\", to = 360, time \
             = 2 }}";

        // Values over time.
        moment_of_motion =
            "Sahne açıldıktan sonraki zaman (s): tahrikin konumu, hızı ve ivmesi zamana göre hareketinden \
             bulunur";
        rows_over_time =
            "Zamana göre satırlar: --from, --to ve --step, sahne açıldıktan sonraki zamandır (s); tahrik \
             hareketini izler";
        rates_by_coordinate(unit: &str) =
            "hızlar ve ivmeler 1 {unit} hızındaki tahrik içindir; zamana göre hareketinki için --time kullanın";

        // The motor.
        over_a_period(seconds: &str) = "hareketin {seconds} s süren bir periyodunda";
        at_a_time(value: &str, seconds: &str, place: &str) = "{value}, {seconds} s anında, {place}";
        part_between(least: &str, most: &str, rms: &str) = "{least} ile {most} arası, RMS {rms}";
        only_at_one_speed(option: &str) =
            "`{option}` için sabit hızlı bir döngü gerekir, ama bu sahnede zamana göre hareket var";
        motion_passes_stop(at: &str, unit: &str, time: &str, name: &str) =
            "zamana göre hareket dayamayı ({name}) geçiyor: {at} {unit}, {time} s anında";
        motion_passes_table(at: &str, unit: &str, time: &str, name: &str) =
            "zamana göre hareket {name} tablosunun sonunu geçiyor: {at} {unit}, {time} s anında";
        motion_passes_end(at: &str, unit: &str, time: &str) =
            "zamana göre hareket {time} s anında aralığın sonunu, {at} {unit} konumunu geçiyor";
        no_torque_on_the_way(at: f64, unit: &str) =
            "zamana göre hareket {at} {unit} konumuna ulaşıyor; mekanizma orada kurulamaz ya da ölü konumdadır";
    }
}
