#!/usr/bin/env python3
"""Rings of the grid of voxels on a skull, with rays to the light from events and from outside the soft edge of surfaces.

    tools/measure/rings.py PDRENDER_CLI [--look resources/looks/bone.json] [--samples 64]

Renders the example head (build/example) twice with either `rayOrigin`, from two seeds a thousand apart. Rings are what both
images of a pair have in common beside a Gaussian blur of 4 pixels [levels rms]: noise has no part in it. Noise is half of
what they differ by, on the temple. Brightness is the mean radiance of the head beside that with `event`.
"""

import argparse
import json
import math
import pathlib
import resource
import statistics
import struct
import subprocess
import tempfile
import zlib

SIZE, VOXELS = (480, 512), (256, 256, 108)
PLACES = {"temple": (85, 150, 205, 300), "forehead": (300, 345, 125, 185), "vault": (200, 262, 76, 100)}  # x0, x1, y0, y1
EXPOSURE, BLUR, TISSUE = 0.5, 4, 12
ROOT = pathlib.Path(__file__).resolve().parents[2]


def head(folder: pathlib.Path) -> pathlib.Path:
    """The example head with its rows in the order of the patient's axes."""
    row, rows = 2 * VOXELS[0], VOXELS[1]
    stored = (ROOT / "build/example/matrix.dat").read_bytes()
    ordered = b"".join(stored[(k * rows + j) * row:(k * rows + j + 1) * row]
                       for k in range(VOXELS[2]) for j in reversed(range(rows)))
    raw = folder / "head.raw"
    raw.write_bytes(ordered)
    return raw


def scene(raw: pathlib.Path, seed: int) -> dict:
    size, spacing = VOXELS, (0.9570312, 0.9570312, 1.5)
    return {"format": "pdrender-scene", "version": 1,
            "volume": {"raw": str(raw), "size": size, "spacingMm": spacing,
                       "type": "int16", "originMm": [-0.5 * d * (n - 1) for d, n in zip(spacing, size)],
                       "table": "hidden"},
            "transferFunction": {"extinctionPerMm": 1, "nodes": [{"hu": 0, "opacity": 0}]},
            "camera": {"type": "perspective", "eyeMm": [-167, -291, 44], "targetMm": [1, 0, -3], "up": [0, 0, 1],
                       "fovDegrees": 35},
            "film": {"width": SIZE[0], "height": SIZE[1]}, "seed": seed}


def levels(png: pathlib.Path) -> list[list[float]]:
    """Luminance of an RGB image of 8 bits, in rows."""
    data, at, packed = png.read_bytes(), 8, b""
    while at < len(data):
        length, kind = struct.unpack(">I4s", data[at:at + 8])
        if kind == b"IHDR":
            width, height, depth, colours = struct.unpack(">IIBB", data[at + 8:at + 18])
        if kind == b"IDAT":
            packed += data[at + 8:at + 8 + length]
        at += length + 12
    channels = {2: 3, 6: 4}[colours]
    raw, step = zlib.decompress(packed), width * channels
    before, rows = bytearray(step), []
    for y in range(height):
        start = y * (step + 1)
        row = bytearray(raw[start + 1:start + 1 + step])
        unfilter(raw[start], row, before, channels)
        rows.append([0.2126 * row[i] + 0.7152 * row[i + 1] + 0.0722 * row[i + 2] for i in range(0, step, channels)])
        before = row
    return rows


def unfilter(kind: int, row: bytearray, above: bytearray, channels: int) -> None:
    for i in range(len(row) if kind else 0):
        left = row[i - channels] if i >= channels else 0
        corner = above[i - channels] if i >= channels else 0
        up = above[i]
        if kind == 4:
            paeth = left + up - corner
            nearest = min((abs(paeth - left), 0, left), (abs(paeth - up), 1, up), (abs(paeth - corner), 2, corner))[2]
        row[i] = (row[i] + (0, left, up, (left + up) // 2, nearest if kind == 4 else 0)[kind]) & 255


def beside_blur(rows: list[list[float]], x0: int, x1: int, y0: int, y1: int) -> list[float]:
    """What a Gaussian blur leaves of each pixel of the place."""
    reach = 4 * BLUR
    kernel = [math.exp(-0.5 * (d / BLUR) ** 2) for d in range(-reach, reach + 1)]
    kernel = [k / sum(kernel) for k in kernel]
    across = {y: [sum(k * rows[y][x + d] for k, d in zip(kernel, range(-reach, reach + 1))) for x in range(x0, x1)]
              for y in range(y0 - reach, y1 + reach)}
    return [rows[y][x0 + i] - sum(k * across[y + d][i] for k, d in zip(kernel, range(-reach, reach + 1)))
            for y in range(y0, y1) for i in range(x1 - x0)]


def radiance(level: float) -> float:
    share = level / 255
    light = share / 12.92 if share <= 0.04045 else ((share + 0.055) / 1.055) ** 2.4
    return -EXPOSURE * math.log(max(1 - light, 1e-3))


def rendered(cli: str, look: dict, samples: int, seed: int, folder: pathlib.Path) -> tuple[float, list[list[float]]]:
    (folder / "scene.json").write_text(json.dumps(scene(folder / "head.raw", seed)))
    (folder / "look.json").write_text(json.dumps(look))
    image = folder / "image.png"
    before = resource.getrusage(resource.RUSAGE_CHILDREN)
    subprocess.run([cli, "render", folder / "scene.json", "-o", image, "--look", folder / "look.json", "--samples",
                    str(samples), "--exposure", str(EXPOSURE), "--tone-curve", "perChannel"], check=True,
                   stdout=subprocess.DEVNULL)
    after = resource.getrusage(resource.RUSAGE_CHILDREN)
    return after.ru_utime - before.ru_utime, levels(image)


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("cli")
    parser.add_argument("--look", type=pathlib.Path, default=ROOT / "resources/looks/bone.json")
    parser.add_argument("--samples", type=int, default=64)
    options = parser.parse_args()
    look = json.loads(options.look.read_text())
    brightness = None
    with tempfile.TemporaryDirectory() as name:
        head(pathlib.Path(name))
        for origin in ("event", "outsideEdge"):
            look["surface"]["rayOrigin"] = origin
            made = [rendered(options.cli, look, options.samples, seed, pathlib.Path(name)) for seed in (1, 1001)]
            pair = [rows for _, rows in made]
            rings, noise = {}, 0.0
            for place, box in PLACES.items():
                a, b = (beside_blur(rows, *box) for rows in pair)
                rings[place] = math.sqrt(max(0.0, statistics.mean(x * y for x, y in zip(a, b))))
                if place == "temple":
                    noise = math.sqrt(statistics.mean((x - y) ** 2 for x, y in zip(a, b)) / 2)
            mean = statistics.mean(radiance(v) for rows in pair for row in rows for v in row if v > TISSUE)
            brightness = brightness or mean
            print(f"{origin:12}", *(f"{place} {value:.2f}" for place, value in rings.items()),
                  f"noise {noise:.2f} brightness {mean / brightness:.3f} seconds {sum(t for t, _ in made) / 2:.1f}",
                  flush=True)


if __name__ == "__main__":
    main()
