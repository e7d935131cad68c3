import { defineConfig } from 'vite';
import { viteSingleFile } from 'vite-plugin-singlefile';

// Writes built/run.html: one file with its script and its style inside, which opens from disk.
export default defineConfig({
  plugins: [viteSingleFile({ removeViteModuleLoader: true })],
  build: {
    outDir: 'built',
    emptyOutDir: false,
    target: 'es2022',
    modulePreload: false,
    rollupOptions: { input: 'run.html' },
  },
});
