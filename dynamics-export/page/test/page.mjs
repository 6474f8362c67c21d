// Pages in a browser: what they show, against what a file of cases expects. The cases are written by
// `dynamics-cli/tests/page.rs`; each that fails is told, with status 1.
//
//     node page.mjs CHROMIUM CASES.json

import { readFileSync } from "node:fs";

import { open, withBrowser } from "./browser.mjs";

const [program, cases] = process.argv.slice(2);
const { pages } = JSON.parse(readFileSync(cases, "utf8"));
const DESK = { width: 1100, height: 640 };
const PHONE = { width: 380, height: 780 };

let failures = 0;
function check(name, isGood, told = "") {
  if (isGood) return;
  failures++;
  console.log(`FAILED ${name}: ${told}`);
}

/** A number that is shown, with all of its digits. */
const shown = (page, key) => page.evaluate(`Number(document.querySelector('data[data-key="${key}"]').value)`);

/** Numbers that are shown, by their keys. */
const allShown = (page) =>
  page.evaluate(`Object.fromEntries([...document.querySelectorAll("data[data-key]")].map((one) => [one.dataset.key, Number(one.value)]))`);

/** Fills in numbers as they stand in the cases, in radians. */
async function type(page, values, event = "input") {
  for (const [key, value] of Object.entries(values)) await page.set(key, value, event);
}

/** The rotation of a base that moves, which no table shows, by keys. */
const rotation = (page) =>
  page.evaluate(`Object.fromEntries((robotPage.now().base ?? []).slice(0, 9).map((entry, k) => ["rotation-" + k, entry]))`);

/** Waits until what was set is computed. */
const computed = (page) => page.until("!robotPage.isStale()");

/** Entries of M, G, tau and so on against those of Rust. */
async function numbers(page, { name, states }) {
  await page.click("mode-pose");
  for (const [k, { set, expected, scale }] of states.entries()) {
    await type(page, set);
    await computed(page);
    const found = await allShown(page);
    let worst = 0;
    for (const [key, value] of Object.entries(expected)) {
      const size = scale[key.split("-")[0]] ?? 1;
      const error = Math.abs(found[key] - value) / size;
      worst = Math.max(worst, error);
      check(`${name}, state ${k}, ${key}`, error < 1e-11, `${found[key]} instead of ${value}`);
    }
    const tip = ["0", "1", "2"].map((i) => found[`tip-${i}-3`].toFixed(4).replace(/^-(0\.0*)$/, "$1"));
    const drawn = await page.evaluate("document.querySelector('.readout').textContent");
    const [x, y, z] = [...drawn.matchAll(/-?\d+\.\d+/g)].map(([text]) => text);
    // The frames that are drawn come from the table, the numbers from the generated function.
    check(`${name}, state ${k}, drawn tip`, [x, y, z].join() === tip.join(), `${drawn} instead of ${tip}`);
    console.log(`${name}, state ${k}: ${Object.keys(expected).length} numbers, largest error ${worst.toExponential(1)}`);
  }
  await page.click("mode-motion");
}

/** The motion at its samples against rows of the commands `inverse` and `simulate`. */
async function motion(page, { name, motions, ofBase }) {
  for (const { mode, set, rows, tolerance } of motions) {
    await page.click(`mode-${mode}`);
    for (const [key, value] of Object.entries(set)) {
      await page.set(key, value, key === "duration" || key === "law" ? "change" : "input");
    }
    await computed(page);
    let worst = 0;
    for (const { t, expected, scale } of rows) {
      await page.set("time", t);
      const found = { ...(await allShown(page)), ...(await rotation(page)) };
      for (const [key, value] of Object.entries(expected)) {
        const error = Math.abs(found[key] - value) / scale[key.split("-")[0]];
        worst = Math.max(worst, error);
        check(`${name}, ${mode} at ${t} s, ${key}`, error < tolerance, `${found[key]} instead of ${value}`);
      }
    }
    await readings(page, `${name}, ${mode}`, ofBase);
    console.log(`${name}, ${mode}: ${rows.length} rows, largest error ${worst.toExponential(1)}`);
    await page.click("mode-motion");
  }
}

