"""How long programs take to come up: startup.py BUILD PAGE

Times are of the processor, the least of many runs, and are written as multiples of what Python itself takes to come up
(python3 -c pass) and, for modules, of what is added to that.
"""

import os
import resource
import shutil
import subprocess
import sys
import tempfile
from pathlib import Path

ROUNDS = 60
PYTHON = "/usr/bin/python3"


def cost(words: list, environment: dict) -> float:
    """Give the least processor time of a command, in s."""
    least = float("inf")
    for _ in range(ROUNDS):
        before = resource.getrusage(resource.RUSAGE_CHILDREN)
        subprocess.run(words, env=environment, check=True, stdout=subprocess.DEVNULL)
        after = resource.getrusage(resource.RUSAGE_CHILDREN)
        least = min(least, after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime)
    return least


def measured(build: Path, source: Path) -> str:
    """Give the table in Markdown."""
    with tempfile.TemporaryDirectory() as folder:
        shutil.copytree(build / "python" / "geargraph", Path(folder) / "geargraph")
        environment = {**os.environ, "PYTHONPATH": folder}
        environment.pop("PYTHONDONTWRITEBYTECODE", None)  # as installed: compiled
        cli = str(build / "app/cli/geargraph-cli")
        robot = str(source / "resources/examples/robot.geargraph")
        python = cost([PYTHON, "-c", "pass"], environment)

        def module(name: str) -> float:
            subprocess.run([PYTHON, "-c", f"import {name}"], env=environment, check=True)
            return (cost([PYTHON, "-c", f"import {name}"], environment) - python) / python

        rows = [
            ("`geargraph-cli --version`", cost([cli, "--version"], environment) / python),
            ("`geargraph-cli analyze robot.geargraph`", cost([cli, "analyze", robot], environment) / python),
            ("`geargraph-cli analyze robot.geargraph --json`", cost([cli, "analyze", robot, "--json"], environment) / python),
            ("`import geargraph`, beside Python itself", module("geargraph")),
            ("`import numpy`, beside Python itself", module("numpy")),
            ("`import sympy`, beside Python itself", module("sympy")),
        ]
        lines = ["| start | times `python3 -c pass` |", "| --- | --- |"]
        lines += [f"| {name} | {ratio:.1f} |" for name, ratio in rows]
        print(f"python3 -c pass: {python * 1000:.1f} ms")
        return "\n".join(lines)


def main(build: Path, readme: Path) -> None:
    text = readme.read_text(encoding="utf-8")
    begin, end = "<!-- startup -->\n", "\n<!-- /startup -->"
    before, rest = text.split(begin)
    table = measured(build, readme.parent)
    print(table)
    readme.write_text(before + begin + table + end + rest.split(end)[1], encoding="utf-8")


if __name__ == "__main__":
    main(Path(sys.argv[1]), Path(sys.argv[2]))
