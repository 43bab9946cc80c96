#!/bin/sh
# A batch in parts with GNU parallel: parallel.sh PARTS FROM OUT [OPTIONS of abflat batch]
# Exits with 1 if a mesh failed, and with 75 if a part did; run again, it starts the parts that
# failed or never ran. SSHLOGINS=host1,host2 shares the parts
# among hosts that see the same folders.
set -eu
here=$(cd "$(dirname "$0")" && pwd)
parts=$1 from=$2 out=$3
shift 3
mkdir -p "$out"
seq 0 $((parts - 1)) |
  parallel ${SSHLOGINS:+--sshlogin "$SSHLOGINS" --workdir "$PWD" --env ABFLAT} \
    --jobs "${JOBS:-100%}" --joblog "$out/joblog" --resume-failed --quote \
    "$here/shard.sh" {} "$parts" "$from" "$out" --jobs 1 "$@" || {
  echo "parallel.sh: some parts failed, see $out/joblog. Run it again to go on." >&2
  exit 75
}
"${ABFLAT:-abflat}" batch --merge --out "$out" --quiet
