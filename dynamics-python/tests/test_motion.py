"""Simulations under constant torques and under laws of Python."""

import numpy as np
import pytest

import robot_dynamics as rd

CART = """
convention = "modified"
gravity = [0, -9.7, -1.5]
[[joint]]
name = "rail"
type = "prismatic"
mass = 2
limits = [-1, 1]
torque_limit = 4
"""
"""A cart of 2 kg on a rail that slopes."""

PENDULUM = """
convention = "modified"
gravity = [9.81, 0, 0]
[[joint]]
name = "pivot"
type = "revolute"
mass = 1
com = [0.5, 0, 0]
"""

METHODS = [
    ("explicit_euler", 1e-4, 2e-3),
    ("craig_euler", 1e-4, 2e-3),
    ("semi_implicit_euler", 1e-4, 2e-3),
    ("runge_kutta4", 1e-2, 1e-6),
    ("implicit_midpoint", 1e-3, 1e-5),
    ("gauss_legendre4", 1e-2, 1e-7),
    ("gauss_legendre6", 1e-2, 1e-9),
    ("dormand_prince", None, 1e-7),
    ("dop853", None, 1e-7),
    ("radau5", None, 1e-6),
]


@pytest.fixture(scope="module")
def cart() -> rd.Robot:
    return rd.Robot.from_toml(CART)


@pytest.fixture(scope="module")
def pendulum() -> rd.Robot:
    return rd.Robot.from_toml(PENDULUM)


@pytest.mark.parametrize(("method", "step", "tolerance"), METHODS)
def test_all_methods_follow_a_pendulum(
    pendulum: rd.Robot, method: str, step: float | None, tolerance: float
) -> None:
    exact = pendulum.simulate([1.0], duration=2, method="dop853", tolerance=1e-13)
    motion = pendulum.simulate([1.0], duration=2, method=method, step=step)
    np.testing.assert_allclose(motion.q, exact.q, atol=tolerance)
    assert motion.q.shape == motion.qd.shape == motion.qdd.shape == motion.tau.shape == (101, 1)
    assert motion.work.steps > 0 and len(motion) == 101
    np.testing.assert_allclose(exact.energy, exact.energy[0], atol=1e-11)


def test_a_constant_torque(cart: rd.Robot) -> None:
    """Gravity pulls with 3 N: 5 N accelerate by 1 m/s^2."""
    motion = cart.simulate([0.0], [0.5], torque=[5], duration=1.0, samples=11)
    np.testing.assert_allclose(motion.q[:, 0], 0.5 * motion.t + 0.5 * motion.t**2, atol=1e-12)
    np.testing.assert_allclose(motion.qdd, 1, atol=1e-12)
    held = cart.simulate([0.0], torque=[5], saturate=True)
    np.testing.assert_array_equal(held.tau, 4)


def test_a_law_of_python(cart: rd.Robot) -> None:
    def law(t: float, q: np.ndarray, qd: np.ndarray) -> np.ndarray:
        return 3 - 50 * q - 20 * qd

    motion = cart.simulate([0.4], torque=law, duration=3.0)
    np.testing.assert_allclose(motion.q[:, 0], 0.4 * (1 + 5 * motion.t) * np.exp(-5 * motion.t), atol=1e-7)
    np.testing.assert_allclose(motion.tau, 3 - 50 * motion.q - 20 * motion.qd, atol=1e-12)


def test_a_sampled_law_has_a_memory(cart: rd.Robot) -> None:
    calls = []

    def law(t: float, q: np.ndarray, qd: np.ndarray) -> list[float]:
        calls.append(t)
        integral = sum(0.1 - p for p in positions) * 1e-2
        positions.append(q[0])
        return [(0.1 - q[0]) * 200 + integral * 400 - qd[0] * 40]

    positions: list[float] = []
    motion = cart.simulate([0.0], torque=law, duration=1.0, control_period=1e-2)
    assert calls == sorted(calls) and 100 <= len(calls) <= 101
    assert motion.q[-1, 0] == pytest.approx(0.1, abs=0.02)


