"""Robots of files, of texts and of keywords, and the mistakes in them."""

import contextlib
import copy
import errno
import pickle
import re
from pathlib import Path

import numpy as np
import pytest

import robot_dynamics as rd
from conftest import DATA, GRAVITY, panda
from robot_dynamics._native import Arm
from robot_dynamics._robot import KEYWORDS

FILES = DATA / "files"

TWO_LINK = {
    "convention": "standard",
    "joint": [
        {"name": "shoulder", "type": "revolute", "a": 0.3, "mass": 1.2, "com": [-0.1, 0, 0]},
        {"name": "elbow", "type": "revolute", "a": 0.25, "mass": "load", "com": (-0.1, 0, 0)},
    ],
}


def test_keywords_are_a_table() -> None:
    arm = rd.Robot.from_table(**TWO_LINK, gravity=(0, -9.81, 0), fields={"load": 0.7})
    text = """
        convention = "standard"
        gravity = [0, -9.81, 0]
        [[joint]]
        name = "shoulder"
        type = "revolute"
        a = 0.3
        mass = 1.2
        com = [-0.1, 0, 0]
        [[joint]]
        name = "elbow"
        type = "revolute"
        a = 0.25
        mass = 0.7
        com = [-0.1, 0, 0]
    """
    same = rd.Robot.from_toml(text)
    q = np.array([0.3, -1.1])
    np.testing.assert_allclose(arm.mass_matrix(q), same.mass_matrix(q), rtol=1e-15)
    assert arm.joint_names == ["shoulder", "elbow"] and arm.dof == 2
    assert arm.fields == {"load": 0.7} and same.fields == {}


def test_a_float_is_its_shortest_decimal() -> None:
    """0.1 + 0.2 is the double 0.30000000000000004, and 0.3 the decimal: the program has the nearest double of each."""
    row = {"name": "pivot", "type": "revolute", "com": [1, 0, 0]}
    for mass in (0.3, 0.1 + 0.2, 1e-7, 12, np.float64(0.7), np.int32(3)):
        arm = rd.Robot.from_table(
            convention="modified", joint=[{**row, "mass": mass}], gravity=[0, 0, 0]
        )
        assert arm.mass_matrix(np.zeros(1))[0, 0] == float(mass)
    with pytest.raises(ValueError, match="finite"):
        rd.Robot.from_table(convention="modified", joint=[{**row, "mass": float("nan")}])


def test_names_that_nothing_binds_are_fields() -> None:
    arm = rd.Robot.from_file(FILES / "two_link.toml")
    assert set(arm.fields) == {"m1", "m2", "l1", "l2", "g"}
    with pytest.raises(rd.TableError, match="l1"):
        rd.Robot.from_file(FILES / "two_link.toml", fields=["m1", "m2", "l2", "g"])


def test_names_beside_a_urdf_file_are_fields() -> None:
    path, entries = DATA / "urdf" / "panda.urdf", {"gravity": (0, 0, "-g"), "ignore": "rest"}
    arm = rd.Robot.from_file(
        path, chain=("panda_link0", "panda_link8"), tool={"mass": "load"}, functions=["gravity_vector"], **entries
    )
    assert set(arm.fields) == {"g", "load"}
    q = np.full(7, 0.3)
    empty, loaded = (arm.with_fields(g=9.81, load=load).gravity_vector(q) for load in (0.0, 2.0))
    assert np.abs(loaded - empty).max() > 1


def test_fields_take_no_new_derivation() -> None:
    arm = rd.Robot.from_file(FILES / "two_link.toml", fields=["m1", "m2", "l1", "l2", "g"])
    with pytest.raises(ValueError, match="field `m1` has no value: `with_fields\\(m1=..\\)`"):
        arm.with_fields(m2=1, l1=1, l2=1, g=9.81).mass_matrix(np.zeros(2))
    arm = arm.with_fields(m1=1, m2=1, l1=1, l2=1, g=9.81)
    heavy = arm.with_fields(m2=2.0)
    assert heavy.fields == {"m1": 1, "m2": 2, "l1": 1, "l2": 1, "g": 9.81}
    light, difference = arm.mass_matrix(np.zeros(2)), heavy.mass_matrix(np.zeros(2))
    assert difference[1, 1] == 2 * light[1, 1]
    with pytest.raises(ValueError, match="no field `m3`: expected one of m1, m2, l1, l2, g"):
        arm.with_fields(m3=1)


