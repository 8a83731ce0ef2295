//! What a scene says of loads, springs, the motor and repeated constraints, where it cannot be so.

use super::Turkish;
use crate::wording::english::ActingWords;

catalogue! {
    impl ActingWords for Turkish {
        // What they are called.
        the_load = "yük";
        the_spring = "yay";
        the_motor = "motor";
        a_load = "yük";
        a_spring = "yay";
        figure_called(name: &str) = "büyüklük {name}";
        scene_too_large(most: usize) =
            "dosya çok büyük: bir sahne en çok {most} bayt (1 MiB) olabilir";

        example_of_list(list: &str, one: &str, other: &str) = "{list} altında {one} ve {other}";

        // Loads.
        must_be_list_of_tables(key: &str) = "`{key}` tablolardan bir liste olmalı";
        load_has_both(one: &str, other: &str) = "yükte hem `{one}` hem `{other}` var";
        one_load = "bir yük";
        a_second_load = "ikinci bir yük";
        each_a_load_of_its_own = "her birine ayrı bir [[loads]] ver";
        load_has_no_target(size: &str, on: &str) = "yükte `{size}` var, `{on}` yok";
        acts_on_what(size: &str) = "`{size}` neye etki ediyor?";
        kinds_of_loads =
            "yük, bir noktada kuvvet, bir uzuvda tork ya da bir kızakta prestir";
        over_without_size = "yükte `over` var, ama ne `force` ne `torque` var";
        factors_of_what = "neyin çarpanları?";
        over_scales =
            "`over` bir kuvveti ya da torku çarpar: büyüklüğünü ver, tam etki ettiği yere 1 yaz";
        load_has_no_size = "yükte ne `force`, ne `torque`, ne `press` var";
        no_load_here = "burada etki eden yok";
        kind_has_no_key(kind: &str, key: &str) = "yük: `{kind}` ile `{key}` olmaz";
        not_for_kind(kind: &str) = "`{kind}` için değil";
        no_frame_to_turn_with =
            "torkun ve presin bir uzuvla dönebilecek yönü yoktur";
        press_is_given_over_way =
            "presin kuvveti yolu boyunca verilir: press = [[12, 0], [0, 350e3]]";
        only_press_has_end = "strokun ucunda çalışan yalnız prestir";
        one_load_acts_on_one =
            "bir yük tek şeye etki eder: her birine ayrı bir [[loads]] ver";
        keeps_direction_without_frame = "yönünü koruyan kuvvete `frame` gerekmez";

        // A press.
        least_or_greatest(name: &str) =
            "`end` (yük) `least` ya da `greatest` olmalı, {name} değil";
        is_no_end_of_stroke = "strokun ucu değil";
        which_ends_there_are =
            "pres, kılavuz boyunca konumun en küçük ya da en büyük olduğu yerde çalışır";
        press_on_moving_guide(slide: &str, link: &str) =
            "{slide} kızağındaki pres: kılavuzu hareketli {link} uzvunda";
        press_acts_on_this = "pres buna etki ediyor";
        press_needs_the_frame =
            "pres şaseye karşı çalışır: on = \"ground\" olan bir kızak adlandır";
        springs_act_between =
            "iki uzuv arasında etki eden yaydır: [[springs]]";
        press_without_end(slide: &str) =
            "{slide} kızağındaki presin `end` değeri yok, kılavuz ise yatay";
        at_which_end = "hangi uçta çalışıyor?";
        no_lower_end = "bu kılavuzun iki ucu da ötekinden aşağıda değil";
        least_is_where =
            "end = \"least\", kılavuz boyunca `through` noktasından ölçülen konumun en küçük olduğu yerdir";
        greatest_is_where = "end = \"greatest\", en büyük olduğu yerdir";

        // Knots.
        coordinate_and_factor = "[koordinat, çarpan]";
        distance_and_force = "[uzaklık, kuvvet]";
        knot_in(number: usize, what: &str) = "{number}. düğüm, {what}";
        a_list_of_knots(form: &str) = "düğüm listesi {form}";
        must_be_but_is_empty(what: &str, wanted: &str) = "{what} {wanted} olmalı, oysa boş";
        no_knots = "düğüm yok";
        factor_never_changes(what: &str) = "{what}: tek düğüm var, çarpan hiç değişmez";
        two_knots_are_needed = "en az iki düğüm gerekir";
        put_factor_into_size = "sabit bir çarpanı kuvvetin ya da torkun kendisine kat";
        negative_distance(what: &str, literal: &str) =
            "{what}: uzaklık eksi olamaz, oysa {literal}";
        distances_from_end =
            "uzaklıklar strokun ucundan sayılır: 0 ucun kendisidir";
        negative_press(what: &str, literal: &str) =
            "{what}: kuvvet eksi olamaz, oysa {literal}";
        press_is_against_motion =
            "presin kuvveti harekete karşıdır; harekete yardım eden bir `force` olur";
        knots_must_grow(what: &str, first: &str, second: &str) =
            "{what}: koordinatlar düğümden düğüme büyümeli, oysa {first} ardından {second} geliyor";
        does_not_grow = "büyümüyor";
        order_growing_knots =
            "düğümleri sıraya koy; sıçrama, aynı koordinattaki iki düğümdür";
        knots_must_fall(what: &str, first: &str, second: &str) =
            "{what}: koordinatlar düğümden düğüme küçülmeli, oysa {first} ardından {second} geliyor";
        does_not_fall = "küçülmüyor";
        order_falling_knots =
            "düğümleri sıraya koy; sıçrama, aynı koordinattaki iki düğümdür";
        the_knot_before = "önceki düğüm";
        three_knots_at_one_place(what: &str, at: &str) = "{what}: {at} koordinatında üç düğüm var";
        a_third_knot_there = "orada üçüncü düğüm";
        a_jump_has_two_knots =
            "bir sıçramanın iki düğümü olur: öncesindeki değer ve oradan sonraki değer";
        length_and_force = "[boy, kuvvet]";
        negative_length(what: &str, literal: &str) =
            "{what}: bir boy negatif olamaz, oysa {literal}";
        lengths_of_gas_spring =
            "gazlı yayın kuvveti, uçlarının uzaklığına göre verilir: force = [[200, 900], [300, 700]]";

        // Springs.
        spring_lacks_end(key: &str) = "yayda `{key}` yok";
        springs_have_two_ends = "yay iki nokta arasında etki eder";
        spring_has_no_size = "yayda ne `stiffness` ne `damping` var";
        does_nothing = "bir şey yapmıyor";
        give_spring_a_size =
            "birini ver: stiffness = 1200 N/m, damping = 5 ise N s/m birimindedir";
        give_torsion_spring_a_size =
            "birini ver: stiffness = 12 N m/rad olarak, damping = 0.5 N m s/rad olarak";
        spring_kind_has_no_key(kind: &str, key: &str) = "yay: {kind} için `{key}` yoktur";
        a_plain_spring = "noktalar arası yay";
        a_gas_spring = "gazlı yay";
        a_torsion_spring = "burulma yayı";
        rule_of_springs =
            "yay şu kuvvetle çeker: preload + stiffness * (uzaklık - length) + damping * hız";
        rule_of_gas_springs =
            "gazlı yay, boyuna göre verilen `force` ile iter; yanına yalnız `damping` eklenebilir";
        rule_of_torsion_springs =
            "burulma yayı `link` uzvunu `to` uzvuna ya da şaseye karşı döndürür: stiffness, angle, preload, damping";
        name_two_links = "iki ayrı uzuv yaz";
        spring_to_itself(from: &str) = "yay {from} noktasından yine kendine gidiyor";
        end_is_beginning = "ucu ile başı aynı";
        begins_here = "burada başlıyor";
        name_two_points = "iki ayrı nokta adlandır";
        spring_on_one_body(body: &str) = "yayın iki ucu da {body} üzerinde";
        length_never_changes = "boyu hiç değişmez";
        springs_join_bodies =
            "yay, birbirine göre hareket eden iki cismin noktaları arasında etki eder";

        // The motor.
        motor_of_slide_has_no(key: &str) = "tahrik edilen kızaksa motorun `{key}` değeri olmaz";
        motor_of_link_has_no(key: &str) = "tahrik edilen uzuvsa motorun `{key}` değeri olmaz";
        does_not_fit_driver = "tahrike uymuyor";
        slide_has_force = "kızağı bir kuvvet sürer: force = 2000 (N)";
        link_has_torque = "uzvu bir tork sürer: torque = 20 (N m)";
        slide_has_no_shaft = "kızağın mili yoktur: çıkar";
        leave_unknown_out(key: &str) =
            "bilinmiyorsa `{key}` yazma; motorun verdiğinin işareti yoktur";
        rest_of_motor_given_twice =
            "motorda hem `rest` var hem `tolerance`; ikincisi birincinin eski adı";
        is_old_name_of_rest = "`rest` için eski ad";
        leave_old_name_of_rest_out = "`tolerance` anahtarını çıkarın";
        peak_of_motor_too_small(rated: &str) = "motorda `peak`, `{rated}` değerinden küçük";
        is_too_small = "çok küçük";
        peak_is_for_short =
            "tepe değer motorun kısa süre verdiğidir, en az sürekli verdiği kadardır";
        fluctuation_of_motor_too_large = "`fluctuation` (motor) en çok 1 olabilir";
        fluctuation_of_motor_impossible =
            "`fluctuation` (motor) 2 üstünde olanaksız: tahrik orada döngüde bir kez durur";
        what_fluctuation_is =
            "hızın (en büyük - en küçük) / ortalama oranıdır: 0.02, yüzde 2 demektir";
        speed_of_motor_not_positive = "`speed` (motor) artı olmalı";

        // Constraints that repeat others.
        misfit_too_large(unit: &str, most: f64, literal: &str) =
            "`misfit` ([redundant], {unit}) en uzun boyun yüzde birini, burada {most} değerini, aşamaz; \
             oysa {literal}";
        misfit_is_for_digits =
            "bir çizimin yazmadığı haneler içindir, birbirine uymayan parçalar için değil";
    }
}
