//! Many designs of a scene: what varies, and what is wished.

use super::Turkish;
use crate::wording::english::DesignsWords;

catalogue! {
    impl DesignsWords for Turkish {
        no_axis(text: &str) =
            "`{text}` bir değerin nasıl değiştiğini söylemiyor: `r3.length` (serbest), `r3.length=280..320` ya da \
             `r3.length=280..320/9` (9 yerde) yazın";
        no_goal(text: &str) =
            "`{text}` bir hedef değil: bir büyüklük, bir işaret ve bir sayı yazın: `C.x.stroke = 120`, \
             `transmission >= 40` ya da `r4.angle.swing <= 75`";
        unit_of_goal(figure: &str, unit: &str, found: &str) = {
            match unit {
                "" => format!("{figure} birimsiz bir sayıdır, birimi {found} değil: sayıyı yalnız yazın"),
                unit => format!(
                    "{figure} büyüklüğünün birimi {unit}, {found} değil: sayıyı yalnız ya da bu türden bir birimle yazın"
                ),
            }
        };

        // Goals and the best.
        to_be_met = "karşılanacak";
        to_be_best = "en iyisi";
        to_be_kept = "korunacak";
        designs_found = "bulunan";
        given_design = "verilen";
        nearest_design = "en yakın";
        best_design = "en iyi";
        kind_of_motion = "hareket";
        motion_of_design(design: &str, motion: &str) = "{design}: {motion}";
        moves_otherwise = "bu tasarım verilen gibi hareket etmiyor";
        greatest_wished(figure: &str) = "en büyük {figure}";
        least_wished(figure: &str) = "en küçük {figure}";
        none_meets_goals(starts: u32) = {
            format!("{starts} başlangıçtan hiçbir tasarım hepsini karşılamıyor; en yakını aşağıda")
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
            format!("{freedoms} serbestlikli bir aileden: bunların yanındaki tasarımlar da hedefleri karşılar")
        };
        generations_made(generations: u32, settled: bool) = {
            match settled {
                true => format!("{generations} kuşağın en iyisi; hepsi bir yere vardı"),
                false => format!("{generations} kuşağın en iyisi; bir yere varmadılar"),
            }
        };
        polished_best(stationary: bool) = {
            match stationary {
                true => "hepsini koruyan hiçbir küçük adım onu iyileştirmiyor",
                false => "küçük bir adımın onu iyileştirip iyileştirmediği kesin değil",
            }
            .to_owned()
        };
        no_goal_given = "neyin karşılanacağını --goal ile, neyin en iyi olacağını --minimize ya da --maximize ile söyleyin";
        goals_and_best = "ya bir hedef karşılanır ya da bir büyüklük en iyi olur: --goal ya da --keep ile birlikte --minimize veya --maximize verin";
        free_without_ends(name: &str) = "`{name}` için burada sınırlar gerek: `{name}=ALT..ÜST` yazın";
        no_such_design(number: usize, count: usize) = "{number} numaralı tasarım yok: {count} tasarım bulundu";
        given_lacks = "verilende yok";
        goals_not_met = "bütün hedefleri karşılayan bir tasarım bulunamadı";
        keeps_nothing = "hepsini koruyan bir tasarım bulunamadı";
        start_was_written = "metin tek başına başka bir montaj biçiminde açılırdı: [start] yeniden yazıldı";

        // The command.
        does_solve = "Sahnenin hedefleri karşılayan ya da bir büyüklüğü en iyi yapan sayılarını bulur";
        values_to_vary = "Değişen değerler, sahne görünümündeki adlarıyla, noktalı: r3.length, A.x, bir parametre; sınırlarıyla r3.length=280..320";
        goal_to_meet = "Karşılanacak olan: C.x.stroke = 120, r4.angle.swing <= 75, C.x@60 = 310 (krank help designs); her hedef için bir kez";
        limit_to_keep = "Ayrıca korunacak olan, >=, <= ya da = ile: transmission >= 40, r4.angle.swing = 75";
        figure_to_minimize = "Değerlerin sınırları içinde, her şey korunarak en küçük olacak büyüklük";
        figure_to_maximize = "En büyük olacak büyüklük";
        starts_of_search = "Verilenin dışında kaç yerden başlayarak tasarım aranacağı";
        generations_of_search = "En iyinin en çok kaç kuşak boyunca aranacağı";
        seed_of_search = "Rastlantının tohumu: aynı tohum aynısını bulur";
        design_to_write = "Tasarımlardan hangisinin -o dosyasına yazılacağı";
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

Her tasarım sahnenin montaj biçiminde açılır, ya da hiç açılmaz. Hedefleri hiçbir
tasarım karşılamıyorsa en yakını söylenir ve çıkış kodu 1 olur. Çok başlangıçlı bir
arama, bulmadığı tasarımlar için hiçbir şey kanıtlamaz.";
        // What varies.
        value_twice(name: &str) = "{name} iki kez değişiyor";
        axis_without_ends(name: &str) =
            "{name} için uç değer yok: {name}=280..320 ya da 9 yer için {name}=280..320/9 yazın";
        hypercube_has_places(name: &str) =
            "{name} için yer sayısı verilmiş, oysa --latin ile her değerin tasarım sayısı kadar yeri olur: / ve \
             arkasındaki sayıyı silin";
        too_many_designs(most: &str) =
            "ızgarada {most} tasarımdan fazlası var: daha az yer verin ya da --latin kullanın";
        no_part(text: &str) = "`{text}` bir parça değil: 64 parçanın üçüncüsü için 3/64 yazın";
        disk_without_locks(file: &str) =
            "{file}: bu diskte dosya kilidi yok; aynı dosyaya ikinci bir çalışma başlatma";
        resume_needs_file = "--resume bir CSV dosyasını sürdürür: dosyayı -o ile belirtin";
        chart_needs_grid(most: &str) =
            "çizim, bir ya da iki değerin ızgarasından, bütün parçalarıyla ve en çok {most} tasarımla yapılır";

        // What came of it.
        designs = "tasarım";
        file_of_other_study(file: &str, line: u64) =
            "{file} bu çalışmanın dosyası değil: {line}. satırı farklı. Baştan yazmak için --resume seçeneğini kaldırın";
        row_was_changed(file: &str, line: u64) =
            "{file} dosyasının {line}. satırı bu çalışmanın yazdığı değil: değiştirilmiş. Satırı geri getirin ya \
             da baştan yazmak için --resume seçeneğini kaldırın";
        file_goes_on(file: &str, done: u64, all: u64) = "{file} içinde {all} tasarımın {done} tanesi hazır";
        designs_left_out(open: u64, unreadable: u64, all: u64) =
            "{all} tasarımın {open} tanesi sahnedeki gibi kurulamıyor, {unreadable} tanesi bir sahne vermiyor: nedeni \
             satırlarında yazılı";
        no_design_has_figures(why: &str) = "hiçbir tasarımda bu büyüklükler yok: {why}";
        has_no_value_in_designs(figure: &str) = "{figure} hiçbir tasarımda değer almıyor";
        designs_from_to(figure: &str, least: [&str; 2], greatest: [&str; 2]) = {
            let ([least, low], [greatest, high]) = (least, greatest);
            format!("{figure}: en küçük {least}, {low} iken; en büyük {greatest}, {high} iken")
        };
        blank_is_no_design = "boş: değer yok";
        axes_of_map(up: &str, along: &str) = "yukarı: {up}; yana: {along}";

        // In the workbench.
        goal = "hedef";
        find_values_for_a_goal = "hedef için değer bul";
        goals_are_typed(value: &str) = "C.x.stroke = 120 by {value}";
        goal_not_met(nearest: &str, values: &str) =
            "yakında bunu karşılayan tasarım yok; en yakınında {nearest} ({values})";
        goal_is_met(values: &str) = "{values} karşılıyor";
        goal_needs_opening(why: &str) = {
            match why.is_empty() {
                true => "yakında söylenebilecek bir tasarım yok".to_owned(),
                false => format!("yakında söylenebilecek bir tasarım yok; bunda: {why}"),
            }
        };
        looking_for_designs(percent: u32) = "tasarımlar aranıyor: %{percent}";
        design_of(number: usize, count: usize, values: &str) = "{number}/{count}: {values}";
        moves_otherwise_as(motion: &str) = "başka türlü hareket ediyor: {motion}";
    }
}
