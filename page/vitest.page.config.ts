import { defineConfig } from 'vitest/config';

// Tests of the built page in a browser.
export default defineConfig({
  test: { include: ['test/page/*.test.ts'], environment: 'node', testTimeout: 120_000, hookTimeout: 120_000 },
});
