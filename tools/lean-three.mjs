// A Vite plugin: three.js without what a mesh with a shader of its own never reaches. WebGLRenderer
// carries the shaders of every built-in material with it (lights, shadows, environments, textures),
// and XR; Mesh carries what finds a ray's triangle, a material what writes it as JSON. No option of
// three.js leaves these out, and a bundler cannot see that nothing asks for them. So modules of
// three/src are whole ones of ours here, which saves 80 kB; no line of the others is edited.
// Only for builds, whose tests then run on it; `npm run dev` has three.js as it is.

import { existsSync, readdirSync, readFileSync } from 'node:fs'
import { basename, join } from 'node:path'
import { Failure, root } from './run.mjs'

const source = join(root, 'node_modules', 'three', 'src')

/**
 * Classes that are made and not asked for anything: there are no textures, no targets but the
 * canvas, nothing is sorted or culled by its bounds, and OrbitControls wants its ray only where it
 * does not pan in the plane of the screen.
 */
const idle = [
  'math/FrustumArray',
  'math/Plane',
  'math/Ray',
  'renderers/WebGLRenderTarget',
  'renderers/webgl/WebGLMorphtargets',
  'renderers/webgl/WebGLOutput',
  'textures/CubeDepthTexture',
  'textures/CubeTexture',
  'textures/Data3DTexture',
  'textures/DataArrayTexture',
  'textures/DepthTexture',
  'textures/Texture',
]

