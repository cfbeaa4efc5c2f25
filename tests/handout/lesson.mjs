// Lessons as pages, in a real browser: every step answered wrong and right, fresh questions at the end, told to a platform.
import assert from 'node:assert/strict';
import fs from 'node:fs';
import path from 'node:path';
import test, {after, before} from 'node:test';
import {pathToFileURL} from 'node:url';
import zlib from 'node:zlib';
import {DESK, PAIRS, PHONE, barriers, closed, geargraph, opened, start, temporaryFolder} from './browsers.mjs';

const folder = temporaryFolder();
const lessons = path.join(folder, 'lessons');
let browser;
before(async () => {
  geargraph('lesson', 'make', '--to', 'html,scorm', '-o', lessons);
  browser = await start('chromium', {isFlat: true});
});
after(async () => {
  await browser?.close();
  fs.rmSync(folder, {recursive: true});
});

const fileOf = id => path.join(lessons, id + '.html');
const names = () => fs.readdirSync(lessons).filter(name => name.endsWith('.html') && name !== 'index.html').map(name => name.slice(0, -5));
const open = async (id, {size = DESK, theme = 'light'} = {}) => {
  const context = await browser.createBrowserContext();
  const each = await opened(context, pathToFileURL(fileOf(id)).href, size);
  await each.page.waitForSelector('#exercises.live');
  await each.page.evaluate(to => { document.documentElement.dataset.theme = to; }, theme);
  return each;
};
const leave = async each => {
  await closed(each);
  await each.page.browserContext().close();
};
// The questions with their keys, by step; null where something is drawn.
const questionsOf = id => {
  const text = fs.readFileSync(fileOf(id), 'utf8');
  const [, packed] = /id="lesson-key">([^<]*)</.exec(text);
  const {questions} = JSON.parse(zlib.gunzipSync(Buffer.from(packed, 'base64')));
  const {steps} = JSON.parse(/id="mechanism">([^<]*)</.exec(text)[1]);
  return steps.map(({isAsked}) => (isAsked ? questions.shift() : null));
};
const atStep = page => page.evaluate(() => [...document.querySelectorAll('.step')].findIndex(node => node.classList.contains('here')));
const press = (page, text) => page.evaluate(name => [...document.querySelectorAll('.step.here .controls button')].find(button => !button.hidden && button.textContent === name).click(), text);
const fill = (page, texts) => page.evaluate(values => {
  const node = document.querySelector('.step.here');
  values.forEach((value, i) => {
    const cell = node.querySelector(`[data-field="${i}"]`);
    const radios = [...cell.querySelectorAll('input[type=radio]')];
    if (radios.length) return radios.find(radio => radio.value === value)?.click();
    const field = cell.querySelector('input, select');
    if (field) {
      field.value = value;
      return field.dispatchEvent(new Event('input', {bubbles: true}));
    }
    for (const chip of cell.querySelectorAll('button'))
      if (value.split(',').includes(chip.textContent) !== (chip.getAttribute('aria-pressed') === 'true')) chip.click();
  });
}, texts);
const verdict = page => page.$eval('.step.here .verdict', node => node.className + ': ' + node.textContent);
const told = page => page.$eval('#exercises', section => ({...section.dataset}));

