"""Write man pages and shell completion from what the programs say with --help.

command_texts.py CLI EDITOR OUT: OUT/geargraph-cli.1, OUT/geargraph.1, OUT/geargraph-cli.bash, OUT/_geargraph-cli
"""

from __future__ import annotations

import os
import re
import subprocess
import sys
from dataclasses import dataclass, field
from pathlib import Path
from typing import Dict, List, Tuple

HELP_COLUMN = 28  # of the options of geargraph-cli
# Options of export with named values, and what has to be said before them.
NAMED_VALUES = {
    "--to": [],
    "--matrix": ["--to", "csv"],
    "--separator": ["--to", "csv", "--matrix", "p"],
    "--decimal": ["--to", "csv", "--matrix", "p"],
    "--view": ["--to", "png"],
    "--from": ["--to", "png", "--view", "3d"],
    "--faces": ["--to", "png", "--view", "3d"],
    "--show": ["--to", "png", "--view", "3d"],
    "--motor": ["--to", "mjcf"],
}


@dataclass
class Option:
    names: str  # "--json", "-h, --help"
    value: str
    help: str


@dataclass
class Command:
    name: str
    usage: str
    summary: str
    groups: List[Tuple[str, List[Option]]] = field(default_factory=list)
    choices: Dict[str, List[str]] = field(default_factory=dict)  # by option: the words that it takes

    def options(self) -> List[Option]:
        return [option for _, options in self.groups for option in options]


def output(words: List[str]) -> str:
    """Run a program without a display and give what it prints."""
    environment = {**os.environ, "QT_QPA_PLATFORM": "offscreen", "LC_ALL": "C.UTF-8"}
    return subprocess.run(
        words, check=True, env=environment, stdout=subprocess.PIPE, encoding="utf-8"
    ).stdout


def read_option(line: str) -> Option:
    """Take apart a line like "  --to FORM   csv: matrices; ..."."""
    if len(line) > HELP_COLUMN and line[HELP_COLUMN - 1] == " ":
        left, text = line[:HELP_COLUMN].split(), line[HELP_COLUMN:]
    else:
        left = line.split(maxsplit=2)[:2]
        text = line.split(maxsplit=2)[2]
    return Option(left[0], " ".join(left[1:]), text)


def read_command(cli: str, name: str) -> Command:
    lines = output([cli, name, "--help"]).rstrip("\n").split("\n")
    assert lines[0].startswith(f"Usage: geargraph-cli {name}"), lines[0]
    command = Command(name, lines[0][len("Usage: ") :], lines[2])
    for line in lines[3:]:
        if line.startswith("Exit status:"):
            break
        if line.endswith(":") and not line.startswith(" "):
            command.groups.append((line[:-1], []))
        elif line.startswith("  -"):  # the other lists, of requests and edits, are for people who ask for them
            command.groups[-1][1].append(read_option(line))
    command.groups = [group for group in command.groups if group[1]]
    assert command.groups, f"{name} --help names no options"
    command.choices = {
        option.names: option.value.split("|") for option in command.options() if "|" in option.value
    }
    if name == "export":
        command.choices.update(read_choices(cli))
    return command


def read_commands(cli: str) -> Tuple[List[Command], str]:
    """Give all commands, and what is said of the exit status."""
    text = output([cli, "--help"])
    listed = text.split("Commands:\n")[1].split("\n\n")[0]
    names = [line.split()[0] for line in listed.split("\n")]
    exit_status = text.split("Exit status: ")[1]
    return [read_command(cli, name) for name in names], " ".join(exit_status.split())


def roff(text: str) -> str:
    """Text as a page of man shows it."""
    text = text.replace("\\", "\\e").replace("-", "\\-")
    text = re.sub(r",(?=\S)", r",\\:", text)  # lists without spaces may be broken
    return re.sub(r"(?m)^([.'])", r"\\&\1", text)


def man_page(name: str, version: str, summary: str, sections: List[Tuple[str, str]]) -> str:
    title = f'.TH {name.upper()} 1 "" "GearGraph {version}" "User Commands"\n.ad l\n'  # .ad l: ragged right
    text = title + f".SH NAME\n{name} \\- {roff(summary)}\n"
    return text + "".join(f".SH {heading}\n{body}" for heading, body in sections)


def option_entry(option: Option) -> str:
    value = f" \\fI{roff(option.value)}\\fR" if option.value else ""
    return f".TP\n\\fB{roff(option.names)}\\fR{value}\n{roff(option.help)}\n"


def cli_page(commands: List[Command], exit_status: str, version: str) -> str:
    body = ""
    for command in commands:
        body += f".SS {command.name}\n{roff(command.usage)}\n.PP\n{roff(command.summary)}\n"
        for group, options in command.groups:
            body += f".PP\n\\fI{roff(group)}\\fR\n" if group != "Options" else ""
            body += "".join(option_entry(option) for option in options)
    return man_page(
        "geargraph-cli",
        version,
        "analysis of geared mechanisms, without a window",
        [
            ("SYNOPSIS", "\\fBgeargraph\\-cli\\fR \\fICOMMAND\\fR \\fIFILE\\fR [\\fIOPTIONS\\fR]\n"),
            (
                "DESCRIPTION",
                roff(
                    "Reads documents of the editor geargraph(1) (*.geargraph). Results go to standard"
                    " output, everything else to standard error. It needs no display.\n"
                ),
            ),
            ("COMMANDS", body),
            ("EXIT STATUS", roff(exit_status) + "\n"),
            ("SEE ALSO", "\\fBgeargraph\\fR(1)\n"),
        ],
    )


