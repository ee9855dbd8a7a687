#!/usr/bin/env python3
"""Independent reference for the presser foot.

    python3 tests/reference/presser_foot.py > tests/reference/presser_foot.json

SciPy's DOP853 at rtol 1e-13 from breakpoint to breakpoint of the path and from event to event, roots of the continuous
solution by Brent's method; Newton's method on the stroboscopic map at phi = -pi with variational equations of its own.
Everything that follows from the path (harmonics, breakpoints) is computed here from its definition. `linear` is another
way: the fabric without separation by its Fourier series, of which the coefficients of the path come from quadrature.
The feed mechanism is closed by circles (linkages.py). Needs numpy, scipy, mpmath. Everything is SI; an angle is in radian.

    m v' = F2 - F10 - c1 w - mu1 v - m g,   D = s - w,   F2 = f(D, D') if D > 0 and f > 0, else 0

On a plate that yields (c_p) D = max(Y, sink w) - w with sink = c2/(c2 + c_p); where Y passes sink w is an event too.
"""
import functools
import math
import sys
import mpmath as mp
import numpy as np
from scipy.integrate import quad, solve_ivp
from scipy.linalg import expm
from scipy.optimize import brentq, linprog, minimize_scalar
import linkages
import rows

BASE = dict(m=0.15, c1=2000.0, mu1=2.0, F10=40.0, c2=1e5, c3=0.0, mu2=30.0, eta=0.8, g=9.80665, omega=300.0,
            phi_p=math.radians(120), phi_v=math.radians(60), rise=1e-3, q1=0.0, q2=0.0, q3=0.0, drop=3e-3, order=5,
            c_p=math.inf, plate_level=36e-3)
LOW, STRAIGHT = dict(rise=2e-4), dict(rise=5e-4)
PROGRESSIVE = dict(c2=4e4, c3=1.5e11)
STIFF = dict(c2=4e5, mu2=40.0)
LEGENDRE = [np.polynomial.Polynomial(c) for c in ([1], [-1, 2], [1, -6, 6])]
GAUSS = np.polynomial.legendre.leggauss(20)


def rack_height(phi):
    """Height of the tooth of the feed mechanism in metres, the regulator at 20 degrees."""
    phi, circ, at = mp.degrees(phi), linkages.circ, linkages.at
    k = circ(at((76, -64), 5, phi), 40, at((76, -24), 30, 20), 30, 1)
    m = circ(k, 76, (0, 0), 24, 1)
    a = at((0, 0), 32, linkages.angle((0, 0), m) + 180)
    c = at((112, 32), 28, linkages.angle((112, 32), circ(at((76, -64), 6, phi + 90), 90, (112, 32), 36, 1)))
    turn = linkages.angle(a, circ(a, mp.hypot(84, 24), c, 24, -1)) - linkages.angle((0, 0), (84, -24))
    return float(a[1] + 36 * mp.sin(turn * linkages.RAD) + 5 * mp.cos(turn * linkages.RAD)) / 1000


