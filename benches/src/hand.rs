//! The elastic batten as an engineer writes it by hand: fixed arrays, everything shared that is seen to be shared.
//!
//! Equations of `mechanisms/batten.eqn`, scene `elastic`: section 3 of the specification in the deflections
//! `w3 = x3 - x1`, `w4 = x4 - x1`. State: `[phi2, w3, w4, phi2', w3', w4']`.

use assur::scalar::Scalar;

/// What the equations need of the parameters.
#[derive(Clone, Copy, Debug)]
pub struct Batten {
    pub n: f64,
    r: f64,
    q: f64,
    c: f64,
    j2: f64,
    m2: f64,
    lambda: f64,
    /// Inverse of the flexibilities of the bar.
    k33: f64,
    k34: f64,
    k44: f64,
    inverse_m3: f64,
    inverse_m4: f64,
}

/// What the equations need of the time.
#[derive(Clone, Copy, Debug)]
pub struct Instant {
    /// `X'`
    x1: f64,
    /// `ω²X''`, acceleration of the pin.
    pin: f64,
    /// `2ωX''`
    coriolis: f64,
    /// `ω²X'''`
    rate: f64,
    /// Inverse of the inertia `J2 + m2 X'²`.
    inverse_inertia: f64,
}

impl Default for Batten {
    fn default() -> Self {
        let (r, l) = (0.075, 0.271);
        let (d33, d44, d34) = (3.80e-6, 3.80e-6, 1.22e-6);
        let determinant = d33 * d44 - d34 * d34;
        Self {
            n: 250.0 * std::f64::consts::PI / 30.0,
            r,
            q: r * r / (2.0 * l),
            c: 20980.0,
            j2: 0.1004,
            m2: 28.5,
            lambda: 0.385,
            k33: d44 / determinant,
            k34: -d34 / determinant,
            k44: d33 / determinant,
            inverse_m3: 1.0 / 2.02,
            inverse_m4: 1.0 / 2.02,
        }
    }
}

impl Batten {
    /// Values that depend on the time alone, with the sine of Assur (`KERNEL`) or of the standard library.
    #[inline(always)]
    pub fn instant_by<const KERNEL: bool>(&self, time: f64) -> Instant {
        let angle = self.n * time;
        self.instant_from(if KERNEL {
            Scalar::sin_cos(angle)
        } else {
            f64::sin_cos(angle)
        })
    }

    /// The same at several times at once, so that the sines of Assur are packed.
    #[inline(always)]
    pub fn instants_by<const KERNEL: bool, const K: usize>(&self, times: [f64; K]) -> [Instant; K] {
        if !KERNEL {
            return times.map(|time| self.instant_by::<false>(time));
        }
        let (sines, cosines) = f64::sin_cos_all(times.map(|time| self.n * time));
        std::array::from_fn(|k| self.instant_from((sines[k], cosines[k])))
    }

    /// The same from sine and cosine of the crank angle.
    #[inline(always)]
    pub fn instant_from(&self, (s, c): (f64, f64)) -> Instant {
        let (sin2, cos2) = (2.0 * s * c, 1.0 - 2.0 * s * s);
        let x1 = self.r * s - self.q * sin2;
        let x2 = self.r * c - 2.0 * self.q * cos2;
        let x3 = -self.r * s + 4.0 * self.q * sin2;
        let w2 = self.n * self.n;
        Instant {
            x1,
            pin: w2 * x2,
            coriolis: 2.0 * self.n * x2,
            rate: w2 * x3,
            inverse_inertia: 1.0 / (self.j2 + self.m2 * x1 * x1),
        }
    }

    /// Elastic forces on the ends of the bar.
    #[inline(always)]
    fn bar(&self, u3: f64, u4: f64) -> (f64, f64) {
        (self.k33 * u3 + self.k34 * u4, self.k34 * u3 + self.k44 * u4)
    }

    /// `y'`
    #[inline(always)]
    pub fn derivative(&self, at: &Instant, y: &[f64; 6], rate: &mut [f64; 6]) {
        let [phi, w3, w4, dphi, dw3, dw4] = *y;
        let slip = at.x1 * phi;
        let (g3, g4) = self.bar(w3 - self.lambda * slip, w4 + (1.0 + self.lambda) * slip);
        let free = at.pin - at.rate * phi - at.coriolis * dphi;
        let torque =
            at.x1 * (self.m2 * free + self.lambda * g3 - (1.0 + self.lambda) * g4) - self.c * phi;
        *rate = [
            dphi,
            dw3,
            dw4,
            torque * at.inverse_inertia,
            -g3 * self.inverse_m3 - at.pin,
            -g4 * self.inverse_m4 - at.pin,
        ];
    }

    /// Columns of `∂y'/∂y`.
    #[inline(always)]
    pub fn jacobian(&self, at: &Instant, columns: &mut [[f64; 6]; 6]) {
        let (low, high) = (self.lambda, 1.0 + self.lambda);
        // Forces by the slip, and what of forces turns the shaft.
        let (g3, g4) = self.bar(-low * at.x1, high * at.x1);
        let turn = at.x1 * at.inverse_inertia;
        let (by3, by4) = (
            low * self.k33 - high * self.k34,
            low * self.k34 - high * self.k44,
        );
        *columns = [[0.0; 6]; 6];
        columns[0][3] =
            turn * (low * g3 - high * g4 - self.m2 * at.rate) - self.c * at.inverse_inertia;
        columns[0][4] = -g3 * self.inverse_m3;
        columns[0][5] = -g4 * self.inverse_m4;
        columns[1][3] = turn * by3;
        columns[1][4] = -self.k33 * self.inverse_m3;
        columns[1][5] = -self.k34 * self.inverse_m4;
        columns[2][3] = turn * by4;
        columns[2][4] = -self.k34 * self.inverse_m3;
        columns[2][5] = -self.k44 * self.inverse_m4;
        columns[3][0] = 1.0;
        columns[3][3] = -turn * self.m2 * at.coriolis;
        columns[4][1] = 1.0;
        columns[5][2] = 1.0;
    }
}
