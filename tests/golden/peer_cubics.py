"""Figures of tst_polynomial_model, by numpy:  python3 tests/golden/peer_cubics.py  (numpy 1.24.2)

Two logs made by a formula, fitted as PX4 (median filter of 31 with zeros beyond the ends, 2000 bins over the
range, polyfit about its middle) and as ArduPilot (moving mean of 2 s, polyfit about 35 degrees Celsius) do. Of two
runs, each is filtered by itself and both go into one fit.
"""
import numpy as np


def noise(seed, count):
    """Even noise in -0.5 .. 0.5 that any language can make."""
    values = np.empty(count)
    for i in range(count):
        seed = (1103515245 * seed + 12345) % 2**31
        values[i] = seed / 2**31 - 0.5
    return values


def log(seed, count, low, high, seconds):
    """Time, temperature and rates of a warm-up from low to high."""
    u = np.arange(count) / (count - 1)
    temperature = low + (high - low) * u + 0.3 * noise(seed, count)
    c = (temperature - 20) / 40
    rates = [0.8 * c - 0.5 * c**2 + 0.2 * c**3 + 0.4 * noise(seed + 1, count),
             -2 + 0.3 * np.sin(3 * c) + 0.2 * noise(seed + 2, count),
             0.05 * c**4 + 0.3 * noise(seed + 3, count)]
    return seconds * u, temperature, np.column_stack(rates)


def median_filtered(rates):
    half = 15
    padded = np.concatenate([np.zeros((half, 3)), rates, np.zeros((half, 3))])
    windows = np.lib.stride_tricks.sliding_window_view(padded, 2 * half + 1, axis=0)
    return np.median(windows, axis=2)


def as_px4(logs):
    temperature = np.concatenate([t for _, t, _ in logs])
    rates = np.concatenate([median_filtered(r) for _, _, r in logs])
    low, high = temperature.min(), temperature.max()
    bins = np.minimum(((temperature - low) / ((high - low) / 2000)).astype(int), 1999)
    count = np.bincount(bins, minlength=2000)
    used = count > 0
    centre = 0.5 * (low + high)
    x = np.bincount(bins, temperature - centre, 2000)[used] / count[used]
    fits = [np.polyfit(x, np.bincount(bins, rates[:, a], 2000)[used] / count[used], 3) for a in range(3)]
    return centre, fits


def as_ardupilot(logs):
    x, y = [], []
    for time, temperature, rates in logs:
        window = int(len(time) / (time[-1] - time[0])) * 2
        mean = np.ones(window) / window
        x.append(np.convolve(temperature, mean, 'valid') - 35)
        y.append(np.column_stack([np.convolve(rates[:, a], mean, 'valid') for a in range(3)]))
    x, y = np.concatenate(x), np.concatenate(y)
    return 35.0, [np.polyfit(x, y[:, a], 3) for a in range(3)]


first, second = log(1, 6000, -12, 61, 300), log(100, 3000, 10, 78, 280)
for name, (centre, fits) in {'PX4, first log': as_px4([first]), 'PX4, both logs': as_px4([first, second]),
                             'ArduPilot, first log': as_ardupilot([first]),
                             'ArduPilot, both logs': as_ardupilot([first, second])}.items():
    print(name, 'centre', repr(float(centre)))
    for power in range(4):
        print('   ', ', '.join(repr(float(fit[3 - power])) for fit in fits))