/** At an instant between two samples the readings of the plots are the numbers of the tables. */
async function readings(page, name, ofBase) {
  await page.evaluate("robotPage.setTime(0.33337 * robotPage.trajectory.duration)");
  const numbers = await allShown(page);
  const read = await page.evaluate(`Object.fromEntries([...document.querySelectorAll("figure[data-plot]")].map((one) => [one.dataset.plot, [...one.querySelectorAll(".reading data")].map((data) => Number(data.value))]))`);
  const keys = { energy: ["kinetic", "potential", "total"], tip: ["tip-0-3", "tip-1-3", "tip-2-3"] };
  const keyOf = (plot, k) => {
    if (keys[plot]) return keys[plot][k];
    const [group, ofWhat] = plot.split("-").reverse();
    // Positions of joints are counted alone, behind the base all else.
    return `${group}-${ofWhat === "base" || group === "base" || group === "q" ? k : ofBase + k}`;
  };
  for (const [plot, values] of Object.entries(read)) {
    values.forEach((value, k) => {
      const key = keyOf(plot, k);
      check(`${name}, reading of ${key}`, value === numbers[key], `${value} beside ${numbers[key]}`);
    });
  }
  const hasJoints = "q-0" in numbers;
  const count = 2 + (hasJoints ? 4 : 0) + (ofBase > 0 ? 3 : 0);
  check(`${name}, readings`, Object.keys(read).length === count, `${Object.keys(read).length} plots`);
}

/** A base that moves falls and spins, and the view follows it. Laws of the torques do what they are called after. */
async function fall(page, { name, moving }) {
  const reset = "[...document.querySelectorAll('button')].find((one) => one.textContent === 'Reset').click()";
  await page.evaluate(reset);
  await page.click("mode-free");
  await computed(page);
  const last = (expression) => page.evaluate(`(({ total, kinetic, qd, q, base, tau }) => ${expression})(robotPage.trajectory)`);
  check(`${name}, spin`, (await last("kinetic[0]")) > 0, "nothing turns at the start");
  const status = await page.evaluate(`document.querySelector('[data-key="status"]').textContent`);
  check(`${name}, fall`, status.includes("Energy and work balance"), status);
  const hasFriction = await page.evaluate(`document.querySelector('[data-key="friction"]') !== null`);
  if (!hasFriction) {
    const spread = await last("(Math.max(...total) - Math.min(...total)) / Math.max(...kinetic)");
    check(`${name}, energy`, spread < 1e-12, `T + U changes by ${spread} of T`);
  }
  await page.set("time", 0);
  const start = await page.picture(".view");
  const before = await allShown(page);
  await page.set("time", 0.5);
  // Gravity alone changes momentum: p by m g t, L about the centre of mass not at all.
  const after = await allShown(page);
  const [pull, scale] = await page.evaluate("[robotPage.table.gravity.map((g) => 0.5 * g * robotPage.evaluated().mass[0][0]), robotPage.evaluated().mass[4][4]]");
  for (const k of [0, 1, 2]) {
    const gained = after[`linear-${k}`] - before[`linear-${k}`];
    check(`${name}, momentum`, Math.abs(gained - pull[k]) < 1e-9 * Math.hypot(...pull), `${gained} instead of ${pull[k]}`);
    const changed = after[`angular-${k}`] - before[`angular-${k}`];
    check(`${name}, angular momentum`, Math.abs(changed) < 1e-9 * scale, `it changes by ${changed}`);
  }
  const later = await page.picture(".view");
  check(`${name}, picture`, start !== later, "the fall is not seen");
  await page.click("show-isFollowed");
  await page.set("time", 0.4);
  await page.set("time", 0.5);
  await page.click("show-isFollowed");
  await page.set("law", "gravity", "change");
  for (const k of [0, 1, 2, 3, 4, 5]) await page.set(`qd-${k}`, 0);
  await computed(page);
  const way = await last("Math.max(...base[base.length - 1].map((x, k) => Math.abs(x - base[0][k])))");
  check(`${name}, G + K`, way < 1e-9, `it moves by ${way}`);
  await page.set("law", "steady", "change");
  await page.set("qd-4", 2);
  if (moving > 0) await page.set("qd-6", 0.5);
  await computed(page);
  const change = await last("Math.max(0, ...qd[0].slice(6).map((x, k) => Math.abs(x - qd[qd.length - 1][6 + k])))");
  check(`${name}, steady joints`, change < 1e-8, `their velocities change by ${change}`);
  const force = await last("Math.max(...tau.flatMap((all) => all.slice(0, 6)).map(Math.abs))");
  check(`${name}, steady joints`, force === 0, `${force} acts on the base`);
  await page.set("law", "none", "change");
  await page.click("mode-motion");
  await page.evaluate(reset);
}

