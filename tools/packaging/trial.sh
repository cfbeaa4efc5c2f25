# Each package installed alone in a fresh system, and run there. Sourced by tools/package.

# fresh_system NAME RELEASE: a folder with the smallest system of a release of Debian, made once and copied.
fresh_system() {
  local base=$root/build/packages-debian-$2
  if [ ! -e "$base/made" ]; then
    rm -rf "$base"
    debootstrap --variant=minbase "$2" "$base" ${GEARGRAPH_DEBIAN_MIRROR:+"$GEARGRAPH_DEBIAN_MIRROR"} >&2
    touch "$base/made"
  fi
  system=$out/trial/$1
  mkdir -p "$out/trial"
  rm -rf "$system"
  cp -a "$base" "$system"
}

# inside COMMAND: a command of the shell in the fresh system, as root, without the environment from outside but for its display.
# /proc, /dev and the sockets of displays are there for this command alone.
inside() {
  unshare --mount bash -euc '
    mount -t proc proc "$1/proc"
    mount --rbind /dev "$1/dev"
    mkdir -p /tmp/.X11-unix "$1/tmp/.X11-unix"
    mount --bind /tmp/.X11-unix "$1/tmp/.X11-unix"
    exec chroot "$1" /usr/bin/env -i PATH=/usr/sbin:/usr/bin:/sbin:/bin HOME=/root LC_ALL=C.UTF-8 \
      DEBIAN_FRONTEND=noninteractive ${DISPLAY:+DISPLAY="$DISPLAY" XAUTHORITY=/tmp/authority} bash -euc "$2"' \
    inside "$system" "$1"
}

# apt_inside PACKAGES...: installs them, with all that they depend on and nothing more.
apt_inside() {
  inside "apt-get update -qq; apt-get install -y -qq --no-install-recommends $* >/tmp/apt.log 2>&1 || { tail -20 /tmp/apt.log; exit 1; }" >&2
}

# has_window PROGRAM DOCUMENT [3d]: the program opens the document in a window of a display outside, so that the system has only
# what it needs itself. The picture of an empty window is some kilobytes, that of one without 3D some 60, that of a whole one 200.
has_window() {
  local least=30000
  [ "${3:-}" != 3d ] || least=100000
  # xvfb-run is no program of bash, and passes no functions on.
  env -u WAYLAND_DISPLAY xvfb-run -a -s '-screen 0 1366x768x24' bash -euc "$(declare -f inside)"'
    system=$1; cp "$XAUTHORITY" "$system/tmp/authority"; inside "$2"' window "$system" \
    "cd /tmp && timeout 120 $1 --screenshot window.png --size 1200x700 $2 && [ \$(stat -c %s window.png) -gt $least ]"
  cp "$system/tmp/window.png" "$out/window-$(basename "$system").png"
}

