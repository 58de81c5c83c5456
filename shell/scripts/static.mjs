// Answers requests for a folder of files as a good static host does: compressed copies, right types, caching by content
// hash, security headers.
import { createReadStream } from 'node:fs';
import { stat } from 'node:fs/promises';
import { createServer } from 'node:http';
import { extname, join, normalize, sep } from 'node:path';
import { policy } from './policy.mjs';

const types = {
  '.css': 'text/css; charset=utf-8',
  '.html': 'text/html; charset=utf-8',
  '.ico': 'image/x-icon',
  '.js': 'text/javascript; charset=utf-8',
  '.json': 'application/json; charset=utf-8',
  '.png': 'image/png',
  '.svg': 'image/svg+xml; charset=utf-8',
  '.ttf': 'font/ttf',
  '.txt': 'text/plain; charset=utf-8',
  '.wasm': 'application/wasm',
  '.webmanifest': 'application/manifest+json; charset=utf-8',
  '.woff2': 'font/woff2',
};

/// The file below `folder` that a request's path means, or null where it means none there.
export function fileFor(folder, url) {
  let path;
  try {
    path = decodeURIComponent(new URL(url, 'http://localhost').pathname);
  } catch {
    return null;
  }
  if (path.includes('\0')) return null;
  const file = normalize(join(folder, path.endsWith('/') ? `${path}index.html` : path));
  return file.startsWith(folder + sep) ? file : null;
}

/// The copies of a file to look for, best first, given the Accept-Encoding header.
export function encodingsFor(accept) {
  const accepted = new Map(
    (accept ?? '').split(',').map((entry) => {
      const [name, ...parameters] = entry.trim().split(';');
      const quality = parameters.map((p) => /^\s*q=([\d.]+)$/.exec(p)?.[1]).find(Boolean);
      return [name.trim().toLowerCase(), quality === undefined ? 1 : Number(quality)];
    }),
  );
  return [['br', '.br'], ['gzip', '.gz']].filter(([name]) => (accepted.get(name) ?? 0) > 0);
}

export async function sizeOf(file) {
  try {
    const found = await stat(file);
    return found.isFile() ? found.size : null;
  } catch {
    return null;
  }
}

function end(request, response, status, text) {
  const body = Buffer.from(`${text}\n`);
  response.writeHead(status, { 'Content-Type': 'text/plain; charset=utf-8', 'Content-Length': body.length });
  response.end(request.method === 'HEAD' ? undefined : body);
}

async function answer(folder, request, response) {
  response.setHeader('X-Content-Type-Options', 'nosniff');
  response.setHeader('Referrer-Policy', 'strict-origin-when-cross-origin');
  response.setHeader('Cross-Origin-Opener-Policy', 'same-origin');
  if (request.method !== 'GET' && request.method !== 'HEAD') {
    response.setHeader('Allow', 'GET, HEAD');
    return end(request, response, 405, 'only GET and HEAD');
  }
  const file = fileFor(folder, request.url ?? '/');
  const raw = file && (await sizeOf(file));
  if (!file || raw === null) return end(request, response, 404, 'not found');

  const extension = extname(file);
  response.setHeader('Content-Type', types[extension] ?? 'application/octet-stream');
  response.setHeader(
    'Cache-Control',
    file.startsWith(join(folder, 'assets') + sep) ? 'public, max-age=31536000, immutable' : 'no-cache',
  );
  if (extension === '.html') response.setHeader('Content-Security-Policy', policy);
  response.setHeader('Vary', 'Accept-Encoding');
  let [chosen, size] = [file, raw];
  for (const [name, suffix] of encodingsFor(request.headers['accept-encoding'])) {
    const compressed = await sizeOf(file + suffix);
    if (compressed === null || compressed >= size) continue;
    [chosen, size] = [file + suffix, compressed];
    response.setHeader('Content-Encoding', name);
    break;
  }
  response.writeHead(200, { 'Content-Length': size });
  if (request.method === 'HEAD') return response.end();
  createReadStream(chosen).on('error', () => response.destroy()).pipe(response);
}

/// Listens on the loopback interface only. `folder` is absolute.
export function serve(folder, port) {
  const server = createServer((request, response) => {
    answer(folder, request, response).catch(() => response.destroy());
  });
  return new Promise((resolve, reject) => {
    server.on('error', reject).listen(port, '127.0.0.1', () => resolve(server));
  });
}
