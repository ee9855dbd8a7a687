#!/usr/bin/env python3
"""Workloads of `assur-benches` by SciPy and by CasADi, whose integrators are CVODES and IDAS of SUNDIALS.

`pip install scipy casadi`, then `python3 peers.py WORKLOAD`. SciPy gets right-hand sides in plain numbers, which it is
fastest with for so few states. CasADi gets expressions and has its Jacobians from them; what it builds or has compiled is
ready before the clock starts. Times are of the processor, so that other work on the machine is not counted. One line for
each run: [method, rtol, evaluations, error, shortest time in s].
"""

import json
import os

os.environ["OMP_NUM_THREADS"] = os.environ["OPENBLAS_NUM_THREADS"] = "1"
import math
import shutil
import subprocess
import sys
import tempfile
import time
from math import cos, hypot, pi, radians, sin, sqrt

import casadi as ca
import numpy as np
from scipy.integrate import solve_ivp
from scipy.linalg.lapack import dgesv
from scipy.optimize import fsolve

RTOLS = [float(f"1e-{k}") for k in range(5, 14)]
# Rounds of a run, seconds after which there is none more, and the time from which on a method goes no further.
ROUNDS, BUDGET, SLOW = 10, 1.0, 1.0
# Absolute tolerance per unit of the relative one, where a workload has none of its own.
SCALE = 1e-3


def tell(*line):
    print(json.dumps(line), flush=True)


def timed(run):
    """What a run gives, and its shortest time."""
    shortest, spent = float("inf"), 0.0
    for _ in range(ROUNDS):
        start = time.process_time()
        found = run()
        took = time.process_time() - start
        shortest, spent = min(shortest, took), spent + took
        if spent > BUDGET:
            break
    return found, shortest


def climb(method, make, error):
    """Runs a method at all tolerances; a run gives the end, and what tells the number of evaluations."""
    for rtol in RTOLS:
        start = time.process_time()
        try:
            (end, evaluations), shortest = timed(make(rtol))
            wrong = float(error(end))
            if not math.isfinite(wrong):
                raise ArithmeticError(f"error {wrong}")
            tell(method, rtol, evaluations(), wrong, shortest)
        except Exception as problem:
            print(f"{method} at {rtol}: {' '.join(str(problem).split())[-120:]}", file=sys.stderr, flush=True)
            shortest = time.process_time() - start
        if shortest > SLOW:
            break


def by_scipy(method, rates, start, end, scales, **more):
    def run(rtol):
        atol = [rtol * scale for scale in scales]
        found = solve_ivp(rates, (0.0, end), start, method, rtol=rtol, atol=atol, **more)
        if not found.success:
            raise ArithmeticError(found.message)
        return found.y[:, -1], lambda: found.nfev

    return lambda rtol: lambda: run(rtol)


def by_casadi(plugin, problem, start, end, scale, **more):
    def make(rtol):
        options = {"reltol": rtol, "abstol": rtol * scale, "max_num_steps": 100_000, "show_eval_warnings": False, **more}
        code = ca.integrator("run", plugin, problem, 0.0, [end], options)
        return lambda: (code(**start)["xf"].full().ravel(), lambda: code.stats()["nfevals"])

    return make


def relative(exact):
    """The largest relative error of the states that are told."""
    return lambda y: max(abs(y[k] / value - 1) for k, value in exact.items())


# The elastic batten, as in `hand.rs`. Its end is by Gragg's extrapolation of order 16 in numbers with 64 bits of mantissa,
# 4000 steps. The same with 30 digits, 1500 steps, and DOP853 of SciPy at rtol 3e-14 differ from it by 2e-18 m and 2e-16 m.
SPEED, RADIUS, ROD, TURN, INERTIA, HEAVY, LOW, MASS = 250 * pi / 30, 0.075, 0.271, 20980.0, 0.1004, 28.5, 0.385, 2.02
BEND = RADIUS * RADIUS / (2 * ROD)
K33, K34 = 3.80e-6 / (3.80e-6**2 - 1.22e-6**2), -1.22e-6 / (3.80e-6**2 - 1.22e-6**2)
BATTEN = [0.0, -0.0003773524295, -0.0003764429601, 0.08025035339, 0.0, 0.0]
BATTEN_END = {1: -3.7735242953618187e-4, 2: -3.7644296011218467e-4, 4: 1.473889e-11, 5: -5.519668e-12}
FREQUENCY = 314.0


