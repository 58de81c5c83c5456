import assert from 'node:assert/strict';
import { mkdirSync, mkdtempSync, rmSync, writeFileSync } from 'node:fs';
import { request, type IncomingMessage } from 'node:http';
import type { AddressInfo } from 'node:net';
import { tmpdir } from 'node:os';
import { join, sep } from 'node:path';
import { after, before, test } from 'node:test';
import { policy } from '../scripts/policy.mjs';
import { encodingsFor, fileFor, serve } from '../scripts/static.mjs';

let folder: string;
let server: Awaited<ReturnType<typeof serve>>;

before(async () => {
  folder = mkdtempSync(join(tmpdir(), 'knotwork-static-'));
  mkdirSync(join(folder, 'assets'));
  writeFileSync(join(folder, 'index.html'), '<!doctype html>plain page');
  writeFileSync(join(folder, 'index.html.br'), 'brotli');
  writeFileSync(join(folder, 'index.html.gz'), 'gzip');
  writeFileSync(join(folder, 'assets', 'm-1a2b.wasm'), 'wasm');
  server = await serve(folder, 0);
});

after(() => {
  server.close();
  rmSync(folder, { recursive: true });
});

/// The path goes out as it is: fetch would tidy it up.
function get(path: string, headers: Record<string, string> = {}, method = 'GET') {
  return new Promise<{ answer: IncomingMessage; body: string }>((resolve, reject) => {
    const { port } = server.address() as AddressInfo;
    request({ host: '127.0.0.1', port, path, headers, method }, (answer) => {
      let body = '';
      answer.setEncoding('utf8').on('data', (text: string) => (body += text));
      answer.on('end', () => resolve({ answer, body }));
    })
      .on('error', reject)
      .end();
  });
}

test('it listens on the loopback interface', () => {
  assert.equal((server.address() as AddressInfo).address, '127.0.0.1');
});

test('the best encoding that the browser takes is sent', async () => {
  const encoding = async (accept?: string): Promise<[string | undefined, string]> => {
    const { answer, body } = await get('/', accept === undefined ? {} : { 'Accept-Encoding': accept });
    return [answer.headers['content-encoding'], body];
  };
  assert.deepEqual(await encoding('gzip, deflate, br'), ['br', 'brotli']);
  assert.deepEqual(await encoding('gzip, br;q=0'), ['gzip', 'gzip']);
  assert.deepEqual(await encoding(), [undefined, '<!doctype html>plain page']);
  assert.deepEqual(encodingsFor('br;q=0.5, gzip;q=1').map(([name]) => name), ['br', 'gzip']);
});

test('types, caching and policy', async () => {
  const page = (await get('/index.html')).answer;
  assert.equal(page.statusCode, 200);
  assert.match(String(page.headers['content-type']), /^text\/html/);
  assert.equal(page.headers['content-security-policy'], policy);
  assert.equal(page.headers['cache-control'], 'no-cache');
  assert.equal(page.headers['x-content-type-options'], 'nosniff');
  const module = (await get('/assets/m-1a2b.wasm')).answer;
  assert.equal(module.headers['content-type'], 'application/wasm');
  assert.match(String(module.headers['cache-control']), /immutable/);
  assert.match(policy, /'wasm-unsafe-eval'/);
  assert.doesNotMatch(policy, /'unsafe-eval'|'unsafe-inline'/);
});

test('HEAD has headers and no body; other methods are refused', async () => {
  const head = await get('/', {}, 'HEAD');
  assert.equal(head.answer.statusCode, 200);
  assert.equal(Number(head.answer.headers['content-length']), '<!doctype html>plain page'.length);
  assert.equal(head.body, '');
  assert.equal((await get('/', {}, 'POST')).answer.statusCode, 405);
});

test('no path leads out of the folder', async () => {
  const outside = ['/../secret', '/..%2fsecret', '/%2e%2e/%2e%2e/etc/passwd', '/assets/../../secret', '/%00', '/%'];
  for (const path of outside) {
    const file = fileFor(folder, path);
    assert.ok(file === null || file.startsWith(folder + sep), `${path} leads to ${file}`);
    assert.equal((await get(path)).answer.statusCode, 404, path);
  }
  assert.equal((await get('/assets')).answer.statusCode, 404, 'a folder is no file');
  assert.equal((await get('/nothing.js')).answer.statusCode, 404);
});
