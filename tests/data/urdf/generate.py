"""Copies the URDF files of `example-robot-data` without meshes, and records Pinocchio's values of arms in them.

    pip install pin==4.1.0
    pip download --no-deps example-robot-data==6.0.0 && unzip example_robot_data-*.whl -d unpacked
    python generate.py unpacked/cmeel.prefix/share/example-robot-data/robots
"""
import json
import re
import sys
import xml.etree.ElementTree as ElementTree
from pathlib import Path

import numpy as np
import pinocchio

HERE = Path(__file__).parent
MOVABLE = ("revolute", "continuous", "prismatic")

# Name: file, first link, last link, joints that are locked off the chain; all others off the chain are ignored.
ARMS = {
    "panda": ("panda_description/urdf/panda.urdf", "panda_link0", "panda_hand_tcp",
              {"panda_finger_joint1": 0.02, "panda_finger_joint2": 0.035}),
    "ur3": ("ur_description/urdf/ur3_robot.urdf", "world", "ee_link", {}),
    "ur5": ("ur_description/urdf/ur5_robot.urdf", "base_link", "tool0", {}),
    "ur5_gripper": ("ur_description/urdf/ur5_gripper.urdf", "world", "tool0", {}),
    "ur10": ("ur_description/urdf/ur10_robot.urdf", "world", "ee_link", {}),
    "z1": ("z1_description/urdf/z1.urdf", "world", "gripperMover", {}),
    "so100": ("so_arm_description/urdf/so100.urdf", "base", "jaw", {}),
    "so101": ("so_arm_description/urdf/so101.urdf", "base_link", "gripper_frame_link", {"gripper": 0.4}),
    "xarm7": ("xarm_description/urdf/xarm7.urdf", "world", "link_eef", {}),
    "kinova": ("kinova_description/robots/kinova.urdf", "base", "j2s6s200_end_effector",
               {}),
    "baxter_left": ("baxter_description/urdf/baxter.urdf", "torso", "left_gripper", {}),
    "talos_left": ("talos_data/robots/talos_left_arm.urdf", "arm_left_1_link", "wrist_left_ft_tool_link", {}),
    "b1_z1": ("b1_description/urdf/b1-z1.urdf", "base", "gripperMover", {}),
    "alexander_leg": ("alexander_description/urdf/alexander_v1.lowerBodyOnly.urdf", "PELVIS_LINK",
                      "LEFT_FOOT_IMU_LINK", {}),
    "allegro_finger": ("allegro_hand_description/urdf/allegro_right_hand.urdf", "palm_link", "link_3.0_tip", {}),
    "allegro_thumb": ("allegro_hand_description/urdf/allegro_right_hand.urdf", "palm_link", "link_15.0_tip", {}),
    "finger_edu": ("finger_edu_description/robots/finger_edu.urdf", "base_link", "finger_tip_link", {}),
    "double_pendulum": ("double_pendulum_description/urdf/double_pendulum.urdf", "base_link", "link2", {}),
    "two_dof": ("asr_twodof_description/urdf/TwoDofs.urdf", "world", "Tip", {}),
    "hextilt": ("hextilt_description/urdf/hextilt_flying_arm_5.urdf", "hextilt__base_link",
                "flying_arm_5__gripper", {}),
    "borinot": ("borinot_description/urdf/borinot_flying_arm_2.urdf", "borinot__base_link", "flying_arm_2__ee", {}),
    "g1_left": ("g1_description/urdf/g1_29dof_rev_1_0.urdf", "torso_link", "left_rubber_hand", {}),
    "romeo_left": ("romeo_description/urdf/romeo_small.urdf", "torso", "l_gripper", {}),
    "simple_humanoid": ("simple_humanoid_description/urdf/simple_humanoid.urdf", "torso", "l_wrist", {}),
    "tiago": ("tiago_description/robots/tiago_no_hand.urdf", "base_footprint", "wrist_ft_tool_link", {}),
    "centauro": ("centauro_description/urdf/centauro.urdf", "pelvis", "arm1_8", {}),
    "laikago_leg": ("laikago_description/urdf/laikago.urdf", "trunk", "FR_foot", {}),
    "anymal_leg": ("anymal_b_simple_description/robots/anymal.urdf", "base", "LF_FOOT", {}),
    "anymal_kinova": ("anymal_b_simple_description/robots/anymal-kinova.urdf", "base", "j2s6s200_end_effector", {}),
}


