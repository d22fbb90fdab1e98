#!/usr/bin/env python3
"""How long large series of two codings take, and how much memory, against the limits that were set for them.

large_series.py DATA [--build build/release] [--rounds 3] [--work FOLDER]
DATA holds the folders j2k_short_stream and chest_contrast of the shared scans. From the first, 749 slices of JPEG 2000
are made, as many as the series has that they come from; from the second, one file of 1,000 frames, as long as the
patient. Both are read by `pdrender-cli info --times`; the lines say how the medians compare with the limits, and how
much processor time that took, which a busy machine changes less. Needs pydicom."""
import argparse
import multiprocessing
import pathlib
import statistics
import sys
import tempfile

import pydicom
import pydicom.uid

import reading

SLICES, FRAMES = 749, 1000


def stacked(folder):
    slices = [pydicom.dcmread(file) for file in folder.iterdir() if file.is_file()]
    return sorted(slices, key=lambda one: float(one.ImagePositionPatient[2]))


def gap(slices):
    return float(slices[1].ImagePositionPatient[2]) - float(slices[0].ImagePositionPatient[2])


def make_like_slices(source, target):
    """Writes SLICES slices, the pixels of `source` again and again, each in a place of its own."""
    slices = stacked(source)
    target.mkdir(parents=True)
    start, step = [float(number) for number in slices[0].ImagePositionPatient], gap(slices)
    uid = pydicom.uid.generate_uid()
    for i in range(SLICES):
        one = slices[i % len(slices)]
        one.SeriesInstanceUID, one.InstanceNumber = uid, i + 1
        one.SOPInstanceUID = one.file_meta.MediaStorageSOPInstanceUID = f"1.2.3.{i + 1}"
        one.ImagePositionPatient = [*start[:2], format(start[2] + i * step, ".9g")]
        one.save_as(target / f"{i:04}.dcm")


def item(**elements):
    one = pydicom.Dataset()
    for name, value in elements.items():
        setattr(one, name, value)
    return one


def make_frames(source, target):
    """Writes a file of FRAMES frames, the slices of `source` again and again."""
    slices = stacked(source)
    target.mkdir(parents=True)
    image, step = slices[0], gap(slices) * len(slices) / FRAMES
    start = [float(number) for number in image.ImagePositionPatient]
    pixels = [one.PixelData for one in slices]
    image.SharedFunctionalGroupsSequence = [item(
        PlaneOrientationSequence=[item(ImageOrientationPatient=image.ImageOrientationPatient)],
        PixelMeasuresSequence=[item(PixelSpacing=image.PixelSpacing)],
        PixelValueTransformationSequence=[item(RescaleSlope=image.RescaleSlope, RescaleType="HU",
                                               RescaleIntercept=image.RescaleIntercept)])]
    image.PerFrameFunctionalGroupsSequence = [item(
        PlanePositionSequence=[item(ImagePositionPatient=[*start[:2], format(start[2] + k * step, ".9g")])],
        FrameContentSequence=[item(StackID="1", InStackPositionNumber=k + 1)]) for k in range(FRAMES)]
    for name in ("ImagePositionPatient", "ImageOrientationPatient", "PixelSpacing", "RescaleSlope", "RescaleIntercept"):
        delattr(image, name)
    image.SOPClassUID = image.file_meta.MediaStorageSOPClassUID = pydicom.uid.EnhancedCTImageStorage
    image.NumberOfFrames = FRAMES
    image.PixelData = b"".join(pixels[k % len(pixels)] for k in range(FRAMES))
    image.save_as(target / "frames.dcm")


def in_its_own_process(make, *arguments):
    """Calls make(): a program that is started counts the memory of this one as its own until then."""
    process = multiprocessing.Process(target=make, args=arguments)
    process.start()
    process.join()
    if process.exitcode:
        raise SystemExit(f"{make.__name__} failed")


def measured(options, folder):
    """Medians of the seconds until a folder is listed, and from there until its voxels are in memory, and of their
    processor seconds; the largest peak [MB] beyond the voxels and their flags."""
    rounds = []
    for _ in range(options.rounds + 1):
        printed, _, _, peak = reading.run([options.build / "bin/pdrender-cli", "info", "--json", "--times", folder])
        report = reading.json.loads(printed)
        series = max(report["series"], key=lambda one: one["slices"])
        count = series["size"][0] * series["size"][1] * series["size"][2]
        held = count * 2 / 2**20 + (count / 8 / 2**20 if series["paddingVoxels"] else 0)
        rounds.append((report["scanSeconds"], series["readSeconds"], report["scanProcessorSeconds"],
                       series["readProcessorSeconds"], peak - held))
    rounds = rounds[1:]  # the first one fills the cache of files
    return [statistics.median(one[i] for one in rounds) for i in range(4)] + [max(one[4] for one in rounds)]


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("data", type=pathlib.Path)
    parser.add_argument("--build", type=pathlib.Path, default=pathlib.Path("build/release"))
    parser.add_argument("--rounds", type=int, default=3)
    parser.add_argument("--work", type=pathlib.Path)
    options = parser.parse_args()
    with tempfile.TemporaryDirectory() as temporary:
        work = options.work or pathlib.Path(temporary)
        in_its_own_process(make_like_slices, options.data / "j2k_short_stream", work / "like")
        in_its_own_process(make_frames, options.data / "chest_contrast", work / "frames")
        like, frames = measured(options, work / "like"), measured(options, work / "frames")
    limits = [(f"{SLICES} slices of JPEG 2000, listed and read [s]", like[0] + like[1], 12, like[2] + like[3]),
              (f"{FRAMES} frames, listed [s]", frames[0], 0.3, frames[2]),
              (f"{FRAMES} frames, read [s]", frames[1], 2, frames[3])]
    for what, value, limit, processor in limits:
        verdict = "" if value <= limit else "OVER"
        print(f"{what:48} {value:7.2f} of {limit:4.1f}  {verdict:4}  processor {processor:.2f} s")
    print(f"{FRAMES} frames: at most {frames[4]:.0f} MB beyond voxels and flags, the search for the table included")
    return 1 if any(value > limit for _, value, limit, _ in limits) else 0


if __name__ == "__main__":
    sys.exit(main())
