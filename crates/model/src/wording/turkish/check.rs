//! The facts that `krank check` prints.

use super::Turkish;
use crate::wording::english::CheckingWords;
use std::fmt::Display;

catalogue! {
    impl CheckingWords for Turkish {
        // Labels.
        fact_source = "kaynak";
        fact_note = "not";
        fact_unit = "birim";
        fact_parameters = "parametreler";
        fact_parts = "parçalar";
        fact_driver = "tahrik";
        fact_motion = "hareket";
        fact_links = "uzuvlar";
        fact_joints = "mafsallar";
        fact_slides = "kızaklar";
        knots_outside(of: &str, at: &str) = "`over` ({of}): hareketin ulaşmadığı düğümler: {at}";
        fact_mobility = "serbestlik";
        fact_redundant = "fazla";
        fact_groups = "gruplar";
        fact_choices = "seçimler";
        fact_assemblies = "montaj";
        fact_loop = "döngü";
        fact_range = "aralık";
        fact_stops = "dayamalar";
        fact_change = "değişim";
        fact_near_miss = "yakın geçiş";
        fact_figures = "stroklar";
        fact_transmission = "açı";
        fact_condition = "koşul";
        fact_forces = "kuvvetler";
        fact_open = "açık";

        // Parts.
        parts_and_ground(links: usize, pins: usize, slides: usize) = {
            format!(
                "{} ve şase, {}, {}",
                some(links, "uzuv"),
                some(pins, "döner mafsal"),
                some(slides, "kızak")
            )
        };
        driven_link(name: &str) = "uzuv {name}";
        turned_from(name: &str, from: &str) = "{name} ({from} uzvuna göre)";
        driven_slide(name: &str) = "kızak {name}";
        driver_opens(driven: &str, at: &str, speed: &str, acceleration: &str) =
            "{driven}, açılışta {at}, {speed}, {acceleration}";
        driver_opens_at(driven: &str, at: &str) = "{driven}, açılışta {at}";
        motion_in_time(laws: &str, period: &str) = "{laws}, {period} s sürer";
        motion_rests(rest: &str) = ", bunun {rest} s kadarı bekleme";
        motion_at_most(speed: &str, acceleration: &str) = "; en çok {speed} ve {acceleration}";
        motion_jumps(time: &str) = "; hız {time} s anında sıçrar";
        motion_verdict(period: &str, speed: &str, acceleration: &str) =
            "{period} s, en çok {speed} ve {acceleration}";
        motion_in_short(period: &str, speed: &str) = "{period} s, {speed}";
        input_follows(driven: &str, ratio: &str, phase: &str) =
            "{driven} izler: tahrik koordinatının {ratio} katı artı {phase}";
        input_follows_table(driven: &str, knots: usize, ends: [&str; 2], unit: &str) = {
            let [first, last] = ends;
            format!("{driven} bir tabloyu izler: {knots} düğüm, tahrik {first} ile {last} {unit} arasında")
        };
        table_repeats(period: &str) = ", {period} deg sonra yinelenir";
        knots_beyond_motion(knots: usize) = "; {knots} düğüm hareketin dışında kalır";
        input_given_by_table(driven: &str, knots: &str, units: [&str; 2], closes: bool) = {
            let [driver, own] = units;
            let ends = match closes {
                true => "periyodik",
                false => "iki ucunda duran",
            };
            format!(
                "{driven}, {ends} bir kübik spline izler [tahrik {driver}, kendi koordinatı {own}]: {knots}"
            )
        };
        pin_in_slot(name: &str, pin: &str, of: &str) = "{name}: pim {pin}, yarığı taşıyan: {of}";
        link_along(name: &str, link: &str, guide: &str) =
            "{name}: uzuv {link}, {guide} boyunca, ona göre dönmez";
        slide_counts_backwards(name: &str, r: &str, unit: &str, angles: [&str; 2], theta: Option<&String>) = {
            let [angle, other] = angles;
            let at = theta.map(|theta| format!(" (theta {theta} deg)")).unwrap_or_default();
            format!(
                "{name} sahnenin açıldığı konumda negatif, {r} {unit}: `through` noktasından `angle = {angle}` yönünde \
                 ölçülür, ama vektörü ters yöndedir; pozitif olması için ders notlarındaki gibi `angle = {other}` yazın{at}"
            )
        };

        // Mobility and groups.
        mobility_set_aside(mobility: &dyn Display, count: usize, which: &str) = {
            let count = some(count, "fazla kısıt");
            format!("{mobility}, {count} hesaba katılmadı: {which}")
        };
        mobility_not_certain =
            "neredeyse 2 ya da daha fazla: boyutlar biraz farklı olsa bir uzuv serbest kalırdı";
        mobility_more_at_opening =
            "sahnenin açıldığı konumda daha büyük: bağlaşık bir grubun değişim ya da ölü konumu";
        repeats_others(part: &str) = "{part} başka kısıtları yineler";
        repeats(part: &str, others: &str) = "{part} şunları yineler: {others}";
        disagree_by(what: &str, misfit: &str) = "{what}; aralarındaki fark en çok {misfit}";
        some_and_more(some: &str, more: usize) = "{some} ve {more} tane daha";
        dyad(class: &str) = "ikili grup {class}";
        dyad_at(class: &str, point: &str) = "ikili grup {class}, {point} noktasında";
        coupled_group(unknowns: usize) = {
            format!("bağlaşık grup, {}", some(unknowns, "bilinmeyen"))
        };
        coupled_group_at(point: &str, unknowns: usize) = {
            format!("bağlaşık grup, {point} noktasında, {}", some(unknowns, "bilinmeyen"))
        };
        closed_form = "kapalı form";
        by_newton = "Newton ile";
        group_of_driver(driven: &str) = "tahrik: {driven}";
        group_of_nothing(group: &str, how: &str) = "{group} ({how})";
        group_of_link(group: &str, link: &str, how: &str) = "{group}: uzuv {link} ({how})";
        group_of_links(group: &str, links: &str, how: &str) = "{group}: uzuvlar {links} ({how})";

        // Assemblies.
        those_of_more(count: usize) = "ve {count} tane daha";
        more_than(count: usize) = "{count} taneden çok";
        chosen_now(choice: &str) = "{choice} şimdi";
        rest_open(choice: &str) = "{choice} (gerisi kurulamaz)";
        at_place(choice: &str, x: &str, y: &str) = "{choice}: ({x}, {y})";

        // The first loop.
        driven_coupler_follower_frame(lengths: &[String; 4], unit: &str) = {
            let [driven, coupler, follower, frame] = lengths;
            format!("tahrik {driven}, biyel {coupler}, çıkış {follower}, şase {frame} {unit}")
        };
        crank_rod_offset(lengths: &[String; 3], unit: &str) = {
            let [crank, rod, offset] = lengths;
            format!("krank {crank}, biyel {rod}, kaçıklık {offset} {unit}")
        };
        four_bar(inversion: &str, grashof: &str) = "dört çubuk, {inversion}: {grashof}";
        slider_crank(what: &str) = "krank-biyel, {what}";
        slider_crank_alone = "krank-biyel";
        crank_turns_fully = "krank tam döner: biyel > krank + kaçıklık";
        rod_is_crank_and_offset = "değişim konumu: biyel = krank + kaçıklık";
        crank_rocks = "krank tam dönmez: biyel < krank + kaçıklık";
        grashof = "Grashof, s + l < p + q";
        grashof_change_point = "değişim konumu, s + l = p + q";
        not_grashof = "Grashof değil, s + l > p + q";
        crank_rocker = "krank-sarkaç";
        rocker_crank = "sarkaç-krank";
        double_crank = "çift krank";
        drag_link = "çift krank (sürükleyici)";
        double_rocker = "çift sarkaç";
        triple_rocker = "üçlü sarkaç";

        // The motion.
        range_full(period: &dyn Display, unit: &str) =
            "tam döner; hareket {period} {unit} sonra yinelenir";
        range_limited(low: &str, high: &str, unit: &str) = "{low} .. {high} {unit}";
        range_errors(low: &str, high: &str) = "alt ucun hatası {low}, üst ucun hatası {high}";
        end_error(bound: &str, unit: &str) = "en çok {bound} {unit}";
        end_error_not_proved = "kanıtlanmadı";
        never_met(name: &str, low: &str, high: &str, unit: &str) =
            "hiç ulaşılmıyor: {name}, {low} ile {high} {unit} arası";
        stop_at(at: &str, unit: &str, name: &str, value: &str) =
            "{at} {unit}: {name} {value} değerinde";
        table_ends_at(at: &str, unit: &str, name: &str) = "{at} {unit}: {name} tablosunun sonu";
        table_named(name: &str) = "{name} tablosu";
        change_points_at(places: &str, unit: &str) = "{places} {unit} konumunda, kesintisiz geçilir";
        equal_as_typed = "yazılan değerleri eşit olan boylar eşit sayılır";
        equal_within(tolerance: &str, unit: &str) =
            "farkı en çok {tolerance} {unit} olan boylar eşit sayılır: koordinatlar yuvarlanmıştır";
        ends_lined_up(at: &str, unit: &str, group: &str) =
            "{group} noktasındaki uzuvlar aralığın sonunda, {at} {unit} konumunda bir doğru üzerine gelir: \
             hareketin nasıl sürdüğü kanıtlanmadı";
        near_miss(at: &str, unit: &str, sine: &str, group: &str) =
            "neredeyse değişim ya da ölü konum: {at} {unit}, bağlama açısının sinüsü {sine} ({group}); hareket \
             montaj biçimini korur";
        transmission_throughout(group: &str, angle: &str) = "bağlama açısı, {group}: hep {angle} deg";
        transmission_between(group: &str, angles: [&str; 4], unit: &str) = {
            let [minimum, at_least, maximum, at_most] = angles;
            format!(
                "bağlama açısı, {group}: en küçük {minimum} deg, {at_least} {unit} konumunda; en büyük \
                 {maximum} deg, {at_most} {unit} konumunda"
            )
        };

        // The verdict.
        range_whole = "tam döner";
        range_between(low: &str, high: &str, unit: &str) = "{low}..{high} {unit}";
        stop_in_verdict(name: &str, at: &str) = "dayama ({name}): {at}";
        stops_of(names: &[String]) = { format!("dayamalar ({})", names.join(", ")) };
        some_change_points(count: usize) = "{count} değişim konumu";
        transmission_worst(group: Option<&str>, off: &str, at: &str, unit: &str) = {
            let group = group.map(|group| format!(" {group}")).unwrap_or_default();
            format!("bağlama açısı{group}: 90'dan {off} deg sapma, {at} {unit}")
        };
        transmission_off(off: &str) = "90'dan sapma {off}";
        nothing_of_it = "yok";
        became(old: &str, new: &str) = "{old} -> {new}";

        // Loads.
        count_of_forces(count: usize) = "{count} kuvvet";
        count_of_torques(count: usize) = "{count} tork";
        count_of_presses(count: usize) = "{count} pres";
        count_of_springs(count: usize) = "{count} yay";
        count_of_masses(count: usize) = "{count} kütleli uzuv";
        gravity = "yerçekimi";
        repeated_after(what: &str, period: &dyn Display) = "{what}; {period} deg sonra yinelenir";
        not_settled(reactions: &str) = "dengenin belirlemediği tepki kuvvetleri: {reactions}";
    }
}

/// Formats a count with its noun: `kızak yok`, `1 kızak`, `2 kızak`.
fn some(count: usize, what: &str) -> String {
    match count {
        0 => format!("{what} yok"),
        _ => format!("{count} {what}"),
    }
}
