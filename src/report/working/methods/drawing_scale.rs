//! The scale of a drawing on paper, and the precision of values read from it.

use super::super::context::Context;
use crate::Vec2;
use crate::scene::Unit;

/// The total error of a pencil line, the compass and the eye, in mm on paper.
const BLUR: f64 = 0.2;
/// The usable area of an A4 sheet, in mm.
const SHEET: [f64; 2] = [250.0, 170.0];
/// Scales are these numbers times a power of ten.
const STEPS: [f64; 3] = [1.0, 2.0, 5.0];

/// A sheet with its scale.
pub(super) struct DrawingSheet {
    /// The length in mm represented by 1 mm on paper.
    reduced: f64,
    /// The scene's unit in mm.
    unit: f64,
}

impl DrawingSheet {
    /// Chooses the largest usual scale at which all points fit on the sheet.
    pub(super) fn of(context: &Context<'_>) -> DrawingSheet {
        let unit = context.scene.unit.in_units_of(Unit::Millimetre);
        let points = context.scene.mechanism.point_ids();
        let places = points.map(|point| context.state.position(point));
        let (mut low, mut high) = (Vec2::new(f64::MAX, f64::MAX), Vec2::new(f64::MIN, f64::MIN));
        for at in places.filter(|at| at.x.is_finite() && at.y.is_finite()) {
            low = Vec2::new(low.x.min(at.x), low.y.min(at.y));
            high = Vec2::new(high.x.max(at.x), high.y.max(at.y));
        }
        let sides = [high.x - low.x, high.y - low.y].map(|side| side * unit);
        let [long, short] = if sides[0] >= sides[1] {
            sides
        } else {
            [sides[1], sides[0]]
        };
        let needed = (long / SHEET[0]).max(short / SHEET[1]);
        let scales = (-9..=12).flat_map(|power| STEPS.map(|step| step * 10.0_f64.powi(power)));
        let reduced = scales
            .into_iter()
            .find(|&scale| scale >= needed)
            .unwrap_or(1.0);
        DrawingSheet { reduced, unit }
    }

    /// Formats the scale: `1:5`, `2:1`.
    pub(super) fn scale(&self) -> String {
        if self.reduced >= 1.0 {
            format!("1:{:.0}", self.reduced)
        } else {
            format!("{:.0}:1", self.reduced.recip())
        }
    }

    /// Formats a length on paper, in mm to a tenth.
    pub(super) fn length(&self, length: f64) -> String {
        let length = length * self.unit / self.reduced;
        format!("{:.1}", if length.abs() < 0.05 { 0.0 } else { length })
    }

    /// Returns the uncertainty of an intersection in the scene's unit; `sine` is that of the angle
    /// between the lines.
    pub(super) fn blur(&self, sine: f64) -> f64 {
        BLUR * self.reduced / self.unit / sine.abs()
    }
}

/// Formats a value with no more decimals than are known, and its uncertainty.
pub(super) fn read_off(value: f64, blur: f64) -> [String; 2] {
    if !(blur.is_finite() && blur < 1e6) {
        return ["-".into(), "-".into()];
    }
    let places = (-blur.log10()).ceil().clamp(0.0, 9.0) as usize;
    [value, blur].map(|v| format!("{v:.places$}"))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn read_off_value_has_only_readable_decimals() {
        assert_eq!(read_off(29.379_46, 0.38), ["29.4", "0.4"]);
        assert_eq!(read_off(412.6, 2.1), ["413", "2"]);
        assert_eq!(read_off(0.123_456, 0.004), ["0.123", "0.004"]);
        assert_eq!(read_off(1.0, f64::INFINITY), ["-", "-"]);
    }

    #[test]
    fn scales_are_written_as_on_drawings() {
        let sheet = |reduced| DrawingSheet {
            reduced,
            unit: 10.0,
        };
        assert_eq!(
            [5.0, 0.5, 100.0].map(|r| sheet(r).scale()),
            ["1:5", "2:1", "1:100"]
        );
        // 30 cm at 1:5.
        assert_eq!(sheet(5.0).length(30.0), "60.0");
        assert!((sheet(5.0).blur(0.5) - 0.2).abs() < 1e-12);
    }
}
