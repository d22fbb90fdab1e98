"""Makers of classes: each returns a function that writes a class to an empty folder, and returns what must be read."""
import subprocess

import numpy as np
import pydicom
import pydicom.uid

from class_stack import COLUMNS, COUNT, GAP, ROWS, Stack, phantom


def changed(change, **others):
    """A class whose slices are changed, with what else is expected of it."""
    def write(folder):
        stack = Stack(folder)
        stack.change = change
        return [stack.write().expected(**others)]
    return write


def turned(row, column, digits=9, **others):
    """A class of another orientation, which the files state with so many digits."""
    def write(folder):
        stack = Stack(folder, row, column)
        stated = [round(number, digits) for number in (*row, *column)]
        stack.change = lambda data, k: setattr(data, "ImageOrientationPatient", stated)
        return [stack.write().expected(**others)]
    return write


def moved(place, **others):
    """A class whose slice k lies at place(k) instead of k * GAP [mm], sideways and along the normal."""
    def write(folder):
        stack = Stack(folder)
        stack.place = lambda k: stack.origin + np.array(place(k))
        return [stack.write().expected(**others)]
    return write


def coded(command, lossy=0.0, eight=False, **others):
    """A class that a program of DCMTK codes."""
    def write(folder):
        raw = folder.parent / "raw"
        raw.mkdir()
        stack = Stack(raw, pixels=phantom() >> 4 if eight else None)
        if eight:
            stack.change = lambda data, k: eight_bits(data, stack.pixels[k])
        stack.write()
        for file in raw.iterdir():
            subprocess.run([*command, file, folder / file.name], check=True, stderr=subprocess.DEVNULL)
        return [stack.expected(lossy=lossy, note="loss" if lossy else "", **others)]
    return write


def eight_bits(data, pixels):
    data.BitsAllocated, data.BitsStored, data.HighBit = 8, 8, 7
    data.PixelData = pixels.astype(np.uint8).tobytes()


def jpeg2000(syntax, lossy=0.0, **how):
    def write(folder):
        stack = Stack(folder)
        for k in range(COUNT):
            data = stack.data(k)
            data.compress(syntax, generate_instance_uid=False, **how)
            data.save_as(stack.name(k), enforce_file_format=True)
        return [stack.expected(lossy=lossy, note="loss" if lossy else "")]
    return write


def mixed_in(others):
    """A class with other objects among the slices, which must be listed apart."""
    def write(folder):
        stack = Stack(folder).write()
        others(stack)
        return [stack.expected()]
    return write


def scout(stack):
    data = stack.data(0)
    data.ImageType = ["ORIGINAL", "PRIMARY", "LOCALIZER"]
    data.ImageOrientationPatient = [1, 0, 0, 0, 0, -1]
    data.save_as(stack.folder / "scout", enforce_file_format=True)


def summary(stack):
    data = stack.data(0)
    data.SamplesPerPixel, data.PhotometricInterpretation, data.PlanarConfiguration = 3, "RGB", 0
    data.BitsAllocated, data.BitsStored, data.HighBit = 8, 8, 7
    data.PixelData = bytes(3 * ROWS * COLUMNS)
    data.save_as(stack.folder / "summary", enforce_file_format=True)


def structures(stack):
    data = stack.data(0)
    data.SOPClassUID = data.file_meta.MediaStorageSOPClassUID = pydicom.uid.RTStructureSetStorage
    data.Modality = "RTSTRUCT"
    del data.PixelData
    data.save_as(stack.folder / "structures", enforce_file_format=True)


def links(stack):
    for k in range(3):
        (stack.folder / f"link{k}").symlink_to(stack.name(k))
    (stack.folder / "loop").symlink_to(stack.folder)


def phases(count, tag, values):
    """A class of `count` volumes in one series, told apart by the values of an element."""
    def write(folder):
        expected, uid = [], pydicom.uid.generate_uid()
        for phase in range(count):
            inner = folder / str(phase)
            inner.mkdir()
            stack = Stack(inner, pixels=phantom(phase))
            stack.uid = uid
            stack.change = lambda data, k, phase=phase: setattr(data, tag, values[phase])
            expected.append(stack.write().expected())
        return expected
    return write


