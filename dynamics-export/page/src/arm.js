// The arm as solids: joints as cylinders and boxes on their axes, links as rods along the steps of the table.

import { Group } from "three";

import { add, distance, point, scaled, subtract } from "./frames.js";
import { baseBox, boxCorners } from "./base_box.js";
import { align, box, center, cone, cylinder, line, massMaterial, material, points, span, sphere } from "./shapes.js";

const AXES = ["#e03131", "#2f9e44", "#1c7ed6"];

/** Three arrows along the axes of a frame. */
function triad() {
  const group = new Group();
  const arrows = AXES.map((color) => {
    const of = material(color);
    const [rod, head] = [cylinder(of, false), cone(of)];
    group.add(rod, head);
    return { rod, head };
  });
  const put = (frame, size) => {
    [frame.x, frame.y, frame.z].forEach((axis, k) => {
      const [neck, end] = [0.78, 1].map((s) => add(frame.o, scaled(axis, s * size)));
      span(arrows[k].rod, frame.o, neck, 0.032 * size);
      span(arrows[k].head, neck, end, 0.085 * size);
    });
  };
  return { group, put };
}

/** The joints and places that are drawn: of a file with mounts, the joints as they were written. */
export function drawn(table) {
  const all = table.rows.map((row, index) => ({ row, index }));
  return table.isMounted ? all.filter(({ row }) => row.mount !== null) : all;
}

