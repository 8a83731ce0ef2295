//! Formulas and their errors.

use super::Turkish;
use crate::wording::english::FormulasWords;

catalogue! {
    impl FormulasWords for Turkish {
        // Syntax.
        formula_too_long(maximum: usize) = "formül çok uzun: en çok {maximum} karakter kullanın";
        formula_too_deep(maximum: usize) = "parantez ve işaretlerin iç içe derinliği {maximum} sınırını aşıyor";
        no_part_of_a_formula(character: &str) = "`{character}` formülde kullanılamaz";
        minus_without_blank(word: &str) = "`{word}` bir ad ya da çıkarma olabilir";
        minus_between_blanks = "çıkarma için `-` çevresine boşluk koyun: adlarda da geçebilir";
        formula_ends_early(wanted: &str) = "formül bitiyor, ama şu gelmeli: {wanted}";
        expected_in_formula(wanted: &str, found: &str) = "beklenen: {wanted}, bulunan: `{found}`";
        operator_or_end = "`+`, `-`, `*`, `/`, `^` ya da formülün sonu";
        number_or_name = "bir sayı, bir ad ya da bir parantez";
        closing_bracket = "`)`";
        exponent_must_be_number = "üs 0'dan farklı bir sayı olmalı";
        exponents_go_to(maximum: usize) =
            "`^` -{maximum} ile {maximum} arasındaki sayıları alır: ötekiler için exp() ve ln() kullanın";
        of_plain_numbers_only(name: &str) =
            "`{name}` yalnız birimsiz sayılarla kullanılır ([parameters] içindeki gibi): türevi yoktur";
        no_function(name: &str) = "bilinmeyen fonksiyon `{name}`";
        functions_are(names: &str) = "fonksiyonlar: {names}";
        function_takes(name: &str, minimum: usize, maximum: usize, found: usize) = {
            let takes = match minimum == maximum {
                true => format!("{minimum}"),
                false => format!("{minimum} ile {maximum} arası"),
            };
            format!("{name}() {takes} argüman alır, {found} değil")
        };

        number_too_large(number: &str) = "{number} sayısı çok büyük";
        number_too_small(number: &str) = "{number} sayısı çok küçük";
        number_with_comma(head: &str, tail: &str) =
            "virgül argümanları ayırır: sayıyı noktayla yazın, `{head}.{tail}`";

        at_character(at: usize, why: &str) = "{at}. karakter: {why}";

        // Units.
        blank_before_unit(number: &str, unit: &str) =
            "sayı ile birimi arasına boşluk koyun: `{number} {unit}`";
        measured_in(what: &str, unit: &str) = {
            match unit {
                "1" => format!("`{what}` birimsiz bir sayı"),
                unit => format!("`{what}` birimi {unit}"),
            }
        };
        do_not_go_together(one: &str, other: &str) = "{one}; {other}: birimler uyuşmuyor";
        numbers_need_units = "sayıdan sonra birim yazın: `90 deg`, `10 mm/s`";
        takes_an_angle(function: &str, unit: &str) = {
            match unit {
                "1" => format!("{function}() açı alır, bu ise birimsiz bir sayı"),
                unit => format!("{function}() açı alır, bunun birimi ise {unit}"),
            }
        };
        angles_have_units = "açıya birim verin: `30 deg`, `0.5 rad`";
        takes_a_number(function: &str, unit: &str) =
            "{function}() birimsiz bir sayı alır, bunun birimi ise {unit}: bu birimden bir değere bölün";
        no_root_of(unit: &str) = "{unit} biriminin karekökü bir birim değil";
        unit_beyond_use = "bu birimin üssü çok büyük";
        formula_has_too_many_steps = "formül, kullandıklarıyla birlikte çok uzun";
        formula_has_no_such_rate = "yalnız birinci ve ikinci türev var";

        // Evaluation and parameters.
        has_no_worth(of: &str) = "`{of}` değer vermiyor";
        divided_by_nothing(by: &str) = "`{by}` 0: sıfıra bölme";
        no_parameter(name: &str) = "bilinmeyen parametre `{name}`";
        parameters_are(names: &str) = "parametreler: {names}";
        scene_has_no_parameters = "adlı sayıları `[parameters]` içinde tanımlayın: `a = 100`";
        units_stand_alone =
            "yalnız aynı birimdeki değerleri toplayın; birimi yalnız birimsiz sayılarla çarpın";
        units_multiplied(formula: &str) = "`{formula}` bir birimi bir birimle çarpıyor";
        units_divided(formula: &str) = "`{formula}` bir birimi başka bir birime ya da bir sayıyı bir birime bölüyor";
        units_divide_their_like =
            "birimi yalnız birimsiz bir sayıya ya da aynı birimden bir değere bölün: `10 cm / (2 mm)`";
        parameter_called(name: &str) = "{name} parametresi";
        parameters_in_a_circle(name: &str, circle: &str) = "{name} parametresi kendine bağlı: {circle}";
        follows_from_itself = "kendine bağlı";
        give_one_a_number = "birine bir sayı verin";
        parameter_reads_as_number(name: &str) = "{name} adı bir sayı olarak okunabilir";
        begin_it_with_a_letter = "bir harfle başlatın";
        formulas_read_a_unit(name: &str) =
            "formüllerde `{name}` bir birimdir: başka bir ad seçin, örneğin `{name}1`";
        formulas_read_a_function(name: &str) =
            "formüllerde `{name}` bir fonksiyondur: başka bir ad seçin, örneğin `{name}1`";
        parameters_measured_in(named: &[(String, String)], wanted: &str) = {
            let named: Vec<_> = named.iter().map(|(name, unit)| format!("`{name}` birimi {unit}")).collect();
            let wanted = match wanted {
                "1" => String::new(),
                wanted => format!("{wanted} ile ya da "),
            };
            format!("{}: {wanted}birimsiz bir sayı olarak yazın", named.join(", "))
        };
        rate_of_units(key: &str, of: &str, formula: &str, found: &str) =
            "`{key}` ({of}): birimden önce birimsiz bir sayı gerekir, ama `{formula}` {found} biriminde";
        rate_brings_its_unit(formula: &str, unit: &str) =
            "`{unit}` bütün değerin birimidir: `{formula}` içindeki parametreleri birimsiz verin";
        value_measures_other(value: &str, found: &str, wanted: &str) =
            "{value}: birimi {wanted} olmalı, bunun birimi ise {found}";
        no_value_named(name: &str, intended: Option<&str>) = {
            let intended = intended.map_or(String::new(), |intended| format!("; {intended}"));
            format!("sahnede `{name}` adında değer yok{intended}")
        };
        edit_the_original(copy: &str, original: &str) = "{copy} bir kopyadır; {original} elemanını değiştirin";
        input_is_held(name: &str, at: &str, unit: &str) = "{name}, {at} {unit} değerinde tutulur";
        no_held_inputs = "sahnede tutulan giriş yok; [inputs] içinde `r7 = { at = 30 }` bir giriş tutar";
        keys_step_the_driver(name: &str) = "adım tuşları tahriki, {name} girişini hareket ettirir";
        keys_step_an_input(name: &str, at: &str, unit: &str) = "adım tuşları {name} girişini hareket ettirir; tutulduğu yer {at} {unit}";
        input_is_not_held(name: &str) = "{name} tahriki izler; tutmak için [inputs] içinde `at` verin";
        path_too_long(most: usize) = "{most} satırdan fazla";
        path_is_empty = "girişlerin adları altında sayı satırı yok";
        path_has_other_unit(name: &str, unit: &str, own: &str) =
            "`{name}` sütunu {unit} biriminde; sayılarını {own} olarak yazın";
        path_names_twice(name: &str) = "iki sütunun adı `{name}`";
        path_row_has_cells(line: u64, cells: usize, names: usize) =
            "satır {line}: {cells} hücre var, ilk satırda {names}";
        path_cell(line: u64, name: &str, cell: &str) =
            "satır {line}: `{name}` altındaki `{cell}` birimsiz bir sayı değil";
        path_has_no_rates(name: &str) = "`{name}` için hız gerekir, `--path` satırlarında zaman yok; yalnız konum adlandırın";
        path_leads_other_number(leading: usize, free: usize, names: &str) =
            "dosyada {leading} nokta koordinatı ve sütunu olmayan {free} giriş var ({names}); izleyen \
             girişlerin sayısı koordinatların sayısına eşit olmalıdır";
        rows_are_singular(singular: u64, rows: u64) =
            "{rows} satırın {singular} tanesi tekil: girişler noktayı orada her yöne hareket ettiremez";
        poses_out_of_reach(outside: u64, rows: u64) = "{rows} satırın {outside} tanesine girişler ulaşamıyor";
        no_input_named(name: &str, names: &str, meant: Option<&str>) = {
            let meant = meant.map_or(String::new(), |meant| format!("; {meant}"));
            format!("sahnede `{name}` adında giriş yok; girişleri: {names}{meant}")
        };
        follows_from_formula(value: &str, formula: &str) =
            "{value}, {formula} ile veriliyor: yazmak için Enter";
        follows_from_parameters(value: &str, formula: &str, names: &str) =
            "{value}, {formula} ile veriliyor: {names} değiştirin ya da Enter ile yazın";

        // Named quantities.
        formula_uses_itself(name: &str) = "{name} kendine bağlı";
        no_rate_of(of: &str) = "{of}: bunun türevi bilinmiyor";
        name_of_figure_missing = "formülden önce bir ad ve `=` yazın: `swing = r4.angle - r3.angle`";
        name_of_figure_bad(name: &str) =
            "`{name}` geçerli bir ad değil: ASCII harf, rakam, `_`, `-` ve `'` kullanın, en çok 64";
        name_of_figure_taken(name: &str) = "`{name}` zaten kullanılıyor: başka bir ad seçin";
        in_formula_of(name: &str) = "{name} formülü";
    }
}
