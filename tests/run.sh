#!/usr/bin/env bash
# Installs what is missing, builds, and runs all tests but those labelled "long". Options go to CTest:
#   bash tests/run.sh -R Pear          some tests
#   bash tests/run.sh -L long          the long ones
set -euo pipefail
source "$(dirname "$0")/../apps/setup.sh"
setup_packages
options=(-DBUILD_TESTING=ON)
[ "${CI:-}" = true ] && options+=(-DVESICLE_WARNINGS_AS_ERRORS=ON)
if command -v npm > /dev/null; then
  options+=(-DVESICLE_HTML=ON)
fi
if ! command -v npm > /dev/null || ! command -v chromium > /dev/null; then
  echo "Skipped: tests of the page in a browser (npm or chromium missing; bash tests/browser.sh sets them up)"
fi
setup_build "${options[@]}"

[ $# -eq 0 ] && set -- -LE long
[ -x "$root/build/paraview/pvpython" ] ||
  echo "ParaView isn't there: its tests are skipped (bash apps/paraview.sh sets it up)"
ctest --test-dir "$build" --output-on-failure --parallel "$(nproc)" "$@"
