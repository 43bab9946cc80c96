#!/bin/sh
# One part of a batch: shard.sh PART OF FROM OUT [OPTIONS of abflat batch]
# PART counts from 0. FROM is a folder, a pattern, or a list of meshes that ends in .txt, .csv or
# .jsonl. Run again, it goes on where it ended.
set -eu
part=$1 of=$2 from=$3 out=$4
shift 4
case $from in
*.txt | *.csv | *.jsonl) set -- --from "$from" "$@" ;;
*) set -- "$from" "$@" ;;
esac
code=0
"${ABFLAT:-abflat}" batch "$@" --out "$out" --shard "$part/$of" --resume --quiet || code=$?
# Layouts that are not valid and meshes that cannot be read are in the manifest. The part is done.
[ "$code" -eq 1 ] || exit "$code"
