//! One-line descriptions of the manual's topics; the texts are separate documents.

use super::English;

catalogue! {
    /// A one-line description of each topic.
    trait ManualWords for English {
        topic_told(about: &str, turkish: &str) = "{about}";
        about_tutorial = "from an empty file to a six-bar";
        about_how = "how do I ...? thirty questions, each with a command or key";
        about_scene = "the scene file: an example, and every key";
        about_views = "what the workbench shows, view by view";
        about_keys = "all keys of the workbench, and how to change them";
        about_columns = "named values: units, bounds, sensitivity, ranges";
        about_designs = "many designs of a scene: grids, samples, charts, long runs";
        about_synthesis = "linkages for a desired motion: tasks, preferences, defects";
        about_forces = "loads, joint forces, and the motor's torque or force";
        about_tolerances = "effects of length tolerances and pin clearances";
        about_drawings = "drawings and plots, for the terminal and for a report";
        about_import = "files of PMKS, PMKS+, Linkage, Pyslvs and pylinkage";
        about_files = "saving, unsaved edits, exit codes, exercises";
        about_trust = "assemblies, ends of motion, bounds: guarantees and tests";
        about_terminals = "characters, colours, slow lines, cost of a frame";
        about_limits = "what krank cannot do, and limits of its results";
        about_glossary = "terms of mechanisms and of krank";
    }
}
