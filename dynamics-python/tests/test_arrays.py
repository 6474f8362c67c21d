"""Shapes, strides and kinds of arrays: all as numpy has them."""

import sys
import threading
from concurrent.futures import ThreadPoolExecutor

import numpy as np
import pytest
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st
from hypothesis.extra.numpy import mutually_broadcastable_shapes

import robot_dynamics as rd

RANDOM = np.random.default_rng(1)

many = settings(
    max_examples=60, deadline=None, suppress_health_check=[HealthCheck.function_scoped_fixture]
)


def states(*lead: int) -> tuple[np.ndarray, ...]:
    return tuple(RANDOM.uniform(-1, 1, (*lead, 7)) for _ in range(3))


def one_by_one(function: rd.Function, *arguments: np.ndarray) -> np.ndarray:
    """The values of all states, each by a call of its own."""
    lead = np.broadcast_shapes(*(argument.shape[:-1] for argument in arguments))
    full = [np.broadcast_to(argument, (*lead, 7)) for argument in arguments]
    values = [function(*(argument[index] for argument in full)) for index in np.ndindex(lead)]
    value = function(*(np.zeros(7) for _ in arguments))
    return np.array(values).reshape(lead + np.shape(value))


@many
@given(mutually_broadcastable_shapes(num_shapes=3, max_dims=3, max_side=3, min_side=0))
def test_leading_axes_are_broadcast(arm: rd.Robot, shapes) -> None:
    arguments = [RANDOM.uniform(-1, 1, (*shape, 7)) for shape in shapes.input_shapes]
    tau = arm.inverse_dynamics(*arguments)
    expected = np.broadcast(*(argument[..., 0] for argument in arguments)).shape
    assert tau.shape == (*expected, 7) and tau.dtype == np.float64
    np.testing.assert_allclose(
        tau, one_by_one(arm.inverse_dynamics, *arguments), rtol=0, atol=1e-12
    )


@many
@given(
    st.lists(st.integers(1, 4), max_size=3),
    st.integers(-2, 3).filter(lambda step: step != 0),
    st.booleans(),
)
def test_strides_do_not_matter(arm: rd.Robot, lead: list[int], step: int, fortran: bool) -> None:
    q = RANDOM.uniform(-1, 1, (*lead, 7 * abs(step)))
    if fortran:
        q = np.asfortranarray(q)
    strided = q[..., ::step]
    assert strided.shape[-1] == 7
    M = arm.mass_matrix(strided)
    np.testing.assert_array_equal(M, arm.mass_matrix(np.ascontiguousarray(strided)))
    assert M.shape == (*lead, 7, 7) and M.flags.c_contiguous


def test_matrices_lie_by_rows() -> None:
    from conftest import panda

    jacobian = panda(functions=["jacobian", "tool_velocity"])
    q, qd, _ = states(5)
    J = jacobian.jacobian(q)
    assert J.shape == (5, 6, 7)
    velocity = np.einsum("...ij,...j", J, qd)
    np.testing.assert_allclose(jacobian.tool_velocity(q, qd), velocity, atol=1e-14)


def test_kinds_of_numbers(arm: rd.Robot) -> None:
    q, qd, qdd = states(3)
    double = arm.inverse_dynamics(q, qd, qdd)
    single = arm.inverse_dynamics(*(x.astype(np.float32) for x in (q, qd, qdd)))
    assert single.dtype == np.float32
    rounded = arm.inverse_dynamics(*(x.astype(np.float32).astype(float) for x in (q, qd, qdd)))
    np.testing.assert_array_equal(single, rounded.astype(np.float32))
    assert arm.inverse_dynamics(q.astype(np.float32), qd, qdd).dtype == np.float64
    whole = np.ones(7, dtype=np.int32)
    np.testing.assert_array_equal(arm.gravity_vector(whole), arm.gravity_vector(whole * 1.0))
    np.testing.assert_array_equal(arm.gravity_vector([1] * 7), arm.gravity_vector(whole * 1.0))
    # One state is read without numpy, and has the same digits and kinds.
    one = [x[0] for x in (q, qd, qdd)]
    tau = arm.inverse_dynamics(*one)
    for given in (x.tolist() for x in one), (list(x) for x in one), (x[::1] for x in one), (tuple(x) for x in one):
        found = arm.inverse_dynamics(*given)
        np.testing.assert_array_equal(found, tau)
        assert found.dtype == np.float64
    found = arm.inverse_dynamics(*(x.astype(np.float32) for x in one))
    assert found.dtype == np.float32
    rounded = arm.inverse_dynamics(*(x.astype(np.float32).astype(float) for x in one))
    np.testing.assert_array_equal(found, rounded.astype(np.float32))
    assert arm.inverse_dynamics(one[0].astype(np.float32), whole, one[2].tolist()).dtype == np.float64
    for kind in ("i1", "i2", "i4", "i8", "u1", "u4", "u8"):
        np.testing.assert_array_equal(arm.gravity_vector(whole.astype(kind)), arm.gravity_vector(whole * 1.0))
        assert arm.gravity_vector(whole.astype(kind)).dtype == np.float64
    mixed = [x.astype(np.float32) for x in one[:2]]
    assert arm.inverse_dynamics(*mixed, whole.astype("i2")).dtype == np.float32
    assert arm.inverse_dynamics(*mixed, whole).dtype == np.float64
    for refused in ([True] * 7, [1j] * 7, ["1"] * 7):
        with pytest.raises(TypeError, match="`q` is an array of"):
            arm.gravity_vector(refused)
    swapped = q.astype(">f8")
    np.testing.assert_array_equal(arm.inverse_dynamics(swapped, qd, qdd), double)
    for kind in ("complex128", "bool", "float16", "longdouble", "object", "U3", "datetime64[s]"):
        with pytest.raises(TypeError, match="`q` is an array of"):
            arm.gravity_vector(np.zeros(7).astype(kind))