@functools.cache
def rack_series(count=128):
    """The same as a trigonometric polynomial: its complex coefficients, which fall below rounding."""
    values = [rack_height(2 * mp.pi * k / count) for k in range(count)]
    found = np.fft.rfft(values)[:count // 4] / count
    found[1:] *= 2
    assert abs(found[-1]) < 1e-18
    return found


def rack(x, derivative=0):
    k = np.arange(len(rack_series()))
    return float(np.real(np.sum((1j * k) ** derivative * rack_series() * np.exp(1j * k * x))))


@functools.cache
def rack_crossings(level):
    """Where the rack comes above the plate and where it goes below it."""
    return [brentq(lambda x: rack(x) - level, *ends, xtol=1e-15, rtol=1e-15) for ends in ((-2.0, 0.0), (0.0, 2.0))]


@functools.cache
def rack_harmonics(level=BASE["plate_level"]):
    """Mean, cosines and sines up to the fifth of what the rack stands above the plate."""
    (low, high), (places, weights) = rack_crossings(level), np.polynomial.legendre.leggauss(80)
    nodes = [((high + low + (high - low) * x) / 2, (high - low) / 2 * c) for x, c in zip(places, weights)]
    integral = lambda shape: math.fsum(c * (rack(x) - level) * shape(x) for x, c in nodes)
    a = [integral(lambda x: 1.0) / (2 * math.pi)] + [integral(lambda x: math.cos(k * x)) / math.pi for k in range(1, 6)]
    return a, [0.0] + [integral(lambda x: math.sin(k * x)) / math.pi for k in range(1, 6)]


class Foot:
    def __init__(self, path="elliptic", law="kelvin_voigt", **changes):
        self.path, self.law, self.glued = path, law, False
        for name, value in dict(BASE, **changes).items():
            setattr(self, name, value)
        self.half = self.phi_p / 2
        self.period = 2 * math.pi / self.omega
        self.sink = self.c2 / (self.c2 + self.c_p)
        # On a plate that yields an ellipse has no breakpoints of its own.
        self.knots = {"elliptic": [] if self.sink else [-self.half, self.half], "harmonics": [], "series": [],
                      "straight": [-self.half, -self.phi_v / 2, self.phi_v / 2, self.half],
                      "mechanism": rack_crossings(self.plate_level) if path == "mechanism" else []}[path]
        power = np.polynomial.Polynomial
        shape = power([1, 0, 0, -2, 1]) + power([0, 0, 1, -1]) * sum(q * p for q, p in zip((self.q1, self.q2, self.q3), LEGENDRE))
        # The transition from 1 to 0 with its derivatives.
        self.shape = [shape, shape.deriv(), shape.deriv(2)]
        if path == "series":
            self.a, self.b = rack_harmonics()
        if path == "harmonics":
            exact = lambda x: self.rise * (math.cos(x) - math.cos(self.half)) / (1 - math.cos(self.half))
            term = lambda k: quad(lambda x: exact(x) * math.cos(k * x), 0, self.half, epsabs=1e-17, epsrel=1e-14)[0]
            self.a, self.b = [term(0) / math.pi] + [2 * term(k) / math.pi for k in range(1, 6)], [0.0] * 6

    def place(self, part, t):
        """s and its first two rates in a part between breakpoints, number 0 before the first; on a plate that yields Y."""
        x, o = self.omega * t - math.pi, self.omega
        x -= 2 * math.pi * self.turn
        if self.path in ("harmonics", "series"):
            waves = [(k, self.a[k] * math.cos(k * x) + self.b[k] * math.sin(k * x),
                      self.b[k] * math.cos(k * x) - self.a[k] * math.sin(k * x)) for k in range(self.order + 1)]
            return (sum(wave for _, wave, _ in waves), o * sum(k * slope for k, _, slope in waves),
                    -o * o * sum(k * k * wave for k, wave, _ in waves))
        if part in (0, len(self.knots)) and not self.sink:
            return 0.0, 0.0, 0.0
        if self.path == "mechanism":
            return rack(x) - self.plate_level, o * rack(x, 1), o * o * rack(x, 2)
        if self.path == "elliptic":
            h, edge = self.rise / (1 - math.cos(self.half)), math.cos(self.half)
            return h * (math.cos(x) - edge), -h * o * math.sin(x), -h * o * o * math.cos(x)
        if part == 2:
            return self.rise, 0.0, 0.0
        width = self.half - self.phi_v / 2
        side = 1.0 if part == 3 else -1.0
        if part in (0, 4):
            return self.below(x)
        u, r = (side * x - self.phi_v / 2) / width, side * o / width
        shape, slope, bend = self.shape
        return self.rise * shape(u), self.rise * r * slope(u), self.rise * r * r * bend(u)

    def below(self, x):
        """The straight path while it is below the plate: a parabola over the cosine."""
        width, o = self.half - self.phi_v / 2, self.omega
        power, edge = np.polynomial.Polynomial, math.cos(self.half)
        depth = power([edge, -1]) / (1 + edge)
        # The slope by x at half is that of the transition, -depth'(edge) sin(half) steep drop.
        steep = self.shape[1](1) * self.rise / width / (depth.deriv()(edge) * math.sin(self.half)) / self.drop
        dip = -self.drop * (steep * depth + (1 - steep) * depth**2)
        c, first, second = math.cos(x), dip.deriv(), dip.deriv(2)
        sine = math.sin(x)
        return dip(c), -o * sine * first(c), o * o * (sine * sine * second(c) - c * first(c))

    def support(self, low, part, t):
        """Level of the fabric, its first two rates, and how it moves with w. `low`: on the plate that yields."""
        return (0.0, 0.0, 0.0, self.sink) if low else self.place(part, t) + (0.0,)

    def fabric(self, part, t, w, v):
        """f, Delta, Delta' and the derivatives of f by Delta and Delta'."""
        s, ds, _, share = self.support(self.low, part, t)
        D, dD = s - (1 - share) * w, ds - (1 - share) * v
        spring, rate = self.c2 * D + self.c3 * D**3, self.c2 + 3 * self.c3 * D * D
        if self.law == "hunt_crossley":
            return spring * (1 + self.eta * dD), D, dD, rate * (1 + self.eta * dD), spring * self.eta
        mu = self.mu2 if self.law == "kelvin_voigt" else 0.0
        return spring + mu * dD, D, dD, rate, mu

    def acceleration(self, contact, part, t, w, v):
        f = self.fabric(part, t, w, v)[0] if contact else 0.0
        return (f - self.F10 - self.c1 * w - self.mu1 * v - self.m * self.g) / self.m

    def rate(self, contact, part, vary):
        def rate(t, y):
            w, v = y[0], y[1]
            out = [v, self.acceleration(contact, part, t, w, v)]
            if vary:
                fD, fR = self.fabric(part, t, w, v)[3:] if contact else (0.0, 0.0)
                share = self.support(self.low, part, t)[3]
                k, d = -(self.c1 + (1 - share) * fD) / self.m, -(self.mu1 + (1 - share) * fR) / self.m
                out += [y[4], y[5], k * y[2] + d * y[4], k * y[3] + d * y[5]]
            return out
        return rate

    def stretch(self, contact, part, t, end, y, vary):
        """In one mode and part of the path up to an event or the end. Gives time, state, which event, solution."""
        solution = solve_ivp(self.rate(contact, part, vary), (t, end), y, method="DOP853", rtol=1e-13, atol=1e-17,
                             max_step=self.period / 250, dense_output=True,
                             first_step=min(1e-3 * self.period / 250, (end - t) / 2))
        assert solution.success, solution.message
        at = solution.sol
        value = lambda x: self.fabric(part, x, at(x)[0], at(x)[1])
        always = lambda x: True
        if self.glued:
            guards = []
        elif contact:
            guards = [("contact", lambda x: -value(x)[0], always)]
        else:
            guards = [("contact", lambda x: value(x)[1], lambda x: value(x)[0] > 0),
                      ("contact", lambda x: value(x)[0], lambda x: value(x)[1] > 0)]
        if self.sink:
            side = 1 if self.low else -1
            guards.append(("support", lambda x: side * (self.place(part, x)[0] - self.sink * at(x)[0]), always))
        found, which = end, None
        eps = 1e-9 * self.period
        times = np.concatenate([np.linspace(a, b, 4)[:-1] for a, b in zip(solution.t, solution.t[1:])] + [[end]])
        times = times[times > t + eps]
        times = np.concatenate([[t + min(eps, (end - t) / 4)], times])
        for name, guard, condition in guards:
            before = guard(times[0])
            for a, b in zip(times, times[1:]):
                if a >= found:
                    break
                after = guard(b)
                if before < 0 <= after:
                    root = brentq(guard, a, b, xtol=1e-18, rtol=1e-15)
                    # The other quantity is zero with it where the law starts from zero.
                    later = min(b, root + 1e-9 * self.period)
                    if condition(later):
                        if root < found:
                            found, which = root, name
                        break
                before = after
        return found, at(found), which, solution

    def passing(self, contact, part, t, y, which):
        """Slopes of the guard of an event by w and v, its rate, and what it is called."""
        w, v = y[:2]
        f, D, dD, fD, fR = self.fabric(part, t, w, v)
        if which == "support":
            return np.array([-self.sink, 0.0]), self.place(part, t)[1] - self.sink * v, "support"
        _, _, dds, share = self.support(self.low, part, t)
        if not contact and abs(D) < abs(f) / (fD + 1e-30):
            return np.array([share - 1, 0.0]), dD, "gap"
        rate = fD * dD + fR * (dds - (1 - share) * self.acceleration(contact, part, t, w, v))
        return (1 - share) * np.array([-fD, -fR]), rate, "force"

    def go(self, y, turns=1, vary=False, contact=True, pieces=None, events=None):
        """From phi = -pi over so many turns."""
        y = list(y[:2]) + ([1.0, 0.0, 0.0, 1.0] if vary else [])
        self.low = self.sink > 0
        for self.turn in range(turns):
            bounds = [self.turn * self.period] + [(x + math.pi + 2 * math.pi * self.turn) / self.omega for x in self.knots]
            bounds.append((self.turn + 1) * self.period)
            for part, (t, end) in enumerate(zip(bounds, bounds[1:])):
                f, D = self.fabric(part, t, y[0], y[1])[:2]
                if not self.glued and part and contact != (f > 0 and (contact or D > 0)):
                    # The force jumps at a breakpoint and sets off the event there; its instant depends on nothing.
                    contact = not contact
                    if events is not None:
                        events.append((t, contact, "edge"))
                while t < end:
                    begin, low = t, self.low
                    t, y, which, solution = self.stretch(contact, part, t, end, y, vary)
                    if pieces is not None:
                        pieces.append((contact, part, self.turn, begin, t, solution.sol, low))
                    if not which:
                        continue
                    w, v = y[:2]
                    before = self.acceleration(contact, part, t, w, v)
                    slope, passing, by = self.passing(contact, part, t, y, which)
                    was = contact
                    if which == "support":
                        self.low = not self.low
                        # The force jumps with the rate of the support, and may set off another event.
                        f, D = self.fabric(part, t, w, v)[:2]
                        contact, by = f > 0 and (contact or D > 0), "edge"
                    else:
                        contact = not contact
                    if vary:
                        jump = np.eye(2) + np.outer([0, self.acceleration(contact, part, t, w, v) - before], slope) / passing
                        y = np.array(y)
                        y[2:] = (jump @ y[2:].reshape(2, 2)).ravel()
                    if events is not None and contact != was:
                        events.append((t, contact, by))
        return np.array(y), contact

    def cycle(self, start=None, follow=200, multiples=12, contact=True):
        """The motion that the start leads to: state, after how many turns, multipliers."""
        y = np.array(start if start is not None else [-(self.F10 + self.m * self.g) / self.c2, 0.0])
        past = [y]
        for _ in range(follow):
            y, contact = self.go(y, contact=contact)
            past.append(y)
            scale = np.array([1e-4, 1e-4 * self.omega])
            if len(past) > 30 and np.max(np.abs(past[-1] - past[-2]) / scale) < 1e-9:
                break
        near = [np.max(np.abs(past[-1] - past[-1 - n]) / scale) for n in range(1, multiples + 1)]
        n = next(i for i, x in enumerate(near) if x <= max(10 * min(near), 1e-8)) + 1
        for _ in range(12):
            end, _ = self.go(y, n, vary=True, contact=contact)
            matrix = end[2:].reshape(2, 2)
            step = np.linalg.solve(np.eye(2) - matrix, end[:2] - y[:2])
            y = y[:2] + step
            if np.max(np.abs(step) / scale) < 1e-11:
                break
        else:
            raise AssertionError("not closed: %r" % (step / scale))
        end, last = self.go(y, n, vary=True, contact=contact)
        assert last == contact
        assert np.max(np.abs(end[:2] - y) / scale) < 1e-10, (end[:2] - y) / scale
        return y, n, np.linalg.eigvals(end[2:].reshape(2, 2)), contact

    def forces(self, pieces):
        """Largest, smallest and mean force of the working stroke."""
        largest, smallest, total, time = -math.inf, math.inf, 0.0, 0.0
        for contact, part, turn, begin, end, sol, low_down in pieces:
            self.turn, self.low = turn, low_down
            low, high = [(x + math.pi + 2 * math.pi * turn) / self.omega for x in (-self.half, self.half)]
            a, b = max(begin, low), min(end, high)
            if b - a < 1e-13:
                continue
            time += b - a
            if not contact:
                largest, smallest = max(largest, 0.0), min(smallest, 0.0)
                continue
            force = lambda t: self.fabric(part, t, *sol(t)[:2])[0]
            grid = np.linspace(a, b, 400)
            values = [force(t) for t in grid]
            for sign in (1, -1):
                best = int(np.argmax([sign * x for x in values]))
                low_t, high_t = grid[max(best - 1, 0)], grid[min(best + 1, 399)]
                found = minimize_scalar(lambda t: -sign * force(t), bounds=(low_t, high_t), method="bounded",
                                        options=dict(xatol=1e-9 * (b - a)))
                value = max([sign * values[best], -found.fun])
                if sign > 0:
                    largest = max(largest, value)
                else:
                    smallest = min(smallest, -value)
            for x, y in zip(grid[::20], list(grid[20::20]) + [grid[-1]]):
                total += (y - x) / 2 * sum(c * force((x + y) / 2 + (y - x) / 2 * q) for q, c in zip(*GAUSS))
        return largest, smallest, total / time


    def history(self, pieces, turns):
        """F2 at times that are spread over the motion."""
        found = []
        for time in [(k + 0.37) / 12 * self.period for k in range(12 * turns)]:
            contact, part, self.turn, begin, end, sol, self.low = next(p for p in pieces if p[3] <= time <= p[4])
            found.append([time, self.fabric(part, time, *sol(time)[:2])[0] if contact else 0.0])
        return found


class Linear:
    """The linear fabric that is never left. Times count from the start of each part of the path."""

    def __init__(self, path="elliptic", **changes):
        foot = self.foot = Foot(path, **changes)
        m, c1, c2, mu1, mu2, o = foot.m, foot.c1, foot.c2, foot.mu1, foot.mu2, foot.omega
        self.weight = foot.F10 + m * foot.g
        bounds = [-math.pi] + foot.knots + [math.pi]
        self.parts = []
        for number, (a, b) in enumerate(zip(bounds, bounds[1:])):
            # s and s' as rows over states that move by themselves: powers, or cosines and sines.
            if path == "elliptic" and number == 1:
                h = foot.rise / (1 - math.cos(foot.half))
                move = np.zeros((3, 3))
                move[0, 1], move[1, 0] = -o, o
                begin, s = np.array([math.cos(a), math.sin(a), 1.0]), np.array([h, 0, -h * math.cos(foot.half)])
            elif path in ("harmonics", "series") or path == "mechanism" and number == 1:
                if path == "mechanism":
                    waves, one = rack_series(), 2 * len(rack_series()) - 2
                    mean, cosines, sines = waves[0].real - foot.plate_level, waves[1:].real, -waves[1:].imag
                else:
                    mean, cosines, sines, one = foot.a[0], foot.a[1:], foot.b[1:], 10
                move, begin, s = np.zeros((one + 1, one + 1)), np.zeros(one + 1), np.zeros(one + 1)
                begin[one], s[one] = 1.0, mean
                for k in range(1, one // 2 + 1):
                    i = 2 * k - 2
                    move[i, i + 1], move[i + 1, i] = -k * o, k * o
                    begin[i], begin[i + 1] = math.cos(k * a), math.sin(k * a)
                    s[i], s[i + 1] = cosines[k - 1], sines[k - 1]
            else:
                width = foot.half - foot.phi_v / 2
                r = {1: -o / width, 3: o / width}.get(number, 0.0) if path == "straight" else 0.0
                u = {1: 1.0, 3: 0.0}.get(number, 0.0)
                move = np.diag([r * k for k in range(1, 6)], -1)
                begin = np.array([u**k for k in range(6)])
                s = foot.rise * np.pad(foot.shape[0].coef, (0, 6))[:6] if r else np.zeros(6)
                s[0] = s[0] if r else (foot.rise if path == "straight" and number == 2 else 0.0)
            n = len(begin)
            ds = s @ move
            A = np.zeros((2 + n, 2 + n))
            A[0, 1] = 1
            A[1, :2] = -(c1 + c2) / m, -(mu1 + mu2) / m
            constant = np.zeros(n)
            constant[0 if n == 6 else n - 1] = 1.0
            A[1, 2:] = (c2 * s + mu2 * ds - self.weight * constant) / m
            A[2:, 2:] = move
            force = np.concatenate([[-c2, -mu2], c2 * s + mu2 * ds])
            self.parts.append((A, begin, force, (b - a) / o, (a, b)))
        whole, shift = np.eye(2), np.zeros(2)
        for A, begin, _, time, _ in self.parts:
            E = expm(A * time)
            whole, shift = E[:2, :2] @ whole, E[:2, :2] @ shift + E[:2, 2:] @ begin
        self.matrix, self.start = whole, np.linalg.solve(np.eye(2) - whole, shift)

    def states(self):
        y = self.start
        for part in self.parts:
            state = np.concatenate([y, part[1]])
            yield part, state
            y = (expm(part[0] * part[3]) @ state)[:2]

    def force(self, x):
        """F2 at an angle, within a part."""
        for (A, _, row, _, (a, b)), state in self.states():
            if a <= x <= b:
                return float(row @ expm(A * (x - a) / self.foot.omega) @ state)

    def smallest(self, count=400):
        """The smallest force of a revolution and its angle, one-sided limits at the breakpoints included."""
        best, where = math.inf, 0.0
        for (A, _, row, time, (a, b)), state in self.states():
            step, moved, values = expm(A * time / count), state, []
            for _ in range(count + 1):
                values.append(float(row @ moved))
                moved = step @ moved
            at = lambda t: float(row @ expm(A * t) @ state)
            for i in range(count + 1):
                if values[i] > min(values[max(i - 1, 0)], values[min(i + 1, count)]):
                    continue
                value, t = values[i], i * time / count
                if 0 < i < count:
                    found = minimize_scalar(at, bounds=((i - 1) * time / count, (i + 1) * time / count), method="bounded",
                                            options=dict(xatol=1e-13))
                    value, t = min((value, t), (found.fun, found.x))
                if value < best:
                    best, where = value, a + t * self.foot.omega
        return best, where

    def preload(self):
        """The smallest F10 that keeps contact: the force moves with it as it does at rest."""
        foot = self.foot
        return foot.F10 - self.smallest()[0] * (foot.c1 + foot.c2) / foot.c2


PATHS = dict(elliptic=("elliptic", {}), straight=("straight", STRAIGHT), straight_low=("straight", LOW),
             five_harmonics=("harmonics", {}), elliptic_half=("elliptic", dict(rise=5e-4)),
             elliptic_low=("elliptic", dict(rise=2e-4)), machine=("mechanism", {}), machine_harmonics=("series", {}))


def linear(name):
    path, changes = PATHS[name]
    smallest = lambda omega: Linear(path, omega=omega, **changes).smallest(150)[0]
    speeds = [120 + k for k in range(0, 301)]
    values = [smallest(omega) for omega in speeds]
    borders = []
    for i in range(300):
        if values[i] * values[i + 1] < 0:
            root = brentq(smallest, speeds[i], speeds[i + 1], xtol=1e-12, rtol=1e-14)
            borders.append(dict(omega=root, separates=bool(values[i + 1] < 0),
                                phi=Linear(path, omega=root, **changes).smallest()[1]))
    print(name, [(b["omega"], b["separates"], math.degrees(b["phi"])) for b in borders], file=sys.stderr)
    rows = []
    for omega in (150.0, 200.0, 250.0, 300.0, 350.0, 400.0, 500.0):
        one = Linear(path, omega=omega, **changes)
        angles = [math.radians(x) for x in (-150, -45, -10, 25, 50, 100)]
        rows.append(dict(omega=omega, start=list(one.start), preload=one.preload(), smallest=one.smallest()[0],
                         forces=[[x, one.force(x)] for x in angles]))
    return dict(values=changes, borders=borders, rows=rows)


def best_transition(omega=300.0, limit=6.0, **changes):
    """The transition that falls all the way and has the largest smallest force of the working stroke.

    The force of the linear fabric depends linearly on the shape: a linear programme. Where the force is least, and where
    the transition would rise, is added until nothing is left to add."""
    changes = dict(STRAIGHT, omega=omega, **changes)
    unit = np.eye(3)
    of = lambda q: Linear("straight", q1=q[0], q2=q[1], q3=q[2], **changes)
    all_of = [of(np.zeros(3))] + [of(row) for row in unit]
    falls = lambda u: [float(p.deriv()(u)) for p in
                       [np.polynomial.Polynomial([1, 0, 0, -2, 1])] +
                       [np.polynomial.Polynomial([0, 0, 1, -1]) * p for p in LEGENDRE]]
    def rows(part, t):
        found = []
        for one in all_of:
            (A, _, row, _, _), state = list(one.states())[part]
            found.append(float(row @ expm(A * t) @ state))
        return [found[0]] + [one - found[0] for one in found[1:]]
    times = [part[3] for part in all_of[0].parts]
    places = [(part, times[part] * k / 20) for part in (1, 2, 3) for k in range(21)]
    forces, slopes = [rows(*place) for place in places], [falls(k / 20) for k in range(21)]
    for _ in range(60):
        above = [[-r[1], -r[2], -r[3], 1.0] for r in forces] + [[r[1], r[2], r[3], 0.0] for r in slopes]
        right = [r[0] for r in forces] + [-r[0] for r in slopes]
        found = linprog([0, 0, 0, -1], above, right, bounds=[(-limit, limit)] * 3 + [(None, None)], method="highs",
                        options=dict(primal_feasibility_tolerance=1e-10, dual_feasibility_tolerance=1e-10))
        q = found.x[:3]
        worst = math.inf
        for part, (A, _, row, time, _), state in [(i, *list(of(q).states())[i]) for i in (1, 2, 3)]:
            at = lambda t: float(row @ expm(A * t) @ state)
            grid = np.linspace(0, time, 61)
            values = [at(t) for t in grid]
            # At the best shape several minima are equally low.
            for i in range(61):
                if values[i] > min(values[max(i - 1, 0)], values[min(i + 1, 60)]):
                    continue
                ends = grid[max(i - 1, 0)], grid[min(i + 1, 60)]
                best = minimize_scalar(at, bounds=ends, method="bounded", options=dict(xatol=1e-12))
                value, t = min((values[i], grid[i]), (best.fun, best.x))
                worst = min(worst, value)
                forces.append(rows(part, t))
        slope = Foot("straight", q1=q[0], q2=q[1], q3=q[2]).shape[1]
        u = np.linspace(0, 1, 2001)
        highest = float(np.max(slope(u)))
        slopes.append(falls(float(u[np.argmax(slope(u))])))
        if found.x[3] - worst < 1e-9 and highest < 1e-9:
            break
    else:
        raise AssertionError("not solved")
    smallest = of(q).smallest()[0]
    assert smallest > 0, "the foot would leave the fabric"
    print("shape", omega, q, found.x[3], worst, smallest, highest, file=sys.stderr)
    return dict(omega=omega, q=list(q), smallest=worst, before=Linear("straight", **changes).smallest()[0])


def growth(omega, settling=6, counted=24):
    """Lyapunov exponents of some turns from rest on the plate: a frame in w over 1 m and v over 1 m/s, whose first
    direction has part in both, is made orthonormal after every turn."""
    foot = Foot(omega=omega)
    y, contact, sums = [-(foot.F10 + foot.m * foot.g) / foot.c2, 0.0], True, np.zeros(2)
    frame = np.linalg.qr(np.array([[1.0, 0.0], [1.0, 1.0]]))[0]
    free, length = 0.0, counted * foot.period
    for turn in range(settling + counted):
        pieces = []
        y, contact = foot.go(y, vary=True, contact=contact, pieces=pieces)
        frame, upper = np.linalg.qr(y[2:].reshape(2, 2) @ frame)
        if turn >= settling:
            sums += np.log(np.abs(np.diag(upper)))
            free += sum(end - begin for contact, _, _, begin, end, *_ in pieces if not contact)
    print("growth", sums / length, np.exp(sums / counted), free / length, file=sys.stderr)
    return dict(omega=omega, settling=settling, counted=counted, exponents=list(sums / length), free=free / length,
                end=list(y[:2]))


def first_separation(law, low, high, **changes):
    """The speed at which the foot leaves a fabric that is not linear: where one that could pull would begin to."""
    def smallest(omega):
        foot = Foot("elliptic", law, omega=omega, **changes)
        foot.glued = True
        y, n, _, _ = foot.cycle(follow=40)
        pieces = []
        foot.go(y, n, pieces=pieces)
        return foot.forces(pieces)[1]
    return brentq(smallest, low, high, xtol=1e-9, rtol=1e-12)


def grazing(mu2, low, high):
    """Just above a speed at which contact is lost where the force has a smooth minimum."""
    border = brentq(lambda omega: Linear(omega=omega, mu2=mu2).smallest()[0], low, high, xtol=1e-12, rtol=1e-14)
    rows = []
    for above in (0.1, 0.025, 0.00625):
        foot = Foot(omega=border + above, mu2=mu2)
        y, n, _, contact = foot.cycle(list(Linear(omega=foot.omega, mu2=mu2).start), follow=40)
        assert contact and n == 1
        pieces = []
        foot.go(y, pieces=pieces)
        free = [end - begin for contact, _, _, begin, end, *_ in pieces if not contact]
        rows.append(dict(omega=foot.omega, above=above, glued=list(Linear(omega=foot.omega, mu2=mu2).start), start=list(y),
                         flight=sum(free), flights=len(free)))
        print("grazing", mu2, border, rows[-1], file=sys.stderr)
    return dict(border=border, mu2=mu2, rows=rows)


def case(scene, path="elliptic", law="kelvin_voigt", start=None, contact=True, follow=200, **changes):
    foot = Foot(path, law, **changes)
    y, n, multipliers, contact = foot.cycle(start, follow, contact=contact)
    pieces, events = [], []
    foot.go(y, n, contact=contact, pieces=pieces, events=events)
    largest, smallest, mean = foot.forces(pieces)
    free = sum(end - begin for contact, _, _, begin, end, *_ in pieces if not contact) / (n * foot.period)
    order = sorted(multipliers, key=lambda x: -abs(x))
    print(scene, changes, n, [abs(x) for x in order], len(events), file=sys.stderr)
    return dict(scene=scene, values=changes, start=list(y), mode="contact" if contact else "flight", turns=n, multipliers=[[x.real, x.imag] for x in map(complex, order)],
                events=[dict(time=t, to="contact" if into else "flight", by=by) for t, into, by in events],
                largest=largest, smallest=smallest, mean=mean, free=free, forces=foot.history(pieces, n))


def main():
    out = {"note": "SI units; see presser_foot.py"}
    cases = {}
    for omega in (200.0, 300.0, 400.0):
        cases["elliptic_%d" % omega] = case("elliptic", omega=omega)
        cases["straight_%d" % omega] = case("straight", "straight", omega=omega, **STRAIGHT)
        cases["straight_low_%d" % omega] = case("straight_low", "straight", omega=omega, **LOW)
    cases["progressive_300"] = case("progressive", **PROGRESSIVE)
    cases["five_harmonics_300"] = case("five_harmonics", "harmonics")
    cases["hunt_crossley_300"] = case("hunt_crossley", law="hunt_crossley")
    # Further ones: the force comes back before the gap closes; regain at the kink; short contacts.
    cases["progressive_250"] = case("progressive", omega=250.0, **PROGRESSIVE)
    cases["straight_180"] = case("straight", "straight", omega=180.0, **STRAIGHT)
    cases["elliptic_500"] = case("elliptic", omega=500.0)
    cases["elliptic_700"] = case("elliptic", omega=700.0)
    cases["light_300"] = case("elliptic", m=0.015)
    cases["held_by_weight"] = case("elliptic", F10=0.0, c1=0.0, omega=60.0)
    # Another motion at the same speed, for a foot that is let fall from 2 mm.
    cases["elliptic_500_other"] = case("elliptic", start=[2e-3, 0.0], contact=False, omega=500.0)
    # A multiplier near one; just beyond a doubling of the period; motions that are reached after hundreds of irregular
    # turns, and begin here near them.
    cases["elliptic_375"] = case("elliptic", omega=375.0, follow=80)
    cases["progressive_515"] = case("progressive", start=[-0.000846, 0.55184], omega=515.0, follow=60, **PROGRESSIVE)
    cases["stiff_335"] = case("elliptic", start=[-0.000117, 0.90827], omega=335.0, follow=40, **STIFF)
    # The feed mechanism, and its five harmonics.
    for omega in (200.0, 300.0, 400.0):
        cases["machine_%d" % omega] = case("machine", "mechanism", omega=omega)
        cases["machine_harmonics_%d" % omega] = case("machine_harmonics", "series", omega=omega)
    # A plate that yields.
    for omega in (200.0, 300.0, 500.0):
        cases["yielding_%d" % omega] = case("yielding", omega=omega, c_p=1e6)
        cases["yielding_straight_%d" % omega] = case("yielding_straight", "straight", omega=omega, c_p=5e5, **STRAIGHT)
    # Newton's method comes to a motion that is not stable.
    cases["stiff_300"] = case("elliptic", **STIFF)
    out["cases"] = cases
    out["rack"] = dict(crossings=rack_crossings(BASE["plate_level"]), cosines=rack_harmonics()[0], sines=rack_harmonics()[1])
    out["linear"] = {name: linear(name) for name in PATHS}
    out["first_separation"] = dict(progressive=first_separation("kelvin_voigt", 220.0, 232.0, **PROGRESSIVE),
                                   hunt_crossley=first_separation("hunt_crossley", 220.0, 232.0))
    out["grazing"] = [grazing(30.0, 226.0, 227.0), grazing(0.0, 229.0, 230.0)]
    out["transition"] = best_transition()
    out["irregular"] = growth(800.0)
    print(rows.text(out))
    print()


if __name__ == "__main__":
    main()
