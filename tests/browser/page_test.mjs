import assert from 'node:assert/strict';
import { after, test } from 'node:test';
import { closeShared, openPage } from './site.mjs';

after(closeShared);

/// A test on a page of its own. It fails when the browser has complained about anything.
export function pageTest(name, options, body) {
  test(name, { timeout: 120_000 }, async () => {
    const opened = await openPage(options);
    try {
      await body(opened.page, opened);
      assert.deepEqual(opened.complaints(), [], 'the browser complained');
    } finally {
      await opened.close();
    }
  });
}
