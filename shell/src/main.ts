import '../generated/fonts.css';
import '../generated/mathematics.css';
import './style/tokens.css';
import './style/page.css';
import './style/prose.css';
import './style/controls.css';
import { ScriptInterface } from './api';
import { Bridge } from './bridge';
import { raise, showProgress, showTrouble, type Trouble } from './curtain';
import { listen } from './input';
import { loadModule, loadStageFonts, LoadError } from './loading';
import { Page } from './page';
import { followSections } from './sections';
import { Stage } from './stage';

const canvas = document.getElementById('canvas') as HTMLCanvasElement;
let stage: Stage | null = null;
let page: Page | null = null;

const api = new ScriptInterface(canvas, () => {
  page?.update();
  stage?.request();
});
followSections([...document.querySelectorAll<HTMLAnchorElement>('.marks a')]);
void begin();

async function begin(): Promise<void> {
  showProgress(0);
  try {
    const [module, fonts] = await Promise.all([loadModule(canvas, showProgress), loadStageFonts()]);
    const bridge = new Bridge(module);
    if (fonts) {
      bridge.font(fonts[0], 400);
      bridge.font(fonts[1], 600);
    }
    start(bridge);
  } catch (error) {
    fail(error instanceof LoadError ? error.reason : 'failed', error);
  }
}

function start(bridge: Bridge): void {
  const drawn = (): void => {
    page?.sync(performance.now());
  };
  stage = new Stage(canvas, bridge, drawn);
  stage.prepare();
  if (!bridge.start('#canvas')) {
    fail('webgl', new Error('WebGL2 is not available'));
    return;
  }
  page = new Page(bridge, () => stage?.request(), canvas);
  listen(canvas, bridge, () => stage?.request());
  stage.watch((present) => (present ? raise() : showTrouble('context', reload)));
  api.attach(bridge);
  stage.request();
  requestAnimationFrame(() => {
    raise();
    api.settle();
  });
}

/// A download can be tried again in place; a script that failed to load stays failed until the page is loaded anew.
function fail(trouble: Trouble, error: unknown): void {
  console.warn(error);
  showTrouble(trouble, trouble === 'download' ? () => void begin() : reload);
  if (trouble !== 'download') api.settle(error instanceof Error ? error : new Error(String(error)));
}

function reload(): void {
  location.reload();
}
