// Reads what learners write, exactly as core/teaching/grading does (written_name.h, expression_reader.h, number_text.h,
// read_answer.h).

const MOST_BYTES = 200;
const DEEPEST = 30;
const HIGHEST_POWER = 20;
const HIGHEST_EXPONENT = 99;
const FEWEST_DIGITS = 3;  // of a decimal that may be rounded
const MOST_DIGITS = 1000;
const isDigit = letter => letter >= '0' && letter <= '9';
const isLetter = letter => /^[a-zA-Z]$/.test(letter);

// A number of a key: "-16/27", "12", "0.75". Each is read once: a question compares with the same few again and again.
const keyNumbers = new Map();
const keyNumber = text => {
  const known = keyNumbers.get(text);
  if (known) return known;
  const [above, below = '1'] = text.split('/');
  const [whole, places = ''] = above.split('.');
  const value = new Rational(BigInt((whole + places).replace('+', '')), BigInt(below) * 10n ** BigInt(places.length));
  keyNumbers.set(text, value);
  return value;
};
const isSame = (a, b) => a.numerator === b.numerator && a.denominator === b.denominator;
const isLess = (a, b) => a.numerator * b.denominator < b.numerator * a.denominator;

// A letter has at most three bytes, or four as two units of the text.
const isLong = text => text.length * 3 > MOST_BYTES && new TextEncoder().encode(text).length > MOST_BYTES;

// Signs of print, Greek letters and LaTeX, and what they are in plain notation; the first that fits counts.
const PLAIN = [
  ['\\dot{\\theta}', 'theta'], ['\\dot\\theta', 'theta'], ['\\theta', 'theta'], ['\u03b8\u0307', 'theta'],
  ['\u03b8', 'theta'], ['\\omega', 'w'], ['\u03c9', 'w'], ['\\cdot', '*'], ['\\times', '*'], ['\u00b7', '*'],
  ['\u22c5', '*'], ['\u00d7', '*'], ['\u2212', '-'], ['\u2013', '-'], ['\u00f7', '/'], ['\u2044', '/'], ['\u2010', '-'],
  ['\u2011', '-'], ['\\%', '%'], ['\\left', ''], ['\\right', ''], ['\\dfrac', '\\frac'], ['\\tfrac', '\\frac'],
  ['\\prime', '\''], ['\u2032', '\''], ['\u2033', '\'\''], ['\u2034', '\'\'\''], ['\\,', ' '], ['\\;', ' '], ['\\:', ' '],
  ['\\!', ''], ['\\ ', ' '], ['~', ' '], ['{,}', '.'], ['\u00a0', ' '], ['\u202f', ' '], ['\t', ' '], ['\u2080', '0'],
  ['\u2081', '1'], ['\u2082', '2'], ['\u2083', '3'], ['\u2084', '4'], ['\u2085', '5'], ['\u2086', '6'], ['\u2087', '7'],
  ['\u2088', '8'], ['\u2089', '9'], ['\\mathrm', ''], ['\\displaystyle', ''], ['$', ''], ['\\quad', ' '], ['.*', '*'],
];
const plainNotation = text => {
  let plain = '';
  for (let at = 0; at < text.length;) {
    const sign = PLAIN.find(([written]) => text.startsWith(written, at));
    plain += sign ? sign[1] : text[at];
    at += sign ? sign[0].length : 1;
  }
  return plain;
};

const BASES = [['thetadot', 'theta'], ['theta', 'theta'], ['omega', 'w'], ['q', 'theta'], ['w', 'w'], ['i', 'i'], ['n', 'n'],
               ['N', 'N'], ['z', 'N'], ['d', 'd']];
