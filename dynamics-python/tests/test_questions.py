"""Formulas, operations, source code and checks."""

import html
from importlib import metadata

import numpy as np
import pytest

import robot_dynamics as rd
from conftest import DATA, panda

FIELDS = {"m1": 1.0, "m2": 2.0, "l1": 0.5, "l2": 0.4, "g": 9.81}


@pytest.fixture(scope="module")
def two_link() -> rd.Robot:
    return rd.Robot.from_file(DATA / "files" / "two_link.toml", fields=FIELDS)


def test_operations_are_counted(arm: rd.Robot) -> None:
    operations = arm.operations("inverse_dynamics")
    assert operations.total == operations.multiplications + operations.additions
    assert 400 < operations.total < 700 and operations.sin_cos == 6
    assert arm.operations("forward_dynamics").divisions > 0


def test_formulas(two_link: rd.Robot) -> None:
    formulas = two_link.formulas("gravity_vector")
    assert len(formulas.equations) == 2 and "m2" in formulas and "cos" in formulas
    assert "\\tfrac{1}{2} \\, m_{1}" in two_link.formulas("gravity_vector", format="latex")
    assert "<math" in two_link.formulas("gravity_vector", format="mathml")
    with pytest.raises(ValueError, match="expected \"text\", \"latex\" or \"mathml\""):
        two_link.formulas("gravity_vector", format="html")
    with pytest.raises(ValueError, match="more than 1 terms"):
        two_link.formulas("mass_matrix", terms=1)
    with pytest.raises(ValueError, match="has no formulas"):
        two_link.formulas("forward_dynamics")


def test_source_in_other_languages(two_link: rd.Robot) -> None:
    header, source = two_link.source("c", functions=["mass_matrix"]).items()
    assert header[0].endswith(".h") and source[0].endswith(".c") and "mass_matrix" in source[1]
    project = two_link.source("c", functions=["mass_matrix"], scalar="float", sines="libm", project=True)
    assert len(project) == 5 and "CMakeLists.txt" in project
    assert any("cosf" in text and "double" not in text for text in project.values())
    with pytest.raises(ValueError, match="`scalar` is \"half\": expected \"double\" or \"float\""):
        two_link.source("c", scalar="half")
    with pytest.raises(ValueError, match="are about `lang=\"c\"`"):
        two_link.source("js", project=True)
    (module,) = two_link.source("js").values()
    assert "export function inverse_dynamics" in module
    assert "mass_matrix.m" in two_link.source("matlab", functions=["mass_matrix"])
    (expansion,) = two_link.source("rust", functions=["gravity_vector"]).values()
    assert "pub struct TwoLink {" in expansion and "pub m1:" in expansion
    assert "pub fn gravity_vector" in expansion
    ((name, text),) = two_link.source("casadi", functions=["inverse_dynamics"]).items()
    assert name == "two_link_casadi.c" and "int jac_jac_inverse_dynamics(" in text
    with pytest.raises(ValueError, match="`lang` is \"fortran\""):
        two_link.source("fortran")


def test_a_function_for_other_namespaces(arm: rd.Robot, two_link: rd.Robot) -> None:
    function = arm.function("inverse_dynamics")
    q, qd, qdd = np.random.default_rng(0).uniform(-1, 1, (3, 5, 7))
    np.testing.assert_allclose(function(q, qd, qdd, xp=np), arm.inverse_dynamics(q, qd, qdd), atol=1e-12)

    class Fields:
        m1, m2, l1, l2, g = FIELDS.values()

    M = two_link.function("mass_matrix")(Fields, np.zeros(2))
    np.testing.assert_allclose(M, two_link.mass_matrix(np.zeros(2)), atol=1e-14)


def test_a_notebook_shows_the_page(arm: rd.Robot, two_link: rd.Robot) -> None:
    page = two_link.page()
    assert page.startswith("<!DOCTYPE html>") and "robotEquations" in page and "shoulder" in page
    shown = two_link._repr_html_()
    assert html.unescape(shown).count(page) == 1
    without_values = rd.Robot.from_file(DATA / "files" / "two_link.toml", fields=list(FIELDS))
    shown = html.unescape(without_values.with_fields(m1=1, g=9.81)._repr_html_())
    assert "<Robot" in shown and "fields `m2`, `l1`, `l2` have no values: `with_fields(m2=.., l1=.., l2=..)`" in shown


def test_the_page_of_a_robot_whose_base_moves() -> None:
    robot = rd.Robot.from_toml(
        """
        convention = "modified"
        gravity = [0, 0, -9.81]
        [[joint]]
        name = "wheel"
        type = "revolute"
        mass = 1
        com = [0.1, 0, 0]
        """,
        base={"floating": True, "mass": 2, "inertia": {"xx": 0.1, "yy": 0.2, "zz": 0.25}},
    )
    page = robot.page()
    assert page.startswith("<!DOCTYPE html>") and "wheel" in page
    assert "forward_dynamics(base, q, qd, tau)" in page


def test_functions_are_checked(arm: rd.Robot) -> None:
    report = arm.check(samples=50)
    assert report and report.ok
    names = [function.function for function in report.functions]
    assert {"mass_matrix", "inverse_dynamics", "forward_dynamics"} <= set(names)
    assert all(function.error <= function.tolerance for function in report.functions)
    assert "inverse_dynamics" in str(report)


def test_identified_robots() -> None:
    arm = panda(functions=["default", "regressor", "base_parameters"])
    q, qd, qdd = np.random.default_rng(0).uniform(-1, 1, (3, 40, 7))
    b = arm.base_parameters()
    changed = b * 1.01
    nearest, distance = arm.nearest_possible(changed)
    identified = arm.identified(nearest)
    np.testing.assert_allclose(identified.base_parameters(), nearest, atol=1e-9)
    expected = arm.regressor(q, qd, qdd) @ nearest + arm.friction_vector(qd)
    np.testing.assert_allclose(identified.inverse_dynamics(q, qd, qdd), expected, atol=1e-8)
    assert distance >= 0
    import pickle

    same = pickle.loads(pickle.dumps(identified))
    np.testing.assert_array_equal(same.mass_matrix(q), identified.mass_matrix(q))
    free = arm.identified(nearest, friction=np.zeros((7, 3)))
    assert not free.friction_vector(qd).any()
    with pytest.raises(ValueError, match="base_parameters"):
        arm.identified(b[:-1])


def test_base_parameters_have_names_and_formulas() -> None:
    arm = panda(functions=["regressor", "base_parameters"])
    names = arm.base_parameter_names
    assert len(names) == len(arm.base_parameters()) and names[0].startswith("J1")
    formulas = arm.base_parameter_formulas
    assert len(formulas.equations) == len(names)
    for name, formula in zip(names, formulas.equations):
        assert name in formula
    assert "first moments mass * com" in formulas.legend[-1]
    # Two rods in a plane: what the torques show of them.
    rod = {"type": "revolute", "a": 1, "mass": 1, "com": [-0.5, 0, 0], "inertia": "rod(1)"}
    joint = [{**rod, "name": "shoulder"}, {**rod, "name": "elbow"}]
    rods = rd.Robot.from_table(convention="standard", gravity=[0, -9.81, 0], joint=joint, functions=["base_parameters"])
    assert rods.base_parameter_names == ["J1zz", "h1x", "h1y", "J2zz", "h2x", "h2y"]
    assert "m2" in rods.base_parameter_formulas.equations[0] and "a1" in rods.base_parameter_formulas.equations[0]


def test_a_version() -> None:
    assert rd.__version__ == metadata.version("robot-dynamics")
