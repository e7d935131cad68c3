// Tools of the canvas: what each draws and when it can be used.

import type { Geometry, Scene } from './scene';

export type ToolName =
  | 'select'
  | 'outline'
  | 'opening'
  | 'joint'
  | 'material'
  | 'fixed'
  | 'point'
  | 'load'
  | 'bolt'
  | 'excavation'
  | 'support'
  | 'traction'
  | 'hole';

export interface Tool {
  name: ToolName;
  label: string;
  key: string;
  /** Points that it takes; 0: a closed chain. */
  points: 0 | 1 | 2;
  geometries: Geometry[];
  /** True if it is for bodies of the manifold method alone. */
  is_nmm?: boolean;
  hint: string;
  /** Lines of its icon, in a box of 20 by 20. */
  icon: string;
}

const CLOSED = 'Click the corners. Enter or a click on the first corner closes the chain.';

export const TOOLS: Tool[] = [
  {
    name: 'select',
    label: 'Select',
    key: 'v',
    points: 1,
    geometries: ['drawing', 'blocks', 'cover', 'file', 'none'],
    hint: 'Click an item, or drag a box around several. Drag an item or a corner to move it.',
    icon: 'M5 3l10 7-4.5 1L13 16l-2 1-2.5-5L5 15z',
  },
  {
    name: 'outline',
    label: 'Outline',
    key: 'o',
    points: 0,
    geometries: ['drawing', 'none'],
    hint: `${CLOSED} It replaces the old outline.`,
    icon: 'M3 16L4 7l7-3 6 6-2 6z',
  },
  {
    name: 'joint',
    label: 'Joint',
    key: 'j',
    points: 2,
    geometries: ['drawing'],
    hint: 'Click start and end of the joint.',
    icon: 'M3 16L17 5M3 5v0M17 16v0',
  },
  {
    name: 'fixed',
    label: 'Fixed',
    key: 'f',
    points: 2,
    geometries: ['drawing', 'blocks', 'cover'],
    hint: 'Click start and end of the fixed line. It fixes blocks where it crosses their edges.',
    icon: 'M3 8h14M5 8l-2 5M9 8l-2 5M13 8l-2 5M17 8l-2 5',
  },
  {
    name: 'point',
    label: 'Point',
    key: 'p',
    points: 1,
    geometries: ['drawing', 'blocks', 'cover'],
    hint: 'Click a place whose motion is recorded.',
    icon: 'M10 3v14M3 10h14M14 10a4 4 0 1 1-8 0 4 4 0 0 1 8 0',
  },
  {
    name: 'load',
    label: 'Load',
    key: 'l',
    points: 2,
    geometries: ['drawing', 'blocks', 'cover'],
    hint: 'Click the loaded point, then the direction of the force.',
    icon: 'M4 4l11 11M15 9v6H9',
  },
  {
    name: 'bolt',
    label: 'Bolt',
    key: 'b',
    points: 2,
    geometries: ['drawing', 'blocks'],
    hint: 'Click both ends of the bolt.',
    icon: 'M5 15L15 5M3 13l4 4M13 3l4 4',
  },
  {
    name: 'opening',
    label: 'Opening',
    key: 'q',
    points: 0,
    geometries: ['drawing'],
    hint: `${CLOSED} The rock in it is absent from the start.`,
    icon: 'M3 3h14v14H3zM7 13V9l3-2 3 2v4z',
  },
  {
    name: 'excavation',
    label: 'Excavation',
    key: 'x',
    points: 0,
    geometries: ['drawing', 'blocks'],
    hint: `${CLOSED} The rock in it is removed by the stage chosen.`,
    icon: 'M4 16v-4M4 9V5h3M10 5h4l2 3M16 11v5h-3M10 16H7',
  },
  {
    name: 'material',
    label: 'Material',
    key: 'm',
    points: 2,
    geometries: ['drawing'],
    hint: 'Click start and end of a line. Blocks that it crosses get the block material chosen.',
    icon: 'M3 14l4-3 4 2 6-7M3 17h14',
  },
  {
    name: 'support',
    label: 'Support',
    key: 'u',
    points: 2,
    geometries: ['drawing', 'blocks'],
    is_nmm: true,
    hint: 'Click start and end of an edge of an NMM body. Its displacement is prescribed there.',
    icon: 'M3 6h14M4 6l3 5H1zM16 6l3 5h-6zM1 14h18',
  },
  {
    name: 'traction',
    label: 'Traction',
    key: 't',
    points: 2,
    geometries: ['drawing', 'blocks'],
    is_nmm: true,
    hint: 'Click start and end of an edge of an NMM body. A pressure acts on it.',
    icon: 'M3 16h14M5 3v9M10 3v9M15 3v9M3 10l2 2 2-2M8 10l2 2 2-2M13 10l2 2 2-2',
  },
  {
    name: 'hole',
    label: 'Hole',
    key: 'h',
    points: 1,
    geometries: ['drawing'],
    hint: 'Click a block that is removed from the start.',
    icon: 'M6 6l8 8M14 6l-8 8',
  },
];

export const tool_of = (name: ToolName): Tool => TOOLS.find(own => own.name === name)!;

/** True if a scene has the tool. */
export const is_for = (tool: Tool, scene: Scene): boolean =>
  tool.geometries.includes(scene.geometry) && (!tool.is_nmm || scene.has_covers);

/** Number of points of a tool in a scene: blocks and elements are fixed at points. */
export function points_of(tool: Tool, geometry: Geometry): 0 | 1 | 2 {
  return tool.name === 'fixed' && geometry !== 'drawing' ? 1 : tool.points;
}

/** Words on the clicks that a tool takes in a scene. */
export const hint_of = (tool: Tool, geometry: Geometry): string =>
  tool.name === 'fixed' && points_of(tool, geometry) === 1 ? 'Click a place of a body. It is fixed there.' : tool.hint;
