#!/usr/bin/env bash
# slurm_render.sh SOURCE BUILD: eight render nodes in a Slurm of its own fill one image, one of them is killed, and not a bit of the
# image differs from that of one machine. Prints what was measured. Ends with 77 where Slurm is not installed or this is not root.
. "$1/tests/slurm/begin.sh"

readonly SIZE=160x120 SAMPLES=${PDR_SLURM_SAMPLES:-2048}
startCluster "$folder" 4
prepareImages
startImage 0 8

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
is 0 "$(over && echo 1 || echo 0)" "images that ended before"
checkImage

began=$(now)
scancel "$job"
within 10 "no node left" "$began" noJobs
is 8 "$(grep -l "exit code 0" "$folder"/job."$job".*.txt | wc -l)" "nodes that ended with 0"
finish || { cat "$folder/said"; exit 1; }
