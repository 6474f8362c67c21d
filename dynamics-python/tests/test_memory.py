"""Arrays that share memory or are not aligned, and threads that the system does not have."""

import mmap
import subprocess
import sys
from collections.abc import Callable

import numpy as np
import pytest

import robot_dynamics as rd
from conftest import moving_body

RANDOM = np.random.default_rng(2)

STATES = 1000


@pytest.fixture(scope="module")
def body() -> rd.Robot:
    return moving_body()


def of_a_map() -> Callable[[int], np.ndarray]:
    """Arrays of states, each with a `memoryview` of its own as its base."""
    memory = mmap.mmap(-1, 8 * (7 * STATES + 16))
    return lambda first: np.frombuffer(memory, offset=8 * first, count=7 * STATES).reshape(-1, 7)


def of_strides() -> Callable[[int], np.ndarray]:
    memory = np.zeros(7 * STATES + 16)
    return lambda first: np.lib.stride_tricks.as_strided(memory[first:], (STATES, 7), (56, 8))


@pytest.mark.parametrize("array", [of_a_map, of_strides])
@pytest.mark.parametrize("shift", [-8, -7, -1, 0, 1, 7, 8])
def test_out_may_be_the_memory_of_an_argument(arm: rd.Robot, array, shift: int) -> None:
    """Also where the two have other objects as their bases: values are those of arguments that are kept."""
    part = array()
    q, out = part(8), part(8 + shift)
    assert np.shares_memory(q, out)
    q[:] = RANDOM.uniform(-1, 1, q.shape)
    kept = q.copy()
    assert arm.gravity_vector(q, out=out, threads=2) is out
    np.testing.assert_array_equal(out, arm.gravity_vector(kept))
    # A single state, the second argument of three, and bounds.
    q[:] = kept
    assert arm.gravity_vector(q[0], out=out[0]) is not None
    np.testing.assert_array_equal(out[0], arm.gravity_vector(kept[0]))
    q[:] = kept
    arm.inverse_dynamics(kept, q, kept, out=out)
    np.testing.assert_array_equal(out, arm.inverse_dynamics(kept, kept, kept))
    q[:] = kept
    arm.gravity_vector.bound(q[:3], out=out[:3])
    np.testing.assert_array_equal(out[:3], arm.bound("gravity_vector", kept[:3]))


def test_out_may_be_the_memory_of_a_pose(body: rd.Robot) -> None:
    memory = bytearray(np.tile(np.eye(4), (5, 1, 1)).tobytes())
    poses, out = np.frombuffer(memory).reshape(5, 4, 4), np.frombuffer(memory, count=35).reshape(5, 7)
    expected = body.gravity_vector(poses.copy(), np.zeros((5, 1)))
    body.gravity_vector(poses, np.zeros((5, 1)), out=out)
    np.testing.assert_array_equal(out, expected)


def unaligned(array: np.ndarray) -> np.ndarray:
    """The same numbers, a byte beside the places of doubles."""
    moved = np.zeros(array.nbytes + 1, dtype=np.uint8)[1:].view(array.dtype).reshape(array.shape)
    moved[...] = array
    assert array.size == 0 or not moved.flags.aligned
    return moved


@pytest.mark.parametrize("lead", [(), (1,), (100,), (3, 40), (0,)])
def test_arrays_may_be_unaligned(arm: rd.Robot, body: rd.Robot, lead: tuple[int, ...]) -> None:
    q, qd, qdd = RANDOM.uniform(-1, 1, (3, *lead, 7))
    tau = arm.inverse_dynamics(q, qd, qdd)
    np.testing.assert_array_equal(arm.inverse_dynamics(unaligned(q), unaligned(qd), qdd), tau)
    out = unaligned(np.full((*lead, 7), np.nan))
    assert arm.inverse_dynamics(q, unaligned(qd), qdd, out=out) is out
    np.testing.assert_array_equal(out, tau)
    single = [x.astype(np.float32) for x in (q, qd, qdd)]
    out = unaligned(np.zeros((*lead, 7), dtype=np.float32))
    arm.inverse_dynamics(*map(unaligned, single), out=out)
    np.testing.assert_array_equal(out, arm.inverse_dynamics(*single))
    packed = np.zeros(lead, dtype=[("kind", "u1"), ("q", "f8", (7,))])
    packed["q"] = q
    np.testing.assert_array_equal(arm.gravity_vector(packed["q"]), arm.gravity_vector(q))
    poses = np.broadcast_to(np.eye(4), (*lead, 4, 4)).copy()
    found = body.gravity_vector(unaligned(poses), unaligned(q[..., :1].copy()))
    np.testing.assert_array_equal(found, body.gravity_vector(poses, q[..., :1]))


PRELUDE = """
import resource, threading
import numpy as np
import robot_dynamics as rd
arm = rd.Robot.from_toml('''
    convention = "modified"
    gravity = [0, -9.81, 0]
    [[joint]]
    name = "a"
    type = "revolute"
    mass = 1
    com = [1, 0, 0]
''')
q = np.linspace(-3, 3, 200_000)[:, None]
expected = arm.gravity_vector(q)
out = np.zeros_like(expected)
"""

SIX_GIGABYTES = """
resource.setrlimit(resource.RLIMIT_AS, (6 << 30, 6 << 30))
arm.gravity_vector(q, out=out, threads=1_000_000)
"""

NO_STACK = """
pages = int(open("/proc/self/statm").read().split()[0])
limit = pages * resource.getpagesize() + (3 << 19)
resource.setrlimit(resource.RLIMIT_AS, (limit, limit))
threading.stack_size(2 << 20)
ended = threading.Event()
try:
    while True:
        threading.Thread(target=ended.wait, daemon=True).start()
except RuntimeError:
    print("no thread")
arm.gravity_vector(q, out=out, threads=2)
ended.set()
"""


@pytest.mark.skipif(sys.platform != "linux", reason="limits of memory are Linux's")
@pytest.mark.parametrize(("limited", "said"), [(SIX_GIGABYTES, ""), (NO_STACK, "no thread\n")])
def test_more_threads_than_the_system_has(limited: str, said: str) -> None:
    program = PRELUDE + limited + "assert (out == expected).all()"
    ended = subprocess.run([sys.executable, "-c", program], capture_output=True, text=True, timeout=120)
    assert (ended.returncode, ended.stdout, ended.stderr) == (0, said, "")
