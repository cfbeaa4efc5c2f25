// Handouts in a real browser, opened from disk as they are handed out, under their own policy.
import assert from 'node:assert/strict';
import test, {after, before} from 'node:test';
import {DESK, PAIRS, PHONE, barriers, handout, opened, quiet, start} from './browsers.mjs';

const name = process.env.GEARGRAPH_BROWSER;
const isFirefox = name.startsWith('firefox');
let browser;
before(async () => { browser = await start(name); });
after(async () => {
  await browser?.close();
});

// With exercises, which have to be as free of barriers as the rest. To open a train is most of what a test costs: each stays
// open, and a test leaves it as it found it.
const trains = new Map();
const open = async (example, {size = DESK, theme = 'light'} = {}) => {
  const key = [example, size.width].join();
  if (!trains.has(key)) trains.set(key, await opened(browser, handout(example, '--exercises'), size));
  const each = trains.get(key);
  await each.page.bringToFront();
  await each.page.evaluate(to => { document.documentElement.dataset.theme = to; }, theme);
  await ready(each.page);
  return each;
};
// Nothing selected, the train where it was.
const left = async each => {
  await each.page.keyboard.press('Escape');
  await each.page.click('[aria-label="To the reference pose"]');
  await quiet(each);
};
const ready = page => page.waitForSelector('#scene canvas');
const rates = page => page.$$eval('[data-now]', cells => cells.map(cell => cell.textContent));
// The picture on the canvas, as a number that changes with it.
const painted = page => page.evaluate(async () => {
  const canvas = document.querySelector('#scene canvas');
  await new Promise(done => requestAnimationFrame(done));
  canvas.dispatchEvent(new Event('none'));
  window.dispatchEvent(new Event('beforeprint'));
  const picture = document.querySelector('#scene img.printed').src;
  window.dispatchEvent(new Event('afterprint'));
  let sum = 0;
  for (let i = 0; i < picture.length; ++i) sum = (sum * 31 + picture.charCodeAt(i)) >>> 0;
  return sum;
});

// All others are opened, without three dimensions, by exercises.mjs.
test('trains of many forms open, without a complaint and without asking for anything', async () => {
  const names = ['robot', 'eight-speed-gearbox', 'spur-pair', 'humpage-reduction', 'ravigneaux', 'ferguson-paradox'];
  for (const example of isFirefox ? names.slice(0, 3) : names) {
    await quiet(await open(example));
  }
});

test('where the graphics are lost the still picture stands, until they are back', async () => {
  const each = await open('spur-pair');
  const {page} = each;
  const before = await painted(page);
  const seen = () => page.evaluate(() => {
    const {width} = document.querySelector('#scene img:not(.printed)').getBoundingClientRect();
    return [width > 0, document.querySelector('#scene canvas').getBoundingClientRect().width > 0];
  });
  assert.deepEqual(await seen(), [false, true]);
  await page.evaluate(() => {
    window.loss = document.querySelector('#scene canvas').getContext('webgl2').getExtension('WEBGL_lose_context');
    window.loss.loseContext();
  });
  await page.waitForFunction(() => document.querySelector('#scene canvas').hidden);
  assert.deepEqual(await seen(), [true, false]);
  await page.evaluate(() => window.loss.restoreContext());
  await page.waitForFunction(() => !document.querySelector('#scene canvas').hidden);
  assert.deepEqual(await seen(), [false, true]);
  assert.equal(await painted(page), before);
  await left(each);
});

test('the page is what it takes for the scene to be seen', async () => {
  const each = await open('robot');
  const colours = await each.page.evaluate(() => {
    window.dispatchEvent(new Event('beforeprint'));
    const picture = document.querySelector('#scene img.printed');
    return picture.decode().then(() => {
      const canvas = document.createElement('canvas');
      [canvas.width, canvas.height] = [90, 60];
      const context = canvas.getContext('2d');
      context.drawImage(picture, 0, 0, 90, 60);
      const {data} = context.getImageData(0, 0, 90, 60);
      const seen = new Set();
      for (let i = 0; i < data.length; i += 4) if (data[i + 3] > 128) seen.add([data[i] >> 5, data[i + 1] >> 5, data[i + 2] >> 5].join());
      return seen.size;
    });
  });
  assert.ok(colours > 12, `${colours} colours`);
  await left(each);
});

