//! Kinematics of a four-bar or a slider-crank, apart from its position, orientation and size.
//!
//! A is at the origin, and the coupler B-C is 1 long. The other pivot D of a four-bar is on the x
//! axis at `ground`. The slide of a slider-crank runs parallel to the x axis at the height `far`.
//! With e the crank's direction and u that of the coupler
//!
//! ```text
//! four-bar       q = a e - g, the vector D-B;   |q + u| = far     m = (far^2 - 1 - |q|^2) / 2
//!                u = (m q + sign h k x q) / |q|^2,  h = sqrt(|q|^2 - m^2)
//! slider-crank   a e_y + u_y = far                                u = (sign sqrt(1 - m^2), m),  m = far - a e_y
//! ```
//!
//! Both are one equation f . (a e + u - ..) = .., with f = q + u or f = (0, 1); so that, psi being
//! the angle of u,
//!
//! ```text
//! f . (k x u) dpsi = far dfar + f_x dg - (f . e) da - a f . (k x e) dphi     (dfar alone of a slider-crank)
//! ```

use kinematics::Vec2;

/// The kind of linkage.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum LinkageForm {
    FourBar,
    SliderCrank,
}

/// Lengths relative to the coupler's, and the sign of the assembly.
#[derive(Clone, Copy, Debug)]
pub(super) struct LinkageShape {
    pub(super) form: LinkageForm,
    /// The sign of the assembly, 1 or -1.
    pub(super) sign: f64,
    pub(super) crank: f64,
    /// The rocker's length, or the slide's height.
    pub(super) far: f64,
    /// The x of D; 0 for a slider-crank.
    pub(super) ground: f64,
}

/// The coupler at one crank angle.
#[derive(Clone, Copy, Debug)]
pub(super) struct Coupling {
    /// The coupler's direction; if the links do not close, the nearest one.
    pub(super) u: Vec2,
    /// f . (k x u), which is zero at a dead point.
    pub(super) lever: f64,
    /// By how much the links are too short; 0 if they close.
    pub(super) short: f64,
}

/// Derivatives of the coupler's angle, in radians.
#[derive(Clone, Copy, Debug)]
pub(super) struct AngleRates {
    pub(super) by_angle: f64,
    pub(super) by_crank: f64,
    pub(super) by_far: f64,
    pub(super) by_ground: f64,
}

impl LinkageShape {
    /// Returns the coupler for the crank along the unit vector `e`.
    #[inline]
    pub(super) fn coupling(&self, e: Vec2) -> Coupling {
        match self.form {
            LinkageForm::FourBar => {
                let q = Vec2::new(self.crank * e.x - self.ground, self.crank * e.y);
                let q2 = q.norm2();
                let m = 0.5 * ((self.far - 1.0) * (self.far + 1.0) - q2);
                let h2 = q2 - m * m;
                if h2 < 0.0 || q2 == 0.0 {
                    let d = q2.sqrt().max(f64::MIN_POSITIVE);
                    return Coupling {
                        u: q * (m.signum() / d),
                        lever: 0.0,
                        short: m.abs() - d,
                    };
                }
                let h = self.sign * h2.sqrt();
                Coupling {
                    u: (q * m + q.perp() * h) * (1.0 / q2),
                    lever: -h,
                    short: 0.0,
                }
            }
            LinkageForm::SliderCrank => {
                let m = self.far - self.crank * e.y;
                let c2 = (1.0 - m) * (1.0 + m);
                if c2 < 0.0 {
                    return Coupling {
                        u: Vec2::new(0.0, m.signum()),
                        lever: 0.0,
                        short: m.abs() - 1.0,
                    };
                }
                let c = self.sign * c2.sqrt();
                Coupling {
                    u: Vec2::new(c, m),
                    lever: c,
                    short: 0.0,
                }
            }
        }
    }

    /// Returns the derivatives of the coupler's angle with respect to the crank's angle and to
    /// every length.
    #[inline]
    pub(super) fn rates(&self, e: Vec2, at: &Coupling) -> AngleRates {
        let per = 1.0 / at.lever;
        let (f, far) = match self.form {
            LinkageForm::FourBar => {
                let b = e * self.crank;
                (
                    Vec2::new(b.x + at.u.x - self.ground, b.y + at.u.y),
                    self.far,
                )
            }
            LinkageForm::SliderCrank => (Vec2::new(0.0, 1.0), 1.0),
        };
        AngleRates {
            by_angle: -self.crank * f.dot(e.perp()) * per,
            by_crank: -f.dot(e) * per,
            by_far: far * per,
            by_ground: f.x * per,
        }
    }

    /// Returns the sine of the angle between coupler and rocker, or between coupler and the slide's
    /// normal.
    pub(super) fn transmission(&self, at: &Coupling) -> f64 {
        match self.form {
            LinkageForm::FourBar => at.lever.abs() / self.far.abs(),
            LinkageForm::SliderCrank => at.lever.abs(),
        }
    }

    /// Returns the maximum by which the links are too short between two crank angles, in degrees,
    /// and the minimum sine of the transmission angle.
    ///
    /// Both extrema occur at the ends, or where the crank lies along the ground or perpendicular to
    /// the slide.
    pub(super) fn worst_between(&self, low: f64, high: f64) -> (f64, f64) {
        let first = match self.form {
            LinkageForm::FourBar => 0.0,
            LinkageForm::SliderCrank => 90.0,
        };
        let next = ((low - first) / 180.0).ceil() * 180.0 + first;
        let inner = [next, next + 180.0].map(|angle| angle.clamp(low, high));
        let all = [low, high, inner[0], inner[1]];
        all.iter().fold((0.0, 1.0), |(short, sine), &angle| {
            let at = self.coupling(kinematics::angle::unit(angle));
            (at.short.max(short), self.transmission(&at).min(sine))
        })
    }
}
