// Grades an answer by the key of its question, as core/teaching/grading does (question.h, grade.h): both know the same tests
// and give the same verdicts, which the test handout.grader holds against each other.

const LONGEST_QUOTE = 40;  // characters of an answer that a sentence repeats
const MOST_NAMED = 6;      // empty fields
const FEWEST_OF_MULTIPLE = 2;  // cells that fix the factor of a row

const isNumeric = fields =>
    fields.every(field => !field.fault && !field.isEmpty && (field.kind === 'integer' || field.kind === 'number'));

// Are the fields this row times some number that is not 0?
const isMultiple = (fields, row) => {
  const expected = row.map(keyNumber);
  const pivot = expected.findIndex(value => !value.isZero());
  if (!isNumeric(fields) || pivot < 0) return false;
  const factor = fields[pivot].number.value.over(expected[pivot]);
  return !factor.isZero() && expected.every((value, i) => agrees(fields[i].number, factor.times(value)));
};

// Are they these rows, in any order and each up to its sign?
const areRows = (fields, rows) => {
  const width = rows[0].length;
  if (!isNumeric(fields) || fields.length !== width * rows.length) return false;
  const expected = rows.map(row => row.map(keyNumber));
  const left = new Set(rows.keys());
  for (let first = 0; first < fields.length; first += width) {
    const isRow = (row, isTurned) =>
        row.every((value, i) => isSame(fields[first + i].number.value, isTurned ? value.negated() : value));
    const found = [...left].find(i => isRow(expected[i], false) || isRow(expected[i], true));
    if (found === undefined) return false;
    left.delete(found);
  }
  return true;
};

// How many edges [edge, node, node] of the set join parts that others of it do not, and how many nodes there are.
const joinedBy = (set, edges) => {
  const above = new Map();
  for (const [, tail, head] of edges) for (const node of [tail, head]) above.set(node, node);
  const rootOf = node => {
    while (above.get(node) !== node) node = above.get(node);
    return node;
  };
  let joining = 0;
  for (const [edge, tail, head] of edges) {
    const [from, to] = [rootOf(tail), rootOf(head)];
    if (!set.includes(edge) || from === to) continue;
    above.set(from, to);
    ++joining;
  }
  return {joining, nodes: above.size};
};

// The rank of the rows [name, numbers ...] that the set names.
const rankOf = (set, named) => {
  const rows = named.filter(([name]) => set.includes(name)).map(row => row.slice(1).map(keyNumber));
  let rank = 0;
  for (let column = 0; column < named[0].length - 1 && rank < rows.length; ++column) {
    const pivot = rows.findIndex((row, i) => i >= rank && !row[column].isZero());
    if (pivot < 0) continue;
    [rows[rank], rows[pivot]] = [rows[pivot], rows[rank]];
    for (let below = rank + 1; below < rows.length; ++below) {
      const factor = rows[below][column].over(rows[rank][column]);
      rows[below] = rows[below].map((value, i) => value.minus(factor.times(rows[rank][i])));
    }
    ++rank;
  }
  return rank;
};

const isWithin = (field, [least, most]) => {
  const {value} = field.number;
  return value.denominator === 1n && !isLess(value, keyNumber(least)) && !isLess(keyNumber(most), value);
};

