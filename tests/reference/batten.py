#!/usr/bin/env python3
"""Independent reference for the batten (sley) mechanism of a shuttle loom.

    python3 tests/reference/batten.py > tests/reference/batten.json

Periodic steady states of the six-mass, three-degree-of-freedom batten by shooting (one Newton step is the
"method of initial parameters" when the equations are linear). Integrator: SciPy DOP853, rtol 1e-13.
The case "elastic" is repeated by mpmath's Taylor `odefun` at 30 digits (key "elastic"/"mpmath_30_digits").
Needs numpy, scipy, mpmath. Everything is SI; n is in rpm in the key names only.

Coordinates: phi2 = lag of the brake-side crank, w3 = x3 - x1, w4 = x4 - x1 with x1 = X(theta), theta = omega t.
With the slip  s = x1 - x2  (K1: s = X'(theta) phi2;  K3: s = X(theta) - X(theta - phi2)):
    u3 = x3 - (1+lam) x1 + lam x2 = w3 - lam s,      u4 = x4 - (1+lam) x2 + lam x1 = w4 + (1+lam) s,
    T = J2 (omega - phi2')^2/2 + sum m_i x_i'^2/2,   V = c phi2^2/2 + u' Delta^-1 u/2,
    D = c beta_t phi2'^2/2 + beta_b u'^T Delta^-1 u'/2.
Let e = ds/dphi2 (K1: X'(theta); K3: X'(theta - phi2)) and g = Delta^-1 (u + beta_b du/dt). Lagrange's equations:
    m3 x3'' = -g3,   m4 x4'' = -g4,
    J2 phi2'' + c (phi2 + beta_t phi2') = e F2,      F2 = m2 x2'' + lam g3 - (1+lam) g4.
Drive side: F1 = m1 x1'' + (1+lam) m3 x3'' - lam m4 x4'',  M1 = X'(theta) F1 + c (phi2 + beta_t phi2').
"""
import cmath
import math
import sys
import mpmath
import numpy as np
from scipy.integrate import solve_ivp
from scipy.optimize import brentq
import rows

THETA_B = "1.9198"                                   # crank angle at the start of the blow into the locks
PH = dict(m1="28.5", m2="28.5", m3="2.02", m4="2.02", J2="0.1004", c="20980", lam="0.385", d33="3.80e-6",
          d44="3.80e-6", d34="1.22e-6", R="0.075", l="0.271", beta_t="0", beta_b="0")
TABLE = dict(A="284", B="2.09e5", D="9.4e5", E="6.07e6", F="4.39e6", G="2.42e6", K="1.45e5", M="4.65e4", N="1.19e5",
             Q="1.45e5", S="4.65e4", T="2.07e5", R="0.075", q="0.0104")
SI_SCALE = {True: 1e-17, False: 1e-15}               # absolute tolerance: displacements, velocities


