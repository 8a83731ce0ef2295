//! Planted linkages: their own poses lead back to them.

mod five;
mod four;
mod newton;
mod planted;
mod three;
