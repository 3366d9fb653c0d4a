// Where the parts of the machine are at a pose: the legs' frames, rings of points, what a twist does to a pose.

import { add, along, column, cross, minus, product, rotationAbout, size, times, turn, unit } from "./vectors.js";

// Frame of a leg at a pose: origin at the base point, x along the leg, y across the universal joint's fixed axis k,
// as in the equations: y = (k x s) / |k x s|. Lower and upper part turn with it.
export function legFrame(machine, pose, leg) {
  const base = machine.b[leg];
  const tip = add(pose.t, turn(pose.R, machine.p[leg]));
  const S = minus(tip, base);
  const x = unit(S);
  const y = unit(cross(machine.k[leg], x), column(pose.R, 1));
  return { base, tip, x, y, z: cross(x, y), length: size(S) };
}

// Platform points at a pose in the order of their ring.
export function ring(points, order, pose) {
  return order.map((i) => (pose ? add(pose.t, turn(pose.R, points[i])) : points[i]));
}

// A pose moved by a share, s, of a twist [v; omega], m/s and rad/s, about the reference point.
export function moved(pose, twist, share) {
  return {
    t: along(pose.t, twist.slice(0, 3), share),
    R: product(rotationAbout(times(twist.slice(3), share)), pose.R),
  };
}

// Point of the trajectory: the tool's, which is the reference point where the robot has no other.
export const toolPoint = (machine, pose) => add(pose.t, turn(pose.R, machine.tool));
