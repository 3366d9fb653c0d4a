// Curves over time: forces, lengths, speeds, and the condition number, with limits. Each pixel column is drawn from its
// smallest to its largest value, so that no peak of a long motion is missed.

import { themeText } from "./colors.js";
import { shown, ticks, tickTexts } from "./numbers.js";
import { amount } from "./quantities.js";

const LEFT = 64;
const RIGHT = 12;
const TOP = 8;
const BOTTOM = 26;
const SUPERSCRIPTS = "\u2070\u00b9\u00b2\u00b3\u2074\u2075\u2076\u2077\u2078\u2079";

export class Panel {
  // figure: element with a canvas; series: { name, column, deviations, factor, color, dashed, leg } with the values of
  // the column, or of its leg, times the factor; limits: numbers.
  constructor(figure, motion, clock, { series, limits = [], logarithmic = false, unit, digits = 5 }) {
    Object.assign(this, { figure, motion, clock, series, limits, logarithmic, unit, digits });
    this.canvas = figure.querySelector("canvas");
    this.plot = figure.querySelector(".plot");
    this.cursor = figure.querySelector(".cursor");
    this.tip = figure.querySelector(".tip");
    this.outside = document.createElement("small");
    figure.querySelector("figcaption").append(" ", this.outside);
    this.hidden = new Set();
    this.measure();
    this.watch();
  }

  watch() {
    const { plot, clock } = this;
    let held = false;
    const seek = (event) => clock.seek(this.timeAt(event.clientX - plot.getBoundingClientRect().left));
    plot.addEventListener("pointerdown", (event) => {
      if (event.pointerType === "mouse" && event.button) return;
      held = true;
      clock.pause();
      seek(event);
    });
    plot.addEventListener("pointermove", (event) => {
      if (held && event.buttons) seek(event);
      this.point(event);
    });
    for (const end of ["pointerup", "pointercancel", "pointerleave"])
      plot.addEventListener(end, () => {
        held = false;
        if (end === "pointerleave") this.tip.hidden = true;
      });
  }

  // Size of the plot area, read once per drawing, because each reading may trigger a new page layout.
  measure() {
    this.width = this.canvas.clientWidth - LEFT - RIGHT;
    this.height = this.canvas.clientHeight - TOP - BOTTOM;
  }

  timeAt(x) {
    const { start, duration } = this.motion;
    return start + (duration * Math.max(0, Math.min(this.width, x - LEFT))) / Math.max(1, this.width);
  }

  place(time) {
    const { start, duration } = this.motion;
    return LEFT + (duration > 0 ? ((time - start) / duration) * this.width : 0);
  }

  // Values at the sample under the pointer.
  point(event) {
    const box = this.plot.getBoundingClientRect();
    const i = this.motion.nearest(this.timeAt(event.clientX - box.left));
    const lines = this.visible().map((each) => {
      const off = each.deviations ? each.deviations[6 * i + each.leg] * each.factor : NaN;
      return `${each.name}\u2002${amount(valueOf(each, i), off, this.unit, this.digits)}`;
    });
    this.tip.textContent = [this.clock.text(this.motion.time[i]), ...lines].join("\n");
    this.tip.hidden = false;
    const x = this.place(this.motion.time[i]);
    const left = x > box.width / 2 ? x - this.tip.offsetWidth - 10 : x + 10;
    this.tip.style.left = `${Math.max(0, left)}px`;
  }

  visible() {
    return this.series.filter(({ leg }) => leg === undefined || !this.hidden.has(leg));
  }

  // Moves the line of the clock to its place.
  follow(index) {
    this.cursor.style.transform = `translateX(${this.place(this.motion.time[index])}px)`;
  }

  draw() {
    this.measure();
    const pen = sheet(this.canvas);
    const drawn = this.visible().map((each) => ({ ...each, columns: this.columns(each) }));
    this.choose(drawn);
    this.sayOutside();
    this.axes(pen);
    pen.save();
    pen.beginPath();
    pen.rect(LEFT, TOP, this.width, this.height);
    pen.clip();
    this.bounds(pen);
    for (const each of drawn) this.curve(pen, each);
    pen.restore();
    this.follow(this.clock.index);
  }

