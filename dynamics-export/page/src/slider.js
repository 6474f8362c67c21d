// A slider with a number beside it.

import { element } from "./dom.js";
import { short } from "./format.js";

/**
 * A labelled slider with a number beside it. Values are SI, `factor` makes them those that are shown. `set` returns why a
 * value is refused, if it is.
 */
export function slider({ label, key, min, max, get, set, factor, unit, about }) {
  const range = element("input", { type: "range", step: "any", "data-key": key, "aria-label": about });
  const typed = element("input", { type: "number", step: "any", "aria-label": `${about}, as a number` });
  const sign = element("span", { class: "unit" });
  const refused = element("p", { class: "refused", role: "alert" });
  const row = element("div", { class: "slider" }, element("span", { class: "what" }, label), range, typed, sign, refused);
  const show = () => {
    const [value, times] = [get(), factor()];
    const [low, high] = [Math.min(min(), value), Math.max(max(), value)];
    Object.assign(range, { min: low * times, max: high * times });
    range.value = value * times;
    range.setAttribute("aria-valuetext", `${short(value * times)} ${unit()}`);
    if (document.activeElement !== typed || refused.textContent) typed.value = short(value * times, 5);
    sign.textContent = unit();
  };
  const take = (text) => {
    const value = Number(text) / factor();
    const isNumber = text.trim() !== "" && Number.isFinite(value);
    const reason = isNumber ? set(value) : "expected a number";
    refused.textContent = reason ? `${isNumber ? `${text} is refused: ` : ""}${reason}` : "";
    show();
  };
  range.addEventListener("input", () => take(range.value));
  typed.addEventListener("change", () => take(typed.value));
  show();
  return { row, show };
}
