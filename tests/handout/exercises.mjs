// Exercises in handouts, in a real browser: answered wrong and right, kept, handed in, graded by the program.
import assert from 'node:assert/strict';
import fs from 'node:fs';
import path from 'node:path';
import test, {after, before} from 'node:test';
import {DESK, PAIRS, PHONE, barriers, closed, exampleFile, examples, geargraph, handout, opened, start, temporaryFolder} from './browsers.mjs';

const name = process.env.GEARGRAPH_BROWSER;
const isFirefox = name.startsWith('firefox');
const folder = temporaryFolder();
let browser;
// Without three dimensions, which browser.mjs looks at: they would cost most of the time.
before(async () => { browser = await start(name, {isFlat: true}); });
after(async () => {
  await browser?.close();
  fs.rmSync(folder, {recursive: true});
});

const live = page => page.waitForSelector('#exercises.live');
const open = async (example, {size = DESK, theme = 'light', words = [], covered = false} = {}) => {
  // Pages from disk share what a browser keeps: each has one of its own.
  const context = await browser.createBrowserContext();
  const page = await opened(context, handout(example, '--exercises', ...words), size, {covered});
  await live(page.page);
  await page.page.evaluate(each => { document.documentElement.dataset.theme = each; }, theme);
  return page;
};
// Fills the fields of a question, and checks them.
const answer = (page, at, texts) => page.evaluate((question, values) => {
  const node = document.querySelectorAll('.question')[question];
  const wake = field => field.dispatchEvent(new Event('input', {bubbles: true}));
  values.forEach((value, i) => {
    const cell = node.querySelector(`[data-field="${i}"]`);
    const radio = [...cell.querySelectorAll('input[type=radio]')].find(each => each.value === value);
    if (radio) return radio.click();
    const field = cell.querySelector('input, select');
    if (field) {
      field.value = value;
      return wake(field);
    }
    for (const chip of cell.querySelectorAll('button'))
      if (value.split(',').includes(chip.textContent) !== (chip.getAttribute('aria-pressed') === 'true')) chip.click();
  });
  [...node.querySelectorAll('.controls button')].find(button => button.textContent === 'Check').click();
}, at, texts);
const verdictOf = (page, at) => page.evaluate(question => {
  const node = document.querySelectorAll('.question')[question];
  return {text: node.querySelector('.verdict').textContent, isRight: Boolean(node.querySelector('.verdict.right')),
          wrong: [...node.querySelectorAll('td.wrong')].map(cell => Number(cell.dataset.field))};
}, at);
const goTo = (page, at) => page.evaluate(question => {
  const [back, , next] = document.querySelector('.walk').children;
  while (!back.disabled) back.click();
  for (let i = 0; i < question; ++i) next.click();
}, at);
// What the program makes of the same options: the file of the sheet, and the questions with their keys.
const sheetOf = (example, number, ...asked) => {
  const words = asked.includes('--seed') ? asked : [...asked, '--seed', '1'];  // as handout() does
  const to = path.join(folder, ['sheet', example, ...words].join('-'));
  geargraph('exercises', 'make', exampleFile(example), '--to', 'json', '--force', ...words, '-o', to);
  return {file: path.join(to, 'sheet.json'), questions: JSON.parse(fs.readFileSync(path.join(to, `solution-${number}.json`))).questions};
};
// What the link "Save answers" hands out.
const saved = page => page.evaluate(() => {
  const link = document.querySelector('a[download]');
  link.addEventListener('click', event => event.preventDefault(), {once: true});
  link.click();
  return decodeURIComponent(link.href.slice(link.href.indexOf(',') + 1));
});
const graded = (sheet, text) => {
  const file = path.join(folder, 'answers.json');
  fs.writeFileSync(file, text);
  return geargraph('exercises', 'grade', sheet, file).trim().split(/\r?\n/).slice(1).map(line => line.split(','));
};

test('a page in another language asks, grades and prints in it', async () => {
  const each = await open('robot', {words: ['--language', 'de']});
  const {page} = each;
  assert.equal(await page.evaluate(() => document.documentElement.lang), 'de');
  assert.ok(await page.evaluate(() => [...document.querySelectorAll('header button')].some(button => button.textContent === 'Drucken')));
  await page.evaluate(() => [...document.querySelectorAll('.question.here .controls button')].find(button => button.textContent === 'Pr\u00fcfen').click());
  assert.match(await page.$eval('.question.here .verdict', node => node.textContent), /Die Frage ist nicht beantwortet\./);
  await closed(each);
});

