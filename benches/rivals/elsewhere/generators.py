"""The table of generators: operations, times and errors of CppADCodeGen's C code and of this project's.

Usage: generators.py LINES FOLDER_OF_OURS CODE_OF_THEIRS
"""

import math
import re
import statistics
import sys
from pathlib import Path

from arms import ARMS, FUNCTIONS

OURS, THEIRS = "C,gcc", "CppADCodeGen"


def digits(x):
    return f"{x:.0f}" if x >= 100 else f"{x:.3g}"


def operations(code):
    """The operations of the functions in C code: signs are none, and stand behind `=`, `(` or another operator; a product
    that is fused with a sum is two.
    """
    for name, body in re.findall(r"^[^\n]*?\b(\w+)\([^()]*\)\s*\{(.*?)^\}", code, re.MULTILINE | re.DOTALL):
        fused = body.count("ROBOT_DYNAMICS_FMA(")
        yield name, 2 * fused + len(re.findall(r"[\w.)\]] [-+*/] ", body))


def main(lines, ours, theirs):
    times, errors = {}, {}
    for line in Path(lines).read_text().splitlines():
        kind, arm, function, candidate, number = line.split()[:5]
        if kind == "time":
            times.setdefault((arm, function, candidate), []).append(float(number))
        else:
            errors[arm, function, candidate] = float(number)
    counts = {}
    for candidate, files in (OURS, Path(ours).glob("*.c")), (THEIRS, [Path(theirs)]):
        for name, count in (pair for file in files for pair in operations(file.read_text())):
            counts[name, candidate] = count
    print("| arm | function | operations | ns | error | CppADCodeGen: operations | CppADCodeGen: ns | CppADCodeGen: error | ns, ratio |")
    print("|---|---|--:|--:|--:|--:|--:|--:|--:|")
    ratios = []
    for arm in ARMS:
        for function in FUNCTIONS:
            keys = [(arm, function, candidate) for candidate in (OURS, THEIRS)]
            time = [statistics.median(times[key]) for key in keys]
            ratios.append(time[0] / time[1])
            count = [counts[f"{arm}_{function}", candidate] for candidate in (OURS, THEIRS)]
            cells = [f"{n} | {digits(t)} | {errors[key]:.1e}" for key, n, t in zip(keys, count, time)]
            print(f"| {arm} | {function} | {' | '.join(cells)} | {ratios[-1]:.2f} |")
    mean = math.exp(statistics.fmean(map(math.log, ratios)))
    print(f"\nGeometric mean of the ratios: {mean:.2f}; the largest is {max(ratios):.2f}.")


main(*sys.argv[1:])
