//! Methods that could solve a scene: speed against error.

use super::Turkish;
use crate::wording::english::MethodsWords;
use std::fmt::Display;

catalogue! {
    impl MethodsWords for Turkish {
        // The methods.
        method = "yöntem";
        closed_and_polished = "kapalı, inceltilmiş";
        newton_from_anchors = "Newton, dayanaktan";
        with_bounds = "sınırlarla";
        single_precision = "tek hassasiyet";
        newton_warm(tolerance: f64) = "Newton {tolerance:e} sıcak";
        newton_cold(tolerance: f64) = "Newton {tolerance:e} soğuk";
        bisection = "ikiye bölme";
        runge_kutta(steps: &dyn Display, turns: &dyn Display) = "RK4 {steps} x {turns}";

        // Why one cannot be used.
        a_group = "bir grup";
        the_group_at(point: &str) = "{point} noktasındaki grup";
        has_no_closed_form(group: &str) = "{group}: kapalı formu yok";
        not_needed = "gerekmez: her grubun kapalı formu var";
        closes_by_conditions(group: &str, count: usize) = "{group} aynı anda {count} koşulla kapanır";
        cannot_turn_fully = "tahrikin sınırları var, tam dönemez";
        gives_no_rows = "bir grubun kısıtları kendi satırlarını vermiyor";
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

        // How they are meant.
        of_time_is =
            "hızları ve ivmeleriyle bir konumun süresi: ortanca, bir de bütün örneklerin yarısının \
             arasında kaldığı değerler; RK4 için bir adımın";
        errors_of_three = "kon hız ivm";
        errors_are =
            "iki kat hassasiyetli hesaba göre en büyük hatalar: noktaların, en uzun boya ve döngünün \
             en büyük hız ve ivmesine oranla";
        failures_are =
            "hiçbir şeyin ya da başka bir montaj biçiminin bulunduğu konumlar; hataya katılmazlar";
        best_are = "en iyi sınır: hiç başarısız olmaz, böyle başka hiçbir yöntem hem daha hızlı hem daha yakın değil";
        with_bounds_is =
            "krank'ın çözdüğü gibi, her değerin kanıtlı hata sınırıyla; sınır kanıtlanamazsa başarısız";
        warm_or_cold = "sıcak, soğuk";
        warm_or_cold_is =
            "Newton yöntemi bir derece ya da aralığın 360'ta biri ötedeki önceki konumdan ya da \
             sahnenin açıldığı yerden başlar; radyan ve en uzun boyun payı olarak adımı toleransın \
             altına inince biter";
        runge_kutta_n_by_m = "RK4 n x m";
        runge_kutta_is =
            "hızların Runge-Kutta ile integrali, 360 deg içinde n adım, m numaralı döngüde bakılır";

        // How many iterations they take, and what they do.
        iterations = "yin";
        iterations_are =
            "bir konumun aldığı Newton adımı ya da ikiye bölme, bütün gruplarla: ortanca ve en çok";
        closed_form_is = "her diad kendi formülüyle, yineleme yok: krank'ın yaptığı";
        anchors = "dayanaklar";
        newton_from_anchors_is =
            "saklanan birçok durumun en yakınından Newton yöntemi: krank'ın bağlı gruplarda yaptığı";
        polished = "inceltilmiş";
        polished_is = "kapalı form, bir de iki kat hassasiyetli artıklardan bir düzeltme";
        single = "tek";
        single_precision_is = "yarı haneli sayılarla kapalı form";
        newton_at_tolerance = "Newton";
        newton_is = "döngü denklemleri doğrusallaştırılır, çözülür, yine doğrusallaştırılır: tam adımlar";
        bisection_is =
            "her grupta bir kök tutan yarım tur, uçları arasında sayı kalmayana dek ikiye bölünür";

        // A method by hand.
        watch_a_method = "bir yöntemi elle izle";
        guess = "tahmin";
        type_where_it_begins = "yöntemin başladığı yer";
        guesses_are_typed = "r3=20, r4=280; ikiye bölmede r3=0..90; boşsa taslak";
        no_method_watched(key: &str) = "İzlenen yöntem yok; ilki için {key} basın";
        begins_at_no_guess = "Bu yöntem bir tahminden başlamaz";
        newton_raphson = "Newton-Raphson";
        bisection_title = "İkiye bölme";
        by_drawing = "Pergel ve cetvelle";
        newton_how =
            "Bir x tahmininden sonraki x + dx'tir, J dx = -f: f döngü denklemlerinden kalan, J bunların \
             bilinmeyenlere göre türevleri. Dersteki program gibi tam adımlarla, bir adım 1e-12 altına \
             inene dek. Hatalar krank'ın çözümüne göredir: açılar rad, boylar en uzun boyun payı olarak.";
        bisection_how =
            "Bir bilinmeyen kolunun boyuyla yok edilir; ötekinin tek denklemi f = 0 kalır. f'nin işaret \
             değiştirdiği aralık ikiye bölünür, işaretin değiştiği yarı tutulur. Hatalar ortaların \
             hatasıdır: açılar rad, boylar en uzun boyun payı olarak.";
        drawing_how =
            "Aynısı kâğıtta: pergelle çemberler, cetvelle kılavuzlar, açılar açıölçerle okunur.";
        error_of_iteration = "hata";
        iteration = "yineleme";
        errors_by_iteration = "Yinelemelere göre hata";
        begins_at_guess(values: &str) = "{values} tahmininden:";
        begins_at_start(values: &str) =
            "{values}: sahnenin açıldığı yerin taslağından okunduğu gibi:";
        not_square(equations: usize, unknowns: usize) =
            "{unknowns} bilinmeyen için {equations} denklem: J kare değil, ondan adım çıkmaz.";
        jacobians(unit: &str) = "J, her yineleme için bir satır, birimi {unit}, açılar için {unit}/rad:";
        first_jacobian(unit: &str) = "Tahminde J, birimi {unit}, açılar için {unit}/rad:";
        largest_step = "adım";
        newton_found(steps: usize) = "{steps} adımda yakınsar, istenen montaj biçimine.";
        errors_are_squared = "Sona doğru her hata bir öncekinin yaklaşık karesidir.";
        newton_other(steps: usize) =
            "{steps} adımda başka bir montaj biçimine yakınsar: döngüler kapanır, ama hareketin buradaki \
             konumu bu değildir. Buna tahmin karar verir, yanlış olduğunu hiçbir şey söylemez.";
        newton_closes(steps: usize) =
            "{steps} adımda yakınsar: döngü kapanırdı, ama sahnenin montaj biçiminden başlayan hareket \
             buraya gelmez.";
        newton_diverged(steps: usize) =
            "Iraksar: {steps} adımdan sonra bir açı tahmininden 100 turdan uzakta ya da bir boy \
             ötekilerin hepsinden ötede. J tekile yakındı, adımı bu yüzden çok uzun oldu.";
        newton_singular(steps: usize) =
            "{steps} adımdan sonra biter: J orada tekil, det J = 0, adım yok. Açıları aranan iki vektör \
             paralel, ya da buna benzer.";
        newton_unsettled(steps: usize) = "{steps} adımda yakınsamaz: adımlar küçülmez.";
        newton_at_dead_point(steps: usize) =
            "{steps} adımdan sonra biter: ölü konumda J çözümün kendisinde tekildir, her adım hatayı ancak \
             yarıya indirir, yuvarlama hanelerin yarısını bırakır.";

        // Halving.
        known_sides_are_k = "K bilinen kenarların toplamı:";
        between_ends(symbol: &str, from: &str, to: &str) = "{symbol}, {from} ile {to} arasında:";
        least_along(m: &str, symbol: &str, at: &str) =
            "f en küçük değerini kol {m} boyunca uzanırken alır, {symbol} = {at}; en büyüğünü tam karşısında: \
             {m} vektörünün her iki yanında birer kök vardır. Turun montaj biçimini tutan yarısı bölünür.";
        least_at(symbol: &str, at: &str) =
            "f en küçük değerini {symbol} = {at} için alır: her iki yanında birer kök vardır, montaj biçiminin \
             bulunduğu yan bölünür.";
        halved_until(finest: &str) =
            "Aralık {finest} değerini aşmayana ya da ortasında f = 0 olana dek bölünür:";
        root_at_an_end(end: &str) =
            "Kök {end} ucunun kendisidir; f orada 0'a yalnız değer, bölünecek bir şey yok.";
        no_change_of_sign =
            "f iki uçta aynı işaretli: aralıkta kök yok ya da iki tane var, bölünecek bir şey yok.";
        middle_of_interval = "orta";
        halved(count: usize) = "{count} bölmeden sonra:";
        holds_the_assembly(from: &str, to: &str) =
            "Bu kök istenen montaj biçimidir. Öteki {from} ile {to} arasında.";
        holds_the_other(from: &str, to: &str) =
            "Bu kök öteki montaj biçimidir. İstenen {from} ile {to} arasında.";
        assemblies_are_one =
            "Burada iki montaj biçimi birdir: iki kök aynı yerde.";
        guess_of_removed(symbol: &str) =
            "Yalnız {symbol} ikiye bölünür: yok edilen için tahmin kullanılmaz.";
        nothing_to_halve(unknowns: usize) =
            "İkiye bölmeyle olmaz: aynı anda {unknowns} bilinmeyen aranır, hiçbiri tek başına yok \
             edilemez, işareti değişebilecek tek denklem kalmaz.";
        two_guides_are_linear =
            "İkiye bölmeyle olmaz: iki bilinmeyen de kılavuz boyunca konumdur, denklemler doğrusaldır, \
             Newton-Raphson'un bir adımı çözer.";

        // By compass and ruler.
        no_assembly_to_draw = "Montaj biçimi yoksa çemberler kesişmez: çizilecek bir şey yok.";
        scale_of_sheet(scale: &str) =
            "Bütün noktalar {scale} ölçekle bir A4 kâğıda sığar. Bir nokta kâğıtta 0.2 mm ile çizilir ve görülür.";
        points_to_begin_with = "Şase ve tahrikin yerleştirdikleri:";
        on_paper(axis: &str) = "kâğıtta {axis} [mm]";
        which_it_is = "hangisi";
        also_on_paper(length: &str, unit: &str, paper: &str) = "{length} {unit} (kâğıtta {paper} mm)";
        draw_a_circle(centre: &str, arm: &str, radius: &str) =
            "Merkezi {centre} olan bir çember çiz: {arm} = {radius}.";
        draw_a_line(through: &str, theta: &str, direction: &str) =
            "{through} noktasından bir doğru çiz: {theta} = {direction} deg.";
        draw_through(one: &str, other: &str) = "{one} ve {other} noktalarından geçen doğruyu çiz.";
        draw_a_tangent(centre: &str, from: &str, radius: &str) =
            "Merkezi {centre} olan bir çember çiz ({radius}), ona {from} noktasından bir teğet çek.";
        leave_out_beyond(name: &str, length: &str) =
            "Boyunca ölçülen {name} ve {length} toplamıdır; ikincisi uzvundur.";
        they_meet_in_two = "İki noktada kesişirler:";
        the_assembly = "montaj biçimi";
        the_other = "öteki";
        they_cross_at(degrees: &str, point: &str, off: &str, unit: &str) =
            "{degrees} deg ile kesişirler, {point} bu yüzden {off} {unit} hatayla bilinir.";
        they_touch_in(point: &str) =
            "{point} noktasında teğettirler; yerini çizim tam söyleyemez:";
        lines_meet_in(point: &str) = "{point} noktasında kesişirler.";
        read_off_sheet = "Okunan, hesaplananın yanında:";
        sought_here = "bilinmeyen";
        as_read = "okunan";
        as_solved = "hesaplanan";
        not_by_compass(unknowns: usize) =
            "Pergel ve cetvelle olmaz: aynı anda {unknowns} bilinmeyen aranır, hiçbir noktası bilinen iki \
             çizginin üzerinde değildir. Son boy uyana dek konumlar denenirdi.";

        // What is guessed.
        guess_is_written =
            "NAME=VALUE yaz, belli değilse arkasına deg, rad ya da bir boy birimi; ikiye bölme için \
             NAME=FROM..TO";
        guess_of_nothing(name: &str, mend: &str) = "`{name}` adında bir vektör yok; {mend}";
        sought_are(names: &str) = "bilinmeyenler {names}";
        not_sought(name: &str, names: &str) =
            "`{name}` verilmiş ya da tahrikle gider; bilinmeyenler {names}";
        other_unit(name: &str, unit: &str) = "`{name}` için {unit} aranır";
        unit_missing(name: &str, unit: &str) =
            "`{name}` için hem boy hem açı aranır; {name}=VALUE{unit} ya da {name}=VALUEdeg yaz";
        guessed_twice(name: &str) = "`{name}` ile söylenen iki kez verilmiş";
        guess_is_one_value(name: &str) =
            "Newton-Raphson tek bir değerden başlar; {name}=FROM..TO ikiye bölme içindir";
        needs_no_guess(name: &str) =
            "`{name}` boşuna tahmin edilmiş; Newton-Raphson ve ikiye bölme bir tahminden başlar";
    }
}
