// WebGL 2: draws solids with an outline, surfaces, and lines with a width in pixels. Unlit solids have exactly their
// color, so that the color of a leg shows its force. Edges are smooth if time permits.

import { ball, bar, tube } from "./shapes.js";

// Settings of fast drawing: resolution relative to the screen, if it exceeds the page's; and sides of tubes and balls
// in fast and in normal drawing. Without a GPU, triangles cost more than pixels.
const ROUGH = 0.75;
const FEW = { tube: 8, ball: 12 };
const MANY = { tube: 18, ball: 18 };

const SOLID = `#version 300 es
in vec3 position; in vec3 normal; in vec3 hull;
in mat4 model; in vec4 color; in float lit;
uniform mat4 eye; uniform vec2 pixels; uniform float outline;
out vec3 turned; out vec4 paint; out float light;
void main() {
  mat3 axes = mat3(model);
  vec3 squares = vec3(dot(axes[0], axes[0]), dot(axes[1], axes[1]), dot(axes[2], axes[2]));
  turned = axes * (normal / squares);
  paint = color;
  light = lit;
  gl_Position = eye * (model * vec4(position, 1.0));
  vec2 away = (eye * vec4(axes * (hull / sqrt(squares)), 0.0)).xy * pixels;
  gl_Position.xy += outline * 2.0 * gl_Position.w * away / max(length(away), 1e-9) / pixels;
}`;

const SURFACE = `#version 300 es
in vec3 position; in vec3 normal; in vec4 color;
uniform mat4 eye;
out vec3 turned; out vec4 paint; out float light;
void main() {
  turned = normal;
  paint = color;
  light = 1.0;
  gl_Position = eye * vec4(position, 1.0);
}`;

const PAINT = `#version 300 es
precision highp float;
in vec3 turned; in vec4 paint; in float light;
uniform vec3 sun; uniform float outline; uniform vec3 ink;
out vec4 seen;
void main() {
  float facing = dot(normalize(turned), sun);
  float shade = mix(1.0, 0.66 + 0.34 * abs(facing), light);
  seen = outline > 0.0 ? vec4(ink, 1.0) : vec4(paint.rgb * shade, paint.a);
}`;

const LINE = `#version 300 es
in vec2 corner; in vec3 start; in vec3 end; in vec4 color; in float wide;
uniform mat4 eye; uniform vec2 pixels;
out vec4 paint;
void main() {
  vec4 a = eye * vec4(start, 1.0);
  vec4 b = eye * vec4(end, 1.0);
  vec2 way = (b.xy / b.w - a.xy / a.w) * pixels;
  vec2 side = vec2(-way.y, way.x) / max(length(way), 1e-6) * wide;
  gl_Position = corner.x < 0.5 ? a : b;
  gl_Position.xy += corner.y * side / pixels * gl_Position.w;
  paint = color;
}`;

const PLAIN = `#version 300 es
precision highp float;
in vec4 paint;
out vec4 seen;
void main() { seen = paint; }`;

// Floats per instance or vertex, and the offset of each attribute.
const PARTS = {
  solid: { size: 21, at: { model: [0, 16], color: [16, 4], lit: [20, 1] } },
  line: { size: 11, at: { start: [0, 3], end: [3, 3], color: [6, 4], wide: [10, 1] } },
  surface: { size: 10, at: { position: [0, 3], normal: [3, 3], color: [6, 4] } },
};

export class Pen {
  // Throws an error without WebGL 2.
  constructor(canvas) {
    this.canvas = canvas;
    this.gl = canvas.getContext("webgl2", { antialias: false, alpha: false, preserveDrawingBuffer: true });
    if (!this.gl) throw new Error("this browser has no WebGL 2");
    this.prepare();
  }

  // Called again after the context was lost.
  prepare() {
    const gl = this.gl;
    this.programs = {
      solid: program(gl, SOLID, PAINT),
      surface: program(gl, SURFACE, PAINT),
      line: program(gl, LINE, PLAIN),
    };
    [this.fewSided, this.manySided] = [FEW, MANY].map((sides) => this.shapes(sides));
    const quad = new Float32Array([0, -1, 1, -1, 1, 1, 0, 1]);
    this.quad = this.instanced("line", quad, 2, [0, 1, 2, 0, 2, 3], { corner: [0, 2] });
    this.sheet = gl.createVertexArray();
    this.sheetBuffer = gl.createBuffer();
    gl.bindVertexArray(this.sheet);
    gl.bindBuffer(gl.ARRAY_BUFFER, this.sheetBuffer);
    attributes(gl, this.programs.surface, PARTS.surface.at, PARTS.surface.size, 0);
    this.smooth = { frame: gl.createFramebuffer(), color: gl.createRenderbuffer(), depth: gl.createRenderbuffer() };
    this.smoothSize = "";
    gl.enable(gl.DEPTH_TEST);
    gl.blendFuncSeparate(gl.SRC_ALPHA, gl.ONE_MINUS_SRC_ALPHA, gl.ONE, gl.ONE_MINUS_SRC_ALPHA);
  }

