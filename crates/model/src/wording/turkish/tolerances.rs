//! Effects of tolerances.

use super::Turkish;
use crate::wording::english::TolerancesWords;

catalogue! {
    impl TolerancesWords for Turkish {
        no_tolerances = "sahnedeki her boy tam: boylar için `tolerance`, pimler için `clearance` verin";
        or_say_tolerance = "ya da burada: --tolerance 0.1";
        redundant_jams = "mekanizma fazla kısıtlı: bir boyun sapması onu sıkıştırır, hiçbir değer hesaplanamaz";
        no_tolerances_of_forces = "toleranslar hareketin değerlerine uygulanır, kuvvetlere değil: bunları çıkarın";

        // Effects.
        within_tolerances = "toleranslar içinde";
        label_worst_case = "en kötü durum";
        range_and_off(low: &str, high: &str, below: &str, above: &str) =
            "{low} ile {high} arası ({below}, {above})";
        worst_by_corners = "toleransların bütün köşeleri çözüldü";
        worst_enclosed = "kuşatıldı: hiçbir makine dışarıda kalmaz; gerçek en kötü durum daha küçük olabilir";
        worst_reached(low: &str, high: &str, below: &str, above: &str) =
            "ulaşıldığı kanıtlı: {low} ile {high} arası ({below}, {above})";
        worst_searched = "tahmin: bir boyla monoton değil, bu yüzden toleransların içi de arandı; kanıtlanmadı";
        worst_at_edge = "tahmin: değerin var olduğu sınıra kadar arandı; kanıtlanmadı";
        worst_unbounded = "toleranslar içindeki bir montaj sınırına doğru sınırsız büyüyor";
        no_worst_case(why: &str) = "yok: {why}";
        worst_at_least(low: &str, below: &str) = "en az {low} ({below})";
        worst_above(why: &str) = "en büyük: yok: {why}";
        worst_at_most(high: &str, above: &str) = "en çok {high} ({above})";
        worst_below(why: &str) = "en küçük: yok: {why}";
        worst_beside_unbounded = "öteki uç tahmin: sınır boyunca arandı; kanıtlanmadı";
        worst_by_derivatives = "tahmin: türevlerin gösterdiği köşede çözüldü; kanıtlanmadı";
        worst_sampled = "tahmin: bir örnek çözülen değerleri aşıyor; kanıtlanmadı";
        worst_does_not_close = "kapanan makineler için; hepsi kapanmıyor";
        label_root_sum_square = "kareler karekökü";
        no_first_order = "yok: burada türev yok";
        label_most_samples = "örneklerin % 99.73'ü";
        spread_of_samples(low: &str, high: &str) = "{low} ile {high} arası";
        mean_and_deviation(mean: &str, deviation: &str) =
            "ortalama {mean}, standart sapma {deviation}";
        label_contributions = "kaynağı";
        head_tolerance = "tolerans";
        head_per_unit = "birim başına";
        head_off_by = "sapma";
        head_share = "pay";
        label_samples = "örnekler";
        how_samples_are_made(count: u32, spread: &str, seed: u64) =
            "{count} makine, boylar {spread}, tohum {seed}";
        spread_normally = "normal dağılmış (tolerans üç standart sapma)";
        spread_evenly = "düzgün dağılmış";
        samples_all_close = "hepsi burada kapanıyor";
        part_of_samples_open(part: &str) = "{part} kadarı burada kapanmıyor";
        samples_keep_class = "hepsi ilk döngünün sınıfını koruyor";
        part_of_samples_changed(part: &str) = "{part} kadarında ilk döngünün sınıfı değişiyor";
        rows_estimated(some: u64, rows: u64) =
            "{rows} satırdan {some} tanesinde en kötü durum tahmin, kanıtlanmadı: worst.by sütununa bakın";
        rows_that_may_not_close(some: u64, rows: u64) =
            "{rows} satırdan {some} tanesinde toleransı içindeki her makine kapanmıyor; en kötü \
             durum kapananlarınki";

        no_figure_in_line = "bu satırda değer yok: / ile bulun";

        // Tolerances in a scene.
        tolerance_of_point(name: &str) = "{name} noktasının toleransı";
        clearance_of_pin(name: &str) = "{name} piminin boşluğu";
        no_general_tolerance(what: &str, text: &str) =
            "{what} bir sayı ya da bir ISO 2768-1 sınıfı olmalı, oysa {text}";
        unknown_general_tolerance = "bilinmeyen sınıf";
        known_general_tolerances(list: &str) = "sınıflar: {list}";
        nought_is_exact = "iki yana da uygulanır; 0 tam demektir";
        frame_has_no_tolerance(name: &str) =
            "{name} uzvu şasenin kendisi, ona ayrı tolerans verilmez";
        is_of_the_frame = "şasenin";
        give_ground_points_tolerances = "sabit noktalarının toleranslarını [tolerances] içinde verin";
        guide_has_no_tolerance(of: &str) = "{of} adı verilen bir noktadan geçiyor: sapabilecek koordinatı yok";
        nothing_to_be_off = "sapacak bir şey yok";
        give_point_of_guide_tolerance = "o noktanın toleransını [tolerances] içinde verin";
        point_has_no_coordinates(what: &str) =
            "{what}: nokta yalnız uzuvların ucu, kendi koordinatı yok";
        give_link_a_tolerance = "boyu orada biten uzva `tolerance` verin";
        tolerance_beyond_length(what: &str, length: f64, literal: &str) =
            "tolerans ({what}) boydan, {length} değerinden, küçük olmalı, oysa {literal}";
        no_deviation_of_size(class: &str, what: &str, size: f64, sizes: &str) =
            "{class} sınıfında {size} mm için değer yok ({what}): {sizes} geçerli";
        sizes_from_to(low: f64, high: f64) = "{low} ile {high} mm arasında";
        sizes_over_to(low: f64, high: f64) = "{low} mm'den büyük, en çok {high} mm";
        of_this_length = "bu boy için";
        by_this_class = "bu sınıfla";
        give_it_its_own_tolerance = "ona kendi toleransını verin";
        clearance_beyond_length(what: &str, of: &str, length: f64, literal: &str) =
            "{what} yanındaki boydan ({of}), {length} değerinden, küçük olmalı, oysa {literal}";
        give_it_its_own_clearance = "pime [clearances] içinde kendi boşluğunu verin";
        is_no_pin(what: &str) = "{what}: nokta hiçbir şeyi birleştirmiyor";
        joins_nothing = "pim değil";
        pins_join = "bir pim iki uzvu, ya da bir uzvu şaseyle veya bir yarıkla birleştirir";
        over_the_whole_motion = "bütün hareket boyunca";
        whole_has_no_place =
            "bütün hareketin değerlerinin koordinatı yoktur: --at, --from, --to ve --step seçeneklerini çıkarın";
        beside_whole_say_where(name: &str) =
            "{name} bütün hareketin değerleriyle birlikte: koordinatını --at ile verin ya da {name}@60 yazın";
    }
}
