#!/usr/bin/env python3
"""How much sooner one build of pdrender-bench reaches an error than another.

    tools/measure/equal_error.py THIS OTHER SCENE.json [--samples 16,64,256] [--size WxH] [--seeds N] [--device D]

Renders the scene with several seeds by both builds in turn, on one thread. A picture's variance is that between pictures of
different seeds, so no error that a build states of itself is believed, and no reference is needed: both must be unbiased,
which the means that are printed beside it tell. Seeds are a thousand apart: builds with low-discrepancy points from before
25 November 2026 gave half of a seed's numbers to the next one, and with neighbours their variance comes out at about half.
Time is the processor's, less that of a picture of one sample.
Gain: time x variance of the other build over that of this one, the median over the seeds with half of them between.
"""

import argparse
import array
import json
import pathlib
import resource
import statistics
import subprocess
import tempfile


def scene_of(path: pathlib.Path, size: str | None, seed: int) -> str:
    scene = json.loads(path.read_text())
    raw = path.parent / scene["volume"]["raw"]
    scene["volume"]["raw"] = str(raw.resolve())
    scene["seed"] = seed
    if size:
        scene["film"]["width"], scene["film"]["height"] = (int(n) for n in size.split("x"))
    return json.dumps(scene)


def pixels(file: pathlib.Path) -> array.array:
    data = file.read_bytes()
    end = 0
    for _ in range(3):  # "Pf", size, scale
        end = data.index(b"\n", end) + 1
    values = array.array("f")
    values.frombytes(data[end:])
    return values


def rendered(bench: str, scene: pathlib.Path, samples: int, device: str, folder: pathlib.Path):
    picture = folder / "picture.pfm"
    before = resource.getrusage(resource.RUSAGE_CHILDREN)
    subprocess.run([bench, "picture", str(scene), "--samples", str(samples), "--threads", "1", "--device", device,
                    "--pfm", str(picture)], check=True, stdout=subprocess.DEVNULL)
    after = resource.getrusage(resource.RUSAGE_CHILDREN)
    return after.ru_utime - before.ru_utime, pixels(picture)


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("this")
    parser.add_argument("other")
    parser.add_argument("scene", type=pathlib.Path)
    parser.add_argument("--samples", default="16,64,256")
    parser.add_argument("--size", help="of the film, instead of the scene's")
    parser.add_argument("--seeds", type=int, default=6)
    parser.add_argument("--device", default="cpu")
    options = parser.parse_args()
    benches = {"this": options.this, "other": options.other}
    print(f"{'samples':>8} {'build':>6} {'seconds':>8} {'error':>8} {'mean':>10}   gain (half of the pairs between)")
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        for samples in (int(n) for n in options.samples.split(",")):
            seconds = {build: [] for build in benches}
            pictures = {build: [] for build in benches}
            for turn in range(options.seeds):
                scene = folder / "scene.json"
                scene.write_text(scene_of(options.scene, options.size, 1 + 1000 * turn))
                for build in sorted(benches, reverse=turn % 2 == 1):
                    start, _ = rendered(benches[build], scene, 1, options.device, folder)
                    whole, picture = rendered(benches[build], scene, samples, options.device, folder)
                    seconds[build].append(max(whole - start, 1e-3) * samples / max(samples - 1, 1))
                    pictures[build].append(picture)
            variances, means = {}, {}
            for build, made in pictures.items():
                pairs = zip(made[0::2], made[1::2])
                variances[build] = statistics.mean(
                    sum((a - b) ** 2 for a, b in zip(*pair)) / 2 / len(pair[0]) for pair in pairs)
                means[build] = statistics.mean(sum(picture) / len(picture) for picture in made)
            times = sorted(o / t for o, t in zip(seconds["other"], seconds["this"]))
            by_error = variances["other"] / variances["this"]
            for build in ("other", "this"):
                error = variances[build] ** 0.5 / means[build]
                gain = ""
                if build == "this":
                    low, middle, high = (times[int(q * (len(times) - 1))] * by_error for q in (0.25, 0.5, 0.75))
                    gain = f"{middle:6.2f} ({low:.2f} to {high:.2f})"
                print(f"{samples:8} {build:>6} {statistics.median(seconds[build]):8.2f} {100 * error:7.2f}% "
                      f"{means[build]:10.6f}   {gain}", flush=True)


if __name__ == "__main__":
    main()
