"""Functions for `casadi.external` beside the derivatives that CasADi finds itself, where it and gcc are installed."""

import shutil
import subprocess
from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import robot_dynamics as rd
from conftest import DATA, panda
from test_documents import ROOT, programs

ca = pytest.importorskip("casadi")
pytestmark = pytest.mark.skipif(shutil.which("gcc") is None, reason="gcc is not installed")

FUNCTIONS = ["inverse_dynamics", "forward_dynamics", "mass_matrix", "gravity_vector"]
ARGUMENTS = {"inverse_dynamics": ["q", "qd", "qdd"], "forward_dynamics": ["q", "qd", "tau"]}
RESULTS = {"inverse_dynamics": "tau", "forward_dynamics": "qdd"}

External = Callable[..., Any]


def compiled(robot: rd.Robot, functions: list[str], folder: Path) -> Path:
    """The library of a robot's functions."""
    ((name, text),) = robot.source("casadi", functions).items()
    (folder / name).write_text(text)
    subprocess.run(["gcc", "-O1", "-shared", "-fPIC", name, "-o", "robot.so"], cwd=folder, check=True)
    return folder / "robot.so"


@pytest.fixture(scope="module")
def external(arm: rd.Robot, tmp_path_factory: pytest.TempPathFactory) -> External:
    library = compiled(arm, FUNCTIONS, tmp_path_factory.mktemp("casadi"))
    return lambda name, **options: ca.external(name, str(library), options)


def graph(arm: rd.Robot, name: str) -> Any:
    """The same function as an SX graph."""
    symbols = [ca.SX.sym(argument, arm.dof) for argument in ARGUMENTS[name]]
    value = arm.function(name)(*symbols, xp=ca)
    return ca.Function(name, symbols, [value], ARGUMENTS[name], [RESULTS[name]])


def states(arm: rd.Robot) -> Any:
    return np.random.default_rng(3).uniform(-2, 2, (20, 3, arm.dof))


def assert_near(found: Any, expected: Any, bound: float) -> None:
    found, expected = ca.DM(found).full(), ca.DM(expected).full()
    assert np.abs(found - expected).max() <= bound * max(1.0, np.abs(expected).max())


def test_values_and_names(arm: rd.Robot, external: External) -> None:
    tau = external("inverse_dynamics")
    assert [tau.name_in(i) for i in range(3)] == ["q", "qd", "qdd"] and tau.name_out(0) == "tau"
    for q, qd, qdd in states(arm):
        assert_near(tau(q, qd, qdd), arm.inverse_dynamics(q, qd, qdd), 1e-15)
        assert_near(external("mass_matrix")(q), arm.mass_matrix(q), 1e-15)
        assert_near(external("forward_dynamics")(q, qd, qdd), arm.forward_dynamics(q, qd, qdd), 1e-13)


def test_zeros_are_declared(arm: rd.Robot, external: External) -> None:
    # Gravity is along the first axis.
    assert external("gravity_vector").nnz_out(0) == arm.dof - 1
    assert external("inverse_dynamics").jacobian().nnz_out("jac_tau_q") == arm.dof * (arm.dof - 1)


@pytest.mark.parametrize(("name", "bound"), [("inverse_dynamics", 1e-14), ("forward_dynamics", 1e-12)])
def test_first_derivatives(arm: rd.Robot, external: External, name: str, bound: float) -> None:
    found, expected = external(name).jacobian(), graph(arm, name).jacobian()
    for state in states(arm):
        for block, other in zip(found(*state, 0), expected(*state, 0), strict=True):
            assert_near(block, other, bound)


def test_second_derivatives(arm: rd.Robot, external: External) -> None:
    tau = external("inverse_dynamics"), graph(arm, "inverse_dynamics")
    found, expected = (function.jacobian().jacobian() for function in tau)
    for names in ("name_in", "name_out"):
        assert getattr(found, names)() == getattr(expected, names)()
    places = [0] * (found.n_in() - 3)
    for state in states(arm):
        for block, other in zip(found(*state, *places), expected(*state, *places), strict=True):
            assert_near(block, other, 1e-13)


@pytest.mark.parametrize(("name", "bound"), [("inverse_dynamics", 1e-13), ("forward_dynamics", 1e-11)])
def test_reverse_mode(arm: rd.Robot, external: External, name: str, bound: float) -> None:
    """Gradients and Hessians are of one file, not of CasADi's products of matrices."""
    found, expected = (function(name).reverse(1) for function in (external, lambda name: graph(arm, name)))
    for functions in (found, expected), (found.jacobian(), expected.jacobian()):
        assert functions[0].name() == functions[1].name() and functions[0].is_a("External")
        for names in ("name_in", "name_out"):
            assert getattr(functions[0], names)() == getattr(functions[1], names)()
        places = [0] * (functions[0].n_in() - 5)
        for weights, state in zip(np.random.default_rng(5).uniform(-1, 1, (20, arm.dof)), states(arm)):
            given = (*state, 0, weights, *places)
            for block, other in zip(functions[0](*given), functions[1](*given), strict=True):
                assert_near(block, other, bound)


def test_an_option_keeps_whole_jacobians(arm: rd.Robot, external: External) -> None:
    """As the chapter says: with it Jacobians are no rows of the reverse mode, and gradients are of it."""
    tau = external("inverse_dynamics", jac_penalty=1.5 / arm.dof)
    x = ca.MX.sym("x", 3 * arm.dof)
    value = tau(*ca.vertsplit(x, arm.dof))
    for derivative, reverses in (ca.jacobian(value, x), 0), (ca.gradient(ca.sum1(value), x), 1):
        steps = ca.Function("derivative", [x], [derivative]).str(True)
        assert steps.count("adj1_inverse_dynamics") == reverses and steps.count("jac_inverse_dynamics") == 1 - reverses