/** Numbers that no table can have are refused, and a motion that cannot be says why in the place of former results. */
async function refusals(page, name) {
  const status = () => page.evaluate(`document.querySelector('[data-key="status"]').textContent`);
  const alert = (key) => page.evaluate(`document.querySelector('[data-key="${key}"]').parentElement.querySelector("[role=alert]").textContent`);
  const plots = () => page.evaluate("document.querySelectorAll('figure[data-plot]').length");
  await page.click("mode-free");
  await computed(page);
  check(`${name}, free motion`, (await status()).includes("Energy and work balance") && (await plots()) === 6, await status());
  const typed = `document.querySelector('[data-key="field-m2"]').nextElementSibling`;
  const fill = (text) => page.evaluate(`(() => { const typed = ${typed}; typed.focus(); typed.value = ${JSON.stringify(text)}; typed.dispatchEvent(new Event("change")); return typed.value; })()`);
  for (const [text, reason] of [["-3", "-3 is refused: `elbow`: a mass cannot be negative"], ["", "expected a number"]]) {
    check(`${name}, mass "${text}"`, (await fill(text)) === "1", "it is left in the field");
    check(`${name}, mass "${text}"`, (await alert("field-m2")) === reason, await alert("field-m2"));
    check(`${name}, mass "${text}"`, (await page.evaluate("robotPage.fields.m2")) === 1, "it was taken");
  }
  await page.set("field-m2", 0);
  await computed(page);
  check(`${name}, no mass`, (await alert("field-m2")) === "", await alert("field-m2"));
  check(`${name}, no inertia`, (await status()) === "The motion cannot begin: the mass matrix is singular at joint 2, `elbow`: no inertia resists its motion.", await status());
  check(`${name}, no inertia`, (await plots()) === 0, "former plots are shown");
  const texts = await page.evaluate("document.querySelector('main').textContent");
  check(`${name}, no inertia`, !texts.includes("NaN"), "NaN is shown");
  await page.set("field-m2", 1);
  await computed(page);
  check(`${name}, mass again`, (await plots()) === 6 && !(await status()).includes("singular"), await status());
  await page.set("duration", -2, "change");
  const duration = await page.evaluate(`(() => { const label = document.querySelector('[data-key="duration"]').closest("label"); return label.nextElementSibling.textContent; })()`);
  check(`${name}, negative duration`, duration === "expected a number from 0.001 to 1000", duration);
  await page.click("mode-motion");
}

