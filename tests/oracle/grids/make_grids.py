#!/usr/bin/env python3
"""Makes files/ and grids.json: small volume files, written by SimpleITK, nibabel and pynrrd, and what SimpleITK reads in
them. Made with SimpleITK 2.5, nibabel 5.4 and pynrrd 1.1:

    python3 -m pip install SimpleITK nibabel pynrrd && python3 make_grids.py

Each file holds the grid of 5 x 4 x 3 voxels, turned about all axes; its spacing differs in every direction, and no two
values are alike. For each one grids.json has the map from voxels to the patient (LPS, mm; by rows) and the values, x
fastest. A reader that swaps axes, spacings, bytes or sides gives other numbers."""
import json
import pathlib

import nibabel
import nrrd
import numpy as np
import SimpleITK as sitk

HERE = pathlib.Path(__file__).parent
SPACING = np.array([0.7, 0.9, 2.5])
ORIGIN = np.array([-31.5, 12.25, 140.0])


def turned():
    """A rotation about all three axes."""
    (a, b, c) = (0.3, -0.2, 0.5)
    about_x = [[1, 0, 0], [0, np.cos(a), -np.sin(a)], [0, np.sin(a), np.cos(a)]]
    about_y = [[np.cos(b), 0, np.sin(b)], [0, 1, 0], [-np.sin(b), 0, np.cos(b)]]
    about_z = [[np.cos(c), -np.sin(c), 0], [np.sin(c), np.cos(c), 0], [0, 0, 1]]
    return np.array(about_z) @ about_y @ about_x


def values(kind):
    """Values by index (i, j, k): -1000 to 1020, or from 0 on where there are none below."""
    (i, j, k) = np.meshgrid(range(5), range(4), range(3), indexing="ij")
    hu = 7 * i + 90 * j + 800 * k - 1000
    return (hu + 1024 if np.issubdtype(kind, np.unsignedinteger) else hu).astype(kind)


def image(kind, mirrored=False):
    made = sitk.GetImageFromArray(values(kind).transpose())
    made.SetSpacing(SPACING.tolist())
    made.SetOrigin(ORIGIN.tolist())
    made.SetDirection((turned() @ np.diag([1, 1, -1 if mirrored else 1])).flatten().tolist())
    return made


def write_itk(folder):
    for (name, kind, packed) in (("itk.nii", np.int16, False), ("itk_packed.nii.gz", np.float32, True),
                                 ("itk_raw.nrrd", np.int32, False), ("itk.nrrd", np.int16, True),
                                 ("itk_beside.nhdr", np.float64, False), ("itk.mha", np.int16, True),
                                 ("itk_raw.mha", np.int8, False), ("itk.mhd", np.int16, False),
                                 ("itk_packed.mhd", np.float32, True)):
        if kind == np.int8:
            small = sitk.GetImageFromArray((values(np.int16) // 16).astype(np.int8).transpose())
            small.CopyInformation(image(np.int16))
            sitk.WriteImage(small, str(folder / name), packed)
        else:
            sitk.WriteImage(image(kind), str(folder / name), packed)
    sitk.WriteImage(image(np.int16, mirrored=True), str(folder / "itk_mirrored.mha"), True)


def write_nibabel(folder):
    ras = np.diag([-1, -1, 1, 1]) @ np.vstack([np.column_stack([turned() * SPACING, ORIGIN]), [0, 0, 0, 1]])
    mirrored = ras @ np.diag([-1, 1, 1, 1])

    def write(name, made, sform, qform, affine):
        made.header.set_xyzt_units("mm")
        made.set_sform(affine if sform else None, 1 if sform else 0)
        made.set_qform(affine if qform else None, 1 if qform else 0)
        nibabel.save(made, folder / name)

    write("sform.nii.gz", nibabel.Nifti1Image(values(np.int16), ras), True, False, ras)
    write("qform.nii", nibabel.Nifti1Image(values(np.uint16), ras), False, True, ras)
    write("qform_mirrored.nii.gz", nibabel.Nifti1Image(values(np.int16), mirrored), False, True, mirrored)
    write("second.nii.gz", nibabel.Nifti2Image(values(np.float64), ras), True, True, ras)
    big = nibabel.Nifti1Image(values(np.int16), ras, nibabel.Nifti1Header(endianness=">"))
    write("big.nii", big, True, True, ras)
    scaled = nibabel.Nifti1Image(values(np.int16), ras)
    scaled.header.set_slope_inter(0.5, -24)
    write("scaled.nii", scaled, True, True, ras)


def write_nrrd(folder):
    for (name, space, signs, kind, endian) in (("ras.nrrd", "right-anterior-superior", [-1, -1, 1], "int16", "little"),
                                               ("las.nrrd", "left-anterior-superior", [1, -1, 1], "uint16", "big")):
        steps = (turned() * SPACING).transpose() * signs
        data = values(np.dtype(kind)).astype(np.dtype(kind).newbyteorder("<" if endian == "little" else ">"))
        nrrd.write(str(folder / name), data, {"space": space, "space directions": steps, "endian": endian,
                                              "space origin": ORIGIN * signs, "encoding": "gzip"})


def facts(path):
    """What SimpleITK reads, or nibabel in the one format that SimpleITK does not know."""
    if path.name == "second.nii.gz":
        read = nibabel.load(path)
        return {"size": read.shape, "patientFromIndex": (np.diag([-1, -1, 1, 1]) @ read.affine)[:3].round(9).tolist(),
                "values": read.get_fdata().transpose().flatten().tolist()}
    read = sitk.ReadImage(str(path))
    steps = np.array(read.GetDirection()).reshape(3, 3) * np.array(read.GetSpacing())
    return {"size": read.GetSize(), "patientFromIndex": np.column_stack([steps, read.GetOrigin()]).round(9).tolist(),
            "values": sitk.GetArrayFromImage(read).astype(float).flatten().round(6).tolist()}


def main():
    folder = HERE / "files"
    folder.mkdir(exist_ok=True)
    write_itk(folder)
    write_nibabel(folder)
    write_nrrd(folder)
    names = sorted(path.name for path in folder.iterdir() if ".raw" not in path.name and ".zraw" not in path.name)
    lines = [f"{json.dumps(name)}: {json.dumps(facts(folder / name))}" for name in names]
    (HERE / "grids.json").write_text("{\n" + ",\n".join(lines) + "\n}\n", encoding="utf-8")


if __name__ == "__main__":
    main()
