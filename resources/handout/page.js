// The page of a mechanism comes complete; this adds what moves: selection, inputs, parts.

// ---- Selection: one element at a time, lit wherever it stands ----

const elements = new Map(data.elements.map(element => [keyOf(element.list, element.id), element]));
// The turning joints of a mesh's cycle.
for (const element of elements.values()) element.cycle = element.walk && element.walk.slice(1).map(([joint]) => joint);
const places = new Map();  // key -> nodes
const addPlace = (key, node) => {
  if (!places.has(key)) places.set(key, []);
  places.get(key).push(node);
};
for (const node of document.querySelectorAll('svg [data-id]'))
  addPlace(keyOf(node.dataset.list, node.dataset.id), node);
for (const node of document.querySelectorAll('[data-el]'))
  for (const key of node.getAttribute('data-el').split(' ')) addPlace(key, node);

let selected = null;
const watchers = [];  // called with the key that is selected, or null
const mark = (key, name, isOn) => {
  for (const node of places.get(key) || []) node.classList.toggle(name, isOn);
};
const select = key => {
  if (selected) {
    mark(selected, 'lit', false);
    for (const joint of elements.get(selected).cycle || []) mark(joint, 'cycle', false);
  }
  selected = elements.has(key) ? key : null;
  if (selected) {
    mark(selected, 'lit', true);
    for (const joint of elements.get(selected).cycle || []) mark(joint, 'cycle', true);
  }
  for (const watcher of watchers) watcher(selected);
};

const keyAt = target => {
  const node = target.closest && target.closest('[data-el], svg [data-id]');
  if (!node) return null;
  const keys = node.getAttribute('data-el');  // formulas have no dataset in every browser
  return keys ? keys.split(' ')[0] : keyOf(node.dataset.list, node.dataset.id);
};
document.addEventListener('click', event => {
  if (event.target.closest('a, button, input, select, .card, canvas, .bar')) return;
  select(keyAt(event.target));
});
document.addEventListener('keydown', event => {
  if (event.key === 'Escape') select(null);
});
// What a mouse is over is lit, too; fingers hover over nothing.
let hovered = null;
document.addEventListener('pointerover', event => {
  const key = event.pointerType === 'mouse' && !event.target.closest('.card') ? keyAt(event.target) : null;
  if (key === hovered) return;
  if (hovered) mark(hovered, 'hovered', false);
  hovered = elements.has(key) ? key : null;
  if (hovered) mark(hovered, 'hovered', true);
});

// Drawings: one stop of Tab each, arrow keys walk the elements, Enter selects.
for (const svg of document.querySelectorAll('figure svg')) {
  const groups = [...svg.querySelectorAll('[data-id]')].filter(
      node => elements.has(keyOf(node.dataset.list, node.dataset.id)));
  const seen = new Set();
  const walk = groups.filter(node => {
    const key = keyOf(node.dataset.list, node.dataset.id);
    return !seen.has(key) && seen.add(key);
  });
  if (!walk.length) continue;
  svg.setAttribute('tabindex', '0');
  const caption = svg.parentNode.querySelector('figcaption');
  svg.setAttribute('aria-label', (caption ? caption.textContent + ' ' : '') + say('arrowKeys'));
  const status = make('p', {role: 'status', class: 'skip'});
  svg.after(status);
  let at = -1;
  const go = step => {
    if (at >= 0) walk[at].classList.remove('walked');
    at = (at + step + walk.length) % walk.length;
    walk[at].classList.add('walked');
    status.textContent = elements.get(keyOf(walk[at].dataset.list, walk[at].dataset.id)).name;
  };
  svg.addEventListener('keydown', event => {
    if (event.key === 'ArrowRight' || event.key === 'ArrowDown') go(1);
    else if (event.key === 'ArrowLeft' || event.key === 'ArrowUp') go(at < 0 ? 0 : -1);
    else if (event.key === 'Enter' && at >= 0) select(keyOf(walk[at].dataset.list, walk[at].dataset.id));
    else return;
    event.preventDefault();
  });
  svg.addEventListener('blur', () => { if (at >= 0) walk[at].classList.remove('walked'); });
}

