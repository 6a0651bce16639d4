// A Vite plugin: three.js without what a mesh with a shader of its own never reaches. WebGLRenderer
// carries the shaders of every built-in material with it (lights, shadows, environments, textures),
// and XR; Mesh carries what finds a ray's triangle, a material what writes it as JSON. No option of
// three.js leaves these out, and a bundler cannot see that nothing asks for them. So modules of
// three/src are whole ones of ours here, which saves 90 kB; no line of the others is edited. What
// else nobody asks for, unread-members.mjs takes out of the package's files: another 8 kB.
// Only for builds, whose tests then run on it; `npm run dev` has three.js as it is.

import { existsSync, readdirSync, readFileSync } from 'node:fs'
import { basename, join } from 'node:path'
import { Failure, root } from './run.mjs'

const source = join(root, 'node_modules', 'three', 'src')

/**
 * Classes that are made and not asked for anything: there are no textures, no targets but the
 * canvas, and nothing is sorted or culled by its bounds.
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
  'math/Color.js': `
    export class Color {
      constructor(hex) { this.set(hex) }
      set(hex) {
        this.r = ((hex >> 16) & 255) / 255
        this.g = ((hex >> 8) & 255) / 255
        this.b = (hex & 255) / 255
      }
      copy({ r, g, b }) {
        Object.assign(this, { r, g, b })
        return this
      }
    }`,
  // What three.js has for colours that the shader gives as they are to be seen.
  'math/ColorManagement.js': `
    import { LinearSRGBColorSpace, SRGBColorSpace } from '../constants.js'
    export const SRGBToLinear = null
    export const ColorManagement = {
      workingColorSpace: LinearSRGBColorSpace,
      _getDrawingBufferColorSpace: () => SRGBColorSpace,
      _getUnpackColorSpace: () => SRGBColorSpace,
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
  'renderers/webgl/WebGLProgram.js': `
    import { error } from '../../utils.js'
    import { WebGLUniforms } from './WebGLUniforms.js'
    let count = 0
    export class WebGLProgram {
      id = count++
      usedTimes = 1
      #gl
      #shaders
      #uniforms
      #attributes
      constructor(gl, cacheKey, { glslVersion, vertexShader, fragmentShader }) {
        const program = gl.createProgram()
        const sources = [[gl.VERTEX_SHADER, vertexShader], [gl.FRAGMENT_SHADER, fragmentShader]]
        this.cacheKey = cacheKey
        this.program = program
        this.#gl = gl
        this.#shaders = sources.map(([type, source]) => {
          const shader = gl.createShader(type)
          gl.shaderSource(shader, '#version ' + glslVersion + '\\n' + source)
          gl.compileShader(shader)
          gl.attachShader(program, shader)
          return shader
        })
        gl.linkProgram(program)
      }
      // Asking for anything waits for the compiler, so that nothing is asked before the first use.
      #use() {
        const { program } = this
        const gl = this.#gl
        if (this.#uniforms) return
        if (!gl.getProgramParameter(program, gl.LINK_STATUS))
          error(gl.getProgramInfoLog(program), ...this.#shaders.map(shader => gl.getShaderInfoLog(shader)))
        for (const shader of this.#shaders) gl.deleteShader(shader)
        this.#uniforms = new WebGLUniforms(gl, program)
        this.#attributes = {}
        for (let i = gl.getProgramParameter(program, gl.ACTIVE_ATTRIBUTES); i-- > 0; ) {
          const { name, type } = gl.getActiveAttrib(program, i)
          this.#attributes[name] = { type, location: gl.getAttribLocation(program, name), locationSize: 1 }
        }
      }
      getUniforms() {
        this.#use()
        return this.#uniforms
      }
      getAttributes() {
        this.#use()
        return this.#attributes
      }
      destroy() {
        this.#gl.deleteProgram(this.program)
      }
    }`,
  // A program for each pair of shaders, whatever is drawn with it.
  'renderers/webgl/WebGLPrograms.js': `
    import { NoToneMapping } from '../../constants.js'
    import { WebGLProgram } from './WebGLProgram.js'
    export class WebGLPrograms {
      programs = []
      #renderer
      #bindingStates
      constructor(renderer, environments, extensions, capabilities, bindingStates) {
        this.#renderer = renderer
        this.#bindingStates = bindingStates
      }
      getParameters({ glslVersion, vertexShader, fragmentShader }) {
        return {
          glslVersion,
          vertexShader,
          fragmentShader,
          outputColorSpace: this.#renderer.outputColorSpace,
          toneMapping: NoToneMapping,
          morphTargets: false,
          morphNormals: false,
          morphColors: false,
          morphTargetsCount: 0,
          vertexAlphas: false,
          vertexTangents: false,
        }
      }
      getProgramCacheKey({ vertexShader, fragmentShader }) { return vertexShader + fragmentShader }
      getUniforms({ uniforms }) { return uniforms }
      acquireProgram(parameters, cacheKey) {
        const known = this.programs.find(program => program.cacheKey === cacheKey)
        if (known) {
          known.usedTimes++
          return known
        }
        const program = new WebGLProgram(this.#renderer.getContext(), cacheKey, parameters)
        this.programs.push(program)
        return program
      }
      releaseProgram(program) {
        if (--program.usedTimes > 0) return
        this.programs.splice(this.programs.indexOf(program), 1)
        this.#bindingStates.releaseStatesOfProgram(program)
        program.destroy()
      }
      releaseShaderCache() {}
    }`,
  'renderers/webgl/WebGLShadowMap.js': `
    export class WebGLShadowMap {
      render() {}
    }`,
  // All that is drawn has two sides, is where the depth is less or equal, or equal, and blends premultiplied colours or none.
  'renderers/webgl/WebGLState.js': `
    import { EqualDepth } from '../../constants.js'
    export class WebGLState {
      #gl
      #program = null
      constructor(gl) {
        this.#gl = gl
        this.buffers = {
          color: { setClear: (...colour) => gl.clearColor(...colour.slice(0, 4)), setMask() {} },
          depth: { getReversed: () => false, setTest() {}, setMask: isWritten => gl.depthMask(isWritten) },
          stencil: { setMask() {} },
        }
        gl.enable(gl.DEPTH_TEST)
        gl.depthFunc(gl.LEQUAL)
        gl.blendFunc(gl.ONE, gl.ONE_MINUS_SRC_ALPHA)
      }
      setMaterial({ transparent, depthWrite, depthFunc, colorWrite }) {
        const gl = this.#gl
        if (transparent) gl.enable(gl.BLEND)
        else gl.disable(gl.BLEND)
        gl.depthFunc(depthFunc === EqualDepth ? gl.EQUAL : gl.LEQUAL)
        gl.depthMask(depthWrite)
        gl.colorMask(colorWrite, colorWrite, colorWrite, colorWrite)
      }
      setPolygonOffset() {}
      useProgram(program) {
        if (program === this.#program) return false
        this.#gl.useProgram(program)
        this.#program = program
        return true
      }
      viewport({ x, y, z, w }) { this.#gl.viewport(x, y, z, w) }
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
