#!/usr/bin/env python3
"""The renderer beside f3d (a fast viewer of 3D files) on the same gears, in one run on one display.

    peer_f3d.py PROGRAMS FOLDER     PROGRAMS holds bench_render and geargraph_bench_field; FOLDER is scratch

First picture: whole processes, each from its own start to a PNG of 1280 x 720 (f3d reads the GLB, we make the gears).
Frame: of f3d by the pictures that a recorded drag of the mouse makes it paint, less what it takes without them; ours
by bench_render. Times are of the wall's clock and, because this machine may be busy, of the processors.
"""

import json
import os
import pathlib
import resource
import statistics
import subprocess
import sys
import time

FIELDS = [(30, 1), (300, 1)]
ROUNDS = 5
FEW, MANY = 10, 60


def run(words):
    """Wall and processor seconds of a process and its children."""
    before, start = resource.getrusage(resource.RUSAGE_CHILDREN), time.monotonic()
    subprocess.run(words, check=True, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL, timeout=600)
    after = resource.getrusage(resource.RUSAGE_CHILDREN)
    return time.monotonic() - start, after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime


def drag(path, moves):
    events = ["# StreamVersion 1.1", "LeftButtonPressEvent 640 360 0 0 0 0 0"]
    events += [f"MouseMoveEvent {640 + i % 2 * 8 + i} 360 0 0 0 0 0" for i in range(moves)]
    path.write_text("\n".join(events + ["LeftButtonReleaseEvent 640 360 0 0 0 0 0", ""]))
    return path


def median(pairs):
    return [statistics.median(column) for column in zip(*pairs)]


def ours(programs, name):
    """Wall and processor milliseconds of one benchmark of bench_render."""
    text = subprocess.run([programs / "bench_render", f"--benchmark_filter=^{name}(/|$)", "--benchmark_format=json",
                           "--benchmark_min_time=0.5", "--benchmark_repetitions=3"], check=True, capture_output=True).stdout
    runs = [r for r in json.loads(text)["benchmarks"] if r.get("aggregate_name") == "median"]
    return runs[0]["real_time"], runs[0]["cpu_time"]


def main():
    programs, folder = pathlib.Path(sys.argv[1]), pathlib.Path(sys.argv[2])
    field = programs / "geargraph_bench_field"
    few, many = drag(folder / "few.log", FEW), drag(folder / "many.log", MANY)
    for count, shapes in FIELDS:
        glb, png = folder / f"field-{count}.glb", folder / f"field-{count}.png"
        run([field, str(count), str(shapes), glb])
        f3d = ["f3d", "--resolution", "1280,720", "--output", folder / "f3d.png", glb]
        first = [(run([field, str(count), str(shapes), png]), run(f3d)) for _ in range(ROUNDS)]
        mine, theirs = median([a for a, _ in first]), median([b for _, b in first])
        frames = []
        for _ in range(ROUNDS):
            short = run(f3d + ["--interaction-test-play", few])
            long = run(f3d + ["--interaction-test-play", many])
            frames.append([(b - a) / (MANY - FEW) * 1e3 for a, b in zip(short, long)])
        peer, film = median(frames), ours(programs, f"film/{count}")
        pick = ours(programs, f"pick/{count}")
        print(f"{count} gears of 60 teeth (times faster than f3d; processor time in brackets)")
        print(f"  first picture {theirs[0] / mine[0]:.2g} ({theirs[1] / mine[1]:.2g})")
        print(f"  frame         {peer[0] / film[0]:.2g} ({peer[1] / film[1]:.2g})")
        print(f"  warm pick     {pick[0] / film[0]:.2g} of a frame of ours")


if __name__ == "__main__":
    if "DISPLAY" not in os.environ:
        sys.exit("f3d needs a display: xvfb-run -a tests/bench/peer_f3d.py ...")
    main()
