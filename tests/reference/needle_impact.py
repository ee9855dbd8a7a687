#!/usr/bin/env python3
"""Independent reference for the needle that strikes a limiting cam.

    python3 tests/reference/needle_impact.py > tests/reference/needle_impact.json

`closed`: at 40 digits (mpmath), linear motions as sums of exponentials of the complex roots, every extreme and every loss
of contact looked for in them; the motion at critical damping by its own formula. `stepped`: SciPy's DOP853 at rtol 1e-13
from event to event, in modes of its own making. Needs mpmath, scipy. Everything is SI.

    overrun       m y'' = -P                                     y(0) = 0, y'(0) = V
    limiting cam  m y'' + 2 m h y' + c y = -P                    y(0) = 0, y'(0) = V
    wedge         m u'' + 2 m h u' + K u = P, u = v t - y        u(0) = u0, u'(0) = v
"""
import math
import random
import sys
from mpmath import mp, mpf, mpc
import mpmath
from scipy.integrate import quad, solve_ivp
from scipy.optimize import brentq
import rows

mp.dps = 40
DIGITS = 25
FACTORS = dict(cos2=lambda a, M: M.cos(a)**2, sin2=lambda a, M: M.sin(a)**2, sincos=lambda a, M: M.sin(a) * M.cos(a),
               cot2=lambda a, M: (M.cos(a) / M.sin(a))**2, one=lambda a, M: 1)
# Numbers as a program reads them: the nearest floats of the printed values in SI units.
BASE = dict(m=0.6e-3, P_C=4.8, Delta=0.25e-3, alpha=math.radians(47.5), D=3.75 * 0.0254, c_l=2.04e6, c_b=5.74e4, C=5.31e4,
            h=565.1, h_p=565.1, H_w=2e-3, V_c=1.75, a=2.5e-3, b=1.8e-3, s=0.45e-3, K_t=2.0, s_R=150e6, s_u=1500e6, N_0=1e7,
            k=8.0, z=2.0, s_Delta=0.05e-3 / 3, s_ln=0.1, t_life=3.6e6, V_given=2.1)


class Values:
    def __init__(self, num, **changes):
        for name, value in dict(BASE, **changes).items():
            setattr(self, name, num(value))


def text(x):
    return mpmath.nstr(x, DIGITS) if isinstance(x, mpf) else x


# ---- linear motions
class Linear:
    """x'' + 2 h x' + w2 x = 0 from x0, x1."""

    def __init__(self, w2, h, x0, x1):
        self.w2, self.h, self.x0, self.x1 = w2, h, x0, x1
        root = mpmath.sqrt(mpc(h * h - w2))
        self.double = abs(root) < mpf(10)**-30 * mpmath.sqrt(w2)
        self.rates = (-h + root, -h - root)

    def __call__(self, t, order=0):
        p, q = self.rates
        if self.double:
            a, b = self.x0, self.x1 - p * self.x0
            return mpmath.re(mpmath.exp(p * t) * (p**order * (a + b * t) + order * (p**(order - 1) if order else 0) * b))
        a = (self.x1 - q * self.x0) / (p - q)
        b = self.x0 - a
        return mpmath.re(a * p**order * mpmath.exp(p * t) + b * q**order * mpmath.exp(q * t))

    def root(self, f, step):
        """The first zero of f after 0, where its sign is different from that soon after 0."""
        t = step / 1000
        sign = f(t) > 0
        while (f(t + step) > 0) == sign:
            t += step
            if t > 400 * step:
                return None
        return bisected(f, t, t + step)


def bisected(f, low, high):
    found = mpmath.findroot(f, (low, high), solver="anderson", tol=mpf(10)**-60, maxsteps=200, verify=False)
    assert low <= found <= high, (low, found, high)
    return found


def peak_at_cam(V, P, m, c, h, whole):
    """Largest force of the loading stroke, in the exact motion."""
    if V == 0:
        return mpf(0)
    x = Linear(c / m, h, P / c, V)                          # y + P/c
    y = lambda t: x(t) - P / c
    force = lambda t: c * y(t) + (2 * m * h * x(t, 1) if whole else 0)
    rate = lambda t: c * x(t, 1) + (2 * m * h * x(t, 2) if whole else 0)
    if rate(mpf(0)) <= 0:
        return force(mpf(0))
    # The stroke takes V m/P where the friction ends it, less where the spring does.
    ways = [mpmath.sqrt(m / c)] + ([V * m / P] if P > 0 else []) + ([1 / h] if h > 0 else [])
    found = x.root(rate, min(ways) / 64)
    if found is None:
        found = x.root(rate, min(ways))
    return force(found)


