"""C++ code of a trial for every arm: the same recursions on as few inertial parameters as there are, on
numbers that are doubles or lanes of doubles, with sines as arguments. No tool offers it.

Usage: trial_code.py FILE
"""

import sys
from dataclasses import dataclass

import casadi as ca

from arms import ARMS, FUNCTIONS, Arm, arm
from casadi_code import Frames, values


@dataclass
class Body:
    """Mass, first moment and inertia tensor about the origin of a frame, in its axes."""

    mass: float
    first: ca.DM
    tensor: ca.DM

    def __add__(self, other):
        return Body(self.mass + other.mass, self.first + other.first, self.tensor + other.tensor)

    def __sub__(self, other):
        return Body(self.mass - other.mass, self.first - other.first, self.tensor - other.tensor)

    def before(self, link):
        """The same body in the frame before the link's, at the joint's zero."""
        (sa, cosa), (st, ct) = link.alpha, link.theta
        r = ca.DM([[ct, -st, 0], [st * cosa, ct * cosa, -sa], [st * sa, ct * sa, cosa]])
        p = ca.DM([link.a, -sa * link.d, cosa * link.d])
        turned, unit = r @ self.first, ca.DM.eye(3)
        shift = (2 * ca.dot(p, turned) + self.mass * ca.dot(p, p)) * unit
        shift -= p @ turned.T + turned @ p.T + self.mass * p @ p.T
        return Body(self.mass, turned + self.mass * p, r @ self.tensor @ r.T + shift)


@dataclass
class Grouped:
    """A link whose body is what Gautier and Khalil (1990) leave of it."""

    revolute: bool
    alpha: tuple
    a: float
    theta: tuple
    d: float
    viscous: float
    coulomb: float
    reflected_inertia: float
    body: Body

    @property
    def mass(self):
        return self.body.mass

    def about_origin(self):
        return self.body.first, self.body.tensor


def grouped(original):
    """The arm with all that can be told from no force moved to the link before, from the tip inwards."""
    links, moved = [], Body(0.0, ca.DM.zeros(3), ca.DM.zeros(3, 3))
    for i, link in reversed(list(enumerate(original.links))):
        first, tensor = map(ca.DM, link.about_origin())
        body = Body(link.mass, first, tensor) + moved
        # What the joint's own motion does not change is a part of the link before.
        if link.revolute:
            yy, h = body.tensor[1, 1], body.first[2]
            part = Body(body.mass, ca.vertcat(0, 0, h), ca.diag(ca.vertcat(yy, yy, 0)))
        else:
            part = Body(0.0, ca.DM.zeros(3), body.tensor)
        body, moved = body - part, part.before(link)
        reflected = link.reflected_inertia
        if i == 0 and link.revolute:
            body.tensor[2, 2] += reflected
            reflected = 0.0
        # Sums that cancel leave a rounding error, which would be a parameter.
        clean = lambda x: ca.if_else(ca.fabs(x) < 1e-13, 0, x)
        body = Body(body.mass, clean(body.first), clean(body.tensor))
        here = link.revolute, link.alpha, link.a, link.theta, link.d, link.viscous, link.coulomb
        links.insert(0, Grouped(*here, reflected, body))
    return Arm(original.gravity, links)


OPERATIONS = {
    ca.OP_ADD: "{} + {}",
    ca.OP_SUB: "{} - {}",
    ca.OP_MUL: "{} * {}",
    ca.OP_DIV: "{} / {}",
    ca.OP_NEG: "-({})",
    ca.OP_SQ: "{0} * {0}",
    ca.OP_TWICE: "{0} + {0}",
    ca.OP_INV: "1.0 / {}",
    ca.OP_SIGN: "sign({})",
}


def body(function):
    """The lines of a function, from CasADi's own list of its instructions."""
    held, lines = {}, []
    for k in range(function.n_instructions()):
        operation, read = function.instruction_id(k), function.instruction_input(k)
        written = function.instruction_output(k)
        if operation == ca.OP_CONST:
            held[written[0]] = repr(function.instruction_constant(k))
        elif operation == ca.OP_INPUT:
            held[written[0]] = f"{function.name_in(read[0])}[{read[1]}]"
        elif operation == ca.OP_OUTPUT:
            lines.append(f"  result[{written[1]}] = T{{}} + {held[read[0]]};")
        else:
            text = OPERATIONS[operation].format(*(held[i] for i in read))
            lines.append(f"  const T t{k} = {text};")
            held[written[0]] = f"t{k}"
    return lines


def main(file):
    names = ["q", "s", "c", "qd", "x"]
    text = ["// Written by trial_code.py."]
    for name in ARMS:
        a = grouped(arm(name))
        symbols = [ca.SX.sym(symbol, len(a.links)) for symbol in names]
        frames = Frames(a, *symbols[:3])
        for k, (function, value) in enumerate(zip(FUNCTIONS, values(a, frames, *symbols[3:]))):
            code = body(ca.Function(function, symbols, [value], names, ["result"]))
            print(name, function, sum(" const T " in line for line in code), file=sys.stderr)
            text.append("template <class T>")
            parameters = ", ".join(f"const T *{symbol}" for symbol in names)
            text.append(f"inline __attribute__((always_inline)) void {name}_{k}({parameters}, T *result) {{")
            text += [*code, "}"]
    open(file, "w").write("\n".join(text) + "\n")


main(sys.argv[1])