/** Solutions of inverse kinematics, typed and dragged, and motions to them. */
async function reach(page, { name }) {
  await page.click("mode-reach");
  await computed(page);
  // The generated function has the tip of each solution where the target is.
  const worst = () =>
    page.evaluate(`(() => {
      const { state, equations, size } = robotPage;
      const { x, y, z, o } = robotPage.problem().target;
      const expected = [0, 1, 2].map((k) => [x[k], y[k], z[k], o[k]]);
      return state.reached.found.map((q) => Math.max(...equations[robotPage.tip().key](robotPage.start(), q).slice(0, 3).flatMap((row, i) =>
        row.map((entry, j) => Math.abs(entry - expected[i][j]) * (j === 3 ? 1 / size : Number(state.hasRotation))))));
    })()`);
  const told = () => page.evaluate(`document.querySelector('[data-key="reached"]').textContent`);
  const errors = await worst();
  check(`${name}, solutions`, errors.length > 0 && Math.max(...errors) < 1e-8, `errors ${errors}`);
  if (name === "puma560") check(`${name}, solutions`, errors.length === 8, await told());
  const last = errors.length - 1;
  await page.click(`solution-${last}`);
  await computed(page);
  const ended = await page.evaluate(`Math.max(...robotPage.trajectory.q.at(-1).map((x, i) => Math.abs(x - robotPage.state.reached.found[${last}][i])))`);
  check(`${name}, motion to a solution`, ended < 1e-12, `it ends ${ended} beside`);
  const torques = await page.evaluate("robotPage.trajectory.tau.flat().every(Number.isFinite)");
  check(`${name}, motion to a solution`, torques, "torques are not finite");
  await page.click("start-0");
  await page.click(`solution-${last}`);
  await computed(page);
  const begun = await page.evaluate("robotPage.trajectory.q[0].every((x, i) => x === robotPage.state.reached.found[0][i])");
  check(`${name}, motion between solutions`, begun, "it does not begin at the first one");
  // The handle is dragged: the tip follows, and the view stays.
  await page.set("time", 0);
  await page.drawn();
  const place = () => page.evaluate(`(() => { const { left, top } = document.querySelector("canvas").getBoundingClientRect(); const [x, y] = document.querySelector(".view").dataset.handle.split(" ").map(Number); return { x: left + x, y: top + y }; })()`);
  await page.evaluate("document.querySelector('.view').scrollIntoView()");
  const before = await page.evaluate("robotPage.state.target.slice(0, 3)");
  const { x, y } = await place();
  await page.call("Input.dispatchMouseEvent", { type: "mousePressed", x, y, button: "left", clickCount: 1 });
  await page.call("Input.dispatchMouseEvent", { type: "mouseMoved", x: x + 4, y: y + 6, button: "left" });
  await page.drawn();
  await page.call("Input.dispatchMouseEvent", { type: "mouseReleased", x: x + 4, y: y + 6, button: "left", clickCount: 1 });
  await page.drawn();
  const after = await page.evaluate("robotPage.state.target.slice(0, 3)");
  check(`${name}, handle`, Math.hypot(...after.map((value, k) => value - before[k])) > 1e-4, "it is not dragged");
  const seen = await place();
  check(`${name}, handle`, Math.hypot(seen.x - x - 4, seen.y - y - 6) < 3, "it does not follow the pointer");
  check(`${name}, handle`, Math.max(0, ...(await worst())) < 1e-8, "the tip is not there");
  // A wheel follows no line.
  if (name !== "brick") await straight(page, name);
  if (name === "puma560") await withoutPast(page, name);
  await page.set("target-0", 100 * (await page.evaluate("robotPage.size")));
  await computed(page);
  check(`${name}, out of reach`, (await told()).startsWith("No solution found: "), await told());
  await page.set("path", "joints", "change");
  await page.click("mode-motion");
}

