//! Forces: the driver, joints, guides and the frame.

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

        // Missing forces.
        driver_alone_has_value(effort: &str) =
            "Burada kuvvetlerden yalnız tahrikinki ({effort}) bellidir: değişim konumunda uzuvlar her \
             büyüklükte iç kuvvet taşıyabilir.";
        nothing_to_balance = "Mekanizma burada kurulamaz, bu yüzden kuvvet de yok.";
        no_effort_exists(effort: &str) =
            "Burada tahrikin değeri ({effort}) tanımsız: ölü konumda tahrik mekanizmayı hareket ettiremez, \
             kuvvetler sınırsız büyür.";
        indeterminate(reactions: &str) =
            "Belirsiz: {reactions}. Mekanizmada fazla kısıtlar var, bunlar birbirine herhangi bir kuvvetle etki \
             edebilir; öteki bütün değerler geçerli.";
        indeterminate_with_least(reactions: &str) =
            "Belirsiz: {reactions}. Mekanizmada fazla kısıtlar var, bunlar birbirine herhangi bir kuvvetle etki \
             edebilir; öteki bütün değerler geçerli. En küçük norm: bütün pimler ve kılavuzlar eşit esnek \
             olsaydı çıkacak tepki kuvvetleri.";
    }
}
