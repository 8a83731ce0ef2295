//! The manual's topics. Their texts are documents of their own.

use super::Turkish;
use crate::wording::english::ManualWords;

catalogue! {
    impl ManualWords for Turkish {
        topic_told(about: &str, turkish: &str) = "{about} ({turkish})";
        about_tutorial = "boş dosyadan altı uzuvlu mekanizmaya";
        about_how = "nasıl ...? komutu ya da tuşuyla otuz soru";
        about_scene = "sahne dosyası: bir örnek ve her anahtar";
        about_views = "tezgâhın gösterdikleri, görünüm görünüm";
        about_keys = "tezgâhın her tuşu ve başkasını seçmek";
        about_columns = "adlarıyla büyüklükler: birim, sınır, duyarlık, aralık";
        about_designs = "bir sahnenin birçok tasarımı: ızgara, örnek, çizim, uzun çalışma";
        about_synthesis = "istenen bir hareketten mekanizmalara: görevler, dilekler, kusurlar";
        about_forces = "etki edenler, mafsallar, motorun yapması gereken";
        about_tolerances = "sapan boyların ve boşluklu pimlerin etkisi";
        about_drawings = "terminal ve rapor için çizimler ve grafikler";
        about_files = "ne zaman ne yazılır, değişiklikler, çıkış kodları, ödevler";
        about_trust = "montajlar, uçlar, sınırlar: verilen sözler ve denenmesi";
        about_terminals = "karakterler, renkler, yavaş hatlar, bir karenin bedeli";
        about_limits = "krank'ın yapmadıkları, yanıtlarının bittiği yer";
        about_glossary = "mekanizmaların ve krank'ın terimleri";
    }
}
