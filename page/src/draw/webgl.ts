// Draws bodies with WebGL2: filled triangles with a colour table, hatch in the shader, outlines as six vertices a segment,
// whose ends come from a texture: instances are slow where no card draws them.

import type { Geometry } from '../data/decode';
import { type Figure, outline_width, split_loops } from './paint';
import { HATCH } from './pen';
import { fraction } from './scene';
import { triangles_of } from './triangles';

const FILL_VERTEX = `#version 300 es
layout(location=0) in vec2 place;
layout(location=1) in float value;
layout(location=2) in float fixed_body;
uniform vec4 view;
out float v_value;
flat out float v_fixed;
void main() {
  v_value = value;
  v_fixed = fixed_body;
  gl_Position = vec4((place - view.xy) * view.zw, 0.0, 1.0);
}`;

const FILL_FRAGMENT = `#version 300 es
precision highp float;
in float v_value;
flat in float v_fixed;
uniform sampler2D table;
uniform vec3 missing;
uniform vec3 plain;
uniform vec3 plain_fixed;
uniform float has_values;
uniform float spacing;
out vec4 colour;
void main() {
  vec3 base = v_fixed > 0.5 ? plain_fixed : plain;
  if (has_values > 0.5) {
    bool is_number = v_value > -1e30;
    float at = (clamp(v_value, 0.0, 1.0) * 255.0 + 0.5) / 256.0;
    base = is_number ? texture(table, vec2(at, 0.5)).rgb : missing;
  }
  if (v_fixed > 0.5) {
    float at = mod(gl_FragCoord.x - gl_FragCoord.y, spacing);
    float width = spacing / ${HATCH}.0 * 1.3;
    float edge = min(at, spacing - at);
    float lit = mod(at + width, spacing);
    float light = min(lit, spacing - lit);
    base = mix(base, vec3(1.0), 0.42 * (1.0 - smoothstep(width * 0.5 - 0.5, width * 0.5 + 0.5, light)));
    base = mix(base, vec3(0.06, 0.08, 0.11), 0.42 * (1.0 - smoothstep(width * 0.5 - 0.5, width * 0.5 + 0.5, edge)));
  }
  colour = vec4(base, 1.0);
}`;

const LINE_VERTEX = `#version 300 es
uniform highp sampler2D ends_of;
uniform vec4 view;
uniform vec2 pixel;
uniform float width;
void main() {
  int segment = gl_VertexID / 6;
  int corner = gl_VertexID - 6 * segment;
  corner = corner < 3 ? corner : 6 - corner;
  vec4 ends = texelFetch(ends_of, ivec2(segment & 2047, segment >> 11), 0);
  vec2 a = (ends.xy - view.xy) * view.zw;
  vec2 b = (ends.zw - view.xy) * view.zw;
  vec2 along = (b - a) / pixel;
  float size = max(length(along), 1e-6);
  vec2 e = along / size;
  vec2 n = vec2(-e.y, e.x);
  float side = float(corner & 1) * 2.0 - 1.0;
  float end = float(corner >> 1);
  vec2 at = mix(a, b, end) + (n * side + e * (end * 2.0 - 1.0) * 0.5) * width * 0.5 * pixel;
  gl_Position = vec4(at, 0.0, 1.0);
}`;

const LINE_FRAGMENT = `#version 300 es
precision mediump float;
uniform vec4 paint;
out vec4 colour;
void main() { colour = paint; }`;

function program_of(gl: WebGL2RenderingContext, vertex: string, fragment: string): WebGLProgram {
  const program = gl.createProgram()!;
  for (const [kind, text] of [
    [gl.VERTEX_SHADER, vertex],
    [gl.FRAGMENT_SHADER, fragment],
  ] as const) {
    const shader = gl.createShader(kind)!;
    gl.shaderSource(shader, text);
    gl.compileShader(shader);
    gl.attachShader(program, shader);
  }
  gl.linkProgram(program);
  if (!gl.getProgramParameter(program, gl.LINK_STATUS)) throw new Error(gl.getProgramInfoLog(program) ?? 'no program');
  return program;
}

function rgb(css: string): [number, number, number] {
  return [1, 3, 5].map(i => Number.parseInt(css.slice(i, i + 2), 16) / 255) as [number, number, number];
}