def batten(t, y, sin=sin, cos=cos):
    phi, w3, w4, dphi, dw3, dw4 = y
    s, c = sin(SPEED * t), cos(SPEED * t)
    sin2, cos2 = 2 * s * c, 1 - 2 * s * s
    x1, x2 = RADIUS * s - BEND * sin2, RADIUS * c - 2 * BEND * cos2
    pin, rate = SPEED * SPEED * x2, SPEED * SPEED * (4 * BEND * sin2 - RADIUS * s)
    slip = x1 * phi
    u3, u4 = w3 - LOW * slip, w4 + (1 + LOW) * slip
    g3, g4 = K33 * u3 + K34 * u4, K34 * u3 + K33 * u4
    free = pin - 2 * SPEED * x2 * dphi - rate * phi
    torque = x1 * (HEAVY * free + LOW * g3 - (1 + LOW) * g4) - TURN * phi
    return [dphi, dw3, dw4, torque / (INERTIA + HEAVY * x1 * x1), -g3 / MASS - pin, -g4 / MASS - pin]


def run_batten():
    def error(y):
        return max(hypot(y[w] - BATTEN_END[w], (y[w + 3] - BATTEN_END[w + 3]) / FREQUENCY) for w in (1, 2))

    for method in ("DOP853", "RK45", "LSODA"):
        climb(method, by_scipy(method, lambda t, y: batten(t, y.tolist()), BATTEN, 2.4, [SCALE] * 6), error)
    t, y = ca.SX.sym("t"), ca.SX.sym("y", 6)
    problem = {"t": t, "x": y, "ode": ca.vertcat(*batten(t, ca.vertsplit(y), ca.sin, ca.cos))}
    # The formulae of Adams are faster here than those for stiff motions.
    climb("CVODES", by_casadi("cvodes", problem, {"x0": BATTEN}, 2.4, SCALE, linear_multistep_method="adams"), error)


# The stiff motions, as in `stiff.rs`: rates, their slopes, start, end, exact end, scales.
OSCILLATOR = (
    lambda x, v: [v, ((1 - x * x) * v - x) * 1e6],
    lambda x, v: [[0.0, 1.0], [(-2 * x * v - 1) * 1e6, (1 - x * x) * 1e6]],
    *([2.0, 0.0], 2.0, {0: 1.706167732170483, 1: -0.8928097010247975}, [1.0, 1.0]),
)
KINETICS = (
    lambda a, b, c: [-0.04 * a + 1e4 * b * c, 0.04 * a - 1e4 * b * c - 3e7 * b * b, 3e7 * b * b],
    lambda a, b, c: [[-0.04, 1e4 * c, 1e4 * b], [0.04, -1e4 * c - 6e7 * b, -1e4 * b], [0.0, 6e7 * b, 0.0]],
    *([1.0, 0.0, 0.0], 1e11, {0: 2.083340149701255e-8, 1: 8.333360770334713e-14, 2: 0.999999979166505}, [1e-8, 1e-14, 1.0]),
)


def run_stiff(rates, slopes, start, end, exact, scales):
    more = {"first_step": 1e-6, "jac": lambda t, y: slopes(*y.tolist())}
    for method in ("Radau", "BDF", "LSODA"):
        climb(method, by_scipy(method, lambda t, y: rates(*y.tolist()), start, end, scales, **more), relative(exact))
    y = ca.SX.sym("y", len(start))
    problem = {"x": y, "ode": ca.vertcat(*rates(*ca.vertsplit(y)))}
    # Its absolute tolerance is one for all states.
    climb("CVODES", by_casadi("cvodes", problem, {"x0": start}, end, min(scales)), relative(exact))


