// A lesson: one step at a time with its drawing, hints one by one, and at the end fresh questions, further ones as long as some
// were not right at the first check. Without scripts all steps stand in the page with blanks.

const STEP_POINTS = 2;  // for a right answer at the first check without a hint; 1 after a hint or a correction

const section = byId('exercises');
const stepNodes = [...section.querySelectorAll('.step')];
let elements = new Map();  // those of the step that is shown, by key

// ---- One step ----

class StepExercise extends Exercise {
  takeHint() {
    const folded = this.node.querySelector('details.hint');
    this.hints = [...folded.querySelectorAll('li')].map(each => [...each.childNodes]);
    this.place = make('p', {class: 'where'});
    this.hint = make('div', {class: 'hint', id: this.node.getAttribute('aria-labelledby') + '-hint', role: 'status'});
    folded.remove();
    this.ask = this.button(say('hint'), () => {
      this.state.hints = Math.min(this.state.hints + 1, this.hints.length);
      this.state.isClean = false;
      this.showHint();
      this.changed();
    });
    this.ask.setAttribute('aria-controls', this.hint.id);
  }
  showHint() {
    const {hints} = this.state;
    const isSolved = this.state.isShown || Boolean(this.verdict?.isRight);
    this.hint.hidden = !hints || isSolved;
    this.hint.replaceChildren(make('ol', {}, ...this.hints.slice(0, hints).map(hint => make('li', {}, ...hint))));
    this.ask.hidden = isSolved || hints >= this.hints.length;
    this.ask.textContent = this.hints.length > 1 ? say('hintOf', hints + 1, this.hints.length) : say('hint');
  }
  pointsOf({isRight, isBlank, isUnreadable}) {
    if (isRight) return this.state.isClean ? STEP_POINTS : STEP_POINTS - 1;
    // What is not answered or cannot be read costs nothing.
    if (!isBlank && !isUnreadable) this.state.isClean = false;
    return 0;
  }
  reveal() {
    this.state.isClean = false;
    super.reveal();
  }
  arrange() {
    super.arrange();
    if (this.hasNext && !this.hasNext()) this.onward.hidden = true;
  }
  isOver() { return this.state.isShown || Boolean(this.verdict?.isRight); }
}

