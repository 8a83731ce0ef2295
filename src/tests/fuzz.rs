//! Fuzzes on a stable toolchain: inputs are mutated at random. A mutated input with a new outcome
//! is kept and mutated further.
//!
//! `cargo test` replays the corpus in `tests/corpus` and tries a fixed number of mutated inputs,
//! from a fixed seed. `KRANK_FUZZ=3600 cargo test --release --lib fuzz -- --nocapture` runs for an
//! hour, from a new seed each time, and writes kept inputs to the folder in `KRANK_FUZZ_KEEP`. A
//! failing input is printed, and belongs in the corpus once the bug is fixed.

use super::TestRng;
use std::collections::HashSet;
use std::fs;
use std::hash::{DefaultHasher, Hash, Hasher};
use std::panic::{self, AssertUnwindSafe};
use std::path::Path;
use std::time::{Duration, Instant, SystemTime, UNIX_EPOCH};

/// Maximum length of an input, in bytes: longer ones are slower and find nothing more.
const MAX_LEN: usize = 4096;
/// Maximum time for an input; a longer one counts as a hang, even on a busy machine.
const PATIENCE: Duration = Duration::from_secs(600);

/// A fuzz target and its input.
pub(crate) struct Fuzz<'a> {
    /// The target's name, and that of its folder in the corpus.
    pub(crate) name: &'a str,
    /// Further folders with initial inputs.
    pub(crate) seeds: &'a [&'a str],
    /// Fragments that random bytes rarely form.
    pub(crate) words: &'a [&'a str],
    /// Number of mutated inputs by default.
    pub(crate) runs: u64,
}

impl Fuzz<'_> {
    /// Runs the target on the inputs. The target returns a number that identifies the outcome.
    #[allow(clippy::print_stdout, reason = "the figures are to be read")]
    pub(crate) fn run(&self, target: impl Fn(&[u8]) -> u64) {
        let mut pool = self.corpus();
        assert!(!pool.is_empty(), "no corpus of {}", self.name);
        let mut seen = HashSet::new();
        for input in &pool {
            seen.insert(fed(&target, input));
        }
        let (known, started) = (pool.len(), Instant::now());
        let requested = std::env::var("KRANK_FUZZ").ok();
        let time = requested.and_then(|seconds| seconds.parse().ok());
        let mut rng = TestRng::new(time.map_or(1, |_| now()));
        let mut runs = 0_u64;
        while time.map_or(runs < self.runs, |time| {
            started.elapsed() < Duration::from_secs(time)
        }) {
            let input = self.changed(&pool, &mut rng);
            runs += 1;
            if seen.insert(fed(&target, &input)) {
                keep(self.name, &input);
                pool.push(input);
            }
        }
        println!(
            "{}: {runs} runs in {:.0} s, {known} inputs of the corpus, {} outcomes",
            self.name,
            started.elapsed().as_secs_f64(),
            seen.len()
        );
    }

    fn corpus(&self) -> Vec<Vec<u8>> {
        let root = Path::new(env!("CARGO_MANIFEST_DIR"));
        let own = format!("tests/corpus/{}", self.name);
        let folders = self.seeds.iter().copied().chain([own.as_str()]);
        let mut found = Vec::new();
        for folder in folders {
            let entries = fs::read_dir(root.join(folder)).unwrap();
            let mut files: Vec<_> = entries.map(|entry| entry.unwrap().path()).collect();
            files.retain(|file| file.is_file());
            files.sort();
            found.extend(files.iter().map(|file| fs::read(file).unwrap()));
        }
        found
    }

    /// Returns one of the inputs, changed in a few places.
    fn changed(&self, pool: &[Vec<u8>], rng: &mut TestRng) -> Vec<u8> {
        let mut input = rng.one_of(pool).clone();
        for _ in 0..=rng.below(4) {
            let from = rng.below(input.len() + 1);
            let to = (from + rng.below(1 + max_piece_len(input.len()))).min(input.len());
            let piece: Vec<u8> = match rng.below(8) {
                0 => Vec::new(),
                1 => input[from..to].repeat(2),
                2 => part_of(pool, rng),
                3 | 4 => rng.one_of(self.words).as_bytes().to_vec(),
                5 => rng.one_of(&NUMBERS).as_bytes().to_vec(),
                6 => vec![rng.byte()],
                _ => {
                    let mut piece = input[from..to].to_vec();
                    piece.reverse();
                    piece
                }
            };
            // The piece replaces a range, or is inserted before it.
            let to = if rng.below(2) == 0 { from } else { to };
            input.splice(from..to, piece);
            input.truncate(MAX_LEN);
        }
        input
    }
}

/// Extreme and malformed numbers.
const NUMBERS: [&str; 14] = [
    "0",
    "-0.0",
    "1",
    "-1",
    "1e300",
    "1e-300",
    "5e-324",
    "1e400",
    "nan",
    "inf",
    "0x7f",
    "360",
    "0.1",
    "9999999999999999999999",
];

/// Returns the maximum length of a replaced piece, which is short for short inputs.
fn max_piece_len(length: usize) -> usize {
    (length / 4).clamp(1, 64)
}

fn part_of(pool: &[Vec<u8>], rng: &mut TestRng) -> Vec<u8> {
    let other = rng.one_of(pool);
    let from = rng.below(other.len());
    let to = (from + rng.below(120)).min(other.len());
    other[from..to].to_vec()
}

fn fed(target: &impl Fn(&[u8]) -> u64, input: &[u8]) -> u64 {
    let started = Instant::now();
    let outcome = panic::catch_unwind(AssertUnwindSafe(|| target(input)));
    let took = started.elapsed();
    match outcome {
        Ok(outcome) => {
            let input = input.escape_ascii();
            assert!(took < PATIENCE, "{took:?} for b\"{input}\"");
            outcome
        }
        Err(why) => {
            keep("finding", input);
            eprintln!("found by b\"{}\"", input.escape_ascii());
            panic::resume_unwind(why);
        }
    }
}

fn keep(name: &str, input: &[u8]) {
    let Some(folder) = std::env::var_os("KRANK_FUZZ_KEEP") else {
        return;
    };
    let mut hasher = DefaultHasher::new();
    input.hash(&mut hasher);
    let file = Path::new(&folder).join(format!("{name}-{:016x}", hasher.finish()));
    fs::write(file, input).unwrap();
}

fn now() -> u64 {
    let since = SystemTime::now().duration_since(UNIX_EPOCH).unwrap();
    u64::try_from(since.as_nanos() % u128::from(u64::MAX)).unwrap()
}

/// Returns a message without quoted parts and numbers: messages of equal shape count as one
/// outcome.
pub(crate) fn shape(message: &str) -> String {
    let plain = message.split('`').step_by(2);
    let letters = plain.map(|part| part.replace(|c: char| !c.is_ascii_alphabetic(), ""));
    letters.collect()
}
