// Main module: reads the data, draws the machine at the clock's time, and connects clock, curves, and tables.

import { Camera, handle } from "./camera.js";
import { Clock } from "./clock.js";
import { forceColor, gradient, themeColor, themeText } from "./colors.js";
import { drawStrip, Panel } from "./curves.js";
import { Motion, readPage } from "./data.js";
import { Pen } from "./draw.js";
import { legFrame } from "./machine.js";
import { shown } from "./numbers.js";
import { amount, DOUBTFUL, EXCEEDED, ofLegs, ofLimit, ofMotors } from "./quantities.js";
import { Ribbon, sceneAt } from "./scene.js";
import { legTable } from "./tables.js";
import { add, along, column, dot, minus, times, unit } from "./vectors.js";

const find = (name) => document.getElementById(name);
const page = readPage();
const { machine, units } = page;
const motion = new Motion(page);
const clock = new Clock(motion);
const sets = page.forces;
const camera = new Camera(machine.up, machine.extent, machine.middle, machine.reach);
const canvas = find("scene");
const still = matchMedia("(prefers-reduced-motion: reduce)");
const state = { shown: sets.slice(0, 1), skeleton: false, frames: true, ribbon: true, twist: null, wave: 0, wordy: true, dirty: true };
const repaint = () => (state.dirty = true);

// Forces and limits; limits are infinite if the robot file has none

const number = (value) => (value === null ? Infinity : value);
const forceLimits = machine.forceLimit.map(number);
const speedLimits = machine.speedLimit.map(number);
const lengthLimits = machine.lengthLimits.map(([low, high]) => [number(low), number(high)]);
const forceOf = (set, i, leg) => motion.ofLeg(`F_${set}`, i, leg);
const legs = [0, 1, 2, 3, 4, 5];
const quantities = ofLegs(motion, sets, units);
const motorQuantities = ofMotors(motion, page.motors);
const others = [quantities.length, quantities.speed, ...motorQuantities];
// Most severe status of a limit for each leg at the clock's time.
function verdicts(set) {
  const all = set ? [quantities.forces[set], ...others] : others;
  return legs.map((leg) => Math.max(...all.map((each) => each.verdict(clock.index, leg))));
}

const limitText = (value, limit) =>
  Number.isFinite(limit) && limit > 0 ? `${shown((100 * Math.abs(value)) / limit, 3)} %` : "none";

// Pace: if frames are slow, as without a GPU, edges are smooth only at rest, and while the clock runs, texts, tables,
// and lines in the curves follow the machine ten times per second.

const pace = {
  moved: -Infinity,
  gaps: [],
  slow: true,
  failed: false,
  drawnRough: false,
  moving: () => clock.playing || state.twist !== null || performance.now() - pace.moved < 150,
  rough: () => pace.slow && pace.moving(),
  written: -Infinity,
  writes() {
    const now = performance.now();
    const due = !pace.slow || !clock.playing || now - pace.written > 100;
    if (due) pace.written = now;
    return due;
  },
  // Fast drawing until frames are fast; fast drawing permanently after slow smooth frames.
  count(gap) {
    if (!pace.moving() || pace.failed) return;
    pace.gaps.push(gap);
    if (pace.gaps.length < 12) return;
    const late = pace.gaps.sort((a, b) => a - b)[6] > 22;
    pace.failed = late && !pace.slow;
    pace.slow = late;
    pace.gaps = [];
  },
};
const byHand = () => {
  pace.moved = performance.now();
  repaint();
};

// Machine

let pen = null;
let ribbon = null;
try {
  pen = new Pen(canvas);
  ribbon = new Ribbon(machine, motion);
} catch (error) {
  find("trouble").textContent = `The machine can't be drawn: ${error.message}. Curves and tables are below.`;
  find("trouble").hidden = false;
}

let style = null;
function readStyle() {
  const colors = {};
  for (const name of ["paper", "ink", "base", "platform", "joint", "fixed", "ghost", "ribbon", "warn", "open"])
    colors[name] = themeColor(`--${name}`);
  colors.axes = ["--axis-x", "--axis-y", "--axis-z"].map((name) => themeColor(name));
  style = { colors, ink: colors.ink };
}

