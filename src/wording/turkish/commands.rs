//! Commands on the command line: what they cannot do, and what a reader of their results should know.

use super::{Turkish, parser};
use crate::wording::english::CommandsWords;
use std::fmt::Display;

catalogue! {
    impl CommandsWords for Turkish {
        error(message: &str) = "hata: {message}";
        note(message: &str) = "not: {message}";
        of_option(option: &str, what: &dyn Display) = "{option}: {what}";

        of_parser(text: &str) = { parser::said(text) };

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
        file_was_mended(name: &dyn Display) =
            "`{name}` yazılırken yarım kalmıştı, şimdi yine tam";
        output_is_the_scene =
            "çıktı, okunan sahnenin kendisi: sahne yok olurdu; başka bir dosyaya yaz";
        output_is_read(file: &str) =
            "çıktı, okunan `{file}` dosyasının kendisi: yok olurdu; başka bir dosyaya yaz";
        no_pictures =
            "bu krank resimler olmadan derlenmiş (özellik `pictures`); resimler için: \
             cargo install --path . --features pictures";
        #[cfg(feature = "pictures")]
        picture_too_large(width: u32, height: u32) =
            "{width} x {height} piksellik bir resim çok büyük";
        #[cfg(feature = "pictures")]
        turn_too_large(pictures: usize) =
            "bu boyda {pictures} resim çok fazla";
        #[cfg(feature = "pictures")]
        smaller_has_room(why: &str) = "{why}; daha küçük `--width` ya da daha az `--seconds` sığar";
        format_takes_no(format: &str, option: &str, others: &str) =
            "{format} biçimindeki çizimde `{option}` olmaz: o şunlar içindir: {others}";
        no_text(format: &str) =
            "{format} terminalin göstereceği bir metin değil; `-o FILE` dosyaya yazar";
        #[cfg(not(feature = "tui"))]
        no_workbench(scene: &dyn Display) =
            "bu krank tezgâhsız derlenmiş (özellik `tui`); `krank table {scene}` tabloları yazar";

        // What was meant.
        did_you_mean(name: &str) = "`{name}` mi demek istedin?";
        did_you_mean_command(name: &str) = "`{name}` komutunu mu demek istedin?";
        did_you_mean_preset(name: &str) = "`{name}` hazır sahnesini mi demek istedin?";
        list_names_presets = "`krank list` hazır sahneleri sayar";
        no_preset_and_no_file(name: &str, mend: &str) = "`{name}` adında hazır sahne de dosya da yok; {mend}";
        command_comes_first(command: &str) = "komut önce gelir: `krank {command} SCENE`";
        no_such_command(name: &str, meant: &str) =
            "`{name}` diye bir komut yok; `{meant}` komutunu mu demek istedin?";
        one_scene_alone(extra: &str) =
            "`{extra}` fazla: krank bir sahne açar, komutlarını `krank --help` sayar";
        krank_has_no_command(name: &str) = "krank'ta `{name}` diye bir komut yok";
        no_topic_and_no_command(word: &str, topics: &str) =
            "`{word}` diye bir konu ya da komut yok; konular: {topics}";
        no_topic_but_near(word: &str, near: &str, topics: &str) =
            "`{word}` diye bir konu ya da komut yok; `{near}` mi demek istedin? konular: {topics}";
        check_names_points = "`krank check SCENE` noktaları sayar";
        no_point(option: &str, name: &str, mend: &str) =
            "{option}: sahnede `{name}` adında bir nokta yok; {mend}";
        there_are(names: &str) = "olanlar: {names}";

        // Values of options.
        must_be_positive = "0'dan büyük olmalı";
        must_be_a_number = "bir sayı olmalı";
        must_not_be_negative = "sonlu ve eksi olmayan bir sayı olmalı";
        size_is_meant(largest: &dyn Display) =
            "sütun x satır yazılır, 80x24 gibi; her biri 1 ile {largest} arasında";
        comma_for_both =
            "--decimal comma, --separator comma ile olmaz: virgül hem ondalık işareti hem ayraç olamaz; \
             --separator semicolon yaz";
        for_csv_alone(option: &str) = "{option} yalnız CSV içindir: --format csv ekle";

        // The driver and the motion.
        taken_within(typed: &dyn Display, at: &dyn Display, unit: &str, covered: &str) =
            "{typed} {unit} yerine {at} {unit} alındı: tahrikin aralığı {covered}";
        cannot_be_assembled(at: &dyn Display, unit: &str, covered: &str) =
            "mekanizma {at} {unit} konumunda kurulamaz: tahrikin aralığı {covered}";
        stopped_before(at: &dyn Display, unit: &str, name: &str, covered: &str) =
            "dayama ({name}), hareketi {at} {unit} konumundan önce bitiriyor: tahrikin aralığı {covered}";
        table_ends_before(at: &dyn Display, unit: &str, name: &str, covered: &str) =
            "{name} tablosu, onunla hareket de, {at} {unit} konumundan önce bitiyor: tahrikin aralığı {covered}";
        no_start_tells_assembly =
            "sahnenin açıldığı yerde hiçbir başlangıç konumu bu montaj biçimini ötekilerden ayırmıyor";
        no_finite_limits = "hareketin sonlu sınırları yok";
        leads_out_of_motion(from: f64, to: f64, covered: &str) =
            "--from {from} --to {to} hareketin dışına çıkar: tahrikin aralığı {covered}";
        must_go_from_one_to_another =
            "--from ve --to sonlu ve farklı olmalı: tahrik birinden ötekine gidip döner";

        // Figures.
        too_many_sensitivities(figures: usize, lengths: usize) =
            "--sensitivity: {lengths} boya göre {figures} büyüklük çok fazla; `krank sweep --columns` \
             daha azını adlandırır";
        unproved(some: &dyn Display, figures: &dyn Display) =
            "{figures} değerden {some} tanesinin hata sınırı yok: ölü ya da değişim konumu kanıt için \
             çok yakın, ya da formülde bir değer olmayabilir";
        no_arrows = "ok yok: ölü konumda hız ve ivme yoktur";
        no_row_in_motion(covered: &str) =
            "hiçbir satır hareketin içinde değil: tahrikin aralığı {covered}";
        rows_outside(some: u64, rows: u64, covered: &str) =
            "{rows} satırdan {some} tanesi hareketin dışında ve değersiz: tahrikin aralığı {covered}";
        rows_withheld(some: u64, rows: u64, why: &str) =
            "{rows} satırdan {some} tanesinde değer verilmedi; {why}";
        rows_without_answer(some: u64, rows: u64, what: &str) = "{rows} satırdan {some} tanesinde {what}";
        figures_without_answer(some: u64, figures: u64) =
            "{figures} değerden {some} tanesinin boylara göre türevi yok: yuvarlama payı içinde formül orada \
             döner ve iki yanı başka yanıt verir, ya da boyu olmayanın yönüdür";

        // Plots.
        no_figures_to_plot =
            "--columns: bunlar çizilecek büyüklükler değil; C.vx ya da r4.omega olurdu";
        too_small_for_plot(columns: u16, rows: u16) =
            "--size: {columns}x{rows} bir grafik için küçük; bir panele 40x12 yeter";
        panels_without_room(count: usize, columns: u16, rows: u16) =
            "{count} panele daha yer yok: --size {columns}x{rows} hepsini gösterir";
        one_along_x(name: &str, count: usize) =
            "--against: `{name}` {count} büyüklüğün adı, oysa x ekseninde bir tane olur";
        no_way_between(at: f64) = "--from ve --to aynı, {at}: arada çizilecek yol yok";
        plot_outside(covered: &str) =
            "grafiğin hiçbir yeri hareketin içinde değil: tahrikin aralığı {covered}";
        plot_partly_outside(covered: &str) =
            "grafiğin bir bölümü hareketin dışında: tahrikin aralığı {covered}";
        has_no_value_anywhere(name: &str) = "{name}: hiçbir yerde değeri yok";

        // The motor.
        peak_less_than_rated(peak: f64, rated: f64) =
            "--peak: {peak}, anma değeri {rated} sayısından küçük; tepe değer motorun kısa süre \
             verdiğidir, en az sürekli verdiği kadardır";
        fluctuation_above_one(share: f64) =
            "--fluctuation: {share} 1'den büyük; hızın (en büyük - en küçük) / ortalama oranıdır: 0.02, \
             yüzde 2 demektir";
        fluctuation_above_two(share: f64) =
            "--fluctuation: {share} olanaksız: 2 değerinde tahrik döngüde bir kez durur; 0.02, yüzde 2 demektir";
        guide_of_ram_moves(name: &str) = "--ram: `{name}` kılavuzu şasede değil; bir koçunki şasededir";
        no_slide_on_ground = "kılavuzu şasede olan kızak yok";
        no_slide_named(name: &str, mend: &str) = "--ram: `{name}` adında kızak yok; {mend}";
        no_ram(why: &dyn Display) = "koç yok: {why}; --ram birini adlandırır";
        nothing_acts_on_it =
            "mekanizmaya bir şey etki etmiyor: yük, yay ya da kütle yok; sahnede [[loads]] ya da bir \
             uzvun `mass` değeri olmalı";
        no_believable_integrals =
            "tahrikin yapması gerekenin bu döngüde güvenilir integralleri yok";

        // How far a command has come.
        parts = "parça";
        rows = "satır";
        best_so_far(value: &str) = "en iyi {value}";
        done_of(done: &str, total: &str, what: &str) = "{done} / {total} {what}";
        seconds_left(seconds: f64) = "{seconds} s kaldı";
        minutes_left(minutes: f64, seconds: f64) = "{minutes} dk {seconds} s kaldı";
        hours_left(hours: f64, minutes: f64) = "{hours} sa {minutes} dk kaldı";

        // The contents of the manual.
        topics_heading = "Konular: krank help TOPIC";
        commands_heading = "Komutlar: krank help COMMAND";
        help_of_workbench = "`krank --help` tezgâhı ve seçeneklerini anlatır.";
    }
}
