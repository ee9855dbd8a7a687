#!/usr/bin/env python3
"""Independent reference for the presser foot.

    python3 tests/reference/presser_foot.py > tests/reference/presser_foot.json

SciPy's DOP853 at rtol 1e-13 from breakpoint to breakpoint of the path and from event to event, roots of the continuous
solution by Brent's method; Newton's method on the stroboscopic map at phi = -pi with variational equations of its own.
Everything that follows from the path (harmonics, breakpoints) is computed here from its definition. `linear` is another
way: the fabric without separation by its Fourier series, of which the coefficients of the path come from quadrature.
Needs numpy, scipy. Everything is SI; an angle is in radian.

    m v' = F2 - F10 - c1 w - mu1 v - m g,   D = s - w,   F2 = f(D, D') if D > 0 and f > 0, else 0
"""
import json
import math
import sys
import numpy as np
from scipy.integrate import quad, solve_ivp
from scipy.linalg import expm
from scipy.optimize import brentq, minimize_scalar

BASE = dict(m=0.15, c1=2000.0, mu1=2.0, F10=40.0, c2=1e5, c3=0.0, mu2=30.0, eta=0.8, g=9.80665, omega=300.0,
            phi_p=math.radians(120), phi_v=math.radians(60), rise=1e-3)
LOW, STRAIGHT = dict(rise=2e-4), dict(rise=5e-4)
PROGRESSIVE = dict(c2=4e4, c3=1.5e11)
STIFF = dict(c2=4e5, mu2=40.0)
GAUSS = np.polynomial.legendre.leggauss(20)


class Foot:
    def __init__(self, path="elliptic", law="kelvin_voigt", **changes):
        self.path, self.law, self.glued = path, law, False
        for name, value in dict(BASE, **changes).items():
            setattr(self, name, value)
        self.half = self.phi_p / 2
        self.period = 2 * math.pi / self.omega
        self.knots = {"elliptic": [-self.half, self.half], "harmonics": [],
                      "straight": [-self.half, -self.phi_v / 2, self.phi_v / 2, self.half]}[path]
        if path == "harmonics":
            exact = lambda x: self.rise * (math.cos(x) - math.cos(self.half)) / (1 - math.cos(self.half))
            term = lambda k: quad(lambda x: exact(x) * math.cos(k * x), 0, self.half, epsabs=1e-17, epsrel=1e-14)[0]
            self.a = [term(0) / math.pi] + [2 * term(k) / math.pi for k in range(1, 6)]

    def place(self, part, t):
        """s and its first two rates in a part between breakpoints, number 0 before the first."""
        x, o = self.omega * t - math.pi, self.omega
        x -= 2 * math.pi * self.turn
        if self.path == "harmonics":
            a = self.a
            return (sum(a[k] * math.cos(k * x) for k in range(6)), -o * sum(k * a[k] * math.sin(k * x) for k in range(6)),
                    -o * o * sum(k * k * a[k] * math.cos(k * x) for k in range(6)))
        if part in (0, len(self.knots)):
            return 0.0, 0.0, 0.0
        if self.path == "elliptic":
            h, edge = self.rise / (1 - math.cos(self.half)), math.cos(self.half)
            return h * (math.cos(x) - edge), -h * o * math.sin(x), -h * o * o * math.cos(x)
        if part == 2:
            return self.rise, 0.0, 0.0
        width = self.half - self.phi_v / 2
        side = 1.0 if part == 3 else -1.0
        u, r = (side * x - self.phi_v / 2) / width, side * o / width
        return (self.rise * (1 - 2 * u**3 + u**4), self.rise * r * (4 * u**3 - 6 * u * u),
                self.rise * r * r * (12 * u * u - 12 * u))

    def fabric(self, part, t, w, v):
        """f, Delta, Delta' and the derivatives of f by Delta and Delta'."""
        s, ds, _ = self.place(part, t)
        D, dD = s - w, ds - v
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
                k, d = -(self.c1 + fD) / self.m, -(self.mu1 + fR) / self.m
                out += [y[4], y[5], k * y[2] + d * y[4], k * y[3] + d * y[5]]
            return out
        return rate

    def stretch(self, contact, part, t, end, y, vary):
        """In one mode and part of the path up to an event or the end. Gives time, state, whether an event, solution."""
        solution = solve_ivp(self.rate(contact, part, vary), (t, end), y, method="DOP853", rtol=1e-13, atol=1e-17,
                             max_step=self.period / 250, dense_output=True,
                             first_step=min(1e-3 * self.period / 250, (end - t) / 2))
        assert solution.success, solution.message
        at = solution.sol
        value = lambda x: self.fabric(part, x, at(x)[0], at(x)[1])
        if self.glued:
            guards = []
        elif contact:
            guards = [(lambda x: -value(x)[0], lambda x: True)]
        else:
            guards = [(lambda x: value(x)[1], lambda x: value(x)[0] > 0), (lambda x: value(x)[0], lambda x: value(x)[1] > 0)]
        found = end
        eps = 1e-9 * self.period
        times = np.concatenate([np.linspace(a, b, 4)[:-1] for a, b in zip(solution.t, solution.t[1:])] + [[end]])
        times = times[times > t + eps]
        times = np.concatenate([[t + min(eps, (end - t) / 4)], times])
        for guard, condition in guards:
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
                        found = min(found, root)
                        break
                before = after
        return found, at(found), found < end, solution

    def go(self, y, turns=1, vary=False, contact=True, pieces=None, events=None):
        """From phi = -pi over so many turns."""
        y = list(y[:2]) + ([1.0, 0.0, 0.0, 1.0] if vary else [])
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
                    begin = t
                    t, y, happened, solution = self.stretch(contact, part, t, end, y, vary)
                    if pieces is not None:
                        pieces.append((contact, part, self.turn, begin, t, solution.sol))
                    if happened:
                        w, v = y[:2]
                        before = [v, self.acceleration(contact, part, t, w, v)]
                        f, D, dD, fD, fR = self.fabric(part, t, w, v)
                        by_gap = not contact and abs(D) < abs(f) / (fD + 1e-30)
                        if vary:
                            after = [v, self.acceleration(not contact, part, t, w, v)]
                            _, ds, dds = self.place(part, t)
                            if by_gap:
                                slope, passing = np.array([-1.0, 0.0]), dD
                            else:
                                slope = np.array([-fD, -fR])
                                passing = fD * dD + fR * (dds - before[1])
                            jump = np.eye(2) + np.outer(np.array(after) - np.array(before), slope) / passing
                            y = np.array(y)
                            y[2:] = (jump @ y[2:].reshape(2, 2)).ravel()
                        contact = not contact
                        if events is not None:
                            events.append((t, contact, "gap" if by_gap else "force"))
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
        for contact, part, turn, begin, end, sol in pieces:
            self.turn = turn
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
            elif path == "harmonics":
                move, begin, s = np.zeros((11, 11)), np.zeros(11), np.zeros(11)
                begin[10], s[10] = 1.0, foot.a[0]
                for k in range(1, 6):
                    i = 2 * k - 2
                    move[i, i + 1], move[i + 1, i] = -k * o, k * o
                    begin[i], begin[i + 1], s[i] = math.cos(k * a), math.sin(k * a), foot.a[k]
            else:
                width = foot.half - foot.phi_v / 2
                r = {1: -o / width, 3: o / width}.get(number, 0.0) if path == "straight" else 0.0
                u = {1: 1.0, 3: 0.0}.get(number, 0.0)
                move = np.diag([r * k for k in range(1, 5)], -1)
                begin = np.array([u**k for k in range(5)])
                s = foot.rise * np.array([1.0, 0, 0, -2, 1]) if r else np.zeros(5)
                s[0] = s[0] if r else (foot.rise if path == "straight" and number == 2 else 0.0)
            n = len(begin)
            ds = s @ move
            A = np.zeros((2 + n, 2 + n))
            A[0, 1] = 1
            A[1, :2] = -(c1 + c2) / m, -(mu1 + mu2) / m
            one = np.zeros(n)
            one[{3: 2, 11: 10}.get(n, 0)] = 1.0
            A[1, 2:] = (c2 * s + mu2 * ds - self.weight * one) / m
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
             elliptic_low=("elliptic", dict(rise=2e-4)))


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
        free = [end - begin for contact, _, _, begin, end, _ in pieces if not contact]
        rows.append(dict(omega=foot.omega, above=above, glued=list(Linear(omega=foot.omega, mu2=mu2).start), start=list(y),
                         flight=sum(free), flights=len(free)))
        print("grazing", mu2, border, rows[-1], file=sys.stderr)
    return dict(border=border, mu2=mu2, rows=rows)


