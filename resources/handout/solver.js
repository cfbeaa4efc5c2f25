// The matroid method in fractions: rates of all joints from those of the inputs, by elimination on the rows
// of P (with those of engaged couplings below it).

// rows: [[joint, Rational]...] each; inputs: joints. K by joint and input; null where the inputs are not
// valid for these rows.
const gainsOf = (rows, joints, inputs) => {
  const column = new Map(inputs.map((joint, i) => [joint, i]));
  const outputs = [];
  for (let joint = 0; joint < joints; ++joint) if (!column.has(joint)) outputs.push(joint);
  const place = new Map(outputs.map((joint, i) => [joint, i]));
  const table = rows.map(row => {
    const left = Array(outputs.length).fill(ZERO);
    const right = Array(inputs.length).fill(ZERO);
    for (const [joint, value] of row) {
      if (column.has(joint)) right[column.get(joint)] = right[column.get(joint)].minus(value);
      else left[place.get(joint)] = left[place.get(joint)].plus(value);
    }
    return left.concat(right);
  });
  let rank = 0;
  for (let at = 0; at < outputs.length; ++at) {
    const pivot = table.findIndex((row, i) => i >= rank && !row[at].isZero());
    if (pivot < 0) return null;
    [table[rank], table[pivot]] = [table[pivot], table[rank]];
    const size = table[rank][at];
    table[rank] = table[rank].map(value => value.over(size));
    for (let i = 0; i < table.length; ++i) {
      if (i === rank || table[i][at].isZero()) continue;
      const factor = table[i][at];
      table[i] = table[i].map((value, j) => value.minus(factor.times(table[rank][j])));
    }
    ++rank;
  }
  // A row that is left and is not zero ties the inputs to each other.
  if (table.slice(rank).some(row => row.some(value => !value.isZero()))) return null;
  const gains = [];
  for (let joint = 0; joint < joints; ++joint) {
    gains.push(column.has(joint) ? inputs.map(input => new Rational(input === joint ? 1n : 0n))
                                 : table[place.get(joint)].slice(outputs.length));
  }
  return gains;
};

const ratesOf = (gains, speeds) =>
    gains.map(row => row.reduce((sum, gain, i) => sum.plus(gain.times(speeds[i])), ZERO));

// The least T > 0 that makes every rate times T whole; null where nothing turns.
const periodOf = rates => {
  let above = 0n, below = 1n;  // gcd of the rates = above / below
  for (const rate of rates) {
    if (rate.isZero()) continue;
    const numerator = gcd(above * rate.denominator, rate.numerator * below);
    const sum = new Rational(numerator, below * rate.denominator);
    above = sum.numerator;
    below = sum.denominator;
  }
  return above === 0n ? null : new Rational(below, above);
};
