# The man pages and the completion that packages bring: command_texts.sh PYTHON SCRIPT CLI EDITOR FOLDER
set -euo pipefail
python=$1 script=$2 cli=$3 editor=$4 texts=$5
rm -rf "$texts"
"$python" -B "$script" "$cli" "$editor" "$texts"

fail() {
  echo "$1" >&2
  exit 1
}

# Every option that a command's help names has its entry.
for command in $("$cli" --help | sed -n '/^Commands:/,/^$/ s/^  \([a-z]*\) .*/\1/p'); do
  grep -q "^\.SS $command$" "$texts/geargraph-cli.1" || fail "The man page lacks $command."
  for option in $("$cli" "$command" --help | sed -n 's/^  \(-[a-z-]*\).*/\1/p'); do
    grep -qF "\fB${option//-/\\-}\fR" "$texts/geargraph-cli.1" || fail "The man page lacks $command $option."
  done
done
grep -qF '\fB\-\-screenshot\fR \fIfile\fR' "$texts/geargraph.1" || fail "The man page lacks --screenshot."

# A list without spaces that no line of 80 columns holds can be broken at its commas: lintian looks at that, too.
long=$(sed 's/\\:/ /g; s/\\-/-/g' "$texts/geargraph-cli.1" | tr ' ' '\n' | awk 'length > 70' | grep -v '^"*http' || true)
[ -z "$long" ] || fail "No line of the man page holds $long"

# Who asks over a remote line has no display.
env -u DISPLAY -u WAYLAND_DISPLAY -u QT_QPA_PLATFORM "$editor" --help | grep -q -- --screenshot ||
  fail "The editor's --help needs a display."

# completes WORDS...: what the last word is completed to.
source "$texts/geargraph-cli.bash"
completes() {
  COMP_WORDS=(geargraph-cli "$@")
  COMP_CWORD=$#
  _geargraph_cli
  echo "${COMPREPLY[*]}"
}
expect() {
  local found
  found=$(completes "${@:2}")
  [ "$found" = "$1" ] || fail "\"${*:2}\" completes to \"$found\" instead of \"$1\"."
}
expect analyze ana
expect '--no-symbolic' analyze robot.geargraph --no-s
expect 'md mjcf modelica' export robot.geargraph --to m
expect 'geargraph graphml' convert robot.csv --to g
expect 'ttgraph' export robot.geargraph --view t
expect 'stiffness' statics robot.geargraph --share s
