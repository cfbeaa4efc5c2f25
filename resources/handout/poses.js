// Where the links are: each turns against what carries it about the line of its joint, as it lies in the
// reference pose. A pose {r, t} is the displacement from there: x goes to r x + t, r by rows.

const AT_REST = {r: [1, 0, 0, 0, 1, 0, 0, 0, 1], t: [0, 0, 0]};

const moved = ({r, t}, [x, y, z]) => [r[0] * x + r[1] * y + r[2] * z + t[0], r[3] * x + r[4] * y + r[5] * z + t[1],
                                      r[6] * x + r[7] * y + r[8] * z + t[2]];

// First `second`, then `first`.
const after = (first, second) => {
  const r = [];
  for (let row = 0; row < 3; ++row) {
    for (let column = 0; column < 3; ++column) {
      r.push(first.r[3 * row] * second.r[column] + first.r[3 * row + 1] * second.r[3 + column] +
             first.r[3 * row + 2] * second.r[6 + column]);
    }
  }
  return {r, t: moved(first, second.t)};
};

const turnedAbout = (point, [x, y, z], angle) => {
  const c = Math.cos(angle), s = Math.sin(angle), d = 1 - c;
  const r = [c + d * x * x, d * x * y - s * z, d * x * z + s * y, d * x * y + s * z, c + d * y * y, d * y * z - s * x,
             d * x * z - s * y, d * y * z + s * x, c + d * z * z];
  const there = moved({r, t: [0, 0, 0]}, point);
  return {r, t: point.map((each, i) => each - there[i])};
};

// movers by link, null for the ground; angles by joint, rad. Poses by link.
const posesOf = (movers, angles) => {
  const poses = Array(movers.length).fill(null);
  poses[0] = AT_REST;
  for (let link = 1; link < movers.length; ++link) {
    const way = [];  // up to a link whose pose is known
    for (let at = link; !poses[at]; at = movers[at].parent) way.push(at);
    for (const at of way.reverse()) {
      const {parent, joint, sense, point, direction} = movers[at];
      poses[at] = after(poses[parent], turnedAbout(point, direction, sense * angles[joint]));
    }
  }
  return poses;
};