def eq12(V, P, m, c, h):
    w = mpmath.sqrt(c / m)
    d = 2 * mpmath.pi * h / w
    t = mpmath.pi / (2 * mpmath.sqrt(c / m - h * h))
    return mpmath.exp(-h * t) * V * mpmath.sqrt(m * c / (1 - d * d / (4 * mpmath.pi**2))) - P


class Wedge:
    def __init__(self, v, V_c, factor, stuck, whole):
        self.v, self.V = v, V_c * mpmath.tan(v.alpha)
        self.K = FACTORS[factor](v.alpha, mpmath) * v.C
        P, h, m = v.P_C, v.h, v.m
        self.u0 = max(mpf(0), (P - 2 * m * h * self.V) / self.K) if stuck else mpf(0)
        self.x = Linear(self.K / m, h, self.u0 - P / self.K, self.V)
        self.w = mpmath.sqrt(self.K / m)
        self.whole = whole

    def force(self, t, order=0):
        spring = self.K * self.x(t, order) + (self.v.P_C if order == 0 else 0)
        return spring + (2 * self.v.m * self.v.h * self.x(t, order + 1) if self.whole else 0)

    def peak(self):
        return self.force(self.x.root(lambda t: self.force(t, 1), 1 / self.w / 20))

    def lowest(self):
        """When the force is least: the second zero of its rate."""
        rate = lambda t: self.force(t, 1)
        first = self.x.root(rate, 1 / self.w / 20)
        t = first + 1 / self.w / 100
        while rate(t) < 0:
            t += 1 / self.w / 20
        return bisected(rate, t - 1 / self.w / 20, t)

    def leaves(self):
        """When, if at all, and with which speed of the needle."""
        low = self.lowest()
        if self.force(low) > 0:
            return None
        first = self.x.root(lambda t: self.force(t, 1), 1 / self.w / 20)
        t = bisected(self.force, first, low)
        return t, self.V - self.x(t, 1)


def roughly(P, factor, stuck, whole, changes):
    """In floats: a function of the speed of the cylinder that gives the least force after the first maximum and its time, and
    one that gives the time of leaving and the speed of the needle then."""
    v = Values(float, P_C=P, **changes)
    K, h, m = FACTORS[factor](v.alpha, math) * v.C, v.h, v.m
    w = math.sqrt(K / m - h * h)
    times = [i * 2.2 * math.pi / w / 1500 for i in range(300, 1501)]

    def motion(V_c):
        V = V_c * math.tan(v.alpha)
        a = (max(0.0, (P - 2 * m * h * V) / K) if stuck else 0.0) - P / K
        b = (V + h * a) / w
        x = lambda t: math.exp(-h * t) * (a * math.cos(w * t) + b * math.sin(w * t))
        slip = lambda t: math.exp(-h * t) * ((b * w - h * a) * math.cos(w * t) - (a * w + h * b) * math.sin(w * t))
        return V, slip, lambda t: P + K * x(t) + (2 * m * h * slip(t) if whole else 0.0)

    def least(V_c):
        force = motion(V_c)[2]
        return min((force(t), t) for t in times)

    def leaves(V_c):
        V, slip, force = motion(V_c)
        t = brentq(force, times[0], least(V_c)[1])
        return t, V - slip(t)
    return least, leaves


def graze(P, factor, stuck, whole, **changes):
    """The speed of the cylinder at which the needle just loses the wedge, and when."""
    v = Values(mpf, P_C=P, **changes)
    least, _ = roughly(P, factor, stuck, whole, changes)
    low = 0.3
    while least(low * 1.05)[0] > 0:
        low *= 1.05
    V_c = brentq(lambda V: least(V)[0], low, low * 1.05)

    def conditions(V_c, t):
        wedge = Wedge(v, V_c, factor, stuck, whole)
        return [wedge.force(t) / v.P_C, wedge.force(t, 1) / v.P_C / 5000]
    V_c, t = mpmath.findroot(conditions, (mpf(V_c), mpf(least(V_c)[1])), tol=mpf(10)**-60, maxsteps=40)
    return V_c, t