def test_entries_beside_a_file() -> None:
    arm = panda()
    assert arm.dof == 7
    locked = rd.Robot.from_file(
        DATA / "urdf" / "panda.urdf",
        chain=["panda_link0", "panda_hand_tcp"],
        gravity=np.array([0, 0, -9.81]),
        lock={"panda_joint7": 0.3},
        ignore="rest",
        tool={"mass": 0.5, "com": [0, 0, 0.1]},
    )
    assert locked.dof == 6 and locked.joint_names[-1] == "panda_joint6"
    assert arm.joint_limits.shape == (7, 2) and (arm.joint_limits[:, 0] < 0).any()


def test_every_entry_of_a_table_is_a_keyword() -> None:
    rows = [
        {"name": "lift", "type": "prismatic", "mass": 3, "spring": {"stiffness": 200, "rest": 0.1}},
        {"name": "turn", "type": "revolute", "a": "l", "mass": 1, "com": [0.1, 0, 0]},
        {"name": "finger_1", "type": "prismatic", "mass": 0.1, "alpha": "PI/2"},
        {"name": "finger_2", "type": "prismatic", "mass": 0.1},
    ]
    arm = rd.Robot.from_table(
        convention="modified",
        joint=rows,
        gravity=[0, 0, -9.81],
        base={"xyz": [0, 0, 0.8], "rpy": [0, "deg(30)", 0]},
        couple={"finger_2": "-finger_1 + 0.02"},
        lock={"lift": 0.2},
        frames={"camera": {"on": "turn", "xyz": [0.1, 0, 0]}},
        tool={"xyz": [0, 0, 0.1], "mass": "load", "com": [0, 0, 0.05], "inertia": "sphere(0.04)"},
        let={"l": 0.3},
        functions=["default", "spring_vector", "forward_kinematics(camera)"],
        fields=["load"],
    ).with_fields(load=0.4)
    assert arm.joint_names == ["turn", "finger_1"]
    pose = arm.forward_kinematics_camera(np.zeros(2))
    np.testing.assert_allclose(pose[3], [0, 0, 0, 1])
    # The base is turned about y by 30 degrees, and 0.8 m high: the camera is 0.4 m out and 0.2 m up in its axes.
    c, s = np.cos(np.pi / 6), np.sin(np.pi / 6)
    np.testing.assert_allclose(pose[:3, 3], [0.4 * c + 0.2 * s, 0, 0.8 - 0.4 * s + 0.2 * c])
    assert (arm.spring_vector(np.zeros(2)) == 0).all()


def test_functions_of_frames_and_of_several() -> None:
    arm = rd.Robot.from_file(
        FILES / "torso.toml",
        functions=["jacobian(left_hand)", {"both": ["mass_matrix", "kinetic_energy"]}],
        fields={"load": 0.3},
    )
    assert arm.functions == ["jacobian_left_hand", "both"]
    q = np.full((2, 5, arm.dof), 0.2)
    assert arm.jacobian_left_hand(q).shape == (2, 5, 6, arm.dof)
    M, T = arm.both(q, q)
    assert M.shape == (2, 5, 6, 6) and T.shape == (2, 5)
    M, T = arm.both(q[0, 0], q[0, 0])
    assert M.shape == (6, 6) and T == pytest.approx(q[0, 0] @ M @ q[0, 0] / 2)
    with pytest.raises(AttributeError, match=r'functions=\["default", "gravity_vector"\]'):
        arm.gravity_vector(q)
    with pytest.raises(AttributeError, match="`jacobian_lef_hand`: did you mean `jacobian_left_hand`"):
        arm.jacobian_lef_hand(q)
    with pytest.raises(ValueError, match="expected one of jacobian_left_hand, both"):
        arm.operations("gravity_vector")


def test_all_mistakes_are_in_one_error() -> None:
    text = 'convention = "modified"\ngravity = [0, 0]\n[[joint]]\nname = "a"\ntype = "revolut"\n'
    with pytest.raises(rd.TableError) as raised:
        rd.Robot.from_toml(text)
    error = raised.value
    assert [(mistake.line, mistake.column) for mistake in error.mistakes] == [(2, 11), (5, 8)]
    assert (error.file, error.line, error.column) == ("TOML", 2, 11)
    assert str(error).splitlines()[1].startswith("TOML:5:8: ")
    assert "revolute" in error.mistakes[1].text
    same = pickle.loads(pickle.dumps(error))
    assert same.mistakes == error.mistakes and str(same) == str(error)


