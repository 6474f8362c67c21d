"""Ctrl-C during a derivation."""

import os
import signal
import subprocess
import sys
import time

import pytest

PROGRAM = """
import signal

import numpy as np
import robot_dynamics as rd
# A background job of a shell inherits that it ignores the signal.
signal.signal(signal.SIGINT, signal.default_int_handler)
row = {"type": "revolute", "a": 0.3, "alpha": 0.4, "d": 0.1, "mass": 1, "com": [0.1, 0.2, 0.3],
       "inertia": {"xx": 1, "yy": 1, "zz": 1, "xy": 0.1, "yz": 0.1, "xz": 0.1}}
arm = rd.Robot.from_table(
    convention="modified",
    gravity=[0, 0, -9.81],
    joint=[{**row, "name": f"joint_{k}"} for k in range(12)],
    functions=["inverse_dynamics_second_derivatives"],
)
print("begins", flush=True)
try:
    arm.inverse_dynamics_second_derivatives(*np.zeros((3, 12)))
    print("derived")
except KeyboardInterrupt:
    print("interrupted")
"""


@pytest.mark.skipif(os.name != "posix", reason="signals of POSIX")
def test_a_long_derivation_is_interrupted() -> None:
    with subprocess.Popen(
        [sys.executable, "-c", PROGRAM], stdout=subprocess.PIPE, text=True
    ) as process:
        assert process.stdout is not None and process.stdout.readline() == "begins\n"
        time.sleep(0.1)
        start = time.perf_counter()
        process.send_signal(signal.SIGINT)
        assert process.stdout.readline() == "interrupted\n"
        assert time.perf_counter() - start < 1
        process.wait(10)
