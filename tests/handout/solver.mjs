// The script of handouts against the program: the solution in fractions of every example that has one.
import assert from 'node:assert/strict';
import fs from 'node:fs';
import path from 'node:path';
import test from 'node:test';
import {exampleFile, examples, geargraph, handout} from './pages.mjs';

const resources = process.env.GEARGRAPH_HANDOUT;
const script = ['rational.js', 'solver.js'].map(name => fs.readFileSync(path.join(resources, name), 'utf8'));
const {Rational, gainsOf, ratesOf, periodOf} =
    new Function(script.join('\n') + '\nreturn {Rational, gainsOf, ratesOf, periodOf};')();

// As the tests in browsers open it, with exercises where they go with the options: made once for both.
const handoutData = (example, ...words) => {
  const text = fs.readFileSync(new URL(handout(example, ...(words.length ? words : ['--exercises']))), 'utf8');
  return JSON.parse(/<script type="application\/json" id="mechanism">([^<]*)<\/script>/.exec(text)[1]);
};
const plain = value => value.toString().replace('\u2212', '-');

const check = (example, ...words) => {
  const data = handoutData(example, ...words);
  const analysis = JSON.parse(geargraph('analyze', exampleFile(example), '--json', ...words));
  if (!analysis.solution) {
    assert.equal(data.inputs.length, 0);
    return 0;
  }
  const rows = data.rows.map(row => row.map(([joint, value]) => [joint, Rational.from(value)]));
  const gains = gainsOf(rows, data.joints.length, data.inputs);
  const ordinal = new Map(data.joints.map((joint, i) => [joint.label, i]));
  assert.deepEqual(data.inputs.map(i => data.joints[i].label), analysis.solution.inputs);
  analysis.solution.outputs.forEach((label, i) =>
    assert.deepEqual(gains[ordinal.get(label)].map(plain), analysis.solution.exact[i]));
  const rates = ratesOf(gains, data.speeds.map(text => Rational.from(text)));
  for (const joint of data.joints) assert.equal(plain(rates[ordinal.get(joint.label)]), analysis.jointSpeeds[joint.label] ?? analysis.jointSpeeds[joint.id]);
  return 1;
};

test('every example is solved as the program solves it', () => {
  let solved = 0;
  for (const name of fs.readdirSync(examples).filter(each => each.endsWith('.geargraph')))
    solved += check(path.basename(name, '.geargraph'));
  assert.ok(solved >= 12, `${solved} examples`);
});

test('every state of the gearbox, with the rows of its brakes and clutches', () => {
  const states = JSON.parse(fs.readFileSync(exampleFile('eight-speed-gearbox'), 'utf8')).states;
  let solved = 0;
  for (const state of states) solved += check('eight-speed-gearbox', '--state', state.name);
  assert.ok(solved >= 8, `${solved} states`);
});

test('inputs that are not valid have no solution', () => {
  const data = handoutData('robot');
  const rows = data.rows.map(row => row.map(([joint, value]) => [joint, Rational.from(value)]));
  assert.equal(gainsOf(rows, 7, [0, 2, 3]), null);  // joint 10 follows from joint 8
  assert.notEqual(gainsOf(rows, 7, [2, 1, 3]), null);
});

test('numbers as they are typed', () => {
  for (const [text, value] of [['2', '2'], [' -3/4 ', '-3/4'], ['0.75', '3/4'], ['0,75', '3/4'], ['.5', '1/2'],
                               ['\u22121/2', '-1/2'], ['6/4', '3/2'], ['+1', '1'], ['1.', '1']])
    assert.equal(plain(Rational.from(text)), value);
  for (const text of ['', '.', '1/0', 'a', '1/2/3', '1e5', '--1', '1.2.3', '1/2.5'])
    assert.equal(Rational.from(text), null, text);
});