// Parts of the canvas, one for each displayed set of forces.
function pictures() {
  const [wide, high] = [canvas.clientWidth, canvas.clientHeight];
  const count = Math.max(1, state.shown.length);
  return Array.from({ length: count }, (_, k) =>
    wide >= high
      ? { x: (k * wide) / count, y: 0, width: wide / count, height: high }
      : { x: 0, y: (k * high) / count, width: wide, height: high / count },
  );
}

function poseShown() {
  return state.twist ? state.twist.pose : motion.pose(clock.index);
}

function paint() {
  if (!pen || pen.gl.isContextLost()) return;
  const pose = poseShown();
  const parts = pictures();
  camera.fit(parts[0].width / parts[0].height);
  const { right, upward, back } = camera.axes();
  const sun = unit(add(add(times(back, 1), times(upward, 0.7)), times(right, -0.35)));
  const smooth = !pace.rough();
  pace.drawnRough = !smooth;
  pen.begin(style.colors.paper, smooth);
  parts.forEach((picture, k) => {
    const set = state.shown[k];
    const force = Array.from({ length: 6 }, (_, leg) => {
      const rgb = set ? forceColor(forceOf(set, clock.index, leg), page.scale) : [150, 150, 150];
      return [...rgb.map((each) => each / 255), 1];
    });
    const scene = sceneAt(machine, pose, { ...state, colors: style.colors, force, verdicts: verdicts(set) });
    if (state.ribbon && motion.count > 1) ribbon.add(scene, clock.index, style.colors.ribbon);
    pen.draw(scene, picture, camera.matrix(picture.width / picture.height), { ...style, sun });
  });
  pen.end();
  if (state.wordy) label(pose, parts);
}

// Numbers of the legs and names of axes, as text over the picture.
const labels = find("labels");
const spare = [];
function label(pose, parts) {
  let used = 0;
  const put = (text, at, kind) => {
    if (!spare[used]) labels.append((spare[used] = document.createElement("span")));
    const span = spare[used++];
    // Unchanged text is not written, because the browser repaints written text.
    if (span.textContent !== text) span.textContent = text;
    if (span.className !== kind) span.className = kind;
    span.at = at;
    span.style.transform = `translate(${at[0].toFixed(1)}px, ${at[1].toFixed(1)}px) translate(-50%, -50%)`;
    if (span.hidden) span.hidden = false;
  };
  const write = (text, point, picture, kind) => {
    const at = camera.pixel(point, picture);
    if (at && at[0] > picture.x + 4 && at[0] < picture.x + picture.width - 4) put(text, at, kind);
  };
  const middle = times(machine.b.reduce(add), 1 / 6);
  const { back } = camera.axes();
  parts.forEach((picture, k) => {
    for (let leg = 0; leg < 6; leg++) {
      const from = minus(machine.b[leg], middle);
      const at = along(along(machine.b[leg], unit(from), 3.2 * machine.thick), machine.up, -1.5 * machine.thick);
      // Numbers behind the machine are pale, because parts in front have their own.
      write(String(leg + 1), at, picture, dot(from, back) < 0 ? "leg behind" : "leg");
    }
    if (state.frames)
      for (let i = 0; i < 3; i++) {
        const axis = [0, 1, 2].map((each) => (each === i ? 1 : 0));
        write("xyz"[i], times(axis, 1.15 * machine.axis), picture, "axis");
        write("xyz"[i] + "\u2032", along(pose.t, column(pose.R, i), 1.15 * machine.axis), picture, "axis");
      }
    if (parts.length > 1) put(state.shown[k], [picture.x + 40, picture.y + 18], "set");
  });
  for (const span of spare.slice(used)) if (!span.hidden) span.hidden = true;
}

