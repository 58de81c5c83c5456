// Runs before the first picture of the page, while its text still arrives. Where a browser does not wait for it and has
// shown text already, that stays.
{
  const root = document.documentElement;
  const shown = performance.getEntriesByType('paint').length > 0;
  const stage = document.getElementById('stage');
  // Figures are alive, unless the page has already said that they cannot be: their still pictures are not shown.
  if (!stage || stage.dataset.state === 'loading') root.classList.add('scripted');

  // The text stays out of sight until its typefaces are here: read in another face first, it would move under the
  // reader's eyes. Not later than 0.9 s after the visit has begun, and not for those of formulas, which come further
  // down. Which faces there are is known with the styles. A face that fails to come is done without.
  if (!shown) root.classList.add('arriving');
  const sheets = [...document.querySelectorAll('link[rel=stylesheet]')].filter((link) => !link.sheet);
  const styles = sheets.map(
    (link) => new Promise((resolve) => ['load', 'error'].forEach((end) => link.addEventListener(end, resolve))),
  );
  const upright = ({ family, style }) => style === 'normal' && !family.includes('KaTeX');
  const load = () => Promise.all([...document.fonts].filter(upright).map((face) => face.load()));
  const faces = Promise.all(styles).then(load);
  const patience = new Promise((resolve) => setTimeout(resolve, Math.max(0, 900 - performance.now())));
  Promise.race([faces, patience])
    .catch(() => {})
    .then(() => root.classList.remove('arriving'));

  // The chapters after the first are laid out, and their typefaces fetched, behind the figure's first picture
  // (src/main.ts), or it would wait for them. Who comes by a link into the page, or back to a place in it, gets it
  // whole; should the figure not come, everybody does after 3 s.
  const [entry] = performance.getEntriesByType('navigation');
  if (!shown && !location.hash && entry?.type === 'navigate') {
    root.classList.add('early');
    setTimeout(() => root.classList.remove('early'), 3000);
  }
}
