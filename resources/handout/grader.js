// Grades an answer by the key of its question, as core/teaching/grading does (question.h, grade.h): both know the same tests
// and give the same verdicts, which the test handout.grader holds against each other.

const FEWEST_FOR_HALF = 4;

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

// The name of the mistake, and what is said of it: of the text and the field.
const UNREADABLE = {
  empty: ['unanswered', (text, name) => say('empty', name)],
  ambiguous: ['ambiguous-number', text => say('ambiguous', text)],
  number: ['not-a-number', text => say('notANumber', text)],
  choice: ['not-a-choice', (text, name) => say('notAChoice', text, name)],
};
// The field's name in the page's language; where there is none, that of files of answers.
const shownName = ({title, name}) => title ?? name;

const hasOneAnswer = ({accepted}) => accepted.length === 1 && accepted[0].test === 'values' && accepted[0].values.length === 1;
// Where an answer differs from the only right one; nothing where several are right.
const differingFields = (question, read) =>
    (hasOneAnswer(question) ? read.flatMap((field, i) => (readsLike(field, question.solution[i]) ? [] : [i])) : []);

// `answer`: a text for each field. {isRight, points, mistakes: [{name, fields, elements, reason}], wrongFields, reason}: the
// first of the mistakes is the one to be told; `wrongFields` are marked, none of them means the answer as a whole.
const grade = (question, answer) => {
  const read = question.fields.map((field, i) => readField(field, answer[i]));
  if (allHold(question.accepted, read))
    return {isRight: true, points: question.points, mistakes: [], wrongFields: [], reason: question.rule};
  const found = [];
  read.forEach(({fault}, i) => {
    if (!fault) return;
    const [name, reason] = UNREADABLE[fault];
    const {elements = []} = question.fields[i];
    found.push({name, fields: [i], elements, reason: reason(answer[i], shownName(question.fields[i]))});
  });
  for (const {name, when, fields = [], elements = [], reason} of question.mistakes) {
    const isMarked = found.some(mistake => mistake.fields.some(field => fields.includes(field)));
    if (found.length && (!fields.length || isMarked)) continue;
    if (!allHold(when, read)) continue;
    found.push({name, fields, elements, reason});
    if (!fields.length) break;
  }
  const marked = new Set(differingFields(question, read).concat(found.flatMap(mistake => mistake.fields)));
  const wrongFields = [...marked].sort((a, b) => a - b);
  const isNearlyRight = wrongFields.length === 1 && answer.length >= FEWEST_FOR_HALF;
  return {isRight: false, points: isNearlyRight ? Math.floor(question.points / 2) : 0, mistakes: found, wrongFields,
          reason: found.length ? found[0].reason : question.rule};
};