for (const figure of document.querySelectorAll('#drawings figure')) addZoom(figure);

// ---- Inputs and results ----

const readRows = rows => rows.map(row => row.map(([joint, value]) => [joint, Rational.from(value)]));
const allRows = readRows(data.rows);
let inputs = [];  // positions of joints
let gains = null;
let motion = null;
const motionWatchers = [];  // called when rates or angles change

const showRates = () => {
  for (const cell of document.querySelectorAll('[data-now]')) {
    const rate = motion.rates[Number(cell.dataset.now)];
    cell.textContent = rate.toString();
    cell.title = spoken(rate.toNumber().toPrecision(6)) + ' rad/s';
  }
  const speeds = inputs.map((joint, i) => say('input', data.joints[joint].label, motion.speeds[i]));
  document.querySelector('#inputs .onpaper').textContent = say('inputs', speeds.join(', '));
  for (const watcher of motionWatchers) watcher();
};

const inputRow = (joint, i) => {
  const {name, label} = data.joints[joint];
  const range = make('input', {type: 'range', min: '-36', max: '36', step: '1', 'aria-label': say('speed', label)});
  const field = make('input', {type: 'text', inputmode: 'text', 'aria-label': say('exactSpeed', label)});
  const reason = make('p', {class: 'reason', role: 'status', hidden: ''});
  // A slider reaches three rad/s, or what was given where that is more.
  const reach = speed => {
    const most = Math.max(36, Math.ceil(Math.abs(speed.toNumber()) * 12));
    if (most > Number(range.max)) [range.min, range.max] = [String(-most), String(most)];
  };
  const show = () => {
    reach(motion.speeds[i]);
    range.value = String(Math.round(motion.speeds[i].toNumber() * 12));
    range.setAttribute('aria-valuetext', motion.speeds[i] + ' rad/s');
  };
  const take = (speed, isTyped) => {
    motion.take(motion.speeds.map((old, j) => (j === i ? speed : old)));
    if (!isTyped) field.value = speed.toString();
    field.setAttribute('aria-invalid', 'false');
    reason.hidden = true;
    show();
    showRates();
  };
  range.addEventListener('input', () => take(new Rational(BigInt(range.value), 12n), false));
  field.addEventListener('input', () => {
    const speed = Rational.from(field.value);
    if (speed) return take(speed, true);
    field.setAttribute('aria-invalid', 'true');
    reason.textContent = say('numbers');
    reason.hidden = false;
  });
  field.addEventListener('change', () => { field.value = motion.speeds[i].toString(); reason.hidden = true;
    field.setAttribute('aria-invalid', 'false'); });
  field.value = motion.speeds[i].toString();
  show();
  return make('div', {class: 'input', 'data-input': label}, make('span', {}, name), range, field,
              make('span', {}, 'rad/s'), reason);
};

// A head or a row of the table that selects its joint.
const placed = (node, joint) => {
  const key = keyOf('turningJoints', data.joints[joint].id);
  node.dataset.el = key;
  addPlace(key, node);
  return node;
};
const resultTable = () => {
  const heads = inputs.map(joint => placed(make('th', {scope: 'col'}, say('ofJoint', data.joints[joint].label)), joint));
  const body = make('tbody');
  data.joints.forEach((joint, at) => {
    if (inputs.includes(at)) return;
    const cells = gains[at].map(gain => make('td', {}, gain.toString()));
    body.append(placed(make('tr', {}, make('th', {scope: 'row'}, String(joint.label)), ...cells,
                            make('td', {class: 'now', 'data-now': String(at)})), at));
  });
  return [make('thead', {}, make('tr', {}, make('th', {scope: 'col'}, say('joint')), ...heads,
                                 make('th', {scope: 'col'}, say('nowHead')))), body];
};

