"""The arms of tests/data, in frames on the joints' own axes: origin and z of frame i on axis i."""

import json
import math
from dataclasses import dataclass
from pathlib import Path

DATA = Path(__file__).parents[3] / "tests" / "data"
ARMS = ["two_link_saha", "elbow_3r", "stanford", "puma560", "ur5", "panda"]
FUNCTIONS = ["inverse_dynamics", "mass_matrix", "coriolis_vector", "gravity_vector", "forward_dynamics"]


@dataclass
class Link:
    """A joint and its link. Frame i in frame i-1 is Rx(alpha) Tx(a) Rz(theta) Tz(d)."""

    revolute: bool
    alpha: tuple  # sine, cosine
    a: float
    theta: tuple
    d: float
    mass: float
    com: list
    tensor: list  # 3 x 3, about the centre of mass
    reflected_inertia: float
    viscous: float
    coulomb: float

    def about_origin(self):
        """First moment m c and inertia tensor about the origin of the link's frame."""
        m, c = self.mass, self.com
        squares = sum(x * x for x in c)
        shift = lambda i, j: m * ((squares if i == j else 0) - c[i] * c[j])
        tensor = [[self.tensor[i][j] + shift(i, j) for j in range(3)] for i in range(3)]
        return [m * x for x in c], tensor


@dataclass
class Arm:
    gravity: list
    links: list


def sine_cosine(angle):
    """Exact at multiples of a right angle."""
    quarters = angle / (math.pi / 2)
    if quarters == round(quarters):
        return [(0.0, 1.0), (1.0, 0.0), (0.0, -1.0), (-1.0, 0.0)][round(quarters) % 4]
    return math.sin(angle), math.cos(angle)


def about_x(sine, cosine, v):
    return [v[0], cosine * v[1] - sine * v[2], sine * v[1] + cosine * v[2]]


def arm(name):
    robot = json.loads((DATA / "robots" / f"{name}.json").read_text())
    links, before = [], ((0.0, 1.0), 0.0)
    for row in robot["joints"]:
        com = row["com"]
        xx, yy, zz, xy, yz, xz = row["inertia"]
        tensor = [[xx, xy, xz], [xy, yy, yz], [xz, yz, zz]]
        alpha, a = sine_cosine(row["alpha"]), row["a"]
        if robot["convention"] == "standard":
            # Rx(alpha) Tx(a) of this row comes in front of the next joint; the link is before it.
            here, before = before, (alpha, a)
            com = about_x(*alpha, com)
            com[0] += a
            half = [about_x(*alpha, list(column)) for column in zip(*tensor)]
            tensor = [about_x(*alpha, list(line)) for line in zip(*half)]
            alpha, a = here
        links.append(
            Link(
                row["type"] == "revolute",
                alpha,
                a,
                sine_cosine(row["theta"]),
                row["d"],
                row["mass"],
                com,
                tensor,
                row["gear_ratio"] ** 2 * row["motor_inertia"],
                row["viscous"],
                row["coulomb"],
            )
        )
    return Arm(robot["gravity"], links)
