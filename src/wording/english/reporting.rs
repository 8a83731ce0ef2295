//! The report: drawing, polygons, tables and plots around the working.

use super::English;

catalogue! {
    /// What is said around the pictures and tables of a report.
    trait ReportingWords for English {
        language_tag = "en";

        // How it begins.
        unit_vectors_are(along: &str, across: &str) =
            "With the unit vectors {along} along an angle and {across} at right angles to it, to its left:";

        // Vector polygons and their tables.
        polygon_drawn(sum: &str) =
            "The vector polygon {sum} = 0, to scale";
        polygon_of_loop(number: usize, sum: &str) =
            "Loop {number}: the vector polygon {sum} = 0, to scale";
        dashes_and_arcs = "; dashed where something is sought, angles at their tails.";
        points_against(vector: &str, theta: &str) =
            "{vector} < 0: its arrow points against {theta}.";
        loop_number(number: usize) = "loop {number}";
        found_by_loop(number: usize) = "from loop {number}";
        tables_asked = "Given, and with a question mark what is sought:";
        tables_told = "Given, and behind their symbols the figures that were found:";

        // Velocities and accelerations of points.
        points_to_scale = "Points to scale";
        direction_in_degrees = "at [deg]";
        velocities_of_joints = "Velocities of the joints from one pole, to scale.";
        velocities_of_centres = "Velocities of the centres of mass from one pole, to scale.";
        accelerations_of_joints =
            "Accelerations of the joints from one pole, to scale; n is a normal part, t a tangential one.";
        accelerations_of_centres =
            "Accelerations of the centres of mass from one pole, to scale; n is a normal part, t a \
             tangential one.";

        // Forces, plots and facts.
        link_cut_free(link: &str) = "{link} cut free, with all that acts on it, its inertia among it; short arrows are drawn longer.";
        centres_drawn =
            "Instant centres, and the lines on which they lie; one that lies far away is not drawn.";
        forces_drawn = "Loads, and the forces that joints and guides bear.";
        plots_part = "Over the whole motion";
        positions_plotted = "Positions";
        velocities_plotted = "Velocities";
        accelerations_plotted = "Accelerations";
        plotted_are(what: &str, names: &str) = "{what}: {names}.";
        facts_part = "The mechanism";

        // On the command line.
        does_report = "Write a report to hand in: drawing, polygons, tables, working and plots of one angle";
        format_of_report = "How to write it [default: by the file's ending, or html]";
        format_html = "One HTML file with its pictures inside, for a browser and for paper";
        format_latex = "LaTeX for a plain TeX Live, its pictures in TikZ";
        examples_of_report = "\
Examples:
  krank report four-bar --at 60 -o four-bar.html
  krank report slider-crank --at 30 --digits 9 -o slider-crank.tex
  krank report press --format markdown --notation krank

The drawing; the vector polygon of every loop to scale; position, velocity and
acceleration tables with a column per vector, empty (theta3 = ?) and then
filled; the working of `krank explain` with the unit vectors mu and nu of the
lectures; velocities and accelerations of joints and centres of mass from one
pole, to scale; instant centres; forces where anything acts; plots over the whole motion; and
what `krank check` tells. An ending .html, .tex, .md or .txt chooses the format;
any other needs --format beside it.";

        no_report_has_ending(ending: &str) =
            "no report has the ending .{ending}; .html, .tex, .md and .txt have one, and --format writes it to any file";
        notation_of_working = "What unit vectors are called";
        notation_lecture = "mu and nu, as the lectures write them";
        notation_krank = "u and n";

        // In the workbench.
        report = "report";
        too_many_links_to_report = "too many links to report on here: krank report does it";
        write_a_report = "write a report";
        the_report = "the report";

        // Beside the figures of others.
        beside_file(file: &str) = "Beside {file}";
        beside_list(file: &str) =
            "The figures of {file} and krank's; `agrees` where the digits that stand there tell no difference.";
        beside_course(file: &str, rows: usize) =
            "The columns of {file} beside krank's, over {rows} rows: of each the root mean square of the differences, the largest one, where that is, \
             what part it is of the largest figure, and in how many rows the difference is beyond rounding.";
        foreign_difference = "difference";
        part_of_it = "of it";
        agrees = "agrees";
        not_compared(names: &str) =
            "Not compared, since krank has no such figure here, or in no such unit: {names}.";
        cells_left_out(cells: &[(u64, &str, String)], more: usize) = {
            let cell = |(line, column, cell): &(u64, &str, String)| format!("line {line}, {column}: {cell}");
            let mut told: Vec<String> = cells.iter().map(cell).collect();
            if more > 0 {
                told.push(format!("and {more} more"));
            }
            format!("Left out, since these are no numbers: {}.", told.join("; "))
        };
        root_mean_square = "rms";
        rows_compared = "rows";
        largest_difference = "most off";
        at_driver = "at";
        of_largest = "of largest";
        beyond_rounding = "beyond";
    }
}