def test_mistakes_of_files_and_of_entries(tmp_path: Path) -> None:
    path = tmp_path / "arm.toml"
    path.write_text('convention = "modified"\n')
    with pytest.raises(rd.TableError) as raised:
        rd.Robot.from_file(path, gravity=[0, 0, -9.81])
    assert raised.value.file == str(path)
    with pytest.raises(rd.TableError) as raised:
        panda(allow=["nothing"])
    assert raised.value.file is None and "nothing" in str(raised.value)
    (tmp_path / "arm.txt").write_text("")
    with pytest.raises(rd.TableError, match="format"):
        rd.Robot.from_file(tmp_path / "arm.txt")


def test_files_that_cannot_be_read(tmp_path: Path) -> None:
    with pytest.raises(FileNotFoundError) as raised:
        rd.Robot.from_file(tmp_path / "none.urdf")
    assert raised.value.filename == str(tmp_path / "none.urdf") and raised.value.errno == errno.ENOENT
    (tmp_path / "letters").write_text("")
    with pytest.raises(NotADirectoryError):
        rd.Robot.from_file(tmp_path / "letters" / "arm.urdf")
    # The system has no number for what a robot alone asks of its files.
    with pytest.raises(OSError, match="it is a folder, expected a file") as raised:
        rd.Robot.from_file(tmp_path)
    assert str(tmp_path) in str(raised.value)


def test_keywords_that_are_not_known() -> None:
    for keyword, message in [
        ("gravty", "unknown keyword `gravty`: did you mean `gravity`?"),
        ("frame", "unknown keyword `frame`: did you mean `frames`?"),
        ("speed", "unknown keyword `speed`: expected one of convention, gravity, base, .*, round_angles, fields$"),
    ]:
        for robot in (
            lambda **entries: rd.Robot.from_table(**TWO_LINK, **entries),
            lambda **entries: rd.Robot.from_toml("", **entries),
            panda,
        ):
            with pytest.raises(TypeError, match=message.replace("?", "\\?")):
                robot(**{keyword: 1})


def test_keywords_are_the_keys_of_files() -> None:
    """A file has a `frame` for each of them, and `tests`, which are written in Rust alone."""
    with pytest.raises(rd.TableError) as raised:
        Arm(DATA / "urdf" / "panda.urdf", (DATA / "urdf" / "panda.urdf").read_text(), "zzzzzz = 1")
    (message,) = [one.text for one in raised.value.mistakes if "zzzzzz" in one.text]
    keys = set(re.findall(r"\w+", message.partition("expected ")[2])) - {"or", "one", "of"}
    beside = {"frames", "joints", "links", "functions", "chain", "ignore", "round_angles", "fields"}
    assert set(KEYWORDS) == keys - {"frame", "tests"} | beside


def test_robots_are_copied_and_pickled() -> None:
    arm = rd.Robot.from_file(
        FILES / "two_link.toml", fields={"m1": 1, "m2": 2, "l1": 0.5, "l2": 0.4, "g": 9.81}
    )
    heavy = arm.with_fields(m2=3)
    q = np.array([0.3, -1.1])
    for robot in (arm, heavy):
        for same in (pickle.loads(pickle.dumps(robot)), copy.copy(robot), copy.deepcopy(robot)):
            assert same.fields == robot.fields
            np.testing.assert_array_equal(same.mass_matrix(q), robot.mass_matrix(q))


def test_a_base_that_moves() -> None:
    arm = rd.Robot.from_table(
        convention="modified",
        gravity=[0, 0, -9.81],
        base={"floating": True, "mass": 3, "inertia": {"xx": 0.1, "yy": 0.2, "zz": 0.25}},
        joint=[{"name": "elbow", "type": "revolute", "mass": 1, "com": [0.2, 0, 0]}],
    )
    assert arm.dof == 7 and arm.joint_names == ["elbow"]
    assert arm.inverse_dynamics.arguments == ["base", "q", "v", "a"]
    assert repr(arm.mass_matrix) == "<function mass_matrix(q) of TOML>"
    pose = np.eye(4)
    pose[:3, 3] = [1, 2, 3]
    q, v, a = np.zeros(1), np.zeros(7), np.zeros(7)
    tau = arm.inverse_dynamics(pose, q, v, a)
    np.testing.assert_allclose(tau[:3], [0, 0, 4 * 9.81])
    many = arm.inverse_dynamics(np.stack([pose] * 4), q, np.zeros((5, 1, 7)), a=a)
    assert many.shape == (5, 4, 7)
    np.testing.assert_allclose(many, np.broadcast_to(tau, (5, 4, 7)), atol=1e-14)
    assert arm.mass_matrix(np.zeros((3, 1))).shape == (3, 7, 7)
    # Upside down gravity has the other sign in the axes of the base.
    pose[:3, :3] = np.diag([1, -1, -1])
    np.testing.assert_allclose(arm.inverse_dynamics(pose, q, v, a)[:3], [0, 0, -4 * 9.81])
    with pytest.raises(ValueError, match=r"`base` has the shape \(3, 4\): expected \(\.\.\., 4, 4\)"):
        arm.gravity_vector(pose[:3], q)


