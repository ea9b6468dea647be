#!/usr/bin/env bash
# Builds the fuzz targets with clang, address and undefined-behaviour sanitizers, and runs each for a time:
#   bash tests/fuzz/run.sh [SECONDS]     60 if left out
# Inputs found go to build/fuzz/corpus, failing ones to build/fuzz.
set -euo pipefail
cd "$(dirname "$0")/../.."
seconds=${1:-60}
mkdir -p build
cmake --preset fuzz > build/fuzz.log 2>&1 || { cat build/fuzz.log >&2; exit 1; }
cmake --build --preset fuzz --target fuzz_meshes fuzz_scene
corpus=build/fuzz/corpus
mkdir -p $corpus/scene $corpus/meshes
cp data/scenes/*.toml $corpus/scene
# A seed a format, each behind the byte that chooses it: a tetrahedron as the command writes it.
cp tests/fuzz/seeds/* $corpus/meshes
common=(-max_total_time="$seconds" -timeout=10 -rss_limit_mb=2048 -max_len=4096 -print_final_stats=1
  -artifact_prefix=build/fuzz/)
for target in meshes scene; do
  build/fuzz/bin/fuzz_$target "${common[@]}" $corpus/$target
done
