"""A swing-up by direct collocation, solved by IPOPT with exact Hessians: functions of `--lang casadi` beside an SX graph, and
beside the C code that CasADi writes of that graph and of its derivatives. Prints a table for `benches/optimal_control.sh`.

    python swing_up.py FOLDER inverse|forward

The folder has `panda_casadi.c` and `panda.py`: `robot-dynamics generate .. --lang casadi` and `.. --lang python`, with
`inverse_dynamics` and `forward_dynamics`. It needs casadi, numpy and gcc. Torques are the inverse dynamics of the
accelerations at each node, so that the equations of motion hold there, and the states of neighbours fit by the trapezoidal
rule. In `forward` accelerations are the forward dynamics of torques, and approximated Hessians are a row of the table.
"""

import importlib.util
import statistics
import subprocess
import sys
import time
from pathlib import Path
from typing import NamedTuple

import casadi as ca
import numpy as np

NODES = 50
DURATION = 2.0
RUNS = 5
MOST = 500
"""The most iterations."""
TORQUES = np.array([87, 87, 87, 87, 12, 12, 12.0])
"""The limits of the Panda's motors, N m."""
HANGING = np.array([0, 3.0, 0, -0.1, 0, 0.1, 0])
UPRIGHT = np.array([0, 0, 0, -0.1, 0, 0.1, 0])
OPTIONS = {"ipopt.print_level": 0, "ipopt.tol": 1e-9, "ipopt.sb": "yes", "ipopt.max_iter": MOST}
OPTIONS |= {"print_time": False, "calc_lam_p": False}


def compiled(source: Path, name: str) -> ca.Function:
    """A function of a C file."""
    library = source.with_suffix(".so")
    subprocess.run(["gcc", "-O3", "-march=native", "-shared", "-fPIC", source, "-o", library, "-lm"], check=True)
    return ca.external(name, str(library))


def of_graph(folder: Path, name: str) -> ca.Function:
    """The same function as an SX graph, which CasADi differentiates and evaluates."""
    specification = importlib.util.spec_from_file_location("panda", folder / "panda.py")
    module = importlib.util.module_from_spec(specification)
    specification.loader.exec_module(module)
    names = ["q", "qd", "tau", "qdd"] if name == "forward_dynamics" else ["q", "qd", "qdd", "tau"]
    symbols = [ca.SX.sym(argument, module.DOF) for argument in names[:3]]
    value = getattr(module, name)(*symbols, xp=ca)
    return ca.Function(name, symbols, [value], names[:3], names[3:])


def of_written_graph(folder: Path, name: str) -> ca.Function:
    """That graph in C, with its derivatives."""
    function = of_graph(folder, name)
    first = function.jacobian()
    file = ca.CodeGenerator("graph.c")
    for written in function, first, first.jacobian():
        file.add(written)
    return compiled(Path(file.generate(f"{folder}/")), name)


def problem(function: ca.Function, **options: object) -> tuple[ca.Function, dict[str, np.ndarray]]:
    """The solver, and its starting point and bounds."""
    dof, step = len(HANGING), DURATION / (NODES - 1)
    # The last are accelerations, or torques as shares of the limits.
    q, qd, given = (ca.MX.sym(name, dof, NODES) for name in ("q", "qd", "given"))
    limits = ca.repmat(ca.DM(TORQUES), 1, NODES)
    # One call at all nodes.
    if function.name() == "forward_dynamics":
        scaled, qdd = given, function.map(NODES)(q, qd, given * limits)
    else:
        scaled, qdd = function.map(NODES)(q, qd, given) / limits, given
    before, after = slice(0, NODES - 1), slice(1, NODES)
    fits = [
        q[:, after] - q[:, before] - step / 2 * (qd[:, before] + qd[:, after]),
        qd[:, after] - qd[:, before] - step / 2 * (qdd[:, before] + qdd[:, after]),
    ]
    cost = step * (ca.sumsqr(scaled) + 1e-4 * ca.sumsqr(qdd))
    unknowns = ca.veccat(q, qd, given)
    constraints = ca.veccat(*fits, scaled)
    solver = ca.nlpsol("solver", "ipopt", {"x": unknowns, "f": cost, "g": constraints}, OPTIONS | options)
    along = np.linspace(0, 1, NODES)
    way = HANGING[:, None] + (UPRIGHT - HANGING)[:, None] * along
    lower = np.full((3, NODES, dof), -np.inf)
    upper = -lower
    for node, position in ((0, HANGING), (NODES - 1, UPRIGHT)):
        lower[0, node] = upper[0, node] = position
        lower[1, node] = upper[1, node] = 0
    states = 2 * dof * (NODES - 1)
    limits = np.concatenate([np.zeros(states), np.ones(dof * NODES)])
    start = np.concatenate([way.T.ravel(), np.zeros(2 * dof * NODES)])
    given = {"x0": start, "lbx": lower.ravel(), "ubx": upper.ravel(), "lbg": -limits, "ubg": limits}
    return solver, given


class Result(NamedTuple):
    optimum: float
    iterations: int
    unknowns: np.ndarray
    in_functions: float
    """Seconds of the objective, the constraints and their derivatives."""
    in_all: float


TIMES = ("in_functions", "in_all")


def run(solver: ca.Function, given: dict[str, np.ndarray]) -> Result:
    began = time.perf_counter()
    solution = solver(**given)
    in_all = time.perf_counter() - began
    stats = solver.stats()
    assert stats["success"] or stats["iter_count"] == MOST, stats["return_status"]
    in_functions = sum(value for key, value in stats.items() if key.startswith("t_wall_nlp_"))
    return Result(float(solution["f"]), stats["iter_count"], solution["x"].full(), in_functions, in_all)


def main() -> None:
    folder, is_forward = Path(sys.argv[1]), sys.argv[2] == "forward"
    name = "forward_dynamics" if is_forward else "inverse_dynamics"
    functions = compiled(folder / "panda_casadi.c", name)
    problems = {"`--lang casadi`": problem(functions), "SX": problem(of_graph(folder, name))}
    if is_forward:
        approximated = {"ipopt.hessian_approximation": "limited-memory"}
        problems["`--lang casadi`, approximated Hessians"] = problem(functions, **approximated)
    else:
        problems["SX written in C"] = problem(of_written_graph(folder, name))
    results: dict[str, list[Result]] = {name: [] for name in problems}
    for _ in range(RUNS):
        for name, of_name in problems.items():
            results[name].append(run(*of_name))
    graph = results["SX"]
    print("| functions | in functions, s | of SX | in all, s | iterations | optimum | difference of unknowns |")
    print("|---|--:|--:|--:|--:|--:|--:|")
    for name, runs in results.items():
        in_functions, in_all = (statistics.median(getattr(run, time) for run in runs) for time in TIMES)
        ratio = statistics.median(run.in_functions / other.in_functions for run, other in zip(runs, graph, strict=True))
        difference = np.abs(runs[0].unknowns - graph[0].unknowns).max()
        iterations = str(runs[0].iterations) if runs[0].iterations < MOST else f"{MOST}, not converged"
        cells = [name, f"{in_functions:.3f}", f"{ratio:.2f}", f"{in_all:.3f}", iterations]
        cells += [f"{runs[0].optimum:.12f}", f"{difference:.0e}"]
        print("|", " | ".join(cells), "|")


if __name__ == "__main__":
    main()
