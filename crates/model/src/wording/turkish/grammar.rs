//! Turkish messages that need grammar: plural forms, choices and lists. `turkish.txt` has all others.

use super::{parser, presets, syntax};
use std::fmt::Display;

pub(in crate::wording) fn parts_and_ground(links: usize, pins: usize, slides: usize) -> String {
    format!(
        "{} ve şase, {}, {}",
        some(links, "uzuv"),
        some(pins, "döner mafsal"),
        some(slides, "kızak")
    )
}

pub(in crate::wording) fn input_follows_table(
    driven: &str,
    knots: usize,
    ends: [&str; 2],
    unit: &str,
) -> String {
    let [first, last] = ends;
    format!("{driven} bir tabloyu izler: {knots} düğüm, tahrik {first} ile {last} {unit} arasında")
}

pub(in crate::wording) fn input_given_by_table(
    driven: &str,
    knots: &str,
    units: [&str; 2],
    closes: bool,
) -> String {
    let [driver, own] = units;
    let ends = match closes {
        true => "periyodik",
        false => "iki ucunda duran",
    };
    format!(
        "{driven}, {ends} bir kübik spline izler [tahrik {driver}, kendi koordinatı {own}]: {knots}"
    )
}

pub(in crate::wording) fn slide_counts_backwards(
    name: &str,
    r: &str,
    unit: &str,
    angles: [&str; 2],
    theta: Option<&String>,
) -> String {
    let [angle, other] = angles;
    let at = theta
        .map(|theta| format!(" (theta {theta} deg)"))
        .unwrap_or_default();
    format!(
        "{name} sahnenin açıldığı konumda negatif, {r} {unit}: `through` noktasından `angle = {angle}` yönünde \
         ölçülür, ama vektörü ters yöndedir; pozitif olması için ders notlarındaki gibi `angle = {other}` yazın{at}"
    )
}

pub(in crate::wording) fn mobility_set_aside(
    mobility: &dyn Display,
    count: usize,
    which: &str,
) -> String {
    let count = some(count, "fazla kısıt");
    format!("{mobility}, {count} hesaba katılmadı: {which}")
}

pub(in crate::wording) fn coupled_group(unknowns: usize) -> String {
    format!("bağlaşık grup, {}", some(unknowns, "bilinmeyen"))
}

pub(in crate::wording) fn coupled_group_at(point: &str, unknowns: usize) -> String {
    format!(
        "bağlaşık grup, {point} noktasında, {}",
        some(unknowns, "bilinmeyen")
    )
}

pub(in crate::wording) fn driven_coupler_follower_frame(
    lengths: &[String; 4],
    unit: &str,
) -> String {
    let [driven, coupler, follower, frame] = lengths;
    format!("tahrik {driven}, biyel {coupler}, çıkış {follower}, şase {frame} {unit}")
}

pub(in crate::wording) fn crank_rod_offset(lengths: &[String; 3], unit: &str) -> String {
    let [crank, rod, offset] = lengths;
    format!("krank {crank}, biyel {rod}, kaçıklık {offset} {unit}")
}

pub(in crate::wording) fn transmission_between(
    group: &str,
    angles: [&str; 4],
    unit: &str,
) -> String {
    let [minimum, at_least, maximum, at_most] = angles;
    format!(
        "bağlama açısı, {group}: en küçük {minimum} deg, {at_least} {unit} konumunda; en büyük \
         {maximum} deg, {at_most} {unit} konumunda"
    )
}

pub(in crate::wording) fn stops_of(names: &[String]) -> String {
    format!("dayamalar ({})", names.join(", "))
}

pub(in crate::wording) fn transmission_worst(
    group: Option<&str>,
    off: &str,
    at: &str,
    unit: &str,
) -> String {
    let group = group.map(|group| format!(" {group}")).unwrap_or_default();
    format!("bağlama açısı{group}: 90'dan {off} deg sapma, {at} {unit}")
}

