#!/usr/bin/env bash
# What a change costs a scene that does not use it: the same image by two builds of pdrender-bench, turn by turn.
#   tools/measure/against_build.sh OTHER_PDRENDER_BENCH [RUNS [SAMPLES [SCENE.json]]]
# Prints the median of the time of this build over that of the other, pair by pair, on one thread.
set -euo pipefail

cd "$(dirname "${BASH_SOURCE[0]}")/../.."
other=${1:?a pdrender-bench of another build} runs=${2:-15} samples=${3:-64} scene=${4:-tests/scenes/yardstick.json}

seconds() {
    "$1" picture "$scene" --samples "$samples" --threads 1 | sed -E 's/.*"seconds": ([0-9.]+).*/\1/'
}

for ((i = 0; i < runs; i++)); do
    if ((i % 2)); then
        ours=$(seconds build/release/bin/pdrender-bench) theirs=$(seconds "$other")
    else
        theirs=$(seconds "$other") ours=$(seconds build/release/bin/pdrender-bench)
    fi
    echo "$ours $theirs"
done | awk '{ print $1 / $2 }' | sort -n | awk '{ r[NR] = $1 } END {
    printf "%d pairs: median ratio of times %.3f, half of them between %.3f and %.3f\n", NR, r[int((NR + 1) / 2)], r[int((NR + 3) / 4)], r[int((3 * NR + 3) / 4)] }'