// The leg under a point of the canvas, or null; and the set of forces of that part.
function legAt(x, y) {
  const parts = pictures();
  const k = parts.findIndex((each) => x >= each.x && x < each.x + each.width && y >= each.y && y < each.y + each.height);
  if (k < 0) return null;
  const pose = poseShown();
  let [best, nearest] = [null, 12];
  for (let leg = 0; leg < 6; leg++) {
    const { base, tip } = legFrame(machine, pose, leg);
    const [a, b] = [base, tip].map((point) => camera.pixel(point, parts[k]));
    if (!a || !b) continue;
    const way = [b[0] - a[0], b[1] - a[1]];
    const share = ((x - a[0]) * way[0] + (y - a[1]) * way[1]) / Math.max(1e-9, way[0] ** 2 + way[1] ** 2);
    const at = Math.max(0, Math.min(1, share));
    const off = Math.hypot(x - a[0] - at * way[0], y - a[1] - at * way[1]);
    if (off < nearest) [best, nearest] = [leg, off];
  }
  return best === null ? null : { leg: best, set: state.shown[k] };
}

const tip = find("tip");
canvas.addEventListener("pointermove", (event) => {
  const box = canvas.getBoundingClientRect();
  const found = event.buttons ? null : legAt(event.clientX - box.left, event.clientY - box.top);
  tip.hidden = !found;
  if (!found) return;
  const i = clock.index;
  const lines = [`leg ${found.leg + 1}`, `length\u2002${quantities.length.text(i, found.leg)}`];
  if (found.set) lines.push(`force, ${found.set}\u2002${quantities.forces[found.set].text(i, found.leg)}`);
  tip.textContent = lines.join("\n");
  const [x, y] = [event.clientX - box.left, event.clientY - box.top];
  tip.style.left = `${Math.min(x + 14, box.width - tip.offsetWidth - 4)}px`;
  tip.style.top = `${Math.min(y + 14, box.height - tip.offsetHeight - 4)}px`;
});
canvas.addEventListener("pointerleave", () => (tip.hidden = true));

// Curves

const LEG_COLORS = ["--leg-1", "--leg-2", "--leg-3", "--leg-4", "--leg-5", "--leg-6"];
const distinct = (values) => [...new Set(values.filter((each) => Number.isFinite(each) && each !== 0))];
const perLeg = (name, factor = 1, dashed = false, ending = "") =>
  legs.map((leg) => ({
    name: `leg ${leg + 1}${ending}`,
    leg,
    color: LEG_COLORS[leg],
    dashed,
    column: motion.columns[name],
    deviations: motion.columns[`${name}_std`],
    factor,
  }));
const panels = [];
function addPanel(name, options) {
  panels.push(new Panel(find(name), motion, clock, options));
}
if (sets.length) {
  const series = sets.flatMap((set, k) => perLeg(`F_${set}`, 1, k > 0, sets.length > 1 ? `, ${set}` : ""));
  addPanel("forces", { series, limits: distinct(forceLimits.flatMap((each) => [each, -each])), unit: "N" });
  panels[0].cut = page.cut === null ? undefined : page.cut;
} else find("forces").hidden = true;
const lengthLimit = distinct(lengthLimits.flat()).map((each) => each * units.length);
addPanel("lengths", { series: perLeg("L", units.length), limits: lengthLimit, unit: units.lengthName, digits: 6 });
const speeds = distinct(speedLimits.flatMap((each) => [each, -each])).map((each) => each * units.length);
addPanel("speeds", { series: perLeg("L_dot", units.length), limits: speeds, unit: `${units.lengthName}/s` });
const conditions = [{ name: "condition number", color: "--text", column: motion.columns.condition, factor: 1 }];
addPanel("conditions", { series: conditions, logarithmic: true, unit: "" });

for (const leg of legs) {
  const button = document.createElement("button");
  button.type = "button";
  button.textContent = `leg ${leg + 1}`;
  button.className = `leg-${leg + 1}`;
  button.setAttribute("aria-pressed", "true");
  button.addEventListener("click", () => {
    const on = button.getAttribute("aria-pressed") !== "true";
    button.setAttribute("aria-pressed", String(on));
    for (const panel of panels) {
      panel.hidden[on ? "delete" : "add"](leg);
      panel.draw();
    }
  });
  find("legs").append(button);
}

