// What every page needs: its data, parts, what scrolls sideways, light or dark, print.

const data = JSON.parse(document.getElementById('mechanism').textContent);
const byId = id => document.getElementById(id);
const make = (tag, attributes = {}, ...children) => {
  const node = document.createElement(tag);
  for (const [name, value] of Object.entries(attributes)) node.setAttribute(name, value);
  node.append(...children);
  return node;
};
const keyOf = (list, id) => list + '/' + id;
// Packed data: gzip in base64.
const unpacked = async text => {
  const packed = Uint8Array.from(atob(text), letter => letter.charCodeAt(0));
  const stream = new Blob([packed]).stream().pipeThrough(new DecompressionStream('gzip'));
  return new Response(stream).arrayBuffer();
};

// ---- What is wider than the page ----

// Tables that stand in the text scroll by themselves, too.
for (const table of document.querySelectorAll('section table')) {
  if (table.closest('.wide')) continue;
  const around = make('div', {class: 'wide'});
  table.replaceWith(around);
  around.append(table);
}
// Where something goes on beyond an edge.
const showMore = node => {
  const [left, right] = [node.scrollLeft > 1, node.scrollLeft + node.clientWidth < node.scrollWidth - 1];
  if (left || right) node.dataset.more = left && right ? 'both' : left ? 'left' : 'right';
  else delete node.dataset.more;
};
// What scrolls sideways can be scrolled by keys, and shows that it goes on.
function reachWide(part = document) {
  for (const node of part.querySelectorAll('.equation > div, .wide')) {
    if (node.scrollWidth > node.clientWidth || node.hasAttribute('role')) node.setAttribute('tabindex', '0');
    else node.removeAttribute('tabindex');
    showMore(node);
  }
}
document.addEventListener('scroll', event => {
  if (event.target.matches?.('.equation > div, .wide')) showMore(event.target);
}, {capture: true, passive: true});
window.addEventListener('resize', () => reachWide());

// ---- Header ----

const theme = make('button', {type: 'button', 'aria-label': say('theme')}, '\u25d0');
theme.addEventListener('click', () => {
  const dark = getComputedStyle(document.documentElement).colorScheme === 'dark';
  document.documentElement.dataset.theme = dark ? 'light' : 'dark';
});
const print = make('button', {type: 'button'}, say('print'));
print.addEventListener('click', () => window.print());
document.querySelector('header').append(theme, print);
