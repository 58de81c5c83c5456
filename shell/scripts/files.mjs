import { readdir } from 'node:fs/promises';
import { join, relative, resolve, sep } from 'node:path';
import { fileURLToPath } from 'node:url';

export const dist = resolve(fileURLToPath(new URL('../dist', import.meta.url)));

/// Paths of all files below `folder`, relative to it, with forward slashes.
export async function filesBelow(folder) {
  const entries = await readdir(folder, { recursive: true, withFileTypes: true });
  return entries
    .filter((entry) => entry.isFile())
    .map((entry) => relative(folder, join(entry.parentPath ?? entry.path, entry.name)).split(sep).join('/'))
    .sort();
}

/// Kinds of files worth compressing; fonts and pictures are compressed already.
export const compressible = /\.(html|css|js|json|svg|wasm|ttf|txt|webmanifest)$/;
