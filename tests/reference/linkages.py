#!/usr/bin/env python3
"""Independent reference for the linkages: positions, velocity ratios and influence coefficients.

    python3 tests/reference/linkages.py > tests/reference/linkages.json

Positions of dyads by the meeting of circles, of the heald linkage by mpmath's Newton on its three equations; derivatives
by differences of positions at 60 digits. Nothing is shared with the equations of the project but the dimensions.
Needs mpmath. Lengths in mm, angles in degrees, derivatives in degrees or mm per unit of the variable (degree or mm).
"""
import mpmath as mp
import rows

mp.mp.dps = 60
RAD = mp.pi / 180


def circ(p, r, q, big_r, side):
    """The point at distance r from p and R from q on the side of the line from p to q that `side` says."""
    dx, dy = q[0] - p[0], q[1] - p[1]
    d = mp.hypot(dx, dy)
    a = (d * d + r * r - big_r * big_r) / (2 * d)
    h = mp.sqrt(r * r - a * a)
    return (p[0] + (a * dx - side * h * dy) / d, p[1] + (a * dy + side * h * dx) / d)


def at(p, length, angle):
    return (p[0] + length * mp.cos(angle * RAD), p[1] + length * mp.sin(angle * RAD))


def angle(p, q):
    return mp.atan2(q[1] - p[1], q[0] - p[0]) / RAD


def near(value, turn):
    """The same angle within half a turn of another."""
    return value - 360 * mp.nint((value - turn) / 360)


def heald(kappa):
    def positions(v):
        def loops(phi5, phi6, phi7):
            c, s = mp.cos, mp.sin
            g = kappa * v["l7"]
            return [
                v["l4"] * c(v["phi4"] * RAD) + v["l5"] * c(phi5) - v["l6"] * c(phi6) - g * c(phi7) - v["b"],
                v["l4"] * s(v["phi4"] * RAD) + v["l5"] * s(phi5) - v["l6"] * s(phi6) - g * s(phi7) - v["a"],
                v["l6"] * c(phi6) - v["s"] - v["l7"] * c(phi7),
            ]

        start = (9.5, 63.3, -70.1) if kappa == 1 else (50.9, 40.7, -36.4)
        # The start holds at 90 degrees: go from there in steps.
        found, here, end = [one * RAD for one in start], mp.mpf(90), v["phi4"]
        for step in range(1, 9):
            v = dict(v, phi4=here + (end - here) * step / 8)
            found = list(mp.findroot(loops, found))
        return {name: value / RAD for name, value in zip(("phi5", "phi6", "phi7"), found)}

    values = dict(l4=90, l5=230, l6=180, l7=120, a=80, b=105, s=40, phi4=90)
    return positions, values, "phi4", [60, 75.5, 90, 101.25, 120] if kappa == 1 else [75, 90, 101.25, 120]


def crank_rocker():
    def positions(v):
        b = at((0, 0), v["l1"], v["beta"])
        e = circ(b, v["l2"], (v["a_w"], 0), v["l3"], 1)
        return {"chi": near(180 - angle((v["a_w"], 0), e), 60), "gamma2": angle(b, e)}

    return positions, dict(l1=25, l2=90, l3=60, a_w=100, beta=0), "beta", [0, 37.5, 90, 180, 271]


def rack(arrangement):
    below = arrangement == "antiparallelogram"

    def positions(v):
        a = at((0, 0), v["L_a"], v["alpha"])
        c = at((v["O_vx"], v["O_vy"]), v["L_c"], 180)
        arm = mp.hypot(v["b_x"], v["b_y"])
        b = circ(a, arm, c, v["L_d"], -1 if below else 1)
        turn = angle(a, b) - angle((0, 0), (v["b_x"], v["b_y"]))
        c_, s_ = mp.cos(turn * RAD), mp.sin(turn * RAD)
        q = (a[0] + c_ * v["q_x"] - s_ * v["q_y"], a[1] + s_ * v["q_x"] + c_ * v["q_y"])
        return {"tooth.x": q[0], "tooth.y": q[1], "gamma": turn, "delta": angle(b, c)}

    values = dict(L_a=32, L_c=28, L_d=24, b_x=84, b_y=-24, q_x=36, q_y=5, O_vx=112, O_vy=32 if below else -16, alpha=90)
    return positions, values, "alpha", [86, 88.25, 90, 93.5]


