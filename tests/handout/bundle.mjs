// The bundled library is what its sources give: the same bytes from the command of package.json.
import assert from 'node:assert/strict';
import {execFileSync} from 'node:child_process';
import fs from 'node:fs';
import path from 'node:path';
import test from 'node:test';

const resources = process.env.GEARGRAPH_HANDOUT;

test('three.min.js is built from three.entry.js', () => {
  fs.copyFileSync(path.join(resources, 'three.entry.js'), 'three.entry.js');
  execFileSync('npm', ['run', 'build'], {stdio: 'ignore'});
  assert.ok(fs.readFileSync('three.min.js').equals(fs.readFileSync(path.join(resources, 'three.min.js'))));
});

test('the licence is the one of the library', () => {
  const own = fs.readFileSync('node_modules/three/LICENSE', 'utf8');
  assert.equal(fs.readFileSync(path.join(resources, 'three.LICENSE'), 'utf8'), own);
});