def editor_page(editor: str, version: str) -> str:
    text = output([editor, "--help"])
    description = " ".join(text.split("\n\n")[0].split("\n")[1:])
    listed = text.split("Options:\n")[1].split("\n\n")[0]
    options: List[Option] = []
    for line in listed.split("\n"):
        found = re.match(r"^  (-.*?)(?: <(.*?)>)?(?:  +(.*))?$", line)
        if found:
            options.append(Option(found.group(1).strip(), found.group(2) or "", found.group(3) or ""))
        else:
            options[-1].help = f"{options[-1].help} {line.strip()}".strip()
    assert any("--screenshot" in option.names for option in options), listed
    return man_page(
        "geargraph",
        version,
        "editor for geared mechanisms",
        [
            ("SYNOPSIS", "\\fBgeargraph\\fR [\\fIOPTIONS\\fR] [\\fIDOCUMENTS\\fR]\n"),
            ("DESCRIPTION", roff(description) + "\n"),
            ("OPTIONS", "".join(option_entry(option) for option in options)),
            ("SEE ALSO", "\\fBgeargraph\\-cli\\fR(1)\n"),
        ],
    )


def read_choices(cli: str) -> Dict[str, List[str]]:
    """Give the words that options of export take: the program lists them where it is given another."""
    document = '{"format": "geargraph", "version": 1, "links": [{"id": "0"}]}'
    found = {}
    for option, before in NAMED_VALUES.items():
        words = [cli, "export", "-", *before, option, "?", "-o", "-"]
        said = subprocess.run(words, input=document, capture_output=True, encoding="utf-8").stderr
        listed = re.search(r"(?:one of|there are|names) ([a-z0-9, -]+?)(?:, with commas)?\.", said)
        assert listed is not None, f"{option}: {said}"
        found[option] = listed.group(1).split(", ")
    return found


def bash_completion(commands: List[Command]) -> str:
    cases, values = "", ""
    for command in commands:
        words = " ".join(["--help", *(option.names for option in command.options())])
        cases += f"    {command.name}) options='{words}' ;;\n"
        for option, taken in command.choices.items():
            values += f"    '{command.name} {option}') listed='{' '.join(taken)}' ;;\n"
    names = " ".join(command.name for command in commands)
    return f"""# bash completion of geargraph-cli; made from its --help
_geargraph_cli() {{
  local word=${{COMP_WORDS[COMP_CWORD]}} before=${{COMP_WORDS[COMP_CWORD-1]}} options='' listed=''
  COMPREPLY=()
  if [ "$COMP_CWORD" -eq 1 ]; then
    mapfile -t COMPREPLY < <(compgen -W '{names} --help --version' -- "$word")
    return
  fi
  case ${{COMP_WORDS[1]}} in
{cases}  esac
  case "${{COMP_WORDS[1]}} $before" in
{values}  esac
  if [ -n "$listed" ]; then
    mapfile -t COMPREPLY < <(compgen -W "$listed" -- "$word")
  elif [[ $word == -* ]]; then
    mapfile -t COMPREPLY < <(compgen -W "$options" -- "$word")
  else
    compopt -o filenames
    mapfile -t COMPREPLY < <(compgen -f -- "$word")
  fi
}}
complete -F _geargraph_cli geargraph-cli
"""


def zsh_quoted(text: str) -> str:
    """Text inside the brackets of a specification of _arguments, in single quotes."""
    return re.sub(r"([\[\]:\\])", r"\\\1", text).replace("'", "'\\''")


def zsh_completion(commands: List[Command]) -> str:
    described = "".join(
        f"    '{command.name}:{zsh_quoted(command.summary)}'\n" for command in commands
    )
    cases = ""
    for command in commands:
        lines = ""
        for option in command.options():
            taken = command.choices.get(option.names)
            action = f"({' '.join(taken)})" if taken else "_files"
            value = f":{zsh_quoted(option.value)}:{action}" if option.value else ""
            lines += f"        '*{option.names}[{zsh_quoted(option.help)}]{value}' \\\n"
        cases += f"    {command.name})\n      _arguments \\\n{lines}        '*:file:_files'\n      ;;\n"
    return f"""#compdef geargraph-cli
# zsh completion of geargraph-cli; made from its --help
_geargraph_cli() {{
  local -a commands=(
{described}  )
  if (( CURRENT == 2 )); then
    _describe command commands
    return
  fi
  local command=$words[2]
  shift words
  (( CURRENT-- ))
  case $command in
{cases}  esac
}}
_geargraph_cli "$@"
"""


def main(cli: str, editor: str, folder: str) -> None:
    out = Path(folder)
    out.mkdir(parents=True, exist_ok=True)
    commands, exit_status = read_commands(cli)
    version = output([cli, "--version"]).split()[1]
    for name, text in {
        "geargraph-cli.1": cli_page(commands, exit_status, version),
        "geargraph.1": editor_page(editor, version),
        "geargraph-cli.bash": bash_completion(commands),
        "_geargraph-cli": zsh_completion(commands),
    }.items():
        (out / name).write_text(text, encoding="utf-8")


if __name__ == "__main__":
    main(sys.argv[1], sys.argv[2], sys.argv[3])
