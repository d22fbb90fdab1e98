#!/usr/bin/env bash
# One image of a CT series under each of some looks, as they were at a commit and as they are, to be looked at.
#   tools/manual/looks_compared.sh COMMIT FOLDER|SCENE.json OUT.jpg LOOK...
# LOOK: the name of a file in resources/looks without its ending, such as bone; one that was not there at COMMIT is shown as it
# is. Parts are found by the rules that a look needs, unless LABELS names a label map. SIZE (240x256), SAMPLES (32),
# COLUMNS (6) and CLI (build/release/bin/pdrender-cli) may be set. Needs ./bootstrap build and ImageMagick.
set -euo pipefail

cd "$(dirname "${BASH_SOURCE[0]}")/../.."
commit=${1:?a commit} scan=${2:?a folder of DICOM files or a scene} out=${3:?the image to write}
shift 3
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT

# sourceOf LOOK.json: the options that say where its parts come from.
sourceOf() {
    local rules=()
    grep -q '"parts"' "$1" || return 0
    if grep -q '"inColour": true' "$1"; then
        echo --labels "${LABELS:?a label map}"
        return
    fi
    ! grep -q '"part": "vessels"' "$1" || rules+=(vessels)
    ! grep -qE '"part": "(skin|muscle)"' "$1" || rules+=(shells)
    ! grep -q '"part": "mirrored bone"' "$1" || rules+=(mirror)
    ! grep -q '"part": "implant"' "$1" || rules+=(metal)
    echo --find "$(IFS=,; echo "${rules[*]}")"
}

images=()
for look in "$@"; do
    git show "$commit:resources/looks/$look.json" >"$scratch/before.json" 2>/dev/null || rm -f "$scratch/before.json"
    cp "resources/looks/$look.json" "$scratch/now.json"
    for when in before now; do
        [ -f "$scratch/$when.json" ] || continue
        image="$scratch/$look-$when.png"
        read -ra source <<<"$(sourceOf "$scratch/$when.json")"
        "${CLI:-build/release/bin/pdrender-cli}" render "$scan" -o "$image" --annotations none --look "$scratch/$when.json" \
            "${source[@]}" --exposure auto --denoised --size "${SIZE:-240x256}" --samples "${SAMPLES:-32}" >/dev/null \
            2>"$scratch/said" || { cat "$scratch/said" >&2; exit 1; }
        images+=(-label "${look//_/ }, $when" "$image")
    done
done
montage -font /usr/share/fonts/truetype/dejavu/DejaVuSans.ttf "${images[@]}" -tile "${COLUMNS:-6}x" -geometry "+3+3" \
    -background '#202020' -fill '#c0c0c0' -pointsize "${POINTSIZE:-12}" -quality "${QUALITY:-85}" "$out"
