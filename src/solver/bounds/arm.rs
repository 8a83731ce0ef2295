//! Bounds of the dyad that places no joint but a direction: an arm that slides through a pin.

use crate::arithmetic::{U, two_product, two_sum};
use crate::solver::state::State;
use crate::solver::step::Swing;
use crate::{Ball, Vec2};

/// What the residual in twice the precision still rounds, in parts of the distance.
const RESIDUAL: f64 = 32.0 * U * U;
/// The part of itself by which the pin's position along the guide may change within the bound.
const CONTRACTION: f64 = 0.25;

impl Swing {
    /// The guide's direction t, as computed, has to be turned by the small angle phi that makes
    /// n.w = e |t|, w from pivot to pin, e the offset. With s = t.w, n.w - e |t| = s sin phi +
    /// n.w (1 - cos phi).
    pub(super) fn enclose<const ORDER: u8>(
        &self,
        state: &State,
        enclosure: &mut State<Ball>,
    ) -> bool {
        let d = state.links[self.link.index()].d;
        let t = self.along.nearest().turned(d);
        let pin = enclosure.points[self.pin.index()].p;
        let pivot = enclosure.points[self.pivot.index()].p;
        let (wx, wx_rest) = two_sum(pin.x.mid, -pivot.x.mid);
        let (wy, wy_rest) = two_sum(pin.y.mid, -pivot.y.mid);
        let wobble = (pin.x.radius + pivot.x.radius) * t.y.abs()
            + (pin.y.radius + pivot.y.radius) * t.x.abs();
        // (|t|^2 - 1) / 2, by which t is too long.
        let ((xx, xx_rest), (yy, yy_rest)) = (two_product(t.x, t.x), two_product(t.y, t.y));
        let (sum, lost) = two_sum(xx, yy);
        let long = 0.5 * ((sum - 1.0) + (lost + xx_rest + yy_rest));
        // n.w - e |t|, n = k x t.
        let ((a, a_rest), (b, b_rest)) = (two_product(t.x, wy), two_product(-t.y, wx));
        let (across, lost) = two_sum(a, b);
        let e = self.offset;
        let residual = (across - e.hi)
            + (lost + (a_rest + b_rest) + (t.x * wy_rest - t.y * wx_rest) - e.lo - e.hi * long);
        let size = wx.abs() + wy.abs() + e.hi.abs();
        let s = t.x * wx + t.y * wy;
        let radii = pin.x.radius + pin.y.radius + pivot.x.radius + pivot.y.radius;
        let least = s.abs() - 4.0 * U * size - radii;
        let fuzz = wobble + e.radius + RESIDUAL * size + 2.0 * U * residual.abs();
        let reach = (residual.abs() + fuzz) / least;
        // Written so that NaN proves nothing.
        let change = ((2.0 * reach + 8.0 * U) * size + radii) / least;
        if !(least > 0.0 && change <= CONTRACTION) {
            return false;
        }
        let phi = residual / s;
        let off = fuzz / least + 2.0 * change * reach + phi * phi;
        let unit = |v: f64, turned: f64| {
            let mid = v - v * long + turned * phi;
            Ball::new(
                mid,
                off + U * mid.abs() + 4.0 * U * phi.abs() + 4.0 * long.abs() * (long.abs() + U),
            )
        };
        let t = Vec2::new(unit(t.x, -t.y), unit(t.y, t.x));
        let s = t.dot(pin - pivot);
        self.place::<Ball, ORDER>(t, s, enclosure);
        true
    }
}
