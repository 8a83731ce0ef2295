//! Reasons why a mechanism cannot be solved, and fixes.

use super::Turkish;
use crate::wording::english::FaultsWords;

catalogue! {
    impl FaultsWords for Turkish {
        // Names of parts.
        a_link(name: &str) = "uzuv {name}";
        slide_named(name: &str) = "kızak `{name}`";
        the_driver = "tahrik";
        origin_of(link: &str) = "başlangıç noktası ({link})";
        either(places: &[String]) = { places.join(" ya da ") };
        together(parts: &[String]) = { parts.join(" ve ") };

        // Mobility.
        mobility_of_none(inputs: usize) = "serbestlik derecesi {inputs} değil 0: hiçbir şey hareket edemez";
        mobility_of_few(mobility: usize, inputs: usize) =
            "serbestlik derecesi {inputs} değil {mobility}: giriş sayısı serbestlik derecesinden çok";
        mobility_elsewhere(inputs: usize) =
            "serbestlik derecesi {inputs}, ama tahrik hareket edemiyor, öteki uzuvlar onsuz hareket ediyor";
        mobility_of_many(mobility: usize, inputs: usize) =
            "serbestlik derecesi {inputs} değil {mobility}: tahrik bütün uzuvları belirlemiyor";
        driven_here = "tahrik burada";
        floats(link: &str) = "{link} tam bağlı değil";
        links_that_float(links: &str) = "tam bağlı olmayan uzuvlar: {links}";
        constraints_repeat(count: usize) = "{count} kısıt fazla: başkalarını yineliyor";
        among(what: &str, parts: &str) = "{what}; şunların arasında: {parts}";
        mobility_unclear =
            "bu kesin değil: boyutlarda yalnız yuvarlama kadar bir fark, serbest görüneni bağlardı";
        take_out_a_part = "harekete engel olan bir uzvu ya da mafsalı çıkarın";
        named_nowhere_else = "yalnız burada kullanılıyor";
        is_this_the_same = "aynı nokta mı?";
        give_it_one_name(point: &str, other: &str) = "{point} ve {other} aynı noktaysa tek ad kullanın";
        turn_a_guide =
            "paralel kılavuzlar kendi doğrultularındaki hareketi engellemez: birinin `angle` değerini \
             değiştirin";
        constraints_missing(count: usize) =
            "{count} kısıt eksik: serbest bir uzvu ortak bir noktayla başka bir uzva bağlayın ya da bir kızak \
             ekleyin";
        or_further_inputs(more: usize) =
            "ya da {more} tanesini de tahrike bir oranla sürün: `[inputs]`, `AD = {{ ratio = 1 }}`";
        are_dimensions_equal =
            "fazla kısıt, eksik olan kısıt olabilir: boyutlarının eşit olması gerekip gerekmediğini denetleyin";

        // Constraints that do not fit.
        over_constrained(part: &str, misfit: &str) =
            "fazla kısıtlı: {part} varken hiçbir şey hareket edemez; ötekilerden farkı {misfit}";
        holds_what_is_held = "başka kısıtları yineler, ama farklı değerlerle";
        found_at(coordinate: &str) = "tahrik {coordinate} konumundayken bulundu";
        the_others_are(parts: &str) = "ötekiler: {parts}";
        correct_its_dimensions = "boyutlarını ötekilerle uyuşacak biçimde düzeltin ya da onu çıkarın";
        accept_few_digits(lines: &str) =
            "ya da çizimdeki yuvarlamayı kabul edin:\n\
             {lines}";
        frame_does_not_fit(link: &str, misfit: &str, tail: &str, head: &str) =
            "fazla kısıtlı: {link} uzvu sabit noktalar `{tail}` ve `{head}` arasına uymuyor, fark {misfit}";
        cannot_move = "hareket edemez";
        are_apart(tail: &str, head: &str, distance: &str) = "`{tail}` ile `{head}` arası {distance}";
        frame_needs_no_link(vector: &str) =
            "ya da silin: şase için uzuv gerekmez; tablolarda göstermek için [vectors] bölümüne taşıyın: \
             {vector}";
        frame_fits_with(length: &str) = "`length = {length}` ile uyar";

        // No assembly, or more than one.
        cannot_close(point: &str, gap: &str) =
            "mekanizma başlangıçta kurulamıyor: {point} erişim dışında, açıklık {gap}";
        cannot_be_placed(point: &str) = "{point} yerleştirilemiyor";
        has_to_reach_it(link: &str) = "{link} ona erişmeli";
        has_to_meet_it(link: &str) = "{link} onunla birleşmeli";
        driver_stands_at(coordinate: &str) = "tahrikin konumu {coordinate}";
        change_a_length =
            "bir boyu ya da sabit noktayı bu kadar değiştirin ya da sahneyi tahrikin başka bir konumunda açın";
        start_is_vague(point: &str, places: &str, unit: &str) =
            "başlangıç birden çok montaj biçimine uyuyor: {point} şuralarda olabilir: {places} {unit}";
        where_is(point: &str) = "{point} nerede?";
        start_is_between(point: &str, place: &str) =
            "[start] içinde {point} noktası {place}; ikisine de eşit uzaklıkta";
        give_one_position(lines: &[String]) = {
            format!("yaklaşık bir konum verin, şunlardan biri:\n[start]\n{}", lines.join("   # ya da\n"))
        };
        open_as_well(points: &[String]) = { format!("; bunlar da açık: {}", points.join(", ")) };
        one_of_lines(lines: &[String]) = { lines.join("   # ya da ") };
        give_a_position_each(lines: &str) =
            "her biri için yaklaşık bir konum verin; ilk seçenekler birlikte geçerlidir, ötekiler de öyle:\n\
             [start]\n\
             {lines}";
        opens_at_change_point(group: &str) =
            "sahne bir değişim konumunda açılıyor: {group} için iki montaj biçimi orada birleşiyor ve ikisi de \
             sürüyor";
        which_way = "devamı belirsiz";
        choose_the_side(one: &str, other: &str) = "sonraki montaj biçimini {one} ya da {other} ile seçin";
        open_at_another(coordinate: &str) = "ya da sahneyi tahrikin başka bir `{coordinate}` değerinde açın";
        opens_beyond_stop(limit: &str, value: &str, low: &str, high: &str) =
            "sahne bir dayamanın ötesinde açılıyor: {limit} {value}, ama {low} ile {high} arasında olmalı";
        opens_beyond_table(table: &str, value: &str, low: &str, high: &str) =
            "sahne {table} tablosunun dışında açılıyor: tahrik {value} konumunda, ama tablo {low} ile {high} \
             arasını kapsıyor";
        not_in_the_table = "tahrik bu tablonun dışında";
        open_within_table(coordinate: &str) =
            "tahrik için tablo içinde bir `{coordinate}` seçin ya da tabloyu uzatın";
        held_by_stops(one: &str, other: &str) =
            "sahne iki dayamada açılıyor, hiçbir şey hareket edemez: {one} ve {other} dayamaları";
        no_way_down = "tahrik geri gidemez";
        no_way_up = "tahrik ileri gidemez";
        is_passed_at_opening = "açılışta aşılmış";
        open_between_stops(coordinate: &str) =
            "sahneyi tahrikin başka bir `{coordinate}` değerinde açın, başka bir montaj biçimi seçin ya da \
             dayamayı kaydırın";
        names_no_choice(group: &str) = "{group}, montaj biçimi seçilebilen bir grup değil";
        has_one_assembly(group: &str) = "{group} grubunun burada tek montaj biçimi var";
        has_assemblies(group: &str, count: usize) =
            "{group} grubunun burada {count} montaj biçimi var: 1 ile {count} arasında bir sayı seçin";
        picked_here = "burada seçilmiş";
        no_assembly_near(points: &str, gap: &str) =
            "başlangıcın yakınında montaj biçimi bulunamadı: {points} yerlerinden en az {gap} uzakta";
        solved_together = "birlikte çözülür";
        with_this = "bununla";
        at_this_position = "tahrikin bu konumunda";
        bring_start_nearer = "[start] konumlarını bir montaj biçimine yaklaştırın ya da boyları denetleyin";
        give_positions(lines: &str) =
            "yaklaşık konumlar verin ya da boyları denetleyin:\n\
             [start]\n\
             {lines}";

        // Singular positions.
        opens_singular(parts: &str) =
            "sahne bir değişim ya da ölü konumda açılıyor: {parts} orada konumu belirlemiyor";
        never_determine(parts: &str) = "{parts}: tahrik nerede olursa olsun bir konum belirlemiyor";
        leave_a_motion_free = "bunlar birlikte serbest bir harekete izin veriyor";
        open_elsewhere_in_motion = "sahneyi tahrikin başka bir `angle` ya da `position` değerinde açın";
        join_in_another_way = "bu hiçbir boyutla düzelmez: bu parçaları başka biçimde bağlayın";

        // Prefixes of the parts of a message.
        level_error = "hata";
        level_warning = "uyarı";
        level_note = "not";
        level_help = "yardım";
    }
}
