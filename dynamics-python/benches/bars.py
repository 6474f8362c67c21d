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
from typing import Any

import numpy as np

sys.path.insert(0, str(Path(__file__).parents[1] / "tests"))
import robot_dynamics as rd  # noqa: E402
from conftest import DATA, panda  # noqa: E402

TURNS = 15

CLOCK = time.perf_counter
"""The clock; `kinds_of_calls` has the time of its thread alone, so that other programs count less."""

STATES = np.random.default_rng(0).uniform(-1, 1, (3, 65_536, 7))


def in_turns(programs: dict[str, Callable[[], object]], calls: int) -> dict[str, float]:
    """Seconds of a call of each program."""
    best = dict.fromkeys(programs, np.inf)
    for _ in range(TURNS):
        for name, program in programs.items():
            seconds = timeit.timeit(program, number=calls, timer=CLOCK)
            best[name] = min(best[name], seconds / calls)
    return best


def reduced_panda(pinocchio: Any) -> Any:
    model = pinocchio.buildModelFromUrdf(str(DATA / "urdf" / "panda.urdf"))
    fingers = [model.getJointId(f"panda_finger_joint{k}") for k in (1, 2)]
    return pinocchio.buildReducedModel(model, fingers, pinocchio.neutral(model))


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
        model = reduced_panda(pinocchio)
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


def beside(title: str, programs: dict[str, Callable[[], object]], calls: int) -> None:
    """The time of each program in shares of the first one's."""
    seconds = in_turns(programs, calls)
    first, *others = seconds
    for name in others:
        print(f"{title + name:44}{seconds[name] / seconds[first]:8.2f} times {first}")


def kinds_of_calls() -> None:
    """A base that moves, derivatives of one state, and kinds of numbers."""
    arm = panda(functions=["inverse_dynamics", "inverse_dynamics_derivatives", "forward_dynamics_derivatives"])
    one, many = tuple(STATES[:, 0]), tuple(STATES[:, :1024])
    for title, doubles, calls in (("one state, ", one, 5_000), ("1,024 states, ", many, 20)):
        singles = tuple(x.astype(np.float32) for x in doubles)
        programs: dict[str, Callable[[], object]] = {
            "doubles": lambda doubles=doubles: arm.inverse_dynamics(*doubles),
            "float32": lambda singles=singles: arm.inverse_dynamics(*singles),
        }
        beside(title, programs, calls)
    for name, given in (("integers", tuple(x.astype(int) for x in one)), ("lists", tuple(x.tolist() for x in one))):
        programs = {
            "doubles and numpy's conversion": lambda given=given: arm.inverse_dynamics(*(np.asarray(x, float) for x in given)),
            name: lambda given=given: arm.inverse_dynamics(*given),
        }
        beside("one state, ", programs, 5_000)
    path = DATA / "urdf" / "laikago.urdf"
    dog = rd.Robot.from_file(path, base="floating", gravity=(0, 0, -9.81), allow=["no_inertia"])
    pose, q, v, a = np.eye(4), *np.split(STATES.ravel()[:48], [12, 30])
    programs = {
        "coriolis_vector, without base": lambda: dog.coriolis_vector(q, v),
        "inverse_dynamics, with base": lambda: dog.inverse_dynamics(pose, q, v, a),
    }
    beside("a quadruped's ", programs, 2_000)
    try:
        import pinocchio
    except ImportError:
        return
    model = pinocchio.buildModelFromUrdf(str(path), pinocchio.JointModelFreeFlyer())
    data, theirs = model.createData(), np.concatenate([pinocchio.neutral(model)[:7], q])
    programs = {
        "Pinocchio's": lambda: pinocchio.rnea(model, data, theirs, v, a),
        "tau": lambda: dog.inverse_dynamics(pose, q, v, a),
    }
    beside("a quadruped's ", programs, 2_000)
    model = reduced_panda(pinocchio)
    data = model.createData()
    for name, theirs in (
        ("inverse_dynamics_derivatives", pinocchio.computeRNEADerivatives),
        ("forward_dynamics_derivatives", pinocchio.computeABADerivatives),
    ):
        programs = {
            "Pinocchio's": lambda theirs=theirs: theirs(model, data, *one),
            name: lambda name=name: getattr(arm, name)(*one),
        }
        beside("", programs, 2_000)


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
    CLOCK = time.thread_time
    kinds_of_calls()
