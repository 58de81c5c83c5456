import '../generated/fonts.css';
import '../generated/mathematics.css';
import './style/tokens.css';
import './style/page.css';
import './style/prose.css';
import './style/controls.css';
import { ScriptInterface } from './api';
import { Bridge } from './bridge';
import { raise, showProgress, showTrouble, type Trouble } from './curtain';
import { cameBack, scrollToFigure } from './figure_links';
import { listen } from './input';
import type { LaterParts } from './later_part';
import { loadModule, loadStageFonts, LoadError } from './loading';
import { Page } from './page';
import { listenToPaste } from './points';
import { followSections, makeContents } from './sections';
import { Stage } from './stage';

// This script runs as soon as it has come: the figure does not wait for the end of the text.
const parsed = new Promise<void>((resolve) => {
  if (document.readyState !== 'loading') resolve();
  else addEventListener('DOMContentLoaded', () => resolve(), { once: true });
});
if (!document.getElementById('prose')) await parsed;  // it comes right after the stage

const canvas = document.getElementById('canvas') as HTMLCanvasElement;
let stage: Stage | null = null;
let page: Page | null = null;
let pinned = false;  ///< a script has put something of its own on the stage, before there was a page to tell

const api = new ScriptInterface(
  canvas,
  () => page?.update(),
  (command) => {
    if (page) return page.scenes.own(command);
    command();
    pinned = true;
  },
);
void parsed.then(() => {
  const contents = document.getElementById('contents') as HTMLDetailsElement;
  followSections([...document.querySelectorAll<HTMLElement>('.marks')], contents);
  makeContents(contents);
  if (!cameBack()) scrollToFigure(location.hash);
});
void begin();

async function begin(): Promise<void> {
  document.documentElement.classList.add('scripted');  // again, after a download that has failed
  showProgress(0);
  // What still arrives after one download has failed must not hide the message.
  let waiting = true;
  try {
    const [{ module, parts }, fonts] = await Promise.all([
      loadModule(canvas, () => stage?.request(), (share) => waiting && showProgress(share)),
      loadStageFonts(),
    ]);
    if (__WORDS__) await parts.later.fetch();  // which knows of other languages
    start(new Bridge(module), parts, fonts);
  } catch (error) {
    waiting = false;
    fail(error instanceof LoadError ? error.reason : 'failed', error);
  }
}

function start(bridge: Bridge, parts: LaterParts, fonts: [regular: Uint8Array, semibold: Uint8Array]): void {
  if (!bridge.start('#canvas')) {
    fail('webgl', new Error('WebGL2 is not available'));
    return;
  }
  bridge.font(fonts[0], 400);
  bridge.font(fonts[1], 600);
  stage = new Stage(canvas, bridge, (now) => page?.sync(now), (error) => fail('failed', error));
  listen(canvas, bridge);
  listenToPaste(canvas, bridge, () => page?.update());
  api.attach(bridge);
  stage.watch((present) => (present ? raise() : showTrouble('context', reload)));
  stage.request();
  // The size's observer has drawn the first frame by then: what the page does with it need not keep it waiting.
  const make = (): Promise<void> => parsed.then(() => makePage(bridge, parts)).catch((error) => fail('failed', error));
  requestAnimationFrame(() => requestAnimationFrame(() => void make()));
}

function makePage(bridge: Bridge, parts: LaterParts): void {
  document.documentElement.classList.remove('early');
  page = new Page(bridge, canvas);
  if (pinned) page.scenes.pin();
  // Not over a message that has come up since.
  if (document.getElementById('stage')!.dataset['state'] === 'loading') raise();
  // Who waits for the page to be ready may ask for anything; the figure is alive before.
  // A part that has not come is fetched again by the first call that needs it.
  void parts.later
    .fetch()
    .then(() => bridge.complete(), console.warn)
    .then(() => {
      page?.follow();
      whenReached(document.getElementById('bsplines')!, () => void parts.last.fetch().catch(console.warn));
    })
    .catch((error) => fail('failed', error))
    .finally(() => api.settle());
}

/// When `element` has come into view, or lies above what is seen: there the window reaches as far as a page may.
function whenReached(element: Element, act: () => void): void {
  const observer = new IntersectionObserver(
    (entries) => {
      if (!entries.some(({ isIntersecting }) => isIntersecting)) return;
      observer.disconnect();
      act();
    },
    { rootMargin: '10000000px 0px 0px 0px' },
  );
  observer.observe(element);
}

/// A download can be tried again in place; a script that failed to load stays failed until the page is loaded anew.
function fail(trouble: Trouble, error: unknown): void {
  // The still pictures of the figures come instead.
  document.documentElement.classList.remove('early', 'scripted');
  if (trouble === 'failed') console.error(error);
  else console.warn(error);
  showTrouble(trouble, trouble === 'download' ? () => void begin() : reload);
  if (trouble !== 'download') api.settle(error instanceof Error ? error : new Error(String(error)));
}

function reload(): void {
  location.reload();
}
