//! Formulas, and what is wrong with them.

use super::Turkish;
use crate::wording::english::FormulasWords;

catalogue! {
    impl FormulasWords for Turkish {
        // How they are written.
        formula_too_long(most: usize) = "formül çok uzun: en çok {most} karakter olabilir";
        formula_too_deep(most: usize) = "parantezler ve işaretler {most} kattan derin iç içe";
        no_part_of_a_formula(character: &str) = "`{character}` formülün parçası olamaz";
        minus_without_blank(word: &str) = "`{word}`: bu bir ad mı, yoksa çıkarma mı?";
        minus_between_blanks = "`-` iki boşluk arasında çıkarır: adlarda geçebilir";
        formula_ends_early(wanted: &str) = "formül bitiyor, oysa şu gelmeliydi: {wanted}";
        expected_in_formula(wanted: &str, found: &str) = "beklenen: {wanted}, bulunan: `{found}`";
        operator_or_end = "`+`, `-`, `*`, `/`, `^` ya da formülün sonu";
        number_or_name = "bir sayı, bir ad ya da bir parantez";
        closing_bracket = "`)`";
        exponent_must_be_number = "üs bir sayı olmalı ve 0 olmamalı";
        exponents_go_to(most: usize) = "`^` {most} değerine kadar ve -{most} değerine dek sayıları alır; ötekiler için exp() ve ln() yazın";
        of_plain_numbers_only(name: &str) =
            "`{name}` yalnızca düz sayıları alır ([parameters] içinde olduğu gibi): hareket edenin bununla hızı yoktur";
        no_function(name: &str) = "`{name}` diye bir fonksiyon yok";
        functions_are(names: &str) = "fonksiyonlar: {names}";
        function_takes(name: &str, least: usize, most: usize, found: usize) = {
            let takes = match least == most {
                true => format!("{least}"),
                false => format!("{least} ile {most} arası"),
            };
            format!("{name}() {takes} değer alır, {found} değil")
        };

        number_too_large(number: &str) = "{number} sayısı çok büyük";
        number_too_small(number: &str) = "{number} sayısı çok küçük";
        number_with_comma(head: &str, tail: &str) =
            "virgül büyüklüklerin arasında durur, formülde sayının noktası olur: `{head}.{tail}`";

        at_character(at: usize, why: &str) = "{at}. karakter: {why}";

        // What they are about.
        blank_before_unit(number: &str, unit: &str) = "sayı ile birimi arasında boşluk olur: `{number} {unit}`";
        measured_in(what: &str, unit: &str) = {
            match unit {
                "1" => format!("`{what}` birimsiz bir sayı"),
                unit => format!("`{what}` birimi {unit}"),
            }
        };
        do_not_go_together(one: &str, other: &str) = "{one}; {other}: bunlar birlikte olmaz";
        numbers_need_units = "sayının arkasına birimini yaz: `90 deg`, `10 mm/s`";
        takes_an_angle(function: &str, unit: &str) = {
            match unit {
                "1" => format!("{function}() açı alır, bu ise birimsiz bir sayı"),
                unit => format!("{function}() açı alır, bunun birimi ise {unit}"),
            }
        };
        angles_have_units = "açıların birimi vardır: `30 deg`, `0.5 rad`";
        takes_a_number(function: &str, unit: &str) =
            "{function}() birimsiz bir sayı alır, bunun birimi ise {unit}: bu birimden bir değere böl";
        no_root_of(unit: &str) = "hiçbir büyüklük {unit} biriminin köküyle ölçülmez";
        unit_beyond_use = "bunun birimi hiçbir işe yaramaz";
        formula_has_too_many_steps = "formül, kullandıklarıyla birlikte çok uzun";
        formula_has_no_such_rate = "yalnız birinci ve ikinci türev bilinir";

        // Numbers that are worked out.
        has_no_worth(of: &str) = "`{of}` bir sayı vermiyor";
        divided_by_nothing(by: &str) = "`{by}` sıfır, sıfıra bölünmez";
        no_parameter(name: &str) = "`{name}` adında parametre yok";
        parameters_are(names: &str) = "parametreler: {names}";
        scene_has_no_parameters = "adı olan sayılar `[parameters]` içinde durur: `a = 100`";
        units_stand_alone = "birimler benzerleriyle toplanır, yalnız birimsiz sayılarla çarpılır";
        units_multiplied(formula: &str) = "`{formula}` bir birimi bir birimle çarpıyor";
        units_divided(formula: &str) = "`{formula}` bir birimi başka bir birime ya da bir sayıyı bir birime bölüyor";
        units_divide_their_like =
            "birim birimsiz sayıyla çarpılır ve bölünür, bir de benzerine bölünür: `10 cm / (2 mm)`";
        parameter_called(name: &str) = "{name} parametresi";
        parameters_in_a_circle(name: &str, circle: &str) = "{name} parametresi kendinden çıkıyor: {circle}";
        follows_from_itself = "kendinden çıkıyor";
        give_one_a_number = "birine bir sayı ver";
        parameter_reads_as_number(name: &str) = "{name} adı sayı diye okunurdu";
        begin_it_with_a_letter = "bir harfle başlat";
        formulas_read_a_unit(name: &str) =
            "formüllerde `{name}` bir birimdir: başka bir ad seç, örneğin `{name}1`";
        formulas_read_a_function(name: &str) =
            "formüllerde `{name}` bir fonksiyondur: başka bir ad seç, örneğin `{name}1`";
        parameters_measured_in(named: &[(String, String)], wanted: &str) = {
            let named: Vec<_> = named.iter().map(|(name, unit)| format!("`{name}` birimi {unit}")).collect();
            let wanted = match wanted {
                "1" => String::new(),
                wanted => format!("{wanted} ile ya da "),
            };
            format!("{}: {wanted}birimsiz yaz, birimsiz sayı durduğu yerin birimini alır", named.join(", "))
        };
        rate_of_units(key: &str, of: &str, formula: &str, found: &str) =
            "`{key}` ({of}): birimin önünde birimsiz bir sayı durur, `{formula}` ise {found} biriminde";
        rate_brings_its_unit(formula: &str, unit: &str) =
            "`{unit}` bütünün birimidir: `{formula}` içindeki parametreleri birimsiz ver";
        value_measures_other(value: &str, found: &str, wanted: &str) =
            "{value}: birimi {wanted} olmalı, bunun birimi ise {found}";
        no_value_named(name: &str, meant: Option<&str>) = {
            let meant = meant.map_or(String::new(), |meant| format!("; {meant}"));
            format!("sahnede `{name}` adında değer yok{meant}")
        };
        follows_from_formula(value: &str, formula: &str) = "{value}, {formula} ifadesinden çıkıyor: Enter ile başkasını yaz";
        follows_from_parameters(value: &str, formula: &str, names: &str) =
            "{value}, {formula} ifadesinden çıkıyor: {names} değiştir ya da Enter ile başkasını yaz";

        // Figures that are defined.
        formula_uses_itself(name: &str) = "{name} kendinden oluşuyor";
        no_rate_of(of: &str) = "{of}: bunun türevi bilinmiyor";
        name_of_figure_missing = "formül bir adın ve `=` işaretinin arkasında durur: `swing = r4.angle - r3.angle`";
        name_of_figure_bad(name: &str) =
            "`{name}` bir büyüklüğün adı olamaz: ASCII harf, rakam, `_`, `-` ve `'`, en çok 64";
        name_of_figure_taken(name: &str) = "`{name}` zaten başka bir şeyin adı: başka bir ad seç";
        in_formula_of(name: &str) = "{name} formülü";
    }
}