# Andrews' squeezing mechanism, as in `andrews.eqn`: angles be, Th, ga, Ph, de, Om, ep, then their speeds. EA and FA reach from
# the joints H and G to the centres of mass.
RR, D, DA, SS, SC, SD, ZT, E, U, ZF, EA, FA = 0.007, 0.028, 0.0115, 0.035, 0.018, 0.02, 0.04, 0.02, 0.04, 0.02, 0.00579, 0.00579
M2, M4, M6, I2, I4, I6 = 0.00365, 0.00706, 0.00706, 4.410e-7, 5.667e-7, 5.667e-7
M11 = 0.04325 * 0.00092**2 + 2.194e-6 + M2 * (RR**2 + DA**2) + I2
M33 = 0.02373 * (0.01874**2 + 0.01043**2) + 5.255e-6
M55 = M4 * (ZT**2 + EA**2) + I4 + 0.07050 * (0.02308**2 + 0.00916**2) + 1.169e-5
M77 = M6 * (U**2 + FA**2) + I6 + 0.05498 * (0.01228**2 + 0.00449**2) + 1.912e-5
SQUEEZER = [-0.0617138900142764, 0.0, 0.455279819163070, 0.222668390165886, 0.487364979543843, -0.222668390165886]
SQUEEZER += [1.23054744454982] + [0.0] * 7
SQUEEZER_END = {0: 15.8107711951537, 7: 1139.92030225911}
# Where numbers stand on and below the diagonal of the matrix of accelerations and forces in the joints; in all of it.
ROWS = [0, 1, 1, 2, 3, 4, 4, 5, 6, 6, *[7] * 3, *[8] * 3, *[9] * 4, *[10] * 4, *[11] * 4, *[12] * 4]
COLUMNS = [0, 0, 1, 2, 3, 3, 4, 5, 5, 6, *[0, 1, 2] * 2, *[0, 1, 3, 4] * 2, *[0, 1, 5, 6] * 2]
BOTH = np.array([13 * row + column for row, column in zip(ROWS + COLUMNS, COLUMNS + ROWS)])


def squeezer(y, sin=sin, cos=cos, sqrt=sqrt):
    """Numbers of the matrix, and the right side."""
    be, th, ga, ph, de, om, ep, vbe, vth, vga, vph, vde, vom, vep = y
    (s1, c1), (sth, cth), (s2, c2), (s3, c3) = ((sin(a), cos(a)) for a in (be, th, be + th, ga))
    (sph, cph), (s4, c4), (s5, c5) = ((sin(a), cos(a)) for a in (ph, ph + de, de))
    (som, com), (s6, c6), (s7, c7) = ((sin(a), cos(a)) for a in (om, om + ep, ep))
    m12, m45, m67 = M2 * DA * RR * cth, M4 * ZT * EA * sph, M6 * U * FA * som
    k2, k4, k6 = M2 * DA * RR * sth, M4 * ZT * EA * cph, M6 * U * FA * com
    x, y = SD * c3 + SC * s3 - 0.03635 - 0.014, SD * s3 - SC * c3 + 0.03273 - 0.072
    length = sqrt(x * x + y * y)
    pull = 4530.0 * (0.07785 - length) / length * (x * (SC * c3 - SD * s3) + y * (SD * c3 + SC * s3))
    p, q, r, s = D * s2 - RR * s1, RR * c1 - D * c2, D * s2, -D * c2
    e4, f4, e6, f6 = -E * c4, -E * s4, ZF * s6, -ZF * c6
    numbers = [M11 - 2 * m12, M2 * DA * DA + I2 - m12, M2 * DA * DA + I2, M33]
    numbers += [M4 * EA * EA + I4, M4 * EA * EA + I4 + m45, M55 + 2 * m45]
    numbers += [M6 * FA * FA + I6, M6 * FA * FA + I6 - m67, M77 - 2 * m67]
    numbers += [p, r, -SS * c3, q, s, -SS * s3, p, r, e4, e4 + ZT * s5, q, s, f4, f4 - ZT * c5]
    numbers += [p, r, e6, e6 - U * c7, q, s, f6, f6 - U * s7]
    w1, w2, w3, w4, w5, w6, w7 = (v * v for v in (vbe, vbe + vth, vga, vph + vde, vde, vom + vep, vep))
    x, y = RR * c1 * w1 - D * c2 * w2, RR * s1 * w1 - D * s2 * w2
    right = [0.033 - k2 * vth * (vth + 2 * vbe), k2 * w1, pull, k4 * w5, -k4 * vph * (vph + 2 * vde)]
    right += [-k6 * w7, k6 * vom * (vom + 2 * vep), x - SS * s3 * w3, y + SS * c3 * w3]
    right += [x - E * s4 * w4 - ZT * c5 * w5, y + E * c4 * w4 - ZT * s5 * w5]
    return numbers, right + [x - ZF * c6 * w6 - U * s7 * w7, y - ZF * s6 * w6 + U * c7 * w7]


