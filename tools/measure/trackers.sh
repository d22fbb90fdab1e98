#!/usr/bin/env bash
# What each way to the first collision costs: on the head phantom, on the cranium, and on a CT series, in one run.
#   tools/measure/trackers.sh [FOLDER_OF_ONE_DICOM_SERIES [OPTIONS_OF_pdrender-bench_trackers...]]
# Needs pdrender-bench (PDR_BENCH, else build/release/bin) and python3. The cranium is build/example/matrix.dat
# (PDR_CRANIUM), left out where it is not there. The series needs dcmdump, and must be uncompressed, axial and even.
set -euo pipefail

cd "$(dirname "${BASH_SOURCE[0]}")/../.."
bench=$(realpath "${PDR_BENCH:-build/release/bin/pdrender-bench}")
cranium=$(realpath -m "${PDR_CRANIUM:-build/example/matrix.dat}")
series=${1:+$(realpath "$1")}
shift || true
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
cd "$scratch"

# Writes a raw volume of the series and two scenes of each volume; prints the names of the scenes.
cat >scenes.py <<'PYTHON'
import array, glob, json, math, os, re, subprocess, sys

BONE = (31, [(-57.7, 0), (157.563, 0.0179028), (157.727, 0.563502), (426.326, 1)])  # Exposure Render's for Manix
SKIN = (1, [(-600, 0), (-300, 0.3), (0, 0.15), (150, 0.05), (300, 0.8), (700, 1)])


def write_scenes(name, raw, size, spacing):
    """The volume from the front; its face fills the picture."""
    x, y, z = (n * s / 2 for n, s in zip(size, spacing))
    away = max(x, z) / math.tan(math.radians(15))
    for look, (extinction, nodes) in {"bone": BONE, "skin and bone": SKIN}.items():
        scene = {
            "format": "pdrender-scene", "version": 1,
            "volume": {"raw": raw, "size": size, "spacingMm": spacing},
            "transferFunction": {"extinctionPerMm": extinction, "nodes": [{"hu": h, "opacity": o} for h, o in nodes]},
            "camera": {"eyeMm": [x, -away, z], "targetMm": [x, y, z], "fovDegrees": 30},
            "film": {"width": 96, "height": 96},
        }
        json.dump(scene, open(f"{name}, {look}", "w"))
        print(f"{name}, {look}")


def raw_of_series(folder, raw):
    """Slices in the order of z, as Hounsfield units; returns size and spacing."""
    slices = []
    for number, file in enumerate(sorted(glob.glob(folder + "/*"))):
        os.mkdir(f"slice{number}")
        text = subprocess.run(["dcmdump", "-q", "+W", f"slice{number}", file], capture_output=True, check=True).stdout
        values = dict(re.findall(r"\((\w{4},\w{4})\) \w\w \[?([^\]#]*)", text.decode("latin-1")))
        numbers = {tag: [float(part) for part in values[tag].split("\\")]
                   for tag in ("0020,0032", "0028,0010", "0028,0011", "0028,0030", "0028,1052", "0028,1053")}
        slices.append((numbers["0020,0032"][2], numbers, glob.glob(f"slice{number}/*")[0]))
    slices.sort(key=lambda one: one[0])
    with open(raw, "wb") as out:
        for _, numbers, pixels in slices:
            stored = array.array("h", open(pixels, "rb").read())
            slope, intercept = numbers["0028,1053"][0], numbers["0028,1052"][0]
            out.write(array.array("h", (round(slope * v + intercept) for v in stored)).tobytes())
    first = slices[0][1]
    between = (slices[-1][0] - slices[0][0]) / (len(slices) - 1)
    return ([int(first["0028,0011"][0]), int(first["0028,0010"][0]), len(slices)],
            [first["0028,0030"][1], first["0028,0030"][0], between])


cranium, series = sys.argv[1], sys.argv[2]
if os.path.exists(cranium):
    write_scenes("cranium", cranium, [256, 256, 108], [0.9570312, 0.9570312, 1.5])
if series:
    write_scenes("series", os.path.abspath("series.raw"), *raw_of_series(series, "series.raw"))
PYTHON

python3 scenes.py "$cranium" "$series" >names
mapfile -t names <names
"$bench" trackers "$@"
if ((${#names[@]} > 0)); then
    "$bench" trackers "${names[@]}" "$@" | tail -n +2
fi
