"""A series of 24 slices with known numbers in a known place, to be changed and written."""
import dataclasses

import numpy as np
import pydicom
import pydicom.dataset
import pydicom.uid

COUNT, ROWS, COLUMNS = 24, 40, 32
SPACING, GAP = (0.8, 0.7), 1.5  # between rows, between columns; between slices [mm]


@dataclasses.dataclass
class Expected:
    """One entry: its values, by slice, row and column, from the lowest slice along the normal on, and its grid."""
    values: np.ndarray
    origin: np.ndarray
    row: np.ndarray
    column: np.ndarray
    step: np.ndarray            # from each slice to the next [mm]
    spacing: tuple = SPACING
    is_hu: bool = True
    lossy: float = 0            # how far values may be off
    within: float = 1e-3        # how far places may be off [mm]
    note: str = ""              # what a note must say
    resampled: bool = False


def phantom(seed=0):
    """Numbers of twelve bits: a ball of tissue and bone with grain, in air."""
    z, y, x = np.mgrid[-1:1:COUNT * 1j, -1:1:ROWS * 1j, -1:1:COLUMNS * 1j]
    radius = np.sqrt(x * x + y * y + z * z)
    grain = np.random.default_rng(seed).normal(0, 12, radius.shape)
    numbers = np.where(radius < 0.5, 2000, np.where(radius < 0.9, 1060 + 40 * x, 24)) + grain
    return np.clip(numbers, 0, 4095).astype(np.uint16)


class Stack:
    """A series to be changed and written: `pixels` are stored numbers, HU are 1024 less."""

    def __init__(self, folder, row=(1, 0, 0), column=(0, 1, 0), pixels=None):
        self.folder = folder
        self.row, self.column = np.array(row, float), np.array(column, float)
        self.normal = np.cross(self.row, self.column)
        self.pixels = phantom() if pixels is None else pixels
        self.step = GAP * self.normal
        self.origin = np.array([-11.0, -16.0, 100.0])
        self.change = lambda data, k: None   # of each slice, before it is written
        self.slope, self.intercept = 1, -1024
        self.uid = pydicom.uid.generate_uid()
        self.stated = 9                      # digits of positions

    def data(self, k):
        """Slice k as a data set."""
        data = pydicom.Dataset()
        data.file_meta = pydicom.dataset.FileMetaDataset()
        data.file_meta.TransferSyntaxUID = pydicom.uid.ExplicitVRLittleEndian
        data.SOPClassUID = data.file_meta.MediaStorageSOPClassUID = pydicom.uid.CTImageStorage
        data.SOPInstanceUID = data.file_meta.MediaStorageSOPInstanceUID = pydicom.uid.generate_uid()
        data.StudyInstanceUID, data.SeriesInstanceUID, data.FrameOfReferenceUID = "1.2.3", self.uid, "1.2.3.4"
        data.PatientName, data.PatientID, data.Modality = "A^B", "1", "CT"
        data.ImageType = ["ORIGINAL", "PRIMARY", "AXIAL"]
        data.InstanceNumber, data.SeriesNumber = k + 1, 1
        data.Rows, data.Columns, data.SamplesPerPixel, data.PhotometricInterpretation = ROWS, COLUMNS, 1, "MONOCHROME2"
        data.BitsAllocated, data.BitsStored, data.HighBit, data.PixelRepresentation = 16, 12, 11, 0
        data.PixelSpacing = [str(number) for number in SPACING]
        data.ImageOrientationPatient = [format(number, ".9g") for number in (*self.row, *self.column)]
        data.ImagePositionPatient = [format(round(number, self.stated), ".9g") for number in self.place(k)]
        data.RescaleSlope, data.RescaleIntercept = str(self.slope), str(self.intercept)
        data.PixelData = self.pixels[k].astype("<u2").tobytes()
        self.change(data, k)
        return data

    def place(self, k):
        return self.origin + k * self.step

    def name(self, k):
        return self.folder / f"{(k * 7) % 100:02}{k:03}.dcm"  # not in the order of places

    def write(self, slices=range(COUNT)):
        for k in slices:
            self.data(k).save_as(self.name(k), enforce_file_format=True)
        return self

    def expected(self, **others):
        values = self.pixels * float(self.slope) + self.intercept
        return Expected(**{"values": values, "origin": self.origin, "row": self.row, "column": self.column,
                           "step": self.step, **others})
