// Reads what learners write, exactly as core/teaching/grading does (number_text.h, read_answer.h).

const MOST_BYTES = 200;
const DEEPEST = 20;
const SIGNS = {'\u2212': '-', '\u2013': '-', '\u00d7': '*', '\u00b7': '*', '\u22c5': '*', '\u00f7': '/', '\u2044': '/',
               '\u00a0': ' ', '\u202f': ' ', ':': '/'};
const isDigit = letter => letter >= '0' && letter <= '9';

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

// Recursive descent over sums, products and factors. `fault`: null, "number" or "ambiguous".
class NumberReader {
  constructor(text) {
    this.text = text.replace(/[\u2212\u2013\u00d7\u00b7\u22c5\u00f7\u2044\u00a0\u202f:]/g, sign => SIGNS[sign])
                    .replace(/^[ \t]+|[ \t]+$/g, '');
    this.at = 0;
    this.fault = null;
    this.literals = 0;
    this.isPlain = true;  // one literal with signs and parentheses
    this.decimals = 0;    // of the last literal
    this.significant = 0;
  }
  // slack: a decimal of at least three digits agrees with every value nearer than one unit of its last place.
  read() {
    if (!this.text || isLong(this.text)) return {fault: 'number', value: ZERO, slack: ZERO};
    const value = this.sum(0);
    if (this.at !== this.text.length) this.fail('number');
    const isRounded = !this.fault && this.literals === 1 && this.isPlain && this.decimals > 0 && this.significant >= 3;
    return {fault: this.fault, value, slack: isRounded ? new Rational(1n, 10n ** BigInt(this.decimals)) : ZERO};
  }
  fail(fault) {
    this.fault ||= fault;
    this.at = this.text.length;
  }
  peek() {
    while (this.text[this.at] === ' ') ++this.at;
    return this.text[this.at] || '';
  }
  sum(depth) {
    let value = this.product(depth);
    for (let sign = this.peek(); sign === '+' || sign === '-'; sign = this.peek()) {
      ++this.at;
      this.isPlain = false;
      const next = this.product(depth);
      value = sign === '+' ? value.plus(next) : value.minus(next);
    }
    return value;
  }
  product(depth) {
    let value = this.factor(depth);
    for (let sign = this.peek(); sign === '*' || sign === '/'; sign = this.peek()) {
      ++this.at;
      this.isPlain = false;
      const next = this.factor(depth);
      if (sign === '*') value = value.times(next);
      else if (next.isZero()) this.fail('number');
      else value = value.over(next);
    }
    return value;
  }
  factor(depth) {
    if (depth > DEEPEST) this.fail('number');
    const sign = this.peek();
    if (sign === '-' || sign === '+') {
      ++this.at;
      const value = this.factor(depth + 1);
      return sign === '-' ? value.negated() : value;
    }
    if (sign !== '(') return this.literal();
    ++this.at;
    const value = this.sum(depth + 1);
    if (this.peek() === ')') ++this.at;
    else this.fail('number');
    return value;
  }
  digits() {
    const from = this.at;
    while (this.at < this.text.length && isDigit(this.text[this.at])) ++this.at;
    return this.text.slice(from, this.at);
  }
  literal() {
    const whole = this.digits();
    let places = '';
    const mark = this.text[this.at];
    if (mark === '.' || mark === ',') {
      ++this.at;
      places = this.digits();
      const next = this.text[this.at];
      const isGrouped = mark === ',' && places.length === 3 && whole.length >= 1 && whole.length <= 3 && whole[0] !== '0';
      if (next === '.' || next === ',' || isGrouped) {
        this.fail('ambiguous');
        return ZERO;
      }
      if (!places) this.fail('number');
    }
    if (!whole && !places) {
      this.fail('number');
      return ZERO;
    }
    ++this.literals;
    this.decimals = places.length;
    this.significant = (whole + places).replace(/^0+/, '').length;
    return new Rational(BigInt(whole + places), 10n ** BigInt(places.length));
  }
}
const readNumber = text => new NumberReader(text).read();

const trimmed = text => text.replace(/^[ \t\r\n]+|[ \t\r\n]+$/g, '').replace(/\u2212/g, '-');
const SEPARATORS = ' \t\r\n,;{}';

// The options in a list, in the question's order; null where it names something else. Names may hold blanks and commas: the
// longest that fits is meant.
const setIn = (options, text) => {
  const names = options.map(trimmed);
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

// fault: null, "empty", "number", "ambiguous" or "choice".
const readField = (field, text) => {
  const word = trimmed(text);
  const {kind, options = []} = field;
  const read = {kind, fault: null, isEmpty: false, number: null, text: '', elements: []};
  if (kind === 'set') {
    const elements = setIn(options, word);
    if (elements) read.elements = elements;
    else read.fault = 'choice';
    read.isEmpty = !read.fault && !read.elements.length;
  } else if (!word) {
    read.isEmpty = true;
  } else if (kind === 'choice') {
    const option = options.find(each => trimmed(each) === word);
    if (option === undefined) read.fault = 'choice';
    else read.text = option;
  } else {
    read.number = readNumber(word);
    if (kind === 'integer') read.number.slack = ZERO;
    read.fault = read.number.fault;
  }
  if (read.isEmpty && !field.mayBeEmpty) read.fault = 'empty';
  return read;
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
