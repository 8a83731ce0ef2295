//! Tasks: descriptions of desired motions.

use super::Turkish;
use crate::wording::english::TasksWords;

catalogue! {
    impl TasksWords for Turkish {
        the_task_itself = "görevin kendisi";
        task_for_a_scene = "bu bir görev, sahne değil";
        synthesize_does_tasks = "görev için mekanizmaları `krank synthesize` ile bulun: her biri bir sahne olur";
        scene_for_a_task = "bu bir sahne, görev değil";
        synthesize_reads_tasks =
            "görev istenen hareketi tanımlar (krank help synthesis); sahneleri `krank check` ve `krank DOSYA` açar";
        task_without_kind = "görevin `kind` anahtarı yok";
        these_are_known(words: &str) = "şunlardan birini kullanın: `{words}`";
        not_known_here = "bilinmiyor";
        no_kind_of_task(kind: &str) = "{kind} bir görev türü değil";
        key_of_another_kind(key: &str, kind: &str) = "`{key}` `{kind}` türünden bir göreve ait değil";
        belongs_to_another_kind = "başka bir görev türüne ait";
        no_form_of_linkage(form: &str) = "{form} desteklenen bir mekanizma değil";
        no_linkage_wanted = "`linkages` boş";
        item_of(number: usize, key: &str) = "`{key}` içinde {number}. öge";
        must_be_row(what: &str, form: &str, count: usize) = "{what} {form} olmalı, {count} ögeli bir liste değil";
        task_lacks(of: &str, key: &str) = "`{of}` için `{key}` eksik";
        told_twice(first: usize, again: usize) = "{again}. öge {first}. ögeyi yineliyor";
        the_same_again = "burada yinelendi";
        first_told_here = "ilk burada verildi";
        take_out_one_pose = "birini çıkarın: yinelenen bir konum yeni bir konum değildir";
        take_out_one_point = "birini çıkarın; yol ilk noktasına dönüyorsa `closed = true` yazın";
        count_of_poses(count: usize) = "konum görevinde 3 ile 5 arası konum olur, {count} değil";
        poses_that_methods_take =
            "üç konum çok serbestlik bırakır, dört konum çözüm eğrileri, beş konum birkaç mekanizma bırakır";
        too_much_given(poses: usize, given: usize) = "{poses} konumla {given} mesnet ya da pim verilemez";
        one_too_many = "bir fazla";
        what_poses_leave_free = "üç konumla en çok iki mesnet ve pim verin, daha çok konumla hiç vermeyin";
        take_out_last_point = "sonuncuyu çıkarın: `closed = true` ile yol ilk noktasına döner";
        slider_crank_has_one_pivot = "bir krank-biyelin şasede tek mesnedi vardır, krankın mesnedi";
        slider_cranks_alone = "yalnızca krank-biyel aranıyor";
        take_out_one_pivot = "tek mesnet verin ya da `linkages` listesine \"four-bar\" ekleyin";
        count_of_points(count: usize, maximum: usize) = "bir yolda 2 ile {maximum} arası nokta olur, {count} değil";
        more_than_two_pivots = "bir dört çubuk mekanizmasının iki mesnedi vardır";
        weights_are_positive = "her ağırlık 0 değerinden büyük olmalı";
        one_for_each_point(key: &str, points: usize, found: usize) = "`{key}` içinde {points} nokta için {found} sayı var";
        turns_begin_at_nought = "`turns` ilk noktadan sayılır: ilki 0 olmalı";
        turns_go_one_way = "`turns` noktadan noktaya hep artmalı ya da hep azalmalı";
        links_have_their_own_ends = "ucu aynı olan iki uzuv tek uzuvdur: iki ayrı nokta verin";
        turns_end_within_one =
            "kapalı bir yolda bütün `turns` bir turun içinde olmalı: son noktadan sonra ilk nokta gelir";
        direction_wants_order = "`order = false` ile `direction` çelişir: ikisinden birini çıkarın";
        one_output = "bir fonksiyonun tek çıkışı vardır: `linkages` içinde birini yazın";
        angle_below_90 = "0 ile 90 arasında (90 hariç)";
        at_least_1 = "en az 1";
        inside_is_a_box = "`inside` bir kutunun karşılıklı iki köşesi olmalı";
        no_turning_direction(name: &str) = "{name} bir dönme yönü değil";
        given_pivot_outside = "verilen bir mesnet, mesnetler için verilen kutunun dışında";
        outside_the_box = "`inside` dışında";
        widen_the_box = "`inside` kutusunu genişletin ya da ikisinden birini çıkarın";
        turns_against_direction = "`turns` ile `direction` ters yönlü: `turns` işaretini ya da tercihi değiştirin";
        crank_against_direction =
            "krankın `swing` ya da `scale` değeri (verilmezse saat yönünün tersi) ile `direction` ters yönlü: \
             işareti ya da tercihi değiştirin";
        pivot_of_function_outside(place: &str) =
            "fonksiyonun {place} noktasındaki mesnedi, mesnetler için verilen kutunun dışında";
        widen_for_function =
            "krankın mesnedi [0, 0] noktasında, dört çubukta öteki mesnet [size, 0] noktasındadır: `inside` \
             kutusunu genişletin ya da çıkarın";
        pairs_and_function = "çiftler hem `pairs` hem `function` ile verilmiş: birini çıkarın";
        positive_number = "pozitif bir sayı";
        count_of_pairs(count: usize, maximum: usize) = "bir fonksiyonda 3 ile {maximum} arası çift olur, {count} değil";
        pairs_not_in_order(number: usize) = "{number}. çiftin x değeri öncekininkinden büyük değil";
        not_further_on = "x artmıyor";
        pairs_by_growing_x = "çiftleri artan x sırasıyla yazın, her x bir kez";
        range_of_function(maximum: usize) = "`function` küçük bir x değerinden büyüğüne 3 ile {maximum} arası noktayla gitmeli";
        swing_and_scale = "`swing` ile `scale` aynı anlama gelir: birini verin";
        start_wants_scale = "`start` en küçük x değerine aittir: onunla bir `scale` ya da `swing` verin";
        scale_is_nought = "`scale` 0 olamaz";
        output_stands_still(y: &str) = "y her x değerinde {y}: çıkış hareket etmezdi";
        let_y_change =
            "y değerinin değiştiği bir fonksiyon ya da çiftler yazın; bekleme fonksiyonun ancak bir parçası olabilir";

        // Results of a task.
        wanted_motion = "istenen";
        poses_wanted(count: usize) = "{count} konumda bir cisim";
        pairs_wanted(count: usize) = "{count} çiftten geçen bir fonksiyon";
        points_wanted(count: usize, closed: bool) = {
            let form = if closed { "kapalı bir yol" } else { "bir yol" };
            format!("{count} noktadan geçen {form}")
        };
        candidates_found(good: usize, told: usize, defective: usize, complete: bool, reason: &str) = {
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
        };
        poses_out_of_range = "koordinatlar hesaplanamayacak kadar büyük ya da küçük: görevi başka bir birimle yazın";
        poses_turn_about(x: &str, y: &str) =
            "bütün konumlar tek bir noktanın, ({x}, {y}), çevresindeki dönmelerdir: cismi oradaki bir mesnet \
             yönlendirir, bir mekanizma değil";
        poses_only_shift =
            "cisim dönmüyor, yerleri de eşit uzuvların onu yönlendirebileceği bir çember üzerinde değil";
        given_leads_nowhere = "verilenlere bütün konumlarda uyan bir uzuv ya da kızak yok";
        no_pair_of_dyads = "bu konumlardan geçen uzuv ve kızakların hiçbir ikisi böyle bir mekanizma oluşturmuyor";
        dyads_out_of_reach = "bu konumlardan geçen uzuvlar ve kızaklar çok uzakta ya da boyları çok orantısız";
        poses_nearly_repeat =
            "bazı konumlar neredeyse çakışıyor: yuvarlama, başka mekanizma olup olmadığını açık bırakıyor";
        head_transmission = "bağlama";
        head_miss = "sapma";
        head_turns = "krank";
        head_lacks = "eksik tercih";
        turns_fully_shortly = "döner";
        swings_shortly = "salınır";
        defective_ones = "kusurlu";
        stands_in_dead_point = "ilk noktada açılamıyor: orası bir ölü konum";
        branch_between(from: usize, to: usize) = "dal: {from} ve {to} noktaları arasında bir ölü konum var";
        circuit_between(from: usize, to: usize) =
            "devre: {from} ve {to} noktaları ayrı devrelerde, arada mekanizmanın sökülüp takılması gerekir";
        order_between(from: usize, to: usize) = "sıra: krank {from} noktasından {to} noktasına geri dönüyor";
        short_of_range = "her çifte ulaşır, ama aralığın tümünde kapanmaz";
        misses_its_function = "yapısal hata: fonksiyondan sapması çıkışın salınımının onda birinden büyük (rms)";
        structural_error = "1 için yapısal hata";
        point_missed(point: usize) = "{point} noktasına ulaşmıyor";
        point_far_off(point: usize) = "uzak: {point} noktasının yanından yolun boyutunun % 5'inden daha uzakta geçer";
        candidate_called(task: &str, number: usize) = "{task}, aday {number}";
        candidate_made_by(task: &str) = "krank synthesize, görevden: {task}";
        driven_as_written(miss: &str, unit: &str) =
            "krank synthesize tarafından yazıldığı haliyle görevi boyunca sürüldü: en büyük sapması {miss} {unit}.";
        transmission_as_written(way: &str, whole: &str) = {
            match way == whole {
                true => format!("Bağlama açısı görevde de başka yerde de en az {way} derecedir."),
                false => format!(
                    "Bağlama açısı görevde en az {way} derecedir; `krank check` ve hedeflerdeki gibi bütün \
                     harekette {whole} derece."
                ),
            }
        };
        solved_with_goals(vary: &str) = "  krank solve SAHNE --vary {vary} \\";
        kept_by_goals = "Sayıları değiştirip görevi korumak için şu hedefleri kullanın:";

        // The list of results.
        linkages = "mekanizmalar";
        linkages_for(task: &str) = "{task} için mekanizmalar";
        good_and_defective(good: usize, defective: usize) = {
            match defective {
                0 => format!("{good} bulundu"),
                _ => format!("{good} bulundu, {defective} kusurlu"),
            }
        };
        looking_for_linkages(percent: u32) = "mekanizma aranıyor: %{percent}";
        at_point_of_task(point: usize, points: usize, crank: &str) =
            "nokta {point} / {points}, krank {crank} derecede";
        point_by_point = "noktadan noktaya";
        dyads_walked(dyad: usize, dyads: usize, curve: usize, curves: usize) =
            "Mesnet ve pim {dyad} / {dyads}, eğri {curve} / {curves}";
        pin_on_pivot(pivot: &str, pin: &str, link: &str, unit: &str) =
            "mesnet {pivot}, pim {pin}, uzuv {link} {unit}";
        pin_on_slide(angle: &str, pin: &str, unit: &str) = "kızak {angle} derecede, pim {pin} {unit}";
        dyad_picked(dyad: &str) = "öbürü: {dyad}";
        pick_the_second = "Enter seçer; ikisi bir mekanizma oluşturur.";
        dyads_make_nothing = "Bu ikisi bir mekanizma oluşturmuyor.";
        transmission_on_the_way(angle: &str) = "bağlama açısı {angle} derece";
        dotted_curves = "Noktalı: olabilecek mesnetler ve ilk konumda pimleri.";
        walk = "gez";
        next_curve = "sonraki eğri";
        curves_of_dyads = "eğriler";
        linkage_alone = "çizim";
        all_linkages = "liste";
        pick = "seç";
        put_into_list = "listeye koy";
        task_in_preview(wanted: &str) = "bir görev: {wanted}; Enter mekanizma arar";
        found_before = "önceden bulundu: Enter listeler";
        task_is_no_scene = "bu bir görev, sahne değil";

        // The command.
        search_was_stopped = "durduruldu: o ana kadarki sonuçlar aşağıda; bir Ctrl-C daha çıkar";
        does_synthesize = "Bir görev için mekanizmalar bulun: konumlar, bir fonksiyon ya da bir yol";
        task_to_do = "Bir görev dosyası, standart girdi için `-` ya da bir örnek: wiper, hatch, logarithm, straight-line, stirrer (krank help synthesis)";
        candidates_to_tell = "Listelenecek mekanizma sayısı, en iyisinden başlayarak";
        tolerance_of_candidates = "Her boyun toleransı, sahnelere yazılır";
        candidates_in_workbench =
            "Mekanizmaları tezgâhta görev boyunca hareket ederken gösterin, birini sahne olarak alın";
        folder_of_candidates = "Listelenen her mekanizmanın sahnesi için bir klasör";
        tolerance_is_no_length = "--tolerance en az 0 olan bir boy olmalı";
        nothing_does_the_task(reason: &str) = {
            match reason {
                "" => "görevi yapan bir mekanizma bulunamadı".into(),
                reason => format!("görevi yapan bir mekanizma bulunamadı: {reason}"),
            }
        };
        no_task_and_no_file(name: &str, meant: &str) =
            "`{name}` adlı bir görev ya da dosya yok; bulunanlar: {meant}";
        example_is_a_task(name: &str) = "bu bir görev: krank synthesize {name}";
        preset_is_no_task(name: &str) = "`{name}` hazır bir sahne, görev değil: krank {name} onu açar (krank help synthesis)";
        scene_would_be_lost(file: &str) =
            "`{file}` içinde başka bir şey var, kaybolurdu; başka bir klasöre yazın ya da onu başka yere taşıyın";
        candidates_written(count: usize, folder: &str) = "{folder} içinde {count} sahne";
        examples_of_synthesize = "\
Örnekler:
  krank synthesize wiper
  krank synthesize wiper --view
  krank synthesize straight-line --top 3 -o found
  krank synthesize task.toml --format json --seed 7
";
    }
}
