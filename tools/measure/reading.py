#!/usr/bin/env python3
"""How long a folder takes to become voxels, against dcm2niix and SimpleITK, and how much memory it takes.

reading.py FOLDER [--build build/release] [--rounds 5] [--slices 100 600] [--codings raw jpeg-2000] [--work FOLDER]
FOLDER holds one series of raw slices. Longer series are made from it, with further slices between its own, and coded
ones with DCMTK (dcmodify, dcmcjpeg) or, in JPEG 2000, with pydicom and pylibjpeg-openjpeg, in the folder --work, which
is kept if it is given. All programs run in turn, after a round that only fills the cache of files; the table has the
medians of wall and processor time, and the largest memory. dcm2niix writes its file to the same folder, without
compressing it. SimpleITK is left out where it is not installed."""
import argparse
import json
import os
import pathlib
import re
import shutil
import statistics
import subprocess
import sys
import tempfile
import time

# Programs that code a file, by the name of the coding.
CODERS = {"jpeg-lossless": ["dcmcjpeg", "+e1"], "jpeg-ls": ["dcmcjpls"], "rle": ["dcmcrle"]}
# A program that reads a folder with SimpleITK, and prints its seconds, without those of loading the library.
SIMPLE_ITK = """
import sys, time
import SimpleITK
def spent(): return time.monotonic(), time.process_time()
began = spent()
SimpleITK.ReadImage(SimpleITK.ImageSeriesReader.GetGDCMSeriesFileNames(sys.argv[1]))
print(*(after - before for before, after in zip(began, spent())))
"""


def run(command):
    """What the command prints, and its seconds on the wall, its processor seconds and its peak of memory [MB]."""
    start = time.monotonic()
    with subprocess.Popen(command, stdout=subprocess.PIPE, stderr=subprocess.DEVNULL) as process:
        printed = process.stdout.read()
        _, status, used = os.wait4(process.pid, 0)
        process.returncode = os.waitstatus_to_exitcode(status)
    if process.returncode:
        raise SystemExit(f"{command[0]} failed")
    return printed, time.monotonic() - start, used.ru_utime + used.ru_stime, used.ru_maxrss / 1024


def numbers(file, tag):
    """The numbers of an element."""
    line = subprocess.run(["dcmdump", "+P", tag, file], capture_output=True, text=True, check=True).stdout
    return [float(value) for value in re.search(r"\[(.*)\]", line)[1].split("\\")]


def make_series(slices, count, target):
    """Writes `count` slices that divide the way from the first to the last of `slices` evenly."""
    target.mkdir(parents=True)
    ordered = sorted((numbers(file, "0020,0032"), file) for file in slices)
    (first, _), (last, _) = ordered[0], ordered[-1]
    for i in range(count):
        part = i / (count - 1)
        place = "\\".join(f"{a + (b - a) * part:.8g}" for a, b in zip(first, last))
        file = target / f"{i:05}.dcm"
        shutil.copyfile(ordered[round(part * (len(ordered) - 1))][1], file)
        subprocess.run(["dcmodify", "-nb", "-m", f"ImagePositionPatient={place}", "-m", f"SOPInstanceUID=1.2.3.{i + 1}",
                        "-m", f"InstanceNumber={i + 1}", file], check=True)


def code_series(raw, coding, target):
    target.mkdir(parents=True)
    if coding == "jpeg-2000":
        return code_jpeg_2000(raw, target)
    for file in sorted(raw.iterdir()):
        subprocess.run([*CODERS[coding], file, target / file.name], check=True)


def code_jpeg_2000(raw, target):
    import pydicom
    for file in sorted(raw.iterdir()):
        data = pydicom.dcmread(file)
        data.compress(pydicom.uid.JPEG2000Lossless, generate_instance_uid=False)
        data.save_as(target / file.name)


def ours(options, folder):
    """Wall and processor seconds from the folder to voxels, the peak and the voxels' own memory [MB]."""
    printed, _, _, peak = run([options.build / "bin/pdrender-cli", "info", "--json", "--times", folder])
    report = json.loads(printed)
    series = max(report["series"], key=lambda one: one["slices"])
    size = series["size"]
    return (report["scanSeconds"] + series["readSeconds"],
            report["scanProcessorSeconds"] + series["readProcessorSeconds"], peak,
            size[0] * size[1] * size[2] * 2 / 2**20)


def theirs(folder, work):
    written = work / "niix"
    shutil.rmtree(written, ignore_errors=True)
    written.mkdir()
    return run(["dcm2niix", "-z", "n", "-b", "n", "-o", written, folder])[1:]


def simple_itk(folder):
    """Wall and processor seconds of SimpleITK; none where it is not installed."""
    read = subprocess.run([sys.executable, "-c", SIMPLE_ITK, folder], capture_output=True, text=True)
    return [float(number) for number in read.stdout.split()] or [float("nan")] * 2


def row(options, name, folder, work):
    rounds = [(ours(options, folder), theirs(folder, work), simple_itk(folder)) for _ in range(options.rounds + 1)][1:]
    middle = lambda values: statistics.median(values)
    our_wall, our_work = (middle(one[0][i] for one in rounds) for i in (0, 1))
    their_wall, their_work = (middle(one[1][i] for one in rounds) for i in (0, 1))
    itk_wall, itk_work = (middle(one[2][i] for one in rounds) for i in (0, 1))
    peak, voxels = max(one[0][2] for one in rounds), rounds[0][0][3]
    print(f"{name:20} {our_wall:8.3f} {their_wall:8.3f} {itk_wall:9.3f} {our_wall / their_wall:6.2f} {our_work:8.3f} "
          f"{their_work:8.3f} {itk_work:9.3f} {our_work / their_work:6.2f} {peak:7.0f} {voxels:7.0f}", flush=True)


def measure(options, work):
    print(f"{'':20} {'wall [s]':>34} {'processor [s]':>34} {'memory [MB]':>15}")
    print(f"{'':20} " + f"{'ours':>8} {'dcm2niix':>8} {'SimpleITK':>9} {'ratio':>6} " * 2 +
          f"{'peak':>7} {'voxels':>7}")
    slices = sorted(file for file in options.folder.iterdir() if file.is_file())
    for count in options.slices:
        for coding in options.codings:
            raw, folder = work / f"{count}-raw", work / f"{count}-{coding}"
            if not raw.exists():
                make_series(slices, count, raw)
            if not folder.exists():
                code_series(raw, coding, folder)
            row(options, f"{count} {coding}", folder, work)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("folder", type=pathlib.Path)
    parser.add_argument("--build", type=pathlib.Path, default=pathlib.Path("build/release"))
    parser.add_argument("--rounds", type=int, default=5)
    parser.add_argument("--slices", type=int, nargs="+", default=[100, 600])
    parser.add_argument("--codings", nargs="+", default=["raw", "jpeg-lossless", "jpeg-2000"],
                        choices=["raw", "jpeg-2000", *CODERS])
    parser.add_argument("--work", type=pathlib.Path)
    options = parser.parse_args()
    with tempfile.TemporaryDirectory() as temporary:
        measure(options, options.work or pathlib.Path(temporary))


if __name__ == "__main__":
    main()