// The rows hold, and these joints are driven. False where they are no valid inputs: nothing changes then.
const drive = (rows, joints, speeds) => {
  const found = joints.length ? gainsOf(rows, data.joints.length, joints) : null;
  if (!found) return false;
  inputs = joints;
  gains = found;
  motion = new Motion(gains, speeds, data.joints);
  const table = document.querySelector('#solution table.plain');
  if (table && table.querySelectorAll('td').length) table.replaceChildren(...resultTable());
  byId('inputs').replaceChildren(...inputs.map(inputRow), make('p', {class: 'onpaper'}));
  showRates();
  if (selected) select(selected);
  return true;
};
drive(allRows, data.inputs, data.speeds.map(text => Rational.from(text)));

// ---- Tabs ----

// On a wide page the tabs lead to its parts and follow the scroll; on a narrow one each shows its part alone.
// Of drawings, and of matrices, one is shown at a time; on paper, and without scripts, all of them.
const chooser = (id, label, pieces, first) => {
  const buttons = pieces.map(([name]) => make('button', {type: 'button', 'aria-pressed': 'false'}, name));
  const show = piece => pieces.forEach(([, nodes], i) => {
    const isShown = nodes.includes(piece);
    for (const node of nodes) node.classList.toggle('folded', !isShown);
    buttons[i].setAttribute('aria-pressed', String(isShown));
  });
  buttons.forEach((button, i) => button.addEventListener('click', () => {
    show(pieces[i][1][0]);
    reachWide();
  }));
  if (pieces.length < 2) return show;
  const heading = byId(id).querySelector('h2');
  const line = make('div', {class: 'headline'});
  heading.replaceWith(line);
  line.append(heading, make('div', {class: 'bar choice', role: 'group', 'aria-label': label}, ...buttons));
  show((pieces.find(([name]) => name.startsWith(first)) || pieces[0])[1][0]);
  return show;
};
const figures = [...document.querySelectorAll('#drawings figure')];
const showDrawing = chooser('drawings', say('drawing'), figures.map(figure => [figure.dataset.title, [figure]]),
                            figures.find(figure => figure.dataset.name === 'Digraph')?.dataset.title ?? '');
// A matrix is all that follows its heading.
const matrixPieces = [];
for (const node of document.querySelectorAll('#matrices > *')) {
  if (node.dataset.name) matrixPieces.push([node.dataset.name, []]);
  matrixPieces.at(-1)?.[1].push(node);
}
chooser('matrices', say('matrix'), matrixPieces, 'C');

// What the exercises ask for stands on the same page: it is covered until somebody wants it.
for (const id of byId('exercises') ? ['matrices', 'derivation', 'solution'] : []) {
  const section = byId(id);
  const reveal = make('button', {type: 'button', class: 'reveal'}, say('reveal'));
  reveal.addEventListener('click', () => {
    section.classList.remove('covered');
    reveal.remove();
    reachWide();
  });
  section.classList.add('covered');
  ['#inputs', '.headline', 'h2'].map(place => section.querySelector(place)).find(place => place).after(reveal);
}

const tabs = [...document.querySelectorAll('nav a')];
const narrow = window.matchMedia('(max-width: 900px)');
const setCurrent = current => {
  for (const tab of tabs) {
    if (tab === current) tab.setAttribute('aria-current', 'location');
    else tab.removeAttribute('aria-current');
  }
};
const showPart = tab => {
  setCurrent(tab);
  document.body.dataset.part = tab.hash.slice(1);
  reachWide();
};
const follow = () => {
  if (narrow.matches) return;
  let current = tabs[0];
  for (const tab of tabs) {
    const section = byId(tab.hash.slice(1));
    const stays = section.closest('aside') && getComputedStyle(section.closest('aside')).position === 'sticky';
    if (!stays && section.getBoundingClientRect().top < window.innerHeight / 3) current = tab;
  }
  setCurrent(current);
};
for (const tab of tabs) {
  tab.addEventListener('click', event => {
    if (!narrow.matches) return;
    event.preventDefault();
    showPart(tab);
    window.scrollTo(0, 0);
  });
}
const partAsked = () => tabs.find(tab => tab.hash === location.hash) || tabs.find(tab => tab.hash === '#solution');
const arrange = () => {
  if (narrow.matches) showPart(partAsked());
  else follow();
  reachWide();
};
narrow.addEventListener('change', arrange);
document.addEventListener('scroll', follow, {passive: true});
arrange();
