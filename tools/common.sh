# Shared by tools/run, tools/test and tools/bench: sourced, not run.
# Sets $root (the checkout) and $build; offers install_packages and build_all.

set -euo pipefail
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
preset=${GEARGRAPH_PRESET:-release}
build=$root/build/$preset

# Installs what is missing of tools/packages.txt; asks nothing, and does nothing when all is there.
# install_packages bench: also the lines that begin with "bench:".
install_packages() {
  local missing=() name
  while read -r name; do
    dpkg-query -W -f='${Status}' "$name" 2>/dev/null | grep -q 'ok installed' || missing+=("$name")
  done < <(sed -e "s/^${1:-only}: *//" -e '/^[a-z]*:/d' -e '/^[[:space:]]*\(#\|$\)/d' "$root/tools/packages.txt")
  [ ${#missing[@]} -eq 0 ] && return 0

  local as_root=()
  if [ "$(id -u)" -ne 0 ]; then
    command -v sudo >/dev/null || {
      echo "These packages are missing, and there is no sudo to install them: ${missing[*]}" >&2
      exit 1
    }
    as_root=(sudo -n)
  fi
  echo "Installing ${#missing[@]} packages: ${missing[*]}" >&2
  "${as_root[@]}" env DEBIAN_FRONTEND=noninteractive apt-get update -qq >&2
  "${as_root[@]}" env DEBIAN_FRONTEND=noninteractive \
    apt-get install -y -qq --no-install-recommends "${missing[@]}" >&2
}

# build_all [target...]: configures where needed and builds the targets, or everything.
build_all() {
  local options=()
  [ "${CI:-}" = true ] && options+=(-DGEARGRAPH_WERROR=ON)
  (cd "$root" && cmake --preset "$preset" "${options[@]}" >"/tmp/geargraph-configure-$$.log" 2>&1) || {
    cat "/tmp/geargraph-configure-$$.log" >&2
    exit 1
  }
  rm -f "/tmp/geargraph-configure-$$.log"
  if [ $# -gt 0 ]; then cmake --build "$build" --target "$@" >&2; else cmake --build "$build" >&2; fi
}
