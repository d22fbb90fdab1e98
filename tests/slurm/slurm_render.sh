#!/usr/bin/env bash
# slurm_render.sh SOURCE BUILD: eight render nodes in a Slurm of its own fill one picture, one of them is killed, and not a bit of the
# picture differs from that of one machine. Prints what was measured. Ends with 77 where Slurm is not installed or this is not root.
set -euo pipefail
source=$1 programs=$2/bin
. "$source/tests/slurm/cluster.sh"
. "$source/tests/slurm/checks.sh"
haveSlurm || { echo "Slurm is not installed, or this is not root"; exit 77; }

readonly SIZE=160x120 SAMPLES=${PDR_SLURM_SAMPLES:-2048}
folder=$(mktemp -d)
coordinator=
trap '[ -z "$coordinator" ] || kill "$coordinator" 2>/dev/null || true; stopCluster "$folder"; rm -rf "$folder"' EXIT
startCluster "$folder" 4
"$programs/pdrender-node" --make-certificates "$folder/certificates" >/dev/null
"$programs/pdrender-cli" example "$folder/ct" >/dev/null 2>&1
render() {
    "$programs/pdrender-cli" render "$folder/ct" --size "$SIZE" --samples "$SAMPLES" "$@"
}
render -o "$folder/alone.exr" >/dev/null 2>&1

export PDR_BUNDLE=$folder/certificates/node PDR_NODE_PROGRAM=$programs/pdrender-node
render -o "$folder/nodes.exr" --listen 127.0.0.1:0 --bundle "$folder/certificates/coordinator" --await 8 --nodes-only \
    >"$folder/said" 2>&1 &
coordinator=$!
heard() {
    [ "$(grep -cE "$2" "$folder/said")" -ge "$1" ]
}
# works COUNT TASKS: so many connections, in the logs of those tasks.
works() {
    [ "$(cat "$folder/job.$job".$2.txt 2>/dev/null | grep -c '^pdrender-node: works for ')" -ge "$1" ]
}
over() {
    ! kill -0 "$coordinator" 2>/dev/null
}
within 120 "the coordinator listens" "$(now)" heard 1 'waiting for nodes at'
PDR_COORDINATOR=$(sed -n 's/^waiting for nodes at //p' "$folder/said")
export PDR_COORDINATOR

began=$(now)
job=$(sbatch --parsable --array=0-7 --output="$folder/job.%A.%a.txt" "$source/installer/slurm/pdrender-node.sbatch")
within "${PDR_SLURM_START:-5}" "8 nodes are there" "$began" works 8 '*'
within 60 "it renders" "$(now)" heard 1 'rendering: '

began=$(now)
kill -KILL "$(pgrep -f -- "--name slurm-$job-3-r0")"
within 8 "it is there again" "$began" works 2 3
drained() {
    grep -q 'exit code 0$' "$folder/job.$job.$1.txt"
}
began=$(now)
scancel "${job}_5"
within 10 "a node at work drains" "$began" drained 5
is 0 "$(over && echo 1 || echo 0)" "pictures that ended before"
until over; do sleep 0.2; done
code=0
wait "$coordinator" || code=$?
coordinator=
is 0 "$code" "exit code of the one who writes the picture"
code=0
python3 "$source/tests/slurm/same_picture.py" "$folder/alone.exr" "$folder/nodes.exr" || code=$?
is 0 "$code" "difference to the picture of one machine"
grep -E '^node .* of the samples' "$folder/said" || true

began=$(now)
scancel "$job"
within 10 "no node left" "$began" noJobs
is 8 "$(grep -l "exit code 0" "$folder"/job."$job".*.txt | wc -l)" "nodes that ended with 0"
finish || { cat "$folder/said"; exit 1; }
