#!/usr/bin/env bash
# One image of a CT series under each of some looks, as they were at a commit and as they are, to be looked at.
#   tools/manual/looks_compared.sh COMMIT FOLDER|SCENE.json OUT.jpg LOOK...
# LOOK: the name of a file in resources/looks without its ending, such as bone. SIZE (240x256), SAMPLES (32) and CLI
# (build/release/bin/pdrender-cli) may be set. Needs ./bootstrap build and ImageMagick.
set -euo pipefail

cd "$(dirname "${BASH_SOURCE[0]}")/../.."
commit=${1:?a commit} scan=${2:?a folder of DICOM files or a scene} out=${3:?the image to write}
shift 3
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT

images=()
for look in "$@"; do
    git show "$commit:resources/looks/$look.json" >"$scratch/before.json"
    cp "resources/looks/$look.json" "$scratch/now.json"
    for when in before now; do
        image="$scratch/$look-$when.png"
        "${CLI:-build/release/bin/pdrender-cli}" render "$scan" -o "$image" --annotations none --look "$scratch/$when.json" \
            --exposure auto --denoised --size "${SIZE:-240x256}" --samples "${SAMPLES:-32}" >/dev/null 2>"$scratch/said" ||
            { cat "$scratch/said" >&2; exit 1; }
        images+=(-label "$look, $when" "$image")
    done
done
montage -font /usr/share/fonts/truetype/dejavu/DejaVuSans.ttf "${images[@]}" -tile 6x -geometry "+3+3" -background '#202020' \
    -fill '#c0c0c0' -pointsize 12 -quality 85 "$out"