def diffusion(folder):
    expected, uid = [], pydicom.uid.generate_uid()
    for phase, (b_value, along) in enumerate([(0.0, None), (1000.0, [0.0, 0.6, 0.8]), (1000.0, [1.0, 0.0, 0.0])]):
        inner = folder / str(phase)
        inner.mkdir()
        stack = Stack(inner, pixels=phantom(phase))
        stack.uid, stack.intercept = uid, 0

        def change(data, k, b_value=b_value, along=along):
            data.Modality, data.SOPClassUID, data.DiffusionBValue = "MR", pydicom.uid.MRImageStorage, b_value
            if along:
                data.DiffusionGradientOrientation = along
        stack.change = change
        expected.append(stack.write().expected(is_hu=False))
    return expected


def of_modality(name):
    def change(data, k):
        data.Modality = name
        if not name:
            del data.Modality
    return changed(change, is_hu=False)


def wide(pixels_of, element, bits, modality="CT"):
    """A class of pixels of 32 or 64 bits, which `element` holds. None may lie in the middle of the range, between two
    steps."""
    def write(folder):
        stack = Stack(folder)
        stack.slope, stack.intercept = 1, 0
        numbers = pixels_of(stack.pixels)

        def change(data, k):
            data.Modality = modality
            data.BitsAllocated = data.BitsStored = bits
            data.HighBit, data.PixelRepresentation = bits - 1, 1
            del data.PixelData
            setattr(data, element, numbers[k].tobytes())
        stack.change = change
        stack.write()
        is_hu = modality == "CT"
        return [stack.expected(values=numbers.astype(float), is_hu=is_hu, lossy=0.5 if is_hu else 0)]
    return write


def by_table(folder):
    stack = Stack(folder)
    table = (np.arange(4096) * 3 // 2).astype("<u2")

    def change(data, k):
        del data.RescaleSlope, data.RescaleIntercept
        lut = pydicom.Dataset()
        lut.add_new(0x00283002, "US", [4096, 0, 16])
        lut.ModalityLUTType = "US"
        lut.add_new(0x00283006, "OW", table.tobytes())
        data.ModalityLUTSequence = [lut]
    stack.change = change
    return [stack.write().expected(values=table[stack.pixels].astype(float), is_hu=False)]


def refused(change=None, place=None, slices=range(COUNT), resampled=False):
    """A class that must not load, or only resampled: what is read of it then is not compared."""
    def write(folder):
        stack = Stack(folder)
        if change:
            stack.change = change
        if place:
            stack.place = lambda k: stack.origin + np.array(place(k))
        expected = stack.write(slices).expected(resampled=True)
        return [expected] if resampled else None
    return write


def tilted(folder):
    stack = Stack(folder)
    stack.step = np.array([0, GAP * np.tan(np.radians(10)), GAP])
    return [stack.write().expected(note="tilted by 10")]


def clipped(folder):
    stack = Stack(folder)
    stack.slope = 20
    stack.write()
    return [stack.expected(values=np.minimum(stack.pixels * 20.0 - 1024, 32767), note="beyond what 16 bits hold")]


def last_missing(folder):
    stack = Stack(folder)
    stack.change = lambda data, k: setattr(data, "ImagesInAcquisition", COUNT)
    return [stack.write(range(COUNT - 1)).expected(values=stack.pixels[:-1] - 1024.0, note="may be missing")]


def jitter(amount, axis):
    offsets = np.random.default_rng(5).uniform(-amount, amount, COUNT)
    offsets[0] = 0

    def place(k):
        where = [0, 0, k * GAP]
        where[axis] += offsets[k]
        return where
    return place


def rounded_places(gap):
    return lambda k: [0, 0, round(k * gap + 1e-9, 1)]


def set_all(**elements):
    def change(data, k):
        for name, value in elements.items():
            setattr(data, name, value(k) if callable(value) else value)
    return change


def with_overlay(data, k):
    pixels = np.frombuffer(data.PixelData, "<u2") | 0x8000
    data.PixelData = pixels.tobytes()


def negative(folder):
    stack = Stack(folder)
    stack.slope, stack.intercept = -1, 3071
    return [stack.write().expected()]


def eight(folder):
    stack = Stack(folder, pixels=phantom() >> 4)
    stack.change = lambda data, k: eight_bits(data, stack.pixels[k])
    return [stack.write().expected()]