  // Limits that are too far from the curves to be drawn, as text in the heading.
  sayOutside() {
    const far = this.limits.filter((each) => this.scaled(each) < this.low || this.scaled(each) > this.high);
    const texts = far.map((each) => {
      if (!far.includes(-each)) return shown(each, 4);
      return each > 0 ? `\u00b1${shown(each, 4)}` : null;
    });
    const words = texts.filter((each) => each !== null).join(", ");
    this.outside.textContent = words && `limit ${words} ${this.unit}, outside the picture`;
  }

  scaled(value) {
    return this.logarithmic ? Math.log10(Math.min(value, 1e16)) : value;
  }

  // Position of each sample and its pixel column, computed once per width.
  places() {
    if (this.placed?.width === this.width) return this.placed;
    const { time, count } = this.motion;
    const [at, pixels] = [new Float32Array(count), new Int32Array(count)];
    for (let i = 0; i < count; i++) {
      at[i] = this.place(time[i]);
      pixels[i] = Math.round(at[i]);
    }
    this.placed = { width: this.width, at, pixels };
    return this.placed;
  }

  // Smallest, largest, first, and last value of a series in each pixel column, and a flag for the start of
  // a curve.
  columns(series) {
    const { at, pixels } = this.places();
    const found = [];
    let last = null;
    let pixel = -1;
    for (let i = 0; i < at.length; i++) {
      const value = this.scaled(valueOf(series, i));
      if (!Number.isFinite(value)) last = null;
      else if (last !== null && pixels[i] === pixel) {
        if (value < last.low) last.low = value;
        if (value > last.high) last.high = value;
        last.end = value;
      } else {
        last = { x: at[i], low: value, high: value, first: value, end: value, begins: last === null };
        pixel = pixels[i];
        found.push(last);
      }
    }
    return found;
  }

  // Range of the values, including limits that are not far outside.
  choose(drawn) {
    let [low, high] = [Infinity, -Infinity];
    for (const { columns } of drawn)
      for (const each of columns) {
        low = Math.min(low, each.low);
        high = Math.max(high, each.high);
      }
    if (low > high) [low, high] = [0, 1];
    if (this.cut !== undefined) [low, high] = [Math.max(low, -this.cut), Math.min(high, this.cut)];
    const reach = high - low || Math.abs(high) || 1;
    for (const each of this.limits.map((limit) => this.scaled(limit)))
      if (each > low - 0.6 * reach && each < high + 0.6 * reach) [low, high] = [Math.min(low, each), Math.max(high, each)];
    const least = 1e-6 * Math.max(Math.abs(low), Math.abs(high));
    const margin = Math.max(0.05 * (high - low), least) || 1;
    [this.low, this.high] = [low - margin, high + margin];
  }

  y(value) {
    return TOP + this.height * (1 - (value - this.low) / (this.high - this.low));
  }

  axes(pen) {
    pen.font = `12px ${themeText("--font")}`;
    pen.fillStyle = themeText("--quiet");
    pen.strokeStyle = themeText("--grid");
    pen.lineWidth = 1;
    pen.textAlign = "right";
    pen.textBaseline = "middle";
    const levels = this.levels();
    levels.forEach(([value, text]) => {
      const y = Math.round(this.y(value)) + 0.5;
      line(pen, LEFT, y, LEFT + this.width, y);
      pen.fillText(text, LEFT - 6, y, LEFT - 8);
    });
    const { start, duration } = this.motion;
    const times = ticks(start, start + duration, Math.max(2, this.width / 90));
    pen.textAlign = "center";
    pen.textBaseline = "top";
    tickTexts(times).forEach((text, i) => {
      const x = Math.round(this.place(times[i])) + 0.5;
      line(pen, x, TOP, x, TOP + this.height);
      pen.fillText(i === times.length - 1 ? `${text} s` : text, Math.min(x, LEFT + this.width - 8), TOP + this.height + 6);
    });
  }

  levels() {
    if (!this.logarithmic) {
      const values = ticks(this.low, this.high, this.height / 34);
      const texts = tickTexts(values);
      return values.map((value, i) => [value, texts[i]]);
    }
    if (this.high - this.low < 1) {
      const values = ticks(10 ** this.low, 10 ** this.high, this.height / 34);
      const texts = tickTexts(values);
      return values.map((value, i) => [Math.log10(value), texts[i]]).filter(([value]) => value >= this.low);
    }
    const steps = this.high - this.low < 2.5 ? [1, 2, 5] : [1];
    const found = [];
    const every = Math.max(1, Math.ceil((this.high - this.low) / 6));
    for (let power = Math.floor(this.low); power <= this.high; power++)
      for (const step of steps) {
        const value = power + Math.log10(step);
        if (value >= this.low && value <= this.high && (steps.length > 1 || power % every === 0))
          found.push([value, powerText(step, power)]);
      }
    return found;
  }