try_command_line() {
  local examples=/usr/share/geargraph/examples
  fresh_system geargraph-cli "$release"
  cp "$out"/geargraph-cli_*.deb "$system/tmp/"
  apt_inside /tmp/geargraph-cli_*.deb
  inside "! dpkg -l | grep -q libqt6"
  inside "geargraph-cli analyze $examples/robot.geargraph --json | grep -q '\"dof\": 3'"
  inside "geargraph-cli export $examples/robot.geargraph --to svg --view schematic -o /tmp/robot.svg && [ -s /tmp/robot.svg ]"
  inside "source /usr/share/bash-completion/completions/geargraph-cli; COMP_WORDS=(geargraph-cli ana); COMP_CWORD=1
    _geargraph_cli; [ \"\${COMPREPLY[*]}\" = analyze ]"
  inside "zcat /usr/share/man/man1/geargraph-cli.1.gz | grep -q '^.SS analyze'"
  # What a file manager does for a thumbnail.
  inside "cd /tmp && entry=\$(sed -n 's/^Exec=//p' /usr/share/thumbnailers/geargraph.thumbnailer)
    entry=\${entry//%i/$examples/robot.geargraph}; entry=\${entry//%o/thumbnail.png}; \${entry//%s/256}
    [ \"\$(head -c 4 thumbnail.png | tail -c 3)\" = PNG ]"
}

try_step() {
  local examples=/usr/share/geargraph/examples
  fresh_system geargraph-step "$release"
  cp "$out"/geargraph-cli_*.deb "$out"/geargraph-step_*.deb "$system/tmp/"
  apt_inside /tmp/geargraph-cli_*.deb
  inside "! geargraph-cli export $examples/robot.geargraph --to step -o /tmp/robot.step && [ ! -e /tmp/robot.step ]"
  apt_inside /tmp/geargraph-step_*.deb
  inside "geargraph-cli export $examples/robot.geargraph --to step -o /tmp/robot.step && grep -q MANIFOLD_SOLID_BREP /tmp/robot.step"
}

try_python() {
  local examples=/usr/share/geargraph/examples
  fresh_system python3-geargraph "$release"
  cp "$out"/geargraph-cli_*.deb "$out"/python3-geargraph_*.deb "$system/tmp/"
  apt_inside /tmp/geargraph-cli_*.deb /tmp/python3-geargraph_*.deb
  inside "python3 -c 'import geargraph as gg
m = gg.open(\"$examples/robot.geargraph\")
assert m.analyze().dof == 3
print(\"geargraph\", gg.__version__, \"in Python\")'" >&2
  apt_inside python3-numpy python3-pandas python3-sympy
  inside "python3 -c 'import geargraph as gg
a = gg.open(\"$examples/robot.geargraph\").analyze()
assert a.cycle_basis.to_pandas().loc[\"C15\", \"10\"] == -1
print(a.solution.symbols.to_sympy())'" >&2
}

try_editor() {
  local example=/usr/share/geargraph/examples/robot.geargraph
  fresh_system geargraph "$release"
  cp "$out"/geargraph-cli_*.deb "$out"/geargraph_*.deb "$system/tmp/"
  apt_inside /tmp/geargraph-cli_*.deb /tmp/geargraph_*.deb libgl1-mesa-dri fonts-dejavu-core \
    shared-mime-info desktop-file-utils libglib2.0-bin
  inside "geargraph --help >/dev/null && zcat /usr/share/man/man1/geargraph.1.gz | grep -q screenshot"
  has_window geargraph "$example" 3d
  # Documents are known by their first bytes, too, and open with the editor.
  inside "cp $example /tmp/nameless; gio info -a standard::content-type /tmp/nameless | grep -q 'application/vnd.geargraph+json'"
  inside "gio mime application/vnd.geargraph+json | grep -q org.geargraph.geargraph.desktop"
  inside "apt-get purge -y -qq geargraph geargraph-cli >/dev/null 2>&1; [ -z \"\$(find /usr /etc /var/lib -path /var/lib/dpkg -prune \
    -o -name '*geargraph*' -print)\" ]"
}

try_debian_packages() {
  try_command_line
  try_step
  try_python
  try_editor
}

# The archive, in systems that have the C and C++ libraries and neither X, fonts, keyboards nor OpenGL.
try_archives() {
  local folder=/opt/geargraph-$version tried
  [ -n "$(find "$out" -maxdepth 1 -name 'geargraph-*.tar.xz')" ] || return 0
  for tried in bookworm trixie; do
    fresh_system "archive-$tried" "$tried"
    tar -C "$system/opt" -xf "$out"/geargraph-*.tar.xz
    inside "! dpkg -l | grep -q -E 'libx11-6|libgl1|libqt6|fontconfig'"
    inside "$folder/geargraph-cli export $folder/share/geargraph/examples/robot.geargraph --to svg --view digraph -o /tmp/robot.svg"
    has_window "$folder/geargraph" "$folder/share/geargraph/examples/robot.geargraph"
  done
  # 3D needs the drivers that a desktop has.
  apt_inside libgl1-mesa-dri libegl1
  has_window "$folder/geargraph" "$folder/share/geargraph/examples/robot.geargraph" 3d
}

# weights: each package as it is downloaded and as it is installed.
weights() {
  local file installed
  printf '%-50s %12s %12s\n' package 'download MB' 'installed MB'
  for file in "$out"/*.deb "$out"/*.tar.xz; do
    [ -e "$file" ] || continue
    case $file in
      *.deb) installed=$(dpkg-deb -f "$file" Installed-Size) ;;
      *) installed=$(du -sk --apparent-size "$out/stage/geargraph-$version" | cut -f1) ;;
    esac
    printf '%-50s %12s %12s\n' "$(basename "$file")" "$(awk "BEGIN {printf \"%.1f\", $(stat -c %s "$file") / 1e6}")" \
      "$(awk "BEGIN {printf \"%.1f\", $installed / 1e3}")"
  done
}
