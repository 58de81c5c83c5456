import type { Bridge } from './bridge';

/// The canvas and its frames. Draws only when the module wants another frame or something asked for one; an idle page
/// draws nothing.
export class Stage {
  private pending = 0;
  private present = true;
  private readonly canvas: HTMLCanvasElement;
  private readonly bridge: Bridge;
  private readonly afterFrame: (now: number) => void;
  private readonly onFailure: (error: unknown) => void;

  constructor(
    canvas: HTMLCanvasElement,
    bridge: Bridge,
    afterFrame: (now: number) => void,
    onFailure: (error: unknown) => void,
  ) {
    this.canvas = canvas;
    this.bridge = bridge;
    this.afterFrame = afterFrame;
    this.onFailure = onFailure;
  }

  /// Follows the canvas's size, the reader's settings, the page's visibility and the context's fate.
  watch(onContext: (present: boolean) => void): void {
    follow('(prefers-color-scheme: dark)', (dark) => this.bridge.scheme(dark));
    follow('(prefers-reduced-motion: reduce)', (reduced) => this.bridge.reducedMotion(reduced));
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
      this.present = this.bridge.context(true);
      if (!this.present) return;  // the message stays
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
    cancelAnimationFrame(this.pending);  // a resize draws before its turn: left waiting, it would start a second chain
    this.pending = 0;
    try {
      if (this.bridge.frame(now)) this.request();
      this.afterFrame(now);
    } catch (error) {
      this.present = false;  // whatever it was, the next frame would not mend it
      this.onFailure(error);
    }
  }

  private watchSize(): void {
    const observer = new ResizeObserver(([entry]) => {
      if (!entry) return;
      const { width, height } = entry.contentRect;
      const device = (entry.devicePixelContentBoxSize as readonly ResizeObserverSize[] | undefined)?.[0];
      this.bridge.resize(width, height, pixelRatio(width, device?.inlineSize));
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
}

/// Device pixels in a CSS pixel: exact where the browser tells the canvas's own width in device pixels. (An emulated
/// screen tells the width without its scale.)
export function pixelRatio(width: number, deviceWidth: number | undefined): number {
  if (!deviceWidth || !(width > 0)) return devicePixelRatio;
  const exact = deviceWidth / width;
  return Math.abs(exact / devicePixelRatio - 1) < 0.05 ? exact : devicePixelRatio;
}

/// Tells the state of a media query now and whenever it changes.
function follow(query: string, tell: (matches: boolean) => void): void {
  const list = matchMedia(query);
  tell(list.matches);
  list.addEventListener('change', () => tell(list.matches));
}
