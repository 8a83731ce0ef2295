//! Forces: what the driver must do, and what joints, guides and the frame bear.

use super::Turkish;
use crate::wording::english::ForcesWords;

catalogue! {
    impl ForcesWords for Turkish {
        // Titles and columns.
        driver = "tahrik";
        driver_named(name: &str) = "tahrik {name}";
        in_all = "toplam";
        loads = "yükler";
        inertia = "atalet";
        power = "güç";
        force_at_joints = "mafsal kuvvetleri";
        force_of_guides = "kılavuz kuvvetleri";
        of_least_norm = "en küçük norm";
        on_the_frame = "şasede";
        shaking = "sarsma";
        checks_miss_by = "sağlama artıkları";
        normal = "normal";
        at = "yer";
        link_at_point(link: &str, point: &str) = "{link}, {point}";
        link_at_point_by(link: &str, point: &str, by: &str) = "{link}, {point} ({by})";
        guide_on(guide: &str, slider: &str) = "{guide} -> {slider}";

        // What is missing.
        driver_alone_has_value(effort: &str) =
            "Burada kuvvetlerden yalnız tahrikin değeri var ({effort}): değişim konumunda uzuvlar öyle \
             durur ki aralarında herhangi bir kuvvet dolaşabilir.";
        nothing_to_balance = "Mekanizma burada olamaz: dengelenecek bir şey yok.";
        no_effort_exists(effort: &str) =
            "Burada tahrikin değeri yok ({effort}): ölü konumda mekanizmayı hareket ettiremez, onu \
             tutacak olan, mafsallarda da, bütün sınırların ötesinde büyür.";
        indeterminate(reactions: &str) =
            "Belirsiz: {reactions}. Mekanizmada gerekenden çok kısıt var, bunlar birbirine herhangi bir \
             kuvvetle basabilir; öteki bütün değerler geçerli.";
        indeterminate_with_least(reactions: &str) =
            "Belirsiz: {reactions}. Mekanizmada gerekenden çok kısıt var, bunlar birbirine herhangi bir \
             kuvvetle basabilir; öteki bütün değerler geçerli. En küçük norm: bütün pimler ve kılavuzlar \
             aynı ölçüde esneseydi ne olurlardı.";
    }
}
