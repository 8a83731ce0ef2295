//! The workbench.
#![allow(dead_code, unused_imports)]
mod key;
mod terminal;