def reach(P, factor, stuck, whole, **changes):
    """The slowest cylinder with which a needle that has left the wedge crosses the gap, and None where the first rebound is
    faster already."""
    v = Values(mpf, P_C=P, **changes)
    star = mpmath.sqrt(2 * v.P_C * v.Delta / v.m)
    _, leaves = roughly(P, factor, stuck, whole, changes)
    start = float(graze(P, factor, stuck, whole, **changes)[0]) * (1 + 1e-5)
    over = lambda V_c: leaves(V_c)[1] - float(star)
    if over(start) > 0:
        return None
    end = start
    while over(end) < 0:
        end *= 1.02
    V_c = brentq(over, start, end)

    def conditions(V_c, t):
        wedge = Wedge(v, V_c, factor, stuck, whole)
        return [wedge.force(t) / v.P_C, (wedge.V - wedge.x(t, 1)) / star - 1]
    V_c, t = mpmath.findroot(conditions, (mpf(V_c), mpf(leaves(V_c)[0])), tol=mpf(10)**-60, maxsteps=40)
    return V_c, t


# ---- strength
def stress(v, F):
    return v.K_t * 6 * F * v.a / (v.s * v.b**2) + F / (v.s * v.b)


def amplitude(v, F, goodman=True):
    half = stress(v, F) / 2
    return half / (1 - stress(v, F) / (2 * v.s_u)) if goodman else half


def damage(v, F, goodman=True, endurance=True):
    s = amplitude(v, F, goodman)
    return mpf(0) if endurance and s <= v.s_R else (s / v.s_R)**v.k / v.N_0


def stiffness(v):
    return 1 / (1 / v.c_l + 1 / v.c_b)


def speed_behind(v, V0, gap):
    square = V0**2 - 2 * gap * v.P_C / v.m
    return mpmath.sqrt(square) if square > 0 else mpf(0)


def fitted(v):
    tan = mpmath.tan(v.alpha)
    r, i = mpf(1.64), mpf(1.71)
    B = (4 - (i * tan)**2) / ((i * tan)**2 - (r * tan)**2)
    square = (v.V_c * tan)**2 + B * ((v.V_c * tan)**2 - (r * tan)**2)
    return max(mpmath.sqrt(square) if square > 0 else 0, v.V_c * tan)


def peak_in_floats(V, P, m, c, h):
    """The largest spring force at the limiting cam, weakly damped; its time by bisection."""
    w = math.sqrt(c / m - h * h)
    x = lambda t: math.exp(-h * t) * (P / c * math.cos(w * t) + (V + h * P / c) / w * math.sin(w * t))
    rate = lambda t: V * math.cos(w * t) - (h * V + P / m) / w * math.sin(w * t)
    return c * x(brentq(rate, 0.0, 1.6 / w, xtol=1e-18, rtol=1e-15)) - P


def chance(V0, F_wedge, both, endurance=False, **changes):
    """The probability that a needle breaks in time: of normal gaps and log-normal fatigue limits. Gauss-Kronrod between
    all kinks, in floats."""
    v, exact = Values(float, **changes), Values(mpf, **changes)
    c = 1 / (1 / v.c_l + 1 / v.c_b)
    cycles = v.z * v.t_life * v.V_c / (math.pi * v.D)
    V0, on = float(V0(exact)), float(F_wedge(exact)) if both else 0.0

    def amplitude(F):
        full = v.K_t * 6 * F * v.a / (v.s * v.b**2) + F / (v.s * v.b)
        return full / 2 / (1 - full / (2 * v.s_u))

    def used(F):
        s = amplitude(F)
        return 0.0 if F <= 0 or endurance and s <= v.s_R else (s / v.s_R)**v.k / v.N_0

    def force(x):
        square = V0**2 - 2 * max(v.Delta + v.s_Delta * x, 0.0) * v.P_C / v.m
        return peak_in_floats(math.sqrt(square), v.P_C, v.m, c, v.h_p) if square > 0 else 0.0

    def part(x):
        total = used(force(x)) + used(on)
        if total <= 0:
            return 0.0
        z = math.log(cycles * total) / (v.k * v.s_ln)
        return math.exp(-x * x / 2) / math.sqrt(2 * math.pi) * math.erfc(-z / math.sqrt(2)) / 2

    kinks = [-v.Delta / v.s_Delta, (v.m * V0**2 / (2 * v.P_C) - v.Delta) / v.s_Delta]
    if endurance:
        over = lambda x: amplitude(force(x)) - v.s_R
        grid = [i / 8 for i in range(-80, 81)]
        kinks += [brentq(over, a, b, xtol=1e-14) for a, b in zip(grid, grid[1:]) if over(a) * over(b) < 0]
    # Where the fatigue limit is used up at the median, the integrand has a step as wide as the scatter of the limit.
    for both_ends in [(i / 8, (i + 1) / 8) for i in range(-72, 72)]:
        over = lambda x: cycles * (used(force(x)) + used(on)) - 1
        if over(both_ends[0]) * over(both_ends[1]) < 0:
            step = brentq(over, *both_ends, xtol=1e-14)
            kinks += [step + i * v.s_ln * 2 for i in range(-8, 9)]
    ends = sorted([float(i) / 2 for i in range(-18, 19)] + [x for x in kinks if -9 < x < 9])
    return math.fsum(quad(part, a, b, epsabs=0, epsrel=1e-12, limit=200)[0] for a, b in zip(ends, ends[1:]) if b > a)


