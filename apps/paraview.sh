#!/usr/bin/env bash
# Puts Debian's ParaView 5.11 into build/paraview, beside the system's VTK, and builds the plugin for it.
# build/paraview/{paraview,pvpython,pvbatch} then start it with the plugin. (Installing Debian's
# python3-paraview instead would remove python3-vtk9 and libvtk9-dev.)
set -euo pipefail
source "$(dirname "$0")/setup.sh"
setup_packages
paraview=$root/build/paraview
prefix=$paraview/root

unpack_paraview() {
  local packages=$paraview/packages
  rm -rf "$packages" "$prefix.part"
  mkdir -p "$packages"
  echo "Downloading ParaView (83 MB)"
  as_root apt-get update -qq
  (cd "$packages" && apt-get -o APT::Sandbox::User=root download -qq paraview paraview-dev python3-paraview)
  # Its libraries; what ParaView's web server and plots from matplotlib need is left out.
  local libraries
  libraries=$(dpkg-deb -f "$packages"/paraview_*.deb Depends | tr ',' '\n' | grep -E '^ *(lib|zlib)' | paste -sd,)
  as_root apt-get satisfy -y -qq --no-install-recommends "$libraries" libqt5svg5 python3-mpi4py > /dev/null
  for package in "$packages"/*.deb; do
    dpkg -x "$package" "$prefix.part"
  done
  mv "$prefix.part" "$prefix"
  rm -r "$packages"
}

# Programs of the prefix with its libraries and the plugin.
write_starter() {
  cat > "$paraview/$1" << STARTER
#!/usr/bin/env bash
export PYTHONPATH=$prefix/usr/lib/python3/dist-packages\${PYTHONPATH:+:\$PYTHONPATH}
export LD_LIBRARY_PATH=$prefix/usr/lib/$(gcc -print-multiarch)\${LD_LIBRARY_PATH:+:\$LD_LIBRARY_PATH}
export PV_PLUGIN_PATH=$paraview/plugin/lib/paraview-5.11/plugins/Vesicle
exec $prefix/usr/bin/$1 "\$@"
STARTER
  chmod +x "$paraview/$1"
}

[ -x "$prefix/usr/bin/pvpython" ] || unpack_paraview
for program in paraview pvpython pvbatch; do
  write_starter "$program"
done

cmake -S "$root" -B "$paraview/plugin" -G Ninja -DCMAKE_BUILD_TYPE=Release -DVESICLE_PARAVIEW=ON \
  -DCMAKE_PREFIX_PATH="$prefix/usr" "$@" > "$paraview/configure.log" 2>&1 || {
  cat "$paraview/configure.log" >&2
  exit 1
}
cmake --build "$paraview/plugin" --parallel "$(build_jobs)"
echo "The plugin is in $paraview/plugin/lib/paraview-5.11/plugins/Vesicle; start $paraview/paraview"