const showLesson = questions => {
  const storage = `geargraph/lesson/${data.lesson}`;
  const old = kept(storage);
  let lit = [];
  let steps = [];  // {node, exercise, state, isFresh, isAsked, isPicked, places}
  let round = [];  // the steps in their order: those of the lesson, then the fresh questions that are asked
  let at = 0;

  const light = (keys, name) => {
    for (const [node, was] of lit) node.classList.remove(was);
    const {places} = round[at] || steps[0];
    lit = keys.flatMap(key => (places.get(key) || []).map(node => [node, name]));
    for (const [node, is] of lit) node.classList.add(is);
  };
  const freshOnes = () => round.filter(step => step.isFresh);
  const cleanOnes = () => freshOnes().filter(({state}) => state.points === STEP_POINTS).length;
  const asksFresh = steps => steps.some(step => step.isFresh);
  const score = make('p', {class: 'score', role: 'status'});

  const changed = () => {
    if (!round.length) return;
    next.disabled = !hasNext();
    keep(storage, {at, round: round.map(step => steps.indexOf(step)), states: steps.map(step => step.state)});
    const asked = steps.filter(step => step.isAsked && !step.isFresh);
    const left = asksFresh(steps) ? Math.max(0, data.fresh - cleanOnes()) : 0;
    const points = asked.reduce((sum, {state}) => sum + state.points, 0) + STEP_POINTS * Math.min(data.fresh, cleanOnes());
    const of = STEP_POINTS * (asked.length + (asksFresh(steps) ? data.fresh : 0));
    score.textContent = !left && asksFresh(steps) ? say('mastered') : round[at].isFresh ? say('freshRight', cleanOnes(), data.fresh)
                      : say('lessonScore', points, of);
    const open = asked.filter(({exercise}) => !exercise.isOver()).length + left;
    Object.assign(section.dataset, {points: String(points), of: String(of), open: String(open)});
    section.dispatchEvent(new Event('points'));
  };

  const hasNext = () => at < round.length - 1 || canGoOn();
  const place = make('p', {class: 'place', 'aria-live': 'polite'});
  const back = make('button', {type: 'button', 'aria-label': say('stepBefore')}, say('back'));
  const next = make('button', {type: 'button', 'aria-label': say('nextStep')}, say('next'));
  const go = to => {
    at = to;
    const step = round[at];
    elements = new Map(step.elements.map(element => [element.key, element]));
    for (const each of steps) each.node.classList.toggle('here', each === step);
    const ownCount = steps.filter(each => !each.isFresh).length;
    place.textContent = step.isFresh ? say('freshOf', at - ownCount + 1) : say('stepOf', at + 1, ownCount);
    back.disabled = at === 0;
    light(step.lit, 'asked');
    step.exercise?.arrange();
    changed();
    reachWide();
  };
  // Fresh questions come when the lesson's own steps were gone through, one more as long as there are too few right ones.
  const canGoOn = () => {
    if (!asksFresh(steps)) return false;
    const fresh = freshOnes();
    return !fresh.length || (fresh.every(({exercise}) => exercise.isOver()) && cleanOnes() < data.fresh);
  };
  const another = () => {
    const unused = steps.filter(step => step.isFresh && !round.includes(step));
    // All were asked: those that were not right are asked once more.
    const pool = unused.length ? unused : freshOnes().filter(({state}) => state.points < STEP_POINTS);
    const step = pool[Math.floor(Math.random() * pool.length)];
    if (!unused.length) {
      round.splice(round.indexOf(step), 1);
      Object.assign(step.state, blank(step));
      step.exercise.restart();
    }
    round.push(step);
  };
  const goOn = () => {
    if (at === round.length - 1) {
      if (!canGoOn()) return;
      const missing = freshOnes().length ? 1 : Math.min(data.fresh, steps.filter(step => step.isFresh).length);
      for (let i = 0; i < missing; ++i) another();
    }
    go(Math.min(at + 1, round.length - 1));
    const {node, exercise} = round[at];
    section.scrollIntoView({block: 'start'});
    if (exercise) exercise.fields[0].focus({preventScroll: true});
    else node.querySelector('button')?.focus({preventScroll: true});
  };
  back.addEventListener('click', () => go(at - 1));
  next.addEventListener('click', goOn);

  const blank = ({question}) => ({texts: question ? question.fields.map(() => '') : [], points: 0, isChecked: false, isShown: false,
                                  isHinted: false, hints: 0, isClean: true});
  let nextQuestion = 0;
  steps = data.steps.map((step, i) => {
    const node = stepNodes[i];
    const question = step.isAsked ? questions[nextQuestion++] : null;
    const places = new Map();
    for (const mark of node.querySelectorAll('svg [data-id]')) {
      const key = keyOf(mark.dataset.list, mark.dataset.id);
      places.set(key, [...(places.get(key) || []), mark]);
    }
    for (const figure of node.querySelectorAll('figure')) {
      const svg = figure.querySelector('svg');
      svg.setAttribute('role', 'img');
      svg.setAttribute('aria-label', say('drawingOf', figure.dataset.title));
      addZoom(figure);
    }
    const made = {...step, node, question, places};
    const was = old?.states?.[i];
    made.state = Array.isArray(was?.texts) && was.texts.length === (question?.fields.length ?? 0) ? was : blank(made);
    return made;
  });
  for (const step of steps) {
    if (step.question) {
      step.exercise = new StepExercise(step.node, step.question, step.state, {changed, light, onward: goOn});
      step.exercise.hasNext = hasNext;
      step.exercise.onward.setAttribute('aria-label', say('nextStep'));
      if (step.isPicked) pickIn(step);
    } else {
      const onward = make('button', {type: 'button', class: 'primary', 'aria-label': say('nextStep')}, say('next'));
      onward.addEventListener('click', goOn);
      step.node.append(make('div', {class: 'controls'}, make('div', {class: 'bar'}, onward)));
    }
  }
  // A click on an element of the drawing picks it, and lets it go.
  function pickIn({node, exercise, question, elements: all}) {
    const labels = new Map(all.map(element => [element.key, element.label]));
    node.classList.add('picking');
    node.querySelector('figure').addEventListener('click', event => {
      const mark = event.target.closest('svg [data-id]');
      const label = mark && labels.get(keyOf(mark.dataset.list, mark.dataset.id));
      if (!label || !question.fields[0].options.includes(label) || exercise.isOver()) return;
      const picked = new Set(exercise.fields[0].get().split(',').filter(Boolean));
      if (!picked.delete(label)) picked.add(label);
      exercise.fields[0].set([...picked].join(','));
      exercise.write();
    });
  }
  const begin = () => {
    round = steps.filter(step => !step.isFresh);
    go(0);
  };
  const startAgain = make('button', {type: 'button'}, say('startAgain'));
  startAgain.addEventListener('click', () => {
    if (!window.confirm(say('lessonAgainSure'))) return;
    for (const step of steps) {
      Object.assign(step.state, blank(step));
      step.exercise?.restart();
    }
    begin();
    section.scrollIntoView({block: 'start'});
  });
  section.prepend(make('div', {class: 'bar walk'}, back, place, next));
  section.append(make('div', {class: 'bar handin'}, score, startAgain), make('p', {class: 'note'}, say('lessonKept')));
  section.classList.add('live');
  const known = (old?.round || []).map(i => steps[i]);
  const isKnown = known.length && known.every(Boolean) && steps.every(step => step.isFresh || known.includes(step));
  if (isKnown) {
    round = known;
    go(Number.isInteger(old.at) && round[old.at] ? old.at : 0);
  } else {
    begin();
  }
};

unpacked(byId('lesson-key').textContent.trim())
    .then(bytes => {
      const {questions, shown} = JSON.parse(new TextDecoder().decode(bytes));
      questions.forEach(({fields, table}, i) => {
        fields.forEach((field, j) => { field.title = shown[i].fields[j]; });
        if (table) table.columns = shown[i].columns;
      });
      showLesson(questions);
    })
    .catch(error => section.append(make('p', {class: 'reason', role: 'status'}, say('cannotGrade', error.message))));
