"""C code of CasADi for every arm: recursive Newton-Euler and composite bodies on SX symbols.

Usage: casadi_code.py FOLDER
"""

import sys

import casadi as ca

from arms import ARMS, FUNCTIONS, arm


def cross(a, b):
    return ca.vertcat(
        a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]
    )


class Frames:
    """Rotation and origin of frame i in frame i-1, of joint positions and their sines and cosines."""

    def __init__(self, arm, q, sines, cosines):
        self.rotations, self.origins = [], []
        for link, qi, s, c in zip(arm.links, *map(ca.vertsplit, (q, sines, cosines))):
            (st, ct), d = link.theta, link.d
            if link.revolute:
                st, ct = s * ct + c * st, c * ct - s * st
            else:
                d = d + qi
            sa, ca_ = link.alpha
            rows = [[ct, -st, 0], [st * ca_, ct * ca_, -sa], [st * sa, ct * sa, ca_]]
            self.rotations.append(ca.vertcat(*[ca.horzcat(*row) for row in rows]))
            self.origins.append(ca.vertcat(link.a, -sa * d, ca_ * d))


def inverse_dynamics(arm, frames, qd, qdd, gravity):
    """Luh, Walker and Paul 1980, with parameters about the frames' origins; without friction."""
    zero, z = ca.SX.zeros(3), ca.DM([0, 0, 1])
    w, wd, a = zero, zero, -ca.SX(gravity)
    forces, moments = [], []
    for i, link in enumerate(arm.links):
        turn, p = frames.rotations[i].T, frames.origins[i]
        a = turn @ (a + cross(wd, p) + cross(w, cross(w, p)))
        w, wd = turn @ w, turn @ wd
        if link.revolute:
            wd = wd + cross(w, z) * qd[i] + z * qdd[i]
            w = w + z * qd[i]
        else:
            a = a + 2 * cross(w, z) * qd[i] + z * qdd[i]
        h, tensor = map(ca.DM, link.about_origin())
        forces.append(link.mass * a + cross(wd, h) + cross(w, cross(w, h)))
        moments.append(tensor @ wd + cross(w, tensor @ w) + cross(h, a))
    tau = [None] * len(arm.links)
    f, n = zero, zero
    for i in reversed(range(len(arm.links))):
        f, n = f + forces[i], n + moments[i]
        tau[i] = (n if arm.links[i].revolute else f)[2] + arm.links[i].reflected_inertia * qdd[i]
        f, n = frames.rotations[i] @ f, frames.rotations[i] @ n
        n = n + cross(frames.origins[i], f)
    return ca.vertcat(*tau)


def mass_matrix(arm, frames):
    """Featherstone 2008, 6.2."""
    size = len(arm.links)
    m = ca.SX.zeros(size, size)
    mass, first, tensor = 0, ca.SX.zeros(3), ca.SX.zeros(3, 3)
    for i in reversed(range(size)):
        link = arm.links[i]
        h, own = map(ca.DM, link.about_origin())
        mass, first, tensor = mass + link.mass, first + h, tensor + own
        if link.revolute:
            f, n = ca.vertcat(-first[1], first[0], 0), tensor[:, 2]
        else:
            f, n = ca.vertcat(0, 0, mass), ca.vertcat(first[1], -first[0], 0)
        m[i, i] = (n if link.revolute else f)[2] + link.reflected_inertia
        for j in reversed(range(i)):
            f, n = frames.rotations[j + 1] @ f, frames.rotations[j + 1] @ n
            n = n + cross(frames.origins[j + 1], f)
            m[i, j] = m[j, i] = (n if arm.links[j].revolute else f)[2]
        r, p = frames.rotations[i], frames.origins[i]
        turned = r @ first
        pp = ca.dot(p, p) * mass + 2 * ca.dot(p, turned)
        shift = pp * ca.SX.eye(3) - mass * p @ p.T - p @ turned.T - turned @ p.T
        tensor, first = r @ tensor @ r.T + shift, turned + mass * p
    return m


def solve(m, b):
    """L^T D L x = b, unrolled."""
    size, m, x = m.shape[0], ca.SX(m), list(ca.vertsplit(b))
    for k in reversed(range(size)):
        for i in reversed(range(k)):
            factor = m[k, i] / m[k, k]
            for j in range(i + 1):
                m[i, j] -= factor * m[k, j]
            m[k, i] = factor
            x[i] -= factor * x[k]
    for k in range(size):
        x[k] /= m[k, k]
        for i in range(k):
            x[k] -= m[k, i] * x[i]
    return ca.vertcat(*x)


def values(a, frames, qd, x):
    """The five functions, in their order: x is qdd, or tau."""
    zero, still = ca.SX.zeros(len(a.links)), [0, 0, 0]
    friction = ca.vertcat(
        *[l.viscous * qd[i] + l.coulomb * ca.sign(qd[i]) for i, l in enumerate(a.links)]
    )
    m = mass_matrix(a, frames)
    bias = inverse_dynamics(a, frames, qd, zero, a.gravity) + friction
    found = [
        inverse_dynamics(a, frames, qd, x, a.gravity) + friction,
        m,
        inverse_dynamics(a, frames, qd, zero, still),
        inverse_dynamics(a, frames, zero, zero, a.gravity),
        solve(m, x - bias),
    ]
    return [ca.cse(ca.densify(value)) for value in found]


def functions(name):
    a = arm(name)
    q, qd, x = (ca.SX.sym(symbol, len(a.links)) for symbol in ("q", "qd", "x"))
    frames = Frames(a, q, ca.sin(q), ca.cos(q))
    arguments = [[q, qd, x], [q], [q, qd], [q], [q, qd, x]]
    for function, of, value in zip(FUNCTIONS, arguments, values(a, frames, qd, x)):
        yield ca.Function(f"{name}_{function}", of, [value])


def main(folder):
    code = ca.CodeGenerator("arms.c", {"with_header": False})
    for name in ARMS:
        for function in functions(name):
            print(function.name(), function.n_instructions(), file=sys.stderr)
            code.add(function)
    code.generate(folder + "/")


if __name__ == "__main__":
    main(sys.argv[1])
