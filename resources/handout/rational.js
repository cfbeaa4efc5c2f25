// Fractions of any size, as the program has them: -16/27.

const gcd = (a, b) => {
  a = a < 0n ? -a : a;
  b = b < 0n ? -b : b;
  while (b) [a, b] = [b, a % b];
  return a;
};

class Rational {
  constructor(numerator, denominator = 1n) {
    if (denominator === 0n) throw new RangeError('division by zero');
    if (denominator < 0n) [numerator, denominator] = [-numerator, -denominator];
    const common = gcd(numerator, denominator) || 1n;
    this.numerator = numerator / common;
    this.denominator = denominator / common;
  }
  // "2", "-3/4", "0.75", "0,75"; null for anything else.
  static from(text) {
    const words = String(text).trim().replace(/[\u2212\u2013]/g, '-').replace(',', '.');
    const fraction = /^([+-]?\d{1,30})\s*\/\s*(\d{1,30})$/.exec(words);
    if (fraction) {
      const below = BigInt(fraction[2]);
      return below === 0n ? null : new Rational(BigInt(fraction[1]), below);
    }
    const decimal = /^([+-]?)(\d{0,30})(?:\.(\d{0,30}))?$/.exec(words);
    if (!decimal || !(decimal[2] || decimal[3])) return null;
    const digits = decimal[3] || '';
    const value = BigInt((decimal[2] || '0') + digits);
    return new Rational(decimal[1] === '-' ? -value : value, 10n ** BigInt(digits.length));
  }
  plus(other) {
    return new Rational(this.numerator * other.denominator + other.numerator * this.denominator,
                        this.denominator * other.denominator);
  }
  minus(other) { return this.plus(other.negated()); }
  times(other) {
    return new Rational(this.numerator * other.numerator, this.denominator * other.denominator);
  }
  over(other) {
    return new Rational(this.numerator * other.denominator, this.denominator * other.numerator);
  }
  negated() { return new Rational(-this.numerator, this.denominator); }
  isZero() { return this.numerator === 0n; }
  toNumber() {
    // Digits beyond those of a double are cut off both first: each of them may be larger than a double holds.
    const excess = Math.max(0, this.denominator.toString(2).length - 1000);
    return Number(this.numerator >> BigInt(excess)) / Number(this.denominator >> BigInt(excess));
  }
  // With at most this many decimals, ties to even.
  toDecimals(digits) {
    const scaled = this.numerator * 10n ** BigInt(digits);
    const size = scaled < 0n ? -scaled : scaled;
    let whole = size / this.denominator;
    const rest = 2n * (size % this.denominator);
    if (rest > this.denominator || (rest === this.denominator && whole % 2n)) ++whole;
    const text = whole.toString().padStart(digits + 1, '0');
    const decimals = text.slice(text.length - digits).replace(/0+$/, '');
    return (scaled < 0n && whole ? '\u2212' : '') + text.slice(0, text.length - digits) + (decimals ? '.' + decimals : '');
  }
  toString() {
    const sign = this.numerator < 0n ? '\u2212' : '';
    const size = this.numerator < 0n ? -this.numerator : this.numerator;
    return sign + size + (this.denominator === 1n ? '' : '/' + this.denominator);
  }
}
const ZERO = new Rational(0n);