/** Stand-ins for modules of three/src: all that WebGLRenderer needs for a RawShaderMaterial. */
const standIns = {
  ...Object.fromEntries(idle.map(name => [`${name}.js`, `export class ${basename(name)} {}`])),
  'core/BufferGeometry.js': `
    import { EventDispatcher } from './EventDispatcher.js'
    let count = 0
    export class BufferGeometry extends EventDispatcher {
      isBufferGeometry = true
      id = count++
      index = null
      attributes = {}
      morphAttributes = {}
      drawRange = { start: 0, count: Infinity }
      setIndex(index) { this.index = index }
      getAttribute(name) { return this.attributes[name] }
      setAttribute(name, attribute) { this.attributes[name] = attribute }
      setDrawRange(start, count) { this.drawRange = { start, count } }
      dispose() { this.dispatchEvent({ type: 'dispose' }) }
    }`,
  'materials/ShaderMaterial.js': `
    import { EventDispatcher } from '../core/EventDispatcher.js'
    import { LessEqualDepth, NormalBlending } from '../constants.js'
    let count = 0
    export class ShaderMaterial extends EventDispatcher {
      isMaterial = true
      isShaderMaterial = true
      id = count++
      version = 0
      visible = true
      blending = NormalBlending
      transparent = false
      colorWrite = true
      depthFunc = LessEqualDepth
      depthTest = true
      depthWrite = true
      precision = null
      extensions = {}
      uniformsNeedUpdate = false
      constructor(values) {
        super()
        Object.assign(this, values)
      }
      onBeforeRender() {}
      onBeforeCompile() {}
      customProgramCacheKey() { return '' }
      dispose() { this.dispatchEvent({ type: 'dispose' }) }
    }`,
  // The faces are never culled: their vertices are where the shader puts them.
  'math/Frustum.js': `
    export class Frustum {
      setFromProjectionMatrix() { return this }
      intersectsObject() { return true }
    }`,
  'objects/Mesh.js': `
    import { Object3D } from '../core/Object3D.js'
    export class Mesh extends Object3D {
      isMesh = true
      constructor(geometry, material) {
        super()
        this.geometry = geometry
        this.material = material
      }
    }`,
  'renderers/shaders/DFGLUTData.js': 'export const getDFGLUT = () => null',
  'renderers/shaders/ShaderChunk.js': 'export const ShaderChunk = {}',
  'renderers/shaders/ShaderLib.js': 'export const ShaderLib = {}',
  'renderers/webgl/WebGLBackground.js': `
    import { Color } from '../../math/Color.js'
    export class WebGLBackground {
      #color = new Color(0)
      #alpha
      #write
      constructor(renderer, environments, state, objects, alpha, premultiplied) {
        this.#alpha = alpha ? 0 : 1
        this.#write = ({ r, g, b }, a) => state.buffers.color.setClear(r, g, b, a, premultiplied)
      }
      getClearColor() { return this.#color }
      getClearAlpha() { return this.#alpha }
      setClearColor(color, alpha = 1) {
        this.#color.set(color)
        this.setClearAlpha(alpha)
      }
      setClearAlpha(alpha) {
        this.#alpha = alpha
        this.#write(this.#color, alpha)
      }
      render() { this.#write(this.#color, this.#alpha) }
      addToRenderList() {}
      dispose() {}
    }`,
  'renderers/webgl/WebGLClipping.js': `
    export class WebGLClipping {
      numPlanes = 0
      numIntersection = 0
      init() { return false }
    }`,
  'renderers/webgl/WebGLEnvironments.js': `
    export class WebGLEnvironments {
      get() { return null }
      dispose() {}
    }`,
  'renderers/webgl/WebGLLights.js': `
    const kinds = ['sun', 'directional', 'point', 'spot', 'rectArea', 'hemi', 'spotLightMap']
    const shadows = ['sunShadowMap', 'directionalShadowMap', 'pointShadowMap', 'spotShadowMap']
    export class WebGLLights {
      state = {
        version: 0,
        numSpotLightShadowsWithMaps: 0,
        numLightProbes: 0,
        ...Object.fromEntries([...kinds, ...shadows].map(name => [name, []])),
      }
      setup() {}
      setupView() {}
    }`,
  'renderers/webgl/WebGLMaterials.js': `
    export class WebGLMaterials {
      refreshMaterialUniforms(uniforms, material) {
        material.uniformsNeedUpdate = false
      }
    }`,
  'renderers/webgl/WebGLShadowMap.js': `
    export class WebGLShadowMap {
      render() {}
    }`,
  'renderers/webgl/WebGLTextures.js': `
    export class WebGLTextures {
      resetTextureUnits() {}
      getTextureUnits() { return null }
      setTextureUnits() {}
    }`,
  'renderers/webgl/WebGLUniformsGroups.js': `
    export class WebGLUniformsGroups {
      dispose() {}
    }`,
  'renderers/webgl/WebGLUtils.js': `
    export class WebGLUtils {
      convert() {}
    }`,
  'renderers/webxr/WebXRManager.js': `
    export class WebXRManager {
      enabled = false
      isPresenting = false
      addEventListener() {}
      removeEventListener() {}
      setAnimationLoop() {}
      dispose() {}
    }`,
}

export const leanThree = {
  name: 'hexlens-lean-three',
  apply: 'build',
  enforce: 'pre',
  config: () => ({ define: { __THREE_DEVTOOLS__: 'undefined' } }),
  buildStart() {
    const missing = Object.keys(standIns).filter(name => !existsSync(join(source, name)))
    if (missing.length > 0) throw new Failure(`This three.js has no ${missing.join(', ')}: mend tools/lean-three.mjs.`)
  },
  /** The sources of three.js: its published file cannot be taken apart. */
  resolveId(id) {
    return id === 'three' ? join(source, 'Three.js') : null
  },
  load(id) {
    return id.startsWith(source) ? standIns[id.slice(source.length + 1)] : null
  },
}

/** Names by which three.js tells its classes, such as `isSkinnedMesh`: undefined where nothing of the class is left. */
export function classFlags() {
  const sources = readdirSync(source, { recursive: true }).filter(name => name.endsWith('.js'))
  const names = sources.flatMap(name =>
    readFileSync(join(source, name), 'utf8').match(/(?<=\.)is[A-Z]\w*(?= = true;)/g),
  )
  return new Set(names.filter(name => name !== null))
}
