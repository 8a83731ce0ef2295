//! The manual's topics. Their texts are documents of their own, in English.

use super::Turkish;
use crate::wording::english::ManualWords;

catalogue! {
    impl ManualWords for Turkish {
        about_tutorial = "boş dosyadan altı uzuvlu mekanizmaya (İngilizce)";
        about_scene = "sahne dosyası: bir örnek ve her anahtar (İngilizce)";
        about_views = "tezgâhın gösterdikleri, görünüm görünüm (İngilizce)";
        about_keys = "tezgâhın her tuşu ve başkasını seçmek (İngilizce)";
        about_columns = "adlarıyla büyüklükler: birim, sınır, duyarlık, aralık (İngilizce)";
        about_forces = "etki edenler, mafsallar, motorun yapması gereken (İngilizce)";
        about_drawings = "terminal ve rapor için çizimler ve grafikler (İngilizce)";
        about_files = "ne zaman ne yazılır, değişiklikler, çıkış kodları, ödevler (İngilizce)";
        about_trust = "montajlar, uçlar, sınırlar: verilen sözler ve denenmesi (İngilizce)";
        about_terminals = "karakterler, renkler, yavaş hatlar, bir karenin bedeli (İngilizce)";
        about_limits = "krank'ın yapmadıkları, yanıtlarının bittiği yer (İngilizce)";
    }
}
