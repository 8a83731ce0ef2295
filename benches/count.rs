//! Counts the instructions of the solver's hot paths beside those of the closed forms, and fails where
//! a path takes more of them than it may.
//!
//! Counts do not depend on what else the machine does, so that they can be held to limits where times
//! cannot. The program runs itself under valgrind, once for each way and mechanism; where there is no
//! valgrind it says so and leaves it at that.
#![allow(clippy::print_stdout, reason = "the counts are to be read")]

mod both;
mod handwritten;

use both::{Agreement, Figures, General, SWEEP, Visitor, angles, closed_form, visit_all};
use std::env;
use std::process::{Command, ExitCode, Stdio};

/// A way to run through a sweep, and how many times the closed form's instructions it may take: for each mechanism
/// what was counted when the limit was set, and a twentieth more.
struct RunVariant {
    name: &'static str,
    most: [f64; MECHANISMS.len()],
}

#[cfg(target_arch = "x86_64")]
fn has_avx2() -> bool {
    std::is_x86_feature_detected!("avx2")
}

#[cfg(not(target_arch = "x86_64"))]
fn has_avx2() -> bool {
    false
}

const MECHANISMS: [&str; 4] = ["four-bar", "slider-crank", "press", "jansen-leg"];
const WAYS: [RunVariant; 5] = [
    RunVariant {
        name: "solved",
        most: [1.48, 1.87, 1.38, 1.32],
    },
    RunVariant {
        name: "solved-and-read",
        most: [2.10, 2.57, 1.98, 1.95],
    },
    RunVariant {
        name: "in-lanes",
        most: [0.40, 0.45, 0.37, 0.36],
    },
    RunVariant {
        name: "in-lanes-and-read",
        most: [0.67, 0.78, 0.69, 0.71],
    },
    RunVariant {
        name: "with-bounds",
        most: [5.7, 7.4, 6.2, 6.4],
    },
];
const HANDWRITTEN: &str = "by-hand";

/// Runs one way once, without anything else that is not small beside it.
struct Counted<'a> {
    mechanism: &'a str,
    variant: &'a str,
}

impl Visitor for Counted<'_> {
    fn visit<const P: usize, const L: usize>(
        &mut self,
        name: &str,
        general: &General<P, L>,
        form: impl Fn(f64) -> Figures<P, L>,
        _: impl Fn(f64) -> Figures<P, L>,
    ) {
        if name != self.mechanism {
            return;
        }
        let angles = angles();
        let (mut state, mut lanes) = (general.solver.state(), general.solver.lanes());
        let mut enclosure = general.solver.enclosure();
        match self.variant {
            HANDWRITTEN => counted(|| closed_form(&form, &angles)),
            "solved" => counted(|| general.sweep(&angles, &mut state)),
            "solved-and-read" => counted(|| general.sweep_and_read(&angles, &mut state)),
            "in-lanes" => counted(|| general.sweep_in_lanes(&angles, &mut lanes)),
            "in-lanes-and-read" => {
                counted(|| general.sweep_in_lanes_and_read(&angles, &mut lanes));
            }
            "with-bounds" => {
                counted(|| general.sweep_with_bounds(&angles, &mut state, &mut enclosure));
            }
            other => panic!("no way is named {other}"),
        }
    }
}

/// Only here does valgrind count.
#[inline(never)]
fn counted(mut sweep: impl FnMut()) {
    sweep();
}

/// Instructions per position.
fn count(mechanism: &str, variant: &str) -> Result<f64, String> {
    let itself = env::current_exe().map_err(|e| e.to_string())?;
    let output = Command::new("valgrind")
        .args(["--tool=callgrind", "--callgrind-out-file=/dev/null"])
        .args(["--collect-atstart=no", "--toggle-collect=count::counted*"])
        .arg(itself)
        .args([mechanism, variant])
        .output()
        .map_err(|e| e.to_string())?;
    let printed = String::from_utf8_lossy(&output.stderr);
    let collected = printed
        .lines()
        .find_map(|line| line.split_once("Collected : "));
    match collected.and_then(|(_, count)| count.trim().parse::<f64>().ok()) {
        Some(count) if count > 0.0 && output.status.success() => Ok(count / SWEEP as f64),
        _ => Err(format!("valgrind counted nothing:\n{printed}")),
    }
}

/// Prints the counts; whether all keep to their limits.
fn compare() -> Result<bool, String> {
    println!("instructions per position, and as parts of the closed form's (the most allowed)");
    let mut kept = true;
    for (i, mechanism) in MECHANISMS.into_iter().enumerate() {
        let hand = count(mechanism, HANDWRITTEN)?;
        println!("{mechanism}\n  {HANDWRITTEN:<18}{hand:>7.0}");
        for RunVariant { name, most } in &WAYS {
            let solved = count(mechanism, name)?;
            let (part, most) = (solved / hand, most[i]);
            let verdict = if part <= most { "" } else { "  too many" };
            println!("  {name:<18}{solved:>7.0}{part:>7.2}  ({most}){verdict}");
            // Without AVX2 everything takes more instructions, and nothing is promised.
            kept &= part <= most || !has_avx2();
        }
    }
    Ok(kept)
}

fn has_valgrind() -> bool {
    let mut requested = Command::new("valgrind");
    requested.arg("--version").stdout(Stdio::null());
    requested.status().is_ok_and(|status| status.success())
}

fn main() -> ExitCode {
    let arguments: Vec<String> = env::args().skip(1).collect();
    if let [mechanism, variant] = &arguments[..] {
        visit_all(&mut Counted { mechanism, variant });
        return ExitCode::SUCCESS;
    }
    visit_all(&mut Agreement);
    // `cargo test --benches` runs this too, in a build whose counts mean nothing.
    if !arguments.iter().any(|argument| argument == "--bench") {
        return ExitCode::SUCCESS;
    }
    if !has_valgrind() {
        println!("no valgrind here: instructions are not counted");
        return ExitCode::SUCCESS;
    }
    match compare() {
        Ok(true) => ExitCode::SUCCESS,
        Ok(false) => ExitCode::FAILURE,
        Err(message) => {
            println!("{message}");
            ExitCode::FAILURE
        }
    }
}
