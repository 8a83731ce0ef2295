//! The manual's topics. Their texts are documents of their own.

use super::English;

catalogue! {
    /// In a line, what each topic tells.
    trait ManualWords for English {
        topic_told(about: &str, turkish: &str) = "{about}";
        about_tutorial = "from an empty file to a six-bar";
        about_how = "how do I ...? thirty questions, each with a command or key";
        about_scene = "the scene file: an example, and every key";
        about_views = "what the workbench shows, view by view";
        about_keys = "every key of the workbench, and how to choose others";
        about_columns = "figures by name: units, bounds, sensitivity, ranges";
        about_designs = "many designs of a scene: grids, samples, charts, long runs";
        about_synthesis = "from a motion that is wanted to linkages: tasks, wishes, defects";
        about_forces = "what acts, what the joints bear, what the motor must do";
        about_tolerances = "what lengths that are off and loose pins do to figures";
        about_drawings = "drawings and plots, for the terminal and for a report";
        about_files = "what is written and when, unsaved edits, exit codes, exercises";
        about_trust = "assemblies, ends, bounds: what is promised and how it was tried";
        about_terminals = "characters, colours, slow lines, and what a frame costs";
        about_limits = "what krank does not do, and where its answers end";
        about_glossary = "terms of mechanisms and of krank";
    }
}