def solved(y):
    """Accelerations and forces; LAPACK is called itself, as `numpy.linalg.solve` takes twice the time here."""
    numbers, right = squeezer(y)
    matrix = np.zeros(169)
    matrix[BOTH] = numbers + numbers
    return dgesv(matrix.reshape(13, 13, order="F"), right, overwrite_a=True)[2].tolist()


def run_squeezer():
    def rates(t, y):
        y = y.tolist()
        return y[7:] + solved(y)[:7]

    for method in ("DOP853", "LSODA"):
        climb(method, by_scipy(method, rates, SQUEEZER, 0.03, [SCALE] * 14), relative(SQUEEZER_END))
    # Accelerations and forces by magnitudes of theirs: IDAS finds no step at small tolerances else.
    units = np.repeat([1e6, 1e3], [7, 6])
    x, z = ca.SX.sym("x", 14), ca.SX.sym("z", 13)
    numbers, right = squeezer(ca.vertsplit(x), ca.sin, ca.cos, ca.sqrt)
    matrix = ca.SX(13, 13)
    for row, column, number in zip(ROWS, COLUMNS, numbers):
        matrix[row, column] = matrix[column, row] = number
    problem = {"x": x, "z": z, "ode": ca.vertcat(x[7:], 1e6 * z[:7]), "alg": matrix @ (units * z) - ca.vertcat(*right)}
    start, first = {"x0": SQUEEZER, "z0": solved(SQUEEZER) / units}, SQUEEZER[7:] + solved(SQUEEZER)[:7]
    more = {"newton_scheme": "direct", "suppress_algebraic": True, "calc_ic": False, "init_xdot": first}
    climb("IDAS", by_casadi("idas", problem, start, 0.03, SCALE, **more), relative(SQUEEZER_END))


# The six-bar, as in `linkage.rs`: L1, L2, L3, L4, eta, X_C, Y_C, L6, L7, X_3, Y_3, phi0.
SIX_BAR = [0.008, 0.06, 0.05, 0.07, 0.9, 0.04, 0.03, 0.06, 0.036, 0.036, 0.096, 0.6]
HALF_WIDTHS = np.array([*[5e-5] * 4, radians(0.1), *[5e-5] * 6, radians(0.1)])
GUESSES = [radians(angle) for angle in (5.6, -63.0, 133.0, -158.0)]
PLACES, SAMPLES = 360, 10_000
STEP = 2 * pi / PLACES
PHIS = [STEP * place for place in range(PLACES)]


def dyad(a, b, mode, x, y, sqrt):
    """The first of two links with `first - second = (x, y)`."""
    square = x * x + y * y
    across = mode * sqrt(((a + b) ** 2 - square) * (square - (a - b) ** 2)) * (0.5 / square)
    along = 0.5 + (a + b) * (a - b) * (0.5 / square)
    return along * x - across * y, along * y + across * x


def outputs(p, places, sin, cos, sqrt):
    """The arm L7 as a vector, at so many places of a revolution, in closed form."""
    l1, l2, l3, l4, eta, xc, yc, l6, l7, x3, y3, phi0 = p
    x2, y2, s0, c0, xc, yc = l4 * cos(eta), l4 * sin(eta), sin(phi0), cos(phi0), xc / l2, yc / l2
    for place in range(places):
        s, c = math.sin(2 * pi * place / places), math.cos(2 * pi * place / places)
        x, y = l1 * (c * c0 - s * s0), l1 * (c * s0 + s * c0)
        u, v = dyad(l2, l3, -1, x2 - x, y2 - y, sqrt)
        x, y = x3 - x - xc * u + yc * v, y3 - y - xc * v - yc * u
        u, v = dyad(l6, l7, 1, x, y, sqrt)
        yield u - x, v - y


def residual(angles, p, phi, sin=sin, cos=cos):
    l1, l2, l3, l4, eta, xc, yc, l6, l7, x3, y3, phi0 = p
    (c1, s1), (c2, s2), (c3, s3) = ((cos(a), sin(a)) for a in (phi + phi0, angles[0], angles[1]))
    (c4, s4), (c6, s6), (c7, s7) = ((cos(a), sin(a)) for a in (eta, angles[2], angles[3]))
    x, y = l1 * c1 + xc * c2 - yc * s2 + l6 * c6, l1 * s1 + xc * s2 + yc * c2 + l6 * s6
    four_bar = [l1 * c1 + l2 * c2 - l4 * c4 - l3 * c3, l1 * s1 + l2 * s2 - l4 * s4 - l3 * s3]
    return [*four_bar, x - x3 - l7 * c7, y - y3 - l7 * s7]


