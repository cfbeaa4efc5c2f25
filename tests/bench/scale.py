#!/usr/bin/env python3
"""Writes the table of what 1,000 to 30,000 links cost into PAGE, between its two marks.

    scale.py BUILD FOLDER PAGE

Times are processor time, which a busy machine does not change. BUILD holds the programs, FOLDER the trains of
geargraph_bench_trains and, where it was run, editor.json (bench_editor's openALargeDocument, which measures the longest
stall of the window's thread). Without the editor's program its column stays empty; with it a display is needed, such as
xvfb-run's. Takes about two minutes of processor time and tells on standard error what it is at.
"""

import json
import os
import pathlib
import sys
import tempfile

BEGIN, END = "<!-- scale -->", "<!-- /scale -->"
TRAINS = [("tree", 1000), ("tree", 3000), ("tree", 10000), ("tree", 30000), ("deep", 1000), ("deep", 3000)]
RUNS = 3
LONG = 1  # s: what takes longer is hardly disturbed, and not run again


def run(words):
    """Processor seconds of all threads and peak memory in MB of one run; the exit status."""
    with open(os.devnull, "wb") as nothing:
        child = os.posix_spawn(words[0], words, dict(os.environ), file_actions=[
            (os.POSIX_SPAWN_DUP2, nothing.fileno(), 1), (os.POSIX_SPAWN_DUP2, nothing.fileno(), 2)])
        _, status, usage = os.wait4(child, 0)
    return usage.ru_utime + usage.ru_stime, usage.ru_maxrss / 1024, os.waitstatus_to_exitcode(status)


def best(words):
    """The shortest of some runs, and the largest memory: what disturbs only ever adds."""
    print(" ".join(pathlib.Path(word).name for word in words), file=sys.stderr, flush=True)
    runs = [run(words)]
    while len(runs) < RUNS and runs[0][0] < LONG:
        runs.append(run(words))
    statuses = {status for _, _, status in runs}
    if len(statuses) != 1 or not statuses <= {0, 1, 3}:
        sys.exit(f"{' '.join(words)}: exit statuses {statuses}")
    return min(seconds for seconds, _, _ in runs), max(memory for _, memory, _ in runs), statuses.pop()


def shown(seconds):
    return f"{seconds:.2f} s" if seconds < 10 else f"{seconds:.0f} s"


def stalls(folder):
    """Longest stall in ms by family and number of links."""
    file = folder / "editor.json"
    if not file.exists():
        return {}
    runs = json.loads(file.read_text())["benchmarks"]
    names = [run["name"].split("/") for run in runs]
    return {(name[1], int(name[2])): run["stall_ms"] for name, run in zip(names, runs)}


def main():
    build, folder, readme = (pathlib.Path(word) for word in sys.argv[1:4])
    cli, window = str(build / "app/cli/geargraph-cli"), str(build / "app/editor/geargraph")
    stall = stalls(folder)
    lines = ["| links | validate | analyze | inputs | csv (P) | glb | window open | longest stall | memory |",
             "| --- | --- | --- | --- | --- | --- | --- | --- | --- |"]
    with tempfile.TemporaryDirectory() as place:
        out = place + "/out"
        hasWindow = os.path.exists(window)
        start = best([window, "--screenshot", out + ".png"])[0] if hasWindow else None
        for family, links in TRAINS:
            file = str(folder / f"{family}-{links}.geargraph")
            commands = [
                [cli, "validate", file],
                [cli, "analyze", "--json", file],
                [cli, "inputs", file],
                [cli, "export", "--to", "csv", "--matrix", "p", "-o", out, file],
                [cli, "export", "--to", "glb", "-o", out, file],
            ]
            cells, peak = [], 0
            for words in commands:
                seconds, memory, status = best(words)
                cells.append("says why not" if status == 3 else shown(seconds))
                peak = max(peak, memory)
            if hasWindow:
                seconds, memory, _ = best([window, "--screenshot", out + ".png", file])
                cells.append(f"{shown(seconds)} ({seconds / start:.1f})")
                peak = max(peak, memory)
            else:
                cells.append("")
            known = stall.get((family, links))
            cells.append("" if known is None else f"{known:.0f} ms")
            cells.append(f"{peak:,.0f} MB")
            name = f"{links:,}" + (", deep" if family == "deep" else "")
            lines.append(f"| {name} | " + " | ".join(cells) + " |")
            print(lines[-1], flush=True)
    lines += ["", "Processor time. Memory: the most that one of these programs takes."]
    if stall:
        lines += ["Longest stall: the longest single event of the window's thread while the document comes up."]
    if hasWindow:
        lines += ["Window open: until all views are painted, the 3D among them; in parentheses times the "
                  f"{shown(start)} that", "the window takes without a document."]
    text = readme.read_text()
    before, rest = text.split(BEGIN)
    readme.write_text(f"{before}{BEGIN}\n" + "\n".join(lines) + f"\n{END}{rest.split(END)[1]}")


if __name__ == "__main__":
    main()
