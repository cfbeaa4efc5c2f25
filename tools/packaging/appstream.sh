# What software centres show: screenshots, and AppStream metadata that names them. Sourced by tools/package.

# screenshot NAME EXAMPLE OPTIONS...: the window with an example.
screenshot() {
  local name=$1 example=$2
  shift 2
  env -u DISPLAY -u WAYLAND_DISPLAY XDG_CONFIG_HOME="$out/stage/settings" xvfb-run -a -s '-screen 0 1400x900x24' timeout 120 \
    "$build/app/editor/geargraph" "$root/resources/examples/$example.geargraph" \
    --size 1280x720 --screenshot "$out/screenshots/$name.png" "$@" >&2
}

# of_screenshot NAME CAPTION [default]: its element of the metadata.
of_screenshot() {
  printf '    <screenshot%s>\n      <caption>%s</caption>\n' "${3:+ type=\"$3\"}" "$2"
  printf '      <image type="source" width="1280" height="720">%s/screenshots/%s.png</image>\n    </screenshot>\n' \
    "${GEARGRAPH_HOMEPAGE%/}" "$1"
}

# make_metadata: AppStream takes screenshots from the web only, so that they are named where the project has a place there.
make_metadata() {
  local from=$root/resources/packaging/org.geargraph.geargraph.metainfo.xml
  local to=$out/texts/org.geargraph.geargraph.metainfo.xml
  mkdir -p "$out/screenshots"
  screenshot robot robot
  screenshot gearbox ravigneaux
  if [ -n "${GEARGRAPH_HOMEPAGE:-}" ]; then
    {
      sed '/<launchable/,$d' "$from"
      printf '  <url type="homepage">%s</url>\n  <screenshots>\n' "$GEARGRAPH_HOMEPAGE"
      of_screenshot robot 'A wrist of bevel gears: its digraph, matrices, speeds and gears' default
      of_screenshot gearbox 'A gearbox with brakes and clutches'
      printf '  </screenshots>\n'
      sed -n '/<launchable/,$p' "$from"
    } >"$to"
  else
    cp "$from" "$to"
    echo 'No screenshots are named in the AppStream metadata: GEARGRAPH_HOMEPAGE is not set.' >&2
  fi
  appstreamcli validate --no-net "$to" >&2
}
