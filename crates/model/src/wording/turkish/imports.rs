//! Başka programların dosyalarından yapılan sahnelerin açıklamaları ve notları.

use super::Turkish;
use crate::wording::english::ImportsWords;

catalogue! {
    impl ImportsWords for Turkish {
        // Sahnenin açıklamaları.
        import_about(program: &str) = "{program} programının bir dosyasından alındı. Sahne çizimin konumunda açılır.";
        import_a_file(program: &str, file: &str) = "{program}, {file}";
        import_an_address(program: &str) = "{program}, bir internet adresi";
        import_no_unit = "dosyada birim yok";
        import_start = "çizim";
        import_ratios = "tahrikin birimi başına, dosyadaki hızlara göre";

        // Dosyadaki yerler.
        import_line(line: usize) = "satır {line}";
        import_element(line: u32, element: &str) = "satır {line}, {element}";
        import_line_joint(line: usize, joint: usize) = "satır {line}, mafsal {joint}";
        import_joint_row(row: usize) = "`j` içinde mafsal {row}";
        import_link_row(row: usize) = "`l` içinde uzuv {row}";
        import_force_row(row: usize) = "`f` içinde kuvvet {row}";

        // Okunamayan dosyalar.
        import_scene_made_from(file: &str) = "{file} dosyasından kurulan sahne";
        import_failed(file: &str, why: &str) = "`{file}`: {why}";
        import_unknown_format =
            "bu bir PMKS, PMKS+, Linkage, Pyslvs ya da pylinkage dosyası değil; `krank help import` bunları anlatır";
        import_packed(version: &str) = {
            let of_version = match version {
                "" => String::new(),
                version => format!(", sürüm {version}"),
            };
            format!(
                "bu PMKS+ adresi paketlenmiş{of_version}; krank yalnızca `j=` ve `l=` içeren adresleri okur; \
                 mafsalları PMKS satırları olarak yazın"
            )
        };
        import_xml(why: &str) = "XML geçersiz: {why}";
        import_json(why: &str) = "JSON geçersiz: {why}";
        import_other_json = "bu JSON bir pylinkage mekanizması değil: `joints` ve `links` listeleri yok";
        import_older_pylinkage = "bu, kısıtları saklayan eski pylinkage JSON'u; onu `Mechanism` olarak kaydedin";
        import_brackets(line: usize) = "satır {line}: ifadenin köşeli ayraçları eşleşmiyor";
        import_no_joints = "dosyada koordinatı olan bir mafsal yok";
        import_too_large(most: usize) = "dosya çok büyük: krank en çok {most} mafsal, {most} uzuv ve 1 MiB alır";

        // Alınmayan parçalar.
        import_not_as_drawn = "sahne açılıyor, ama çizimin konumunda değil: dosya kendiyle çelişiyor";
        import_more_remarks(more: usize) = "{more} not daha gösterilmiyor";
        import_renamed(name: &str, valid: &str) = "`{name}` burada `{valid}` adını taşır";
        import_not_a_joint = "uzuvları, türü ve koordinatları olan bir mafsal değil; alınmadı";
        import_joint_without_links = "mafsalın uzvu yok; alınmadı";
        import_other_addresses = "dosyada başka adresler de var; yalnızca ilki okunur";
        import_gears = "krank dişlileri modellemez; alınmadı";
        import_chain = "krank kayış ve zincirleri modellemez; alınmadı";
        import_slider_of_many = "bir kayar mafsal iki uzvu birleştirir; ötekiler alınmadı";
        import_slider_on_frame = "kayar mafsal sabit bir uzuv adlandırmıyor; kılavuzu şasededir";
        import_input_of_one_link = "giriş iki uzvu birleştirmiyor; alınmadı";
        import_second_input = "dosyada daha önce başka bir giriş var; alınmadı";
        import_first_joint = "dosya bir giriş göstermiyor; bu, şasedeki ilk mafsaldır ve tahrik olur";
        import_no_input = "dosyada giriş yok: sahneye [driver] ekleyin";
        import_link_without_joints(link: &str) = "hiçbir mafsalda `{link}` uzvu yok; alınmadı";
        import_unknown_joint(joint: &str) = "`{joint}` diye bir mafsal yok; alınmadı";
        import_not_a_force = "bir uzva etkiyen kuvvet değil; alınmadı";
        import_not_a_link = "kimliği ve mafsalları olan bir uzuv değil; alınmadı";
        import_unknown_kind(kind: &str) = "bilinmeyen tür `{kind}`; alınmadı";
        import_not_a_connector = "bağlantının kimliği ya da koordinatları yok; alınmadı";
        import_same_id = "bu kimlik başka bir öğenin, ya da kimlik yok; alınmadı";
        import_no_such_connector = "bu kimlikte bir bağlantı yok; alınmadı";
        import_input_not_fixed = "giriş sabit bir nokta değil; alınmadı";
        import_input_turns_nothing = "giriş hiçbir uzvu döndürmüyor; alınmadı";
        import_input_is_fixed = "giriş sabit bir uzvu döndürüyor; alınmadı";
        import_input_twice = "başka bir giriş aynı uzvu hareket ettiriyor; alınmadı";
        import_input_is_held = "giriş, tahrike göre sabit bir oranda hareket etmiyor; çizildiği yerde durur, oranı 0";
        import_same_speed = "dosyada hız yok; giriş tahrik kadar hızlı döner";
        import_actuator_of_two = "bir eyleyicinin iki bağlantısı olur; rijit uzuv olarak okundu";
        import_actuator_is_fixed = "eyleyicinin iki ucu da sabit ya da aynı yerde; rijit uzuv olarak okundu";
        import_stroke_too_long = "eyleyici kendi boyundan daha çok kısalırdı";
        import_fastened_to_nothing = "var olmayan bir uzva bağlanmış; alınmadı";
        import_fastened_to_connector = "giriş olmayan bir bağlantıya bağlanmış; alınmadı";
        import_slot_without_ends = "yarığın iki ucu yok; alınmadı";
        import_slot_on_nothing = "yarığın iki ucu aynı uzuvda değil; alınmadı";
        import_pin_beside_arc(off: f64) = "pim yayın {off:.3} yanına çizilmiş; sahne çizime uyar";
        import_pin_beside_slot(name: &str, off: f64) = "`{name}` yarığın {off:.3} yanına çizilmiş; sahne çizime uyar";
        import_slide_is_fixed(name: &str) = "`{name}` bağlı olduğu bir parça üzerinde kayıyor; alınmadı";
        import_link_of_one_point(name: &str) =
            "`{name}` uzvunun tek noktası var ve hiçbir şeyi hareket ettirmez; alınmadı";
    }
}
