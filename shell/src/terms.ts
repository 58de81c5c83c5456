import type { HeldKind } from '../plugins/symbols';
import type { Bridge } from './bridge';

/// While a hand moves a handle or a knot, the letters that denote it light up in the formulas of the figure's chapter,
/// whose element says which ones (data-in-hand; plugins/symbols.ts marks them). Nothing is looked at unless a pointer
/// is down.

type Shape = Readonly<Record<string, unknown>>;

/// The members of an object that a hand moves, and what they hold; what is made from a list has data in `points`.
const members: Readonly<Record<string, HeldKind>> = {
  points: 'point',
  net: 'point',
  knots: 'knot',
  parameter: 'parameter',
  patches: 'local',
  edits: 'local',
};

/// To write down longer lists at every press would keep the hand waiting.
const mostPoints = 1000;

/// A hand that has changed nothing in so many frames drags something else: a slider of the panel, say.
const mostLooks = 12;

export function heldKind(before: Shape, now: Shape): HeldKind | null {
  const differs = (name: string): boolean => JSON.stringify(before[name]) !== JSON.stringify(now[name]);
  const name = Object.keys(members).find(differs);
  if (!name) return null;
  const kind = members[name]!;
  return kind === 'point' && /^(fitted|subdivision)/.test(String(now['kind'])) ? 'datum' : kind;
}

/// `chapter`: the one whose figure is on the stage.
export function listenToHolds(canvas: HTMLCanvasElement, bridge: Bridge, chapter: () => HTMLElement | null): void {
  let before: Shape | null = null;  ///< what the press has found; null while nothing is looked for
  let camera = '';
  let lit: HTMLElement | null = null;
  let asked = 0;
  let looks = 0;
  const stage = (): [shape: Shape, camera: string] => {
    const { objects, camera: view } = bridge.document();
    return [(objects as Shape[])[0]!, JSON.stringify(view)];
  };
  const look = (): void => {
    asked = 0;
    if (!before) return;
    const [now, view] = stage();
    const kind = heldKind(before, now);
    lit = kind ? chapter() : null;
    if (kind && lit) lit.dataset['inHand'] = kind;
    if (kind || view !== camera || ++looks === mostLooks) before = null;  // who turns the view holds nothing
  };
  const letGo = (): void => {
    before = null;
    if (lit) delete lit.dataset['inHand'];
    lit = null;
  };
  canvas.addEventListener('pointerdown', (event) => {
    letGo();
    if (event.button !== 0 || !event.isPrimary || !chapter() || (bridge.state().points ?? 0) > mostPoints) return;
    [before, camera] = stage();
    looks = 0;
  });
  canvas.addEventListener('pointermove', () => {
    if (before && asked === 0) asked = requestAnimationFrame(look);
  });
  for (const end of ['pointerup', 'pointercancel', 'lostpointercapture']) canvas.addEventListener(end, letGo);
}