class Batten:
    """One variant. `free` lists the free coordinates; `num` makes numbers (float or mpmath.mpf) of the strings."""

    def __init__(self, level="K1", kinematics="two-term", free=("phi2", "w3", "w4"), rpm=250, num=float,
                 pi=math.pi, table=False, **changes):
        self.level, self.kin, self.free, self.table = level, kinematics, free, table
        p = dict(TABLE if table else PH, **changes)
        for k, v in p.items():
            setattr(self, k, num(v))
        self.om = 2 * pi * rpm / 60
        self.period = 2 * pi / self.om
        self.beta = 0 if table else self.beta_t + self.beta_b
        if not table:
            self.q = 0 * self.R if kinematics == "harmonic" else self.R**2 / (2 * self.l)
            det = self.d33 * self.d44 - self.d34**2
            self.k33, self.k44, self.k34 = self.d44 / det, self.d33 / det, -self.d34 / det

    # ---- crank geometry; m is math, cmath or mpmath
    def X(self, th, m):
        """X, X', X'', X''' at the angle th."""
        R, q = self.R, self.q
        s, c, s2, c2 = m.sin(th), m.cos(th), m.sin(2 * th), m.cos(2 * th)
        one_minus_cos = 2 * m.sin(th / 2)**2
        if self.kin != "exact":
            return R * one_minus_cos - q * s * s, R * s - q * s2, R * c - 2 * q * c2, -(R * s - 4 * q * s2)
        l, k2 = self.l, (self.R / self.l)**2
        S = m.sqrt(1 - k2 * s * s)                   # S^2 = 1 - k2 sin^2, differentiated three times
        S1 = -k2 * s2 / (2 * S)
        S2 = (-k2 * c2 - S1 * S1) / S
        S3 = (2 * k2 * s2 - 3 * S1 * S2) / S
        return R * one_minus_cos - l * k2 * s * s / (1 + S), R * s + l * S1, R * c + l * S2, -R * s + l * S3

    def slip(self, th, phi, m):
        """X(th) - X(th - phi) without cancellation."""
        a = 2 * self.R * m.sin(th - phi / 2) * m.sin(phi / 2)
        b = m.sin(2 * th - phi) * m.sin(phi)         # = sin^2(th) - sin^2(th - phi)
        if self.kin != "exact":
            return a - self.q * b
        k2 = (self.R / self.l)**2
        roots = m.sqrt(1 - k2 * m.sin(th)**2) + m.sqrt(1 - k2 * m.sin(th - phi)**2)
        return a - self.l * k2 * b / roots

    def slip_state(self, th, phi, dphi, m):
        """s, ds/dt, e = ds/dphi2, and x2'' = a0 - e phi2''; returns (s, ds, e, a0)."""
        om = self.om
        _, X1, X2, X3 = self.X(th, m)
        if self.level == "K1":
            return X1 * phi, X1 * dphi + om * X2 * phi, X1, om * om * (X2 - X3 * phi) - 2 * om * X2 * dphi
        _, Y1, Y2, _ = self.X(th - phi, m)           # Y = X at the brake-side crank angle
        return self.slip(th, phi, m), om * (X1 - Y1) + Y1 * dphi, Y1, Y2 * (om - dphi)**2

    # ---- equations of motion
    def full(self, t, y, m):
        """(phi2, phi2', phi2'', w3, w3', w3'', w4, w4', w4'') from the free state y."""
        th, om, zero = self.om * t, self.om, 0 * y[0]
        _, X1, X2, X3 = self.X(th, m)
        x1dd = om * om * X2
        if self.table:                               # section 4, with x = X + w, P = K - M, W = Q - S, H = F - G
            phi, dphi, w3, v3, w4, v4 = y
            rhs = (X1 * (self.G * w3 - self.F * w4) + self.A * om * om * X1 * X2 - 2 * self.A * om * X1 * X2 * dphi
                   - (self.B + self.A * om * om * X1 * X3 + (self.D + self.E) * X1 * X1) * phi)
            return (phi, dphi, rhs / (1 + self.A * X1 * X1),
                    w3, v3, -self.K * w3 + self.M * w4 + self.N * X1 * phi - x1dd,
                    w4, v4, -self.Q * w4 + self.S * w3 - self.T * X1 * phi - x1dd)
        lam, mu = self.lam, 1 + self.lam
        if self.free == ("phi2",):                   # bar rigid (K1): w3 = lam s, w4 = -(1+lam) s
            phi, dphi = y
            s, ds, e, a0 = self.slip_state(th, phi, dphi, m)
            sdd0 = x1dd - a0                         # s'' = sdd0 + e phi2''
            f0 = (self.m2 * (x1dd - sdd0) + mu * self.m4 * (x1dd - mu * sdd0) - lam * self.m3 * (x1dd + lam * sdd0))
            eff = self.m2 + mu**2 * self.m4 + lam**2 * self.m3
            a = (e * f0 - self.c * phi) / (self.J2 + eff * e * e)
            sdd = sdd0 + e * a
            return phi, dphi, a, lam * s, lam * ds, lam * sdd, -mu * s, -mu * ds, -mu * sdd
        phi, dphi, w3, v3, w4, v4 = y if "phi2" in self.free else (zero, zero, *y)
        s, ds, e, a0 = self.slip_state(th, phi, dphi, m)
        r3 = w3 - lam * s + self.beta_b * (v3 - lam * ds)
        r4 = w4 + mu * s + self.beta_b * (v4 + mu * ds)
        g3, g4 = self.k33 * r3 + self.k34 * r4, self.k34 * r3 + self.k44 * r4
        a = zero
        if "phi2" in self.free:
            a = e * (self.m2 * a0 + lam * g3 - mu * g4) - self.c * (phi + self.beta_t * dphi)
            a = a / (self.J2 + self.m2 * e * e)
        return phi, dphi, a, w3, v3, -g3 / self.m3 - x1dd, w4, v4, -g4 / self.m4 - x1dd

    def rhs(self, t, y, m):
        f = self.full(t, y, m)
        out = []
        for i, name in enumerate(("phi2", "w3", "w4")):
            if name in self.free:
                out += [f[3 * i + 1], f[3 * i + 2]]
        return out

    def outputs(self, t, y, m=math):
        """Everything of interest at the instant t. Forces only in physical parameters (not for the TABLE set)."""
        phi, dphi, ddphi, w3, v3, b3, w4, v4, b4 = self.full(t, y, m)
        th, om = self.om * t, self.om
        X0, X1, X2, _ = self.X(th, m)
        x1dd = om * om * X2
        o = {"phi2": phi, "dphi2": dphi, "w3": w3, "dw3": v3, "w4": w4, "dw4": v4,
             "x3": X0 + w3, "dx3": om * X1 + v3, "x4": X0 + w4, "dx4": om * X1 + v4,
             "ddphi2": ddphi, "ddw3": b3, "ddw4": b4, "ddx3": x1dd + b3, "ddx4": x1dd + b4}
        if self.table:
            o["shaft_torque_over_J2"] = self.B * phi
            o["ddphi2_plus_B_phi2"] = ddphi + self.B * phi        # = X'(theta) F2 / J2
            return o
        s, ds, e, a0 = self.slip_state(th, phi, dphi, m)
        lam, mu = self.lam, 1 + self.lam
        p3, p4 = self.m3 * o["ddx3"], self.m4 * o["ddx4"]
        o["F1"] = self.m1 * x1dd + mu * p3 - lam * p4
        o["F2"] = self.m2 * (a0 - e * ddphi) + mu * p4 - lam * p3
        # with the shaft rigid its torque is the reaction X' F2
        o["shaft"] = self.c * (phi + self.beta_t * dphi) if "phi2" in self.free else e * o["F2"]
        o["M1"] = X1 * o["F1"] + o["shaft"]
        u3, u4 = v3 - lam * ds, v4 + mu * ds
        o["dissipation"] = (self.c * self.beta_t * dphi**2 + self.beta_b *
                            (self.k33 * u3 * u3 + 2 * self.k34 * u3 * u4 + self.k44 * u4 * u4))
        return o


