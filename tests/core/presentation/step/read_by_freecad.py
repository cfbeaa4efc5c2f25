"""Run by FreeCAD's command line: reads STEP files of examples as its users do, and checks what is in them."""

import os
import subprocess
import tempfile

import Part

# The parts of each example: its wheels, and the bodies of its links.
EXAMPLES = {"robot": 16, "planetary-ring-held": 7, "bevel-differential": 10, "worm-hoist": 8}


def main():
    for name, parts in EXAMPLES.items():
        with tempfile.TemporaryDirectory() as folder:
            path = os.path.join(folder, name + ".step")
            document = os.path.join(os.environ["EXAMPLES"], name + ".geargraph")
            subprocess.run([os.environ["GEARGRAPH_CLI"], "export", document, "--to", "step", "-o", path], check=True)
            whole = Part.Shape()
            whole.read(path)
            assert whole.isValid(), name
            assert parts <= len(whole.Solids) <= parts + 1, (name, len(whole.Solids))
            for solid in whole.Solids:
                assert solid.isValid() and solid.Volume > 0, name
            print(name, len(whole.Solids), "solids", round(whole.Volume), "mm3")
    print("all files read")


main()
