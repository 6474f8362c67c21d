"""A swing-up by direct collocation, solved by IPOPT with exact Hessians: functions of `--lang casadi` beside an SX graph, and
beside the C code that CasADi writes of that graph and of its derivatives. Prints the table for `benches/optimal_control.sh`.

    python swing_up.py FOLDER

The folder has `panda_casadi.c` and `panda.py`: `robot-dynamics generate .. --lang casadi` and `.. --lang python`, with
`inverse_dynamics`. It needs casadi, numpy and gcc. Torques are the inverse dynamics of the accelerations at each node, so
that the equations of motion hold there, and the states of neighbours fit by the trapezoidal rule.
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
TORQUES = np.array([87, 87, 87, 87, 12, 12, 12.0])
"""The limits of the Panda's motors, N m."""
HANGING = np.array([0, 3.0, 0, -0.1, 0, 0.1, 0])
UPRIGHT = np.array([0, 0, 0, -0.1, 0, 0.1, 0])
OPTIONS = {"ipopt.print_level": 0, "ipopt.tol": 1e-9, "print_time": False, "calc_lam_p": False}


def compiled(source: Path) -> ca.Function:
    """The function of a C file."""
    library = source.with_suffix(".so")
    subprocess.run(["gcc", "-O3", "-march=native", "-shared", "-fPIC", source, "-o", library, "-lm"], check=True)
    return ca.external("inverse_dynamics", str(library))


def of_graph(folder: Path) -> ca.Function:
    """The same function as an SX graph, which CasADi differentiates and evaluates."""
    specification = importlib.util.spec_from_file_location("panda", folder / "panda.py")
    module = importlib.util.module_from_spec(specification)
    specification.loader.exec_module(module)
    symbols = [ca.SX.sym(name, module.DOF) for name in ("q", "qd", "qdd")]
    tau = module.inverse_dynamics(*symbols, xp=ca)
    return ca.Function("inverse_dynamics", symbols, [tau], ["q", "qd", "qdd"], ["tau"])


def of_written_graph(folder: Path) -> ca.Function:
    """That graph in C, with its derivatives."""
    function = of_graph(folder)
    first = function.jacobian()
    file = ca.CodeGenerator("graph.c")
    for written in function, first, first.jacobian():
        file.add(written)
    return compiled(Path(file.generate(f"{folder}/")))


def problem(inverse_dynamics: ca.Function) -> tuple[ca.Function, dict[str, np.ndarray]]:
    """The solver, and its starting point and bounds."""
    dof, step = len(HANGING), DURATION / (NODES - 1)
    q, qd, qdd = (ca.MX.sym(name, dof, NODES) for name in ("q", "qd", "qdd"))
    # One call at all nodes.
    tau = inverse_dynamics.map(NODES)(q, qd, qdd)
    before, after = slice(0, NODES - 1), slice(1, NODES)
    fits = [
        q[:, after] - q[:, before] - step / 2 * (qd[:, before] + qd[:, after]),
        qd[:, after] - qd[:, before] - step / 2 * (qdd[:, before] + qdd[:, after]),
    ]
    scaled = tau / ca.repmat(ca.DM(TORQUES), 1, NODES)
    cost = step * (ca.sumsqr(scaled) + 1e-4 * ca.sumsqr(qdd))
    unknowns = ca.veccat(q, qd, qdd)
    constraints = ca.veccat(*fits, scaled)
    solver = ca.nlpsol("solver", "ipopt", {"x": unknowns, "f": cost, "g": constraints}, OPTIONS)
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
    assert stats["success"], stats["return_status"]
    in_functions = sum(value for key, value in stats.items() if key.startswith("t_wall_nlp_"))
    return Result(float(solution["f"]), stats["iter_count"], solution["x"].full(), in_functions, in_all)


def main() -> None:
    folder = Path(sys.argv[1])
    problems = {
        "`--lang casadi`": problem(compiled(folder / "panda_casadi.c")),
        "SX": problem(of_graph(folder)),
        "SX written in C": problem(of_written_graph(folder)),
    }
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
        cells = [name, f"{in_functions:.3f}", f"{ratio:.2f}", f"{in_all:.3f}", str(runs[0].iterations)]
        cells += [f"{runs[0].optimum:.12f}", f"{difference:.0e}"]
        print("|", " | ".join(cells), "|")


if __name__ == "__main__":
    main()
