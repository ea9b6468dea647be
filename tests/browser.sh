#!/usr/bin/env bash
# Sets up what the pages of `vesicle render --html` need (npm, which fetches vtk.js) and what shows them
# (Chromium), builds, and runs the tests labelled "browser". Options go to CTest.
set -euo pipefail
source "$(dirname "$0")/../apps/setup.sh"
setup_packages
for program in npm chromium; do
  command -v "$program" > /dev/null || install_packages "$program"
done
setup_build -DBUILD_TESTING=ON -DVESICLE_HTML=ON
ctest --test-dir "$build" --output-on-failure -L browser "$@"
