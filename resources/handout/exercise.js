// One question with fields, graded here (grader.js), with hints and verdict. Without scripts, and on paper, questions stand in
// the page with blanks.

const MOST_CHIPS = 24;  // options of a set that are buttons
const LONG_OPTION = 24;  // letters, from which on options are sentences below each other

// ---- Fields: {node, get, set, focus} each, over a text as in the files of answers ----

const textField = (field, label) => {
  const input = make('input', {type: 'text', 'aria-label': label, autocomplete: 'off', autocapitalize: 'off', spellcheck: 'false'});
  return {node: input, get: () => input.value, set: text => { input.value = text; }, focus: () => input.focus()};
};
const choiceField = (field, label) => {
  const list = make('select', {'aria-label': label}, make('option', {value: ''}, '\u2013'),
                    ...field.options.map(option => make('option', {value: option}, option)));
  return {node: list, get: () => list.value, set: text => {
    const word = trimmed(text);
    list.value = field.options.find(option => trimmed(option) === word) ?? '';
  }, focus: () => list.focus()};
};
// Sentences: a list that opens would cut them off.
let radioGroups = 0;
const sentenceField = (field, label) => {
  const group = make('div', {role: 'radiogroup', 'aria-label': label, class: 'sentences'});
  const name = `choice-${++radioGroups}`;
  const radios = field.options.map(option => make('input', {type: 'radio', name, value: option}));
  group.append(...radios.map((radio, i) => make('label', {}, radio, make('span', {}, field.options[i]))));
  return {node: group, get: () => radios.find(radio => radio.checked)?.value ?? '', set: text => {
    const word = trimmed(text);
    for (const radio of radios) radio.checked = trimmed(radio.value) === word;
  }, focus: () => (radios.find(radio => radio.checked) || radios[0]).focus()};
};
const setField = (field, label) => {
  const group = make('div', {role: 'group', 'aria-label': label, class: 'chips'});
  const chips = field.options.map(option => make('button', {type: 'button', 'aria-pressed': 'false'}, option));
  const isIn = chip => chip.getAttribute('aria-pressed') === 'true';
  for (const chip of chips) {
    chip.addEventListener('click', () => {
      chip.setAttribute('aria-pressed', String(!isIn(chip)));
      group.dispatchEvent(new Event('input', {bubbles: true}));
    });
  }
  group.append(...chips);
  return {node: group, get: () => field.options.filter((_, i) => isIn(chips[i])).join(','), set: text => {
    const names = setIn(field.options, trimmed(text)) || [];
    chips.forEach((chip, i) => chip.setAttribute('aria-pressed', String(names.includes(field.options[i]))));
  }, focus: () => chips[0].focus()};
};
const fieldFor = (field, label) => {
  if (field.kind === 'choice')
    return field.options.some(option => option.length > LONG_OPTION) ? sentenceField(field, label) : choiceField(field, label);
  if (field.kind === 'set' && field.options.length <= MOST_CHIPS) return setField(field, label);
  return textField(field, label);
};
const labelOf = ({table, fields}, at) => {
  if (!table) return shownName(fields[at]);
  const wide = table.columns.length;
  return say('cell', table.rows[Math.floor(at / wide)], table.columns[at % wide]);
};

// ---- What is kept: in the browser, where it may be; else until the page is closed ----

const kept = key => {
  try {
    return JSON.parse(localStorage.getItem(key));
  } catch (error) {
    return null;
  }
};
const keep = (key, value) => {
  try {
    localStorage.setItem(key, JSON.stringify(value));
  } catch (error) {
    // Nothing is kept where the browser forbids it.
  }
};

// ---- One question ----

