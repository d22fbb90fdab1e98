#!/usr/bin/env python3
"""Makes files/ and labels.json: a small CT, label maps of it by highdicom, nibabel and SimpleITK, and the label
that each voxel of the scan has in them. Made with highdicom 0.28, pydicom 3.0, nibabel 5.4 and SimpleITK 2.5:

    python3 -m pip install highdicom nibabel SimpleITK && python3 make_labels.py

The scan has 7 x 5 x 4 voxels, turned about all axes: the bits of a frame do not end with a byte. Segment 2 is missing
in a slice and segment 3 in two, so that frames are left out."""
import json
import pathlib

import highdicom as hd
import nibabel
import numpy as np
import pydicom
import SimpleITK as sitk
from highdicom.seg import SegmentDescription, Segmentation
from pydicom.sr.codedict import codes

HERE = pathlib.Path(__file__).parent
FILES = HERE / "files"
SPACING = np.array([0.7, 0.9, 2.5])
ORIGIN = np.array([-31.5, 12.25, 140.0])
NAMES = {1: "Leber für alle", 2: "kidney", 3: "aorta"}
COLOURS = {1: (10, 120, 200), 2: (240, 220, 180), 3: (255, 0, 0)}


def turned():
    """A rotation about all three axes."""
    (a, b, c) = (0.3, -0.2, 0.5)
    about_x = [[1, 0, 0], [0, np.cos(a), -np.sin(a)], [0, np.sin(a), np.cos(a)]]
    about_y = [[np.cos(b), 0, np.sin(b)], [0, 1, 0], [-np.sin(b), 0, np.cos(b)]]
    about_z = [[np.cos(c), -np.sin(c), 0], [np.sin(c), np.cos(c), 0], [0, 0, 1]]
    return np.array(about_z) @ about_y @ about_x


def truth():
    """The label of voxel (k, j, i)."""
    (k, j, i) = np.meshgrid(range(4), range(5), range(7), indexing="ij")
    labels = (i + 2 * j + 3 * k + i * j) % 5 % 4
    labels[(labels == 2) & (k == 1)] = 0
    labels[(labels == 3) & ((k == 1) | (k == 2))] = 0
    return labels.astype(np.uint8)


def overlapping():
    """Three segments (k, j, i, n), of which smaller ones lie in larger ones."""
    labels = truth()
    return np.stack([labels >= 1, (labels >= 2) & (labels < 3) | (labels == 3), labels == 3], -1).astype(np.uint8)


def number(value):
    return f"{value:.10g}"


def slices():
    """The CT, a data set a slice."""
    turn = turned()
    made = []
    for k in range(4):
        data = pydicom.Dataset()
        data.file_meta = pydicom.dataset.FileMetaDataset()
        data.file_meta.TransferSyntaxUID = pydicom.uid.ExplicitVRLittleEndian
        data.file_meta.MediaStorageSOPClassUID = data.SOPClassUID = pydicom.uid.CTImageStorage
        data.file_meta.MediaStorageSOPInstanceUID = data.SOPInstanceUID = f"2.25.7.{k + 1}"
        (data.StudyInstanceUID, data.SeriesInstanceUID, data.FrameOfReferenceUID) = ("2.25.5", "2.25.6", "2.25.4")
        (data.PatientName, data.PatientID, data.PatientBirthDate, data.PatientSex) = ("Phantom^Labels", "L1", "", "O")
        (data.StudyDate, data.StudyTime, data.StudyID, data.AccessionNumber) = ("", "", "", "")
        (data.ReferringPhysicianName, data.PositionReferenceIndicator) = ("", "")
        (data.Modality, data.SeriesNumber, data.InstanceNumber) = ("CT", 1, k + 1)
        data.ImageType = ["ORIGINAL", "PRIMARY", "AXIAL"]
        data.ImagePositionPatient = [number(x) for x in ORIGIN + turn[:, 2] * SPACING[2] * k]
        data.ImageOrientationPatient = [number(x) for x in (*turn[:, 0], *turn[:, 1])]
        data.PixelSpacing = [number(SPACING[1]), number(SPACING[0])]
        (data.SliceThickness, data.RescaleSlope, data.RescaleIntercept) = (2.5, 1, 0)
        (data.Rows, data.Columns, data.SamplesPerPixel, data.PhotometricInterpretation) = (5, 7, 1, "MONOCHROME2")
        (data.BitsAllocated, data.BitsStored, data.HighBit, data.PixelRepresentation) = (16, 16, 15, 1)
        data.PixelData = (np.arange(35, dtype=np.int16) * 7 - 1000 + k).tobytes()
        made.append(data)
    return made


def described(numbers):
    return [SegmentDescription(
        segment_number=place + 1, segment_label=NAMES[n], segmented_property_category=codes.SCT.Tissue,
        segmented_property_type=codes.SCT.Bone, algorithm_type="MANUAL",
        display_color=hd.color.CIELabColor.from_rgb(*COLOURS[n])) for (place, n) in enumerate(numbers)]


