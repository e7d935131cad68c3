// Follows the files of an open case on the disk. A change made elsewhere is taken; if the window has changes of its own,
// the user chooses.

import { useEffect, useRef, useState } from 'preact/hooks';
import * as api from './api';
import { leaf_of } from './cases';
import * as state from './state';

export interface Loaded {
  text: string;
  sha256: string;
  is_text: boolean;
}

/** Milliseconds between two looks at the disk. */
const PAUSE = 3000;

/** Letters beyond which a file is only looked at before it is saved. */
const LARGE = 1_000_000;

export interface Disk {
  /** Files that differ from those that were read, while the window has changes of its own. */
  differing: Record<string, Loaded>;
  /** Reads the files again. */
  look: () => Promise<void>;
  /** Ends a difference: takes the text of the disk, or keeps that of the window to save it over the other. */
  settle: (path: string, takes_text: boolean) => void;
}

/** `take` puts a file in place of the one that was read, with its text or without. */
export function useDisk(
  paths: string[],
  files: Record<string, Loaded>,
  texts: Record<string, string>,
  take: (path: string, loaded: Loaded, takes_text: boolean) => void,
): Disk {
  const [differing, set_differing] = useState<Record<string, Loaded>>({});
  const now = useRef({ paths, files, texts, take });
  now.current = { paths, files, texts, take };
  const without = (path: string) =>
    set_differing(before => Object.fromEntries(Object.entries(before).filter(([own]) => own !== path)));

  const look = async () => {
    for (const path of now.current.paths) {
      const own = await api.read(path).catch(() => null);
      const before = now.current.files[path];
      if (!own || !before || !now.current.paths.includes(path)) continue;
      const loaded = { text: own.text ?? '', sha256: own.sha256, is_text: own.is_text };
      const text = now.current.texts[path];
      if (loaded.sha256 === before.sha256) without(path);
      else if (text === before.text || text === loaded.text) {
        now.current.take(path, loaded, text !== loaded.text);
        without(path);
      } else set_differing(all => ({ ...all, [path]: loaded }));
    }
  };

  useEffect(() => {
    set_differing({});
    const is_large = () => Object.values(now.current.files).some(own => own.text.length > LARGE);
    const timer = setInterval(() => {
      if (!document.hidden && !is_large()) void look();
    }, PAUSE);
    return () => clearInterval(timer);
  }, [paths.join('\n')]);

  const settle = (path: string, takes_text: boolean) => {
    take(path, differing[path], takes_text);
    without(path);
    state.trouble.value = '';
  };
  return { differing, look, settle };
}

/** Names the files that differ, with the choice. */
export function DiskNote({ disk }: { disk: Disk }) {
  const paths = Object.keys(disk.differing);
  if (!paths.length) return null;
  return (
    <div class="conflicts">
      {paths.map(path => (
        <div class="conflict" role="alert" key={path}>
          <span>{leaf_of(path)} has changed on the disk since it was read.</span>
          <button type="button" class="small" onClick={() => disk.settle(path, true)}>
            Read it anew
          </button>
          <button type="button" class="small" onClick={() => disk.settle(path, false)}>
            Keep this text
          </button>
        </div>
      ))}
    </div>
  );
}
