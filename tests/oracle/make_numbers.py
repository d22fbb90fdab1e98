#!/usr/bin/env python3
"""make_numbers.py FOLDER: writes the numbers that slices must show, into made.json, chest.json and sheared.json.

They come from SimpleITK alone and are in the tree (tests/oracle/numbers), so that tests need none of these packages:
SimpleITK, numpy, pydicom. Seeds are fixed: another run writes the same files.
"""
import json
import os
import sys

import numpy as np
import SimpleITK as sitk

import volumes

# Places of the chest whose values are also in the design of the planning views.
GOLDEN = [(-13.1, -58.2, -48.9), (0, 0, -111.5), (30.3, -20.7, -150.2), (-60.4, 40.6, -77.7), (100.1, -33.3, -200.9)]


def numbers_of(image, places, plane):
    hu = [image.EvaluateAtPhysicalPoint(place, sitk.sitkLinear) for place in places]
    slice_hu = [None if np.isnan(value) else round(value, 4) for value in volumes.resliced(image, plane).ravel()]
    return {
        "by": "SimpleITK " + sitk.Version_VersionString() + ", linear, float64",
        "size": image.GetSize(),
        "patientFromIndex": [[round(x, 9) for x in row] for row in volumes.patient_from_index(image).tolist()],
        "placesMmHu": [[float(x) for x in place] + [round(value, 4)] for place, value in zip(places, hu)],
        "slice": plane | {"hu": slice_hu},
    }


def write(folder, name, numbers):
    with open(os.path.join(folder, name), "w") as file:
        json.dump(numbers, file, separators=(",", ":"))
        file.write("\n")


def main(folder):
    random = np.random.default_rng(20261126)
    for name, image, pixels, mm in (("made.json", volumes.made_volume(), (56, 48), 0.625),
                                    ("chest.json", volumes.chest(), (56, 48), 5.5),
                                    ("sheared.json", volumes.sheared_volume(), (56, 48), 0.625)):
        if image is None:
            sys.exit("the chest is not there: name the shared data in PDR_SHARED")
        places = [tuple(np.round(place, 3).tolist()) for place in volumes.places_in(image, 1000, random)]
        if name == "chest.json":
            places = GOLDEN + places
        write(folder, name, numbers_of(image, places, volumes.oblique_plane(image, pixels, mm, random)))


if __name__ == "__main__":
    main(sys.argv[1])
