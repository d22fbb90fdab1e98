#!/usr/bin/env bash
# slurm_cluster.sh SOURCE BUILD: `pdrender-cli cluster start` has a Slurm of the test's own start four nodes, and they render for the
# next program that listens in its place. Ends with 77 where Slurm is not installed or this is not root.
. "$1/tests/slurm/begin.sh"

startCluster "$folder" 2
cd "$folder"
"$programs/pdrender-node" --make-certificates certificates >/dev/null
"$programs/pdrender-cli" example ct >/dev/null 2>&1
port=$(python3 -c 'import socket; s = socket.socket(); s.bind(("127.0.0.1", 0)); print(s.getsockname()[1])')
wait_here=(--listen "127.0.0.1:$port" --bundle certificates/coordinator)

code=0
"$programs/pdrender-cli" cluster start --slurm 4 "${wait_here[@]}" -- --cpus-per-task=1 >said 2>told || code=$?
is 0 "$code" "exit code of cluster start"
sed -n 's/^\(4 nodes of job .* after .* s\)\. .*/      \1/p' said
job=$(sed -n 's/.*nodes of job \([0-9]*\) .*/\1/p' said)

render() {
    "$programs/pdrender-cli" render ct --size 96x72 --samples 64 "$@" 2>>told
}
render -o alone.exr
began=$(now)
render -o nodes.exr "${wait_here[@]}" --await 4 --nodes-only
within 120 "an image by nodes that had waited" "$began" true
code=0
python3 "$source/tests/slurm/same_image.py" alone.exr nodes.exr || code=$?
is 0 "$code" "difference to the image of one machine"
is 4 "$(grep -c '^node slurm-'"$job"'-[0-3]-r0: ' told)" "nodes that rendered"
began=$(now)
scancel "$job"
within 10 "no node left" "$began" noJobs
finish || { cat told said; exit 1; }
