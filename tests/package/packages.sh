#!/bin/bash
# packages.sh BUILD FOLDER: Debian's packages of a build, each file in one of them, unpacked into a root of
# their own, where the command, the Python package and a consumer's build work.
set -euo pipefail
build=$1 folder=$2
rm -rf "$folder" && mkdir -p "$folder/root"
cpack --config "$build/CPackConfig.cmake" -B "$folder" > "$folder/cpack.log" || { cat "$folder/cpack.log"; exit 1; }
for package in libvesicle0 libvesicle-dev vesicle_ python3-vesicle; do
  ls "$folder"/$package*.deb > /dev/null
done
for deb in "$folder"/*.deb; do
  dpkg-deb --fsys-tarfile "$deb" | tar t | grep -v '/$' >> "$folder/files"
  dpkg-deb -x "$deb" "$folder/root"
  dpkg-deb -f "$deb" Package Version Depends
done
twice=$(sort "$folder/files" | uniq -d)
[ -z "$twice" ] || { echo "in two packages: $twice"; exit 1; }
usr="$folder/root/usr"
export LD_LIBRARY_PATH="$usr/lib"
"$usr/bin/vesicle" --version
"$usr/bin/vesicle" shape prolate --reduced-volume 0.9 --triangles 80 -o "$folder/prolate.vtu" > /dev/null
readelf -d "$usr/lib/libVesicleFilters.so" | grep 'SONAME.*libVesicleFilters.so.0'
for page in man/man1/vesicle.1 bash-completion/completions/vesicle; do
  [ -e "$usr/share/$page" ] || [ -e "$usr/share/$page.gz" ] || { echo "no $page"; exit 1; }
done
PYTHONPATH="$usr/lib/python3/dist-packages" /usr/bin/python3 -c '
import vesicle
source = vesicle.vtkVesicleSource()
source.Update()
print(vesicle.__version__, source.GetOutput().GetNumberOfPoints(), vesicle.__file__)'
