// The package for learning platforms, unpacked and run in a browser by a runtime of SCORM 1.2 that is not ours.
import assert from 'node:assert/strict';
import {execFileSync} from 'node:child_process';
import fs from 'node:fs';
import http from 'node:http';
import os from 'node:os';
import path from 'node:path';
import test, {after, before} from 'node:test';
import zlib from 'node:zlib';
import {LONGEST, start} from './browsers.mjs';


// The files of a ZIP archive, by its central directory [APPNOTE 6.3.9, 4.3.12].
const unzipped = bytes => {
  const end = bytes.lastIndexOf(Buffer.from('PK\x05\x06', 'latin1'));
  const files = new Map();
  for (let i = 0, at = bytes.readUInt32LE(end + 16); i < bytes.readUInt16LE(end + 10); ++i) {
    const [packed, nameSize, extra, comment] =
        [bytes.readUInt32LE(at + 20), bytes.readUInt16LE(at + 28), bytes.readUInt16LE(at + 30), bytes.readUInt16LE(at + 32)];
    const local = bytes.readUInt32LE(at + 42);
    const start = local + 30 + bytes.readUInt16LE(local + 26) + bytes.readUInt16LE(local + 28);
    files.set(bytes.toString('utf8', at + 46, at + 46 + nameSize), zlib.inflateRawSync(bytes.subarray(start, start + packed)));
    at += 46 + nameSize + extra + comment;
  }
  return files;
};

const file = path.join(fs.mkdtempSync(path.join(os.tmpdir(), 'geargraph-scorm-')), 'robot.zip');
execFileSync(process.env.GEARGRAPH_CLI, ['export', path.join(process.env.GEARGRAPH_EXAMPLES, 'robot.geargraph'), '--to', 'scorm', '--exercises', '--kinds', 'freedom,cycle-basis', '--seed', '1', '-o', file]);
const files = unzipped(fs.readFileSync(file));
const manifest = files.get('imsmanifest.xml').toString();

// A platform: it lists the item, opens what the manifest names in a frame, and keeps what it is told.
const platform = `<!DOCTYPE html><title>Platform</title><script src="runtime.js"></script><script>
  window.API = new window.Scorm12API({autocommit: false, logLevel: 5});
  window.told = [];
  window.API.on('LMSSetValue', (name, value) => window.told.push([name, value]));
</script><iframe id="sco" width="1000" height="700"></iframe>`;
let server, browser, page;
before(async () => {
  server = http.createServer((request, response) => {
    const name = request.url.slice(1);
    const body = name === 'platform.html' ? platform : name === 'runtime.js' ? fs.readFileSync('node_modules/scorm-again/dist/scorm12.min.js') : files.get(name);
    response.writeHead(body ? 200 : 404, {'content-type': name.endsWith('.js') ? 'text/javascript' : 'text/html; charset=utf-8'});
    response.end(body || '');
  }).listen(0, '127.0.0.1');
  await new Promise(done => server.once('listening', done));
  browser = await start('chromium');
  page = await browser.newPage();
  page.setDefaultTimeout(LONGEST);
  await page.goto(`http://127.0.0.1:${server.address().port}/platform.html`);
});
after(async () => {
  await browser?.close();
  server?.close();
  fs.rmSync(path.dirname(file), {recursive: true});
});

const value = name => page.evaluate(each => window.API.LMSGetValue(each), name);
const show = async () => {
  const named = await page.evaluate(text => {
    const xml = new DOMParser().parseFromString(text, 'application/xml');
    if (xml.querySelector('parsererror')) throw new Error(xml.documentElement.textContent);
    return xml.querySelector('resource').getAttribute('href');
  }, manifest);
  await page.evaluate(name => { document.getElementById('sco').src = name; }, named);
  await page.waitForFunction(() => window.told.some(([name]) => name === 'cmi.suspend_data'));
  const frame = await (await page.$('#sco')).contentFrame();
  await frame.waitForSelector('#scene canvas');
  return frame;
};

test('the manifest lists the mechanism and every file of the package', () => {
  assert.match(manifest, /<schemaversion>1\.2<\/schemaversion>/);
  assert.match(manifest, /<title>Geared robotic mechanism<\/title>/);
  for (const [, name] of manifest.matchAll(/<file href="([^"]*)"/g)) assert.ok(files.has(name), name);
  assert.equal(files.size, 2);
});

test('what was not yet seen is incomplete, what was seen is kept, and all of it completes', async () => {
  const frame = await show();
  assert.equal(await value('cmi.core.lesson_status'), 'incomplete');
  assert.match(await value('cmi.suspend_data'), /drawings/);
  for (const part of ['matrices', 'derivation', 'solution'])
    await frame.evaluate(id => document.getElementById(id).scrollIntoView(), part);
  await page.waitForFunction(() => window.API.LMSGetValue('cmi.suspend_data') === 'drawings,matrices,solution,derivation');
  assert.equal(await value('cmi.core.lesson_status'), 'incomplete', 'the exercises are left');
});

test('points of the exercises are the score, and the last of them completes', async () => {
  const frame = await (await page.$('#sco')).contentFrame();
  await frame.waitForSelector('#exercises.live');
  assert.deepEqual([await value('cmi.core.score.raw'), await value('cmi.core.score.max')], ['0', '100']);
  const fill = (at, texts) => frame.evaluate((question, values) => {
    const node = document.querySelectorAll('.question')[question];
    [...node.querySelectorAll('td input')].forEach((input, i) => {
      input.value = values[i];
      input.dispatchEvent(new Event('input', {bubbles: true}));
    });
    node.querySelector('.controls .bar:last-child button').click();
  }, at, texts);
  await fill(0, ['4', '4']);
  assert.deepEqual([await value('cmi.core.score.raw'), await value('cmi.core.lesson_status')], ['14', 'incomplete']);  // one cell of two
  await fill(0, ['4', '3']);
  assert.equal(await value('cmi.core.score.raw'), '43');  // 3 of 7 points
  await fill(1, Array(11).fill('0'));
  assert.deepEqual([await value('cmi.core.score.raw'), await value('cmi.core.lesson_status')], ['43', 'completed']);
  assert.equal(await value('cmi.suspend_data'), 'drawings,matrices,solution,derivation,exercises');
});

test('leaving tells how long it took and finishes', async () => {
  await page.evaluate(() => { document.getElementById('sco').src = 'about:blank'; });
  await page.waitForFunction(() => window.told.some(([name]) => name === 'cmi.core.session_time'));
  const time = await page.evaluate(() => window.told.find(([name]) => name === 'cmi.core.session_time')[1]);
  assert.match(time, /^\d{4}:\d\d:\d\d\.\d\d$/);
  assert.equal(await page.evaluate(() => window.API.isTerminated()), true);
});

test('by itself the page of the package works, too', async () => {
  const alone = await browser.newPage();
  const complaints = [];
  alone.on('pageerror', error => complaints.push(String(error)));
  alone.on('console', message => { if (message.type() === 'error' && !/favicon|404/.test(message.text())) complaints.push(message.text()); });
  await alone.goto(`http://127.0.0.1:${server.address().port}/index.html`);
  await alone.waitForSelector('#scene canvas');
  assert.deepEqual(complaints, []);
});
