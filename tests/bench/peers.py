#!/usr/bin/python3
"""Peers on the same files: pandas' C parser, numpy's polyfit, scikit-learn's MLPRegressor, SciPy's RBFInterpolator.

    peers.py DRIFTBENCH_CLI RUN1.csv RUN2.csv ...

Leave one run out, mean square on the held-out run less the within-cell floor, x/y/z summed per axis. Prints times
and figures of each peer and of Driftbench on the same files, and the ratios.
"""
import json
import os
import subprocess
import sys
import tempfile
import time
import warnings

import numpy as np
import pandas as pd
from scipy.interpolate import RBFInterpolator
from sklearn.exceptions import ConvergenceWarning
from sklearn.neural_network import MLPRegressor
from sklearn.preprocessing import StandardScaler

warnings.filterwarnings("ignore", category=ConvergenceWarning)
AXES = ["gyro_x_dps", "gyro_y_dps", "gyro_z_dps"]
REFERENCE = np.array([25.0, 5.0, 53.0])


def quantities(delta_t):
    return np.column_stack([delta_t, delta_t**2, np.sign(delta_t) * np.sqrt(np.abs(delta_t))])


def floor(delta_t, tde):
    cells = pd.DataFrame(tde).groupby(np.floor(delta_t / 0.5 + 0.5))
    squares = (cells.count().sub(1) * cells.var()).sum()
    return (squares / cells.count().sub(1).sum()).to_numpy()


def polyfit(train_x, train_y, x):
    return np.column_stack([np.polyval(np.polyfit(train_x, train_y[:, a], 3), x) for a in range(3)])


def mlp(train_x, train_y, x):
    scale = StandardScaler().fit(quantities(train_x))
    out = []
    for a in range(3):
        net = MLPRegressor(hidden_layer_sizes=(10,), activation="tanh", random_state=1)
        net.fit(scale.transform(quantities(train_x)), train_y[:, a])
        out.append(net.predict(scale.transform(quantities(x))))
    return np.column_stack(out)


def interpolator(train_x, train_y, x):
    # Every row is a centre, so all rows are out of its reach: means of 0.5 degree cells, smoothed.
    cells = pd.DataFrame(train_y).groupby(np.floor(train_x / 0.5 + 0.5)).mean()
    scale = StandardScaler().fit(quantities(train_x))
    rbf = RBFInterpolator(scale.transform(quantities(cells.index.to_numpy() * 0.5)), cells.to_numpy(),
                          kernel="gaussian", epsilon=1.0, smoothing=1e-3)
    return rbf(scale.transform(quantities(x)))


def leave_one_out(runs, floors, fit, folds):
    """Seconds for all folds (scaled up where only some are run) and the mean excess over those that were run."""
    excess = np.zeros(3)
    seconds = 0.0
    for held, (x, y) in list(enumerate(runs))[:folds]:
        train_x = np.concatenate([r[0] for i, r in enumerate(runs) if i != held])
        train_y = np.concatenate([r[1] for i, r in enumerate(runs) if i != held])
        start = time.perf_counter()
        prediction = fit(train_x, train_y, x)
        seconds += time.perf_counter() - start
        excess += (((y - prediction) ** 2).mean(axis=0) - floors[held]) / floors[held] / folds
    return seconds * len(runs) / folds, 100.0 * excess


def driftbench(cli, files, models):
    with tempfile.TemporaryDirectory() as folder:
        run = subprocess.run([cli, "fit", *files, "--out", folder, "--reference-rate", "25,5,53", "--models", models,
                              "--json"], check=True, stdout=subprocess.PIPE)
    comparison = json.loads(run.stdout)
    figures = {}
    for row in comparison["rows"]:
        figures.setdefault(row["model"], np.zeros(3))["xyz".index(row["axis"])] += (
            100.0 * row["excess_over_floor"] / len(files))
    return comparison["timings_s"], figures


def reader_rate(cli):
    bench = os.path.join(os.path.dirname(cli), "driftbench-bench")
    run = subprocess.run([bench, "--benchmark_filter=csvToRecording", "--benchmark_format=json"],
                         check=True, stdout=subprocess.PIPE, stderr=subprocess.DEVNULL)
    return json.loads(run.stdout)["benchmarks"][0]["bytes_per_second"]


def main():
    cli, files = sys.argv[1], sys.argv[2:]
    start = time.perf_counter()
    frames = [pd.read_csv(f, engine="c") for f in files]
    pandas_seconds = time.perf_counter() - start
    low = min(frame["temperature_C"].iloc[:1000].mean() for frame in frames)
    runs = [(f["temperature_C"].to_numpy() - low, f[AXES].to_numpy() - REFERENCE) for f in frames]
    floors = [floor(x, y) for x, y in runs]
    rows = {}
    # The last takes minutes: one fold of it is enough.
    for name, fit, folds in [("numpy polyfit, cubic", polyfit, len(runs)),
                             ("SciPy RBFInterpolator on cells", interpolator, len(runs)),
                             ("scikit-learn MLPRegressor", mlp, 1)]:
        rows[name] = leave_one_out(runs, floors, fit, folds)
    timings, figures = driftbench(cli, files, "constant,linear,cubic,bpnn,rbf-paper,rbf")
    rbf_timings, _ = driftbench(cli, files, "rbf")
    print(f"{'leave one run out':34s} {'seconds':>9s}   excess over the floor x/y/z, %")
    for name, (seconds, excess) in rows.items():
        print(f"{name:34s} {seconds:9.3f}   {excess[0]:7.2f} /{excess[1]:7.2f} /{excess[2]:7.2f}")
    print(f"{'Driftbench rbf, nested':34s} {rbf_timings['compare']:9.3f}   "
          + " /".join(f"{v:7.2f}" for v in figures["rbf"]))
    print(f"{'Driftbench, all six models':34s} {timings['compare']:9.3f}")
    for name in ("cubic", "bpnn", "rbf-paper"):
        print(f"{'  its ' + name:34s} {'':9s}   " + " /".join(f"{v:7.2f}" for v in figures[name]))
    print(f"MLPRegressor takes {rows['scikit-learn MLPRegressor'][0] / rbf_timings['compare']:.0f} times as long as rbf")
    pandas_rate = sum(os.path.getsize(f) for f in files) / pandas_seconds
    rate = reader_rate(cli)
    print(f"CSV: Driftbench reads {rate / 1e6:.0f} MB/s, pandas' C parser {pandas_rate / 1e6:.0f} MB/s: "
          f"{rate / pandas_rate:.1f} times as fast")


main()