const TESTS_OF_FIELDS = {
  values: (fields, rows) => rows.some(row => row.every((value, i) => readsLike(fields[i], value))),
  differs: (fields, rows) => !TESTS_OF_FIELDS.values(fields, rows),
  multiple: (fields, rows) => isMultiple(fields, rows[0]),
  rows: areRows,
  quotient: (fields, rows) => isNumeric(fields) && !fields[1].number.value.isZero() &&
      isSame(fields[0].number.value.over(fields[1].number.value), keyNumber(rows[0][0])),
  within: (fields, rows) => isNumeric(fields) && fields.every(field => isWithin(field, rows[0])),
  outside: (fields, rows) => isNumeric(fields) && !fields.every(field => isWithin(field, rows[0])),
};
const sizeOf = set => new Rational(BigInt(set.length));
const TESTS_OF_SETS = {
  'spanning-tree': (set, rows) => {
    const {joining, nodes} = joinedBy(set, rows);
    return joining === set.length && set.length + 1 === nodes;
  },
  'has-loop': (set, rows) => joinedBy(set, rows).joining < set.length,
  basis: (set, rows) => set.length + 1 === rows[0].length && rankOf(set, rows) === set.length,
  dependent: (set, rows) => rankOf(set, rows) < set.length,
  fewer: (set, rows) => isLess(sizeOf(set), keyNumber(rows[0][0])),
  more: (set, rows) => isLess(keyNumber(rows[0][0]), sizeOf(set)),
  includes: (set, rows) => rows[0].every(each => set.includes(each)),
  lacks: (set, rows) => !rows[0].every(each => set.includes(each)),
  touches: (set, rows) => rows[0].some(each => set.includes(each)),
};

const holds = ({test, fields: at, values}, answer) => {
  const fields = at && at.length ? at.map(i => answer[i]) : answer;
  if (fields.some(field => field.fault)) return false;
  if (TESTS_OF_FIELDS[test]) return TESTS_OF_FIELDS[test](fields, values);
  return fields.length === 1 && fields[0].kind === 'set' && TESTS_OF_SETS[test](fields[0].elements, values);
};
const allHold = (conditions, answer) => conditions.every(condition => holds(condition, answer));

// The text, cut after some characters.
const quoted = text => {
  const letters = [...text];
  return letters.length > LONGEST_QUOTE ? letters.slice(0, LONGEST_QUOTE).join('') + '\u2026' : text;
};
// The name of the mistake, and what is said of it: of the text, the place where reading stopped and the field.
const UNREADABLE = {
  ambiguous: ['ambiguous-number', text => say('ambiguous', text)],
  number: ['not-a-number', (text, place) =>
      (place && place !== text ? say('stopsAtNumber', text, place) : say('notANumber', text))],
  symbol: ['unknown-symbol', (text, place) => say('stopsAtSymbol', text, place)],
  unit: ['other-unit', (text, place, {unit}) =>
      (unit ? say('otherUnit', text, place, unit) : say('noUnit', text, place))],
  choice: ['not-a-choice', (text, place, field) => say('notAChoice', text, shownName(field))],
};
// The field's name in the page's language; where there is none, that of files of answers.
const shownName = ({title, name}) => title ?? name;

const hasOneAnswer = ({accepted}) => accepted.length === 1 && accepted[0].test === 'values' && accepted[0].values.length === 1;

// With the multiple of the row that most cells agree with; null if no two of them do.
const agreementWithMultiple = (fields, row) => {
  const expected = row.map(keyNumber);
  const isRead = field => !field.fault && !field.isEmpty;
  let best = null, most = FEWEST_OF_MULTIPLE - 1;
  fields.forEach((pivot, at) => {
    if (!isRead(pivot) || expected[at].isZero() || pivot.number.value.isZero()) return;
    const factor = pivot.number.value.over(expected[at]);
    const isAgreed = fields.map((field, i) => isRead(field) && agrees(field.number, factor.times(expected[i])));
    const count = isAgreed.filter((each, i) => each && !expected[i].isZero()).length;
    if (count <= most) return;
    most = count;
    best = isAgreed;
  });
  return best;
};
// An answer, cell by cell, against the accepted one that most of its cells agree with (nearest_answer.h): the fields that
// differ, and how many of the cells that earn points are right.
const compareCells = (question, answer) => {
  const wrong = new Set();
  let right = 0, counted = 0;
  for (const condition of question.accepted) {
    const {test, values} = condition;
    const at = condition.fields && condition.fields.length ? condition.fields : answer.map((_, i) => i);
    const fields = at.map(i => answer[i]);
    let row = values[0], isAgreed = null;
    if (test === 'values') {
      let most = -1;
      for (const other of values) {
        const agreed = fields.map((field, i) => readsLike(field, other[i]));
        const count = agreed.filter(Boolean).length;
        if (count <= most) continue;
        most = count;
        isAgreed = agreed;
        row = other;
      }
    } else if (test === 'multiple') {
      isAgreed = agreementWithMultiple(fields, row);
    } else if (holds(condition, answer)) {
      isAgreed = fields.map(() => true);
    } else if (fields.length === 1) {
      isAgreed = [false];
    }
    const isFiller = i => question.table && (test === 'values' || test === 'multiple') && (row[i] === '0' || row[i] === '');
    fields.forEach((_, i) => {
      const isRight = Boolean(isAgreed && isAgreed[i]);
      if (isRight && isFiller(i)) return;
      ++counted;
      if (isRight) ++right;
      else if (isAgreed) wrong.add(at[i]);
    });
  }
  return {wrong, right, counted};
};

