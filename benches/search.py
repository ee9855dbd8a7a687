"""A search for the dwell six-bar by SciPy's differential evolution, what a design is worth compiled by numba.

As `src/hand_search.rs`: 72 positions, one design at a time, conditions in their order as penalties. Needs SciPy and numba:

    python3 search.py [DESIGNS]

It prints a line as those of `peers.py`: a name, nothing, designs that were judged, the deviation in degrees, seconds for each design.
"""
import json
import sys
import time

import numpy as np
from numba import njit
from scipy.optimize import Bounds, differential_evolution, fsolve

PLACES = 72
TURN = np.radians(360 * (np.arange(PLACES) + 0.5) / PLACES - 180)


def wanted():
    """What the lift rocker swings by, from the path of the middle tooth (`feed_inverse.eqn`), p_pl = 0.2 mm."""
    la, lc, ld, bx, by, qx, qy, ox, oy = 32, 28, 24, 84, -24, 36, 5, 112, 32
    stitch, phi_p, phi_v, rise, drop = 4, np.radians(120), np.radians(60), 0.2, 3
    d1, d2 = (phi_p - phi_v) / 2, np.pi - phi_p / 2
    g1 = 2 * rise * d2 / (drop * d1)
    a5 = 8 * (1 - g1) / 3 + g1
    a4 = -(1 - g1) / 3 - 3 * a5
    a3 = -4 * a4 - 10 * a5
    found, guess = [], np.array([np.pi / 2, 0, np.pi / 2, np.pi])
    for phi in TURN:
        turned = abs(phi)
        u, w = (turned - phi_v / 2) / d1, (turned - phi_p / 2) / d2
        x = stitch / (2 * np.sin(phi_p / 2)) * np.sin(phi)
        if turned < phi_v / 2:
            y = rise
        elif turned < phi_p / 2:
            y = rise * (1 - 2 * u**3 + u**4)
        else:
            y = -drop * (g1 * w + a3 * w**3 + a4 * w**4 + a5 * w**5)

        def gaps(z):
            alpha, gamma, delta, beta = z
            c, s = np.cos(gamma), np.sin(gamma)
            a = la * np.array([np.cos(alpha), np.sin(alpha)])
            tooth = a + [c * qx - s * qy, s * qx + c * qy] - np.array([qx + x, la + qy - rise + y])
            joint = a + [c * bx - s * by, s * bx + c * by] + ld * np.array([np.cos(delta), np.sin(delta)])
            return [*tooth, *(joint - [ox + lc * np.cos(beta), oy + lc * np.sin(beta)])]

        guess, _, status, _ = fsolve(gaps, guess, full_output=True, xtol=1e-13)
        assert status == 1
        found.append(np.pi - guess[3])
    return np.array(found)


@njit
def dyad(vx, vy, first, second, mode):
    """The direction of the first of two links between joints so far apart; NaN where they do not reach."""
    d2 = vx * vx + vy * vy
    along = (first * first + d2 - second * second) / (2 * d2)
    square = first * first / d2 - along * along
    across = mode * np.sqrt(square) if square >= 0 else np.nan
    return (along * vx - across * vy) / first, (along * vy + across * vx) / first


@njit
def worth(design, swing):
    """What is made small, or by how much the first condition is missed that is, beyond a hundred."""
    l1, l2, l3, l4, eta, x, y, l6, l7, phi0, psi0, m1, m2 = design
    m1, m2 = (1.0 if m1 >= 0 else -1.0), (1.0 if m2 >= 0 else -1.0)
    missed = -2.0 / np.pi
    if l2 + l3 - l1 - l4 < 0:
        return 100 * (8 + missed * np.arctan(l2 + l3 - l1 - l4))
    if abs(l4 - l1) < abs(l2 - l3):
        return 100 * (7 + missed * np.arctan(abs(l4 - l1) - abs(l2 - l3)))
    off, first, second = 0.0, 1.0, 1.0
    for k in range(PLACES):
        phi = phi0 + 2 * np.pi * (k + 0.5) / PLACES - np.pi
        ax, ay = l1 * np.cos(phi), l1 * np.sin(phi)
        vx, vy = l4 * np.cos(eta) - ax, l4 * np.sin(eta) - ay
        ux, uy = dyad(vx, vy, l2, l3, m1)
        wx, wy = ax + x * ux - y * uy - 36, ay + x * uy + y * ux - 96
        qx, qy = dyad(wx, wy, l7, l6, m2)
        # That the dyad reaches and folds is the same as that it closes.
        if np.isnan(qx):
            return 100 * (4 + 1 - k / PLACES)
        first = min(first, abs((l2 * ux - vx) * uy - (l2 * uy - vy) * ux) / l3)
        second = min(second, abs(qx * (l7 * qy - wy) - qy * (l7 * qx - wx)) / l6)
        aim = psi0 - swing[k]
        c, s = np.cos(aim), np.sin(aim)
        off = max(off, abs(np.arctan2(c * qy - s * qx, c * qx + s * qy)))
    limit = np.pi / 3
    return off + 0.2 * (max(np.arccos(first) - limit, 0) + max(np.arccos(second) - limit, 0))


def main():
    designs = int(sys.argv[1]) if len(sys.argv) > 1 else 100_000
    low = [3, 15, 15, 15, 0, -120, -120, 10, 10, 0, 0, -2, -2]
    high = [20, 110, 110, 110, 2 * np.pi, 120, 120, 120, 60, 2 * np.pi, 2 * np.pi, 2, 2]
    swing = wanted()
    worth(np.array(low, float), swing)
    clock = time.perf_counter()
    found = differential_evolution(
        worth, Bounds(low, high), args=(swing,), popsize=18, maxiter=designs // (18 * 13) - 1, seed=1, polish=False, tol=0
    )
    seconds = time.perf_counter() - clock
    print(json.dumps(["SciPy, numba", 1e-05, found.nfev, np.degrees(found.fun), seconds / found.nfev]))


main()