def test_numbers_are_those_of_numpy(arm: rd.Robot) -> None:
    q, qd, _ = states()
    energy = arm.kinetic_energy(q, qd)
    assert type(energy) is np.float64 and energy > 0
    assert type(arm.kinetic_energy(q.astype("f4"), qd.astype("f4"))) is np.float32
    assert arm.kinetic_energy(np.zeros((4, 1, 7)), np.zeros((3, 7))).shape == (4, 3)
    assert energy == pytest.approx(qd @ arm.mass_matrix(q) @ qd / 2)


def test_wrong_shapes_name_the_argument_and_both_shapes(arm: rd.Robot) -> None:
    with pytest.raises(ValueError, match=r"`qd` has the shape \(5, 6\): expected \(\.\.\., 7\)"):
        arm.inverse_dynamics(np.zeros(7), np.zeros((5, 6)), np.zeros(7))
    with pytest.raises(ValueError, match=r"`q` has the shape \(\)"):
        arm.gravity_vector(1.0)
    with pytest.raises(ValueError, match=r"`qd` has the leading axes \(3,\).* \(2,\)"):
        arm.kinetic_energy(np.zeros((2, 7)), np.zeros((3, 7)))


def test_wrong_calls(arm: rd.Robot) -> None:
    q, qd, qdd = states()
    tau = arm.inverse_dynamics(q, qd, qdd)
    np.testing.assert_array_equal(arm.inverse_dynamics(q, qdd=qdd, qd=qd), tau)
    for arguments, keywords, message in [
        ((q, qd), {}, "`qdd` is missing"),
        ((q, qd, qdd, qdd), {}, "takes 3 arguments, and 4 were given"),
        ((q, qd, qdd), {"q": q}, "`q` is given twice"),
        ((q, qd, qdd), {"velocity": q}, "has no argument `velocity`"),
        ((q, qd, qdd), {"out": [0.0] * 7}, "`out` is no array"),
        ((q, qd, qdd), {"out": np.zeros(7, dtype="f4")}, "`out` is an array of float32"),
    ]:
        with pytest.raises(TypeError, match=message):
            arm.inverse_dynamics(*arguments, **keywords)
    for keywords, message in [
        ({"out": np.zeros(6)}, r"`out` has the shape \(6,\): expected \(7,\)"),
        ({"threads": 0}, "`threads` is 0"),
        ({"on_singular": "zero"}, "`on_singular` is zero"),
    ]:
        with pytest.raises(ValueError, match=message):
            arm.inverse_dynamics(q, qd, qdd, **keywords)


@pytest.mark.parametrize("lead", [(), (5,), (100,), (3, 40)])
def test_results_in_an_array_of_the_caller(arm: rd.Robot, lead: tuple[int, ...]) -> None:
    q, qd, qdd = states(*lead)
    tau = arm.inverse_dynamics(q, qd, qdd)
    out = np.full((*lead, 7), np.nan)
    assert arm.inverse_dynamics(q, qd, qdd, out=out) is out
    np.testing.assert_array_equal(out, tau)
    strided = np.full((*lead, 14), np.nan)
    arm.inverse_dynamics(q, qd, qdd, out=strided[..., ::2])
    np.testing.assert_array_equal(strided[..., ::2], tau)
    assert np.isnan(strided[..., 1::2]).all()
    single = [x.astype(np.float32) for x in (q, qd, qdd)]
    out = np.empty((*lead, 7), dtype=np.float32)
    assert arm.inverse_dynamics(*single, out=out) is out
    np.testing.assert_array_equal(out, arm.inverse_dynamics(*single))
    own = qdd.copy()
    assert arm.inverse_dynamics(q, qd, own, out=own) is own
    np.testing.assert_array_equal(own, tau)


