// Requests of `keyblock serve`, as SERVER.md lists them.

import type { Update } from '../data/contract';
import type { TestRecord } from './tested';

export interface FileEntry {
  path: string;
  bytes: number;
  time: number;
}

export interface ResultEntry {
  path: string;
  time: number;
  is_finished: boolean;
  /** The record of the run is damaged. */
  is_broken?: boolean;
  has_checkpoint: boolean;
  kind?: 'run' | 'fos' | 'sweep';
}

export interface Listing {
  folder: string;
  files: FileEntry[];
  results: ResultEntry[];
  /** Number of files and folders left out because their names are not UTF-8. */
  unreadable?: number;
}

export interface Problem {
  name?: string;
  file?: string;
  line?: number;
  column?: number;
  sentence: string;
  level?: 'error' | 'warning' | 'note' | 'silent';
  remedy?: string;
}

export interface Report {
  files: { file: string; format?: string; warnings?: Problem[]; error?: string; counts?: Record<string, number> }[];
  case?: {
    warnings: Problem[];
    profile?: string;
    profile_because?: string;
    size?: string;
    smallest_block?: string;
    requires?: { unknowns: number; basis: string; terms: { term: string; reason: string }[] };
    /** Part that a run needs and the files do not have. */
    lacks?: 'analysis' | 'geometry';
    settings?: Record<string, unknown>;
    /** Units by the letters of a dimension. */
    unit_by_letters?: Record<string, string>;
    cost?: { seconds_in_all?: number; step_seconds?: number; failure?: string } | null;
  };
  exit_code: number;
  errors: Problem[];
}

export interface Job {
  id: number;
  kind: 'run' | 'resume' | 'fos' | 'both' | 'sweep';
  title: string;
  result: string;
  state: 'waits' | 'runs' | 'ended' | 'stopped';
  is_stopping: boolean;
  step?: number;
  steps?: number;
  left?: string;
  /** Greatest factor found stable so far, least one found unstable. */
  stands?: number;
  falls?: number;
  seconds?: number;
  exit_code?: number;
  messages?: string;
}

/** News of a run: frames that the page lacks, a change of the run, or neither after some seconds. */
export interface News extends Partial<Update> {
  is_running: boolean;
  /** Changes with the file of the newest frame. */
  stamp?: string;
  /** The frames of the page are no longer those of the run. */
  is_anew?: boolean;
}

export interface Difference {
  path: string;
  first?: unknown;
  second?: unknown;
  relative?: number;
  /** Units of both values, if they are numbers of a record with declared units. */
  units?: [string, string];
  /** Title of an entry of a record that has one. */
  title?: string;
}

export class RequestError extends Error {
  constructor(
    readonly status: number,
    message: string,
  ) {
    super(message);
  }
}

async function answer<T>(reply: Response): Promise<T> {
  const text = await reply.text();
  let value: unknown;
  try {
    value = JSON.parse(text);
  } catch {
    value = null;
  }
  if (!reply.ok) {
    const sentence = (value as { error?: string } | null)?.error;
    throw new RequestError(reply.status, sentence ?? `The server refused the request (${reply.status}).`);
  }
  return value as T;
}

/** Address with its parameters. */
export function address(path: string, parameters: Record<string, string>): string {
  return `${path}?${new URLSearchParams(parameters)}`;
}

async function reply_to(path: string, parameters: Record<string, string>, end?: AbortSignal): Promise<Response> {
  try {
    return await fetch(Object.keys(parameters).length ? address(path, parameters) : path, { signal: end });
  } catch {
    throw new RequestError(0, 'The server does not answer: start keyblock serve again.');
  }
}

const get = async <T>(path: string, parameters: Record<string, string> = {}) =>
  answer<T>(await reply_to(path, parameters));

async function post<T>(path: string, body: unknown): Promise<T> {
  let reply: Response;
  try {
    reply = await fetch(path, {
      method: 'POST',
      headers: { 'Content-Type': 'application/json' },
      body: JSON.stringify(body),
    });
  } catch {
    throw new RequestError(0, 'The server does not answer: start keyblock serve again.');
  }
  return answer<T>(reply);
}

