"""Registers that the loops of batches store on the stack, from the machine code of benches/goals.

Usage: spills.py PROGRAM

Prints a table: for each arm and function the instructions on vectors, and how many of them write a vector to the
stack, or read one there (a load by itself, or as an operand). Constants are read from elsewhere. Then the
instructions of 512 bits among those of one state, beside which some processors multiply at half their speed.
"""

import re
import subprocess
import sys

FUNCTIONS = {
    "InverseDynamics": "inverse_dynamics",
    "MassMatrix": "mass_matrix",
    "CoriolisVector": "coriolis_vector",
    "GravityVector": "gravity_vector",
    "ForwardDynamics": "forward_dynamics",
    "InverseDynamicsDerivatives": "inverse_dynamics_derivatives",
    "ForwardDynamicsDerivatives": "forward_dynamics_derivatives",
}
HEADER = re.compile(r"^[0-9a-f]+ <(.*)>:$")
# The loop of a batch by columns: Task<measured_arms::industrial::Arm, f64 or f32, functions::F, ..>::vectorised.
LOOP = re.compile(r"4Task.*?13measured_arms\d+[a-z_]+?\d+([A-Z][A-Za-z0-9]*?)([df])Nt.*?9functions\d+([A-Z][A-Za-z]*?)INt.*?7Columns[df]Kj.*10vectorised")
# The functions of one state, of an arm in doubles: goals::five::calls<measured_arms::industrial::Arm, f64, N>.
ONE_STATE = re.compile(r"5goals4five5calls.*?13measured_arms\d+[a-z_]+?\d+([A-Z][A-Za-z0-9]*?)dKj")
ON_STACK = re.compile(r"-?(?:0x[0-9a-f]+)?\(%r[sb]p")


def functions(program):
    """Name and instructions of every function, as objdump lists them."""
    command = ["objdump", "--disassemble", "--no-show-raw-insn", program]
    name, lines = None, []
    for line in subprocess.run(command, capture_output=True, text=True, check=True).stdout.splitlines():
        header = HEADER.match(line)
        if header:
            if name:
                yield name, lines
            name, lines = header.group(1), []
        elif ":\t" in line:
            lines.append(line.split(":\t", 1)[1])
    if name:
        yield name, lines


def count(lines):
    """Instructions on whole vectors, those that write to the stack, those that read there."""
    vectors = [line for line in lines if re.search(r"%[yz]mm", line)]
    on_stack = [line for line in vectors if ON_STACK.search(line)]
    writes = [line for line in on_stack if re.search(r"^vmov\S+\s+%[yz]mm\d+,", line)]
    return len(vectors), len(writes), len(on_stack) - len(writes)


def main(program):
    found, of_512_bits = {}, {}
    for name, lines in functions(program):
        if one_state := ONE_STATE.search(name):
            of_512_bits[one_state.group(1)] = sum("%zmm" in line for line in lines)
        match = LOOP.search(name)
        if match and match.group(3) in FUNCTIONS:
            arm, number, function = match.groups()
            counts = found.setdefault((arm, FUNCTIONS[function]), {})
            # Where the loop is a function of its own, what calls it has the same name before its own.
            counts[number] = max(count(lines), counts.get(number, (0, 0, 0)))
    if not (found and of_512_bits):
        sys.exit(f"{program} has no functions of batches or of one state: build it with -C symbol-mangling-version=v0")
    print("\nInstructions on vectors in the loops of batches, of these stores to the stack and reads of it:\n")
    print("| arm | function | `f64` | stores | reads | `f32` | stores | reads |")
    print("|---|---|--:|--:|--:|--:|--:|--:|")
    for (arm, function), counts in sorted(found.items()):
        cells = [str(x) for number in "df" for x in counts.get(number, ("", "", ""))]
        print("|", " | ".join([arm, function, *cells]), "|")
    wide = [f"{arm} {count}" for arm, count in sorted(of_512_bits.items()) if count]
    print("\nInstructions of 512 bits in the five functions of one state:", ", ".join(wide) or "none")


main(sys.argv[1])
