"""Values of a program against the references of 25 digits: prints its `error` lines.

Usage: check.py PROGRAM CANDIDATE
"""

import json
import math
import subprocess
import sys
import tempfile
from fractions import Fraction

from arms import ARMS, DATA, FUNCTIONS

# Beyond this a program computes something else.
AGREEMENT = 1e-9


def references():
    """The states of every arm, with their values as fractions."""
    for name in ARMS:
        for state in json.loads((DATA / "reference" / f"{name}.json").read_text())["states"]:
            vector = lambda key: [Fraction(x) for x in state[key]]
            state["torque"] = [t + f for t, f in zip(vector("tau"), vector("friction"))]
            state["V"], state["G"] = vector("V"), vector("G")
            state["M"] = [[Fraction(x) for x in row] for row in state["M"]]
            yield name, state


def errors(function, values, state):
    """Errors of a function's values relative to the natural magnitude, as src/errors.rs has them."""
    scale, n = state["scale"], len(state["q"])
    exact = [Fraction(x) for x in values]
    torque_scale = max([scale["tau"]] + [abs(float(t)) for t in state["torque"]])
    if function == "inverse_dynamics":
        return [(x - t, torque_scale) for x, t in zip(exact, state["torque"])]
    if function == "mass_matrix":
        entries = [x for row in state["M"] for x in row]
        return [(x - m, scale["M"]) for x, m in zip(exact, entries)]
    if function == "coriolis_vector":
        return [(x - v, scale["V"]) for x, v in zip(exact, state["V"])]
    if function == "gravity_vector":
        return [(x - g, scale["G"]) for x, g in zip(exact, state["G"])]
    # The torques that the accelerations need beyond those that were applied.
    beyond = [x - Fraction(exact_qdd) for x, exact_qdd in zip(exact, state["qdd"])]
    applied = [Fraction(float(t)) - t for t in state["torque"]]
    needed = [sum(m * x for m, x in zip(row, beyond)) for row in state["M"]]
    return [(needed[i] - applied[i], torque_scale) for i in range(n)]


def main(program, candidate):
    states = list(references())
    with tempfile.NamedTemporaryFile("w", suffix=".txt") as file:
        for name, state in states:
            numbers = state["q"] + state["qd"] + state["qdd"] + [float(t) for t in state["torque"]]
            print(name, *map(float.hex, numbers), file=file)
        file.flush()
        output = subprocess.run([program, "values", file.name], capture_output=True, text=True, check=True)
    lines = iter(output.stdout.splitlines())
    relative = {(name, function): [] for name in ARMS for function in FUNCTIONS}
    for name, state in states:
        for function in FUNCTIONS:
            words = next(lines).split()
            assert words[:2] == [name, function]
            values = [float.fromhex(word) for word in words[2:]]
            for error, scale in errors(function, values, state):
                relative[name, function].append(abs(float(error)) / scale if error else 0.0)
    for (name, function), found in relative.items():
        largest, rms = max(found), math.sqrt(sum(x * x for x in found) / len(found))
        assert largest < AGREEMENT, (candidate, name, function, largest)
        print("error", name, function, candidate, repr(largest), repr(rms))


main(*sys.argv[1:])
