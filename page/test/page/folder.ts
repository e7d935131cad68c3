// A server for tests that answers as `keyblock serve` does, with a small folder in memory.

import { createHash } from 'node:crypto';
import { readFileSync } from 'node:fs';
import { createServer, type IncomingMessage, type Server } from 'node:http';
import type { AddressInfo } from 'node:net';
import { built } from './browser';

const DRAWING =
  '<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 90 60"><rect width="90" height="60" fill="#e3d9c6"/></svg>';

const BLOCKS = [
  {
    material: 1,
    loops: [
      [
        [0, 0],
        [5, 0],
        [5, 5],
        [0, 5],
      ],
    ],
  },
];

/** Part of the schema of a case file. */
const SCHEMA = {
  type: 'object',
  'x-sections': [
    { title: 'Block materials', row: 'block material', path: ['analysis', 'block_materials'] },
    { title: 'Analysis', row: '', path: ['analysis'] },
    { title: 'Run', row: '', path: ['run'] },
  ],
  properties: {
    keyblock: { enum: [1, 2], title: 'Version', description: 'version of the layout' },
    analysis: {
      type: 'object',
      title: 'Analysis',
      description: 'steps and materials',
      properties: {
        step_count: {
          type: 'integer',
          title: 'Step count',
          description: 'number of time steps. Permitted: a whole number from 1 to 100000000',
          'x-permitted': 'a whole number from 1 to 100000000',
          'x-unit': 'none',
          'x-group': 'Time steps',
          minimum: 1,
          maximum: 100000000,
        },
        rotation: {
          enum: ['first_order', 'exact'],
          title: 'Rotation',
          default: 'first_order',
          description: 'formula for rotation',
          'x-words': { exact: 'sine and cosine' },
          'x-group': 'Old files',
        },
        joint_materials: {
          type: 'array',
          title: 'Joint materials',
          items: {
            type: 'object',
            properties: { friction_angle_deg: { type: 'number', title: 'Friction angle', 'x-unit': 'deg' } },
          },
        },
        block_materials: {
          type: 'array',
          title: 'Block materials',
          description: 'materials of blocks',
          items: {
            type: 'object',
            properties: {
              name: { type: 'string', title: 'Name', description: 'name of the material' },
              poissons_ratio: {
                type: 'number',
                title: "Poisson's ratio",
                default: 0,
                description: "Poisson's ratio. Permitted: 0 to 0.5",
                'x-permitted': '0 to 0.5',
                'x-unit': 'none',
                minimum: 0,
                maximum: 0.5,
              },
            },
          },
        },
      },
    },
    run: {
      type: 'object',
      title: 'Run',
      description: 'choices of a run',
      properties: {
        profile: { type: 'string', title: 'Profile', description: 'preset', examples: ['legacy', 'draft', 'standard'] },
        set: {
          type: 'object',
          title: 'Settings',
          description: 'settings',
          properties: {
            steps: {
              type: ['string', 'number', 'boolean'],
              title: 'Steps',
              description: 'number of time steps. Permitted: a whole number of at least 1',
              'x-permitted': 'a whole number of at least 1',
              'x-unit': 'none',
              minimum: 1,
            },
          },
        },
      },
    },
  },
};

/** Part of the schema of joint sets. */
const JOINT_SCHEMA = {
  type: 'object',
  properties: {
    slope: {
      type: 'object',
      title: 'Slope',
      required: ['height'],
      properties: {
        height: { type: 'number', title: 'Height', description: 'height of the face', 'x-unit': 'L' },
      },
    },
    sets: {
      type: 'array',
      items: {
        type: 'object',
        required: ['dip', 'spacing'],
        properties: {
          dip: { type: 'number', title: 'Dip', description: 'angle from the x axis', 'x-unit': 'deg' },
          spacing: {
            type: 'number',
            title: 'Spacing',
            description: 'mean distance between rows of joints. Permitted: greater than 0',
            'x-unit': 'L',
            'x-permitted': 'greater than 0',
            exclusiveMinimum: 0,
          },
        },
      },
    },
  },
};

