// Vectors as arrays of three numbers, rotations as three rows, matrices for WebGL column by column.

export const add = (a, b) => [a[0] + b[0], a[1] + b[1], a[2] + b[2]];
export const minus = (a, b) => [a[0] - b[0], a[1] - b[1], a[2] - b[2]];
export const times = (a, s) => [a[0] * s, a[1] * s, a[2] * s];
export const along = (a, b, s) => [a[0] + b[0] * s, a[1] + b[1] * s, a[2] + b[2] * s];
export const dot = (a, b) => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
export const cross = (a, b) => [
  a[1] * b[2] - a[2] * b[1],
  a[2] * b[0] - a[0] * b[2],
  a[0] * b[1] - a[1] * b[0],
];
export const size = (a) => Math.hypot(a[0], a[1], a[2]);

export function unit(a, otherwise = [0, 0, 1]) {
  const length = size(a);
  return length > 0 ? times(a, 1 / length) : otherwise;
}

// A unit vector normal to a unit vector.
export function across(a) {
  const axis = Math.abs(a[0]) < 0.8 ? [1, 0, 0] : [0, 1, 0];
  return unit(cross(a, axis));
}

export const turn = (R, a) => [dot(R[0], a), dot(R[1], a), dot(R[2], a)];
export const column = (R, i) => [R[0][i], R[1][i], R[2][i]];

export function product(A, B) {
  return A.map((row) => [0, 1, 2].map((j) => row[0] * B[0][j] + row[1] * B[1][j] + row[2] * B[2][j]));
}

// Rotation of a unit quaternion, scalar first.
export function rotationOf([w, x, y, z]) {
  return [
    [1 - 2 * (y * y + z * z), 2 * (x * y - w * z), 2 * (x * z + w * y)],
    [2 * (x * y + w * z), 1 - 2 * (x * x + z * z), 2 * (y * z - w * x)],
    [2 * (x * z - w * y), 2 * (y * z + w * x), 1 - 2 * (x * x + y * y)],
  ];
}

// Rotation about a vector by its magnitude (rad).
export function rotationAbout(vector) {
  const angle = size(vector);
  const half = times(unit(vector), Math.sin(angle / 2));
  return rotationOf([Math.cos(angle / 2), ...half]);
}

// Product of two 4 x 4 matrices.
export function product4(A, B) {
  const found = new Float32Array(16);
  for (let j = 0; j < 4; j++)
    for (let i = 0; i < 4; i++)
      for (let k = 0; k < 4; k++) found[4 * j + i] += A[4 * k + i] * B[4 * j + k];
  return found;
}
