// Exported models in a real engine: they turn as the analysis says, slip nowhere, and hold loads as statics says.

import assert from 'node:assert/strict';
import fs from 'node:fs';
import path from 'node:path';
import test from 'node:test';

import {cli, Model, withExport} from './mujoco_model.mjs';

const examples = process.env.GEARGRAPH_EXAMPLES;
const example = (name) => path.join(examples, `${name}.geargraph`);
const json = (words, status = 0) => JSON.parse(cli([...words, '--json'], status).stdout);
const number = (text) => {
  const [above, below = '1'] = String(text).split('/');
  return Number(above) / Number(below);
};
/** The ids of the turning joints by their labels. */
const jointIds = (report) =>
    Object.fromEntries(Object.entries(report.labels.turningJoints).map(([id, label]) => [label, id]));

const driven = [
  [example('robot')],
  [example('planetary-ring-held')],
  [example('three-planets')],
  [example('bevel-differential')],
  [example('humpage-reduction')],
  [example('three-roll-wrist')],
  [example('eight-speed-gearbox'), '--state', '3'],
  [example('eight-speed-gearbox')],  // its couplings are there and hold nothing
  [example('ravigneaux'), '--state', '1'],
];

for (const words of driven) {
  test(`every joint turns at its speed: ${words.map((word) => path.basename(word)).join(' ')}`, () => {
    const report = json(['analyze', ...words, '--no-symbolic']);
    const ids = jointIds(report);
    withExport([...words, '--to', 'mjcf'], (folder) => {
      const model = new Model(folder);
      model.startDriven();
      model.step(Math.round(2 / model.timestep));  // before the robot is at a limit
      const speeds = Object.entries(report.jointSpeeds).map(([label, speed]) => [ids[label], number(speed)]);
      const fastest = Math.max(...speeds.map(([, speed]) => Math.abs(speed)));
      assert.ok(speeds.filter(([, speed]) => speed !== 0).length > 1);
      for (const [joint, speed] of speeds) {
        const found = model.speeds[model.joint(joint)];
        assert.ok(Math.abs(found - speed) < 1e-3 * fastest, `joint ${joint} turns at ${found}, not ${speed}`);
      }
      assert.ok(report.counts.gearMeshes > 0);
      for (let mesh = 0; mesh < report.counts.gearMeshes; ++mesh)
        assert.ok(Math.abs(model.slips[mesh]) < 1e-6, `mesh ${mesh} slips by ${model.slips[mesh]} m`);
    });
  });
}

test('joints stop at their limits and come back', () => {
  const file = example('robot');
  const limits = JSON.parse(fs.readFileSync(file, 'utf8')).turningJoints.filter((joint) => joint.limits)
      .map(({id, limits: [low, high]}) => ({id, low: low * Math.PI / 180, high: high * Math.PI / 180}));
  withExport([file, '--to', 'mjcf'], (folder) => {
    const model = new Model(folder);
    model.startDriven();
    const farthest = () => Math.max(...limits.map(({id, low, high}) => {
      const angle = model.angles[model.joint(id)];
      return angle / (angle < 0 ? low : high);
    }));
    for (const sense of [1, -1]) {
      for (let i = 0; i < model.data.ctrl.length; ++i) model.data.ctrl[i] *= sense;
      let least = 1;
      for (let second = 0; second < 8; ++second) {
        model.step(Math.round(1 / model.timestep));
        least = Math.min(least, farthest());
        assert.ok(farthest() < 1.01, `${farthest()} of its limit`);
      }
      assert.ok(farthest() > 0.99, `only ${farthest()} of its limit`);
      assert.ok(least < 0.7);
    }
  });
});

const loaded = [
  [example('robot'), '14'],
  [example('robot'), '12'],
  [example('planetary-ring-held'), '5'],
];

for (const [file, joint] of loaded) {
  test(`servos hold a load as statics says: ${path.basename(file)}, joint ${joint}`, () => {
    const statics = json(['statics', file, '--load', `joint:${joint}=1Nm`]);
    withExport([file, '--to', 'mjcf'], (folder) => {
      const model = new Model(folder);
      model.apply(joint, 1);
      model.step(Math.round(0.3 / model.timestep));  // servos yield: later the joint rests on its limit
      assert.ok(statics.balances.length > 0);
      statics.balances.forEach((balance, input) => {
        const torque = number(balance.torque);
        assert.ok(Math.abs(model.torques[input] - torque) < 2e-3 * Math.max(1, Math.abs(torque)),
                  `input ${balance.joint} gives ${model.torques[input]}, not ${torque}`);
      });
    });
  });
}

test('the inertia at a motor is that of the equation of motion', () => {
  const report = json(['dynamics', example('planetary-ring-held'), '--torque', '4=0.3Nm']);
  withExport([example('planetary-ring-held'), '--to', 'mjcf', '--motor', 'torque'], (folder) => {
    const model = new Model(folder);
    model.data.ctrl[0] = 0.3;
    model.step(200);
    const acceleration = model.speeds[model.joint('4')] / (200 * model.timestep);
    assert.ok(Math.abs(acceleration / report.accelerations[0] - 1) < 2e-3,
              `${acceleration}, not ${report.accelerations[0]}`);
  });
});

test('joints of URDF follow their input', () => {
  withExport([example('planetary-ring-held'), '--to', 'urdf'], (folder) => {
    const model = new Model(folder);
    model.apply('4', 0.01);
    model.step(500);
    const speeds = json(['analyze', example('planetary-ring-held'), '--no-symbolic']).jointSpeeds;
    for (const joint of ['5', '6']) {
      const ratio = model.speeds[model.joint(joint)] / model.speeds[model.joint('4')];
      const expected = number(speeds[joint]) / number(speeds['4']);
      assert.ok(Math.abs(ratio - expected) < 1e-2, `joint ${joint} follows by ${ratio}, not ${expected}`);
    }
  });
});
