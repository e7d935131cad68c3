// Groups the files of a folder into cases.

import type { FileEntry } from './api';

export interface Case {
  /** Name to show: the path of a lone file, or the shared path without endings. */
  name: string;
  paths: string[];
  time: number;
}

/** Endings of files that are no input of the program. */
const OTHER = /\.(csv|md|txt|py|svg|html?|log|png|pdf|pvd|vt[upkm]|gif|zip|gz|toml|sh)$/i;

/** Geometry files of old programs, which stand first, and their analysis files: by an ending, or by a beginning (cv15). */
const GEOMETRY = /\.(geo|blk|dc|dcg|dl|mc|ml|cv)$|(^|\/)(dc|cv)[^./]*$/i;
const ANALYSIS = /\.(ana|df|mf)$|(^|\/)(df|mf)[^./]*$/i;

/** Name that both files of an old case share: that without its ending, or without its beginning. */
function shared_name(path: string): string {
  const leaf = leaf_of(path);
  return `${folder_of(path)}/${leaf.includes('.') ? stem_of(leaf) : leaf.replace(/^(dc|cv|df|mf)/i, '')}`;
}

export function stem_of(path: string): string {
  return path.replace(/\.[^./]*$/, '');
}

export function folder_of(path: string): string {
  const slash = path.lastIndexOf('/');
  return slash < 0 ? '' : path.slice(0, slash);
}

export function leaf_of(path: string): string {
  return path.slice(path.lastIndexOf('/') + 1);
}

/** Name of a result; one of both profiles has that of their folder before it. */
export function name_of_result(path: string): string {
  const leaf = leaf_of(path);
  return /^(standard|legacy)$/.test(leaf) && folder_of(path) ? `${leaf_of(folder_of(path))}, ${leaf}` : leaf;
}

/** Cases in the order of their names. A geometry and an analysis file with one name are one case. */
export function cases_of(files: FileEntry[]): Case[] {
  // A search for a factor of safety leaves its record beside cases.
  const inputs = files.filter(file => !OTHER.test(file.path) && leaf_of(file.path) !== 'fos.json');
  const cases: Case[] = [];
  const taken = new Set<string>();
  for (const file of inputs) {
    if (!GEOMETRY.test(file.path)) continue;
    const partner = inputs.find(
      other =>
        ANALYSIS.test(other.path) && shared_name(other.path) === shared_name(file.path) && !taken.has(other.path),
    );
    if (!partner) continue;
    taken.add(file.path);
    taken.add(partner.path);
    cases.push({
      name: stem_of(file.path),
      paths: [file.path, partner.path],
      time: Math.max(file.time, partner.time),
    });
  }
  for (const file of inputs) {
    if (!taken.has(file.path)) cases.push({ name: file.path, paths: [file.path], time: file.time });
  }
  return cases.sort((a, b) => a.name.localeCompare(b.name, 'en', { numeric: true }));
}

/** Tables that may hold tests: all but the expected values of a verification case. */
export function tables_of(files: FileEntry[]): FileEntry[] {
  return files.filter(file => /\.csv$/i.test(file.path) && leaf_of(file.path) !== 'expected.csv');
}

/** A name for a new result that no result has yet. */
export function new_result(base: string, taken: string[]): string {
  const own = new Set(taken);
  if (!own.has(base)) return base;
  for (let i = 2; ; i++) if (!own.has(`${base}_${i}`)) return `${base}_${i}`;
}

/** Index in a text of a line and column, both from 1. */
export function index_at(text: string, line: number, column: number): number {
  let at = 0;
  for (let l = 1; l < line; l++) {
    const next = text.indexOf('\n', at);
    if (next < 0) return text.length;
    at = next + 1;
  }
  return Math.min(text.length, at + Math.max(0, column - 1));
}

/** The error and what follows it; else the last lines of messages without those that told the progress. */
export function last_messages(messages: string): string {
  const lines = messages
    .trim()
    .split('\n')
    .filter(line => !/^(initial state and )?step [0-9]+/.test(line));
  const error = lines.findIndex(line => /\berror: /.test(line));
  return (error < 0 ? lines.slice(-6) : lines.slice(error, error + 6)).join('\n');
}
