"""The table of trees: times and errors of the generated functions and of Pinocchio, from lines of several rounds.

Usage: trees_table.py LINES
"""

import statistics
import sys
from pathlib import Path

found = {}
for line in Path(sys.argv[1]).read_text().splitlines():
    kind, tree, function, candidate, number = line.split()
    found.setdefault((kind, tree, function, candidate), []).append(float(number))
CANDIDATES = {"generated": "ns", "generated,batch": "batch, ns", "generated,f32": "f32 batch, ns", "Pinocchio": "Pinocchio, ns"}
measured = {key[3] for key in found}
columns = [candidate for candidate in CANDIDATES if candidate in measured]
heads = [head for candidate in columns for head in (CANDIDATES[candidate], "error")]
digits = lambda x: f"{x:.0f}" if x >= 100 else f"{x:.3g}"
print("| robot | function |", " | ".join(heads), "| ratio |")
print("|---|---|" + "--:|" * (len(heads) + 1))
for tree, function in dict.fromkeys(key[1:3] for key in found):
    median = lambda kind, of: statistics.median(found[kind, tree, function, of])
    cells = []
    for candidate in columns:
        is_there = ("time", tree, function, candidate) in found
        cells += [digits(median('time', candidate)), f"{median('error', candidate):.0e}"] if is_there else ["", ""]
    has_both = ("time", tree, function, "Pinocchio") in found
    ratio = f"{median('time', 'generated') / median('time', 'Pinocchio'):.2f}" if has_both else ""
    print(f"| {tree} | {function} |", " | ".join(cells), f"| {ratio} |")
