// A drawing for itself, as large as is wanted. It is the same one, so that what is selected stays lit.
const zoomStep = 1.25;
const enlarge = (figure, opener) => {
  const svg = figure.querySelector('svg');
  const home = document.createComment('');
  const box = svg.viewBox.baseVal;
  const drawing = make('div', {class: 'drawing', tabindex: '0', role: 'region', 'aria-label': figure.dataset.title});
  const title = make('h2', {}, figure.dataset.title);
  const button = (text, label, run) => {
    const node = make('button', {type: 'button', 'aria-label': label}, text);
    node.addEventListener('click', run);
    return node;
  };
  const dialog = make('dialog', {class: 'zoom', 'aria-label': figure.dataset.title});
  let width = 0;
  const resize = to => {
    const [x, y] = [(drawing.scrollLeft + drawing.clientWidth / 2) / (width || 1), (drawing.scrollTop + drawing.clientHeight / 2) / (width || 1)];
    width = Math.min(8 * box.width, Math.max(120, to));
    svg.style.width = width + 'px';
    drawing.scrollTo(x * width - drawing.clientWidth / 2, y * width - drawing.clientHeight / 2);
  };
  const fit = () => resize(Math.min(drawing.clientWidth, drawing.clientHeight * box.width / box.height));
  dialog.append(make('div', {class: 'bar'}, title, button('\u2212', say('smaller'), () => resize(width / zoomStep)),
                     button('+', say('larger'), () => resize(width * zoomStep)), button(say('fit'), say('fitWindow'), fit),
                     button('\u00d7', say('close'), () => dialog.close())), drawing);
  svg.replaceWith(home);
  drawing.append(svg);
  document.body.append(dialog);
  dialog.addEventListener('keydown', event => {
    if (event.key === '+' || event.key === '=') resize(width * zoomStep);
    else if (event.key === '-') resize(width / zoomStep);
    else return;
    event.preventDefault();
  });
  dialog.addEventListener('close', () => {
    svg.style.width = '';
    home.replaceWith(svg);
    dialog.remove();
    opener.focus();
  });
  dialog.showModal();
  fit();
};
const addZoom = figure => {
  const opener = make('button', {type: 'button', class: 'larger', 'aria-label': say('enlarge', figure.dataset.title), title: say('enlarge', figure.dataset.title)}, '\u2922');
  opener.addEventListener('click', () => enlarge(figure, opener));
  figure.querySelector('figcaption').before(opener);
};
