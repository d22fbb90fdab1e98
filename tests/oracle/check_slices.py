#!/usr/bin/env python3
"""check_slices.py PROGRAM: compares slices that PROGRAM (oblique_slices) makes with SimpleITK's, at 200,000 places of
each of the volumes. Ends with 77 where a package (SimpleITK, numpy, pydicom) or the chest is missing.
"""
import json
import os
import subprocess
import sys
import tempfile

PLACES, PIXELS, LARGEST = 200_000, (256, 240), 0.05


def skip(reason):
    print("SKIP   : CheckSlices::slicesAreSimpleItks() " + reason)
    sys.exit(1 if os.environ.get("PDR_REQUIRE_DATA") and "data" in reason else 77)


try:
    import numpy as np

    import volumes
except ImportError as missing:
    skip(f"the Python package {missing.name} is not installed; the numbers in the tree are compared all the same")


def ours(program, volume, planes):
    with tempfile.TemporaryDirectory() as folder:
        listed, out = os.path.join(folder, "planes.json"), os.path.join(folder, "out")
        with open(listed, "w") as file:
            json.dump(planes, file)
        subprocess.run([program, volume, listed, out], check=True)
        return np.fromfile(out, "<f4").reshape(len(planes), PIXELS[1], PIXELS[0])


def compare(program, name, volume, image, mm_per_pixel):
    random = np.random.default_rng(7)
    planes, theirs, places = [], [], 0
    while places < PLACES:
        planes.append(volumes.oblique_plane(image, PIXELS, mm_per_pixel, random))
        theirs.append(volumes.resliced(image, planes[-1]))
        places += np.count_nonzero(~np.isnan(theirs[-1]))
    mine, theirs = ours(program, volume, planes), np.stack(theirs)
    both = ~np.isnan(mine) & ~np.isnan(theirs)
    edges = np.count_nonzero(np.isnan(mine) != np.isnan(theirs))
    off = np.abs(mine - theirs)[both]
    print(f"{name}: {off.size} places on {len(planes)} planes: at most {off.max():.4f} HU off, rms "
          f"{np.sqrt(np.mean(off ** 2)):.5f}; {edges} pixels on the very edge differ")
    return off.max() < LARGEST and edges <= 1e-4 * mine.size


def main(program):
    chest = volumes.chest()
    if chest is None:
        skip("the real CT data is not there: put it beside the source tree as shared/data, or name it in PDR_SHARED")
    good = compare(program, "made", "made", volumes.made_volume(), 0.15)
    good = compare(program, "chest", volumes.chest_folder(), chest, 1.5) and good
    good = compare(program, "sheared", "sheared", volumes.sheared_volume(), 0.15) and good
    good = compare(program, "tilted head", volumes.tilted_head_folder(), volumes.tilted_head(), 0.5) and good
    sys.exit(0 if good else 1)


if __name__ == "__main__":
    main(sys.argv[1])
