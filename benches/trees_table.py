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
median = lambda *key: statistics.median(found[key])
print("| tree | function | ns | error | batch, ns | Pinocchio, ns | error | ratio |")
print("|---|---|--:|--:|--:|--:|--:|--:|")
for tree, function in dict.fromkeys(key[1:3] for key in found):
    time, theirs = (median("time", tree, function, of) for of in ("generated", "Pinocchio"))
    batch = median("time", tree, function, "generated,batch")
    errors = [median("error", tree, function, of) for of in ("generated", "Pinocchio")]
    print(f"| {tree} | {function} | {time:.0f} | {errors[0]:.0e} | {batch:.1f} | {theirs:.0f} | {errors[1]:.0e} | {time / theirs:.2f} |")