test('what the exercises ask for is covered until somebody wants it', async () => {
  const each = await open('robot', {covered: true});
  const seen = () => each.page.evaluate(() => ['#matrices td', '#derivation .equation', '#solution td', '.input input', '.question']
    .map(place => [...document.querySelectorAll(place)].some(node => node.getClientRects().length > 0)));
  assert.deepEqual(await seen(), [false, false, false, true, true]);
  await each.page.click('#matrices .reveal');
  assert.deepEqual(await seen(), [true, false, false, true, true]);
  await each.page.click('#solution .reveal');
  assert.deepEqual(await seen(), [true, false, true, true, true]);
  await closed(each);
  await each.page.browserContext().close();
});

// How the three-dimensional train of each is opened, browser.mjs sees.
test('every example is opened and driven, with its exercises, without a complaint', async () => {
  const files = fs.readdirSync(examples).filter(each => each.endsWith('.geargraph')).map(each => path.basename(each, '.geargraph'));
  let questions = 0, driven = 0;
  for (const example of files) {
    const each = await open(example);
    const found = await each.page.evaluate(() => {
      const rates = () => [...document.querySelectorAll('[data-now]')].map(cell => cell.textContent).join();
      const before = rates();
      for (const field of document.querySelectorAll('.input input[type=text]')) {
        field.value = '7/3';
        field.dispatchEvent(new Event('input', {bubbles: true}));
      }
      const isDriven = rates() !== before;
      for (const head of document.querySelectorAll('table.matrix tr[data-el] th')) head.click();
      const card = document.querySelector('.card h2').textContent;
      const show = [...document.querySelectorAll('.controls button')].filter(button => button.textContent === 'Show');
      for (const button of show) button.click();
      const {points, open} = document.getElementById('exercises').dataset;
      const blanks = [...document.querySelectorAll('td[data-field]')].filter(cell => !cell.querySelector('input, select, button'));
      return {shown: document.querySelectorAll('.verdict.shown').length, all: document.querySelectorAll('.question').length,
              points, open, blanks: blanks.length, isDriven, card};
    });
    assert.deepEqual([found.shown, found.points, found.open, found.blanks], [found.all, '0', '0', 0], example);
    assert.ok(found.card, example);
    questions += found.all;
    driven += found.isDriven ? 1 : 0;
    await closed(each);
    await each.page.browserContext().close();
  }
  assert.ok(questions >= 200 && driven >= 13, `${questions} questions, ${driven} driven`);
});

test('right answers to a whole sheet are right here and where they are handed in', async () => {
  const words = ['--seed', '7', '--variants', '30'];
  const each = await open('robot', {words: [...words, '--variant', '12']});
  const {file, questions} = sheetOf('robot', 12, ...words);
  for (const [at, {solution, kind}] of questions.entries()) {
    await answer(each.page, at, solution);
    assert.ok((await verdictOf(each.page, at)).isRight, kind);
  }
  await each.page.type('#student', 'Ada, "L."');
  const {points, of, open: left} = await each.page.$eval('#exercises', section => ({...section.dataset}));
  assert.deepEqual([points, left], [of, '0']);
  const answers = JSON.parse(await saved(each.page));
  assert.deepEqual([answers.format, answers.variant, answers.student], ['geargraph-answers', 12, 'Ada, "L."']);
  const csv = graded(file, JSON.stringify({...answers, student: 'Ada'}));
  assert.equal(csv.filter(line => line[7] === 'right').length, questions.length);
  assert.deepEqual(csv.at(-1).slice(5, 7), [of, of]);
  // Another variant of the sheet would have other questions.
  assert.ok(graded(file, JSON.stringify({...answers, variant: 13, student: ''})).some(line => line[7] === 'wrong'));
  await closed(each);
  await each.page.browserContext().close();
});

