#!/usr/bin/env bash
# slurm_relay.sh SOURCE BUILD: in a Slurm of the test's own one task is a relay, and four nodes dial it. They fill one image, a node
# and then the relay are killed and run again, and not a bit of the image differs from that of one machine. Prints what was measured.
# Ends with 77 where Slurm is not installed or this is not root.
. "$1/tests/slurm/begin.sh"

readonly SIZE=160x120 SAMPLES=${PDR_SLURM_SAMPLES:-2048} BELOW=4
startCluster "$folder" 3
prepareImages
"$programs/pdrender-node" --make-certificates "$folder/below" >/dev/null
freePort() {
    python3 -c 'import socket; s = socket.socket(); s.bind(("127.0.0.1", 0)); print(s.getsockname()[1])'
}
workstation=$(freePort) relayed=$(freePort)

# As in the manual (nodes-administration.md): the relay has a host of its own, whose name the nodes below are told.
relay=$(PDR_COORDINATOR=127.0.0.1:$workstation sbatch --parsable --nodelist=n1 --cpus-per-task=1 --output="$folder/relay.txt" \
    "$source/installer/slurm/pdrender-node.sbatch" --relay "127.0.0.1:$relayed" --relay-bundle "$folder/below/coordinator")
job=$(PDR_COORDINATOR=127.0.0.1:$relayed PDR_BUNDLE=$folder/below/node sbatch --parsable --array=0-$((BELOW - 1)) \
    --dependency="after:$relay" --cpus-per-task=1 --output="$folder/job.%A.%a.txt" "$source/installer/slurm/pdrender-node.sbatch")
# below COUNT: so many nodes have been let in by the relay.
below() {
    [ "$(cat "$folder/relay.txt" 2>/dev/null | grep -c 'below: .* is there')" -ge "$1" ]
}
within 60 "$BELOW nodes are below the relay" "$(now)" below "$BELOW"
startImage "$workstation" 1
within 60 "it renders" "$(now)" heard 1 'rendering: '
within 60 "nodes below work" "$(now)" works "$BELOW" '*'

began=$(now)
kill -KILL "$(pgrep -f -- "--name slurm-$job-3-r0")"
within 10 "a killed node is below the relay again" "$began" below $((BELOW + 1))
began=$(now)
kill -KILL "$(pgrep -f -- "--name slurm-$relay-0-r0")"
within 20 "a killed relay works again" "$began" heard 1 "^node slurm-$relay-0-r1 "
within 30 "all nodes are below it" "$began" below $((2 * BELOW + 1))
is 0 "$(over && echo 1 || echo 0)" "images that ended before"
checkImage
is 0 "$(grep -c "^node slurm-$job-" "$folder/said" || true)" "nodes that dialled the workstation"

began=$(now)
scancel "$relay" "$job"
within 10 "no task left" "$began" noJobs
finish || { cat "$folder/said" "$folder/relay.txt"; exit 1; }
