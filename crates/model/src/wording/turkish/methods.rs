//! Comparison of the methods that can solve a scene: speed against error.

use super::Turkish;
use crate::wording::english::MethodsWords;
use std::fmt::Display;

catalogue! {
    impl MethodsWords for Turkish {
        // The methods.
        method = "yöntem";
        closed_and_polished = "kapalı, düzeltilmiş";
        newton_from_anchors = "Newton, dayanaktan";
        with_bounds = "sınırlarla";
        single_precision = "tek hassasiyet";
        newton_warm(tolerance: f64) = "Newton {tolerance:e} sıcak";
        newton_cold(tolerance: f64) = "Newton {tolerance:e} soğuk";
        bisection = "ikiye bölme";
        runge_kutta(steps: &dyn Display, turns: &dyn Display) = "RK4 {steps} x {turns}";

        // Reasons why a method is not applicable.
        a_group = "bir grup";
        the_group_at(point: &str) = "{point} noktasındaki grup";
        has_no_closed_form(group: &str) = "{group}: kapalı formu yok";
        not_needed = "gerekmez: her grubun kapalı formu var";
        closes_by_conditions(group: &str, count: usize) = "{group}: {count} denklem birlikte çözülmeli";
        cannot_turn_fully = "tahrikin sınırları var, tam tur dönemez";
        gives_no_rows = "bir grubun kısıtlarının ayrı denklemleri yok";
        not_measured = "ölçülmedi";

        // Figures.
        positions_over_cycle(positions: &dyn Display, longest: &str, unit: &str) =
            "döngü boyunca {positions} konum; en uzun boy {longest} {unit}";
        time = "süre";
        quartiles = "çeyrekler";
        error_of_positions = "kon";
        error_of_velocities = "hız";
        error_of_accelerations = "ivm";
        failures = "başarısız";

        // Explanations.
        of_time_is = "hızları ve ivmeleriyle bir konumun süresi: ortanca ve çeyrekler; RK4 için bir adımın süresi";
        errors_of_three = "kon hız ivm";
        errors_are =
            "double-double hesaba göre en büyük hatalar: noktalarda en uzun boya, hız ve ivmelerde döngünün \
             en büyük hız ve ivmesine oranla";
        failures_are = "çözüm bulunamayan ya da başka bir montaj biçiminin bulunduğu konumlar; hatalara katılmaz";
        best_are =
            "Pareto sınırı: hiç başarısız olmaz, böyle başka hiçbir yöntem hem daha hızlı hem daha doğru değil";
        with_bounds_is = "krank'ın çözümü, her değerin kanıtlı hata sınırıyla; sınır kanıtlanamazsa başarısız";
        warm_or_cold = "sıcak, soğuk";
        warm_or_cold_is =
            "Newton yöntemi bir önceki konumdan (sıcak; bir derece ya da aralığın 360'ta biri ötede) ya da açılış \
             konumundan (soğuk) başlar; radyan ve en uzun boyun kesri olarak bir adım toleransın altına inince \
             biter";
        runge_kutta_n_by_m = "RK4 n x m";
        runge_kutta_is =
            "hızların Runge-Kutta yöntemiyle integrali, 360 deg için n adım, m. döngüde karşılaştırılır";

        // Iterations and methods.
        iterations = "yin";
        iterations_are = "konum başına Newton adımı ya da yarılama, bütün gruplarda: ortanca ve en çok";
        closed_form_is = "her ikili grup kendi formülüyle, yinelemesiz: krank'ın yöntemi";
        anchors = "dayanaklar";
        newton_from_anchors_is =
            "saklanan birçok durumun en yakınından Newton yöntemi: krank'ın bağlaşık gruplardaki yöntemi";
        polished = "düzeltilmiş";
        polished_is = "kapalı form ve double-double artıklarla bir düzeltme";
        single = "tek";
        single_precision_is = "tek hassasiyetle kapalı form";
        newton_at_tolerance = "Newton";
        newton_is = "doğrusallaştırılmış vektörel konum denklemlerini tam adımlarla art arda çözer";
        bisection_is = "her grupta bir kök içeren yarım turu, uçları arasında sayı kalmayana dek ikiye böler";

        // Methods worked out step by step.
        watch_a_method = "yöntemi adım adım izle";
        guess = "tahmin";
        type_where_it_begins = "ilk tahmin";
        guesses_are_typed = "r3=20, r4=280; ikiye bölme: r3=0..90; boş: taslak";
        no_method_watched(key: &str) = "Seçili yöntem yok; ilki için {key} tuşuna basın";
        begins_at_no_guess = "Bu yöntem tahmin kullanmaz";
        newton_raphson = "Newton-Raphson";
        bisection_title = "İkiye bölme";
        by_drawing = "Pergel ve cetvelle";
        newton_how =
            "Bir x tahmininden sonraki x + dx'tir, J dx = -f. f vektörel konum denklemlerinin artığı, J bunların \
             bilinmeyenlere göre türevleridir. Bir adım 1e-12 altına inene dek tam adımlar atılır. Hatalar \
             krank'ın çözümünden farklardır: açılar rad, boylar en uzun boyun kesri olarak.";
        bisection_how =
            "Kolunun boyu bir bilinmeyeni yok eder; öteki için tek denklem f = 0 kalır. f'nin işaret değiştirdiği \
             aralık ikiye bölünür, işaret değişiminin olduğu yarı tutulur. Hatalar orta noktalarındır: açılar rad, \
             boylar en uzun boyun kesri olarak.";
        drawing_how =
            "Aynısı kâğıtta: pergelle çemberler, cetvelle kılavuzlar, açılar açıölçerle okunur.";
        error_of_iteration = "hata";
        iteration = "yineleme";
        errors_by_iteration = "Yinelemelere göre hata";
        begins_at_guess(values: &str) = "{values} tahmininden:";
        begins_at_start(values: &str) = "Açılış konumunun taslağından okunan {values} değerlerinden:";
        not_square(equations: usize, unknowns: usize) =
            "{unknowns} bilinmeyen için {equations} denklem: J kare değil, adım vermez.";
        jacobians(unit: &str) = "J, her yineleme için bir satır, birimi {unit}, açılar için {unit}/rad:";
        first_jacobian(unit: &str) = "Tahminde J, birimi {unit}, açılar için {unit}/rad:";
        largest_step = "adım";
        newton_found(steps: usize) = "{steps} adımda bu hareketin montaj biçimine yakınsar.";
        errors_are_squared = "Sona doğru her hata bir öncekinin yaklaşık karesidir.";
        newton_other(steps: usize) =
            "{steps} adımda başka bir montaj biçimine yakınsar: döngüler kapanır, ama hareketin buradaki konumu \
             başkadır. Sonuç tahmine bağlıdır, yanlış olduğunu hiçbir şey göstermez.";
        newton_closes(steps: usize) =
            "{steps} adımda yakınsar: döngü kapanır, ama sahnenin montaj biçiminden başlayan hareket bu konuma \
             ulaşmaz.";
        newton_diverged(steps: usize) =
            "Iraksar: {steps} adımdan sonra bir açı tahmininden 100 turdan uzaktadır ya da bir boy bütün ötekileri \
             aşar. J tekile yakındı, bu yüzden adım çok uzun oldu.";
        newton_singular(steps: usize) =
            "{steps} adımdan sonra biter: J orada tekildir, det J = 0, adım yoktur. Örneğin açıları bilinmeyen iki \
             vektör paraleldir.";
        newton_unsettled(steps: usize) = "{steps} adımda yakınsamaz: adımlar küçülmez.";
        newton_at_dead_point(steps: usize) =
            "{steps} adımdan sonra biter: ölü konumda J çözümün kendisinde tekildir. Her adım hatayı en çok yarıya \
             indirir, yuvarlama hanelerin yarısını bırakır.";

        // Bisection.
        known_sides_are_k = "K bilinen kenarların toplamı:";
        between_ends(symbol: &str, from: &str, to: &str) = "{symbol}, {from} ile {to} arasında:";
        least_along(m: &str, symbol: &str, at: &str) =
            "f en küçük değerini kol {m} boyunca uzanırken, {symbol} = {at} için, en büyüğünü tam karşısında alır: \
             {m} vektörünün her iki yanında birer kök vardır. Turun montaj biçimini içeren yarısı ikiye bölünür.";
        least_at(symbol: &str, at: &str) =
            "f en küçük değerini {symbol} = {at} için alır: her iki yanında birer kök vardır, montaj biçiminin \
             olduğu yan ikiye bölünür.";
        halved_until(finest: &str) = "Aralık en çok {finest} olana ya da ortasında f = 0 olana dek ikiye bölünür:";
        root_at_an_end(end: &str) =
            "{end} ucu kökün kendisidir; f orada 0'a yalnız değer, bu yüzden ikiye bölme olanaksızdır.";
        no_change_of_sign =
            "f iki uçta aynı işaretlidir: aralıkta ya kök yoktur ya da iki kök vardır, bu yüzden ikiye bölme olanaksızdır.";
        middle_of_interval = "orta";
        halved(count: usize) = "{count} bölmeden sonra:";
        holds_the_assembly(from: &str, to: &str) =
            "Bu kök bu hareketin montaj biçimidir. Öteki {from} ile {to} arasındadır.";
        holds_the_other(from: &str, to: &str) =
            "Bu kök öteki montaj biçimidir. Bu hareketinki {from} ile {to} arasındadır.";
        assemblies_are_one = "İki montaj biçimi burada çakışır: iki kök eşittir.";
        guess_of_removed(symbol: &str) =
            "Yalnız {symbol} ikiye bölünür; yok edilen bilinmeyenin tahmini kullanılmaz.";
        nothing_to_halve(unknowns: usize) =
            "İkiye bölmeyle olmaz: {unknowns} bağlaşık bilinmeyen vardır, hiçbiri tek başına yok edilemez, işareti \
             değişebilecek tek bir denklem kalmaz.";
        two_guides_are_linear =
            "İkiye bölmeyle olmaz: iki bilinmeyen de kılavuz boyunca konumdur, denklemler doğrusaldır ve \
             Newton-Raphson'un bir adımı çözer.";

        // Graphical constructions.
        no_assembly_to_draw = "Montaj biçimi yok, çemberler kesişmez: çizilecek bir şey yok.";
        scale_of_sheet(scale: &str) =
            "Bütün noktalar {scale} ölçekle bir A4 kâğıda sığar. Bir nokta kâğıtta 0.2 mm doğrulukla çizilir ve \
             okunur.";
        points_to_begin_with = "Şasenin noktaları ve tahrikin yerleştirdiği noktalar:";
        on_paper(axis: &str) = "kâğıtta {axis} [mm]";
        which_it_is = "hangisi";
        also_on_paper(length: &str, unit: &str, paper: &str) = "{length} {unit} (kâğıtta {paper} mm)";
        draw_a_circle(centre: &str, arm: &str, radius: &str) =
            "Merkezi {centre} olan bir çember çizin: {arm} = {radius}.";
        draw_a_line(through: &str, theta: &str, direction: &str) =
            "{through} noktasından bir doğru çizin: {theta} = {direction} deg.";
        draw_through(one: &str, other: &str) = "{one} ve {other} noktalarından geçen doğruyu çizin.";
        draw_a_tangent(centre: &str, from: &str, radius: &str) =
            "Merkezi {centre}, yarıçapı {radius} olan bir çember çizin, ona {from} noktasından bir teğet çekin.";
        leave_out_beyond(name: &str, length: &str) =
            "Boyunca ölçülen uzaklık {name} ve {length} değerlerinden oluşur; ikincisi uzva aittir.";
        they_meet_in_two = "İki noktada kesişirler:";
        the_assembly = "montaj biçimi";
        the_other = "öteki";
        they_cross_at(degrees: &str, point: &str, off: &str, unit: &str) =
            "{degrees} deg ile kesişirler, bu yüzden {point} en çok {off} {unit} hatayla bilinir.";
        they_touch_in(point: &str) = "{point} noktasında teğettirler; tam yerini çizim gösteremez:";
        lines_meet_in(point: &str) = "{point} noktasında kesişirler.";
        read_off_sheet = "Kâğıttan okunan değerler, hesaplananların yanında:";
        sought_here = "bilinmeyen";
        as_read = "okunan";
        as_solved = "hesaplanan";
        not_by_compass(unknowns: usize) =
            "Pergel ve cetvelle olmaz: {unknowns} bağlaşık bilinmeyen vardır, hiçbir nokta bilinen iki çizginin \
             üzerinde değildir. Elle tek yol, son boy uyana dek konum denemektir.";

        // Guesses.
        guess_is_written =
            "NAME=VALUE yazın, belirsizse ardından deg, rad ya da bir boy birimi; ikiye bölme için NAME=FROM..TO";
        guess_of_nothing(name: &str, mend: &str) = "`{name}` adında bir vektör yok; {mend}";
        sought_are(names: &str) = "bilinmeyenler {names}";
        not_sought(name: &str, names: &str) = "`{name}` verilmiş ya da tahrikle belirli; bilinmeyenler {names}";
        other_unit(name: &str, unit: &str) = "`{name}` tahminini {unit} olarak yazın";
        unit_missing(name: &str, unit: &str) =
            "`{name}` için hem boy hem açı bilinmiyor; {name}=VALUE{unit} ya da {name}=VALUEdeg yazın";
        guessed_twice(name: &str) = "`{name}` aynı bilinmeyeni ikinci kez tahmin ediyor; bir tahmini silin";
        guess_is_one_value(name: &str) =
            "Newton-Raphson tek bir değerden başlar; {name}=FROM..TO ikiye bölme içindir";
        needs_no_guess(name: &str) = "`{name}`: bu yöntem tahmin kullanmaz; Newton-Raphson ya da ikiye bölme seçin";
    }
}
