import { dirname, resolve } from 'node:path';
import { fileURLToPath } from 'node:url';
import { defineConfig } from 'vite';
import { head, page } from './plugins/page';
import { policy } from './scripts/policy.mjs';

const root = dirname(fileURLToPath(import.meta.url));
const moduleDirectory = resolve(process.env['KNOTWORK_MODULE_DIR'] ?? resolve(root, '../build/web/module'));

/// The page links to its source where the build knows an address: given by hand, or by GitHub's workflow runner.
function sourceUrl(): string {
  const { KNOTWORK_SOURCE_URL: given, GITHUB_SERVER_URL: host, GITHUB_REPOSITORY: repository } = process.env;
  return given ?? (host && repository ? `${host}/${repository}` : '');
}

/// Social cards need addresses with a host; where none is given they stay relative.
const siteAddress = process.env['KNOTWORK_SITE_ADDRESS'] ?? '';
const language = process.env['KNOTWORK_LANGUAGE'] ?? 'en';
const options = { root, moduleDirectory, policy, sourceUrl: sourceUrl(), siteAddress, language };

export default defineConfig({
  root,
  base: './',  // the built folder works under any path
  publicDir: resolve(root, '../public'),
  plugins: [page(options), head(options)],
  resolve: { alias: { '@module': moduleDirectory } },
  server: { fs: { allow: [root, moduleDirectory] } },
  build: {
    outDir: resolve(root, 'dist'),
    emptyOutDir: true,
    target: 'es2022',
    assetsInlineLimit: 0,  // the policy allows no data: fonts or scripts
    modulePreload: { polyfill: false },
    manifest: 'manifest.json',
    reportCompressedSize: false,
  },
});
