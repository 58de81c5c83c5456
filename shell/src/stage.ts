import type { Bridge } from './bridge';

/// The canvas and its frames. Draws only when the module wants another frame or something asked for one; an idle page
/// draws nothing.
export class Stage {
  private pending = 0;
  private present = true;
  private readonly canvas: HTMLCanvasElement;
  private readonly bridge: Bridge;
  private readonly afterFrame: () => void;

  constructor(canvas: HTMLCanvasElement, bridge: Bridge, afterFrame: () => void) {
    this.canvas = canvas;
    this.bridge = bridge;
    this.afterFrame = afterFrame;
  }

  /// Sizes the canvas and tells the module about the reader's settings. Before knotwork_start, and once.
  prepare(): void {
    const rect = this.canvas.getBoundingClientRect();
    this.resize(rect.width, rect.height, rect.width * devicePixelRatio, rect.height * devicePixelRatio);
    follow('(prefers-color-scheme: dark)', (dark) => this.tell(() => this.bridge.scheme(dark)));
    follow('(prefers-reduced-motion: reduce)', (reduced) => this.tell(() => this.bridge.reducedMotion(reduced)));
  }

  /// After knotwork_start: follows the canvas's size, the page's visibility and the context's fate.
  watch(onContext: (present: boolean) => void): void {
    this.watchSize();
    document.addEventListener('visibilitychange', () => {
      if (!document.hidden) this.request();
    });
    this.canvas.addEventListener('webglcontextlost', (event) => {
      event.preventDefault();  // or it would never come back
      this.present = false;
      cancelAnimationFrame(this.pending);
      this.pending = 0;
      this.bridge.context(false);
      onContext(false);
    });
    this.canvas.addEventListener('webglcontextrestored', () => {
      this.present = true;
      this.bridge.context(true);
      onContext(true);
      this.request();
    });
  }

  /// Asks for a frame; asking twice draws one.
  request(): void {
    if (this.pending !== 0 || !this.present) return;
    this.pending = requestAnimationFrame((now) => this.draw(now));
  }

  private draw(now: number): void {
    this.pending = 0;
    if (this.bridge.frame(now)) this.request();
    this.afterFrame();
  }

  private tell(change: () => void): void {
    change();
    this.request();
  }

  private watchSize(): void {
    const observer = new ResizeObserver(([entry]) => {
      if (!entry) return;
      const { width, height } = entry.contentRect;
      const device = (entry.devicePixelContentBoxSize as readonly ResizeObserverSize[] | undefined)?.[0];
      this.resize(
        width, height,
        device?.inlineSize ?? width * devicePixelRatio,
        device?.blockSize ?? height * devicePixelRatio,
      );
      // A resized canvas is blank: fill it within this very frame.
      if (this.present) this.draw(performance.now());
    });
    try {
      observer.observe(this.canvas, { box: 'device-pixel-content-box' });
    } catch {
      observer.observe(this.canvas);
      const followRatio = (): void => {
        matchMedia(`(resolution: ${devicePixelRatio}dppx)`).addEventListener(
          'change',
          () => {
            observer.unobserve(this.canvas);
            observer.observe(this.canvas);
            followRatio();
          },
          { once: true },
        );
      };
      followRatio();
    }
  }

  private resize(width: number, height: number, deviceWidth: number, deviceHeight: number): void {
    const [w, h] = [Math.max(1, Math.round(deviceWidth)), Math.max(1, Math.round(deviceHeight))];
    if (this.canvas.width !== w) this.canvas.width = w;
    if (this.canvas.height !== h) this.canvas.height = h;
    this.bridge.resize(width, height, width > 0 ? w / width : devicePixelRatio);
  }
}

/// Tells the state of a media query now and whenever it changes.
function follow(query: string, tell: (matches: boolean) => void): void {
  const list = matchMedia(query);
  tell(list.matches);
  list.addEventListener('change', () => tell(list.matches));
}
