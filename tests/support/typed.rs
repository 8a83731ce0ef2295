//! Numbers with few digits, as typed by a user.

/// Returns a nearby number that is known exactly: one with at most 15 digits that a double
/// represents. Any other number may be half an ulp off the intended one, which widens its bounds.
pub(crate) fn short(v: f64) -> f64 {
    if v == 0.0 {
        return v;
    }
    // A number with this many binary places has as many decimal places.
    let places = 14 - v.abs().log10().floor() as i32;
    let unit = 2.0_f64.powi(places.max(0));
    (v * unit).round() / unit
}
