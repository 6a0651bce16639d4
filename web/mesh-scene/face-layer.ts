/** Bilinear faces of one layer of the picture. It knows three.js and the shader. */
import { DoubleSide, EqualDepth, GLSL3, LessEqualDepth, Mesh, RawShaderMaterial, Vector3 } from 'three'
import type { Vec3 } from '../model/hexahedron'
import { FACE_VERTICES } from '../survey/face-list'
import { COLOURS, NO_TONE_COLOUR, RAMP_COLOURS } from './cell-colour'
import type { FaceChunks } from './face-chunks'

/** Lightness that a face in the dark loses: more than within an element, as a cell has one colour here, and a mesh has a shape. */
const SHADE = 0.26

const LINE_OPACITY = 0.55

const vertexShader = /* glsl */ `
precision highp float;
uniform mat4 modelViewMatrix;
uniform mat4 projectionMatrix;
uniform float scale;
uniform float size;
uniform vec3 colours[${COLOURS}];
uniform float showsHidden;
in vec4 vertex;
in vec3 middle;
in float hidden;
out vec2 st;
out vec3 position;
flat out vec3 colour;

// (s, t) of a face's vertices.
const vec2 PATCH[${FACE_VERTICES}] = vec2[](vec2(0), vec2(1, 0), vec2(1), vec2(0, 1), vec2(0.5));

vec3 colourOf(float tone) {
  if (tone > 1.0) return colours[${NO_TONE_COLOUR}];
  float along = abs(tone) * ${RAMP_COLOURS - 1}.0;
  int stop = min(int(along), ${RAMP_COLOURS - 2}) + (tone < 0.0 ? 0 : ${RAMP_COLOURS});
  return mix(colours[stop], colours[stop + 1], along - floor(min(along, ${RAMP_COLOURS - 2}.0)));
}

void main() {
  st = PATCH[gl_VertexID % ${FACE_VERTICES}];
  colour = colourOf(vertex.w);
  position = mix(middle, vertex.xyz, size) * scale;
  gl_Position = projectionMatrix * modelViewMatrix * vec4(position, 1.0);
  // All vertices of a face that is hidden lie in one place beside the picture.
  if (hidden > showsHidden) gl_Position = vec4(2.0, 2.0, 2.0, 1.0);
}
`

const fragmentShader = /* glsl */ `
precision highp float;
in vec2 st;
in vec3 position;
flat in vec3 colour;
out vec4 fragment;
uniform vec3 eye;
uniform vec3 toLight;
uniform vec3 ink;
uniform float opacity;
uniform float lineOpacity;
uniform float pixelRatio;

const vec3 LUMINANCE = vec3(0.2126, 0.7152, 0.0722);

void main() {
  vec3 normal = cross(dFdx(position), dFdy(position));
  float lit = 0.5 + 0.5 * dot(normal * sign(dot(normal, eye - position)), toLight) / max(length(normal), 1e-30);
  float lightness = pow(dot(colour * colour, LUMINANCE), 1.0 / 3.0);
  // What is translucent shows less of its shading, so it has more.
  vec3 shaded = colour * max(1.0 - ${SHADE} * (1.0 - lit) / max(lightness, 0.1) / sqrt(opacity), 0.0);
  // Pixels from the nearest edge. Lines of cells of a few pixels would leave no colour: they fade.
  vec2 slope = max(fwidth(st), vec2(1e-6));
  vec2 pixels = min(st, 1.0 - st) / slope / pixelRatio;
  float line = 1.0 - smoothstep(0.2, 1.0, min(pixels.x, pixels.y));
  float room = 1.0 - smoothstep(0.08, 0.35, max(slope.x, slope.y) * pixelRatio);
  float shown = line * room * lineOpacity;
  float alpha = mix(opacity, 1.0, shown * 0.6);
  fragment = vec4(mix(shaded, ink, shown) * alpha, alpha);
}
`

/** What all layers of a picture have in common. */
export interface FaceView {
  /** World units a unit of the mesh. */
  readonly scale: number
  /** Of a cell that is drawn whole, from 0 to 1: less than 1 draws cells apart. */
  readonly size: number
  readonly eye: Vec3
  readonly toLight: Vec3
  readonly ink: Vec3
  readonly pixelRatio: number
}

export class FaceLayer {
  readonly #uniforms = {
    scale: { value: 1 },
    size: { value: 1 },
    eye: { value: new Vector3() },
    toLight: { value: new Vector3() },
    ink: { value: new Vector3() },
    colours: { value: new Float32Array(3 * COLOURS) },
    showsHidden: { value: 0 },
    opacity: { value: 1 },
    lineOpacity: { value: LINE_OPACITY },
    pixelRatio: { value: 1 },
  }
  readonly #material = new RawShaderMaterial({
    glslVersion: GLSL3,
    vertexShader,
    fragmentShader,
    uniforms: this.#uniforms,
    side: DoubleSide,
    premultipliedAlpha: true,
  })
  #meshes: readonly Mesh[] = []
  #isWhole = false

  /** `showsHidden`: also the faces that are hidden elsewhere. */
  constructor({ opacity = 1, lineOpacity = LINE_OPACITY, writesDepth = true, showsHidden = false } = {}) {
    this.opacity = opacity
    this.#uniforms.lineOpacity.value = lineOpacity
    this.#uniforms.showsHidden.value = showsHidden ? 1 : 0
    this.#material.depthWrite = writesDepth
  }

  get meshes(): readonly Mesh[] {
    return this.#meshes
  }

  /** All of them are loaded; whoever gives them up does so after they are no layer's any more. */
  set lists(lists: readonly FaceChunks[]) {
    this.#isWhole = lists.every(({ faces }) => faces.middles !== null)
    this.#meshes = lists.flatMap(({ geometries }) =>
      geometries.map(geometry => {
        const mesh = new Mesh(geometry, this.#material)
        mesh.frustumCulled = false
        return mesh
      }),
    )
  }

  set colours(colours: Float32Array<ArrayBuffer>) {
    this.#uniforms.colours.value = colours
  }

  get isTranslucent(): boolean {
    return this.#meshes.length > 0 && this.#uniforms.opacity.value < 1
  }

  set opacity(opacity: number) {
    this.#uniforms.opacity.value = opacity
    this.#material.transparent = opacity < 1
  }

  /** The depth alone, or the colours where the depth is that. */
  beIn(pass: 'invalid' | 'depth' | 'surface' | 'ghost'): void {
    this.#material.colorWrite = pass !== 'depth'
    this.#material.depthFunc = pass === 'surface' && this.isTranslucent ? EqualDepth : LessEqualDepth
  }

  write({ scale, size, eye, toLight, ink, pixelRatio }: FaceView): void {
    const uniforms = this.#uniforms
    uniforms.scale.value = scale
    // At full size a middle counts nothing.
    uniforms.size.value = this.#isWhole ? size : 1
    uniforms.eye.value.set(...eye)
    uniforms.toLight.value.set(...toLight)
    uniforms.ink.value.set(...ink)
    uniforms.pixelRatio.value = pixelRatio
  }

  dispose(): void {
    this.#material.dispose()
  }
}