def test_an_exception_of_the_law_is_raised(cart: rd.Robot) -> None:
    def law(t: float, q: np.ndarray, qd: np.ndarray) -> list[float]:
        if t > 0.5:
            raise KeyError("broken")
        return [0.0]

    with pytest.raises(KeyError, match="broken"):
        cart.simulate([0.0], torque=law)
    with pytest.raises(ValueError, match="`torque` returned 2 numbers: expected 1"):
        cart.simulate([0.0], torque=lambda t, q, qd: [0, 0])


def test_a_force_at_the_tool() -> None:
    """From 1 m on a wall pushes back: the cart returns with its speed."""
    arm = rd.Robot.from_toml(
        CART, gravity=[0, -9.7, 0], functions=["default", "forward_kinematics", "jacobian"]
    )

    def wall(t: float, pose: np.ndarray, twist: np.ndarray) -> list[float]:
        assert pose.shape == (4, 4) and twist.shape == (6,)
        return [0, 0, -800 * max(pose[2, 3] - 1, 0), 0, 0, 0]

    motion = arm.simulate([0.0], [1.0], tool_wrench=wall, duration=2.0, tolerance=1e-10)
    np.testing.assert_allclose(motion.qd[[0, -1], 0], [1, -1], atol=1e-6)
    with pytest.raises(ValueError, match="`tool_wrench` returned 3 numbers: expected 6"):
        arm.simulate([0.0], tool_wrench=lambda t, pose, twist: [0, 0, 0])
    with pytest.raises(ValueError, match="forward_kinematics"):
        rd.Robot.from_toml(CART).simulate([0.0], tool_wrench=wall)


def test_a_held_force_at_the_tool() -> None:
    """Pushes that are drawn once a period: the momentum is the sum of them."""
    arm = rd.Robot.from_toml(
        CART, gravity=[0, -9.7, 0], functions=["default", "forward_kinematics", "jacobian"]
    )
    random = np.random.default_rng(0)
    pushes: list[float] = []

    def push(t: float, pose: np.ndarray, twist: np.ndarray) -> list[float]:
        pushes.append(random.uniform(-1, 1))
        return [0, 0, pushes[-1], 0, 0, 0]

    motion = arm.simulate([0.0], held_tool_wrench=push, control_period=0.1, duration=1.0)
    assert 10 <= len(pushes) <= 11
    assert 2 * motion.qd[-1, 0] == pytest.approx(0.1 * sum(pushes[:10]), abs=1e-9)
    for settings in {}, {"tool_wrench": push, "control_period": 0.1}:
        with pytest.raises(ValueError, match="`held_tool_wrench` takes the place"):
            arm.simulate([0.0], held_tool_wrench=push, **settings)


FINGERS = """
convention = "modified"
gravity = [0, -9.81, 0]
functions = ["default", "forward_kinematics(left_pad)", "jacobian(left_pad)", "forward_kinematics(right_pad)", "jacobian(right_pad)"]
[[joint]]
name = "left"
type = "prismatic"
mass = 1
[[joint]]
name = "right"
on = "base"
type = "prismatic"
mass = 1
[frame.left_pad]
on = "left"
xyz = [0, 0, 0.1]
[frame.right_pad]
on = "right"
xyz = [0, 0, -0.1]
[frame.screw]
on = "right"
"""
"""Two fingers on one rail, with pads."""


