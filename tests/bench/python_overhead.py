#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""What Python costs on top of the library: a whole run, and one step.

usage: TRUCKRIDE_LIBRARY=libtruckride.so.0 PYTHONPATH=bindings/python python_overhead.py [CC]

A C program with the same calls is compiled and timed in turn with it: processor time, the least of several runs.
"""
import os
import pathlib
import subprocess
import sys
import tempfile
import time

import truckride as tr

PAIRS, REPEATS, STEPS, DURATION = 5, 3, 20000, 480.0
SOURCE = r"""
#include <stdio.h>
#include <time.h>
#include <truckride/truckride.h>
static double now(void)
{ struct timespec t; clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &t); return (double)t.tv_sec + 1e-9 * (double)t.tv_nsec; }
int main(void)
{
    trk_context *c; trk_spec *s; trk_model *m; trk_signal *w; trk_excitation *e; trk_series *r; trk_newmark *n;
    trk_simulate_options o; double values[64], best_run = 1e9, best_step = 1e9, height[4] = {0}, rate[4] = {0};
    trk_simulate_options_init(&o, sizeof o); o.duration = DURATION;
    if (trk_context_create(NULL, NULL, &c) ||
        trk_vehicle_create_builtin(c, TRK_VEHICLE_REFERENCE_TRUCK, TRK_VARIANT_THESIS_DAMPERS, &s) ||
        trk_model_compile(c, s, NULL, &m) || trk_signal_create_sweep(c, NULL, &w) ||
        trk_excitation_create(c, m, &e) || trk_excitation_add_motion(e, TRK_ROAD_ALL, w, 1, 0) ||
        trk_newmark_create(c, m, NULL, &n)) return 1;
    for (int k = 0; k < REPEATS; k++) {
        double t = now();
        if (trk_simulate(c, m, e, NULL, &o, NULL, NULL, &r)) return 1;
        t = now() - t; best_run = t < best_run ? t : best_run;
        trk_series_destroy(r);
        t = now();
        for (int i = 0; i < STEPS; i++) {
            height[0] = 1e-6 * i;
            if (trk_newmark_step(n, height, rate, NULL)) return 1;
            trk_newmark_read_sensors(n, values);
        }
        t = (now() - t) / STEPS; best_step = t < best_step ? t : best_step;
        if (trk_newmark_set_state(n, 0, NULL, NULL, NULL, NULL, NULL)) return 1;
    }
    printf("%.9g %.9g\n", best_run, best_step);
    return 0;
}
"""


def in_c(compiler):
    library = pathlib.Path(os.path.realpath(tr.library_path))
    include = pathlib.Path(__file__).resolve().parents[2] / "include"
    with tempfile.TemporaryDirectory() as folder:
        source, program = pathlib.Path(folder, "bench.c"), pathlib.Path(folder, "bench")
        source.write_text(SOURCE)
        subprocess.run([compiler, "-O2", "-std=gnu11", f"-DREPEATS={REPEATS}", f"-DSTEPS={STEPS}",
                        f"-DDURATION={DURATION}", f"-I{include}", str(source), "-o", str(program),
                        str(library), f"-Wl,-rpath,{library.parent}"], check=True)
        output = subprocess.run([str(program)], check=True, capture_output=True, text=True).stdout
    return map(float, output.split())


def in_python():
    model = tr.vehicle("reference_truck", "thesis_dampers").compile()
    excitation, stepper = tr.Excitation(model, tr.sweep()), tr.Newmark(model)
    height, step, read = stepper.height, stepper.step, stepper.read
    run, one = [], []
    for _ in range(REPEATS):
        started = time.process_time()
        tr.simulate(model, excitation, DURATION)
        run.append(time.process_time() - started)
        started = time.process_time()
        for k in range(STEPS):
            height[0] = 1e-6 * k
            step()
            read()
        one.append((time.process_time() - started) / STEPS)
        stepper.set_state()
    return min(run), min(one)


def main(compiler="cc"):
    pairs = [(*in_c(compiler), *in_python()) for _ in range(PAIRS)]
    run_c, step_c, run, one = (min(column) for column in zip(*pairs))
    print(f"{DURATION:.0f} s run: C {run_c:.4f} s, Python {run:.4f} s, ratio {run / run_c:.3f} "
          "(limit 1.05)")
    print(f"one step with reading the sensors: C {1e6 * step_c:.2f} us, Python {1e6 * one:.2f} us, "
          f"overhead {1e6 * (one - step_c):.2f} us (limit 2)")
    return 0 if run <= 1.05 * run_c and one - step_c <= 2e-6 else 1


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:]))