/** The solids of an arm in a room. `size` is the length of the arm. */
export function solids(room, table, size) {
  const links = drawn(table);
  // The first joints are the largest, and joints of many links are smaller.
  const largest = (0.034 * size) / Math.sqrt(Math.max(1, links.length / 6));
  const radius = (k) => largest * (1 - (0.45 * k) / Math.max(links.length, 4));
  const steel = material("#c9d1db");
  const dark = material("#5c6673");
  const world = new Group();
  room.scene.add(world);
  const added = (mesh, group = world) => {
    group.add(mesh);
    return mesh;
  };

  const base = table.floating ? null : { disc: added(cylinder(dark)), post: added(cylinder(dark)) };
  const moving = table.floating && baseBox();
  if (moving) added(moving.mesh);
  const parts = links.map(({ row }) => {
    const color = material("#888888");
    return {
      color,
      body: row.isPlace ? null : added(row.type === "prismatic" ? box(color) : cylinder(color)),
      caps: row.isPlace || row.type === "prismatic" ? [] : [0, 1].map(() => added(cylinder(dark))),
      rods: [0, 1].map(() => added(cylinder(steel))),
      corners: [0, 1].map(() => added(sphere(steel))),
    };
  });
  const tools = table.tips.map(() => ({ rod: added(cylinder(steel)), ball: added(sphere(dark)), stub: added(cylinder(steel)) }));

  const frames = added(new Group());
  const triads = [...links, "base", "world", ...table.tips].map(() => {
    const made = triad();
    frames.add(made.group);
    return made;
  });

  const axes = added(new Group());
  const axisLines = links.map(({ row }) => {
    const drawnLine = line("#888888", 1.6);
    drawnLine.material.dashed = true;
    axes.add(drawnLine);
    drawnLine.visible = !row.isPlace;
    return drawnLine;
  });

  const masses = added(new Group());
  const ball = massMaterial();
  const balls = [...table.rows, ...table.tips, ...(table.floating ? [table.floating] : [])].map(() => added(sphere(ball), masses));
  const whole = added(sphere(material("#f08c00")), masses);

  /** The rods of a link: from its frame before to its own, along the steps of the table. */
  function put(at, k, from) {
    const { row, index } = links[k];
    const { middle, frame, link, origin, axis, before } = at.rows[index];
    const { body, caps, rods, corners } = parts[k];
    const r = radius(k);
    const corner = table.isMounted ? link.o : middle.o;
    const end = table.isMounted ? link.o : frame.o;
    span(rods[0], from, corner, 0.52 * r);
    span(rods[1], corner, end, 0.52 * r);
    [corner, end].forEach((p, i) => {
      corners[i].position.set(...p);
      corners[i].scale.setScalar(0.52 * r);
    });
    if (!body) return end;
    if (row.type === "prismatic") {
      // The guide stays with the link before.
      const seat = table.convention === "standard" ? before : middle;
      align(body, table.isMounted ? from : origin, { ...seat, z: axis }, [1.7 * r, 1.7 * r, 3.4 * r]);
    } else {
      const place = table.isMounted ? link.o : table.convention === "standard" ? origin : frame.o;
      center(body, place, axis, 2.5 * r, r);
      caps.forEach((cap, i) => {
        center(cap, add(place, scaled(axis, (i === 0 ? 1.3 : -1.3) * r)), axis, 0.12 * r, 0.5 * r);
      });
    }
    return end;
  }

  return {
    /** Colors of the joints. */
    paint(colorOf) {
      parts.forEach(({ color }, k) => {
        color.color.set(colorOf(links[k].row));
        axisLines[k].material.color.set(colorOf(links[k].row));
      });
      room.ask();
    },

    /** Which groups are seen. */
    show({ frames: hasFrames, axes: hasAxes, masses: hasMasses }) {
      frames.visible = hasFrames;
      axes.visible = hasAxes;
      masses.visible = hasMasses;
      // The rods are glass where what is inside of them is to be seen.
      steel.transparent = hasMasses;
      steel.opacity = hasMasses ? 0.45 : 1;
      room.ask();
    },

    /** The arm at its frames; `now` is the table for the present values of the fields. */
    put(at, now) {
      const r = radius(0);
      const stand = at.base.o;
      moving?.put(at.base, now.floating);
      if (base) center(base.disc, subtract(stand, scaled(at.base.z, 1.75 * r)), at.base.z, 0.9 * r, 1.9 * r);
      if (base) center(base.post, subtract(stand, scaled(at.base.z, 1.1 * r)), at.base.z, 0.6 * r, 1.25 * r);
      // Where the rods of every link end.
      const ends = new Map([[null, stand]]);
      links.forEach(({ row, index }, k) => ends.set(index, put(at, k, ends.get(row.on) ?? stand)));
      const last = radius(links.length);
      tools.forEach((tool, k) => {
        const { on } = now.tips[k];
        const [from, tip] = [ends.get(on) ?? stand, at.tips[k].o];
        span(tool.rod, from, tip, 0.45 * last);
        tool.ball.position.set(...tip);
        tool.ball.scale.setScalar(0.62 * last);
        // Behind the last joint of a modified table a link has no step of the table: it is drawn to its mass.
        const end = on === null ? at.base : at.rows[on].link;
        const isBare = on !== null && now.convention === "modified" && distance(from, tip) < 0.01 * size;
        span(tool.stub, end.o, isBare ? point(end, now.rows[on].com) : end.o, 0.45 * last);
      });

      const length = 0.13 * size;
      links.forEach(({ index }, k) => triads[k].put(at.rows[index].link, length));
      triads[links.length].put(at.base, 1.15 * length);
      triads[links.length + 1].put({ x: [1, 0, 0], y: [0, 1, 0], z: [0, 0, 1], o: [0, 0, 0] }, 1.5 * length);
      at.tips.forEach((tip, k) => triads[links.length + 2 + k].put(tip, length));

      links.forEach(({ row, index }, k) => {
        if (row.isPlace) return;
        const { origin, axis, link } = at.rows[index];
        const place = table.isMounted ? link.o : origin;
        points(axisLines[k], [-0.16, 0.16].map((s) => add(place, scaled(axis, s * size))));
      });

      let [total, moment] = [0, [0, 0, 0]];
      const bodies = now.rows.map((row, i) => ({ ...row, frame: at.rows[i].link }));
      // A body on a base that stands counts nowhere.
      now.tips.forEach(({ on, body }, k) => bodies.push({ ...(on === null && !now.floating ? null : body), frame: at.tips[k] }));
      if (now.floating) bodies.push({ ...now.floating, frame: at.base });
      balls.forEach((mesh, i) => {
        const body = bodies[i];
        mesh.visible = body.mass > 0;
        if (!mesh.visible) return;
        const place = point(body.frame, body.com);
        mesh.position.set(...place);
        total += body.mass;
        moment = add(moment, scaled(place, body.mass));
      });
      // Volumes are as masses.
      const heaviest = Math.max(...bodies.map((body) => body.mass ?? 0));
      balls.forEach((mesh, i) => {
        if (mesh.visible) mesh.scale.setScalar(0.034 * size * Math.cbrt(bodies[i].mass / heaviest));
      });
      whole.visible = total > 0;
      if (total > 0) whole.position.set(...scaled(moment, 1 / total));
      whole.scale.setScalar(0.02 * size);
      room.ask();
    },
  };
}

/** Points that a picture of the arm should hold. */
export function corners(table, at, size) {
  const seen = [at.base.o, ...at.tips.map((tip) => tip.o)];
  for (const { index } of drawn(table)) {
    const { middle, link } = at.rows[index];
    seen.push(link.o);
    if (!table.isMounted) seen.push(middle.o);
  }
  if (table.floating) seen.push(...boxCorners(at.base, table.floating));
  for (const { on } of table.tips) if (on !== null) seen.push(point(at.rows[on].link, table.rows[on].com));
  const wide = 0.05 * size;
  return seen.flatMap((p) => [
    p,
    ...[0, 1, 2].flatMap((k) => [-wide, wide].map((s) => p.map((x, i) => (i === k ? x + s : x)))),
  ]);
}