def test_forces_at_frames() -> None:
    fingers = rd.Robot.from_toml(FINGERS)
    places: list[float] = []

    def push(t: float, pose: np.ndarray, twist: np.ndarray) -> list[float]:
        places.append(pose[2, 3])
        assert pose.shape == (4, 4) and twist.shape == (6,)
        return [0, 0, 2, 0, 0, 0]

    laws = {"left_pad": push, "right_pad": lambda t, pose, twist: -0.5 * twist}
    motion = fingers.simulate([0, 0.5], [0, 1], wrench_at=laws, tolerance=1e-12)
    np.testing.assert_allclose(motion.q[:, 0], motion.t**2, atol=1e-9)
    np.testing.assert_allclose(motion.qd[:, 1], np.exp(-motion.t / 2), atol=1e-9)
    assert places[0] == 0.1
    np.testing.assert_array_equal(motion.tau, 0)
    sampled = fingers.simulate([0, 0.5], wrench_at=laws, control_period=0.1, torque=lambda t, q, qd: [-2, 0])
    np.testing.assert_allclose(sampled.q[-1], [0, 0.5], atol=1e-9)
    for nothing in None, {}:
        np.testing.assert_array_equal(fingers.simulate([0, 0.5], wrench_at=nothing).q[-1], [0, 0.5])


def test_a_force_at_a_frame_besides_those_at_the_tool() -> None:
    functions = [f"{name}{of}" for name in ("forward_kinematics", "jacobian") for of in ("", "(bumper)")]
    cart = rd.Robot.from_toml(
        CART, gravity=[0, -9.7, 0], functions=["default", *functions], frames={"bumper": {"on": "rail"}}
    )

    def along(force: float) -> rd.Law:
        return lambda t, pose, twist: [0, 0, force, 0, 0, 0]

    laws = {"wrench_at": {"bumper": along(1.5)}, "duration": 1.0}
    both = cart.simulate([0.0], tool_wrench=along(0.5), **laws)
    assert both.q[-1, 0] == pytest.approx(0.5, abs=1e-12)
    held = cart.simulate([0.0], held_tool_wrench=along(-1.5), control_period=0.1, **laws)
    assert held.q[-1, 0] == pytest.approx(0, abs=1e-12)


def test_mistakes_about_forces_at_frames() -> None:
    fingers = rd.Robot.from_toml(FINGERS)

    def still(t: float, pose: np.ndarray, twist: np.ndarray) -> list[float]:
        return [0] * 6

    for laws, message in [
        ({"left_pda": still}, "no frame `left_pda`: did you mean `left_pad`\\?"),
        ({"elbow": still}, "no frame `elbow`: expected one of left_pad, right_pad, screw"),
        ({"screw": still}, r"frame `screw` needs .*\"forward_kinematics\(screw\)\", \"jacobian\(screw\)\""),
        ({"left_pad": lambda *_: [1, 2, 3]}, r'`wrench_at\["left_pad"\]` returned 3 numbers: expected 6'),
        ({"left_pad": lambda *_: np.zeros((2, 3))}, r"an array of the shape \(2, 3\): expected \(6,\)"),
        ({"left_pad": lambda *_: None}, "returned None: expected 6 numbers"),
    ]:
        with pytest.raises(ValueError, match=message):
            fingers.simulate([0, 0], wrench_at=laws)
    with pytest.raises(TypeError, match="`wrench_at` is a mapping of frames to laws"):
        fingers.simulate([0, 0], wrench_at=still)  # type: ignore[arg-type]
    with pytest.raises(TypeError, match=r'`wrench_at\["left_pad"\]` is 2: expected a function'):
        fingers.simulate([0, 0], wrench_at={"left_pad": 2})  # type: ignore[dict-item]
    with pytest.raises(ValueError, match="no frame `left_pad`: there are none"):
        rd.Robot.from_toml(CART).simulate([0], wrench_at={"left_pad": still})


def test_stops_and_limits(cart: rd.Robot) -> None:
    with pytest.raises(rd.SimulationError, match="rail|joint 1") as raised:
        cart.simulate([0.0], limits_are_errors=True, duration=4)
    error = raised.value
    # It slides down by 1.5 m/s^2 / 2 t^2.
    assert error.time == pytest.approx(np.sqrt(2 / 1.5)) and error.trajectory.t[-1] <= error.time
    motion = cart.simulate([0.0], stops=0.5, duration=4)
    assert motion.q.min() >= -1 and motion.qd.max() > 0.5


