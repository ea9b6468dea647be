#!/usr/bin/env bash
# What clang-tidy says by .clang-tidy; nothing is as it should be:
#   bash tests/style/tidy.sh           the solver's files that the working tree or the last commit changed
#   bash tests/style/tidy.sh FILE…     these
#   bash tests/style/tidy.sh --all     the whole solver: 250 files of some 16 s, an hour and more of one core
set -euo pipefail
cd "$(dirname "$0")/../.."

if ! command -v clang-tidy > /dev/null || ! command -v clang++ > /dev/null; then
  echo "Skipped: clang-tidy or clang++ is missing"
  exit 77
fi
case ${1:-} in
  '') mapfile -t files < <(git diff --name-only --diff-filter=d HEAD~1 -- 'solver/*.cpp') ;;
  --all) mapfile -t files < <(find solver -name '*.cpp' | sort) ;;
  *) files=("$@") ;;
esac
[ ${#files[@]} -eq 0 ] && exit

mkdir -p build
cmake --preset clang > build/clang.log 2>&1 || { cat build/clang.log >&2; exit 1; }
printf '%s\0' "${files[@]}" |
  xargs -0 -n 1 -P "$(nproc)" clang-tidy -p build/clang --quiet --warnings-as-errors='*' 2> /dev/null