test('a wrong answer is told with place and reason, lit up, mended, and kept', async () => {
  const words = ['--kinds', 'cycle-basis,freedom,inputs'];
  const each = await open('robot', {words});
  const {page} = each;
  const {file, questions: [row]} = sheetOf('robot', 1, ...words);
  const at = row.solution.indexOf('-1');
  const wrong = row.solution.map((value, i) => (i === at ? '1' : value));
  await answer(page, 0, wrong);
  const verdict = await verdictOf(page, 0);
  assert.deepEqual([verdict.isRight, verdict.wrong], [false, [at]]);
  assert.match(verdict.text, /runs against the arrow of joint \d+: \u22121, not 1\..*The other 10 fields are right\./);
  assert.equal(await page.evaluate(() => document.querySelectorAll('.asked-drawing svg .wrong').length > 0), true);
  const filled = row.solution.filter(value => value !== '0').length;  // all of them but one are right
  assert.deepEqual(graded(file, await saved(page))[0].slice(4, 9),
                   ['cycle-basis', String(Math.floor(4 * (filled - 1) / filled)), '4', 'wrong', 'walked-against-arrow']);
  // It is there when the page is opened again.
  await page.reload();
  await live(page);
  assert.deepEqual(await verdictOf(page, 0), verdict);
  await page.evaluate(() => [...document.querySelectorAll('.question.here .controls button')].find(button => button.textContent === 'Try again').click());
  const texts = await page.$$eval('.question.here td input', inputs => inputs.map(input => input.value));
  assert.deepEqual(texts, wrong.map((value, i) => (i === at ? '' : value)));
  assert.equal(await page.evaluate(() => document.activeElement.closest('td').dataset.field), String(at));
  assert.equal(await page.evaluate(() => document.querySelectorAll('svg .wrong').length), 0);
  await page.keyboard.type('-1');
  await page.keyboard.press('Enter');
  assert.ok((await verdictOf(page, 0)).isRight);
  assert.equal(await page.$eval('#exercises', section => section.dataset.points), '4');
  await closed(each);
  await each.page.browserContext().close();
});

test('what is shown gives no points, and what is handed in is the learner\'s own', async () => {
  const each = await open('robot', {words: ['--kinds', 'freedom']});
  await answer(each.page, 0, ['3', '7']);
  assert.equal((await verdictOf(each.page, 0)).isRight, false);
  await each.page.evaluate(() => [...document.querySelectorAll('.controls button')].find(button => button.textContent === 'Show').click());
  assert.deepEqual(await each.page.$$eval('td[data-field] input', inputs => inputs.map(input => input.value)), ['4', '3']);
  assert.equal(await each.page.$eval('#exercises', section => section.dataset.points), '0');
  assert.deepEqual(Object.values(JSON.parse(await saved(each.page)).answers['1']), ['3', '7']);
  await closed(each);
  await each.page.browserContext().close();
});

test('cells are filled and walked by keys, and by the buttons under them', async () => {
  const each = await open('robot', {words: ['--kinds', 'tree-matrix'], size: PHONE});
  const {page} = each;
  await page.evaluate(() => document.querySelector('nav a[href="#exercises"]').click());
  const here = () => page.evaluate(() => document.activeElement.closest('td')?.dataset.field);
  await page.focus('[data-field="0"] input');
  await page.keyboard.press('ArrowDown');
  assert.equal(await here(), '7');
  await page.keyboard.press('ArrowRight');
  assert.equal(await here(), '8');
  await page.keyboard.press('ArrowUp');
  assert.equal(await here(), '1');
  await page.evaluate(() => { for (const button of document.querySelectorAll('.keys button')) button.click(); });
  assert.deepEqual(await page.$$eval('td[data-field] input', inputs => inputs.slice(0, 5).map(input => input.value)), ['', '\u22121', '0', '1', '']);
  await closed(each);
  await each.page.browserContext().close();
});

