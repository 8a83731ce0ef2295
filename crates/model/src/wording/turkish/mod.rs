//! Turkish messages that are more than a text of `turkish.txt`.

pub(super) mod grammar;
mod parser;
mod presets;
mod syntax;
mod translations {
    include!(concat!(env!("OUT_DIR"), "/translations.rs"));
}