# ---- double precision: integration, shooting, Floquet
def integrate(f, t1, y0, atol, dense=False, t0=0.0):
    s = solve_ivp(f, (t0, t1), y0, method="DOP853", rtol=1e-13, atol=atol, dense_output=dense)
    assert s.success, s.message
    return s if dense else s.y[:, -1]


def flow(b, v):
    """y(Tp) and Phi(Tp): variational equations with the Jacobian by complex step (exact to rounding)."""
    n = len(v)

    def f(t, z):
        y, Phi = z[:n].tolist(), z[n:].reshape(n, n)
        J = np.empty((n, n))
        for k in range(n):
            yc = [complex(a) for a in y]
            yc[k] += 1e-40j
            J[:, k] = [a.imag / 1e-40 for a in b.rhs(t, yc, cmath)]
        return np.concatenate((b.rhs(t, y, math), (J @ Phi).ravel()))

    a = np.array([SI_SCALE[i % 2 == 0] for i in range(n)])
    scale = np.array([1.0 if i % 2 == 0 else b.om for i in range(n)])
    z = integrate(f, b.period, np.concatenate((v, np.eye(n).ravel())),
                  np.concatenate((a, (1e-15 * np.outer(scale, 1 / scale)).ravel())))
    return z[:n], z[n:].reshape(n, n)


def periodic(b, guess=None):
    """Periodic initial state v and Phi(Tp); (I - Phi) dv = y(Tp; v) - v until dv stalls at rounding."""
    n = 2 * len(b.free)
    v = np.zeros(n) if guess is None else np.array(guess, float)
    scale = np.array([1e-3 if i % 2 == 0 else 1e-3 * b.om for i in range(n)])
    for _ in range(8):
        y, Phi = flow(b, v)
        dv = np.linalg.solve(np.eye(n) - Phi, y - v)
        v = v + dv
        if np.max(np.abs(dv) / scale) < 1e-11:
            break
    return v, Phi, float(np.max(np.abs(dv) / scale))


