// The handle at the target of inverse kinematics, which is dragged in the picture.

import { distance } from "./frames.js";
import { material, sphere } from "./shapes.js";

/** How far from the handle it is taken hold of, in pixels. */
const NEAR = 24;

/** Puts the handle into a room whose canvas stands in `view`. */
export function handle(model, room, view) {
  const { state, size } = model;
  const ball = sphere(material("#f08c00"));
  ball.scale.setScalar(size / 45);
  room.scene.add(ball);
  function put() {
    ball.visible = state.mode === "reach";
    if (ball.visible) ball.position.set(...state.target.slice(0, 3));
    room.ask();
  }

  const onCanvas = ({ clientX, clientY }) => {
    const { left, top } = room.canvas.getBoundingClientRect();
    return [clientX - left, clientY - top];
  };
  let [held, asked] = [null, null];
  // Before the canvas hears of it, which turns the view.
  view.addEventListener(
    "pointerdown",
    (event) => {
      if (state.mode !== "reach" || event.target !== room.canvas) return;
      const at = room.onCanvas(state.target.slice(0, 3));
      if (!at || distance([...at, 0], [...onCanvas(event), 0]) > NEAR) return;
      held = event.pointerId;
      room.hold(true);
      room.canvas.setPointerCapture(held);
    },
    true,
  );
  view.addEventListener("pointermove", (event) => {
    if (event.pointerId !== held) return;
    const isWaiting = asked !== null;
    asked = onCanvas(event);
    if (!isWaiting) requestAnimationFrame(drag);
  });
  function drag() {
    if (asked === null) return;
    room.under(asked, state.target.slice(0, 3)).forEach((x, k) => (state.target[k] = x));
    asked = null;
    model.seek(true);
  }
  for (const name of ["pointerup", "pointercancel"]) {
    view.addEventListener(name, (event) => {
      if (event.pointerId !== held) return;
      drag();
      held = null;
      room.hold(false);
      model.seek();
    });
  }
  // Where it is on the canvas, for tests.
  room.onDraw(() => {
    if (ball.visible) view.dataset.handle = room.onCanvas(state.target.slice(0, 3))?.map(Math.round).join(" ");
  });
  model.on("reached mode", put);
  put();
}