/** True if WebGL2 runs on a card: software rasterising is slower than a plain canvas. */
export function has_card(gl: WebGL2RenderingContext): boolean {
  const info = gl.getExtension('WEBGL_debug_renderer_info');
  const name = String(info ? gl.getParameter(info.UNMASKED_RENDERER_WEBGL) : gl.getParameter(gl.RENDERER));
  return !/swiftshader|llvmpipe|software|basic render/i.test(name);
}

export class WebglBodies {
  private readonly fill: WebGLProgram;
  private readonly line: WebGLProgram;
  private readonly places: WebGLBuffer;
  private readonly values: WebGLBuffer;
  private readonly fixed: WebGLBuffer;
  private readonly index: WebGLBuffer;
  private readonly ends: WebGLTexture;
  private readonly table: WebGLTexture;
  private readonly fill_array: WebGLVertexArrayObject;
  private readonly line_array: WebGLVertexArrayObject;
  private geometry: Geometry | null = null;
  private count = 0;
  private segments = new Float32Array(0);
  private value_of_vertex = new Float32Array(0);

  private constructor(private readonly gl: WebGL2RenderingContext) {
    this.fill = program_of(gl, FILL_VERTEX, FILL_FRAGMENT);
    this.line = program_of(gl, LINE_VERTEX, LINE_FRAGMENT);
    const buffer = () => gl.createBuffer()!;
    [this.places, this.values, this.fixed, this.index] = [buffer(), buffer(), buffer(), buffer()];
    this.table = gl.createTexture()!;
    this.ends = gl.createTexture()!;
    for (const texture of [this.table, this.ends]) {
      gl.bindTexture(gl.TEXTURE_2D, texture);
      for (const name of [gl.TEXTURE_MIN_FILTER, gl.TEXTURE_MAG_FILTER]) {
        gl.texParameteri(gl.TEXTURE_2D, name, gl.NEAREST);
      }
      gl.texParameteri(gl.TEXTURE_2D, gl.TEXTURE_WRAP_S, gl.CLAMP_TO_EDGE);
      gl.texParameteri(gl.TEXTURE_2D, gl.TEXTURE_WRAP_T, gl.CLAMP_TO_EDGE);
    }
    this.fill_array = gl.createVertexArray()!;
    gl.bindVertexArray(this.fill_array);
    [this.places, this.values, this.fixed].forEach((own, i) => {
      gl.bindBuffer(gl.ARRAY_BUFFER, own);
      gl.enableVertexAttribArray(i);
      gl.vertexAttribPointer(i, i === 0 ? 2 : 1, gl.FLOAT, false, 0, 0);
    });
    gl.bindBuffer(gl.ELEMENT_ARRAY_BUFFER, this.index);
    this.line_array = gl.createVertexArray()!;
    gl.bindVertexArray(null);
  }

  /** Makes a renderer, or nothing where the page had better draw on a plain canvas. */
  static make(canvas: HTMLCanvasElement, even_without_card: boolean): WebglBodies | null {
    try {
      const gl = canvas.getContext('webgl2', {
        antialias: !even_without_card,
        preserveDrawingBuffer: true,
        alpha: false,
      });
      if (!gl || (!even_without_card && !has_card(gl))) return null;
      return new WebglBodies(gl);
    } catch {
      return null;
    }
  }

  /** Waits until all that was drawn is there. */
  wait(): void {
    const { gl } = this;
    gl.readPixels(0, 0, 1, 1, gl.RGBA, gl.UNSIGNED_BYTE, new Uint8Array(4));
  }

  private set_geometry(geometry: Geometry): void {
    const gl = this.gl;
    this.geometry = geometry;
    const index = triangles_of(geometry);
    this.count = index.length;
    gl.bindVertexArray(this.fill_array);
    gl.bufferData(gl.ELEMENT_ARRAY_BUFFER, index, gl.STATIC_DRAW);
    gl.bindVertexArray(null);
    const fixed = Float32Array.from(geometry.vertex_body, b => geometry.fixed[b]);
    gl.bindBuffer(gl.ARRAY_BUFFER, this.fixed);
    gl.bufferData(gl.ARRAY_BUFFER, fixed, gl.STATIC_DRAW);
    // The texture of segments is 2,048 wide, in whole rows.
    this.segments = new Float32Array(4 * 2048 * Math.ceil(geometry.vertices / 2048));
    this.value_of_vertex = new Float32Array(geometry.vertices);
  }

