import assert from 'node:assert/strict';
import { mkdirSync, mkdtempSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { test } from 'node:test';
import { Language } from '../plugins/language';
import { pseudo } from '../src/pseudo';
import { filled, translation } from '../src/translation';
import { say } from '../src/words';

/// A shell's folder with a chapter in English and one that German has, too.
function folder(words: string): string {
  const root = mkdtempSync(join(tmpdir(), 'knotwork-language-'));
  mkdirSync(join(root, 'chapters'));
  mkdirSync(join(root, 'languages', 'de'), { recursive: true });
  writeFileSync(join(root, 'chapters', '00-one.md'), 'one');
  writeFileSync(join(root, 'chapters', '01-two.md'), 'two');
  writeFileSync(join(root, 'languages', 'de', '00-one.md'), 'eins');
  writeFileSync(join(root, 'languages', 'de', 'words.json'), words);
  return root;
}

test('a language has its own chapters, and the others in English', () => {
  const root = folder('{ "Hint": "Hinweis", "Try it": "Zum Probieren", "Undo": "\\"Zurück\\"" }');
  const german = new Language(root, 'de');
  assert.equal(german.tag, 'de');
  assert.deepEqual(german.chapter('00-one.md'), { source: 'eins', own: true });
  assert.deepEqual(german.chapter('01-two.md'), { source: 'two', own: false });
  assert.equal(
    german.html('<!--foreign--><p>Undo</p><!--/foreign--><p>Undo</p>'),
    '<!--foreign--><p>Undo</p><!--/foreign--><p>"Zurück"</p>',
  );
  assert.equal(german.html('<p title="Undo">Undo</p>'), '<p title="&quot;Zurück&quot;">"Zurück"</p>');
  assert.deepEqual(new Language(root, 'en').chapter('00-one.md'), { source: 'one', own: true });
  assert.equal(german.html('<aside aria-label="Try it">\n  Hint\n <code>Hint</code></aside>'),
    '<aside aria-label="Zum Probieren">\n  Hinweis\n <code>Hint</code></aside>');
  rmSync(root, { recursive: true });
});

test('a language without words, with a wrong file or a wrong name is refused by name', () => {
  const root = folder('["Hint"]');
  assert.throws(() => new Language(root, 'fr'), /KNOTWORK_LANGUAGE is fr: there is no languages\/fr\/words\.json/);
  assert.throws(() => new Language(root, '../de'), /not a language tag/);
  writeFileSync(join(root, 'languages', 'de', 'words.json'), '{ "Hint": 1 }');
  assert.throws(() => new Language(root, 'de'), /languages\/de\/words\.json/);
  rmSync(root, { recursive: true });
});

test('the disguise touches neither mathematics nor code nor what scripts read', () => {
  const language = new Language('.', 'pseudo');
  const kept = ['<!--tex--><span>abc</span><!--/tex-->', '<pre>abc</pre>', '<svg viewBox="0 0 1 1"><path d="M1"/></svg>'];
  for (const html of kept) assert.equal(language.html(html), html);
  const tag = '<div data-goal="curve.length > 5.5 and points.moved = 2" id="figure-one">';
  assert.equal(language.html(tag), tag);
  assert.equal(language.html('<p title="Undo">one &amp; two</p>'), '<p title="Úñdó ··">óñé · &amp; twó ·</p>');
});

test('the disguise is longer by two fifths; single letters and numbers have none', () => {
  assert.equal(pseudo('locals u'), 'lóçáls ú ···');
  assert.equal(pseudo(' u '), ' u ');
  assert.equal(pseudo('0.5'), '0.5');
  assert.equal(pseudo('{} is here'), '{} ís héré ····');
});

test('what scripts say in English is what stands in the source, with its values', () => {
  assert.equal(say('{} of {} exercises solved', 1, 3), '1 of 3 exercises solved');
  assert.equal(say('Undo'), 'Undo');
  for (const name of ['Patch 2, 1', 'Local curve 12', 'Parameter']) assert.equal(say(name), name);
});

test('a sentence with its values is found by its form, and values have words of their own', () => {
  const say = translation({
    'Patch': 'Flicken', 'Undone: {}': 'Rückgängig: {}', '{} moved': '{} bewegt', 'open': 'offen', 'closed': 'geschlossen',
    'from {} to {}': 'bis {2} von {1}', 'Two of {} (all?)': 'Zwei von {} (alle?)', '{} × {}': '{} mal {}',
    '{} points, {} control points': '{} Punkte, {} Kontrollpunkte', '{} points': '{} Punkte', 'locals in {}': '{}: $& Lokale',
  });
  assert.equal(say('{} moved'), '{} bewegt');
  assert.equal(say('Patch 2, 1 moved'), 'Flicken 2, 1 bewegt');
  assert.equal(say('Undone: Patch 2, 1 moved'), 'Rückgängig: Flicken 2, 1 bewegt');
  assert.equal(say('from open to closed'), 'bis geschlossen von offen');
  assert.equal(say('Two of 7 (all?)'), 'Zwei von 7 (alle?)');
  assert.equal(say('12 points, 5 control points'), '12 Punkte, 5 Kontrollpunkte');
  assert.equal(say('locals in u'), 'u: $& Lokale');
  for (const unknown of ['Knot 3', '2 × 3', 'It moved on', ' moved', 'toString', '', '0.5'])
    assert.equal(say(unknown), unknown);
});

test('translated sentences are kept up to a limit, and stay right beyond it', () => {
  const say = translation({ 'Line {}': 'Zeile {}' });
  for (let k = 0; k < 1200; ++k) assert.equal(say(`Line ${k}`), `Zeile ${k}`);
  assert.equal(say('Line 3'), 'Zeile 3');
});

test('values go where the language wants them, and what is missing stays open', () => {
  assert.equal(filled('{} von {}', [1, 2]), '1 von 2');
  assert.equal(filled('{2} von {1}', ['a', 'b']), 'b von a');
  assert.equal(filled('{} von {}', [1]), '1 von {}');
});
