// The exercise sheet: one question at a time (exercise.js), the points, and the file of answers.

const SHEET_FORMAT = 'geargraph-answers';

const answersText = (sheet, states, student) => JSON.stringify({
  format: SHEET_FORMAT, version: 1, sheet: sheet.sheet, variant: sheet.variant, student,
  answers: Object.fromEntries(sheet.questions.map(({fields}, i) => [String(i + 1),
    Object.fromEntries(fields.map((field, j) => [field.name, states[i].texts[j]]))])),
}, null, 2) + '\n';

// A drawing beside the question, on which nothing can be asked: its elements light up with the cells and the mistakes.
const askedDrawings = () => {
  const drawings = [...document.querySelectorAll('#drawings figure')].slice(0, 2).map(figure => {
    const name = figure.dataset.title;
    const svg = figure.querySelector('svg').cloneNode(true);
    for (const attribute of ['tabindex', 'aria-label']) svg.removeAttribute(attribute);
    svg.setAttribute('role', 'img');
    svg.setAttribute('aria-label', say('drawingOf', name));
    for (const node of svg.querySelectorAll('[data-id]')) addPlace(keyOf(node.dataset.list, node.dataset.id), node);
    return {name, svg};
  });
  const views = drawings.map(({name}, i) => make('button', {type: 'button', 'aria-pressed': String(i === 0)}, name));
  const show = at => {
    drawings.forEach(({svg}, i) => svg.toggleAttribute('hidden', i !== at));
    views.forEach((view, i) => view.setAttribute('aria-pressed', String(i === at)));
  };
  views.forEach((view, i) => view.addEventListener('click', () => show(i)));
  show(0);
  return make('div', {class: 'asked-drawing'}, make('div', {class: 'bar', role: 'group', 'aria-label': say('drawing')}, ...views),
              ...drawings.map(({svg}) => svg));
};

const showSheet = sheet => {
  const section = byId('exercises');
  const {questions} = sheet;
  const key = `geargraph/${sheet.sheet}/${sheet.variant}`;
  const old = kept(key);
  const isOld = i => Array.isArray(old?.states?.[i]?.texts) && old.states[i].texts.length === questions[i].fields.length;
  const blank = i => ({texts: questions[i].fields.map(() => ''), points: 0, isChecked: false, isShown: false, isHinted: false});
  const states = questions.map((_, i) => (isOld(i) ? old.states[i] : blank(i)));
  const student = make('input', {type: 'text', id: 'student', autocomplete: 'name'});
  student.value = old?.student || sheet.student;
  let lit = [];
  let at = Number.isInteger(old?.at) && questions[old.at] ? old.at : 0;
  const light = (keys, name) => {
    for (const [each, was] of lit) mark(each, was, false);
    lit = keys.map(each => [each, name]);
    for (const each of keys) mark(each, name, true);
  };
  const of = questions.reduce((sum, question) => sum + question.points, 0);
  const score = make('p', {class: 'score'});
  const changed = () => {
    keep(key, {states, student: student.value, at});
    const points = states.reduce((sum, state) => sum + state.points, 0);
    const done = states.filter(state => state.isChecked || state.isShown).length;
    score.textContent = of === 1 ? say('scoreOfOne', points, done, questions.length) : say('scoreOf', points, of, done, questions.length);
    Object.assign(section.dataset, {points: String(points), of: String(of), open: String(questions.length - done)});
    section.dispatchEvent(new Event('points'));
  };

  const nodes = [...section.querySelectorAll('.question')];
  const exercises = [];
  const drawings = askedDrawings();
  const place = make('p', {class: 'place', 'aria-live': 'polite'});
  const go = to => {
    at = to;
    light([], 'wrong');
    nodes.forEach((node, i) => node.classList.toggle('here', i === at));
    nodes[at].querySelector('.wide').before(drawings);  // below the question, above its blanks
    place.textContent = say('question', at + 1, questions.length);
    back.disabled = at === 0;
    next.disabled = at === questions.length - 1;
    const verdict = exercises[at].verdict;
    if (verdict && !verdict.isRight) light(verdict.mistakes[0]?.elements || [], 'wrong');
    if (!verdict) exercises[at].showHint();
    keep(key, {states, student: student.value, at});
    reachWide();
  };
  const back = make('button', {type: 'button', 'aria-label': say('questionBefore')}, say('back'));
  const next = make('button', {type: 'button', 'aria-label': say('nextQuestion')}, say('next'));
  back.addEventListener('click', () => go(at - 1));
  next.addEventListener('click', () => go(at + 1));
  student.addEventListener('input', changed);
  const save = make('a', {class: 'button', href: '#exercises', download: `answers-${sheet.variant}.json`}, say('save'));
  save.addEventListener('click', () => {
    save.href = 'data:application/json;charset=utf-8,' + encodeURIComponent(answersText(sheet, states, student.value));
  });

  nodes.forEach((node, i) => exercises.push(new Exercise(node, questions[i], states[i], {
    changed, light, onward: i + 1 < nodes.length ? () => {
      go(i + 1);
      nodes[i + 1].scrollIntoView({block: 'start'});
      exercises[i + 1].fields[0].focus({preventScroll: true});
    } : null})));
  nodes[0].before(make('div', {class: 'bar walk'}, back, place, next));
  // On a device that several pupils share the next one begins with an empty sheet.
  const startAgain = make('button', {type: 'button'}, say('startAgain'));
  startAgain.addEventListener('click', () => {
    if (!window.confirm(say('startAgainSure'))) return;
    states.forEach((state, i) => Object.assign(state, blank(i)));
    student.value = sheet.student;
    for (const exercise of exercises) exercise.restart();
    changed();
    go(0);
    nodes[0].scrollIntoView({block: 'start'});
  });
  const printSheet = make('button', {type: 'button'}, say('printQuestions'));
  printSheet.addEventListener('click', () => {
    document.body.dataset.print = 'exercises';
    window.addEventListener('afterprint', () => delete document.body.dataset.print, {once: true});
    window.print();
  });
  section.append(make('div', {class: 'bar handin'}, score, make('label', {for: 'student'}, say('name')), student, save, printSheet, startAgain),
                 make('p', {class: 'note'}, say('kept')));
  section.classList.add('live');
  go(at);
  changed();
};

if (byId('exercises-key')) {
  unpacked(byId('exercises-key').textContent.trim())
      .then(bytes => {
        const sheet = JSON.parse(new TextDecoder().decode(bytes));
        sheet.questions.forEach(({fields, table}, i) => {
          fields.forEach((field, j) => { field.title = sheet.shown[i].fields[j]; });
          if (table) table.columns = sheet.shown[i].columns;
        });
        showSheet(sheet);
      })
      .catch(error => byId('exercises').append(make('p', {class: 'reason', role: 'status'},
          say('cannotGrade', error.message))));
}
