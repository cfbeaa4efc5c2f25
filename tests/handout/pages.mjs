// The program, and the handouts that it makes of the examples: the tests in browsers and those of the script share them.
import {execFileSync} from 'node:child_process';
import fs from 'node:fs';
import path from 'node:path';
import {pathToFileURL} from 'node:url';

const cli = process.env.GEARGRAPH_CLI;
export const examples = process.env.GEARGRAPH_EXAMPLES;

// The exit status 1 is that of a mechanism with errors.
export const geargraph = (...words) => {
  try {
    return execFileSync(cli, words, {maxBuffer: 1 << 28, stdio: ['ignore', 'pipe', 'pipe']}).toString();
  } catch (error) {
    if (error.status !== 1) throw new Error(`geargraph-cli ${words.join(' ')}: ${error.stderr}`);
    return error.stdout.toString();
  }
};
export const exampleFile = example => path.join(examples, example + '.geargraph');

// The address of the handout of an example. Each is made once as long as the program is the same, also where two tests that run
// beside each other ask for it.
export const handout = (example, ...asked) => {
  const words = asked.includes('--exercises') && !asked.includes('--seed') ? [...asked, '--seed', '1'] : asked;
  const folder = process.env.GEARGRAPH_PAGES;
  fs.mkdirSync(folder, {recursive: true});
  const file = path.join(folder, [example, ...words].join('_').replace(/[^-\w]/g, '') + '.html');
  if (!fs.existsSync(file) || fs.statSync(file).mtimeMs < fs.statSync(cli).mtimeMs) {
    const own = `${file}.${process.pid}`;
    geargraph('export', exampleFile(example), '--to', 'handout', ...words, '-o', own);
    fs.renameSync(own, file);
  }
  return pathToFileURL(file).href;
};
