#!/usr/bin/env python3
"""Independent reference for the run-up of the table drive.

    python3 tests/reference/table_drive.py > tests/reference/table_drive.json

Two ways that share nothing. `closed`: the closed forms at 50 digits (mpmath), every one of them tried against the
differential equation it solves and its start values before it is written. `stepped`: SciPy's DOP853 at rtol 1e-13 from
event to event, in modes of its own making; where both apply they are compared here already (key "apart").
Needs mpmath, scipy. Everything is SI.

    gap    J1 f1'' = Me                                          f1 = phi1, f2 = phi2, x = f1 - f2 - g
    wind   J1 f1'' + b f1' + c x = Me,  f2 at rest               T = c x + b (f1' - f2')
    run    J1 f1'' + T = Me,  J2 f2'' = T - Mc
    stick  like wind, and T decides when the table moves
    back   like run with -Mc
    coast  J1 f1'' = Me,  J2 f2'' = -Mc
"""
import math
import sys
import mpmath
from mpmath import mp, mpf
from scipy.integrate import solve_ivp
from scipy.optimize import brentq
import rows

mp.dps = 50
BASE = dict(J1="5e-4", J2="5e-4", c="710", beta="0.980665", Mc="0.2", Ms="17.2", omega="157", g="0",
            Mst="10", lambda1="30", lambda2="60", cos_ph="0.8", s_k="0.3", q="0.2")
TABLE_2 = dict(J1="6.3e-4", Mc="1")
PRINTED = dict(J1="6.3e-4", J2="1.15e-3", beta="0.1", Mc="1")
DIGITS = 25


class Values:
    def __init__(self, num, **changes):
        for name, value in dict(BASE, **changes).items():
            setattr(self, name, num(value))


def starting(v, t, m):
    """Eq (2), as the paper has it."""
    ph = m.acos(v.cos_ph)
    return v.Mst * (1 + m.exp(-(v.lambda1 + v.lambda2) * t)
                    - (m.exp(-v.lambda2 * t) * m.cos(v.omega * t - ph)
                       + m.exp(-v.lambda1 * t) * m.cos(v.omega * t + ph)) / m.cos(ph))


# ---- closed forms: functions of the time that return (phi1, phi1', phi1'')
def by_terms(terms):
    """A sum of amplitude * exp(rate * t), real in the end, with two derivatives."""
    def at(t):
        parts = [(a * mpmath.exp(s * t), s) for a, s in terms]
        values = [sum(x for x, _ in parts), sum(x * s for x, s in parts), sum(x * s * s for x, s in parts)]
        return [mpmath.re(mpmath.mpmathify(x)) for x in values]
    return at


def wind_transient(v):
    """4.1: the rates are -delta +- ip, 0, -L, -lam2 +- i omega, -lam1 +- i omega."""
    delta, L, k2 = v.beta / (2 * v.J1), v.lambda1 + v.lambda2, v.c / v.J1
    p = mpmath.sqrt(k2 - delta**2)
    ph = mpmath.acos(v.cos_ph)
    sin, cos, G = mpmath.sin(ph), mpmath.cos(ph), v.Mst / (v.J1 * mpmath.cos(ph))
    P = [lam**2 - v.omega**2 - 2 * delta * lam + k2 for lam in (v.lambda1, v.lambda2)]
    Q = [2 * v.omega * (delta - lam) for lam in (v.lambda1, v.lambda2)]
    n = [P[i]**2 + Q[i]**2 for i in (0, 1)]
    A, B, D, N = -G * P[1] / n[1], -G * Q[1] / n[1], -G * P[0] / n[0], -G * Q[0] / n[0]
    M0, ML = v.Mst / v.c, v.Mst / (v.J1 * (L * L - 2 * delta * L + k2))
    C1 = -M0 - ML - (A + D) * cos + (B - N) * sin
    C2 = (delta * C1 + L * ML + v.lambda2 * (A * cos - B * sin) - v.omega * (A * sin + B * cos)
          + v.lambda1 * (D * cos + N * sin) + v.omega * (D * sin - N * cos)) / p

    def pair(a, b, rate, frequency, phase):          # e^{rate t} (a cos + b sin)(frequency t + phase)
        up, i = mpmath.exp(1j * phase), mpmath.mpc(0, 1)
        return [((a - i * b) / 2 * up, rate + i * frequency), ((a + i * b) / 2 / up, rate - i * frequency)]

    return by_terms([(M0, mpf(0)), (ML, -L)] + pair(C1, C2, -delta, p, 0)
                    + pair(A, B, -v.lambda2, v.omega, -ph) + pair(D, N, -v.lambda1, v.omega, ph))


