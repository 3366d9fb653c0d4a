// Numbers as text.

const MINUS = "\u2212";

// A number with so many significant digits, and an exponent only where it is long without.
export function shown(value, digits = 5) {
  if (!Number.isFinite(value)) return value > 0 ? "\u221e" : "\u2013";
  if (value === 0) return "0";
  const power = Math.floor(Math.log10(Math.abs(value)));
  const text =
    power >= 7 || power < -4
      ? value.toExponential(digits - 1)
      : value.toFixed(Math.max(0, Math.min(10, digits - 1 - power)));
  return text.replace("-", MINUS);
}

// Values at which an axis is numbered: a few multiples of 1, 2 or 5 times a power of ten.
export function ticks(low, high, count) {
  const raw = (high - low) / Math.max(1, count);
  if (!(raw > 0) || !Number.isFinite(raw)) return [low];
  const ten = 10 ** Math.floor(Math.log10(raw));
  const step = [1, 2, 5, 10].map((each) => each * ten).find((each) => each >= raw * 0.999);
  const found = [];
  for (let k = Math.ceil(low / step - 1e-9); k * step <= high + 1e-9 * step; k++) found.push(k * step);
  return found;
}

// Text of ticks, all with the decimals that tell them apart.
export function tickTexts(values) {
  if (values.length < 2) return values.map((value) => shown(value, 3));
  const step = values[1] - values[0];
  const largest = Math.max(...values.map(Math.abs));
  if (largest >= 1e5) {
    const digits = Math.max(0, Math.ceil(Math.log10(largest / step) - 1e-9));
    return values.map((value) => (value === 0 ? "0" : value.toExponential(Math.min(digits, 3)).replace("-", MINUS)));
  }
  const decimals = Math.max(0, -Math.floor(Math.log10(step) + 1e-9));
  return values.map((value) => value.toFixed(Math.min(decimals, 10)).replace("-", MINUS));
}
