#!/usr/bin/env bash
# One image of a CT series under each of some looks, as the manual shows them, to be looked at.
#   tools/manual/acceptance.sh FOLDER OUT.jpg LOOK...
# SIZE (320, or 400x280), SAMPLES (96) and COLUMNS (4) may be set. Needs ./bootstrap build and ImageMagick.
set -euo pipefail

cd "$(dirname "${BASH_SOURCE[0]}")/../.."
folder=${1:?a folder of DICOM files} out=${2:?the picture to write}
shift 2
size=${SIZE:-320}
[[ $size == *x* ]] || size=${size}x$size
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT

pictures=()
for look in "$@"; do
    picture="$scratch/${look// /-}.png"
    build/release/bin/pdrender-cli render "$folder" -o "$picture" --annotations none --look "$look" --exposure auto --denoised \
        --size "$size" --samples "${SAMPLES:-96}" >/dev/null 2>"$scratch/said" || { cat "$scratch/said" >&2; exit 1; }
    pictures+=(-label "$look" "$picture")
done
montage -font /usr/share/fonts/truetype/dejavu/DejaVuSans.ttf "${pictures[@]}" -tile "${COLUMNS:-4}x" -geometry "+3+3" -background '#202020' -fill '#c0c0c0' -pointsize 13 -quality 88 "$out"
