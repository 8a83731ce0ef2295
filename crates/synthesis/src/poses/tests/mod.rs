//! Tests of linkages with a known solution: their poses lead back to them.

mod five;
mod four;
mod near;
mod newton;
mod none;
mod planted;
mod three;
