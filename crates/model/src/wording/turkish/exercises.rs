//! Exercises: sheets, files of answers and grades.

use super::Turkish;
use crate::wording::english::ExercisesWords;

catalogue! {
    impl ExercisesWords for Turkish {
        // The scene of an exercise.
        exercise_called(name: &str, seed: u64) = "{name}: ödev {seed}";
        exercise_made_by(scene: &str, seed: u64) = "krank exercise {scene} --seed {seed}";
        made_by_chance = "boylar, hız ve açı rastgeledir; verilen değerler kesindir";

        // The sheet.
        name_and_number = "Ad: ______________________________   Numara: ____________________";
        given_part = "Verilenler";
        asked_part = "İstenenler";
        fixed_at(at: &str, unit: &str) = "{at} {unit} konumunda sabit";
        link_from_to(from: &str, to: &str, length: &str, unit: &str) = "{from} noktasından {to} noktasına, {length} {unit}";
        point_on_link(name: &str, at: &str, unit: &str) = "{name}, uzvun ekseninde {at} {unit}";
        point_seen_from(name: &str, base: &str, length: &str, unit: &str, angle: &str) =
            "{name}, {base} noktasından {length} {unit}, uzvun eksenine göre {angle} deg";
        the_origin = "başlangıç";
        the_frame = "şase";
        slides_along(what: &str, on: &str, through: &str, angle: &str) =
            "{what} kayar, kılavuz: {on}, {through} noktasından {angle} deg ile";
        lies_to_guide(what: &str, angle: &str) = "{what} ekseni kılavuza göre hep {angle} deg";
        driver_stands(name: &str, at: &str, speed: &str, acceleration: &str) =
            "{name}: {at}, hız {speed}, ivme {acceleration}";
        what_is_asked =
            "Her döngünün vektörel poligonunu çizin, denklemlerini sinüs ve kosinüsle yazın, iki kez türevini \
             alın ve tabloları doldurun. Ara hesaplarda bütün haneleri koruyun; cevapları en az dört haneye \
             yuvarlayın. Uzvun eksen takımının başlangıcı uzvun ilk ucundadır, x ekseni uzuv boyuncadır.";
        positions_asked = "Konumlar, bilinmeyenler soru işaretiyle:";
        velocities_asked = "Hızlar, bilinmeyenler soru işaretiyle:";
        accelerations_asked = "İvmeler, bilinmeyenler soru işaretiyle:";
        points_are_asked = "Noktaların hız ve ivmeleri, büyüklük ve yön:";
        where_answers_belong(file: &str) =
            "Cevapları bir hesap tablosuyla {file} dosyasına yazın; değerlerin adları ve birimleri orada \
             listelenmiştir.";

        names_in_answers(names: &str) =
            "Cevap dosyasındaki değerler: {names}. Bir uzvun açısı, ilk ucundan ikinci ucuna giden ekseninin \
             açısıdır; öteki kenarları bu eksenle sabit açılar yapar.";

        names_of_a_point(point: &str, names: &str) = "Her nokta için, burada {point} için: {names}.";

        // Verdicts.
        is_right = "doğru";
        rounded_by(figure: &str, written: &str) = "erken yuvarlama: {figure} = {written}";
        rounded_somewhere = "erken yuvarlama";
        cut_off = "yuvarlanmadan kesilmiş";
        too_few_digits = "hane az";
        right_by_own(figure: &str) = "kendi {figure} değerine göre doğru";
        wrong_in_sign = "işareti yanlış";
        other_way_round = "ters yönde";
        in_other_unit(unit: &str) = "birimi {unit}";
        of_other_assembly = "öbür montaj biçimi";
        is_wrong = "yanlış";
        is_unanswered = "boş";
        is_no_figure = "sayı değil";

        // Answers.
        answers_to(sheet: &str) = "Cevaplanan: {sheet}.";
        figure = "değer";
        answer = "cevap";
        exact_figure = "kesin";
        judged = "sonuç";
        student = "öğrenci";
        points_head = "puan";
        figures_head = "toplam";
        file_head = "dosya";
        first_mistake_head = "ilk hata";
        points_of(points: usize, figures: usize, right: usize, nearly: usize) =
            "{figures} değerden {points} puan: {right} değer doğru, {nearly} değer yuvarlama ya da önceki bir \
             hata dışında doğru.";
        first_that_differs(figure: &str, verdict: &str) = "İlk farklı değer {figure}: {verdict}.";
        first_mistake(figure: &str, verdict: &str) = "İlk hata {figure}: {verdict}.";
        value_misread(name: &str, given: &str, read: &str) =
            "Bu cevaplar, `{name}` {given} yerine {read} olsaydı doğru olurdu: yanlış okunmuş olabilir.";
        judged_besides = "Bunlar sorulmamıştı ve puan getirmez:";
        strange_units(cells: &str) =
            "Bilinmeyen birimler ya da başka bir büyüklüğün birimleri: {cells}. Bilinmeyen birim yerine sorulan \
             birim alındı.";
        answers_unread(cells: &str) = "Sayı olmayan cevaplar: {cells}.";
        answered_again(cells: &str) = "Sonraki bir satırın geçersiz kıldığı cevaplar: {cells}.";
        no_figures_of_scene(cells: &str) = "Bu sahnenin hiçbir değerini göstermeyen satırlar: {cells}.";
        cell_of_line(line: u64, figure: &str, text: &str) = "{line}. satırda {figure} [{text}]";
        decoded_as(encoding: &str) =
            "Dosya UTF-8 değil; ISO 8859-9'u da içeren {encoding} olarak okundu.";
        file_decoded_as(file: &str, encoding: &str) =
            "`{file}` UTF-8 değil; ISO 8859-9'u da içeren {encoding} olarak okundu";

        // Errors of the commands.
        no_exercise(seed: u64) =
            "{seed} tohumu için ödev bulunamadı: rastgele boylar mekanizmanın gerektirdiği bağıntıları bozuyor";
        no_dimensions = "sahnede rastgele seçilebilecek boy yok";
        no_figures_at(at: &str) = "{at} konumunda hız ve ivme yok: başka bir konum seçin";
        folder_for_many = "--count birçok dosya yazar: -o DIR ile bir klasör verin";
        seeds_run_out = "--seed ile --count en büyük tohumu aşıyor";
        would_be_lost(file: &str) =
            "`{file}` bu ödevin yazdığı gibi değil ve içeriği kaybolurdu: başka bir klasöre yazın";
        holds_no_answers(file: &str) = "`{file}` içinde cevap yok: hiçbir satırda bir değerin adı yok";
        names_no_figure(file: &str, sheet: &str) =
            "`{file}` içinde cevap yok: hiçbir satırda `{sheet}` sahnesinin bir değeri yok";
        too_many_answers(file: &str) = "`{file}` bir cevap dosyası için çok büyük";
        names_no_sheet(file: &str, sheet: &str) = "`{file}` dosyasında adı geçen `{sheet}` klasörde yok";
        answers_another_sheet(file: &str, named: &str, sheet: &str) =
            "`{file}` dosyası {named} için, ama {sheet} ile notlandırılıyor";
        student_again(student: &str, files: &str) = "{student} birden çok dosyada geçiyor: {files}";
        some_not_graded(some: usize, files: usize) = "{files} dosyadan {some} tanesi notlandırılmadı";

        // On the command line.
        does_exercise = "Bir sahneden ödev yapın: rastgele boyutlu ödev kâğıdı, cevap dosyası, çözüm";
        does_grade = "Cevapları notlandırın: her değer doğru, erken yuvarlanmış, işareti, birimi ya da kendisi yanlış";
        seed_of_exercise = "Ödevin tohumu: aynı tohum her makinede aynı ödevi verir";
        count_of_exercises = "Ardışık tohumlarla ödev sayısı";
        format_of_sheet = "Ödev ve çözümün biçimi [yoksa: klasöre html, değilse metin]";
        folder_of_exercises = "Sahneyi, ödevi, cevap dosyasını ve çözümü bu klasöre yazın";
        sheet_to_grade =
            "Ödevin sahnesi, herhangi bir sahne ya da hazır sahne, ya da cevaplarda adı geçen sahnelerin \
             klasörü";
        files_of_answers = "Cevap dosyaları, CSV";
        how_to_write_grades = "Çıktı biçimi; CSV'de her dosya bir satırdır";
        examples_of_exercise = "\
Örnekler:
  krank exercise four-bar --seed 7
  krank exercise slider-crank --seed 1 --count 100 -o class
  krank exercise press --seed 3 --decimal comma --format latex -o class

Bütün boylar, hız ve açı iki haneli rastgele sayılardır; sahne montaj biçimini ve
hareket türünü korur, ölü konumlara yakın değildir. -o her tohum
için four-bar-7.toml (sahne), four-bar-7.html (ödev), four-bar-7.csv (cevaplar)
ve four-bar-7-solution.html (çözüm) dosyalarını yazar.";
        examples_of_grade = "\
Örnekler:
  krank grade class/four-bar-7.toml ayse.csv
  krank grade class answered/*.csv --format csv -o points.csv
  krank grade four-bar --at 60 notes.csv

Cevap, kesin değerin kendi hanelerine (en az üç) yuvarlanmış hâliyse doğrudur.
Başka bir cevap önceki cevaplardan çıkıyor olabilir: o zaman erken yuvarlanmıştır
ya da önceki yanlış bir cevaba göre doğrudur; o cevabın adı verilir.";
    }
}
