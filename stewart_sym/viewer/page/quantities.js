// Quantities of legs and motors at each sample: values, standard deviations due to noise, and status of limits.

import { lastPlace, power, shown } from "./numbers.js";

// Status codes of limits; within_limit is 0.
export const DOUBTFUL = [1, 2];
export const EXCEEDED = 3;

const DEVIATION_DIGITS = 2;

export class Quantity {
  // column: its name; factors: of the six legs, for the column's values; name: of its status codes.
  constructor(motion, { head, unit, column, factors = [1, 1, 1, 1, 1, 1], name = column, digits = 5, limits = [] }) {
    Object.assign(this, { motion, head, unit, column, factors, name, digits, limits });
  }

  value(i, leg) {
    return this.motion.ofLeg(this.column, i, leg) * this.factors[leg];
  }

  // NaN if the noise does not affect the displayed digits.
  deviation(i, leg) {
    return this.motion.ofLeg(`${this.column}_std`, i, leg) * Math.abs(this.factors[leg]);
  }

  verdict(i, leg) {
    return this.motion.verdicts[this.name]?.[6 * i + leg] ?? 0;
  }

  // For the whole motion.
  worst(leg) {
    let found = 0;
    for (let i = 0; i < this.motion.count; i++) found = Math.max(found, this.verdict(i, leg));
    return found;
  }

  // Sample of the largest magnitude of each leg.
  peaks() {
    return [0, 1, 2, 3, 4, 5].map((leg) => {
      let [best, most] = [0, -1];
      for (let i = 0; i < this.motion.count; i++) {
        const size = Math.abs(this.value(i, leg));
        if (size > most) [best, most] = [i, size];
      }
      return best;
    });
  }

  text(i, leg, digits = this.digits) {
    return amount(this.value(i, leg), this.deviation(i, leg), this.unit, digits);
  }
}

// Mechanical power, the product of torque and speed.
class Power extends Quantity {
  constructor(motion, torque, speed, options) {
    super(motion, { column: "power", ...options });
    this.value = (i, leg) => torque.value(i, leg) * speed.value(i, leg);
  }
}

// A value with its standard deviation, rounded to the digits of the deviation; or alone if it affects no digit.
export function amount(value, deviation, unit, digits = 5) {
  if (!Number.isFinite(value)) return "\u2013";
  const reaches = deviation > 0 && deviation >= 0.5 * lastPlace(value, digits);
  if (!reaches) return `${shown(value, digits)} ${unit}`;
  const known = power(value) - power(deviation) + DEVIATION_DIGITS;
  return `${shown(value, Math.max(1, Math.min(digits, known || 1)))} \u00b1 ${shown(deviation, DEVIATION_DIGITS)} ${unit}`;
}

// The same with its limit, if there is one, which may be on the next line.
export function ofLimit(text, limit) {
  if (!Number.isFinite(limit)) return text;
  return `${text.replaceAll(" ", "\u00a0")} of\u00a0${Number(limit.toPrecision(6))}`;
}

// Quantities of the legs: forces by formulation, length, and speed.
export function ofLegs(motion, sets, { length, lengthName }) {
  const factors = Array(6).fill(length);
  const forces = Object.fromEntries(
    sets.map((set) => [set, new Quantity(motion, { head: sets.length > 1 ? `force, ${set}` : "force", unit: "N", column: `F_${set}` })]),
  );
  return {
    forces,
    length: new Quantity(motion, { head: "length", unit: lengthName, column: "L", factors, digits: 6 }),
    speed: new Quantity(motion, { head: "speed", unit: `${lengthName}/s`, column: "L_dot", factors }),
  };
}

// Quantities of the motors; none for a robot without a drive.
export function ofMotors(motion, motors) {
  if (!motors) return [];
  const limits = Object.fromEntries(
    Object.entries(motors.limits).map(([name, values]) => [name, values.map((each) => each ?? Infinity)]),
  );
  const own = motion.columns.speed ? { column: "speed" } : { column: "L_dot", factors: motors.turns, name: "speed" };
  const currents = { column: "torque", factors: motors.constant.map((each) => (each > 0 ? 1 / each : NaN)), name: "current" };
  const torque = new Quantity(motion, { head: "torque", unit: "N m", column: "torque", limits: limits.torque });
  const speed = new Quantity(motion, { head: "speed", unit: "rad/s", ...own, limits: limits.speed });
  const current = new Quantity(motion, { head: "current", unit: "A", ...currents, limits: limits.current });
  const power = new Power(motion, torque, speed, { head: "shaft power", unit: "W", limits: limits.power });
  return motors.constant.some((each) => each > 0) ? [torque, speed, current, power] : [torque, speed, power];
}
