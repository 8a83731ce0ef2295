//! The working of the forces: free bodies, pins and the driver.

use super::Turkish;
use crate::wording::english::ReactionsWords;

catalogue! {
    impl ReactionsWords for Turkish {
        forces_part = "Kuvvetler";
        reactions_need_not_exist =
            "Bu konumda tepkiler olmayabilir; tahrikin torku sanal işten bulunur.";
        reactions_open(links: &str) =
            "Mekanizma statikçe belirsizdir: denge tek başına şu uzuvların tepkilerini belirlemez: {links}.";
        order_of_groups(groups: &str) =
            "Tepkiler, aşağıdaki uzuvların hareket denklemlerindeki bilinmeyenlerdir. Gruplar sondan başlayarak \
             çözülür, çünkü her grup yükünü kendinden öncekilere iletir: {groups}. En son tahrik gelir.";
        dyad_by_two_sums(point: &str, first: &str, sums: [&str; 2], second: &str) = {
            let [one, other] = sums;
            format!("F, {first} uzvuna {point} mafsalında etki eden kuvvettir; {second} uzvuna -F etki eder, \
                     pimdeki yük de onunladır. Dış tepkileri içermeyen iki toplam: {first} için {one}, {second} \
                     için {other}.")
        };
        one_sum(sum: &str, reaction: &str) = "Tek bir toplam {reaction} içermez: {sum}.";
        reaction_at(point: &str) = "{point} noktasındaki tepki";
        reaction_of_guide(slide: &str) = "{slide} kılavuzunun kuvveti";
        vector_is(letter: char, vector: &str) = "{letter}: {vector}.";
        arm_from_to(from: &str, to: &str) =
            "{from} noktasından {to} noktasına kol, m olarak; x ve y {from} noktasından ölçülür";
        unit_vector_along(at: &str) = "{at} deg yönünde birim vektör";
        moments_about(point: &str) = "{point} noktasına göre momentler";
        forces_along_guide(slide: &str, at: &str) = "{slide} kılavuzu boyunca, {at} deg yönünde kuvvetler";
        moment_about(point: &str) = "{point} noktasına göre";
        force_along = "boyunca";
        known_on(link: &str) = "{link} üstünde bilinen";
        so_that = "İki toplam da 0'dır:";
        part_at(part: &str, link: &str, point: &str) = "{part}, {link}, {point}";
        across(name: &str) = "{name}, dik";
        along(name: &str) = "{name}, boyunca";
        moment_of(name: &str) = "{name}, moment";
        reactions_at_once(unknowns: usize) =
            "{unknowns} bilinmeyen için bütün uzuvların denklemleri; aşağıdaki yüklü pimlerin dengesi de bunların \
             içindedir:";
        reactions_too_many(links: usize) =
            "{links} uzvun tepkileri birlikte çözülür: yazılamayacak kadar çok denklem.";
        sought_reaction = "bilinmeyen";
        what_it_is = "ne olduğu";
        sums_of_link(link: &str, about: &str) =
            "{link} uzvunun toplamları: x ve y boyunca kuvvetler, {about} noktasına göre N m olarak momentler, \
             kollar m:";
        solved_one_by_one = "Tek bilinmeyeni kalan bir toplam onu verir; değer öteki toplamlarda yerine konur:";
        others_at_once(names: &str) = "Öteki bilinmeyenler bağlaşıktır ve birlikte çözülür: {names}.";
        sum_on(what: &str, link: &str) = "{what} toplamı, {link}";
        no_balance_at_dead_point =
            "Ölü konumda mekanik kazanç sonsuzdur: tahrikin hiçbir torku yükleri dengelemez, tepkiler \
             yoktur.";
        no_forces_without_assembly = "Mekanizma kurulamadıkça kuvvet de yoktur.";
        no_forces_here = "Burada kuvvetler yoktur.";
        loads_here = "Buradaki yükler:";

        // Loads.
        kind_press = "pres";
        kind_spring = "yay";
        acts_at(what: &str, point: &str) = "{what}, {point} noktasında";
        acts_on(what: &str, link: &str) = "{what}, {link} uzvunda";
        spring_between(from: &str, to: &str) = "L: {from} - {to}";
        pull_of_spring = "Bir yayın çekmesi, boylar m olarak:";
        pull_of_gas_spring = "Gazlı yay, L boyuna göre verilen p kuvvetiyle iter:";
        push_by_line = "(L1, p1) ile (L2, p2) düğümleri arasında doğrusal ara değer:";
        push_beyond_knots = "Düğümlerin ötesinde kuvvet en yakın düğümdekidir:";
        torque_of_torsion_spring(link: &str) =
            "Burulma yayı {link} uzvuna etkir; θ, serbest açısı θ0'dan ölçülen açıdır:";
        distance_of_press(slide: &str) = "Pres, strokunun {slide} değerinin r0 olduğu ucundan d uzaklığındadır:";
        press_by_line = "p kuvveti, (d1, p1) ile (d2, p2) düğümleri arasında doğrusal ara değerdir:";
        press_opens = "Kızak açılıyor, bu yüzden baskı kuvveti yok.";
        press_has_not_begun(reach: &str) = "Baskı ancak strokun son {reach} içinde etkir, henüz kuvvet yok.";
        pull = "çekme";
        factor = "çarpan";
        weight = "ağırlık";
        weight_of(link: &str) = "{link} ağırlığı";
        inertia_of(link: &str) = "{link} ataleti";
        column_of = "kaynağı";
        column_formula = "formül";
        column_load = "yük";
        symbols_of(symbols: &str, link: &str) = "{symbols}, {link} için";

        // A free body.
        link_part(name: &str) = "Uzuv {name}";
        on_it = "ona etki eden";
        motion_about(point: &str) =
            "x ve y {point} noktasından ölçülür, momentler ona göredir. Hareket denklemleri:";
        motion_about_accelerated(point: &str) =
            "x ve y {point} noktasından, momentler ona göre. {point} noktasının ivmesi \u{e000}m/s^2 olarak \
             hareket denklemleri:";
        guide_of(slide: &str) = "{slide} kılavuzu";
        slider_of(slide: &str) = "{slide} kayan parçası";
        pin_by(link: &str, point: &str, by: &str) = "{link}, {point}: {by} tarafından";
        pin_by_ground(link: &str, point: &str) = "{link}, {point}: şase tarafından";

        // A pin.
        pin_part(name: &str) = "Pim {name}";
        load_at_pin = "Pimdeki yük, kütlesi olmayan pime etki eder; uzuvlar onu oradaki kuvvetleriyle dengeler:";
        forces_along(axis: &str, point: &str) = "{point} noktasında {axis} doğrultusundaki kuvvetler";

        // The driver.
        torque_of_driver = "Tahrikin torku";
        force_of_driver = "Tahrikin kuvveti";
        torque_checked_by_work(torque: &str) =
            "Tahrikin {torque} olan torku uzuvların dengesinden bulunur. Sağlama olarak yüklerin, yerçekiminin ve \
             ataletin sanal işi aynısını vermelidir. Her pay, kuvvetlerinin ters işaretli gücünün tahrikin hızına \
             bölümüdür.";
        force_checked_by_work(force: &str) =
            "Tahrikin {force} olan kuvveti uzuvların dengesinden bulunur. Sağlama olarak yüklerin, yerçekiminin ve \
             ataletin sanal işi aynısını vermelidir. Her pay, kuvvetlerinin ters işaretli gücünün tahrikin hızına \
             bölümüdür.";
        effort_by_work =
            "Yüklerin, yerçekiminin ve ataletin sanal işinden. Her pay, kuvvetlerinin ters işaretli gücünün \
             tahrikin hızına bölümüdür.";
        frame_feels(x: &str, y: &str, moment: &str) =
            "Şase x boyunca {x} N, y boyunca {y} N ve başlangıç noktasına göre {moment} N m moment taşır. Güç \
             dengesinin ve bütünün dengesinin artıkları, her biri bağımsız hesaplanmıştır:";
        virtual_work = "sanal iş";
        forces_in(axis: &str) = "kuvvetler, {axis}";
        moments = "momentler";
    }
}