test('the index leads to every lesson', async () => {
  const index = fs.readFileSync(path.join(lessons, 'index.html'), 'utf8');
  const listed = geargraph('lesson', 'list').trim().split('\n').slice(0, -1).map(line => line.split(' ')[0]);
  assert.deepEqual([...index.matchAll(/href="([^"]*)\.html"/g)].map(([, id]) => id), listed);
  assert.deepEqual(names().sort(), [...listed].sort());
  for (const id of listed) assert.ok(index.includes(`href="${id}.zip"`) && fs.existsSync(path.join(lessons, id + '.zip')));
});

test('every lesson is finished with right answers, and mastered with three fresh questions', async () => {
  for (const id of names()) {
    const each = await open(id);
    const {page} = each;
    const questions = questionsOf(id);
    let answered = 0;
    for (let i = 0; i < questions.length + 4; ++i) {
      const question = questions[await atStep(page)];
      if (question) {
        await fill(page, question.solution);
        await press(page, 'Check');
        assert.match(await verdict(page), /verdict right/, `${id}: ${question.prompt}`);
        ++answered;
      }
      if (await page.$eval('.step.here .controls', node => ![...node.querySelectorAll('button')].some(button => !button.hidden && button.textContent.startsWith('Next')))) break;
      await press(page, 'Next \u203a');
    }
    const {points, of, open: left} = await told(page);
    assert.deepEqual([points, left], [of, '0'], id);
    assert.equal(await page.$eval('.score', node => node.textContent), 'You have mastered this lesson.', id);
    assert.equal(Number(of), 2 * answered, id);
    await leave(each);
  }
});

test('a fresh question that is not right at once brings another one', async () => {
  const each = await open('cycle-basis');
  const {page} = each;
  const questions = questionsOf('cycle-basis');
  const own = questions.length - await page.$$eval('.step.fresh', nodes => nodes.length);
  for (let i = 0; i < own; ++i) {
    if (questions[i]) await press(page, 'Show');
    await press(page, 'Next \u203a');
  }
  assert.deepEqual([(await told(page)).points, (await told(page)).open], ['0', '3']);
  const seen = [];
  for (let i = 0; i < 4; ++i) {
    assert.equal(await page.$eval('.place', node => node.textContent), `Fresh question ${i + 1}`);
    const question = questions[await atStep(page)];
    seen.push(question);
    if (i === 1) {
      await fill(page, question.solution.map((text, at) => (question.fields[at].kind === 'integer' ? '7' : text)));
      await press(page, 'Check');
      assert.match(await verdict(page), /verdict wrong/);
      await press(page, 'Try again');
    }
    await fill(page, question.solution);
    await press(page, 'Check');
    assert.match(await verdict(page), /verdict right/);
    if (i < 3) await press(page, 'Next \u203a');
  }
  assert.equal(new Set(seen).size, 4);
  assert.deepEqual([(await told(page)).points, (await told(page)).open], ['6', '0']);
  // It is there when the page is opened again.
  await page.reload();
  await page.waitForSelector('#exercises.live');
  assert.equal((await told(page)).points, '6');
  assert.equal(await page.$eval('.score', node => node.textContent), 'You have mastered this lesson.');
  await leave(each);
});

test('a wrong answer has its reason, hints come one by one, and both cost a point', async () => {
  const each = await open('gear-pair');
  const {page} = each;
  const hints = () => page.$$eval('.step.here .hint li', items => items.filter(item => item.getClientRects().length > 0).length);
  assert.equal(await hints(), 0);
  await press(page, 'Hint 1 of 2');
  assert.equal(await hints(), 1);
  await press(page, 'Hint 2 of 2');
  assert.equal(await hints(), 2);
  await fill(page, ['3/2']);
  await press(page, 'Check');
  assert.match(await verdict(page), /ratio upside down/);
  await press(page, 'Try again');
  await fill(page, ['0.667']);
  await press(page, 'Check');
  assert.match(await verdict(page), /Right, 1 of 2 points/);
  assert.equal((await told(page)).points, '1');
  // What cannot be read costs nothing.
  await press(page, 'Next \u203a');
  await fill(page, ['two']);
  await press(page, 'Check');
  assert.match(await verdict(page), /Cannot be read/);
  await fill(page, ['-2/3']);
  await press(page, 'Check');
  assert.match(await verdict(page), /Right, 2 of 2 points/);
  await leave(each);
});

test('elements are picked in the drawing', async () => {
  const each = await open('paths-trees-cycles');
  const {page} = each;
  await press(page, 'Show');
  await press(page, 'Next \u203a');
  const click = id => page.evaluate(each => document.querySelector(`.step.here figure svg [data-list=turningJoints][data-id="${each}"]`)
                                                  .dispatchEvent(new MouseEvent('click', {bubbles: true})), id);
  for (const id of ['10', '12', '13', '14']) await click(id);
  await click('13');
  assert.deepEqual(await page.$$eval('.step.here .chips [aria-pressed=true]', chips => chips.map(chip => chip.textContent)), ['10', '12', '14']);
  await press(page, 'Check');
  assert.match(await verdict(page), /verdict right/);
  await leave(each);
});

test('a platform is told points, and that the lesson is completed when it is mastered', async () => {
  const context = await browser.createBrowserContext();
  const page = await context.newPage();
  await page.evaluateOnNewDocument(() => {
    window.kept = {};
    window.API = {LMSInitialize: () => 'true', LMSFinish: () => 'true', LMSCommit: () => 'true', LMSGetValue: name => window.kept[name] ?? '',
                  LMSSetValue: (name, value) => { window.kept[name] = value; return 'true'; }};
  });
  const packed = fs.readFileSync(path.join(lessons, 'mesh-signs.zip'));
  const local = packed.indexOf(Buffer.from('index.html', 'latin1'));  // the entry of the page, behind its local header
  const size = packed.readUInt32LE(local - 12);
  const file = path.join(folder, 'package.html');
  fs.writeFileSync(file, zlib.inflateRawSync(packed.subarray(local + 'index.html'.length, size ? local + 10 + size : undefined)));
  await page.goto(pathToFileURL(file).href);
  await page.waitForSelector('#exercises.live');
  const kept = name => page.evaluate(each => window.kept[each], name);
  assert.deepEqual([await kept('cmi.core.lesson_status'), await kept('cmi.core.score.raw')], ['incomplete', '0']);
  const questions = questionsOf('mesh-signs');
  for (let i = 0; ; ++i) {
    const question = questions[await atStep(page)];
    await fill(page, question.solution);
    await press(page, 'Check');
    if ((await told(page)).open === '0') break;
    await press(page, 'Next \u203a');
  }
  assert.deepEqual([await kept('cmi.core.lesson_status'), await kept('cmi.core.score.raw')], ['completed', '100']);
  await context.close();
});

for (const [where, size, theme] of PAIRS) {
  test(`axe-core finds nothing in a lesson, and nothing is wider than the page: ${where}, ${theme}`, async () => {
    for (const id of ['gear-pair', 'links-and-joints', 'read-the-lever']) {
      const each = await open(id, {size, theme});
      const {page} = each;
      const questions = questionsOf(id);
      const own = questions.length - await page.$$eval('.step.fresh', nodes => nodes.length);
      for (let i = 0; i < own; ++i) {
        if (questions[i]) await page.evaluate(() => document.querySelector('.step.here .controls .bar button:nth-child(4)').click());  // a hint
        assert.deepEqual(await barriers(page), [], `${id}, step ${i + 1}`);
        const [wide, view] = await page.evaluate(() => [document.documentElement.scrollWidth, window.innerWidth]);
        assert.ok(wide <= view, `${wide} px wide`);
        if (size === PHONE) {
          const small = await page.$$eval('button, .step.here :is(input[type=text], select, label)', nodes =>
              nodes.filter(node => node.offsetHeight > 0 && node.getBoundingClientRect().height < 43.5).map(node => node.outerHTML));
          assert.deepEqual(small, []);
        }
        await page.evaluate(() => document.querySelector('.walk button:last-child').click());
      }
      await leave(each);
    }
  });
}

test('without scripts all steps with blanks and hints are there', async () => {
  const page = await browser.newPage();
  await page.setJavaScriptEnabled(false);
  await page.goto(pathToFileURL(fileOf('gear-pair')).href);
  const client = await page.createCDPSession();
  const {root} = await client.send('DOM.getDocument', {depth: -1});
  const count = async selector => (await client.send('DOM.querySelectorAll', {nodeId: root.nodeId, selector})).nodeIds.length;
  assert.equal(await count('button, input, select'), 0);
  assert.ok(await count('.step') >= 7 && await count('.step:not(.fresh)') === 4);
  assert.equal(await count('.step:not(.fresh) > figure svg'), 4);
  await page.close();
});
