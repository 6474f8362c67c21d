"""The arms as numbers for pinocchio.cpp: `arm NAME N gx gy gz`, then for each joint its type, its
placement (rotation by rows, origin), mass, centre, tensor by rows, reflected inertia, friction.

Usage: pinocchio_arms.py > arms.txt
"""

from arms import ARMS, arm

for name in ARMS:
    a = arm(name)
    print("arm", name, len(a.links), *a.gravity)
    for link in a.links:
        (sa, ca), (st, ct) = link.alpha, link.theta
        rotation = [ct, -st, 0, st * ca, ct * ca, -sa, st * sa, ct * sa, ca]
        origin = [link.a, -sa * link.d, ca * link.d]
        rows = [x for row in link.tensor for x in row]
        numbers = rotation + origin + [link.mass] + link.com + rows
        numbers += [link.reflected_inertia, link.viscous, link.coulomb]
        print("RZ" if link.revolute else "PZ", *map(repr, numbers))
