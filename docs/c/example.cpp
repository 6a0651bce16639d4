// As example.c, from C++17: one hexahedron, then a small mesh. docs/c-library.md says how to compile it.
#include <hexlens.h>

#include <array>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <optional>
#include <vector>

struct Minimum {
  double jacdet;
  std::array<double, 3> point;
};

struct InvalidCell {
  std::size_t cell;
  Minimum minimum;
};

struct Mesh {
  std::vector<double> points;
  std::vector<std::uint32_t> indices;
};

// Nothing if a coordinate is not finite.
std::optional<bool> is_valid(const std::array<double, HL_COORDINATES> &vertices) {
  hl_verdict verdict;
  if (hl_decide(vertices.data(), &verdict) != HL_OK) return std::nullopt;
  return verdict == HL_VALID;
}

std::optional<Minimum> boundary_minimum(const std::array<double, HL_COORDINATES> &vertices) {
  hl_minimum least;
  if (hl_boundary_minimum(vertices.data(), HL_ROOTS_B, &least) != HL_OK) return std::nullopt;
  const double *point = least.minimizer.point;
  return Minimum{std::ldexp(least.minimizer.value, least.exponent), {point[0], point[1], point[2]}};
}

// Nothing if the mesh is not one of hexahedra with finite coordinates.
std::optional<std::vector<InvalidCell>> invalid_cells(const Mesh &mesh) {
  const std::size_t count = mesh.indices.size() / HL_VERTICES;
  std::vector<std::uint8_t> verdicts(count);
  std::vector<double> minima(count), minimizers(3 * count), corner_minima(count);
  std::vector<std::int16_t> exponents(count);

  const hl_cells cells = {mesh.points.data(), mesh.points.size(), mesh.indices.data(), mesh.indices.size()};
  hl_batch batch = {};
  batch.verdicts = verdicts.data();
  batch.minima = minima.data();
  batch.minimizers = minimizers.data();
  batch.corner_minima = corner_minima.data();
  batch.exponents = exponents.data();
  if (hl_classify(&cells, &batch) != HL_OK) return std::nullopt;

  std::vector<InvalidCell> invalid;
  for (std::size_t c = 0; c < count; ++c)
    if (verdicts[c] == HL_INVALID)
      invalid.push_back(
          {c,
           {std::ldexp(minima[c], exponents[c]), {minimizers[3 * c], minimizers[3 * c + 1], minimizers[3 * c + 2]}}});
  return invalid;
}

int main() {
  std::printf("Hexlens %s\n", hl_version());

  // All eight vertices and all twelve edges are positive; on a face jacdet is negative.
  const std::array<double, HL_COORDINATES> hexahedron = {
      0.5,  0.25, 0.25, // 0
      1,    0,    1,    // 1
      0.5,  0.75, 0.25, // 2
      0,    1,    1,    // 3
      0,    0,    0,    // 4
      0.75, 0.5,  0.75, // 5
      1,    1,    0,    // 6
      0.25, 0.5,  0.75  // 7
  };
  const auto valid = is_valid(hexahedron);
  const auto least = boundary_minimum(hexahedron);
  if (!valid || !least) return 1;
  std::printf("The hexahedron is %s: jacdet is %.6f at xi, eta, zeta = %.6f, %.6f, %.6f.\n",
              *valid ? "valid" : "invalid", least->jacdet, least->point[0], least->point[1], least->point[2]);

  // Three cubes in a row along x. Point 15 is too far back, so that the last cell is folded.
  Mesh mesh;
  for (double z : {0., 1.})
    for (double y : {0., 1.})
      for (double x : {0., 1., 2., 3.}) mesh.points.insert(mesh.points.end(), {x, y, z});
  mesh.points[3 * 15] = 1.5;
  for (std::uint32_t c = 0; c < 3; ++c)
    mesh.indices.insert(mesh.indices.end(), {c, c + 1, c + 5, c + 4, c + 8, c + 9, c + 13, c + 12});

  const auto invalid = invalid_cells(mesh);
  if (!invalid) return 1;
  const std::size_t count = mesh.indices.size() / HL_VERTICES;
  std::printf("%zu of %zu cells are valid.\n", count - invalid->size(), count);
  for (const auto &[cell, minimum] : *invalid)
    std::printf("Cell %zu is invalid: jacdet is %g at %g, %g, %g.\n", cell, minimum.jacdet, minimum.point[0],
                minimum.point[1], minimum.point[2]);
}
