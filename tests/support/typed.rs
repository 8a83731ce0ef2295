//! Numbers as a person types them.

/// A number near to this one that is known exactly: one of up to 15 digits that a double holds. Any other could
/// have been meant to be half an ulp elsewhere, and its bounds say so.
pub(crate) fn short(v: f64) -> f64 {
    if v == 0.0 {
        return v;
    }
    // So many binary places make so many decimal ones.
    let places = 14 - v.abs().log10().floor() as i32;
    let unit = 2.0_f64.powi(places.max(0));
    (v * unit).round() / unit
}