def test_threads_have_the_same_digits(arm: rd.Robot) -> None:
    q, qd, qdd = states(1000)
    tau = arm.forward_dynamics(q, qd, qdd)
    for threads in (2, 3, 7, 5000):
        np.testing.assert_array_equal(arm.forward_dynamics(q, qd, qdd, threads=threads), tau)


def test_many_threads_of_python_call_one_robot() -> None:
    from conftest import panda

    arm = panda()
    q, qd, qdd = states(64)
    with ThreadPoolExecutor(8) as pool:
        results = list(pool.map(lambda _: arm.inverse_dynamics(q, qd, qdd), range(64)))
    for tau in results:
        np.testing.assert_array_equal(tau, results[0])


@pytest.mark.parametrize(("count", "calls", "gives_back"), [(12, 2_000, False), (20_000, 20, True)])
def test_other_threads_run_during_large_batches(
    arm: rd.Robot, count: int, calls: int, gives_back: bool
) -> None:
    """The interpreter changes threads by itself after 100 s: before that, only where the lock is given back."""
    q, qd, tau = states(count)
    arm.forward_dynamics(q[0], qd[0], tau[0])  # A derivation gives the lock back, too.
    started, ended = threading.Event(), threading.Event()

    def compute() -> None:
        started.set()
        for _ in range(calls):
            arm.forward_dynamics(q, qd, tau)
        ended.set()

    interval = sys.getswitchinterval()
    sys.setswitchinterval(100)
    try:
        thread = threading.Thread(target=compute)
        thread.start()
        started.wait()
        is_during = not ended.is_set()
    finally:
        sys.setswitchinterval(interval)
    thread.join()
    assert is_during == gives_back


def test_no_states(arm: rd.Robot) -> None:
    assert arm.mass_matrix(np.zeros((0, 7))).shape == (0, 7, 7)
    assert arm.mass_matrix(np.zeros((3, 0, 7)), threads=2).shape == (3, 0, 7, 7)


def test_bounds_have_the_shape_of_the_values(arm: rd.Robot) -> None:
    q = states(2)[0]
    bounds = arm.bound("mass_matrix", q)
    M = arm.mass_matrix(q)
    assert bounds.shape == M.shape and (bounds < 1e-13).all() and (bounds > 0).any()
    assert arm.bound("inverse_dynamics", q, q, q).shape == (2, 7)


def test_a_body_without_joints_has_arrays() -> None:
    body = rd.Robot.from_toml(
        """
        gravity = [0, 0, -9.81]
        base = { floating = true, mass = 5, inertia = { xx = 0.1, yy = 0.2, zz = 0.25 } }
        """,
        functions=["mass_matrix", "coriolis_vector", "link_poses"],
    )
    v = np.arange(30.0).reshape(5, 6)
    many = body.coriolis_vector(np.zeros((5, 0)), v)
    for found, one in zip(many, v):
        np.testing.assert_allclose(found, body.coriolis_vector([], one), rtol=1e-12)
    assert body.mass_matrix(np.zeros((3, 0))).shape == (3, 6, 6)
    assert body.link_poses(np.eye(4), []).shape == (0, 4, 4)
    assert body.bound("link_poses", np.eye(4), []).shape == (0, 4, 4)


def test_unaligned_numbers(arm: rd.Robot) -> None:
    q = RANDOM.uniform(-1, 1, (5, 7))
    for kind in ("f8", "f4"):
        packed = np.zeros((5, 7), dtype=[("flag", "i1"), ("q", kind)])
        packed["q"] = q
        assert not packed["q"].flags.aligned
        expected = arm.gravity_vector(q.astype(kind))
        np.testing.assert_array_equal(arm.gravity_vector(packed["q"]), expected)
        np.testing.assert_array_equal(arm.gravity_vector(packed["q"][0]), arm.gravity_vector(q[0].astype(kind)))


