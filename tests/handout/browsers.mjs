// What tests in browsers share. They run on machines of two busy processors, without a display and as root: everything waits for
// what it needs, with generous limits, and nothing for a time.
import assert from 'node:assert/strict';
import fs from 'node:fs';
import os from 'node:os';
import path from 'node:path';
import puppeteer from 'puppeteer-core';

export const LONGEST = 120000;  // ms for one step
export const DESK = {width: 1366, height: 768}, PHONE = {width: 390, height: 844, isMobile: false};

export {exampleFile, examples, geargraph, handout} from './pages.mjs';

// The path of a browser. That it is there, tests/npm/run.sh has seen: node's own runner knows no skipped file.
export const programOf = name => {
  const program = (process.env.PATH || '').split(':').map(folder => path.join(folder, name)).find(fs.existsSync);
  if (!program) throw new Error(`there is no ${name}; tools/packages.txt lists it under "test:"`);
  return program;
};

// The page itself is painted without it: that takes half of the time.
const SOFTWARE_GL = ['--use-gl=angle', '--use-angle=swiftshader', '--enable-unsafe-swiftshader'];
// Starts a browser, once more where the machine was too busy for the first time. `isFlat`: it paints no WebGL.
export const start = async (name, {isFlat = false, ...more} = {}) => {
  const isFirefox = name.startsWith('firefox');
  const options = {
    browser: isFirefox ? 'firefox' : 'chrome', executablePath: programOf(name), headless: true, timeout: LONGEST,
    protocolTimeout: LONGEST, ...more,
    // Nobody but root is there, and shared memory is small in containers.
    args: isFirefox ? [] : ['--no-sandbox', '--disable-dev-shm-usage', '--disable-gpu-compositing', '--renderer-process-limit=1',
      ...(isFlat ? ['--disable-3d-apis', '--disable-gpu'] : SOFTWARE_GL)]};
  if (isFirefox && isFlat) options.extraPrefsFirefox = {'webgl.disabled': true};
  try {
    return await puppeteer.launch(options);
  } catch (error) {
    console.log(`${name} did not start (${error.message}); once more`);
    return puppeteer.launch(options);
  }
};

export const temporaryFolder = () => fs.mkdtempSync(path.join(os.tmpdir(), 'geargraph-browser-'));

// A page with what it complained of: errors, refusals of its policy, requests. What exercises ask for is covered until its
// button is clicked; `covered`: it stays so.
export const opened = async (browser, address, size, {covered = false} = {}) => {
  const page = await browser.newPage();
  page.setDefaultTimeout(LONGEST);
  const complaints = [];
  page.on('pageerror', error => complaints.push(String(error)));
  page.on('console', message => { if (['error', 'warn'].includes(message.type())) complaints.push(message.text()); });
  page.on('request', request => { if (!/^(file|data|blob):/.test(request.url())) complaints.push(request.url()); });
  await page.setViewport(size);
  await page.goto(address);
  if (!covered) await page.evaluate(() => { for (const button of document.querySelectorAll('.reveal')) button.click(); });
  return {page, complaints};
};
// Elements of MathML with another number of children than they must have.
const brokenFormulas = page => page.evaluate(() => {
  const children = {msub: 2, msup: 2, mfrac: 2, mroot: 2, munder: 2, mover: 2, msubsup: 3, munderover: 3};
  return Object.entries(children).flatMap(([name, count]) => [...document.getElementsByTagName(name)]
    .filter(each => each.childElementCount !== count).map(each => each.outerHTML));
});
// Has it kept quiet, and are its formulas whole?
export const quiet = async ({page, complaints}) => {
  // What a driver without a graphics card says of itself; and what Firefox says of a formula that is not read to its end when
  // it lays out the first part of a page: the whole page is looked at for that.
  const own = complaints.filter(each => !/WebGL|GPU stall|GL Driver|swiftshader|software|Incorrect number of children/i.test(each));
  assert.deepEqual(own, []);
  assert.deepEqual(await brokenFormulas(page), []);
};
export const closed = async each => {
  await quiet(each);
  await each.page.close();
};

// What axe-core finds in a part of the page, a line each.
const axe = fs.readFileSync('node_modules/axe-core/axe.min.js', 'utf8');
export const barriers = async (page, part = 'body') => {
  // The page's policy allows no foreign script; the debugger's own evaluation is not one.
  if (!await page.evaluate(() => Boolean(window.axe))) await page.evaluate(axe);
  await page.evaluate(() => window.scrollTo({top: 0, behavior: 'instant'}));  // nothing is under the tabs
  const found = await page.evaluate(selector => window.axe.run(selector === 'body' ? document : selector,
    {runOnly: ['wcag2a', 'wcag2aa', 'wcag21aa', 'wcag22aa', 'best-practice']}), part);
  return found.violations.map(each => `${each.id}: ${each.nodes.map(node => node.target).slice(0, 3).join(' ')}`);
};
export const PAIRS = [['desk', DESK, 'light'], ['phone', PHONE, 'dark']];