test('a hint is there before the answer, when asked for, and says where to look', async () => {
  const each = await open('robot', {words: ['--kinds', 'cycle-basis,freedom,inputs']});
  const {page} = each;
  const button = text => page.evaluateHandle(name => [...document.querySelectorAll('.question.here .controls button')].find(each => each.textContent === name), text);
  const hint = () => page.$eval('.question.here .hint', node => (node.getClientRects().length > 0 ? node.innerText : ''));
  const ask = await button('Hint');
  assert.equal(await hint(), '');
  assert.equal(await ask.evaluate(each => each.getAttribute('aria-expanded')), 'false');
  await ask.focus();
  await page.keyboard.press('Enter');
  assert.match(await hint(), /a cycle of the basis holds one mesh, its own/);
  assert.equal(await ask.evaluate(each => [each.getAttribute('aria-expanded'), document.getElementById(each.getAttribute('aria-controls')).className].join()), 'true,hint');
  // It names what the field is about, and lights it; nothing is filled in or graded.
  await page.evaluate(() => document.querySelector('.question.here [data-field="1"] input').focus());
  assert.match(await hint(), /Look at .*joint 9 in the drawing\.$/);
  assert.ok(await page.evaluate(() => document.querySelectorAll('.asked-drawing svg .asked').length > 0));
  assert.ok((await page.$$eval('.question.here td input', inputs => inputs.map(input => input.value))).every(text => text === ''));
  assert.deepEqual(await page.$eval('#exercises', section => [section.dataset.points, section.dataset.open]), ['0', '3']);
  // Kept, as the rest is.
  await page.reload();
  await live(page);
  assert.match(await hint(), /holds one mesh/);
  await (await button('Hint')).click();
  assert.equal(await hint(), '');
  // It costs no points, and goes with the right answer. Each question has one.
  const {questions} = sheetOf('robot', 1, '--kinds', 'cycle-basis,freedom,inputs');
  for (let at = 0; at < 3; ++at) {
    await goTo(page, at);
    await (await button('Hint')).click();
    assert.ok((await hint()).length > 60);
    await answer(page, at, questions[at].solution);
    assert.ok((await verdictOf(page, at)).isRight);
    assert.equal(await hint(), '');
  }
  const {points, of} = await page.$eval('#exercises', section => ({...section.dataset}));
  assert.equal(points, of);
  await closed(each);
  await each.page.browserContext().close();
});

test('on a phone the sheet leads on, nothing hides under the bar, and a shared device begins again', async () => {
  const each = await open('robot', {size: PHONE, words: ['--kinds', 'incidence,cycle-basis']});
  const {page} = each;
  await page.evaluate(() => document.querySelector('nav a[href="#exercises"]').click());
  // What has the focus is never below the bar at the bottom.
  const stops = await page.evaluate(() => {
    const bar = document.querySelector('nav').getBoundingClientRect().top;
    return [...document.querySelectorAll('#exercises .question.here :is(input, select, button), .handin :is(input, a, button)')]
        .filter(node => node.offsetParent && !node.disabled).map(node => {
          window.scrollTo({top: 0, behavior: 'instant'});
          node.focus();
          node.scrollIntoView({block: 'nearest', behavior: 'instant'});
          return node.getBoundingClientRect().bottom <= bar;
        });
  });
  assert.ok(stops.length > 20, stops.length);
  assert.ok(stops.every(Boolean), stops.join());
  // Beside the verdict, not only above the question.
  const shown = () => page.$$eval('.question.here .controls button', nodes => nodes.filter(node => !node.hidden).map(node => node.textContent));
  assert.ok(!(await shown()).includes('Next \u203a'));
  await page.evaluate(() => [...document.querySelectorAll('.question.here .controls button')].find(node => node.textContent === 'Show').click());
  assert.ok((await shown()).includes('Next \u203a'));
  await page.evaluate(() => [...document.querySelectorAll('.question.here .controls button')].find(node => node.textContent === 'Next \u203a').click());
  assert.equal(await page.$eval('.place', node => node.textContent), 'Question 2 of 2');
  assert.ok(await page.evaluate(() => document.querySelector('.question.here').contains(document.activeElement)));
  // Start again asks first.
  await page.type('#student', 'Ada');
  const startAgain = () => page.evaluate(() => [...document.querySelectorAll('.handin button')].find(node => node.textContent === 'Start again').click());
  page.once('dialog', dialog => dialog.dismiss());
  await startAgain();
  assert.equal(await page.$eval('#student', node => node.value), 'Ada');
  page.once('dialog', dialog => dialog.accept());
  await startAgain();
  assert.equal(await page.$eval('#student', node => node.value), '');
  assert.equal(await page.$eval('.place', node => node.textContent), 'Question 1 of 2');
  assert.ok(!(await shown()).includes('Next \u203a'));
  assert.deepEqual(await page.$$eval('.question.here input', nodes => nodes.map(node => node.value + node.disabled)),
                   await page.$$eval('.question.here input', nodes => nodes.map(() => 'false')));
  const {answers} = JSON.parse(await saved(page));
  assert.ok(Object.values(answers).every(fields => Object.values(fields).every(text => text === '')));
  await closed(each);
});

