# Each package installed alone in a fresh Debian 12, and run there. Sourced by tools/package.

# fresh_system NAME: a folder with the smallest Debian 12, made once and copied.
fresh_system() {
  local base=$root/build/packages-debian-12
  if [ ! -e "$base/made" ]; then
    rm -rf "$base"
    debootstrap --variant=minbase bookworm "$base" "${GEARGRAPH_DEBIAN_MIRROR:-http://deb.debian.org/debian}" >&2
    touch "$base/made"
  fi
  system=$out/trial/$1
  mkdir -p "$out/trial"
  rm -rf "$system"
  cp -a "$base" "$system"
}

# inside COMMAND: a command of the shell in the fresh system, as root, without the environment from outside. /proc and /dev are
# there for this command alone.
inside() {
  unshare --mount bash -euc '
    mount -t proc proc "$1/proc"
    mount --rbind /dev "$1/dev"
    exec chroot "$1" /usr/bin/env -i PATH=/usr/sbin:/usr/bin:/sbin:/bin HOME=/root LC_ALL=C.UTF-8 \
      DEBIAN_FRONTEND=noninteractive bash -euc "$2"' inside "$system" "$1"
}

# apt_inside PACKAGES...: installs them, with all that they depend on and nothing more.
apt_inside() {
  inside "apt-get update -qq; apt-get install -y -qq --no-install-recommends $* >/tmp/apt.log 2>&1 || { tail -20 /tmp/apt.log; exit 1; }" >&2
}

# has_window PROGRAM DOCUMENT: the program opens the document in a window under Xvfb. The picture of an empty window is some
# kilobytes, that of a whole one 200.
has_window() {
  inside "cd /tmp && xvfb-run -a -s '-screen 0 1366x768x24' timeout 120 $1 --screenshot window.png --size 1200x700 $2 && [ \$(stat -c %s window.png) -gt 100000 ]"
  cp "$system/tmp/window.png" "$out/window-$(basename "$system").png"
}

try_debian_packages() {
  local examples=/usr/share/geargraph/examples
  fresh_system geargraph-cli
  cp "$out"/geargraph-cli_*.deb "$system/tmp/"
  apt_inside /tmp/geargraph-cli_*.deb
  inside "! dpkg -l | grep -q libqt6"
  inside "geargraph-cli analyze $examples/robot.geargraph --json | grep -q '\"dof\": 3'"
  inside "geargraph-cli export $examples/robot.geargraph --to svg --view schematic -o /tmp/robot.svg && [ -s /tmp/robot.svg ]"
  inside "source /usr/share/bash-completion/completions/geargraph-cli; COMP_WORDS=(geargraph-cli ana); COMP_CWORD=1
    _geargraph_cli; [ \"\${COMPREPLY[*]}\" = analyze ]"

  fresh_system python3-geargraph
  cp "$out"/geargraph-cli_*.deb "$out"/python3-geargraph_*.deb "$system/tmp/"
  apt_inside /tmp/geargraph-cli_*.deb /tmp/python3-geargraph_*.deb
  inside "python3 -c 'import geargraph as gg
m = gg.open(\"$examples/robot.geargraph\")
assert m.analyze().dof == 3
print(\"geargraph\", gg.__version__, \"in Python\")'" >&2

  fresh_system geargraph
  cp "$out"/geargraph-cli_*.deb "$out"/geargraph_*.deb "$system/tmp/"
  apt_inside /tmp/geargraph-cli_*.deb /tmp/geargraph_*.deb xvfb xauth libgl1-mesa-dri fonts-dejavu-core shared-mime-info
  has_window geargraph "$examples/robot.geargraph"
  inside "update-mime-database /usr/share/mime; grep -q 'vnd.geargraph+json' /usr/share/mime/globs2"
}

try_archive() {
  fresh_system archive
  apt_inside xvfb xauth
  tar -C "$system/opt" -xf "$out"/geargraph-*.tar.xz
  local folder=/opt/geargraph-$version
  inside "$folder/geargraph-cli export $folder/share/geargraph/examples/robot.geargraph --to svg --view digraph -o /tmp/robot.svg"
  has_window "$folder/geargraph" "$folder/share/geargraph/examples/robot.geargraph"
}

# weights: each package as it is downloaded and as it is installed.
weights() {
  local file installed
  printf '%-45s %12s %12s\n' package 'download MB' 'installed MB'
  for file in "$out"/*.deb "$out"/*.tar.xz; do
    case $file in
      *.deb) installed=$(dpkg-deb -f "$file" Installed-Size) ;;
      *) installed=$(du -sk --apparent-size "$out/stage/geargraph-$version" | cut -f1) ;;
    esac
    printf '%-45s %12s %12s\n' "$(basename "$file")" "$(awk "BEGIN {printf \"%.1f\", $(stat -c %s "$file") / 1e6}")" \
      "$(awk "BEGIN {printf \"%.1f\", $installed / 1e3}")"
  done
}
