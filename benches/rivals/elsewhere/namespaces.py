"""The functions of a module that `generate --lang python` wrote, in each namespace of arrays that is installed, beside
those in numpy's doubles.

Usage: namespaces.py MODULE
"""

import importlib.util
import inspect
import sys

import numpy


def load(path):
    spec = importlib.util.spec_from_file_location("robot", path)
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    return module


def functions(robot):
    """The functions with the names of their vectors; those with fields or poses are left out."""
    for name, function in inspect.getmembers(robot, inspect.isfunction):
        names = list(inspect.signature(function).parameters)[:-1]
        if not name.startswith("_") and not {"arm", "base", "wrench"} & set(names):
            yield name, function, names


def error(found, expected):
    return abs(numpy.asarray(found, dtype=float).reshape(expected.shape) - expected).max() / abs(expected).max()


def by_casadi(casadi, function, states, expected):
    symbols = [casadi.SX.sym("x", state.shape[-1]) for state in states]
    value = function(*symbols, xp=casadi)
    compiled = casadi.Function("f", symbols, [value, casadi.jacobian(value, symbols[0])])
    worst, slope = 0.0, 0.0
    for k in range(len(expected)):
        at = [state[k] for state in states]
        found, jacobian = (numpy.array(x) for x in compiled(*at))
        worst = max(worst, error(found, expected[k]))
        step = 1e-6
        for i in range(len(at[0])):
            both = [function(at[0] + sign * step * numpy.eye(len(at[0]))[i], *at[1:]) for sign in (1, -1)]
            difference = (both[0] - both[1]).ravel(order="F") / (2 * step)
            slope = max(slope, abs(jacobian[:, i] - difference).max() / max(abs(difference).max(), 1.0))
    return f"values {worst:.0e}, its own Jacobian beside differences {slope:.0e}"


def by_jax(jax, function, states, expected):
    jax.config.update("jax_enable_x64", True)
    compiled = jax.jit(lambda *state: function(*state, xp=jax.numpy))
    one = jax.vmap(lambda *state: function(*state, xp=jax.numpy))
    slope = jax.jacfwd(lambda q: function(q, *[state[0] for state in states[1:]], xp=jax.numpy))(states[0][0])
    assert numpy.isfinite(numpy.asarray(slope)).all()
    return f"values {error(compiled(*states), expected):.0e}, by vmap {error(one(*states), expected):.0e}"


def by_torch(torch, function, states, expected):
    tensors = [torch.from_numpy(state).requires_grad_() for state in states]
    value = function(*tensors, xp=torch)
    value.sum().backward()
    assert torch.isfinite(tensors[0].grad).all()
    return f"values {error(value.detach().numpy(), expected):.0e}"


robot = load(sys.argv[1])
numbers = numpy.random.default_rng(1)
for namespace, compare in [("casadi", by_casadi), ("jax", by_jax), ("torch", by_torch)]:
    try:
        module = __import__(namespace)
    except ImportError:
        print(f"{namespace}: left out, for it is not installed")
        continue
    for name, function, names in functions(robot):
        states = [numbers.uniform(-2, 2, (5, robot.DOF)) for _ in names]
        print(f"{namespace} {module.__version__}, {name}: {compare(module, function, states, function(*states))}")