test('the period of the robot, and of a train at rest', () => {
  const rates = ['1', '1/2', '-1/2', '0', '-2/3', '-8/9', '-16/27'].map(text => Rational.from(text));
  assert.equal(plain(periodOf(rates)), '54');
  assert.equal(periodOf([Rational.from('0')]), null);
});

test('fractions of thousands of digits are numbers', () => {
  let power = Rational.from('1');
  for (let i = 0; i < 4000; ++i) power = power.times(Rational.from('3/2'));
  assert.ok(Math.abs(power.over(power.times(Rational.from('4'))).toNumber() - 0.25) < 1e-15);
  const third = new Rational(10n ** 400n, 3n * 10n ** 400n + 1n);
  assert.ok(Math.abs(third.toNumber() - 1 / 3) < 1e-15);
});

test('links stand where the program has them', () => {
  const {placedBy} = new Function(['rational', 'solver', 'poses', 'motion'].map(name => fs.readFileSync(path.join(resources, name + '.js'), 'utf8'))
      .join('\n') + '\nreturn {placedBy: (data, turns) => {' +
      'const rows = data.rows.map(row => row.map(([joint, value]) => [joint, Rational.from(value)]));' +
      'const motion = new Motion(gainsOf(rows, data.joints.length, data.inputs), data.speeds.map(text => Rational.from(text)), data.joints);' +
      'motion.start = turns.map(text => Rational.from(text));' +
      'return posesOf(data.movers, motion.angles()); }};')();
  let compared = 0;
  for (const name of ['robot', 'planetary-ring-held', 'bevel-wrist', 'humpage-reduction', 'bevel-differential']) {
    const data = handoutData(name);
    // Turns of a twelfth and of many times one: 30 degrees, 4,000 of them.
    const turns = data.inputs.map((_, i) => (i % 2 === 0 ? '1/12' : '1000/3'));
    const angles = data.inputs.map((joint, i) => ['--angle', `${data.joints[joint].label}=${i % 2 === 0 ? 30 : 120000}deg`]);
    const pose = JSON.parse(geargraph('pose', exampleFile(name), '--json', ...angles.flat()));
    placedBy(data, turns).forEach(({r, t}, node) => {
      const label = node === 0 ? '0' : Object.keys(pose.links)[node];
      const {rotation, point} = pose.links[label];
      const size = Math.max(1, ...point.map(Math.abs));
      rotation.flat().forEach((each, i) => assert.ok(Math.abs(each - r[i]) < 1e-9, `${name}, link ${label}`));
      point.forEach((each, i) => assert.ok(Math.abs(each - t[i]) < 1e-9 * size, `${name}, link ${label}`));
      ++compared;
    });
  }
  assert.ok(compared > 25, `${compared} poses`);
});

test('a motion stops at the limits of its joints and comes back', () => {
  const {Motion: MotionClass} = new Function(['rational', 'solver', 'poses', 'motion'].map(name => fs.readFileSync(path.join(resources, name + '.js'), 'utf8'))
      .join('\n') + '\nreturn {Motion};')();
  const gains = [[Rational.from('1')], [Rational.from('-1/2')]];
  const joints = [{}, {low: -Math.PI / 2, high: Math.PI}];
  const motion = new MotionClass(gains.map(row => row.map(each => each)), [Rational.from('2')], joints);
  const range = motion.range();
  assert.ok(Math.abs(range.to - 0.25) < 1e-12 && range.toJoint === 1);
  assert.ok(Math.abs(range.from + 0.5) < 1e-12 && range.fromJoint === 1);
  assert.equal(motion.goTo(0.1), -1);
  assert.equal(motion.goTo(10), 1);
  assert.ok(motion.time.toNumber() <= 0.25 && motion.time.toNumber() > 0.2499);
  motion.take([Rational.from('-2')]);
  assert.equal(motion.time.toNumber(), 0);
  assert.ok(Math.abs(motion.inputTurns()[0].toNumber() - 0.5) < 1e-4);
  assert.ok(Math.abs(motion.range().to - 0.75) < 1e-4);
});