def test_tuples_of_one_state_and_of_many() -> None:
    from conftest import panda

    arm = panda(functions=["inverse_dynamics_derivatives"])
    given = states(3)
    many = arm.inverse_dynamics_derivatives(*given)
    assert [part.shape for part in many] == [(3, 7, 7)] * 2
    for k in range(3):
        one = arm.inverse_dynamics_derivatives(*(x[k] for x in given))
        for part, parts in zip(one, many, strict=True):
            assert part.flags.c_contiguous and part.flags.owndata
            np.testing.assert_allclose(part, parts[k], atol=1e-13)
    one = arm.inverse_dynamics_derivatives(*(x[0].astype("f4") for x in given))
    assert [part.dtype for part in one] == [np.float32] * 2


def test_fields_by_state() -> None:
    """A call has values of fields, one for all states or one for each."""
    from conftest import DATA

    arm = rd.Robot.from_file(DATA / "files" / "two_link.toml", fields={"m1": 1.0, "l1": 0.5, "l2": 0.4, "g": 9.81, "m2": 2.0})
    q, qd, qdd = (RANDOM.uniform(-1, 1, (4, 2)) for _ in range(3))
    loads = np.array([0.5, 0.5, 3.0, 1.0])
    found = arm.inverse_dynamics(q, qd, qdd, m2=loads)
    each = [arm.with_fields(m2=m).inverse_dynamics(*x) for m, *x in zip(loads, q, qd, qdd)]
    np.testing.assert_allclose(found, each, atol=1e-13)
    np.testing.assert_array_equal(arm.inverse_dynamics(q, qd, qdd, m2=loads, threads=2), found)
    # They are broadcast with the arguments, and several of them with each other.
    grid = arm.mass_matrix(q[0], m2=loads[:, None], l1=[0.3, 0.4, 0.7])
    assert grid.shape == (4, 3, 2, 2)
    same = arm.with_fields(m2=3.0, l1=0.7).mass_matrix(q[0])
    np.testing.assert_allclose(grid[2, 2], same, atol=1e-14)
    np.testing.assert_array_equal(arm.mass_matrix(q[0], m2=3), arm.with_fields(m2=3.0).mass_matrix(q[0]))
    bounds = arm.mass_matrix.bound(q[0], m2=loads)
    np.testing.assert_array_equal(bounds[2], arm.with_fields(m2=3.0).mass_matrix.bound(q[0]))
    single = arm.gravity_vector(q.astype("f4"), m2=loads.astype("f4"))
    assert single.dtype == np.float32
    # The robot keeps its own.
    assert arm.fields["m2"] == 2.0
    np.testing.assert_array_equal(arm.mass_matrix(q, m2=2.0), arm.mass_matrix(q))
    with pytest.raises(ValueError, match=r"`m2` has the leading axes \(3,\), .* \(4,\)"):
        arm.mass_matrix(q, m2=[1, 2, 3])
    with pytest.raises(TypeError, match="`m2` is an array of"):
        arm.mass_matrix(q, m2="heavy")
    with pytest.raises(TypeError, match="has no argument `m3`"):
        arm.mass_matrix(q, m3=1)


def test_a_call_may_give_what_a_robot_has_not() -> None:
    from conftest import DATA

    arm = rd.Robot.from_file(DATA / "files" / "two_link.toml")
    q = np.array([0.3, 0.4])
    values = {"m1": 1.0, "l1": 0.5, "l2": 0.4, "g": 9.81, "m2": 2.0}
    np.testing.assert_array_equal(arm.mass_matrix(q, **values), arm.with_fields(**values).mass_matrix(q))
    with pytest.raises(ValueError, match="field `m2` has no value"):
        arm.mass_matrix(q, **{name: x for name, x in values.items() if name != "m2"})
    with pytest.raises(ValueError, match="have no values"):
        arm.mass_matrix(q)


def test_singular_states_of_fields_are_told() -> None:
    point = {"name": "pivot", "type": "revolute", "mass": "m", "com": [1, 0, 0]}
    arm = rd.Robot.from_table(convention="modified", gravity=[0, 0, 0], joint=[point], functions=["forward_dynamics"])
    masses = np.array([[1.0, 2.0, 0.0], [1.0, 0.0, 1.0]])
    with pytest.raises(rd.SingularMassMatrix) as raised:
        arm.forward_dynamics([0], [0], [1], m=masses)
    assert raised.value.index == (0, 2)
    found = arm.forward_dynamics([0], [0], [1], m=masses, on_singular="nan")
    np.testing.assert_array_equal(found[..., 0], [[1, 0.5, np.nan], [1, np.nan, 1]])
