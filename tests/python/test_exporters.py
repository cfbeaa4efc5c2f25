"""Every format of the registry, from Python."""

import os

import geargraph as gg
import pytest
from conftest import EXAMPLES


def quick(exporter):
    options = {}
    for option in exporter.options:
        if option.needed:
            options[option.name] = option.choices[0]
        if option.name == "tolerance":
            options[option.name] = 0.2
        if option.name == "size":
            options[option.name] = "64x48"
        if option.name == "frames":
            options[option.name] = int(option.bounds[0])
    return options


def test_every_exporter_writes(tmp_path):
    a = gg.open(EXAMPLES / "spur-pair.geargraph").analyze()  # one input, for URDF
    assert len({each.id for each in gg.exporters()}) == len(gg.exporters()) > 25
    for exporter in gg.exporters():
        path = tmp_path / (exporter.id + ("." + exporter.suffix if exporter.suffix else ""))
        a.export_as(exporter.id, path, **quick(exporter))
        assert path.is_dir() == exporter.folder, exporter.id
        assert os.listdir(path) if exporter.folder else path.stat().st_size > 0, exporter.id


def test_endings_are_those_of_the_registry(robot, tmp_path):
    a = robot.analyze()
    a.export(tmp_path / "robot.mo")
    assert "model" in (tmp_path / "robot.mo").read_text()
    a.export(tmp_path / "robot.json", view="ttgraph")
    assert '"chord"' in (tmp_path / "robot.json").read_text()
    with pytest.raises(ValueError):
        a.export(tmp_path / "robot.none")


def test_refusals_have_the_codes_that_are_listed(tmp_path):
    m = gg.Mechanism()
    m.add_link()
    a = m.analyze()
    by_id = {each.id: each for each in gg.exporters()}
    with pytest.raises(gg.Error) as caught:
        a.export_as("png-3d", tmp_path / "loose.png")
    assert caught.value.code == "no-spanning-tree"
    assert caught.value.code in by_id["png-3d"].refusals
    assert os.listdir(tmp_path) == []


def test_a_format_that_cannot_hold_the_mechanism_says_so(robot, tmp_path):
    with pytest.raises(gg.Error, match="URDF") as caught:
        robot.analyze().export_as("urdf", tmp_path / "robot", tolerance=0.2)
    assert caught.value.code == "not-expressible"


def test_wrong_options_are_named(robot, tmp_path):
    a = robot.analyze()
    with pytest.raises(TypeError, match="--motor"):
        a.export_as("dot", tmp_path / "robot.dot", motor="none")
    with pytest.raises(ValueError, match="--timestep"):
        a.export_as("mjcf", tmp_path / "robot", timestep=2)
    with pytest.raises(ValueError):
        a.export_as("none", tmp_path / "robot")
    assert os.listdir(tmp_path) == []


def test_files_that_are_there_stay(robot, tmp_path):
    a = robot.analyze()
    a.export_as("csv-all", tmp_path / "tables")
    with pytest.raises(gg.Error) as caught:
        a.export_as("csv-all", tmp_path / "tables")
    assert caught.value.code == "file"
    a.export_as("csv-all", tmp_path / "tables", overwrite=True, no_labels=True)
