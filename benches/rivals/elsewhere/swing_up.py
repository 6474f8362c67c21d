"""A swing-up by direct collocation, solved by IPOPT with exact Hessians: functions of `--lang casadi` beside an SX graph.

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


def of_library(folder: Path) -> ca.Function:
    """The function of the C file."""
    library = folder / "panda_casadi.so"
    source = folder / "panda_casadi.c"
    subprocess.run(
        ["gcc", "-O3", "-march=native", "-shared", "-fPIC", source, "-o", library], check=True
    )
    return ca.external("inverse_dynamics", str(library))


def of_graph(folder: Path) -> ca.Function:
    """The same function as an SX graph, which CasADi differentiates and evaluates."""
    specification = importlib.util.spec_from_file_location("panda", folder / "panda.py")
    module = importlib.util.module_from_spec(specification)
    specification.loader.exec_module(module)
    symbols = [ca.SX.sym(name, module.DOF) for name in ("q", "qd", "qdd")]
    tau = module.inverse_dynamics(*symbols, xp=ca)
    return ca.Function("inverse_dynamics", symbols, [tau], ["q", "qd", "qdd"], ["tau"])


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


def run(solver: ca.Function, given: dict[str, np.ndarray]) -> tuple[float, int, float, float, float]:
    """The optimum, iterations, seconds in functions and in all, and the largest unknown."""
    began = time.perf_counter()
    solution = solver(**given)
    seconds = time.perf_counter() - began
    stats = solver.stats()
    assert stats["success"], stats["return_status"]
    in_functions = sum(value for key, value in stats.items() if key.startswith("t_wall_nlp_"))
    return float(solution["f"]), stats["iter_count"], in_functions, seconds, solution["x"].full()


def main() -> None:
    folder = Path(sys.argv[1])
    problems = {"C": problem(of_library(folder)), "SX": problem(of_graph(folder))}
    results = {name: [] for name in problems}
    for _ in range(RUNS):
        for name, of_name in problems.items():
            results[name].append(run(*of_name))
    for name, runs in results.items():
        cost, iterations, _, _, _ = runs[0]
        in_functions, seconds = (statistics.median(run[place] for run in runs) for place in (2, 3))
        print(f"{name}: optimum {cost:.12f} in {iterations} iterations, {in_functions:.3f} s in functions, {seconds:.3f} s in all")
    unknowns = [runs[0][4] for runs in results.values()]
    print(f"largest difference of an unknown: {np.abs(unknowns[0] - unknowns[1]).max():.1e}")
    times = [statistics.median(run[2] for run in runs) for runs in results.values()]
    print(f"time in functions: {times[0] / times[1]:.3f}")


if __name__ == "__main__":
    main()
