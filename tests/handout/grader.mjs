// The grader of handouts against that of the program: the same verdict on every answer of the corpus.
import assert from 'node:assert/strict';
import {spawn} from 'node:child_process';
import {once} from 'node:events';
import fs from 'node:fs';
import path from 'node:path';
import readline from 'node:readline';
import test from 'node:test';
import {handout} from './pages.mjs';

const resources = process.env.GEARGRAPH_HANDOUT;
const page = fs.readFileSync(new URL(handout('robot', '--exercises')), 'utf8');
const data = JSON.parse(/<script type="application\/json" id="mechanism">([^<]*)<\/script>/.exec(page)[1]);
const script = ['texts', 'rational', 'solver', 'answers', 'grader'].map(name => fs.readFileSync(path.join(resources, name + '.js'), 'utf8'));
const {grade, readNumber} = new Function('data', script.join('\n') + '\nreturn {grade, readNumber};')(data);

test('both graders agree about every answer', async t => {
  const corpus = spawn(process.env.GEARGRAPH_CORPUS, {stdio: ['ignore', 'pipe', 'inherit']});
  const ended = once(corpus, 'close');
  const kinds = new Set(), names = new Set();
  const counts = {questions: 0, answers: 0, right: 0, named: 0, unnamed: 0};
  const disagreements = [];
  for await (const line of readline.createInterface({input: corpus.stdout})) {
    const {question, cases} = JSON.parse(line);
    ++counts.questions;
    kinds.add(question.kind);
    for (const {answer, verdict} of cases) {
      const own = grade(question, answer);
      ++counts.answers;
      ++counts[own.isRight ? 'right' : own.mistakes.length ? 'named' : 'unnamed'];
      for (const {name} of own.mistakes) names.add(name);
      if (JSON.stringify(own) !== JSON.stringify(verdict) && disagreements.push({prompt: question.prompt, answer, own, verdict}) > 20) break;
    }
    if (disagreements.length > 20) corpus.kill();
  }
  const [status] = await ended;
  t.diagnostic(`${counts.questions} questions of ${kinds.size} kinds, ${counts.answers} answers: ${counts.right} right, ` +
               `${counts.named} with a named mistake (${names.size} names), ${counts.unnamed} wrong without a name; ` +
               `${disagreements.length} disagreements`);
  assert.deepEqual(disagreements, []);
  assert.equal(status, 0);
  assert.ok(counts.questions > 4000 && counts.answers > 150000, 'the corpus is large');
  assert.ok(counts.right > 20000 && counts.named > 120000 && counts.unnamed > 5000, 'and has answers of every sort');
  assert.ok(kinds.size >= 24 && names.size >= 80, `${kinds.size} kinds, ${names.size} mistakes`);
});

test('every spelling has its verdict', () => {
  const {symbols, choices, set, spellings} = JSON.parse(fs.readFileSync(new URL('spellings.json', import.meta.url), 'utf8'));
  const faults = [];
  for (const [text, value, kind, language, expected] of spellings) {
    const isNumber = !['integer', 'choice', 'set'].includes(kind);
    const field = {name: 'x', kind: isNumber ? 'number' : kind, options: {choice: choices, set}[kind],
                   unit: isNumber && kind !== 'number' ? kind : undefined};
    const question = {kind: 'spelling', points: 4, rule: 'Rule.', fields: [field], solution: [value], mistakes: [], symbols,
                      decimal: language === 'en' ? undefined : ',', accepted: [{test: 'values', values: [[value]]}]};
    const {isRight, isBlank, isUnreadable} = grade(question, [text]);
    const verdict = isRight ? 'right' : isBlank ? 'blank' : isUnreadable ? 'unreadable' : 'wrong';
    if (verdict !== expected) faults.push({text, value, language, verdict, expected});
  }
  assert.deepEqual(faults, []);
  assert.ok(spellings.length >= 300, `${spellings.length} spellings`);
});

test('the corpus would show a grader that reads otherwise', () => {
  const question = {kind: 'k', prompt: '', points: 2, fields: [{name: 'a', kind: 'number'}], solution: ['1/3'], rule: 'Rule.',
                    accepted: [{test: 'values', values: [['1/3']]}],
                    mistakes: [{name: 'ratio-upside-down', when: [{test: 'values', values: [['3']]}], fields: [0], reason: 'Reason.'}]};
  for (const right of ['1/3', '2:6', '0.333', '0,3333', '(1)/3']) assert.ok(grade(question, [right]).isRight, right);
  assert.equal(grade(question, ['6/2']).reason, 'Reason.');
  assert.equal(grade(question, ['0.33']).reason, 'Rule.');
  assert.equal(readNumber('1,250').fault, 'ambiguous');
});
