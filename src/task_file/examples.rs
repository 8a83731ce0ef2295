//! The tasks that are built in.

/// A task built into the program.
#[derive(Clone, Copy, Debug)]
pub struct ExampleTask {
    /// As it is called on the command line.
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
    /// All of them, in the order in which they are listed.
    #[must_use]
    pub fn all() -> &'static [ExampleTask] {
        EXAMPLES
    }

    /// The one of this name.
    #[must_use]
    pub fn find(name: &str) -> Option<&'static ExampleTask> {
        EXAMPLES.iter().find(|task| task.name == name)
    }
}
