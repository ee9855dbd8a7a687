#!/usr/bin/env python3
"""Four-bars through nine points, by SciPy's Levenberg-Marquardt from random starts.

Problem 3 of C. W. Wampler, A. P. Morgan, A. J. Sommese, J. Mech. Des. 114 (1992), 153-159. Of each crank the fixed pivot a and
the moving one x, from the first point, keep |way + e^(i theta) x - a| = |x - a| at each other point. What is found is checked
by eliminating the angles, and counted without regard to which crank comes first.

    python3 tests/reference/nine_points.py [STARTS]
"""

import sys

import numpy as np
from scipy.optimize import least_squares

POINTS = np.array([0.25, 0.52 + 0.10j, 0.80 + 0.70j, 1.20 + 1.00j, 1.40 + 1.30j, 1.10 + 1.48j, 0.70 + 1.40j, 0.20 + 1.00j, 0.02 + 0.40j])
WAY = POINTS[1:] - POINTS[0]


def cranks(v):
    a, x, b, y = v[:8:2] + 1j * v[1:8:2]
    return (a, x), (b, y)


def misfit(v):
    turn = np.exp(1j * v[8:])
    return np.concatenate([np.abs(WAY + turn * x - a) ** 2 - np.abs(x - a) ** 2 for a, x in cranks(v)])


def slopes(v):
    turn, rows = np.exp(1j * v[8:]), np.zeros((16, 16))
    for k, (a, x) in enumerate(cranks(v)):
        there, begin = WAY + turn * x - a, x - a
        part = rows[8 * k : 8 * k + 8]
        by_a, by_x = -there + begin, np.conj(turn) * there - begin
        part[:, 4 * k : 4 * k + 4] = 2 * np.array([by_a.real, by_a.imag, by_x.real, by_x.imag]).T
        part[:, 8:] = np.diag(2 * (np.conj(there) * 1j * turn * x).real)
    return rows


def off_circle(v):
    """By how much e^(i theta) is off the circle, as both cranks together determine it."""
    lines = []
    for a, x in cranks(v):
        product = x * np.conj(WAY - a)
        lines.append((product.real, -product.imag, 0.5 * np.abs(WAY) ** 2 + (WAY * np.conj(x - a)).real))
    (r1, i1, s1), (r2, i2, s2) = lines
    both = r1 * i2 - r2 * i1
    g, h = (i1 * s2 - i2 * s1) / both, (r2 * s1 - r1 * s2) / both
    return np.abs(np.abs(g + 1 + 1j * h) - 1).max()


def main():
    starts = int(sys.argv[1]) if len(sys.argv) > 1 else 26277
    random, found, exact = np.random.default_rng(7), [], 0
    for _ in range(starts):
        size = random.choice([1, 2, 4])
        start = np.concatenate([random.uniform(-size, size, 8), random.uniform(-np.pi, np.pi, 8)])
        end = least_squares(misfit, start, slopes, method="lm", xtol=1e-15, ftol=1e-15, gtol=1e-15, max_nfev=500)
        with np.errstate(all="ignore"):
            is_exact = end.cost < 1e-20 and off_circle(end.x) < 1e-6
        if is_exact:
            exact += 1
            one = end.x[:8] if end.x[0] <= end.x[4] else np.roll(end.x[:8], 4)
            if not any(np.abs(one - other).max() < 1e-4 * max(1, np.abs(other).max()) for other in found):
                found.append(one)
    within = sum(np.abs(one).max() <= 4 for one in found)
    print(f"{starts} starts, {exact} exact, {len(found)} distinct, {within} of them between -4 and 4")


if __name__ == "__main__":
    main()