test('inputs drive the solution, in fractions; what is no number is refused with a reason', async () => {
  const each = await open('robot');
  const {page} = each;
  const before = await rates(page);
  const field = '[data-input="8"] input[type=text]';
  await page.$eval(field, input => { input.value = ''; });
  await page.type(field, '-3/4');
  assert.notDeepEqual(await rates(page), before);
  assert.equal((await rates(page))[0], '3/8');  // joint 10, at -1/2 of joint 8
  await page.type(field, '/');
  assert.equal(await page.$eval(field, input => input.getAttribute('aria-invalid')), 'true');
  assert.ok(await page.$eval('[data-input="8"] .reason', reason => !reason.hidden && reason.textContent.length > 0));
  await page.$eval('[data-input="8"] input[type=range]', range => {
    range.value = '12';
    range.dispatchEvent(new Event('input', {bubbles: true}));
  });
  assert.deepEqual(await rates(page), before);
  await left(each);
});

test('a click selects an element everywhere, Escape clears it, keys walk a drawing', async () => {
  const each = await open('robot');
  const {page} = each;
  const still = await painted(page);
  await page.evaluate(() => document.querySelector('table.matrix tr[data-el="gearMeshes/16"] th').click());
  const lit = () => page.$$eval('.lit', nodes => nodes.map(node => node.closest('svg') ? 'drawing' : node.closest('table') ? 'table' : 'text'));
  const places = await lit();
  assert.ok(places.includes('drawing') && places.includes('table'), places.join());
  assert.match(await page.$eval('.card h2', title => title.textContent), /Mesh 16/);
  assert.notEqual(await painted(page), still, 'the wheels of the mesh light up');
  await page.keyboard.press('Escape');
  assert.deepEqual(await lit(), []);
  assert.equal(await painted(page), still);
  await page.evaluate(() => document.querySelector('figure svg').focus());
  await page.keyboard.press('ArrowRight');
  await page.keyboard.press('Enter');
  assert.ok((await lit()).length > 0);
  await left(each);
});

const select = (page, key) => page.evaluate(each => document.querySelector(`table.matrix tr[data-el="${each}"] th`).click(), key);

test('the card has the equations of what is selected, as the derivation has them', async () => {
  const each = await open('robot');
  const {page} = each;
  const shown = () => page.$$eval('.card .equations > *', nodes => nodes.map(node => node.textContent.replace(/\s/g, '')));
  await select(page, 'gearMeshes/16');
  const equations = await shown();
  assert.equal(equations[0], 'RowsofPtimestherates(17)');
  assert.equal(equations[1], '20\u03b8\u02d99\u221220\u03b8\u02d910+30\u03b8\u02d912=0');
  // The terminal equation, and both f-circuits, with their numbers.
  for (const number of ['(20)', '(28)', '(31)', '(35)']) assert.ok(equations.some(text => text.endsWith(number)), equations.join());
  assert.ok(equations.includes('Terminalequations') && equations.includes('Fundamentalcircuits'));
  // Each is a copy of one of the page, and selects nothing.
  const copies = await page.evaluate(() => {
    const own = new Set([...document.querySelectorAll('section math, section mtr')].map(node => node.textContent));
    const math = [...document.querySelectorAll('.card math')];
    return [math.length, math.every(node => own.has(node.textContent)), document.querySelectorAll('.card [data-el], .card [id]').length];
  });
  assert.deepEqual(copies, [5, true, 0]);
  // A number leads to its place.
  await page.evaluate(() => [...document.querySelectorAll('.card a.number')].find(link => link.textContent === '(28)').click());
  assert.equal(await page.evaluate(() => document.querySelector(location.hash).closest('.equation').dataset.el), 'gearMeshes/16');
  // A joint has its rate, which follows the inputs, and the step that gives it.
  await page.evaluate(() => document.querySelector('table.matrix th[data-el="turningJoints/12"]').click());
  assert.equal(await page.$eval('.card .rate', line => line.textContent), 'Now \u22122/3 rad/s.');
  assert.ok((await shown()).includes('Solutionbysubstitution'));
  const drive = value => page.$eval('[data-input="8"] input[type=range]', (range, to) => {
    range.value = to;
    range.dispatchEvent(new Event('input', {bubbles: true}));
  }, value);
  await drive('24');
  assert.equal(await page.$eval('.card .rate', line => line.textContent), 'Now \u22121 rad/s.');
  await drive('12');
  // A link has none.
  await select(page, 'links/3');
  assert.deepEqual(await shown(), []);
  await left(each);
});