/// Formats a count with its noun: `kızak yok`, `1 kızak`, `2 kızak`.
fn some(count: usize, what: &str) -> String {
    match count {
        0 => format!("{what} yok"),
        _ => format!("{count} {what}"),
    }
}

pub(in crate::wording) fn of_parser(text: &str) -> String {
    parser::translate_message(text)
}

pub(in crate::wording) fn cannot_read(name: &str, why: &dyn Display) -> String {
    format!("{name} okunamıyor: {}", parser::of_system(why))
}

pub(in crate::wording) fn cannot_write_results(why: &dyn Display) -> String {
    format!("sonuçlar yazılamıyor: {}", parser::of_system(why))
}

pub(in crate::wording) fn cannot_write(name: &dyn Display, why: &dyn Display) -> String {
    format!("`{name}` yazılamıyor: {}", parser::of_system(why))
}

pub(in crate::wording) fn ignored(first: &str, more: usize) -> String {
    match more {
        0 => first.to_owned(),
        _ => format!("{first}, ve {more} tane daha"),
    }
}

pub(in crate::wording) fn slow_by_quick(
    ratio: &str,
    slow: &str,
    quick: &str,
    rises: bool,
) -> String {
    let (there, back) = if rises {
        ("artarken", "azalırken")
    } else {
        ("azalırken", "artarken")
    };
    format!("{ratio}: {there} {slow}, {back} {quick}")
}

pub(in crate::wording) fn unit_of_goal(figure: &str, unit: &str, found: &str) -> String {
    match unit {
        "" => format!("{figure} birimsizdir, birimi {found} değil: yalnız sayıyı yazın"),
        unit => format!(
            "{figure} büyüklüğünün birimi {unit}, {found} değil: yalnız sayıyı ya da bu türden bir birimle yazın"
        ),
    }
}

pub(in crate::wording) fn none_meets_goals(starts: u32) -> String {
    format!("{starts} başlangıçtan hiçbir tasarım bütün hedefleri karşılamıyor; en yakını aşağıda")
}

pub(in crate::wording) fn no_design_opens(starts: u32) -> String {
    format!("{starts} başlangıçtan hiçbir tasarımda bu büyüklüklerin hepsi yok")
}

pub(in crate::wording) fn one_design_meets(starts: u32) -> String {
    format!("bir tasarım, {starts} başlangıçtan")
}

pub(in crate::wording) fn designs_meet(count: usize, shown: usize, starts: u32) -> String {
    let first = match count > shown {
        true => format!(", en yakın {shown} tanesi aşağıda"),
        false => ", önce en yakını".into(),
    };
    format!("{count} tasarım{first}, {starts} başlangıçtan")
}

pub(in crate::wording) fn family_of_designs(freedoms: usize) -> String {
    format!(
        "{freedoms} serbestlik dereceli bir aileden: yakındaki tasarımlar da hedefleri karşılar"
    )
}

pub(in crate::wording) fn generations_made(generations: u32, settled: bool) -> String {
    match settled {
        true => format!("{generations} kuşağın en iyisi; arama yakınsadı"),
        false => format!("{generations} kuşağın en iyisi; arama yakınsamadı"),
    }
}

pub(in crate::wording) fn polished_best(stationary: bool) -> String {
    match stationary {
        true => "sınırlar içinde hiçbir küçük değişiklik onu iyileştirmiyor",
        false => "küçük bir değişikliğin onu iyileştirmeyeceği kesin değil",
    }
    .to_owned()
}

pub(in crate::wording) fn designs_from_to(
    figure: &str,
    minimum: [&str; 2],
    maximum: [&str; 2],
) -> String {
    let ([minimum, low], [maximum, high]) = (minimum, maximum);
    format!("{figure}: en küçük {minimum}, {low} iken; en büyük {maximum}, {high} iken")
}