def slopes(angles, p):
    """Slopes of the residual by the angles."""
    (c2, s2), (c3, s3), (c6, s6), (c7, s7) = ((cos(a), sin(a)) for a in angles)
    _, l2, l3, _, _, xc, yc, l6, l7, _, _, _ = p
    four_bar = [[-l2 * s2, l3 * s3, 0.0, 0.0], [l2 * c2, -l3 * c3, 0.0, 0.0]]
    return [*four_bar, [-xc * s2 - yc * c2, 0.0, -l6 * s6, l7 * s7], [xc * c2 - yc * s2, 0.0, l6 * c6, -l7 * c7]]


def influence(angles, p, phi):
    """How the output follows all variables."""
    l1, _, _, l4, eta, _, _, _, _, _, _, phi0 = p
    (c1, s1), (c2, s2), (c3, s3) = ((cos(a), sin(a)) for a in (phi + phi0, angles[0], angles[1]))
    (c4, s4), (c6, s6), (c7, s7) = ((cos(a), sin(a)) for a in (eta, angles[2], angles[3]))
    a, b, c, d = dgesv(np.array(slopes(angles, p)).T, [0.0, 0.0, 0.0, -1.0])[2].tolist()
    turn = l1 * ((b + d) * c1 - (a + c) * s1)
    four_bar = [(a + c) * c1 + (b + d) * s1, a * c2 + b * s2, -a * c3 - b * s3, -a * c4 - b * s4, l4 * (a * s4 - b * c4)]
    return [*four_bar, c * c2 + d * s2, d * c2 - c * s2, c * c6 + d * s6, -c * c7 - d * s7, -c, -d, turn, turn]


def by_fsolve():
    """Output and coefficients of all places, and the number of evaluations."""
    angles, found, evaluations = GUESSES, [], 0
    for phi in PHIS:
        more = {"fprime": lambda y: slopes(y.tolist(), SIX_BAR), "xtol": 1e-12, "full_output": True}
        y, told, _, _ = fsolve(lambda y: residual(y.tolist(), SIX_BAR, phi), angles, **more)
        angles, evaluations = y.tolist(), evaluations + told["nfev"]
        found.append([angles[3], *influence(angles, SIX_BAR, phi)])
    return found, evaluations


def by_loops(matrix, right):
    """Solves for the angles of the first loop, then for those of the second."""
    first = ca.inv_minor(matrix[:2, :2]) @ right[:2]
    return ca.vertcat(first, ca.inv_minor(matrix[2:, 2:]) @ (right[2:] - matrix[2:, :2] @ first))


def revolution():
    """A revolution as a function, and the state before it: angles and their rates at a place and at that before.

    Angles are extrapolated from both places so well that one iteration is enough; the error told shows it.
    """
    state, angles, p, phi = ca.SX.sym("state", 16), ca.SX.sym("angles", 4), ca.SX.sym("p", 12), ca.SX.sym("phi")
    f = ca.vertcat(*residual(ca.vertsplit(angles), ca.vertsplit(p), phi, ca.sin, ca.cos))
    slopes = [ca.jacobian(f, angles), ca.jacobian(f, ca.vertcat(p, phi))]
    loops = ca.Function("loops", [angles, p, phi], [f, *slopes])
    now, rate, before, rate_before = ca.vertsplit(state, 4)
    guess = 5 * before - 4 * now + STEP * (4 * rate + 2 * rate_before)
    f, matrix, _ = loops(guess, p, phi)
    found = guess - by_loops(matrix, f)
    _, matrix, by_all = loops(found, p, phi)
    # The loops of the transposed matrix come in the other order.
    left = by_loops(matrix.T[::-1, ::-1], ca.DM([-1, 0, 0, 0]))[::-1]
    after = ca.vertcat(found, -by_loops(matrix, by_all[:, 12]), now, rate)
    place = ca.Function("place", [state, phi, p], [after, ca.vertcat(found[3], by_all.T @ left)])
    state, phis, p = ca.MX.sym("state", 16), ca.MX.sym("phis", 1, PLACES), ca.MX.sym("p", 12)
    states, all_found = place.mapaccum(PLACES)(state, phis, ca.repmat(p, 1, PLACES))
    whole = ca.Function("whole", [state, phis, p], [states[:, -1], all_found])
    found = ca.DM(GUESSES)
    for _ in range(8):
        start = ca.vertcat(found, ca.DM.zeros(4), found, ca.DM.zeros(4))
        found = place(start, 0.0, SIX_BAR)[0][:4]
    return whole, whole(start, PHIS, SIX_BAR)[0].full().ravel()