def write_segmentation(name, sources, pixels, kind, numbers, coding=pydicom.uid.ExplicitVRLittleEndian):
    made = Segmentation(
        source_images=sources, pixel_array=pixels, segmentation_type=kind, segment_descriptions=described(numbers),
        series_instance_uid="2.25.8", series_number=2, sop_instance_uid="2.25.9", instance_number=1,
        manufacturer="none", manufacturer_model_name="none", software_versions="1", device_serial_number="1",
        transfer_syntax_uid=coding)
    made.SpecificCharacterSet = "ISO_IR 192"
    made.save_as(FILES / name)


def write_segmentations():
    (FILES / "ct").mkdir(parents=True, exist_ok=True)
    sources = slices()
    for (k, data) in enumerate(sources):
        data.save_as(FILES / "ct" / f"{k}.dcm", enforce_file_format=True)
    write_segmentation("binary.dcm", sources, truth(), "BINARY", [1, 2, 3])
    write_segmentation("overlapping.dcm", sources, overlapping(), "BINARY", [1, 2, 3])
    aorta = (truth() == 3).astype(float)
    write_segmentation("fraction.dcm", sources, 0.6 * aorta + 0.4 * (truth() == 1), "FRACTIONAL", [3])
    write_segmentation("fraction_rle.dcm", sources, 0.6 * aorta, "FRACTIONAL", [3], pydicom.uid.RLELossless)
    write_segmentation("label_map.dcm", sources, truth(), "LABELMAP", [1, 2, 3])
    deflated = pydicom.dcmread(FILES / "binary.dcm")
    deflated.file_meta.TransferSyntaxUID = pydicom.uid.DeflatedExplicitVRLittleEndian
    deflated.save_as(FILES / "deflated.dcm")


def caret_table():
    """The extension of TotalSegmentator's files."""
    rows = "".join(
        f'<Label Key="{n + 4}" Red="{r / 255}" Green="{g / 255}" Blue="{b / 255}" Alpha="1">'
        f'<![CDATA[{NAMES[n]}]]></Label>\n'
        for (n, (r, g, b)) in COLOURS.items())
    return nibabel.nifti1.Nifti1Extension(0, (
        '<?xml version="1.0" encoding="UTF-8"?> <CaretExtension>  <Date><![CDATA[2013-07-14T05:45:09]]></Date>\n'
        f'<VolumeInformation Index="0">   <LabelTable>\n{rows}</LabelTable>  <StudyMetaDataLinkSet>\n'
        '</StudyMetaDataLinkSet>  <VolumeType><![CDATA[Label]]></VolumeType>   </VolumeInformation></CaretExtension>'
        ).encode())


def placed(labels):
    made = sitk.GetImageFromArray(labels)
    made.SetSpacing(SPACING.tolist())
    made.SetOrigin(ORIGIN.tolist())
    made.SetDirection(turned().flatten().tolist())
    return made


def write_volumes():
    labels = truth().transpose()  # by (i, j, k)
    lps = np.vstack([np.column_stack([turned() * SPACING, ORIGIN]), [0, 0, 0, 1]])
    ras = np.diag([-1, -1, 1, 1]) @ lps
    moved = np.where(labels > 0, labels + 4, 0).astype(np.uint8)
    made = nibabel.Nifti1Image(moved, ras)
    made.header.extensions.append(caret_table())
    nibabel.save(nibabel.as_closest_canonical(made), FILES / "canonical.nii.gz")
    segmented = placed(truth())
    for (place, n) in enumerate((3, 1, 2)):
        for (field, value) in (("ID", f"Segment_{n}"), ("Name", NAMES[n]), ("LabelValue", str(n)), ("Layer", "0"),
                               ("Color", " ".join(str(c / 255) for c in COLOURS[n]))):
            segmented.SetMetaData(f"Segment{place}_{field}", value)
    sitk.WriteImage(segmented, str(FILES / "slicer.seg.nrrd"), True)
    sitk.WriteImage(placed(truth())[1:6, 0:4, 1:4], str(FILES / "cropped.mha"), True)


def main():
    write_segmentations()
    write_volumes()
    named = {"names": list(NAMES.values()), "colours": ["#%02x%02x%02x" % c for c in COLOURS.values()]}
    plain = {"labels": truth().flatten().tolist(), **named}
    aorta = {"labels": (truth() == 3).astype(int).flatten().tolist(), "names": [NAMES[3]], "colours": ["#ff0000"]}
    inside = np.zeros_like(truth())
    inside[1:4, 0:4, 1:6] = truth()[1:4, 0:4, 1:6]
    cropped = {"labels": inside.flatten().tolist(), "names": ["part 1", "part 2", "part 3"]}
    facts = {"binary.dcm": plain, "overlapping.dcm": plain, "deflated.dcm": plain, "label_map.dcm": plain,
             "fraction.dcm": aorta, "fraction_rle.dcm": aorta, "canonical.nii.gz": plain, "slicer.seg.nrrd": plain,
             "cropped.mha": cropped}
    lines = [f"{json.dumps(name)}: {json.dumps(fact)}" for (name, fact) in facts.items()]
    (HERE / "labels.json").write_text("{\n" + ",\n".join(lines) + "\n}\n", encoding="utf-8")


if __name__ == "__main__":
    main()