def test_joints_that_creep_are_told() -> None:
    arm = rd.Robot.from_toml(CART + "friction = { coulomb = 5 }\n")
    with pytest.warns(RuntimeWarning, match="let it creep"):
        motion = arm.simulate([0.0], [1.0], method="runge_kutta4", step=1e-2)
    assert motion.creeping == motion.joint_names
    assert not arm.simulate([0.0], [1.0], method="runge_kutta4", step=1e-2, friction="sticking").creeping
    with pytest.raises(ValueError, match="more samples"):
        arm.simulate([0.0], [1.0], method="runge_kutta4", step=1e-2, control_period=1e-9)


def test_sticking(cart: rd.Robot) -> None:
    text = CART + "friction = { coulomb = 5 }\n"
    arm = rd.Robot.from_toml(text)
    motion = arm.simulate([0.0], [1.0], friction="sticking")
    assert motion.qd[-1, 0] == 0 and motion.q[-1, 0] > 0
    with pytest.raises(rd.SimulationError, match="joint 1 \\(rail\\) is held at rest .*: take sticking friction") as raised:
        arm.simulate([0.0], [1.0], tolerance=1e-6, duration=1e4, samples=10_001)
    assert 0.2 < raised.value.time < 1 and raised.value.trajectory.work.steps < 12_000
    with pytest.raises(ValueError, match="`friction` is \"glue\""):
        arm.simulate([0.0], friction="glue")


def test_settings_that_make_no_sense(cart: rd.Robot) -> None:
    for settings, message in [
        ({"method": "verlet"}, "`method` is \"verlet\""),
        ({"method": "runge_kutta4"}, "`step` is missing"),
        ({"step": 0.1}, "\"dormand_prince\" has no `step`: it chooses its steps"),
        ({"method": "runge_kutta4", "step": 0.1, "tolerance": 1e-6}, "has no `tolerance`: all of its steps"),
        ({"duration": -1.0}, "duration"),
        ({"torque": [1, 2]}, r"`torque` has the shape \(2,\): expected \(1,\)"),
        ({"base": np.eye(4)}, "stands"),
    ]:
        with pytest.raises(ValueError, match=message):
            cart.simulate([0.0], **settings)
    for setting, message in [
        ("steps", "unknown keyword `steps`: did you mean `step`"),
        ("torqe", "unknown keyword `torqe`: did you mean `torque`"),
        ("mass", "unknown keyword `mass`: expected one of q, qd, torque, .*held_tool_wrench"),
    ]:
        with pytest.raises(TypeError, match=message):
            cart.simulate([0.0], **{setting: 3})
    with pytest.raises(TypeError, match="`samples` is -1: .*negative"):
        cart.simulate([0.0], samples=-1)


def test_a_base_that_moves() -> None:
    body = rd.Robot.from_table(
        convention="modified",
        gravity=[0, 0, -10],
        base={"floating": True, "mass": 2, "inertia": {"xx": 0.1, "yy": 0.2, "zz": 0.25}},
        joint=[{"name": "wheel", "type": "revolute", "mass": 1, "inertia": {"zz": 0.1}}],
    )

    def law(t: float, base: np.ndarray, q: np.ndarray, v: np.ndarray) -> np.ndarray:
        assert base.shape == (4, 4) and q.shape == (1,) and v.shape == (7,)
        return np.zeros(7)

    aside = np.eye(4)
    aside[0, 3] = 0.1
    with pytest.raises(ValueError, match="`base` is no homogeneous transform, .*transposed"):
        body.simulate([0.0], base=aside.T)
    with pytest.raises(ValueError, match="`base` is no homogeneous transform, .*transposed"):
        body.potential_energy(np.stack([aside, aside.T]), np.zeros((2, 1)))
    velocity = [0, 0, 0, 0, 0, 0, 3.0]
    motion = body.simulate([0.0], velocity, torque=law, duration=1, samples=11)
    assert motion.base is not None and motion.base.shape == (11, 4, 4)
    np.testing.assert_allclose(motion.base[:, 2, 3], -5 * motion.t**2, atol=1e-9)
    np.testing.assert_allclose(motion.q[:, 0], 3 * motion.t, atol=1e-9)


