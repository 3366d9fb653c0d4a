// The camera: it looks at a target from a distance, rotated about the upward direction; and its controls.

import { across, add, along, cross, dot, minus, product4, times, unit } from "./vectors.js";

const FIELD = (32 * Math.PI) / 180;
// Fraction of half the picture that a machine fills in the first view.
const ROOM = 0.84;
const STEEPEST = (89 * Math.PI) / 180;
const HOME = { azimuth: (-60 * Math.PI) / 180, elevation: (18 * Math.PI) / 180 };
export const VIEWS = {
  home: HOME,
  front: { azimuth: -Math.PI / 2, elevation: 0 },
  side: { azimuth: 0, elevation: 0 },
  top: { azimuth: -Math.PI / 2, elevation: STEEPEST },
};

export class Camera {
  // up: unit vector; points: visible points; middle: their center; reach: their largest distance from it.
  constructor(up, points, middle, reach) {
    this.up = up;
    this.points = points;
    this.home = middle;
    this.reach = reach;
    // In the first view of a machine with z up, x points to the right.
    const first = Math.abs(up[0]) < 0.8 ? [1, 0, 0] : [0, 1, 0];
    this.right = unit(minus(first, times(up, dot(first, up))), across(up));
    this.front = cross(up, this.right);
    this.reset();
  }

  reset(view = "home") {
    Object.assign(this, VIEWS[view]);
    this.target = this.home;
    this.distance = (1.05 * this.reach) / Math.sin(FIELD / 2);
    this.untouched = true;
  }

  // Moves as close as all points allow in a picture of that aspect ratio, until the user has moved the camera.
  fit(aspect) {
    if (!this.untouched) return;
    const { right, upward, back } = this.axes();
    const [wide, high] = this.slopes(aspect);
    for (let round = 0; round < 3; round++) {
      const from = this.points.map((point) => minus(point, this.target));
      const spans = [[right, wide], [upward, high]].map(([axis, slope]) => {
        const each = from.map((point) => dot(point, axis));
        const middle = (Math.min(...each) + Math.max(...each)) / 2;
        this.target = along(this.target, axis, middle);
        return Math.max(...from.map((point, i) => Math.abs(each[i] - middle) / (ROOM * slope) + dot(point, back)));
      });
      this.distance = Math.max(...spans, 0.2 * this.reach);
    }
  }

  get eye() {
    const { azimuth, elevation } = this;
    const level = add(times(this.right, Math.cos(azimuth)), times(this.front, Math.sin(azimuth)));
    const from = add(times(level, Math.cos(elevation)), times(this.up, Math.sin(elevation)));
    return along(this.target, from, this.distance);
  }

  // Right, upward, and backward unit vectors of the picture.
  axes() {
    const back = unit(minus(this.eye, this.target));
    const right = unit(cross(this.up, back));
    return { right, upward: cross(back, right), back };
  }

  orbit(turned, raised) {
    this.untouched = false;
    this.azimuth += turned;
    this.elevation = Math.max(-STEEPEST, Math.min(STEEPEST, this.elevation + raised));
  }

  zoom(factor) {
    this.untouched = false;
    this.distance = Math.max(0.2 * this.reach, Math.min(30 * this.reach, this.distance * factor));
  }

  // Moves the target with the picture; fractions of its height.
  pan(x, y) {
    this.untouched = false;
    const { right, upward } = this.axes();
    const height = 2 * this.distance * Math.tan(FIELD / 2);
    this.target = along(along(this.target, right, -x * height), upward, y * height);
  }

  // Half the picture's width and height at unit distance: the machine fits in both directions.
  slopes(aspect) {
    const slope = Math.tan(FIELD / 2);
    return aspect >= 1 ? [slope * aspect, slope] : [slope, slope / aspect];
  }

