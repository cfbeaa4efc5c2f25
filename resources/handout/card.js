// The card of what is selected: its sentences, its equations from the derivation, and for a mesh the walk round its cycle.

const SVG = 'http://www.w3.org/2000/svg', MATHML = 'http://www.w3.org/1998/Math/MathML';
const BESIDE = 10;     // of the arrow of the walk from the edge, in units of the drawing
const STATIONS = 12;   // points along that arrow

// The paper's minus for what the script writes itself.
const labelOfElement = key => String(elements.get(key).label);
const printedSign = sign => (sign < 0 ? '\u22121' : '1');

// ---- Equations: copies of those in the page that speak of this element alone ----

const headingOver = node => {
  let above = node;
  while (above && !/^H[2-4]$/.test(above.tagName)) above = above.previousElementSibling;
  return above ? above.textContent : '';
};
// A line of an aligned formula is no formula by itself.
const formulaOf = node => {
  const math = node.matches('.equation') ? node.querySelector('math').cloneNode(true) : document.createElementNS(MATHML, 'math');
  if (!node.matches('.equation')) {
    const table = node.closest('mtable').cloneNode(false);
    table.append(node.cloneNode(true));
    math.setAttribute('display', 'block');
    math.append(table);
  }
  for (const each of math.querySelectorAll('[data-el]')) {
    each.removeAttribute('data-el');
    each.removeAttribute('class');
  }
  return math;
};
// Where the number stands in the page: a link, which on a narrow page opens the part first.
const numberLink = number => {
  const link = make('a', {class: 'number', href: '#' + number.id}, number.textContent);
  link.addEventListener('click', () => {
    const part = tabs.find(tab => tab.hash === '#' + number.closest('section').id);
    if (narrow.matches && part) showPart(part);
  });
  return link;
};
const equationsOf = key => {
  const list = make('div', {class: 'equations'});
  let last = '';
  for (const node of (places.get(key) || []).filter(each => each.matches('.equation, mtr'))) {
    const equation = node.closest('.equation');
    // The comparison of both methods repeats what has its number elsewhere.
    if (node === equation && !equation.querySelector('.number') && !equation.closest('#matrices')) continue;
    const heading = headingOver(equation);
    if (heading !== last) list.append(make('p', {class: 'from'}, heading));
    last = heading;
    const number = equation.querySelector('.number');
    list.append(make('div', {class: 'equation'}, make('div', {}, formulaOf(node)), ...(number ? [numberLink(number)] : [])));
  }
  return list;
};

// ---- The walk round a cycle, one edge for each press of a key or button ----

const digraph = document.querySelector('#drawings figure[data-name=Digraph] svg');
const drawn = (tag, attributes, ...children) => {
  const node = document.createElementNS(SVG, tag);
  for (const [name, value] of Object.entries(attributes)) node.setAttribute(name, value);
  node.append(...children);
  return node;
};
// The tag of a motor, a frame and its text, carries the joint's name, too, but is no part of its arrow.
const isTag = node => Boolean(node.querySelector('rect') || (node.querySelector('text') && node.previousElementSibling?.querySelector('rect')));
const groupsOf = key => [...digraph.querySelectorAll('[data-id]')]
    .filter(node => keyOf(node.dataset.list, node.dataset.id) === key && !isTag(node));