/** Where the straight line ends is what the list marks; it does not begin in a singular pose; answers have no past. */
async function withoutPast(page, name) {
  const solve = (q, end) => page.evaluate(`(() => { robotPage.state.q.splice(0, 6, ${q}); robotPage.state.end = [${end}]; robotPage.placeTarget(); robotPage.seek(); })()`);
  const found = () => page.evaluate("JSON.stringify(robotPage.state.reached.found)");
  const status = () => page.evaluate(`document.querySelector('[data-key="status"]').textContent`);
  const [start, end] = ["0.3, -0.6, 0.4, 0.5, 0.7, 0.2", "0.5, -0.4, 0.3, 0.6, 0.9, 0.4"];
  await solve(start, end);
  const first = await found();
  const target = await page.evaluate("robotPage.state.target");
  // Other questions in between, the last of them several turns away.
  for (const yaw of [3, 6, 9, 12]) await page.evaluate(`(robotPage.state.target = [0.3, 0.4, 0.2, 0.1, 0.4, ${yaw}], robotPage.seek())`);
  await page.evaluate(`(robotPage.state.target = ${JSON.stringify(target)}, robotPage.seek())`);
  check(`${name}, same question`, (await found()) === first, "another answer");
  // Whole turns, also where solutions become starts again and again.
  for (let k = 0; k < 6; k++) {
    await page.click(`start-${(await page.evaluate("robotPage.state.reached.found.length")) - 1}`);
    await computed(page);
  }
  const wound = await page.evaluate("Math.max(...robotPage.state.q.map((x, i) => robotPage.table.rows[i].limits ? 0 : Math.abs(x)))");
  check(`${name}, whole turns`, wound <= Math.PI + 1e-9, `a joint stands at ${wound}`);
  // The line goes to the solution of its own branch, whatever was chosen.
  await solve(start, end);
  await page.set("path", "line", "change");
  await page.click("solution-3");
  await computed(page);
  const off = await page.evaluate(`(() => {
    const { reached } = robotPage.state;
    const last = robotPage.trajectory.q.at(-1);
    const marked = [...document.querySelectorAll(".solutions tbody tr")].findIndex((row) => row.className === "chosen");
    return marked < 0 ? robotPage.trajectory.ended?.reason ?? "none is marked" : Math.max(...last.map((x, i) => Math.abs(x - reached.found[marked][i])));
  })()`);
  check(`${name}, marked solution`, off < 1e-6, off);
  await lineRates(page, name);
  // Near a singular pose, the wrist almost in line, velocities and accelerations are those of the line.
  await solve("0.3, -0.6, 0.4, 0.5, 0.003, 0.2", "0.3, -0.6, 0.4, 0.5, 0.6, 0.2");
  await computed(page);
  check(`${name}, near a singular pose`, (await page.evaluate("robotPage.trajectory.ended")) === null, await status());
  await lineRates(page, `${name} near a singular pose`);
  await page.evaluate("robotPage.setTime(0)");
  // The wrist in line, and on the way through that.
  await solve("0.3, -0.6, 0.4, 0.5, 0, 0.2", end);
  check(`${name}, singular start`, /^The motion cannot begin: at its start the arm is singular.*choose another start/.test(await status()), await status());
  check(`${name}, singular start`, await page.evaluate("robotPage.now().tau.every(Number.isNaN)"), "torques are shown");
  check(`${name}, singular start`, (await page.evaluate("document.querySelectorAll('tr.chosen').length")) === 0, "a solution is marked");
  await solve("0.3, -0.6, 0.4, 0.5, 0.2, 0.2", "0.3, -0.6, 0.4, 0.5, -0.2, 0.2");
  check(`${name}, singular pose on the way`, /^Ends at .* % of the line .*singular.*choose another start/.test(await status()), await status());
  await page.set("path", "joints", "change");
  await page.set("duration", 2000, "change");
  const told = await page.evaluate(`document.querySelector('[data-key="duration"]').closest("label").nextElementSibling.textContent`);
  check(`${name}, long duration`, told === "expected a number from 0.001 to 1000", told);
  await page.set("duration", 90, "change");
  await computed(page);
  check(`${name}, duration`, (await page.evaluate("robotPage.trajectory.duration")) === 90, "it is not 90 s");
  await page.set("duration", 2, "change");
  await computed(page);
}

