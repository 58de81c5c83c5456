/// Marks, in the masthead, the section that is being read and those before it; of its chapter alone.
export function followSections(lists: readonly HTMLElement[], contents: HTMLElement | null): void {
  const chapters = lists.map((list) => ({
    list,
    article: document.getElementById(list.dataset['marks']!)!,
    entry: contents?.querySelector(`a[href="#${list.dataset['marks']}"]`) ?? null,
    marks: [...list.querySelectorAll<HTMLAnchorElement>('a')].map((mark) => ({
      mark,
      heading: document.getElementById(mark.hash.slice(1))!,
    })),
  }));
  let scheduled = false;
  const update = (): void => {
    scheduled = false;
    const line = readingLine();
    const passed = (place: Element): boolean => place.getBoundingClientRect().top < line;
    const atEnd = innerHeight + scrollY >= document.documentElement.scrollHeight - 2 && scrollY > 0;
    const begun = chapters.filter(({ article }) => passed(article));
    const present = atEnd ? chapters.at(-1) : (begun.at(-1) ?? chapters[0]);
    for (const chapter of chapters) {
      chapter.list.hidden = chapter !== present;
      setCurrent(chapter.entry, chapter === present);
      if (chapter !== present) continue;
      const last = atEnd ? chapter.marks.length - 1 : chapter.marks.filter(({ heading }) => passed(heading)).length - 1;
      chapter.marks.forEach(({ mark }, i) => {
        mark.classList.toggle('read', i < last);
        setCurrent(mark, i === last);
      });
    }
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

/// The list of chapters closes when one has been chosen, by Escape and by a click beside it.
export function makeContents(contents: HTMLDetailsElement): void {
  const close = (): void => contents.removeAttribute('open');
  contents.addEventListener('click', (event) => {
    if (event.target instanceof HTMLAnchorElement) close();
  });
  contents.addEventListener('keydown', (event) => {
    if (event.key !== 'Escape' || !contents.open) return;
    close();
    contents.querySelector('summary')?.focus();
  });
  document.addEventListener('pointerdown', (event) => {
    if (!contents.contains(event.target as Node)) close();
  });
}

function setCurrent(link: Element | null, current: boolean): void {
  if (current) link?.setAttribute('aria-current', 'location');
  else link?.removeAttribute('aria-current');
}

/// Two fifths down the part of the window that the prose has to itself.
export function readingLine(): number {
  const stage = document.getElementById('stage')!.getBoundingClientRect();
  const top = stage.width >= innerWidth ? stage.bottom : 0;
  return top + 0.4 * (innerHeight - top);
}
