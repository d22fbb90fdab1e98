#!/usr/bin/env bash
# Makes images of the README and the manual anew, each into resources/manual/pictures.
#   tools/manual/manual_pictures.sh CHEST PICTURE...
# CHEST: a folder of DICOM files of a chest with contrast. PICTURE: first looks-chest looks-parts looks-head looks-phantom models table;
# none: all of them, an hour on two cores. SAMPLES may be set; else 256 for `first`, 64. Those of the
# window: window_pictures.sh. Needs ./bootstrap build, the example's voxels and ImageMagick.
set -euo pipefail

cd "$(dirname "${BASH_SOURCE[0]}")/../.."
chest=$(realpath "${1:?a folder of DICOM files of a chest with contrast}")
shift
cli=$PWD/build/release/bin/pdrender-cli out=$PWD/resources/manual/pictures
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
"$cli" example "$scratch/head" --cranium build/example/matrix.dat >/dev/null 2>&1

# scene FOLDER EYE TARGET: seen from there [mm], its slices interpolated; the look brings the rest.
scene() {
    cat <<JSON
{ "format": "pdrender-scene", "version": 1, "volume": { "dicom": "$1", "table": "hidden", "reconstruction": "cubic" },
  "transferFunction": { "extinctionPerMm": 1, "nodes": [{ "hu": 0, "opacity": 0 }] },
  "camera": { "type": "perspective", "eyeMm": $2, "targetMm": $3, "up": [0, 0, 1], "fovDegrees": 35 },
  "film": { "width": 600, "height": 640 } }
JSON
}

first() {
    scene "$scratch/head" "[-167, -291, 44]" "[1, 0, -3]" >"$scratch/left.json"
    scene "$chest" "[-349, -597, 7]" "[-5, 0, -115]" >"$scratch/right.json"
    local side look
    for side in left right; do
        [ $side = left ] && look="Bone" || look="Vessels and bone"
        "$cli" render "$scratch/$side.json" -o "$scratch/$side.png" --annotations none --look "$look" --exposure auto --denoised \
            --samples "${SAMPLES:-256}" >/dev/null 2>&1
    done
    convert "$scratch/left.png" "$scratch/right.png" +append -fuzz 3% -trim -bordercolor black -border 16 -strip -quality 92 "$out/first.jpg"
}

looks-chest() {
    SAMPLES=${SAMPLES:-64} SIZE=420x280 COLUMNS=3 tools/manual/acceptance.sh "$chest" "$out/looks-chest.jpg" "Bones alone" "Vessels" \
        "Heart and great vessels" "Vessels and bone" "Bone beside contrast" "Muscles" "Organs" "Lung vessels" \
        "MIP of the lungs" "MIP" "X-ray" "Implants"
}

# parts NAME LOOK RULES FOLDER VIEW: one image under a look that shows parts.
parts() {
    "$cli" render "$4" -o "$scratch/$1.png" --annotations none --look "$2" --find "$3" --view "$5" --size 300x300 --exposure auto \
        --denoised --samples "${SAMPLES:-64}" >/dev/null 2>&1
}

looks-parts() {
    parts muscle "Bones, vessels and muscle" vessels,shells "$chest" anterior
    parts right "Skull with a defect and its mirror" mirror "$scratch/head" right
    parts front "Skull with a defect and its mirror" mirror "$scratch/head" anterior
    convert "$scratch/muscle.png" "$scratch/right.png" "$scratch/front.png" +append -strip -quality 88 "$out/looks-parts.jpg"
}

# heads FOLDER OUT.jpg
heads() {
    SAMPLES=${SAMPLES:-64} SIZE=300 tools/manual/acceptance.sh "$1" "$2" "Bone" "Thin bone" "Muscles and skull" "MIP" "X-ray" \
        "Fluoroscopy" "Skin over bone" "Skin"
}

looks-head() {
    heads "$scratch/head" "$out/looks-head.jpg"
}

looks-phantom() {
    "$cli" example "$scratch/phantom" >/dev/null 2>&1
    heads "$scratch/phantom" "$out/looks-phantom.jpg"
}

models() {
    tools/manual/contact_sheet.sh "$scratch/head" "$out/models.jpg" 200 "${SAMPLES:-64}" 30
}

table() {
    local word
    for word in shown hidden; do
        "$cli" render "$chest" -o "$scratch/$word.png" --annotations none --look "Bone beside contrast" --view posterior --table $word \
            --size 512x400 --exposure auto --denoised --samples "${SAMPLES:-64}" >/dev/null 2>&1
    done
    convert "$scratch/shown.png" "$scratch/hidden.png" +append -strip -quality 88 "$out/table.jpg"
}

[ $# -gt 0 ] || set -- first looks-chest looks-parts looks-head looks-phantom models table
for picture in "$@"; do
    "$picture"
done
