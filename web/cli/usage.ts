/** The texts of `--help`. */

export const CALL = process.env.npm_lifecycle_event === 'hexlens' ? 'npm run -s hexlens --' : 'hexlens'

export const USAGE = `Usage: ${CALL} check FILE...           a mesh: ${CALL} check --help
       ${CALL} repair FILE -o OUT      a mesh, with vertices moved: ${CALL} repair --help
       ${CALL} analyze FILE.json
       ${CALL} certify FILE.json
       ${CALL} --version

Decides exactly whether trilinear hexahedra are valid finite elements: jacdet > 0 everywhere in them.

analyze reads a JSON list of {"name", "vertices": [[x, y, z], ... 8 points in VTK_HEXAHEDRON order]} ("-": standard input)
and prints a JSON list of {"name", "valid", "class", "coincident", "shape", "boundary_min", "boundary_min_error",
"minimizer", "corner_min", "edge_min", "volume_min": [lower, upper], "volume_minimizer", "volume", "relative_min",
"decided_by", "checks"}, or of {"name", "error"} for what cannot be analysed, in the same order. jacdet is that of the map
from [0,1]^3.

class         valid; invalid; inverted (jacdet < 0 everywhere); collapsed (jacdet = 0 everywhere)
coincident    the groups of vertices at the same position: [[4,5],[6,7]]
shape         wedge, pyramid or tetrahedron where the coincidences make one, else null
volume        the integral of jacdet
relative_min  boundary_min over |volume|, a number without a dimension; null where the volume is 0

certify reads the same list and prints {"name", "vertices", "valid", ...} with a proof: docs/certificates.md says which, and
tests/certificates/check_certificates.py checks it.

Exit status: 0, or 2 for a wrong call or input.
`

export const CHECK_USAGE = `Usage: ${CALL} check [OPTION...] FILE...

Reads meshes, decides for every hexahedron of eight nodes whether jacdet > 0 in all of it, exactly, and says which are the
worst: those with the least minimum of jacdet over |volume|. "-" is standard input.

  --json               prints one JSON object: docs/check.schema.json
  --worst N|all        how many of the worst are listed (10)
  --min-relative R     counts cells with a minimum over |volume| below R in "below"
  --degenerate=skip    counts cells with coincident vertices in "degenerate" alone
  --allow-unchecked    exit status 0 in place of 3
  --format NAME        the files are in this format, whatever they look like
  --step N|last|all    which time step is read of a file that has several (1); all: every one
  --ids abaqus|nastran|plain
                       prints the ids of the invalid hexahedra: an element set, a SET, or one on a line
  --csv FILE           writes a line for each hexahedron
  --junit FILE         writes a JUnit report, a suite for each file
  --html FILE          writes one document to keep, which needs nothing else: the sentence, the notes, the histogram, and the
                       first ten of the worst, drawn and in numbers
  --annotate FILE.vtu|.vtk|.msh|.inp
                       writes the hexahedra with the cell arrays valid, boundary_min, relative_min, volume; valid is
                       255 where a cell is unanswered. VTK 5.1, Gmsh 4.1; Abaqus has sets in place of arrays. For one input

Exit status: of each file
  0  all hexahedra are valid
  1  some are invalid, or below R
  2  the file cannot be read, or the call is wrong
  3  none is invalid, but not all could be answered: cells of 20 or 27 nodes and Lagrange cells, coordinates that are not
     finite, an order of nodes that is not stated and decides, a file that is cut off, or no hexahedra at all
and of several files 2 before 1 before 3 before 0. Cells of other types never change it.
`

export const REPAIR_USAGE = `Usage: ${CALL} repair [OPTION...] FILE -o OUT

Reads a mesh, moves vertices so that hexahedra become valid, and writes it to OUT. FILE stays as it is; "-" is standard input.
Each move takes a vertex to the best place for the worst of its cells, and never makes that worse. The boundary stays unless an
option frees it. It knows no geometry but what stays, and a mesh whose topology forbids validity stays invalid: docs/repair.md.

  -o, --output OUT     the file to write, in the format of FILE: all bytes but those of coordinates are as they were. Where that
                       does not let coordinates be replaced, or OUT ends as files of another format do (.vtu, .vtk, .msh, .inp),
                       the hexahedra alone are written as VTU, VTK, Gmsh or Abaqus
  --min-relative R     moves on until the least minimum of jacdet over |volume| is R, from 0 to 1; without, until all are valid
  --slide              vertices on planar parts of the boundary move in their plane, those on a straight edge of it along it
  --free-boundary D    vertices of the boundary move by D at most, in the unit of the coordinates; with --slide only in their
                       planes where they have one
  --reorder            where nodes are listed in another order than was meant, as in mirrored cells, writes them in that one: the
                       hexahedra alone, as VTU, VTK, Gmsh or Abaqus. Without, a sentence says so, and the order stays
  --certificates FILE  writes for each vertex that holds what is left the proof that no place of it helps, as a JSON list that
                       tests/certificates/check_certificates.py checks: docs/certificates.md, section 5
  --format NAME        the file is in this format, whatever it looks like
  --step N|last        which time step is read of a file that has several (1)
  --allow-unchecked    exit status 0 in place of 3

Exit status: that of ${CALL} check OUT, with the same R. OUT is read again for it.
`
