// Colors of forces: blue if a leg pulls, red if it pushes, light near zero.

const STEPS = [
  [33, 102, 172],
  [103, 169, 207],
  [209, 229, 240],
  [247, 247, 247],
  [253, 219, 199],
  [239, 138, 98],
  [178, 24, 43],
];
const UNKNOWN = [128, 128, 128];

// Color, 0 to 255, of a force on a scale from -scale to scale (N); larger forces have the color of the end.
export function forceColor(force, scale) {
  if (!Number.isFinite(force)) return UNKNOWN;
  const share = scale > 0 ? Math.max(-1, Math.min(1, force / scale)) : 0;
  const at = ((share + 1) / 2) * (STEPS.length - 1);
  const i = Math.min(Math.floor(at), STEPS.length - 2);
  return STEPS[i].map((low, k) => Math.round(low + (STEPS[i + 1][k] - low) * (at - i)));
}

// The scale as a CSS gradient.
export function gradient() {
  return `linear-gradient(to right, ${STEPS.map((rgb) => `rgb(${rgb.join(" ")})`).join(", ")})`;
}

// Color of a style sheet variable as numbers from 0 to 1; it depends on the theme.
export function themeColor(name, opacity = 1) {
  const text = getComputedStyle(document.documentElement).getPropertyValue(name).trim();
  const value = parseInt(text.slice(1), 16);
  return [((value >> 16) & 255) / 255, ((value >> 8) & 255) / 255, (value & 255) / 255, opacity];
}

export function themeText(name) {
  return getComputedStyle(document.documentElement).getPropertyValue(name).trim();
}
