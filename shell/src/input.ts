import { Device, PointerKind, type Bridge } from './bridge';

/// Pointer, wheel and key events of the canvas, handed to the module. What they mean is decided there.
export function listen(canvas: HTMLCanvasElement, bridge: Bridge): void {
  const position = (event: MouseEvent): [x: number, y: number] => {
    const rect = canvas.getBoundingClientRect();
    return [event.clientX - rect.left, event.clientY - rect.top];
  };

  const pointer = (kind: PointerKind) => (event: PointerEvent) => {
    const [x, y] = position(event);
    const device = deviceOf(event.pointerType);
    const used = bridge.pointer(
      kind, event.pointerId, device, x, y, event.button, modifiersOf(event), event.timeStamp,
    );
    if (used && event.cancelable) event.preventDefault();
    const cursor = bridge.cursor();
    if (canvas.style.cursor !== cursor) canvas.style.cursor = cursor;
  };

  canvas.addEventListener('pointerdown', (event) => {
    // The ring is for those who came by key; focus() from a script would show it to everybody.
    canvas.dataset['held'] = '';
    canvas.focus({ preventScroll: true });
    canvas.setPointerCapture(event.pointerId);
    pointer(PointerKind.down)(event);
  });
  canvas.addEventListener('pointermove', pointer(PointerKind.move));
  canvas.addEventListener('pointerup', pointer(PointerKind.up));
  canvas.addEventListener('pointercancel', pointer(PointerKind.cancel));
  canvas.addEventListener('pointerleave', pointer(PointerKind.leave));
  canvas.addEventListener('contextmenu', (event) => event.preventDefault());

  // A plain wheel scrolls the page, or a panel that is longer than its place. With Ctrl or Meta, as a pinch on a trackpad
  // sends it, it zooms.
  canvas.addEventListener(
    'wheel',
    (event) => {
      const zooms = event.ctrlKey || event.metaKey;
      if (zooms) event.preventDefault();
      const unit = wheelUnit(event.deltaMode, canvas.clientHeight);
      const [x, y] = position(event);
      const used = bridge.wheel(event.deltaX * unit, event.deltaY * unit, x, y, modifiersOf(event));
      if (used && !zooms) event.preventDefault();
    },
    { passive: false },
  );
  listenToGestures(canvas, bridge);

  canvas.addEventListener('keydown', (event) => {
    if (event.isComposing) return;
    if (event.repeat && event.key === ' ') {
      event.preventDefault();  // a switch is pressed once, however long
      return;
    }
    delete canvas.dataset['held'];
    const used = bridge.key(true, event.key, modifiersOf(event));
    if (used && event.key !== 'Tab') event.preventDefault();
  });
  canvas.addEventListener('keyup', (event) => {
    bridge.key(false, event.key, modifiersOf(event));
  });
  for (const focused of [true, false]) {
    canvas.addEventListener(focused ? 'focus' : 'blur', () => bridge.focus(focused));
  }
}

/// Safari's pinch on a trackpad comes as gesture events, not as a wheel with Ctrl.
function listenToGestures(canvas: HTMLCanvasElement, bridge: Bridge): void {
  let scale = 1;
  canvas.addEventListener('gesturestart', (event) => {
    event.preventDefault();
    scale = 1;
  });
  canvas.addEventListener('gesturechange', (event) => {
    event.preventDefault();
    const gesture = event as Event & { scale: number; clientX: number; clientY: number };
    const rect = canvas.getBoundingClientRect();
    const delta = -100 * Math.log(gesture.scale / scale);
    scale = gesture.scale;
    bridge.wheel(0, delta, gesture.clientX - rect.left, gesture.clientY - rect.top, modifier.ctrl);
  });
}

const modifier = { shift: 1, ctrl: 2, alt: 4, meta: 8 };

export function modifiersOf(event: { shiftKey: boolean; ctrlKey: boolean; altKey: boolean; metaKey: boolean }): number {
  return (
    (event.shiftKey ? modifier.shift : 0) |
    (event.ctrlKey ? modifier.ctrl : 0) |
    (event.altKey ? modifier.alt : 0) |
    (event.metaKey ? modifier.meta : 0)
  );
}

/// CSS pixels in one unit of a wheel event's delta: pixels, lines or pages.
export function wheelUnit(deltaMode: number, pageHeight: number): number {
  return deltaMode === 1 ? 16 : deltaMode === 2 ? pageHeight : 1;
}

function deviceOf(pointerType: string): Device {
  return pointerType === 'touch' ? Device.touch : pointerType === 'pen' ? Device.pen : Device.mouse;
}
