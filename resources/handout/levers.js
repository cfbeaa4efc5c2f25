// Levers: the speeds of the links as arrows on their bars, which follow the inputs; the state that is in, on the nomogram.

const SPEED_REACH = 96;   // of the greatest speed, in units of the drawing
const SPEED_MARGIN = 90;  // beside the bars, for arrows and numbers

const leverSheet = document.querySelector('#drawings figure[data-name=Levers] svg');
const nomogramSheet = document.querySelector('#drawings figure[data-name=Nomogram] svg');

// ---- Levers ----

const leverBars = leverSheet ? data.levers.map(bar => ({
  line: drawn('polyline', {fill: 'none', stroke: '#1d2126', 'stroke-width': '1.4', class: 'speed-line'}),
  points: bar.map(point => ({
    ...point,
    shaft: drawn('polyline', {fill: 'none', stroke: point.colour, 'stroke-width': '3'}),
    head: drawn('polygon', {fill: point.colour}),
    value: drawn('text', {'font-size': '12', 'font-weight': 'bold', fill: '#1d2126'}),
  })),
})) : [];

const speedOf = point => point.terms.reduce(
    (sum, [joint, sign]) => sign > 0 ? sum.plus(motion.rates[joint]) : sum.minus(motion.rates[joint]), new Rational(0n));

const showSpeeds = () => {
  const speeds = leverBars.map(bar => bar.points.map(point => motion ? speedOf(point) : new Rational(0n)));
  const most = Math.max(0, ...speeds.flat().map(speed => Math.abs(speed.toNumber())));
  const scale = most > 0 && Number.isFinite(most) ? SPEED_REACH / most : 0;
  leverBars.forEach((bar, i) => {
    const tips = bar.points.map((point, at) => point.x + scale * speeds[i][at].toNumber());
    bar.line.setAttribute('points', bar.points.map((point, at) => `${tips[at]},${point.y}`).join(' '));
    bar.line.toggleAttribute('hidden', !scale);
    bar.points.forEach((point, at) => {
      const speed = speeds[i][at];
      const side = Math.sign(tips[at] - point.x);
      const back = tips[at] - side * Math.min(9, Math.abs(tips[at] - point.x));
      point.shaft.setAttribute('points', `${point.x},${point.y} ${back},${point.y}`);
      point.head.setAttribute('points', side ? `${tips[at]},${point.y} ${back},${point.y - 4} ${back},${point.y + 4}` : '');
      const beyond = side < 0 ? Math.min(tips[at], point.x - 17) - 5 : Math.max(tips[at], point.x + 17) + 5;
      point.value.setAttribute('x', beyond);
      point.value.setAttribute('y', point.y - 3);
      point.value.setAttribute('text-anchor', side < 0 ? 'end' : 'start');
      // A speed is not written as 0 unless it is; what is at rest has none.
      const decimals = speed.toDecimals(3);
      point.value.textContent = scale && side ? spoken(decimals === '0' ? speed.toString() : decimals) : '';
    });
  });
};

if (leverSheet) {
  const {x, y, width, height} = leverSheet.viewBox.baseVal;
  leverSheet.setAttribute('viewBox', `${x - SPEED_MARGIN} ${y} ${width + 2 * SPEED_MARGIN} ${height}`);
  leverSheet.setAttribute('width', width + 2 * SPEED_MARGIN);
  const arrows = drawn('g', {class: 'lever-speeds', 'font-family': 'DejaVu Sans, Verdana, Arial, sans-serif'});
  for (const bar of leverBars) {
    arrows.append(bar.line);
    for (const point of bar.points) {
      const [list, id] = point.element.split(/\/(.*)/);
      const arrow = drawn('g', {'data-list': list, 'data-id': id}, point.shaft, point.head, point.value);
      addPlace(point.element, arrow);
      arrows.append(arrow);
    }
  }
  // Under the discs with their labels.
  const disc = [...leverSheet.querySelectorAll('[data-list=links]')].find(node => node.dataset.id && node.querySelector('rect'));
  disc.before(arrows);
  motionWatchers.push(showSpeeds);
  showSpeeds();
}

// ---- Nomogram ----

const stateMarks = [];  // [state, node]
const stateMark = (states, node) => {
  node.addEventListener('click', event => {
    event.stopPropagation();
    const shown = stateMarks.find(([, each]) => each.classList.contains('in'))?.[0];
    putIn(states[(states.indexOf(shown) + 1) % states.length]);
  });
  for (const state of states) stateMarks.push([state, node]);
  return node;
};
if (nomogramSheet) {
  const marks = drawn('g', {class: 'state-marks'});
  for (const [state, ...[x1, y1, x2, y2]] of data.nomogram.lines) {
    const name = drawn('title', {}, data.states[state].name);
    marks.append(stateMark([state], drawn('line', {x1, y1, x2, y2, class: 'state-line'}, name)));
  }
  for (const {states, box: [x, y, width, height]} of data.nomogram.tags)
    marks.append(stateMark(states, drawn('rect', {x, y, width, height, rx: '4', class: 'state-tag'})));
  nomogramSheet.append(marks);
  const showState = at => {
    for (const [, node] of stateMarks) node.classList.remove('in');
    for (const [state, node] of stateMarks) if (state === at) node.classList.add('in');
  };
  stateWatchers.push(showState);
  showState(data.state);
}
