// How the joints turn with time. Time is counted in 2 pi s, so that a joint of rate w makes w turns in it: turns
// stay fractions, and nothing drifts however long the train runs.

const MICRO = 1000000n;

class Motion {
  // joints: their limits "low" and "high", rad, where they have any.
  constructor(gains, speeds, joints) {
    this.gains = gains;
    this.joints = joints;
    this.start = speeds.map(() => ZERO);  // turns of the inputs when `time` was 0
    this.time = ZERO;
    this.take(speeds);
  }
  // The train goes on from where it is.
  take(speeds) {
    if (this.speeds) this.start = this.inputTurns();
    this.time = ZERO;
    this.speeds = speeds;
    this.rates = ratesOf(this.gains, speeds);
    this.period = periodOf(this.rates);
  }
  toReference() {
    this.start = this.speeds.map(() => ZERO);
    this.time = ZERO;
  }
  inputTurns() { return this.start.map((turns, i) => turns.plus(this.speeds[i].times(this.time))); }
  jointTurns() { return ratesOf(this.gains, this.inputTurns()); }
  // rad, within half a turn of 0.
  angles() {
    return this.jointTurns().map(turns => {
      const rest = ((turns.numerator % turns.denominator) + turns.denominator) % turns.denominator;
      const part = new Rational(rest, turns.denominator).toNumber();
      return 2 * Math.PI * (part > 0.5 ? part - 1 : part);
    });
  }
  // The times, in 2 pi s, that the limits of joints leave: {from, to, fromJoint, toJoint}; infinite, and -1, where
  // there is none.
  range() {
    const range = {from: -Infinity, to: Infinity, fromJoint: -1, toJoint: -1};
    const starts = ratesOf(this.gains, this.start);
    this.joints.forEach(({low = -Infinity, high = Infinity}, joint) => {
      const rate = this.rates[joint].toNumber();
      if (rate === 0) return;
      const start = starts[joint].toNumber();
      const ends = [low, high].map(limit => (limit / (2 * Math.PI) - start) / rate).sort((a, b) => a - b);
      if (ends[0] > range.from) [range.from, range.fromJoint] = [ends[0], joint];
      if (ends[1] < range.to) [range.to, range.toJoint] = [ends[1], joint];
    });
    return range;
  }
  // To this time, a number, or as near as the limits allow. The joint that is at its limit; -1: none.
  goTo(time) {
    const range = this.range();
    const stopped = time > range.to ? range.toJoint : time < range.from ? range.fromJoint : -1;
    const allowed = Math.max(range.from, Math.min(range.to, time));
    // Towards the reference pose, so that rounding never passes a limit.
    if (Number.isFinite(allowed)) this.time = new Rational(BigInt(Math.trunc(allowed * Number(MICRO))), MICRO);
    return stopped;
  }
}
