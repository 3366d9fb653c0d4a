// Visible objects at a sample: solids, lines, and sheets in the base frame. Sizes are relative to the machine.

import { add, along, column, cross, minus, size, times, unit } from "./vectors.js";
import { legFrame, moved, ring, toolPoint } from "./machine.js";
import { DOUBTFUL, EXCEEDED } from "./quantities.js";
import { placed } from "./shapes.js";

const RIBBON_STEPS = 100;

// look: colors by name, force colors of the six legs, status of their limits, and the options.
export function sceneAt(machine, pose, look) {
  const scene = { solids: { tube: [], ball: [], bar: [] }, lines: [], sheets: [], overlaid: look.skeleton };
  const draw = look.skeleton ? skeleton : bodies;
  draw(scene, machine, pose, look);
  frames(scene, machine, pose, look);
  if (look.twist) ghost(scene, machine, look);
  return scene;
}

function bodies(scene, machine, pose, look) {
  const { colors } = look;
  plate(scene, machine, ring(machine.b, machine.baseRing), colors.base, 0.45);
  plate(scene, machine, ring(machine.p, machine.platformRing, pose), colors.platform, 1);
  for (let leg = 0; leg < 6; leg++) {
    const frame = legFrame(machine, pose, leg);
    lowerPart(scene, machine, frame, leg, look);
    upperPart(scene, machine, frame, leg, look);
    if (machine.universal) joint(scene, machine, frame, leg, colors);
    else knob(scene, frame.base, 1.25 * machine.thick, colors.joint);
    knob(scene, frame.point || frame.tip, 1.05 * machine.thick, colors.joint);
    if (frame.point) offsets(scene, machine, frame, colors);
  }
}

// Connections of axes that do not intersect: from the base point to the moving axis, from there to the prismatic axis,
// and from its end to the platform point.
function offsets(scene, machine, frame, colors) {
  for (const [from, to] of [[frame.joint, frame.moving], [frame.moving, frame.base], [frame.tip, frame.point]])
    strut(scene, from, to, 0.5 * machine.thick, colors.joint);
}

function strut(scene, from, to, radius, color) {
  const way = minus(to, from);
  if (size(way) < 0.1 * radius) return;
  const x = unit(way);
  const y = unit(cross(x, Math.abs(x[0]) < 0.8 ? [1, 0, 0] : [0, 1, 0]));
  tube(scene, from, { x, y, z: cross(x, y) }, size(way), radius, color, 1);
}

function tube(scene, from, frame, length, radius, color, lit) {
  const [x, y, z] = [times(frame.x, length), times(frame.y, radius), times(frame.z, radius)];
  scene.solids.tube.push([...placed(from, x, y, z), ...color, lit]);
}

function knob(scene, at, radius, color) {
  const axes = [[radius, 0, 0], [0, radius, 0], [0, 0, radius]];
  scene.solids.ball.push([...placed(at, ...axes), ...color, 1]);
}

// A key along a part, on the side of its y axis: it shows the spin.
function key(scene, from, frame, length, out, wide, color) {
  const origin = along(from, frame.y, out);
  const axes = [times(frame.x, length), times(frame.y, wide), times(frame.z, wide)];
  scene.solids.bar.push([...placed(origin, ...axes), ...color, 1]);
}

function collarColor({ colors }, verdict) {
  if (verdict === EXCEEDED) return colors.warn;
  return DOUBTFUL.includes(verdict) ? colors.open : colors.joint;
}

// The lower part: a tube from the base point, with a collar at its end, whose color warns of a limit.
function lowerPart(scene, machine, frame, leg, look) {
  const { thick } = machine;
  const length = machine.lower[leg];
  const from = along(frame.base, frame.x, 1.6 * thick);
  tube(scene, from, frame, length - 1.6 * thick, thick, look.force[leg], 0);
  const collar = collarColor(look, look.verdicts[leg]);
  tube(scene, along(frame.base, frame.x, length - 0.7 * thick), frame, 0.7 * thick, 1.22 * thick, collar, 1);
  if (machine.universal)
    key(scene, along(frame.base, frame.x, 2 * thick), frame, length - 3 * thick, thick, 0.22 * thick, look.colors.joint);
}

// The upper part: a rod down from the platform point, equally long in every pose. A thin rod continues it if it ends
// before the lower part, as in robot files that define bodies without a connection.
function upperPart(scene, machine, frame, leg, look) {
  const { thick } = machine;
  const length = machine.upper[leg];
  const turned = frame.up ? { x: frame.x, y: frame.up, z: cross(frame.x, frame.up) } : frame;
  tube(scene, along(frame.tip, frame.x, -length), frame, length, 0.55 * thick, look.force[leg], 0);
  const open = frame.length - length - machine.lower[leg];
  if (open > 0) tube(scene, along(frame.base, frame.x, machine.lower[leg]), frame, open, 0.3 * thick, look.colors.joint, 1);
  if (machine.universal)
    key(scene, along(frame.tip, frame.x, -length), turned, length - 1.1 * thick, 0.55 * thick, 0.14 * thick, look.colors.joint);
}

