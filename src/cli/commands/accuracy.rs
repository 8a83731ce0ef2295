//! `krank accuracy`: runs the accuracy study and writes its findings.

use super::args::{AccuracyArgs, OutputFormat};
use super::failure::Failure;
use super::output::write_to;
use super::progress::Progress;
use super::screen::TextScreen;
use super::source::{SolvableScene, open_for};
use crate::drawing::{Glyphs, trade_off};
use crate::report::{Accuracy, accuracy_notes};
use crate::study::{Findings, Study};
use crate::wording::words;
use std::time::{Duration, Instant};

/// Time between two progress reports.
const SLICE: Duration = Duration::from_millis(50);
/// Resolution of the progress.
const PARTS: u64 = 1000;
/// Size of the chart below the table, in columns and rows.
const CHART: (u16, u16) = (80, 20);

pub(super) fn accuracy(args: &AccuracyArgs, screen: TextScreen) -> Result<(), Failure> {
    let dialect = args.csv.dialect(args.format)?;
    let SolvableScene { scene, solver } =
        open_for(&args.scene, &args.assembly.wishes, &args.output)?;
    let study = Study::new(&solver, args.positions);
    let findings = measured(study, screen);
    let accuracy = Accuracy {
        scene: &scene,
        findings: &findings,
    };
    write_to(args.output.output.as_deref(), |out| match args.format {
        OutputFormat::Text => {
            let table = accuracy.to_text(screen.ascii);
            let notes = screen.shown(&accuracy_notes());
            write!(out, "{table}\n{}\n{notes}", chart(&findings))
        }
        OutputFormat::Csv => accuracy.write_csv(dialect, out),
        OutputFormat::Json => writeln!(out, "{:#}", accuracy.to_json()),
    })
}

fn measured(mut study: Study, screen: TextScreen) -> Findings {
    let begun = Instant::now();
    // Results are written only at the end, so the progress line disturbs no output.
    let mut progress = Progress::new(PARTS, words().parts(), screen, false);
    while study.advance(&mut || begun.elapsed(), SLICE) {
        #[expect(
            clippy::cast_possible_truncation,
            clippy::cast_sign_loss,
            reason = "from 0 to 1 times a thousand"
        )]
        progress.tell((study.progress() * PARTS as f64) as u64);
    }
    progress.end();
    study.findings()
}

fn chart(findings: &Findings) -> String {
    let (cols, rows) = CHART;
    trade_off(findings).render(cols, rows, Glyphs::Ascii).text()
}
