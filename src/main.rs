//! The program `krank`.

use std::process::ExitCode;

fn main() -> ExitCode {
    krank::cli::run(std::env::args_os())
}