def wind_resonant(v):
    """4.2 at omega = k without damping and decay."""
    k = mpmath.sqrt(v.c / v.J1)

    def at(t):
        s, c, x = mpmath.sin(k * t), mpmath.cos(k * t), k * t
        factor = 2 * v.Mst / v.c
        return [factor * (1 - c - x * s / 2), factor * k * (s / 2 - x * c / 2), factor * k * k * x * s / 2]
    return at


def wind_linear(v):
    """4.3, from rest in contact."""
    d, k2 = (v.beta + v.Ms / v.omega) / (2 * v.J1), v.c / v.J1
    q = mpmath.sqrt(mpmath.mpc(k2 - d * d))
    i = mpmath.mpc(0, 1)
    return by_terms([(v.Ms / v.c, mpf(0)), (-v.Ms / v.c * (1 - i * d / q) / 2, -d + i * q),
                     (-v.Ms / v.c * (1 + i * d / q) / 2, -d - i * q)])


def gap_linear(v):
    tau = v.omega * v.J1 / v.Ms
    return lambda t: [v.omega * (t + tau * mpmath.expm1(-t / tau)), -v.omega * mpmath.expm1(-t / tau),
                      v.omega / tau * mpmath.exp(-t / tau)]


def run_linear(v, start):
    """4.4: functions of tau that return (phi1, phi1', phi1'') and the same of phi2, from a state
    (phi1, phi2, phi1', phi2')."""
    a, b, d, h, z = v.beta / v.J1, v.Ms / (v.J1 * v.omega), v.c / v.J1, v.beta / v.J2, v.c / v.J2
    roots = [mpf(0)] + list(mpmath.polyroots([1, a + b + h, d + z + b * h, b * z], maxsteps=500, extraprec=400))
    g = [(s * s + h * s + z) / (h * s + z) for s in roots]
    alpha = v.omega * (1 - v.Mc / v.Ms)
    A = mpmath.matrix(4, 4)
    for j, s in enumerate(roots):
        A[0, j], A[1, j], A[2, j], A[3, j] = g[j], 1, g[j] * s, s
    N = mpmath.lu_solve(A, mpmath.matrix([start[0] - v.Mc / v.c, start[1], start[2] - alpha, start[3] - alpha]))

    def steady(at, offset):
        return lambda t: [x + y for x, y in zip(at(t), (alpha * t + offset, alpha, 0))]

    return (steady(by_terms([(g[j] * N[j], s) for j, s in enumerate(roots)]), v.Mc / v.c),
            steady(by_terms([(N[j], s) for j, s in enumerate(roots)]), 0), roots)


def run_matrix(v, start, constant=False):
    """The same by the exponential of a matrix: for roots that coincide, and for a constant torque."""
    slope = mpf(0) if constant else v.Ms / v.omega
    A = mpmath.matrix([[0, 0, 1, 0, 0], [0, 0, 0, 1, 0],
                       [-v.c / v.J1, v.c / v.J1, -(v.beta + slope) / v.J1, v.beta / v.J1, v.Ms / v.J1],
                       [v.c / v.J2, -v.c / v.J2, v.beta / v.J2, -v.beta / v.J2, -v.Mc / v.J2], [0, 0, 0, 0, 0]])
    y0 = mpmath.matrix(list(start) + [mpf(1)])

    def at(t):
        y = mpmath.expm(A * t, method="taylor") * y0
        r = A * y
        return [y[0], y[2], r[2]], [y[1], y[3], r[3]]
    return at


def first(f, level, guess):
    """The first time at which f reaches a level: by steps of a hundredth of the guess, then by the secant."""
    step, t = guess / 100, mpf(0)
    while f(t + step) < level:
        t += step
        assert t < 1000 * guess, "no event"
    return mpmath.findroot(lambda x: f(x) - level, (t, t + step), solver="anderson", tol=mpf(10)**-45)


