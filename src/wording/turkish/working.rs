//! The working: loops, positions and rates, step by step.

use super::Turkish;
use crate::wording::english::WorkingWords;
use std::fmt::Display;

catalogue! {
    impl WorkingWords for Turkish {
        // How it begins.
        driver_turns(state: &str, driver: &str, at: &str, speed: &str, acceleration: &str) =
            "Durum: {state}. Tahrik {driver} döner: {at} konumunda, hızı {speed}, ivmesi {acceleration}.";
        driver_slides(state: &str, driver: &str, at: &str, speed: &str, acceleration: &str) =
            "Durum: {state}. Tahrik {driver} kayar: {at} konumunda, hızı {speed}, ivmesi {acceleration}.";
        inputs_are_given = "Öteki girişler tahriki izler: koordinatları, onunki gibi verilidir.";
        inputs_have_tables(names: &str) =
            "Sahnedeki tablosuna, kübik bir spline'a göre {names} burada:";
        forces_of_inputs_in_tables =
            "İşi birkaç giriş paylaştığında kuvvetler adım adım yazılmaz: kuvvet tablosunda dururlar.";
        dead_point_explained =
            "Ölü konum: hareket burada biter. Konumlar vardır; hızlar ve ivmeler yoktur, çünkü \
             denklemleri 0 olan bir sinüse bölünürdü.";
        change_point_explained =
            "Değişim konumu: burada iki montaj biçimi buluşur. Hız ve ivme denklemleri bu tek yerde \
             tekildir; verilen hızlar ve ivmeler hareket boyunca limitlerdir.";
        no_assembly_explained(covered: &str) =
            "Mekanizma burada kurulamaz: tahrikin aralığı {covered}. Aşağıdakiler sahnenin ve tahrikin \
             verdikleridir.";

        // Vector polygons and the position table.
        vector_polygons = "Vektörel poligonlar";
        loop_is(number: usize, what: &str) = "Döngü {number}: {what}";
        solved_by_group(walk: &str, group: usize) = "{walk} (grup {group})";
        tells_further_vector(walk: &str) = "{walk} (başka bir vektörü verir)";
        no_closed_loop = "Kapalı döngü yok: her şeyi tek başına tahrik yerleştirir.";
        vector_on(vector: &str, tail: &str, head: &str, body: &str) =
            "{vector}: {tail} - {head}, {body} üzerinde";
        the_ground = "şase";
        beside_vectors_of_scene(vectors: &str) = "Sahnedekilere ek vektörler: {vectors}.";
        in_no_loop(vectors: &str) = "Hiçbir döngüde olmayan: {vectors}.";
        position_table = "Konum tablosu";
        column_ends = "uçlar";
        column_is(symbol: &str) = "{symbol} nedir";
        is_sought = "bilinmeyen";
        vectors_by_coordinates =
            "Bir uzvun noktaları arasındaki vektörler, noktaların uzvun kendi takımındaki yerlerinden:";

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
            "{arm} bir yana yalnız bırakılır, iki bileşenin kareleri toplanırsa {lost} düşer; yalnız {kept} ile:";

        // Positions.
        positions_by_groups = "Konumlar, grup grup";
        the_vector(names: &str) = "Vektör {names}";
        group_in_words(number: usize, kind: &str) = "Grup {number}, {kind}";
        group_of_one_link(number: usize, kind: &str, link: &str) = "Grup {number}, {kind}: uzuv {link}";
        group_of_many_links(number: usize, kind: &str, links: &str) =
            "Grup {number}, {kind}: uzuvlar {links}";
        coupled_of_unknowns(count: usize) = "{count} bilinmeyenli bağlı grup";
        not_without_groups_before = "Önceki grupların konumları olmadan bulunamaz.";
        loop_repeats_others = "Döngüsü başkalarını yineler: içinde bilinmeyen yok.";
        nothing_sought = "Bilinmeyen yok.";
        driver_places = "Tahrikin yerleştirdikleri:";

        // Two arms.
        with_m_between(m: &str, from: &str, to: &str, joint: &str) =
            "{m}: {from} noktasından {to} noktasına; iki kolun buluştuğu mafsal {joint}:";
        lies_to_the_left(joint: &str, from: &str, to: &str) =
            "Montaj biçimine göre {joint}, {from} → {to} doğrusunun solundadır:";
        lies_to_the_right(joint: &str, from: &str, to: &str) =
            "Montaj biçimine göre {joint}, {from} → {to} doğrusunun sağındadır:";
        lies_on_the_line(joint: &str, from: &str, to: &str) =
            "{joint}, {from} → {to} doğrusunun üzerindedir: iki montaj biçimi birdir:";
        pivots_coincide(one: &str, other: &str) =
            "{one} ve {other} üst üste: üçgen yok, açılar hareket boyunca limitlerdir:";
        arms_too_short(m: &str, one: &str, other: &str, sum: &str) =
            "{m}, {one} + {other} = {sum} toplamından uzun: kollar birbirine erişmez.";
        arms_too_unlike(m: &str, one: &str, other: &str, difference: &str) =
            "{m}, |{one} - {other}| = {difference} farkından kısa: kollar üçgeni kapatamaz.";
        triangle_would_close =
            "Bu üçgen kapanırdı, ama sahnenin montaj biçiminden başlayan hareket buraya gelmez.";

        // Guides.
        quadratic_in(arm: &str, sum: &str, name: &str) =
            "K bilinen kenarların toplamı olunca döngüden {arm} = |{sum}|; karesi {name} için ikinci \
             derece denklemdir.";
        either_or(one: &str, other: &str) = "{one} ya da {other}";
        by_the_assembly = "Montaj biçimine göre:";
        angle_of_minus(what: &str) = "-({what}) açısı";
        others_turn_with(name: &str, along: &str, left: &str) =
            "{name} ile dönen öteki kenarlar onun boyunca t = {along}, soluna e = {left} uzanır:";
        does_not_reach_guide(arm: &str) = "Eksi çıkar: {arm} kılavuza erişmez.";
        root_would_close =
            "Kapanırdı, ama sahnenin montaj biçiminden başlayan hareket buraya gelmez.";

        // Coupled groups.
        solved_at_once = "Kurulabildiği yerde Newton yöntemiyle bir kerede çözülür.";
        no_part_alone =
            "Hiçbir parçası tek başına çözülemez: bütün denklemler f(z) = 0 bir kerede Newton \
             yöntemiyle çözülür, z - dz, J dz = f, J ise f'nin z'ye göre türevleridir. Durduğu yer:";
        equations_left = "Denklemler ve onlardan artan:";
        jacobian_too_large(n: usize) = "J matrisinin {n} x {n} öğesi var, onu kimse okumaz.";
        jacobian_rows =
            "J, her denklem için bir satır; bir öğenin birimi satırınınki bölü sütununkidir:";
        sides_by_joints = "Mafsallardan, aralarındaki vektörlerin bilinmeyenleri:";
        joint = "mafsal";
        two_ways(coordinate: &str, point: &str) = "{point}, {coordinate}, iki yoldan";
        distance_from_guide(point: &str) = "{point} noktasının kılavuzdan uzaklığı";
        found_together = "Birlikte bulunan:";

        // Rates.
        velocities_part = "Hızlar";
        accelerations_part = "İvmeler";
        differentiated = "Zamana göre türevi alınmış konum denklemleri, hız denklemleri:";
        differentiated_again = "Bir kez daha türev, ivme denklemleri:";
        rates_are_limits =
            "Denklemler burada tekildir; değerler hareket boyunca limitlerdir.";
        no_rates_at_dead_point =
            "Ölü konumda yoktur. Burada hiçbir şeyin çözmediği denklemler:";
        do_not_exist_either = "Onlar da yoktur.";
        none_without_assembly = "Mekanizma kurulamadıkça yoktur. Denklemler:";
        nothing_sought_in_it = "İçinde bilinmeyen yok.";
        factor_vanishes(symbol: &str) =
            "{symbol} çarpanı sıfır olur; hareket boyunca limit:";
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
        lies_on(base: &str) = "{base} üzerindedir, onun gibi hareket eder.";
        does_not_turn(link: &str, base: &str) =
            "{link} dönmez: her yeri {base} gibi hareket eder.";
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
            "Bir uzvun ani dönme merkezi, o anda şaseye göre duran yeridir: başka her noktasında \
             v = |ω| çarpı merkeze uzaklık. Kennedy teoremine göre üç uzvun üç merkezi bir doğru \
             üzerindedir.";
        common_centres(joints: &str) =
            "Mafsalla bağlı iki uzvun ortak merkezi mafsaldır: {joints}.";
        centre_of_link(centre: &str, link: &str) = "{link} uzvunun {centre} merkezi";
        on_two_lines(centre: &str, one: &str, other: &str) =
            "{centre} iki doğrunun kesişimidir: {one}, β açısında, ve {other}, γ açısında:";
        line_through(one: &str, other: &str) = "{one} ve {other} noktalarından geçen doğru";
        line_across(joint: &str) = "{joint} noktasından geçip yoluna dik olan doğru";
        centre_by_velocity(centre: &str, point: &str, omega: &str) =
            "{centre} noktasında açıkça kesişen iki doğru bilinmiyor; {point} noktasının hızı ve {omega} ile:";
        centre_of_guided(link: &str, direction: &str) =
            "{link} dönmez: merkezi sonsuzdadır, hızına dik, {direction} deg ve ters yönünde.";
        centre_far(link: &str, direction: &str) =
            "Basamakların gösterdiği kadarıyla {link} bu anda dönmüyor: merkezi sonsuzdadır, hızına \
             dik, {direction} deg ve ters yönünde.";
        link_is_at_rest(link: &str) = "{link} bu anda duruyor: her yeri merkezdir.";
        centre_is_blurred(link: &str, digits: usize) =
            "{link} neredeyse dönmüyor, merkezi çok uzakta: {digits} basamağı söylenebilir:";
        at_infinity = "sonsuzda";

        // The check.
        check_part = "Sağlama";
        nothing_to_check = "Mekanizma kurulamadıkça sağlanacak bir şey yok.";
        figures_do_not_differ =
            "Yukarıda hesaplanan değerlerle çözücününkiler arasında fark yok.";
        figures_differ(part: &str, symbol: &str) =
            "Yukarıda hesaplanan değerlerle çözücününkiler arasındaki fark, büyüklüklerinin en çok \
             {part} katı ({symbol}).";
        left_of_loops = "Bütün sayılar yerindeyken konum denklemlerinden artan:";
        loop_component(number: usize, axis: &dyn Display) = "döngü {number} {axis}";
    }
}