/** Velocities and accelerations of a line against differences of its positions, of fourth order, at small steps. */
async function lineRates(page, name) {
  const worst = await page.evaluate(`(() => {
    const { at, duration } = robotPage.trajectory;
    const errors = [0.00731, 0.03, 0.1, 0.31, 0.5, 0.77, 0.9].map((share) => {
      const [t, h] = [share * duration, 2e-3 * Math.min(share, 1 - share) * duration];
      const [a, b, , d, e] = [-2, -1, 0, 1, 2].map((k) => at(t + k * h));
      const state = at(t);
      const slopes = (of) => state.q.map((_, i) => (a[of][i] - 8 * b[of][i] + 8 * d[of][i] - e[of][i]) / (12 * h));
      const off = (values, expected) => Math.max(...values.map((x, i) => Math.abs(x - expected[i]))) / (1e-3 + Math.max(...expected.map(Math.abs)));
      return Math.max(off(state.qd, slopes("q")), off(state.qdd, slopes("qd")));
    });
    return Math.max(...errors);
  })()`);
  console.log(`${name}, rates along the line: largest error ${worst.toExponential(1)}`);
  check(`${name}, rates along the line`, worst < 1e-5, `they are off by ${worst}`);
}

/** A joint that sticks is held by friction: F = tau - M qdd - V - G - K, at most the Coulomb friction. */
async function held(page, name) {
  await page.click("mode-free");
  await page.set("law", "constant", "change");
  for (const [key, value] of [["qd-6", 0], ["tau-6", 0.02]]) await page.set(key, value);
  for (const k of [0, 1, 2, 3, 4, 5]) await page.set(`qd-${k}`, 0);
  await computed(page);
  for (const t of [0, 0.1, 0.123]) {
    await page.evaluate(`robotPage.setTime(${t})`);
    const [force, rest, speed] = await page.evaluate(`(() => {
      const { friction, tau, mass, qdd, coriolis, gravity, spring, qd } = robotPage.evaluated();
      return [friction[6], tau[6] - mass[6].reduce((sum, m, j) => sum + m * qdd[j], 0) - coriolis[6] - gravity[6] - spring[6], qd[6]];
    })()`);
    const seen = await shown(page, "friction-6");
    const isHeld = speed === 0 && Math.abs(force) > 1e-3 && Math.abs(force) <= 0.05 && Math.abs(force - rest) < 1e-6 && seen === force;
    check(`${name}, friction that holds`, isHeld, `F ${force} beside ${rest}, shown ${seen}, velocity ${speed}`);
  }
  await page.click("friction");
  await computed(page);
  await page.evaluate("robotPage.setTime(0.5)");
  check(`${name}, friction left out`, (await shown(page, "friction-6")) === 0, "F is shown");
  await page.click("friction");
  await page.set("law", "none", "change");
  await page.click("mode-motion");
}

/** From a pose that is not singular, no elbow stretched, a short way: the tip stays on the line, and rates are those of it. */
async function straight(page, name) {
  const joints = await page.evaluate("robotPage.joints.length");
  for (let k = 0; k < joints; k++) {
    await page.evaluate(`robotPage.state.q[${k}] = robotPage.ranges[${k}][0] + ${0.42 + 0.05 * k} * (robotPage.ranges[${k}][1] - robotPage.ranges[${k}][0])`);
    await page.evaluate(`robotPage.state.end[${k}] = robotPage.state.q[${k}] + 0.02 * (robotPage.ranges[${k}][1] - robotPage.ranges[${k}][0])`);
  }
  await page.evaluate("robotPage.placeTarget(), robotPage.seek()");
  await page.set("path", "line", "change");
  await computed(page);
  const off = await page.evaluate(`(() => {
    const { tip, ended, tau } = robotPage.trajectory;
    const [from, to] = [tip[0], tip.at(-1)];
    const way = to.map((x, k) => x - from[k]);
    const square = way.reduce((sum, x) => sum + x * x, 0);
    const beside = tip.map((p) => { const d = p.map((x, k) => x - from[k]); const s = d.reduce((sum, x, k) => sum + x * way[k], 0) / square; return Math.hypot(...d.map((x, k) => x - s * way[k])); });
    return [Math.max(...beside), ended?.reason ?? null, tau.flat().every(Number.isFinite)];
  })()`);
  check(`${name}, straight line`, off[0] < 1e-8 && off[1] === null && off[2], JSON.stringify(off));
  const isRedundant = await page.evaluate("robotPage.joints.length > 6");
  if (off[1] === null && !isRedundant) await lineRates(page, name);
}