test('the cycle of a mesh is walked by keys, edge by edge, with sign and sentence', async () => {
  const each = await open('robot');
  const {page} = each;
  await page.emulateMediaFeatures?.([{name: 'prefers-reduced-motion', value: 'reduce'}]).catch(() => {});
  await select(page, 'gearMeshes/16');
  await page.evaluate(() => [...document.querySelectorAll('.choice button')].find(button => button.textContent === 'Schematic').click());
  await page.focus('.card .begin');
  await page.keyboard.press('Enter');
  const now = () => page.evaluate(() => {
    const svg = document.querySelector('figure[data-name=Digraph] svg');
    const edges = name => [...new Set([...svg.querySelectorAll(`[data-id].${name}`)].map(node => node.dataset.id))];
    return {sentence: document.querySelector('.cycle-walk .step').textContent, passed: edges('passed'), here: edges('here'),
            signs: [...svg.querySelectorAll('.cycle-arrows text')].map(text => text.textContent),
            cells: [...document.querySelectorAll('td.passed')].map(cell => cell.closest('.wide').getAttribute('aria-label')),
            isSeen: svg.getClientRects().length > 0};
  });
  const sentences = ['Along mesh 16, from link 5 to link 2: 1.', 'Against joint 12, from link 2 to link 1: \u22121.',
                     'Against joint 10, from link 1 to the ground: \u22121.', 'Along joint 9, from the ground to link 5: 1.'];
  const edges = ['16', '12', '10', '9'], signs = ['1', '\u22121', '\u22121', '1'];
  for (let at = 0; at < 4; ++at) {
    const {sentence, passed, here, signs: seen, isSeen} = await now();
    assert.ok(isSeen, 'the digraph is shown');
    assert.ok(sentence.startsWith(`${at + 1} of 4. ${sentences[at]}`), sentence);
    assert.deepEqual([passed.sort(), here, seen], [edges.slice(0, at + 1).sort(), [edges[at]], signs.slice(0, at + 1)]);
    await page.keyboard.press('ArrowRight');
  }
  const end = await now();
  assert.match(end.sentence, /^4 of 4\..*The walk is closed: row C16 has no other entries\.$/);
  // Every cell of the row in C, and those of the joints in T and in P, are marked.
  assert.deepEqual(end.cells.sort().filter(label => /cycle/i.test(label)).length, 4, end.cells.join());
  // Each arrow runs as the walk does: the one at joint 12 from link 2 to link 1.
  const runs = await page.evaluate(() => {
    const svg = document.querySelector('figure[data-name=Digraph] svg');
    const line = svg.querySelectorAll('.cycle-arrows polyline')[1].getAttribute('points').split(' ').map(point => point.split(',').map(Number));
    const path = svg.querySelector('[data-list=turningJoints][data-id="12"] path');
    const [from, to] = [path.getPointAtLength(0), path.getPointAtLength(path.getTotalLength())];
    const along = (to.x - from.x) * (line.at(-1)[0] - line[0][0]) + (to.y - from.y) * (line.at(-1)[1] - line[0][1]);
    const gap = Math.hypot(line[6][0] - (from.x + to.x) / 2, line[6][1] - (from.y + to.y) / 2);
    return [along < 0, Math.round(gap)];
  });
  assert.deepEqual(runs, [true, 10]);
  await page.keyboard.press('ArrowLeft');
  assert.ok((await now()).sentence.startsWith('3 of 4.'));
  // The buttons do the same, and keep the focus where something can be pressed.
  await page.evaluate(() => { for (let i = 0; i < 3; ++i) document.querySelector('.cycle-walk button').click(); });
  assert.ok((await now()).sentence.startsWith('1 of 4.'));
  await page.keyboard.press('Escape');
  const {passed, signs: none, cells} = await page.evaluate(() => ({
    passed: document.querySelectorAll('.passed, .fading').length, signs: document.querySelectorAll('.cycle-arrows').length, cells: document.querySelectorAll('td.here').length}));
  assert.deepEqual([passed, none, cells], [0, 0, 0]);
  assert.equal(await page.evaluate(() => document.activeElement.className), 'begin', 'and Escape leaves the selection');
  // Another selection ends a walk.
  await page.keyboard.press('Enter');
  await select(page, 'gearMeshes/17');
  assert.equal(await page.evaluate(() => document.querySelectorAll('.passed, .fading, .cycle-arrows, .cycle-walk').length), 0);
  await left(each);
});

