//! Bilinear forms in the homogeneous coordinates of a pin and of its pivot.

use super::space::Triple;
use kinematics::{Double, Vec2};

/// A bilinear form: `[i][k]` is the coefficient of the pin's coordinate i times the pivot's
/// coordinate k.
pub(super) type Form = [[Double; 3]; 3];

/// Multiple of the poses' rounding error below which an equation's part independent of the others
/// means nothing.
const NOTHING: f64 = 8.0;
/// Double-double rounding error of a form, relative to the largest form.
const ROUNDING: f64 = 1e-28;

/// Returns the equation of a dyad at a pose, without its constant k: see [`super::dyad`].
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

/// Returns `a - factor b`.
pub(super) fn minus(a: &Form, b: &Form, factor: Double) -> Form {
    std::array::from_fn(|i| std::array::from_fn(|k| a[i][k] - factor * b[i][k]))
}

fn product(a: &Form, b: &Form) -> Double {
    let pairs = a.iter().flatten().zip(b.iter().flatten());
    pairs.fold(Double::ZERO, |sum, (x, y)| sum + *x * *y)
}

/// Returns an orthonormal basis of the forms, largest first, and the relative error of its smallest
/// member.
///
/// Poses that nearly repeat differ by little, and normalising gives these differences full weight.
/// `error` is the effect of the poses' rounding on each form; the returned error is its effect on
/// the smallest form after normalising.
pub(super) fn independent(mut forms: Vec<Form>, error: f64) -> (Vec<Form>, f64) {
    let mut found: Vec<Form> = Vec::with_capacity(forms.len());
    let length = |form: &Form| product(form, form).sqrt();
    let maximum = forms.iter().map(|form| length(form).hi).fold(0.0, f64::max);
    let mut minimum = maximum;
    while let Some(next) =
        (0..forms.len()).max_by(|&a, &b| length(&forms[a]).hi.total_cmp(&length(&forms[b]).hi))
    {
        let form = forms.swap_remove(next);
        let size = length(&form);
        if !(size.hi > (NOTHING * error).max(ROUNDING * maximum)) {
            break;
        }
        minimum = size.hi;
        let unit = form.map(|row| row.map(|c| c / size));
        for other in &mut forms {
            // Twice, since the first pass leaves its rounding error.
            for _ in 0..2 {
                let part = product(other, &unit);
                *other = minus(other, &unit, part);
            }
        }
        found.push(unit);
    }
    (found, error / minimum)
}

/// Returns the squared size of the translation part of these normalised forms: all coefficients
/// except those of the rotation.
pub(super) fn moving(forms: &[Form]) -> f64 {
    let part = |form: &Form| {
        let [[_, _, a], [_, _, b], [c, d, e]] = form.map(|row| row.map(|c| c.hi));
        a * a + b * b + c * c + d * d + e * e
    };
    forms.iter().map(part).sum()
}

/// Evaluates a form at a pivot, which gives a linear form of the pin.
pub(super) fn of_pivot(form: &Form, pivot: Triple) -> Triple {
    form.map(|row| super::space::dot(row, pivot))
}

/// Evaluates a form at a pin, which gives a linear form of the pivot.
pub(super) fn of_pin(form: &Form, pin: Triple) -> Triple {
    std::array::from_fn(|k| pin[0] * form[0][k] + pin[1] * form[1][k] + pin[2] * form[2][k])
}

/// Returns the columns of the pivot's coordinates, each a linear form of the pin.
pub(super) fn columns(form: &Form) -> [Triple; 3] {
    std::array::from_fn(|k| [form[0][k], form[1][k], form[2][k]])
}

/// Returns the form for pins in a frame with this direction as its x axis.
pub(super) fn turned(form: &Form, direction: Vec2<Double>) -> Form {
    let (c, s) = (direction.x, direction.y);
    let [x, y, w] = *form;
    [
        std::array::from_fn(|k| c * x[k] + s * y[k]),
        std::array::from_fn(|k| c * y[k] - s * x[k]),
        w,
    ]
}

/// Converts a pin from that frame to the original one.
pub(super) fn turned_back(pin: Triple, direction: Vec2<Double>) -> Triple {
    let position = Vec2::new(pin[0], pin[1]).turned(direction);
    [position.x, position.y, pin[2]]
}
