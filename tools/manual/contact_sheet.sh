#!/usr/bin/env bash
# One image of a CT series under every optical model (rows) and four looks (columns), to be looked at.
#   tools/manual/contact_sheet.sh FOLDER OUT.jpg [SIZE [SAMPLES [SECONDS]]]
# SIZE: pixels of each image's edge; SAMPLES per pixel, but no longer than SECONDS each. Needs ./bootstrap build and
# ImageMagick.
set -euo pipefail

cd "$(dirname "${BASH_SOURCE[0]}")/../.."
folder=${1:?a folder of DICOM files} out=${2:?the picture to write}
size=${3:-240} samples=${4:-256} seconds=${5:-6}
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT

pictures=()
for model in absorption emission emissionAbsorption singleScattering multipleScattering maximumIntensity; do
    # Without scattering there is no noise but at edges; glowing tissue adds up to much light.
    exposure=() count=$samples
    case $model in
        absorption | emissionAbsorption) exposure=(--exposure 0.6) count=16 ;;
        emission) exposure=(--exposure 60) count=16 ;;
        maximumIntensity) exposure=(--exposure 1) count=16 ;;
    esac
    for look in "Bone" "Thin bone" "Muscles and skull" "Skin over bone"; do
        picture="$scratch/$model-${look// /-}.png"
        build/release/bin/pdrender-cli render "$folder" -o "$picture" --annotations none --look "$look" --model "$model" \
            --size "${size}x${size}" --samples "$count" --seconds "$seconds" "${exposure[@]}" --denoised >/dev/null 2>&1
        pictures+=(-label "$model\n$look" "$picture")
    done
done
montage -font /usr/share/fonts/truetype/dejavu/DejaVuSans.ttf "${pictures[@]}" -tile 4x -geometry "+3+3" -background '#202020' -fill '#c0c0c0' -pointsize 12 "$out"