test('one drawing and one matrix are shown at a time, all on paper', async () => {
  const each = await open('robot');
  const {page} = each;
  const shown = () => page.evaluate(() => ['#drawings figure', '#matrices h3[data-name]'].map(selector =>
    [...document.querySelectorAll(selector)].filter(node => node.getClientRects().length > 0).map(node => node.dataset.name).join()));
  const choose = text => page.evaluate(name => [...document.querySelectorAll('.choice button')].find(button => button.textContent.startsWith(name)).click(), text);
  await choose('Digraph');
  await choose('C');
  assert.deepEqual(await shown(), ['Digraph', 'C = [T | U]']);
  const rows = () => page.$eval('#matrices .equation[data-el="gearMeshes/16"]', row => row.getClientRects().length > 0);
  assert.equal(await rows(), false, 'the equations go with P');
  await choose('T-T');
  await choose('P');
  assert.deepEqual(await shown(), ['T-T graph', 'P']);
  assert.equal(await rows(), true);
  if (!isFirefox) {  // which has no such switch
    await page.emulateMediaType('print');
    const [drawings, matrices] = await shown();
    assert.deepEqual([drawings.split(',').length, matrices.split(',').length], [3, 7]);
    await page.emulateMediaType(null);
  }
  await choose('Digraph');
  await choose('C');
  await left(each);
});

test('the train turns: played, scrubbed, by keys, and back', async () => {
  const each = await open('planetary-ring-held');
  const {page} = each;
  const still = await painted(page);
  const play = await page.evaluateHandle(() => [...document.querySelectorAll('#train button')].find(each => /Play/.test(each.textContent)));
  await play.click();
  await page.waitForFunction(() => Number(document.querySelector('[aria-label=Time]').value) > 0);
  await play.click();
  assert.notEqual(await painted(page), still);
  await page.click('[aria-label="To the reference pose"]');
  assert.equal(await painted(page), still);
  await page.$eval('[aria-label=Time]', range => {
    range.value = '250';
    range.dispatchEvent(new Event('input', {bubbles: true}));
  });
  const scrubbed = await painted(page);
  assert.notEqual(scrubbed, still);
  await page.focus('#scene canvas');
  await page.keyboard.press('ArrowLeft');
  assert.notEqual(await painted(page), scrubbed, 'arrow keys orbit');
  await left(each);
});

test('a joint stops at its limit and says so', async () => {
  const each = await open('robot');
  const {page} = each;
  await page.$eval('[aria-label=Time]', range => {
    range.value = '999';
    range.dispatchEvent(new Event('input', {bubbles: true}));
  });
  assert.match(await page.$eval('.time', text => text.textContent), /^Joint \d+ is at its limit of .*°\.$/);
  await page.focus('#scene canvas');
  await page.keyboard.press('Space');
  await page.waitForFunction(() => /the motion turns round\.$/.test(document.querySelector('.time').textContent));
  const time = () => page.$eval('[aria-label=Time]', range => Number(range.value));
  const atLimit = await time();
  await page.waitForFunction(from => Number(document.querySelector('[aria-label=Time]').value) < from, {}, atLimit);
  await page.keyboard.press('Space');
  await left(each);
});

