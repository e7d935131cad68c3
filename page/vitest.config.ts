import { defineConfig } from 'vitest/config';

// Tests of data and drawing, without a browser.
export default defineConfig({
  test: { include: ['test/data/*.test.ts', 'test/draw/*.test.ts', 'test/edit/*.test.ts'], environment: 'node' },
});