def compiled(code):
    """The same in C, in a list; nothing where there is no compiler."""
    if shutil.which("gcc") is None:
        print("CasADi C: there is no gcc", file=sys.stderr)
        return []
    with tempfile.TemporaryDirectory() as folder:
        generator = ca.CodeGenerator(code.name())
        generator.add(code)
        generator.generate(f"{folder}/")
        name = f"{folder}/{code.name()}"
        subprocess.run(["gcc", "-O3", "-march=native", "-shared", "-fPIC", f"{name}.c", "-o", f"{name}.so"], check=True)
        return [ca.external(code.name(), f"{name}.so")]


def bound(code, *inputs):
    """A call with these very arrays, which gives the last output."""
    buffer, call = code.buffer()
    results = [np.zeros((code.size2_out(k), code.size1_out(k))) for k in range(code.n_out())]
    for k, array in enumerate(inputs):
        buffer.set_arg(k, memoryview(array))
    for k, array in enumerate(results):
        buffer.set_res(k, memoryview(array))
    # The list keeps alive what the call itself does not.
    return lambda: [call(), buffer, inputs, results[-1]][-1]


def run_six_bar():
    exact = [math.atan2(v, u) for u, v in outputs(SIX_BAR, PLACES, sin, cos, sqrt)]

    def said(method, iterations, found, seconds):
        wrong = max(abs(math.remainder(row[0] - psi, 2 * pi)) for row, psi in zip(found, exact))
        tell(method, 1e-12, iterations, wrong, seconds / PLACES)

    whole, start = revolution()
    for method, code in [*(("CasADi C", code) for code in compiled(whole)), ("CasADi", whole)]:
        said(method, PLACES, *timed(bound(code, start, np.array(PHIS), np.array(SIX_BAR))))
    (found, evaluations), seconds = timed(by_fsolve)
    said("fsolve", evaluations, found, seconds)


def run_random():
    """Errors are angles from the nominal output to that of what is made, so that none is wrong by a turn."""
    nominal = list(outputs(SIX_BAR, 36, sin, cos, sqrt))

    def errors(made, atan2):
        return [atan2(v * a - u * b, u * a + v * b) for (u, v), (a, b) in zip(made, nominal)]

    def drawn():
        return SIX_BAR + np.random.default_rng(1).uniform(-HALF_WIDTHS, HALF_WIDTHS, (SAMPLES, 12))

    def by_numpy():
        made = outputs(np.ascontiguousarray(drawn().T), 36, np.sin, np.cos, np.sqrt)
        return [error.std() for error in errors(made, np.arctan2)]

    def by_code():
        numbers[:] = drawn()
        return call().std(axis=0)

    p, numbers = ca.SX.sym("p", 12), np.zeros((SAMPLES, 12))
    made = outputs(ca.vertsplit(p), 36, ca.sin, ca.cos, ca.sqrt)
    one, runs = ca.Function("one", [p], [ca.vertcat(*errors(made, ca.atan2))]), [("numpy", by_numpy)]
    for code in compiled(one.map(SAMPLES)):
        call = bound(code, numbers)
        runs.append(("CasADi C", by_code))
    for method, run in runs:
        deviations, seconds = timed(run)
        tell(method, 1e-12, 0, float(deviations[0]), seconds)


WORKLOADS = {"batten": run_batten, "squeezer": run_squeezer, "six-bar": run_six_bar, "six-bar-random": run_random}
WORKLOADS |= {"van-der-pol": lambda: run_stiff(*OSCILLATOR), "robertson": lambda: run_stiff(*KINETICS)}


def main():
    if len(sys.argv) != 2 or sys.argv[1] not in WORKLOADS:
        sys.exit(f"usage: python3 peers.py {' | '.join(WORKLOADS)}")
    WORKLOADS[sys.argv[1]]()


if __name__ == "__main__":
    main()