// An arrow beside the edge that runs as the walk does, on the side where the edge has no label, and the sign where no other
// sign, of those in `taken`, is near.
const walkArrow = (key, sign, taken) => {
  const groups = groupsOf(key);
  const path = groups.map(group => group.querySelector('path')).find(Boolean);
  if (!path) return null;
  const label = groups.map(group => group.querySelector('text')).find(Boolean);
  const long = path.getTotalLength();
  const along = at => path.getPointAtLength(at);
  const frame = at => {
    const [before, here, behind] = [along(Math.max(0, at - 1)), along(at), along(Math.min(long, at + 1))];
    const size = Math.hypot(behind.x - before.x, behind.y - before.y) || 1;
    return {here, normal: [-(behind.y - before.y) / size, (behind.x - before.x) / size]};
  };
  const middle = frame(long / 2);
  let side = 1;
  if (label) {
    const offset = [Number(label.getAttribute('x')) - middle.here.x, Number(label.getAttribute('y')) - 5 - middle.here.y];
    side = offset[0] * middle.normal[0] + offset[1] * middle.normal[1] > 0 ? -1 : 1;
  }
  const beside = (at, distance) => {
    const {here, normal} = frame(at);
    return [here.x + side * distance * normal[0], here.y + side * distance * normal[1]];
  };
  const points = [];
  for (let i = 0; i <= STATIONS; ++i) points.push(beside(long * (0.2 + 0.6 * i / STATIONS), BESIDE));
  if (sign < 0) points.reverse();
  const [end, before] = [points.at(-1), points.at(-2)];
  const size = Math.hypot(end[0] - before[0], end[1] - before[1]) || 1;
  const [x, y] = [(end[0] - before[0]) / size, (end[1] - before[1]) / size];
  const head = [[9 * x, 9 * y], [-4 * y, 4 * x], [4 * y, -4 * x]].map(([dx, dy]) => `${end[0] + dx},${end[1] + dy}`);
  const spots = [0.5, 0.36, 0.64, 0.24, 0.76].map(part => beside(long * part, BESIDE + 13));
  const isFree = spot => taken.every(other => Math.hypot(spot[0] - other[0], spot[1] - other[1]) > 2 * BESIDE);
  const [textX, textY] = spots.find(isFree) || spots[0];
  taken.push([textX, textY]);
  return drawn('g', {class: sign > 0 ? 'along' : 'against'},
               drawn('polyline', {points: points.map(point => point.join()).join(' '), fill: 'none'}),
               drawn('polygon', {points: head.join(' ')}),
               drawn('text', {x: textX, y: textY + 4.5, 'text-anchor': 'middle'}, printedSign(sign)));
};

// The cells of the edge in the rows of the mesh, in every matrix.
const cellsOf = (mesh, edge) => (places.get(mesh) || []).filter(row => row.matches('table.matrix tbody tr')).flatMap(row => {
  const heads = [...row.closest('table').querySelectorAll('thead th')];
  const at = heads.findIndex(head => head.dataset.el === edge);
  return at < 0 ? [] : [row.querySelectorAll('td')[at]];
});