// Tables

const asCell = (quantity) => ({
  head: quantity.head,
  text: (i, leg) => ({ words: quantity.text(i, leg), verdict: quantity.verdict(i, leg) }),
});
const forces = Object.values(quantities.forces);
const columns = forces.map(asCell);
if (sets.length && distinct(forceLimits).length)
  columns.push({
    head: "of its limit",
    text: (i, leg) => ({
      words: limitText(forces[0].value(i, leg), forceLimits[leg]),
      verdict: forces[0].verdict(i, leg),
    }),
  });
columns.push(asCell(quantities.length), asCell(quantities.speed));
const fillLegs = legTable(find("now"), columns);
// Many columns, and numbers with standard deviations, take the width of the page.
const noisy = Object.keys(motion.columns).some((name) => name.endsWith("_std"));
find("now").closest(".tables").classList.toggle("single", noisy || columns.length > 4);
// Maximum of the whole motion with its status, and additional text.
const asPeak = (quantity, more) => {
  const at = quantity.peaks();
  const worst = legs.map((leg) => quantity.worst(leg));
  return {
    head: `peak ${quantity.head}`,
    text: (_, leg) => ({ words: more(quantity.text(at[leg], leg, 4), at[leg], leg), verdict: worst[leg] }),
  };
};
const withTime = (text, i) => `${text} at ${clock.text(motion.time[i])}`;
legTable(find("peaks"), [...forces, quantities.speed].map((each) => asPeak(each, withTime)))(0);
const motors = page.motors;
for (const name of ["motors", "motors-whole"]) find(name).hidden = !motors;
const fillMotors = legTable(find("motors-now"), motorQuantities.map(asCell));
if (motors) {
  const rated = motors.rated.map(number);
  const meanSquare = {
    head: "RMS torque",
    text: (_, leg) => ({
      words: ofLimit(amount(motors.rms[leg], motors.rmsDeviation?.[leg] ?? NaN, "N m", 4), rated[leg]),
      verdict: motors.rmsVerdict[leg],
    }),
  };
  const besideLimit = (each) => asPeak(each, (text, _, leg) => ofLimit(text, each.limits[leg]));
  legTable(find("motors-peaks"), [...motorQuantities.map(besideLimit), meanSquare])(0);
}
const fillNow = (index) => {
  fillLegs(index);
  fillMotors(index);
};

// Clock and controls

const slider = find("time");
slider.max = String(motion.duration || 1);
slider.disabled = !(motion.duration > 0);
const seekBySlider = () => {
  const since = Number(slider.value);
  endTwist();
  clock.pause();
  clock.seek(motion.start + since);
};
slider.addEventListener("input", seekBySlider);
const STEPS = { ArrowLeft: -1, ArrowDown: -1, ArrowRight: 1, ArrowUp: 1, PageUp: 10, PageDown: -10, Home: -Infinity, End: Infinity };
slider.addEventListener("keydown", (event) => {
  if (!(event.key in STEPS) || event.ctrlKey || event.metaKey || event.altKey) return;
  event.preventDefault();
  endTwist();
  clock.step(STEPS[event.key]);
});

let announced = "";
clock.onChange((index) => {
  repaint();
  const next = clock.playing ? "Pause" : "Play";
  if (find("play").textContent !== next) find("play").textContent = next;
  state.wordy = pace.writes();
  if (!state.wordy) return;
  const time = motion.time[index];
  const text = clock.text(time);
  slider.value = String(time - motion.start);
  slider.setAttribute("aria-valuetext", `${text}, condition number ${shown(motion.condition(index), 4)}`);
  find("at").textContent = text;
  find("condition").textContent = shown(motion.condition(index), 5);
  const fixed = !clock.playing && text !== announced && announced !== "";
  if (fixed) find("said").textContent = `${text}, condition number ${shown(motion.condition(index), 4)}`;
  announced = text;
  for (const panel of panels) panel.follow(index);
  fillNow(index);
});