test('states of a gearbox are put in by a click', async () => {
  const each = await open('eight-speed-gearbox');
  const {page} = each;
  const buttons = await page.$$('tr[data-state] button');
  assert.ok(buttons.length >= 8, `${buttons.length} states`);
  const seen = new Set();
  for (const button of buttons) {
    await button.evaluate(each => each.click());
    seen.add((await rates(page)).join());
    assert.equal(await button.evaluate(each => each.getAttribute('aria-pressed')), 'true');
  }
  assert.equal(seen.size, buttons.length, 'each has speeds of its own');
  await left(each);
});

test('a drawing is seen by itself, as large as is wanted, and goes back', async () => {
  const each = await open('robot');
  const {page} = each;
  const figure = '#drawings figure:not(.folded)';
  await page.focus(`${figure} .larger`);
  await page.keyboard.press('Enter');
  const width = () => page.$eval('.zoom svg', node => node.getBoundingClientRect().width);
  const before = await width();
  await page.keyboard.press('+');
  assert.ok(await width() > 1.2 * before);
  await page.keyboard.press('-');
  assert.ok(Math.abs(await width() - before) < 1);
  assert.deepEqual(await barriers(page, '.zoom'), []);
  await page.keyboard.press('Escape');
  await page.waitForFunction(() => !document.querySelector('.zoom'));
  assert.equal(await page.$$eval(`${figure} svg`, nodes => nodes.length), 1);
  assert.ok(await page.$eval(`${figure} .larger`, node => node === document.activeElement));
  await left(each);
});

test('on a phone, either way up, nothing is wider than the page and the train leaves room', async () => {
  for (const size of [PHONE, {width: 844, height: 390, isMobile: false}]) {
    const each = await open('robot', {size});
    const {page} = each;
    for (const part of ['drawings', 'matrices', 'solution', 'derivation', 'exercises']) {
      await page.evaluate(id => document.querySelector(`nav a[href="#${id}"]`).click(), part);
      assert.ok(await page.evaluate(() => document.documentElement.scrollWidth <= window.innerWidth), `${part} at ${size.width}`);
    }
    await page.evaluate(() => document.querySelector('nav a[href="#solution"]').click());
    const {height} = await page.$eval('#scene canvas', node => node.getBoundingClientRect().toJSON());
    assert.ok(height > 50 && height <= 0.6 * size.height + 1, String(height));
    if (size === PHONE) {
      // Where a matrix goes on it fades, until it is scrolled to its end.
      await page.evaluate(() => document.querySelector('nav a[href="#matrices"]').click());
      const wide = '#matrices .wide:not(.folded)';
      assert.equal(await page.$eval(wide, node => node.dataset.more), 'right');
      await page.$eval(wide, node => { node.scrollLeft = node.scrollWidth; });
      await page.waitForFunction(place => document.querySelector(place).dataset.more === 'left', {}, wide);
      await page.evaluate(() => document.querySelector('nav a[href="#solution"]').click());
    }
    await quiet(each);
  }
});

test('speeds on the levers follow the inputs, a line of the nomogram puts its state in', async () => {
  const each = await open('simpson');
  const {page} = each;
  const choose = text => page.evaluate(name => [...document.querySelectorAll('.choice button')].find(button => button.textContent.startsWith(name)).click(), text);
  const values = () => page.$$eval('.lever-speeds text', all => all.map(text => text.textContent));
  await choose('Levers');
  const before = await values();
  assert.equal(before.length, 4, 'a bar of four points');
  // The tips of the arrows are on the line through those of both ends.
  const off = await page.evaluate(() => {
    const points = document.querySelector('.speed-line').getAttribute('points').split(' ').map(each => each.split(',').map(Number));
    const [[x0, y0], [x1, y1]] = [points[0], points.at(-1)];
    return Math.max(...points.map(([x, y]) => Math.abs((x - x0) * (y1 - y0) - (x1 - x0) * (y - y0)) / Math.hypot(x1 - x0, y1 - y0)));
  });
  assert.ok(off < 1e-6, `${off} beside the line`);
  await page.$eval('#inputs input[type=text]', field => {
    field.value = '2';
    field.dispatchEvent(new Event('input', {bubbles: true}));
  });
  assert.notDeepEqual(await values(), before);
  await choose('Nomogram');
  const second = await page.$$eval('.state-line', lines => lines.findIndex(line => line.textContent === '2'));
  await page.evaluate(at => document.querySelectorAll('.state-line')[at].dispatchEvent(new MouseEvent('click', {bubbles: true})), second);
  assert.equal(await page.$$eval('.state-line.in', lines => lines.map(line => line.textContent).join()), '2');
  assert.equal(await page.$eval('tr[data-state].in th', head => head.textContent), '2');
  assert.ok((await values()).includes(''), 'what a brake holds has no number');
  await left(each);
});

