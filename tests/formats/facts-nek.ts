/** Facts of Nek5000's meshes. */
import { CUBE, type FormatFacts, fact, ONE } from './fact'

const axes = [0, 1, 2].map(axis => [0, 1, 2, 3, 4, 5, 6, 7].map(v => CUBE[3 * v + axis] as number))
const lines = [0, 4].flatMap(first => axes.map(values => values.slice(first, first + 4).join('  ')))
const counts = (count: number, dimensions = 3) => `${count} ${dimensions} ${count}  NEL,NDIM,NELV\n`
const rea = (elements: number, behind: string) => ({
  'a.rea': ` ****** PARAMETERS *****\n 0 PARAMETERS FOLLOW\n  **MESH DATA** 6 lines are X,Y,Z;X,Y,Z. Columns corners 1-4;5-8\n${behind}${` ELEMENT 7 [ 1a] GROUP 0\n${lines.join('\n')}\n`.repeat(elements)}`,
})
const sides = (count: number) =>
  `  ***** CURVED SIDE DATA *****\n ${count} Curved sides follow IEDGE,IEL,CURVE(I),I=1,5, CCURVE\n`
const whole = (count: number) => ({ 'a.rea': `${rea(1, counts(1))['a.rea']}${sides(count)}` })

/** Version 1 has floats, later ones have doubles. */
function re2(version: 1 | 2, isLittleEndian: boolean, dimensions = 3) {
  const size = version === 1 ? 4 : 8
  const view = new DataView(new ArrayBuffer(84 + 26 * size))
  const header = `#v00${version} 1 ${dimensions} 1 this is the hdr`.padEnd(80)
  for (let i = 0; i < 80; i++) view.setUint8(i, header.charCodeAt(i))
  view.setFloat32(80, 6.54321, isLittleEndian)
  for (const [i, value] of [0, ...axes.flat()].entries())
    view[size === 4 ? 'setFloat32' : 'setFloat64'](84 + size * i, value, isLittleEndian)
  return new Uint8Array(view.buffer)
}

export const nekFacts: readonly FormatFacts[] = [
  {
    format: 'Nek5000',
    read: [
      fact('`.rea`', [whole(0), { 'a.txt': ` ELEMENT 7 [ 1 ] GROUP 0\n${lines.join('\n')}\n` }], { ...ONE, ids: [7] }),
      fact('`.re2`, bytes in either order', [{ 'a.re2': re2(2, true) }, { 'a.re2': re2(2, false) }], {
        ...ONE,
        ids: [1],
      }),
      fact('its first version in `Float32`', { 'a.re2': re2(1, true) }, { ...ONE, note: /Float32/ }),
      fact('curved sides as straight ones, with a note', whole(3), { ...ONE, note: /curves 3 sides/ }),
    ],
    notRead: [
      fact(
        'meshes of two dimensions are refused',
        [{ 'a.re2': re2(2, true, 2) }, rea(0, counts(1, 2))],
        /two dimensions has no hexahedra/,
      ),
      fact('`.rea` without elements is refused', rea(0, counts(-4)), /in the file of the same name with \.re2/),
      fact(
        'a file that is cut is refused',
        [
          { 'a.re2': re2(2, true).subarray(0, 200) },
          rea(1, counts(2)),
          { 'a.rea': `${rea(1, counts(2))['a.rea']}${sides(0)}` },
        ],
        /the file ends|2 elements are declared, and 1 are there/,
      ),
    ],
  },
]