  // Tube and ball with numbers of sides, and bar.
  shapes(sides) {
    const places = { position: [0, 3], normal: [3, 3], hull: [6, 3] };
    const made = { tube: tube(sides.tube), ball: ball(sides.ball), bar: bar() };
    for (const [name, { numbers, corners }] of Object.entries(made))
      made[name] = this.instanced("solid", new Float32Array(numbers), 9, corners, places);
    return made;
  }

  // Triangles that are drawn once for each instance of a buffer.
  instanced(kind, numbers, size, corners, places) {
    const gl = this.gl;
    const found = { array: gl.createVertexArray(), instances: gl.createBuffer(), count: corners.length, kind };
    gl.bindVertexArray(found.array);
    gl.bindBuffer(gl.ARRAY_BUFFER, gl.createBuffer());
    gl.bufferData(gl.ARRAY_BUFFER, numbers, gl.STATIC_DRAW);
    attributes(gl, this.programs[kind], places, size, 0);
    gl.bindBuffer(gl.ARRAY_BUFFER, found.instances);
    attributes(gl, this.programs[kind], PARTS[kind].at, PARTS[kind].size, 1);
    gl.bindBuffer(gl.ELEMENT_ARRAY_BUFFER, gl.createBuffer());
    gl.bufferData(gl.ELEMENT_ARRAY_BUFFER, new Uint16Array(corners), gl.STATIC_DRAW);
    return found;
  }

  // Clears the canvas; the picture has as many pixels as the screen displays. smooth: with smooth edges. Without them,
  // and with fewer sides and pixels, drawing takes a third of the time.
  begin(paper, smooth) {
    const { gl, canvas } = this;
    const whole = window.devicePixelRatio || 1;
    const ratio = smooth ? whole : Math.min(whole, Math.max(1, ROUGH * whole));
    const [wide, high] = [canvas.clientWidth, canvas.clientHeight].map((each) => Math.max(1, Math.round(each * ratio)));
    if (canvas.width !== wide || canvas.height !== high) Object.assign(canvas, { width: wide, height: high });
    this.isSmooth = smooth;
    if (smooth) this.useSamples();
    else gl.bindFramebuffer(gl.FRAMEBUFFER, null);
    gl.disable(gl.SCISSOR_TEST);
    gl.clearColor(...paper);
    gl.clear(gl.COLOR_BUFFER_BIT | gl.DEPTH_BUFFER_BIT);
  }

  // Draws into four samples of each pixel.
  useSamples() {
    const { gl, canvas, smooth } = this;
    gl.bindFramebuffer(gl.FRAMEBUFFER, smooth.frame);
    const size = `${canvas.width} ${canvas.height}`;
    if (size === this.smoothSize) return;
    this.smoothSize = size;
    for (const [buffer, format, place] of [
      [smooth.color, gl.RGB8, gl.COLOR_ATTACHMENT0],
      [smooth.depth, gl.DEPTH_COMPONENT24, gl.DEPTH_ATTACHMENT],
    ]) {
      gl.bindRenderbuffer(gl.RENDERBUFFER, buffer);
      gl.renderbufferStorageMultisample(gl.RENDERBUFFER, 4, format, canvas.width, canvas.height);
      gl.framebufferRenderbuffer(gl.FRAMEBUFFER, place, gl.RENDERBUFFER, buffer);
    }
  }

  // Copies the drawing to the canvas.
  end() {
    const { gl, canvas } = this;
    if (!this.isSmooth) return;
    const all = [0, 0, canvas.width, canvas.height];
    gl.disable(gl.SCISSOR_TEST);
    gl.bindFramebuffer(gl.DRAW_FRAMEBUFFER, null);
    gl.blitFramebuffer(...all, ...all, gl.COLOR_BUFFER_BIT, gl.NEAREST);
  }

