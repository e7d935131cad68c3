// Contract between the program, which writes the page's data, and the page, which reads them: version 1.

export const FORMAT = 'keyblock-page';
export const VERSION = 1;

/** Row of a body that is missing, as contacts with nothing on one side have it. */
export const NO_ROW = 0xffffffff;

/** Low byte of a body's kind if it is an element of an NMM body; that of a block is 0. */
export const ELEMENT_KIND = 1;
/** Bit of a body's kind that marks it as fixed. */
export const FIXED_BIT = 256;

export interface FrameHead {
  step: number;
  time: number;
  load_factor?: number | null;
  epoch: number;
  stage?: string;
  is_static?: boolean;
}

export interface EpochHead {
  bodies: number;
  loops: number;
  vertices: number;
  geometry: string;
}

export interface FieldHead {
  name: string;
  label: string;
  unit: string;
  on: 'body' | 'vertex';
  parts: number;
  components?: string[];
  bits: number;
  kind?: 'real' | 'state';
  names?: string[];
}

export interface ChunkHead {
  id: string;
  what: string;
  from: number;
  to: number;
  epoch: number;
  frames?: number[];
}

export interface ColumnHead {
  name: string;
  unit?: string;
  parts?: number;
  type?: 'f32' | 'u32';
  names?: string[];
}

export interface PartHead {
  columns: ColumnHead[];
  title?: string;
}

export interface CurveColumn {
  name: string;
  unit?: string;
  values: (number | null)[];
}

export interface CurveTable {
  name: string;
  title: string;
  columns: CurveColumn[];
}

export interface StillThing {
  kind: string;
  /** Place in the drawing, from the origin. */
  at: [number, number];
  /** Number of the body that it moves with. */
  block?: number;
  force?: [number, number];
  [more: string]: unknown;
}

export interface Units {
  length?: string;
  mass?: string;
  time?: string;
  force?: string;
  stress?: string;
}

// biome-ignore lint/suspicious/noExplicitAny: run.json is shown as the run left it.
export type RunRecord = Record<string, any>;

/** Verdict on a run, in words of the program. */
export interface Verdict {
  tone: 'good' | 'warn' | 'bad' | 'plain';
  words: string;
  /** Why the run failed, was stopped or is unreliable; may be empty. */
  reason: string;
}

export interface Head {
  format: string;
  version: number;
  program: string;
  title: string;
  verdict: Verdict;
  /** Content of run.json; nothing for a run that was stopped before it was written. */
  run: RunRecord | null;
  origin: [number, number];
  precision: string;
  units: Units | null;
  /** Units by the letters of a dimension. */
  unit_by_letters: Record<string, string>;
  /** Titles of extremes of the record by their names. */
  titles: Record<string, string>;
  frames: FrameHead[];
  epochs: EpochHead[];
  fields: FieldHead[];
  parts?: Record<string, PartHead>;
  chunks: ChunkHead[];
  materials: string[];
  joints: string[];
  tables: CurveTable[];
  still?: StillThing[];
}

/** Addition to the head of a page while its run goes on: frames count from 0, new epochs too; -1 is the last epoch of the page. */
export interface Update {
  frames: FrameHead[];
  epochs: EpochHead[];
  fields: FieldHead[];
  parts: Record<string, PartHead>;
  chunks: ChunkHead[];
  /** Chunks, not packed, by their ids. */
  bytes: Record<string, Uint8Array>;
}

/** Thrown for data that the page cannot show; its message is for the reader. */
export class PageError extends Error {}

/** Checks format and version, and fills what may be missing. */
export function accept_head(value: unknown): Head {
  const head = value as Head;
  if (!head || head.format !== FORMAT) throw new PageError('This page holds no results of Keyblock.');
  if (head.version !== VERSION) {
    throw new PageError(
      `This page holds data of version ${head.version}, and it can show version ${VERSION} only: ` +
        'write it again with one version of Keyblock.',
    );
  }
  if (!head.frames?.length || !head.epochs?.length) throw new PageError('This run has no frames to show.');
  return {
    ...head,
    run: head.run ?? null,
    verdict: head.verdict ?? { tone: 'plain', words: '', reason: '' },
    origin: head.origin ?? [0, 0],
    precision: head.precision ?? '',
    units: head.units ?? null,
    unit_by_letters: head.unit_by_letters ?? {},
    titles: head.titles ?? {},
    fields: head.fields ?? [],
    parts: head.parts ?? {},
    chunks: head.chunks ?? [],
    materials: head.materials ?? [],
    joints: head.joints ?? [],
    tables: head.tables ?? [],
    still: head.still ?? [],
  };
}
