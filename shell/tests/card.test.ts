import assert from 'node:assert/strict';
import { existsSync, readFileSync } from 'node:fs';
import { test } from 'node:test';
import { card } from '../plugins/card';

test('the social card has whole addresses where the build knows the site\'s, and a relative picture elsewhere', () => {
  assert.equal(card(''), '<meta property="og:image" content="./social-card.png">');
  for (const site of ['https://host.example/splines/', 'https://host.example/splines'])
    assert.deepEqual(card(site).match(/"[^"]*"/g), [
      '"og:image"', '"https://host.example/splines/social-card.png"', '"og:url"', '"https://host.example/splines/"',
    ]);
  assert.match(card('https://host.example'), /"https:\/\/host\.example\/social-card\.png"/);
  assert.ok(existsSync('../public/social-card.png'));
  assert.match(readFileSync('index.html', 'utf8'), /<!--card-->/);
});

test('what is no address of a site stops the build, and no address breaks out of its attribute', () => {
  const wrong = ['host.example', 'ftp://host.example/', 'javascript:alert(1)', 'https://', 'https://host.example/?a'];
  for (const site of wrong) assert.throws(() => card(site), /KNOTWORK_SITE_ADDRESS/, site);
  assert.equal(card('https://host.example/"><script>/').match(/[<>]/g)!.length, 4);
});