def text(x):
    return mpmath.nstr(mpmath.mpmathify(x), DIGITS)


def sample(t, one, two=None):
    two = two or [0, 0, 0]
    names = ("phi1", "dphi1", "ddphi1", "phi2", "dphi2", "ddphi2")
    return dict(time=text(t), **{n: text(x) for n, x in zip(names, list(one) + list(two))})


def tried(at, residual, start=(0, 0)):
    """Asserts a closed form: its start values and its differential equation."""
    assert all(abs(x - y) < mpf(10)**-40 for x, y in zip(at(mpf(0)), start)), "start"
    for t in ("1e-4", "1e-3", "0.017"):
        assert abs(residual(mpf(t), at(mpf(t)))) < mpf(10)**-30, "equation"
    return at


TIMES = ["1e-4", "5e-4", "1e-3", "2e-3", "5e-3", "0.01", "0.02", "0.05", "0.1"]


def changed(changes):
    return {name: float(mpf(value)) for name, value in changes.items()}


def blocked(changes, at=None):
    """The table cannot move."""
    v = Values(mpf, **changes)
    at = at(v) if at else wind_transient(v)
    tried(at, lambda t, y: v.J1 * y[2] + v.beta * y[1] + v.c * y[0] - starting(v, t, mpmath))
    return dict(scene="blocked", values=changed(changes), events=[], samples=[sample(mpf(t), at(mpf(t))) for t in TIMES])


def run_up(scene, changes, full=False, double=False):
    """Clearance, winding and run-up with the straight characteristic, one closed form after the other."""
    v = Values(mpf, **changes)
    assert v.g == 0
    wind = tried(wind_linear(v), lambda t, y: v.J1 * y[2] + v.beta * y[1] + v.c * y[0] - v.Ms * (1 - y[1] / v.omega))
    weigh = (lambda t: v.c * wind(t)[0] + v.beta * wind(t)[1]) if full else (lambda t: v.c * wind(t)[0])
    guess = mpmath.sqrt(2 * v.Mc * v.J1 / (v.c * v.Ms))
    t1 = first(weigh, v.Mc, guess) if v.Mc > 0 else mpf(0)
    start = [wind(t1)[0], mpf(0), wind(t1)[1], mpf(0)]
    matrix = run_matrix(v, start)
    roots = None
    if double:
        run = matrix
    else:
        one, two, roots = run_linear(v, start)
        run = lambda t: (one(t), two(t))
        for t in ("1e-4", "3e-3"):
            for x, y in zip(run(mpf(t)), matrix(mpf(t))):
                assert all(abs(p - q) < mpf(10)**-25 * (1 + abs(q)) for p, q in zip(x, y)), "two closed forms"
    times = [mpf(t) for t in TIMES]
    samples = [sample(t, wind(t)) if t < t1 else sample(t, *run(t - t1)) for t in times]
    case = dict(scene=scene, values=changed(changes), events=[dict(time=text(t1), to="run")], samples=samples)
    if roots:
        case["roots"] = [[float(mpmath.re(s)), float(mpmath.im(s))] for s in roots[1:]]
    return case


def constant(changes):
    v = Values(mpf, **changes)
    d = Values(mpf, **dict(changes, omega="1e60"))
    wind = tried(wind_linear(d), lambda t, y: v.J1 * y[2] + v.beta * y[1] + v.c * y[0] - v.Ms)
    t1 = first(lambda t: v.c * wind(t)[0], v.Mc, mpmath.sqrt(2 * v.Mc * v.J1 / (v.c * v.Ms)))
    run = run_matrix(v, [wind(t1)[0], mpf(0), wind(t1)[1], mpf(0)], constant=True)
    samples = [sample(t, wind(t)) if t < t1 else sample(t, *run(t - t1)) for t in map(mpf, TIMES)]
    return dict(scene="constant", values=changed(changes), events=[dict(time=text(t1), to="run")], samples=samples)


