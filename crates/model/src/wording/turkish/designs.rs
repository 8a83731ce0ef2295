//! Studies of many designs of a scene: ranges, goals and results.

use super::Turkish;
use crate::wording::english::DesignsWords;

catalogue! {
    impl DesignsWords for Turkish {
        no_axis(text: &str) =
            "`{text}` geçerli bir aralık değil: `r3.length` (serbest), `r3.length=280..320` ya da \
             `r3.length=280..320/9` (9 değer) yazın";
        no_goal(text: &str) =
            "`{text}` bir hedef değil: bir büyüklük, bir işaret ve bir sayı yazın: `C.x.stroke = 120`, \
             `transmission >= 40` ya da `r4.angle.swing <= 75`";
        unit_of_goal(figure: &str, unit: &str, found: &str) = {
            match unit {
                "" => format!("{figure} birimsizdir, birimi {found} değil: yalnız sayıyı yazın"),
                unit => format!(
                    "{figure} büyüklüğünün birimi {unit}, {found} değil: yalnız sayıyı ya da bu türden bir birimle yazın"
                ),
            }
        };

        // Goals and optimization.
        to_be_met = "hedefler";
        to_be_best = "eniyile";
        to_be_kept = "koru";
        designs_found = "bulunan";
        given_design = "verilen";
        nearest_design = "en yakın";
        best_design = "en iyi";
        kind_of_motion = "hareket";
        motion_of_design(design: &str, motion: &str) = "{design}: {motion}";
        moves_otherwise = "bu tasarım verilenden farklı hareket ediyor";
        greatest_wished(figure: &str) = "en büyük {figure}";
        least_wished(figure: &str) = "en küçük {figure}";
        none_meets_goals(starts: u32) = {
            format!("{starts} başlangıçtan hiçbir tasarım bütün hedefleri karşılamıyor; en yakını aşağıda")
        };
        no_design_opens(starts: u32) = {
            format!("{starts} başlangıçtan hiçbir tasarımda bu büyüklüklerin hepsi yok")
        };
        one_design_meets(starts: u32) = { format!("bir tasarım, {starts} başlangıçtan") };
        designs_meet(count: usize, shown: usize, starts: u32) = {
            let first = match count > shown {
                true => format!(", en yakın {shown} tanesi aşağıda"),
                false => ", önce en yakını".into(),
            };
            format!("{count} tasarım{first}, {starts} başlangıçtan")
        };
        family_of_designs(freedoms: usize) = {
            format!("{freedoms} serbestlik dereceli bir aileden: yakındaki tasarımlar da hedefleri karşılar")
        };
        generations_made(generations: u32, settled: bool) = {
            match settled {
                true => format!("{generations} kuşağın en iyisi; arama yakınsadı"),
                false => format!("{generations} kuşağın en iyisi; arama yakınsamadı"),
            }
        };
        polished_best(stationary: bool) = {
            match stationary {
                true => "sınırlar içinde hiçbir küçük değişiklik onu iyileştirmiyor",
                false => "küçük bir değişikliğin onu iyileştirmeyeceği kesin değil",
            }
            .to_owned()
        };
        no_goal_given = "aranacak bir şey verilmemiş: --goal, --minimize ya da --maximize verin";
        goals_and_best =
            "--goal ile --minimize ya da --maximize birlikte kullanılamaz: sınırları --keep ile yazın";
        free_without_ends(name: &str) = "`{name}` için burada sınırlar gerekir: `{name}=ALT..ÜST` yazın";
        no_such_design(number: usize, count: usize) =
            "{number} numaralı tasarım yok: yalnız {count} tasarım bulundu";
        given_lacks = "verilende yok";
        goals_not_met = "hiçbir tasarım bütün hedefleri karşılamıyor";
        keeps_nothing = "hiçbir tasarım bütün sınırlara uymuyor";
        value_misses_limits(value: &str) = "{value}, sınırlara uymuyor";
        start_was_written = "yeni bir [start] yazıldı: o olmadan sahne başka bir montaj biçiminde açılırdı";

        // The command.
        does_solve =
            "Bir sahnenin hedefleri karşılayan ya da bir büyüklüğü en küçük veya en büyük yapan değerlerini bulun";
        values_to_vary =
            "Değiştirilecek değerler, sahne görünümündeki adlarıyla ve noktayla: r3.length, A.x, bir parametre; \
             sınırlarıyla: r3.length=280..320";
        goal_to_meet =
            "Karşılanacak hedef: C.x.stroke = 120, r4.angle.swing <= 75, C.x@60 = 310 (krank help designs); \
             yinelenebilir";
        limit_to_keep =
            "Uyulacak sınır, >=, <= ya da = ile: transmission >= 40, r4.angle.swing = 75; yinelenebilir";
        figure_to_minimize = "Sınırlar içinde en küçük yapılacak büyüklük";
        figure_to_maximize = "Sınırlar içinde en büyük yapılacak büyüklük";
        starts_of_search = "Verilen tasarıma ek olarak rastgele başlangıç sayısı";
        generations_of_search = "Aramadaki en büyük kuşak sayısı";
        seed_of_search = "Rastgele sayıların tohumu: aynı tohum aynı tasarımları bulur";
        design_to_write = "-o ile yazılacak tasarımın numarası";
        starts_counted = "başlangıç";
        generations_counted = "kuşak";
        examples_of_solve = "\
Örnekler:
  krank solve slider-crank --vary r2.length --goal 'r4.length.stroke = 13'
  krank solve offset-slider-crank --vary r2.length,r4.through.y \\
      --goal 'r4.length.stroke = 120' --goal 'r4.length.ratio = 1.1' \\
      --keep 'transmission >= 40' -o bulunan.toml
  krank solve four-bar --vary r2.length=60..140,r4.length=200..320 \\
      --maximize r4.angle.swing --keep 'transmission >= 45'

Her tasarım sahnenin montaj biçimini korur. Hedefleri hiçbir tasarım karşılamıyorsa
en yakını yazılır ve çıkış kodu 1 olur. Çok başlangıçlı bir arama, başka tasarım
bulunmadığını kanıtlamaz.";
        // Ranges.
        value_twice(name: &str) = "{name} iki kez verilmiş: her değeri bir kez yazın";
        axis_without_ends(name: &str) =
            "{name} için sınır yok: {name}=280..320 ya da 9 değer için {name}=280..320/9 yazın";
        hypercube_has_places(name: &str) =
            "{name} için değer sayısı verilmiş, ama --latin ile bu sayı tasarım sayısıdır: / işaretini ve \
             arkasındaki sayıyı silin";
        too_many_designs(most: &str) =
            "ızgarada {most} tasarımdan fazlası var: daha az değer ya da --latin kullanın";
        no_part(text: &str) = "`{text}` bir parça değil: 64 parçanın üçüncüsü için 3/64 yazın";
        disk_without_locks(file: &str) =
            "{file}: bu diskte dosya kilidi yok; bu dosyayla ikinci bir çalışma başlatmayın";
        resume_needs_file = "--resume için bir CSV dosyası gerekir: dosyayı -o ile verin";
        chart_needs_grid(most: &str) =
            "grafik için bir ya da iki değerin bütün parçalarıyla ızgarası ve en çok {most} tasarım gerekir";

        // Results.
        designs = "tasarım";
        file_of_other_study(file: &str, line: u64) =
            "{file} başka bir çalışmanın dosyası: {line}. satır farklı. Dosyayı baştan yazmak için --resume \
             seçeneğini kaldırın";
        row_was_changed(file: &str, line: u64) =
            "{file} dosyasının {line}. satırı, bu çalışma yazdıktan sonra değiştirilmiş. Satırı geri getirin ya \
             da dosyayı baştan yazmak için --resume seçeneğini kaldırın";
        file_goes_on(file: &str, done: u64, all: u64) = "{file} içinde {all} tasarımın {done} tanesi hazır";
        designs_left_out(open: u64, unreadable: u64, all: u64) =
            "{all} tasarımın {open} tanesi sahnedeki gibi kurulamıyor, {unreadable} tanesi geçerli bir sahne \
             değil: nedeni satırlarında yazılı";
        no_design_has_figures(why: &str) = "bu değerlerin hiçbiri hiçbir tasarımda yok: {why}";
        has_no_value_in_designs(figure: &str) = "{figure} hiçbir tasarımda değer almıyor";
        designs_from_to(figure: &str, minimum: [&str; 2], maximum: [&str; 2]) = {
            let ([minimum, low], [maximum, high]) = (minimum, maximum);
            format!("{figure}: en küçük {minimum}, {low} iken; en büyük {maximum}, {high} iken")
        };
        blank_is_no_design = "boş: değer yok";
        axes_of_map(up: &str, along: &str) = "yukarı: {up}; yana: {along}";

        // In the workbench.
        goal = "hedef";
        find_values_for_a_goal = "hedef için değer bul";
        goals_are_typed(value: &str) = "C.x.stroke = 120 by {value}";
        goal_not_met(nearest: &str, values: &str) =
            "yakında bunu karşılayan tasarım yok; en yakını: {nearest} ({values})";
        goal_is_met(values: &str) = "{values} karşılıyor";
        goal_needs_opening(why: &str) = {
            match why.is_empty() {
                true => "yakında hesaplanabilen bir tasarım yok".to_owned(),
                false => format!("yakında hesaplanabilen bir tasarım yok; bunda: {why}"),
            }
        };
        looking_for_designs(percent: u32) = "tasarımlar aranıyor: %{percent}";
        design_of(number: usize, count: usize, values: &str) = "{number}/{count}: {values}";
        moves_otherwise_as(motion: &str) = "farklı hareket ediyor: {motion}";
    }
}