  // Matrix from the base frame to clip coordinates, for a picture of that aspect ratio.
  matrix(aspect) {
    const { right, upward, back } = this.axes();
    const eye = this.eye;
    const [wide, high] = this.slopes(aspect);
    const near = 0.02 * this.distance;
    const far = this.distance + 60 * this.reach;
    const look = [right, upward, back];
    const view = new Float32Array(16);
    look.forEach((axis, row) => {
      for (let i = 0; i < 3; i++) view[4 * i + row] = axis[i];
      view[12 + row] = -dot(axis, eye);
    });
    view[15] = 1;
    const lens = new Float32Array(16);
    lens[0] = 1 / wide;
    lens[5] = 1 / high;
    lens[10] = (far + near) / (near - far);
    lens[11] = -1;
    lens[14] = (2 * far * near) / (near - far);
    return product4(lens, view);
  }

  // Pixel of a point in a picture { x, y, width, height }; null behind the camera.
  pixel(point, picture) {
    const { right, upward, back } = this.axes();
    const from = minus(point, this.eye);
    const depth = -dot(from, back);
    if (depth <= 0) return null;
    const [wide, high] = this.slopes(picture.width / picture.height);
    return [
      picture.x + (picture.width / 2) * (1 + dot(from, right) / (depth * wide)),
      picture.y + (picture.height / 2) * (1 - dot(from, upward) / (depth * high)),
    ];
  }
}

// Connects mouse, touch, and keyboard with the camera; calls `changed` after each move.
export function handle(camera, element, changed) {
  const fingers = new Map();
  element.addEventListener("pointerdown", (event) => {
    element.setPointerCapture(event.pointerId);
    fingers.set(event.pointerId, [event.clientX, event.clientY]);
  });
  for (const end of ["pointerup", "pointercancel", "lostpointercapture"])
    element.addEventListener(end, (event) => fingers.delete(event.pointerId));
  element.addEventListener("pointermove", (event) => {
    const before = fingers.get(event.pointerId);
    if (!before) return;
    const now = [event.clientX, event.clientY];
    const step = [now[0] - before[0], now[1] - before[1]];
    const height = element.clientHeight;
    if (fingers.size === 2) pinch(camera, fingers, event.pointerId, now, height);
    else if (event.shiftKey || event.buttons & 6) camera.pan(step[0] / height, step[1] / height);
    else camera.orbit((-step[0] / height) * Math.PI, (step[1] / height) * Math.PI);
    fingers.set(event.pointerId, now);
    changed();
  });
  element.addEventListener("contextmenu", (event) => event.preventDefault());
  element.addEventListener(
    "wheel",
    (event) => {
      event.preventDefault();
      camera.zoom(Math.exp(event.deltaY * (event.deltaMode ? 0.05 : 0.0015)));
      changed();
    },
    { passive: false },
  );
  element.addEventListener("keydown", (event) => {
    if (byKey(camera, event)) {
      event.preventDefault();
      event.stopPropagation();
      changed();
    }
  });
}

// Two fingers: their distance zooms, their center pans.
function pinch(camera, fingers, moving, now, height) {
  const [other] = [...fingers].filter(([id]) => id !== moving).map(([, place]) => place);
  const before = fingers.get(moving);
  const apart = (place) => Math.max(1, Math.hypot(place[0] - other[0], place[1] - other[1]));
  camera.zoom(apart(before) / apart(now));
  camera.pan((now[0] - before[0]) / 2 / height, (now[1] - before[1]) / 2 / height);
}

const ARROWS = { ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, 1], ArrowDown: [0, -1] };

function byKey(camera, event) {
  if (event.ctrlKey || event.metaKey || event.altKey) return false;
  const arrow = ARROWS[event.key];
  if (arrow && event.shiftKey) camera.pan(0.05 * arrow[0], -0.05 * arrow[1]);
  else if (arrow) camera.orbit((arrow[0] * Math.PI) / 36, (arrow[1] * Math.PI) / 36);
  else if (event.key === "+" || event.key === "=") camera.zoom(1 / 1.15);
  else if (event.key === "-") camera.zoom(1.15);
  else if (event.key === "0") camera.reset();
  else return false;
  return true;
}
