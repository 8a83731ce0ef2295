//! The built-in tasks.

/// A task built into the program.
#[derive(Clone, Copy, Debug)]
pub struct ExampleTask {
    /// The name on the command line.
    pub name: &'static str,
    /// The task file's text.
    pub text: &'static str,
}

macro_rules! tasks {
    ($($name:literal)*) => {
        &[$(ExampleTask {
            name: $name,
            text: include_str!(concat!("../../presets/tasks/", $name, ".toml")),
        }),*]
    };
}

static EXAMPLES: &[ExampleTask] = tasks! {
    "wiper"
    "hatch"
    "logarithm"
    "straight-line"
    "stirrer"
};

impl ExampleTask {
    /// Returns all built-in tasks, in their order in lists.
    #[must_use]
    pub fn all() -> &'static [ExampleTask] {
        EXAMPLES
    }

    /// Returns the built-in task of this name.
    #[must_use]
    pub fn find(name: &str) -> Option<&'static ExampleTask> {
        EXAMPLES.iter().find(|task| task.name == name)
    }
}
