#!/usr/bin/env python3
"""Makes regions.json: statistics of regions of a small scan on an oblique grid, by numpy and scipy.

    make_regions.py            writes regions.json beside this script
    make_regions.py --check    compares instead; exit code 77 without numpy or scipy

The scan is a formula of integers, which oracle_regions_test.cpp repeats. Inside is found by other means than the
program's: distances by matrices, polygons by winding angles. The noise of a mean comes from the products of
all residuals up to 3 voxels apart in the slice and 1 across, by correlation of whole arrays;
its interval is Student's with 3 n / lags degrees of freedom, or as many as independent voxels, at least 3.
"""
import json
import pathlib
import sys

try:
    import numpy as np
    from scipy import stats
    from scipy.signal import fftconvolve
except ImportError:
    print("numpy and scipy are not installed")
    sys.exit(77)

SIZE = (40, 36, 14)
SPACING = np.array([0.9, 0.9, 2.5])
ORIGIN = np.array([-20.0, 11.5, 30.25])
# Two turns, one after the other: by (3, 4, 5) about z and by (5, 12, 13) about x.
AXES = np.array([[1, 0, 0], [0, 12 / 13, -5 / 13], [0, 5 / 13, 12 / 13]]) @ np.array(
    [[0.6, -0.8, 0], [0.8, 0.6, 0], [0, 0, 1]])
LAGS = (3, 3, 1)


def scan():
    """HU by index i, j, k, and the padding: a corner of the scan."""
    i, j, k = np.meshgrid(*[np.arange(n) for n in SIZE], indexing="ij")
    hu = (37 * i * i + 101 * j * k + 53 * k + 29 * i * j) % 997 // 4 + (i // 3 + j // 3) % 5 * 20 - 150
    return hu.astype(float), i + j + 2 * k < 30


def centres():
    index = np.stack(np.meshgrid(*[np.arange(n) for n in SIZE], indexing="ij"), -1)
    return (index * SPACING) @ AXES.T + ORIGIN


def inside(shape, mm):
    if shape["kind"] == "ball":
        return ((mm - shape["centre"]) ** 2).sum(-1) <= shape["radius"] ** 2
    if shape["kind"] == "ellipse":
        u, v = np.array(shape["u"]), np.array(shape["v"])
        normal = np.cross(u, v) / np.linalg.norm(np.cross(u, v))
        away = mm - shape["centre"]
        plane = (away @ u / (u @ u)) ** 2 + (away @ v / (v @ v)) ** 2 <= 1
        origin = np.array(shape["centre"])
    else:
        normal, corners = np.array(shape["normal"]), np.array(shape["corners"])
        origin = corners[0]
        angle = 0
        for a, b in zip(corners, np.roll(corners, -1, 0)):
            flat = lambda p: p - (p @ normal)[..., None] * normal  # noqa: E731
            p, q = flat(a - mm), flat(b - mm)
            angle = angle + np.arctan2(np.cross(p, q) @ normal, (p * q).sum(-1))
        plane = np.round(angle / (2 * np.pi)).astype(int) % 2 != 0
    thickness = (np.abs(normal @ AXES) * SPACING).sum()
    height = (mm - origin) @ normal
    return plane & (height >= -thickness / 2) & (height < thickness / 2)


def plus_minus(hu, mask):
    n = mask.sum()
    if n < 20:
        return None
    residual = np.where(mask, hu - hu[mask].mean(), 0.0)
    flipped = (slice(None, None, -1),) * 3
    window = tuple(slice(s - 1 - l, s + l) for s, l in zip(hu.shape, LAGS))
    products = fftconvolve(residual, residual[flipped])[window].sum()
    pairs = np.round(fftconvolve(mask.astype(float), mask.astype(float)[flipped])[window]).sum()
    sample = (residual**2).sum() / n
    mean = max(products / n**2 / max(1 - pairs / n**2, 0.2), sample / (n - 1))
    lags = np.prod([2 * l + 1 for l in LAGS])
    freedom = int(np.clip(min((sample + mean) / mean, 3 * n / lags), 3, 1000))
    return float(stats.t.ppf(0.975, freedom) * np.sqrt(mean))


def numbers(shape):
    hu, padding = scan()
    found = inside(shape, centres())
    mask = found & ~padding
    x = hu[mask]
    return {"count": int(mask.sum()), "padding": int((found & padding).sum()), "mean": float(x.mean()),
            "sd": float(x.std(ddof=1)), "median": float(np.median(x)), "lowest": float(x.min()),
            "highest": float(x.max()), "percentile5": float(np.percentile(x, 5)),
            "percentile95": float(np.percentile(x, 95)), "ml": float(mask.sum() * SPACING.prod() / 1000),
            "plus_minus": plus_minus(hu, mask)}


def place(i, j, k):
    return [round(float(x), 3) for x in (np.array([i, j, k]) * SPACING) @ AXES.T + ORIGIN]


def shapes():
    axis = [AXES[:, n] for n in range(3)]
    tilted = (0.6 * axis[0] + 0.8 * axis[2], axis[1])
    listed = lambda v: [float(x) for x in v]  # noqa: E731
    return [
        {"kind": "ball", "centre": place(20.3, 17.6, 6.8), "radius": 3.0},
        {"kind": "ball", "centre": place(20.3, 17.6, 6.8), "radius": 1.4},
        {"kind": "ball", "centre": place(21.1, 16.2, 7.4), "radius": 11.0},
        {"kind": "ball", "centre": place(6.2, 7.1, 4.9), "radius": 9.0},
        {"kind": "ellipse", "centre": place(18.4, 19.2, 6.3), "u": listed(12.3 * axis[0]), "v": listed(6.1 * axis[1])},
        {"kind": "ellipse", "centre": place(18.4, 19.2, 6.3), "u": listed(10.3 * tilted[0]), "v": listed(7.7 * tilted[1])},
        {"kind": "polygon", "normal": listed(axis[2]), "corners": [
            place(5.3, 6.1, 8.2), place(33.4, 9.3, 8.2), place(28.7, 30.2, 8.2), place(19.6, 15.4, 8.2),
            place(8.9, 29.8, 8.2)]},
        {"kind": "polygon", "normal": listed(axis[0]), "corners": [
            place(17.3, 6.1, 2.2), place(17.3, 29.3, 3.7), place(17.3, 20.2, 11.6)]},
    ]


def main():
    target = pathlib.Path(__file__).with_name("regions.json")
    made = [{"shape": shape, "expected": numbers(shape)} for shape in shapes()]
    if "--check" not in sys.argv:
        target.write_text(json.dumps(made, indent=1) + "\n")
        return 0
    for old, new in zip(json.loads(target.read_text()), made, strict=True):
        for key, value in new["expected"].items():
            was = old["expected"][key]
            if was != value and (was is None or value is None or abs(was - value) > 1e-9 * abs(value)):
                print(f"{new['shape']['kind']}: {key} is {value}, in the file {was}")
                return 1
    return 0


if __name__ == "__main__":
    sys.exit(main())