const press = (name, action) => find(name).addEventListener("click", action);
const toggle = () => {
  endTwist();
  if (clock.playing) clock.pause();
  else clock.play();
};
press("play", toggle);
press("back", () => (endTwist(), clock.step(-1)));
press("forward", () => (endTwist(), clock.step(1)));
find("speed").addEventListener("change", (event) => (clock.speed = Number(event.target.value)));
for (const name of ["home", "front", "side", "top"])
  press(`view-${name}`, () => {
    camera.reset(name);
    repaint();
  });
for (const name of ["skeleton", "frames", "ribbon"])
  find(name).addEventListener("change", (event) => {
    state[name] = event.target.checked;
    repaint();
  });
const choice = find("sets");
for (const set of sets.length > 1 ? [...sets, "side by side"] : []) choice.append(new Option(set, set));
find("choice").hidden = sets.length < 2;
choice.addEventListener("change", () => {
  state.shown = choice.value === "side by side" ? sets : [choice.value];
  find("stage").classList.toggle("double", state.shown.length > 1);
  resize();
});

const flip = (id) => {
  find(id).checked = !find(id).checked;
  find(id).dispatchEvent(new Event("change"));
};
const KEYS = {
  " ": toggle,
  k: toggle,
  ",": () => (endTwist(), clock.step(-1)),
  ".": () => (endTwist(), clock.step(1)),
  Home: () => (endTwist(), clock.step(-Infinity)),
  End: () => (endTwist(), clock.step(Infinity)),
  s: () => flip("skeleton"),
  f: () => flip("frames"),
  r: () => flip("ribbon"),
  n: () => nextEvent(),
};
document.addEventListener("keydown", (event) => {
  const busy = event.target.closest("button, input, select, summary");
  if (event.ctrlKey || event.metaKey || event.altKey || (busy && !(event.target.type === "range")) || !KEYS[event.key]) return;
  event.preventDefault();
  KEYS[event.key]();
});

// Singular poses and their unconstrained twist

const marks = find("marks");
const list = find("events");
motion.events.forEach((event, number) => {
  const share = motion.duration > 0 ? (event.time - motion.start) / motion.duration : 0;
  const mark = document.createElement("i");
  mark.className = event.singular ? "singular" : "near";
  mark.style.left = `${100 * share}%`;
  marks.append(mark);
  const item = document.createElement("li");
  const button = document.createElement("button");
  button.type = "button";
  button.setAttribute("aria-pressed", "false");
  button.textContent = `${event.singular ? "singular" : "largest condition number"} at ${event.text} s`;
  button.addEventListener("click", () => (state.twist?.number === number ? endTwist() : showTwist(number)));
  const text = document.createElement("span");
  text.textContent = event.words;
  item.append(button, " ", text);
  list.append(item);
});
find("singular").hidden = !motion.events.length;
find("kind").textContent = motion.events.some(({ singular }) => singular)
  ? "Singular poses"
  : "Nearest to a singular pose";

function showTwist(number) {
  const event = motion.events[number];
  clock.pause();
  clock.seek(event.time);
  state.twist = { number, pose: event.pose, vector: event.twist, axis: event.axis, point: event.point, share: 0 };
  // With reduced motion, the platform is displayed at the end of the twist.
  state.wave = still.matches ? Math.PI / 2 : 0;
  pressEvents();
}

function endTwist() {
  state.twist = null;
  pressEvents();
}

function pressEvents() {
  [...list.querySelectorAll("button")].forEach((button, i) =>
    button.setAttribute("aria-pressed", String(state.twist?.number === i)),
  );
  repaint();
}

function nextEvent() {
  if (!motion.events.length) return;
  showTwist(((state.twist?.number ?? -1) + 1) % motion.events.length);
}

// Legend, theme, sizes, print

