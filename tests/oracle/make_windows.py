#!/usr/bin/env python3
"""make_windows.py FILE: writes the grey levels of windows of DICOM PS3.3, C.11.2.1.2 and C.11.2.1.3.

Linear windows are computed in whole fractions, sigmoid ones with 50 digits; all are compared with pydicom's before they
are written. The HU of a window are first + n * step. Levels are two hexadecimal digits each, halves rounded up.
"""
import json
import sys
from decimal import Decimal, getcontext
from fractions import Fraction

import numpy as np
from pydicom.dataset import Dataset
from pydicom.pixels.processing import apply_windowing

getcontext().prec = 50
COUNT = 1000
# Centre and width; the last ones test a threshold, a narrow window, halves, and a huge one.
WINDOWS = [(50, 350), (40, 80), (400, 1000), (-600, 1500), (700, 4000), (40.5, 256), (127.5, 2), (-3.25, 1), (0, 511),
           (1024, 65536)]


def linear(hu, centre, width):
    low, high = centre - Fraction(1, 2) - (width - 1) / 2, centre - Fraction(1, 2) + (width - 1) / 2
    if hu <= low:
        return Fraction(0)
    if hu > high:
        return Fraction(255)
    return ((hu - (centre - Fraction(1, 2))) / (width - 1) + Fraction(1, 2)) * 255


def linear_exact(hu, centre, width):
    if hu <= centre - width / 2:
        return Fraction(0)
    if hu > centre + width / 2:
        return Fraction(255)
    return ((hu - centre) / width + Fraction(1, 2)) * 255


def sigmoid(hu, centre, width):
    power = -4 * (hu - centre) / width
    return 255 / (1 + (Decimal(power.numerator) / Decimal(power.denominator)).exp())


def of_pydicom(hu, centre, width, function):
    header = Dataset()
    header.PhotometricInterpretation = "MONOCHROME2"
    header.WindowCenter, header.WindowWidth, header.VOILUTFunction = centre, width, function
    header.PixelRepresentation, header.BitsStored = 1, 16
    header.RescaleSlope, header.RescaleIntercept = 255 / 65535, 32768 * 255 / 65535  # white is 255
    return apply_windowing(np.array(hu), header)


def case(name, function, centre, width):
    # Steps are halves of a power of two: places that are exact in binary, from black into white.
    step = 2.0 ** int(np.ceil(np.log2(max(1.5 * width, 1.5) / COUNT)))
    first = float(np.floor(centre - step * COUNT / 2))
    hu = [first + n * step for n in range(COUNT)]
    exact = [function(Fraction(x), Fraction(centre), Fraction(width)) for x in hu]
    theirs = of_pydicom(hu, centre, width, name)
    for one, other in zip(exact, theirs):
        assert abs(float(one) - other) < 1e-6, (name, centre, width, float(one), other)
    levels = [int(level + type(level)(1) / 2) for level in exact]
    return {"function": name, "centre": centre, "width": width, "first": first, "step": step,
            "levels": "".join(f"{level:02x}" for level in levels)}


def main(path):
    cases = [case(name, function, centre, width)
             for name, function in (("LINEAR", linear), ("LINEAR_EXACT", linear_exact), ("SIGMOID", sigmoid))
             for centre, width in WINDOWS]
    with open(path, "w") as file:
        json.dump(cases, file, separators=(",", ":"))
        file.write("\n")


if __name__ == "__main__":
    main(sys.argv[1])