  /** Draws fills, hatches and outlines of a figure. */
  draw(figure: Figure, ratio: number): void {
    const { gl } = this;
    const { pose, camera, size, paint, shade } = figure;
    const { geometry, places } = pose;
    if (geometry !== this.geometry) this.set_geometry(geometry);
    const width = Math.round(size.width * ratio);
    const height = Math.round(size.height * ratio);
    gl.viewport(0, 0, width, height);
    gl.clearColor(...rgb(paint.background), 1);
    gl.clear(gl.COLOR_BUFFER_BIT);
    const view: [number, number, number, number] = [
      camera.x,
      camera.y,
      (2 * camera.scale) / size.width,
      (2 * camera.scale) / size.height,
    ];

    gl.useProgram(this.fill);
    const at = (name: string) => gl.getUniformLocation(this.fill, name);
    gl.uniform4f(at('view'), ...view);
    gl.uniform3f(at('missing'), ...rgb(paint.missing));
    gl.uniform3f(at('plain'), ...rgb(paint.plain));
    gl.uniform3f(at('plain_fixed'), ...rgb(paint.plain_fixed));
    gl.uniform1f(at('has_values'), shade ? 1 : 0);
    gl.uniform1f(at('spacing'), HATCH * ratio);
    gl.bindBuffer(gl.ARRAY_BUFFER, this.places);
    gl.bufferData(gl.ARRAY_BUFFER, places, gl.DYNAMIC_DRAW);
    const values = this.value_of_vertex;
    if (shade) {
      const on_vertices = shade.measure.on === 'vertex';
      for (let v = 0; v < values.length; v++) {
        const t = fraction(shade, shade.values[on_vertices ? v : geometry.vertex_body[v]]);
        values[v] = Number.isNaN(t) ? -2e30 : t;
      }
      gl.bindTexture(gl.TEXTURE_2D, this.table);
      gl.pixelStorei(gl.UNPACK_ALIGNMENT, 1);
      gl.texImage2D(gl.TEXTURE_2D, 0, gl.RGB8, 256, 1, 0, gl.RGB, gl.UNSIGNED_BYTE, shade.table);
    }
    gl.bindBuffer(gl.ARRAY_BUFFER, this.values);
    gl.bufferData(gl.ARRAY_BUFFER, values, gl.DYNAMIC_DRAW);
    gl.bindVertexArray(this.fill_array);
    gl.drawElements(gl.TRIANGLES, this.count, gl.UNSIGNED_INT, 0);

    if (outline_width(figure) > 0) {
      const { segments } = this;
      const { loop_start } = geometry;
      const [light, dark] = split_loops(figure);
      let at = 0;
      // Outlines about dark fills come first, in a lighter colour.
      for (const list of [dark, light]) {
        for (const l of list) {
          const end = loop_start[l + 1];
          for (let v = loop_start[l]; v < end; v++) {
            const next = v + 1 === end ? loop_start[l] : v + 1;
            segments[at++] = places[2 * v];
            segments[at++] = places[2 * v + 1];
            segments[at++] = places[2 * next];
            segments[at++] = places[2 * next + 1];
          }
        }
      }
      const dark_segments = dark.reduce((sum, l) => sum + loop_start[l + 1] - loop_start[l], 0);
      gl.useProgram(this.line);
      const on = (name: string) => gl.getUniformLocation(this.line, name);
      gl.uniform4f(on('view'), ...view);
      gl.uniform2f(on('pixel'), 2 / width, 2 / height);
      gl.uniform1f(on('width'), Math.max(1, outline_width(figure) * ratio));
      gl.bindTexture(gl.TEXTURE_2D, this.ends);
      gl.texImage2D(gl.TEXTURE_2D, 0, gl.RGBA32F, 2048, segments.length / 8192, 0, gl.RGBA, gl.FLOAT, segments);
      gl.bindVertexArray(this.line_array);
      gl.uniform4f(on('paint'), ...rgb(paint.outline_on_dark), 1);
      gl.drawArrays(gl.TRIANGLES, 0, 6 * dark_segments);
      gl.uniform4f(on('paint'), ...rgb(paint.outline), 1);
      gl.drawArrays(gl.TRIANGLES, 6 * dark_segments, 6 * (geometry.vertices - dark_segments));
    }
    gl.bindVertexArray(null);
  }
}
