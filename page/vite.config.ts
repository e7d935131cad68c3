import { defineConfig } from 'vite';
import { viteSingleFile } from 'vite-plugin-singlefile';

// Writes built/run.html and, in the mode `serve`, built/serve.html: one file each, with script and style inside.
export default defineConfig(({ mode }) => ({
  plugins: [viteSingleFile({ removeViteModuleLoader: true })],
  build: {
    outDir: 'built',
    emptyOutDir: false,
    target: 'es2022',
    modulePreload: false,
    rollupOptions: { input: mode === 'serve' ? 'serve.html' : 'run.html' },
  },
}));
