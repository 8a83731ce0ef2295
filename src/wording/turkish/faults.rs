//! Why a mechanism cannot be solved, and what would mend it.

use super::Turkish;
use crate::wording::english::FaultsWords;

catalogue! {
    impl FaultsWords for Turkish {
        // What parts are called.
        a_link(name: &str) = "uzuv {name}";
        slide_named(name: &str) = "kızak `{name}`";
        the_driver = "tahrik";
        origin_of(link: &str) = "başlangıç noktası ({link})";
        either(places: &[String]) = { places.join(" ya da ") };
        together(parts: &[String]) = { parts.join(" ve ") };

        // Mobility.
        mobility_of_none(inputs: usize) = "serbestlik derecesi {inputs} değil 0: hiçbir şey hareket edemez";
        mobility_of_few(mobility: usize, inputs: usize) =
            "serbestlik derecesi {inputs} değil {mobility}: hareket edebilecek olandan çok giriş var";
        mobility_elsewhere(inputs: usize) =
            "serbestlik derecesi {inputs}, ama tahrik tutulmuş, öteki uzuvlar onsuz hareket ediyor";
        mobility_of_many(mobility: usize, inputs: usize) =
            "serbestlik derecesi {inputs} değil {mobility}: tahrik her uzvu belirlemiyor";
        driven_here = "tahrik burada";
        floats(link: &str) = "{link} boşta";
        links_that_float(links: &str) = "boşta kalan uzuvlar: {links}";
        constraints_repeat(count: usize) = "{count} kısıt başkalarını yineliyor ve bir şey tutmuyor";
        among(what: &str, parts: &str) = "{what}; şunların arasında: {parts}";
        mobility_unclear =
            "bu kesin söylenemez: yalnız yuvarlama kadar farklı boyutlar, serbest görüneni tutardı";
        take_out_a_part = "bir uzvu ya da mafsalı çıkar: hareket etmesi gerekeni tutan bir tanesini";
        named_nowhere_else = "başka yerde adı geçmiyor";
        is_this_the_same = "bu aynısı mı?";
        give_it_one_name(point: &str, other: &str) =
            "{point} ve {other} aynı noktaysa ona tek ad ver";
        turn_a_guide = "paralel kılavuzlar kendi doğrultularında bir şey tutmaz: birini `angle` ile döndür";
        constraints_missing(count: usize) =
            "{count} kısıt eksik: boşta bir uzvu ortak bir noktayla başkasına bağla ya da kızak ekle";
        or_further_inputs(more: usize) =
            "ya da {more} tanesini de sür, tahrike bir oranla: `[inputs]`, `AD = {{ ratio = 1 }}`";
        are_dimensions_equal =
            "başkalarını yineleyen, başka yerde eksik olan olabilir: boyutları eşit mi olmalıydı?";

        // Constraints that do not fit.
        over_constrained(part: &str, misfit: &str) =
            "fazla kısıtlı: {part} varken hiçbir şey hareket edemez, ötekilerle uyuşmazlığı {misfit}";
        holds_what_is_held = "başkalarının tuttuğunu tutuyor, ama eşit ölçüde değil";
        found_at(coordinate: &str) = "tahrik şuradayken bulundu: {coordinate}";
        the_others_are(parts: &str) = "ötekiler: {parts}";
        correct_its_dimensions =
            "boyutlarını ötekilerle uyuşacak gibi düzelt ya da onu çıkar";
        accept_few_digits(lines: &str) = "ya da az haneli bir çizimin bıraktığını kabul et:\n{lines}";
        frame_does_not_fit(link: &str, misfit: &str, tail: &str, head: &str) =
            "fazla kısıtlı: {link} uzvu, sabit noktalar `{tail}` ve `{head}` arasına {misfit} farkla uymuyor";
        cannot_move = "hareket edemez";
        are_apart(tail: &str, head: &str, distance: &str) = "`{tail}` ile `{head}` arası {distance}";
        frame_needs_no_link(vector: &str) =
            "şasenin uzva gereği yok; tablolarda görmek için [vectors] bölümüne taşı: {vector}";
        frame_fits_with(length: &str) = "`length = {length}` ile uyar";

        // No assembly, or no one in particular.
        cannot_close(point: &str, gap: &str) =
            "mekanizma başlangıçta kapanmıyor: {point} erişim dışında, açıklık {gap}";
        cannot_be_placed(point: &str) = "{point} yerleştirilemiyor";
        has_to_reach_it(link: &str) = "{link} ona erişmeli";
        has_to_meet_it(link: &str) = "{link} onunla buluşmalı";
        driver_stands_at(coordinate: &str) = "tahrikin yeri {coordinate}";
        change_a_length =
            "bir boyu ya da sabit noktayı o kadar değiştir ya da sahneyi tahrikin başka bir konumunda aç";
        start_is_vague(point: &str, places: &str, unit: &str) =
            "başlangıç hangi montaj biçiminin istendiğini söylemiyor: {point} şuralarda olabilir: {places} {unit}";
        where_is(point: &str) = "{point} nerede?";
        start_is_between(point: &str, place: &str) =
            "[start] içinde {point} noktası {place}; birine de ötekine de aynı yakınlıkta";
        give_one_position(lines: &[String]) = {
            format!("kabaca bir konum ver, şunlardan biri:\n[start]\n{}", lines.join("   # ya da\n"))
        };
        open_as_well(points: &[String]) = { format!("; bunlar da açık: {}", points.join(", ")) };
        one_of_lines(lines: &[String]) = { lines.join("   # ya da ") };
        give_a_position_each(lines: &str) =
            "her biri için kabaca bir konum ver; başta yazılan, üstünde başta yazılanla gider:\n\
             [start]\n{lines}";
        opens_at_change_point(group: &str) =
            "sahne bir değişim konumunda açılıyor: {group} için iki montaj biçimi burada buluşuyor ve \
             ikisi de sürüyor";
        which_way = "hangi yoldan sürsün?";
        choose_the_side(one: &str, other: &str) = "ötesindeki tarafı seç: {one} ya da {other}";
        open_at_another(coordinate: &str) =
            "ya da sahneyi başka yerde, tahrikin başka bir `{coordinate}` değerinde aç";
        opens_beyond_stop(limit: &str, value: &str, low: &str, high: &str) =
            "sahne bir dayamanın ötesinde açılıyor: {limit} {value} değerinde, {low} ile {high} arasında kalmalı";
        opens_beyond_table(table: &str, value: &str, low: &str, high: &str) =
            "sahne {table} tablosunun bir şey söylemediği yerde açılıyor: tahrik {value} konumunda, tablo {low} ile {high} arasında";
        not_in_the_table = "tahrik bu tablonun dışında";
        open_within_table(coordinate: &str) =
            "sahneyi tahrikin tabloda bulunan bir `{coordinate}` değerinde aç ya da tabloyu oraya kadar uzat";
        held_by_stops(one: &str, other: &str) =
            "sahne iki dayamada açılıyor, hiçbir şey hareket edemez: {one} ve {other}";
        no_way_down = "tahrik geri gidemez";
        no_way_up = "tahrik ileri gidemez";
        is_passed_at_opening = "açılışta aşılmış";
        open_between_stops(coordinate: &str) =
            "sahneyi tahrikin başka bir `{coordinate}` değerinde aç, başka bir montaj biçimi seç ya da dayamayı kaydır";
        names_no_choice(group: &str) =
            "{group}: başka türlü kurulabilecek böyle bir grup yok";
        has_one_assembly(group: &str) = "{group} grubunun burada tek montaj biçimi var";
        has_assemblies(group: &str, count: usize) =
            "{group} grubunun burada {count} montaj biçimi var, 1 ile {count} arası numaralı";
        picked_here = "burada seçilmiş";
        no_assembly_near(points: &str, gap: &str) =
            "başlangıcın yakınında montaj biçimi bulunamadı: {points} yerlerinden en az {gap} uzak";
        solved_together = "birlikte çözülür";
        with_this = "bununla";
        at_this_position = "tahrikin bu konumunda";
        bring_start_nearer =
            "[start] konumlarını bir montaj biçimine yaklaştır ya da boyları gözden geçir";
        give_positions(lines: &str) = "kaba konumlar ver ya da boyları gözden geçir:\n[start]\n{lines}";

        // Singular places.
        opens_singular(parts: &str) =
            "sahne, {parts} ile konumun belirlenmediği yerde açılıyor: bir değişim ya da ölü konumda";
        never_determine(parts: &str) =
            "{parts}: tahrik nerede olursa olsun konumu belirlemez";
        leave_a_motion_free = "bunlar birlikte bir hareketi serbest bırakıyor";
        open_elsewhere_in_motion =
            "sahneyi başka yerde, tahrikin başka bir `angle` ya da `position` değerinde aç";
        join_in_another_way = "bunu hiçbir boyut düzeltmez: bu parçaları başka türlü bağla";

        // What stands before each part of a message.
        level_error = "hata";
        level_warning = "uyarı";
        level_note = "not";
        level_help = "yardım";
    }
}