# ---- from event to event by SciPy
class Needle:
    def __init__(self, rebound=False, lag=False, coulomb=False, dashpot=False, damping=True, longitudinal=True,
                 stuck=True, factor="sincos", **changes):
        v = self.v = Values(float, **changes)
        self.rebound, self.lag, self.coulomb, self.dashpot, self.stuck = rebound, lag, coulomb, dashpot, stuck
        self.h, self.hp = (v.h, v.h_p) if damping else (0.0, 0.0)
        self.c = 1 / (1 / v.c_l + 1 / v.c_b) if longitudinal else v.c_b
        self.speed = v.V_c * math.tan(v.alpha)
        self.K = FACTORS[factor](v.alpha, math) * v.C
        self.top = v.H_w + v.Delta

    # What the cams do to a butt that touches them.
    def wedge(self, t, s):
        return self.K * (self.speed * t - s[0]) + 2 * self.v.m * self.h * (self.speed - s[1])

    def cam(self, t, s):
        return self.c * (s[0] - self.top) + 2 * self.v.m * self.hp * s[1]

    def seen_wedge(self, t, s):
        return self.wedge(t, s) if self.dashpot else self.K * (self.speed * t - s[0])

    def seen_cam(self, t, s):
        return self.cam(t, s) if self.dashpot else self.c * (s[0] - self.top)

    def forces(self, mode, t, s):
        return (self.seen_wedge(t, s) if mode in ("press", "stuck", "turn") else 0.0,
                self.seen_cam(t, s) if mode in ("impact", "back", "pressed") else 0.0)

    def rate(self, mode, t, s):
        P, m = self.v.P_C, self.v.m
        if mode in ("wait", "stuck", "pressed", "rest"):
            return [0.0, 0.0]
        force = {"press": lambda: self.wedge(t, s) - P, "turn": lambda: self.wedge(t, s) + P, "free": lambda: -P,
                 "overrun": lambda: -P, "impact": lambda: -P - self.cam(t, s), "back": lambda: P - self.cam(t, s),
                 "away": lambda: P if self.coulomb else -P}[mode]()
        return [s[1], force / m]

    def exits(self, mode):
        """(guard, direction, condition, next mode, what changes)."""
        v, out = self.v, []
        yes = lambda t, s: True
        stop = lambda s: [s[0], 0.0]
        stay = lambda s: s
        to_end = lambda s: [v.H_w, s[1]]
        u = lambda t, s: self.speed * t - s[0]
        d = lambda t, s: s[0] - self.top
        ended = lambda t, s: self.speed * t - v.H_w
        running = lambda t, s: self.speed * t < v.H_w
        chase = self.rebound and self.lag
        add = lambda *x: out.append(x)
        if mode == "wait":
            held = self.stuck or self.coulomb
            hard = 2 * v.m * self.h * self.speed > v.P_C
            add(u, 1, yes, "stuck" if held and not hard else "press", stay)
            if self.lag:
                add(ended, 1, yes, "rest", stay)
        if mode == "stuck":
            add(lambda t, s: self.wedge(t, s) - v.P_C, 1, yes, "press", stay)
            if self.lag:
                add(ended, 1, yes, "rest", stay)
        if mode == "press":
            if self.rebound:
                add(self.seen_wedge, -1, yes, "free" if self.lag else "overrun", stay if self.lag else to_end)
            if self.rebound and not self.lag:
                add(lambda t, s: self.speed - s[1], 1, yes, "overrun", to_end)
            if self.lag:
                add(ended, 1, yes, "overrun", stay)
            if self.coulomb and self.rebound:
                add(lambda t, s: s[1], -1, yes, "stuck", stop)
        if mode == "free":
            add(d, 1, yes, "impact", stay)
            add(u, 1, yes, "press", stay)
            if self.dashpot:
                add(self.wedge, 1, lambda t, s: u(t, s) > 0, "press", stay)
            add(ended, 1, yes, "overrun", stay)
            if self.coulomb:
                add(lambda t, s: s[1], -1, yes, "wait", stop)
        if mode == "overrun":
            add(d, 1, yes, "impact", stay)
            if self.coulomb:
                add(lambda t, s: s[1], -1, yes, "rest", stop)
        if mode == "impact":
            if self.coulomb:
                add(lambda t, s: s[1], -1, lambda t, s: self.c * d(t, s) > v.P_C, "back", stay)
                add(lambda t, s: s[1], -1, lambda t, s: self.c * d(t, s) <= v.P_C, "pressed", stop)
            else:
                add(self.seen_cam, -1, yes, "away", stay)
        if mode == "back":
            add(self.seen_cam, -1, yes, "away", stay)
            add(lambda t, s: s[1], 1, yes, "pressed", stop)
        if mode == "turn":
            add(lambda t, s: s[1], 1, lambda t, s: self.wedge(t, s) > v.P_C, "press", stay)
            add(lambda t, s: s[1], 1, lambda t, s: self.wedge(t, s) <= v.P_C, "stuck", stop)
            add(ended, 1, yes, "away", stay)
        if mode == "away":
            if self.dashpot:
                add(self.cam, 1, lambda t, s: d(t, s) > 0, "back" if self.coulomb else "impact", stay)
            if chase:
                add(u, 1, running, "turn" if self.coulomb else "press", stay)
            if self.coulomb:
                add(lambda t, s: s[1], 1, lambda t, s: chase and running(t, s), "wait", stop)
                add(lambda t, s: s[1], 1, lambda t, s: not (chase and running(t, s)), "rest", stop)
        return out

    def begin(self):
        if self.rebound:
            return "wait", [0.0, 0.0]
        if self.lag:
            return "press", [-self.v.P_C / self.K, self.speed]
        return "overrun", [self.v.H_w, self.speed]

    def go(self, end, samples=25, max_step=2e-6):
        mode, s = self.begin()
        t, events, out, peaks = 0.0, [], [], [0.0, 0.0]
        wanted = [end * (i + 0.37) / samples for i in range(samples)]
        while t < end:
            if mode == "wait" and t == 0:                       # the wedge touches the needle already
                mode = self.exits(mode)[0][3]
                events.append(dict(time=0.0, to=mode, y=0.0, speed=0.0))
            exits = self.exits(mode)
            solution = solve_ivp(lambda t, s: self.rate(mode, t, s), (t, end), s, method="DOP853", rtol=1e-13, atol=1e-18,
                                 max_step=max_step, first_step=min(1e-9, (end - t) / 2), dense_output=True)
            knots, at = solution.t, [solution.y[:, i] for i in range(len(solution.t))]
            found = None
            for guard, direction, condition, target, change in exits:
                values = [guard(x, y) for x, y in zip(knots, at)]
                for i in range(1, len(knots)):
                    low = knots[i - 1]
                    before = values[i - 1]
                    if i == 1:                                  # zero where the mode begins: the sign soon after
                        low = knots[0] + 0.5 * (knots[1] - knots[0])
                        before = guard(low, solution.sol(low))
                    if before * direction < 0 <= values[i] * direction:
                        x = brentq(lambda x: guard(x, solution.sol(x)), low, knots[i], xtol=1e-20, rtol=1e-15)
                        if condition(x, solution.sol(x)):
                            if found is None or x < found[0]:
                                found = (x, target, change)
                            break
            until = found[0] if found else end
            inside = [x for x in knots if x <= until]
            for i, x in enumerate(inside):                      # the largest forces, between the knots by parabolas
                for j in (0, 1):
                    peaks[j] = max(peaks[j], self.forces(mode, x, solution.sol(x))[j])
            for j in (0, 1):
                force = lambda x: self.forces(mode, x, solution.sol(x))[j]
                values = [force(x) for x in inside] + [force(until)]
                grid = inside + [until]
                k = max(range(len(values)), key=lambda i: values[i])
                peaks[j] = max(peaks[j], values[k], golden(force, grid[max(k - 1, 0)], grid[min(k + 1, len(grid) - 1)]))
            while wanted and wanted[0] < until:
                y = solution.sol(wanted[0])
                out.append(dict(time=wanted[0], y=y[0], speed=y[1]))
                wanted.pop(0)
            if not found:
                break
            s = list(found[2](list(solution.sol(found[0]))))
            t, mode = found[0], found[1]
            events.append(dict(time=t, to=mode, y=s[0], speed=s[1]))
            assert len(events) < 200
        return events, out, peaks