test('on a phone each part is a page of its own', async () => {
  const each = await open('robot', {size: PHONE});
  const {page} = each;
  const shown = () => page.$$eval('section', all => all.filter(each => each.offsetHeight > 0).map(each => each.id));
  assert.deepEqual(await shown(), ['train', 'solution']);
  for (const part of ['matrices', 'drawings', 'derivation', 'exercises']) {
    await page.click(`nav a[href="#${part}"]`);
    assert.deepEqual(await shown(), [part]);
    const [wide, view] = await page.evaluate(() => [document.documentElement.scrollWidth, window.innerWidth]);
    assert.ok(wide <= view, `${part} is ${wide} px wide`);
    const broken = await page.$$eval('table.matrix th', heads => heads.filter(head => head.offsetHeight > 60).map(head => head.textContent));
    assert.deepEqual(broken, [], 'a label stays on its line');
  }
  await page.click('nav a[href="#solution"]');
  await left(each);
});

for (const [where, size, theme] of isFirefox ? [] : PAIRS) {
  test(`axe-core finds nothing: ${where}, ${theme}`, async () => {
    const each = await open('robot', {size, theme});
    const {page} = each;
    // What is hidden would not be looked at: all drawings and matrices are unfolded, and on a phone each part is opened.
    await page.evaluate(() => { for (const node of document.querySelectorAll('.folded')) node.classList.remove('folded'); });
    assert.deepEqual(await barriers(page), []);
    for (const part of size === PHONE ? ['drawings', 'matrices', 'derivation', 'exercises'] : []) {
      await page.click(`nav a[href="#${part}"]`);
      assert.deepEqual(await barriers(page, '#' + part), [], part);
    }
    await page.evaluate(() => { for (const bar of document.querySelectorAll('.choice')) bar.querySelector('[aria-pressed=true]').click(); });
    await select(page, 'gearMeshes/16');
    assert.deepEqual(await barriers(page, '.card'), [], 'the card');
    await page.evaluate(() => document.querySelector('.card .begin').click());
    for (let at = 0; at < 2; ++at) await page.keyboard.press('ArrowRight');
    assert.deepEqual(await barriers(page, '.card'), [], 'the walk');
    const [wide, view] = await page.evaluate(() => [document.documentElement.scrollWidth, window.innerWidth]);
    assert.ok(wide <= view, `${wide} px wide`);
    await page.keyboard.press('Escape');
    if (size === PHONE) await page.click('nav a[href="#solution"]');
    await left(each);
  });
}

test('without scripts all parts and the still picture are there', async () => {
  const quiet = isFirefox ? await start(name, {extraPrefsFirefox: {'javascript.enabled': false}}) : browser;
  const page = await quiet.newPage();
  if (!isFirefox) await page.setJavaScriptEnabled(false);
  await page.setViewport(DESK);
  await page.goto(handout('robot'));
  if (isFirefox) {
    // Nothing can be asked of a page without scripts here: what it paints is compared with an empty sheet.
    const picture = await page.screenshot();
    assert.ok(picture.length > 40000, `${picture.length} bytes`);
    await quiet.close();
    return;
  }
  const client = await page.createCDPSession();
  const {root} = await client.send('DOM.getDocument', {depth: -1});
  const {nodeIds} = await client.send('DOM.querySelectorAll', {nodeId: root.nodeId, selector: 'section, #scene img, figure svg, table.matrix, math'});
  assert.ok(nodeIds.length > 40, `${nodeIds.length} parts`);
  const {nodeIds: controls} = await client.send('DOM.querySelectorAll', {nodeId: root.nodeId, selector: 'button, input, select, canvas'});
  assert.equal(controls.length, 0);
  await page.close();
});
