"""Results: arrays, tables, expressions, statics, pictures, files."""

import json
import subprocess
import xml.etree.ElementTree as ElementTree
from fractions import Fraction

import geargraph as gg
import numpy as np
import pandas as pd
import pytest
import sympy
from conftest import EXAMPLES


def test_pandas_frames_have_the_labels(robot):
    frame = robot.analyze().cycle_basis.to_pandas()
    assert list(frame.index) == ["C15", "C16", "C17", "C18"]
    assert frame.loc["C15", "10"] == -1
    exact = robot.analyze().solution.fractions.to_pandas()
    assert isinstance(exact.iloc[0, 0], Fraction)


def test_sympy_solution_at_the_ratios_is_the_exact_one(robot):
    a = robot.analyze()
    symbols = a.solution.symbols.to_sympy()
    values = {
        sympy.Symbol(name, positive=True): sympy.Rational(ratio.numerator, ratio.denominator)
        for name, ratio in a.ratios.items()
    }
    assert symbols.subs(values) == a.solution.fractions.to_sympy()
    step = a.tt_graph.steps[-1]
    expected = [a.solution.fractions[step.joint, label] for label in a.inputs]
    assert [formula.to_sympy().subs(values) for formula in step.after] == expected


def test_irrational_lengths_have_no_fractions():
    m = gg.Mechanism()
    one, two = m.add_link(), m.add_link()
    m.add_turning_joint(0, one, "a", point=(0, 0, 0), direction=(1, 1, 0))
    m.add_turning_joint(0, two, "b", point=(0, 0, 0), direction=(0, 0, 1))
    m.add_mesh(one, two, (20, 30), kind="bevel")
    a = m.analyze()
    assert a.screws.fractions is None and a.screws.decimals.shape[1] == 6
    assert a.solution.fractions.at(0, 0) in (Fraction(2, 3), Fraction(-2, 3))


def test_what_is_undefined_tells_why():
    m = gg.Mechanism()
    m.add_link()
    a = m.analyze()
    assert a.incidence.shape == (2, 0)
    for ask in (lambda: a.path, lambda: a.solution, lambda: a.rank, lambda: a.gears, lambda: a.joint_speeds):
        with pytest.raises(gg.Error) as caught:
            ask()
        assert caught.value.code == "disconnected"
        assert caught.value.elements == (gg.Element("link", m.links[1].id),)
    assert [d.code for d in a.diagnostics] == ["disconnected"]
    assert not a.ok


def test_invalid_inputs(robot):
    robot.set_inputs([8, 10, 11])
    with pytest.raises(gg.Error) as caught:
        robot.analyze().solution
    assert caught.value.code == "invalid-inputs"


def test_statics_of_both_methods(robot):
    robot.add_torque(10, joint=14)
    s = robot.analyze().statics()
    assert s.held and s.agree
    assert {balance.joint for balance in s.balances} == {8, 9, 11}
    rates = robot.analyze().solution.fractions
    assert [heading.label for heading in s.solution.columns] == [10, 12, 13, 14]
    assert all(s.solution[i, j] == -rates[j, i] for i in (8, 9, 11) for j in (10, 12, 13, 14))
    # Power in = power out: sum of torque times rate over all joints is 0.
    speeds = robot.analyze().joint_speeds
    assert sum(torque * speeds[joint] for joint, torque in s.joint_torques.items()) == 0
    assert [force.mesh for force in s.mesh_forces] == [15, 16, 17, 18]
    assert len(s.bearings) == 7
    assert list(s.to_pandas().index) == [15, 16, 17, 18]
    lossy = robot.analyze().statics(efficiency="0.98")
    assert lossy.efficiency is not None and lossy.power["loss"] > 0
    assert s.json["format"] == "geargraph-statics"


