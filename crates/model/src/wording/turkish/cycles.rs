//! Quantities over the whole motion.

use super::Turkish;
use crate::wording::english::CyclesWords;

catalogue! {
    impl CyclesWords for Turkish {
        // Names.
        no_cycle_figure(name: &str, mend: &str) = "`{name}` adında bir döngü büyüklüğü yok{mend}";
        column_can_be_asked(list: &str) = "; bir sütun adının sonuna şunlardan biri yazılır: {list}";

        // Reasons for missing values.
        no_value_at(at: &str) = "{at} konumunda değeri yok";
        turns_round = "tam tur dönüyor";
        never_turns = "hiç geri dönmüyor";
        figure_stands = "hareket etmiyor";
        figure_rests = "uç değerinde bekliyor";
        figure_leaps = "bir uçtan öbürüne sıçrıyor";
        there_and_back_alike = "tahrik aynı yoldan gidip geliyor";
        driver_has_no_speed = "tahrikin hızı yok";
        driver_does_not_come_round = "tahrik tam tur dönmeden geri dönüyor";
        no_rate_known = "hızı bilinmiyor";
        rate_unbounded(at: &str) = "{at} yakınında sınırsız büyüyor";
        figure_jumps(at: &str) = "{at} konumunda sıçrıyor: formülündeki bir yön orada tam turu geçiyor";
        no_limit = "tahrik tam dönüyor";
        no_dyad = "bağlama açısı olan ikili grup yok";
        no_coupled_group = "yinelemeyle çözülen grup yok";
        motion_never_at(at: &str) = "hareket {at} konumuna ulaşmıyor";

        // The page.
        cycle_goes_round(speed: &str, range: &str) = "{range}; {speed} ile bir periyot";
        cycle_of_range(speed: &str, range: &str) = "{range}; {speed} ile bu aralık";
        cycle_leaves_motion_out =
            "hızlar ve süreler bu sabit hızdaki tahrik içindir, zamana göre hareketi için değil";
        nothing_to_follow =
            "sahnede izlenecek kızak, sarkaç ya da [figures] yok: --columns ile sütun adı verin";
        label_stroke = "strok";
        label_swing = "salınım";
        label_turns = "dönüşler";
        label_ratio = "zaman oranı";
        label_dwells = "bekler";
        label_fastest = "en hızlı";
        label_hardest = "en ivmeli";
        label_transmission = "açı";
        label_condition = "koşul";
        mechanism_as_a_whole = "mekanizma";
        stays_at(value: &str) = "{value} değerinde kalıyor";
        turns_round_times(times: &str) = "bir periyotta {times} kez tam dönüyor";
        turns_round_once = "bir periyotta bir kez tam dönüyor";
        value_at(value: &str, at: &str) = "{value}, {at}";
        peak_at(value: &str, at: &str) = "en büyük {value}, {at}";
        dip_at(value: &str, at: &str) = "en küçük {value}, {at}";
        peak_between(value: &str, from: &str, to: &str) = "en büyük {value}, {from} ile {to} arasında";
        dip_between(value: &str, from: &str, to: &str) = "en küçük {value}, {from} ile {to} arasında";
        limit_of_driver(turn: &str) = "{turn}; tahrik burada geri döner";
        slow_by_quick(ratio: &str, slow: &str, quick: &str, rises: bool) = {
            let (there, back) = if rises { ("artarken", "azalırken") } else { ("azalırken", "artarken") };
            format!("{ratio}: {there} {slow}, {back} {quick}")
        };
        way_there_and_back(way: &str) = "gidiş geliş {way}";
        stays_within(way: &str, from: &str, to: &str, tolerance: &str, of: &str) =
            "{way}: {from} ile {to} arasında; {of} değerine {tolerance} içinde";
        never_dwells = "yok";
        not_there(why: &str) = "yok: {why}";
        off_the_best(group: &str, off: &str, least: &str, at: &str) =
            "{group}: {least} deg, 90 dereceden {off} deg sapar, {at}";
        condition_at(group: &str, least: &str, at: &str) =
            "{group} grubu: en kötü yerde {least}, {at}";
    }
}
