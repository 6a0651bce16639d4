/**
 * The surface jacdet = 0 in space: the reference points of its vertices go to the shader, which maps them by the trilinear map of the
 * eight vertices, so that one mesh serves the element and the reference cube. Normals follow jacdet's gradient. The part on the
 * eye's side of the section is cut away.
 */
import { BufferAttribute, BufferGeometry, DoubleSide, GLSL3, Mesh, RawShaderMaterial, Vector3, Vector4 } from 'three'
import type { Surface } from '../../core/zero-surface'
import { VERTEX_COUNT, vertexReference } from '../../model/hexahedron'
import type { Section } from '../../views/scene-slices'
import type { Rgb, Theme } from './colour-map'
import type { FacesUniforms } from './faces-material'
import { LIGHT } from './shading'

const references = vertexReference.map(point => `vec3(${point.map(x => x.toFixed(1)).join(', ')})`).join(', ')

/**
 * With F's derivative D a normal n of the reference cube becomes cof(D) n. Where det D = 0, as here, cof(D) has rank one and the surface
 * is a fold of F, whose both sides are the same side in space: light falls on either side alike.
 */
const vertexShader = /* glsl */ `
precision highp float;
uniform vec3 vertices[${VERTEX_COUNT + 4}];
uniform mat4 modelViewMatrix;
uniform mat4 projectionMatrix;
in vec3 point;
in vec3 gradient;
out vec3 normal;
out vec3 seen;
out vec3 at;
const vec3 REFERENCES[${VERTEX_COUNT}] = vec3[](${references});

void main() {
  vec3 position = vec3(0.0);
  mat3 d = mat3(0.0);
  for (int v = 0; v < ${VERTEX_COUNT}; v++) {
    vec3 side = 2.0 * REFERENCES[v] - 1.0;
    vec3 weight = 1.0 - REFERENCES[v] + side * point;
    position += weight.x * weight.y * weight.z * vertices[v];
    d[0] += side.x * weight.y * weight.z * vertices[v];
    d[1] += weight.x * side.y * weight.z * vertices[v];
    d[2] += weight.x * weight.y * side.z * vertices[v];
  }
  vec3 outward = cross(d[1], d[2]) * gradient.x + cross(d[2], d[0]) * gradient.y + cross(d[0], d[1]) * gradient.z;
  vec4 eyed = modelViewMatrix * vec4(position, 1.0);
  normal = mat3(modelViewMatrix) * outward;
  seen = eyed.xyz;
  at = point;
  gl_Position = projectionMatrix * eyed;
}
`

const fragmentShader = /* glsl */ `
precision highp float;
in vec3 normal;
in vec3 seen;
in vec3 at;
out vec4 fragment;
uniform vec3 shade;
uniform vec3 hue;
uniform vec3 lit;
// Cut away is where dot(at, cut.xyz) > cut.w.
uniform vec4 cut;
const vec3 LIGHT = vec3(${LIGHT});

void main() {
  if (dot(at, cut.xyz) > cut.w) discard;
  float size = length(normal);
  // In a cusp, where the folds of F meet, the normal has no length, and the plane of the triangle stands in.
  vec3 n = size > 1e-9 ? normal / size : normalize(cross(dFdx(seen), dFdy(seen)));
  float light = dot(n.z < 0.0 ? -n : n, LIGHT);
  vec3 colour = light < 0.5 ? mix(shade, hue, max(light, 0.0) * 2.0) : mix(hue, lit, light * 2.0 - 1.0);
  fragment = vec4(colour, 1.0);
}
`

/** Shares of dark and light that the tones mix with the negative's hue. */
const SHADE = 0.55
const LIT = 0.62

export class ZeroSurfaceMesh {
  readonly mesh: Mesh
  readonly #uniforms
  readonly #material: RawShaderMaterial
  #geometry = new BufferGeometry()
  #surface: Surface | null = null
  /** The most vertices and indices that the geometry holds. */
  #capacity = { vertices: 0, indices: 0 }

  /** The vertices are the faces' own uniform. */
  constructor({ vertices }: FacesUniforms) {
    this.#uniforms = {
      vertices,
      shade: { value: new Vector3() },
      hue: { value: new Vector3() },
      lit: { value: new Vector3() },
      cut: { value: new Vector4() },
    }
    this.#material = new RawShaderMaterial({
      glslVersion: GLSL3,
      vertexShader,
      fragmentShader,
      uniforms: this.#uniforms,
      side: DoubleSide,
    })
    this.mesh = new Mesh(this.#geometry, this.#material)
    this.mesh.frustumCulled = false
    this.mesh.visible = false
  }

  /** Shows a surface, or none. */
  update(surface: Surface | null): void {
    this.mesh.visible = surface !== null && surface.triangles.length > 0
    if (surface === null || surface === this.#surface || !this.mesh.visible) return
    this.#surface = surface
    this.#grow(surface)
    this.#fill('point', surface.points)
    this.#fill('gradient', surface.gradients)
    const index = this.#geometry.index as BufferAttribute
    index.array.set(surface.triangles)
    index.needsUpdate = true
    this.#geometry.setDrawRange(0, surface.triangles.length)
  }

  /** Cuts away what lies above a section, or below it. */
  cut({ axis, value }: Section, side: 'above' | 'below'): void {
    const sign = side === 'above' ? 1 : -1
    const along = [0, 0, 0].with(axis, sign)
    this.#uniforms.cut.value.fromArray([...along, sign * value])
  }

  colour({ negative, ink, paper }: Theme): void {
    const [dark, light] = sum(ink) < sum(paper) ? [ink, paper] : [paper, ink]
    this.#uniforms.shade.value.fromArray(mix(negative, dark, SHADE))
    this.#uniforms.hue.value.fromArray(negative)
    this.#uniforms.lit.value.fromArray(mix(negative, light, LIT))
  }

  dispose(): void {
    this.#geometry.dispose()
    this.#material.dispose()
  }

  /** Makes another geometry, half as large again as need be, if this one is too small. */
  #grow({ points, triangles }: Surface): void {
    const { vertices, indices } = this.#capacity
    if (3 * vertices >= points.length && indices >= triangles.length) return
    this.#geometry.dispose()
    this.#capacity = { vertices: Math.ceil(points.length / 2), indices: Math.ceil(1.5 * triangles.length) }
    this.#geometry = new BufferGeometry()
    for (const name of ['point', 'gradient'])
      this.#geometry.setAttribute(name, new BufferAttribute(new Float32Array(3 * this.#capacity.vertices), 3))
    this.#geometry.setIndex(new BufferAttribute(new Uint32Array(this.#capacity.indices), 1))
    this.mesh.geometry = this.#geometry
  }

  #fill(name: string, values: Float64Array): void {
    const attribute = this.#geometry.getAttribute(name) as BufferAttribute
    attribute.array.set(values)
    attribute.needsUpdate = true
  }
}

function mix(a: Rgb, b: Rgb, way: number): [number, number, number] {
  return [a[0] + (b[0] - a[0]) * way, a[1] + (b[1] - a[1]) * way, a[2] + (b[2] - a[2]) * way]
}

function sum([r, g, b]: Rgb): number {
  return r + g + b
}