  // Limits as dashed lines, singular poses as vertical lines.
  bounds(pen) {
    pen.strokeStyle = themeText("--warn");
    pen.lineWidth = 1.5;
    pen.setLineDash([6, 4]);
    for (const limit of this.limits) line(pen, LEFT, this.y(this.scaled(limit)), LEFT + this.width, this.y(this.scaled(limit)));
    pen.setLineDash([2, 3]);
    for (const event of this.motion.events)
      if (event.singular) line(pen, this.place(event.time), TOP, this.place(event.time), TOP + this.height);
    pen.setLineDash([]);
  }

  curve(pen, { columns, color, dashed }) {
    pen.strokeStyle = themeText(color);
    pen.lineWidth = 1.6;
    pen.setLineDash(dashed ? [5, 3] : []);
    pen.beginPath();
    for (const { x, low, high, first, end, begins } of columns) {
      if (begins) pen.moveTo(x, this.y(first));
      else pen.lineTo(x, this.y(first));
      if (low !== high) {
        pen.lineTo(x, this.y(low));
        pen.lineTo(x, this.y(high));
        pen.lineTo(x, this.y(end));
      }
    }
    if (columns.length === 1) pen.arc(columns[0].x, this.y(columns[0].first), 2, 0, 7);
    pen.stroke();
    pen.setLineDash([]);
  }
}

function valueOf({ column, factor, leg }, i) {
  return leg === undefined ? column[i] : column[6 * i + leg] * factor;
}

// A step times a power of ten; large powers are written above the axis.
function powerText(step, power) {
  if (power < 5 && power > -4) return shown(step * 10 ** power, 1);
  const above = [...String(power)].map((letter) => (letter === "-" ? "\u207b" : SUPERSCRIPTS[letter])).join("");
  return `${step === 1 ? "" : `${step}\u00b7`}10${above}`;
}

function line(pen, x, y, right, low) {
  pen.beginPath();
  pen.moveTo(x, y);
  pen.lineTo(right, low);
  pen.stroke();
}

// Empty canvas with the size of its element in page pixels. It is drawn by the CPU, because compiling GPU programs
// takes longer than drawing a few curves.
function sheet(canvas) {
  const ratio = window.devicePixelRatio || 1;
  const [wide, high] = [canvas.clientWidth, canvas.clientHeight];
  canvas.width = Math.round(wide * ratio);
  canvas.height = Math.round(high * ratio);
  const pen = canvas.getContext("2d", { willReadFrequently: true });
  pen.setTransform(ratio, 0, 0, ratio, 0, 0);
  return pen;
}

// Condition number along the time line, from the smallest to the largest, on a logarithmic scale.
export function drawStrip(canvas, motion) {
  const [wide, high] = [canvas.clientWidth, canvas.clientHeight];
  const pen = sheet(canvas);
  const heights = new Float64Array(Math.max(1, Math.ceil(wide))).fill(NaN);
  let [least, most] = [Infinity, -Infinity];
  for (let i = 0; i < motion.count; i++) {
    const value = Math.log10(Math.min(motion.condition(i), 1e16));
    if (!Number.isFinite(value)) continue;
    [least, most] = [Math.min(least, value), Math.max(most, value)];
    const share = motion.duration > 0 ? (motion.time[i] - motion.start) / motion.duration : 0;
    const x = Math.min(heights.length - 1, Math.round(share * (heights.length - 1)));
    heights[x] = Math.max(value, heights[x] || -Infinity);
  }
  pen.fillStyle = themeText("--strip");
  let last = heights.find(Number.isFinite);
  const range = Math.max(most - least, 1);
  for (let x = 0; x < heights.length; x++) {
    if (Number.isFinite(heights[x])) last = heights[x];
    const tall = 0.15 * high + (0.8 * high * (last - least)) / range;
    pen.fillRect(x, high - tall, 1, tall);
  }
}
