#!/usr/bin/env python3
"""Which classes of CT load, with the right geometry and the right voxels.

classes.py [--build build/release] [--only WORD] [--keep FOLDER]
Writes each class of class_series.py as a series of 24 slices, asks `pdrender-cli info --json` for it, and prints what
it says beside the truth, which is known by construction: the values of every voxel, by their checksum, and the grid. A
row that is not as it should be is marked, and the exit code is 1 then. Needs DCMTK's programs, numpy, and pydicom with
pylibjpeg-openjpeg for JPEG 2000. SimpleITK, where it is installed, reads the same folders for comparison."""
import argparse
import contextlib
import hashlib
import json
import os
import pathlib
import shutil
import subprocess
import sys
import tempfile

import numpy as np

import class_series

try:
    import SimpleITK
    SimpleITK.ProcessObject.SetGlobalWarningDisplay(False)
except ImportError:
    SimpleITK = None


def report_of(options, folder):
    place = next(folder.glob("*.zip"), folder)
    printed = subprocess.run([options.build / "bin/pdrender-cli", "info", "--json", place], capture_output=True,
                             text=True)
    return json.loads(printed.stdout) if printed.returncode == 0 else {"series": [], "problems": [
        {"reason": printed.stderr.strip().splitlines()[-1]}]}


def wrong_grid(series, expected):
    """What is wrong with the place of an entry; empty: nothing."""
    size = list(expected.values.shape[::-1])
    if series["size"] != size:
        return f"{series['size']} voxels"
    row, column = np.array(series["rowDirection"]), np.array(series["columnDirection"])
    spacing = series["spacingMm"]
    drift = series["driftMm"]
    step = np.cross(row, column) * spacing[2] + row * drift[0] + column * drift[1]
    ours = lambda i, j, k: np.array(series["originMm"]) + i * spacing[0] * row + j * spacing[1] * column + k * step
    true = lambda i, j, k: (expected.origin + i * expected.spacing[1] * expected.row +
                            j * expected.spacing[0] * expected.column + k * expected.step)
    corners = [(i, j, k) for i in (0, size[0] - 1) for j in (0, size[1] - 1) for k in (0, size[2] - 1)]
    off = max(np.linalg.norm(ours(*corner) - true(*corner)) for corner in corners)
    return f"{off:.3g} mm off" if off > expected.within else ""


def wrong_values(series, expected):
    if (series["unit"] == "HU") != expected.is_hu:
        return "HU" if series["unit"] == "HU" else "no HU"
    notes = " ".join(series["notes"])
    if expected.note not in notes:
        return f"not noted: {expected.note}"
    if expected.lossy >= 1:
        return "" if abs(series["hu"]["mean"] - expected.values.mean()) < expected.lossy / 10 else "another mean"
    step, zero = series["valueStep"], series["valueZero"]
    voxels = np.clip(np.rint((expected.values - zero) / step + 1e-9), -32768, 32767)
    most = step / 2 * (1 + 1e-6) if "rounded to steps" in notes else max(expected.lossy, 1e-6 * step)
    off = np.abs(voxels * step + zero - expected.values).max()
    if off > most and "beyond what 16 bits hold" not in notes:
        return f"values {off:.3g} off, and no note of it"
    same = hashlib.sha256(voxels.astype("<i2").tobytes()).hexdigest() == series["sha256"]
    return "" if same else "other voxels"


def judge(report, expected):
    """What is said, and what is wrong with it; empty: nothing."""
    said = [series for series in report["series"] if series["loadable"] and "error" not in series]
    loaded = [series for series in said if not series["resampled"]]
    reasons = [series.get("error") or series["reason"] for series in report["series"] if series not in said]
    reasons += [problem["reason"] for problem in report["problems"]]
    if expected is None:
        return reasons[0] if reasons else "", "loads" if said else "" if any(reasons) else "no sentence"
    if expected[0].resampled:
        is_offered = len(said) == 1 and not loaded and reasons
        return reasons[0] if reasons else "", "" if is_offered else "not offered resampled"
    if len(loaded) != len(expected):
        return reasons[0] if reasons else "", f"{len(loaded)} of {len(expected)} load"
    wrong = [wrong_grid(series, one) or wrong_values(series, one) for series, one in zip(loaded, expected)]
    notes = [note for series in loaded for note in series["notes"]]
    phases = ", ".join(series["phase"] for series in loaded if "phase" in series)
    return phases or (notes[0] if notes else ""), next(filter(None, wrong), "")


@contextlib.contextmanager
def silence():
    """Nothing reaches the standard error meanwhile, libraries' words included."""
    kept, nothing = os.dup(2), os.open(os.devnull, os.O_WRONLY)
    os.dup2(nothing, 2)
    try:
        yield
    finally:
        os.dup2(kept, 2)
        os.close(kept)
        os.close(nothing)


def simple_itk(folder, expected):
    """What SimpleITK makes of the first entry: right, wrong, or an error."""
    if SimpleITK is None or not expected or expected[0].resampled:
        return ""
    place = folder if any(folder.glob("*.dcm")) else folder / "0"
    try:
        with silence():
            names = SimpleITK.ImageSeriesReader.GetGDCMSeriesFileNames(str(place))
            image = SimpleITK.ReadImage(names if len(names) > 1 else str(next(folder.iterdir())))
        values = SimpleITK.GetArrayFromImage(image)
    except (RuntimeError, StopIteration):
        return "refuses"
    one = expected[0]
    if values.shape != one.values.shape:
        return "wrong size"
    corner = np.array(image.TransformIndexToPhysicalPoint([n - 1 for n in image.GetSize()]))
    true = (one.origin + (values.shape[2] - 1) * one.spacing[1] * one.row +
            (values.shape[1] - 1) * one.spacing[0] * one.column + (values.shape[0] - 1) * one.step)
    if np.linalg.norm(corner - true) > max(one.within, 1e-3):
        return f"{np.linalg.norm(corner - true):.2f} mm off"
    off = np.abs(values - one.values)
    return "right" if (off.mean() < one.lossy / 10 if one.lossy >= 1 else off.max() <= 0.5) else "other values"


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--build", type=pathlib.Path, default=pathlib.Path("build/release"))
    parser.add_argument("--only", default="", help="only the classes whose names contain this")
    parser.add_argument("--keep", type=pathlib.Path, help="leave the series in this folder")
    options = parser.parse_args()
    failed = 0
    print(f"{'class':28} {'here':34} {'SimpleITK':14} sentence")
    for name, write in class_series.CLASSES.items():
        if options.only not in name:
            continue
        with tempfile.TemporaryDirectory() as temporary:
            folder = pathlib.Path(temporary) / "series"
            folder.mkdir()
            expected = write(folder)
            sentence, wrong = judge(report_of(options, folder), expected)
            should = "refused" if expected is None else "resampled" if expected[0].resampled else "right"
            failed += bool(wrong)
            print(f"{name:28} {'WRONG: ' + wrong if wrong else should:34} {simple_itk(folder, expected):14} "
                  f"{sentence[:110]}", flush=True)
            if options.keep:
                shutil.copytree(folder, options.keep / name.replace(" ", "-"), symlinks=True)
    print(f"{failed} of {len(class_series.CLASSES)} classes are not as they should be")
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main())
