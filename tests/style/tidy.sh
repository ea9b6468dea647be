#!/usr/bin/env bash
# What clang-tidy says by .clang-tidy; nothing is as it should be:
#   bash tests/style/tidy.sh           the solver's files that the working tree or the last commit changed
#   bash tests/style/tidy.sh FILE…     these
#   bash tests/style/tidy.sh --all     the whole solver, six files at a time
set -euo pipefail
cd "$(dirname "$0")/../.."

if ! command -v clang-tidy > /dev/null || ! command -v clang++ > /dev/null; then
  echo "Skipped: clang-tidy or clang++ is missing"
  exit 77
fi
files=("$@")
folder=build/clang
together=OFF
options=(--quiet --warnings-as-errors='*')
if [ $# -eq 0 ]; then
  mapfile -t files < <(git diff --name-only --diff-filter=d HEAD~1 -- 'solver/*.cpp')
  [ ${#files[@]} -eq 0 ] && exit
elif [ "$1" = --all ]; then
  # Most of the work is what a file includes: files that are compiled together share it.
  folder=build/tidy
  together=ON
  options+=(--header-filter='/solver/.*\.(h|cpp)$' --checks=-bugprone-suspicious-include)
fi

mkdir -p build
cmake --preset clang -B "$folder" -DVESICLE_UNITY_BUILD=$together > build/clang.log 2>&1 ||
  { cat build/clang.log >&2; exit 1; }
if [ $together = ON ]; then
  mapfile -t files < <(grep -oP "\"file\": \"\K$PWD/($folder/)?solver/[^\"]*" $folder/compile_commands.json)
fi
printf '%s\0' "${files[@]}" |
  xargs -0 -n 1 -P "$(nproc)" clang-tidy -p "$folder" "${options[@]}" 2> /dev/null
