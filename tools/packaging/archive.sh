# The archive for any Linux with glibc 2.36: a folder with programs, their libraries, plugins and fonts, which runs from wherever
# it is unpacked. Sourced by tools/package.

# What stays the system's: the C and C++ libraries, which drivers of graphics cards share with the program.
readonly kSystemLibraries='^(linux-vdso|ld-linux|libc|libm|libdl|librt|libpthread|libresolv|libstdc[+][+]|libgcc_s)[.-]'

# copy_libraries FILES...: all libraries that the files need, with those that these need.
copy_libraries() {
  local name path
  ldd "$@" 2>/dev/null | awk '/=> \// {print $1, $3}' | sort -u | while read -r name path; do
    if [[ ! $name =~ $kSystemLibraries ]]; then
      [ -e "$folder/lib/$name" ] || install -D -m 644 "$(readlink -f "$path")" "$folder/lib/$name"
    fi
  done
}

# find_libraries_at PLACE FILES...: the files look for libraries at this place, seen from where they are.
find_libraries_at() {
  local place=$1
  shift
  patchelf --set-rpath "\$ORIGIN/$place" "$@"
}

# starter NAME: a script beside bin that starts a program with what a bare system may lack.
starter() {
  cat >"$folder/$1" <<'SCRIPT'
#!/bin/sh
# Starts the program with the plugins, and where the system has none, the fonts and keyboards of this folder. Without any driver of
# OpenGL for windows, Qt would abort when it asks the display for them; 3D is painted beside the window then.
here=$(dirname "$(readlink -f "$0")")
export GVBINDIR="$here/lib/graphviz"
[ -e /etc/fonts/fonts.conf ] || export FONTCONFIG_FILE="$here/share/fonts.conf"
[ -d /usr/share/X11/xkb ] || export XKB_CONFIG_ROOT="$here/share/xkb"
export PATH="$PATH:/sbin:/usr/sbin"
if [ -z "$QT_XCB_GL_INTEGRATION" ] && command -v ldconfig >/dev/null && ! ldconfig -p | grep -q libGLX_; then
  export QT_XCB_GL_INTEGRATION=none
fi
exec "$here/bin/$(basename "$0")" "$@"
SCRIPT
  chmod 755 "$folder/$1"
}

make_archive() {
  local folder=$out/stage/geargraph-$version plugins qt_plugins graphviz component
  mkdir -p "$folder"
  for component in cli editor; do
    cmake --install "$build" --component "$component" --prefix "$folder" --strip >/dev/null
  done
  qt_plugins=$(qtpaths6 --query QT_INSTALL_PLUGINS)
  for plugins in platforms/libqxcb platforms/libqoffscreen xcbglintegrations/libqxcb-egl-integration \
    xcbglintegrations/libqxcb-glx-integration iconengines/libqsvgicon imageformats/libqsvg imageformats/libqjpeg \
    platforminputcontexts/libcomposeplatforminputcontextplugin printsupport/libcupsprintersupport; do
    [ ! -e "$qt_plugins/$plugins.so" ] || install -D -m 644 "$qt_plugins/$plugins.so" "$folder/plugins/$plugins.so"
  done
  printf '[Paths]\nPrefix = ..\nPlugins = plugins\n' >"$folder/bin/qt.conf"

  # Graphviz loads its layouts as plugins, which a file lists.
  graphviz=$(dirname "$(find /usr/lib -name 'libgvplugin_dot_layout.so.6' | head -1)")
  for plugins in dot_layout core; do
    install -D -m 644 "$graphviz/libgvplugin_$plugins.so.6" "$folder/lib/graphviz/libgvplugin_$plugins.so.6"
  done
  sed -n '/^libgvplugin_\(dot_layout\|core\)\.so/,/^}/p' "$graphviz/config6a" >"$folder/lib/graphviz/config6a"

  copy_libraries "$folder"/bin/geargraph* "$folder"/libexec/geargraph/* "$folder"/plugins/*/*.so "$folder"/lib/graphviz/*.so.6
  find_libraries_at ../lib "$folder"/bin/geargraph "$folder"/bin/geargraph-cli
  find_libraries_at ../../lib "$folder"/libexec/geargraph/* "$folder"/plugins/*/*.so
  find_libraries_at .. "$folder"/lib/graphviz/*.so.6
  find_libraries_at . "$folder"/lib/*.so*

  install -D -m 644 -t "$folder/share/fonts" /usr/share/fonts/truetype/dejavu/DejaVuSans{,-Bold}.ttf
  cat >"$folder/share/fonts.conf" <<'FONTS'
<?xml version="1.0"?>
<fontconfig><dir prefix="relative">fonts</dir><cachedir prefix="xdg">fontconfig</cachedir></fontconfig>
FONTS
  cp -r /usr/share/X11/xkb "$folder/share/xkb"
  install -m 644 "$root/README.md" "$root/LICENSE" "$root/CHANGELOG.md" "$folder"
  install -D -m 644 -t "$folder/share/man/man1" "$out"/texts/*.1
  starter geargraph
  starter geargraph-cli
  XZ_OPT=-T0 tar -C "$out/stage" --sort=name --owner=0 --group=0 --mtime="@$SOURCE_DATE_EPOCH" -cJf \
    "$out/geargraph-$version-$(uname -m).tar.xz" "geargraph-$version"
}