def test_a_shift_table_is_a_frame():
    states = gg.sets.ravigneaux().analyze().states
    assert isinstance(states, tuple) and states[0].name
    frame = states.to_pandas()
    assert list(frame.index) == [state.name for state in states]
    assert list(frame["ratio"]) == [state.ratio for state in states]
    first = states[0]
    assert {label: frame.loc[first.name, label] for label in first.joint_speeds} == first.joint_speeds


def test_unknown_matrices_list_the_known_ones(robot):
    with pytest.raises(ValueError, match="no matrix 'gamma'; these are incidence, .*cutset"):
        robot.analyze().matrix("gamma")


def test_quantities_by_name(robot):
    analysis = robot.analyze()
    assert analysis.quantity("p") is analysis.coefficients
    cutsets, circuits = analysis.quantity("tt-cutsets"), analysis.quantity("tt-circuits")
    assert cutsets.fractions.shape == (7, 15) and circuits.fractions.shape == (8, 15)
    assert not (circuits.to_numpy() @ cutsets.to_numpy().T).any()  # B Q'ᵀ = 0
    equations = analysis.quantity("cutset-equations")
    assert (equations.to_numpy() == analysis.coefficients.to_numpy().T).all()
    assert equations.fractions is None and equations.symbols is None
    with pytest.raises(ValueError, match="no quantity 'q'; these are screw, .*tt-cutsets"):
        analysis.quantity("q")


def test_statics_in_a_state():
    m = gg.sets.ravigneaux()
    m.add_torque(100, link=3)
    for state in m.analyze().states:
        s = m.analyze().statics(state=state.name)
        assert s.engaged == state.engaged
    with pytest.raises(gg.Error):
        m.analyze().statics(state="9")


def test_frequencies():
    m = gg.sets.planetary(sun=24, planet=18)
    a = m.analyze()
    (found,) = a.vibration(rpm=6000, planets=3)
    assert found.state is None and found.reason is None
    carrier = m.link(found.lines[0].link)
    meshes = [line for line in found.lines if line.kind == "tooth-mesh"]
    ring = next(mesh for mesh in m.meshes if 60 in (mesh.tail_teeth, mesh.head_teeth))
    turns = {line.link: line.ratio for line in found.lines if line.kind == "shaft"}
    assert carrier.id in turns and all(line.ratio == meshes[0].ratio for line in meshes)
    assert meshes[0].ratio == Fraction(120, 7) and ring.id in [line.mesh for line in meshes]
    assert meshes[0].hertz == pytest.approx(100 * 120 / 7)
    (slower,) = a.vibration(reference=m.link(next(k for k, v in turns.items() if v == Fraction(2, 7))))
    assert next(line for line in slower.lines if line.kind == "tooth-mesh").ratio == 60
    assert len(found.to_pandas()) == len(found.lines)
    shifted = gg.sets.ravigneaux().analyze()
    assert [each.state for each in shifted.vibration()] == [state.name for state in shifted.states]
    with pytest.raises(ValueError):
        a.vibration(rpm=-1)
    with pytest.raises(ValueError):
        a.vibration(harmonics=0)
    with pytest.raises(gg.Error) as caught:
        a.vibration(reference=99)
    assert caught.value.code == "unknown-id"


def test_backlash():
    (shared,) = gg.sets.planetary(sun=24, planet=18).analyze().backlash
    assert shared.shared and all(output.root_of_squares is None for output in shared.outputs)
    m = gg.open(EXAMPLES / "planetary-ring-held.geargraph")
    (found,) = m.analyze().backlash
    assert found.shared is False and set(found.plays.values()) == {Fraction(2, 25)}
    for output in found.outputs:
        assert output.worst == sum(output.parts.values())
        assert output.root_of_squares == pytest.approx(sum(float(x) ** 2 for x in output.parts.values()) ** 0.5)
        assert output.parts[output.most] == max(output.parts.values())
    assert Fraction(4, 25) / 84 in [output.worst for output in found.outputs]
    assert len(gg.sets.ravigneaux().analyze().backlash) == len(gg.sets.ravigneaux().analyze().states)


