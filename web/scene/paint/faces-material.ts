/**
 * The shader of the faces and of the section: positions are bilinear in (s, t) of four of the vertices, the section's own behind
 * the element's eight; jacdet is the biquadratic with the face's nine Bernstein coefficients, evaluated per pixel with its gradient.
 * Every line (border, zero contour, level, hatch) is drawn at its distance in pixels, so its width is the same everywhere. The
 * light that falls on the faces, not on the section, is faint: see shading.ts.
 */
import { DoubleSide, GLSL3, RawShaderMaterial, Vector3, Vector4 } from 'three'
import { faces, VERTEX_COUNT } from '../../model/hexahedron'
import { HATCH_PERIOD, RAMP_STEPS, type Ramp, type Rgb } from './colour-map'
import { SECTION } from './faces-geometry'
import { SHADE } from './shading'

const FACE_COUNT = faces.length + 1
const COEFFICIENT_COUNT = 9 * FACE_COUNT
const CORNER_COUNT = VERTEX_COUNT + 4

const sectionVertices = [0, 1, 2, 3].map(k => VERTEX_COUNT + k)
const faceVertices = [...faces.map(face => face.vertices), sectionVertices]
  .map(vertices => `ivec4(${vertices.join(', ')})`)
  .join(', ')

// A patch is origin + s byS + t byT + s t twist. A face's own values are looked up once a vertex: software renderers take several
// times as long to look them up at each pixel.
const patchOf = (qualifier: 'in' | 'out') =>
  ['origin', 'byS', 'byT', 'twist', 'bernstein0', 'bernstein1', 'bernstein2']
    .map(name => `flat ${qualifier} vec3 ${name};`)
    .join('\n')

const vertexShader = /* glsl */ `
precision highp float;
precision highp int;
uniform vec3 vertices[${CORNER_COUNT}];
uniform float bernstein[${COEFFICIENT_COUNT}];
uniform mat4 modelViewMatrix;
uniform mat4 projectionMatrix;
in vec3 facePoint;
out vec2 st;
flat out int face;
${patchOf('out')}
const ivec4 FACE_VERTICES[${FACE_COUNT}] = ivec4[](${faceVertices});

// Coincident faces of a collapsed element are told apart by less than any depth the eye could see.
const float FACE_BIAS = 2e-6;

void main() {
  st = facePoint.xy;
  face = int(facePoint.z + 0.5);
  ivec4 v = FACE_VERTICES[face];
  origin = vertices[v.x];
  byS = vertices[v.y] - origin;
  byT = vertices[v.z] - origin;
  twist = vertices[v.w] - vertices[v.z] - byS;
  int k = 9 * face;
  bernstein0 = vec3(bernstein[k], bernstein[k + 1], bernstein[k + 2]);
  bernstein1 = vec3(bernstein[k + 3], bernstein[k + 4], bernstein[k + 5]);
  bernstein2 = vec3(bernstein[k + 6], bernstein[k + 7], bernstein[k + 8]);
  vec3 at0 = mix(origin, vertices[v.y], st.x);
  vec3 at1 = mix(vertices[v.z], vertices[v.w], st.x);
  gl_Position = projectionMatrix * modelViewMatrix * vec4(mix(at0, at1, st.y), 1.0);
  gl_Position.z += FACE_BIAS * float(face) * gl_Position.w;
}
`