def golden(f, low, high):
    ratio = (math.sqrt(5) - 1) / 2
    for _ in range(80):
        a, b = high - ratio * (high - low), low + ratio * (high - low)
        if f(a) < f(b):
            low = a
        else:
            high = b
    return f((low + high) / 2)


def stepped(scene, end=3e-3, changes=None, **kinds):
    changes = changes or {}
    events, samples, peaks = Needle(**kinds, **changes).go(end)
    return dict(scene=scene, end=end, values=changes, events=events, samples=samples, F_wedge=peaks[0], F_cam=peaks[1])


# ---- the cases
def overruns():
    """Speed behind the gap and time to it, of floats as they are."""
    random.seed(1)
    out = []

    def one(m, P, gap, V0):
        M, p, g, V = map(mpf, (m, P, gap, V0))
        square = V * V - 2 * g * p / M
        V_tau = mpmath.sqrt(square)
        tau = (V - V_tau) * M / p if p > 0 else g / V
        naive = (V0 - math.sqrt(max(0.0, V0 * V0 - 2 * gap * P / m))) / (P / m) if P > 0 else None
        # As texts: not every reader of JSON reads the nearest float.
        out.append(dict(m=repr(m), P_C=repr(P), Delta=repr(gap), V_given=repr(V0), V_tau=text(V_tau), tau=text(tau),
                        naive=naive, naive_V=math.sqrt(max(0.0, V0 * V0 - 2 * gap * P / m))))
    # The speed that just crosses the gap is a float of 24 bits, so that its square is one.
    star = round(1.3 * 2**23) / 2**23
    for exponent in range(0, 15):
        one(2.0**-10, 8.0, star**2 / 2**14, star * (1 + (0.5 + random.random()) * 10.0**-exponent))
    for exponent in range(0, 19, 2):
        one(0.6e-3, 4.8 * 10.0**-exponent, 0.25e-3, 2.1)
    one(0.6e-3, 0.0, 0.25e-3, 2.1)
    return out


