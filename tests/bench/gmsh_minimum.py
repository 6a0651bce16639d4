"""gmsh_minimum.py COUNT SIGMA...: reads the sweep's displacements and prints, for each sigma, Gmsh's time for minDetJac in
nanoseconds an element. Ends with status 1 where there is no gmsh."""
import array
import statistics
import sys
import time

try:
    import gmsh
except (ImportError, OSError):
    sys.exit(1)

TRIALS = 3
CUBE = [0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0, 0, 0, 1, 1, 0, 1, 1, 1, 1, 0, 1, 1]
HEXAHEDRON = 5  # Gmsh's element type; its vertex order is VTK's

count = int(sys.argv[1])
displacements = array.array("d")
displacements.frombytes(sys.stdin.buffer.read())

for sigma in map(float, sys.argv[2:]):
    gmsh.initialize()
    gmsh.option.setNumber("General.Terminal", 0)
    gmsh.option.setNumber("General.NumThreads", 1)
    entity = gmsh.model.addDiscreteEntity(3)
    points = [CUBE[i % 24] + sigma * displacements[i] for i in range(24 * count)]
    nodes = list(range(1, 8 * count + 1))
    gmsh.model.mesh.addNodes(3, entity, nodes, points)
    tags = list(range(1, count + 1))
    gmsh.model.mesh.addElementsByType(entity, HEXAHEDRON, tags, nodes)
    times = []
    for _ in range(TRIALS):
        begin = time.process_time()
        gmsh.model.mesh.getElementQualities(tags, "minDetJac")
        times.append(time.process_time() - begin)
    print(1e9 * statistics.median(times) / count, flush=True)
    gmsh.finalize()
