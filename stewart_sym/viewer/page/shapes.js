// Triangles of the shapes that form the machine, each of size one: position, normal, and direction of the outline.
// A tube and a bar extend from 0 to 1 along x; around: number of sides of round shapes.

function shape() {
  return { numbers: [], corners: [] };
}

function vertex(found, position, normal, hull) {
  found.numbers.push(...position, ...normal, ...hull);
  return found.numbers.length / 9 - 1;
}

export function tube(around) {
  const found = shape();
  const half = Math.SQRT1_2;
  for (let i = 0; i <= around; i++) {
    const angle = (2 * Math.PI * i) / around;
    const [y, z] = [Math.cos(angle), Math.sin(angle)];
    for (const [x, out] of [[0, -1], [1, 1]]) {
      vertex(found, [x, y, z], [0, y, z], [out * half, y * half, z * half]);
      vertex(found, [x, y, z], [out, 0, 0], [out * half, y * half, z * half]);
    }
  }
  const ends = [0, 1].map((x) => vertex(found, [x, 0, 0], [2 * x - 1, 0, 0], [2 * x - 1, 0, 0]));
  for (let i = 0; i < around; i++) {
    const [a, b] = [4 * i, 4 * (i + 1)];
    found.corners.push(a, b, a + 2, b, b + 2, a + 2);
    found.corners.push(ends[0], b + 1, a + 1, ends[1], a + 3, b + 3);
  }
  return found;
}

export function ball(around) {
  const found = shape();
  const rows = around / 2;
  for (let j = 0; j <= rows; j++)
    for (let i = 0; i <= around; i++) {
      const [turn, tilt] = [(2 * Math.PI * i) / around, (Math.PI * j) / rows];
      const at = [Math.sin(tilt) * Math.cos(turn), Math.sin(tilt) * Math.sin(turn), Math.cos(tilt)];
      vertex(found, at, at, at);
    }
  for (let j = 0; j < rows; j++)
    for (let i = 0; i < around; i++) {
      const [a, b] = [j * (around + 1) + i, (j + 1) * (around + 1) + i];
      found.corners.push(a, b, a + 1, b, b + 1, a + 1);
    }
  return found;
}

export function bar() {
  const found = shape();
  const third = 1 / Math.sqrt(3);
  const at = (corner) => [(corner[0] + 1) / 2, corner[1], corner[2]];
  for (const axis of [0, 1, 2])
    for (const side of [-1, 1]) {
      const normal = [0, 0, 0];
      normal[axis] = side;
      const first = found.numbers.length / 9;
      for (const [u, v] of [[-1, -1], [1, -1], [1, 1], [-1, 1]]) {
        const corner = [...normal];
        corner[(axis + 1) % 3] = u;
        corner[(axis + 2) % 3] = v;
        vertex(found, at(corner), normal, corner.map((each) => each * third));
      }
      const order = side > 0 ? [0, 1, 2, 0, 2, 3] : [0, 2, 1, 0, 3, 2];
      found.corners.push(...order.map((i) => first + i));
    }
  return found;
}

// Model matrix that maps a shape's x, y, and z axes to three vectors at a point.
export function placed(origin, x, y, z) {
  return [...x, 0, ...y, 0, ...z, 0, ...origin, 1];
}
