//! The help of the command line: commands, options and their values.

use super::Turkish;
use crate::wording::english::OptionsWords;

catalogue! {
    impl OptionsWords for Turkish {
        what_krank_is = "Düzlemsel mekanizmalar için terminalde bir çalışma tezgâhı";
        what_krank_does =
            "Düzlemsel mekanizmalar için terminalde bir çalışma tezgâhı: tek girişli herhangi bir \
             mekanizmanın konumu, hızı ve ivmesi, bir şey etki ediyorsa kuvvetleri; çizimle ve \
             tablolarla.";
        name_of_scene = "Bir dosya, hazır bir sahnenin adı ya da standart girdi için -";
        name_of_scene_or(usual: &str) =
            "Bir dosya, hazır bir sahnenin adı ya da standart girdi için - [yoksa: {usual}]";

        // Commands.
        does_list = "Hazır sahneleri say";
        does_check = "krank'ın bir sahneden anladığını söyle: parçalar, serbestlik, gruplar, aralık";
        does_table = "Bir açıdaki konum, hız ve ivme tablolarını, bir şey etki ediyorsa kuvvetleri yaz";
        does_explain = "Çözümü göster: döngüler, denklemler ve bir açının tablolarına giden her değer";
        does_draw = "Mekanizmayı bir açıda çiz: karakterlerle, SVG ya da CAD için DXF olarak";
        does_sweep = "Büyüklükleri tahrik açısı boyunca satır satır yaz";
        does_plot = "Büyüklüklerin hareket boyunca grafiğini çiz: karakterlerle ya da SVG olarak";
        does_cycle = "Büyüklüklerin bütün hareket boyunca yaptığı: strok, salınım, zaman oranı, bekleme, hız";
        does_export = "Konumları kendi başına hesaplayan bir Python ya da MATLAB betiği yaz";
        does_study = "Birçok tasarımın büyüklüklerini yaz: sayıların ızgarası ya da örneği, her biri bir satır";
        does_motor = "Bir sahnenin bir döngüde motordan istediği ve bir koçun yaptığı";
        does_tolerance = "Sapan boyların ve boşluklu pimlerin etkisi: en kötü durum, karelerin toplamının karekökü, örnekler, paylar";
        does_start = "Sahneyi başka bir montaj biçiminin [start] bölümüyle yaz";
        does_accuracy = "Süreye karşı hatayı ölç: sahneyi çözebilecek her yöntem, tablo ve grafikte";
        does_config = "Başlangıç için bir ayar dosyası yaz: her anahtar ve yerleşik değeri";
        does_help = "El kitabından bir konuyu ya da bir komutun yardımını oku";
        does_completions = "Bir kabuk için tamamlama betiği yaz";
        does_man = "man sayfasını yaz";

        // Options and their values.
        language_to_speak = "Dil: ekranlar, tablolar, iletiler ve yardım";
        language_auto = "Ayar dosyası ya da LC_ALL, LC_MESSAGES, LANG ne diyorsa";
        language_turkish = "Türkçe";
        language_english = "İngilizce";
        decimal_of_csv = "CSV sayılarının ondalık işareti [yoksa: point]";
        decimal_point = "15.5";
        decimal_comma = "15,5; Türkçe hesap tablolarındaki gibi";
        separator_of_csv = "CSV hücrelerinin arasında ne olduğu [yoksa: comma; --decimal comma ile semicolon]";
        separator_comma = "Virgül";
        separator_semicolon = "Noktalı virgül";
        separator_tab = "Sekme";
        format_text = "Okunacak hizalı sütunlar";
        format_csv = "Ayraçlı değerler";
        format_json = "Bir nesne";
        format_plain = "80 sütunluk düz metin";
        format_markdown = "Markdown";
        format_for_person = "Okumak için";
        format_characters = "Karakterler";
        format_svg = "Ölçeklenebilir vektör grafiği, tarayıcı ya da rapor için";
        format_python = "Python 3, hiçbir paket gerekmez";
        format_matlab = "MATLAB ya da Octave";
        format_dxf = "CAD için çizim: her uzva bir katman, milimetre olarak";
        format_cast = "Renkli bir tur, asciinema oynatır";
        format_png = "Pikseller, bir sunu için";
        format_gif = "Piksellerle bir tur";
        scale_on_paper = "SVG'nin basılacağı ölçek, 1:2 gibi [yoksa: ekrana uygun büyüklük]";
        scale_is_meant(most: f64) = "ölçek 1:2 ya da 5:1 gibi, 1:{most} ile {most}:1 arasında yazılır";
        width_in_pixels = "PNG ya da GIF için piksel olarak genişlik [yoksa: 1600, GIF için 800]";
        on_a_dark_ground = "Okuyan ne isterse istesin koyu zeminde SVG, PNG ya da GIF";
        seconds_of_turn = "cast ya da GIF içinde bir turun ya da gidiş dönüşün süresi [yoksa: 6]";
        how_to_write = "Nasıl yazılacağı";
        columns_of_cycle = "İzlenecek büyüklükler, adla ya da `ad = formül` ile, virgülle ayrılmış; * herhangi karakterler [yoksa: sahnenin kendi büyüklükleri, kızaklar, şasedeki uzuvlar]";
        bounds_of_cycle = "Her strokun ve büyüklüğün döndüğü her yerdeki değerin hatasının aşmadığı sınırı ekler";
        dwell_of_cycle = "Bir büyüklüğün ne kadar içinde duruyor sayıldığı, kendi biriminde [yoksa: strokun yüzde biri]";
        how_to_write_cycle = "Nasıl yazılacağı; CSV her büyüklük ve özellik için bir satır verir";
        values_of_study = "Değişen sayılar, virgülle ayrılmış: AD=BAŞ..SON/YER, örneğin r3.length=280..320/9 [yoksa: 11 yer]";
        columns_of_study = "Bütün hareketin büyüklükleri, virgülle ayrılmış: C.x.stroke, r4.angle.swing, C.x@60, transmission; yönler sahnenin kendi yönlerinden sayılır, bir turu aşsa da";
        designs_of_hypercube = "Izgara yerine bir Latin hiperküpünün N tasarımı";
        seed_of_hypercube = "Hiperküpün tohumu; aynı tohum aynı tasarımları verir";
        part_of_study = "Tasarımların n parçasından yalnız k'inci: 3/64";
        resume_study = "-o dosyasını kaldığı yerden sürdür";
        threads_of_study = "Kaç iş parçacığının çalışacağı; satırlar her sayıyla aynıdır [yoksa: bütün çekirdekler]";
        how_to_write_study = "Nasıl yazılacağı; chart ve svg bir değeri eğrilerle, iki değeri haritayla çizer";
        format_chart = "Karakterlerle çizim";
        size_of_chart = "Çizimin sütun ve satır sayısı, örneğin 100x40";
        how_to_write_motor = "Nasıl yazılacağı; CSV döngüyü adım adım verir";
        digits_of_tables = "Metin tablolarında anlamlı hane sayısı; CSV ve JSON hep hepsini taşır";
        digits = "Anlamlı hane sayısı";
        leave_units_out = "Birimleri yazma";
        add_bounds = "Her değerin hatasının aşmadığı sınırı ekle; kanıtlanamayana bir şey eklenmez";
        add_sensitivity = "Verilen boyların her değere etkisini ekle: bir birimlik boyda ne kadar değişir";
        first_row = "İlk satır [yoksa: hareket aralığının başı]";
        last_row = "Son satır, adım ona denk gelirse [yoksa: hareket aralığının sonu]";
        row_to_row = "Satırdan satıra, aşağı için eksi [yoksa: 1 deg; kızakta 100 ile 250 satır]";
        columns_of_table = "Yalnız bu büyüklükler, her biri bir satır: adlar, * her karakter yerine, ya da NAME = FORMULA; virgülle ayrılır";
        columns_or_all = "Büyüklüklerin adları, * her karakter yerine, ya da NAME = FORMULA; virgülle ayrılır [yoksa: bütün vektörler ve noktalar]";
        columns_of_tolerances = "Büyüklüklerin adları, * her karakter yerine, ya da NAME = FORMULA; virgülle ayrılır [yoksa: yerler ve yönler]";
        place_of_tolerances = "Yalnız bu konumda, paylar ve örneklerle [yoksa: hareket boyunca]";
        row_to_row_of_tolerances = "Satırdan satıra, aşağı için eksi [yoksa: 5 deg; kızakta 100 ile 250 satır]";
        tolerance_of_all = "Her boyun ve koordinatın ne kadar sapabileceği, sahnenin dediğinin yerine: 0.1, '0.004 in' ya da 'ISO 2768-m'";
        machines_by_chance = "Rastgele kaç makine yapılacağı [yoksa: bir konumda 100000, bütün hareketin büyüklüklerinde 2000, satırlarda hiç]";
        seed_of_samples = "Hangi makineler: aynı tohum aynı makineleri verir";
        spread_of_lengths = "Boyların toleransları içinde nasıl dağıldığı";
        spread_choice_normal = "Normal; tolerans üç standart sapmadır";
        spread_choice_even = "Tolerans içindeki her boy eşit olasılıkla";
        band_of_tolerances = "Her eğrinin yanında, sahnenin toleranslarıyla ne kadar sapabileceğini çiz";
        band_worst = "krank tolerance komutunun bulduğu en kötü durum";
        band_root_sum_square = "Karelerin toplamının karekökü";
        columns_to_plot = "Büyüklüklerin adları, * her karakter yerine; virgülle ayrılır";
        positions_to_compare = "Karşılaştırılacak konum sayısı, 360 deg ya da aralık boyunca, 360'ta bir";
        topic_or_command = "Bir konu ya da komut; verilmezse ne olduğu";
        write_at_once = "Hepsini bir kerede yaz";
        place_of_driver = "Tahrik açısı deg olarak, kızaksa konumu [yoksa: sahnenin açıldığı yer]";
        assembly_of_group = "Sahnenin açıldığı yerde bir grubun montaj biçimi, check listesindeki gibi; virgülle ayrılır";
        write_to_a_file = "Standart çıktı yerine dosyaya yaz, ya bütünü ya hiçbiri";
        the_shell = "Kabuk";
        command_of_page = "Sayfanın anlattığı komut; verilmezse krank'ın kendisi";
        rated_effort = "Motorun sürekli verebildiği tork, N m, ya da kuvvet, N";
        peak_effort = "Bir an için verebildiği en büyük değer";
        motor_speed = "Birimiyle hızı: '1500 rpm', '0.2 m/s'";
        flywheel_on_shaft = "Tahrik milinde bir volan, kg m^2";
        wished_fluctuation = "İstenen hız dalgalanması: en büyük eksi en küçük, bölü ortalama";
        slide_of_ram = "Koç olan kızak [yoksa: presin çalıştığı ya da tek olan]";
        height_of_ram = "Koçun alt noktasının üstünde bir yükseklik, sahnenin biriminde";
        effort_for_ram = "Koç kuvveti için tork, N m, ya da kuvvet, N [yoksa: anma değeri]";
        tolerance_of_rest = "Koçun alt noktadan ne kadar uzakta duruyor sayıldığı, sahnenin biriminde";
        there_and_back_from = "Tahrikin bu koordinatından gidip dön [yoksa: bütün hareket]";
        there_and_back_to = "Bu koordinata; dönen tahrikte küçük olan bir tur ötededir";
        glyphs_as_allowed = "Yerel ve terminal neye izin veriyorsa";
        glyphs_of_seven_bits = "7 bitlik karakterler";
        glyphs_of_boxes = "Konsol yazı tiplerinde de olan çizgi karakterleri";
        glyphs_of_braille = "Braille desenleri";
        glyphs_of_quadrants = "Çoğu yazı tipinde olan çeyrek karakterler";
        glyphs_of_sextants = "Kimi yazı tipinde olan altıda bir karakterler";
        glyphs_of_octants = "Az yazı tipinde olan sekizde bir karakterler";
        trace_points = "Noktaların bütün hareketteki izleri";
        draw_velocities = "Hız okları";
        draw_accelerations = "İvme okları";
        draw_forces = "Yükler, mafsal ve kılavuz kuvvetleri, büyüklükleriyle";
        draw_ghosts = "Mekanizmayı hareketinin bu kadar yerinde göster";
        names_to_write = "Hangi adların yazılacağı";
        mark_centres = "Ağırlık merkezlerini işaretle";
        leave_guides_out = "Kılavuz ve mesnetleri çizme";
        characters_to_draw_with = "Çizimde kullanılacak karakterler";
        size_of_drawing = "Boyu; SVG'de bir karakter 8 x 16 birimdir [yoksa: terminalin boyu ya da 80x24; SVG 100 geniş]";
        size_of_plot = "Boyu; SVG'de bir karakter 8 x 16 birimdir [yoksa: terminalin boyu ya da 80x24; SVG 100x40]";
        names_none = "Hiçbiri";
        names_of_points_alone = "Noktaların";
        names_all = "Noktaların ve uzuvların";
        plot_against = "x ekseninde ne olduğu: driver, time ya da bir büyüklüğün adı";
        driver_begins = "Tahrikin başladığı yer [yoksa: hareket aralığının başı]";
        driver_ends = "Tahrikin bittiği yer [yoksa: hareket aralığının sonu]";
        leave_extrema_out = "En büyük ve en küçük değerleri işaretleme";
        where_to_open = "Nerede açılacağı: tahrik uzvunun açısı deg ya da tahrik kızağının konumu";
        colours_to_draw_with = "Çizimde kullanılacak renkler";
        theme_to_draw_with = "Palet adlarının hangi renkler olduğu [yoksa: auto]";
        way_of_pictures = "Terminale durağan resimlerin nasıl gönderildiği [yoksa: auto]";
        pictures_as_told = "TERM, TERM_PROGRAM ya da KITTY_WINDOW_ID ne diyorsa";
        pictures_of_kitty = "kitty'nin aldığı gibi";
        pictures_of_iterm = "iTerm2'nin aldığı gibi";
        pictures_of_sixels = "sixel olarak";
        pictures_never = "Hiç";
        view_to_open_with = "Açılışta gösterilecek görünüm";
        print_and_leave = "Açılan ekranı metin olarak yaz ve çık: terminal gerekmez";
        size_of_print = "Yazılan ekranın boyu [yoksa: 80x24]";
        tell_of_terminal = "Terminalde ne bulunduğunu ve nedenini söyle";
        configuration_file = "Ayar dosyası [yoksa: ~/.config/krank/config.toml]";
        colours_as_allowed = "Terminal ve NO_COLOR neye izin veriyorsa";
        colours_none = "Renksiz; kalın ve ters kalır";
        colours_of_palette = "Terminal paletinin 16 rengi";
        colours_fixed = "256'lık sabit palet";
        colours_any = "Her renk, 24 bit";
        theme_auto = "Paletinkiler ya da her zeminde okunanlar";
        theme_light = "Açık zemin için";
        theme_dark = "Koyu zemin için";
        theme_plain = "Renksiz";

        // Methods.
        method_of_positions = "Konumların hangi yöntemle bulunduğu";
        method_closed = "Kapalı form, sonra hızlar, ivmeler ve kuvvetler";
        method_newton = "Döngü denklemlerine Newton-Raphson, yineleme yineleme";
        method_bisection = "Bir bilinmeyenin aralığını ikiye bölme";
        method_graphical = "Pergel ve cetvel, adım adım";
        against_figures = "krank'ınkilerin yanında duracak değerler, ders notundan ya da başka bir programdan: her satırda bir değer ya da driver.angle boyunca sütunlar olan CSV";
        measured_figures = "Yanında duracak ölçümler: driver.angle ya da driver.position boyunca her büyüklüğe bir sütunu olan, adı ve köşeli ayraçta birimi yazılı CSV";
        no_measurements(file: &str) =
            "`{file}` bu büyüklüklerin ölçümünü içermiyor: ilk satırı tahrikin koordinatını ve büyüklükleri adlandırır, her satırda sayıları durur";
        measured_over_driver = "ölçümler tahrik boyunca durur: `--against` olmasın";
        holds_no_figures(file: &str) =
            "`{file}` içinde değer yok: bir satır `figure,unit,value` ya da biri tahrikinki olan her başlık için bir sayıdır";
        too_many_figures(file: &str) = "`{file}` karşılaştırılamayacak kadar büyük";
        guess_of_vectors = "Yöntemin başladığı yer: r3=20,r4=280, deg ya da sahnenin birimiyle; ikiye bölme için r3=0..90 [yoksa: açılışın bir taslağı]";
    }
}
