"""Equations of motion of robots: derived from a table or a URDF file, proven, and evaluated over arrays of numpy.

    import robot_dynamics as rd

    arm = rd.Robot.from_file("panda.urdf", chain=("panda_link0", "panda_hand_tcp"), gravity=(0, 0, -9.81), ignore="rest")
    tau = arm.inverse_dynamics(q, qd, qdd)

The last axis of an array has the joints, and the axes before it are broadcast as numpy does. SI units, radians.
"""

from . import layouts
from ._closed_form import BranchEnds, Solutions
from ._errors import Mistake, SingularMassMatrix, TableError
from ._motion import Law, SimulationError, Trajectory, Work
from ._native import Function, __version__
from ._questions import Compared, Formulas, Operations, Report
from ._reach import NotReached, Target
from ._robot import Robot

__all__ = [
    "BranchEnds",
    "Compared",
    "Formulas",
    "Function",
    "Law",
    "Mistake",
    "NotReached",
    "Operations",
    "Report",
    "Robot",
    "SimulationError",
    "SingularMassMatrix",
    "Solutions",
    "TableError",
    "Target",
    "Trajectory",
    "Work",
    "__version__",
    "layouts",
]
