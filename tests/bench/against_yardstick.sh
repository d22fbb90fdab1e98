#!/usr/bin/env bash
# Time to equal error against a plain tracer of the same scene, in one run on one machine, turn by turn.
#   tests/bench/against_yardstick.sh FOLDER_OF_single_scatter.cpp [THREADS [RUNS [SAMPLES]]]
# Needs ./bootstrap build and build/example/matrix.dat (./bootstrap test unpacks it). Prints every run and the medians of
#   cost = seconds per sample x variance of a sample          ratio = cost of ours / cost of theirs, pair by pair
set -euo pipefail

cd "$(dirname "${BASH_SOURCE[0]}")/../.."
folder=${1:?the folder that holds single_scatter.cpp and reference.pfm}
threads=${2:-1} runs=${3:-7} samples=${4:-64}
bench=build/release/bin/pdrender-bench
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT

g++ -O3 -march=native "$folder/single_scatter.cpp" -o "$scratch/plain" -lpthread

# number KEY: the value of "KEY" in one line of JSON.
number() {
    sed -E "s/.*\"$1\": ([-0-9.e+]+).*/\1/"
}
# noise PICTURE: relative error of a picture, the reference's own (2.15 %) taken out.
noise() {
    "$bench" compare "$1" "$folder/reference.pfm" | number relativeRmse | awk '{ print sqrt($1 * $1 - 0.0215 * 0.0215) }'
}

for ((i = 1; i <= runs; i++)); do
    theirs=$("$scratch/plain" build/example/matrix.dat "$samples" "$threads" "$scratch/plain.pfm" | sed -E 's/.*: ([0-9.]+) s,.*/\1/')
    ours=$("$bench" picture tests/scenes/yardstick.json --samples "$samples" --threads "$threads" --pfm "$scratch/ours.pfm" | number seconds)
    echo "$ours $(noise "$scratch/ours.pfm") $theirs $(noise "$scratch/plain.pfm")"
done | awk -v samples="$samples" -v threads="$threads" '
    { ratio[NR] = ($1 * $2 * $2) / ($3 * $4 * $4); time[NR] = $1 / $3
      printf "run %d: ours %.3f s, error %.4f; plain %.3f s, error %.4f; ratio of costs %.3f\n", NR, $1, $2, $3, $4, ratio[NR] }
    function median(list, n,   i, j, swap) {
        for (i = 1; i <= n; i++) for (j = i + 1; j <= n; j++) if (list[j] < list[i]) { swap = list[i]; list[i] = list[j]; list[j] = swap }
        return n % 2 ? list[(n + 1) / 2] : (list[n / 2] + list[n / 2 + 1]) / 2
    }
    END { printf "%d threads, %d samples, %d runs: median time ratio %.3f, median cost ratio at equal error %.3f\n", threads, samples, NR, median(time, NR), median(ratio, NR) }'