pub(in crate::wording) fn goal_needs_opening(why: &str) -> String {
    match why.is_empty() {
        true => "yakında hesaplanabilen bir tasarım yok".to_owned(),
        false => format!("yakında hesaplanabilen bir tasarım yok; bunda: {why}"),
    }
}

pub(in crate::wording) fn gathering(count: usize) -> String {
    match count {
        0 => "değişiklikler bekler".to_owned(),
        count => format!("{count} değişiklik bekliyor"),
    }
}

pub(in crate::wording) fn gathered_made(count: usize) -> String {
    match count {
        0 => "değişiklikler hemen uygulanır".to_owned(),
        count => format!("{count} değişiklik uygulandı"),
    }
}

pub(in crate::wording) fn terminal_failed(why: &dyn Display) -> String {
    format!("terminal hata verdi: {}", parser::of_system(why))
}

pub(in crate::wording) fn no_number_typed(typed: &str, units: &str) -> String {
    match units {
        "" => format!("sayı değil: {typed}; bir sayı yazın"),
        units => format!("sayı değil: {typed}; birimsiz ya da şu birimlerle yazın: {units}"),
    }
}

pub(in crate::wording) fn unit_does_not_fit(unit: &str, units: &str) -> String {
    match units {
        "" => format!("{unit} buraya uymaz: birimsiz yazın"),
        units => format!("{unit} buraya uymaz: {units}"),
    }
}

pub(in crate::wording) fn either(places: &[String]) -> String {
    places.join(" ya da ")
}

pub(in crate::wording) fn together(parts: &[String]) -> String {
    parts.join(" ve ")
}

pub(in crate::wording) fn give_one_position(lines: &[String]) -> String {
    format!(
        "yaklaşık bir konum verin, şunlardan biri:\n[start]\n{}",
        lines.join("   # ya da\n")
    )
}

pub(in crate::wording) fn open_as_well(points: &[String]) -> String {
    format!("; bunlar da açık: {}", points.join(", "))
}

pub(in crate::wording) fn one_of_lines(lines: &[String]) -> String {
    lines.join("   # ya da ")
}

pub(in crate::wording) fn not_written(why: &str) -> String {
    format!("yazılmadı: {}", parser::of_system(&why))
}

pub(in crate::wording) fn not_written_to(name: &str, why: &str) -> String {
    format!("yazılmadı, {}: {name}", parser::of_system(&why))
}

pub(in crate::wording) fn cannot_be_read(why: &dyn Display) -> String {
    format!("okunamıyor: {}", parser::of_system(why))
}

pub(in crate::wording) fn name_cannot_be_read(name: &str, why: &dyn Display) -> String {
    format!("{name} okunamıyor: {}", parser::of_system(why))
}

pub(in crate::wording) fn function_takes(
    name: &str,
    minimum: usize,
    maximum: usize,
    found: usize,
) -> String {
    let takes = match minimum == maximum {
        true => format!("{minimum}"),
        false => format!("{minimum} ile {maximum} arası"),
    };
    format!("{name}() {takes} argüman alır, {found} değil")
}

pub(in crate::wording) fn measured_in(what: &str, unit: &str) -> String {
    match unit {
        "1" => format!("`{what}` birimsiz bir sayı"),
        unit => format!("`{what}` birimi {unit}"),
    }
}

pub(in crate::wording) fn takes_an_angle(function: &str, unit: &str) -> String {
    match unit {
        "1" => format!("{function}() açı alır, bu ise birimsiz bir sayı"),
        unit => format!("{function}() açı alır, bunun birimi ise {unit}"),
    }
}

pub(in crate::wording) fn parameters_measured_in(
    named: &[(String, String)],
    wanted: &str,
) -> String {
    let named: Vec<_> = named
        .iter()
        .map(|(name, unit)| format!("`{name}` birimi {unit}"))
        .collect();
    let wanted = match wanted {
        "1" => String::new(),
        wanted => format!("{wanted} ile ya da "),
    };
    format!(
        "{}: {wanted}birimsiz bir sayı olarak yazın",
        named.join(", ")
    )
}

