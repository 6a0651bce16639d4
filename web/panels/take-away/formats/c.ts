/** A C array in hexadecimal floats, exact with any compiler; decimals are beside them. */
import { decimalText, pointsOf, type Writer } from '../../../model/written-element'

export const c: Writer = {
  title: 'C',
  note: 'array of hexadecimal floats, exact',
  extension: 'c',
  mediaType: 'text/x-c',
  write(vertices) {
    const rows = pointsOf(vertices).map(
      (point, v) => `  ${point.map(hexadecimal).join(', ')}, /* ${v}: ${point.map(decimalText).join(', ')} */`,
    )
    return [
      '/* VTK_HEXAHEDRON order: x, y, z of vertices 0 to 7 */',
      'double vertices[24] = {',
      ...rows,
      '};',
      '',
    ].join('\n')
  },
}

const FRACTION_DIGITS = 13
const words = new DataView(new ArrayBuffer(8))

/** A finite double as C's %a prints it: sign, 1.fraction (0. for subnormals), exponent of 2. */
export function hexadecimal(value: number): string {
  words.setFloat64(0, value)
  const bits = words.getBigUint64(0)
  const sign = bits >> 63n ? '-' : ''
  const biased = Number((bits >> 52n) & 0x7ffn)
  const fraction = (bits & 0xf_ffff_ffff_ffffn).toString(16).padStart(FRACTION_DIGITS, '0').replace(/0+$/, '')
  if (biased === 0 && fraction === '') return `${sign}0x0p+0`
  const power = biased === 0 ? -1022 : biased - 1023
  return `${sign}0x${biased === 0 ? 0 : 1}${fraction && `.${fraction}`}p${power < 0 ? '' : '+'}${power}`
}
