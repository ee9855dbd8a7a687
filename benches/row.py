#!/usr/bin/env python3
"""Forty windows in a row by Exudyn and by IDAS of CasADi, beside `assur-benches row`.

`pip install exudyn casadi`, then `python3 row.py`. Both are given settings that come through the flat positions, found by
trial; those of IDAS (Baumgarte's alpha, regularisation of the forces by epsilon) knowing the exact motion. Each line: settings, error
of the first crank's angle after 10 s in rad, seconds of the solution alone on one thread.
"""
import os

os.environ["OMP_NUM_THREADS"] = "1"
import time
from math import pi

import casadi as ca
import exudyn as exu
import numpy as np
from exudyn.utilities import *

N, END, G = 40, 10.0, 9.81
EXACT = -30.0266374171908


def timed(solve):
    start = time.perf_counter()
    try:
        angle = solve()
    except Exception as error:
        lines = [line for line in str(error).splitlines() if line.strip()]
        return f"fails: {lines[-1][:90] if lines else error}"
    return f"{angle - EXACT:+.1e} rad {time.perf_counter() - start:7.2f} s"


def bodies():
    """Rods with three coordinates each and a pin at every joint."""
    mbs = exu.SystemContainer().AddSystem()
    ground = mbs.AddObject(ObjectGround())

    def rod(place, speed):
        node = mbs.AddNode(NodeRigidBody2D(referenceCoordinates=place, initialVelocities=speed))
        body = mbs.AddObject(ObjectRigidBody2D(mass=1.0, inertia=1 / 12, nodeNumber=node))
        marker = mbs.AddMarker(MarkerBodyMass(bodyNumber=body))
        mbs.AddLoad(LoadMassProportional(markerNumber=marker, loadVector=[0, -G, 0]))
        return node, body

    def pin(*ends):
        markers = [mbs.AddMarker(MarkerBodyPosition(bodyNumber=body, localPosition=place)) for body, place in ends]
        mbs.AddObject(ObjectJointRevolute2D(markerNumbers=markers))

    first = before = None
    for k in range(N + 1):
        if before is not None:
            _, coupler = rod([k - 0.5, 1, 0], [1, 0, 0])
            pin((before, [0.5, 0, 0]), (coupler, [-0.5, 0, 0]))
        node, crank = rod([k, 0.5, pi / 2], [0.5, 0, -1])
        pin((ground, [k, 0, 0]), (crank, [-0.5, 0, 0]))
        if before is None:
            first = node
        else:
            pin((coupler, [0.5, 0, 0]), (crank, [0.5, 0, 0]))
        before = crank
    mbs.Assemble()
    return mbs, first


def exudyn(step, relative, adaptive):
    mbs, first = bodies()
    settings = exu.SimulationSettings()
    settings.parallel.numberOfThreads = 1
    settings.solution.file.write = False
    settings.solution.sensors.writePeriod = END
    settings.linearSolver.solverType = exu.LinearSolverType.EigenSparse
    run = settings.timeIntegration
    run.endTime, run.numberOfSteps, run.adaptiveStep = END, round(END / step), adaptive
    run.verboseMode = 0
    run.newton.useModifiedNewton = True
    run.newton.relativeTolerance, run.newton.absoluteTolerance = relative, relative * 1e-2
    run.generalizedAlpha.spectralRadius = 0.9
    run.generalizedAlpha.useIndex2Constraints = False

    def solve():
        mbs.SolveDynamic(settings, solverType=exu.DynamicSolverType.GeneralizedAlpha)
        return pi / 2 + mbs.GetNodeOutput(first, exu.OutputVariableType.Coordinates)[2]

    return timed(solve)


def idas(tolerance, alpha, epsilon):
    """Angles `th_0, ph_1, th_1, …`, closures differentiated twice."""
    n = 2 * N + 1
    q, w, a, force = (ca.SX.sym(name, size) for name, size in zip("qwaf", (n, n, n, 2 * N)))
    closures, kinetic, potential = [], 0, 0
    for k in range(N + 1):
        kinetic += w[2 * k] ** 2 / 6
        potential += G * ca.sin(q[2 * k]) / 2
        if k > 0:
            th, ph, own = q[2 * k - 2], q[2 * k - 1], q[2 * k]
            closures += [ca.cos(th) + ca.cos(ph) - 1 - ca.cos(own), ca.sin(th) + ca.sin(ph) - ca.sin(own)]
            x = -w[2 * k - 2] * ca.sin(th) - w[2 * k - 1] * ca.sin(ph) / 2
            y = w[2 * k - 2] * ca.cos(th) + w[2 * k - 1] * ca.cos(ph) / 2
            kinetic += (x**2 + y**2) / 2 + w[2 * k - 1] ** 2 / 24
            potential += G * (ca.sin(th) + ca.sin(ph) / 2)
    closures = ca.vertcat(*closures)
    momentum = ca.gradient(kinetic, w)
    forces = ca.gradient(potential - kinetic, q) - ca.jtimes(closures, q, force, True)
    motion = ca.jtimes(momentum, w, a) + ca.jtimes(momentum, q, w) + forces
    rate = ca.jtimes(closures, q, w)
    second = ca.jtimes(closures, q, a) + ca.jtimes(rate, q, w)
    held = second + 2 * alpha * rate + alpha**2 * closures + epsilon * force
    state, given = ca.vertcat(q, w), ca.vertcat(a, force)
    rates, equations = ca.vertcat(w, a), ca.vertcat(motion, held)
    start = np.zeros(2 * n)
    start[0:n:2], start[n::2] = pi / 2, -1
    slopes, rest = ca.Function("slopes", [state, given], [ca.jacobian(equations, given), equations])(start, ca.DM.zeros(n + 2 * N))
    begin = -np.linalg.lstsq(np.array(slopes.full()), np.array(rest.full()).ravel(), rcond=None)[0]
    options = {
        "reltol": tolerance, "abstol": tolerance, "linear_solver": "csparse", "newton_scheme": "direct",
        "max_num_steps": 20_000, "suppress_algebraic": True, "calc_ic": False,
        "init_xdot": list(np.array(ca.Function("rates", [state, given], [rates])(start, begin).full()).ravel()),
        "show_eval_warnings": False,
    }
    problem = {"x": state, "z": given, "ode": rates, "alg": equations}
    run = ca.integrator("run", "idas", problem, 0.0, [END], options)
    return timed(lambda: float(run(x0=start, z0=begin)["xf"][0]))


if __name__ == "__main__":
    for step, relative, adaptive in [(1.6e-3, 1e-8, False), (9e-4, 1e-8, False), (1.5e-4, 1e-8, True), (2e-4, 1e-8, False)]:
        print(f"Exudyn {exu.__version__}, step {step:.1e} s{', adaptive' if adaptive else ''}: {exudyn(step, relative, adaptive)}", flush=True)
    for tolerance, alpha, epsilon in [(5e-7, 1e3, 1e-12), (2e-10, 1e3, 1e-12), (1e-8, 1e3, 1e-12), (1e-6, 0.0, 0.0), (1e-8, 0.0, 0.0)]:
        what = f"CasADi {ca.__version__}, IDAS, tolerance {tolerance:.0e}, alpha {alpha:.0e}, epsilon {epsilon:.0e}"
        print(f"{what}: {idas(tolerance, alpha, epsilon)}", flush=True)