const fragmentShader = /* glsl */ `
precision highp float;
precision highp int;
in vec2 st;
flat in int face;
${patchOf('in')}
out vec4 fragment;

uniform float negativeExtent;
uniform float positiveExtent;
uniform vec3 neutral;
// From stop to stop of the ramps: of red, green and blue four steps each, then the other four.
uniform vec4 negativeSteps[6];
uniform vec4 positiveSteps[6];
uniform vec3 ink;
uniform vec3 paper;
uniform vec3 eye;
uniform vec3 toLight;
uniform float pixelRatio;
uniform float hatchPeriod;
// Opacities: of faces where positive and where negative, and of lines on them. The section hides what is behind it.
uniform vec3 opacity;

const float STEPS = ${RAMP_STEPS}.0;
// Below this change per pixel, and this value where nothing changes, single precision shows noise.
const float LEAST_SLOPE = 1e-6;
const float LEAST_VALUE = 1e-6;
const vec3 LUMINANCE = vec3(0.2126, 0.7152, 0.0722);

float coverage(float distance, float halfWidth) {
  return 1.0 - smoothstep(halfWidth - 0.5, halfWidth + 0.5, distance);
}

vec3 rampColour(float position) {
  float along = abs(position) * STEPS;
  vec4 a = clamp(along - vec4(0.0, 1.0, 2.0, 3.0), 0.0, 1.0);
  vec4 b = clamp(along - vec4(4.0, 5.0, 6.0, 7.0), 0.0, 1.0);
  if (position < 0.0)
    return neutral + vec3(dot(a, negativeSteps[0]) + dot(b, negativeSteps[3]), dot(a, negativeSteps[1]) + dot(b, negativeSteps[4]),
                          dot(a, negativeSteps[2]) + dot(b, negativeSteps[5]));
  return neutral + vec3(dot(a, positiveSteps[0]) + dot(b, positiveSteps[3]), dot(a, positiveSteps[1]) + dot(b, positiveSteps[4]),
                        dot(a, positiveSteps[2]) + dot(b, positiveSteps[5]));
}

// jacdet and its derivatives by s and t.
vec3 jacdet(vec2 p) {
  vec2 q = 1.0 - p;
  vec3 bs = vec3(q.x * q.x, 2.0 * p.x * q.x, p.x * p.x);
  vec3 bt = vec3(q.y * q.y, 2.0 * p.y * q.y, p.y * p.y);
  vec3 ds = vec3(-2.0 * q.x, 2.0 * (q.x - p.x), 2.0 * p.x);
  vec3 dt = vec3(-2.0 * q.y, 2.0 * (q.y - p.y), 2.0 * p.y);
  mat3 b = mat3(bernstein0, bernstein1, bernstein2);
  vec3 along = b * bs;
  return vec3(dot(bt, along), dot(bt, b * ds), dot(dt, along));
}

void main() {
  vec2 p = clamp(st, 0.0, 1.0);
  vec2 sSlope = vec2(dFdx(st.x), dFdy(st.x));
  vec2 tSlope = vec2(dFdx(st.y), dFdy(st.y));
  vec3 t = byT + p.x * twist;
  vec3 normal = cross(byS + p.y * twist, t);
  // Zero where the surface turns away from the eye.
  float turned = dot(normal, origin + p.x * byS + p.y * t - eye);
  vec2 turnedSlope = vec2(dFdx(turned), dFdy(turned));

  vec3 f = jacdet(p);
  float slope = length(f.y * sSlope + f.z * tSlope);
  float extent = f.x < 0.0 ? negativeExtent : positiveExtent;
  float position = clamp(f.x / extent, -1.0, 1.0);
  vec3 colour = rampColour(position);
  float lit = -sign(turned) * dot(normal, toLight) / max(length(normal), 1e-20);
  float lightness = pow(dot(colour * colour, LUMINANCE), 1.0 / 3.0);
  float shade = face == ${SECTION} ? 1.0 : 1.0 - ${SHADE} * (1.0 - max(lit, 0.0)) / lightness;
  colour *= shade;

  // A line on the colour takes whichever of ink and paper stands out from it.
  vec3 dark = dot(ink, vec3(1.0)) < dot(paper, vec3(1.0)) ? ink : paper;
  vec3 light = dark == ink ? paper : ink;
  float brightness = dot(colour, LUMINANCE);
  vec3 tone = mix(light, dark, smoothstep(0.30, 0.35, brightness));

  float zeroDistance = abs(f.x) / max(slope, 1e-20) / pixelRatio;
  float zeroSeen = smoothstep(LEAST_SLOPE, 4.0 * LEAST_SLOPE, slope * pixelRatio);

  float levels = abs(position) * STEPS;
  float levelSpacing = extent / (STEPS * max(slope * pixelRatio, 1e-20));
  float levelDistance = abs(levels - floor(levels + 0.5)) * levelSpacing;
  float levelSeen = levels < 0.5 || levels > STEPS - 0.5 ? 0.0 : smoothstep(5.0, 12.0, levelSpacing) * zeroSeen;
  float level = 0.16 * levelSeen * coverage(levelDistance * pixelRatio, 0.5 * pixelRatio);

  // A dark and a light stripe side by side: one of them stands out on any colour, and in grey.
  float diagonal = (gl_FragCoord.x + gl_FragCoord.y) * 0.70710678 / pixelRatio;
  float across = (fract(diagonal / hatchPeriod) - 0.5) * hatchPeriod;
  float hatchSeen = f.x < 0.0 ? max(zeroSeen, smoothstep(LEAST_VALUE, 4.0 * LEAST_VALUE, -f.x)) : 0.0;
  float darkStripe = 0.36 * hatchSeen * coverage(abs(across - 0.55) * pixelRatio, 0.55 * pixelRatio);
  float lightStripe = 0.3 * hatchSeen * coverage(abs(across + 0.55) * pixelRatio, 0.55 * pixelRatio);

  colour = mix(colour, tone, level);
  colour = mix(colour, light, lightStripe);
  colour = mix(colour, dark, darkStripe);

  // Within the heavy line's casing nothing but the neutral lies beside it.
  float casing = zeroSeen * coverage(zeroDistance * pixelRatio, 2.4 * pixelRatio);
  float zero = zeroSeen * coverage(zeroDistance * pixelRatio, 1.15 * pixelRatio);
  colour = mix(colour, neutral * shade, casing);
  colour = mix(colour, ink, zero);

  vec2 toBorder = min(p, 1.0 - p) / max(vec2(length(sSlope), length(tSlope)), 1e-20);
  float borderDistance = min(toBorder.x, toBorder.y);
  float fold = coverage(abs(turned) / max(length(turnedSlope), 1e-20), 1.8 * pixelRatio);
  float edge = coverage(borderDistance, 0.75 * pixelRatio);
  colour = mix(colour, paper, 0.55 * coverage(borderDistance, 1.6 * pixelRatio));
  colour = mix(colour, ink, max(edge, 0.7 * fold));

  float lines = opacity.z * max(max(0.9 * zero, 0.85 * edge), 0.5 * fold);
  float alpha = face == ${SECTION} ? 1.0 : max(f.x < 0.0 ? opacity.y : opacity.x, lines);
  fragment = vec4(colour * alpha, alpha);
}
`

