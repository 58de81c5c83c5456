/// Marks, in the masthead, the section that is being read and those before it.
export function followSections(marks: readonly HTMLAnchorElement[]): void {
  const headings = marks.map((mark) => document.getElementById(mark.hash.slice(1)));
  let scheduled = false;
  const update = (): void => {
    scheduled = false;
    const line = readingLine();
    const atEnd = innerHeight + scrollY >= document.documentElement.scrollHeight - 2;
    let current = -1;
    headings.forEach((heading, i) => {
      if (heading && heading.getBoundingClientRect().top < line) current = i;
    });
    if (atEnd && scrollY > 0) current = marks.length - 1;
    marks.forEach((mark, i) => {
      mark.classList.toggle('read', i < current);
      if (i === current) mark.setAttribute('aria-current', 'location');
      else mark.removeAttribute('aria-current');
    });
  };
  const schedule = (): void => {
    if (scheduled) return;
    scheduled = true;
    requestAnimationFrame(update);
  };
  addEventListener('scroll', schedule, { passive: true });
  addEventListener('resize', schedule);
  update();
}

/// Two fifths down the part of the window that the prose has to itself.
function readingLine(): number {
  const stage = document.getElementById('stage')!.getBoundingClientRect();
  const top = stage.width >= innerWidth ? stage.bottom : 0;
  return top + 0.4 * (innerHeight - top);
}
