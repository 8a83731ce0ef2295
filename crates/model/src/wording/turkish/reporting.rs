//! The report: drawing, polygons, tables and plots around the working.

use super::Turkish;
use crate::wording::english::ReportingWords;

catalogue! {
    impl ReportingWords for Turkish {
        language_tag = "tr";

        // The beginning.
        unit_vectors_are(along: &str, across: &str) =
            "Birim vektörler: açı boyunca {along}, ona dik ve soluna {across}:";

        // Vector polygons and their tables.
        polygon_drawn(sum: &str) = "Ölçekli vektörel poligon: {sum} = 0";
        polygon_of_loop(number: usize, sum: &str) =
            "Döngü {number}: ölçekli vektörel poligon, {sum} = 0";
        dashes_and_arcs = "; bilinmeyenli vektörler kesikli, açılar kuyruklarda.";
        points_against(vector: &str, theta: &str) =
            "{vector} < 0: oku {theta} yönünün tersini gösterir.";
        loop_number(number: usize) = "döngü {number}";
        found_by_loop(number: usize) = "{number}. döngüden";
        tables_asked = "Verilenler ve soru işaretli bilinmeyenler:";
        tables_told = "Verilenler ve simgelerinden sonra hesaplanan değerler:";

        // Velocities and accelerations of points.
        points_to_scale = "Ölçekli noktalar";
        direction_in_degrees = "yön [deg]";
        velocities_of_joints = "Mafsalların hızları, tek kutuptan, ölçekli.";
        velocities_of_centres = "Ağırlık merkezlerinin hızları, tek kutuptan, ölçekli.";
        accelerations_of_joints = "Mafsalların ivmeleri, tek kutuptan, ölçekli; n merkezcil, t teğetsel bileşen.";
        accelerations_of_centres =
            "Ağırlık merkezlerinin ivmeleri, tek kutuptan, ölçekli; n merkezcil, t teğetsel bileşen.";

        // Forces, plots and facts.
        link_cut_free(link: &str) =
            "{link} uzvunun serbest cisim diyagramı, atalet içinde bütün kuvvetlerle; kısa oklar uzatılmıştır.";
        centres_drawn = "Ani dönme merkezleri ve üzerinde oldukları doğrular; çok uzaktakiler çizilmez.";
        forces_drawn = "Yükler, mafsal ve kılavuz kuvvetleri.";
        plots_part = "Bütün hareket boyunca";
        positions_plotted = "Konumlar";
        velocities_plotted = "Hızlar";
        accelerations_plotted = "İvmeler";
        plotted_are(what: &str, names: &str) = "{what}: {names}.";
        facts_part = "Mekanizma";

        // On the command line.
        does_report = "Teslim edilecek bir rapor yazın: bir açının çizimi, poligonları, tabloları, çözümü ve grafikleri";
        format_of_report = "Çıktı biçimi [yoksa: dosya uzantısına göre ya da html]";
        format_html = "Resimleri içinde tek bir HTML dosyası, tarayıcı ve kâğıt için";
        format_latex = "Sade bir TeX Live için LaTeX, resimleri TikZ ile";
        examples_of_report = "\
Örnekler:
  krank report four-bar --at 60 -o four-bar.html
  krank report slider-crank --at 30 --digits 9 -o slider-crank.tex
  krank report press --format markdown --notation krank

Çizim; her döngünün ölçekli vektörel poligonu; her vektöre bir sütunla konum,
hız ve ivme tabloları, önce boş (theta3 = ?), sonra dolu; ders notlarının mu ve
nu birim vektörleriyle `krank explain` çözümü; mafsalların ve ağırlık
merkezlerinin hız ve ivmeleri tek kutuptan ölçekli; ani dönme merkezleri; yük
varsa kuvvetler; bütün hareket boyunca grafikler; `krank check` bilgileri. .html,
.tex, .md ya da .txt uzantısı biçimi seçer; başkası için --format gerekir.";

        no_report_has_ending(ending: &str) =
            "bilinmeyen rapor uzantısı .{ending}: .html, .tex, .md ya da .txt kullanın ya da --format verin";
        notation_of_working = "Birim vektörlerin adları";
        notation_lecture = "Ders notlarındaki gibi mu ve nu";
        notation_krank = "u ve n";

        // In the workbench.
        report = "rapor";
        too_many_links_to_report = "burada rapor için uzuv çok fazla: krank report kullanın";
        write_a_report = "bir rapor yaz";
        the_report = "rapor";

        // Comparison with other values.
        beside_file(file: &str) = "{file} ile karşılaştırma";
        beside_list(file: &str) =
            "{file} değerleri ve krank'ın değerleri; verilen haneler bir fark göstermiyorsa `uyuyor`.";
        beside_course(file: &str, rows: usize) =
            "{file} sütunları {rows} satır boyunca krank'ınkilerle karşılaştırılır: her biri için farkların \
             karesel ortalaması, en büyük fark, yeri, en büyük değere oranı ve farkın yuvarlamayı aştığı satır \
             sayısı.";
        foreign_difference = "fark";
        part_of_it = "oranı";
        agrees = "uyuyor";
        not_compared(names: &str) =
            "Karşılaştırılmayanlar (krank'ta burada ya da bu birimde böyle bir değer yok): {names}.";
        cells_left_out(cells: &[(u64, &str, String)], more: usize) = {
            let cell = |(line, column, cell): &(u64, &str, String)| format!("{line}. satır, {column}: {cell}");
            let mut text: Vec<String> = cells.iter().map(cell).collect();
            if more > 0 {
                text.push(format!("ve {more} tane daha"));
            }
            format!("Sayı olmadığı için dışarıda bırakıldı: {}.", text.join("; "))
        };
        root_mean_square = "rms";
        rows_compared = "satır";
        largest_difference = "en büyük fark";
        at_driver = "yeri";
        of_largest = "en büyüğe oranı";
        beyond_rounding = "aşan";
    }
}
