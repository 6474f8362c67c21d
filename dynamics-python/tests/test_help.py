"""The documentation of functions: their arguments, shapes and units, as `help` and editors show them."""

import ast
import inspect
import pydoc
from pathlib import Path

import numpy as np

import robot_dynamics as rd
from conftest import panda


def test_functions_say_their_arguments(arm: rd.Robot) -> None:
    assert (arm.inverse_dynamics.__doc__ or "").splitlines()[:9] == [
        'inverse_dynamics(q, qd, qdd, *, out=None, threads=None, on_singular="raise")',
        "",
        "Inverse dynamics tau = M(q) qdd + V(q, qd) + G(q) + K(q) + F(qd), N m or N, as one program; K is of springs, "
        "F of friction.",
        "",
        "q: (..., 7) joint positions, rad",
        "qd: (..., 7) joint velocities, rad per s",
        "qdd: (..., 7) joint accelerations, rad per s^2",
        "",
        "Returns (..., 7).",
    ]
    assert "Returns (..., 7, 7)." in (arm.mass_matrix.__doc__ or "")
    assert "Returns (...)." in (arm.kinetic_energy.__doc__ or "")
    for word in ("out: ", "threads: ", "on_singular: "):
        assert word in pydoc.render_doc(arm.forward_dynamics)


def test_nothing_is_derived_for_help() -> None:
    """The answer of a robot of thirty joints would take a minute."""
    rows = [
        {"name": f"joint_{k}", "type": "revolute", "a": 0.1, "alpha": "PI/2", "mass": 1, "com": [0.1, 0.2, 0]}
        for k in range(30)
    ]
    arm = rd.Robot.from_table(convention="modified", joint=rows, gravity=[0, 0, 0], functions=["regressor", "coriolis_matrix"])
    assert "Returns (..., 30, P)." in (arm.regressor.__doc__ or "")
    assert "Returns (..., 30, 30)." in (arm.coriolis_matrix.__doc__ or "")


def test_tuples_and_moving_bases_say_theirs() -> None:
    arm = rd.Robot.from_table(
        convention="modified",
        gravity=[0, 0, -9.81],
        base={"floating": True, "mass": 3, "inertia": {"xx": 0.1, "yy": 0.2, "zz": 0.25}},
        joint=[{"name": "elbow", "type": "revolute", "mass": 1, "com": [0.2, 0, 0]}],
        functions=[{"both": ["inverse_dynamics", "mass_matrix"]}],
    )
    text = arm.both.__doc__ or ""
    assert text.startswith("both(base, q, v, a, *, ")
    assert "base: (..., 4, 4) where the base stands" in text and "a: (..., 7) accelerations" in text
    assert "Returns a tuple: (..., 7), (..., 7, 7)." in text


def test_signatures(arm: rd.Robot) -> None:
    signature = inspect.signature(arm.forward_dynamics)
    assert str(signature) == "(q, qd, tau, *, out=None, threads=None, on_singular='raise')"
    q = np.zeros(7)
    bound = signature.bind(q, q, q, on_singular="nan")
    assert arm.forward_dynamics(*bound.args, **bound.kwargs).shape == (7,)


def texts_of_attributes() -> dict[str, str]:
    """The texts behind the attributes of a robot, which editors know by the source alone."""
    source = Path(inspect.getsourcefile(rd.Robot) or "").read_text()
    (robot,) = [node for node in ast.parse(source).body if isinstance(node, ast.ClassDef) and node.name == "Robot"]
    found = {}
    for node, after in zip(robot.body, robot.body[1:]):
        if isinstance(node, ast.AnnAssign) and isinstance(node.target, ast.Name):
            assert isinstance(after, ast.Expr) and isinstance(after.value, ast.Constant), node.target.id
            found[node.target.id] = " ".join(str(after.value.value).split())
    return found


def test_attributes_of_robots_say_the_same() -> None:
    found = texts_of_attributes()
    assert set(panda().functions) <= set(found)
    arm = panda(functions=list(found))
    for name, text in found.items():
        lines = (getattr(arm, name).__doc__ or "").splitlines()
        call = lines[0].partition(", *")[0]
        assert text == f"`{call})`: {lines[2]}".replace("last link frame", "tip")


def test_the_stub_has_the_settings() -> None:
    stub = Path(inspect.getsourcefile(rd) or "").with_name("_native.pyi").read_text()
    (function,) = [node for node in ast.parse(stub).body if isinstance(node, ast.ClassDef) and node.name == "Function"]
    text = ast.get_docstring(function) or ""
    settings = (panda().gravity_vector.__doc__ or "").partition("\n\nout: ")[2]
    assert settings and text.endswith("out: " + settings)