def start_of(scene, changes):
    """When the table starts under the transient torque."""
    v = Values(mpf, **changes)
    at = wind_transient(v)
    second = v.Mst * (2 * v.lambda1 * v.lambda2 + 2 * v.omega**2
                      + 2 * v.omega * (v.lambda2 - v.lambda1) * mpmath.tan(mpmath.acos(v.cos_ph)))
    leading = (24 * v.J1 * v.Mc / (v.c * second))**mpf("0.25")
    t1 = first(lambda t: v.c * at(t)[0], v.Mc, leading)
    return dict(scene=scene, values=changed(changes), events=[dict(time=text(t1), to="run")], samples=[],
                leading=text(leading), speed=text(at(t1)[1]))


def double_beta():
    """The damping of table 1 at which two roots of (19) coincide: a zero of the discriminant."""
    def discriminant(beta):
        v = Values(mpf)
        v.beta = mpf(beta)
        a, b, d, h, z = v.beta / v.J1, v.Ms / (v.J1 * v.omega), v.c / v.J1, v.beta / v.J2, v.c / v.J2
        p, q, r = a + b + h, d + z + b * h, b * z
        return (p * p * q * q - 4 * q**3 - 4 * p**3 * r + 18 * p * q * r - 27 * r * r) / mpf(10)**18
    return mpmath.nstr(mpmath.findroot(discriminant, (mpf("0.7"), mpf("0.9")), solver="anderson"), 45)


# ---- from event to event by SciPy
def law(name, v, modes_with_linear=("run", "stick", "back", "coast")):
    linear = lambda t, w, mode: v.Ms * (1 - w / v.omega)

    def kloss(t, w, mode):
        s = 1 - w / v.omega
        mk = v.Ms * v.s_k / (2 * (1 + v.q))
        return 2 * mk * (1 + v.q) * s * v.s_k / (s * s + v.s_k**2 + 2 * v.q * s * v.s_k)
    transient = lambda t, w, mode: starting(v, t, math)
    return dict(linear=linear, constant=lambda t, w, mode: v.Ms, kloss=kloss, transient=transient,
                switched=lambda t, w, mode: (linear if mode in modes_with_linear else transient)(t, w, mode))[name]


