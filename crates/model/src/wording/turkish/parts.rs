//! Errors in single parts of a scene: links, slides, points, vectors.

use super::{Turkish, presets};
use crate::wording::english::PartsWords;
use std::fmt::LowerExp;

catalogue! {
    impl PartsWords for Turkish {
        // Names of parts.
        link_called(name: &str) = "uzuv {name}";
        slide_called(name: &str) = "kızak {name}";
        vector_called(name: &str) = "vektör {name}";
        the_ground_as_body = "şase";
        point_in(of: &str) = "{of}: nokta";
        ground_point = "sabit nokta";
        mark = "işaret";
        start_of = "başlangıç";
        tail_of(what: &str) = "kuyruğu ({what})";
        head_of(what: &str) = "ucu ({what})";
        the_scene_itself = "sahne";
        body_called(name: &str) = {
            // No link may have this name.
            match name {
                "ground" => "şase".to_owned(),
                name => name.to_owned(),
            }
        };
        condition_called(word: &str) = {
            match word {
                "ok" => "tamam".to_owned(),
                "dead-point" => "ölü konum".to_owned(),
                "change-point" => "değişim konumu".to_owned(),
                "no-assembly" => "kurulamaz".to_owned(),
                word => word.to_owned(),
            }
        };
        translated_scene_text(text: &str) = { presets::said(text).to_owned() };
        add_for_example(text: &str) = "örneğin şunu ekleyin:\n{text}";

        // The scene.
        no_unit_of_length(name: &str) = "{name} bir boy birimi değil";
        unknown_unit = "bilinmeyen birim";
        known_units(names: &str) = "bilinen birimler: {names}";
        no_links = "sahnede uzuv yok: hiçbir şey hareket etmiyor";
        links_above_most(count: usize, most: usize) =
            "sahnede {count} uzuv var; en çok {most} olabilir";
        are_too_many_links = "çok fazla uzuv";
        no_driver = "sahnede tahrik yok: hiçbir şey dönmüyor";
        none_is_driven = "bunların hiçbiri tahrik edilmiyor";

        // Links.
        link_has_no_points(of: &str) = "{of}: noktası yok";
        needs_ends_or_points = "bir uzva iki uç ya da `points` gerekir";
        or_single_joint(example: &str) = "ya da tek mafsallı bir uzuv için: {example}";
        of_has(of: &str, what: &str) = "{of}: {what}";
        ends_without_length = "`from` ve `to` var, `length` yok";
        only_from = "`from` var, `to` yok";
        only_to = "`to` var, `from` yok";
        length_without_ends = "`length` var, `from` ve `to` yok";
        ends_and_length = "`from`, `to` ve `length` birlikte verilir";
        points_alone(example: &str) =
            "doğal iki ucu olmayan bir uzuv yalnız `points` ile verilir: {example}";
        at_least_smallest = "en az 1e-300";
        too_small_to_compute = "hesaplamak için çok küçük";
        positive = "pozitif";
        no_direction = "boyu olmayan bir uzvun yönü yoktur";
        give_joints_one_name = "aynı yerdeki iki mafsal arasına uzuv gerekmez: onlara tek ad verin";
        is_not_positive = "pozitif değil";
        length_is_distance =
            "boy bir uzaklıktır; uzvun yönü `from` noktasından `to` noktasınadır";
        no_place_of_its_own = "uzaklığı 0 olan bir nokta, ölçüldüğü noktayla çakışır";
        leave_point_out = "onu çıkarın, ölçüldüğü noktayı kullanın; uzvun başlangıcındaysa [0, 0] yazın";
        turn_angle_by_half = "boy bir uzaklıktır: işaretsiz yazın, açıyı 180 döndürün";
        pinned_to_itself(link: &str, point: &str) =
            "{link} uzvu kendine bağlı: iki ucu da {point}";
        joins_two_points = "bir uzuv iki ayrı noktayı birleştirir";
        names_point_twice(link: &str, point: &str) = "{link} uzvunda {point} noktası iki kez var";
        ends_are_points = "uçları zaten [0, 0] ve [length, 0]; `points` öteki noktalardır";
        again_here = "yine burada";
        once_here = "ilki burada";
        out_of_proportion(link: &str, length: &dyn LowerExp, longest: &dyn LowerExp) =
            "{link} uzvu oransız: boyu {length:e}, oysa sahnenin en uzun boyu {longest:e}";
        less_than_part = "en uzunun 1e-75 katından kısa";
        look_for_mistyped =
            "ikisinin çarpımı bir double değerine sığmıyor; yanlış yazılmış bir koordinat, `com` ya da boy arayın";
        mass_without_centre(link: &str) = "{link} uzvunun kütlesi var, ağırlık merkezi yok";
        inertia_without_centre(link: &str) = "{link} uzvunun ataleti var, ağırlık merkezi yok";
        about_which_point = "hangi noktaya göre?";
        give_centre_at_middle(x: f64) =
            "merkezi uzvun kendi eksen takımında verin; boyun ortası: com = [{x}, 0]";
        give_centre = "merkezi uzvun kendi eksen takımında verin: örneğin com = [20, 10]";

        // Places by length and angle.
        or_by_length_and_angle(example: &str) = "ya da boy ve açı ile: {example}";
        seen_from_itself(what: &str) = "{what} kendisinden ölçülmüş";
        seen_in_a_circle = "kendisine geri döner";
        begin_with_an_end =
            "uzvun bir ucundan ya da koordinatları olan bir noktadan başlayın: from = \"A\"";
        name_another_point_of(body: &str) =
            "başka bir nokta verin ({body}) ya da `from` yazmayın: uzvun kendi eksen başlangıcı";

        or_by_two_distances(example: &str) = "ya da iki uzaklıkla: {example}";
        a_pair_of_names = "[birinci, ikinci] noktalar";
        a_pair_of_distances = "[birinci, ikinci] uzaklıklar";
        left_or_right = "`left` ya da `right`";
        which_side_is_left = "`from` içindeki ilk noktadan ikincisine bakıldığında; `side` yoksa sol yan";
        distances_do_not_meet(what: &str, apart: &str) =
            "{what}: iki uzaklık buluşmuyor: noktalarının arası {apart}";
        no_such_triangle = "kenarları bunlar olan üçgen yok";
        sides_of_a_triangle =
            "üçgenin her kenarı en çok öteki ikisinin toplamı kadardır; yanlış yazılmış bir boy arayın";

        // Links as drawn.
        drawn_link_has_key(of: &str, key: &str) =
            "{of}: `points` listesi olan uzuvda `{key}` kullanılmaz";
        drawn_driver_has_angle(link: &str) = "[driver]: çizildiği gibi verilen {link} için `angle` kullanılmaz";
        drawing_has_angle = "açıyı noktalarının koordinatları belirler";
        open_as_drawn = "silin; koordinatları değiştirin ya da başka bir konum için `--at` kullanın";
        ends_are_first_two = "listenin ilk iki noktası uzvun uçlarıdır";
        further_points_are_a_table(example: &str) =
            "onu çıkarın ya da öteki noktaları tablo olarak yazın: {example}";
        drawn_link_needs_two(of: &str) = "{of}: `points` listesine en az iki nokta gerekir";
        drawn_point_has_no_place(of: &str, name: &str) = "{of}: {name} noktasının koordinatı yok";
        neither_ground_nor_start = "ne [ground] ne [start] içinde";
        add_drawn_place(name: &str) =
            "liste, uzvun biçimini koordinatlardan alır: [start] bölümüne çizimdeki {name} = [x, y] değerini ekleyin";
        drawn_at_one_place(of: &str, from: &str, to: &str) = "{of}: {from} ile {to} aynı koordinatlarda";
        begin_with_two_places = "listeye ayrı yerlerdeki iki noktayla başlayın";
        name_each_point_once = "her noktayı bir kez yazın";

        // Copies.
        copy_called(name: &str) = "{name} kopyası";
        a_list_of_elements = "uzuv, kızak ya da noktaların listesi";
        copy_of_nothing(of: &str) = "{of}: `of` listesi boş";
        no_element_called(what: &str, name: &str) = "{what}: {name} adında uzuv, kızak ya da nokta yok";
        no_such_element = "böyle bir eleman yok";
        whole_number_up_to(most: usize) = "1 ile {most} arasında bir tam sayı";
        x_or_y = "`x` ya da `y`";
        mirrors_at_axis = "`x`, x eksenine göre yansıtır ve y'nin işaretini değiştirir; `y`, y eksenine göre yansıtır";
        turn_the_mirror_image = "başka bir eksen için `turn` ekleyin: eksenler arasındaki açının iki katı";
        a_ground_point_or_pair = "sabit bir nokta ya da `[x, y]`";
        about_nothing(of: &str) = "{of}: `about` için `mirror` ya da `turn` gerekir";
        neither_turns_nor_mirrors = "yansıtılan ya da döndürülen bir şey yok";
        copy_in_place(of: &str) = "{of}, aslının üzerinde";
        is_where_original_is = "aynı yer";
        place_the_copy = "`mirror`, `turn`, `move`, `phase` ya da `join` verin";
        joins_no_point(of: &str, name: &str) = "{of}: `join`, grubun noktası olmayan {name} yerine başka bir nokta koyuyor";
        not_in_the_group = "grubun noktası değil";
        phase_turns_nothing(of: &str) = "{of}: `phase` etkisiz";
        no_point_on_another_link = "grubun hiçbir noktası başka bir uzuvda değil";
        phase_is_for_cranks =
            "`phase`, grubun krank gibi başka uzuvlarda da bulunan noktalarını döndürür; `turn` bütün \
             kopyayı döndürür";
        phase_at_origin(of: &str, point: &str) = "{of}: `phase`, {point} noktasını döndüremez";
        turns_about_the_origin = "öteki uzvunun başlangıç noktası";
        begin_crank_at_pivot = "o uzvu mesnedinden başlatın: from = \"A\"";
        name_of_copy_is_taken(of: &str, original: &str, name: &str) =
            "{of}: {original} elemanının kopyası {name} olurdu; bu ad kullanılıyor";
        choose_another_suffix = "[copies] içinde başka bir anahtar seçin: kopyalar adlarını ondan alır";
        too_many_copies(of: &str, most: usize) = "{of}: toplam {most} taneden fazla kopya";
        too_many_copied(of: &str, most: usize) = "{of}: toplam {most} taneden fazla kopya eleman";
        copy_is_too_far(of: &str) = "{of}: koordinatları hesaplanamayacak kadar büyük";

        // Slides.
        of_has_no(of: &str, key: &str) = "{of}: `{key}` yok";
        is_missing(key: &str) = "`{key}` eksik";
        pin_or_link =
            "yarıktaki pim için `point = \"C\"`, dönmeden kayan uzuv için `link = \"r6\"` yazılır";
        pin_has_no_turn(of: &str) = "{of}: yarıktaki pimin `turn` değeri olmaz";
        for_slide_of_link = "yalnız kayan uzuv için";
        slide_the_link =
            "pim yarığında dönebilir; bir uzvun dönmemesi için uzvu kaydırın: link = \"...\"";
        has_point_and_link(of: &str) = "{of}: hem `point` hem `link` var";
        one_of_them_slides = "kayan bunlardan biridir";
        has_no_point_nor_link(of: &str) = "{of}: ne `point` ne `link` var";
        nothing_slides_here = "burada kayan bir şey yok";
        guide_in_the_frame = "şasedeki kılavuz için on = \"ground\"";
        must_be_point_of(what: &str, body: &str, name: &str) =
            "{what}: {body} üzerinde bir nokta olmalı, {name} değil";
        no_point_of(body: &str) = "{body} üzerinde bir nokta değil";
        name_point_of(body: &str) =
            "{body} üzerinde bir nokta adlandırın ya da onun eksen takımında koordinat verin: through = [0, 0]";
        cannot_slide_on_itself(body: &str) = "{body} kendi üzerinde kayamaz";
        origin_is_fixed(link: &str, body: &str) =
            "uzuv {link}, {body} üzerinde kayamaz: başlangıç noktası orada sabit";
        carried_by(point: &str, body: &str) = "{point}, onu taşıyan {body} üzerinde kayamaz";
        nothing_slides_on(body: &str) = "{body} üzerinde kayan yok";
        this_slides = "kayan bu";
        guide_is_fixed_to = "kılavuz buna sabit";
        guide_and_slider_differ = "kılavuz ve onun boyunca kayan ayrı cisimlerdir";

        // Driven parts.
        driven_link_is_given = "tahrik edilen uzuv `link` ve `angle` ile verilir";
        driven_slide_is_given = "tahrik edilen kızak `slide` ve `position` ile verilir";
        pinned_to_ground_twice(name: &str) =
            "tahrik edilen {name} uzvu dönemez: şaseye iki yerden bağlı";
        the_driven_link = "tahrik edilen uzuv";
        one_pin = "bir pim";
        another_pin = "ötekisi";
        turns_about_one_point = "tahrik edilen uzuv, çoğu zaman krank, şasenin tek noktası çevresinde döner";
        slide_has_its_guide(of: &str) = "{of}: kızak kendi kılavuzu boyunca sürülür, `from` geçerli değil";
        not_of_a_slide = "yalnız tahrik edilen bir uzuv için";
        seat_is_for_links = "bunu silin ya da kızağın yerine bir uzuv yazın: `from`, motoru taşıyan uzuvdur";
        turns_from_itself(name: &str) = "{name} kendisine göre tahrik edilemez";
        seat_is_another_link =
            "`from`, motoru taşıyan başka bir uzvun adıdır; yazılmazsa uzuv şaseye göre tahrik edilir";
        no_pivot(name: &str) = "tahrik edilen {name} uzvunun çevresinde döneceği sabit noktası yok";
        not_joined_to_ground = "şaseye bağlı değil";
        none_in_ground = "hiçbir noktası [ground] içinde değil";
        put_into_ground = "noktalarından birini [ground] bölümüne koyun: A = [0, 0]";
        or_name_its_seat(link: &str) = "ya da motorunu taşıyan uzvu yazın: from = \"{link}\"";
        links_with_ground_point(names: &str) = "sabit noktası olan uzuvlar: {names}";

        input_called(name: &str) = "giriş {name}";
        input_is_the_driver(name: &str) = "giriş {name}: {name} zaten tahrikin kendisi";
        driven_again = "yine tahrik ediliyor";
        the_driver_itself = "tahrik";
        inputs_follow_the_driver =
            "tahrik edilen öteki uzuvları ve kızakları [inputs] bölümüne yazın; her biri tahriki izler";

        // Stops.
        limit_called(name: &str) = "sınır {name}";
        low_end_of(what: &str) = "alt ucu ({what})";
        high_end_of(what: &str) = "üst ucu ({what})";
        ends_must_rise(what: &str, literal: &str) =
            "{what}: önce alt uç yazılmalı, {literal} değil";
        lower_end_first = "[low, high]";
        nothing_moves_between = "eşit iki uç arasında hiçbir şey hareket edemez";
        ends_the_other_way(ends: &str) = "şöyle yazın: {ends}";
        or_angle_of_link(example: &str) = "bir uzvun başka bir uzva göre açısı: {example}";
        limit_of_nothing(name: &str) = "sınır {name}: bu adda ne bir uzuv ne bir kızak var";
        neither_link_nor_slide = "ne uzuv ne kızak";
        angle_to_itself(what: &str, link: &str) = "{what}: {link} kendisinden ölçülmüş";
        always_zero = "her zaman 0 deg";
        limit_of_a_turn(what: &str) = "{what}: bir açının uçları arasında 360 deg değerinden az olmalı";
        is_too_wide = "çok geniş";
        driver_has_range =
            "daha çok dönebilenin sınırını kaldırın; tahrikin birkaç turluk bir `range` değeri olabilir";
        range_of_too_many_turns(what: &str, most: f64) = "{what} {most} deg değerinden dar olmalı";
        leave_range_out = "`range` değerini silin: serbestçe dönen bir tahrike gerekmez";

        // Points and vectors.
        start_of_ground_point(name: &str) = "[start]: {name} şasenin bir noktası";
        does_not_move = "hareket etmez";
        fixed_here = "burada sabit";
        start_is_for_moving = "[start] hareketli noktalar içindir: satırı çıkarın";
        runs_to_itself(what: &str, from: &str) = "{what}: {from} noktasından yine kendine gidiyor";
        head_is_tail = "kuyruğu ve ucu aynı";
        name_tail_and_head = "iki ayrı nokta adlandırın: [tail, head]";
        a_pair_of_points = "nokta [tail, head]";
        a_list_of_points = "nokta listesi";
        has_no_centre(what: &str, link: &str) = "{what}: {link} uzvunun ağırlık merkezi yok";
        no_such_point = "böyle bir nokta yok";
        has_no_com = "`com` yok";
        give_the_link_one = "uzva kendi eksen takımında bir tane verin: com = [50, 0]";
        was_moving_meant(near: &str, name: &str) = "`{near}` hareketli bir nokta; {name} mi demek istediniz?";
        take_out_or_use = "çıkarın ya da bir uzvu orada başlatın veya bitirin";
        belongs_to_nothing(name: &str) = "sabit nokta {name} kullanılmıyor";
        nothing_names_it = "hiçbir uzuv, kızak ya da vektör onu kullanmıyor";
    }
}
