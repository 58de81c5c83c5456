// Cut into the chapter "In code"; chapters.test.mjs runs it in the page.

export async function pullPatch(knotwork) {
  // [pull]
  await knotwork.ready;
  knotwork.open('blending-surface');
  knotwork.set('locals.u', 8);

  const drawn = knotwork.document();
  const still = { rotation: [0, 0, 0, 1], scale: [1, 1, 1] };
  drawn.objects[0].patches = [{ i: 3, j: 0, translation: [0, 0, 0.4], ...still }];
  knotwork.load(drawn);

  const at = knotwork.evaluate('surface', [1, 0.5], 1);  // { S, Su, Sv }
  // [/pull]
  return at;
}
