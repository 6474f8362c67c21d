// Texts over the picture, at points of the room.

import { element } from "./dom.js";

/** How near labels may be, in pixels. */
const GAP = 2;

/** Labels in a layer over a canvas. */
export function labels(room, layer) {
  let shown = [];
  const pool = [];

  function place() {
    const taken = [];
    const { clientWidth: width, clientHeight: height } = layer;
    shown.forEach(({ at }, i) => {
      const mark = pool[i];
      const found = room.onCanvas(at);
      mark.hidden = found === null;
      if (!found) return;
      const [wide, high] = [mark.offsetWidth, mark.offsetHeight];
      const x = Math.min(Math.max(found[0] - wide / 2, 2), width - wide - 2);
      let y = Math.min(Math.max(found[1] - high / 2, 2), height - high - 2);
      // Down, below those that are there already.
      for (let tries = 0; tries < 12; tries++) {
        const other = taken.find((box) => {
          const isBeside = x > box.x + box.wide + GAP || box.x > x + wide + GAP;
          return !isBeside && y < box.y + box.high + GAP && box.y < y + high + GAP;
        });
        if (!other) break;
        y = other.y + other.high + GAP + 0.5;
      }
      taken.push({ x, y, wide, high });
      mark.style.transform = `translate(${x}px, ${y}px)`;
    });
  }
  room.onDraw(place);

  return {
    /** Texts at points: `at`, `content` (nodes or text), `kind` (a class), `color`. */
    put(texts) {
      shown = texts;
      while (pool.length < texts.length) pool.push(layer.appendChild(element("span")));
      pool.forEach((mark, i) => {
        mark.hidden = i >= texts.length;
        if (mark.hidden) return;
        const { content, kind, color } = texts[i];
        mark.className = `label ${kind}`;
        mark.style.setProperty("--color", color);
        mark.replaceChildren(...[content].flat());
      });
      room.ask();
    },
  };
}