def test_words_that_are_no_functions_are_not_advised_as_such() -> None:
    arm = rd.Robot.from_file(DATA / "urdf/ur5_robot.urdf", gravity=GRAVITY)
    for word, told in [
        ("effort_limits", "a robot has no `effort_limits`: there are .*`?joint_limits"),
        ("mass_matrx", "did you mean `mass_matrix`"),
        ("Mass_Matrix", "did you mean `mass_matrix`"),
        ("regressor", 'functions=\\["default", "regressor"\\]'),
        ("jacobian_FL_foot", 'functions=\\["default", "jacobian\\(FL_foot\\)"\\]; .* small'),
    ]:
        with pytest.raises(AttributeError, match=told):
            getattr(arm, word)


def test_positions_in_degrees_are_told() -> None:
    arm = rd.Robot.from_file(DATA / "urdf/ur5_robot.urdf", gravity=GRAVITY)
    degrees = [0, -90, 90, 0, 45, 0]
    told = "-90 rad of `shoulder_lift_joint` are 14.3 turns: angles are in radians, and -90 degrees are -1.5708"
    for call in [
        lambda: arm.gravity_vector(degrees),
        lambda: arm.gravity_vector(np.array(degrees)),
        lambda: arm.simulate(degrees, duration=1e-3, samples=2),
        lambda: arm.reach(np.eye(4) + 0.3, start=degrees),
    ]:
        with pytest.warns(UserWarning, match=told) as caught:
            with contextlib.suppress(ValueError):
                call()
        assert {one.filename for one in caught} == {__file__}


def test_limits_of_torques_and_velocities() -> None:
    arm = panda()
    np.testing.assert_array_equal(arm.torque_limits, [87] * 4 + [12] * 3)
    assert arm.velocity_limits.shape == (7,) and (arm.velocity_limits > 2).all()
    bare = rd.Robot.from_table(**TWO_LINK, gravity=(0, -9.81, 0), fields={"load": 0.7})
    assert np.isinf(bare.torque_limits).all() and np.isinf(bare.velocity_limits).all()


def test_links_of_a_file_have_cells(tmp_path: Path) -> None:
    """The hand of a Panda with a load: the robot of a file that has the numbers itself."""
    text = (DATA / "urdf" / "panda.urdf").read_text()
    begin, end = text.index('<link name="panda_hand">'), text.index('<link name="panda_hand_tcp">')
    hand = re.sub(r'<mass value="[^"]*"', '<mass value="2.5"', text[begin:end])
    hand = re.sub(r'(<inertial>.*?<origin[^>]*?xyz=)"[^"]*"', r'\1"0 0 0.125"', hand, flags=re.DOTALL)
    (tmp_path / "loaded.urdf").write_text(text[:begin] + hand + text[end:])
    chain = {"chain": ("panda_link0", "panda_hand_tcp"), "gravity": GRAVITY, "lock": {"rest": 0}}
    expected = rd.Robot.from_file(tmp_path / "loaded.urdf", **chain)
    path = DATA / "urdf" / "panda.urdf"
    links = {"panda_hand": {"mass": "load", "com": [0, 0, "z"]}}
    arm = rd.Robot.from_file(path, links=links, **chain)
    assert list(arm.fields) == ["load", "z"]
    q, qd = np.linspace(0.1, 0.7, 7), np.linspace(-0.5, 0.9, 7)
    given = arm.with_fields(load=2.5, z=0.125)
    np.testing.assert_allclose(given.mass_matrix(q), expected.mass_matrix(q), rtol=1e-12, atol=1e-14)
    tau = expected.inverse_dynamics(q, qd, qd)
    np.testing.assert_allclose(given.inverse_dynamics(q, qd, qd), tau, rtol=1e-12, atol=1e-12)
    # By state, as any field.
    loads = np.array([2.5, 0.0, 4.0])
    found = arm.inverse_dynamics(q, qd, qd, load=loads, z=0.125)
    np.testing.assert_allclose(found[0], tau, rtol=1e-12, atol=1e-12)
    with pytest.raises(rd.TableError, match="did you mean `panda_hand`"):
        panda(links={"panda_hnd": {"mass": 1}})
