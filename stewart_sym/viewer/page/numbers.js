// Numbers as text.

const MINUS = "\u2212";

// A number with a number of significant digits, and with an exponent only if the text is long without one.
export function shown(value, digits = 5) {
  if (!Number.isFinite(value)) return value > 0 ? "\u221e" : "\u2013";
  if (value === 0) return "0";
  const text = isLong(value) ? value.toExponential(digits - 1) : value.toFixed(decimals(value, digits));
  return text.replace("-", MINUS);
}

// Value of one unit in the last place; 0 for 0.
export function lastPlace(value, digits) {
  return 10 ** (isLong(value) ? power(value) - digits + 1 : -decimals(value, digits));
}

export const power = (value) => Math.floor(Math.log10(Math.abs(value)));
const isLong = (value) => power(value) >= 7 || power(value) < -4;
const decimals = (value, digits) => Math.max(0, Math.min(10, digits - 1 - power(value)));

// Values of axis ticks: multiples of 1, 2, or 5 times a power of ten, about as many as requested, at
// least two.
export function ticks(low, high, count) {
  const raw = (high - low) / Math.max(1, count);
  if (!(raw > 0) || !Number.isFinite(raw)) return [low];
  const ten = 10 ** Math.floor(Math.log10(raw));
  const steps = [0.5, 1, 2, 5, 10].map((each) => each * ten);
  for (let s = steps.findIndex((each) => each >= raw * 0.999); ; s--) {
    const found = multiples(steps[s], low, high);
    if (found.length > 1 || s === 0) return found;
  }
}

function multiples(step, low, high) {
  const found = [];
  for (let k = Math.ceil(low / step - 1e-9); k * step <= high + 1e-9 * step; k++) found.push(k * step);
  return found;
}

// Text of ticks, all with the decimals that distinguish them.
export function tickTexts(values) {
  if (values.length < 2) return values.map((value) => shown(value, 3));
  const largest = Math.max(...values.map(Math.abs));
  const [power, last] = [largest, values[1] - values[0]].map((each) => Math.floor(Math.log10(each) + 1e-9));
  if (largest >= 1e6 || largest < 1e-3)
    return values.map((value) => (value === 0 ? "0" : value.toExponential(power - last).replaceAll("-", MINUS)));
  return values.map((value) => value.toFixed(Math.max(0, -last)).replace("-", MINUS));
}
