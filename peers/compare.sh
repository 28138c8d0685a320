#!/usr/bin/env bash
# Holds two builds of wisch against each other: every scenario with the seeds 1 to 3, file by file and byte by byte.
#
#     peers/compare.sh BEFORE AFTER [COMMAND]     COMMAND: run (default), plan, predict or follow
#
# Says which files differ; ends with 0 if none does. How long stages took to compute, which no two runs share, is left out.
set -euo pipefail
before=$(realpath "$1") after=$(realpath "$2") command=${3:-run}
root=$(realpath "$(dirname "$0")/..")

work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
mkdir "$work/before" "$work/after"
options=(--quiet)
[ "$command" = run ] && options+=(--no-memory)

differs=0
for scenario in "$root"/scenarios/*.toml; do
    for seed in 1 2 3; do
        name=$(basename "$scenario" .toml)-$seed
        for build in before after; do
            mkdir "$work/$build/$name"
            cd "$work/$build/$name"
            status=0
            "${!build}" "$command" "$scenario" --seed $seed --out out "${options[@]}" 2>errors.txt || status=$?
            echo $status >status.txt
            find . -name 'rounds.json' -exec sed -i -E 's/"(planning|following|interpretation)_time_s": ?[0-9.e-]+//' {} +
        done
        diff --recursive --brief "$work/before/$name" "$work/after/$name" || differs=1
        rm -r "$work/before/$name" "$work/after/$name"
    done
done
exit $differs