class Stepped:
    def __init__(self, motor="linear", full=False, clearance=False, **changes):
        self.v = Values(float, **changes)
        self.me, self.full, self.clearance = law(motor, self.v), full, clearance

    def wound(self, y):
        return y[0] - y[1] - self.v.g

    def pressed(self, y):
        return self.v.c * self.wound(y) + self.v.beta * (y[2] - y[3])

    def started(self, y):
        return self.pressed(y) if self.full else self.v.c * self.wound(y)

    def rate(self, mode, t, y):
        v = self.v
        T = 0.0 if mode in ("gap", "coast") else self.pressed(y)
        resisted = {"run": v.Mc, "coast": v.Mc, "back": -v.Mc}.get(mode)
        a2 = 0.0 if resisted is None else (T - resisted) / v.J2
        return [y[2], y[3], (self.me(t, y[2], mode) - T) / v.J1, a2]

    def exits(self, mode):
        """(guard, direction, condition, next, stops)."""
        v, always = self.v, lambda y: True
        up, down = 1, -1
        touching = lambda y: self.wound(y) > 0
        if mode == "gap":
            ready = lambda y: "run" if self.started(y) > v.Mc else "wind"
            return [(self.wound, up, always, ready), (self.pressed, up, touching, ready)]
        if mode == "coast":
            return [(self.wound, up, always, "run"), (self.pressed, up, touching, "run"),
                    (lambda y: y[3], down, always, "gap")]
        opened = [(self.pressed, down, always, "coast" if mode == "run" else "gap")] if self.clearance else []
        pulled = [] if self.clearance else [(lambda y: self.pressed(y) + v.Mc, down, always, "back")]
        if mode == "wind":
            return [(lambda y: self.started(y) - v.Mc, up, always, "run")] + opened + pulled
        if mode == "stick":
            return [(lambda y: self.pressed(y) - v.Mc, up, always, "run")] + opened + pulled
        if mode == "run":
            rest = lambda y: "stick" if self.pressed(y) >= -v.Mc else "back"
            return [(lambda y: y[3], down, always, rest)] + opened
        rest = lambda y: "stick" if self.pressed(y) <= v.Mc else "run"
        return [(lambda y: y[3], up, always, rest)]

    def go(self, end, times, mode="wind", max_step=2e-5):
        t, y, events, samples = 0.0, [0.0] * 4, [], []
        wanted = list(times)
        while t < end:
            exits = self.exits(mode)
            solution = solve_ivp(lambda t, y: self.rate(mode, t, y), (t, end), y, method="DOP853", rtol=1e-13, atol=1e-16,
                                 max_step=max_step, first_step=min(1e-9, (end - t) / 2), dense_output=True)
            assert solution.success, solution.message
            found = None
            knots = solution.t
            states = [solution.sol(x) for x in knots]
            for guard, direction, condition, target in exits:
                values = [guard(state) for state in states]
                for i in range(1, len(knots)):
                    # A guard that is zero where the mode begins has the sign of what follows.
                    before = values[i - 1] if i > 1 else guard(solution.sol(knots[0] + 1e-3 * (knots[1] - knots[0])))
                    if before * direction < 0 <= values[i] * direction:
                        low = knots[i - 1] if i > 1 else knots[0] + 1e-3 * (knots[1] - knots[0])
                        root = brentq(lambda x: guard(solution.sol(x)), low, knots[i], xtol=1e-18, rtol=1e-15)
                        if condition(solution.sol(root)) and (found is None or root < found[0]):
                            found = (root, target)
                        if condition(solution.sol(root)):
                            break
            until = found[0] if found else end
            while wanted and wanted[0] <= until:
                at = solution.sol(wanted[0])
                r = self.rate(mode, wanted[0], at)
                samples.append(dict(time=wanted[0], mode=mode, phi1=at[0], phi2=at[1], dphi1=at[2], dphi2=at[3],
                                    ddphi1=r[2], ddphi2=r[3]))
                wanted.pop(0)
            if not found:
                break
            t, target = found
            y = list(solution.sol(t))
            name = target(y) if callable(target) else target
            if name in ("stick", "gap", "back") or (mode == "back" and name == "run"):
                y[3] = 0.0
            events.append(dict(time=t, to=name))
            mode = name
        return events, samples


def stepped(scene, changes, end=0.1, **kind):
    drive = Stepped(**kind, **changes)
    mode = "gap" if kind.get("clearance") else "wind"
    events, samples = drive.go(end, [end * k / 20 for k in range(1, 21)], mode=mode)
    return dict(scene=scene, values=changed(changes), end=end, events=events, samples=samples)


def apart(case, **kind):
    """The largest distance of a closed form from the stepped motion, angles and speeds."""
    changes = {name: repr(value) for name, value in case["values"].items()}
    times = [float(one["time"]) for one in case["samples"]]
    events, samples = Stepped(**kind, **changes).go(times[-1], times)
    off = [abs(float(a["time"]) - b["time"]) for a, b in zip(case["events"], events)]
    for a, b in zip(case["samples"], samples):
        off += [abs(float(a[name]) - b[name]) / (1 + abs(b[name])) for name in ("phi1", "phi2", "dphi1", "dphi2")]
    assert len(samples) == len(times) and max(off) < 1e-10, (case["scene"], max(off))
    return max(off)


