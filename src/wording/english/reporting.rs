//! The report: drawing, polygons, tables and plots around the working.

use super::English;

catalogue! {
    /// What is said around the pictures and tables of a report.
    trait ReportingWords for English {
        language = "en";

        // How it begins.
        unit_vectors_are =
            "With the unit vectors μ(θ) along an angle and ν(θ) at right angles to it, to its left:";

        // Vector polygons and their tables.
        polygon_drawn(sum: &str) = "The vector polygon {sum} = 0, to scale; angles stand at the tails.";
        polygon_of_loop(number: usize, sum: &str) =
            "Loop {number}: the vector polygon {sum} = 0, to scale; angles stand at the tails.";
        loop_number(number: usize) = "loop {number}";
        tables_asked = "Given, and with a mark of question what is sought:";
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
        forces_drawn = "Loads, and the forces that joints and guides bear.";
        plots_part = "Over the whole motion";
        positions_plotted = "Positions";
        velocities_plotted = "Velocities";
        accelerations_plotted = "Accelerations";
        plotted_are(what: &str, names: &str) = "{what}: {names}.";
        facts_part = "The mechanism";

        // In the workbench.
        report = "report";
        write_a_report = "write a report";
        the_report = "the report";
    }
}
