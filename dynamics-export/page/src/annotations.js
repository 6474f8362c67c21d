// The parameters of a row of the table, drawn where they are: theta and alpha as arcs, d and a as lines.

import { Group } from "three";

import { add, cross, distance, dot, scaled, subtract, turned, unit } from "./frames.js";
import { drawn } from "./arm.js";
import { line, points } from "./shapes.js";

export const COLORS = { theta: "#e64980", d: "#228be6", a: "#37b24d", alpha: "#f76707" };
const SIGNS = { theta: "θ", d: "d", a: "a", alpha: "α" };
const PLAIN = "#868e96";

/** An arc about an axis from one direction to another one, with the angle that it has. */
function arc(center, axis, from, angle, radius) {
  const count = Math.max(2, Math.ceil(Math.abs(angle) / 0.06));
  const start = scaled(unit(subtract(from, scaled(axis, dot(axis, from)))), radius);
  return Array.from({ length: count + 1 }, (_, k) => add(center, turned(start, axis, (angle * k) / count)));
}

/** Two short strokes at the end of a line or an arc. */
function arrow(path, size) {
  const end = path[path.length - 1];
  const way = unit(subtract(end, path[path.length - 2]));
  const side = unit(cross(way, Math.abs(way[2]) < 0.9 ? [0, 0, 1] : [1, 0, 0]));
  return [1, -1].map((s) => add(end, add(scaled(way, -size), scaled(side, 0.4 * s * size))));
}

/** What is drawn of a row: paths with a color, and texts at points. */
function parametersOf(table, at, index, format, size) {
  const row = table.rows[index];
  const { before, middle, frame, theta, d } = at.rows[index];
  const isStandard = table.convention === "standard";
  const radius = 0.115 * size;
  const number = index + 1;
  const found = { paths: [], texts: [] };
  // A modified row has alpha and a of the link before.
  const of = (name) => (!isStandard && (name === "a" || name === "alpha") ? number - 1 : number);
  const say = (name, at, text) => found.texts.push({ at, name, sign: SIGNS[name], index: of(name), text });
  const draw = (name, path, place, text) => {
    found.paths.push({ color: COLORS[name], path, width: 3.2 });
    const [left, right] = arrow(path, 0.03 * size);
    const end = path[path.length - 1];
    found.paths.push({ color: COLORS[name], path: [left, end, right], width: 3.2 });
    say(name, place, text);
  };
  const stroke = (from, to) => found.paths.push({ color: PLAIN, path: [from, to], width: 1.4 });
  const middleOf = (path) => path[Math.floor(path.length / 2)];

  // The screw about z turns x, and slides along z; that about x turns z, and slides along x.
  const [zFrom, zTo] = isStandard ? [before, middle] : [middle, frame];
  const [xFrom, xTo] = isStandard ? [middle, frame] : [before, middle];
  const atZ = isStandard ? zFrom.o : zTo.o;
  const atX = isStandard ? xTo.o : xFrom.o;
  const isShort = (angle) => Math.abs(angle) < 1e-9;

  const z = zFrom.z;
  for (const x of [zFrom.x, zTo.x]) stroke(atZ, add(atZ, scaled(x, 1.25 * radius)));
  if (!isShort(theta)) {
    const path = arc(atZ, z, zFrom.x, theta, radius);
    const out = unit(subtract(middleOf(path), atZ));
    draw("theta", path, add(atZ, scaled(out, 1.2 * radius)), format.angle(theta));
  } else {
    say("theta", add(atZ, scaled(zTo.x, 1.3 * radius)), format.angle(0));
  }
  if (Math.abs(d) > 1e-9) {
    draw("d", [zFrom.o, zTo.o], scaled(add(zFrom.o, zTo.o), 0.5), format.length(d));
  }
  if (Math.abs(row.a) > 1e-9) {
    draw("a", [xFrom.o, xTo.o], scaled(add(xFrom.o, xTo.o), 0.5), format.length(row.a));
  }
  if (!isShort(row.alpha)) {
    for (const axis of [xFrom.z, xTo.z]) stroke(atX, add(atX, scaled(axis, 1.25 * radius)));
    const path = arc(atX, xFrom.x, xFrom.z, row.alpha, radius);
    const out = unit(subtract(middleOf(path), atX));
    draw("alpha", path, add(atX, scaled(out, 1.2 * radius)), format.angle(row.alpha));
  }
  return found;
}

/** The step from a link to its joint, of a row that was not written as one of a table. */
function mountOf(table, at, index, previous, format, size) {
  const { link, axis } = at.rows[index];
  const found = { paths: [], texts: [] };
  const path = [previous.o, link.o];
  if (distance(...path) > 1e-9) {
    found.paths.push({ color: COLORS.a, path, width: 3.2 });
    const xyz = subtract(link.o, previous.o);
    const inLink = [previous.x, previous.y, previous.z].map((of) => format.number(dot(of, xyz)));
    found.texts.push({
      at: scaled(add(...path), 0.5),
      name: "a",
      sign: "xyz",
      index: null,
      text: `${inLink.join(", ")} m`,
    });
  }
  const tip = add(link.o, scaled(axis, 0.2 * size));
  found.paths.push({ color: COLORS.theta, path: [link.o, tip], width: 3.2 });
  found.texts.push({ at: tip, name: "theta", sign: "axis", index: null, text: "" });
  return found;
}

/** Draws rows of the table into a room. */
export function annotations(room, table, size) {
  const group = new Group();
  room.scene.add(group);
  const pool = [];
  const links = drawn(table);

  return {
    /** The texts of the rows; their lines are drawn. */
    put(at, now, indices, format) {
      const found = indices.map((index) => {
        if (!table.isMounted) return parametersOf(now, at, index, format, size);
        const place = links.findIndex((link) => link.index === index);
        const previous = place > 0 ? at.rows[links[place - 1].index].link : at.base;
        return mountOf(now, at, index, previous, format, size);
      });
      const paths = found.flatMap(({ paths }) => paths);
      while (pool.length < paths.length) {
        const drawnLine = line(PLAIN, 1, true);
        group.add(drawnLine);
        pool.push(drawnLine);
      }
      pool.forEach((drawnLine, i) => {
        drawnLine.visible = i < paths.length;
        if (!drawnLine.visible) return;
        points(drawnLine, paths[i].path);
        drawnLine.material.color.set(paths[i].color);
        drawnLine.material.linewidth = paths[i].width;
      });
      room.ask();
      return found.flatMap(({ texts }) => texts);
    },
  };
}

