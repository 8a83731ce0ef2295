//! The motor's demand over a cycle, and the motion of the ram.

use super::Turkish;
use crate::wording::english::MotorsWords;
use std::fmt::Display;

catalogue! {
    impl MotorsWords for Turkish {
        // The driver's effort over the cycle.
        torque = "tork";
        force = "kuvvet";
        over_a_turn(speed: &str) = "{speed} ile bir turda";
        over_turns(turns: f64, speed: &str) = "{speed} ile {turns} turda";
        there_and_back(low: &str, high: &str, unit: &str, speed: &str) =
            "{low} ile {high} {unit} arasında gidip dönerek, {speed}";
        driver_asks(course: &str, driver: &str, asked: &str) = "{course}, {driver} {asked}";
        asks_throughout(effort: &str) = "her yerde {effort} ister";
        asks_at_worst(effort: &str, place: &str, rms: &str) = "{effort} ister, en kötü an {place}; {rms} RMS";
        asks_too_much(effort: &str) = "sınırsız {effort} gerektirir: en büyük değeri ve RMS değeri yok";
        on_the_way_back(place: &str) = "{place} dönüşte";
        back_at(place: &str) = "{place} dönüşte";
        places_of(places: &[String], unit: &str) = {
            format!("{} {unit}", places.join(" ve "))
        };

        // Remarks on the values.
        nothing_acts = "sahnede yük ve kütle yok, tahrik iş yapmıyor";
        no_figures(why: &str) = "değer yok: {why}";
        mechanism_drives(driver: &str, work: &str) =
            "mekanizma {driver} uzvunu sürüyor: her döngüde {work} J geri veriyor";
        dead_points_run_into(places: &str) =
            "ölü konumlar {places}: onlara doğru ivmeler sınırsız büyür, sabit hızlı bir tahrik oraya varamaz. \
             Ortalamalar ve enerjiler yalnız yükleri ve yerçekimini içerir; bütün değerler için hareketin bir \
             bölümünü seçin";
        dead_points_passed(places: &str) =
            "ölü konumlar {places}: onlara doğru tahrikin torku ya da kuvveti sınırsız büyüyebilir. İşi ve \
             ortalaması var, tepe değeri ve RMS yok; bütün değerler için hareketin bir bölümünü seçin";
        change_points_passed(places: &str) =
            "değişim konumları {places}: orada tork süreklidir, mafsal kuvvetleri sürekli olmayabilir";
        not_converged(error: &str, effort: &str) =
            "integraller yakınsamadı: hata en büyük {effort} değerinin {error} katına ulaşabilir";
        does_not_repeat(numbers: &[String], from: &str, to: &str, unit: &str) = {
            let numbers = numbers.join(" ve ");
            format!("{numbers} numaralı yükün `over` değeri yinelenmiyor: bu, {from} ile {to} {unit} arasındaki döngü")
        };
        repeats_late = "yükler ancak 64 turdan sonra yineleniyor: değerler hareketin bir periyodu için";
        speed_not_kept = "tahrikin hızı sabit değil: ivmesinin gerektirdiği, atalet payının içinde";
        no_power = "tahrik duruyor: güç yok, zaman geçmiyor";
        trapezoids(places: &dyn Display, error: &str, effort: &str) =
            "{places} noktada yamuk kuralı, hata en büyük {effort} değerinin {error} katı";
        polynomials(pieces: &dyn Display, error: &str, effort: &str) =
            "{pieces} parçada polinomlar, hata en büyük {effort} değerinin {error} katı";

        // Labels of values.
        label_all = "hepsi";
        label_largest = "en büyük";
        label_least = "en küçük";
        label_mean = "ortalama";
        label_rms = "RMS";
        label_energy = "enerji";
        label_put_in = "verilen";
        label_given_back = "geri alınan";
        label_work = "iş";
        label_integrals = "integraller";

        // The motor.
        motor_is(verdict: &str) = "motor: {verdict}";
        enough = "yeterli";
        enough_with_flywheel = "volanla birlikte yeterli";
        enough_but_the_flywheel = "yeterli, ama volan küçük";
        not_enough = "yetersiz";
        not_judged(effort: &str) = "değerlendirilmedi: en büyük {effort} yok";
        rated_for_rms = "anma, RMS için";
        peak = "tepe";
        speed = "hız";
        with_flywheel = "volanla";
        with_a_gear = "redüktörle";
        about_the_mean(verdict: &str) = "ortalama çevresinde: {verdict}";
        gear_enough(ratio: &str) = "{ratio} : 1 onu tahrikin hızına indirir: yeterli olur";
        gear_not_enough(ratio: &str) = "{ratio} : 1 onu tahrikin hızına indirir: yine yetmez";
        has_left_by_times(has: &str, wants: &str, left: &str, times: &str) =
            "{wants} için {has}: {left} artar (gerekenin {times} katı)";
        has_left(has: &str, wants: &str, left: &str) = "{wants} için {has}: {left} artar";
        has_a_share(has: &str, wants: &str, percent: &str) = "{wants} için {has}: yalnız yüzde {percent} kadarı";

        // Evenness.
        evenness = "düzgünlük";
        flywheel = "volan";
        fluctuation = "dalgalanma";
        energy_up_and_down(energy: &str, slowest: &str, fastest: &str) =
            "{energy} J: en yavaş {slowest}, en hızlı {fastest}";
        flywheel_leaves(inertia: &str, fluctuation: &str) =
            "{inertia} kg m^2 ile dalgalanma {fluctuation} kalır";
        takes_a_flywheel(fluctuation: &str, inertia: &str) =
            "{fluctuation} için {inertia} kg m^2 volan gerekir";
        impossible(what: &str) =
            "{what}: olanaksız, 2 değerinde tahrik her döngüde bir kez durur; daha büyük bir volan kullanın";
        roughly(what: &str) = "{what}, kaba bir değer: enerji dalgalanmayla yalnız küçükken orantılıdır";

        // Forces on the frame.
        on_frame_with_loads = "şasede, yükler içinde";
        moment = "moment";
        no_joint_forces = "değer yok: mafsal kuvvetleri her konumda bulunmuyor";
        force_throughout(force: &str, x: &str, y: &str) = "her yerde {force} N ({x}, {y})";
        force_at(force: &str, place: &str, x: &str, y: &str, rms: &str) =
            "{force} N, {place} ({x}, {y}); {rms} N RMS";
        moment_throughout(moment: &str) = "başlangıç noktasına göre her yerde {moment} N m";
        moment_at(moment: &str, place: &str, rms: &str) =
            "{moment} N m, {place}, başlangıç noktasına göre; {rms} N m RMS";

        // The ram.
        several_rams(names: &str) = "birkaç kızak koç olabilir, birini seçin: {names}";
        ram_named(name: &str) = "koç {name}";
        ram_works = "çalışır";
        works_at(end: &str) = "{end} ucunda";
        works_at_by_convention(end: &str) = "{end} ucunda, varsayım gereği";
        stroke = "strok";
        bottom = "alt";
        top = "üst";
        turns_too = "yön değiştirir";
        centre_at(at: &str, unit: &str, position: &str, length: &str) =
            "{at} {unit}, konum {position} {length}";
        closes_in = "kapanma";
        opens_in = "açılma";
        in_seconds(way: &str, seconds: &str) = "{way}, {seconds} s";
        time_ratio = "zaman oranı";
        closing_to_opening(ratio: &str) = "{ratio}, kapanma / açılma";
        strokes = "stroklar";
        a_minute(count: &str) = "dakikada {count}";
        dwells = "bekleme";
        dwells_within(way: &str, from: &str, to: &str, tolerance: &str) =
            "{way}: {from} ile {to} arasında; alt noktaya {tolerance} içinde";
        at_height(height: &str, unit: &str) = "{height} {unit} yükseklikte";
        ram_never_there(stroke: &str, unit: &str) = "koç oraya ulaşmaz: stroku {stroke} {unit}";
        closing = "kapanırken";
        opening_way = "açılırken";
        label_place = "yer";
        newtons_per(unit: &str) = "N / {unit}";
        force_held_by(effort: &str) = "kuvvet: tahrikin {effort} değeriyle tuttuğu, sürtünmesiz";
        force_unbounded = "bir ölü konum: kuvvet sınırsız";
    }
}
