#!/usr/bin/env python3
"""Writes the table of ratios into PAGE, between its two marks.

    table.py FOLDER PAGE      FOLDER holds analysis.json, peers.json, teeth.json (Google Benchmark) and python.json (peers.py)
"""

import json
import pathlib
import sys

BEGIN, END = "<!-- bench -->", "<!-- /bench -->"

# What, ours, peer, peer's name, accepted and aimed-at ratio (peer's time over ours; below 1: ours may be slower).
# {} stands for the family: tree or coupled.
ROWS = [
    ("live analysis, 1,000 links", "live/{}/1000", "networkx+scipy {} 1000", "networkx + scipy, no rank", 40, 100),
    ("live analysis, 10,000 links", "live/{}/10000", "networkx+scipy {} 10000", "networkx + scipy, no rank", 40, 100),
    ("live analysis, 1,000 links", "live/{}/1000", "numpy dense {} 1000", "numpy, the paper's formulas", 1000, 2500),
    ("live analysis, 1,000 links", "live/{}/1000", "eigenSparse/{}/1000", "Eigen SparseLU, no rank", 6, 15),
    ("live analysis, 10,000 links", "live/{}/10000", "eigenSparse/{}/10000", "Eigen SparseLU, no rank", 6, 15),
    ("live analysis, the paper's robot", "liveRobot", "eigenDenseRobot", "Eigen dense, no rank, geometry given", 1, 2.5),
    ("rank, inputs, speeds, the paper's robot", "matroidRobot", "eigenDenseRobot",
     "Eigen dense, no rank, geometry given", 1, 2.5),
    ("rank, inputs, speeds, 10,000 links", "matroidOnly/{}/10000", "kluAlone/{}/10000", "KLU, the solve alone", 0.67, 1.67),
    ("live analysis, 10,000 links", "live/{}/10000", "kluAlone/{}/10000", "KLU, the solve alone", 0.67, 1.67),
    ("live statics, 1,000 links", "liveStatics/{}/1000", "live/{}/1000", "the live analysis of the same train", 0.67, 1),
    ("live statics, 10,000 links", "liveStatics/{}/10000", "live/{}/10000", "the live analysis of the same train", 0.67, 1),
    ("exact rates, 1,000 links", "exact/{}/1000", "flintDense/{}/1000/iterations:1", "FLINT dense rank + Dixon", 1000, 4000),
    ("symbolic, 7 links", "symbolic/{}/7", "sympy LUsolve {} 7", "SymPy LUsolve", 40, 80),
    ("symbolic, 20 links", "symbolic/{}/20", "sympy LUsolve {} 20", "SymPy LUsolve", 300, 800),
    ("symbolic, 80 links", "symbolic/{}/80", "sympy linsolve {} 80", "SymPy linsolve", 3000, 8000),
    ("teeth of two pairs for a ratio, 5,764,801 choices", "sandgrenTeeth", "numpy teeth", "numpy, all choices at once", 1, 3),
    ("forward kinematics, 1,000 links", "forwardKinematics/1000", "numpy poses 1000", "a numpy loop", 60, 150),
]


def google(path):
    """Median CPU seconds by name."""
    unit = {"ns": 1e-9, "us": 1e-6, "ms": 1e-3, "s": 1}
    return {
        run["run_name"]: run["cpu_time"] * unit[run["time_unit"]]
        for run in json.loads(path.read_text())["benchmarks"]
        if run.get("aggregate_name") == "median"
    }


def same_choices(teeth, peer):
    """Both have found as many."""
    counts = {run["within"] for run in json.loads(teeth.read_text())["benchmarks"]
              if run["run_name"] == "sandgrenTeeth" and run.get("aggregate_name") == "median"}
    if counts != {peer}:
        raise SystemExit(f"Different work: {counts} choices of teeth, numpy {peer}")


def shown(ratio):
    return f"{ratio:,.0f}" if ratio >= 20 else f"{ratio:.2g}"


def main():
    folder, readme = pathlib.Path(sys.argv[1]), pathlib.Path(sys.argv[2])
    python = json.loads((folder / "python.json").read_text())
    times = {**google(folder / "analysis.json"), **google(folder / "peers.json"), **google(folder / "teeth.json"), **python}
    same_choices(folder / "teeth.json", python["numpy teeth within"])
    lines = ["| work | against | times faster | with any inputs | accepted | aimed at |", "| --- | --- | --- | --- | --- | --- |"]
    for work, ours, peer, name, accepted, aim in ROWS:
        ratios = [times[peer.format(family)] / times[ours.format(family)] for family in ("tree", "coupled")]
        coupled = shown(ratios[1]) if "{}" in ours else ""
        lines.append(f"| {work} | {name} | {shown(ratios[0])} | {coupled} | {accepted:,} | {aim:,} |")
    growth = times["live/tree/10000"] / times["live/tree/1000"]
    lines += ["", f"From 1,000 to 10,000 links the live analysis takes {growth:.1f} times as long (at most 16 accepted)."]
    text = readme.read_text()
    before, rest = text.split(BEGIN)
    after = rest.split(END)[1]
    readme.write_text(f"{before}{BEGIN}\n" + "\n".join(lines) + f"\n{END}{after}")
    print("\n".join(lines))


if __name__ == "__main__":
    main()
