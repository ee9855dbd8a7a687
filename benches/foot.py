#!/usr/bin/env python3
"""The presser foot by SciPy's `solve_ivp`, for `assur-benches foot-peers`.

Ten turns from the motion that repeats, restarted at each event: lift-off and landing are terminal events, the instants
at which the rack passes the plate are known. Each phase has its own right-hand side, in plain numbers, which is what
SciPy is fastest with for two states; the step before an event is the first one after it. Times are of the processor, so
that other work on the machine is not counted. One line for each run:
[method, rtol, evaluations, error in m, shortest time in s].
"""
import json
import sys
import time
from math import cos, pi, radians, sin

from scipy.integrate import solve_ivp

M, C1, MU1, F10, C2, C3, MU2, G, OMEGA, RISE = 0.15, 2000.0, 2.0, 40.0, 1e5, 0.0, 30.0, 9.80665, 300.0, 1e-3
HALF = radians(60)
EDGE = cos(HALF)
HEIGHT = RISE / (1 - EDGE)
PERIOD = 2 * pi / OMEGA
START = [8.200937991467597e-5, -0.0639426226661612]
TURNS = 10
FREQUENCY = 816.0
SCALE = 1e-3
# Rounds of a run, seconds after which there is none more, and the time from which on a method goes no further.
ROUNDS, BUDGET, SLOW = 20, 1.5, 1.0
REST = -(F10 / M + G)


def flight(t, y):
    w, v = y
    return v, REST - (C1 * w + MU1 * v) / M


def plate(t, y):
    w, v = y
    return v, ((-C2 - C3 * w * w) * w - MU2 * v - C1 * w - MU1 * v) / M + REST


def rack(t, y):
    w, v = y
    phi = OMEGA * t - pi
    d = HEIGHT * (cos(phi) - EDGE) - w
    return v, ((C2 + C3 * d * d) * d + MU2 * (-HEIGHT * OMEGA * sin(phi) - v) - C1 * w - MU1 * v) / M + REST


def force_on_plate(t, y):
    return (-C2 - C3 * y[0] * y[0]) * y[0] - MU2 * y[1]


def force_on_rack(t, y):
    phi = OMEGA * t - pi
    d = HEIGHT * (cos(phi) - EDGE) - y[0]
    return (C2 + C3 * d * d) * d + MU2 * (-HEIGHT * OMEGA * sin(phi) - y[1])


def touch(t, y):
    """The foot lands where compression and force are both above zero."""
    phi = OMEGA * t - pi
    s = HEIGHT * (cos(phi) - EDGE)
    if s <= 0:
        d, rate = -y[0], -y[1]
    else:
        d, rate = s - y[0], -HEIGHT * OMEGA * sin(phi) - y[1]
    return min(C2 * d, (C2 + C3 * d * d) * d + MU2 * rate)


for guard, direction in ((force_on_plate, -1), (force_on_rack, -1), (touch, 1)):
    guard.terminal, guard.direction = True, direction


def crossing(number):
    """When the rack passes the plate, up and down in turn."""
    return (pi * (2 * (number // 2) + 1) + (-HALF if number % 2 == 0 else HALF)) / OMEGA


def run(method, rtol):
    t, y, end = 0.0, START, TURNS * PERIOD
    flying, passed, evaluations, events, step = True, 0, 0, 0, None
    while t < end:
        stop = end if flying else min(end, crossing(passed))
        rate, guard = (flight, touch) if flying else (rack, force_on_rack) if passed % 2 else (plate, force_on_plate)
        if step is not None:
            step = min(step, stop - t)
        found = solve_ivp(rate, (t, stop), y, method, rtol=rtol, atol=rtol * SCALE, events=guard, first_step=step)
        if not found.success:
            return None
        evaluations += found.nfev
        t, y = found.t[-1], found.y[:, -1]
        steps = found.t[1:] - found.t[:-1]
        step = steps.max()
        if found.status == 1:
            flying = not flying
            while crossing(passed) <= t:
                passed += 1
            events += 1
        elif t == crossing(passed):
            passed += 1
            events += 1
    error = ((y[0] - START[0]) ** 2 + ((y[1] - START[1]) / FREQUENCY) ** 2) ** 0.5
    return evaluations, events, error


def main():
    for method in ("DOP853", "RK45", "LSODA", "Radau"):
        for k in range(5, 14):
            rtol = float(f"1e-{k}")
            shortest, spent = float("inf"), 0.0
            for _ in range(ROUNDS):
                start = time.process_time()
                found = run(method, rtol)
                shortest = min(shortest, time.process_time() - start)
                spent += time.process_time() - start
                if spent > BUDGET or found is None:
                    break
            if found is None or found[1] != 5 * TURNS:
                print(f"{method} at {rtol}: {found}", file=sys.stderr)
                continue
            print(json.dumps([method, rtol, found[0], float(found[2]), shortest]), flush=True)
            if shortest > SLOW:
                break


if __name__ == "__main__":
    main()