@pytest.mark.parametrize("name", ["schematic", "digraph", "ttgraph", "levers", "nomogram", "plan", "kutzbach", "spectrum", "motors"])
def test_drawings(robot, name, tmp_path):
    drawing = robot.analyze().drawing(name)
    root = ElementTree.fromstring(drawing.svg)
    assert root.tag.endswith("svg")
    assert drawing.png.startswith(b"\x89PNG") and drawing.pdf.startswith(b"%PDF")
    drawing.save(tmp_path / "drawing.svg")
    assert (tmp_path / "drawing.svg").read_text() == drawing.svg == drawing._repr_svg_()
    with pytest.raises(ValueError):
        drawing.save(tmp_path / "drawing.gif")


def test_a_mechanism_shows_its_drawing(robot):
    assert robot._repr_svg_() == robot.analyze().drawing("schematic").svg
    assert ElementTree.fromstring(gg.Mechanism("empty")._repr_svg_()).tag.endswith("svg")


def test_pictures(robot):
    a = robot.analyze()
    picture = a.picture(size=(320, 200), view="iso", show=("labels", "axes"), hide=[4], time=1)
    assert picture.size == (320, 200)
    assert picture._repr_png_().startswith(b"\x89PNG")
    assert a.picture(size=(320, 200), view="front").png != picture.png
    for wrong in ({"view": "behind"}, {"size": (1, 1)}, {"faces": "none"}, {"show": ["noise"]}):
        with pytest.raises(ValueError):
            a.picture(**wrong)
    with pytest.raises(gg.Error):
        gg.Mechanism().analyze().picture()


def test_3d_files_are_shown_with_their_links(robot, tmp_path):
    robot.analyze().export(tmp_path / "gear.stl", gear="15:tail", tolerance=0.1)
    robot.save(tmp_path / "robot.geargraph")
    m = gg.open(tmp_path / "robot.geargraph")
    bare = m.analyze().picture(size=(200, 150))
    m.add_shape(3, "gear.stl", position=(0, 0, 160), scale=2)
    shown = m.analyze().picture(size=(200, 150))
    assert shown.png != bare.png and shown.notes == ()
    m.add_shape(3, "none.stl")
    missing = m.analyze().picture(size=(200, 150))
    assert missing.png == shown.png and "none.stl" in missing.notes[0]


def test_what_an_export_leaves_out_is_a_warning(tmp_path):
    m = gg.Mechanism()
    with m.edit():
        last = None
        for teeth in (101, 103, 107, 109, 113):
            link = m.add_link()
            m.add_turning_joint(0, link)
            if last is not None:
                m.add_mesh(last[0], link, (last[1], teeth))
            last = (link, teeth)
    with pytest.warns(UserWarning, match="first 60 s"):
        m.analyze().export(tmp_path / "long.glb", tolerance=0.1)
    with pytest.warns(UserWarning, match="first 5 s"):
        m.analyze().export(tmp_path / "long.glb", tolerance=0.1, seconds=5)


def test_a_film(robot, tmp_path):
    robot.analyze().film(tmp_path / "film.png", "turntable", frames=2, size=(64, 48))
    assert b"acTL" in (tmp_path / "film.png").read_bytes()
    for _ in range(2):
        robot.analyze().film(
            tmp_path / "film", frames=3, size=(64, 48), folder=True, overwrite=True
        )
    assert [path.name for path in sorted((tmp_path / "film").iterdir())] == [
        "0001.png", "0002.png", "0003.png",
    ]
    with pytest.raises(gg.Error) as caught:
        robot.analyze().film(tmp_path / "film", frames=3, size=(64, 48), folder=True)
    assert caught.value.code == "file"


