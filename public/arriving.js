// Keeps the text out of sight until its typefaces are here, a second at most: read in another face first, it would move
// under the reader's eyes.
{
  const root = document.documentElement;
  const faces = Promise.all([...document.fonts].map((face) => face.load()));
  const patience = new Promise((resolve) => setTimeout(resolve, 1000));
  root.classList.add('arriving');
  Promise.race([faces, patience])
    .catch(() => {})
    .then(() => root.classList.remove('arriving'));
}