pub(in crate::wording) fn no_value_named(name: &str, intended: Option<&str>) -> String {
    let intended = intended.map_or(String::new(), |intended| format!("; {intended}"));
    format!("sahnede `{name}` adında değer yok{intended}")
}

pub(in crate::wording) fn no_input_named(name: &str, names: &str, meant: Option<&str>) -> String {
    let meant = meant.map_or(String::new(), |meant| format!("; {meant}"));
    format!("sahnede `{name}` adında giriş yok; girişleri: {names}{meant}")
}

pub(in crate::wording) fn character_not_taken(c: char) -> String {
    format!("{c} (U+{:04X}) burada geçersiz", u32::from(c))
}

pub(in crate::wording) fn value_in(name: &str, units: &str) -> String {
    match units {
        "" => name.to_owned(),
        units => format!("{name} [{units}]"),
    }
}

pub(in crate::wording) fn import_unknown_attribute(name: &str, count: usize) -> String {
    match count {
        1 => format!("`{name}` niteliği bilinmiyor; alınmadı"),
        count => format!("{count} öğedeki `{name}` niteliği bilinmiyor; alınmadı"),
    }
}

pub(in crate::wording) fn import_packed(version: &str) -> String {
    let of_version = match version {
        "" => String::new(),
        version => format!(", sürüm {version}"),
    };
    format!(
        "bu PMKS+ adresi paketlenmiş{of_version}; krank yalnızca `j=` ve `l=` içeren adresleri okur; \
         mafsalları PMKS satırları olarak yazın"
    )
}

pub(in crate::wording) fn plays_in(turns: bool, seconds: &dyn Display, backwards: bool) -> String {
    let sweep = if turns { "tur" } else { "geçiş" };
    format!(
        "1 {sweep} {seconds} s{}",
        if backwards { ", geri" } else { "" }
    )
}

pub(in crate::wording) fn plays_period_in(seconds: &dyn Display, backwards: bool) -> String {
    format!(
        "hareket {seconds} s{}",
        if backwards { ", geri" } else { "" }
    )
}

pub(in crate::wording) fn all_of(names: &[&str]) -> String {
    names.join(" ve ")
}

pub(in crate::wording) fn places_of(places: &[String], unit: &str) -> String {
    format!("{} {unit}", places.join(" ve "))
}

pub(in crate::wording) fn does_not_repeat(
    numbers: &[String],
    from: &str,
    to: &str,
    unit: &str,
) -> String {
    let numbers = numbers.join(" ve ");
    format!(
        "{numbers} numaralı yükün `over` değeri yinelenmiyor: bu, {from} ile {to} {unit} arasındaki döngü"
    )
}

pub(in crate::wording) fn body_called(name: &str) -> String {
    // No link may have this name.
    match name {
        "ground" => "şase".to_owned(),
        name => name.to_owned(),
    }
}

pub(in crate::wording) fn condition_called(word: &str) -> String {
    match word {
        "ok" => "tamam".to_owned(),
        "dead-point" => "ölü konum".to_owned(),
        "change-point" => "değişim konumu".to_owned(),
        "no-assembly" => "kurulamaz".to_owned(),
        word => word.to_owned(),
    }
}

pub(in crate::wording) fn translated_scene_text(text: &str) -> String {
    presets::said(text).to_owned()
}

pub(in crate::wording) fn dyad_by_two_sums(
    point: &str,
    first: &str,
    sums: [&str; 2],
    second: &str,
) -> String {
    let [one, other] = sums;
    format!(
        "F, {first} uzvuna {point} mafsalında etki eden kuvvettir; {second} uzvuna -F etki eder, \
             pimdeki yük de onunladır. Dış tepkileri içermeyen iki toplam: {first} için {one}, {second} \
             için {other}."
    )
}

pub(in crate::wording) fn not_valid_toml(message: &str) -> String {
    format!("geçerli TOML değil: {}", syntax::translate_message(message))
}