// All empty fields in one sentence.
const unanswered = (question, fields) => {
  const names = fields.map(i => shownName(question.fields[i]));
  const {elements = []} = question.fields[fields[0]];
  if (fields.length === 1) return {name: 'unanswered', fields, elements, reason: say('empty', names[0])};
  const list = names.slice(0, MOST_NAMED).join('; ') + (names.length > MOST_NAMED ? '; \u2026' : '');
  return {name: 'unanswered', fields, elements: [], reason: say('emptyFields', fields.length, list)};
};
// What was found in an answer that is not accepted; a mistake marks those of its fields that differ.
const mistakesIn = (question, answer, read, wrong) => {
  const found = [];
  const blank = [...read.keys()].filter(i => read[i].fault === 'empty');
  const marked = new Set([...read.keys()].filter(i => read[i].fault));
  read.forEach(({fault, place}, i) => {
    if (!fault || fault === 'empty') return;
    const [name, reason] = UNREADABLE[fault];
    const field = question.fields[i];
    found.push({name, fields: [i], elements: field.elements || [], reason: reason(quoted(answer[i]), quoted(place), field)});
  });
  if (blank.length) found.push(unanswered(question, blank));
  for (const {name, when, fields = [], elements = [], reason} of question.mistakes) {
    if (found.length && (!fields.length || fields.some(field => marked.has(field)))) continue;
    if (!allHold(when, read)) continue;
    const differing = fields.filter(field => wrong.has(field));
    found.push({name, fields: differing.length ? differing : fields, elements, reason});
    for (const field of fields) marked.add(field);
    if (!fields.length) break;
  }
  return found;
};

// `answer`: a text for each field. {isRight, isBlank, isUnreadable, points, mistakes: [{name, fields, elements, reason}],
// wrongFields, reason}: the first of the mistakes is the one to be told; `wrongFields` are marked, none of them means the
// answer as a whole.
const grade = (question, texts) => {
  const answer = withRowsSpread(question, texts);
  const read = readAnswer(question, answer);
  const verdict = {isRight: false, isBlank: false, isUnreadable: false, points: 0, mistakes: [], wrongFields: [],
                   reason: question.rule};
  if (allHold(question.accepted, read)) return {...verdict, isRight: true, points: question.points};
  if (read.every(field => field.isEmpty) && read.some(({fault}) => fault)) {
    const reason = say('notAnswered');
    return {...verdict, isBlank: true, mistakes: [{name: 'unanswered', fields: [], elements: [], reason}], reason};
  }
  const {wrong, right, counted} = compareCells(question, read);
  const mistakes = mistakesIn(question, answer, read, wrong);
  for (const {fields} of mistakes) for (const field of fields) wrong.add(field);
  return {...verdict, isUnreadable: read.some(({fault}) => fault && fault !== 'empty'),
          points: Math.floor(question.points * right / Math.max(counted, 1)), mistakes,
          wrongFields: [...wrong].sort((a, b) => a - b), reason: mistakes.length ? mistakes[0].reason : question.rule};
};
