"""Builds the Python module by CMake, for pip: a build backend [PEP 517, PEP 660].

A build folder that is there is used where the environment names it as GEARGRAPH_BUILD, or pip is told
--config-settings build=FOLDER (from the checkout); else one is made, build/python-<version>.
"""

from __future__ import annotations

import base64
import hashlib
import os
import re
import subprocess
import sys
import sysconfig
import zipfile
from pathlib import Path
from typing import Dict, List, Optional, Tuple

HERE = Path(__file__).resolve().parent.parent
ROOT = HERE.parent.parent
Settings = Optional[Dict[str, str]]


def _version() -> str:
    text = (ROOT / "CMakeLists.txt").read_text(encoding="utf-8")
    found = re.search(r"project\(GearGraph VERSION ([0-9.]+)", text)
    assert found is not None, "CMakeLists.txt states no version"
    return found.group(1)


def _tag() -> str:
    python = f"cp{sys.version_info.major}{sys.version_info.minor}"
    platform = re.sub(r"[-.]", "_", sysconfig.get_platform())
    return f"{python}-{python}-{platform}"


def _metadata() -> Dict[str, str]:
    version = _version()
    metadata = "\n".join(
        [
            "Metadata-Version: 2.1",
            "Name: geargraph",
            f"Version: {version}",
            "Summary: Geared mechanisms: built, analysed by the Matroid and the T-T graph method,"
            " drawn and exported",
            "License: MIT",
            "Requires-Python: >=3.9",
            "Provides-Extra: arrays",
            'Requires-Dist: numpy; extra == "arrays"',
            "Provides-Extra: tables",
            'Requires-Dist: pandas; extra == "tables"',
            "Provides-Extra: symbols",
            'Requires-Dist: sympy; extra == "symbols"',
            "",
        ]
    )
    wheel = "\n".join(
        ["Wheel-Version: 1.0", "Generator: geargraph_build", "Root-Is-Purelib: false",
         f"Tag: {_tag()}", ""]
    )
    folder = f"geargraph-{version}.dist-info"
    licence = (ROOT / "LICENSE").read_text(encoding="utf-8")
    return {f"{folder}/METADATA": metadata, f"{folder}/WHEEL": wheel, f"{folder}/LICENSE": licence}


def _run(words: List[str]) -> None:
    print("+", " ".join(words), flush=True)
    subprocess.run(words, check=True)


def _built(settings: Settings) -> Path:
    """Build the importable package and give its folder."""
    named = (settings or {}).get("build") or os.environ.get("GEARGRAPH_BUILD")
    version = f"{sys.version_info.major}.{sys.version_info.minor}"
    build = ROOT / (named or f"build/python-{version}")
    if not (build / "CMakeCache.txt").exists():
        _run(
            ["cmake", "-S", str(ROOT), "-B", str(build), "-G", "Ninja", "-DCMAKE_BUILD_TYPE=Release",
             "-DGEARGRAPH_QT=OFF", "-DGEARGRAPH_UNITY=ON",
             f"-DGEARGRAPH_PYTHON_EXECUTABLE={sys.executable}"]
        )
    _run(["cmake", "--build", str(build), "--target", "geargraph_python"])
    return build


def _files(build: Path) -> List[Tuple[str, Path]]:
    """Name each file of the package in the wheel, and where it is."""
    package = build / "python" / "geargraph"
    module = f"_geargraph{sysconfig.get_config_var('EXT_SUFFIX')}"
    if not (package / module).exists():
        raise SystemExit(f"{build} was built for another Python than {sys.executable}")
    files = [
        (f"geargraph/{path.name}", path)
        for path in sorted(package.iterdir()) if path.suffix in (".py", ".pyi")
        or path.name in ("py.typed", module)
    ]
    return files + [("geargraph/geargraph-mesh", build / "app" / "mesh" / "geargraph-mesh")]


class _Wheel:
    """A wheel that is written file by file, with the record of what is in it."""

    def __init__(self, folder: str) -> None:
        self.name = f"geargraph-{_version()}-{_tag()}.whl"
        self._archive = zipfile.ZipFile(Path(folder) / self.name, "w", zipfile.ZIP_DEFLATED)
        self._record: List[str] = []

    def add(self, name: str, data: bytes, executable: bool = False) -> None:
        info = zipfile.ZipInfo(name, (1980, 1, 1, 0, 0, 0))
        info.compress_type = zipfile.ZIP_DEFLATED
        info.external_attr = (0o100755 if executable else 0o100644) << 16
        self._archive.writestr(info, data)
        digest = base64.urlsafe_b64encode(hashlib.sha256(data).digest()).rstrip(b"=").decode()
        self._record.append(f"{name},sha256={digest},{len(data)}")

    def close(self) -> str:
        for name, text in _metadata().items():
            self.add(name, text.encode())
        record = f"geargraph-{_version()}.dist-info/RECORD"
        self._archive.writestr(record, "\n".join(self._record + [f"{record},,", ""]))
        self._archive.close()
        return self.name


def get_requires_for_build_wheel(config_settings: Settings = None) -> List[str]:
    return []


def get_requires_for_build_editable(config_settings: Settings = None) -> List[str]:
    return []


def prepare_metadata_for_build_wheel(
    metadata_directory: str, config_settings: Settings = None
) -> str:
    for name, text in _metadata().items():
        path = Path(metadata_directory) / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(text, encoding="utf-8")
    return f"geargraph-{_version()}.dist-info"


prepare_metadata_for_build_editable = prepare_metadata_for_build_wheel


def build_wheel(
    wheel_directory: str, config_settings: Settings = None,
    metadata_directory: Optional[str] = None,
) -> str:
    build = _built(config_settings)
    wheel = _Wheel(wheel_directory)
    for name, path in _files(build):
        wheel.add(name, path.read_bytes(), executable=os.access(path, os.X_OK))
    return wheel.close()


def build_editable(
    wheel_directory: str, config_settings: Settings = None,
    metadata_directory: Optional[str] = None,
) -> str:
    build = _built(config_settings)
    wheel = _Wheel(wheel_directory)
    wheel.add("geargraph.pth", f"{build / 'python'}\n".encode())
    return wheel.close()


def build_sdist(sdist_directory: str, config_settings: Settings = None) -> str:
    raise NotImplementedError("The sources are those of the whole project: git archive makes them.")
