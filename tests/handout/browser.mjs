// Handouts in a real browser, opened from disk as they are handed out, under their own policy.
import assert from 'node:assert/strict';
import {execFileSync} from 'node:child_process';
import fs from 'node:fs';
import os from 'node:os';
import path from 'node:path';
import test, {after, before} from 'node:test';
import {pathToFileURL} from 'node:url';
import puppeteer from 'puppeteer-core';

const cli = process.env.GEARGRAPH_CLI;
const examples = process.env.GEARGRAPH_EXAMPLES;
const name = process.env.GEARGRAPH_BROWSER;
const isFirefox = name.startsWith('firefox');
const program = ['/usr/bin', '/usr/local/bin', '/snap/bin'].map(folder => path.join(folder, name)).find(fs.existsSync);
if (!program) {
  console.log(`skipped: there is no ${name}`);
  process.exit(77);
}
const DESK = {width: 1366, height: 768}, PHONE = {width: 390, height: 844, isMobile: false};
const axe = fs.readFileSync('node_modules/axe-core/axe.min.js', 'utf8');
const folder = fs.mkdtempSync(path.join(os.tmpdir(), 'geargraph-browser-'));

let browser;
const start = more => puppeteer.launch({
  browser: isFirefox ? 'firefox' : 'chrome', executablePath: program, headless: true, ...more,
  args: isFirefox ? [] : ['--no-sandbox', '--use-gl=angle', '--use-angle=swiftshader', '--enable-unsafe-swiftshader']});
before(async () => { browser = await start({}); });
after(async () => {
  await browser.close();
  fs.rmSync(folder, {recursive: true});
});

const made = new Map();
const handout = example => {
  if (!made.has(example)) {
    const file = path.join(folder, example + '.html');
    try {
      execFileSync(cli, ['export', path.join(examples, example + '.geargraph'), '--to', 'handout', '-o', file], {stdio: 'ignore'});
    } catch (error) {
      if (error.status !== 1) throw error;  // 1: a mechanism with errors, which has a handout, too
    }
    made.set(example, pathToFileURL(file).href);
  }
  return made.get(example);
};

// A page with what it complained of: errors, refusals of its policy, requests.
const open = async (example, {size = DESK, theme = 'light', from = browser} = {}) => {
  const page = await from.newPage();
  const complaints = [];
  page.on('pageerror', error => complaints.push(String(error)));
  page.on('console', message => { if (['error', 'warn'].includes(message.type())) complaints.push(message.text()); });
  page.on('request', request => { if (!/^(file|data|blob):/.test(request.url())) complaints.push(request.url()); });
  await page.setViewport(size);
  await page.goto(handout(example));
  if (theme === 'dark') await page.evaluate(() => { document.documentElement.dataset.theme = 'dark'; });
  return {page, complaints};
};
const ready = page => page.waitForSelector('#scene canvas', {timeout: 60000});
// Elements of MathML with another number of children than they must have.
const brokenFormulas = page => page.evaluate(() => {
  const children = {msub: 2, msup: 2, mfrac: 2, mroot: 2, munder: 2, mover: 2, msubsup: 3, munderover: 3};
  return Object.entries(children).flatMap(([name, count]) => [...document.getElementsByTagName(name)]
    .filter(each => each.childElementCount !== count).map(each => each.outerHTML));
});
const closed = async ({page, complaints}) => {
  // What a driver without a graphics card says of itself; and what Firefox says of a formula that is not read to its end when
  // it lays out the first part of a page: the whole page is looked at for that.
  const own = complaints.filter(each => !/WebGL|GPU stall|GL Driver|swiftshader|software|Incorrect number of children/i.test(each));
  assert.deepEqual(own, []);
  assert.deepEqual(await brokenFormulas(page), []);
  await page.close();
};
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

test('every example opens, without a complaint and without asking for anything', async () => {
  let scenes = 0;
  const files = fs.readdirSync(examples).filter(each => each.endsWith('.geargraph'));
  // Two browsers need not look at all: what differs between them is not the mechanism.
  for (const file of isFirefox ? files.slice(0, 4) : files) {
    const opened = await open(path.basename(file, '.geargraph'));
    if (await opened.page.$('#scene')) {
      await ready(opened.page);
      ++scenes;
    }
    await closed(opened);
  }
  assert.ok(scenes >= (isFirefox ? 3 : 12), `${scenes} scenes`);
});

