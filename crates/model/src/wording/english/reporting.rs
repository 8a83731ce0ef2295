//! The report: drawing, polygons, tables and plots around the working.

use super::English;

catalogue! {
    /// The text around the pictures and tables of a report.
    trait ReportingWords for English {
        language_tag = "en";

        // The beginning.
        unit_vectors_are(along: &str, across: &str) =
            "With the unit vectors {along} along an angle and {across} perpendicular to it, to its left:";

        // Vector polygons and their tables.
        polygon_drawn(sum: &str) =
            "The vector polygon {sum} = 0, to scale";
        polygon_of_loop(number: usize, sum: &str) =
            "Loop {number}: the vector polygon {sum} = 0, to scale";
        dashes_and_arcs = "; vectors with unknowns are dashed, angles are at the tails.";
        points_against(vector: &str, theta: &str) =
            "{vector} < 0: its arrow points against {theta}.";
        loop_number(number: usize) = "loop {number}";
        found_by_loop(number: usize) = "from loop {number}";
        tables_asked = "Given values, and unknowns with a question mark:";
        tables_told = "Given values, and computed values after their symbols:";

        // Velocities and accelerations of points.
        points_to_scale = "Points to scale";
        direction_in_degrees = "at [deg]";
        velocities_of_joints = "Velocities of the joints from one pole, to scale.";
        velocities_of_centres = "Velocities of the centres of mass from one pole, to scale.";
        accelerations_of_joints =
            "Accelerations of the joints from one pole, to scale; n is a normal component, t a tangential one.";
        accelerations_of_centres =
            "Accelerations of the centres of mass from one pole, to scale; n is a normal component, t a tangential \
             one.";

        // Forces, plots and facts.
        link_cut_free(link: &str) =
            "Free-body diagram of {link} with all forces, including inertia; short arrows are drawn longer.";
        centres_drawn = "Instant centres, and the lines on which they lie; distant ones are not drawn.";
        forces_drawn = "Loads, and the forces at joints and guides.";
        plots_part = "Over the whole motion";
        positions_plotted = "Positions";
        velocities_plotted = "Velocities";
        accelerations_plotted = "Accelerations";
        plotted_are(what: &str, names: &str) = "{what}: {names}.";
        facts_part = "The mechanism";

        // On the command line.
        does_report = "Write a report to hand in: drawing, polygons, tables, working and plots at one angle";
        format_of_report = "The output format [default: from the file extension, or html]";
        format_html = "One HTML file with its pictures embedded, for a browser and for paper";
        format_latex = "LaTeX for a plain TeX Live, with pictures in TikZ";
        examples_of_report = "\
Examples:
  krank report four-bar --at 60 -o four-bar.html
  krank report slider-crank --at 30 --digits 9 -o slider-crank.tex
  krank report press --format markdown --notation krank

The drawing; the vector polygon of every loop to scale; position, velocity and
acceleration tables with a column per vector, empty (theta3 = ?) and then
filled; the working of `krank explain` with the unit vectors mu and nu of the
lectures; velocities and accelerations of joints and centres of mass from one
pole, to scale; instant centres; forces where loads act; plots over the whole
motion; and the facts of `krank check`. The extension .html, .tex, .md or .txt
selects the format; any other needs --format as well.";

        no_report_has_ending(ending: &str) =
            "unknown report extension .{ending}: use .html, .tex, .md or .txt, or give --format";
        notation_of_working = "The names of the unit vectors";
        notation_lecture = "mu and nu, as in the lectures";
        notation_krank = "u and n";

        // In the workbench.
        report = "report";
        too_many_links_to_report = "too many links to report on here: use krank report";
        write_a_report = "write a report";
        the_report = "the report";

        // Comparison with other values.
        beside_file(file: &str) = "Comparison with {file}";
        beside_list(file: &str) =
            "The values of {file} and of krank; `agrees` where the given digits show no difference.";
        beside_course(file: &str, rows: usize) =
            "The columns of {file} compared with krank's, over {rows} rows. Each line has the root mean square \
             of the differences, and the largest difference with its position and its ratio to the largest value. \
             The last number counts the rows with a difference beyond rounding.";
        foreign_difference = "difference";
        part_of_it = "ratio";
        agrees = "agrees";
        not_compared(names: &str) =
            "Not compared, since krank has no such value here, or not in this unit: {names}.";
        cells_left_out(cells: &[(u64, &str, String)], more: usize) = {
            let cell = |(line, column, cell): &(u64, &str, String)| format!("line {line}, {column}: {cell}");
            let mut text: Vec<String> = cells.iter().map(cell).collect();
            if more > 0 {
                text.push(format!("and {more} more"));
            }
            format!("Left out, since they are not numbers: {}.", text.join("; "))
        };
        root_mean_square = "rms";
        rows_compared = "rows";
        largest_difference = "max diff";
        at_driver = "at";
        of_largest = "of largest";
        beyond_rounding = "beyond";
    }
}
