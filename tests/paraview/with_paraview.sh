#!/usr/bin/env bash
# with_paraview.sh FOLDER COMMAND…: runs the command if the folder has ParaView, or says how to get it.
folder=$1
shift
if [ ! -x "$folder/pvpython" ] || [ ! -e "$folder/plugin/build.ninja" ]; then
  echo "Skipped: no ParaView in $folder; \`bash apps/paraview.sh\` sets it up"
  exit 77
fi
exec "$@"
