#!/usr/bin/env bash
# The charts and the table of docs/tradeoff.md, and how promises compare with what is exact:
#   bash docs/make-tradeoff.sh [SCENE…]      pear tank-treading rigid-sphere; or relax-prolate
# with the command in build/release, or in the folder BUILD; its runs stay in tradeoff/ there and aren't
# repeated. Eight minutes of CPU time, on two cores half of that.
set -euo pipefail
cd "$(dirname "$0")/.."
build=${BUILD:-build/release}
out=$build/tradeoff
mkdir -p "$out"
[ $# -gt 0 ] || set -- pear tank-treading rigid-sphere

# Where the last moment is a steady state, whose exact values are known.
declare -A end=([pear]=5 [tank-treading]=20 [relax-prolate]=15 [rigid-sphere]=0.5)
declare -A budget=([pear]=200 [tank-treading]=215 [relax-prolate]=240 [rigid-sphere]=60) # seconds
for scene; do
  "$build/bin/vesicle" tradeoff "data/scenes/$scene.toml" --end "${end[$scene]}" --budget "${budget[$scene]}" -o "$out/$scene"
  cp "$out/$scene/tradeoff.svg" "docs/pictures/tradeoff-$scene.svg"
done
python3 docs/tradeoff-table.py "${@/#/$out/}"
