//! One-line descriptions of the manual's topics; the texts are separate documents.

use super::Turkish;
use crate::wording::english::ManualWords;

catalogue! {
    impl ManualWords for Turkish {
        topic_told(about: &str, turkish: &str) = "{about} ({turkish})";
        about_tutorial = "boş dosyadan altı çubuk mekanizmasına";
        about_how = "nasıl ...? komutu ya da tuşuyla otuz soru";
        about_scene = "sahne dosyası: bir örnek ve bütün anahtarlar";
        about_views = "tezgâhın gösterdikleri, görünüm görünüm";
        about_keys = "tezgâhın bütün tuşları ve değiştirilmesi";
        about_columns = "adlı büyüklükler: birim, sınır, duyarlık, aralık";
        about_designs = "bir sahnenin birçok tasarımı: ızgara, örnek, çizim, uzun çalışma";
        about_synthesis = "istenen hareket için mekanizmalar: görevler, tercihler, kusurlar";
        about_forces = "yükler, mafsal kuvvetleri, motorun torku";
        about_tolerances = "boy toleransları ile pim boşluklarının etkisi";
        about_drawings = "terminal ve rapor için çizimler ve grafikler";
        about_import = "PMKS, PMKS+, Linkage, Pyslvs ve pylinkage dosyaları";
        about_files = "kaydetme, değişiklikler, çıkış kodları, ödevler";
        about_trust = "montajlar, uçlar, sınırlar: güvenceler ve sınamalar";
        about_terminals = "karakterler, renkler, yavaş hatlar, kare maliyeti";
        about_limits = "krank'ın yapamadıkları ve sonuçlarının sınırı";
        about_glossary = "mekanizmaların ve krank'ın terimleri";
    }
}