def main():
    out = {"note": "SI units; d = d/dt; see table_drive.py. `closed` at 50 digits, `stepped` by SciPy."}
    undamped = dict(beta="0", lambda1="0", lambda2="0")
    # With J1 = 2^-11 and c = 2^9 the frequency k = 1024 is a number that floats hold.
    exact = dict(J1="0.00048828125", c="512")
    never = dict(Mc="1e6")
    closed = {
        "blocked": blocked(never),
        "blocked_soft": blocked(dict(never, c="30", beta="0.02")),
        "blocked_undamped": blocked(dict(never, **undamped)),
        "blocked_resonant": blocked(dict(never, **undamped, **exact, omega="1024"), wind_resonant),
        "blocked_nearly_resonant": blocked(dict(never, **undamped, **exact, omega="1024.0001")),
        "table_1": run_up("table_1", {}),
        "table_2": run_up("table_2", TABLE_2),
        "printed": run_up("printed", PRINTED),
        "undamped": run_up("table_1", dict(beta="0")),
        "overdamped": run_up("table_1", dict(beta="3")),
        "no_resistance": run_up("table_1", dict(Mc="0")),
        "double_root": run_up("table_1", dict(beta=repr(float(double_beta()))), double=True),
        "light_table": run_up("table_1", dict(J2="5e-7")),
        "stiff": run_up("table_1", dict(c="7.1e6")),
        "full": run_up("full", {}, full=True),
        "full_table_2": run_up("full", TABLE_2, full=True),
        "constant": constant({}),
    }
    # beta = 2 sqrt(c J1) = 1 exactly: the closed form divides by zero there, so its value 1e-20 beside is taken.
    critical = dict(never, **exact, beta="1")
    v = Values(mpf, **critical)
    v.beta = 1 - mpf(10)**-20
    at = wind_transient(v)
    closed["blocked_critical"] = dict(scene="blocked", values=changed(critical), events=[],
                                      samples=[sample(mpf(t), at(mpf(t))) for t in TIMES])
    kinds = {"full": dict(full=True), "full_table_2": dict(full=True), "constant": dict(motor="constant"),
             "blocked": dict(motor="transient"), "blocked_soft": dict(motor="transient")}
    for name in ("blocked", "blocked_soft", "table_1", "table_2", "printed", "undamped", "overdamped", "double_root", "full",
                 "full_table_2", "constant"):
        closed[name]["apart"] = apart(closed[name], **kinds.get(name, {}))
    for exponent in (0, -2, -4, -6, -8, -10, -12):
        name = "starts_at_1e%d" % exponent
        closed[name] = start_of("switched", dict(Mc="1e%d" % exponent))
    v = Values(mpf, g="5e-3")
    gap = tried(gap_linear(v), lambda t, y: v.J1 * y[2] - v.Ms * (1 - y[1] / v.omega))
    t0 = first(lambda t: gap(t)[0], v.g, mpmath.sqrt(2 * v.g * v.J1 / v.Ms))
    closed["contact"] = dict(scene="loose", values=dict(g=5e-3), events=[dict(time=text(t0), to="wind")], samples=[],
                             speed=text(gap(t0)[1]))
    out["closed"] = closed
    v = Values(mpf)
    out["starting"] = [dict(time=time, torque=text(starting(v, mpf(time), mpmath)))
                       for time in ("1e-9", "1e-8", "1e-7", "1e-6", "1e-5", "1e-4", "1e-3", "0.01", "0.1", "10", "1000")]
    out["stepped"] = {
        "switched": stepped("switched", {}, motor="switched"),
        "transient": stepped("transient", {}, motor="transient"),
        "kloss": stepped("kloss", {}, end=0.2, motor="kloss"),
        "kloss_table_2": stepped("kloss", TABLE_2, end=0.2, motor="kloss"),
        "loose": stepped("loose", dict(g="5e-3"), clearance=True),
        "loose_undamped": stepped("loose", dict(g="5e-3", beta="0.05"), clearance=True),
        "loose_wide": stepped("loose", dict(g="0.02", beta="0.05", J2="5e-5"), clearance=True),
        "loose_rubbing": stepped("loose", dict(g="0.01", beta="0.02", Mc="4"), clearance=True),
        "loose_switched": stepped("loose_switched", dict(g="5e-3"), clearance=True, motor="switched"),
        "loose_full": stepped("loose_full", dict(g="5e-3"), clearance=True, full=True),
        "loose_full_rubbing": stepped("loose_full", dict(g="5e-3", Mc="10", beta="0.05"), clearance=True, full=True),
        "rubbing": stepped("table_1", dict(beta="0.001", Mc="16.5", J2="5e-5")),
        "stalled": stepped("table_1", dict(beta="0.01", Mc="18")),
        # In resonance the torque of the link grows until it moves the table, now forwards, now backwards.
        "pulled_back": stepped("transient", dict(beta="0.001", Mc="30", J2="5e-3", c="12.3", lambda1="0", lambda2="0"),
                               end=0.3, motor="transient"),
    }
    print(rows.text(out))
    print()


if __name__ == "__main__":
    main()