def test_forces_on_a_base_that_moves() -> None:
    """A ball on a rope that is tied to it at one side, and beside it a thread at its tip."""
    ball = rd.Robot.from_toml(
        """
        convention = "modified"
        gravity = [0, 0, -10]
        base = { floating = true, mass = 1, inertia = "sphere(0.1)" }
        [[joint]]
        name = "wheel"
        type = "revolute"
        mass = 1
        inertia = { zz = 0.1 }
        [frame.knot]
        on = "base"
        xyz = [0, 0, 0.1]
        """,
        functions=["default", "forward_kinematics(knot)", "jacobian(knot)", "forward_kinematics", "jacobian"],
    )
    base = np.eye(4)
    base[:3, 3] = [1, 2, 3]

    def rope(t: float, pose: np.ndarray, twist: np.ndarray) -> list[float]:
        np.testing.assert_allclose(pose[:3, 3], [1, 2, 3.1], atol=1e-9)
        return [0, 0, 15, 0, 0, 0]

    def thread(t: float, pose: np.ndarray, twist: np.ndarray) -> list[float]:
        return [0, 0, 5, 0, 0, 0.1]

    motion = ball.simulate([0.0], base=base, wrench_at={"knot": rope}, tool_wrench=thread, samples=3)
    assert motion.base is not None
    np.testing.assert_allclose(motion.base[-1], base, atol=1e-9)
    # The thread turns the wheel by 0.1 N m / 0.1 kg m^2.
    assert motion.q[-1, 0] == pytest.approx(0.5, abs=1e-9)
    with pytest.raises(ValueError, match="`held_tool_wrench` is of a robot whose base stands"):
        ball.simulate([0.0], held_tool_wrench=thread, control_period=0.1)


def test_series_are_of_compiled_robots(pendulum: rd.Robot) -> None:
    with pytest.raises(ValueError, match="`TaylorSimulation` in Rust: .* \"dop853\" with `tolerance=1e-12`"):
        pendulum.simulate([1.0], method="taylor")
    with pytest.raises(AttributeError, match="`taylor_series` is a function of compiled robots"):
        rd.Robot.from_toml(PENDULUM, functions=["default", "taylor_series"]).taylor_series


def test_a_motion_is_shown_in_one_line(cart: rd.Robot) -> None:
    motion = cart.simulate([0.0], duration=0.5, samples=6)
    assert repr(motion) == "<Trajectory: 6 samples from 0 s to 0.5 s, rail>"


def test_a_motion_is_plotted(pendulum: rd.Robot) -> None:
    matplotlib = pytest.importorskip("matplotlib")
    matplotlib.use("Agg")
    figure = pendulum.simulate([1.0]).plot()
    assert [axis.get_ylabel() for axis in figure.axes] == ["q in rad", "qd in rad/s", "tau in N m"]
    assert [axis.get_title() for axis in figure.axes] == ["Positions", "Velocities", "Torques and forces"]
    np.testing.assert_allclose(figure.axes[0].lines[0].get_xdata(), np.linspace(0, 1, 101))


def test_a_plot_has_the_units_of_slides(cart: rd.Robot) -> None:
    matplotlib = pytest.importorskip("matplotlib")
    matplotlib.use("Agg")
    motion = cart.simulate([0.0], duration=0.1, samples=3)
    assert [axis.get_ylabel() for axis in motion.plot().axes] == ["q in m", "qd in m/s", "tau in N"]
    motion.joint_units = ["rad", "m", "rad"]
    labels = [axis.get_ylabel() for axis in motion.plot().axes]
    assert labels == ["q in rad or m", "qd in rad/s or m/s", "tau in N m or N"]
