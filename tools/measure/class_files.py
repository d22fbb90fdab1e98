"""Makers of classes whose files have another form than one slice each: frames, archives, volume files."""
import copy
import gzip
import struct
import subprocess
import zipfile

import numpy as np
import pydicom
import pydicom.filebase
import pydicom.uid

from class_stack import COLUMNS, COUNT, GAP, ROWS, SPACING, Stack

GE_BIG_ENDIAN = "1.2.840.113619.5.2"


def groups(stack, converted):
    """An image of all slices of `stack` as frames."""
    image = stack.data(0)
    for name in ("ImagePositionPatient", "ImageOrientationPatient", "PixelSpacing", "RescaleSlope", "RescaleIntercept"):
        delattr(image, name)
    image.SOPClassUID = (pydicom.uid.LegacyConvertedEnhancedCTImageStorage if converted else
                         pydicom.uid.EnhancedCTImageStorage)
    image.file_meta.MediaStorageSOPClassUID = image.SOPClassUID
    image.ImageType, image.NumberOfFrames = ["ORIGINAL", "PRIMARY", "VOLUME", "NONE"], COUNT
    image.PixelData = stack.pixels.astype("<u2").tobytes()

    def item(**elements):
        one = pydicom.Dataset()
        for name, value in elements.items():
            setattr(one, name, value)
        return one
    image.SharedFunctionalGroupsSequence = [item(
        PlaneOrientationSequence=[item(ImageOrientationPatient=[*stack.row, *stack.column])],
        PixelMeasuresSequence=[item(PixelSpacing=list(SPACING))],
        PixelValueTransformationSequence=[item(RescaleSlope=stack.slope, RescaleIntercept=stack.intercept,
                                               RescaleType="HU")])]
    image.PerFrameFunctionalGroupsSequence = [
        item(PlanePositionSequence=[item(ImagePositionPatient=[round(v, 6) for v in stack.place(k)])],
             **({"UnassignedPerFrameConvertedAttributesSequence": [item(AcquisitionNumber=1)]} if converted else
                {"FrameContentSequence": [item(StackID="1", TemporalPositionIndex=1)]})) for k in range(COUNT)]
    return image


def enhanced(command=None, converted=False):
    def write(folder):
        stack = Stack(folder)
        file = folder / "frames"
        groups(stack, converted).save_as(file, enforce_file_format=True)
        if command:
            subprocess.run([*command, file, folder.parent / "coded"], check=True, stderr=subprocess.DEVNULL)
            (folder.parent / "coded").rename(file)
        return [stack.expected()]
    return write


def ge_big_endian(folder):
    stack = Stack(folder)
    for k in range(COUNT):
        data = stack.data(k)
        data.PixelData = stack.pixels[k].astype(">u2").tobytes()
        data["PixelData"].VR = "OW"
        data.file_meta.TransferSyntaxUID = GE_BIG_ENDIAN
        buffer = pydicom.filebase.DicomBytesIO()
        meta = copy.deepcopy(data)
        meta.file_meta.TransferSyntaxUID = pydicom.uid.ImplicitVRLittleEndian
        pydicom.dcmwrite(buffer, meta, enforce_file_format=True)
        stated = bytes(pydicom.uid.ImplicitVRLittleEndian, "ascii") + b"\0"
        private = bytes(GE_BIG_ENDIAN, "ascii")
        whole = buffer.getvalue().replace(struct.pack("<2sH", b"UI", len(stated)) + stated,
                                          struct.pack("<2sH", b"UI", len(private)) + private, 1)
        # The length of group 2 grows by the difference
        length = struct.unpack_from("<I", whole, 140)[0] + len(private) - len(stated)
        stack.name(k).write_bytes(whole[:140] + struct.pack("<I", length) + whole[144:])
    return [stack.expected()]


def archive(folder):
    inner = folder.parent / "inner"
    inner.mkdir()
    stack = Stack(inner).write()
    with zipfile.ZipFile(folder / "series.zip", "w", zipfile.ZIP_DEFLATED) as packed:
        for file in inner.iterdir():
            packed.write(file, f"a/{file.name}")
    return [stack.expected()]


def packed_files(folder):
    stack = Stack(folder).write()
    for file in list(folder.iterdir()):
        (folder / (file.name + ".gz")).write_bytes(gzip.compress(file.read_bytes()))
        file.unlink()
    return [stack.expected()]


def volume_file(name):
    """A NIfTI, NRRD or MetaImage file, by the ending of its name."""
    def write(folder):
        stack = Stack(folder)
        values = stack.pixels.astype(np.int16) - 1024
        steps = np.column_stack([SPACING[1] * stack.row, SPACING[0] * stack.column, stack.step])
        numbers = lambda vector: ",".join(map(str, vector))
        file = folder / name
        if name.endswith(".nrrd"):
            head = ("NRRD0004\ntype: short\ndimension: 3\nspace: left-posterior-superior\n"
                    f"sizes: {COLUMNS} {ROWS} {COUNT}\nspace directions: " +
                    " ".join(f"({numbers(step)})" for step in steps.T) +
                    f"\nendian: little\nencoding: raw\nspace origin: ({numbers(stack.origin)})\n\n")
            file.write_bytes(head.encode() + values.astype("<i2").tobytes())
        elif name.endswith(".mha"):
            head = ("ObjectType = Image\nNDims = 3\nBinaryData = True\nBinaryDataByteOrderMSB = False\n"
                    "CompressedData = False\nTransformMatrix = 1 0 0 0 1 0 0 0 1\n"
                    f"Offset = {' '.join(map(str, stack.origin))}\nElementSpacing = {SPACING[1]} {SPACING[0]} {GAP}\n"
                    f"DimSize = {COLUMNS} {ROWS} {COUNT}\nElementType = MET_SHORT\nElementDataFile = LOCAL\n")
            file.write_bytes(head.encode() + values.astype("<i2").tobytes())
        else:
            head = bytearray(352)
            struct.pack_into("<i", head, 0, 348)
            struct.pack_into("<8h", head, 40, 3, COLUMNS, ROWS, COUNT, 1, 1, 1, 1)
            struct.pack_into("<2h", head, 70, 4, 16)
            struct.pack_into("<8f", head, 76, 1, SPACING[1], SPACING[0], GAP, 1, 1, 1, 1)
            struct.pack_into("<3f", head, 108, 352, 1, 0)
            head[123] = 2
            struct.pack_into("<2h", head, 252, 0, 1)
            ras = np.diag([-1, -1, 1]) @ np.column_stack([steps, stack.origin])
            struct.pack_into("<12f", head, 280, *ras.ravel())
            head[344:348] = b"n+1\0"
            file.write_bytes(bytes(head) + values.astype("<i2").tobytes())
        return [stack.expected(note="does not say that its values are HU")]
    return write


def without_meta(folder):
    stack = Stack(folder)
    for k in range(COUNT):
        data = stack.data(k)
        del data.file_meta
        with open(stack.name(k), "wb") as file:
            pydicom.dcmwrite(file, data, implicit_vr=True, little_endian=True, enforce_file_format=False)
    return [stack.expected()]


def directory(stack):
    """A DICOMDIR that names files which are not there."""
    data = stack.data(0)
    data.SOPClassUID = data.file_meta.MediaStorageSOPClassUID = pydicom.uid.MediaStorageDirectoryStorage
    del data.PixelData
    record = pydicom.Dataset()
    record.DirectoryRecordType, record.ReferencedFileID = "IMAGE", ["IMAGES", "ABSENT"]
    data.DirectoryRecordSequence = [record]
    data.save_as(stack.folder / "DICOMDIR", enforce_file_format=True)