test('the page is what it takes for the scene to be seen', async () => {
  const opened = await open('robot');
  await ready(opened.page);
  const colours = await opened.page.evaluate(() => {
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
  await closed(opened);
});

test('inputs drive the solution, in fractions; what is no number is refused with a reason', async () => {
  const opened = await open('robot');
  const {page} = opened;
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
  await closed(opened);
});

test('a click selects an element everywhere, Escape clears it, keys walk a drawing', async () => {
  const opened = await open('robot');
  const {page} = opened;
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
  await closed(opened);
});

test('the train turns: played, scrubbed, by keys, and back', async () => {
  const opened = await open('planetary-ring-held');
  const {page} = opened;
  await ready(page);
  const still = await painted(page);
  const play = await page.evaluateHandle(() => [...document.querySelectorAll('#train button')].find(each => /Play/.test(each.textContent)));
  await play.click();
  await page.waitForFunction(() => Number(document.querySelector('[aria-label=Time]').value) > 0, {timeout: 30000});
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
  await closed(opened);
});

test('a joint stops at its limit and says so', async () => {
  const opened = await open('robot');
  const {page} = opened;
  await ready(page);
  await page.$eval('[aria-label=Time]', range => {
    range.value = '999';
    range.dispatchEvent(new Event('input', {bubbles: true}));
  });
  assert.match(await page.$eval('.time', text => text.textContent), /^Joint \d+ is at its limit of .*°\.$/);
  await closed(opened);
});

test('states of a gearbox are put in by a click', async () => {
  const opened = await open('eight-speed-gearbox');
  const {page} = opened;
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
  await closed(opened);
});

test('on a phone each part is a page of its own', async () => {
  const opened = await open('robot', {size: PHONE});
  const {page} = opened;
  await ready(page);
  const shown = () => page.$$eval('section', all => all.filter(each => each.offsetHeight > 0).map(each => each.id));
  assert.deepEqual(await shown(), ['train', 'solution']);
  for (const part of ['matrices', 'drawings', 'derivation']) {
    await page.click(`nav a[href="#${part}"]`);
    assert.deepEqual(await shown(), [part]);
    const [wide, view] = await page.evaluate(() => [document.documentElement.scrollWidth, window.innerWidth]);
    assert.ok(wide <= view, `${part} is ${wide} px wide`);
  }
  await closed(opened);
});

for (const theme of ['light', 'dark']) {
  for (const [where, size] of [['desk', DESK], ['phone', PHONE]]) {
    test(`axe-core finds nothing: ${where}, ${theme}`, async () => {
      const {page} = await open('robot', {size, theme});
      await ready(page);
      await page.evaluate(() => new Promise(done => setTimeout(done, 0)));
      // The page's policy allows no foreign script; the debugger's own evaluation is not one.
      await page.evaluate(axe);
      const parts = size === PHONE ? ['solution', 'drawings', 'matrices', 'derivation'] : ['all'];
      for (const part of parts) {
        if (part !== 'all') await page.click(`nav a[href="#${part}"]`);
        const found = await page.evaluate(() => window.axe.run(document, {runOnly: ['wcag2a', 'wcag2aa', 'wcag21aa', 'wcag22aa', 'best-practice']}));
        assert.deepEqual(found.violations.map(each => `${part} ${each.id}: ${each.nodes.map(node => node.target).slice(0, 3).join(' ')}`), []);
      }
      await page.close();
    });
  }
}

test('without scripts all parts and the still picture are there', async () => {
  const quiet = isFirefox ? await start({extraPrefsFirefox: {'javascript.enabled': false}}) : browser;
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
  const {nodeIds: controls} = await client.send('DOM.querySelectorAll', {nodeId: root.nodeId, selector: 'button, input, canvas'});
  assert.equal(controls.length, 0);
  await page.close();
});
