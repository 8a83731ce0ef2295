//! The help of the command line: commands, options and values.

use super::Turkish;
use crate::wording::english::OptionsWords;

catalogue! {
    impl OptionsWords for Turkish {
        what_krank_is = "Düzlemsel mekanizmalar için terminalde bir çalışma tezgâhı";
        what_krank_does =
            "Düzlemsel mekanizmalar için terminalde bir çalışma tezgâhı: tek girişli her mekanizmanın konumu, hızı \
             ve ivmesi, yük varsa kuvvetleri; çizim ve tablolarla.";
        name_of_scene = "Bir dosya, hazır bir sahnenin adı ya da standart girdi için -";
        name_of_scene_or(usual: &str) =
            "Bir dosya, hazır bir sahnenin adı ya da standart girdi için - [yoksa: {usual}]";

        // Commands.
        does_list = "Hazır sahneleri listeleyin";
        does_check = "Sahneyi denetleyin ve tanıtın: parçalar, serbestlik, gruplar, aralık";
        does_table = "Bir açıdaki konum, hız ve ivme tablolarını, yük varsa kuvvetleri yazın";
        does_explain = "Bir açıdaki çözümü gösterin: döngüler, denklemler ve her ara değer";
        does_draw = "Mekanizmayı bir açıda çizin: karakterlerle, SVG ya da CAD için DXF olarak";
        does_sweep = "Değerleri tahrik açısı boyunca yazın, her konum bir satır";
        does_plot = "Değerlerin hareket boyunca grafiğini çizin: karakterlerle ya da SVG olarak";
        does_cycle = "Bütün hareketi özetleyin: strok, salınım, zaman oranı, bekleme, hız";
        does_import = "PMKS, PMKS+, Linkage, Pyslvs ya da pylinkage dosyasını sahneye çevirin";
        file_to_import = "Bir dosya, tırnak içinde bir adres ya da standart girdi için -";
        does_export = "Konumları kendi başına hesaplayan bir Python ya da MATLAB betiği yazın";
        does_study = "Birçok tasarımı hesaplayın: sayıların ızgarası ya da örneği, her biri bir satır";
        does_motor = "Motorun bir döngüdeki torkunu ya da kuvvetini ve koçun hareketini hesaplayın";
        does_tolerance =
            "Toleransların ve boşlukların etkisini hesaplayın: en kötü durum, karelerin toplamının karekökü, \
             örnekler, paylar";
        does_start = "Sahneyi başka bir montaj biçiminin [start] bölümüyle yazın";
        does_accuracy = "Bir sahnede her yöntemin süresini ve hatasını ölçün, tablo ve grafikle";
        does_config = "Başlangıç için bir ayar dosyası yazın: her anahtar, varsayılan değeriyle";
        does_help = "El kitabından bir konuyu ya da bir komutun yardımını gösterin, ya da bir sözcük arayın";
        does_completions = "Bir kabuk için tamamlama betiği yazın";
        does_man = "man sayfasını yazın";

        // Options and their values.
        language_to_speak = "Dil: ekranlar, tablolar, iletiler ve yardım";
        language_auto = "Ayar dosyasından ya da LC_ALL, LC_MESSAGES, LANG değişkenlerinden";
        language_turkish = "Türkçe";
        language_english = "İngilizce";
        decimal_of_csv = "CSV sayılarının ondalık işareti [yoksa: point]";
        decimal_point = "15.5";
        decimal_comma = "15,5; Türkçe hesap tablolarındaki gibi";
        separator_of_csv = "CSV hücrelerinin ayırıcısı [yoksa: comma; --decimal comma ile semicolon]";
        separator_comma = "Virgül";
        separator_semicolon = "Noktalı virgül";
        separator_tab = "Sekme";
        format_text = "Hizalı metin sütunları";
        format_csv = "Virgülle ayrılmış değerler";
        format_json = "Bir nesne";
        format_plain = "80 sütunluk düz metin";
        format_markdown = "Markdown";
        format_for_person = "Okunur metin";
        format_characters = "Karakterler";
        format_svg = "Ölçeklenebilir vektör grafiği, tarayıcı ya da rapor için";
        format_python = "Python 3, hiçbir paket gerekmez";
        format_matlab = "MATLAB ya da Octave";
        format_dxf = "CAD için çizim: her uzva bir katman, milimetre olarak";
        format_cast = "Renkli bir tur, asciinema kaydı";
        format_png = "Sunu için piksel resmi";
        format_gif = "Hareketli resim olarak bir tur";
        scale_on_paper = "SVG'nin basılacağı ölçek, 1:2 gibi [yoksa: ekrana uygun büyüklük]";
        scale_is_meant(most: f64) = "ölçek 1:2 ya da 5:1 gibi, 1:{most} ile {most}:1 arasında yazılır";
        width_in_pixels = "PNG ya da GIF için piksel olarak genişlik [yoksa: 1600, GIF için 800]";
        on_a_dark_ground = "SVG, PNG ya da GIF için koyu zemin, açık ekranlı okuyucular için de";
        seconds_of_turn = "cast ya da GIF içinde bir turun ya da gidiş dönüşün süresi, saniye olarak [yoksa: 6]";
        how_to_write = "Çıktı biçimi";
        format_of_output = "Çıktı biçimi; verilmezse çıktı dosyasının uzantısı seçer";
        columns_of_cycle =
            "İzlenecek sütunlar, adla ya da `ad = formül` ile, virgülle ayrılır; * joker karakterdir [yoksa: \
             sahnenin kendi büyüklükleri, kızaklar, şasedeki uzuvlar]";
        bounds_of_cycle = "Her strokun ve her dönüm noktasındaki değerin hata sınırını ekleyin";
        dwell_of_cycle = "Değerin bekliyor sayıldığı aralık, kendi biriminde [yoksa: strokun yüzde biri]";
        how_to_write_cycle = "Çıktı biçimi; CSV her değer ve özellik için bir satır verir";
        values_of_study =
            "Değişecek sayılar, virgülle ayrılır: AD=BAŞ..SON/SAYI, örneğin r3.length=280..320/9 [yoksa: 11 değer]";
        columns_of_study =
            "Bütün hareketin değerleri, virgülle ayrılır: C.x.stroke, r4.angle.swing, C.x@60, transmission; yönler \
             sahnedeki yönlerden ölçülür, bir turu aşsa da";
        designs_of_hypercube = "Izgara yerine N tasarımlık bir Latin hiperküpü kullanın";
        seed_of_hypercube = "Hiperküpün tohumu; aynı tohum aynı tasarımları verir";
        part_of_study = "Tasarımların n parçasından yalnız k. parça: 3/64";
        resume_study = "-o dosyasını kaldığı yerden sürdürün";
        threads_of_study = "İş parçacığı sayısı; satırlar buna bağlı değildir [yoksa: bütün çekirdekler]";
        how_to_write_study = "Çıktı biçimi; chart ve svg bir değeri eğrilerle, iki değeri haritayla çizer";
        format_chart = "Karakterlerle çizim";
        size_of_chart = "Çizimin sütun ve satır sayısı, örneğin 100x40";
        how_to_write_motor = "Çıktı biçimi; CSV döngüyü adım adım verir";
        digits_of_tables = "Metin tablolarında anlamlı hane sayısı; CSV ve JSON her zaman bütün haneleri içerir";
        digits = "Anlamlı hane sayısı";
        leave_units_out = "Birimleri yazmayın";
        add_bounds = "Her değere hata sınırını ekleyin; kanıtlanamayan sınır eklenmez";
        add_sensitivity = "Her değerin verilen boylara duyarlığını ekleyin: boyun bir birimi başına değişimi";
        first_row = "İlk satır [yoksa: hareket aralığının başı]";
        last_row = "Son satır, bir adım ona denk gelirse [yoksa: hareket aralığının sonu]";
        row_to_row = "Satırlar arasındaki adım, aşağı için negatif [yoksa: 1 deg; kızakta 100 ile 250 satır]";
        columns_of_table =
            "Yalnız bu sütunlar, her biri bir satır: adlar, * joker, ya da NAME = FORMULA; virgülle ayrılır";
        columns_or_all =
            "Sütun adları, * joker, ya da NAME = FORMULA; virgülle ayrılır [yoksa: bütün vektörler ve noktalar]";
        columns_of_tolerances =
            "Sütun adları, * joker, ya da NAME = FORMULA; virgülle ayrılır [yoksa: yerler ve yönler]";
        place_of_tolerances = "Yalnız bu konumda, paylar ve örneklerle [yoksa: hareket boyunca]";
        row_to_row_of_tolerances =
            "Satırlar arasındaki adım, aşağı için negatif [yoksa: 5 deg; kızakta 100 ile 250 satır]";
        tolerance_of_all =
            "Her boyun ve koordinatın toleransı, sahnedekinin yerine: 0.1, '0.004 in' ya da 'ISO 2768-m'";
        machines_by_chance =
            "Rastgele makine sayısı [yoksa: bir konumda 100000, bütün hareketin değerlerinde 2000, satırlarda hiç]";
        seed_of_samples = "Rastgele makinelerin tohumu; aynı tohum aynı makineleri verir";
        spread_of_lengths = "Boyların toleransları içindeki dağılımı";
        spread_choice_normal = "Normal; tolerans üç standart sapmadır";
        spread_choice_even = "Tolerans içinde düzgün dağılım";
        band_of_tolerances = "Her eğrinin tolerans bandını çizin";
        band_worst = "krank tolerance komutundaki gibi en kötü durum";
        band_root_sum_square = "Karelerin toplamının karekökü";
        columns_to_plot = "Sütun adları, * joker, ya da NAME = FORMULA; virgülle ayrılır";
        positions_to_compare = "360 deg ya da aralık boyunca konum sayısı, 360'ın katına yuvarlanır";
        topic_or_command = "Bir konu, bir komut ya da aranacak sözcükler [yoksa: konuları ve komutları listeler]";
        write_at_once = "Sayfalayıcı kullanmadan hepsini yazın";
        format_web = "El kitabı, web sitesi olarak: her konuya bir sayfa";
        folder_of_manual = "Web sitesinin klasörü; aynı adlı dosyaların yerine yenileri yazılır";
        place_of_driver = "Tahrik açısı deg olarak ya da tahrik kızağının konumu [yoksa: sahnenin açıldığı yer]";
        path_of_inputs =
            "Girişlerin koordinatlarını içeren CSV dosyası, uzvunun ya da kızağının adıyla her giriş için bir sütun, \
             ya da girişlerin izlediği noktaların koordinatlarını, örneğin `P.x,P.y`; her satır için bir satır yazar";
        input_that_moves =
            "Hareket eden giriş, uzvunun ya da kızağının adıyla; öteki girişler tutulur [yoksa: tahrik]";
        assembly_of_group =
            "Sahnenin açıldığı yerde bir grubun montaj biçimi, check çıktısındaki gibi; virgülle ayrılır";
        write_to_a_file = "Standart çıktı yerine dosyaya yazın, ya tam ya hiç";
        add_to_version = "--version ile: bu derlemenin özelliklerini, hedefini, profilini ve lisansını da yazın";
        the_shell = "Kabuk";
        command_of_page = "Sayfanın komutu [yoksa: krank'ın kendisi]";
        rated_effort = "Motorun anma torku, N m, ya da kuvveti, N";
        peak_effort = "Motorun tepe torku, N m, ya da kuvveti, N";
        motor_speed = "Motorun hızı, birimiyle: '1500 rpm', '0.2 m/s'";
        flywheel_on_shaft = "Tahrik milinde bir volan, kg m^2";
        wished_fluctuation = "İstenen hız dalgalanması: (en büyük - en küçük) / ortalama";
        slide_of_ram = "Koç olan kızak [yoksa: presi olan ya da tek olan]";
        height_of_ram = "Koçun alt noktasının üstünde bir yükseklik, sahnenin biriminde";
        effort_for_ram = "Koç kuvveti için tork, N m, ya da kuvvet, N [yoksa: anma değeri]";
        tolerance_of_rest = "Koçun alt noktadan ne kadar uzakta duruyor sayıldığı, sahnenin biriminde";
        there_and_back_from = "Tahrikin bu koordinatından gidip dönün [yoksa: bütün hareket]";
        there_and_back_to = "Bu koordinata; dönen tahrikte küçük değer bir tur ötededir";
        glyphs_as_allowed = "Yerel ayara ve terminale göre";
        glyphs_of_seven_bits = "7 bitlik karakterler";
        glyphs_of_boxes = "Çizgi karakterleri, konsol yazı tiplerinde de vardır";
        glyphs_of_braille = "Braille desenleri";
        glyphs_of_quadrants = "Çeyrek bloklar, çoğu yazı tipinde";
        glyphs_of_sextants = "Altılı bloklar, kimi yazı tipinde";
        glyphs_of_octants = "Sekizli bloklar, az yazı tipinde";
        trace_points = "Noktaların bütün hareketteki izlerini çizin; none, sahnenin adlandırdıklarını gizler";
        draw_velocities = "Hız oklarını çizin";
        draw_accelerations = "İvme oklarını çizin";
        draw_forces = "Yükleri, mafsal ve kılavuz kuvvetlerini büyüklükleriyle çizin";
        draw_ghosts = "Mekanizmayı hareketinin bu kadar konumunda gösterin";
        names_to_write = "Hangi adların yazılacağı";
        mark_centres = "Ağırlık merkezlerini işaretleyin";
        leave_guides_out = "Kılavuz ve mesnetleri çizmeyin";
        characters_to_draw_with = "Çizimde kullanılacak karakterler";
        size_of_drawing = "Boyutu; SVG'de bir karakter 8 x 16 birimdir [yoksa: terminalin boyutu ya da 80x24; SVG 100 geniş]";
        size_of_plot = "Boyutu; SVG'de bir karakter 8 x 16 birimdir [yoksa: terminalin boyutu ya da 80x24; SVG 100x40]";
        names_none = "Hiçbiri";
        names_of_points_alone = "Noktalar";
        names_all = "Noktalar ve uzuvlar";
        plot_against = "x ekseni: driver, time ya da bir sütunun adı";
        driver_begins = "Tahrikin ilk koordinatı [yoksa: hareket aralığının başı]";
        driver_ends = "Tahrikin son koordinatı [yoksa: hareket aralığının sonu]";
        leave_extrema_out = "En büyük ve en küçük değerleri işaretlemeyin";
        where_to_open = "Nerede açılacağı: tahrik uzvunun açısı deg ya da tahrik kızağının konumu";
        colours_to_draw_with = "Çizimde kullanılacak renkler";
        theme_to_draw_with = "Paletin renkleri [yoksa: auto]";
        way_of_pictures = "Durağan resimler için terminal protokolü [yoksa: auto]";
        pictures_as_told = "TERM, TERM_PROGRAM ya da KITTY_WINDOW_ID değerine göre";
        pictures_of_kitty = "kitty protokolü";
        pictures_of_iterm = "iTerm2 protokolü";
        pictures_of_sixels = "sixel";
        pictures_never = "Resim yok";
        view_to_open_with = "Açılışta gösterilecek görünüm";
        print_and_leave = "Açılış ekranını metin olarak yazın ve çıkın; terminal gerekmez";
        size_of_print = "Yazılan ekranın boyutu [yoksa: 80x24]";
        tell_of_terminal = "Terminalde ne algılandığını ve nedenini yazın";
        configuration_file = "Ayar dosyası [yoksa: ~/.config/krank/config.toml]";
        colours_as_allowed = "Terminale ve NO_COLOR değişkenine göre";
        colours_none = "Renksiz; kalın ve ters yazı kalır";
        colours_of_palette = "Terminalin 16 rengi";
        colours_fixed = "256 renklik sabit palet";
        colours_any = "24 bit renk";
        theme_auto = "Paletin kendi renkleri ya da her zeminde okunan renkler";
        theme_light = "Açık zemin için";
        theme_dark = "Koyu zemin için";
        theme_plain = "Renksiz";

        // Methods.
        method_of_positions = "Konumları bulan yöntem";
        method_closed = "Kapalı form, sonra hızlar, ivmeler ve kuvvetler";
        method_newton = "Vektörel konum denklemlerinde Newton-Raphson, yineleme yineleme";
        method_bisection = "Tek bilinmeyenin ikiye bölme yöntemiyle bulunması";
        method_graphical = "Pergel ve cetvel, adım adım";
        against_figures =
            "Karşılaştırılacak değerler, ders notundan ya da başka bir programdan: her satırda bir değer ya da \
             driver.angle boyunca sütunlar olan CSV";
        measured_figures =
            "Karşılaştırılacak ölçümler: driver.angle ya da driver.position boyunca her değere bir sütunu olan \
             CSV; adından sonra köşeli parantezde birimi";
        no_measurements(file: &str) =
            "`{file}` bu sütunların ölçümünü içermiyor: ilk satırda tahrikin koordinatını ve sütunları adlandırın, \
             her satıra sayılarını yazın";
        measured_over_driver = "ölçümler için x ekseni tahrik olmalı: `--against` seçeneğini kaldırın";
        holds_no_figures(file: &str) =
            "`{file}` içinde değer yok: `figure,unit,value` satırları ya da tahrikin sütunu olan bir başlık ve her \
             sütuna bir sayı yazın";
        too_many_figures(file: &str) = "`{file}` karşılaştırılamayacak kadar büyük";
        guess_of_vectors =
            "İlk tahmin: r3=20,r4=280, deg ya da sahnenin birimiyle; ikiye bölme için r3=0..90 [yoksa: açılış \
             konumunun bir taslağı]";
    }
}
