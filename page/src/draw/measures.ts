// Measures: numbers or states by which bodies are coloured, listed and plotted, made from motion and fields.

import type { FieldHead, Head } from '../data/contract';
import type { Geometry } from '../data/decode';
import { type FieldAt, offset_of, type Store } from '../data/store';

export interface Measure {
  id: string;
  /** Heading under which the choice stands. */
  group: string;
  label: string;
  unit: string;
  on: 'body' | 'vertex';
  /** Field that it is made from; none for what geometry alone gives. */
  field: string | null;
  kind: 'real' | 'state';
  /** Values on both sides of zero mean opposite things. */
  is_signed: boolean;
  /** Names of states. */
  names?: string[];
  digits: number;
  /** Writes one value a row (body or vertex) of a frame. */
  fill(out: Float32Array, at: FieldAt | undefined, geometry: Geometry, frame: number): void;
}

type Parts2 = (a: number, b: number, c: number) => number;

const hypot: Parts2 = (a, b) => Math.sqrt(a * a + b * b);
const greater: Parts2 = (a, b, c) => (a + b) / 2 + Math.sqrt(((a - b) / 2) ** 2 + c * c);
const lesser: Parts2 = (a, b, c) => (a + b) / 2 - Math.sqrt(((a - b) / 2) ** 2 + c * c);
const shear: Parts2 = (a, b, c) => Math.sqrt(((a - b) / 2) ** 2 + c * c);

/** Fills from up to three parts of a field. */
function from_parts(parts: number[], make: Parts2): Measure['fill'] {
  return (out, at) => {
    if (!at) {
      out.fill(Number.NaN);
      return;
    }
    const { values, rows } = at.chunk;
    const [a, b, c] = [0, 1, 2].map(i => offset_of(at, parts[Math.min(i, parts.length - 1)]));
    for (let row = 0; row < rows; row++) out[row] = make(values[a + row], values[b + row], values[c + row]);
  };
}

/** Digits that a field's precision carries. */
export function digits_of(bits: number): number {
  return bits >= 14 ? 4 : 3;
}

/** "horizontal" and "vertical" for x and y. */
const AXES: Record<string, string> = { x: 'horizontal (x)', y: 'vertical (y)' };

function measures_of_field(field: FieldHead): Measure[] {
  const group = field.label;
  const base = {
    group,
    unit: field.unit,
    on: field.on,
    field: field.name,
    kind: field.kind ?? 'real',
    names: field.names,
    digits: digits_of(field.bits),
  } as const;
  const one = (part: number): Measure['fill'] => from_parts([part], a => a);
  const is_vector = field.parts === 2;
  const is_tensor = field.parts >= 3 && field.components?.[0] === 'xx' && field.components?.[1] === 'yy';
  if (field.parts === 1) {
    return [{ ...base, id: field.name, label: field.label, is_signed: false, fill: one(0) }];
  }
  const names = field.components ?? (is_vector ? ['x', 'y'] : []);
  const components = Array.from({ length: field.parts }, (_, part): Measure => {
    const name = names[part] ?? String(part + 1);
    return {
      ...base,
      id: `${field.name}.${name}`,
      label: `${field.label}, ${AXES[name] ?? name}`,
      is_signed: true,
      fill: one(part),
    };
  });
  if (is_vector) {
    const size: Measure = {
      ...base,
      id: `${field.name}.size`,
      label: `${field.label}, magnitude`,
      is_signed: false,
      fill: from_parts([0, 1], hypot),
    };
    return [size, ...components];
  }
  if (!is_tensor) return components;
  const principal = (id: string, label: string, make: Parts2, is_signed: boolean): Measure => ({
    ...base,
    id: `${field.name}.${id}`,
    label: `${field.label}, ${label}`,
    is_signed,
    fill: from_parts([0, 1, 2], make),
  });
  return [
    principal('greatest', 'greatest principal', greater, true),
    principal('least', 'least principal', lesser, true),
    principal('shear', 'greatest shear', shear, false),
    ...components,
  ];
}

/** Displacement as measures; of vertices where they move on their own. */
function displacement(store: Store): Measure[] {
  const on_vertices = store.has('vertex_motion');
  const field: FieldHead = {
    name: on_vertices ? 'vertex_motion' : 'motion',
    label: 'Displacement',
    unit: store.head.units?.length ?? '',
    on: on_vertices ? 'vertex' : 'body',
    parts: 2,
    components: ['x', 'y'],
    bits: 14,
  };
  return measures_of_field(field).map(measure => ({
    ...measure,
    id: measure.id.replace(/^.*\./, 'displacement.'),
    fill: (out, at, geometry, frame) => {
      const motion = on_vertices && !at ? store.field_now('motion', frame) : undefined;
      measure.fill(out, motion ? vertices_from_motion(motion, geometry) : at, geometry, frame);
    },
  }));
}

/** Displacement of vertices from their bodies' motion, for frames in which bodies move affinely. */
function vertices_from_motion(motion: FieldAt, geometry: Geometry): FieldAt {
  const { vertices, vertex_body, place } = geometry;
  const values = new Float32Array(2 * vertices);
  const [ux, uy, g11, g12, g21, g22] = [0, 1, 2, 3, 4, 5].map(part => offset_of(motion, part));
  const from = motion.chunk.values;
  for (let v = 0; v < vertices; v++) {
    const b = vertex_body[v];
    values[v] = from[ux + b] + from[g11 + b] * place[2 * v] + from[g12 + b] * place[2 * v + 1];
    values[vertices + v] = from[uy + b] + from[g21 + b] * place[2 * v] + from[g22 + b] * place[2 * v + 1];
  }
  return { chunk: { parts: 2, frames: 1, rows: vertices, values }, frame: 0 };
}

/** All measures of a run. */
export function measures_of(head: Head, store: Store): Measure[] {
  const names = head.materials.map((name, i) => (name === String(i + 1) ? `Material ${name}` : name));
  const still = (
    id: string,
    label: string,
    states: string[],
    value: (geometry: Geometry, row: number) => number,
  ): Measure => ({
    id,
    group: 'Model',
    label,
    unit: '',
    on: 'body',
    field: null,
    kind: 'state',
    is_signed: false,
    names: states,
    digits: 4,
    fill: (out, _, geometry) => {
      for (let row = 0; row < geometry.bodies; row++) out[row] = value(geometry, row);
    },
  });
  return [
    ...displacement(store),
    ...head.fields.filter(field => !/^(vertex_)?motion$/.test(field.name)).flatMap(measures_of_field),
    still('material', 'Material', names, (geometry, row) => geometry.material[row]),
    still('fixed', 'Fixed or free', ['free', 'fixed'], (geometry, row) => geometry.fixed[row]),
    still('single', 'Each block its own colour', [], (geometry, row) => (geometry.key[row] * 5) % 8),
  ];
}
