import { defineConfig } from 'vitest/config';

// Screenshots to be looked at, in the folder SHOTS.
export default defineConfig({
  test: { include: ['test/shots/*.test.ts'], environment: 'node', testTimeout: 120_000, hookTimeout: 120_000 },
});
