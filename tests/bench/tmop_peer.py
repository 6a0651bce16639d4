"""TMOP of PyMFEM on a grid, as MFEM's mesh-optimizer does it: the metric 360, which has no barrier, the targets unit cubes, the boundary
fixed, Newton's method with MINRES. Prints the CPU seconds, and what moved_grid.py says of the result."""

import os
import time

import mfem.ser as mfem
import moved_grid
import numpy as np
from mfem._ser import tmop, tmop_tools

ORDER = 4

points, cells = moved_grid.read()
side = round(len(cells) ** (1 / 3))
mesh = mfem.Mesh.MakeCartesian3D(side, side, side, mfem.Element.HEXAHEDRON, float(side), float(side), float(side))
collection = mfem.H1_FECollection(1, 3)
space = mfem.FiniteElementSpace(mesh, collection, 3)
mesh.SetNodalFESpace(space)
nodes = mfem.GridFunction(space)
mesh.SetNodalGridFunction(nodes)
coordinates = nodes.GetDataArray().reshape(3, -1)
regular = coordinates.T.round().astype(int)
index = regular @ [1, side + 1, (side + 1) ** 2]
coordinates[:] = points[index].T

rules = mfem.IntegrationRules(0, mfem.Quadrature1D.GaussLobatto)
rule = rules.Get(mfem.Geometry.CUBE, ORDER)


def least_determinant():
    def at(cell, q):
        transformation = mesh.GetElementTransformation(cell)
        transformation.SetIntPoint(rule.IntPoint(q))
        return transformation.Jacobian().Det()

    return min(at(cell, q) for cell in range(len(cells)) for q in range(rule.GetNPoints()))


least = mfem.Vector(1)
least[0] = least_determinant()
first = mfem.GridFunction(space)
first.Assign(nodes)
metric = tmop.TMOP_Metric_360()
targets = tmop.TargetConstructor(tmop.TargetConstructor.IDEAL_SHAPE_UNIT_SIZE)
targets.SetNodes(first)
integrator = tmop.TMOP_Integrator(metric, targets)
integrator.SetIntegrationRules(rules, ORDER)
form = mfem.NonlinearForm(space)
form.AddDomainIntegrator(integrator)
fixed = mfem.intArray(mesh.bdr_attributes.Max())
fixed.Assign(1)
form.SetEssentialBC(fixed)
linear = mfem.MINRESSolver()
linear.SetMaxIter(50)
linear.SetRelTol(1e-12)
linear.SetAbsTol(0)
newton = tmop_tools.TMOPNewtonSolver(rule, 0)
newton.SetIntegrationRules(rules, ORDER)
newton.SetPreconditioner(linear)
newton.SetMaxIter(200)
newton.SetRelTol(1e-5)
newton.SetAbsTol(0)
newton.SetPrintLevel(-1)
newton.SetOperator(form)
newton.SetMinDetPtr(least.GetData())

# Its progress goes to standard output, which is the answer's.
answer = os.dup(1)
os.dup2(2, 1)
start = time.process_time()
newton.Mult(mfem.Vector(0), nodes)
seconds = time.process_time() - start
os.dup2(answer, 1)
moved = np.empty_like(points)
moved[index] = nodes.GetDataArray().reshape(3, -1).T
moved_grid.print_result(f"PyMFEM {mfem.MFEM_VERSION}, TMOP", seconds, points, moved, cells)
