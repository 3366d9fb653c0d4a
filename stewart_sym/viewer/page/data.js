// Data of the page: the machine as plain values, the motion as columns of numbers in base 64.

import { rotationOf } from "./vectors.js";

function bytesOf(text) {
  if (Uint8Array.fromBase64) return Uint8Array.fromBase64(text);
  const letters = atob(text);
  const found = new Uint8Array(letters.length);
  for (let i = 0; i < letters.length; i++) found[i] = letters.charCodeAt(i);
  return found;
}

function columnOf({ kind, data }) {
  const bytes = bytesOf(data);
  return kind === "f8" ? new Float64Array(bytes.buffer) : new Float32Array(bytes.buffer);
}

// Parses the data block of the file; columns become arrays of numbers.
export function readPage() {
  const page = JSON.parse(document.getElementById("data").textContent);
  for (const name of Object.keys(page.columns)) page.columns[name] = columnOf(page.columns[name]);
  return page;
}

// Status codes of limits at each sample for the six legs: 0 except in the runs [leg, first, after, code].
function spread(runs, count) {
  const found = new Uint8Array(6 * count);
  for (const [leg, first, after, verdict] of runs) for (let i = first; i < after; i++) found[6 * i + leg] = verdict;
  return found;
}

// A motion of the machine. Every sample is kept; only drawings omit some.
export class Motion {
  constructor(page) {
    this.columns = page.columns;
    this.time = page.columns.time;
    this.count = this.time.length;
    this.start = this.time[0];
    this.duration = this.time[this.count - 1] - this.start;
    this.events = page.events;
    this.verdicts = {};
    for (const [name, runs] of Object.entries(page.verdicts)) this.verdicts[name] = spread(runs, this.count);
  }

  // Returns the index of the sample nearest to a time (s).
  nearest(time) {
    let low = 0;
    let high = this.count - 1;
    while (high - low > 1) {
      const middle = (low + high) >> 1;
      if (this.time[middle] <= time) low = middle;
      else high = middle;
    }
    return time - this.time[low] <= this.time[high] - time ? low : high;
  }

  // For legs with offsets also their chains: at(name, leg) is one of their points or axes.
  pose(i) {
    const { t, q, moving } = this.columns;
    return {
      t: [t[3 * i], t[3 * i + 1], t[3 * i + 2]],
      R: rotationOf([q[4 * i], q[4 * i + 1], q[4 * i + 2], q[4 * i + 3]]),
      at: moving && ((name, leg) => [...this.columns[name].subarray(18 * i + 3 * leg, 18 * i + 3 * leg + 3)]),
    };
  }

  // Value of L, L_dot, or a force of a leg.
  ofLeg(name, i, leg) {
    const values = this.columns[name];
    return values ? values[6 * i + leg] : NaN;
  }

  condition(i) {
    return this.columns.condition[i];
  }
}