/** News of a run: a line of JSON, and the bytes of its chunks after it. */
export async function live(result: string, shown: Record<string, string>, end: AbortSignal): Promise<News> {
  const reply = await reply_to('/api/live', { result, ...shown }, end);
  if (!reply.headers.get('Content-Type')?.startsWith('application/octet')) return answer<News>(reply);
  const bytes = new Uint8Array(await reply.arrayBuffer());
  let at = bytes.indexOf(10) + 1;
  const { sizes, ...news } = JSON.parse(new TextDecoder().decode(bytes.subarray(0, at)));
  news.bytes = {};
  for (const [id, size] of Object.entries(sizes as Record<string, number>)) {
    news.bytes[id] = bytes.subarray(at, at + size);
    at += size;
  }
  return news;
}

/** The page of a result (HTML). */
export async function page(result: string): Promise<string> {
  const reply = await fetch(address('/page', { result }));
  return reply.ok ? reply.text() : answer<string>(reply);
}
export const list = () => get<Listing>('/api/list');
export const read = (path: string) =>
  get<{ path: string; is_text: boolean; sha256: string; text?: string }>('/api/read', { path });
export const jobs = () => get<{ jobs: Job[] }>('/api/jobs').then(reply => reply.jobs);
export const record = (result: string) => get<Record<string, unknown>>('/api/record', { result });
export const compare = (first: string, second: string) =>
  get<{ inputs?: Difference[]; differences: Difference[] }>('/api/compare', { first, second });
export const check = (paths: string[], profile: string, set: Record<string, string>, trial = false, text?: string) =>
  post<Report>('/api/check', {
    ...(text === undefined ? { paths } : { path: paths[0], text }),
    ...(profile && { profile }),
    ...(Object.keys(set).length && { set }),
    ...(trial && { trial }),
  });
export interface Blocks {
  blocks?: { material: number; loops: [number, number][][] }[];
  errors?: Problem[];
}

export interface JointRows {
  boundary_count?: number;
  joints?: [number, number, number, number, number][];
  errors?: Problem[];
}

export interface Library {
  block_materials: Record<string, string | number>[];
  joint_materials: Record<string, string | number>[];
}

/** Blocks of a text that need not be saved. */
export const blocks = (path: string, text: string) => post<Blocks>('/api/blocks', { path, text });
/** Outline and joints of sets. */
export const joints = (spec: unknown) => post<JointRows>('/api/joints', { spec });
export const materials = () => get<Library>('/api/materials');
export const schema = () => get<Record<string, unknown>>('/api/schema');
/** Schema of the specification that `joints` takes. */
export const joint_schema = () => get<Record<string, unknown>>('/api/joint_schema');
export interface Converted {
  /** Files that were written. */
  files: string[];
  /** Sentences about files not written and values lost. */
  changes: string[];
  exit_code: number;
  messages: string;
}

export const convert = (paths: string[], target: string, to: string) =>
  post<Converted>('/api/convert', { paths, target, to });
/** Saves a new file, or replaces the one with this checksum. */
export const save = (path: string, text: string, sha256?: string) =>
  post<{ path: string; sha256: string }>('/api/save', { path, text, ...(sha256 && { sha256 }) });
export const run = (
  kind: 'run' | 'fos',
  paths: string[],
  result: string,
  profile: string,
  set: Record<string, string>,
  more: Record<string, unknown> = {},
) =>
  post<{ id: number }>(`/api/${kind}`, {
    paths,
    result,
    ...(profile && { profile }),
    ...(Object.keys(set).length && { set }),
    ...more,
  });
/** Answer of an element test or a fit. */
export interface Tested {
  exit_code: number;
  record: TestRecord | null;
  svg: string;
  table: string;
  errors: Problem[];
  messages: string;
}

export const sweep = (paths: string[], result: string, body: Record<string, unknown>) =>
  post<{ id: number }>('/api/sweep', { paths, result, ...body });
export const element = (body: Record<string, unknown>) => post<Tested>('/api/element', body);
export const fit = (body: Record<string, unknown>) => post<Tested>('/api/fit', body);
export const resume = (result: string) => post<{ id: number }>('/api/resume', { result });
export const stop = (id: number) => post<{ jobs: Job[] }>('/api/stop', { id });
