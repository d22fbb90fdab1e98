#!/usr/bin/env bash
# slurm_shares.sh SOURCE BUILD: the shares of an image as an array in a Slurm of its own, some of their programs killed at random, and a
# job that depends on them and makes the image: not a bit of it differs from that of one machine. The commands are those of
# installer/slurm/README.md. Ends with 77 where Slurm is not installed or this is not root.
. "$1/tests/slurm/begin.sh"

readonly SHARES=${PDR_SHARES_OF_TEST:-200} KILLED=${PDR_SHARES_KILLED:-12}
startCluster "$folder" 4
"$programs/pdrender-cli" example "$folder/ct" >/dev/null 2>&1
options=("$folder/ct" --size 320x240)
samples=(--samples 64)
"$programs/pdrender-cli" render "${options[@]}" "${samples[@]}" -o "$folder/alone.exr" >/dev/null 2>&1

mkdir "$folder/films"
export PDR_FILMS=$folder/films PDR_CLI_PROGRAM=$programs/pdrender-cli PDR_THREADS=1
began=$(now)
job=$(sbatch --parsable --array="1-$SHARES%4" --output="$folder/job.%A.%a.txt" "$source/installer/slurm/pdrender-share.sbatch" \
    "${options[@]}" "${samples[@]}")
merge=$(sbatch --parsable --dependency=afterok:"$job" --output="$folder/merge.txt" \
    --wrap "$programs/pdrender-cli merge ${options[*]} $folder/films/*.film -o $folder/shares.exr")

# Kill programs at random, but always some that are still at work.
RANDOM=7
killed=0
while [ "$killed" -lt "$KILLED" ] && ! noJobs; do
    mapfile -t running < <(pgrep -f -- "pdrender-cli render $folder/ct .*--share" || true)
    if [ "${#running[@]}" -gt 0 ] && kill -KILL "${running[RANDOM % ${#running[@]}]}" 2>/dev/null; then
        killed=$((killed + 1))
    fi
    sleep 0.3
done
is "$KILLED" "$killed" "programs killed"
ended() {
    [ -s "$folder/shares.exr" ] && noJobs
}
for try in $(seq 6000); do
    ! ended || break
    sleep 0.1
done
is "$SHARES" "$(ls "$folder/films" | wc -l)" "films"
is 0 "$(ls -A "$folder/films" | grep -c part || true)" "films half written"
code=0
python3 "$source/tests/slurm/same_image.py" "$folder/alone.exr" "$folder/shares.exr" || code=$?
is 0 "$code" "difference to the image of one machine"
is 0 "$(grep -l 'requeue' "$folder"/job."$job".*.txt 2>/dev/null | wc -l)" "tasks that could not be run again"
awk -v a="$began" -v b="$(now)" -v n="$SHARES" 'BEGIN { printf "%d shares and the merge in %.0f s\n", n, b - a }'
finish || { tail -n 5 "$folder"/job.*.txt "$folder/merge.txt" | tail -40; exit 1; }
