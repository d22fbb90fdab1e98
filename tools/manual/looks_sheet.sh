#!/usr/bin/env bash
# One sheet of all looks, each as it was before parts, studio and light from outside edges, and as it is, for the manual.
#   tools/manual/looks_sheet.sh CHEST LABELS [OUT.jpg]
# CHEST: a folder of DICOM files of a chest with contrast. LABELS: a label map of it, for Organs in colour. The scan without
# contrast is the example's head. SAMPLES (256) may be set. Needs ./bootstrap build, the example's voxels and ImageMagick.
set -euo pipefail

cd "$(dirname "${BASH_SOURCE[0]}")/../.."
export LABELS
chest=${1:?a folder of DICOM files of a chest with contrast} LABELS=${2:?a label map of it}
out=${3:-resources/manual/pictures/looks-before-and-now.jpg}
before=7534679e^
export SIZE=150x116 COLUMNS=8 POINTSIZE=8 QUALITY=96 SAMPLES=${SAMPLES:-256}
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
build/release/bin/pdrender-cli example "$scratch/head" --cranium build/example/matrix.dat >/dev/null 2>&1

tools/manual/looks_compared.sh "$before" "$chest" "$scratch/chest.png" bones_alone bone_beside_contrast heart muscles organs vessels \
    vessels_and_bone lung_vessels mip_lungs mip xray implants skin_and_bone skin bones_and_vessels bones_vessels_and_muscle \
    vessels_in_ghost organs_in_colour implant_over_ghost
tools/manual/looks_compared.sh "$before" "$scratch/head" "$scratch/head.png" bone thin_bone muscles_and_skull fluoroscopy mip xray \
    skin_and_bone skin skull_and_mirror
convert "$scratch/chest.png" "$scratch/head.png" -background '#202020' -append -strip -quality 82 "$out"