// The symbol at this place of a text in plain notation, {base, subscript, primes, end}; null if there is none.
const nameAt = (text, at) => {
  const base = BASES.find(([written]) => text.startsWith(written, at));
  if (!base) return null;
  let end = at + base[0].length, subscript = '', primes = 0;
  const takePrimes = () => {
    const found = /^(?:\^\{('+)\}?|\^('+)|('*))/.exec(text.slice(end));
    primes += (found[1] || found[2] || found[3] || '').length;
    end += found[0].length;
  };
  takePrimes();
  let isBraced = false;
  if (text[end] === '_') {
    isBraced = text[++end] === '{';
    if (isBraced) ++end;
  }
  for (; end < text.length; ++end) {
    const letter = text[end];
    const isInside = isBraced || ((letter === '_' || letter === ',') && isDigit(text[end + 1] || ''));
    if (isDigit(letter)) subscript += letter;
    else if ('_, '.includes(letter) && subscript && isInside) subscript += subscript.endsWith('_') ? '' : '_';
    else break;
  }
  if (isBraced && text[end++] !== '}') return null;
  takePrimes();
  return subscript && !subscript.endsWith('_') ? {base: base[1], subscript, primes, end} : null;
};

const ONE = new Rational(1n);
const PER_CENT = new Rational(1n, 100n);
const TWO_THOUSAND = new Rational(2000n);
// An exact amount and the slack by which it is rounded.
const amount = (value, slack = ZERO) => ({value, slack});
const magnitude = value => (value.numerator < 0n ? value.negated() : value);
const isBounded = ({value: {numerator, denominator}}) =>
    (numerator + (denominator === 1n ? '' : '/' + denominator)).length <= MOST_DIGITS;

// Recursive descent over sums, products, quotients and whole powers. `fault`: null, "number", "ambiguous" or "symbol"; then
// `place` is the part of the text that cannot be read.
class NumberReader {
  constructor(text, {isDecimalComma, symbols}) {
    Object.assign(this, {text, isDecimalComma, symbols, at: 0, fault: null, place: ''});
  }
  read() {
    if (!/[^ ]/.test(this.text)) this.fail('number', '');
    const {value, slack} = this.fault ? amount(ZERO) : this.sum(0);
    if (!this.fault && this.peek()) this.unexpected();
    return {fault: this.fault, place: this.place, value, slack};
  }
  fail(fault, place) {
    if (!this.fault) Object.assign(this, {fault, place});
    this.at = this.text.length;
    return amount(ZERO);
  }
  unexpected() { return this.fail('number', this.text.slice(this.at)); }
  peek() {
    while (this.text[this.at] === ' ') ++this.at;
    return this.here();
  }
  here() { return this.text[this.at] || ''; }
  bounded(number, from) { return isBounded(number) ? number : this.fail('number', this.text.slice(from)); }
  times(a, b, from) {
    const slack = magnitude(a.value).times(b.slack).plus(magnitude(b.value).times(a.slack)).plus(a.slack.times(b.slack));
    return this.bounded(amount(a.value.times(b.value), slack), from);
  }
  inverse({value, slack}, from) {
    if (value.isZero()) return this.fail('number', this.text.slice(from));
    return amount(ONE.over(value), slack.over(value.times(value)));
  }
  sum(depth) {
    let whole = this.product(depth);
    for (let sign = this.peek(); sign === '+' || sign === '-'; sign = this.peek()) {
      const from = this.at++;
      const next = this.product(depth);
      if (this.fault) break;
      const value = sign === '+' ? whole.value.plus(next.value) : whole.value.minus(next.value);
      whole = this.bounded(amount(value, whole.slack.plus(next.slack)), from);
    }
    return whole;
  }
  product(depth) {
    let whole = this.factor(depth);
    for (let sign = this.peek(); sign && !this.fault; sign = this.peek()) {
      const from = this.at;
      const isDivided = sign === '/' || sign === ':';
      if (sign === '*' || isDivided) ++this.at;
      else if (!'({[\\'.includes(sign) && !isLetter(sign)) break;
      let next = this.factor(depth);
      if (!this.fault && isDivided) next = this.inverse(next, from);
      if (!this.fault) whole = this.times(whole, next, from);
    }
    return whole;
  }
  factor(depth) {
    const sign = this.peek();
    if (depth > DEEPEST) this.fail('number', this.text.slice(this.at));
    if (this.fault) return amount(ZERO);
    const from = this.at;
    if (sign === '-' || sign === '+') {
      ++this.at;
      const {value, slack} = this.factor(depth + 1);
      return sign === '-' ? amount(value.negated(), slack) : amount(value, slack);
    }
    let base = sign && '({['.includes(sign) ? this.group(depth)
             : isDigit(sign) || sign === '.' || sign === ',' ? this.literal() : this.named(depth);
    if (!this.fault && this.peek() === '^') {
      ++this.at;
      base = this.power(base, from);
    }
    for (; !this.fault && this.peek() === '%'; ++this.at) base = this.times(base, amount(PER_CENT), from);
    return base;
  }
  group(depth) {
    const close = {'(': ')', '{': '}', '[': ']'}[this.peek()];
    ++this.at;
    const inner = this.sum(depth + 1);
    if (!this.fault && this.peek() !== close) this.unexpected();
    ++this.at;
    return inner;
  }
  power(base, from) {
    const close = {'(': ')', '{': '}'}[this.peek()];
    if (close) ++this.at;
    const isNegative = this.peek() === '-';
    if (isNegative) ++this.at;
    const begin = this.at;
    let exponent = 0;
    for (; isDigit(this.here()) && exponent <= HIGHEST_POWER; ++this.at) exponent = 10 * exponent + Number(this.here());
    if (this.at === begin || exponent > HIGHEST_POWER) return this.fail('number', this.text.slice(from));
    if (close && this.here() !== close) this.unexpected();
    if (close) ++this.at;
    let whole = amount(ONE);
    for (let i = 0; i < exponent && !this.fault; ++i) whole = this.times(whole, base, from);
    return !this.fault && isNegative ? this.inverse(whole, from) : whole;
  }
  digits() {
    const from = this.at;
    while (isDigit(this.here())) ++this.at;
    return this.text.slice(from, this.at);
  }
  // "e-3" after a number; 0 without one, null if it is out of range.
  exponent() {
    const found = /^[eE]([+-]?)(\d+)/.exec(this.text.slice(this.at));
    if (!found) return 0;
    this.at += found[0].length;
    const size = Number(found[2]);
    if (size > HIGHEST_EXPONENT) return null;
    return found[1] === '-' ? -size : size;
  }
  literal() {
    const begin = this.at;
    const failHere = fault => {
      while (isDigit(this.here()) || this.here() === '.' || this.here() === ',') ++this.at;
      return this.fail(fault, this.text.slice(begin, this.at));
    };
    const whole = this.digits();
    let places = '';
    const mark = this.here();
    if (mark === '.' || mark === ',') {
      ++this.at;
      places = this.digits();
      const isGrouped = mark === ',' && !this.isDecimalComma && places.length === 3 && whole.length >= 1 && whole.length <= 3 &&
          whole[0] !== '0';
      if (this.here() === '.' || this.here() === ',' || isGrouped) return failHere('ambiguous');
      if (!places) return failHere('number');
    }
    const power = this.exponent();
    if (power === null) return failHere('number');
    const shift = power - places.length;
    const unit = shift < 0 ? new Rational(1n, 10n ** BigInt(-shift)) : new Rational(10n ** BigInt(shift));
    const value = new Rational(BigInt(whole + places)).times(unit);
    if (!places || (whole + places).replace(/^0+/, '').length < FEWEST_DIGITS) return amount(value);
    const share = value.over(TWO_THOUSAND);
    return amount(value, isLess(unit, share) ? share : unit);
  }
  named(depth) {
    const from = this.at;
    if (this.text.startsWith('\\frac', this.at)) {
      this.at += 5;
      const above = this.fractionPart(depth);
      const below = this.fractionPart(depth);
      if (this.fault) return above;
      const inverse = this.inverse(below, from);
      return this.fault ? above : this.times(above, inverse, from);
    }
    const name = nameAt(this.text, this.at);
    if (!name) return this.unexpected();
    this.at = name.end;
    const primes = "'".repeat(name.primes);
    const merged = name.subscript.replaceAll('_', '');
    const value = this.symbols[name.base + name.subscript + primes] ??
        (merged === name.subscript || name.subscript.length === 3 ? this.symbols[name.base + merged + primes] : undefined);
    return value === undefined ? this.fail('symbol', this.text.slice(from)) : amount(keyNumber(value));
  }
  fractionPart(depth) {
    const sign = this.peek();
    if (sign === '{') return this.group(depth);
    if (!isDigit(sign)) return this.unexpected();
    ++this.at;
    return amount(new Rational(BigInt(sign)));
  }
}

// A way to write a unit, the unit of its dimension, and how many of that it is; 0: not converted.
const TORQUES = [['', 'm', '1'], ['k', 'm', '1000'], ['', 'cm', '1/100'], ['', 'mm', '1/1000'], ['m', 'm', '1/1000']];
const UNITS = [
  ['rad/s', 'rad/s', '1'], ['rad s^-1', 'rad/s', '1'], ['rad*s^-1', 'rad/s', '1'], ['rad s^{-1}', 'rad/s', '1'],
  ['s^{-1}', 'rad/s', '1'], ['s^-1', 'rad/s', '1'], [' 1/s', 'rad/s', '1'], ['/s', 'rad/s', '1'], ['deg/s', 'rad/s', '0'],
  ['°/s', 'rad/s', '0'], ['rpm', 'rad/s', '0'], [' 1/min', 'rad/s', '0'], ['U/min', 'rad/s', '0'], ['r/min', 'rad/s', '0'],
  ['/min', 'rad/s', '0'], ['ft', 'N m', '0'], ['W', 'W', '1'], ['kW', 'W', '1000'], ['rad', 'rad', '1'], ['deg', 'rad', '0'],
  ['mm', 'mm', '1'], ['°', 'rad', '0'],
  ...TORQUES.flatMap(([prefix, length, factor]) => ['', ' ', '*'].map(sign => [prefix + 'N' + sign + length, 'N m', factor])),
];
// The longest unit at the end of the text, after a number and not after a letter.
const unitOf = text => UNITS.reduce((found, unit) => {
  const before = text[text.length - unit[0].length - 1];
  const isHere = before !== undefined && text.endsWith(unit[0]) && !isLetter(before) && before !== '_' && before !== '^';
  return isHere && (!found || unit[0].length > found[0].length) ? unit : found;
}, null);

// {fault, place, value, slack}: null, or "number", "ambiguous", "symbol" or "unit" with the part that cannot be read.
const readNumber = (text, {isDecimalComma = false, unit = '', symbols = {}} = {}) => {
  if (isLong(text) || text.includes('\0')) return {fault: 'number', place: '', value: ZERO, slack: ZERO};
  let plain = plainNotation(text).replace(/ +$/, '');
  let factor = ONE;
  const written = unitOf(plain);
  if (written) {
    factor = keyNumber(written[2]);
    if (written[1] !== unit || factor.isZero()) return {fault: 'unit', place: written[0].trim(), value: ZERO, slack: ZERO};
    plain = plain.slice(0, -written[0].length);
  }
  const number = new NumberReader(plain, {isDecimalComma, symbols}).read();
  if (number.fault) return {...number, value: ZERO, slack: ZERO};
  return {...number, value: number.value.times(factor), slack: number.slack.times(factor)};
};

const trimmed = text => text.replace(/^[ \t\r\n]+|[ \t\r\n]+$/g, '').replace(/\u2212/g, '-');
const SEPARATORS = ' \t\r\n,;{}';

// A word without its case: letters of ASCII and Latin-1, Ğ and Ş. The i of Turkish, with and without its dot, is one letter.
const folded = text => text.replace(/[A-Z\u00c0-\u00d6\u00d8-\u00de\u011e\u015e]/g, letter => letter.toLowerCase())
                           .replace(/[\u0130\u0131]/g, 'i');
// The options without their case; null if two of them differ in case only.
const anyCase = options => {
  const names = options.map(option => folded(trimmed(option)));
  return new Set(names).size === names.length ? names : null;
};

// The options in a list, in the question's order; null where it names something else. Names may hold blanks and commas: the
// longest that fits is meant.
const setIn = (options, word) => {
  const names = anyCase(options) || options.map(trimmed);
  const text = anyCase(options) ? folded(word) : word;
  const isIn = options.map(() => false);
  for (let at = 0; at < text.length;) {
    let found = -1;
    names.forEach((name, i) => {
      const after = text[at + name.length];
      const isNamed = name && text.startsWith(name, at) && (after === undefined || SEPARATORS.includes(after));
      if (isNamed && (found < 0 || name.length > names[found].length)) found = i;
    });
    if (found >= 0) {
      isIn[found] = true;
      at += names[found].length;
    } else if (SEPARATORS.includes(text[at])) {
      ++at;
    } else {
      return null;
    }
  }
  return options.filter((_, i) => isIn[i]);
};

// The option that is meant, whatever its case where only one fits.
const optionOf = (options, word) => {
  const exact = options.find(each => trimmed(each) === word);
  const at = exact === undefined ? (anyCase(options) || []).indexOf(folded(word)) : -1;
  return exact ?? options[at];
};

// fault: null, "empty", "choice" or that of a number. `notation`: as for numbers, {isDecimalComma, symbols}.
const readField = (field, text, notation = {}) => {
  const word = trimmed(text);
  const {kind, options = [], unit = ''} = field;
  const read = {kind, fault: null, place: '', isEmpty: false, number: null, text: '', elements: []};
  if (kind === 'set') {
    const elements = setIn(options, word);
    if (elements) read.elements = elements;
    else read.fault = 'choice';
    read.isEmpty = !read.fault && !read.elements.length;
  } else if (!word) {
    read.isEmpty = true;
  } else if (kind === 'choice') {
    const option = optionOf(options, word);
    if (option === undefined) read.fault = 'choice';
    else read.text = option;
  } else {
    read.number = readNumber(word, {...notation, unit});
    if (kind === 'integer') read.number.slack = ZERO;
    ({fault: read.fault, place: read.place} = read.number);
  }
  if (read.isEmpty && !field.mayBeEmpty) read.fault = 'empty';
  return read;
};
const notationOf = ({decimal, symbols = {}}) => ({isDecimalComma: decimal === ',', symbols});
// The answer, where a row of a table that is written into its first cell fills the row (written_rows.h).
const withRowsSpread = (question, answer) => {
  const width = question.table ? question.table.columns.length : 0;
  const texts = [...answer];
  const isBlank = text => !/[^ \t\r\n]/.test(text);
  for (let first = 0; width > 1 && first + width <= texts.length; first += width) {
    const text = texts[first];
    if (isBlank(text) || !texts.slice(first + 1, first + width).every(isBlank)) continue;
    const entries = text.split(question.decimal === ',' || text.includes(';') ? /[;\t]/ : /[;\t,]/);
    if (entries.length === width && readField(question.fields[first], text, notationOf(question)).fault)
      texts.splice(first, width, ...entries);
  }
  return texts;
};
const readAnswer = (question, answer) => {
  const notation = notationOf(question);
  return question.fields.map((field, i) => readField(field, answer[i], notation));
};

const agrees = ({value, slack}, expected) => {
  const rest = value.minus(expected);
  return rest.isZero() || isLess(rest.numerator < 0n ? rest.negated() : rest, slack);
};
// Is it what this text of a key is read as?
const readsLike = (read, value) => {
  if (read.fault) return false;
  if (read.kind === 'set') return read.elements.join(',') === value;
  if (read.isEmpty || value === '') return read.isEmpty && value === '';
  if (read.kind === 'choice') return read.text === value;
  return agrees(read.number, keyNumber(value));
};