class Exercise {
  // `state`: {texts, points, isChecked, isShown}; `changed` is called when it changes; `light` with elements and a mark; `onward`
  // goes to the next question, null for the last one.
  constructor(node, question, state, {changed, light, onward}) {
    Object.assign(this, {node, question, state, changed, light});
    this.fields = question.fields.map((field, i) => fieldFor(field, labelOf(question, i)));
    this.cells = this.fields.map((_, i) => node.querySelector(`[data-field="${i}"]`));
    this.fields.forEach((field, i) => {
      field.set(state.texts[i]);
      this.cells[i].replaceChildren(field.node);
      field.node.addEventListener('input', () => this.write());
      field.node.addEventListener('focusin', () => {
        this.at = i;
        if (!this.verdict) light(this.asked(), 'asked');
        this.showHint();
        if (!this.verdict) return;
        const mistake = this.verdict.mistakes.find(each => each.fields.includes(i));
        if (mistake) light(mistake.elements, 'wrong');
      });
      if (question.table) field.node.addEventListener('keydown', event => this.move(event, i));
    });
    this.at = 0;
    this.verdict = null;
    this.told = make('div', {class: 'verdict', role: 'status', tabindex: '-1'});
    this.check = this.button(say('check'), () => this.tell());
    this.again = this.button(say('tryAgain'), () => this.retry());
    for (const main of [this.check, this.again]) main.classList.add('primary');
    this.show = this.button(say('show'), () => this.reveal());
    this.onward = this.button(say('next'), onward || (() => {}));
    this.onward.setAttribute('aria-label', say('nextQuestion'));
    this.onward.classList.add('primary');
    this.isLast = !onward;
    this.takeHint();
    const parts = [this.told, this.hint, make('div', {class: 'bar'}, this.check, this.again, this.onward, this.ask, this.show)];
    if (question.table && question.fields.every(field => field.kind === 'integer')) parts.unshift(this.keys());
    this.controls = make('div', {class: 'controls'}, ...parts);
    node.append(this.controls);
    node.addEventListener('keydown', event => {
      if (event.key !== 'Enter' || event.target.closest('button')) return;
      event.preventDefault();
      if (!this.check.disabled) this.tell();
    });
    this.arrange();
    if (state.isShown) this.reveal();
    else if (state.isChecked) this.grade();
  }
  button(text, run) {
    const button = make('button', {type: 'button'}, text);
    button.addEventListener('click', run);
    return button;
  }
  // The hint of the page becomes one of the buttons, and says where to look as well.
  takeHint() {
    const folded = this.node.querySelector('details.hint');
    this.place = make('p', {class: 'where'});
    this.hint = make('div', {class: 'hint', id: this.node.getAttribute('aria-labelledby') + '-hint'},
                     ...[...folded.children].filter(each => each.tagName !== 'SUMMARY'), this.place);
    folded.remove();
    this.ask = this.button(say('hint'), () => {
      this.state.isHinted = !this.state.isHinted;
      this.showHint();
      this.changed();
    });
    this.ask.setAttribute('aria-controls', this.hint.id);
  }
  // What the field asks about, or else the question.
  asked() { return this.question.fields[this.at].elements || this.question.elements || []; }
  showHint() {
    const isOpen = Boolean(this.state.isHinted) && !this.ask.hidden;
    this.hint.hidden = !isOpen;
    this.ask.setAttribute('aria-expanded', String(isOpen));
    const names = [...new Set(this.asked().map(key => elements.get(key)?.mention).filter(Boolean))];
    this.place.hidden = !names.length;
    this.place.textContent = say('lookAt', listed(names));
    if (isOpen && !this.verdict && this.node.classList.contains('here')) this.light(this.asked(), 'asked');
  }
  // For those who have no keyboard at hand.
  keys() {
    const put = text => {
      const at = this.at;
      this.fields[at].set(text);
      this.write();
      this.fields[Math.min(at + 1, this.fields.length - 1)].focus();
    };
    return make('div', {class: 'bar keys', role: 'group', 'aria-label': say('fillKeys')},
                ...['\u22121', '0', '1'].map(text => this.button(text, () => put(text))));
  }
  move(event, at) {
    const {selectionStart, selectionEnd, value} = event.target;
    const wide = this.question.table.columns.length;
    const isText = value !== undefined && event.target.tagName === 'INPUT';
    const atStart = isText && selectionStart === 0 && selectionEnd === 0, atEnd = isText && selectionStart === value.length;
    const step = {ArrowUp: isText && -wide, ArrowDown: isText && wide, ArrowLeft: atStart && -1, ArrowRight: atEnd && 1}[event.key];
    if (!step || !this.fields[at + step]) return;
    event.preventDefault();
    this.fields[at + step].focus();
  }
  texts() { return this.fields.map(field => field.get()); }
  write() {
    if (this.state.isShown) return;
    this.state.texts = this.texts();
    this.state.isChecked = false;
    this.verdict = null;
    this.told.replaceChildren();
    this.mark([]);
    this.light([], 'wrong');
    this.arrange();
    this.changed();
  }
  arrange() {
    const {isShown} = this.state;
    this.check.disabled = isShown || Boolean(this.verdict);
    this.again.hidden = !this.verdict || this.verdict.isRight || isShown;
    this.show.hidden = isShown || Boolean(this.verdict && this.verdict.isRight);
    this.ask.hidden = this.show.hidden;
    this.onward.hidden = this.isLast || !this.show.hidden;  // beside the verdict
    this.showHint();
    this.node.classList.toggle('done', isShown || Boolean(this.verdict && this.verdict.isRight));
  }
  mark(wrong) {
    this.cells.forEach((cell, i) => {
      const isWrong = wrong.includes(i);
      cell.classList.toggle('wrong', isWrong);
      if (this.fields[i].node.tagName === 'DIV') return;  // a group has no such state; its cell shows it
      if (isWrong) this.fields[i].node.setAttribute('aria-invalid', 'true');
      else this.fields[i].node.removeAttribute('aria-invalid');
    });
  }
  tell() {
    this.grade();
    this.told.scrollIntoView({block: 'nearest'});
    // A button that can no longer be pressed loses the focus.
    if (this.node.contains(document.activeElement) && document.activeElement !== this.check) return;
    (this.verdict.isRight ? (this.isLast ? this.told : this.onward) : this.again).focus({preventScroll: true});
  }
  grade() {
    const {question, state} = this;
    const verdict = this.verdict = grade(question, this.texts());
    state.isChecked = !verdict.isBlank && !verdict.isUnreadable;  // what cannot be read is not wrong
    const points = this.pointsOf(verdict);
    state.points = Math.max(state.points, points);  // it never falls
    this.mark(verdict.wrongFields);
    const names = verdict.wrongFields.map(i => labelOf(question, i));
    const places = names.slice(0, 6).join('; ') + (names.length > 6 ? '; \u2026' : '');
    const title = verdict.isRight ? say(question.points === 1 ? 'rightOfOne' : 'rightOf', points, question.points)
                : verdict.isBlank ? '' : verdict.isUnreadable ? say('unreadableAt', places) : names.length ? say('wrongAt', places)
                               : say('wrong');
    const reasons = verdict.mistakes.length ? verdict.mistakes.map(mistake => mistake.reason) : [verdict.isRight ? verdict.reason : ''];
    const rest = question.fields.length - names.length;
    if (names.length && rest > 0 && hasOneAnswer(question))
      reasons.push(rest === 1 ? say('otherField') : say('otherFields', rest));
    if (!verdict.isRight && !verdict.mistakes.length) reasons.push(say('unknownMistake'));
    this.told.className = 'verdict ' + (verdict.isRight ? 'right' : 'wrong');
    this.told.replaceChildren(...(title ? [make('h4', {}, title)] : []), ...reasons.filter(Boolean).map(reason => make('p', {}, reason)));
    this.light(verdict.isRight ? [] : (verdict.mistakes[0]?.elements || []), 'wrong');
    this.arrange();
    this.changed();
  }
  pointsOf(verdict) { return verdict.points; }
  // Empties what is wrong, and nothing else; what cannot be read stays to be corrected.
  retry() {
    const {wrongFields: wrong, isUnreadable} = this.verdict;
    if (!isUnreadable) for (const i of wrong) this.fields[i].set('');
    this.write();
    this.fields[wrong.length ? wrong[0] : 0].focus();
  }
  // May the fields be filled in?
  setFilling(isOn) {
    for (const control of this.node.querySelectorAll('[data-field] input, [data-field] select, [data-field] button, .keys button'))
      control.disabled = !isOn;
  }
  // As if nobody had been here.
  restart() {
    this.verdict = null;
    this.at = 0;
    this.fields.forEach((field, i) => field.set(this.state.texts[i]));
    this.setFilling(true);
    this.told.className = 'verdict';
    this.told.replaceChildren();
    this.mark([]);
    this.light([], 'wrong');
    this.arrange();
  }
  // The learner's own texts are kept: they are what is handed in.
  reveal() {
    const {question, state} = this;
    state.isShown = true;
    state.points = 0;
    this.verdict = null;
    this.mark([]);
    this.fields.forEach((field, i) => field.set(question.solution[i]));
    this.setFilling(false);
    this.told.className = 'verdict shown';
    this.told.replaceChildren(make('h4', {}, say('shown')), make('p', {}, question.rule));
    this.light([], 'wrong');
    this.arrange();
    this.changed();
  }
}