def case(scene, path="elliptic", law="kelvin_voigt", start=None, contact=True, **changes):
    foot = Foot(path, law, **changes)
    y, n, multipliers, contact = foot.cycle(start, contact=contact)
    pieces, events = [], []
    foot.go(y, n, contact=contact, pieces=pieces, events=events)
    largest, smallest, mean = foot.forces(pieces)
    free = sum(end - begin for contact, _, _, begin, end, _ in pieces if not contact) / (n * foot.period)
    order = sorted(multipliers, key=lambda x: -abs(x))
    print(scene, changes, n, [abs(x) for x in order], len(events), file=sys.stderr)
    return dict(scene=scene, values=changes, start=list(y), mode="contact" if contact else "flight", turns=n, multipliers=[[x.real, x.imag] for x in map(complex, order)],
                events=[dict(time=t, to="contact" if into else "flight", by=by) for t, into, by in events],
                largest=largest, smallest=smallest, mean=mean, free=free)


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
    # Newton's method comes to a motion that is not stable.
    cases["stiff_300"] = case("elliptic", **STIFF)
    out["cases"] = cases
    out["linear"] = {name: linear(name) for name in PATHS}
    out["first_separation"] = dict(progressive=first_separation("kelvin_voigt", 220.0, 232.0, **PROGRESSIVE),
                                   hunt_crossley=first_separation("hunt_crossley", 220.0, 232.0))
    out["grazing"] = [grazing(30.0, 226.0, 227.0), grazing(0.0, 229.0, 230.0)]
    json.dump(out, sys.stdout, indent=1)
    print()


if __name__ == "__main__":
    main()