def without_meshes(text):
    """The same text without what says nothing about motion."""
    for name in ("visual", "collision", "gazebo", "transmission", "material"):
        text = re.sub(rf"[ \t]*<{name}\b[^>]*/>[ \t]*\n?", "", text) if name in ("material", "gazebo") else text
        text = re.sub(rf"[ \t]*<{name}\b[^>]*(?<!/)>.*?</{name}>[ \t]*\n?", "", text, flags=re.S)
    text = re.sub(r"[ \t\r]+\n", "\n", text)
    return re.sub(r"\n\s*\n+", "\n", text)


def chain(root, first, last):
    inward = {j.find("child").get("link"): j for j in root.findall("joint") if j.find("child") is not None}
    path = []
    while last != first:
        path.append(inward[last])
        last = path[-1].find("parent").get("link")
    return path[::-1]


def quarter_turns(element):
    """Decimals within 1e-9 of a quarter turn mean that turn, as in tables."""
    angles = [float(x) for x in element.get("rpy", "").split()]
    nearest = [round(x / (np.pi / 2)) * (np.pi / 2) for x in angles]
    angles = [y if y != 0 and abs(x - y) <= 1e-9 else x for x, y in zip(angles, nearest)]
    if angles:
        element.set("rpy", " ".join(map(repr, map(float, angles))))


def arm(text, first, last, lock):
    """The tree from the first link on, without what is ignored; the names of that."""
    root = ElementTree.fromstring(text)
    for origin in root.iter("origin"):
        quarter_turns(origin)
    on_chain = {j.get("name") for j in chain(root, first, last)}
    kept, ignored, open_links = [], [], [first]
    while open_links:
        link = open_links.pop()
        for joint in root.findall("joint"):
            if joint.find("parent") is None or joint.find("parent").get("link") != link:
                continue
            name = joint.get("name")
            if joint.get("type") in MOVABLE and name not in on_chain and name not in lock:
                ignored.append(name)
                continue
            kept.append(name)
            open_links.append(joint.find("child").get("link"))
    links = {first} | {j.find("child").get("link") for j in root.findall("joint") if j.get("name") in kept}
    for element in list(root):
        if element.tag == "link" and element.get("name") in links:
            continue
        if element.tag == "joint" and element.get("name") in kept:
            if element.get("type") == "continuous":
                element.set("type", "revolute")
            for mimic in element.findall("mimic"):
                element.remove(mimic)
            if element.find("limit") is None and element.get("type") in MOVABLE:
                ElementTree.SubElement(element, "limit", lower="-9", upper="9", effort="1", velocity="1")
            continue
        root.remove(element)
    return ElementTree.tostring(root, encoding="unicode"), ignored


def values(text, first, last, lock):
    text, ignored = arm(text, first, last, lock)
    model = pinocchio.buildModelFromXML(text)
    position = pinocchio.neutral(model)
    for name, q in lock.items():
        position[model.joints[model.getJointId(name)].idx_q] = q
    locked = [model.getJointId(name) for name in lock]
    model = pinocchio.buildReducedModel(model, locked, position) if locked else model
    assert model.nq == model.nv
    data, tip = model.createData(), model.getFrameId(last)
    random = np.random.default_rng(7)
    states = []
    for _ in range(3):
        q, qd, qdd = (random.uniform(-x, x, model.nq) for x in (3.0, 2.0, 3.0))
        mass_matrix = pinocchio.crba(model, data, q)
        mass_matrix = np.triu(mass_matrix) + np.triu(mass_matrix, 1).T
        bias = pinocchio.nonLinearEffects(model, data, q, qd).copy()
        tau = pinocchio.rnea(model, data, q, qd, qdd).copy()
        jacobian = pinocchio.computeFrameJacobian(model, data, q, tip, pinocchio.LOCAL_WORLD_ALIGNED).copy()
        pinocchio.framesForwardKinematics(model, data, q)
        states.append({
            "q": q.tolist(), "qd": qd.tolist(), "qdd": qdd.tolist(), "M": mass_matrix.tolist(),
            "bias": bias.tolist(), "tau": tau.tolist(), "J": jacobian.tolist(),
            "pose": data.oMf[tip].homogeneous.tolist(),
        })
    return ignored, [model.names[i] for i in range(1, model.njoints)], states


def main():
    robots = Path(sys.argv[1])
    for name, (file, first, last, lock) in ARMS.items():
        text = without_meshes((robots / file).read_text())
        copy = Path(file).name
        (HERE / copy).write_text(text)
        ignored, joints, states = values(text, first, last, lock)
        reference = {
            "file": copy, "source": f"example-robot-data 6.0.0, {file}", "pinocchio": pinocchio.__version__,
            "chain": [first, last], "ignore": ignored, "lock": lock, "joints": joints, "states": states,
        }
        (HERE / f"{name}.json").write_text(json.dumps(reference) + "\n")
        print(name, len(joints), len(ignored), len(text))


if __name__ == "__main__":
    main()
