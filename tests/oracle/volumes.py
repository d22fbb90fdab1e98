"""The volumes of the oracles, made without a line of the program: SimpleITK images of float64 HU.

made_volume   small, by a rule in whole numbers, its axes turned against the patient's; tests/support/scenes/made_volume.h
sheared       the same voxels, each slice 0.7 mm farther along the columns than the one before: a tilted gantry
chest         the shared CT of a chest with contrast, read by pydicom; padding (below -1024 HU) is -1024 HU
tilted_head   the shared CT of a head whose gantry was tilted by 18.5 degrees, read by pydicom
"""
import glob
import os

import numpy as np
import pydicom
import SimpleITK as sitk

MADE_SIZE = (23, 19, 17)
MADE_SPACING = (0.75, 0.875, 2.125)
MADE_ORIGIN = (-31.5, 12.25, 104.75)
# The rotation of the quaternion (5, 1, 2, 3): every entry is a whole number of 39ths.
MADE_DIRECTION = np.array([[13, -26, 26], [34, 19, 2], [-14, 22, 29]]) / 39


def made_volume():
    k, j, i = np.meshgrid(*[np.arange(n, dtype=np.int64) for n in reversed(MADE_SIZE)], indexing="ij")
    hu = (i * 7919 + j * 104729 + k * 1299709 + i * j * k * 31) % 4001 - 1000
    image = sitk.GetImageFromArray(hu.astype(np.float64))
    image.SetSpacing(MADE_SPACING)
    image.SetOrigin(MADE_ORIGIN)
    image.SetDirection(MADE_DIRECTION.ravel().tolist())
    return image


def sheared_volume():
    image = made_volume()
    step = MADE_DIRECTION[:, 2] * MADE_SPACING[2] + MADE_DIRECTION[:, 1] * 0.7
    return on_grid(image, MADE_DIRECTION[:, 0], MADE_DIRECTION[:, 1], step)


def on_grid(image, row, column, step):
    """The image on unit vectors along rows and columns, and the step from slice to slice [mm]."""
    length = float(np.linalg.norm(step))
    image.SetSpacing((*image.GetSpacing()[:2], length))
    image.SetDirection(np.stack([row, column, np.array(step) / length], 1).ravel().tolist())
    return image


def shared_folder():
    beside = os.path.join(os.path.dirname(__file__), "..", "..", "..", "shared")
    return os.environ.get("PDR_SHARED", os.path.normpath(beside))


def chest_folder():
    return os.path.join(shared_folder(), "data", "ct", "chest_contrast")


def chest():
    """The chest; None where the shared data is not there."""
    files = [pydicom.dcmread(name) for name in glob.glob(os.path.join(chest_folder(), "*.dcm"))]
    if not files:
        return None
    files.sort(key=lambda each: float(each.ImagePositionPatient[2]))
    stored = np.stack([each.pixel_array.astype(np.float64) for each in files])
    hu = np.maximum(stored * float(files[0].RescaleSlope) + float(files[0].RescaleIntercept), -1024)
    first, last = (np.array([float(x) for x in each.ImagePositionPatient]) for each in (files[0], files[-1]))
    image = sitk.GetImageFromArray(hu)
    rows, columns = (float(x) for x in files[0].PixelSpacing)
    image.SetSpacing((columns, rows, (last - first)[2] / (len(files) - 1)))
    image.SetOrigin(first.tolist())
    return image


def tilted_head_folder():
    return os.path.join(shared_folder(), "data", "ct", "mixed_study_tilt")


def tilted_head():
    """The head; None where the shared data is not there. Slices are sorted along their normal."""
    files = [pydicom.dcmread(name) for name in glob.glob(os.path.join(tilted_head_folder(), "S2010", "*"))]
    if not files:
        return None
    axes = np.array([float(x) for x in files[0].ImageOrientationPatient]).reshape(2, 3)
    place = lambda each: np.array([float(x) for x in each.ImagePositionPatient])
    files.sort(key=lambda each: np.dot(place(each), np.cross(*axes)))
    image = sitk.GetImageFromArray(np.stack([
        each.pixel_array * float(each.RescaleSlope) + float(each.RescaleIntercept) for each in files]).astype(float))
    rows, columns = (float(x) for x in files[0].PixelSpacing)
    image.SetSpacing((columns, rows, 1))
    image.SetOrigin(place(files[0]).tolist())
    return on_grid(image, *axes, (place(files[-1]) - place(files[0])) / (len(files) - 1))


def patient_from_index(image):
    """The three steps between voxels and the centre of the first voxel, as 4 x 3 numbers [mm]."""
    steps = np.array(image.GetDirection()).reshape(3, 3) * np.array(image.GetSpacing())
    return np.vstack([steps.T, image.GetOrigin()])


def places_in(image, count, random):
    """Places [mm] all over the box of the voxels, halves of the outermost voxels included."""
    size = np.array(image.GetSize())
    index = random.uniform(-0.5 + 1e-3, size - 0.5 - 1e-3, (count, 3))
    return index @ patient_from_index(image)[:3] + patient_from_index(image)[3]


def oblique_plane(image, pixels, mm_per_pixel, random):
    """A plane of random direction through the volume's middle region: the first pixel's centre, right and down."""
    across = np.linalg.qr(random.normal(size=(3, 3)))[0]
    right, down = across[0], across[1]
    middle = np.array(image.TransformContinuousIndexToPhysicalPoint((np.array(image.GetSize()) - 1) / 2))
    middle = middle + random.uniform(-5, 5, 3)
    first = middle - (right * (pixels[0] - 1) + down * (pixels[1] - 1)) * mm_per_pixel / 2
    return {"originMm": first.tolist(), "right": right.tolist(), "down": down.tolist(), "mmPerPixel": mm_per_pixel,
            "size": list(pixels)}


def resliced(image, plane):
    """The HU of a plane by SimpleITK's linear interpolation, rows from the top; NaN where the volume does not reach."""
    right, down = np.array(plane["right"]), np.array(plane["down"])
    grid = sitk.ResampleImageFilter()
    grid.SetInterpolator(sitk.sitkLinear)
    grid.SetDefaultPixelValue(np.nan)
    grid.SetOutputOrigin(plane["originMm"])
    grid.SetOutputDirection(np.stack([right, down, np.cross(right, down)], 1).ravel().tolist())
    grid.SetOutputSpacing((plane["mmPerPixel"], plane["mmPerPixel"], 1.0))
    grid.SetSize((*plane["size"], 1))
    return sitk.GetArrayFromImage(grid.Execute(image))[0]
