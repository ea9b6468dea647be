# Sourced by apps/demo.sh and tests/run.sh: installs what is missing and builds.
#   setup_packages          installs the packages of apps/packages.txt that are missing (root or sudo)
#   install_packages NAME…  installs these
#   setup_build [OPTION…]   configures and builds in build/release; OPTIONs go to CMake

root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
build=$root/build/release

setup_packages() {
  local missing=()
  while read -r package; do
    case $package in '' | '#'*) continue ;; esac
    dpkg-query -W -f '${Status}' "$package" 2>/dev/null | grep -q '^install ok installed' ||
      missing+=("$package")
  done < "$root/apps/packages.txt"
  [ ${#missing[@]} -eq 0 ] || install_packages "${missing[@]}"
}

install_packages() {
  echo "Installing $*"
  as_root apt-get update -qq
  as_root apt-get install -y -qq --no-install-recommends "$@" > /dev/null
}

# as_root COMMAND…: by sudo where that is needed.
as_root() {
  local sudo=()
  if [ "$(id -u)" -ne 0 ]; then
    command -v sudo > /dev/null || {
      echo "Root or sudo is needed for: $*" >&2
      return 1
    }
    sudo=(sudo)
  fi
  "${sudo[@]}" env DEBIAN_FRONTEND=noninteractive "$@"
}

# One job a core, but no more than memory has room for: a VTK or Eigen file takes up to 1.5 GB.
build_jobs() {
  local cores memory
  cores=$(nproc)
  memory=$(awk '/MemAvailable/ { print int($2 / 1.5e6) }' /proc/meminfo)
  [ "$memory" -lt 1 ] && memory=1
  echo $((cores < memory ? cores : memory))
}

setup_build() {
  (cd "$root" && cmake --preset release "$@" > "$root/build/configure.log" 2>&1) || {
    cat "$root/build/configure.log" >&2
    return 1
  }
  cmake --build "$build" --parallel "$(build_jobs)"
}

mkdir -p "$root/build"
