//! Bilinear forms in the homogeneous coordinates of a pin and of its pivot.

use super::space::Triple;
use kinematics::{Double, Vec2};

/// `[i][k]` stands before the pin's coordinate i times the pivot's coordinate k.
pub(super) type Form = [[Double; 3]; 3];

/// An equation that says no more beside the others than so many times what the rounding of the poses may say, says
/// nothing.
const NOTHING: f64 = 8.0;
/// What arithmetic in twice the digits leaves of nothing, as a part of the largest form.
const ROUNDING: f64 = 1e-28;

/// The equation of a dyad at a pose, but for its constant k: see [`super::dyad`].
///
/// `Re(conj(d) e w) = Re(conj(f) w)` with `f = conj(e) d`.
pub(super) fn of_pose(d: Vec2<Double>, e: Vec2<Double>) -> Form {
    let f = d.turned(e.conj());
    [
        [-e.x, -e.y, f.x],
        [e.y, -e.x, f.y],
        [-d.x, -d.y, d.norm2().scaled(0.5)],
    ]
}

/// `a - factor b`.
pub(super) fn minus(a: &Form, b: &Form, factor: Double) -> Form {
    std::array::from_fn(|i| std::array::from_fn(|k| a[i][k] - factor * b[i][k]))
}

fn product(a: &Form, b: &Form) -> Double {
    let pairs = a.iter().flatten().zip(b.iter().flatten());
    pairs.fold(Double::ZERO, |sum, (x, y)| sum + *x * *y)
}

/// Forms that say the same as these, of length one and orthogonal, those that say most first: poses that nearly repeat
/// differ by little, and what they differ by counts as much as the rest. `error` is what the rounding of the poses may
/// make of each; what it may make of the one that says least, of length one, comes second.
pub(super) fn independent(mut forms: Vec<Form>, error: f64) -> (Vec<Form>, f64) {
    let mut found: Vec<Form> = Vec::with_capacity(forms.len());
    let length = |form: &Form| product(form, form).sqrt();
    let most = forms.iter().map(|form| length(form).hi).fold(0.0, f64::max);
    let mut least = most;
    while let Some(next) =
        (0..forms.len()).max_by(|&a, &b| length(&forms[a]).hi.total_cmp(&length(&forms[b]).hi))
    {
        let form = forms.swap_remove(next);
        let size = length(&form);
        if !(size.hi > (NOTHING * error).max(ROUNDING * most)) {
            break;
        }
        least = size.hi;
        let unit = form.map(|row| row.map(|c| c / size));
        for other in &mut forms {
            // Twice: the first leaves what it rounds.
            for _ in 0..2 {
                let part = product(other, &unit);
                *other = minus(other, &unit, part);
            }
        }
        found.push(unit);
    }
    (found, error / least)
}

/// How much of these forms of length one is of moves: all but what is of turns.
pub(super) fn moving(forms: &[Form]) -> f64 {
    let part = |form: &Form| {
        let [[_, _, a], [_, _, b], [c, d, e]] = form.map(|row| row.map(|c| c.hi));
        a * a + b * b + c * c + d * d + e * e
    };
    forms.iter().map(part).sum()
}

/// With the pivot given: linear in the pin.
pub(super) fn of_pivot(form: &Form, pivot: Triple) -> Triple {
    form.map(|row| super::space::dot(row, pivot))
}

/// With the pin given: linear in the pivot.
pub(super) fn of_pin(form: &Form, pin: Triple) -> Triple {
    std::array::from_fn(|k| pin[0] * form[0][k] + pin[1] * form[1][k] + pin[2] * form[2][k])
}

/// The column of the pivot's coordinate k: a linear form of the pin.
pub(super) fn columns(form: &Form) -> [Triple; 3] {
    std::array::from_fn(|k| [form[0][k], form[1][k], form[2][k]])
}

/// The form for pins in a frame with this direction as its x axis.
pub(super) fn turned(form: &Form, direction: Vec2<Double>) -> Form {
    let (c, s) = (direction.x, direction.y);
    let [x, y, w] = *form;
    [
        std::array::from_fn(|k| c * x[k] + s * y[k]),
        std::array::from_fn(|k| c * y[k] - s * x[k]),
        w,
    ]
}

/// A pin of that frame, as it is in the first.
pub(super) fn turned_back(pin: Triple, direction: Vec2<Double>) -> Triple {
    let place = Vec2::new(pin[0], pin[1]).turned(direction);
    [place.x, place.y, pin[2]]
}