/** Where the table places the tip in the last link: all fixed joints on the way are in it. */
async function tip(page, { name, tip: expected }) {
  const found = await page.evaluate(`[...document.querySelectorAll(".cells tbody tr")].find((row) => row.querySelector("th").textContent === "tip").querySelector("td").textContent`);
  check(`${name}, tip of the table`, found === expected, `${found} instead of ${expected}`);
}

/** Sliders move the arm, by pointer and by keyboard; time moves it, and stops. */
async function moves(page, { name }) {
  await page.set("time", 0);
  const [still, again] = [await page.picture(".view"), await page.picture(".view")];
  check(`${name}, picture`, still === again, "two pictures of one state differ");
  const before = await shown(page, "q-0");
  const slider = (key) => `document.querySelector('[data-key="${key}"]')`;
  const value = await page.evaluate(`(${slider("q-0")}.min * 3 + ${slider("q-0")}.max * 5) / 8`);
  await page.set("q-0", value);
  await computed(page);
  check(`${name}, slider`, Math.abs((await shown(page, "q-0")) - value) < 1e-9 && value !== before, "q does not follow it");
  check(`${name}, slider`, still !== (await page.picture(".view")), "the picture is the same");

  await page.evaluate(`${slider("q-0")}.focus()`);
  for (const type of ["keyDown", "keyUp"]) {
    await page.call("Input.dispatchKeyEvent", { type, key: "ArrowRight", code: "ArrowRight", windowsVirtualKeyCode: 39 });
  }
  await computed(page);
  check(`${name}, arrow key`, (await shown(page, "q-0")) > value, "q does not follow the key");

  const start = await page.picture(".view");
  await page.click("play");
  await page.until(`Number(${slider("time")}.value) > 0.2`);
  await page.click("play");
  const held = await page.evaluate(`Number(${slider("time")}.value)`);
  const later = await page.picture(".view");
  check(`${name}, play`, start !== later, "the picture is the same");
  check(`${name}, pause`, held === (await page.evaluate(`Number(${slider("time")}.value)`)), "time goes on");
  await page.evaluate("robotPage.setTime(0.7 * robotPage.trajectory.duration)");
  const traced = await page.picture(".view");
  await page.click("show-trace");
  check(`${name}, trace`, traced !== (await page.picture(".view")), "the picture without it is the same");
  for (const key of ["frames", "axes", "masses"]) {
    const without = await page.picture(".view");
    await page.click(`show-${key}`);
    check(`${name}, ${key}`, without !== (await page.picture(".view")), "the picture is the same");
    await page.click(`show-${key}`);
  }
  await page.set("parameters", "none", "change");
  check(`${name}, labels`, (await labels(page)) === 0, "labels without parameters");
  await page.set("parameters", "all", "change");
  check(`${name}, labels`, (await labels(page)) > 1, "no labels");
  // A pointer on a plot sets the time, and all plots have it.
  await page.evaluate("document.querySelector('.plots').scrollIntoView()");
  const box = await page.evaluate("(() => { const { x, y, width, height } = document.querySelector('.u-over').getBoundingClientRect(); return { x, y, width, height }; })()");
  const at = { x: box.x + box.width / 2, y: box.y + box.height / 2, button: "left", clickCount: 1 };
  await page.call("Input.dispatchMouseEvent", { type: "mousePressed", ...at });
  await page.call("Input.dispatchMouseEvent", { type: "mouseReleased", ...at });
  const half = await page.evaluate(`${slider("time")}.value / ${slider("time")}.max`);
  check(`${name}, plot`, Math.abs(half - 0.5) < 0.02, `time at ${half} of the motion`);
  const heads = await page.evaluate("[...document.querySelectorAll('.playhead')].map((head) => head.style.transform)");
  check(`${name}, plots`, heads.length === 6, `${heads.length} plots`);
}