def blows():
    """Peak forces of impacts at a speed, for a gap of nothing."""
    out = []
    m, P = BASE["m"], BASE["P_C"]
    for V in (1e-6, 1e-3, 0.1, 0.5, 0.9, 1.5, 3.0):
        for h in (0.0, 1e-3, 565.1, 4000.0, 9000.0, 9600.0, 9646.0, 9700.0, 2e4, 1e5):
            for P in (4.8, 0.0, 1e-9):
                if P != 4.8 and (V not in (0.5, 1.5) or h not in (0.0, 565.1, 9646.0, 2e4)):
                    continue
                v = Values(mpf, P_C=P, h_p=h)
                c = stiffness(v)
                one = dict(values=dict(V_given=V, h_p=h, P_C=P, Delta=0.0),
                           exact=text(peak_at_cam(mpf(V), v.P_C, v.m, c, v.h_p, False)),
                           total=text(peak_at_cam(mpf(V), v.P_C, v.m, c, v.h_p, True)))
                if h * h < float(c) / m:
                    one["paper"] = text(eq12(mpf(V), v.P_C, v.m, c, v.h_p))
                out.append(one)
    # Critical damping to the last digit: c and m are powers of two.
    for V in (0.5, 2.0):
        changes = dict(m=2.0**-10, c_b=2.0**15, c_l=2.0**15, h_p=2.0**12)   # in series 2^14: w^2 = 2^24
        v = Values(mpf, **changes)
        c = stiffness(v)
        assert v.h_p**2 == c / v.m
        out.append(dict(values=dict(V_given=V, Delta=0.0, **changes),
                        exact=text(peak_at_cam(mpf(V), v.P_C, v.m, c, v.h_p, False)),
                        total=text(peak_at_cam(mpf(V), v.P_C, v.m, c, v.h_p, True))))
    return out


