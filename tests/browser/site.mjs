// The built site, a browser, and pages on it. One browser a test file; a fresh context a test.
import assert from 'node:assert/strict';
import { existsSync } from 'node:fs';
import { readFile } from 'node:fs/promises';
import { createServer } from 'node:http';
import { dirname, extname, join, normalize, resolve } from 'node:path';
import { fileURLToPath } from 'node:url';
import { chromium } from 'playwright-core';
import { serve } from '../../shell/scripts/static.mjs';
import { settled } from './stage.mjs';

const repository = resolve(dirname(fileURLToPath(import.meta.url)), '../..');
export const siteFolder = join(repository, 'shell/dist');

function chromiumPath() {
  const { KNOTWORK_CHROMIUM, CHROMIUM } = process.env;
  return KNOTWORK_CHROMIUM ?? CHROMIUM ?? '/usr/bin/chromium';
}

// Rendering in software on any machine, so that pictures do not depend on it; and a browser that calls nobody.
const browserArguments = [
  '--no-sandbox',
  '--disable-quic',
  '--no-first-run',
  '--disable-background-networking',
  '--disable-component-update',
  '--disable-sync',
  '--use-angle=swiftshader',
  '--enable-unsafe-swiftshader',
  '--disable-gpu-compositing',  // the page around the stage is cheaper without
];

const closing = [];

/// Ends the shared browser and the shell's server.
export async function closeShared() {
  for (const close of closing.reverse()) await close();
}

function once(make) {
  let made;
  return () => (made ??= make());
}

/// The shell's own server on a port that the system chose; its address with a slash at the end.
export const siteAddress = once(async () => {
  assert.ok(existsSync(join(siteFolder, 'index.html')), 'the site is not built: run npm run build in shell/');
  const server = await serve(siteFolder, 0);
  closing.push(() => closed(server));
  return `http://localhost:${server.address().port}/`;
});

function closed(server) {
  server.closeAllConnections();
  return new Promise((done) => server.close(done));
}

const plainTypes = {
  '.html': 'text/html',
  '.js': 'text/javascript',
  '.css': 'text/css',
  '.svg': 'image/svg+xml',
  '.png': 'image/png',
  '.woff2': 'font/woff2',
};

/// The same folder as a host without any knowledge of it would serve it: under a path, no headers beyond a type, and
/// that unknown for WebAssembly.
export async function plainHost(path) {
  const server = createServer(async (request, response) => {
    const name = decodeURIComponent(new URL(request.url, 'http://host').pathname);
    const inside = name.startsWith(path) ? normalize(name.slice(path.length)) : undefined;
    try {
      if (inside === undefined || inside.startsWith('..')) throw new Error('outside');
      const file = inside === '.' || inside.endsWith('/') ? join(inside, 'index.html') : inside;
      const body = await readFile(join(siteFolder, file));
      response.writeHead(200, { 'content-type': plainTypes[extname(file)] ?? 'application/octet-stream' }).end(body);
    } catch {
      response.writeHead(404).end();
    }
  });
  await new Promise((listening) => server.listen(0, '127.0.0.1', listening));
  return {
    address: `http://127.0.0.1:${server.address().port}${path}`,
    close: () => closed(server),
  };
}

export async function launch(extraArguments = []) {
  const browser = await chromium.launch({
    executablePath: chromiumPath(),
    args: [...browserArguments, ...extraArguments],
  });
  return browser;
}

export const sharedBrowser = once(async () => {
  const browser = await launch();
  closing.push(() => browser.close());
  return browser;
});

/// Everything on a page that a reader's console would show in red, and every request that leaves the site.
function watch(page, origin, complaints) {
  page.on('console', (message) => {
    if (message.type() === 'error') complaints.push(`console: ${message.text()} (${message.location().url})`);
  });
  page.on('pageerror', (error) => complaints.push(`uncaught: ${error.stack ?? error}`));
  page.on('request', (request) => {
    const url = new URL(request.url());
    if (url.origin !== origin && !['data:', 'blob:'].includes(url.protocol)) complaints.push(`request: ${url}`);
  });
}

/// The page's own start document, all patches in their places and without the shaded surface: drawn in software, that
/// would take nine tenths of the time. The tests that are about pixels ask for the full picture.
async function loadLean(page, surface) {
  await page.evaluate((surface) => {
    const document = window.knotwork.document();
    document.objects[0].samples = { u: 24, v: 16 };
    document.objects[0].patches = [];
    document.display.surface = surface;
    document.display.adaptive = false;
    window.knotwork.load(document);
  }, surface);
}

/// What a script opens stays on the stage while a test scrolls the page; and it stands still, which the first figure
/// does not. That it comes into view belongs to the opening.
async function openStill(page) {
  await page.evaluate(() => window.knotwork.open('blending-surface'));
  await settled(page);
}

/// Drawn in software, smooth edges are half of a frame's time: a stage that is not to be looked at goes without.
function drawRough() {
  const { getContext } = HTMLCanvasElement.prototype;
  HTMLCanvasElement.prototype.getContext = function (kind, attributes) {
    return getContext.call(this, kind, { ...attributes, antialias: false });
  };
}

/// Options: followed: the stage goes with the reader instead; full: the page as a reader finds it; drawn: with its
/// surface, but few samples; smooth: with smooth edges; size [w, h] in CSS pixels; scale, the device pixel ratio (0.5
/// unless full or drawn); touch, a phone's context; dark; reducedMotion; scripts: false without JavaScript; address;
/// browser; wait: false does not wait for the figure; before(page): runs before the page is opened; expected: patterns
/// of complaints that are provoked.
export async function openPage(options = {}) {
  const [width, height] = options.size ?? [1040, 560];
  const browser = options.browser ?? (await sharedBrowser());
  const context = await browser.newContext({
    viewport: { width, height },
    // Drawn in software, pixels are what takes time: a test that is not about them sees the page zoomed out.
    deviceScaleFactor: options.scale ?? (options.full || options.drawn ? 1 : 0.5),
    hasTouch: options.touch ?? false,
    isMobile: options.touch ?? false,
    colorScheme: options.dark ? 'dark' : 'light',
    reducedMotion: options.reducedMotion ? 'reduce' : 'no-preference',
    javaScriptEnabled: options.scripts ?? true,
  });
  const page = await context.newPage();
  page.setDefaultTimeout(20000);
  const address = options.address ?? (await siteAddress());
  const complaints = [];
  watch(page, new URL(address).origin, complaints);
  if (!options.smooth) await page.addInitScript(drawRough);
  await options.before?.(page);
  await page.goto(address);
  if (options.wait ?? true) {
    await page.waitForFunction(() => window.knotwork);
    await page.evaluate(() => window.knotwork.ready);
    if (!options.followed) await openStill(page);
    if (!options.full) await loadLean(page, options.drawn ?? false);
  }
  return {
    page,
    context,
    complaints: () => complaints.filter((text) => !(options.expected ?? []).some((pattern) => pattern.test(text))),
    close: () => context.close(),
  };
}