pub(in crate::wording) fn edits_not_kept(folder: &dyn Display, why: &dyn Display) -> String {
    let why = parser::of_system(why);
    format!("değişiklikler kurtarma için saklanmıyor: {folder}: {why}")
}

pub(in crate::wording) fn cells_left_out(cells: &[(u64, &str, String)], more: usize) -> String {
    let cell =
        |(line, column, cell): &(u64, &str, String)| format!("{line}. satır, {column}: {cell}");
    let mut text: Vec<String> = cells.iter().map(cell).collect();
    if more > 0 {
        text.push(format!("ve {more} tane daha"));
    }
    format!(
        "Sayı olmadığı için dışarıda bırakıldı: {}.",
        text.join("; ")
    )
}

pub(in crate::wording) fn points_wanted(count: usize, closed: bool) -> String {
    let form = if closed { "kapalı bir yol" } else { "bir yol" };
    format!("{count} noktadan geçen {form}")
}

pub(in crate::wording) fn candidates_found(
    good: usize,
    told: usize,
    defective: usize,
    complete: bool,
    reason: &str,
) -> String {
    let maximum = match good > told {
        true => format!(", en iyi {told} tanesi aşağıda"),
        false => String::new(),
    };
    let others = match defective {
        0 => String::new(),
        count => format!("; kusurlu {count} mekanizma daha"),
    };
    let proof = match (complete, reason) {
        (true, "") => "; başkası yok".into(),
        (true, reason) => format!("; başkası yok: {reason}"),
        (false, "") => "; aramayla bulundu, başkaları olabilir".into(),
        (false, reason) => format!("; {reason}"),
    };
    format!("görev için {good} mekanizma{maximum}{others}{proof}")
}

pub(in crate::wording) fn transmission_as_written(way: &str, whole: &str) -> String {
    match way == whole {
        true => format!("Bağlama açısı görevde de başka yerde de en az {way} derecedir."),
        false => format!(
            "Bağlama açısı görevde en az {way} derecedir; `krank check` ve hedeflerdeki gibi bütün \
             harekette {whole} derece."
        ),
    }
}

pub(in crate::wording) fn good_and_defective(good: usize, defective: usize) -> String {
    match defective {
        0 => format!("{good} bulundu"),
        _ => format!("{good} bulundu, {defective} kusurlu"),
    }
}

pub(in crate::wording) fn nothing_does_the_task(reason: &str) -> String {
    match reason {
        "" => "görevi yapan bir mekanizma bulunamadı".into(),
        reason => format!("görevi yapan bir mekanizma bulunamadı: {reason}"),
    }
}

pub(in crate::wording) fn tour_of_the_crank_text(keys: &[String; 10]) -> String {
    let [
        step,
        step_back,
        play,
        smaller,
        larger,
        slower,
        faster,
        reverse,
        go_to,
        opening,
    ] = keys;
    format!(
        "{step} ve {step_back} adım atar: şimdi deneyin. {play} tur bitince oynatır.\n\
         {smaller} ve {larger} adımı, {slower} ve {faster} hızı, {reverse} yönü değiştirir. \
         {go_to} yazdığınız yere, {opening} açılışa gider."
    )
}

pub(in crate::wording) fn tour_of_figures_text(views: &[String; 9]) -> String {
    let [
        motion,
        tables,
        plots,
        accuracy,
        forces,
        working,
        motor,
        lengths,
        polygons,
    ] = views;
    format!(
        "{tables} tablo, {plots} grafik, {forces} kuvvet, {working} çözüm, {motor} motor, {polygons} poligon, \
         {motion} yine hareket.\nDeğerlerin, olabildiğinde, kanıtlı hata sınırı vardır: ötesindeki haneler soluk ya da \
         noktadır. - değer yok demektir. {accuracy} yöntemleri, {lengths} boyların etkisini gösterir."
    )
}

pub(in crate::wording) fn layout_is(name: &str) -> String {
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
}