def lift():
    def positions(v):
        shaft, pivot = (v["O1_x"], v["O1_y"]), (v["O_vx"], v["O_vy"])
        e = at(shaft, v["e_v"], v["phi"] + 90)
        d = circ(e, v["l_v"], pivot, v["r_D"], 1)
        return {"beta": near(angle(pivot, d), 180), "epsilon": angle(e, d)}

    values = dict(O1_x=76, O1_y=-64, O_vx=112, O_vy=32, e_v=6, l_v=90, r_D=36, phi=0)
    return positions, values, "phi", [-180, -60, 0, 60.5, 133]


def stitch():
    def positions(v):
        e = at((v["O1_x"], v["O1_y"]), v["e_h"], v["phi"])
        n = at((v["K0_x"], v["K0_y"]), v["l_n"], 20)
        k = circ(e, v["l_h"], n, v["l_n"], 1)
        m = circ(k, v["l_m"], (0, 0), v["r_M"], 1)
        return {"alpha": angle((0, 0), m) + 180, "kappa": angle(e, k), "lambda": near(angle(n, k), -160)}

    values = dict(O1_x=76, O1_y=-64, K0_x=76, K0_y=-24, e_h=5, l_h=40, l_n=30, l_m=76, r_M=24, phi=0)
    return positions, values, "phi", [-180, -60, 0, 60.5, 133]


def six_bar():
    def positions(v):
        a = at((0, 0), v["L1"], mp.mpf("0.6") / RAD + v["phi"])
        o2 = at((0, 0), v["L4"], mp.mpf("0.9") / RAD)
        b = circ(a, v["L2"], o2, v["L3"], -1)
        theta = angle(a, b)
        c_, s_ = mp.cos(theta * RAD), mp.sin(theta * RAD)
        c = (a[0] + c_ * v["X_C"] - s_ * v["Y_C"], a[1] + s_ * v["X_C"] + c_ * v["Y_C"])
        o3 = (v["X_3"], v["Y_3"])
        d = circ(c, v["L6"], o3, v["L7"], 1)
        return {"Psi": near(angle(o3, d), -158), "theta": theta, "rho": angle(o2, b), "sigma": angle(c, d)}

    values = dict(L1=8, L2=60, L3=50, L4=70, X_C=40, Y_C=30, L6=60, L7=36, X_3=36, Y_3=96, phi=0)
    return positions, values, "phi", [-180, -60, 0, 60.5, 133]


def case(mechanism, scene, model, still=None):
    positions, values, driver, places = model
    values = {name: mp.mpf(value) for name, value in values.items()}
    text = lambda value: mp.nstr(value, 25)
    listed = []
    for place in places:
        here = dict(values, **{driver: mp.mpf(place)})
        step = mp.mpf(10) ** -20
        derivatives = {}
        for name in values:
            above = positions(dict(here, **{name: here[name] + step}))
            below = positions(dict(here, **{name: here[name] - step}))
            derivatives[name] = {key: text((above[key] - below[key]) / (2 * step)) for key in above}
        outputs = {key: text(value) for key, value in positions(here).items()}
        listed.append({"place": place, "outputs": outputs, "derivatives": derivatives})
    return {"mechanism": mechanism, "scene": scene, "driver": driver, "still": still or {}, "places": listed}


if __name__ == "__main__":
    cases = [
        case("heald_linkage", "printed", heald(1)),
        case("heald_linkage", "straight", heald(-1)),
        case("selvedge_linkage", "crank", crank_rocker()),
        case("feed_rack", "straight", rack("antiparallelogram"), {"beta": 180}),
        case("feed_rack", "straight_parallelogram", rack("parallelogram"), {"beta": 180}),
        case("feed_lift", "standard", lift(), {"u": 0}),
        case("feed_stitch", "forward", stitch(), {"nu": 20}),
        case("dwell_six_bar", "standard", six_bar()),
    ]
    print(rows.text(cases))
