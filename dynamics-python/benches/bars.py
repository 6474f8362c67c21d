"""The package beside Pinocchio and beside the Rust that it calls: one process on one core, in turns.

    pip install pin
    python benches/bars.py

The least of several turns counts, for other programs disturb all the others.
"""

import os
import sys
import time
import timeit
from collections.abc import Callable
from pathlib import Path

import numpy as np

sys.path.insert(0, str(Path(__file__).parents[1] / "tests"))
from conftest import DATA, panda  # noqa: E402

TURNS = 15

STATES = np.random.default_rng(0).uniform(-1, 1, (3, 65_536, 7))


def in_turns(programs: dict[str, Callable[[], object]], calls: int) -> dict[str, float]:
    """Seconds of a call of each program."""
    best = dict.fromkeys(programs, np.inf)
    for _ in range(TURNS):
        for name, program in programs.items():
            best[name] = min(best[name], timeit.timeit(program, number=calls) / calls)
    return best


def one_call() -> None:
    arm = panda(functions=["default", "coriolis_matrix"])
    q, qd, qdd = STATES[:, 0]
    programs: dict[str, Callable[[], object]] = {
        "inverse_dynamics": lambda: arm.inverse_dynamics(q, qd, qdd),
        "mass_matrix": lambda: arm.mass_matrix(q),
        "forward_dynamics": lambda: arm.forward_dynamics(q, qd, qdd),
        "coriolis_matrix": lambda: arm.coriolis_matrix(q, qd),
        "nothing": lambda: None,
        "numpy.negative": lambda: np.negative(q),
    }
    try:
        import pinocchio
    except ImportError:
        print("Pinocchio is not installed")
    else:
        model = pinocchio.buildModelFromUrdf(str(DATA / "urdf" / "panda.urdf"))
        fingers = [model.getJointId(f"panda_finger_joint{k}") for k in (1, 2)]
        model = pinocchio.buildReducedModel(model, fingers, pinocchio.neutral(model))
        data = model.createData()
        programs |= {
            "pinocchio.rnea": lambda: pinocchio.rnea(model, data, q, qd, qdd),
            "pinocchio.crba": lambda: pinocchio.crba(model, data, q),
            "pinocchio.aba": lambda: pinocchio.aba(model, data, q, qd, qdd),
        }
    seconds = in_turns(programs, 5_000)
    # The call of the lambda itself is not counted.
    nothing = seconds.pop("nothing")
    for name, time_of_call in seconds.items():
        print(f"{name:24}{(time_of_call - nothing) * 1e9:8.0f} ns a call")


def batches() -> None:
    arm = panda()
    q, qd, qdd = STATES[:, :1024]
    out = np.empty_like(q)
    seconds = in_turns(
        {
            "1,024 states": lambda: arm.inverse_dynamics(q, qd, qdd),
            "1,024 states, out=": lambda: arm.inverse_dynamics(q, qd, qdd, out=out),
        },
        20,
    )
    for name, time_of_call in seconds.items():
        print(f"{name:24}{time_of_call / 1024 * 1e9:8.1f} ns a state")


def two_threads() -> None:
    arm = panda()
    q, qd, qdd = STATES
    out = np.empty_like(q)
    run = {k: (lambda k=k: arm.inverse_dynamics(q, qd, qdd, out=out, threads=k)) for k in (1, 2)}
    seconds = in_turns({str(k): program for k, program in run.items()}, 2)
    print(f"{'two threads, 65,536':24}{seconds['1'] / seconds['2']:8.2f} times as fast as one")


def first_result() -> None:
    start = time.perf_counter()
    panda().inverse_dynamics(*STATES[:, 0])
    print(f"{'from_file to a result':24}{time.perf_counter() - start:8.3f} s")


if __name__ == "__main__":
    first_result()
    two_threads()
    os.sched_setaffinity(0, {max(os.sched_getaffinity(0))})
    one_call()
    batches()
