"""Instructions, stack and code of generated C in single precision on a Cortex-M4, which QEMU executes.

Usage: measure.py FOLDER NAME..

FOLDER has NAME.c and NAME.h of `robot-dynamics generate --lang c --scalar float`. Prints a table in Markdown. The
program fails if a count of 1,000 instructions is another one, or if a value differs by a bit from that of a program for
this machine, which the host's compiler makes of the same C.
"""

import re
import struct
import subprocess
import sys
from pathlib import Path

HERE = Path(__file__).parent
FUNCTIONS = ["inverse_dynamics", "mass_matrix", "coriolis_vector", "gravity_vector", "forward_dynamics"]
CORE = ["-mcpu=cortex-m4", "-mthumb", "-mfloat-abi=hard", "-mfpu=fpv4-sp-d16"]
FLAGS = ["-std=c99", "-O2", "-ffunction-sections", "-fdata-sections"]
STATES = 16
BOARD = ["qemu-system-arm", "-machine", "mps2-an386", "-icount", "shift=0", "-display", "none", "-monitor", "none", "-serial", "none"]


def numbers(seed, count, range):
    """Numbers of a linear congruential generator, as single precision has them."""
    state = seed
    for _ in __builtins__.range(count):
        state = (state * 6364136223846793005 + 1442695040888963407) % 2**64
        yield struct.unpack("f", struct.pack("f", ((state >> 40) / 2**24 * 2 - 1) * range))[0]


def program(name, header, on_board):
    """A program that calls each function at all states: on the board it measures, on the host it prints values alone."""
    joints = int(re.search(rf"{name.upper()}_DOF (\d+)", header)[1])
    inputs = {
        key: ",".join(f"{{{','.join(f'{x!r}f' for x in numbers(seed + 9 * state, joints, size))}}}" for state in range(STATES + 1))
        # The last state has angles of thousands of turns, which are reduced by another way.
        for key, seed, size in [("q", 1, 3.0), ("qd", 2, 3.0), ("qdd", 3, 10.0), ("tau", 4, 30.0)]
    }
    text = [f'#include "{name}.h"', "#include <stdint.h>", "#include <string.h>"]
    text.append('#include "board.h"' if on_board else "#include <stdio.h>")
    for key, values in inputs.items():
        text.append(f"static float {key}s[{STATES + 1}][{joints}] = {{{values}}};")
    text.append(f"static float found[{joints * joints}];\nstatic volatile int state;")
    for function in FUNCTIONS:
        signature = re.search(rf"\b{name}_{function}\(([^)]*)\)", header)[1]
        given = re.findall(r"const float (\w+)\[", signature)
        result = f"(float (*)[{joints}])found" if "][" in signature else "found"
        arguments = ", ".join([f"{x}s[state]" for x in given] + [result])
        text.append(f"static void call_{function}(void) {{ {name}_{function}({arguments}); }}")
    text.append("static uint32_t hash(void) { uint32_t sum = 2166136261u, bits; for (unsigned i = 0; i < sizeof found / sizeof *found; ++i) { memcpy(&bits, found + i, sizeof bits); sum = (sum ^ bits) * 16777619u; } return sum; }")
    text.append(f"int main(void) {{\nfor (int i = 0; i < {joints}; ++i) qs[{STATES}][i] *= 1e5f;")
    if on_board:
        text.append("say_number(instructions_of_a_thousand(), '\\n');")
    for function in FUNCTIONS:
        body = [f"memset(found, 0, sizeof found); call_{function}();"]
        if on_board:
            body.append(f"say_number(hash(), ' '); say_number(instructions(call_{function}), ' '); say_number(depth(call_{function}), '\\n');")
        else:
            body.append('printf("%u\\n", (unsigned)hash());')
        text.append(f"for (state = 0; state <= {STATES}; ++state) {{ {' '.join(body)} }}")
    return "\n".join([*text, "return 0;\n}", ""])


def run(*words):
    return subprocess.run([str(word) for word in words], check=True, capture_output=True, text=True).stdout


def code(folder, name, function):
    """Bytes of a program that has this function alone, with its sines and constants."""
    out = folder / "alone.elf"
    run("arm-none-eabi-gcc", *CORE, *FLAGS, "-nostartfiles", f"-Wl,--gc-sections,-e,{name}_{function}", folder / f"{name}.c", "-o", out)
    text, data, bss = run("arm-none-eabi-size", out).splitlines()[1].split()[:3]
    assert data == bss == "0", "static data"
    return int(text)


def rows(folder, name):
    header = (folder / f"{name}.h").read_text()
    for on_board in [True, False]:
        (folder / f"on_{'board' if on_board else 'host'}.c").write_text(program(name, header, on_board))
    host = folder / "on_host"
    run("cc", "-std=c99", "-O2", "-I", folder, folder / "on_host.c", folder / f"{name}.c", "-o", host)
    board = folder / "on_board.elf"
    sources = [folder / "on_board.c", folder / f"{name}.c", HERE / "board.c"]
    run("arm-none-eabi-gcc", *CORE, *FLAGS, "-nostartfiles", "-T", HERE / "board.ld", "-I", folder, "-I", HERE, *sources, "-o", board)
    printed = folder / "printed.txt"
    semihosting = ["-chardev", f"file,id=printed,path={printed}", "-semihosting-config", "enable=on,chardev=printed"]
    run(*BOARD, *semihosting, "-kernel", board)
    thousand, *measured = [line.split() for line in printed.read_text().splitlines()]
    if thousand != ["1000"]:
        sys.exit(f"{name}: 1000 instructions are counted as {thousand}")
    values = run(host).split()
    if len(values) != len(measured) or any(line[0] != value for line, value in zip(measured, values)):
        sys.exit(f"{name}: values differ from this machine's")
    for i, function in enumerate(FUNCTIONS):
        states = [[int(x) for x in line[1:]] for line in measured[i * (STATES + 1) : (i + 1) * (STATES + 1)]]
        usual = [count for count, _ in states[:-1]]
        cells = [min(usual), max(usual), states[-1][0], max(depth for _, depth in states), code(folder, name, function)]
        yield f"| {name} | `{function}` | " + " | ".join(map(str, cells)) + " |"


def main():
    folder = Path(sys.argv[1])
    print("| arm | function | instructions, least | most | at huge angles | stack, bytes | code, bytes |")
    print("|---|---|--:|--:|--:|--:|--:|")
    for name in sys.argv[2:]:
        print("\n".join(rows(folder, name)))


main()
