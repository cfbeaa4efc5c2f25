// A model that geargraph-cli exports, in the engine it was written for.

import {spawnSync} from 'node:child_process';
import fs from 'node:fs';
import os from 'node:os';
import path from 'node:path';

import loadMujoco from '@mujoco/mujoco';

const mujoco = await loadMujoco();

/** One call of the program; the test ends where the status is another than expected. */
export function cli(words, status = 0) {
  const call = spawnSync(process.env.GEARGRAPH_CLI, words, {encoding: 'utf8', maxBuffer: 1 << 28});
  if (call.status !== status) throw new Error(`${words.join(' ')}: status ${call.status}\n${call.stderr}`);
  return call;
}

/** The folder of an export, which is gone after `use`. */
export function withExport(words, use) {
  const folder = fs.mkdtempSync(path.join(os.tmpdir(), 'geargraph-'));
  try {
    const target = path.join(folder, 'model');
    cli(['export', ...words, '-o', target]);
    return use(target);
  } finally {
    fs.rmSync(folder, {recursive: true});
  }
}

export class Model {
  /** `change`: what becomes of the text before the engine reads it. */
  constructor(folder, change = (text) => text) {
    const files = new mujoco.MjVFS();
    for (const mesh of fs.readdirSync(path.join(folder, 'meshes'))) {
      const bytes = new Uint8Array(fs.readFileSync(path.join(folder, 'meshes', mesh)));
      files.addBuffer(`meshes/${mesh}`, bytes);
      files.addBuffer(mesh, bytes);  // of URDF the engine takes names without their folders
    }
    const name = fs.readdirSync(folder).find((file) => /[.](xml|urdf)$/.test(file));
    this.model = mujoco.MjModel.from_xml_string(change(fs.readFileSync(path.join(folder, name), 'utf8')), files);
    this.data = new mujoco.MjData(this.model);
  }

  /** The position of a joint in the lists of angles and speeds. */
  joint(name) {
    const id = mujoco.mj_name2id(this.model, mujoco.mjtObj.mjOBJ_JOINT.value, name);
    if (id < 0) throw new Error(`no joint ${name}`);
    return id;  // every joint is a hinge
  }
  startDriven() {
    mujoco.mj_resetDataKeyframe(this.model, this.data, 0);
  }
  step(count) {
    for (let i = 0; i < count; ++i) mujoco.mj_step(this.model, this.data);
  }
  get timestep() { return this.model.opt.timestep; }
  get angles() { return this.data.qpos; }
  get speeds() { return this.data.qvel; }
  // By tendon: of a mesh the slip along its pitch circles, m.
  get slips() { return this.data.ten_length; }
  get torques() { return this.data.actuator_force; }
  /** A torque on a joint from outside, N m. */
  apply(name, torque) { this.data.qfrc_applied[this.joint(name)] = torque; }
}
