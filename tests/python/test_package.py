"""The package: what importing costs and brings, docstrings, types, wheels."""

import inspect
import os
import re
import subprocess
import sys
from pathlib import Path

import geargraph as gg
import pytest
from conftest import SOURCE

PROJECT = SOURCE / "app" / "python"


def python(code, **environment):
    return subprocess.run(
        [sys.executable, "-c", code], check=True, capture_output=True, text=True,
        env={**os.environ, **environment},
    ).stdout


def test_importing_brings_no_large_library():
    brought = python("import geargraph, sys; print(*sys.modules)").split()
    assert not {"numpy", "pandas", "sympy", "IPython", "matplotlib"} & set(brought)


def test_it_works_without_the_optional_libraries():
    code = (
        "import sys\n"
        "for name in ('numpy', 'pandas', 'sympy'): sys.modules[name] = None\n"
        "import geargraph as gg\n"
        "a = gg.sets.planetary(24, 18).analyze()\n"
        "print(a.joint_speeds, a.incidence.to_list(), a.solution.fractions, a.drawing().svg[:4])\n"
        "try: a.incidence.to_numpy()\n"
        "except ImportError: print('no numpy')\n"
    )
    assert python(code).strip().endswith("no numpy")


def test_the_lines_of_the_readme_give_results(tmp_path):
    """Every expression of README's example has a value, and motions do not end at once."""
    block = re.search(r"## Python\n\n```python\n(.*?)```", (SOURCE / "README.md").read_text(), re.S)[1]
    block = block.replace('"resources/', f'"{SOURCE}/resources/')
    block = block.replace('"robot.', f'"{tmp_path}/robot.')
    names = {}
    shown = 0
    for line in (each for part in block.splitlines() for each in part.split("; ")):
        code = line.split("  #")[0].strip()
        try:
            compiled = compile(code, "README", "eval")
        except SyntaxError:
            exec(code, names)
            continue
        value = eval(compiled, names)
        writes = ".save(" in code or ".export(" in code
        assert writes or value is not None, code
        if isinstance(value, tuple):
            assert all(part is not None for part in value), code
        shown += not writes
    assert shown >= 6
    motion = names["a"].dynamics.simulate(0.1, {8: 0.1}).to_pandas()
    assert motion.index[-1] == pytest.approx(0.1)
    assert (tmp_path / "robot.png").exists() and (tmp_path / "robot.glb").exists()


def public_objects():
    for module in (gg, gg.exercises, gg.sets):
        for name in module.__all__:
            value = getattr(module, name)
            yield f"{module.__name__}.{name}", value
            if inspect.isclass(value):
                for member, inner in inspect.getmembers(value):
                    own = any(member in base.__dict__ for base in value.__mro__
                              if base.__module__.startswith("geargraph"))
                    if not member.startswith("_") and own and not _is_field(value, member):
                        yield f"{module.__name__}.{name}.{member}", inner


def _is_field(owner, member):
    slots = [slot for base in owner.__mro__ for slot in getattr(base, "__slots__", ())]
    return member in getattr(owner, "_fields", ()) or member in slots


OBJECTS = dict(public_objects())


def section(doc, name):
    found = re.search(rf"^{name}\n-+\n(.*?)(?=^\w[\w ]*\n-+\n|\Z)", doc, re.M | re.S)
    return found.group(1) if found else None


@pytest.mark.parametrize("name", OBJECTS)
def test_docstrings_are_complete(name):
    value = OBJECTS[name]
    if inspect.ismodule(value):
        assert value.__doc__
        return
    doc = inspect.getdoc(value)
    assert doc and re.search(r"[.?:;)\]]\s*$", doc.split("\n\n")[0]), name
    if inspect.isclass(value):
        fields = getattr(value, "_fields", ())
        listed = section(doc, "Attributes") or ""
        for field in fields:
            assert re.search(rf"^(\w+, )*{field}(, \w+)* :", listed, re.M), f"{name}: {field}"
        return
    if not callable(value):
        return  # a property: its sentence is enough
    signature = inspect.signature(value)
    parameters = [p for p in signature.parameters.values() if p.name not in ("self", "cls")]
    listed = section(doc, "Parameters") or ""
    for parameter in parameters:
        stars = {parameter.VAR_POSITIONAL: r"\*", parameter.VAR_KEYWORD: r"\*\*"}.get(parameter.kind, "")
        assert re.search(rf"^(\w+, )*{stars}{parameter.name}(, \w+)*( :|$)", listed, re.M), f"{name}: {parameter}"
    if signature.return_annotation not in (None, "None"):
        assert section(doc, "Returns") or section(doc, "Yields"), name


def test_examples_in_docstrings_are_true():
    import doctest
    import importlib

    for name in ("", "._mechanism"):
        failed, tried = doctest.testmod(importlib.import_module("geargraph" + name))
        assert tried and not failed, name


def test_names_that_are_listed_exist_and_no_others():
    public = {name for name in vars(gg) if not name.startswith("_")}
    assert set(gg.__all__) <= public
    extra = public - set(gg.__all__)
    assert extra <= {"annotations", "PathLike"}


def test_the_version_is_the_projects():
    text = (SOURCE / "CMakeLists.txt").read_text()
    assert f"VERSION {gg.__version__} " in text


def test_a_wheel_is_made_of_the_build(tmp_path):
    build = Path(gg.__file__).parents[2]
    pip = [sys.executable, "-m", "pip", "--quiet", "install", "--no-build-isolation", "--no-deps",
           "--no-index", "--disable-pip-version-check", "--target", str(tmp_path / "site"),
           f"--config-settings=build={build}", str(PROJECT)]
    subprocess.run(pip, check=True, capture_output=True)
    site = tmp_path / "site"
    there = {path.name for path in (site / "geargraph").iterdir()}
    assert {"__init__.py", "py.typed", "_geargraph.pyi", "geargraph-mesh"} <= there
    assert os.access(site / "geargraph" / "geargraph-mesh", os.X_OK)
    used = python("import geargraph; print(geargraph.__file__)", PYTHONPATH=str(site))
    assert Path(used.strip()).parent == site / "geargraph"


def test_the_backend_refuses_a_build_for_another_python(tmp_path):
    sys.path.insert(0, str(PROJECT / "backend"))
    import geargraph_build

    (tmp_path / "python" / "geargraph").mkdir(parents=True)
    with pytest.raises(SystemExit):
        geargraph_build._files(tmp_path)
    assert geargraph_build.get_requires_for_build_wheel() == []
