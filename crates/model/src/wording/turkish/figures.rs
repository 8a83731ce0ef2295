//! Values in tables, their derivatives by lengths, and reasons for missing values.

use super::Turkish;
use crate::wording::english::FiguresWords;

catalogue! {
    impl FiguresWords for Turkish {
        // Reasons for values that are not shown.
        forces_disagree(at: &str, residual: &str, missed: &str, most: &str) =
            "{at} konumundaki kuvvetler gösterilmiyor: {residual} {missed}, ama yuvarlama en çok {most} \
             açıklar; iki yöntem uyuşmuyor, bu sahnenin değil krank'ın hatası: lütfen bildirin";
        forces_too_large(at: &str) =
            "{at} konumundaki kuvvetler gösterilmiyor: bazıları bir double değerine sığmıyor; daha küçük \
             hızlar, kütleler ve yükler kullanın";
        figure_too_large(figure: &str, at: &str) =
            "{figure}, {at} konumunda bir double değerine sığmıyor; daha küçük boylar ve hızlar kullanın";

        // Tables.
        vector = "vektör";
        point = "nokta";
        given = "verilen";
        position = "Konum";
        velocity = "Hız";
        acceleration = "İvme";
        of_points(figure: &str) = "{figure}, mafsal noktaları";
        direction = "yön";
        direction_r = "yön r";
        direction_v = "yön v";
        direction_a = "yön a";
        driver_at(driver: &str, at: &str, speed: &str, acceleration: &str) =
            "tahrik {driver}: {at}, {speed}, {acceleration}";
        state_is(state: &str) = "durum: {state}";
        stars_are_found = "* bulunan; yıldızsız olanlar verilen";
        bounds_are = "+- hata sınırı; ? kanıtlanmış sınır yok";

        // Derivatives by lengths.
        no_derivatives_by_lengths =
            "burada boylara göre türev yok: hareket burada biter ya da dallanır, ya da neredeyse öyle, ya da \
             yanlış bir boy mekanizmayı sıkıştırır";
        per(figure: &str, length: &str) = "{figure} / {length}";
        change_for_one(unit: &str) = "1 {unit} için değişim";
        change_for_length = "boydaki 1 için değişim";
        without_change(change: &str, why: &str) = "{change}: {why}";
        in_every_length = "bütün boylarda";
        in_one = "birinde";
        in_which = "hangisinde";
        most_in = "en çok";
    }
}