/** Sides of the outline, and one joint. */
function joints_of(spec: { outline?: [number, number][] }) {
  const corners = spec.outline ?? [
    [0, 0],
    [10, 0],
    [10, 10],
    [0, 10],
  ];
  const sides = corners.map((corner, i) => [...corner, ...corners[(i + 1) % corners.length], 1]);
  return { boundary_count: sides.length, joints: [...sides, [1, 0, 1, 10, 1]], hole_points: [] };
}

/** Policy that the server of the program sends with its pages. */
const POLICY =
  "default-src 'none'; script-src 'unsafe-inline'; style-src 'unsafe-inline'; img-src 'self' data: blob:; " +
  "media-src blob:; connect-src 'self'; frame-src 'self'; frame-ancestors 'self'; base-uri 'none'; form-action 'none'";

async function body_of(request: IncomingMessage): Promise<Record<string, unknown>> {
  let text = '';
  for await (const part of request) text += part;
  return text ? JSON.parse(text) : {};
}

export interface Folder {
  server: Server;
  address: string;
  files: Map<string, string>;
  results: Set<string>;
  /** Bodies of requests, by address. */
  asked: { path: string; body: Record<string, unknown> }[];
}

/** Starts the server; pages of results are the built page with `scripts`. */
export async function serve_folder(files: Record<string, string>, scripts: string): Promise<Folder> {
  const own: Folder = {
    server: null as unknown as Server,
    address: '',
    files: new Map(Object.entries(files)),
    results: new Set(['first', 'second', ...(files['strength/fos.json'] ? ['strength', 'broken', 'halted'] : [])]),
    asked: [],
  };
  const sum = (text: string) => createHash('sha256').update(text).digest('hex');
  const jobs: Record<string, unknown>[] = [];
  const start_page = readFileSync(new URL('../../built/serve.html', import.meta.url), 'utf8');
  own.server = createServer(async (request, reply) => {
    const url = new URL(request.url ?? '/', 'http://localhost');
    const send = (value: unknown, status = 200) => {
      reply.writeHead(status, { 'Content-Type': 'application/json' });
      reply.end(JSON.stringify(value));
    };
    const page = (text: string) => {
      reply.writeHead(200, { 'Content-Type': 'text/html; charset=utf-8', 'Content-Security-Policy': POLICY });
      reply.end(text);
    };
    const body = request.method === 'POST' ? await body_of(request) : {};
    if (request.method === 'POST') own.asked.push({ path: url.pathname, body });
    switch (url.pathname) {
      case '/':
        return page(start_page);
      case '/page':
        return page(built().replace('<!--keyblock-data-->', () => scripts));
      case '/api/live':
        // No run goes on: the second request waits.
        if (url.searchParams.get('stamp')) await new Promise(resolve => setTimeout(resolve, 5000));
        return send({ is_running: false, stamp: '1' });
      case '/api/list':
        return send({
          folder: 'cases',
          files: [...own.files].map(([path, text]) => ({ path, bytes: text.length, time: 1.79e9 })),
          results: [...own.results].map(path => ({
            path,
            time: 1.79e9,
            is_finished: true,
            is_broken: path === 'broken',
            has_checkpoint: false,
            kind: own.files.has(`${path}/fos.json`) ? 'fos' : own.files.has(`${path}/table.csv`) ? 'sweep' : 'run',
          })),
        });
      case '/api/read': {
        const path = url.searchParams.get('path') ?? '';
        const text = own.files.get(path);
        if (text === undefined) return send({ error: `there is no file ${path}` }, 404);
        return send({ path, is_text: true, sha256: sum(text), text });
      }
      case '/api/record': {
        const text = own.files.get(`${url.searchParams.get('result')}/fos.json`);
        return text ? send(JSON.parse(text)) : send({ outcome: { end: 'finished', steps: 300 } });
      }
      case '/api/drawing':
      case '/api/thumbnail':
      case '/api/picture':
        reply.writeHead(200, { 'Content-Type': 'image/svg+xml' });
        reply.end(DRAWING);
        return;
      case '/api/jobs':
        return send({ jobs });
      case '/api/compare':
        return send({
          inputs: [{ path: 'analysis.joint_materials[1].friction_angle_deg', first: 35, second: 33, relative: 0.057 }],
          differences: [
            { path: 'outcome.steps', first: 300, second: 100, relative: 0.667 },
            { path: 'settings.steps', first: 300, second: 100, relative: 0.667 },
            {
              path: 'extremes.greatest_displacement.value',
              first: 0.002,
              second: 0.001,
              relative: 0.5,
              units: ['m', 'm'],
              title: 'Greatest displacement',
            },
          ],
        });
      case '/api/check': {
        const path = body.path ? String(body.path) : (body.paths as string[])[0];
        const text = body.path ? String(body.text) : (own.files.get(path) ?? '');
        const at = text.split('\n').findIndex(line => /wrong|friction_angle_deg": 95/.test(line));
        const errors =
          at < 0 ? [] : [{ file: path, line: at + 1, column: 2, sentence: 'expected a key <b>of the case</b>' }];
        return send({
          files: [{ file: path, warnings: [] }],
          case: {
            warnings: [],
            profile: 'standard',
            profile_because: "the case is Keyblock's own",
            size: '30 m by 14 m',
            requires: { unknowns: 252, basis: 'affine', terms: [] },
            settings: { steps: 300 },
            unit_by_letters: { L: 'm', T: 's' },
            ...(body.trial ? { cost: { seconds_in_all: 3.2 } } : {}),
          },
          exit_code: errors.length ? 3 : 0,
          errors,
        });
      }
      case '/api/blocks':
        return send({ blocks: BLOCKS });
      case '/api/joints':
        return send(joints_of(body.spec as { outline?: [number, number][] }));
      case '/api/materials':
        return send({
          block_materials: [{ like: 'limestone', density: 2600, youngs_modulus: 39.3e9, poissons_ratio: 0.23 }],
          joint_materials: [{ like: 'limestone_joint', friction_angle_deg: 34 }],
        });
      case '/api/schema':
        return send(SCHEMA);
      case '/api/joint_schema':
        return send(JOINT_SCHEMA);
      case '/api/save': {
        const path = String(body.path);
        const there = own.files.get(path);
        if (there !== undefined && body.sha256 !== sum(there))
          return send({ error: `${path} exists already, or has changed` }, 409);
        own.files.set(path, String(body.text));
        return send({ path, sha256: sum(String(body.text)) });
      }
      case '/api/convert': {
        own.files.set(String(body.target), '{"keyblock": 2}\n');
        const messages = 'old/tips.ana: warning: a run takes profile standard [profile_changes]\n';
        return send({ files: [body.target], changes: [], exit_code: 0, messages });
      }
      case '/api/run': {
        const result = String(body.result);
        own.results.add(result);
        const job = {
          id: jobs.length + 1,
          kind: 'run',
          title: (body.paths as string[])[0],
          result,
          is_stopping: false,
        };
        jobs.push({ ...job, state: 'ended', step: 300, steps: 300, left: '', seconds: 1, exit_code: 0, messages: '' });
        return send({ id: job.id });
      }
      case '/api/sweep': {
        const result = String(body.result);
        own.results.add(result);
        own.files.set(
          `${result}/table.csv`,
          'angle,verdict,doubt,displacement,job\n10,finished,,1.7034884,0f7b\n15,"x, y",,1.314,b99a\n',
        );
        own.files.set(`${result}/columns.csv`, 'column,unit,meaning\ndisplacement,m,largest displacement\n');
        jobs.push({
          id: jobs.length + 1,
          kind: 'sweep',
          title: (body.paths as string[])[0],
          result,
          state: 'ended',
          exit_code: 0,
        });
        return send({ id: jobs.length });
      }
      case '/api/element':
      case '/api/fit':
        return send({
          exit_code: 0,
          record: {
            least_stress: -5.25e6,
            parameters: { cohesion: { value: 13.6254, standard_error: 1, interval: [12, 15], unit: 'MPa' } },
            units: { stress: 'Pa' },
          },
          svg: DRAWING,
          table: 'strain,stress\n',
          errors: [],
          messages: '',
        });
      default:
        return send({ error: `there is nothing at ${url.pathname}` }, 404);
    }
  });
  await new Promise<void>(resolve => own.server.listen(0, '127.0.0.1', resolve));
  own.address = `http://127.0.0.1:${(own.server.address() as AddressInfo).port}/`;
  return own;
}
