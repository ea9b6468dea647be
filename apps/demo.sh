#!/usr/bin/env bash
# Installs what is missing, builds, and lets a vesicle rise: leaves a VTU series, a movie and plots in demo/.
set -euo pipefail
source "$(dirname "$0")/setup.sh"
setup_packages
setup_build -DBUILD_TESTING=OFF

"$build/bin/vesicle" run "$root/data/scenes/pear.toml" -o "$root/demo" --overwrite

cat << DONE

Done. Look at
  demo/pear.mp4              the movie, frame by frame in demo/movie/
  demo/plots/                speed, energy and drift against time
  demo/pear.vtu.series       the time series, for ParaView
  demo/pear.csv              the diagnostics
More scenes are in data/scenes: $build/bin/vesicle run data/scenes/banana.toml
DONE
