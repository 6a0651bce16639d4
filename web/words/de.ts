/** German. No native speaker has read it yet. */
import type { Dictionary } from './say'

export const german: Dictionary = {
  ', ': ', ',
  ', and ': ', sowie ',
  '0 to 7, or [ and ]': '0 bis 7, oder [ und ]',
  '12 edges': '12 Kanten',
  '1e30: to Verdict an edge or axis has no length': '1e30: Für Verdict hat eine Kante oder Achse keine Länge',
  '2×2×2 Gauss points': '2×2×2 Gauß-Punkte',
  '3×3×3 Gauss points': '3×3×3 Gauß-Punkte',
  '6 faces': '6 Flächen',
  '8 vertices': '8 Ecken',
  'A and B are the same element. Move a vertex, or keep this one as A and choose another preset.':
    'A und B sind dasselbe Element. Bewegen Sie eine Ecke, oder behalten Sie dieses als A und wählen Sie ein anderes Beispiel.',
  'A block like any other, and all eight vertices are positive; yet along two edges of its top jacdet is negative.':
    'Ein Block wie jeder andere, und alle acht Ecken sind positiv; doch entlang zweier Kanten oben ist jacdet negativ.',
  'A check accepts an element if its number is above zero. Point at a row, and the scene marks what it looks at.':
    'Eine Prüfung nimmt ein Element an, wenn ihre Zahl größer als null ist. Zeigen Sie auf eine Zeile, und die Szene markiert, was sie betrachtet.',
  'A good block with its points in deal.II’s order instead of this page’s: jacdet is negative at four vertices until Node order puts them right.':
    'Ein guter Block, dessen Punkte in der Reihenfolge von deal.II statt in der dieser Seite stehen: jacdet ist an vier Ecken negativ, bis „Knotenreihenfolge“ sie ordnet.',
  'A hexahedron': 'Ein Hexaeder',
  'A hexahedron has 24 coordinates; none were given.': 'Ein Hexaeder hat 24 Koordinaten; es wurden keine angegeben.',
  'A hexahedron has 24 coordinates; {count} were given.': 'Ein Hexaeder hat 24 Koordinaten; angegeben wurden {count}.',
  'A lower bound of jacdet, by four tangents in two variables. If it is positive, it certifies the element. Otherwise it says nothing.':
    'Eine untere Schranke von jacdet, durch vier Tangenten in zwei Variablen. Ist sie positiv, so bestätigt sie das Element. Sonst sagt sie nichts.',
  'A number is missing.': 'Es fehlt eine Zahl.',
  'a pyramid stored as a hexahedron': 'eine als Hexaeder gespeicherte Pyramide',
  'a side of the box': 'eine Seite des Kastens',
  'a tetrahedron stored as a hexahedron': 'ein als Hexaeder gespeichertes Tetraeder',
  'A valid hexahedron': 'Ein gültiges Hexaeder',
  'a wedge stored as a hexahedron': 'ein als Hexaeder gespeicherter Keil',
  'a witness: J ≤ {bound} there': 'einen Zeugen: J ≤ {bound} dort',
  'A, D, W, S': 'A, D, W, S',
  'Accepted by': 'Angenommen von',
  accepts: 'nimmt an',
  agrees: 'stimmt überein',
  'Algorithm 1': 'Algorithmus 1',
  'Algorithm 1, step by step': 'Algorithmus 1, Schritt für Schritt',
  'All eight vertices and all twelve edges are positive; in the middle of two faces jacdet is negative.':
    'Alle acht Ecken und alle zwölf Kanten sind positiv; mitten auf zwei Flächen ist jacdet negativ.',
  'All eight vertices are positive; on an edge between two of them jacdet is negative.':
    'Alle acht Ecken sind positiv; auf einer Kante zwischen zweien ist jacdet negativ.',
  'All faces': 'Alle Flächen',
  'All steps': 'Alle Schritte',
  'An invalid hexahedron': 'Ein ungültiges Hexaeder',
  'and in the reference cube': 'und im Referenzwürfel',
  'and {count} more, all in the file': 'und {count} weitere, alle in der Datei',
  Another: 'Noch eines',
  answer: 'Antwort',
  'array of hexadecimal floats, exact': 'Array hexadezimaler Gleitkommazahlen, exakt',
  'Arrow keys': 'Pfeiltasten',
  'Arrow keys move the point over the section. Escape removes it.':
    'Pfeiltasten bewegen den Punkt über den Schnitt. Escape entfernt ihn.',
  'Arrow keys move the point over this face. Escape removes it. Enter shows the face’s quartic.':
    'Pfeiltasten bewegen den Punkt über diese Fläche. Escape entfernt ihn. Die Eingabetaste zeigt die Quartik der Fläche.',
  'as it is: {verdict}': 'wie es ist: {verdict}',
  'as the page’s': 'wie die Seite',
  'at the top of the page, page.mdx': 'an den Anfang der Seite, page.mdx',
  'at the top of the page, page.qmd': 'an den Anfang der Seite, page.qmd',
  'at vertex {name}': 'an Ecke {name}',
  'at vertex {name}, {point}': 'an Ecke {name}, {point}',
  'at {point}': 'bei {point}',
  'AVS UCD': 'AVS UCD',
  Back: 'Zurück',
  'Best place of a vertex': 'Bester Ort einer Ecke',
  'between {lower} and {upper}': 'zwischen {lower} und {upper}',
  Block: 'Block',
  'Both start at one upright edge; the bottom goes round against the top.':
    'Beide beginnen an einer aufrechten Kante; der Boden läuft gegen den Deckel.',
  'Both the other way round': 'Beide andersherum',
  'Bottom and top are exchanged: jacdet is −1 everywhere. The usual cause is another order of the nodes.':
    'Boden und Deckel sind vertauscht: jacdet ist überall −1. Die übliche Ursache ist eine andere Reihenfolge der Knoten.',
  'Bottom and top go round the other way, which turns the element inside out.':
    'Boden und Deckel laufen andersherum; das stülpt das Element um.',
  'Bottom the other way round': 'Boden andersherum',
  bound: 'Schranke',
  'Boundary minimum and volume minimum': 'Minimum auf dem Rand und im Volumen',
  'Boundary minimum from A, {first}, to B, {last}; no change of the verdict was found':
    'Minimum auf dem Rand von A, {first}, bis B, {last}; keine Änderung des Urteils wurde gefunden',
  'Boundary minimum from A, {first}, to B, {last}; the verdict changes at tau {changes}':
    'Minimum auf dem Rand von A, {first}, bis B, {last}; das Urteil ändert sich bei tau {changes}',
  'Bring the element into view (F)': 'Das Element ins Bild holen (F)',
  by: 'durch',
  'By upright edges': 'Nach aufrechten Kanten',
  'By upright edges, downwards': 'Nach aufrechten Kanten, abwärts',
  Cancel: 'Abbrechen',
  'Candidate {place}: J = {value}': 'Kandidat {place}: J = {value}',
  'Candidate, {part}: jacdet {jacdet}. {point}. {position}.': 'Kandidat, {part}: jacdet {jacdet}. {point}. {position}.',
  'Candidates for the minimum': 'Kandidaten für das Minimum',
  'Cannot be changed by readers': 'Von Lesern nicht änderbar',
  'cannot tell': 'weiß nicht',
  Cell: 'Zelle',
  'Cell {cell} cannot be shown: {why}.': 'Zelle {cell} kann nicht gezeigt werden: {why}.',
  'Cell {cell}, {verdict}': 'Zelle {cell}, {verdict}',
  'Cell {cell}, {verdict}, relative minimum {minimum}': 'Zelle {cell}, {verdict}, relatives Minimum {minimum}',
  'Cell {cell}, {verdict}, {answer}': 'Zelle {cell}, {verdict}, {answer}',
  'Cell {cell}, {verdict}, {answer}, block {block}': 'Zelle {cell}, {verdict}, {answer}, Block {block}',
  'Cell {cell}:': 'Zelle {cell}:',
  Cells: 'Zellen',
  'Cells in the picture': 'Zellen im Bild',
  'Cells, worst first': 'Zellen, schlechteste zuerst',
  'Certain by': 'Sicher durch',
  certifies: 'bestätigt',
  'Changed from “{preset}”.': 'Geändert aus „{preset}“.',
  Check: 'Prüfung',
  'Checks that accept the cell': 'Prüfungen, die die Zelle annehmen',
  'choose a vertex': 'wählen eine Ecke',
  'Choose one to look at it.': 'Wählen Sie eine, um sie anzusehen.',
  Class: 'Klasse',
  'Close the list': 'Liste schließen',
  collapsed: 'zusammengefallen',
  'Collapsed to a wedge': 'Zum Keil zusammengefallen',
  Colours: 'Farben',
  'Colours of jacdet: maximum {maximum}, zero, minimum {minimum}':
    'Farben von jacdet: Maximum {maximum}, null, Minimum {minimum}',
  'conf.py': 'conf.py',
  'Coordinate {index} is {value}, not a finite number.': 'Koordinate {index} ist {value}, keine endliche Zahl.',
  Copied: 'Kopiert',
  'Copied {title}': '{title} kopiert',
  'Copied: {what}.': 'Kopiert: {what}.',
  Copy: 'Kopieren',
  'Copy embed': 'Zum Einbetten kopieren',
  'Copy JSON': 'JSON kopieren',
  'Copy link': 'Link kopieren',
  'Copy point and value': 'Punkt und Wert kopieren',
  'Copy {text}': '{text} kopieren',
  'Copy {text}. {means}': '{text} kopieren. {means}',
  'Copy {title}': '{title} kopieren',
  'Copy: {what}': 'Kopieren: {what}',
  'Copying is not allowed here. Download gives the same.':
    'Kopieren ist hier nicht erlaubt. Herunterladen gibt dasselbe.',
  'Copying is not allowed here:': 'Kopieren ist hier nicht erlaubt:',
  'Corners and centre': 'Ecken und Mitte',
  'VTK’s scaled Jacobian': 'Scaled Jacobian von VTK',
  'Cube inside out': 'Umgestülpter Würfel',
  Custom: 'Eigenes',
  dark: 'dunkel',
  'deal.II': 'deal.II',
  'deal.II, DOLFINx, VTK_VOXEL': 'deal.II, DOLFINx, VTK_VOXEL',
  'Deciding the cells of {name} …': 'Die Zellen von {name} werden entschieden …',
  degenerate: 'entartet',
  Depth: 'Tiefe',
  'Description, for screen readers and in the picture’s place':
    'Beschreibung, für Vorleseprogramme und anstelle des Bildes',
  Dismiss: 'Schließen',
  'Done. Every value is positive: the element is valid.': 'Fertig. Jeder Wert ist positiv: Das Element ist gültig.',
  'Done: the boundary minimum is {minimum}.': 'Fertig: Das Minimum auf dem Rand ist {minimum}.',
  Download: 'Herunterladen',
  'Download {file}': '{file} herunterladen',
  'Download {title}': '{title} herunterladen',
  'Drag a handle': 'Einen Griff ziehen',
  'Drag elsewhere': 'Anderswo ziehen',
  'Drag or the arrow keys turn it, plus and minus zoom, F fits. Point at a face, or tap it, and the same point is marked in space. P points at the minimizer, then at one candidate after another.':
    'Ziehen oder die Pfeiltasten drehen ihn, Plus und Minus zoomen, F passt ein. Zeigen Sie auf eine Fläche, oder tippen Sie sie an, und derselbe Punkt wird im Raum markiert. P zeigt auf den Ort des Minimums, dann auf einen Kandidaten nach dem anderen.',
  'Drags are held to': 'Ziehen wird gehalten an',
  'Each sign is that of whole numbers, the Bernstein coefficients on the interval. If jacdet is positive on the six faces, it is positive everywhere: Knupp’s conjecture, now a theorem ({paper}).':
    'Jedes Vorzeichen ist das ganzer Zahlen, der Bernstein-Koeffizienten auf dem Intervall. Ist jacdet auf den sechs Flächen positiv, so ist es überall positiv: Knupps Vermutung, jetzt ein Satz ({paper}).',
  edge: 'Kante',
  'edge candidate': 'Kantenkandidat',
  'Edge {name}': 'Kante {name}',
  'edge {name}': 'Kante {name}',
  'Edges fine, a face is not': 'Kanten gut, eine Fläche nicht',
  'Eight corners': 'Acht Ecken',
  'error bounds: all J ≥ {bound}': 'Fehlerschranken: überall J ≥ {bound}',
  Escape: 'Escape',
  'Every face’s quartic is solved.': 'Die Quartik jeder Fläche wird gelöst.',
  'exact arithmetic, not doubles': 'exakte Arithmetik, nicht Doubles',
  exactly: 'genau',
  Face: 'Fläche',
  face: 'Fläche',
  'face candidate': 'Flächenkandidat',
  'Face maps': 'Flächenkarten',
  'Face {name}': 'Fläche {name}',
  'face {name}': 'Fläche {name}',
  'Face {name} alone': 'Nur Fläche {name}',
  'Face {name}, vertices {vertices}': 'Fläche {name}, Ecken {vertices}',
  'Faces shown': 'Gezeigte Flächen',
  'Faces that their Bernstein bounds rule out are skipped.':
    'Flächen, die ihre Bernstein-Schranke ausschließt, werden übersprungen.',
  'Fetching {name} …': '{name} wird geholt …',
  Find: 'Gesucht',
  First: 'Anfang',
  'First invalid': 'Zuerst ungültig',
  Fit: 'Einpassen',
  flat: 'flach',
  For: 'Für',
  'Forget both': 'Beide vergessen',
  'Forget it': 'Vergessen',
  Forward: 'Weiter',
  'Four tangents': 'Vier Tangenten',
  Go: 'Los',
  'Go to cell': 'Gehe zu Zelle',
  'Go to index': 'Gehe zu Index',
  'Go to the minimum': 'Zum Minimum',
  'Go to the minimum inside': 'Zum Minimum im Inneren',
  Grid: 'Raster',
  Height: 'Höhe',
  Help: 'Hilfe',
  Hexahedron: 'Hexaeder',
  'Hexlens reads {formats}, gzipped or not; code, tables and logs with eight points in them, a link or a PNG taken away from here.':
    'Hexlens liest {formats}, gzip-gepackt oder nicht; Programmcode, Tabellen und Protokolle mit acht Punkten darin, einen Link oder ein von hier mitgenommenes PNG.',
  'Hide the proof': 'Beweis verbergen',
  HXT: 'HXT',
  'in a cell': 'in eine Zelle',
  'in a page, index.md': 'in eine Seite, index.md',
  'in a page, index.rst': 'in eine Seite, index.rst',
  'in practice': 'in der Praxis',
  'in s jacdet falls or is concave, so it is nowhere below its lower end.':
    'in s fällt jacdet oder ist konkav, also ist es nirgends kleiner als an seinem tieferen Ende.',
  'in s jacdet is a parabola that never reaches zero.': 'in s ist jacdet eine Parabel, die null nie erreicht.',
  'in s jacdet rises or is concave, so it is nowhere below its lower end.':
    'in s steigt jacdet oder ist konkav, also ist es nirgends kleiner als an seinem tieferen Ende.',
  'in the body': 'in den Rumpf',
  'in the element': 'im Element',
  'in the head': 'in den Kopf',
  'in the next cell': 'in die nächste Zelle',
  'In the order “{order}” it is valid.': 'In der Reihenfolge „{order}“ ist es gültig.',
  'in the page': 'in die Seite',
  'In the whole element': 'Im ganzen Element',
  Index: 'Index',
  Inside: 'Innen',
  inside: 'im Inneren',
  'inside out': 'umgestülpt',
  intervals: 'Intervalle',
  'Intervals of each face': 'Intervalle jeder Fläche',
  INVALID: 'UNGÜLTIG',
  Invalid: 'Ungültig',
  invalid: 'ungültig',
  'Invalid at every place tried from A to B: no change of the verdict was found.':
    'Ungültig an jedem versuchten Ort von A bis B: Keine Änderung des Urteils wurde gefunden.',
  'Invalid cells': 'Ungültige Zellen',
  inverted: 'umgestülpt',
  'it is not on the page': 'es ist nicht auf der Seite',
  'its Bernstein bound {bound} is below M\u00a0=\u00a0{m}; {outcome}':
    'die Bernstein-Schranke {bound} liegt unter M\u00a0=\u00a0{m}; {outcome}',
  'its Bernstein bound {bound} is not positive; {outcome}':
    'die Bernstein-Schranke {bound} ist nicht positiv; {outcome}',
  'Its bound {bound} alone settles this face. The quartic is not needed, but shown.':
    'Die Schranke {bound} allein entscheidet diese Fläche. Die Quartik wird nicht gebraucht, aber gezeigt.',
  'Its bound {bound} decides nothing, so the quartic is needed.':
    'Die Schranke {bound} entscheidet nichts, also wird die Quartik gebraucht.',
  'Its bound {bound} is not below the least value so far, so this face has no lower minimum. The quartic is not needed, but shown.':
    'Die Schranke {bound} liegt nicht unter dem kleinsten Wert bisher, also hat diese Fläche kein kleineres Minimum. Die Quartik wird nicht gebraucht, aber gezeigt.',
  'Its bound {bound} shows that the face is positive. It is below {minimum}, the least value so far, so the minimum needs the quartic.':
    'Die Schranke {bound} zeigt, dass die Fläche positiv ist. Sie liegt unter {minimum}, dem kleinsten Wert bisher, also braucht das Minimum die Quartik.',
  'its parabola opens downwards, so its least value is at an end, a vertex already seen':
    'die Parabel öffnet sich nach unten, also liegt der kleinste Wert an einem Ende, einer schon betrachteten Ecke',
  'its parabola opens upwards with its vertex inside, at {place}; {comparison}':
    'die Parabel öffnet sich nach oben, ihr Scheitel liegt im Inneren, bei {place}; {comparison}',
  'its parabola opens upwards, but its vertex is not strictly inside, so its least value is at an end, a vertex already seen':
    'die Parabel öffnet sich nach oben, aber ihr Scheitel liegt nicht im Inneren, also liegt der kleinste Wert an einem Ende, einer schon betrachteten Ecke',
  'its quartic gives one point, (ξ, η, ζ) = {point}; {comparison}':
    'die Quartik liefert einen Punkt, (ξ, η, ζ) = {point}; {comparison}',
  'its quartic gives {count} points with J\u00a0=\u00a0{values}; of the least, {comparison}':
    'die Quartik liefert {count} Punkte mit J\u00a0=\u00a0{values}; vom kleinsten: {comparison}',
  'its quartic has no root in (0, 1), so nothing inside can be the minimum':
    'die Quartik hat keine Nullstelle in (0, 1), also kann nichts im Inneren das Minimum sein',
  'its quartic has one root in (0, 1), but there no parabola opens upwards with its vertex inside':
    'die Quartik hat eine Nullstelle in (0, 1), doch dort öffnet sich keine Parabel nach oben mit dem Scheitel im Inneren',
  'its quartic has {count} roots in (0, 1), but there no parabola opens upwards with its vertex inside':
    'die Quartik hat {count} Nullstellen in (0, 1), doch dort öffnet sich keine Parabel nach oben mit dem Scheitel im Inneren',
  'its quartic is identically zero, so the edges, already seen, suffice':
    'die Quartik ist identisch null, also genügen die Kanten, die schon betrachtet sind',
  'J < 0 everywhere: the element is inverted. The usual cause is a mirrored node order.':
    'J < 0 überall: Das Element ist umgestülpt. Die übliche Ursache ist eine gespiegelte Knotenreihenfolge.',
  'J = 0 everywhere: the element is collapsed.': 'J = 0 überall: Das Element ist zusammengefallen.',
  'J = {value} at {point}': 'J = {value} bei {point}',
  'J > 0 at all eight vertices, yet J ≤ 0 on edge {names}.': 'J > 0 an allen acht Ecken, doch J ≤ 0 auf Kante {names}.',
  'J > 0 at all eight vertices, yet J ≤ 0 on edges {names}.':
    'J > 0 an allen acht Ecken, doch J ≤ 0 auf den Kanten {names}.',
  'J > 0 at all vertices and on all edges, yet J ≤ 0 on face {names}.':
    'J > 0 an allen Ecken und auf allen Kanten, doch J ≤ 0 auf Fläche {names}.',
  'J > 0 at all vertices and on all edges, yet J ≤ 0 on faces {names}.':
    'J > 0 an allen Ecken und auf allen Kanten, doch J ≤ 0 auf den Flächen {names}.',
  'J > 0 on all six faces, so J > 0 everywhere (Knupp’s conjecture, now a theorem).':
    'J > 0 auf allen sechs Flächen, also J > 0 überall (Knupps Vermutung, jetzt ein Satz).',
  'J > 0 on the boundary, so J > 0 everywhere. By the theorem nothing inside is lower.':
    'J > 0 auf dem Rand, also J > 0 überall. Nach dem Satz ist nichts im Inneren kleiner.',
  'J is jacdet: the map’s change of volume at a point.':
    'J ist jacdet: die Volumenänderung der Abbildung an einem Punkt.',
  'J is zero nowhere inside, so there is no surface J = 0.':
    'J ist im Inneren nirgends null, also gibt es keine Fläche J = 0.',
  'J now': 'J jetzt',
  'J there': 'J dort',
  'J ≤ 0 at all eight vertices.': 'J ≤ 0 an allen acht Ecken.',
  'J ≤ 0 at vertex {names}.': 'J ≤ 0 an Ecke {names}.',
  'J ≤ 0 at vertices {names}.': 'J ≤ 0 an den Ecken {names}.',
  'J ≥ 0 on the boundary, yet inside it falls to {least}. Zero is not enough: valid means more than zero.':
    'J ≥ 0 auf dem Rand, doch im Inneren fällt es auf {least}. Null genügt nicht: Gültig heißt mehr als null.',
  'J ≥ 0 on the boundary, yet J < 0 inside. The theorem needs J > 0 on the boundary: zero is not enough.':
    'J ≥ 0 auf dem Rand, doch J < 0 im Inneren. Der Satz braucht J > 0 auf dem Rand: Null genügt nicht.',
  'jacdet in all digits, on the cube chosen': 'jacdet in allen Ziffern, auf dem gewählten Würfel',
  'jacdet is 1 everywhere.': 'jacdet ist überall 1.',
  'jacdet is linear along it, so its least value is at an end, a vertex already seen':
    'jacdet ist dort linear, also liegt der kleinste Wert an einem Ende, einer schon betrachteten Ecke',
  'jacdet on [0,1]³': 'jacdet auf [0,1]³',
  'jacdet on [−1,1]³': 'jacdet auf [−1,1]³',
  'JSON, every number of it': 'JSON, mit jeder Zahl',
  'J\u00a0=\u00a0{now} is below M in digits not shown, and M becomes that':
    'J\u00a0=\u00a0{now} liegt in nicht gezeigten Ziffern unter M, und M wird dies',
  'J\u00a0=\u00a0{now} is below M\u00a0=\u00a0{m}, so M becomes {now}':
    'J\u00a0=\u00a0{now} liegt unter M\u00a0=\u00a0{m}, also wird M zu {now}',
  'J\u00a0=\u00a0{now} is not below M\u00a0=\u00a0{m}': 'J\u00a0=\u00a0{now} liegt nicht unter M\u00a0=\u00a0{m}',
  'J\u00a0=\u00a0{now} is not positive': 'J\u00a0=\u00a0{now} ist nicht positiv',
  'J\u00a0=\u00a0{now} is positive': 'J\u00a0=\u00a0{now} ist positiv',
  'J\u00a0=\u00a0{now} is what M is already': 'J\u00a0=\u00a0{now} ist M schon',
  'J\u00a0=\u00a0{now}, the first value, so M\u00a0=\u00a0{now}':
    'J\u00a0=\u00a0{now}, der erste Wert, also M\u00a0=\u00a0{now}',
  'Keep as {name}': 'Als {name} behalten',
  'Keep this view': 'Diese Ansicht behalten',
  kept: 'behalten',
  'Knabner, Korotov, Summ': 'Knabner, Korotov, Summ',
  Last: 'Ende',
  'Last valid': 'Zuletzt gültig',
  'leaves it open': 'lässt es offen',
  'legacy file with one VTK_HEXAHEDRON': 'Datei im alten Format mit einem VTK_HEXAHEDRON',
  'length³': 'Länge³',
  Lexicographic: 'Lexikografisch',
  'Lexicographic, last coordinate fastest': 'Lexikografisch, letzte Koordinate am schnellsten',
  light: 'hell',
  'linear image, enlarged': 'lineares Bild, vergrößert',
  Link: 'Link',
  'Link copied': 'Link kopiert',
  'Link views': 'Ansichten koppeln',
  'Looks fine, is not': 'Sieht gut aus, ist es nicht',
  M: 'M',
  'M over the steps, from {first} down to {last}': 'M über die Schritte, von {first} hinab zu {last}',
  'make faces see-through, or show the inside; comma and full stop show one face alone':
    'machen Flächen durchsichtig oder zeigen das Innere; Komma und Punkt zeigen nur eine Fläche',
  'makes faces see-through, or shows one alone': 'macht Flächen durchsichtig oder zeigt nur eine',
  'Map of jacdet on the section {section}': 'Karte von jacdet auf dem Schnitt {section}',
  Maximum: 'Maximum',
  'Mesh: arrow keys turn it, plus and minus zoom, F shows it whole, N and P go through the invalid cells':
    'Netz: Pfeiltasten drehen es, Plus und Minus zoomen, F zeigt es ganz, N und P gehen durch die ungültigen Zellen',
  'min by': 'Min.',
  'min J inside': 'min J innen',
  Minimum: 'Minimum',
  minimum: 'Minimum',
  'minimum by': 'Minimum durch',
  'Minimum jacdet {minimum} {place}, {lower} inside.': 'Kleinstes jacdet {minimum} {place}, {lower} im Inneren.',
  'Minimum jacdet {minimum} {place}.': 'Kleinstes jacdet {minimum} {place}.',
  'Minimum, {part}: jacdet {jacdet}. {point}. {position}.': 'Minimum, {part}: jacdet {jacdet}. {point}. {position}.',
  'mkdocs.yml': 'mkdocs.yml',
  Morph: 'Übergang',
  'move it along the third axis': 'bewegen sie entlang der dritten Achse',
  'move the chosen vertex along the axis that is nearest to the arrow':
    'bewegen die gewählte Ecke entlang der Achse, die dem Pfeil am nächsten ist',
  'Move there': 'Dorthin bewegen',
  'moves its vertex. Shift moves it in depth, Alt on a grid, X, Y or Z along that axis alone':
    'bewegt seine Ecke. Umschalt bewegt sie in die Tiefe, Alt auf einem Raster, X, Y oder Z nur entlang dieser Achse',
  'moves its vertex. X, Y, Z, Depth and Grid, there once a vertex is chosen, hold the next drags':
    'bewegt seine Ecke. X, Y, Z, Tiefe und Raster, die da sind, sobald eine Ecke gewählt ist, halten das nächste Ziehen',
  'Neither a text nor files were given to be opened.': 'Zum Öffnen wurden weder ein Text noch Dateien angegeben.',
  'new M': 'neues M',
  Next: 'Nächste',
  'Next invalid cell (N)': 'Nächste ungültige Zelle (N)',
  'No cell is invalid: nothing is drawn.': 'Keine Zelle ist ungültig: Nichts ist gezeichnet.',
  'no dimension': 'ohne Einheit',
  'No double lies between the last valid and the first invalid τ, and each verdict is exact. The element at τ is A + τ (B − A), with every coordinate in doubles.':
    'Kein Double liegt zwischen dem letzten gültigen und dem ersten ungültigen τ, und jedes Urteil ist exakt. Das Element bei τ ist A + τ (B − A), jede Koordinate in Doubles.',
  'No place is better, proved exactly: with these weights J\u00a0−\u00a0r·volume adds up to the same number at every place, and it is not positive. So no place has more than r = {bound}.':
    'Kein Ort ist besser, exakt bewiesen: Mit diesen Gewichten ist die Summe von J\u00a0−\u00a0r·Volumen an jedem Ort dieselbe Zahl, und sie ist nicht positiv. Also hat kein Ort mehr als r = {bound}.',
  'No place is better, proved: the least jacdet is never above its mean, the volume.':
    'Kein Ort ist besser, bewiesen: Das kleinste jacdet ist nie größer als sein Mittel, das Volumen.',
  'No place of vertex {name} makes this element valid: these {count} points forbid it.':
    'Kein Ort von Ecke {name} macht dieses Element gültig: Diese {count} Punkte verbieten es.',
  'No place of vertex {name} makes this element valid: this point forbids it.':
    'Kein Ort von Ecke {name} macht dieses Element gültig: Dieser Punkt verbietet es.',
  'no point inside': 'kein Punkt innen',
  'no t chosen': 'kein t gewählt',
  'No valid place of vertex {name} was found, and none is ruled out.':
    'Es wurde kein gültiger Ort für Ecke {name} gefunden und keiner ausgeschlossen.',
  'NO VERDICT': 'KEIN URTEIL',
  'no vertex inside': 'kein Scheitel innen',
  'Node order': 'Knotenreihenfolge',
  none: 'keine',
  'None of the {count} orders tried makes it valid.': 'Keine der {count} versuchten Reihenfolgen macht es gültig.',
  'none, as the volume is 0': 'keines, da das Volumen 0 ist',
  'not on the way': 'nicht auf dem Weg',
  'Not proved: the weights do not cancel exactly. All that is certain is that no relative minimum is above 1.':
    'Nicht bewiesen: Die Gewichte heben sich nicht genau auf. Sicher ist nur, dass kein relatives Minimum über 1 ist.',
  'Not tested in {host} itself.': 'Nicht in {host} selbst getestet.',
  'Nothing that is pasted, dropped or typed here leaves the browser.':
    'Nichts, was hier eingefügt, abgelegt oder getippt wird, verlässt den Browser.',
  'nowhere lower': 'nirgends kleiner',
  'nowhere lower, to within {gap}': 'nirgends kleiner, bis auf {gap}',
  number: 'Zahl',
  'NumPy array, exact': 'NumPy-Array, exakt',
  'of the boundary, likewise': 'auf dem Rand, ebenso',
  'Of {count} other orders of the same eight points, one makes it valid:':
    'Von {count} anderen Reihenfolgen derselben acht Punkte macht eine es gültig:',
  'Of {count} other orders of the same eight points, {helpful} make it valid:':
    'Von {count} anderen Reihenfolgen derselben acht Punkte machen {helpful} es gültig:',
  'On a face jacdet is {formula}, with s and t in the order of ξ, η, ζ. On each interval of t it is positive at {lower} and {upper}. In between it is positive for the reason given.':
    'Auf einer Fläche ist jacdet {formula}, mit s und t in der Reihenfolge von ξ, η, ζ. Auf jedem Intervall von t ist es bei {lower} und {upper} positiv. Dazwischen ist es aus dem angegebenen Grund positiv.',
  'on edge {name}': 'auf Kante {name}',
  'on edge {name} at {point}': 'auf Kante {name} bei {point}',
  'on face {name}': 'auf Fläche {name}',
  'on face {name} at {point}': 'auf Fläche {name} bei {point}',
  'on the': 'auf dem',
  'On the boundary': 'Auf dem Rand',
  'on the boundary': 'auf dem Rand',
  'on {faces}': 'auf {faces}',
  'once on the page': 'einmal auf der Seite',
  'One Bernstein bound': 'Eine Bernstein-Schranke',
  'One edge of the top lies on the bottom: jacdet is zero along the sharp edge.':
    'Eine Kante des Deckels liegt auf dem Boden: jacdet ist entlang der scharfen Kante null.',
  'One upright edge after the other, its lower end first.':
    'Eine aufrechte Kante nach der anderen, das untere Ende zuerst.',
  'One upright edge after the other, its upper end first.':
    'Eine aufrechte Kante nach der anderen, das obere Ende zuerst.',
  'only whether it is valid': 'nur, ob es gültig ist',
  'Open files': 'Dateien öffnen',
  'opens this very element': 'öffnet genau dieses Element',
  OpenVolumeMesh: 'OpenVolumeMesh',
  'or tap it, to read jacdet there: the probe. The box is the image of a little cube, enlarged':
    'oder sie antippen liest jacdet dort ab: der Messpunkt. Der Kasten ist das Bild eines kleinen Würfels, vergrößert',
  P: 'P',
  'P cannot be told from zero. If it is zero, the least value is on an edge (a lemma of the paper).':
    'P ist von null nicht zu unterscheiden. Ist es null, so liegt der kleinste Wert auf einer Kante (ein Lemma des Artikels).',
  'P has no root in (0, 1), so the least value is on an edge.':
    'P hat keine Nullstelle in (0, 1), also liegt der kleinste Wert auf einer Kante.',
  'P has one root in (0, 1):': 'P hat eine Nullstelle in (0, 1):',
  'P has {count} roots in (0, 1):': 'P hat {count} Nullstellen in (0, 1):',
  'Page Up, Page Down': 'Bild auf, Bild ab',
  Paste: 'Einfügen',
  'Paste or drop': 'Einfügen oder ablegen',
  Pause: 'Anhalten',
  'PETSc’s DMPlex': 'DMPlex von PETSc',
  'Place between A and B': 'Ort zwischen A und B',
  'Places are sought up to {half} away on each axis. Derivation and limits: {document}.':
    'Orte werden bis {half} entfernt auf jeder Achse gesucht. Herleitung und Grenzen: {document}.',
  Play: 'Abspielen',
  Point: 'Punkt',
  'Point at a face': 'Auf eine Fläche zeigen',
  'Point at a map to read jacdet there, or use the arrow keys.':
    'Zeigen Sie auf eine Karte, um jacdet dort abzulesen, oder benutzen Sie die Pfeiltasten.',
  'Point at a plot: the maps mark the least point of that row of the face. The dashed line in the picture joins these points.':
    'Zeigen Sie auf ein Diagramm: Die Karten markieren den kleinsten Punkt dieser Zeile der Fläche. Die gestrichelte Linie im Bild verbindet diese Punkte.',
  'Point at the section to read jacdet there, or use the arrow keys.':
    'Zeigen Sie auf den Schnitt, um jacdet dort abzulesen, oder benutzen Sie die Pfeiltasten.',
  'Points that forbid a better place of vertex {name}': 'Punkte, die einen besseren Ort von Ecke {name} verbieten',
  'points, and the corners of the faces': 'Punkte, und die Ecken der Flächen',
  Preset: 'Beispiel',
  'Presets, undo': 'Beispiele, Rückgängig',
  'Press Ctrl+V (⌘V), drop a text or files anywhere on Hexlens, or use the box. Give files that belong together at once, such as a .pvtu and its pieces.':
    'Strg+V (⌘V) drücken, einen Text oder Dateien irgendwo auf Hexlens ablegen, oder das Feld benutzen. Dateien, die zusammengehören, auf einmal geben, etwa eine .pvtu und ihre Teile.',
  'Press Ctrl+V (⌘V), or use the box.': 'Strg+V (⌘V) drücken, oder das Feld benutzen.',
  Preview: 'Vorschau',
  'Preview {order}': 'Vorschau {order}',
  'Preview: {label}': 'Vorschau: {label}',
  Previous: 'Vorige',
  'Previous invalid cell (P)': 'Vorige ungültige Zelle (P)',
  Proof: 'Beweis',
  'Proof: one point with J < 0. At {point} jacdet is exactly {value}.':
    'Beweis: ein Punkt mit J < 0. Bei {point} ist jacdet genau {value}.',
  'Proof: one point with J = 0. At {point} jacdet is exactly {value}.':
    'Beweis: ein Punkt mit J = 0. Bei {point} ist jacdet genau {value}.',
  'Proved exactly: J at this point is the same wherever vertex {name} is, and it is not positive.':
    'Exakt bewiesen: J ist an diesem Punkt dasselbe, wo immer Ecke {name} ist, und es ist nicht positiv.',
  'Proved exactly: with these weights J adds up to the same number at every place, and it is not positive. So J is never positive at all of them.':
    'Exakt bewiesen: Mit diesen Gewichten ist die Summe von J an jedem Ort dieselbe Zahl, und sie ist nicht positiv. Also ist J nie an allen Punkten positiv.',
  'puts a vertex that is being moved back; at other times it removes the probe':
    'setzt eine Ecke zurück, die gerade bewegt wird; sonst entfernt es den Messpunkt',
  'puts the probe on the next candidate; C copies its numbers':
    'setzt den Messpunkt auf den nächsten Kandidaten; C kopiert seine Zahlen',
  quartic: 'Quartik',
  'Quartic of face {face}': 'Quartik der Fläche {face}',
  'R, ?': 'R, ?',
  Random: 'Zufällig',
  'Read as {format}, cell {cell}.': 'Gelesen als {format}, Zelle {cell}.',
  'Read as {format}.': 'Gelesen als {format}.',
  'Read it': 'Lesen',
  'Loading the HDF5 reader, 1 MB …': 'Der Leser für HDF5 wird geladen, 1 MB …',
  'Reading {name} …': '{name} wird gelesen …',
  reason: 'Grund',
  'Red: the surface J = 0, around the negative part. The section cuts through both.':
    'Rot: die Fläche J = 0 um den negativen Teil. Der Schnitt geht durch beide.',
  Redo: 'Wiederholen',
  'Reference cube': 'Referenzwürfel',
  rejects: 'lehnt ab',
  'Relative min.': 'Rel. Min.',
  'Relative minimum': 'Relatives Minimum',
  'relative minimum {minimum}': 'relatives Minimum {minimum}',
  Report: 'Bericht',
  Reset: 'Zurücksetzen',
  'Roots that rounding may have left are tried as well:':
    'Nullstellen, die vom Runden kommen können, werden auch versucht:',
  's*(t), inside from 0 to 1': 's*(t), innen von 0 bis 1',
  'Salome’s MED files': 'MED-Dateien von Salome',
  'Saved as {file}.': 'Gespeichert als {file}.',
  Scene: 'Szene',
  'Section at': 'Schnitt bei',
  'Section at {axis}': 'Schnitt bei {axis}',
  'See-through': 'Durchsichtig',
  'show and hide the reference cube, or this help': 'zeigen und verbergen den Referenzwürfel oder diese Hilfe',
  'Show jacdet on [0,1]³, eight times': 'jacdet auf [0,1]³ zeigen, das Achtfache',
  'Show jacdet on [−1,1]³, an eighth': 'jacdet auf [−1,1]³ zeigen, ein Achtel',
  'Show the minimum': 'Minimum zeigen',
  'Show the proof': 'Beweis zeigen',
  'Show the whole mesh (F)': 'Das ganze Netz zeigen (F)',
  Shown: 'Gezeigt',
  'Shown in space': 'Im Raum gezeigt',
  'sign by': 'Zeichen',
  skipped: 'übersprungen',
  'skipped, since its Bernstein bound {bound} is not below M\u00a0=\u00a0{m} and nothing on it is lower':
    'übersprungen, denn die Bernstein-Schranke {bound} liegt nicht unter M\u00a0=\u00a0{m}, und nichts darauf ist kleiner',
  'skipped, since its Bernstein bound {bound} is positive and nothing on it is lower':
    'übersprungen, denn die Bernstein-Schranke {bound} ist positiv, und nichts darauf ist kleiner',
  solvers: 'Löser',
  Steps: 'Schritte',
  stops: 'hält an',
  'Subdivision to depth\u00a04': 'Unterteilung bis Tiefe\u00a04',
  Surface: 'Oberfläche',
  'SVG of the face maps': 'SVG der Flächenkarten',
  't = {t}: dropped, a = {a} ≤ 0: concave in s, or straight':
    't = {t}: verworfen, a = {a} ≤ 0: konkav in s oder gerade',
  't = {t}: dropped, s* = {s} on an edge': 't = {t}: verworfen, s* = {s} auf einer Kante',
  't = {t}: dropped, s* = {s} outside the face': 't = {t}: verworfen, s* = {s} außerhalb der Fläche',
  't = {t}: kept, a = {a} > 0 and s* = {s} inside': 't = {t}: behalten, a = {a} > 0 und s* = {s} innen',
  't from … to …': 't von … bis …',
  't on face {face}, with P, D, a and s* there': 't auf Fläche {face}, mit P, D, a und s* dort',
  'T, I': 'T, I',
  'Take away': 'Mitnehmen',
  'Taken in the order “{order}”; Undo takes this back.':
    'In der Reihenfolge „{order}“ genommen; „Rückgängig“ nimmt das zurück.',
  'Tap a face': 'Eine Fläche antippen',
  'Tap beside the element': 'Neben das Element tippen',
  'Text with eight points, or a part of a mesh file': 'Text mit acht Punkten, oder ein Teil einer Netzdatei',
  'The attribute {name} is not understood: {why}.': 'Das Attribut {name} wird nicht verstanden: {why}.',
  'The boundary already shows that the element is invalid. Inside, J falls further, to {least}.':
    'Schon der Rand zeigt, dass das Element ungültig ist. Im Inneren fällt J weiter, auf {least}.',
  'The boundary already shows that the element is invalid. Nothing lower is found inside.':
    'Schon der Rand zeigt, dass das Element ungültig ist. Im Inneren wird nichts Kleineres gefunden.',
  'The boundary minimum on [0,1]³ over |volume|.': 'Das Minimum auf dem Rand von [0,1]³ durch |Volumen|.',
  'the box around the element': 'der Kasten um das Element',
  'The browser did not let the link be copied. Here it is:':
    'Der Browser hat den Link nicht kopieren lassen. Hier ist er:',
  'The browser does not allow copying here.': 'Der Browser erlaubt hier kein Kopieren.',
  'The core that computes jacdet did not start, so nothing is known of this element.':
    'Der Kern, der jacdet berechnet, ist nicht gestartet; also ist nichts über dieses Element bekannt.',
  'the element as it is': 'das Element, wie es ist',
  'The element as it is: {verdict}': 'Das Element, wie es ist: {verdict}',
  'The element in the order {order}: {verdict}': 'Das Element in der Reihenfolge {order}: {verdict}',
  'The element is not on the way from A to B. Move the slider to put it there.':
    'Das Element liegt nicht auf dem Weg von A nach B. Bewegen Sie den Regler, um es dorthin zu setzen.',
  'The element is valid as its points are ordered, so no other order is tried.':
    'Das Element ist gültig, wie seine Punkte geordnet sind, also wird keine andere Reihenfolge versucht.',
  'the element that Reset goes back to': 'das Element, zu dem Zurücksetzen führt',
  'the element with vertex 6 pushed in': 'das Element mit eingedrückter Ecke 6',
  'The exact minimum is at most this far from the computed one, which has more digits than are shown.':
    'Das genaue Minimum ist höchstens so weit vom berechneten entfernt, das mehr Ziffern hat, als gezeigt sind.',
  'The file has it on [0,1]³, eight times this.': 'Die Datei hat es auf [0,1]³, das Achtfache davon.',
  'The first block that the cell is in': 'Der erste Block, in dem die Zelle ist',
  'The first coordinate runs fastest, then the second, then the third.':
    'Die erste Koordinate läuft am schnellsten, dann die zweite, dann die dritte.',
  'The graphics context was lost, so the faces are not coloured until the browser gives it back. Everything else goes on.':
    'Der Grafikkontext ging verloren, also sind die Flächen nicht gefärbt, bis der Browser ihn zurückgibt. Alles andere geht weiter.',
  'The greatest relative minimum that each vertex can bring, moved alone:':
    'Das größte relative Minimum, das jede Ecke bringen kann, wenn sie allein bewegt wird:',
  'The hexahedron in space': 'Das Hexaeder im Raum',
  'The hexahedron in space, eight vertices to move': 'Das Hexaeder im Raum, acht Ecken zum Bewegen',
  'The id in the file': 'Die Nummer in der Datei',
  'The integral of jacdet.': 'Das Integral von jacdet.',
  'The least jacdet': 'Das kleinste jacdet',
  'The least jacdet along the twelve edges. It comes from the quadratic on each edge, not from samples.':
    'Das kleinste jacdet entlang der zwölf Kanten. Es kommt aus dem quadratischen Polynom jeder Kante, nicht aus Stichproben.',
  'The least jacdet at eight points inside, where a solver with full integration evaluates it.':
    'Das kleinste jacdet an acht Punkten im Inneren, wo ein Löser mit voller Integration es auswertet.',
  'The least jacdet at the 27 points of the next finer integration rule.':
    'Das kleinste jacdet an den 27 Punkten der nächstfeineren Integrationsregel.',
  'The least jacdet at the eight vertices.': 'Das kleinste jacdet an den acht Ecken.',
  'The least jacdet found before this face': 'Das kleinste jacdet vor dieser Fläche',
  'The least jacdet over the volume: at most 1': 'Das kleinste jacdet durch das Volumen: höchstens 1',
  'The least of the 27 Bernstein coefficients, which follow from 20 samples. It is a lower bound of jacdet, often a poor one: it rejects some valid elements.':
    'Der kleinste der 27 Bernstein-Koeffizienten, die aus 20 Werten folgen. Er ist eine untere Schranke von jacdet, oft eine schlechte: Sie lehnt manches gültige Element ab.',
  'The least of the face’s nine Bernstein coefficients': 'Der kleinste der neun Bernstein-Koeffizienten der Fläche',
  'The mean of jacdet': 'Der Mittelwert von jacdet',
  'the minimum': 'das Minimum',
  'The minimum is exactly zero, and a valid element needs J > 0 everywhere.':
    'Das Minimum ist genau null, und ein gültiges Element braucht überall J > 0.',
  'The minimum is exactly zero, in the middle of a face. A valid element needs more than zero.':
    'Das Minimum ist genau null, mitten auf einer Fläche. Ein gültiges Element braucht mehr als null.',
  'The minimum is not on this section: it is {off} above it in {axis}, marked where it projects.':
    'Das Minimum liegt nicht auf diesem Schnitt: Es liegt {off} darüber in {axis}, markiert an seiner Projektion.',
  'The minimum is not on this section: it is {off} below it in {axis}, marked where it projects.':
    'Das Minimum liegt nicht auf diesem Schnitt: Es liegt {off} darunter in {axis}, markiert an seiner Projektion.',
  'The number at which cutting into eight stops. An element still open at depth 4 is rejected, valid or not.':
    'Die Zahl, bei der das Zerlegen in acht Teile endet. Ein bei Tiefe 4 noch offenes Element wird abgelehnt, gültig oder nicht.',
  'The orders are tried when this change is done.': 'Die Reihenfolgen werden versucht, wenn diese Änderung fertig ist.',
  'the paper behind the verdict': 'der Artikel hinter dem Urteil',
  'The paper’s counterexample: on the boundary jacdet is never below zero, at the centre it is −1/4. Positive has to mean more than zero.':
    'Das Gegenbeispiel des Artikels: Auf dem Rand ist jacdet nie kleiner als null, in der Mitte ist es −1/4. Positiv muss größer als null heißen.',
  'The points were taken in the order “{order}”. Undo takes this back.':
    'Die Punkte wurden in der Reihenfolge „{order}“ genommen. „Rückgängig“ nimmt das zurück.',
  'the preview as a picture, for readers without JavaScript. Put it beside the page.':
    'die Vorschau als Bild, für Leser ohne JavaScript. Legen Sie es neben die Seite.',
  'The proof follows when this change is done.': 'Der Beweis folgt, wenn diese Änderung fertig ist.',
  'The query stops here: the element is invalid.': 'Die Suche endet hier: Das Element ist ungültig.',
  'The reference cube, in xi, eta and zeta': 'Der Referenzwürfel, in xi, eta und zeta',
  'The relative minimum is the least jacdet over the volume: 1 of a box, 0 or less of an invalid element. The best place has the greatest one, to one part in a million. Of several it is the nearest.':
    'Das relative Minimum ist das kleinste jacdet durch das Volumen: 1 bei einem Quader, 0 oder weniger bei einem ungültigen Element. Der beste Ort hat das größte, auf ein Millionstel genau. Von mehreren ist es der nächste.',
  'the same': 'dasselbe',
  'The same colours in (ξ, η, ζ), beside the element (R)': 'Dieselben Farben in (ξ, η, ζ), neben dem Element (R)',
  'The scaled Jacobian (corners and centre) is acceptable from 0.5 on in the manuals of {cubit} and {verdict}, and {inPractice} often from 0.2 or 0.3 on.':
    'Die skalierte Jacobi-Determinante (Ecken und Mitte) gilt in den Handbüchern von {cubit} und {verdict} ab 0.5 als annehmbar, {inPractice} oft ab 0.2 oder 0.3.',
  'The scaled Jacobian: jacdet over the lengths of its three columns, the least at the vertices and the centre. It is from −1 to 1. Verdict gives 1e30 if an edge or an axis has no length.':
    'Die skalierte Jacobi-Determinante: jacdet durch die Längen seiner drei Spalten, die kleinste an den Ecken und der Mitte. Sie liegt zwischen −1 und 1. Verdict gibt 1e30, wenn eine Kante oder eine Achse keine Länge hat.',
  'the scene: lines and words over a picture of the faces': 'die Szene: Linien und Worte über einem Bild der Flächen',
  'the scene; dropped here it opens this element again': 'die Szene; hier abgelegt öffnet es dieses Element wieder',
  'The section and the surface J = 0 can be shown in space.':
    'Der Schnitt und die Fläche J = 0 können im Raum gezeigt werden.',
  'the six faces unfolded, likewise': 'die sechs Flächen entfaltet, ebenso',
  'the text': 'den Text',
  'The top comes before the bottom, which turns it inside out as well.':
    'Der Deckel kommt vor dem Boden; auch das stülpt das Element um.',
  'The top comes first, and the bottom starts under its fourth point.':
    'Der Deckel kommt zuerst, und der Boden beginnt unter seinem vierten Punkt.',
  'The top comes first, and the bottom starts under its second point.':
    'Der Deckel kommt zuerst, und der Boden beginnt unter seinem zweiten Punkt.',
  'The top comes first, and the bottom starts under its third point.':
    'Der Deckel kommt zuerst, und der Boden beginnt unter seinem dritten Punkt.',
  'The top comes first; the bottom starts under its fourth point and goes round against it.':
    'Der Deckel kommt zuerst; der Boden beginnt unter seinem vierten Punkt und läuft gegen ihn.',
  'The top comes first; the bottom starts under its second point and goes round against it.':
    'Der Deckel kommt zuerst; der Boden beginnt unter seinem zweiten Punkt und läuft gegen ihn.',
  'The top comes first; the bottom starts under its third point and goes round against it.':
    'Der Deckel kommt zuerst; der Boden beginnt unter seinem dritten Punkt und läuft gegen ihn.',
  'The top is stretched and turned; at 143.13° (cosine −4/5) jacdet reaches zero.':
    'Der Deckel ist gestreckt und gedreht; bei 143.13° (Kosinus −4/5) erreicht jacdet null.',
  'The top starts above vertex 0 and goes round against the bottom.':
    'Der Deckel beginnt über Ecke 0 und läuft gegen den Boden.',
  'The top starts above vertex 1 and goes round against the bottom.':
    'Der Deckel beginnt über Ecke 1 und läuft gegen den Boden.',
  'The top starts above vertex 1.': 'Der Deckel beginnt über Ecke 1.',
  'The top starts above vertex 2 and goes round against the bottom.':
    'Der Deckel beginnt über Ecke 2 und läuft gegen den Boden.',
  'The top starts above vertex 2.': 'Der Deckel beginnt über Ecke 2.',
  'The top starts above vertex 3 and goes round against the bottom: its four points are reversed.':
    'Der Deckel beginnt über Ecke 3 und läuft gegen den Boden: Seine vier Punkte sind umgekehrt.',
  'The top starts above vertex 3.': 'Der Deckel beginnt über Ecke 3.',
  'The unit cube with every coordinate moved by chance (normally, deviation 0.3): about half of these are valid.':
    'Der Einheitswürfel, jede Koordinate zufällig verschoben (normalverteilt, Abweichung 0.3): Etwa die Hälfte davon ist gültig.',
  'The vertex has been moved. Undo takes it back.': 'Die Ecke wurde bewegt. „Rückgängig“ nimmt das zurück.',
  'The WebAssembly core did not start, so there is no verdict ({why}). The vertices and the link still work; reload the page to try again.':
    'Der WebAssembly-Kern ist nicht gestartet, also gibt es kein Urteil ({why}). Ecken und Link funktionieren weiter; zum erneuten Versuch die Seite neu laden.',
  'The weights cancel exactly, but their sum is positive: it forbids nothing.':
    'Die Gewichte heben sich genau auf, aber ihre Summe ist positiv: Sie verbietet nichts.',
  'The worst {shown} of {wanted} cells are drawn.': 'Gezeichnet sind die schlechtesten {shown} von {wanted} Zellen.',
  'The {count} orders tried': 'Die {count} versuchten Reihenfolgen',
  'There is no cell {cell}.': 'Es gibt keine Zelle {cell}.',
  'There is no report to follow.': 'Es gibt keinen Bericht, dem man folgen könnte.',
  'There is no verdict, so there is no best place.': 'Es gibt kein Urteil und also keinen besten Ort.',
  'There is no verdict, so there is nothing to compare.': 'Es gibt kein Urteil, also nichts zu vergleichen.',
  'These coefficients are rounded to be read; the core keeps P in Bernstein form.':
    'Diese Koeffizienten sind zum Lesen gerundet; der Kern behält P in Bernstein-Form.',
  'This browser gives no WebGL2, so the faces are coloured in coarse tiles. Everything else is as it should be, and the verdict holds.':
    'Dieser Browser bietet kein WebGL2, also sind die Flächen in groben Kacheln gefärbt. Alles andere ist, wie es sein soll, und das Urteil gilt.',
  'This browser gives no WebGL2, so there is no picture. The list has every cell.':
    'Dieser Browser bietet kein WebGL2, also gibt es kein Bild. Die Liste hat jede Zelle.',
  'This could not be drawn ({why}).': 'Dies konnte nicht gezeichnet werden ({why}).',
  'This panel could not be loaded ({why}). Reload the page to try again.':
    'Dieses Feld konnte nicht geladen werden ({why}). Zum erneuten Versuch die Seite neu laden.',
  'Three nested loops, the third coordinate innermost.':
    'Drei verschachtelte Schleifen, die dritte Koordinate ganz innen.',
  'To check it without this page: {check}. {certify} makes the same of a list of elements.':
    'Um ihn ohne diese Seite zu prüfen: {check}. {certify} macht dasselbe für eine Liste von Elementen.',
  'To check it, evaluate the definition once in rational numbers.':
    'Um ihn zu prüfen, werten Sie die Definition einmal in rationalen Zahlen aus.',
  'To check the proof without this page:': 'Um den Beweis ohne diese Seite zu prüfen:',
  'to read jacdet there: the probe. The box is the image of a little cube, enlarged':
    'liest jacdet dort ab: der Messpunkt. Der Kasten ist das Bild eines kleinen Würfels, vergrößert',
  'to remove the probe and let go of the vertex': 'entfernt den Messpunkt und lässt die Ecke los',
  'to {point}, {distance} away': 'nach {point}, {distance} entfernt',
  'to {point}, {distance} away, where min J is greatest, though not positive':
    'nach {point}, {distance} entfernt, wo min J am größten ist, wenn auch nicht positiv',
  'Top first': 'Deckel zuerst',
  'Top first, bottom turned by one': 'Deckel zuerst, Boden um eins gedreht',
  'Top first, bottom turned by one, the other way round': 'Deckel zuerst, Boden um eins gedreht, andersherum',
  'Top first, bottom turned by three': 'Deckel zuerst, Boden um drei gedreht',
  'Top first, bottom turned by three, the other way round': 'Deckel zuerst, Boden um drei gedreht, andersherum',
  'Top first, bottom turned by two': 'Deckel zuerst, Boden um zwei gedreht',
  'Top first, bottom turned by two, the other way round': 'Deckel zuerst, Boden um zwei gedreht, andersherum',
  'Top the other way round': 'Deckel andersherum',
  'Top turned by one': 'Deckel um eins gedreht',
  'Top turned by one, the other way round': 'Deckel um eins gedreht, andersherum',
  'Top turned by three': 'Deckel um drei gedreht',
  'Top turned by three, the other way round': 'Deckel um drei gedreht, andersherum',
  'Top turned by two': 'Deckel um zwei gedreht',
  'Top turned by two, the other way round': 'Deckel um zwei gedreht, andersherum',
  'Touches zero on a face': 'Berührt null auf einer Fläche',
  Turn: 'Drehen',
  'Turn and zoom': 'Drehen und zoomen',
  'Turn and zoom by pressing buttons': 'Durch Knöpfe drehen und zoomen',
  'Turn down': 'Nach unten drehen',
  'Turn left': 'Nach links drehen',
  'Turn right': 'Nach rechts drehen',
  'turn the view; plus and minus zoom, F fits it, Home resets it':
    'drehen die Ansicht; Plus und Minus zoomen, F passt sie ein, Pos1 setzt sie zurück',
  'Turn to where it is seen (M)': 'Dorthin drehen, wo man es sieht (M)',
  'Turn up': 'Nach oben drehen',
  'Turned 0.3° further: jacdet is negative on the upright edges.':
    '0.3° weiter gedreht: jacdet ist auf den aufrechten Kanten negativ.',
  'turned and zoomed as in the preview': 'gedreht und gezoomt wie in der Vorschau',
  'Turning one turns the other': 'Wer einen dreht, dreht den anderen mit',
  'Turning the numbers by one of the cube’s 24 rotations changes nothing, so orders that differ by one are tried once.':
    'Die Nummern mit einer der 24 Drehungen des Würfels zu drehen ändert nichts; Reihenfolgen, die sich so unterscheiden, werden einmal versucht.',
  'turns and zooms the view by buttons': 'dreht und zoomt die Ansicht durch Knöpfe',
  'turns the view if you begin sideways; up and down scrolls the page':
    'dreht die Ansicht, wenn man seitwärts beginnt; auf und ab rollt die Seite',
  'turns the view to the minimum, or shows it through the faces':
    'dreht die Ansicht zum Minimum oder zeigt es durch die Flächen',
  'turns the view. Two fingers, or Ctrl and the wheel, zoom':
    'dreht die Ansicht. Zwei Finger, oder Strg und das Rad, zoomen',
  'Twelve edges': 'Zwölf Kanten',
  'Twisted by 143.3°, just not': 'Um 143.3° verdreht, gerade nicht mehr',
  'Twisted by 143°, just valid': 'Um 143° verdreht, gerade noch gültig',
  'Two fingers': 'Zwei Finger',
  'Two points of the bottom exchanged': 'Zwei Punkte des Bodens vertauscht',
  'Two points of the top exchanged': 'Zwei Punkte des Deckels vertauscht',
  unanswered: 'unbeantwortet',
  Undo: 'Rückgängig',
  'Unit cube': 'Einheitswürfel',
  'Use it': 'Diese nehmen',
  'Use this order': 'Diese Reihenfolge nehmen',
  'Use this order: {order}': 'Diese Reihenfolge nehmen: {order}',
  'usual limits 0.5, 0.3, 0.2': 'übliche Grenzen 0.5, 0.3, 0.2',
  VALID: 'GÜLTIG',
  Valid: 'Gültig',
  valid: 'gültig',
  'Valid at every place tried from A to B: no change of the verdict was found.':
    'Gültig an jedem versuchten Ort von A bis B: Keine Änderung des Urteils wurde gefunden.',
  'Valid, invalid, inverted or collapsed': 'Gültig, ungültig, umgestülpt oder zusammengefallen',
  'Valid, though subdivision gives up': 'Gültig, obwohl die Unterteilung aufgibt',
  'Valid; a recursive subdivision that gives up past depth 4 rejects it.':
    'Gültig; eine rekursive Unterteilung, die nach Tiefe 4 aufgibt, lehnt es ab.',
  Verdict: 'Urteil',
  'Verdict in VTK, PyVista, ParaView': 'Verdict in VTK, PyVista, ParaView',
  vertex: 'Ecke',
  'Vertex {name}': 'Ecke {name}',
  'vertex {name}': 'Ecke {name}',
  'Vertex {name} alone can bring the relative minimum from {before} to {after}.':
    'Ecke {name} allein kann das relative Minimum von {before} auf {after} bringen.',
  'Vertex {name} alone can bring the relative minimum to {after}.':
    'Ecke {name} allein kann das relative Minimum auf {after} bringen.',
  'Vertex {name} is at its best place: relative minimum {after}.':
    'Ecke {name} ist an ihrem besten Ort: relatives Minimum {after}.',
  'Vertex {name} {axis}': 'Ecke {name} {axis}',
  'Vertex {name}, at best {value}': 'Ecke {name}, bestenfalls {value}',
  'Vertex {name}, no valid place': 'Ecke {name}, kein gültiger Ort',
  'Vertex {name}: {coordinates}.': 'Ecke {name}: {coordinates}.',
  Vertices: 'Ecken',
  'Vertices 2 and 3 have changed places.': 'Die Ecken 2 und 3 haben die Plätze getauscht.',
  'Vertices 6 and 7 have changed places.': 'Die Ecken 6 und 7 haben die Plätze getauscht.',
  'Vertices fine, an edge is not': 'Ecken gut, eine Kante nicht',
  'Vertices {names} coincide': 'Die Ecken {names} fallen zusammen',
  Volume: 'Volumen',
  'volume 0': 'Volumen 0',
  'volume × {factor}': 'Volumen × {factor}',
  weight: 'Gewicht',
  'What each looks at': 'Was jede betrachtet',
  'What is certain, and why': 'Was sicher ist und warum',
  'What keys and pointers do (?)': 'Was Tasten und Zeiger tun (?)',
  'What settles each face': 'Was jede Fläche entscheidet',
  'What was read': 'Was gelesen wurde',
  'Where the verdict changes': 'Wo das Urteil sich ändert',
  'While the other seven vertices stay, J at a point of the element is an affine function of the place, and so is the volume. So the places with at least r > 0 form a convex set, and at most four points forbid a greater r.':
    'Solange die anderen sieben Ecken bleiben, ist J an einem Punkt des Elements eine affine Funktion des Ortes, und das Volumen auch. Also bilden die Orte mit mindestens r > 0 eine konvexe Menge, und höchstens vier Punkte verbieten ein größeres r.',
  'Who would notice': 'Wer würde es merken',
  'Who would notice?': 'Wer würde es merken?',
  'with c and a + b + c these are the Bernstein coefficients in s. All are positive.':
    'mit c und a + b + c sind dies die Bernstein-Koeffizienten in s. Alle sind positiv.',
  'With neighbours': 'Mit Nachbarn',
  wrong: 'falsch',
  'Wrong node order': 'Falsche Knotenreihenfolge',
  'Zero on the faces, negative inside': 'Null auf den Flächen, negativ im Inneren',
  'zoom and shift the view; Fit brings the element back':
    'zoomen und verschieben die Ansicht; Einpassen holt das Element zurück',
  'Zoom in': 'Vergrößern',
  'Zoom out': 'Verkleinern',
  '{bound} is a lower bound of jacdet on the face. If {bound}\u00a0>\u00a00, the face is positive. If {bound}\u00a0≥\u00a0M, the least value so far, the face has no lower minimum. Otherwise the quartic decides.':
    '{bound} ist eine untere Schranke von jacdet auf der Fläche. Ist {bound}\u00a0>\u00a00, so ist die Fläche positiv. Ist {bound}\u00a0≥\u00a0M, der kleinste Wert bisher, so hat die Fläche kein kleineres Minimum. Sonst entscheidet die Quartik.',
  '{box} at {point}': '{box} bei {point}',
  '{clause}, and so do {others}': '{clause}, ebenso {others}',
  '{clause}: jacdet is 0 at vertices {names}.': '{clause}: jacdet ist an den Ecken {names} 0.',
  '{clause}: jacdet is 0 there.': '{clause}: Dort ist jacdet 0.',
  '{entity}: J = {value}, the minimum': '{entity}: J = {value}, das Minimum',
  '{entity}: {clause}.': '{entity}: {clause}.',
  '{field}: {why} {number} is kept.': '{field}: {why} {number} bleibt.',
  '{filler} boundary': '{filler} Rand',
  '{from} to {to}': '{from} bis {to}',
  '{names} and {last}': '{names} und {last}',
  '{name} could not be fetched: it is not an address.': '{name} konnte nicht geholt werden: Das ist keine Adresse.',
  '{name} could not be fetched: the connection or the memory ended before the file.':
    '{name} konnte nicht geholt werden: Die Verbindung oder der Speicher endete vor der Datei.',
  '{name} could not be fetched: the server answers {status}.':
    '{name} konnte nicht geholt werden: Der Server antwortet {status}.',
  '{name} could not be fetched: there is no such server, it does not let this page read the file (CORS), or a policy of the page forbids it.':
    '{name} konnte nicht geholt werden: Es gibt den Server nicht, er lässt diese Seite die Datei nicht lesen (CORS), oder eine Richtlinie der Seite verbietet es.',
  '{name} is larger than {most} MB, the most that is fetched with a page.':
    '{name} ist größer als {most} MB, mehr wird mit einer Seite nicht geholt.',
  '{name}, change {number}': '{name}, Änderung {number}',
  '{number} of {count}': '{number} von {count}',
  '{order}: {verdict}': '{order}: {verdict}',
  '{place}, {verdict}, minimum {minimum}': '{place}, {verdict}, Minimum {minimum}',
  '{sentence}.': '{sentence}.',
  '{text} can mean {point} or {none}: write one of them.':
    '{text} kann {point} oder {none} bedeuten: Bitte eines davon schreiben.',
  '{text} divides by zero.': '{text} teilt durch null.',
  '{text} is not a number from {least} to {most}.': '{text} ist keine Zahl von {least} bis {most}.',
  '{text} is not a number of {least} or more.': '{text} ist keine Zahl ab {least}.',
  '{text} is not a whole number from {least} to {most}.': '{text} ist keine ganze Zahl von {least} bis {most}.',
  '{text} is not a whole number of {least} or more.': '{text} ist keine ganze Zahl ab {least}.',
  '{text} is not a whole number.': '{text} ist keine ganze Zahl.',
  '{text} is not one number, such as −1.5, 1/3 or 2e-3.': '{text} ist nicht eine Zahl wie −1.5, 1/3 oder 2e-3.',
  '{text} is outside the doubles, which are from 5e-324 to 1.8e308.':
    '{text} liegt außerhalb der Doubles, die von 5e-324 bis 1.8e308 reichen.',
  '{verdict}: {kind}.': '{verdict}: {kind}.',
  '“{text}” is none of {known}': '„{text}“ ist keines von {known}',
  '“{text}” is not a number': '„{text}“ ist keine Zahl',
  '“{text}” is not azimuth and elevation in degrees and a zoom, such as “-58 24 1.5”':
    '„{text}“ ist nicht Azimut und Höhenwinkel in Grad und ein Zoom, wie „-58 24 1.5“',
  'of the type {type}': 'vom Typ {type}',
  '“{text}” is not the address of a page': '„{text}“ ist nicht die Adresse einer Seite',
  'Shift, Ctrl': 'Umschalt, Strg',
  'with arrow keys make the step ten times as long, or a tenth. On a Mac, and with Page Up and Down, it is Alt':
    'machen mit den Pfeiltasten den Schritt zehnmal so lang oder ein Zehntel so lang. Auf einem Mac und mit Bild auf und Bild ab ist es Alt',
  Details: 'Einzelheiten',
  'the light file of Hexlens has no readers': 'die leichte Datei von Hexlens enthält keine Leser',
}