const labels = (page) => page.evaluate("[...document.querySelectorAll('.label')].filter((one) => !one.hidden).length");

/** On a phone nothing is wider than the screen, too small, or without a name. */
async function readable(page, { name }) {
  const wide = await page.evaluate("document.documentElement.scrollWidth");
  check(`${name} at 380 px`, wide <= 380, `${wide} px wide`);
  const cut = await page.evaluate(`[...document.querySelectorAll("body *")].filter((one) => {
    if (one.closest(".scroll, .labels, .u-wrap, svg") || one.getClientRects().length === 0) return false;
    const { left, right } = one.getBoundingClientRect();
    return left < -0.5 || right > 380.5;
  }).map((one) => one.outerHTML.slice(0, 80))`);
  check(`${name} at 380 px`, cut.length === 0, `cut: ${cut.slice(0, 3).join(" ")}`);
  const small = await page.evaluate(`[...document.querySelectorAll("body *")].filter((one) => {
    const isText = [...one.childNodes].some((node) => node.nodeType === 3 && node.textContent.trim() !== "");
    return isText && !one.closest("sub") && one.getClientRects().length > 0 && parseFloat(getComputedStyle(one).fontSize) < 11;
  }).map((one) => one.outerHTML.slice(0, 80))`);
  check(`${name} at 380 px`, small.length === 0, `small: ${small.slice(0, 3).join(" ")}`);
  const view = await page.evaluate("document.querySelector('.view').getBoundingClientRect().height");
  check(`${name} at 380 px`, view > 200, `the picture is ${view} px high`);
  const nameless = await page.evaluate(`[...document.querySelectorAll("input, select, button")].filter((one) => {
    return !one.ariaLabel && !(one.labels?.length > 0) && one.textContent.trim() === "";
  }).map((one) => one.outerHTML.slice(0, 80))`);
  check(`${name}, names of inputs`, nameless.length === 0, nameless.slice(0, 3).join(" "));
}

/** How far a color is from white, of 0 to 1. */
const darkness = (page) =>
  page.evaluate("(() => { const [r, g, b] = getComputedStyle(document.body).backgroundColor.match(/\\d+/g).map(Number); return 1 - (r + g + b) / 765; })()");

function clean(page, name) {
  check(`${name}, console`, page.errors.length === 0, page.errors.join("; "));
  const outside = page.requests.filter((url) => !/^(file|data|blob):/.test(url));
  check(`${name}, network`, outside.length === 0, outside.join(" "));
}

await withBrowser(program, async (browser) => {
  for (const given of pages) {
    const { name, file } = given;
    const page = await open(browser, file, { ...DESK });
    await page.click("units");
    await numbers(page, given);
    await motion(page, given);
    if (given.ofBase > 0) await fall(page, { ...given, moving: await page.evaluate("robotPage.joints.length") });
    if (given.refuses) await refusals(page, name);
    if (given.tip) await tip(page, given);
    if (given.moves) await moves(page, given);
    if (await page.evaluate("robotPage.joints.length > 0")) await reach(page, given);
    if (name === "brick") await held(page, name);
    clean(page, name);
    await page.close();
    const phone = await open(browser, file, { ...PHONE, scheme: "dark", isReduced: true });
    await readable(phone, given);
    const reaches = (await phone.evaluate("robotPage.joints.length > 0")) ? ["reach"] : [];
    for (const mode of [...reaches, ...(given.ofBase > 0 ? ["pose", "free"] : [])]) {
      await phone.click(`mode-${mode}`);
      await computed(phone);
      await readable(phone, given);
    }
    check(`${name}, dark`, (await darkness(phone)) > 0.8, "it is light");
    // From the system's colors to light ones.
    await phone.click("theme");
    check(`${name}, light`, (await darkness(phone)) < 0.2, "it is dark");
    clean(phone, name);
    await phone.close();
  }
});
console.log(failures === 0 ? "all pages are as they should be" : `${failures} failures`);
process.exitCode = failures === 0 ? 0 : 1;
