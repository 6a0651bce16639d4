/** Imports go down only, and never in a circle: `npm run check` looks. */

// From the top to the bottom; folders in one line stand side by side. What is not in a layer of web/ is not looked at.
const layers = [
  ['pages', 'package'],
  ['mesh-element'],
  ['cli', 'element'],
  ['mesh-views'],
  ['panels'],
  ['mesh-scene'],
  ['survey'],
  ['outputs'],
  ['scene'],
  ['views'],
  ['input'],
  ['mesh'],
  ['core'],
  ['model'],
  ['words'],
]

// The same in the scene; its own files are above them.
const sceneLayers = ['input', 'overlay', 'paint', 'space']

const folders = names => names.map(name => `^web/${name}/`).join('|')

module.exports = {
  forbidden: [
    { name: 'no-circle', severity: 'error', from: {}, to: { circular: true } },
    ...layers.slice(1).map((names, i) => ({
      name: `${names[0]}-imports-down`,
      severity: 'error',
      from: { path: folders(names) },
      to: { path: folders(layers.slice(0, i + 1).flat()) },
    })),
    ...layers.flatMap(names =>
      names.flatMap(name => {
        const others = names.filter(other => other !== name)
        return others.length === 0 || name === 'package'
          ? []
          : {
              name: `${name}-stands-alone`,
              severity: 'error',
              from: { path: folders([name]) },
              to: { path: folders(others) },
            }
      }),
    ),
    ...sceneLayers.map((name, i) => ({
      name: `scene-${name}-imports-down`,
      severity: 'error',
      from: { path: `^web/scene/${name}/` },
      to: { path: '^web/scene/', pathNot: `^web/scene/(${sceneLayers.slice(i).join('|')})/` },
    })),
  ],
  options: {
    parser: 'swc', // TypeScript 7 has no interface that others could use
    tsPreCompilationDeps: true, // types count
    exclude: { path: '^build/|node_modules' },
    enhancedResolveOptions: { extensions: ['.ts', '.js', '.json'] },
  },
}
