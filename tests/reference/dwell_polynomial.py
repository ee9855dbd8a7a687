#!/usr/bin/env python3
"""The polynomial of degree 9 whose roots are lengths r of the rocker O3-D for which the squares of the misfit of the dyad C-D-O3 are
least: all its roots for the test vector of the specification (task 4a), for `solvers/src/synthesis/fit/tests.rs`.

    python3 tests/reference/dwell_polynomial.py

Normal equations and powers of r with 80 digits; nothing is shared with the equations of the project but the dimensions. Lengths in mm.
Needs mpmath.
"""
import mpmath as mp
from linkages import circ

mp.mp.dps = 80
DEG = mp.pi / 180
POSITIONS = 36


def turned(angle, v):
    c, s = mp.cos(angle), mp.sin(angle)
    return (c * v[0] - s * v[1], s * v[0] + c * v[1])


def arg(p, q):
    return mp.atan2(q[1] - p[1], q[0] - p[0])


def swing(phi):
    """How far the lift rocker has to swing: the rack unit inverted along its path, for a dwell of 60 deg, 0.2 mm and 3 mm."""
    working, still, rise, drop = 120 * DEG, 60 * DEG, mp.mpf("0.2"), 3
    d1, d2, p = (working - still) / 2, mp.pi - working / 2, abs(phi)
    g1 = 2 * rise * d2 / (drop * d1)
    a5 = 8 * (1 - g1) / 3 + g1
    a4 = -(1 - g1) / 3 - 3 * a5
    a3 = -4 * a4 - 10 * a5
    u, w = (p - still / 2) / d1, (p - working / 2) / d2
    if p <= still / 2:
        y = rise
    elif p <= working / 2:
        y = rise * (1 - 2 * u**3 + u**4)
    else:
        y = -drop * (g1 * w + a3 * w**3 + a4 * w**4 + a5 * w**5)
    q = (36 + 4 / (2 * mp.sin(working / 2)) * mp.sin(phi), 37 - rise + y)
    a = circ((0, 0), 32, q, mp.hypot(36, 5), 1)
    gamma = arg(a, q) - mp.atan2(5, 36)
    bx, by = turned(gamma, (84, -24))
    c = circ((112, 32), 28, (a[0] + bx, a[1] + by), 24, -1)
    beta = arg((112, 32), c)
    return mp.pi - (beta if beta > 0 else beta + 2 * mp.pi)


def terms(mode):
    """At each position |E|^2, f, g, h of the specification."""
    phi0, psi0, l1, l2, l3, l4, eta = map(mp.mpf, ("0.6", "2.9", "8", "60", "50", "70", "0.9"))
    found = []
    for index in range(POSITIONS):
        phi = 10 * index * DEG
        phi -= 2 * mp.pi if phi > mp.pi else 0
        a = turned(phi0 + phi, (l1, 0))
        theta = arg(a, circ(a, l2, turned(eta, (l4, 0)), l3, mode))
        e = turned(psi0 - swing(phi), (1, 0))
        big = (a[0] - 36, a[1] - 96)
        h = e[0] * big[0] + e[1] * big[1]
        found.append((big[0] ** 2 + big[1] ** 2, turned(-theta, big), turned(-theta, e), h))
    return found


def at(found, r):
    """For a length r: w and C, the misfits, the determinant of the inner problem, the slope of the sum of squares."""
    rows = [(mp.mpf(1), 2 * (f[0] - r * g[0]), 2 * (f[1] - r * g[1])) for _, f, g, _ in found]
    left, right = mp.matrix(rows), mp.matrix([2 * r * h - square for square, _, _, h in found])
    normal = left.T * left
    solution = mp.lu_solve(normal, left.T * right)
    misfit = left * solution - right
    moved = [-2 * h - 2 * (solution[1] * g[0] + solution[2] * g[1]) for _, _, g, h in found]
    slope = 2 * sum(one * way for one, way in zip(misfit, moved))
    return solution, misfit, mp.det(normal), slope


def polynomial(found):
    """Its coefficients by powers of r, through twelve places: those of the powers 10 and 11 are nothing."""
    places = [mp.mpf(10 * k - 55) for k in range(12)]
    powers = mp.matrix([[place**power for power in range(12)] for place in places])
    values = [at(found, place) for place in places]
    return mp.lu_solve(powers, mp.matrix([slope * determinant**2 for _, _, determinant, slope in values]))


if __name__ == "__main__":
    for mode in (1, -1):
        found = terms(mode)
        coefficients = polynomial(found)
        largest = max(abs(one) for one in coefficients)
        print("M1", mode, "coefficients over the largest", [mp.nstr(one / largest, 4) for one in coefficients])
        roots = mp.polyroots([coefficients[9 - k] for k in range(10)], maxsteps=500, extraprec=400)
        for root in roots:
            if abs(mp.im(root)) > mp.mpf(10) ** -40 or mp.re(root) <= 0:
                print("  ", mp.nstr(root, 20))
                continue
            r, beside = mp.re(root), mp.mpf("1e-15")
            solution, misfit, _, _ = at(found, r)
            square = solution[1] ** 2 + solution[2] ** 2 + r**2 - solution[0]
            curved = (at(found, r + beside)[3] - at(found, r - beside)[3]) / (2 * beside)
            numbers = {
                "r": r, "X_C": solution[1], "Y_C": solution[2], "L6^2": square, "L6": mp.sqrt(square),
                "S": sum(one**2 for one in misfit), "max": max(abs(one) for one in misfit), "S''": curved,
            }
            print("  ", ", ".join(f"{name} {mp.nstr(value, 18)}" for name, value in numbers.items()))
