// Play, pause, scrub.

import { element } from "./dom.js";

const SPEEDS = [0.1, 0.25, 0.5, 1, 2];
const ICONS = {
  play: "M7 4.5v15l12.5-7.5z",
  pause: "M6.5 4.5h4v15h-4zM13.5 4.5h4v15h-4z",
};

function icon(path) {
  const drawn = document.createElementNS("http://www.w3.org/2000/svg", "svg");
  drawn.setAttribute("viewBox", "0 0 24 24");
  drawn.setAttribute("aria-hidden", "true");
  const shape = document.createElementNS("http://www.w3.org/2000/svg", "path");
  shape.setAttribute("d", path);
  drawn.append(shape);
  return drawn;
}

/** The bar below the picture. */
export function transport(model) {
  const { state } = model;
  const button = element("button", { type: "button", class: "play", "data-key": "play" });
  const time = element("input", { type: "range", min: 0, step: "any", "data-key": "time", "aria-label": "Time" });
  const said = element("output", { class: "time", "data-key": "seconds" });
  const speed = element(
    "select",
    { "aria-label": "Speed", "data-key": "speed" },
    SPEEDS.map((factor) => element("option", { value: factor, selected: factor === 1 }, `${factor}×`)),
  );
  const again = element("input", { type: "checkbox", "data-key": "repeat" });

  let before = null;
  function tick(now) {
    if (!state.isPlaying) {
      before = null;
      return;
    }
    if (before !== null) {
      const { duration } = model.trajectory;
      let t = state.t + ((now - before) / 1000) * state.speed;
      if (t >= duration && again.checked && duration > 0) t %= duration;
      if (t >= duration) model.play(false);
      model.setTime(t);
    }
    before = now;
    requestAnimationFrame(tick);
  }

  function played() {
    button.replaceChildren(icon(state.isPlaying ? ICONS.pause : ICONS.play));
    button.setAttribute("aria-label", state.isPlaying ? "Pause" : "Play");
    if (state.isPlaying && before === null) requestAnimationFrame(tick);
  }
  function moved() {
    const { duration } = model.trajectory ?? { duration: 0 };
    time.max = duration;
    time.value = state.t;
    const text = `${state.t.toFixed(2)} / ${duration.toFixed(2)} s`;
    time.setAttribute("aria-valuetext", text);
    said.textContent = text;
    bar.hidden = model.trajectory === null;
  }
  button.addEventListener("click", () => model.play(!state.isPlaying));
  time.addEventListener("input", () => {
    model.play(false);
    model.setTime(Number(time.value));
  });
  speed.addEventListener("change", () => (state.speed = Number(speed.value)));
  const bar = element(
    "div",
    { class: "transport", role: "group", "aria-label": "Time" },
    button,
    time,
    said,
    speed,
    element("label", { class: "check" }, again, "repeat"),
  );
  model.on("play", played);
  model.on("time trajectory", moved);
  played();
  moved();
  return bar;
}
