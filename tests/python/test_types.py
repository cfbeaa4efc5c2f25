"""The package is typed: mypy finds nothing, and the stub of the compiled part tells the truth."""

import os
import subprocess
import sys
from pathlib import Path

from conftest import SOURCE

PROJECT = SOURCE / "app" / "python"
QUICK = Path(__file__).parent / "mypy.ini"  # without looking into the libraries that are optional


def run(words, tmp_path):
    environment = {**os.environ, "MYPYPATH": str(PROJECT)}
    return subprocess.run(
        [sys.executable, "-m", *words], capture_output=True, text=True, env=environment, cwd=tmp_path,
    )


def test_mypy_finds_nothing(tmp_path):
    config = f"--config-file={PROJECT / 'pyproject.toml'}"
    found = run(["mypy", config, f"--cache-dir={tmp_path / 'cache'}", "-p", "geargraph"], tmp_path)
    assert found.returncode == 0, found.stdout


def test_the_stub_is_that_of_the_module(tmp_path):
    options = [f"--mypy-config-file={QUICK}", f"--allowlist={QUICK.with_name('stubtest.txt')}"]
    found = run(["mypy.stubtest", *options, "geargraph._geargraph"], tmp_path)
    assert found.returncode == 0, found.stdout + found.stderr


def test_types_are_those_that_users_see(tmp_path):
    (tmp_path / "use.py").write_text(
        "from fractions import Fraction\n"
        "from typing import Dict, Tuple\n"
        "import geargraph as gg\n"
        "m = gg.Mechanism('robot')\n"
        "link: gg.Link = m.add_link()\n"
        "speeds: Dict[int, Fraction] = m.analyze().joint_speeds\n"
        "gears: Tuple[gg.Gear, ...] = m.analyze().gears\n"
        "wrong: int = m.analyze().drawing().svg\n"
    )
    found = run(["mypy", "--strict", f"--config-file={QUICK}", f"--cache-dir={tmp_path / 'cache'}", "use.py"], tmp_path)
    lines = found.stdout.splitlines()
    assert [line for line in lines if "error" in line] and "use.py:8" in lines[0]
    assert lines[-1].startswith("Found 1 error"), found.stdout
