// Handouts in a real browser, opened from disk as they are handed out, under their own policy.
import assert from 'node:assert/strict';
import test, {after, before} from 'node:test';
import {DESK, PAIRS, PHONE, barriers, closed, handoutsIn, opened, start} from './browsers.mjs';

const name = process.env.GEARGRAPH_BROWSER;
const isFirefox = name.startsWith('firefox');
// With exercises, which have to be as free of barriers as the rest.
const pages = handoutsIn('pages');
const handout = example => pages(example, '--exercises');
let browser;
before(async () => { browser = await start(name); });
after(async () => {
  await browser?.close();
  });

const open = async (example, {size = DESK, theme = 'light'} = {}) => {
  const each = await opened(browser, handout(example), size);
  if (theme === 'dark') await each.page.evaluate(() => { document.documentElement.dataset.theme = 'dark'; });
  return each;
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
    const each = await open(example);
    await ready(each.page);
    await closed(each);
  }
});

test('where the graphics are lost the still picture stands, until they are back', async () => {
  const each = await open('spur-pair');
  const {page} = each;
  await ready(page);
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
  await closed(each);
});

test('the page is what it takes for the scene to be seen', async () => {
  const each = await open('robot');
  await ready(each.page);
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
  await closed(each);
});

test('inputs drive the solution, in fractions; what is no number is refused with a reason', async () => {
  const each = await open('robot');
  const {page} = each;
  await ready(page);
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
  await closed(each);
});

test('a click selects an element everywhere, Escape clears it, keys walk a drawing', async () => {
  const each = await open('robot');
  const {page} = each;
  await ready(page);
  const still = await painted(page);
  await page.evaluate(() => document.querySelector('table.matrix tr[data-el="gearMeshes/16"] th').click());
  const lit = () => page.$$eval('.lit', nodes => nodes.map(node => node.closest('svg') ? 'drawing' : node.closest('table') ? 'table' : 'text'));
  const places = await lit();
  assert.ok(places.includes('drawing') && places.includes('table'), places.join());
  assert.match(await page.$eval('.card h3', title => title.textContent), /Mesh 16/);
  assert.notEqual(await painted(page), still, 'the wheels of the mesh light up');
  await page.keyboard.press('Escape');
  assert.deepEqual(await lit(), []);
  assert.equal(await painted(page), still);
  await page.evaluate(() => document.querySelector('figure svg').focus());
  await page.keyboard.press('ArrowRight');
  await page.keyboard.press('Enter');
  assert.ok((await lit()).length > 0);
  await closed(each);
});

test('the train turns: played, scrubbed, by keys, and back', async () => {
  const each = await open('planetary-ring-held');
  const {page} = each;
  await ready(page);
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
  await closed(each);
});

test('a joint stops at its limit and says so', async () => {
  const each = await open('robot');
  const {page} = each;
  await ready(page);
  await page.$eval('[aria-label=Time]', range => {
    range.value = '999';
    range.dispatchEvent(new Event('input', {bubbles: true}));
  });
  assert.match(await page.$eval('.time', text => text.textContent), /^Joint \d+ is at its limit of .*°\.$/);
  await closed(each);
});

test('states of a gearbox are put in by a click', async () => {
  const each = await open('eight-speed-gearbox');
  const {page} = each;
  await ready(page);
  const buttons = await page.$$('tr[data-state] button');
  assert.ok(buttons.length >= 8, `${buttons.length} states`);
  const seen = new Set();
  for (const button of buttons) {
    await button.evaluate(each => each.click());
    seen.add((await rates(page)).join());
    assert.equal(await button.evaluate(each => each.getAttribute('aria-pressed')), 'true');
  }
  assert.equal(seen.size, buttons.length, 'each has speeds of its own');
  await closed(each);
});

test('on a phone each part is a page of its own', async () => {
  const each = await open('robot', {size: PHONE});
  const {page} = each;
  await ready(page);
  const shown = () => page.$$eval('section', all => all.filter(each => each.offsetHeight > 0).map(each => each.id));
  assert.deepEqual(await shown(), ['train', 'solution']);
  for (const part of ['matrices', 'drawings', 'derivation', 'exercises']) {
    await page.click(`nav a[href="#${part}"]`);
    assert.deepEqual(await shown(), [part]);
    const [wide, view] = await page.evaluate(() => [document.documentElement.scrollWidth, window.innerWidth]);
    assert.ok(wide <= view, `${part} is ${wide} px wide`);
  }
  await closed(each);
});

for (const [where, size, theme] of isFirefox ? [] : PAIRS) {
  test(`axe-core finds nothing: ${where}, ${theme}`, async () => {
    const {page} = await open('robot', {size, theme});
    await ready(page);
    for (const part of size === PHONE ? ['solution', 'drawings', 'matrices', 'derivation', 'exercises'] : ['all']) {
      if (part !== 'all') await page.click(`nav a[href="#${part}"]`);
      assert.deepEqual(await barriers(page), [], part);
    }
    await page.close();
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
