"""Profiles for laser and wire, read by ezdxf."""

import json
import math
import os
import subprocess

import ezdxf
import pytest
from conftest import EXAMPLES


def export(tmp_path, document, *options, status=0):
    out = tmp_path / "out.dxf"
    done = subprocess.run(
        [os.environ["GEARGRAPH_CLI"], "export", str(document), "--to", "dxf", "-o", str(out), *options],
        capture_output=True, text=True, check=False,
    )
    assert done.returncode == status, done.stderr
    return out, done.stderr


def read(path):
    drawing = ezdxf.readfile(path)
    audit = drawing.audit()
    assert not audit.errors and not audit.fixes
    assert drawing.dxfversion == "AC1015"
    return drawing


def wheels(drawing):
    """By the words below each wheel: teeth, module, profile shift, centre, outline."""
    found = []
    space = drawing.modelspace()
    outlines = [e for e in space if e.dxftype() == "LWPOLYLINE" and e.dxf.layer == "PROFILE"]
    pitches = [e for e in space if e.dxftype() == "CIRCLE" and e.dxf.layer == "PITCH"]
    texts = [e for e in space if e.dxftype() == "TEXT"]
    for text, pitch, outline in zip(texts, pitches, outlines):
        words = text.dxf.text.split("  ")
        values = {w.split()[0]: float(w.split()[1]) for w in words[1:]}
        assert outline.closed
        found.append((words[0], int(values["z"]), values["m"], values["x"], pitch, outline))
    assert len(found) == len(outlines) == len(texts)
    return found


def sampled(outline, parts=16):
    """Points on the pieces, by the definition of bulges."""
    vertices = list(outline.get_points("xyb"))
    for (x0, y0, bulge), (x1, y1, _) in zip(vertices, vertices[1:] + vertices[:1]):
        if bulge == 0:
            yield from ((x0 + (x1 - x0) * k / parts, y0 + (y1 - y0) * k / parts) for k in range(parts))
            continue
        center, start, end, radius = ezdxf.math.bulge_to_arc((x0, y0), (x1, y1), bulge)
        turn = (end - start) % (2 * math.pi)
        for k in range(parts):
            angle = start + turn * k / parts
            yield center[0] + radius * math.cos(angle), center[1] + radius * math.sin(angle)


@pytest.mark.parametrize("name", ["spur-pair", "planetary-ring-held", "reverted-train"])
@pytest.mark.parametrize("tolerance", [0.0005, 0.01])
def test_profiles_are_involutes_within_their_tolerance(name, tolerance, tmp_path):
    path, _ = export(tmp_path, EXAMPLES / f"{name}.geargraph", "--tolerance", str(tolerance))
    drawing = read(path)
    assert drawing.header["$INSUNITS"] == 4
    compared = 0
    for _, teeth, module, shift, pitch, outline in wheels(drawing):
        assert pitch.dxf.radius == pytest.approx(module * teeth / 2)
        assert len(outline) % teeth == 0
        points = [(x - pitch.dxf.center.x, y - pitch.dxf.center.y) for x, y in sampled(outline)]
        # Tooth 0 is on +x; the tips of a ring are inside of its pitch circle.
        tip = min(points, key=lambda at: abs(math.atan2(at[1], at[0])))
        ring = math.hypot(*tip) < pitch.dxf.radius
        alpha = math.radians(20)
        base = math.cos(alpha) * module * teeth / 2
        sign = -1 if ring else 1
        for x, y in points:
            radius = math.hypot(x, y)
            # On the flank, clear of tip and fillet.
            if abs(radius - pitch.dxf.radius) > 0.5 * module or radius < base * 1.01:
                continue
            phi = math.acos(base / radius)
            half = (math.pi / 2 + sign * 2 * shift * math.tan(alpha) - 0.02) / teeth
            half += sign * (math.tan(alpha) - alpha - math.tan(phi) + phi)
            pitch_angle = 2 * math.pi / teeth
            angle = abs(math.remainder(math.atan2(y, x), pitch_angle))
            assert abs(angle - half) * radius * math.cos(phi) <= 1.05 * tolerance * module + 2e-5 * module
            compared += 1
    assert compared > 500


def test_layers_rings_and_single_wheels(tmp_path):
    path, _ = export(tmp_path, EXAMPLES / "planetary-ring-held.geargraph")
    drawing = read(path)
    assert {"PROFILE", "BORE", "TIP", "PITCH", "ROOT", "CENTRE", "TEXT"} <= {layer.dxf.name for layer in drawing.layers}
    assert sorted(teeth for _, teeth, *_ in wheels(drawing)) == [18, 24, 60]
    rims = [e for e in drawing.modelspace() if e.dxftype() == "CIRCLE" and e.dxf.layer == "PROFILE"]
    assert len(rims) == 1 and rims[0].dxf.radius > 60
    boxes = []
    for *_, pitch, outline in wheels(drawing):
        xs = [x for x, _ in sampled(outline)]
        boxes.append((min(xs), max(xs)))
    boxes.sort()
    assert all(a[1] < b[0] for a, b in zip(boxes, boxes[1:]))  # side by side
    path, _ = export(tmp_path, EXAMPLES / "planetary-ring-held.geargraph", "--gear", "7:tail")
    ((_, teeth, _, _, pitch, _),) = wheels(read(path))
    assert teeth == 24 and pitch.dxf.center == (0, 0, 0)


def test_units_and_refusals(tmp_path):
    document = json.loads((EXAMPLES / "spur-pair.geargraph").read_text())
    document["unit"] = "in"
    inches = tmp_path / "inches.geargraph"
    inches.write_text(json.dumps(document))
    path, _ = export(tmp_path, inches)
    assert read(path).header["$INSUNITS"] == 1
    bevels = EXAMPLES / "bevel-differential.geargraph"
    _, message = export(tmp_path, bevels, status=1)
    assert "no profile" in message
    export(tmp_path, EXAMPLES / "spur-pair.geargraph", "--gear", "99:tail", status=2)
    export(tmp_path, EXAMPLES / "spur-pair.geargraph", "--tolerance", "5", status=2)
