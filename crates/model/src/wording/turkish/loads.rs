//! Errors of the loads, springs, motor and redundant constraints of a scene.

use super::Turkish;
use crate::wording::english::ActingWords;

catalogue! {
    impl ActingWords for Turkish {
        // Names.
        the_load = "yük";
        the_spring = "yay";
        the_motor = "motor";
        a_load = "yük";
        a_spring = "yay";
        figure_called(name: &str) = "değer {name}";
        scene_too_large(most: usize) =
            "dosya çok büyük: bir sahne en çok {most} bayt (1 MiB) olabilir";

        example_of_list(list: &str, one: &str, other: &str) = "{list} altında {one} ve {other}";

        // Loads.
        must_be_list_of_tables(key: &str) = "`{key}` tablolardan bir liste olmalı";
        load_has_both(one: &str, other: &str) = "yükte hem `{one}` hem `{other}` var";
        one_load = "bir yük";
        a_second_load = "ikinci bir yük";
        each_a_load_of_its_own = "her biri için ayrı bir [[loads]] yazın";
        load_has_no_target(size: &str, on: &str) = "yükte `{size}` var, `{on}` yok";
        acts_on_what(size: &str) = "`{size}` nereye uygulanıyor?";
        kinds_of_loads =
            "yük, bir noktada kuvvet, bir uzuvda tork ya da bir kızakta prestir";
        over_without_size = "yükte `over` var, ama `force` ya da `torque` yok";
        factors_of_what = "çarpılacak bir şey yok";
        over_scales =
            "`over` bir `force` ya da `torque` değerini çarpar: tam değeri oraya, çarpanları buraya yazın";
        load_has_no_size = "yükte ne `force`, ne `torque`, ne `press` var";
        no_load_here = "bu yük boş";
        kind_has_no_key(kind: &str, key: &str) = "`{kind}` yükünde `{key}` olmaz";
        not_for_kind(kind: &str) = "`{kind}` için geçerli değil";
        no_frame_to_turn_with = "`frame` yalnız kuvvet için geçerlidir: torkun ve presin yönü yoktur";
        press_is_given_over_way =
            "presin kuvveti uzaklığa göre bir tabloyla verilir: press = [[12, 0], [0, 350e3]]";
        only_press_has_end = "`end` yalnız pres için geçerlidir";
        one_load_acts_on_one = "bir yükün tek hedefi olur: her hedef için ayrı bir [[loads]] yazın";
        keeps_direction_without_frame = "yönü sabit olan kuvvette `frame` yazmayın";

        // A press.
        least_or_greatest(name: &str) = "yükte `end`, `least` ya da `greatest` olmalı, {name} değil";
        is_no_end_of_stroke = "strokun ucu değil";
        which_ends_there_are =
            "`least` ve `greatest`, kılavuz boyunca konumun en küçük ve en büyük değeridir";
        press_on_moving_guide(slide: &str, link: &str) =
            "pres {slide} kızağına etki ediyor; kızağın kılavuzu hareketli {link} uzvunda";
        press_acts_on_this = "presin hedefi";
        press_needs_the_frame = "pres şaseye karşı etki eder: on = \"ground\" olan bir kızak yazın";
        springs_act_between = "iki uzuv arasındaki kuvvet için yay kullanın: [[springs]]";
        press_without_end(slide: &str) = "{slide} kızağındaki presin `end` değeri yok ve kılavuzu yatay";
        at_which_end = "`end` eksik";
        no_lower_end = "bu kılavuzun iki ucundan hiçbiri ötekinden aşağıda değil";
        least_is_where =
            "end = \"least\", kılavuz boyunca `through` noktasından ölçülen konumun en küçük değeridir";
        greatest_is_where = "end = \"greatest\", en büyük değeridir";

        // Knots.
        coordinate_and_factor = "[koordinat, çarpan]";
        distance_and_force = "[uzaklık, kuvvet]";
        knot_in(number: usize, what: &str) = "{number}. düğüm, {what}";
        a_list_of_knots(form: &str) = "düğüm listesi {form}";
        must_be_but_is_empty(what: &str, wanted: &str) = "{what} {wanted} olmalı, ama boş";
        no_knots = "düğüm yok";
        factor_never_changes(what: &str) = "{what}: tek düğüm var, çarpan hiç değişmez";
        two_knots_are_needed = "en az iki düğüm verin";
        put_factor_into_size = "sabit bir çarpanı doğrudan kuvvetin ya da torkun değerine katın";
        negative_distance(what: &str, literal: &str) = "{what}: uzaklık negatif olamaz, ama {literal}";
        distances_from_end = "uzaklıklar strokun ucundan ölçülür: 0 ucun kendisidir";
        negative_press(what: &str, literal: &str) = "{what}: kuvvet negatif olamaz, ama {literal}";
        press_is_against_motion =
            "pres her zaman harekete karşı etki eder; hareket yönündeki kuvvet için `force` kullanın";
        knots_must_grow(what: &str, first: &str, second: &str) =
            "{what}: koordinatlar düğümden düğüme artmalı, ama {first} değerinden sonra {second} geliyor";
        does_not_grow = "artmıyor";
        order_growing_knots = "düğümleri sıralayın; sıçramayı aynı koordinatta iki düğüm olarak yazın";
        knots_must_fall(what: &str, first: &str, second: &str) =
            "{what}: koordinatlar düğümden düğüme azalmalı, ama {first} değerinden sonra {second} geliyor";
        does_not_fall = "azalmıyor";
        order_falling_knots = "düğümleri sıralayın; sıçramayı aynı koordinatta iki düğüm olarak yazın";
        the_knot_before = "önceki düğüm";
        three_knots_at_one_place(what: &str, at: &str) = "{what}: {at} koordinatında üç düğüm var";
        a_third_knot_there = "üçüncü düğüm";
        a_jump_has_two_knots = "sıçramaya iki düğüm verin: önceki değer ve sonraki değer";
        length_and_force = "[boy, kuvvet]";
        negative_length(what: &str, literal: &str) = "{what}: boy negatif olamaz, ama {literal}";
        lengths_of_gas_spring = "gazlı yayın kuvvetini boyuna göre verin: force = [[200, 900], [300, 700]]";

        // Springs.
        spring_lacks_end(key: &str) = "yayda `{key}` yok";
        springs_have_two_ends = "yay iki nokta arasında etki eder";
        spring_has_no_size = "yayda ne `stiffness` ne `damping` var";
        does_nothing = "etkisi yok";
        give_spring_a_size = "birini verin, örneğin stiffness = 1200 (N/m) ya da damping = 5 (N s/m)";
        give_torsion_spring_a_size =
            "birini verin, örneğin stiffness = 12 (N m/rad) ya da damping = 0.5 (N m s/rad)";
        spring_kind_has_no_key(kind: &str, key: &str) = "yay türü {kind} ise `{key}` olmaz";
        a_plain_spring = "noktalar arası yay";
        a_gas_spring = "gazlı yay";
        a_torsion_spring = "burulma yayı";
        rule_of_springs =
            "yay şu kuvvetle çeker: preload + stiffness * (uzaklık - length) + damping * hız";
        rule_of_gas_springs =
            "gazlı yay, boyuna göre verilen `force` ile iter; bundan başka yalnız `damping` yazılabilir";
        rule_of_torsion_springs =
            "burulma yayı `link` ile `to` ya da şase arasında etki eder; anahtarlar: stiffness, angle, preload, \
             damping";
        name_two_links = "iki farklı uzuv yazın";
        spring_to_itself(from: &str) = "yayın iki ucu da {from}";
        end_is_beginning = "başlangıçla aynı";
        begins_here = "başlangıç";
        name_two_points = "iki farklı nokta yazın";
        spring_on_one_body(body: &str) = "yayın iki ucu da {body} üzerinde";
        length_never_changes = "boyu hiç değişmez";
        springs_join_bodies = "birbirine göre hareket eden iki cismin noktalarını bağlayın";

        // The motor.
        motor_of_slide_has_no(key: &str) = "motorda `{key}` olamaz: tahrik bir kızak";
        motor_of_link_has_no(key: &str) = "motorda `{key}` olamaz: tahrik bir uzuv";
        does_not_fit_driver = "tahrike uymuyor";
        slide_has_force = "tahrik edilen kızak için kuvvet verin: force = 2000 (N)";
        link_has_torque = "tahrik edilen uzuv için tork verin: torque = 20 (N m)";
        slide_has_no_shaft = "tahrik edilen kızağın mili yoktur: bu anahtarı silin";
        leave_unknown_out(key: &str) = "`{key}` değerini işaretsiz verin, bilinmiyorsa silin";
        rest_of_motor_given_twice = "motorda hem `rest` hem de onun eski adı `tolerance` var";
        is_old_name_of_rest = "`rest` için eski ad";
        leave_old_name_of_rest_out = "`tolerance` anahtarını silin";
        peak_of_motor_too_small(rated: &str) = "motorda `peak`, `{rated}` değerinden küçük";
        is_too_small = "çok küçük";
        peak_is_for_short = "tepe değer kısa süre içindir ve en az sürekli değer kadardır";
        fluctuation_of_motor_too_large = "motorda `fluctuation` en çok 1 olabilir";
        fluctuation_of_motor_impossible =
            "motorda `fluctuation` 2'den büyük olamaz: 2 değerinde tahrik her döngüde bir kez durur";
        what_fluctuation_is = "hızın (en büyük - en küçük) / ortalama oranıdır: 0.02, %2 demektir";
        speed_of_motor_not_positive = "motorda `speed` pozitif olmalı";

        // Redundant constraints.
        misfit_too_large(unit: &str, most: f64, literal: &str) =
            "[redundant] içindeki `misfit` ({unit}) en uzun boyun en çok %1'i, burada {most} olabilir, ama \
             {literal}";
        misfit_is_for_digits =
            "yalnız çizimde yuvarlanmış boyutlar için kullanın, birbirine uymayan parçalar için değil";
    }
}