def amplitude(b, sol, v, which):
    """max |phi2| (0), |phi2'| (1), |phi2''| (2) over a period: extrema located densely, evaluated by integration."""
    atol = [SI_SCALE[i % 2 == 0] for i in range(len(v))]
    value = lambda t, y: b.full(t, y, math)[which]
    ts = np.linspace(0, b.period, 1201)
    xs = [value(t, sol.sol(t).tolist()) for t in ts]
    h, best = b.period * 1e-4, 0.0
    slope = lambda t: value(t + h, sol.sol(t + h).tolist()) - value(t - h, sol.sol(t - h).tolist())
    top = max(abs(x) for x in xs)
    for i in range(1, 1200):
        if abs(xs[i]) > 0.98 * top and (xs[i] - xs[i - 1]) * (xs[i + 1] - xs[i]) <= 0:
            try:
                t = brentq(slope, ts[i - 1], ts[i + 1], xtol=1e-12)
            except ValueError:
                t = ts[i]
            y = integrate(lambda t, y: b.rhs(t, y.tolist(), math), t, v, atol)
            best = max(best, abs(value(t, y.tolist())))
    return max(best, abs(xs[0]))


def multipliers(Phi):
    mu = sorted(np.linalg.eigvals(Phi), key=lambda z: (abs(math.atan2(z.imag, z.real)), z.imag))
    return [[float(z.real), float(z.imag)] for z in mu]


def report(b, guess=None):
    v, Phi, step = periodic(b, guess)
    n = len(v)
    atol = [SI_SCALE[i % 2 == 0] for i in range(n)]
    f = lambda t, y: b.rhs(t, y.tolist(), math)
    sol = integrate(f, b.period, v, atol, dense=True)
    tb = float(THETA_B) / b.om
    r = {"omega": b.om, "start": b.outputs(0.0, v.tolist()),
         "at_1.9198": b.outputs(tb, integrate(f, tb, v, atol).tolist()),
         "multipliers": multipliers(Phi), "det_Phi": float(np.linalg.det(Phi)), "last_newton_step_relative": step,
         "closure": float(np.max(np.abs(sol.y[:, -1] - v)))}
    if "phi2" in b.free:
        r["amplitudes"] = {k: amplitude(b, sol, v, i) for i, k in enumerate(("phi2", "dphi2", "ddphi2"))}
    if b.beta > 0:                                   # Liouville: det Phi = exp(int tr A), the damped det is tiny
        def trace(t, z):
            y = z[:n].tolist()
            tr = 0.0
            for k in range(n):
                yc = [complex(a) for a in y]
                yc[k] += 1e-40j
                tr += b.rhs(t, yc, cmath)[k].imag / 1e-40
            return b.rhs(t, y, math) + [tr]
        r["det_Phi_liouville"] = math.exp(integrate(trace, b.period, np.append(v, 0), atol + [1e-13])[n])
    if not b.table:
        def g(t, z):
            y = z[:n].tolist()
            o = b.outputs(t, y)
            return b.rhs(t, y, math) + [o["M1"], o["dissipation"]]
        z = integrate(g, b.period, np.concatenate((v, [0, 0])), atol + [1e-12, 1e-12])
        r["mean_M1"], r["mean_dissipation"] = float(z[n] / b.period), float(z[n + 1] / b.period)
        r["mean_M1_times_omega"] = r["mean_M1"] * b.om
    return r, v, Phi


def rigid(b):
    """Both flexibilities off: x1 = ... = x4 = X."""
    def at(th):
        X0, X1, X2, _ = b.X(th, math)
        a = b.om**2 * X2
        F1 = (b.m1 + (1 + b.lam) * b.m3 - b.lam * b.m4) * a
        F2 = (b.m2 + (1 + b.lam) * b.m4 - b.lam * b.m3) * a
        return {"phi2": 0.0, "dphi2": 0.0, "ddphi2": 0.0, "w3": 0.0, "w4": 0.0, "x3": X0, "dx3": b.om * X1, "ddx3": a,
                "x4": X0, "dx4": b.om * X1, "ddx4": a, "F1": F1, "F2": F2, "shaft": X1 * F2, "M1": X1 * (F1 + F2)}
    return {"omega": b.om, "start": at(0.0), "at_1.9198": at(float(THETA_B)), "mean_M1": 0.0}


