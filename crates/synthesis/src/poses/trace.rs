//! Traces a run of a curve in equally spaced spots, independent of its parameter's speed, in pieces
//! cut where it passes through infinity.

use super::four::Run;
use super::space::Triple;

/// Maximum angle between neighbouring spots as directions in space, in radians, for both pin and
/// pivot. Near the middle this is a part of the size.
const STEP: f64 = 0.03;
/// Number of initial intervals of a run.
const FIRST: u8 = 48;
/// Maximum number of bisections. Neighbours that are still far apart then have a gap between them.
const MAX_HALVINGS: u8 = 40;
/// Maximum number of spots of a run, far more than any curve needs.
const MAX_SPOTS: usize = 6000;

/// Absolute value of the third coordinate, with coordinates of size one, below which it is zero up
/// to rounding.
const INFINITE: f64 = 1e-12;

/// A solution of the equations.
#[derive(Clone, Copy)]
pub(super) struct CurveSpot {
    pub pin: Triple,
    pub pivot: Triple,
    /// The drawn coordinates of both: relative to the body's origin, and to the middle of the
    /// poses.
    pub seen: [Triple; 2],
}

/// Successive spots without a point at infinity between them.
#[derive(Default)]
pub(super) struct Piece {
    pub spots: Vec<CurveSpot>,
    /// Whether the pivot comes from infinity at the beginning.
    pub starts_at_infinity: bool,
    /// Whether the pivot goes to infinity at the end.
    pub ends_at_infinity: bool,
}

/// Returns the pieces of a run: `spot` returns the solution at s degrees of it, for s from 0 to
/// 360.
pub(super) fn pieces(run: &Run, spot: impl Fn(f64) -> Option<CurveSpot>) -> Vec<Piece> {
    if let Run::Over { low, high, .. } = run
        && (low.hi, low.lo) == (high.hi, high.lo)
    {
        let spots: Vec<CurveSpot> = spot(0.0).into_iter().collect();
        return vec![Piece {
            spots,
            ..Piece::default()
        }];
    }
    let mut all = Vec::new();
    for part in parts(run) {
        let spots = spots(part, &spot);
        let is_closed = part == [0.0, 360.0];
        all.extend(cut(spots, is_closed));
    }
    all
}

/// Returns the parameter ranges of a run, in degrees. A run open at its upper end begins there; a
/// run open at its lower end has two ranges.
fn parts(run: &Run) -> Vec<[f64; 2]> {
    match run {
        Run::Over {
            is_closed: [false, _],
            ..
        } => vec![[0.0, 180.0], [180.0, 360.0]],
        Run::Over {
            is_closed: [true, false],
            ..
        } => vec![[0.0, 360.0 - 1e-9]],
        Run::Over {
            is_closed: [true, true],
            ..
        }
        | Run::Line(_) => vec![[0.0, 360.0]],
    }
}

fn spots([from, to]: [f64; 2], spot: &impl Fn(f64) -> Option<CurveSpot>) -> Vec<Option<CurveSpot>> {
    let at = |k: u8| from + (to - from) * (f64::from(k) / f64::from(FIRST));
    let mut all = vec![spot(from)];
    for k in 0..FIRST {
        let last = all.last().copied().flatten();
        refine(
            (at(k), last),
            (at(k + 1), spot(at(k + 1))),
            MAX_HALVINGS,
            spot,
            &mut all,
        );
    }
    all
}

/// Adds the spots after `a` up to `b`. `None` marks a gap that could not be reached.
fn refine(
    a: (f64, Option<CurveSpot>),
    b: (f64, Option<CurveSpot>),
    halvings: u8,
    spot: &impl Fn(f64) -> Option<CurveSpot>,
    all: &mut Vec<Option<CurveSpot>>,
) {
    let is_near = match (&a.1, &b.1) {
        (Some(a), Some(b)) => {
            let mut pairs = a.seen.iter().zip(&b.seen);
            pairs.all(|(a, b)| angle(a, b) <= STEP)
        }
        (None, _) | (_, None) => true,
    };
    if is_near {
        all.push(b.1);
    } else if halvings == 0 || all.len() > MAX_SPOTS {
        all.extend([None, b.1]);
    } else {
        let middle = 0.5 * (a.0 + b.0);
        let between = (middle, spot(middle));
        refine(a, between, halvings - 1, spot, all);
        refine(between, b, halvings - 1, spot, all);
    }
}

/// Returns the angle between two directions, up to their sign, by its sine, which is small.
fn angle(a: &Triple, b: &Triple) -> f64 {
    let [a, b] = [a, b].map(|v| v.map(|c| c.hi));
    let length = |v: [f64; 3]| v[0].hypot(v[1]).hypot(v[2]);
    let product = [
        a[1] * b[2] - a[2] * b[1],
        a[2] * b[0] - a[0] * b[2],
        a[0] * b[1] - a[1] * b[0],
    ];
    length(product) / (length(a) * length(b))
}

/// Returns `true` if the shorter path between two neighbours passes through infinity, but not if it
/// stays there.
fn passes_infinity(a: &Triple, b: &Triple) -> bool {
    let dot = (0..3).map(|k| a[k].hi * b[k].hi).sum::<f64>();
    let is_far = |v: &Triple| v[2].hi.abs() < INFINITE;
    dot * a[2].hi * b[2].hi < 0.0 && !(is_far(a) && is_far(b))
}

fn cut(spots: Vec<Option<CurveSpot>>, is_closed: bool) -> Vec<Piece> {
    let is_whole = is_closed && spots.iter().all(Option::is_some);
    let mut pieces: Vec<Piece> = Vec::new();
    let mut piece = Piece::default();
    for spot in spots {
        let Some(spot) = spot else {
            pieces.push(std::mem::take(&mut piece));
            continue;
        };
        if let Some(last) = piece.spots.last() {
            let is_slide = passes_infinity(&last.pivot, &spot.pivot);
            if is_slide || passes_infinity(&last.pin, &spot.pin) {
                piece.ends_at_infinity = is_slide;
                pieces.push(std::mem::take(&mut piece));
                piece.starts_at_infinity = is_slide;
            }
        }
        piece.spots.push(spot);
    }
    // A closed run ends where it began: pieces that are cut only by its arbitrary start are joined.
    match pieces.first_mut() {
        Some(first) if is_whole => {
            piece.spots.pop();
            piece.spots.append(&mut first.spots);
            first.spots = piece.spots;
            first.starts_at_infinity = piece.starts_at_infinity;
        }
        Some(_) | None => pieces.push(piece),
    }
    pieces.retain(|piece| !piece.spots.is_empty());
    pieces
}
