"""The table of C code: times of this project's beside those of Rust, and of CasADi's.

Usage: c_table.py LINES
"""

import math
import statistics
import sys
from pathlib import Path

from arms import ARMS, FUNCTIONS

RUST, COMPILERS, CASADI = "generated", ("C,gcc", "C,clang"), ("CasADi,-O3", "CasADi,-Ofast")


def digits(x):
    return f"{x:.0f}" if x >= 100 else f"{x:.3g}"


def main(lines):
    times = {}
    for line in Path(lines).read_text().splitlines():
        _, arm, function, candidate, number = line.split()[:5]
        times.setdefault((arm, function, candidate), []).append(float(number))
    median = {key: statistics.median(all) for key, all in times.items()}
    compilers = [c for c in COMPILERS if (ARMS[0], FUNCTIONS[0], c) in median]
    names = [c.split(",")[1] for c in compilers]
    heads = ["arm", "function", "Rust", *(f"C, {n}" for n in names), *(f"{n} / Rust" for n in names), "CasADi / C"]
    heads += ["Rust, batch", *(f"C, {n}, batch" for n in names), *(f"{n} / Rust, batch" for n in names)]
    print("| " + " | ".join(heads) + " |")
    print("|---|---|" + "--:|" * (len(heads) - 2))
    ratios = {}

    def ratio(name, arm, function, value):
        ratios.setdefault(name, []).append((value, function, arm))
        return f"{value:.2f}"

    for arm in ARMS:
        for function in FUNCTIONS:
            cells = [arm, function]
            for suffix, of in ("", "one state"), ("_batch", "batches"):
                rust, *ours = (median[arm, function + suffix, c] for c in (RUST, *compilers))
                cells += [digits(rust), *map(digits, ours)]
                cells += [ratio(f"{of}, {n} / Rust", arm, function, c / rust) for n, c in zip(names, ours)]
                if not suffix:
                    theirs = min(median[arm, function, c] for c in CASADI)
                    cells.append(ratio("one state, CasADi / C of gcc", arm, function, theirs / ours[0]))
            print("| " + " | ".join(cells) + " |")
    print("\n| ratio | geometric mean | least | largest |")
    print("|---|--:|---|---|")
    for name, all in ratios.items():
        mean = math.exp(statistics.fmean(math.log(x) for x, *_ in all))
        ends = (f"{x:.2f}: `{function}` of {arm}" for x, function, arm in (min(all), max(all)))
        print(f"| {name} | {mean:.2f} | {' | '.join(ends)} |")


main(*sys.argv[1:])
