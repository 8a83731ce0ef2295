//! The working: loops, positions and rates, step by step.

use super::Turkish;
use crate::wording::english::WorkingWords;
use std::fmt::Display;

catalogue! {
    impl WorkingWords for Turkish {
        // The beginning.
        driver_turns(state: &str, driver: &str, at: &str, speed: &str, acceleration: &str) =
            "Durum: {state}. Tahrik {driver} döner: {at} konumunda, hızı {speed}, ivmesi {acceleration}.";
        driver_slides(state: &str, driver: &str, at: &str, speed: &str, acceleration: &str) =
            "Durum: {state}. Tahrik {driver} kayar: {at} konumunda, hızı {speed}, ivmesi {acceleration}.";
        inputs_are_given = "Öteki girişler tahriki izler: koordinatları, onunki gibi verilmiştir.";
        inputs_have_tables(names: &str) = "Sahnedeki tablosunun kübik spline'ından {names} burada:";
        forces_of_inputs_in_tables = "Birden çok girişle kuvvetler burada türetilmez: kuvvet tablosuna bakın.";
        dead_point_explained =
            "Ölü konum: hareket burada biter. Konumlar vardır; hızlar ve ivmeler yoktur, çünkü denklemleri 0 olan \
             bir sinüse bölünür.";
        change_point_explained =
            "Değişim konumu: burada iki montaj biçimi buluşur. Hız ve ivme denklemleri bu konumda tekildir; \
             verilen hızlar ve ivmeler hareket boyunca limitlerdir.";
        no_assembly_explained(covered: &str) =
            "Mekanizma burada kurulamaz: tahrikin aralığı {covered}. Aşağıdakiler yalnız sahnenin ve tahrikin \
             değerlerini kullanır.";

        // Vector polygons and the position table.
        vector_polygons = "Vektörel poligonlar";
        loop_is(number: usize, what: &str) = "Döngü {number}: {what}";
        solved_by_group(walk: &str, group: usize) = "{walk} (grup {group})";
        tells_further_vector(walk: &str) = "{walk} (başka bir vektörü verir)";
        no_closed_loop = "Kapalı döngü yok: bütün konumları tek başına tahrik belirler.";
        vector_on(vector: &str, tail: &str, head: &str, body: &str) =
            "{vector}: {tail} - {head}, {body} üzerinde";
        the_ground = "şase";
        beside_vectors_of_scene(vectors: &str) = "Sahnedekilere ek vektörler: {vectors}.";
        in_no_loop(vectors: &str) = "Hiçbir döngüde olmayan: {vectors}.";
        position_table = "Konum tablosu";
        column_ends = "uçlar";
        column_is(symbol: &str) = "{symbol} değeri";
        is_sought = "bilinmeyen";
        vectors_by_coordinates =
            "Bir uzvun noktaları arasındaki vektörler, noktaların uzvun eksen takımındaki koordinatlarından:";

        // Loop equations.
        loop_equations = "Vektörel konum denklemleri";
        multiplied_by(vector: &str, removed: &str) =
            "{vector} ile çarpılır, {removed} gider:";
        multiplied_across(vector: &str, side: &str) =
            "{side} kenarına dik {vector} ile çarpılır, {side} gider:";
        collected_by(one: &str, other: &str) =
            "{one} ve {other} ile çarpılır, açılıp düzenlenirse bilinmeyenlerin önünde yalnız sayılar kalır:";
        collected_with_letters = "Açılıp düzenlenirse bilinmeyenlerin önünde yalnız sayılar kalır:";
        collected_with_numbers = "Sayılarıyla:";
        collected_equation(number: usize) = "{number}. döngünün düzenlenmiş denklemleri";
        squared_and_added(arm: &str, lost: &str, kept: &str) =
            "{arm} bir yanda yalnız bırakılır, iki bileşenin kareleri toplanırsa {lost} yok olur, {kept} kalır:";

        // Positions.
        positions_by_groups = "Konumlar, grup grup";
        the_vector(names: &str) = "Vektör {names}";
        group_in_words(number: usize, kind: &str) = "Grup {number}, {kind}";
        group_of_one_link(number: usize, kind: &str, link: &str) = "Grup {number}, {kind}: uzuv {link}";
        group_of_many_links(number: usize, kind: &str, links: &str) =
            "Grup {number}, {kind}: uzuvlar {links}";
        coupled_of_unknowns(count: usize) = "{count} bilinmeyenli bağlaşık grup";
        not_without_groups_before = "Önce önceki grupların konumları gerekir.";
        loop_repeats_others = "Döngüsü başkalarını yineler: bilinmeyeni yok.";
        nothing_sought = "Bilinmeyen yok.";
        driver_places = "Tahrikin belirledikleri:";

        // Two arms.
        with_m_between(m: &str, from: &str, to: &str, joint: &str) =
            "{m}: {from} noktasından {to} noktasına; iki kolun buluştuğu mafsal {joint}:";
        lies_to_the_left(joint: &str, from: &str, to: &str) =
            "{joint}, bu montaj biçiminde {from} → {to} doğrusunun solundadır:";
        lies_to_the_right(joint: &str, from: &str, to: &str) =
            "{joint}, bu montaj biçiminde {from} → {to} doğrusunun sağındadır:";
        lies_on_the_line(joint: &str, from: &str, to: &str) =
            "{joint}, {from} → {to} doğrusunun üzerindedir: iki montaj biçimi çakışır:";
        pivots_coincide(one: &str, other: &str) =
            "{one} ve {other} çakışır: üçgen yoktur, açılar hareket boyunca limitlerdir:";
        arms_too_short(m: &str, one: &str, other: &str, sum: &str) =
            "{m}, {one} + {other} = {sum} toplamından uzun: kollar birbirine erişmez.";
        arms_too_unlike(m: &str, one: &str, other: &str, difference: &str) =
            "{m}, |{one} - {other}| = {difference} farkından kısa: kollar üçgeni kapatamaz.";
        triangle_would_close =
            "Bu üçgen kapanır, ama sahnenin montaj biçiminden başlayan hareket bu konuma ulaşmaz.";

        // Guides.
        quadratic_in(arm: &str, sum: &str, name: &str) =
            "K bilinen kenarların toplamı olmak üzere döngü {arm} = |{sum}| gerektirir; karesi {name} için ikinci \
             derece denklemdir.";
        either_or(one: &str, other: &str) = "{one} ya da {other}";
        by_the_assembly = "Bu montaj biçiminde:";
        angle_of_minus(what: &str) = "-({what}) açısı";
        others_turn_with(name: &str, along: &str, left: &str) =
            "{name} ile dönen öteki kenarlar onun boyunca t = {along}, soluna e = {left} uzanır:";
        does_not_reach_guide(arm: &str) = "Negatif çıkar: {arm} kılavuza erişmez.";
        root_would_close = "Döngü kapanır, ama sahnenin montaj biçiminden başlayan hareket bu konuma ulaşmaz.";

        // Coupled groups.
        solved_at_once = "Kurulabildiği yerde bütün olarak Newton yöntemiyle çözülür.";
        no_part_alone =
            "Hiçbir parçası tek başına çözülemez: bütün denklemler f(z) = 0 birlikte Newton yöntemiyle çözülür, z \
             - dz, J dz = f, J ise f'nin z'ye göre türevleridir. Son durum:";
        equations_left = "Denklemler ve artıkları:";
        jacobian_too_large(n: usize) = "J matrisinin {n} x {n} ögesi var, yazılamayacak kadar çok.";
        jacobian_rows = "J, her denklem için bir satır; bir ögenin birimi satırınınki bölü sütununkidir:";
        sides_by_joints = "Mafsallar arasındaki vektörlerin bilinmeyenleri:";
        joint = "mafsal";
        two_ways(coordinate: &str, point: &str) = "{point}, {coordinate}, iki yoldan";
        distance_from_guide(point: &str) = "{point} noktasının kılavuzdan uzaklığı";
        found_together = "Birlikte bulunan:";

        // Rates.
        velocities_part = "Hızlar";
        accelerations_part = "İvmeler";
        differentiated = "Vektörel konum denklemlerinin zamana göre türevi, hız denklemleri:";
        differentiated_again = "Bir kez daha türev, ivme denklemleri:";
        rates_are_limits =
            "Denklemler burada tekildir; değerler hareket boyunca limitlerdir.";
        no_rates_at_dead_point = "Ölü konumda yoktur. Burada çözümü olmayan denklemler:";
        do_not_exist_either = "Onlar da burada yoktur.";
        none_without_assembly = "Mekanizma kurulamadığı için yoktur. Denklemler:";
        nothing_sought_in_it = "İçinde bilinmeyen yok.";
        factor_vanishes(symbol: &str) = "{symbol} katsayısı 0'dır; hareket boyunca limit:";
        equations_for_unknowns(equations: usize, unknowns: usize) =
            "{unknowns} bilinmeyen için {equations} denklem; birlikte çözülür:";
        sliding = "kayma";
        turning = "dönme";
        speeds_up = "hızlanma";
        slows_down = "yavaşlama";

        // Points.
        points_part = "Noktalar";
        rates_of_points_missing = "Hızları ve ivmeleri burada yoktur.";
        a_point = "bir nokta";
        point_on_about(point: &str, link: &str, base: &str) = "{point}, {link} üzerinde, {base} çevresinde";
        lies_on(base: &str) = "{base} ile çakışır, onunla hareket eder.";
        does_not_turn(link: &str, base: &str) = "{link} dönmez: her noktası {base} gibi hareket eder.";
        at_degrees(figure: &str, direction: &str) = "{figure}, yatayla {direction} deg";
        between_normal_part(angle: &str, symbol: &str) =
            "{angle} deg, {symbol} ile merkezcil bileşeni arasında";
        along_guide_of(point: &str, slide: &str, body: &str) =
            "{point}, {slide} kılavuzu boyunca, {body} üzerinde";
        of_under(symbol: &str, body: &str, point: &str) = "{symbol}, {body} üzerinde, {point} altında";

        // Instant centres.
        instant_centres = "Ani dönme merkezleri";
        instant_centre = "ani dönme merkezi";
        instant_centre_is =
            "Bir uzvun ani dönme merkezi, uzvun o anda şaseye göre hareketsiz noktasıdır. Öteki her noktada v, |ω| \
             ile merkeze uzaklığın çarpımıdır. Kennedy teoremine göre üç uzvun üç merkezi bir doğru üzerindedir.";
        common_centres(joints: &str) =
            "Mafsalla bağlı iki uzvun ortak merkezi mafsaldır: {joints}.";
        centre_of_link(centre: &str, link: &str) = "{link} uzvunun {centre} merkezi";
        on_two_lines(centre: &str, one: &str, other: &str) =
            "{centre} iki doğrunun kesişimidir: {one}, β açısında, ve {other}, γ açısında:";
        line_through(one: &str, other: &str) = "{one} ve {other} noktalarından geçen doğru";
        line_across(joint: &str) = "{joint} noktasından geçip yoluna dik olan doğru";
        centre_by_velocity(centre: &str, point: &str, omega: &str) =
            "{centre} noktasında belirgin kesişen iki bilinen doğru yok; {point} noktasının hızından ve {omega} \
             ile:";
        centre_of_guided(link: &str, direction: &str) =
            "{link} dönmez: merkezi sonsuzdadır, hızına dik, {direction} deg ve ters yönünde.";
        centre_far(link: &str, direction: &str) =
            "Hanelerin hassasiyetine göre {link} bu anda dönmüyor: merkezi sonsuzdadır, hızına dik, {direction} deg \
             ve ters yönünde.";
        link_is_at_rest(link: &str) = "{link} bu anda hareketsiz: her noktası merkezdir.";
        centre_is_blurred(link: &str, digits: usize) =
            "{link} neredeyse dönmüyor, merkezi çok uzakta: {digits} hanesi biliniyor:";
        at_infinity = "sonsuzda";

        // The check.
        check_part = "Sağlama";
        nothing_to_check = "Mekanizma kurulamadığı için sağlanacak bir şey yok.";
        figures_do_not_differ = "Yukarıdaki değerlerle çözücününkiler arasında fark yok.";
        figures_differ(part: &str, symbol: &str) =
            "Yukarıdaki değerlerle çözücününkiler arasındaki fark, büyüklüklerinin en çok {part} katı ({symbol}).";
        left_of_loops = "Bütün sayılar yerine konunca vektörel konum denklemlerinin artıkları:";
        loop_component(number: usize, axis: &dyn Display) = "döngü {number} {axis}";
    }
}
