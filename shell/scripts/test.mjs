// Runs tests/*.test.ts with Node's test runner: bundled first, as Node 20 does not read TypeScript.
import { spawnSync } from 'node:child_process';
import { readdirSync, rmSync } from 'node:fs';
import { join } from 'node:path';
import { fileURLToPath } from 'node:url';
import { build } from 'vite';

const root = fileURLToPath(new URL('..', import.meta.url));
const out = join(root, 'node_modules', '.cache', 'knotwork-tests');
rmSync(out, { recursive: true, force: true });
const names = readdirSync(join(root, 'tests')).filter((name) => name.endsWith('.test.ts'));
await build({
  root,
  configFile: false,
  logLevel: 'warn',
  define: { __WORDS__: 'null' },
  build: {
    ssr: true,
    outDir: out,
    target: 'node20',
    rollupOptions: {
      input: names.map((name) => join(root, 'tests', name)),
      output: { entryFileNames: '[name].mjs' },
    },
  },
});
const files = names.map((name) => join(out, name.replace(/\.ts$/, '.mjs')));
process.exitCode = spawnSync(process.execPath, ['--test', ...files], { stdio: 'inherit', cwd: root }).status ?? 1;