test('the questions are printed alone', async () => {
  const each = await open('spur-pair');
  const {page} = each;
  const printed = await page.evaluate(() => new Promise(done => {
    window.print = () => done(document.body.dataset.print);
    [...document.querySelectorAll('.handin button')].find(node => node.textContent === 'Print the questions').click();
  }));
  assert.equal(printed, 'exercises');
  await page.emulateMediaType('print');
  const seen = id => page.$eval(id, node => node.getClientRects().length > 0);
  assert.deepEqual([await seen('#exercises'), await seen('#drawings'), await seen('#solution')], [true, false, false]);
  await page.evaluate(() => window.dispatchEvent(new Event('afterprint')));
  assert.deepEqual([await seen('#exercises'), await seen('#drawings'), await seen('#solution')], [true, true, true]);
  await closed(each);
});

test('on paper all questions are there, with empty blanks', async () => {
  const each = await open('robot', {words: ['--kinds', 'cycle-basis,freedom,inputs']});
  await answer(each.page, 0, Array(11).fill('1'));
  if (!isFirefox) {  // which has no such switch
    await each.page.emulateMediaType('print');
    const paper = await each.page.evaluate(() => {
      const isSeen = node => node.getClientRects().length > 0;
      return {questions: [...document.querySelectorAll('.question')].filter(isSeen).length,
              blanks: [...document.querySelectorAll('td[data-field]')].filter(cell => isSeen(cell) && !cell.innerText.trim()).length,
              bars: [...document.querySelectorAll('mtd.bar')].map(cell => getComputedStyle(cell).display).filter((each, i, all) => all.indexOf(each) === i),
              controls: [...document.querySelectorAll('#exercises input, #exercises button, #exercises select, .verdict')].filter(isSeen).length};
    });
    assert.deepEqual(paper, {questions: 3, blanks: 14, bars: ['table-cell'], controls: 0});
  }
  await closed(each);
  await each.page.browserContext().close();
});

test('the answers do not stand in the file to be read', () => {
  const text = fs.readFileSync(new URL(handout('robot', '--exercises')), 'utf8');
  const {questions} = sheetOf('robot', 1);
  let reasons = 0;
  for (const {rule, mistakes} of questions) {
    for (const reason of [rule, ...mistakes.map(mistake => mistake.reason)]) {
      assert.ok(!text.includes(`"${reason}"`), reason);
      ++reasons;
    }
  }
  assert.ok(reasons > 200, `${reasons} reasons`);
  assert.ok(!/\sstyle="/.test(text.replace(/<script>[^]*?<\/script>/g, '')), 'no style attributes');
});

for (const [where, size, theme] of isFirefox ? [] : PAIRS) {
  test(`axe-core finds nothing in exercises, answered wrong and right: ${where}, ${theme}`, async () => {
    const {page} = await open('robot', {size, theme, words: ['--kinds', 'cycle-basis,orientation,inputs,freedom']});
    const {questions} = sheetOf('robot', 1, '--kinds', 'cycle-basis,orientation,inputs,freedom');
    await answer(page, 0, Array(11).fill('2'));
    await answer(page, 2, ['8,9']);
    await answer(page, 3, questions[3].solution);
    await page.evaluate(() => document.querySelector('nav a[href="#exercises"]').click());
    for (let at = 0; at < 4; ++at) {
      await goTo(page, at);
      await page.evaluate(() => [...document.querySelectorAll('.question.here .controls button')].find(button => button.textContent === 'Hint').click());
      assert.deepEqual(await barriers(page, '#exercises'), [], `question ${at + 1}`);
      const small = await page.$$eval('#exercises button, #exercises input, #exercises select, #exercises a', nodes =>
          nodes.filter(node => node.offsetHeight > 0 && node.getBoundingClientRect().height < 43.5).map(node => node.outerHTML));
      assert.deepEqual(small, []);
      const [wide, view] = await page.evaluate(() => [document.documentElement.scrollWidth, window.innerWidth]);
      assert.ok(wide <= view, `${wide} px wide`);
    }
    await page.browserContext().close();
  });
}

test('without scripts all questions and their blanks are there', async () => {
  if (isFirefox) return;  // which cannot be asked then
  const page = await browser.newPage();
  await page.setJavaScriptEnabled(false);
  await page.goto(handout('robot', '--exercises', '--kinds', 'cycle-basis,freedom,inputs'));
  const client = await page.createCDPSession();
  const {root} = await client.send('DOM.getDocument', {depth: -1});
  const count = async selector => (await client.send('DOM.querySelectorAll', {nodeId: root.nodeId, selector})).nodeIds.length;
  assert.deepEqual([await count('.question'), await count('td[data-field]'), await count('button, input, select'), await count('details.hint')], [3, 14, 0, 3]);
  await page.close();
});