def test_solids_as_they_are_seen(robot, tmp_path):
    def names(**options):
        robot.analyze().export(tmp_path / "seen.glb", as_seen=True, **options)
        data = (tmp_path / "seen.glb").read_bytes()
        length = int.from_bytes(data[12:16], "little")
        return {node.get("name", "") for node in json.loads(data[20 : 20 + length])["nodes"]}

    assert names() - names(hide=["end-effector"])


def test_derivation(robot):
    derivation = robot.analyze().derivation
    assert "<math" in derivation._repr_html_() and "\\begin{" in derivation._repr_latex_()
    assert derivation.pdf.startswith(b"%PDF")
    assert derivation.markdown.startswith("#")
    kinds = {block.kind for block in derivation.blocks}
    assert {"heading", "paragraph", "equation", "figure"} <= kinds
    with pytest.raises(KeyError, match="no equation 99; these are .*17, "):
        derivation.equation(99)


def test_a_matrix_is_typeset(robot):
    matrix = robot.analyze().reduced_incidence
    latex = matrix._repr_latex_()
    assert latex.count("\\\\") == 1 + robot.n and "|" in latex
    assert matrix._repr_html_() is None
    assert "C_{15}" in robot.analyze().cycle_basis.to_latex()
    assert "-i_{15}" in robot.analyze().solution._repr_latex_()
    assert str(matrix).splitlines()[0].split()[0] == "8"


def test_large_matrices_are_shown_as_a_table_cut_off():
    m = gg.Mechanism()
    with m.edit():
        last = m.ground
        for _ in range(60):
            link = m.add_link()
            m.add_turning_joint(last, link)
            last = link
    matrix = m.analyze().incidence
    assert matrix._repr_latex_() is None
    assert "61 × 60" in matrix._repr_html_() and "…" in matrix._repr_html_()


def test_gears_are_closed_surfaces(robot):
    gears = robot.analyze().gears
    assert {gear.teeth for gear in gears} == {18, 36, 20, 30, 24, 16}
    assert sum(len(gear.meshes) for gear in gears) == 8
    for gear in gears:
        mesh = gear.mesh(0.05)
        corners = mesh.vertices[mesh.triangles]
        points, welded = np.unique(mesh.vertices, axis=0, return_inverse=True)
        faces = welded[mesh.triangles]
        edges = np.concatenate([faces[:, [0, 1]], faces[:, [1, 2]], faces[:, [2, 0]]])
        counted = set(map(tuple, edges.tolist()))
        assert len(counted) == len(edges) and {(b, a) for a, b in counted} == counted
        assert mesh.volume > 0 and np.isfinite(corners).all()
        assert np.allclose(np.linalg.norm(mesh.normals, axis=1), 1, atol=1e-5)
        assert mesh.vertices.flags.writeable is False
        if gear.kind == "external":
            radii = np.hypot(mesh.vertices[:, 0], mesh.vertices[:, 1])
            assert radii.max() == pytest.approx(gear.tip_radius, rel=1e-3)
        assert gear.pose.shape == (4, 4)
    assert any(not solid.is_gear for solid in robot.analyze().solids(0.1))


def test_exports(robot, tmp_path):
    a = robot.analyze()
    heads = {"glb": b"glTF", "3mf": b"PK", "ply": b"ply", "pdf": b"%PDF", "html": b"<!", "md": b"#"}
    for ending, head in heads.items():
        options = {"tolerance": 0.1} if ending in ("glb", "3mf", "ply") else {}
        a.export(tmp_path / f"robot.{ending}", **options)
        assert (tmp_path / f"robot.{ending}").read_bytes().lower().startswith(head.lower()), ending
    a.export(tmp_path / "gear.stl", gear="15:tail", tolerance=0.1)
    a.export(tmp_path / "drawing.png", drawing="digraph")
    a.export(tmp_path / "p.csv", table="p")
    assert (tmp_path / "p.csv").read_text() == a.csv("p")
    with pytest.raises(ValueError):
        a.export(tmp_path / "gear.stl", gear="99:tail")
    with pytest.raises(ValueError):
        a.export(tmp_path / "robot.dwg")
    with pytest.raises(gg.Error) as caught:
        a.export(tmp_path / "none" / "robot.md")
    assert caught.value.code == "file"
    a.export_assembly(tmp_path / "teeth", frames=12, tolerance=0.1)
    assert len(json.loads((tmp_path / "teeth" / "assembly.json").read_text())["frames"]) == 12
    with pytest.raises(gg.Error):
        a.export_assembly(tmp_path / "teeth", frames=12, tolerance=0.1)


