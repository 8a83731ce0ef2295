//! The reference of a scene's keys: descriptions and defaults.

use super::Turkish;
use crate::wording::english::SceneKeysWords;

catalogue! {
    impl SceneKeysWords for Turkish {
        heads_of_keys = "anahtar | açıklama | verilmezse";
        // Descriptions.
        the_title = "başlık";
        where_it_comes_from = "mekanizmanın kaynağı";
        what_there_is_to_see = "sahnenin açıklaması";
        unit_of_every_length = "bütün boyların birimi: `\"mm\"`, `\"cm\"`, `\"m\"` ya da `\"in\"`";
        numbers_with_names = "formüllerde kullanılan, adı olan sayılar: `a = 100`, `b = \"2 * a + 5\"`";
        points_fixed_in_frame = "şasede sabit noktalar: `A = [x, y]`";
        points_only_shown = "yalnız gösterim ve formüller için noktalar: `T1 = [x, y]`";
        the_input = "giriş: tahrik edilen bir uzuv ya da kızak";
        inputs_that_follow =
            "tahriki izleyen öteki girişler, her biri uzvunun ya da kızağının adıyla: `r7 = { ... }`";
        rigid_links = "rijit uzuvlar, her biri bir tablo: `r2 = { ... }`";
        guides_and_sliders = "kılavuzlar ve üzerlerinde hareket edenler, her biri bir tablo: `r4 = { ... }`";
        rough_positions = "hareketli noktaların sahnenin açıldığı yerdeki kaba konumları: `C = [x, y]`; çizildiği gibi verilen uzuvlar için tam";
        copies_of_groups =
            "uzuvların ve kızakların kopyaları ve yansımaları, her biri adların son ekiyle: `left = { ... }`";
        further_vectors = "tablolar için ek vektörler, kuyruk ve uç: `r1 = [\"D\", \"A\"]`";
        coordinates_between_stops =
            "iki dayaması olan koordinatlar, hareket dayamalarda biter: bir kızağın konumu `rod = [120, 200]`, bir \
             uzvun şasedeki açısı `r4 = [30, 150]` ya da bir tablo";
        any_number_of_loads = "istendiği kadar yük, her biri bir kuvvet, bir tork ya da bir pres";
        any_number_of_springs = "istendiği kadar yay ve sönümleyici: noktalar arasında ya da uzuvlar arasında burulma yayı";
        acceleration_of_fall = "yerçekimi ivmesi `[x, y]`, m/s^2 olarak";
        figures_by_formulas =
            "başkalarından formülle hesaplanan adlı büyüklükler: `swing = \"r4.angle - r3.angle\"`";
        what_is_to_drive = "sahnenin motoru; hareketi değiştirmez";
        constraints_that_repeat = "başkalarını yineleyen kısıtların ne kadar uyuşması gerektiği";
        what_views_show_first = "sahne açılınca çizimlerin gösterdikleri";
        the_turning_link = "sabit noktası çevresinde dönen uzuv";
        the_pushed_slide = "ya da: tahrik edilen kızak";
        opening_angle = "sahnenin açıldığı yerde tahrik uzvunun x ekseninin yönü, deg olarak; `points` liste değilse zorunlu";
        opening_position = "tahrik edilen kızağın açılıştaki konumu: kılavuz boyunca `through` noktasından";
        where_an_input_is_held =
            "ötekilerin yerine: girişin tutulduğu koordinat, deg olarak ya da kızakta sahnenin `unit` birimiyle";
        ratio_of_input =
            "tahrikin koordinatının 1 artışına karşılık kendi koordinatının değişimi: her biri derece ya da \
             sahnenin `unit` birimi";
        phase_of_input =
            "tahrikin koordinatı 0 iken kendi koordinatı: uzvun x ekseninin yönü, deg, ya da kızağın konumu";
        table_of_input =
            "ikisinin yerine bir tablo: tahrikin koordinatı ile kendi koordinatından düğümler, arada düzgün bir \
             eğri; hareket onunla biter ya da tablo tahrikin tam turlarını kapsar, ilk değerine döner ve yinelenir";
        seat_of_driver = "şase değilse motoru taşıyan uzuv: açı o uzva göredir, tork ikisi arasında etki eder";
        range_of_driver =
            "tahrikin dayamaları `[low, high]`, deg ya da tahrik edilen kızakta sahnenin `unit` biriminde";
        link_and_from_where = "açısı sınırlanan uzuv ve açının ölçüldüğü uzuv";
        ends_of_an_angle = "uçları `[low, high]`, deg olarak, araları bir turdan az";
        speed_of_driver = "`\"15 rad/s\"`, `\"90 deg/s\"`, `\"143.2 rpm\"` ya da `\"143.2 d/dk\"`; kızakta `\"50 mm/s\"` (`cm/s`, `m/s`, `in/s`)";
        acceleration_of_driver = "`\"2 rad/s^2\"`, `\"90 deg/s^2\"`; kızakta `\"5 mm/s^2\"` (`cm/s^2`, `m/s^2`, `in/s^2`)";
        motion_of_driver =
            "ya da zamana göre hareketi, adım adım: `[{ law = \"cycloidal\", to = 120, time = 0.5 }, { dwell = 0.2 \
             }, { law = \"harmonic\", to = 0, time = 0.4 }]`";
        law_of_step = "`\"constant\"`, `\"harmonic\"`, `\"cycloidal\"`, `\"trapezoid\"`, `\"table\"` ya da `\"sine\"`";
        end_of_step = "adımın sonunda tahrikin koordinatı";
        time_of_step = "s olarak süresi";
        amplitude_of_step = "sinüste, orta konumdan en büyük uzaklık";
        phase_of_step = "sinüste, başlangıçtaki faz, derece olarak: ortada 0, en büyük değerde 90";
        ramp_of_step = "trapezde, sürenin hızlanma ve yine yavaşlama için payı";
        knots_of_step = "tabloda: `[[0, 0], [0.2, 40], [0.5, 120]]`, başından s olarak";
        dwell_of_step = "ya da: tahrikin bekleme süresi, s olarak";
        ends_and_their_distance = "bir uzvun iki ucu ve aralarındaki uzaklık: vektörel konum denklemindeki vektörü";
        points_in_link_frame =
            "uzvun eksen takımında öteki noktalar: `{ P = [150, 80] }`, ya da boy ve açıyla `{ P = { from = \"D\", \
             length = 170, angle = 28 } }`, ya da iki uzaklıkla `from = [\"D\", \"E\"], distances = [120, 90]`; \
             doğal iki ucu olmayan bir uzuvda yalnız bunlar; ya da tek başına bir liste `[\"B\", \"C\", \"P\"]`: B'den C'ye \
             bir uzuv, biçimi `[ground]` ve `[start]` içindeki koordinatlardan";
        centre_in_link_frame = "uzvun eksen takımında ağırlık merkezi, bir nokta gibi yazılır";
        point_that_sees =
            "yerin, uzvun hangi noktasından ölçüldüğü; `distances` için iki nokta: `[\"D\", \"E\"]`";
        origin_by_default = "uzvun eksen takımının başlangıcı";
        distance_of_place = "uzaklığı";
        direction_of_place = "yönü, uzvun x ekseninden, deg olarak";
        distances_of_place = "ya da: iki noktadan uzaklıkları, bir üçgenin kenarları gibi";
        side_of_place = "ilk noktadan ikincisine giden doğrunun hangi yanında olduğu: `\"left\"` (sol) ya da `\"right\"` (sağ)";
        mass_of_link = "kg olarak; `com` gerekir";
        inertia_of_link = "ağırlık merkezine göre, kg m^2 olarak; `com` gerekir";
        pin_in_the_slot = "yarıkta hareket eden pim, dönmekte serbest";
        link_without_turning = "ya da: dönmeden kayan uzuv, başlangıcı kılavuzun üstünde";
        what_carries_the_guide = "kılavuzu taşıyan cisim: `\"ground\"` ya da bir uzuv";
        point_of_the_guide =
            "kılavuzun bir noktası: `on` cisminin bir noktası, adıyla, ya da onun eksen takımında `[x, y]`";
        angle_of_guide = "kılavuzun `on` cisminin x eksenine göre açısı, deg olarak";
        turn_of_slider = "kayan uzvun x ekseninin kılavuza göre açısı, deg olarak";
        group_that_is_copied =
            "kopyalanacak uzuvlar ve kızaklar, ayrıca kopyanın paylaşmayacağı noktalar: `[\"b\", \"c\"]`";
        number_of_copies = "kopya sayısı; her biri bir öncekine göre yerleşir";
        mirror_axis_of_copy = "yansıma ekseni, `\"x\"` ya da `\"y\"`; `about` noktasından geçer";
        turn_of_copy = "yansıtmadan sonra `about` çevresinde saat yönünün tersine dönme, deg olarak";
        centre_of_copy = "`mirror` ve `turn` için merkez: adıyla sabit bir nokta ya da `[x, y]`";
        shift_of_copy = "döndürmeden sonra öteleme `[x, y]`";
        phase_of_copy =
            "aslının krank gibi başka uzuvlardaki noktaları ile kopyanınkiler arasındaki açı, deg olarak";
        points_joined_by_copy =
            "kopyada başka adla bulunan noktalar: `{ O = \"L\" }` ile kopyada, aslındaki O yerine L ya da bir \
             önceki kopyanın L noktası bulunur";
        force_at_a_point = "bir noktada `[x, y]` kuvveti, N olarak";
        frame_of_a_force = "kuvvetin eksen takımında verildiği uzuv: kuvvet onunla döner";
        torque_on_a_link = "ya da: bir uzva N m olarak tork, saat yönünün tersine";
        factor_over_driver =
            "kuvvetin ya da torkun, tahrikin koordinatına göre çarpanı: düğümler `[[0, 0.2], [15, 1], [360, \
             0.2]]`, deg ya da tahrik edilen kızağın biriminde";
        press_of_a_slide = "ya da: kapanan bir kızağa karşı, strokunun sonundan önceki uzaklığa göre N olarak kuvvet: düğümler \
                 `[[12, 0], [4, 200e3], [0, 350e3]]`";
        end_of_a_press = "presin çalıştığı yer: kılavuz boyunca en küçük `\"least\"` ya da en büyük `\"greatest\"` konum; \
                 kılavuz yataysa verilmelidir";
        ends_of_a_spring = "iki nokta, ayrı cisimlerde";
        stiffness_of_spring = "N/m olarak; burulma yayında N m/rad olarak";
        free_length = "yalnız ön gerilmesiyle çektiği boy, sahnenin `unit` biriminde";
        force_of_gas_spring = "onun yerine, gazlı yayda: uçlarının uzaklığına göre N olarak itme kuvveti, düğümler \
                 `[[200, 900], [300, 700]]`";
        link_of_torsion_spring = "ya da: burulma yayının etkidiği uzuv; `to` yayın bağlı olduğu uzuvdur, verilmezse \
                 şasedir";
        free_angle = "burulma yayında: serbestken `to` uzvunun x ekseninden `link` uzvununkine açı, deg olarak";
        preload_of_spring = "serbest boyunda çektiği kuvvet, N olarak; burulma yayında serbest açısında uzvu döndüren tork, \
                 N m olarak, saat yönünün tersine";
        damping_of_spring = "N s/m olarak, uzaklığın hızına; burulma yayında N m s/rad olarak";
        rated_torque = "anma torku, N m olarak";
        rated_force = "tahrik edilen kızakta onun yerine: anma kuvveti, N olarak";
        peak_of_motor = "kısa süre için en büyük değer, N m ya da N olarak";
        rated_speed = "anma hızı, tahrikinki gibi yazılır";
        flywheel_of_motor = "tahrik milindeki atalet momenti, kg m^2 olarak";
        fluctuation_wished = "tahrik hızının istenen dalgalanması, (en büyük - en küçük) / ortalama";
        rest_of_ram = "koçun, strokunun sonundan hangi uzaklığa kadar duruyor sayıldığı; eski adı `tolerance`";
        tolerance_of_lengths =
            "verilen her boyun ve koordinatın iki yana toleransı, sahnenin `unit` biriminde, ya da bir sınıfla, \
             `\"ISO 2768-m\"` (`f`, `m`, `c`, `v`); sınıfla, 0 olan koordinat tam sayılır";
        exact_by_default = "tam";
        clearance_of_pins = "her pimin deliğinin merkezinden en büyük uzaklığı: çaptaki boşluğun yarısı";
        tolerance_of_link = "boyunun ve noktalarının yerlerinin toleransı";
        tolerance_of_guide = "`through` koordinatlarının toleransı";
        tolerance_of_scene = "sahneninki";
        tolerance_of_link_or_scene = "uzvunki ya da sahneninki";
        tolerances_of_points = "şasede ya da bir uzuvda bir noktanın iki koordinatının toleransı: `A = 0.05`";
        clearances_of_pins = "bir pimin deliğinin merkezinden en büyük uzaklığı: `B = 0.02`";
        misfit_accepted =
            "hareket boyunca ne kadar ayrışabilecekleri, sahnenin `unit` biriminde: az haneli çizimler için";
        points_traced_first = "izi çizilen noktalar: `[\"T\"]`";
        // Defaults.
        name_of_the_file = "dosyanın adı";
        no_default = "yok";
        direction_if_drawn = "çizimdeki yön";
        unit_speed = "1 rad/s ya da 1 birim/s";
        no_vector_by_default = "vektör yok";
        the_lower_end = "alttaki uç";
        unknown_by_default = "bilinmiyor";
    }
}