def bending_closed_form(b):
    """Symmetric bar, phi2 = 0, P = 1/(m3 (d33 + d34)): w = x - X at start and at theta = 1.9198."""
    P = 1 / (b.m3 * (b.d33 + b.d34))
    a, c = b.om**2 / P, 4 * b.om**2 / P
    w = lambda th: -b.R * math.cos(th) * a / (1 - a) + b.q / 2 * math.cos(2 * th) * c / (1 - c)
    return {"w3_start": w(0.0), "w3_at_1.9198": w(float(THETA_B))}


# ---- 30 digits
def mpmath_elastic(v, Phi, dps=30):
    """The case "elastic" again by Taylor series in theta (mpmath.odefun): closure of the double-precision v over one
    period in 30 digits, one more Newton step with the double-precision Phi (error left about 1e-12 of that step),
    and the refined solution at theta = 1.9198."""
    mpmath.mp.dps = dps
    mpf, m = mpmath.mpf, mpmath
    b = Batten(num=mpf, pi=mpmath.pi)
    scale = [1, b.om] * 3                            # velocities per radian

    def f(th, z):
        return [a / (b.om * s) for a, s in zip(b.rhs(th / b.om, [u * s for u, s in zip(z, scale)], m), scale)]

    z0 = [mpf(float(a)) / s for a, s in zip(v, scale)]
    z1 = mpmath.odefun(f, 0, z0)(2 * mpmath.pi)
    gap = mpmath.matrix([(a - c) * s for a, c, s in zip(z1, z0, scale)])
    dv = mpmath.lu_solve(mpmath.eye(6) - mpmath.matrix(Phi.tolist()), gap)
    z = [a + d / s for a, d, s in zip(z0, dv, scale)]
    zb = mpmath.odefun(f, 0, z)(mpf(THETA_B))
    names = ("phi2", "dphi2", "w3", "dw3", "w4", "dw4")
    show = lambda z: {k: mpmath.nstr(u * s, 20) for k, u, s in zip(names, z, scale)}
    out = {"start": show(z), "at_1.9198": show(zb),
           "correction": {k: mpmath.nstr(d, 3) for k, d in zip(names, dv)}}
    mpmath.mp.dps = 15
    return out


def main():
    out = {"note": "SI units; d = d/dt; see batten.py. Forces F along the chord, shaft = shaft torque, M1 = drive torque."}
    out["elastic"], v, Phi = report(Batten())
    out["rigid"] = rigid(Batten())
    out["torsion_only"], _, _ = report(Batten(free=("phi2",)))
    out["bending_only"], _, _ = report(Batten(free=("w3", "w4")))
    out["bending_only"]["closed_form"] = bending_closed_form(Batten())
    out["uncoupled"], _, _ = report(Batten(d34="0"))
    out["nonlinear"], v3, _ = report(Batten("K3"), v)
    out["exact"], _, _ = report(Batten("K3", "exact"), v3)
    out["harmonic"], _, _ = report(Batten(kinematics="harmonic"))
    out["damped"], _, _ = report(Batten("K3", beta_t="1e-3", beta_b="1e-3"), v3)
    out["damped_K1"], _, _ = report(Batten(beta_t="1e-3", beta_b="1e-3"))
    out["table_T207"], _, _ = report(Batten(table=True))
    out["table_T217.5"], _, _ = report(Batten(table=True, T="2.175e5"))
    for rpm in (248, 249, 251, 300):
        b = Batten(rpm=rpm)
        vn, Phin, step = periodic(b)
        out["elastic_n%d" % rpm] = {"omega": b.om, "start": b.outputs(0.0, vn.tolist()), "multipliers": multipliers(Phin),
                                    "det_Phi": float(np.linalg.det(Phin)), "last_newton_step_relative": step}
    if "--no-mpmath" not in sys.argv:
        out["elastic"]["mpmath_30_digits"] = mpmath_elastic(v, Phi)
    print(rows.text(out))
    print()


if __name__ == "__main__":
    main()
