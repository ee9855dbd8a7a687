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
pub struct Instant<S = f64> {
    /// `X'`
    x1: S,
    /// `ω²X''`, acceleration of the pin.
    pin: S,
    /// `2ωX''`
    coriolis: S,
    /// `ω²X'''`
    rate: S,
    /// Inverse of the inertia `J2 + m2 X'²`.
    inverse_inertia: S,
}

/// Length of a row of the numbers of an instant.
pub const WIDTH: usize = 5;

impl<S: Scalar> Instant<S> {
    /// Its numbers in a row.
    #[inline(always)]
    pub fn row(&self) -> [S; WIDTH] {
        [self.x1, self.pin, self.coriolis, self.rate, self.inverse_inertia]
    }

    /// From such a row.
    #[inline(always)]
    pub fn of(row: &[S; WIDTH]) -> Self {
        let [x1, pin, coriolis, rate, inverse_inertia] = *row;
        Self { x1, pin, coriolis, rate, inverse_inertia }
    }
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
        self.instant_from(if KERNEL { Scalar::sin_cos(angle) } else { f64::sin_cos(angle) })
    }

    /// The same at several times at once, so that the sines of Assur are packed.
    #[inline(always)]
    pub fn instants_by<const KERNEL: bool, const K: usize>(&self, times: [f64; K]) -> [Instant; K] {
        if !KERNEL {
            return times.map(|time| self.instant_by::<false>(time));
        }
        self.instants(times)
    }

    /// The same on any numbers, packed.
    #[inline(always)]
    pub fn instants<S: Scalar, const K: usize>(&self, times: [S; K]) -> [Instant<S>; K] {
        let mut angles = times;
        for angle in &mut angles {
            *angle = S::from_f64(self.n) * *angle;
        }
        let (sines, cosines) = S::sin_cos_all(angles);
        let mut instants = [self.instant_from((sines[0], cosines[0])); K];
        for k in 1..K {
            instants[k] = self.instant_from((sines[k], cosines[k]));
        }
        instants
    }

    /// The same from sine and cosine of the crank angle.
    #[inline(always)]
    pub fn instant_from<S: Scalar>(&self, (s, c): (S, S)) -> Instant<S> {
        let [one, two, r, q] = [1.0, 2.0, self.r, self.q].map(S::from_f64);
        let [q2, q4, w2, n2] =
            [2.0 * self.q, 4.0 * self.q, self.n * self.n, 2.0 * self.n].map(S::from_f64);
        let (sin2, cos2) = (two * s * c, (-two * s).mul_add(s, one));
        let x1 = r.mul_add(s, -(q * sin2));
        let x2 = r.mul_add(c, -(q2 * cos2));
        let x3 = (-r).mul_add(s, q4 * sin2);
        let [j2, m2] = [self.j2, self.m2].map(S::from_f64);
        Instant {
            x1,
            pin: w2 * x2,
            coriolis: n2 * x2,
            rate: w2 * x3,
            inverse_inertia: one / (m2 * x1).mul_add(x1, j2),
        }
    }

    /// Elastic forces on the ends of the bar.
    #[inline(always)]
    fn bar<S: Scalar>(&self, u3: S, u4: S) -> (S, S) {
        let [k33, k34, k44] = [self.k33, self.k34, self.k44].map(S::from_f64);
        (k33.mul_add(u3, k34 * u4), k34.mul_add(u3, k44 * u4))
    }

    /// `y'`
    #[inline(always)]
    pub fn derivative<S: Scalar>(&self, at: &Instant<S>, y: &[S; 6], rate: &mut [S; 6]) {
        let [phi, w3, w4, dphi, dw3, dw4] = *y;
        let [low, high, m2, c] = [self.lambda, 1.0 + self.lambda, self.m2, self.c].map(S::from_f64);
        let [inverse_m3, inverse_m4] = [self.inverse_m3, self.inverse_m4].map(S::from_f64);
        let slip = at.x1 * phi;
        let (g3, g4) = self.bar((-low).mul_add(slip, w3), high.mul_add(slip, w4));
        let free = (-at.coriolis).mul_add(dphi, (-at.rate).mul_add(phi, at.pin));
        let forces = (-high).mul_add(g4, m2.mul_add(free, low * g3));
        let torque = at.x1.mul_add(forces, -(c * phi));
        *rate = [
            dphi,
            dw3,
            dw4,
            torque * at.inverse_inertia,
            (-g3).mul_add(inverse_m3, -at.pin),
            (-g4).mul_add(inverse_m4, -at.pin),
        ];
    }

    /// Columns of `∂y'/∂y`.
    #[inline(always)]
    pub fn jacobian<S: Scalar>(&self, at: &Instant<S>, columns: &mut [[S; 6]; 6]) {
        let number = S::from_f64;
        let [low, high, m2, c] = [self.lambda, 1.0 + self.lambda, self.m2, self.c].map(number);
        let [inverse_m3, inverse_m4] = [self.inverse_m3, self.inverse_m4].map(number);
        // Forces by the slip, and what of forces turns the shaft.
        let (g3, g4) = self.bar(-low * at.x1, high * at.x1);
        let turn = at.x1 * at.inverse_inertia;
        let [by3, by4] = [[self.k33, self.k34], [self.k34, self.k44]]
            .map(|[k3, k4]| number(self.lambda * k3 - (1.0 + self.lambda) * k4));
        *columns = [[S::ZERO; 6]; 6];
        columns[0][3] = turn * (low * g3 - high * g4 - m2 * at.rate) - c * at.inverse_inertia;
        columns[0][4] = -g3 * inverse_m3;
        columns[0][5] = -g4 * inverse_m4;
        columns[1][3] = turn * by3;
        columns[1][4] = number(-self.k33 * self.inverse_m3);
        columns[1][5] = number(-self.k34 * self.inverse_m4);
        columns[2][3] = turn * by4;
        columns[2][4] = number(-self.k34 * self.inverse_m3);
        columns[2][5] = number(-self.k44 * self.inverse_m4);
        columns[3][0] = S::ONE;
        columns[3][3] = -turn * m2 * at.coriolis;
        columns[4][1] = S::ONE;
        columns[5][2] = S::ONE;
    }
}
