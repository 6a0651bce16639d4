/** The styles of the document that `--html` writes: light and dark on screens, light on paper. */
import type { Rgb, Theme } from '../scene/paint/colour-map'
import { flatFigureStyles, hex } from '../scene/paint/flat-figure'

interface Colours extends Theme {
  readonly muted: Rgb
  readonly line: Rgb
}

const LIGHT: Colours = {
  paper: rgb(0xfcfcfb),
  ink: rgb(0x1c1e21),
  negative: rgb(0xb2182b),
  positive: rgb(0x2166ac),
  neutral: rgb(0xeeeeeb),
  muted: rgb(0x5f646b),
  line: rgb(0xe4e5e3),
}

const DARK: Colours = {
  paper: rgb(0x17181a),
  ink: rgb(0xe9e9e6),
  negative: rgb(0xf4787a),
  positive: rgb(0x6cb2ff),
  neutral: rgb(0x373a3f),
  muted: rgb(0x9a9fa6),
  line: rgb(0x303336),
}

function rgb(colour: number): Rgb {
  return [(colour >> 16) / 255, ((colour >> 8) & 255) / 255, (colour & 255) / 255]
}

function properties(colours: Colours): string {
  return Object.entries(colours)
    .map(([name, colour]) => `--${name}:${hex(colour)};`)
    .join('')
}

export const STYLES = `
:root{${properties(LIGHT)}color-scheme:light}
${flatFigureStyles(LIGHT)}
@media screen and (prefers-color-scheme:dark){
:root{${properties(DARK)}color-scheme:dark}
${flatFigureStyles(DARK)}
}
html{background:var(--paper);color:var(--ink);font:15px/1.45 system-ui,-apple-system,"Segoe UI",Roboto,"Helvetica Neue",Arial,sans-serif;font-variant-numeric:tabular-nums}
body{max-width:60rem;margin:0 auto;padding:2.5rem 1.5rem}
h1,h2,h3,h4{margin:0;font-size:1rem;font-weight:650;line-height:1.3;text-wrap:pretty}
.headline{font-size:1.5rem}
h2.headline{font-size:1.25rem}
.part{margin:2rem 0 .5rem}
p,ul,dl{margin:0}
.name,.beside,footer{color:var(--muted);overflow-wrap:anywhere}
.file+.file,footer{margin-top:3rem;border-top:1px solid var(--line);padding-top:1.5rem}
.notes{margin-top:.75rem;padding-left:1.1rem;overflow-wrap:anywhere}
.histogram{display:block;width:100%;max-width:48rem;height:auto;overflow:visible}
.histogram text{fill:var(--muted);font-size:11px}
.histogram rect{fill:var(--positive)}
.histogram .negative rect:first-child{fill:var(--negative)}
.histogram .negative rect:last-of-type{fill:url(#hex-hatch)}
.histogram .axis{fill:none;stroke:var(--muted)}
.histogram .grid{fill:none;stroke:var(--line)}
.histogram .zero{fill:none;stroke:var(--ink);stroke-width:1.5}
table{border-collapse:collapse}
th,td{padding:.1rem 1rem .1rem 0;text-align:right;font-weight:400}
th{color:var(--muted)}
.histogram+.beside{margin-top:.5rem}
.cells{display:grid;grid-template-columns:repeat(auto-fill,minmax(min(100%,26rem),1fr));gap:0 2rem}
.cell{display:grid;grid-template-columns:11rem minmax(0,1fr);gap:0 1rem;border-top:1px solid var(--line);padding:.75rem 0;break-inside:avoid}
.cell h3,.cell h4,.cell .why,.cell details{grid-column:1/-1;overflow-wrap:anywhere}
.hex{display:block;width:100%;height:auto}
.hex-defs{position:absolute}
.cell dt{color:var(--muted);font-size:.8125rem}
.cell dd{margin:0 0 .25rem;overflow-wrap:anywhere}
.negative{color:var(--negative)}
b{font-weight:650}
summary{cursor:pointer;color:var(--muted);font-size:.8125rem}
details table{font-size:.8125rem}
@media (max-width:30rem){.cell{grid-template-columns:8rem minmax(0,1fr)}body{padding:1rem}.histogram text{font-size:18px}}
@media print{
html{background:none;font-size:9.5pt}
body{max-width:none;padding:0}
.cells{grid-template-columns:1fr 1fr}
.cell{grid-template-columns:8.5rem minmax(0,1fr)}
.part{break-after:avoid}
summary{display:none}
}
@page{margin:16mm 14mm}
`