def variants():
    out = []
    for factor in FACTORS:
        for stuck in (True, False):
            for whole in (False, True):
                V_c, t = graze(4.8, factor, stuck, whole)
                met = reach(4.8, factor, stuck, whole)
                out.append(dict(factor=factor, begin="stuck" if stuck else "free", whole=whole, graze=text(V_c), t_graze=text(t),
                                reach=text(met[0]) if met else None, t_reach=text(met[1]) if met else None))
    return out


def over_inclination():
    """First rebound and first impact over the inclination of the wedge; the former is proportional to the friction."""
    out = []
    for degrees in (44.0, 45.5, 47.5, 49.0, 51.0):
        tilt = dict(alpha=math.radians(degrees))
        one = graze(4.8, "sincos", True, False, **tilt)[0]
        assert abs(graze(9.6, "sincos", True, False, **tilt)[0] / one - 2) < mpf(10)**-30
        out.append(dict(alpha=tilt["alpha"], graze=text(one), total=text(graze(4.8, "sincos", True, True, **tilt)[0]),
                        cos2=text(graze(4.8, "cos2", False, False, **tilt)[0]),
                        reach=text(reach(4.8, "sincos", True, False, **tilt)[0]),
                        reach_cos2=text(reach(4.8, "cos2", False, False, **tilt)[0])))
    return out


def struck():
    """Rebounds over the speed of the cylinder, from just above the first one."""
    first = graze(4.8, "sincos", True, False)[0]
    out = []
    for V_c in (1.665, 1.67, 1.71, 1.8, 2.0, 2.5, 3.0):
        assert V_c > first
        v = Values(mpf, V_c=V_c)
        wedge = Wedge(v, v.V_c, "sincos", True, False)
        t, V0 = wedge.leaves()
        V = speed_behind(v, V0, v.Delta)
        c = stiffness(v)
        F, on = peak_at_cam(V, v.P_C, v.m, c, v.h_p, False), wedge.peak()
        used = [v.z * damage(v, x) for x in (on, F)]
        out.append(dict(V_c=V_c, t_leave=text(t), V_0=text(V0), V_tau=text(V), F=text(F), F_wedge=text(on),
                        stress_wedge=text(stress(v, on)), stress_cam=text(stress(v, F)), damage_wedge=text(used[0]),
                        damage_cam=text(used[1]), used=text(sum(used) * v.V_c / (mpmath.pi * v.D))))
    return out


def sliding():
    out = []
    for V_c in (1.0, 1.64, 1.71, 1.83, 1.85, 1.9, 2.0, 2.5, 3.0):
        v = Values(mpf, V_c=V_c)
        V0 = v.V_c * mpmath.tan(v.alpha)
        V, c = speed_behind(v, V0, v.Delta), stiffness(v)
        F = peak_at_cam(V, v.P_C, v.m, c, v.h_p, False)
        whole = peak_at_cam(V, v.P_C, v.m, c, v.h_p, True)
        plain = peak_at_cam(V, v.P_C, v.m, v.c_b, mpf(0), False)
        used = v.z * damage(v, F)
        straight = v.z * (damage(v, plain, False, False) + damage(v, v.P_C, False, False))
        out.append(dict(V_c=V_c, speed=text(2 * v.V_c / v.D), V_0=text(V0), V_tau=text(V), F=text(F), F_total=text(whole),
                        F_plain=text(plain), F_paper=text(eq12(V, v.P_C, v.m, c, v.h_p)) if V > 0 else None,
                        stress_cam=text(stress(v, F)), damage_cam=text(used),
                        used_plain=text(straight * v.V_c / (mpmath.pi * v.D)),
                        gap_needed=text(v.m * V0**2 / (2 * v.P_C))))
    return out


def chances():
    slides = lambda v: v.V_c * mpmath.tan(v.alpha)
    friction = lambda v: v.P_C
    wedge = lambda v: Wedge(v, v.V_c, "sincos", True, False).peak()
    out = []

    def one(scene, V0, F, endurance=False, **changes):
        out.append(dict(scene=scene, values=changes, P_cam=chance(V0, F, False, endurance, **changes),
                        P_both=chance(V0, F, True, endurance, **changes)))
    for V_c in (1.8, 2.0, 2.6, 2.8, 3.0):
        one("chance", slides, friction, V_c=V_c)
    one("chance", slides, friction, V_c=2.8, s_Delta=0.2e-3)
    one("chance", slides, friction, V_c=2.8, s_ln=0.001, t_life=1.2e7)
    one("chance", slides, friction, V_c=2.8, k=25.0, s_ln=0.05)
    for V_c in (1.71, 1.8, 2.0):
        one("chance_struck", fitted, wedge, V_c=V_c, t_life=3.6e5, s_ln=0.2)
    for V in (3.9, 4.2, 5.0):
        one("chance_given", lambda v: v.V_given, wedge, True, V_given=V)
    return out


