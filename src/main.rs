//! The program `krank`.

fn main() {}
