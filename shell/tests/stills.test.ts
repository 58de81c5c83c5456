import assert from 'node:assert/strict';
import { mkdirSync, mkdtempSync, readdirSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { test } from 'node:test';
import type { FigureSource } from '../plugins/chapter';
import { Stills, withStills } from '../plugins/stills';

const figure = (id: string, start = 'bezier-curve', values = ''): FigureSource => ({ id, start, values });

/// A folder with a program in the place of the real one, which answers with what it is asked, and with one scene.
function folder(): string {
  const root = mkdtempSync(join(tmpdir(), 'knotwork-stills-'));
  mkdirSync(join(root, 'scenes'));
  writeFileSync(join(root, 'scenes', 'ring.json'), '{}');
  writeFileSync(
    join(root, 'knotwork_stills.js'),
    `let calls = 0;
    module.exports = async () => ({
      ccall: (name, result, types, [start, scene, values, coarse]) =>
        start === 'nowhere' ? 'nowhere: There is no such start document.'
          : '<svg>' + [++calls, start, scene, values, coarse].join(' ') + '</svg>',
    });`,
  );
  return root;
}

test('a still picture is drawn from a start document or a scene, and again only when they change', async () => {
  const root = folder();
  const stills = await Stills.make(root, join(root, 'scenes'));
  assert.equal(stills.picture(figure('one')), '<svg>1 bezier-curve   false</svg>');
  assert.equal(stills.picture(figure('other')), '<svg>1 bezier-curve   false</svg>');
  assert.equal(stills.picture(figure('one', 'bezier-curve', 'curve.degree=2')), '<svg>2 bezier-curve  curve.degree=2 false</svg>');
  assert.equal(stills.picture(figure('ring', 'file')), '<svg>3 file {}  false</svg>');
  writeFileSync(join(root, 'scenes', 'ring.json'), '{ }');
  assert.equal(stills.picture(figure('ring', 'file')), '<svg>4 file { }  false</svg>');
  rmSync(root, { recursive: true });
});

test('they lie in a folder with nothing else, the first one in a coarse copy, too', async () => {
  const root = folder();
  const out = join(root, 'out');
  mkdirSync(out);
  writeFileSync(join(out, 'stale.svg'), '');
  (await Stills.make(root, join(root, 'scenes'))).write(out, [figure('one'), figure('two')]);
  assert.deepEqual(readdirSync(out).sort(), ['hero.svg', 'one.svg', 'two.svg']);
  assert.match(readFileSync(join(out, 'hero.svg'), 'utf8'), /true<\/svg>$/);
  rmSync(root, { recursive: true });
});

test('a figure without a picture, and a build without the program, are refused by name', async () => {
  const root = folder();
  const stills = await Stills.make(root, join(root, 'scenes'));
  assert.throws(() => stills.picture(figure('one', 'nowhere')), /"one" has no still picture: nowhere: There is no such/);
  assert.throws(() => stills.picture(figure('none', 'file')), /none\.json/);
  await assert.rejects(Stills.make(join(root, 'scenes'), root), /knotwork_stills\.js is missing/);
  rmSync(root, { recursive: true });
});

test('a picture stands before its caption, and its words are the first sentence without formulas', () => {
  const html =
    '<div id="caption-one"><p>A <em>"thin"</em>\ncurve of degree <!--tex--><span>n</span><!--/tex--> here. More.</p></div>' +
    '<div id="caption-two">No end</div>';
  const page = withStills(html, [figure('one'), figure('two')]);
  assert.match(page, /^<img [^>]*src="\.\/generated\/stills\/one\.svg"[^>]* alt="A &quot;thin&quot; curve of degree … here\."><div id="caption-one">/);
  assert.match(page, /alt="No end"><div id="caption-two">/);
  assert.throws(() => withStills(html, [figure('three')]), /"three" has no caption/);
});
