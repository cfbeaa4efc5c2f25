// States of a gearbox: each puts its brakes and clutches in, as rows below those of the meshes.

const stateWatchers = [];  // called with the position of the state that is in
const stateRows = [...document.querySelectorAll('[data-state]')];
const putIn = at => {
  const state = data.states[at];
  const rows = allRows.slice(0, data.meshRows).concat(readRows(state.rows));
  if (!drive(rows, state.inputs, state.speeds.map(text => Rational.from(text)))) return;
  // Both methods were compared for the state that the page was made for.
  const agreement = document.querySelector('.agreement');
  if (agreement) agreement.hidden = at !== data.state;
  for (const row of stateRows) {
    const isIn = Number(row.dataset.state) === at;
    row.classList.toggle('in', isIn);
    row.querySelector('button')?.setAttribute('aria-pressed', String(isIn));
  }
  for (const watcher of stateWatchers) watcher(at);
};
for (const row of stateRows) {
  const at = Number(row.dataset.state);
  if (!data.states[at].inputs.length) continue;
  const head = row.querySelector('th');
  const button = make('button', {type: 'button', 'aria-pressed': String(at === data.state)}, head.textContent);
  button.addEventListener('click', () => putIn(at));
  head.replaceChildren(button);
  row.classList.toggle('in', at === data.state);
}
