/**
 * What to do about a sentence that is said of a mesh. Sentences are the readers', for the command line as for pages; what a page can do about
 * them is said here. A test goes through all that readers can say.
 */

const NOTHING = ''
const REPEATED =
  'If they are meant as wedges, pyramids or tetrahedra, “boundary_min < 0” as the condition lists what is invalid beside them.'
const EXPORT_WHOLE = 'For all of them, export the whole mesh anew.'
const WHICH_ORDER = 'If an answer surprises, write the mesh in a format that states the order of nodes, such as VTU.'
const ANOTHER_STEP = 'The slider shows the others, if the file was opened alone.'
const PLACES = 'If that is not what you meant, write the mesh with its nodes where they are in the analysis.'

/** The first that a sentence meets holds. An empty advice: nothing has to be done. */
const ADVICE: readonly (readonly [about: RegExp, advice: string])[] = [
  [
    /mirrored, jacdet < 0 everywhere/,
    'The button corrects it here; the meshes under “Take away” then have the corrected cells.',
  ],
  [/have been taken here in the order|been corrected here/, 'The meshes under “Take away” have them so.'],
  [/not corrected here: its cells are others/, 'Show that step and correct it there.'],
  [/coincident vertices/, REPEATED],
  [/^Not checked:/, 'They are left as they are: this page answers for hexahedra of eight nodes.'],
  [/repeat (nodes|some)/, REPEATED],
  [
    /more than eight nodes/,
    'Only their eight corners are looked at: write the mesh with linear elements to have them checked.',
  ],
  [/nodes beyond those on the edges/, 'Write the mesh with linear elements to have them checked.'],
  [/of order .*, not trilinear/, 'Write the mesh with linear elements to have them checked.'],
  [/curved edges/, 'What blockMesh makes of them is answered for its polyMesh.'],
  [/^The file curves/, 'Answered are the elements with straight sides between their eight vertices.'],
  [
    /^Coordinates are (printed|stored)/,
    'It may decide about cells whose minimum is as near to 0: write more digits, or doubles.',
  ],
  [/not stated in which order|order of their nodes is not certain|order of its nodes is not stated/, WHICH_ORDER],
  [/(taken|read) in the order of the text|in the order of the text/, WHICH_ORDER],
  [/in two orders, mirror images|in scikit-fem’s order/, WHICH_ORDER],
  [/answered as hexahedra with these corners/, 'Write them as hexahedra (type 12) if they are meant so.'],
  [/counting the points from/, 'If that is not so, the cells are others: say the base in the text, or write a VTU.'],
  [
    /taken as eight (points|x)|comes from the six faces/,
    'If they were meant in another way, write eight rows of x, y and z.',
  ],
  [/^Eight points taken|^Points taken/, WHICH_ORDER],
  [/Commas were taken/, 'If they were not meant so, write points.'],
  [/unanswered/, 'Look at its row in the list, and mend the file: nothing is assumed in its place.'],
  [
    /cut off|is cut:|ends before the end|end of the file is missing/,
    'Copy or export the file again to have all of it checked.',
  ],
  [/leaves .* out|leaves something out/, EXPORT_WHOLE],
  [/declares .*, and has/, 'Write the file anew if it should have as many as it declares.'],
  [
    /passed over|is not read here|are not read|not counted|left out|were left out/,
    'What it has to say of cells is not in the answer: write nodes and elements out in one file if it matters.',
  ],
  [/ghosts/, 'Take them off before the mesh is written if the counts matter.'],
  [/Time step .* was read/, ANOTHER_STEP],
  [/calculates with its numbers/, 'Paste what the program prints.'],
  [/the same at all/, NOTHING],
  [/taken together/, 'For one alone, drop that alone.'],
  [/belong to other ranks/, 'Give the files of all ranks to have the whole mesh.'],
  [/lacks? files/, 'Give them together with the others.'],
  [
    /^Cells of (OpenFOAM|Fluent) are polyhedra|^OBJ has faces|known by their faces alone|are listed with their nodes/,
    NOTHING,
  ],
  [/no polyhedra/, 'Write the cells, too, not the surface alone.'],
  [/cannot be read: blocks lack/, 'The answers are the same; write the file anew to have the names.'],
  [
    /none of Gmsh|are not known here|is not defined|are none of/,
    'If they are hexahedra, write the mesh in another format.',
  ],
  [/without the scale/, 'A scale changes no verdict and no relative minimum.'],
  [/projects vertices/, PLACES],
  [/parts and no assembly|has no instance/, 'Write the input with its assembly to have the parts where they are.'],
  [/rounded to doubles/, 'It may decide about cells whose minimum is as near to 0 as that, about no others.'],
  [/\*IMPERFECTION/, PLACES],
  [/Blank coordinates/, 'Write them if they were meant otherwise.'],
  [/meshio wrote this file|non-conforming|elements are read as they are written/, NOTHING],
  [
    /are taken as .* steps|time steps of one mesh/,
    'If they are parts of one mesh, the button below takes them together.',
  ],
]

/** Empty where nothing has to be done; null for a sentence that is not known. */
export function adviceFor(sentence: string): string | null {
  return ADVICE.find(([about]) => about.test(sentence))?.[1] ?? null
}
