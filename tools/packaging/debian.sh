# Debian packages: geargraph, geargraph-cli (without Qt), geargraph-step (OpenCASCADE) and python3-geargraph. Sourced by tools/package.

# Each release has packages of its own, of libraries that other releases do not have.
debian_version() {
  echo "$version-1~deb$(. /etc/os-release && echo "$VERSION_ID")u1"
}

# stage_component PACKAGE COMPONENT: what the build installs of a component, stripped, below /usr.
stage_component() {
  cmake --install "$build" --component "$2" --prefix "$out/stage/$1/usr" --strip >/dev/null
}

# add_text FILE PLACE PACKAGE: a file below /usr, compressed as Debian asks for.
add_text() {
  install -D -m 644 "$1" "$out/stage/$3/usr/$2"
  gzip -9 -n "$out/stage/$3/usr/$2"
}

# maintainer: who makes the packages, from the environment as Debian's tools read it, or from git.
maintainer() {
  echo "${DEBFULLNAME:-$(git -C "$root" config user.name)} <${DEBEMAIL:-$(git -C "$root" config user.email)}>"
}

# library_dependencies PACKAGE: the Debian packages of the libraries that its programs are linked with.
library_dependencies() {
  local work=$out/stage/shlibs programs
  mapfile -t programs < <(cd "$out/stage/$1" && find usr -type f \( -perm -u+x -o -name '*.so' \) -exec file {} + |
    sed -n 's/: *ELF .*//p')
  mkdir -p "$work/debian"
  printf 'Source: geargraph\n\nPackage: %s\nArchitecture: any\n' "$1" >"$work/debian/control"
  (cd "$work" && dpkg-shlibdeps -O "${programs[@]/#/$out/stage/$1/}" 2>/dev/null) | sed -n 's/^shlibs:Depends=//p'
}

# make_debian_package NAME SECTION DEPENDS MORE SUMMARY DESCRIPTION: of what is staged below its name. MORE: further lines.
make_debian_package() {
  local name=$1 stage=$out/stage/$1 depends
  install -D -m 644 "$root/resources/packaging/copyright" "$stage/usr/share/doc/$name/copyright"
  {
    echo "geargraph ($(debian_version)) unstable; urgency=medium"
    printf '\n  * Release %s.\n\n' "$version"
    echo " -- $(maintainer)  $(LC_ALL=C date -u -R -d "@$SOURCE_DATE_EPOCH")"
  } >"$out/texts/changelog.Debian"
  add_text "$out/texts/changelog.Debian" "share/doc/$name/changelog.Debian" "$name"
  add_text "$root/CHANGELOG.md" "share/doc/$name/changelog" "$name"
  depends=$(library_dependencies "$name")
  mkdir -p "$stage/DEBIAN"
  {
    printf 'Package: %s\nVersion: %s\nArchitecture: %s\n' "$name" "$(debian_version)" "$(dpkg --print-architecture)"
    printf 'Maintainer: %s\nSection: %s\nPriority: optional\n' "$(maintainer)" "$2"
    printf 'Installed-Size: %s\n' "$(du -sk --apparent-size "$stage/usr" | cut -f1)"
    printf 'Depends: %s%s\n' "${3:+$3, }" "$depends"
    [ -z "$4" ] || printf '%s\n' "$4"
    printf 'Description: %s\n %s\n' "$5" "$6"
  } >"$stage/DEBIAN/control"
  (cd "$stage" && find usr -type f -exec md5sum {} + | LC_ALL=C sort -k2) >"$stage/DEBIAN/md5sums"
  find "$stage" -type d -exec chmod 755 {} +
  dpkg-deb --root-owner-group -Zxz --build "$stage" "$out/${name}_$(debian_version)_$(dpkg --print-architecture).deb" >/dev/null
}

make_debian_packages() {
  local python
  python=$(python3 -c 'import sys; print("python3 (>= %d.%d), python3 (<< %d.%d)" % (3, sys.version_info[1], 3, sys.version_info[1] + 1))')

  stage_component geargraph-cli cli
  add_text "$out/texts/geargraph-cli.1" share/man/man1/geargraph-cli.1 geargraph-cli
  install -D -m 644 "$out/texts/geargraph-cli.bash" \
    "$out/stage/geargraph-cli/usr/share/bash-completion/completions/geargraph-cli"
  install -D -m 644 "$out/texts/_geargraph-cli" "$out/stage/geargraph-cli/usr/share/zsh/vendor-completions/_geargraph-cli"
  make_debian_package geargraph-cli science "" $'Recommends: libgl1-mesa-dri\nSuggests: geargraph-step' \
    'analysis of geared mechanisms on the command line' \
    'Degrees of freedom, speeds, torques, motion and drawings of epicyclic trains,
 planetary gearboxes and bevel-gear wrists, by the Matroid method and by the
 T-T graph method, exactly; exports for print, 3D programs and simulators.
 .
 It needs neither a display nor Qt.'

  stage_component geargraph-step step
  make_debian_package geargraph-step science "geargraph-cli (= $(debian_version))" '' \
    'STEP files of geared mechanisms, for CAD' \
    'With this program GearGraph exports wheels, bodies and whole trains as STEP
 assemblies: solids with exact planes and cylinders, and with teeth as B-spline
 surfaces. It is run by the editor, the command line and the Python module.'

  stage_component geargraph editor
  install -m 644 "$out/texts/org.geargraph.geargraph.metainfo.xml" "$out/stage/geargraph/usr/share/metainfo"
  add_text "$out/texts/geargraph.1" share/man/man1/geargraph.1 geargraph
  make_debian_package geargraph science "geargraph-cli (= $(debian_version))" 'Recommends: libgl1-mesa-dri, fonts-dejavu-core' \
    'editor and teaching tool for geared mechanisms' \
    'Draw links, turning joints and gear meshes, and see what theory says of them:
 the digraph, its matrices, speeds by two methods, the functional schematic,
 torques and power flow, and the gears with real teeth in motion.'

  stage_component python3-geargraph python
  # 3D files are read by the program of geargraph-cli.
  make_debian_package python3-geargraph python "geargraph-cli (= $(debian_version)), $python" \
    'Suggests: python3-numpy, python3-pandas, python3-sympy' \
    'geared mechanisms in Python' \
    'Mechanisms built and edited in code, analysed exactly by two methods, drawn and
 exported; matrices as NumPy arrays and pandas tables, results as fractions and
 SymPy expressions.'
  # Nobody has uploaded it, so no bug of the distribution asks for it.
  lintian --fail-on error,warning --suppress-tags initial-upload-closes-no-bugs "$out"/*.deb >&2
}
