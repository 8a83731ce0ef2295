//! Errors and notes of commands.

use super::{Turkish, parser};
use crate::wording::english::CommandsWords;
use std::fmt::Display;

catalogue! {
    impl CommandsWords for Turkish {
        error(message: &str) = "hata: {message}";
        note(message: &str) = "not: {message}";
        of_option(option: &str, what: &dyn Display) = "{option}: {what}";

        of_parser(text: &str) = { parser::translate_message(text) };

        // Files and results.
        cannot_read(name: &str, why: &dyn Display) = {
            format!("{name} okunamıyor: {}", parser::of_system(why))
        };
        standard_input = "standart girdi";
        cannot_write_results(why: &dyn Display) = {
            format!("sonuçlar yazılamıyor: {}", parser::of_system(why))
        };
        cannot_write(name: &dyn Display, why: &dyn Display) = {
            format!("`{name}` yazılamıyor: {}", parser::of_system(why))
        };
        file_was_mended(name: &dyn Display) = "`{name}`: yarıda kalan kayıt tamamlandı";
        output_is_the_scene =
            "çıktı dosyası okunan sahnenin kendisi, sahne kaybolurdu: başka bir dosyaya yazın";
        output_is_read(file: &str) =
            "çıktı dosyası okunan `{file}` dosyasının kendisi, dosya kaybolurdu: başka bir dosyaya yazın";
        no_pictures =
            "bu krank `pictures` özelliği olmadan derlenmiş; şöyle kurun: cargo install --path . --features \
             pictures";
        picture_too_large(width: u32, height: u32) = "{width} x {height} piksellik resim çok büyük";
        turn_too_large(pictures: usize) =
            "bu boyutta {pictures} resim çok fazla";
        smaller_has_room(why: &str) = "{why}: daha küçük bir `--width` ya da daha az `--seconds` seçin";
        format_takes_no(format: &str, option: &str, others: &str) =
            "`{option}`, `--format {format}` ile kullanılamaz; şunlardan birini kullanın: {others}";
        no_format_of_extension(extension: &str, known: &str) =
            "`{extension}` uzantılı resim yok; {known} kullanın ya da biçimi `--format` ile verin";
        no_text(format: &str) = "{format} ikili bir biçimdir: `-o FILE` ile bir dosyaya yazın";
        no_workbench(scene: &dyn Display) =
            "bu krank tezgâh olmadan derlenmiş (özellik `tui`); tabloları `krank table {scene}` ile yazdırın";

        // Suggestions.
        did_you_mean(name: &str) = "`{name}` mi demek istediniz?";
        did_you_mean_command(name: &str) = "`{name}` komutunu mu demek istediniz?";
        did_you_mean_preset(name: &str) = "`{name}` hazır sahnesini mi demek istediniz?";
        list_names_presets = "hazır sahneleri `krank list` ile listeleyin";
        no_preset_and_no_file(name: &str, mend: &str) = "`{name}` adında hazır sahne ya da dosya yok; {mend}";
        command_comes_first(command: &str) = "komutu başa yazın: `krank {command} SCENE`";
        no_such_command(name: &str, meant: &str) =
            "bilinmeyen komut `{name}`; `{meant}` komutunu mu demek istediniz?";
        one_scene_alone(extra: &str) =
            "beklenmeyen argüman `{extra}`: krank bir kerede tek sahne açar; komutları `krank --help` ile \
             listeleyin";
        krank_has_no_command(name: &str) = "bilinmeyen komut `{name}`";
        no_topic_and_no_command(word: &str, topics: &str) =
            "`{word}` adında konu ya da komut yok; konular: {topics}";
        no_topic_but_near(word: &str, near: &str, topics: &str) =
            "`{word}` adında konu ya da komut yok; `{near}` mi demek istediniz? konular: {topics}";
        word_occurs(word: &str) = "`{word}` adında konu ya da komut yok; geçtiği yerler:";
        word_occurs_but_near(word: &str, near: &str) =
            "`{word}` adında konu ya da komut yok; `{near}` mi demek istediniz? geçtiği yerler:";
        html_needs_folder = "`--format html` bir web sitesi yazar: `-o DIR` ekleyin";
        html_has_all_topics(word: &str) = "`--format html` bütün konuları yazar: `{word}` sözcüğünü silin";
        folder_needs_html = "`-o DIR` için `--format html` gerekir";
        check_names_points = "noktaları `krank check SCENE` ile listeleyin";
        no_point(option: &str, name: &str, mend: &str) =
            "{option}: sahnede `{name}` adında bir nokta yok; {mend}";
        there_are(names: &str) = "olanlar: {names}";

        // Values of options.
        must_be_positive = "0'dan büyük olmalı";
        must_be_a_number = "bir sayı olmalı";
        must_not_be_negative = "sonlu ve negatif olmayan bir sayı olmalı";
        size_is_meant(largest: &dyn Display) =
            "sütun x satır yazın, örneğin 80x24; her biri 1 ile {largest} arasında";
        comma_for_both =
            "--decimal comma ile --separator comma birlikte kullanılamaz: --separator semicolon kullanın";
        for_csv_alone(option: &str) = "{option} için CSV gerekir: --format csv ekleyin";

        // The driver and the motion.
        taken_within(typed: &dyn Display, at: &dyn Display, unit: &str, covered: &str) =
            "{typed} {unit} yerine {at} {unit} kullanılıyor: tahrikin aralığı {covered}";
        cannot_be_assembled(at: &dyn Display, unit: &str, covered: &str) =
            "mekanizma {at} {unit} konumunda kurulamaz: tahrikin aralığı {covered}";
        stopped_before(at: &dyn Display, unit: &str, name: &str, covered: &str) =
            "dayama ({name}), hareketi {at} {unit} konumundan önce bitiriyor: tahrikin aralığı {covered}";
        table_ends_before(at: &dyn Display, unit: &str, name: &str, covered: &str) =
            "hareket {at} {unit} konumundan önce, {name} tablosuyla birlikte bitiyor: tahrikin aralığı \
             {covered}";
        no_start_tells_assembly =
            "sahnenin açıldığı konumda hiçbir başlangıç konumu, bütün uzuvlar aynı kalarak bu montaj biçimini belirlemiyor";
        no_finite_limits = "hareketin sonlu sınırları yok";
        leads_out_of_motion(from: f64, to: f64, covered: &str) =
            "--from {from} --to {to} hareketin dışına çıkar: tahrikin aralığı {covered}";
        must_go_from_one_to_another =
            "--from ve --to sonlu ve farklı olmalı: tahrik ikisi arasında gidip gelir";

        // Values.
        too_many_sensitivities(figures: usize, lengths: usize) =
            "--sensitivity: {lengths} boya göre {figures} büyüklük çok fazla: `krank sweep --columns` ile daha \
             azını seçin";
        unproved(some: &dyn Display, figures: &dyn Display) =
            "{figures} değerden {some} tanesinin hata sınırı yok: ölü ya da değişim konumu çok yakın, ya da bir \
             formül tanımsız olabilir";
        no_arrows = "ok yok: ölü konumda hız ve ivme tanımlı değildir";
        no_row_in_motion(covered: &str) =
            "hiçbir satır hareketin içinde değil: tahrikin aralığı {covered}";
        rows_outside(some: u64, rows: u64, covered: &str) =
            "{rows} satırdan {some} tanesi hareketin dışında ve değeri yok: tahrikin aralığı {covered}";
        rows_withheld(some: u64, rows: u64, why: &str) =
            "{rows} satırdan {some} tanesinde gösterilmeyen değerler var: {why}";
        rows_without_answer(some: u64, rows: u64, what: &str) = "{rows} satırdan {some} tanesinde {what}";
        figures_without_answer(some: u64, figures: u64) =
            "{figures} değerden {some} tanesinin boylara göre türevi yok: formülde bir kırılma ya da sıçrama, \
             ya da sıfır vektörün yönü var";

        // Plots.
        no_figures_to_plot =
            "--columns: çizilecek bir şey yok: en az bir sütun adı verin, örneğin C.vx ya da r4.omega";
        too_small_for_plot(columns: u16, rows: u16) =
            "--size: {columns}x{rows} bir grafik için çok küçük: bir panel için en az 40x12 verin";
        panels_without_room(count: usize, columns: u16, rows: u16) =
            "{count} panel daha sığmıyor: hepsini görmek için --size {columns}x{rows} verin";
        one_along_x(name: &str, count: usize) =
            "--against: `{name}` {count} büyüklüğü gösteriyor: x ekseni için birini seçin";
        no_way_between(at: f64) = "--from ve --to değerlerinin ikisi de {at}: iki farklı konum seçin";
        plot_outside(covered: &str) =
            "grafiğin hiçbir bölümü hareketin içinde değil: tahrikin aralığı {covered}";
        plot_partly_outside(covered: &str) =
            "grafiğin bir bölümü hareketin dışında: tahrikin aralığı {covered}";
        has_no_value_anywhere(name: &str) = "{name}: hiçbir yerde değeri yok";

        // The motor.
        peak_less_than_rated(peak: f64, rated: f64) =
            "--peak: {peak}, anma değeri {rated} sayısından küçük: motorun tepe değerini verin, en az anma \
             değeri kadardır";
        fluctuation_above_one(share: f64) =
            "--fluctuation: {share} 1'den büyük: hızın (en büyük - en küçük) / ortalama oranını verin; 0.02, %2 \
             demektir";
        fluctuation_above_two(share: f64) =
            "--fluctuation: {share} olanaksız: 2 değerinde tahrik her döngüde bir kez durur; 0.02, %2 demektir";
        guide_of_ram_moves(name: &str) =
            "--ram: `{name}` kızağının kılavuzu şasede değil: kılavuzu şasede olan bir kızak verin";
        no_slide_on_ground = "kılavuzu şasede olan bir kızak yok";
        no_slide_named(name: &str, mend: &str) = "--ram: `{name}` adında kızak yok; {mend}";
        no_ram(why: &dyn Display) = "koç yok: {why}; --ram ile bir kızak verin";
        nothing_acts_on_it = "sahnede yük, yay ya da kütle yok: [[loads]] ya da bir uzva `mass` ekleyin";
        no_believable_integrals = "tahrik kuvvetinin ya da torkunun integralleri bu döngüde yakınsamıyor";

        // Progress.
        parts = "parça";
        rows = "satır";
        best_so_far(value: &str) = "en iyi {value}";
        done_of(done: &str, total: &str, what: &str) = "{done} / {total} {what}";
        seconds_left(seconds: f64) = "{seconds} s kaldı";
        minutes_left(minutes: f64, seconds: f64) = "{minutes} dk {seconds} s kaldı";
        hours_left(hours: f64, minutes: f64) = "{hours} sa {minutes} dk kaldı";

        // The version.
        build_details(features: &str, target: &str, profile: &str, licence: &str) =
            "özellikler  {features}\nhedef       {target}\nprofil      {profile}\nlisans      {licence}";

        // The contents of the manual.
        topics_heading = "Konular: krank help TOPIC";
        keys_heading = "Tezgâhın tuşları: krank help keys";
        columns_heading = "Sütunlar: krank help columns";
        commands_heading = "Komutlar: krank help COMMAND";
        help_of_workbench = "Tezgâh ve seçenekleri: `krank --help`.";
    }
}
