// Elements of the page.

/** An element with properties and children; what begins with `on` is called, names with `-` are attributes. */
export function element(tag, properties = {}, ...children) {
  const made = document.createElement(tag);
  for (const [name, value] of Object.entries(properties)) {
    if (name.startsWith("on")) made.addEventListener(name.slice(2), value);
    else if (name === "class") made.className = value;
    else if (name.includes("-") || !(name in made)) made.setAttribute(name, value);
    else made[name] = value;
  }
  made.append(...children.flat(Infinity).filter((child) => child !== null && child !== undefined));
  return made;
}

/** A sign with an index below it: q with 1. */
export function indexed(sign, index) {
  const of = element("i", {}, sign);
  return index === null ? [of] : [of, element("sub", {}, String(index))];
}

/** A number that keeps all of its digits beside those that are shown. */
export function datum(key) {
  return element("data", { "data-key": key });
}

/** Shows a number in it. */
export function show(shown, value, text) {
  shown.value = String(value);
  shown.title = String(value);
  shown.textContent = text;
}
