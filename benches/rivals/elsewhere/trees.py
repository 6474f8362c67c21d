"""Trees of URDF files as numbers for trees.cpp: `tree NAME N BASE`, N joints on a base that moves or, if BASE is 0, stands;
the place among Pinocchio's joints of each joint of the file, for a base that moves a line for its body, then for each joint its parent, type, axis, placement (rotation by rows, origin), mass, centre, tensor by rows,
viscous friction.

Usage: trees.py [--floating] FILE.. > trees.txt
"""

import re
import sys
from pathlib import Path

import pinocchio


def cleaned(x):
    """Entries of rotations within 1e-9 of a whole number are that number, as angles near quarter turns are."""
    return round(x) if abs(x - round(x)) < 1e-9 else x


def in_file(path):
    """The joints that move, depth first, children in the order of the file."""
    joints = {}
    for name, kind, text in re.findall(r'<joint name="([^"]*)" type="([^"]*)">(.*?)</joint>', Path(path).read_text(), re.DOTALL):
        parent, child = (re.search(f'<{end} link="([^"]*)"', text)[1] for end in ("parent", "child"))
        joints.setdefault(parent, []).append((name, kind, child))
    children = {child for all in joints.values() for _, _, child in all}
    found, open_ = [], [(None, "fixed", link) for link in joints if link not in children]
    while open_:
        name, kind, link = open_.pop()
        if kind != "fixed":
            found.append(name)
        open_ += reversed(joints.get(link, []))
    return found


floats = sys.argv[1] == "--floating"
for path in sys.argv[1 + floats :]:
    root = [pinocchio.JointModelFreeFlyer()] if floats else []
    model = pinocchio.buildModelFromUrdf(path, *root)
    first = 1 + floats
    print("tree", Path(path).stem, model.njoints - first, int(floats))
    print(*(model.getJointId(name) - first for name in in_file(path)))
    for i in range(1, model.njoints):
        joint, place, body = model.joints[i], model.jointPlacements[i], model.inertias[i]
        axis = list(joint.extract().axis) if "Unaligned" in joint.shortname() else [0, 0, 0]
        numbers = axis + [cleaned(x) for x in place.rotation.flatten()] + list(place.translation)
        numbers += [body.mass, *body.lever, *body.inertia.flatten(), model.damping[joint.idx_v]]
        print(model.parents[i], joint.shortname(), *(repr(float(x)) for x in numbers))
