//! The flank of [`crate::sheets`] by hand, in the frame that does not turn.
//!
//! The fundamental forms are the same in every frame. In that of the rack the gear flank has the tangents
//! `r_u' = rack_u + φ_u v`, `r_th' = rack_th + φ_th v`, `v = (−H, 0, xF)`, and a normal `n` of the rack, of any length,
//! changes by `n_u' = n_u + φ_u (−n_z, 0, n_x)`. Tangents are at right angles to `n`, so that its length falls out of
//! `−n_u'·r_u'` but for a factor. Here `n` is that of the parameters over `ra`:
//!
//! ```text
//! n = (−C cos u, −B cos u, −A sin u),    A = R + w sin th,  B = R sin th + w,  C = R cos th,  w = q rb
//! ```

use std::hint::black_box;

use assur::scalar::Scalar;

use crate::sheets::gear::Flank;
use crate::sheets::{Code, Sheet};

/// The flank by hand.
pub struct ByHand;

/// What its points share.
pub struct Constants<S> {
    /// Arc of the profile.
    ra: S,
    ca: S,
    /// Head.
    r0: S,
    w: S,
    /// What `X` has without `u` and `th`.
    shift: S,
    pitch: S,
    inverse_pitch: S,
    half: S,
}

impl Code<2, 10> for ByHand {
    type Sheet<S: Scalar> = Constants<S>;

    fn prepare<S: Scalar>() -> Constants<S> {
        let f = black_box(Flank::default());
        let w = f.q * f.z0 * f.m / 2.0;
        let middle = (-w / f.R0).asin();
        let s0 = (0.5 * middle).sin();
        let pitch = f.m * f.z / 2.0;
        Constants {
            ra: S::from_f64(f.ra),
            ca: S::from_f64(f.ca),
            r0: S::from_f64(f.R0),
            w: S::from_f64(w),
            shift: S::from_f64(2.0 * f.R0 * s0 * s0 + w * (middle + f.delta)),
            pitch: S::from_f64(pitch),
            inverse_pitch: S::from_f64(1.0 / pitch),
            half: S::from_f64(0.5),
        }
    }
}

impl<S: Scalar> Sheet<S, 2, 10> for Constants<S> {
    #[inline(always)]
    fn row(&self, [u, th]: [S; 2]) -> [S; 10] {
        let w = self.w;
        let ([su, s_half], [cu, c_half]) = S::sin_cos_all([u, self.half * th]);
        // 1 − cos th, without cancellation where the head is large.
        let twice = s_half + s_half;
        let (s, t) = (twice * c_half, twice * s_half);
        let c = S::ONE - t;
        let (h, h1) = (self.ra * su, self.ra * cu);
        let x = h1 - self.ca;
        let r = self.r0 + x;
        let (a, b, rs) = (w.mul_add(s, r), r.mul_add(s, w), r * s);
        let rc = r * c;
        let place = x.mul_add(c, self.shift) - self.r0.mul_add(t, w * th);
        let n = [-(cu * rc), -(cu * b), -(su * a)];
        let (hs, hc, wc) = (h * s, h * c, w * c);
        let n_u = [su.mul_add(rc, cu * hc), su.mul_add(b, cu * hs), su.mul_add(h, -(cu * a))];
        let n_th = [cu * rs, n[0], -(su * wc)];

        let inverse = S::ONE / a;
        let xf = h1 * rc * inverse;
        let roll = (xf - place) * self.inverse_pitch;
        let roll_u = (h * inverse).mul_add(xf - rc - h1 * c, hc) * self.inverse_pitch;
        let roll_th = (b - inverse * h1.mul_add(rs, xf * wc)) * self.inverse_pitch;

        let r_u = [-roll_u.mul_add(h, hc), -hs, roll_u.mul_add(xf, h1)];
        let r_th = [-roll_th.mul_add(h, b), rc, roll_th * xf];
        let n_u = turned(n_u, roll_u, n);
        let n_th = turned(n_th, roll_th, n);
        let (e, f, g) = (inner(r_u, r_u), inner(r_u, r_th), inner(r_th, r_th));
        // The second form with its other sign.
        let (l, m, k) = (inner(n_u, r_u), inner(n_u, r_th), inner(n_th, r_th));
        let area = e.mul_add(g, -(f * f));
        let length = inner(n, n).sqrt();
        let both = S::ONE / (area * length);
        let (over_length, over_area) = (area * both, length * both);
        let gauss = l.mul_add(k, -(m * m)) * over_area * (over_length * over_length);
        let mean = -(e.mul_add(k, g * l) - (f + f) * m) * (self.half * both);
        let spread = mean.mul_add(mean, -gauss).max(S::ZERO).sqrt();

        let (sine, cosine) = roll.sin_cos();
        let high = h + self.pitch;
        [
            xf.mul_add(cosine, -(high * sine)),
            b,
            xf.mul_add(sine, high * cosine),
            n[0].mul_add(cosine, -(n[2] * sine)) * over_length,
            n[1] * over_length,
            n[0].mul_add(sine, n[2] * cosine) * over_length,
            gauss,
            mean,
            mean - spread,
            mean + spread,
        ]
    }
}

/// How a normal changes with the roll too.
#[inline(always)]
fn turned<S: Scalar>([x, y, z]: [S; 3], roll: S, n: [S; 3]) -> [S; 3] {
    [x - roll * n[2], y, roll.mul_add(n[0], z)]
}

#[inline(always)]
fn inner<S: Scalar>(a: [S; 3], b: [S; 3]) -> S {
    a[0].mul_add(b[0], a[1].mul_add(b[1], a[2] * b[2]))
}
