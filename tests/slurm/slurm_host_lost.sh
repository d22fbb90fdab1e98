#!/usr/bin/env bash
# slurm_host_lost.sh SOURCE BUILD: of three hosts in a Slurm of the test's own one dies with all that runs on it, while render nodes on two
# of them fill an image. The image is finished without it, to the same bits; Slurm notices, and what ran there comes back on the
# third host and renders the next image. Prints what was measured. Ends with 77 where Slurm is not installed or this is not root.
. "$1/tests/slurm/begin.sh"

readonly SIZE=160x120 SAMPLES=${PDR_SLURM_SAMPLES:-768}
startCluster "$folder" 3
prepareImages
startImage 0 2
# Two do not fit on a host.
job=$(PDR_THREADS=1 sbatch --parsable --array=0-1 --cpus-per-task=9 --output="$folder/job.%A.%a.txt" \
    "$source/installer/slurm/pdrender-node.sbatch")
within 60 "it renders" "$(now)" heard 1 'rendering: '
hostOf() {
    squeue --noheader --jobs="${job}_0" --states=running --format=%N
}
parentOf() {
    ps -o ppid= -p "$1" | tr -d ' '
}

# The host of task 0: its daemon, what watches the task for it, the script and the program.
lost=$(hostOf)
program=$(pgrep -f -- "--name slurm-$job-0-r0")
script=$(parentOf "$program")
watcher=$(parentOf "$script")
[ "$(ps -o comm= -p "$watcher")" = slurmstepd ]
began=$(now)
kill -KILL "$(cat "$folder/slurmd.$lost.pid")" "$watcher" "$script" "$program"
rm "$folder/slurmd.$lost.pid"
is 0 "$(over && echo 1 || echo 0)" "images that ended before"
checkImage

# Those who are there wait for the next image; it begins when what was lost is back.
startImage "${PDR_COORDINATOR##*:}" 2
within "${PDR_SLURM_BACK:-40}" "a lost task works again" "$began" heard 1 "^node slurm-$job-0-r1 "
[ "$FAILURES" -eq 0 ] || stopImage  # it would wait for ever
is 0 "$(hostOf | grep -cx "$lost" || true)" "tasks on the lost host"
is down "$(sinfo --noheader --nodes="$lost" --format=%T | tr -d '*')" "state of the lost host"
checkImage
is 2 "$(grep -cE "^node slurm-$job-(0-r1|1-r0): " "$folder/said")" "nodes that rendered"

isBack() {
    [ "$(sinfo --noheader --nodes="$lost" --format=%T)" = idle ]
}
began=$(now)
slurmd -N "$lost" -f "$SLURM_CONF"
within 10 "the host is back" "$began" isBack
began=$(now)
scancel "$job"
within 10 "no node left" "$began" noJobs
finish || { cat "$folder/said"; exit 1; }
