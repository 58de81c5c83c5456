// Writes a .br and a .gz beside every file of dist that gains by it, and dist/sizes.json with what they came to.
import { readFile, writeFile } from 'node:fs/promises';
import { join } from 'node:path';
import { promisify } from 'node:util';
import { brotliCompress, constants, gzip } from 'node:zlib';
import { compressible, dist, filesBelow } from './files.mjs';

const brotli = promisify(brotliCompress);
const deflate = promisify(gzip);

const sizes = {};
for (const file of (await filesBelow(dist)).filter((name) => !/\.(br|gz)$/.test(name))) {
  const bytes = await readFile(join(dist, file));
  sizes[file] = { raw: bytes.length };
  if (!compressible.test(file)) continue;
  const [br, gz] = await Promise.all([
    brotli(bytes, {
      params: {
        [constants.BROTLI_PARAM_QUALITY]: 11,
        [constants.BROTLI_PARAM_SIZE_HINT]: bytes.length,
        [constants.BROTLI_PARAM_LGWIN]: 22,
      },
    }),
    deflate(bytes, { level: 9 }),
  ]);
  sizes[file].br = br.length;
  sizes[file].gz = gz.length;
  await Promise.all([writeFile(join(dist, `${file}.br`), br), writeFile(join(dist, `${file}.gz`), gz)]);
}
await writeFile(join(dist, 'sizes.json'), `${JSON.stringify(sizes, null, 2)}\n`);
const total = (kind) => Object.values(sizes).reduce((sum, size) => sum + (size[kind] ?? size.raw), 0);
console.log(`compressed ${Object.keys(sizes).length} files: ${total('raw')} bytes, ${total('br')} with brotli`);
