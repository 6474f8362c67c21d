// Chromium without a window, spoken to by the DevTools protocol over a pipe: messages in JSON, each ended
// by a zero byte. Nothing but node is needed.

import { spawn } from "node:child_process";
import { mkdtempSync, rmSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { pathToFileURL } from "node:url";

const ARGUMENTS = [
  "--headless=new",
  "--remote-debugging-pipe",
  // Containers have neither a sandbox nor much shared memory, and no graphics card.
  "--no-sandbox",
  "--disable-dev-shm-usage",
  "--use-angle=swiftshader",
  "--enable-unsafe-swiftshader",
  "--hide-scrollbars",
  "--disable-extensions",
  "--disable-background-networking",
  "--no-first-run",
];

/** Starts the browser, calls `use` with it, and ends it. */
export async function withBrowser(program, use) {
  const profile = mkdtempSync(join(tmpdir(), "robot-dynamics-page-"));
  const browser = spawn(program, [...ARGUMENTS, `--user-data-dir=${profile}`], {
    stdio: ["ignore", "ignore", "ignore", "pipe", "pipe"],
  });
  try {
    return await use(connection(browser));
  } finally {
    const ended = new Promise((resolve) => browser.once("exit", resolve));
    browser.kill("SIGKILL");
    await ended;
    rmSync(profile, { recursive: true, force: true, maxRetries: 5 });
  }
}

/** Calls and events of the protocol. */
function connection(browser) {
  const [, , , input, output] = browser.stdio;
  const pending = new Map();
  const listeners = [];
  let [count, rest] = [0, ""];
  output.setEncoding("utf8");
  output.on("data", (text) => {
    const messages = (rest + text).split("\0");
    rest = messages.pop();
    for (const message of messages.map((one) => JSON.parse(one))) {
      const call = pending.get(message.id);
      pending.delete(message.id);
      if (!call) listeners.forEach((listener) => listener(message));
      else if (message.error) call.reject(new Error(`${call.method}: ${message.error.message}`));
      else call.resolve(message.result);
    }
  });
  browser.once("exit", () => pending.forEach(({ reject }) => reject(new Error("the browser has ended"))));
  const call = (method, params = {}, sessionId = undefined) =>
    new Promise((resolve, reject) => {
      const id = ++count;
      pending.set(id, { resolve, reject, method });
      input.write(`${JSON.stringify({ id, method, params, sessionId })}\0`);
    });
  return { call, on: (listener) => listeners.push(listener) };
}

/** Opens a file in a page of a size, in light or dark colors. */
export async function open(browser, file, { width, height, scheme = "light", scale = 1, isReduced = false }) {
  const { targetId } = await browser.call("Target.createTarget", { url: "about:blank" });
  const { sessionId } = await browser.call("Target.attachToTarget", { targetId, flatten: true });
  const call = (method, params) => browser.call(method, params, sessionId);
  const errors = [];
  const requests = [];
  browser.on(({ method, params, sessionId: from }) => {
    if (from !== sessionId) return;
    if (method === "Runtime.exceptionThrown") errors.push(params.exceptionDetails.exception?.description ?? params.exceptionDetails.text);
    if (method === "Runtime.consoleAPICalled" && params.type === "error") errors.push(params.args.map((one) => one.value).join(" "));
    if (method === "Log.entryAdded" && params.entry.level === "error") errors.push(params.entry.text);
    if (method === "Network.requestWillBeSent") requests.push(params.request.url);
  });
  await Promise.all(["Page", "Runtime", "Log", "Network"].map((domain) => call(`${domain}.enable`)));
  await call("Emulation.setDeviceMetricsOverride", { width, height, deviceScaleFactor: scale, mobile: width < 600 });
  const features = [
    { name: "prefers-color-scheme", value: scheme },
    { name: "prefers-reduced-motion", value: isReduced ? "reduce" : "no-preference" },
  ];
  await call("Emulation.setEmulatedMedia", { features });
  await call("Page.navigate", { url: pathToFileURL(file).href });

  const page = {
    errors,
    requests,
    call,

    /** The value of an expression in the page. */
    async evaluate(expression) {
      const { result, exceptionDetails } = await call("Runtime.evaluate", { expression, returnByValue: true, awaitPromise: true });
      if (exceptionDetails) throw new Error(`${expression}: ${exceptionDetails.exception?.description}`);
      return result.value;
    },

    /** Waits until an expression is true. */
    async until(expression, seconds = 60) {
      const end = Date.now() + 1000 * seconds;
      while (!(await page.evaluate(expression))) {
        if (Date.now() > end) throw new Error(`not true within ${seconds} s: ${expression}; errors: ${errors.join("; ")}`);
        await new Promise((resolve) => setTimeout(resolve, 30));
      }
    },

    /** Two frames later: what was asked for is drawn. */
    drawn: () => page.evaluate("new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(() => done(true))))"),

    /** A picture of the page, or of the part that a selector names, as base64. */
    async picture(selector = null) {
      await page.drawn();
      const params = { format: "png" };
      if (selector) {
        const box = await page.evaluate(
          `(() => { const { x, y, width, height } = document.querySelector(${JSON.stringify(selector)}).getBoundingClientRect(); return { x: x + scrollX, y: y + scrollY, width, height }; })()`,
        );
        params.clip = { ...box, scale: 1 };
        params.captureBeyondViewport = true;
      }
      return (await call("Page.captureScreenshot", params)).data;
    },
    async save(path, selector = null) {
      writeFileSync(path, Buffer.from(await page.picture(selector), "base64"));
    },

    /** Sets an input as a person does, and tells the page. */
    set: (key, value, event = "input") =>
      page.evaluate(
        `(() => { const input = document.querySelector('[data-key="${key}"]'); input.value = ${JSON.stringify(String(value))}; input.dispatchEvent(new Event("${event}", { bubbles: true })); })()`,
      ),
    click: (key) => page.evaluate(`document.querySelector('[data-key="${key}"]').click()`),
    close: () => browser.call("Target.closeTarget", { targetId }),
  };
  await page.until("document.documentElement?.dataset.ready === 'true'");
  return page;
}