// The cross of a universal joint: one bar along the fixed axis k, one along the moving axis y, at its position.
function joint(scene, machine, frame, leg, colors) {
  const { thick } = machine;
  const k = machine.k[leg];
  for (const [axis, color] of [[k, colors.fixed], [frame.y, colors.joint]]) {
    const side = unit(cross(axis, frame.x), frame.z);
    const bars = { x: axis, y: side, z: cross(axis, side) };
    const middle = axis === k ? frame.joint || frame.base : frame.moving || frame.base;
    tube(scene, along(middle, axis, -1.9 * thick), bars, 3.8 * thick, 0.42 * thick, color, 1);
  }
}

// A thin plate through a ring of points, whose rim is a tube.
function plate(scene, machine, points, color, opacity) {
  const middle = times(points.reduce(add), 1 / points.length);
  const numbers = [];
  points.forEach((point, i) => {
    const next = points[(i + 1) % points.length];
    const normal = unit(cross(minus(point, middle), minus(next, middle)));
    for (const corner of [middle, point, next]) numbers.push(...corner, ...normal, ...color.slice(0, 3), opacity);
    const side = minus(next, point);
    if (size(side) > 0.05 * machine.thick) {
      const x = unit(side);
      const y = unit(cross(x, normal), normal);
      tube(scene, point, { x, y, z: cross(x, y) }, size(side), 0.45 * machine.thick, color, 1);
    }
  });
  scene.sheets.push({ numbers: new Float32Array(numbers), clear: opacity < 1 });
}

// Lines only: each leg from its base point to its platform point, on a darker line for contrast.
function skeleton(scene, machine, pose, look) {
  const { colors } = look;
  outline(scene, ring(machine.b, machine.baseRing), colors.base, 2);
  outline(scene, ring(machine.p, machine.platformRing, pose), colors.platform, 2);
  for (let leg = 0; leg < 6; leg++) {
    const { base, tip, joint, moving, point } = legFrame(machine, pose, leg);
    for (const [from, to] of point ? [[joint, moving], [moving, base], [tip, point]] : [])
      scene.lines.push([...from, ...to, ...colors.joint, 2]);
    scene.lines.push([...base, ...tip, ...colors.ink, 5], [...base, ...tip, ...look.force[leg], 3]);
  }
}

function outline(scene, points, color, wide) {
  points.forEach((point, i) => scene.lines.push([...point, ...points[(i + 1) % points.length], ...color, wide]));
}

// Base frame, reference frame, and tool frame if it differs.
function frames(scene, machine, pose, look) {
  if (!look.frames) return;
  const long = machine.axis;
  const origins = [[0, 0, 0], pose.t];
  if (size(machine.tool) > 0) {
    origins.push(toolPoint(machine, pose));
    scene.lines.push([...pose.t, ...origins[2], ...look.colors.ghost, 1]);
  }
  origins.forEach((origin, which) => {
    for (let i = 0; i < 3; i++) {
      const axis = which ? column(pose.R, i) : [0, 1, 2].map((k) => (k === i ? 1 : 0));
      scene.lines.push([...origin, ...along(origin, axis, which === 2 ? 0.7 * long : long), ...look.colors.axes[i], 1.6]);
    }
  });
}

// The platform moved by the unconstrained twist, its legs, and the axis of the twist as a screw.
function ghost(scene, machine, { twist, colors }) {
  const there = moved(twist.pose, twist.vector, twist.share);
  outline(scene, ring(machine.p, machine.platformRing, there), colors.ghost, 2.2);
  for (let leg = 0; leg < 6; leg++) {
    const { base, tip } = legFrame(machine, there, leg);
    scene.lines.push([...base, ...tip, ...colors.ghost, 1.2]);
  }
  if (twist.axis) {
    const reach = 3 * machine.axis;
    const [from, to] = [-reach, reach].map((s) => along(twist.point, twist.axis, s));
    scene.lines.push([...from, ...to, ...colors.ghost, 1]);
  }
}

// The path of the tool point: a line, and a ribbon along the platform's y axis. The future path is pale.
export class Ribbon {
  constructor(machine, motion) {
    const steps = Math.min(motion.count, RIBBON_STEPS);
    this.at = Array.from({ length: steps }, (_, i) => Math.round((i * (motion.count - 1)) / Math.max(1, steps - 1)));
    this.edges = this.at.map((i) => {
      const pose = motion.pose(i);
      const [point, y] = [toolPoint(machine, pose), column(pose.R, 1)];
      const wide = 0.12 * machine.axis;
      return { point, left: along(point, y, -wide), right: along(point, y, wide), normal: column(pose.R, 2) };
    });
    const numbers = [];
    this.pairs((a, b) => {
      for (const corner of [a.left, a.right, b.left, a.right, b.right, b.left])
        numbers.push(...corner, ...a.normal, 0, 0, 0, 0);
    });
    this.numbers = new Float32Array(numbers);
  }

  pairs(each) {
    for (let i = 0; i + 1 < this.edges.length; i++) each(this.edges[i], this.edges[i + 1], i);
  }

  // Adds it to a scene, with one opacity for the samples up to an index and one after it.
  add(scene, index, [red, green, blue]) {
    this.pairs((a, b, i) => {
      const passed = this.at[i] < index;
      for (let corner = 0; corner < 6; corner++)
        this.numbers.set([red, green, blue, passed ? 0.6 : 0.2], 10 * (6 * i + corner) + 6);
      scene.lines.push([...a.point, ...b.point, red, green, blue, 1, passed ? 3 : 1.2]);
    });
    scene.sheets.push({ numbers: this.numbers, clear: true });
  }
}