/** The uniforms of the faces, which FaceRenderer writes. */
export function createFacesUniforms() {
  const steps = () => Array.from({ length: 6 }, () => new Vector4())
  return {
    vertices: { value: Array.from({ length: CORNER_COUNT }, () => new Vector3()) },
    bernstein: { value: new Float32Array(COEFFICIENT_COUNT) },
    negativeExtent: { value: 1 },
    positiveExtent: { value: 1 },
    neutral: { value: new Vector3() },
    negativeSteps: { value: steps() },
    positiveSteps: { value: steps() },
    ink: { value: new Vector3() },
    paper: { value: new Vector3() },
    eye: { value: new Vector3() },
    toLight: { value: new Vector3() },
    pixelRatio: { value: 1 },
    hatchPeriod: { value: HATCH_PERIOD },
    opacity: { value: new Vector3(1, 1, 1) },
  }
}

/** Writes the uniforms of the ramps. */
export function writeRamp({ neutral, negativeSteps, positiveSteps }: FacesUniforms, ramp: Ramp): void {
  neutral.value.fromArray(ramp.positive[0] as Rgb)
  for (const [{ value: steps }, stops] of [
    [negativeSteps, ramp.negative],
    [positiveSteps, ramp.positive],
  ] as const)
    for (let k = 0; k < RAMP_STEPS; k++)
      for (let channel = 0; channel < 3; channel++)
        steps[channel + (k < 4 ? 0 : 3)]?.setComponent(
          k % 4,
          (stops[k + 1]?.[channel] as number) - (stops[k]?.[channel] as number),
        )
}

export type FacesUniforms = ReturnType<typeof createFacesUniforms>

export function createFacesMaterial(uniforms: FacesUniforms): RawShaderMaterial {
  return new RawShaderMaterial({
    glslVersion: GLSL3,
    vertexShader,
    fragmentShader,
    uniforms,
    side: DoubleSide,
    premultipliedAlpha: true,
  })
}
