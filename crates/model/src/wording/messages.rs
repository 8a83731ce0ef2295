//! The languages, the trait of all messages and its implementations, as the build script writes them.

use std::fmt::{Display, LowerExp};

include!(concat!(env!("OUT_DIR"), "/words.rs"));