class CycleWalk {
  // `ended` is called when the walk is left.
  constructor(key, ended) {
    Object.assign(this, {key, ended, at: -1, marked: []});
    this.steps = elements.get(key).walk;
    this.arrows = drawn('g', {class: 'cycle-arrows', 'aria-hidden': 'true', 'font-family': 'DejaVu Sans, Verdana, Arial, sans-serif'});
    this.status = make('p', {role: 'status', class: 'step'});
    this.stations = this.steps.map(() => make('li'));
    this.back = make('button', {type: 'button'}, say('back'));
    this.next = make('button', {type: 'button'}, say('next'));
    const end = make('button', {type: 'button'}, say('endWalk'));
    this.back.addEventListener('click', () => this.go(this.at - 1));
    this.next.addEventListener('click', () => this.go(this.at + 1));
    end.addEventListener('click', () => this.leave());
    this.node = make('div', {class: 'cycle-walk', role: 'group', 'aria-label': say('walkKeys')},
                     make('ol', {class: 'stations', 'aria-hidden': 'true'}, ...this.stations), this.status,
                     make('div', {class: 'bar'}, this.back, this.next, end));
    this.node.addEventListener('keydown', event => {
      const to = {ArrowRight: this.at + 1, ArrowLeft: this.at - 1, Home: 0, End: this.steps.length - 1}[event.key];
      if (event.key === 'Escape') this.leave();
      else if (to === undefined) return;
      else this.go(to);
      event.preventDefault();
      event.stopPropagation();
    });
  }
  begin() {
    const part = tabs.find(tab => tab.hash === '#drawings');
    if (narrow.matches) showPart(part);
    showDrawing(digraph.closest('figure'));
    digraph.append(this.arrows);
    digraph.classList.add('fading');
    this.go(0);
    digraph.scrollIntoView({block: 'start'});
    this.next.focus({preventScroll: true});
  }
  go(to) {
    if (to < 0 || to >= this.steps.length) return;
    this.at = to;
    this.clear();
    const gone = this.steps.slice(0, to + 1), taken = [];
    gone.forEach(([edge, sign], i) => {
      const nodes = groupsOf(edge).concat(cellsOf(this.key, edge));
      for (const node of nodes) {
        const names = ['passed', ...(i === to ? ['here'] : [])];
        node.classList.add(...names);
        this.marked.push([node, names]);
      }
      const arrow = walkArrow(edge, sign, taken);
      if (arrow) this.arrows.append(arrow);
      if (arrow && i === to) arrow.classList.add('here');
    });
    this.stations.forEach((station, i) => {
      const [edge, sign] = this.steps[i];
      station.className = i > to ? '' : (sign > 0 ? 'plus' : 'minus') + (i === to ? ' here' : '');
      station.replaceChildren(labelOfElement(edge), make('b', {}, i > to ? '\u00b7' : printedSign(sign)));
    });
    const isLast = to === this.steps.length - 1;
    this.status.textContent = say('walkStep', to + 1, this.steps.length, this.steps[to][2]) +
                              (isLast ? ' ' + say('walkClosed', labelOfElement(this.key)) : '');
    this.back.disabled = to === 0;
    this.next.disabled = isLast;
    // A button that can no longer be pressed loses the focus.
    if (this.node.contains(document.activeElement) && document.activeElement.disabled) (isLast ? this.back : this.next).focus();
  }
  clear() {
    for (const [node, names] of this.marked) node.classList.remove(...names);
    this.marked = [];
    this.arrows.replaceChildren();
  }
  stop() {
    this.clear();
    this.arrows.remove();
    digraph.classList.remove('fading');
  }
  leave() {
    this.stop();
    this.ended();
  }
}

// ---- The card ----

// Within the page's main part, at the bottom of what is seen of it: nothing stays hidden under it.
const card = make('div', {class: 'card', role: 'region', 'aria-label': say('selection'), hidden: ''});
document.querySelector('main').append(card);
let walk = null;
const rateLine = make('p', {class: 'rate'});
const showRate = () => {
  const [list, id] = (selected || '').split(/\/(.*)/);
  const joint = list === 'turningJoints' && motion ? data.joints.findIndex(each => each.id === id) : -1;
  rateLine.hidden = joint < 0;
  if (joint >= 0) rateLine.textContent = say('now', motion.rates[joint]);
};
motionWatchers.push(showRate);
const showCard = key => {
  if (walk) walk.stop();
  walk = null;
  card.classList.remove('walking');
  card.hidden = !key;
  if (!key) return;
  const element = elements.get(key);
  const close = make('button', {type: 'button', class: 'close', 'aria-label': say('clear')}, '\u00d7');
  close.addEventListener('click', () => select(null));
  const about = make('div', {class: 'about'}, make('div', {role: 'status'}, make('h2', {}, element.name),
                     ...element.lines.map(line => make('p', {}, line))), rateLine);
  const equations = equationsOf(key);
  if (element.walk && digraph) {
    const begin = make('button', {type: 'button', class: 'begin'}, '\u25b6 ' + say('walk'));
    begin.addEventListener('click', () => {
      walk = new CycleWalk(key, () => {
        walk.node.replaceWith(begin);
        walk = null;
        card.classList.remove('walking');
        begin.focus({preventScroll: true});
      });
      begin.replaceWith(walk.node);
      card.classList.add('walking');
      walk.begin();
    });
    about.append(begin);
  }
  card.replaceChildren(about, ...(equations.childElementCount ? [equations] : []), close);
  showRate();
  reachWide(card);
};
watchers.push(key => {
  // Another look at the same element, as when inputs are exchanged, leaves its walk alone.
  if (key !== null && walk && walk.key === key) return;
  showCard(key);
});
