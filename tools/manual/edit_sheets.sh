#!/usr/bin/env bash
# Sheets of the images 0.1, 1 and 10 seconds after a turn, raw and denoised, and after edits of a look, with those of the
# new samples alone, for the manual.
#   tools/manual/edit_sheets.sh FOLDER NAME [EDIT...]
# FOLDER: a CT. NAME: of the pictures first-seconds-NAME.jpg and edit-NAME-KIND.jpg. EDIT: view, for a turn, or as
# first_images --edit reads it; none: view node:30 lights:3 albedo:0.9. FILM (64) and REFERENCE (256) samples, LOOK
# (Bone) and OUT (the manual's pictures) may be set. The machine should have nothing else to do. Needs ./bootstrap build
# and ImageMagick.
set -euo pipefail

cd "$(dirname "${BASH_SOURCE[0]}")/../.."
folder=${1:?a folder of DICOM files} name=${2:?a name for the pictures}
shift 2
(($# > 0)) || set -- view node:30 lights:3 albedo:0.9
out=${OUT:-resources/manual/pictures}
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
export QT_QPA_PLATFORM=offscreen

for edit in "$@"; do
    kind=("--edit" "$edit" "--film" "${FILM:-64}") picture=edit-$name-${edit%%:*}
    if [[ $edit == view ]]; then
        kind=() picture=first-seconds-$name
    fi
    build/release/tools/first_images "$folder" --look "${LOOK:-Bone}" "${kind[@]}" --reference "${REFERENCE:-256}" \
        -o "$scratch/sheet.png"
    convert "$scratch/sheet.png" -resize 1400x -strip -quality 80 "$out/$picture.jpg"
done