def hessian(function: Any, dof: int) -> Any:
    """That of the outputs with given weights, by all inputs together."""
    x, weights = ca.MX.sym("x", 3 * dof), ca.MX.sym("weights", dof)
    weighted = ca.dot(weights, function(*ca.vertsplit(x, dof)))
    return ca.Function("hessian", [x, weights], [ca.hessian(weighted, x)[0]])


@pytest.mark.parametrize(("name", "bound"), [("inverse_dynamics", 1e-13), ("forward_dynamics", 1e-11)])
def test_hessian(arm: rd.Robot, external: External, name: str, bound: float) -> None:
    found, expected = (hessian(function, arm.dof) for function in (external(name), graph(arm, name)))
    weights = np.linspace(-1, 1, arm.dof)
    for state in states(arm):
        assert_near(found(state.ravel(), weights), expected(state.ravel(), weights), bound)


def test_bias_force_has_no_second_derivatives(tmp_path: Path) -> None:
    arm = panda(functions=["bias_force"])
    bias = ca.external("bias_force", str(compiled(arm, ["bias_force"], tmp_path)))
    q, qd = ca.MX.sym("q", arm.dof), ca.MX.sym("qd", arm.dof)
    with pytest.raises(RuntimeError, match="[Dd]erivatives cannot be calculated"):
        ca.hessian(ca.sumsqr(bias(q, qd)), q)


def test_fields_are_an_input(tmp_path: Path) -> None:
    fields = {"m1": 1.0, "m2": 2.0, "l1": 0.5, "l2": 0.4, "g": 9.81}
    arm = rd.Robot.from_file(DATA / "files" / "two_link.toml", fields=fields)
    tau = ca.external("inverse_dynamics", str(compiled(arm, ["inverse_dynamics"], tmp_path)))
    assert tau.name_in(0) == "arm" and tau.size1_in(0) == 5
    values = [fields[name] for name in arm.fields]
    q, qd, qdd = np.random.default_rng(1).uniform(-1, 1, (3, 2))
    assert_near(tau(values, q, qd, qdd), arm.inverse_dynamics(q, qd, qdd), 1e-15)
    # As parameters of a problem they are no hindrance. A derivative by them is not known.
    p, x = ca.MX.sym("p", 5), ca.MX.sym("x", 2)
    torque = tau(p, x, qd, qdd)
    by = ca.Function("by", [p, x], [ca.jacobian(torque, x), ca.jacobian(torque, p)])
    by_x, by_p = by(values, q)
    assert np.isfinite(by_x.full()).all() and np.isnan(by_p.full()).all()


def test_ipopt_with_exact_hessians(arm: rd.Robot, external: External) -> None:
    """The posture in which the Panda's motors hold it with the least effort, and its torques are those of a graph."""
    q = ca.MX.sym("q", arm.dof)
    options = {"ipopt.print_level": 0, "print_time": False, "ipopt.sb": "yes"}
    optima = []
    for tau in external("inverse_dynamics"), graph(arm, "inverse_dynamics"):
        effort = ca.sumsqr(tau(q, np.zeros(arm.dof), np.zeros(arm.dof))) + ca.sumsqr(q - 0.5)
        solver = ca.nlpsol("solver", "ipopt", {"x": q, "f": effort}, options)
        optima.append(solver(x0=np.full(arm.dof, 0.5))["x"])
        assert solver.stats()["success"]
    assert_near(optima[0], optima[1], 1e-10)


def test_a_motion_by_forward_dynamics(arm: rd.Robot, external: External) -> None:
    """Collocation whose constraints have `forward_dynamics` in them takes the iterations of a graph, to the same optimum."""
    nodes, target = 15, np.array([0.8, -0.5, 0.4, 1.0, -0.3, 0.6, 0.2])
    step = 1.5 / (nodes - 1)
    q, qd, tau = (ca.MX.sym(name, arm.dof, nodes) for name in ("q", "qd", "tau"))
    before, after = slice(0, nodes - 1), slice(1, nodes)
    options = {"ipopt.print_level": 0, "print_time": False, "ipopt.sb": "yes", "ipopt.tol": 1e-8}
    optima, iterations = [], []
    for function in external("forward_dynamics"), graph(arm, "forward_dynamics"):
        qdd = function.map(nodes)(q, qd, 100 * tau)
        fits = [x[:, after] - x[:, before] - step / 2 * (v[:, after] + v[:, before]) for x, v in ((q, qd), (qd, qdd))]
        ends = [q[:, 0], qd[:, 0], q[:, -1] - target, qd[:, -1]]
        problem = {"x": ca.veccat(q, qd, tau), "f": step * ca.sumsqr(tau), "g": ca.veccat(*fits, *ends)}
        solver = ca.nlpsol("solver", "ipopt", problem, options)
        optima.append(solver(x0=0, lbg=0, ubg=0)["f"])
        assert solver.stats()["success"]
        iterations.append(solver.stats()["iter_count"])
    assert iterations[0] == iterations[1] < 60, iterations
    assert_near(optima[0], optima[1], 1e-8)


def test_the_chapter_runs(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.chdir(tmp_path)
    (program,) = programs((ROOT / "docs/guide/src/optimal_control.md").read_text())
    names: dict[str, Any] = {}
    exec(program, names)
    assert names["solver"].stats()["success"]
