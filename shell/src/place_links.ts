import type { Said } from './said';

/// A sign beside a heading leads there, as links do, and puts the address on the clipboard. With a key held that opens
/// it elsewhere, it is a link and no more.
export function listenToPlaces(root: HTMLElement, said: Said): void {
  root.addEventListener('click', (event) => {
    const link = event.target instanceof Element ? event.target.closest<HTMLAnchorElement>('a.place') : null;
    if (!link || event.ctrlKey || event.metaKey || event.shiftKey || event.altKey) return;
    void said.copy(link.href);
  });
}
