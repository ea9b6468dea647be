#!/usr/bin/env bash
# Every C++ file as .clang-format says:
#   bash tests/style/format.sh           formats them
#   bash tests/style/format.sh --check   names those that aren't
set -euo pipefail
cd "$(dirname "$0")/../.."

wanted=14.0.6 # Debian 12's; others break some lines elsewhere
version=$(clang-format --version 2> /dev/null | grep -oE '[0-9]+(\.[0-9]+)+' | head -1 || true)
if [ "$version" != "$wanted" ]; then
  echo "Skipped: clang-format $wanted is needed, not ${version:-none}"
  exit 77
fi
options=(-i)
[ "${1:-}" = --check ] && options=(--dry-run --Werror)
find apps examples render solver tests vtkfilters \( -name '*.h' -o -name '*.cpp' -o -name '*.cxx' \) -print0 |
  xargs -0 clang-format "${options[@]}"
