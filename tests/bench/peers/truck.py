# SPDX-License-Identifier: MIT
"""truck.py FILE: SciPy's solve_ivp on the truck of the benchmark. Prints a line
"name;seconds;error" for each method, at the loosest tolerance that meets the target."""
import json
import sys
import time

import numpy as np
from scipy.integrate import solve_ivp
from scipy.interpolate import PPoly

with open(sys.argv[1]) as file:
    p = json.load(file)
n, wanted = p["n"], np.array(p["q"])
inverse = np.linalg.inv(np.array(p["mass"]))
linear = -inverse @ np.hstack([np.array(p["stiffness"]), np.array(p["damping"])])
of_road = inverse @ np.hstack([np.array(p["of_height"]), np.array(p["of_rate"])])
rows = np.array(p["rows"])
of_force = -inverse @ rows.T
tables = [PPoly(np.array(t["pieces"]).T, np.array(t["breaks"])) for t in p["tables"]]
times = p["sample"] * np.arange(len(wanted))


def road(t):
    ratio = np.exp(p["growth"] * t)
    f = p["frequency"] * ratio
    phase = 2 * np.pi * p["frequency"] / p["growth"] * (ratio - 1)
    a = p["amplitude"] / f
    return np.array([a * np.sin(phase),
                     a * (2 * np.pi * f * np.cos(phase) - p["growth"] * np.sin(phase))])


def right_side(t, y):
    rate = rows @ y[n:]
    force = np.array([float(table(x)) for table, x in zip(tables, rate)])
    return np.concatenate([y[n:], linear @ y + of_road @ road(t) + of_force @ force])


def error(q):
    return np.max(np.max(np.abs(q - wanted), axis=0) / np.max(np.abs(wanted), axis=0))


for method in "RK45", "DOP853", "LSODA":
    for rtol in 1e-2, 1e-3, 1e-4, 1e-5, 1e-6, 1e-7:
        start = time.process_time()
        run = solve_ivp(right_side, (0, times[-1]), np.zeros(2 * n), method=method,
                        t_eval=times, rtol=rtol, atol=1e-3 * rtol)
        seconds = time.process_time() - start
        if run.success and error(run.y[:n].T) <= p["target"]:
            print(f"{method} rtol {rtol:.0e};{seconds:.6g};{error(run.y[:n].T):.6g}")
            break
