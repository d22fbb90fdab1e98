#!/usr/bin/env python3
"""Resamples a CT series along its axis by cubic splines, to a size that hospitals see every day.

    finer_slices.py SERIES_FOLDER NEW_FOLDER [SLICES, default 600]

Writes uncompressed DICOM with new UIDs. No noise is added: slices between those of the scanner are smoother than a
scanner's own. Needs numpy, scipy and pydicom.
"""
import pathlib
import sys

import numpy as np
import pydicom
import pydicom.uid
import scipy.ndimage


def main(source, target, count=600):
    slices = [pydicom.dcmread(path) for path in sorted(pathlib.Path(source).iterdir())]
    slices.sort(key=lambda one: float(one.ImagePositionPatient[2]))
    stack = np.stack([one.pixel_array for one in slices]).astype(np.float32)
    ends = [np.array(one.ImagePositionPatient, float) for one in (slices[0], slices[-1])]
    places = np.linspace(0, len(slices) - 1, count)
    fine = np.empty((count, *stack.shape[1:]), stack.dtype)
    for y in range(stack.shape[1]):
        rows = scipy.ndimage.spline_filter1d(stack[:, y], axis=0)
        at = np.meshgrid(places, np.arange(stack.shape[2]), indexing="ij")
        fine[:, y] = scipy.ndimage.map_coordinates(rows, at, order=3, prefilter=False, mode="nearest")
    target = pathlib.Path(target)
    target.mkdir(parents=True)
    template = slices[0]
    low, high = stack.min(), stack.max()
    template.SeriesInstanceUID = pydicom.uid.generate_uid()
    template.file_meta.TransferSyntaxUID = pydicom.uid.ExplicitVRLittleEndian
    template.SliceThickness = format(abs(ends[1][2] - ends[0][2]) / (count - 1), ".6g")
    for i, pixels in enumerate(fine):
        template.SOPInstanceUID = template.file_meta.MediaStorageSOPInstanceUID = pydicom.uid.generate_uid()
        template.InstanceNumber = i + 1
        template.ImagePositionPatient = [format(v, ".10g") for v in ends[0] + (ends[1] - ends[0]) * i / (count - 1)]
        template.PixelData = np.rint(np.clip(pixels, low, high)).astype(slices[0].pixel_array.dtype).tobytes()
        template.save_as(target / f"{i:04}.dcm")


if __name__ == "__main__":
    main(*sys.argv[1:3], *map(int, sys.argv[3:4]))