const legend = find("legend");
legend.hidden = !sets.length;
find("bar").style.background = gradient();
find("low").textContent = `${shown(-page.scale, 4)} N`;
find("high").textContent = `${shown(page.scale, 4)} N`;
for (const limit of distinct(forceLimits))
  for (const side of [-1, 1])
    if (limit <= page.scale) {
      const mark = document.createElement("i");
      mark.style.left = `${50 + (50 * side * limit) / page.scale}%`;
      mark.title = `limit ${shown(side * limit, 4)} N`;
      find("bar").append(mark);
    }
const limits = distinct(forceLimits);
find("limit").textContent = limits.length ? `limit ${limits.map((each) => shown(each, 4)).join(", ")} N` : "no force limit";

// Colors of status codes other than within_limit that occur in the motion.
const found = new Set([...forces, ...others].flatMap((each) => legs.map((leg) => each.worst(leg))));
for (const [name, words, has] of [
  ["--warn", "limit exceeded", found.has(EXCEEDED)],
  ["--open", "inconclusive noise ?", DOUBTFUL.some((each) => found.has(each))],
]) {
  if (!has) continue;
  const item = document.createElement("span");
  const mark = document.createElement("i");
  mark.style.background = `var(${name})`;
  item.append(mark, words);
  find("verdicts").append(item);
}

const dark = matchMedia("(prefers-color-scheme: dark)");
function setTheme(name) {
  document.documentElement.dataset.theme = name;
  find("theme").textContent = name === "dark" ? "Light" : "Dark";
  readStyle();
  redraw();
}
press("theme", () => setTheme(document.documentElement.dataset.theme === "dark" ? "light" : "dark"));
dark.addEventListener("change", () => setTheme(dark.matches ? "dark" : "light"));

function redraw() {
  for (const panel of panels) panel.draw();
  drawStrip(find("strip"), motion);
  paint();
}
function resize() {
  redraw();
  repaint();
}
new ResizeObserver(resize).observe(document.body);
// On paper the page is light, and the machine is a plain picture with labels, because WebGL content would be late.
let before = null;
addEventListener("beforeprint", () => {
  before = document.documentElement.dataset.theme;
  setTheme("light");
  const copy = find("printed");
  [copy.width, copy.height] = [canvas.width, canvas.height];
  const brush = copy.getContext("2d");
  brush.drawImage(canvas, 0, 0);
  const ratio = canvas.width / canvas.clientWidth;
  brush.scale(ratio, ratio);
  brush.font = `600 14px ${themeText("--font")}`;
  brush.textAlign = "center";
  brush.textBaseline = "middle";
  brush.fillStyle = themeText("--text");
  for (const { textContent, at } of spare.filter(({ hidden }) => !hidden)) brush.fillText(textContent, ...at);
});
addEventListener("afterprint", () => setTheme(before ?? "light"));

handle(camera, canvas, byHand);
canvas.addEventListener("webglcontextlost", (event) => event.preventDefault());
canvas.addEventListener("webglcontextrestored", () => {
  pen.prepare();
  repaint();
});

// Runs while something moves; otherwise it draws only changes.
const seen = { frames: 0, last: null };
function frame(now) {
  const seconds = seen.last === null ? 0 : Math.min(0.25, (now - seen.last) / 1000);
  seen.last = now;
  pace.count(1000 * seconds);
  if (pace.drawnRough && !pace.moving()) repaint();
  if (clock.playing) clock.pass(seconds);
  if (state.twist) {
    if (!still.matches) state.wave += 2.4 * seconds;
    state.twist.share = machine.swing * Math.sin(state.wave);
    repaint();
  }
  if (state.dirty) {
    state.dirty = false;
    paint();
    seen.frames += 1;
  }
  requestAnimationFrame(frame);
}

document.documentElement.dataset.theme = dark.matches ? "dark" : "light";
find("theme").textContent = dark.matches ? "Light" : "Dark";
readStyle();
clock.seek(motion.start);
if (motion.duration > 0 && !still.matches) clock.play();
requestAnimationFrame(frame);

// For tests and for the browser console.
window.viewer = { page, motion, clock, camera, state, seen, panels, pictures, showTwist, endTwist };
