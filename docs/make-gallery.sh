#!/usr/bin/env bash
# Draws the pictures of docs/gallery.md from shipped scenes at 320 triangles: bash docs/make-gallery.sh
# Takes the command from build/release/bin, or from PATH.
set -euo pipefail
root=$(cd "$(dirname "$0")/.." && pwd)
PATH=$root/build/release/bin:$PATH
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT

# picture NAME [RENDER OPTION…]: three moments of the scene as docs/pictures/NAME.png
picture() {
  local name=$1
  shift
  vesicle run "$root/data/scenes/$name.toml" -o "$folder/$name" --set vesicle.triangles=320 --no-movie --no-plots --quiet
  vesicle render "$folder/$name/$name.pvd" --montage "$root/docs/pictures/$name.png" --panels 3 --size 1000x260 --smooth "$@"
}

picture banana
picture parachute
picture tadpole
picture tank-treading --color Tension --arrows
picture capsule
picture relax-prolate

# The last frame of the pear, with the fluid around it.
vesicle run "$root/data/scenes/pear.toml" -o "$folder/pear" --set vesicle.triangles=320 --no-movie --no-plots --quiet
vesicle render "$folder/pear/pear.pvd" -o "$folder/flow" --flow-lines --smooth --size 900x640
cp "$(ls "$folder"/flow/*.png | tail -1)" "$root/docs/pictures/flow-lines.png"