  // Draws a scene { solids, lines, sheets } in a part of the canvas, in page pixels.
  draw(scene, picture, eye, style) {
    const { gl, canvas } = this;
    const ratio = canvas.width / Math.max(1, canvas.clientWidth);
    const at = [picture.x, canvas.clientHeight - picture.y - picture.height, picture.width, picture.height];
    const [x, y, wide, high] = at.map((each) => Math.round(each * ratio));
    gl.viewport(x, y, wide, high);
    gl.enable(gl.SCISSOR_TEST);
    gl.scissor(x, y, wide, high);
    const common = { eye, pixels: [wide, high], sun: style.sun, ink: style.ink, ratio };
    const shapes = this.isSmooth ? this.manySided : this.fewSided;
    for (const [name, shape] of Object.entries(shapes)) this.solids(shape, scene.solids[name] || [], common);
    this.sheets(scene.sheets.filter((each) => !each.clear), common);
    if (scene.overlaid) gl.disable(gl.DEPTH_TEST);
    this.lines(scene.lines, common);
    gl.enable(gl.DEPTH_TEST);
    gl.enable(gl.BLEND);
    gl.depthMask(false);
    this.sheets(scene.sheets.filter((each) => each.clear), common);
    gl.depthMask(true);
    gl.disable(gl.BLEND);
  }

  solids(shape, instances, common) {
    if (!instances.length) return;
    const gl = this.gl;
    const use = this.uniforms("solid", common);
    fill(gl, shape.instances, instances);
    gl.bindVertexArray(shape.array);
    gl.enable(gl.CULL_FACE);
    // The outline is the back of each solid, slightly enlarged.
    for (const [side, outline] of [[gl.FRONT, 1.3 * common.ratio], [gl.BACK, 0]]) {
      gl.cullFace(side);
      gl.uniform1f(use.outline, outline);
      gl.drawElementsInstanced(gl.TRIANGLES, shape.count, gl.UNSIGNED_SHORT, 0, instances.length);
    }
    gl.disable(gl.CULL_FACE);
  }

  lines(instances, common) {
    if (!instances.length) return;
    const gl = this.gl;
    this.uniforms("line", common);
    fill(gl, this.quad.instances, instances.map((line) => [...line.slice(0, 10), line[10] * common.ratio]));
    gl.bindVertexArray(this.quad.array);
    gl.drawElementsInstanced(gl.TRIANGLES, this.quad.count, gl.UNSIGNED_SHORT, 0, instances.length);
  }

  sheets(sheets, common) {
    const gl = this.gl;
    const use = this.uniforms("surface", common);
    gl.uniform1f(use.outline, 0);
    gl.bindVertexArray(this.sheet);
    gl.bindBuffer(gl.ARRAY_BUFFER, this.sheetBuffer);
    for (const { numbers } of sheets) {
      gl.bufferData(gl.ARRAY_BUFFER, numbers, gl.DYNAMIC_DRAW);
      gl.drawArrays(gl.TRIANGLES, 0, numbers.length / PARTS.surface.size);
    }
  }

  uniforms(kind, { eye, pixels, sun, ink }) {
    const gl = this.gl;
    const use = this.programs[kind];
    gl.useProgram(use.program);
    gl.uniformMatrix4fv(use.eye, false, eye);
    if (use.pixels) gl.uniform2fv(use.pixels, pixels);
    if (use.sun) gl.uniform3fv(use.sun, sun);
    if (use.ink) gl.uniform3fv(use.ink, ink.slice(0, 3));
    return use;
  }
}

function fill(gl, buffer, instances) {
  gl.bindBuffer(gl.ARRAY_BUFFER, buffer);
  gl.bufferData(gl.ARRAY_BUFFER, new Float32Array(instances.flat()), gl.DYNAMIC_DRAW);
}

function program(gl, ...texts) {
  const made = gl.createProgram();
  texts.forEach((text, i) => {
    const shader = gl.createShader(i ? gl.FRAGMENT_SHADER : gl.VERTEX_SHADER);
    gl.shaderSource(shader, text);
    gl.compileShader(shader);
    gl.attachShader(made, shader);
  });
  gl.linkProgram(made);
  if (!gl.getProgramParameter(made, gl.LINK_STATUS) && !gl.isContextLost()) throw new Error(gl.getProgramInfoLog(made));
  const found = { program: made };
  for (const name of ["eye", "pixels", "outline", "sun", "ink"]) found[name] = gl.getUniformLocation(made, name);
  return found;
}

// Declares the offsets of a program's attributes in the bound buffer; a matrix takes four places.
function attributes(gl, { program }, places, size, divisor) {
  for (const [name, [offset, count]] of Object.entries(places)) {
    const first = gl.getAttribLocation(program, name);
    for (let i = 0; first >= 0 && i < Math.ceil(count / 4); i++) {
      gl.enableVertexAttribArray(first + i);
      gl.vertexAttribPointer(first + i, Math.min(4, count), gl.FLOAT, false, 4 * size, 4 * (offset + 4 * i));
      gl.vertexAttribDivisor(first + i, divisor);
    }
  }
}
