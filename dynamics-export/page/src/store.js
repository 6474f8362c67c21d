// What the page shows, and who is told where it changes.

/** Listeners of events by name. */
export function events() {
  const listeners = new Map();
  return {
    on(names, listener) {
      for (const name of names.split(" ")) {
        listeners.set(name, [...(listeners.get(name) ?? []), listener]);
      }
    },
    tell(name) {
      (listeners.get(name) ?? []).forEach((listener) => listener());
    },
  };
}
