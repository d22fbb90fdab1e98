# The beginning of each test with a Slurm of its own. To be sourced with the test's words, SOURCE and BUILD. Sets `source`, `programs`
# and `folder`, which is deleted at the end with all that runs. Ends with 77 where Slurm is not installed or this is not root.
set -euo pipefail
source=$1 programs=${2:-}/bin
. "$source/tests/slurm/cluster.sh"
. "$source/tests/slurm/checks.sh"
. "$source/tests/slurm/image.sh"
haveSlurm || { echo "Slurm is not installed, or this is not root"; exit 77; }
folder=$(mktemp -d)
trap 'stopImage; stopCluster "$folder"; rm -rf "$folder"' EXIT
