import { createHash } from 'node:crypto';
import { readFileSync } from 'node:fs';
import { defineConfig, type Plugin } from 'vite';

/** Writes the service worker with the names of all files of the page. */
function offline(): Plugin {
  return {
    name: 'offline',
    apply: 'build',
    generateBundle(_options, bundle) {
      const files = [
        './',
        'icon.svg',
        ...Object.keys(bundle).filter((name) => name !== 'index.html'),
      ];
      const hash = createHash('sha256');
      for (const chunk of Object.values(bundle)) {
        hash.update(chunk.type === 'chunk' ? chunk.code : chunk.source);
      }
      const version = hash.digest('hex').slice(0, 12);
      const source = readFileSync(new URL('src/service_worker.js', import.meta.url), 'utf8')
        .replace('FILES', JSON.stringify(files.sort()))
        .replace('VERSION', JSON.stringify(version));
      this.emitFile({ type: 'asset', fileName: 'service_worker.js', source });
    },
  };
}

export default defineConfig({
  base: './',
  // The site takes all of dist.
  build: { outDir: 'dist/explore', emptyOutDir: true, target: 'es2022', assetsInlineLimit: 0, chunkSizeWarningLimit: 200 },
  worker: { format: 'es' },
  server: { host: '127.0.0.1', fs: { allow: ['..'] } },
  plugins: [offline()],
});
