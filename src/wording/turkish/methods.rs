//! Methods that could solve a scene: speed against error.

use super::Turkish;
use crate::wording::english::MethodsWords;
use std::fmt::Display;

catalogue! {
    impl MethodsWords for Turkish {
        // The methods.
        method = "yöntem";
        closed_and_polished = "kapalı, inceltilmiş";
        newton_from_anchors = "Newton, dayanaktan";
        with_bounds = "sınırlarla";
        single_precision = "tek hassasiyet";
        newton_warm(tolerance: f64) = "Newton {tolerance:e} sıcak";
        newton_cold(tolerance: f64) = "Newton {tolerance:e} soğuk";
        bisection = "ikiye bölme";
        runge_kutta(steps: &dyn Display, turns: &dyn Display) = "RK4 {steps} x {turns}";

        // Why one cannot be used.
        a_group = "bir grup";
        the_group_at(point: &str) = "{point} noktasındaki grup";
        has_no_closed_form(group: &str) = "{group}: kapalı formu yok";
        not_needed = "gerekmez: her grubun kapalı formu var";
        closes_by_conditions(group: &str, count: usize) = "{group} aynı anda {count} koşulla kapanır";
        cannot_turn_fully = "tahrikin sınırları var, tam dönemez";
        gives_no_rows = "bir grubun kısıtları kendi satırlarını vermiyor";
        not_measured = "ölçülmedi";

        // Figures.
        positions_over_cycle(positions: &dyn Display, longest: &str, unit: &str) =
            "döngü boyunca {positions} konum; en uzun boy {longest} {unit}";
        time = "süre";
        quartiles = "çeyrekler";
        error_of_positions = "kon";
        error_of_velocities = "hız";
        error_of_accelerations = "ivm";
        failures = "başarısız";

        // How they are meant.
        of_time_is =
            "hızları ve ivmeleriyle bir konumun süresi: ortanca, bir de bütün örneklerin yarısının \
             arasında kaldığı değerler; RK4 için bir adımın";
        errors_of_three = "kon hız ivm";
        errors_are =
            "iki kat hassasiyetli hesaba göre en büyük hatalar: noktaların, en uzun boya ve döngünün \
             en büyük hız ve ivmesine oranla";
        failures_are =
            "hiçbir şeyin ya da başka bir montaj biçiminin bulunduğu konumlar; hataya katılmazlar";
        best_are = "en iyi sınır: hiç başarısız olmaz, böyle başka hiçbir yöntem hem daha hızlı hem daha yakın değil";
        with_bounds_is =
            "krank'ın çözdüğü gibi, her değerin kanıtlı hata sınırıyla; sınır kanıtlanamazsa başarısız";
        warm_or_cold = "sıcak, soğuk";
        warm_or_cold_is =
            "Newton yöntemi bir derece ya da aralığın 360'ta biri ötedeki önceki konumdan ya da \
             sahnenin açıldığı yerden başlar; radyan ve en uzun boyun payı olarak adımı toleransın \
             altına inince biter";
        runge_kutta_n_by_m = "RK4 n x m";
        runge_kutta_is =
            "hızların Runge-Kutta ile integrali, 360 deg içinde n adım, m numaralı döngüde bakılır";
    }
}