def main():
    v = Values(mpf)
    star = mpmath.sqrt(2 * v.P_C * v.Delta / v.m)
    limit = star / mpmath.tan(v.alpha)
    out = {"note": "SI units; see needle_impact.py. `closed` at 40 digits, `stepped` by SciPy."}
    closed = out["closed"] = dict(
        V_star=text(star), c_p=text(stiffness(v)), limit=text(limit), limit_speed=text(2 * limit / v.D),
        overruns=overruns(), blows=blows(), variants=variants(), over_inclination=over_inclination(), struck=struck(),
        sliding=sliding(), chances=chances())
    assert abs(star - 2) < 1e-15 and len(closed["variants"]) == 20
    full = dict(lag=True, coulomb=True, dashpot=True)
    out["stepped"] = {
        "selected": stepped("selected", 1e-3, dict(V_c=1.9)),
        "selected_slow": stepped("selected", 1e-3, dict(V_c=1.7)),
        "plain": stepped("plain", 1e-3, dict(V_c=1.9), damping=False, longitudinal=False),
        "rubbing": stepped("rubbing", 1e-3, dict(V_c=1.9), coulomb=True),
        "rubbing_slow": stepped("rubbing", 1e-3, dict(V_c=1.7), coulomb=True),
        "rubbing_pressed": stepped("rubbing", 1e-3, dict(V_c=1.835), coulomb=True),
        "rubbing_fast": stepped("rubbing", 1e-3, dict(V_c=3.0), coulomb=True),
        "total": stepped("total", 1e-3, dict(V_c=1.9), dashpot=True),
        "selected_full": stepped("selected_full", changes=dict(V_c=2.0), factor="cos2", **full),
        "selected_full_fast": stepped("selected_full", changes=dict(V_c=3.0), factor="cos2", **full),
        "unselected_slow": stepped("unselected", changes=dict(V_c=1.6), rebound=True),
        "unselected": stepped("unselected", changes=dict(V_c=1.75), rebound=True),
        "unselected_hard": stepped("unselected", changes=dict(V_c=1.75, h=3000.0), rebound=True),
        "unselected_free": stepped("unselected_free", changes=dict(V_c=1.75), rebound=True, stuck=False, factor="cos2"),
        "unselected_total": stepped("unselected_total", changes=dict(V_c=1.75), rebound=True, dashpot=True),
        "caught_up": stepped("caught_up", changes=dict(V_c=1.75), rebound=True, lag=True),
        "caught_up_often": stepped("caught_up", changes=dict(V_c=2.5, H_w=20e-3), end=12e-3, rebound=True, lag=True),
        "caught_up_early": stepped("caught_up", changes=dict(V_c=2.5, H_w=1e-3), rebound=True, lag=True),
        "unselected_full": stepped("unselected_full", changes=dict(V_c=1.75), rebound=True, **full),
        "unselected_full_fast": stepped("unselected_full", changes=dict(V_c=2.5), rebound=True, **full),
        "unselected_full_light": stepped("unselected_full", changes=dict(V_c=2.0, P_C=0.5, H_w=4e-3), rebound=True, **full),
        "unselected_full_short": stepped("unselected_full", changes=dict(V_c=2.0, H_w=0.5e-3), rebound=True, **full),
        "unselected_full_long": stepped("unselected_full", changes=dict(V_c=2.5, H_w=20e-3, P_C=2.0), end=12e-3, rebound=True,
                                        **full),
        # The limiting cam is reached ahead of the wedge, which meets the needle on its way back.
        "unselected_full_ahead": stepped("unselected_full", changes=dict(V_c=3.0, H_w=6e-3, Delta=0.02e-3, P_C=0.2),
                                         rebound=True, **full),
        "unselected_full_ended": stepped("unselected_full", changes=dict(V_c=3.0, H_w=0.1e-3), rebound=True, **full),
    }
    print(rows.text(out))
    print()


if __name__ == "__main__":
    main()
