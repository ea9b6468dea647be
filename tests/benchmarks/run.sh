#!/usr/bin/env bash
# The solver's speed beside the machine's own rates, as JSON and as tables:
#   bash tests/benchmarks/run.sh          up to 5,120 triangles, two minutes
#   bash tests/benchmarks/run.sh --long   up to 20,480, or 81,920 where that is affordable, with what is
#                                         factorised and the paper's scheme at equal error: ten minutes
# In build/release, or in the folder BUILD; leaves its files in benchmarks/ there.
set -euo pipefail
cd "$(dirname "$0")/../.."
build=${BUILD:-build/release}
[ -f "$build/CMakeCache.txt" ] || cmake --preset release -B "$build" -DBUILD_TESTING=ON
cmake --build "$build" --target vesicle_benchmarks
out=$build/benchmarks
rm -rf "$out"
mkdir -p "$out"

# measure NAME REPETITIONS FILTER [OPTION…], in a process of its own.
measure() {
  "$build/bin/vesicle_benchmarks" --benchmark_repetitions="$2" --benchmark_filter="$3" --benchmark_min_time=0.1 \
    --benchmark_display_aggregates_only=true --benchmark_out="$out/$1.json" --benchmark_out_format=json "${@:4}"
}
mixed=--benchmark_enable_random_interleaving=true # what is compared shares whatever else the machine does

measure kernels 5 '^(Peak|ByHand|Kernel|DirectSum)/' $mixed
steps=20
for size in 320 1280 5120; do
  measure "memory-$size" 1 "^Step/pear/$size/threads:2" # where nothing else is in it
  measure "steps-$size" $steps "^Step/(pear/$size/|(tank-treading|pear-fast)/$size/threads:2)" $mixed
  measure "parts-$size" 1 "^Part/.*/$size/"
  steps=$((steps / 2))
done
for side in 1 2 4; do
  measure "several-$side" 3 "^Several/step/side:$side/threads:2"
done
measure terms 3 '^Term/' $mixed

if [ "${1:-}" = --long ]; then
  begin=$SECONDS
  measure steps-20480 3 '^Step/pear/20480/threads:2'
  taken=$((SECONDS - begin))
  measure steps-20480-others 2 '^Step/(pear/20480/threads:1|tank-treading/20480/threads:2)'
  measure parts-20480 1 '^Part/.*/20480/'
  measure linear 1 '^Linear/'
  measure equal-error 1 '^EqualError/.*/(balanced/(80|320)|paper/(640|1280|2560))/'
  # A start and a step take four to five times as long as the start and three steps of a quarter of them.
  memory=$(awk '/MemAvailable/ { print int($2 / 1e6) }' /proc/meminfo)
  if [ "$taken" -le 30 ] && [ "$memory" -ge 12 ]; then
    measure steps-81920 1 '^Step/pear/81920/threads:2'
    measure several-8 1 '^Several/step/side:8/threads:2'
  else
    echo "Left out: 81,920 triangles and 512 vesicles (20,480 took $taken s of 30, memory is $memory GB of 12)"
  fi
fi

python3 tests/benchmarks/tables.py "$out"/*.json | tee "$out/tables.md"