def test_tables_are_those_of_the_command_line(robot, tmp_path):
    import os

    names = robot.analyze().tables
    assert {"incidence", "cycle-basis", "screw", "p", "solution"} <= set(names)
    robot.analyze().export_tables(tmp_path / "tables")
    for name in names:
        written = subprocess.run(
            [os.environ["GEARGRAPH_CLI"], "export", EXAMPLES / "robot.geargraph", "--to", "csv",
             "--matrix", name, "-o", "-"],
            check=True, capture_output=True, text=True,
        ).stdout
        assert (tmp_path / "tables" / f"{name}.csv").read_text() == written, name
    with pytest.raises(gg.Error):
        robot.analyze().export_tables(tmp_path / "tables")


def test_motion_is_checked(robot):
    checked = robot.analyze().check_motion()
    assert checked is not None and checked.complete
    assert gg.Mechanism().analyze().check_motion() is None


def test_random_trains_agree_by_both_methods():
    rng = np.random.default_rng(7)
    for _ in range(40):
        m = gg.Mechanism()
        first = m.add_link()
        m.add_turning_joint(0, first)
        for _ in range(int(rng.integers(1, 7))):
            gear = m.links[int(rng.integers(1, m.n + 1))]
            tail = next(joint.tail for joint in m.joints if joint.head == gear)
            m.attach_gear(gear, tail, tuple(int(z) for z in rng.integers(17, 60, 2)))
        a = m.analyze()
        assert a.ok and a.agree and a.dof == m.t - a.rank
        p = a.coefficients.to_numpy()
        assert np.allclose(p @ np.array(a.joint_rates), 0, atol=1e-6)


def test_packed_sizes_are_labelled(robot):
    for quantity in (robot.analyze().screws, robot.analyze().coefficients, robot.analyze().solution):
        assert quantity.to_numpy().shape == quantity.decimals.shape
        assert isinstance(quantity.decimals.to_pandas(), pd.DataFrame)


def test_graphs_of_any_name_are_well_formed(robot):
    robot.name = 'a "b" & <c> \\ \x01'
    robot.rename(robot.link(3), "tool\n\"3\"")
    a = robot.analyze()
    for name, edges in (("digraph", 11), ("ttgraph", 7 + 8)):
        data = json.loads(a.graph(name))
        assert len(data["nodes"]) == 8 and len(data["links"]) == edges
        assert data["nodes"][3]["name"] == robot.link(3).name
        root = ElementTree.fromstring(a.graph(name, "graphml"))
        graph = root.find("{*}graph")
        assert len(graph.findall("{*}node")) == 8 and len(graph.findall("{*}edge")) == edges
        assert {key.get("id") for key in root.findall("{*}key")} >= {
            data.get("key") for data in graph.iter("{http://graphml.graphdrawing.org/xmlns}data")
        }
        assert a.graph(name, "dot").count(" -> ") == edges
    first = json.loads(a.graph("digraph"))["links"][7]
    assert (first["source"], first["target"], first["tailTeeth"], first["headTeeth"]) == (4, 1, 18, 36)
    with pytest.raises(ValueError):
        a.graph("schematic")
    with pytest.raises(ValueError):
        a.graph("digraph", "gexf")
    with pytest.raises(gg.Error):
        gg.Mechanism.from_text(
            '{"format": "geargraph", "version": 1, "links": [{"id": "0"}, {"id": "1"}]}'
        ).analyze().graph("ttgraph")
