#!/usr/bin/env bash
# Time to equal error against a plain tracer of the same scene, in one run on one machine, turn by turn.
#   tools/measure/against_yardstick.sh FOLDER_OF_single_scatter.cpp [THREADS [RUNS [SAMPLES [BENCH...]]]]
# BENCH: pdrender-bench of other builds, to be compared in the same turns; the first is build/release/bin/pdrender-bench.
# Needs ./bootstrap build and build/example/matrix.dat (./bootstrap test unpacks it). Prints every run and the medians of
#   cost = seconds per sample x variance of a sample          ratio = cost of ours / cost of theirs, pair by pair
set -euo pipefail

cd "$(dirname "${BASH_SOURCE[0]}")/../.."
folder=${1:?the folder that holds single_scatter.cpp and reference.pfm}
threads=${2:-1} runs=${3:-7} samples=${4:-64}
benches=(build/release/bin/pdrender-bench "${@:5}")
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT

g++ -O3 -march=native "$folder/single_scatter.cpp" -o "$scratch/plain" -lpthread

# number KEY: the value of "KEY" in one line of JSON.
number() {
    sed -E "s/.*\"$1\": ([-0-9.e+]+).*/\1/"
}
# noise PICTURE: relative error of an image, the reference's own (2.15 %) taken out.
noise() {
    "${benches[0]}" compare "$1" "$folder/reference.pfm" | number relativeRmse | awk '{ print sqrt($1 * $1 - 0.0215 * 0.0215) }'
}

for ((i = 1; i <= runs; i++)); do
    theirs=$("$scratch/plain" build/example/matrix.dat "$samples" "$threads" "$scratch/plain.pfm" | sed -E 's/.*: ([0-9.]+) s,.*/\1/')
    plain=$(noise "$scratch/plain.pfm")
    for bench in "${benches[@]}"; do
        ours=$("$bench" picture tests/scenes/yardstick.json --samples "$samples" --threads "$threads" --pfm "$scratch/ours.pfm" | number seconds)
        printf '%s\t%s\t%s\t%s\t%s\n' "$bench" "$ours" "$(noise "$scratch/ours.pfm")" "$theirs" "$plain"
    done
done | awk -F '\t' -v samples="$samples" -v threads="$threads" '
    { if (!($1 in n)) order[++builds] = $1
      k = ++n[$1]
      ratio[$1, k] = ($2 * $3 * $3) / ($4 * $5 * $5); time[$1, k] = $2 / $4
      printf "%s, run %d: ours %.3f s, error %.4f; plain %.3f s, error %.4f; ratio of costs %.3f\n", $1, k, $2, $3, $4, $5, ratio[$1, k] }
    function median(list, of, n,   i, j, swap, sorted) {
        for (i = 1; i <= n; i++) sorted[i] = list[of, i]
        for (i = 1; i <= n; i++) for (j = i + 1; j <= n; j++) if (sorted[j] < sorted[i]) { swap = sorted[i]; sorted[i] = sorted[j]; sorted[j] = swap }
        return n % 2 ? sorted[(n + 1) / 2] : (sorted[n / 2] + sorted[n / 2 + 1]) / 2
    }
    END { for (b = 1; b <= builds; b++) printf "%s: %d threads, %d samples, %d runs: median time ratio %.3f, median cost ratio at equal error %.3f\n", order[b], threads, samples, n[order[b]], median(time, order[b], n[order[b]]), median(ratio, order[b], n[order[b]]) }'
