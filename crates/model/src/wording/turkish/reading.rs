//! Errors in the keys, values and names of a scene or a configuration, and how to fix them.

use super::{Turkish, syntax};
use crate::wording::english::ReadingWords;

catalogue! {
    impl ReadingWords for Turkish {
        // The document.
        not_utf8(byte: u8, at: usize) = "dosya UTF-8 değil: {at} konumunda bayt 0x{byte:02x}";
        not_a_character = "UTF-8'de geçerli bir karakter değil";
        save_as_utf8 = "dosyayı UTF-8 olarak kaydedin";
        not_valid_toml(message: &str) = {
            format!("geçerli TOML değil: {}", syntax::translate_message(message))
        };
        more_faults(count: usize) = "{count} hata daha var, gösterilmiyor";
        given_twice(key: &str) = "{key} iki kez verilmiş";
        the_first_time = "ilki";
        the_second_time = "ikincisi";
        take_one_out = "birini çıkarın ya da adını değiştirin";
        unknown_key_in(of: &str, key: &str) = "{of}: bilinmeyen anahtar {key}";
        unknown_key_here = "bilinmeyen anahtar";
        known_keys(names: &str) = "bilinen anahtarlar: {names}";
        no_gears_yet = "krank henüz dişlileri modellemez";
        no_cams_yet = "krank henüz kamları modellemez";
        no_belts_yet = "krank henüz kayış ve zincirleri modellemez";
        no_friction_yet = "krank henüz sürtünmeyi modellemez: kuvvetleri sürtünmesiz mafsallar içindir";
        no_contacts_yet = "krank henüz temasları modellemez";
        motion_is_given =
            "krank bir kuvvetten ya da torktan hareket hesaplamaz: hızı verin, yükleri [[loads]] içine yazın";
        joints_are_points =
            "krank'ta mafsal listesi yoktur: iki uzvun ya da bir uzuv ile [ground] bölümünün adlandırdığı nokta döner mafsaldır";
        sliders_are_slides = "kayan parça [slides] bölümünde yazılır: yarıktaki bir pim ya da dönmeyen bir uzuv";
        motors_are_drivers = "giriş [driver] bölümüdür, öteki girişler [inputs]; [motor] tahriki derecelendirir";
        anchors_are_ground = "sabit noktalar [ground] bölümündedir";
        bars_are_links = "rijit parçalar [links] bölümündedir";
        krank_reads_toml = "sahne bir TOML dosyasıdır: `krank help scene` onu anlatır";
        is_an_address = "bu bir internet adresi, sahne değil";
        is_a_pmks_address = "bu bir PMKS+ mekanizmasının adresi, sahne değil: onu `krank import` ile çevirin";
        is_json = "bu JSON, TOML değil";
        is_json_of_pmks = "bu bir PMKS+ mekanizmasının JSON'u; krank onu okumaz, `krank import` adreslerini okur";

        // Values.
        must_be(what: &str, wanted: &str, found: &str) = "{what} {wanted} olmalı, {found} değil";
        expected(wanted: &str) = "beklenen: {wanted}";
        for_example(example: &str) = "örneğin: {example}";
        write_in_quotes(literal: &str) = "tırnak içinde yazın: \"{literal}\"";
        write_without_quotes(literal: &str) = "tırnaksız yazın: {literal}";
        a_quoted_text = "tırnak içinde bir metin";
        a_text = "bir metin";
        a_number = "bir sayı";
        a_truth = "true ya da false";
        a_date = "bir tarih";
        a_list = "bir liste";
        a_table = "bir tablo";
        key_of(key: &str, of: &str) = "`{key}` ({of})";
        part_of(part: &str, of: &str) = "{of}: {part}";

        // Numbers.
        a_finite_number = "sonlu bir sayı";
        at_most_in_size = "büyüklükçe en çok 1e300";
        is_not_a_number = "sayı değil";
        is_not_finite = "double olarak sonlu değil";
        is_too_large = "çok büyük";
        write_a_decimal = "ondalık bir sayı yazın, 12.5 gibi";
        choose_a_unit = "boyutların olağan büyüklükte olduğu bir `unit` seçin";
        must_not_be_less_than_zero(what: &str, literal: &str) = "{what} negatif olamaz, oysa {literal}";
        is_negative = "negatif";
        leave_it_out(key: &str) = "önemi yoksa `{key}` yazmayın";
        a_pair(form: &str) = "bir çift {form}";
        must_be_a_pair(what: &str, form: &str, count: usize) =
            "{what} bir çift {form} olmalı, {count} değer değil";
        expected_two(count: usize) = "2 değer beklenirken {count} var";
        write_as_a_part(part: f64) = "kesir olarak yazın: {part}";
        is_no_unit(word: &str, units: &str) = "`{word}` birim değil; şunlardan birini kullanın: {units}";
        product_has_a_sign(number: &str, name: &str) = "çarpımı işaretiyle yazın: `{number} * {name}`";

        // Common mistakes.
        comments_begin_with = "açıklama # ile başlar";
        quote_the_name = "içinde ' olan adı tırnak içinde yazın: \"B'\" = [0, 0]";
        has_decimal_comma(number: &str) = "`{number}` sayısında ondalık virgülü var";
        decimals_have_a_point(number: &str) = "ondalıkları noktayla yazın: {number}";
        write_key_and_value = "anahtar = değer yazın";
        quote_texts_and_names = "metinleri ve adları tırnak içinde yazın: \"A\"";
        separate_by_commas = "bir listenin değerlerini virgülle ayırın: [0, 0]";
        quote_with_unit(number: &str, unit: &str) = "birimli sayıyı tırnak içinde yazın: \"{number} {unit}\"";
        angle_alone(number: &str) = "açılar derecedir: yalnız sayıyı yazın: {number}";
        number_alone_or_unit(number: &str) =
            "yalnız sayıyı yazın: {number}; ya da tırnak içinde, birimiyle: \"{number} mm\"";

        // The driver.
        driver_has_both = "tahrikte hem `link` hem `slide` var";
        one_is_driven = "tahrik edilen bunlardan biridir";
        driver_has_neither = "tahrikte ne `link` ne `slide` var";
        nothing_is_driven = "tahrik edilen yok";
        how_a_link_is_driven(example: &str) = "tahrik edilen uzuv: {example}";
        how_a_slide_is_driven(example: &str) = "tahrik edilen kızak: {example}";
        driver_has_other(driven: &str, other: &str, coordinate: &str) =
            "tahrik: tahrik edilen `{driven}` için `{other}` değil, `{coordinate}` verilir";
        coordinate_is_meant(coordinate: &str) = "`{coordinate}` kullanın";
        driver_lacks(coordinate: &str) = "tahrikte `{coordinate}` yok";
        coordinate_is_missing(coordinate: &str) = "`{coordinate}` eksik: sahnenin açıldığı yerdeki değeri";

        // Rates.
        rate_is_no_number(key: &str, of: &str, typed: &str) =
            "`{key}` ({of}) tırnak içinde bir sayı ve birim olmalı, `{typed}` değil";
        rate_has_no_unit(key: &str, of: &str, typed: &str) = "`{key}` ({of}) birimsiz: `{typed}`";
        rate_has_other_unit(key: &str, of: &str, typed: &str) =
            "`{key}` ({of}) için uymayan bir birim: `{typed}`";
        rate_has_two_marks(key: &str, of: &str, typed: &str) =
            "`{key}` ({of}) içinde birden çok ondalık işareti var: `{typed}`";
        rate_is_too_large(key: &str, of: &str, typed: &str) = "`{key}` ({of}) çok büyük: `{typed}`";
        digits_without_groups = "haneleri gruplamadan yazın: 1234.5 ya da 1234,5";
        expected_a_rate = "tırnak içinde bir sayı ve birim beklenir";
        possible_units(units: &str) = "olabilecek birimler: {units}";

        // Names.
        noun_point = "nokta";
        noun_link = "uzuv";
        noun_slide = "kızak";
        noun_vector = "vektör";
        noun_figure = "büyüklük";
        noun_parameter = "parametre";
        noun_limit = "sınır";
        names_both(name: &str, other: &str, one: &str) = "{name} hem {other} hem {one} adı";
        named_here(noun: &str) = "burada {noun}";
        names_are_shared =
            "noktalar, uzuvlar, kızaklar, vektörler, büyüklükler ve parametreler adları paylaşır: birinin adını değiştirin";
        is_another(what: &str, name: &str, other: &str, noun: &str) =
            "{what}: {name} {noun} değil, {other}";
        expected_name_of(noun: &str) = "bir {noun} adı beklenir";
        that_one(noun: &str) = "o {noun}";
        there_is_no(what: &str, noun: &str, name: &str) = "{what}: {name} adında {noun} yok";
        unknown_noun(noun: &str) = "bilinmeyen {noun}";
        key_stands_above(key: &str) = "sahnenin `{key}` anahtarını ilk [table] üstüne yazın";
        scene_has_no(noun: &str) = "sahnede {noun} yok";
        those_of_scene(noun: &str, names: &str) = "sahnedekiler ({noun}): {names}";
        name_is_reserved(name: &str) = "{name} adı ayrılmış";
        is_reserved = "ayrılmış";
        columns_use(names: &str) = "{names} sütunlarda özel anlam taşır: başka bir ad seçin";
        name_a_ground_point = "bir uzvu şaseye bağlamak için [ground] noktalarından birini adlandırın";
        name_is_empty = "ad boş olamaz";
        is_empty = "boş";
        name_is_too_long(name: &str, count: usize, most: usize) =
            "{name} adı {count} karakter; en çok {most} olabilir";
        is_too_long = "çok uzun";
        name_contains(name: &str, odd: &str) = "{name} adında {odd} var";
        is_no_name = "ad değil";
        names_are_made_of = "adlar ASCII harfleri, rakamlar, `_`, `-` ve `'` ile yazılır";
    }
}
