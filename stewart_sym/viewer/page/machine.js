// Positions of the machine's parts at a pose: leg frames, rings of points, and poses moved by a twist.

import { add, along, column, cross, minus, product, rotationAbout, size, times, turn, unit } from "./vectors.js";

// Frame of a leg at a pose: origin at the base point, x along the leg, y normal to the universal joint's fixed axis k,
// as in the equations: y = (k x s) / |k x s|. Lower and upper part turn with it.
// With offsets, the prismatic axis extends from the foot (base) to its end (tip); joint and point are the base point and
// the platform point, moving is the position of the second axis, and up is the direction across the upper part.
export function legFrame(machine, pose, leg) {
  if (pose.at) return chainFrame(machine, pose, leg);
  const base = machine.b[leg];
  const tip = add(pose.t, turn(pose.R, machine.p[leg]));
  const S = minus(tip, base);
  const x = unit(S);
  const y = unit(cross(machine.k[leg], x), column(pose.R, 1));
  return { base, tip, x, y, z: cross(x, y), length: size(S) };
}

function chainFrame(machine, pose, leg) {
  const [base, tip, moving, y, up] = ["foot", "end", "moving", "lower", "upper"].map((name) => pose.at(name, leg));
  const x = unit(minus(tip, base));
  const [joint, point] = [machine.b[leg], add(pose.t, turn(pose.R, machine.p[leg]))];
  return { base, tip, joint, point, moving, x, y, z: cross(x, y), up, length: size(minus(tip, base)) };
}

// Platform points at a pose in the order of their ring.
export function ring(points, order, pose) {
  return order.map((i) => (pose ? add(pose.t, turn(pose.R, points[i])) : points[i]));
}

// A pose moved by a fraction (s) of a twist [v; omega] (m/s, rad/s) about the reference point.
export function moved(pose, twist, share) {
  return {
    t: along(pose.t, twist.slice(0, 3), share),
    R: product(rotationAbout(times(twist.slice(3), share)), pose.R),
  };
}

// Point of the trajectory: the tool, or the reference point if the robot has no tool.
export const toolPoint = (machine, pose) => add(pose.t, turn(pose.R, machine.tool));
