/* The dual method of Goldfarb and Idnani (A numerically stable dual method for solving strictly convex quadratic programs, 1983) in
   three dimensions, where the objective is |z|^2 / 2: docs/repair.md (R8), (R9). */
#include "nearest.h"
#include "bernstein.h"

#include <math.h>

/* (R12): of a distance to a half-space, in its terms. */
#define DISTANCE_ERROR 0x1p-47
/* (R13): the part of a normal of length 1 that is no longer told from a combination of others, and a factor told from 0. */
#define DEPENDENT 0x1p-32
#define NO_FACTOR 0x1p-44

/* Every step moves away from 0; more than this many are due to rounding. */
enum { MOST_STEPS = 200 };

/* The half-spaces at whose borders z is, with their multipliers and an orthonormal basis of their normals: normal c is
   sum_r basis[r] factors[r][c]. */
typedef struct active_set {
  int count;
  size_t indices[3];
  double multipliers[3];
  double basis[3][3], factors[3][3];
} active_set;

static void normal_of(const half_spaces *all, size_t i, double n[3]) {
  n[0] = all->x[i];
  n[1] = all->y[i];
  n[2] = all->w[i];
}

/* Takes the first `count` basis vectors out of n, twice for the sake of rounding; their parts in n are written. */
static void take_out(const active_set *a, int count, double n[3], double parts[3]) {
  for (int r = 0; r < 3; ++r) parts[r] = 0;
  for (int pass = 0; pass < 2; ++pass)
    for (int b = 0; b < count; ++b) {
      const double part = dot(a->basis[b], n);
      for (int r = 0; r < 3; ++r) n[r] -= part * a->basis[b][r];
      parts[b] += part;
    }
}

static void find_basis(const half_spaces *all, active_set *a) {
  for (int c = 0; c < a->count; ++c) {
    double n[3], parts[3];
    normal_of(all, a->indices[c], n);
    take_out(a, c, n, parts);
    const double length = sqrt(dot(n, n));
    for (int r = 0; r < 3; ++r) {
      a->basis[c][r] = n[r] / length;
      a->factors[r][c] = parts[r];
    }
    a->factors[c][c] = length;
  }
}

static void drop(active_set *a, int at) {
  --a->count;
  for (int i = at; i < a->count; ++i) {
    a->indices[i] = a->indices[i + 1];
    a->multipliers[i] = a->multipliers[i + 1];
  }
}

/* The half-space that z is farthest from, by more than rounding; `count` if there is none. */
static size_t most_violated(const half_spaces *all, const double z[3]) {
  const double size = fabs(z[0]) + fabs(z[1]) + fabs(z[2]);
  double least = 0;
  size_t worst = all->count;
  for (size_t i = 0; i < all->count; ++i) {
    const double distance = all->x[i] * z[0] + all->y[i] * z[1] + all->w[i] * z[2] - all->offset[i];
    if (distance < least && distance < -DISTANCE_ERROR * (size + fabs(all->offset[i]))) {
      least = distance;
      worst = i;
    }
  }
  return worst;
}

/* The half-space `added` and the active ones have no point in common, since its normal is a combination of theirs without a positive
   factor. */
static void support(size_t added, const active_set *a, const double combination[3], nearest_point *found) {
  found->kind = NEAREST_NONE;
  found->supports[0] = added;
  found->weights[0] = 1;
  found->support_count = 1;
  for (int i = 0; i < a->count; ++i) {
    if (combination[i] >= -NO_FACTOR) continue;
    found->supports[found->support_count] = a->indices[i];
    found->weights[found->support_count++] = -combination[i];
  }
}

/* Moves z into the half-space `added`, active ones leaving where their multipliers end. Returns false where that is not possible. */
static bool enter(const half_spaces *all, size_t added, active_set *a, nearest_point *found) {
  double multiplier = 0, normal[3];
  normal_of(all, added, normal);
  for (;;) {
    double direction[3] = {normal[0], normal[1], normal[2]}, combination[3];
    take_out(a, a->count, direction, combination);
    for (int c = a->count - 1; c >= 0; --c) {
      for (int d = c + 1; d < a->count; ++d) combination[c] -= a->factors[c][d] * combination[d];
      combination[c] /= a->factors[c][c];
    }
    int leaving = -1;
    double step = INFINITY;
    for (int i = 0; i < a->count; ++i) {
      if (combination[i] <= NO_FACTOR || a->multipliers[i] >= step * combination[i]) continue;
      step = a->multipliers[i] / combination[i];
      leaving = i;
    }
    const double square = dot(direction, direction);
    const bool is_free = a->count < 3 && square > DEPENDENT * DEPENDENT;
    if (!is_free && leaving < 0) {
      support(added, a, combination, found);
      return false;
    }
    double full = INFINITY;
    if (is_free) full = smaller(larger(all->offset[added] - dot(normal, found->z), 0) / square, full);
    const bool is_full = full <= step;
    if (is_full) step = full;
    for (int r = 0; r < 3 && is_free; ++r) found->z[r] += step * direction[r];
    for (int i = 0; i < a->count; ++i) a->multipliers[i] = larger(a->multipliers[i] - step * combination[i], 0);
    multiplier += step;
    if (is_full) {
      a->indices[a->count] = added;
      a->multipliers[a->count++] = multiplier;
      find_basis(all, a);
      return true;
    }
    drop(a, leaving);
    find_basis(all, a);
  }
}

nearest_point find_nearest(const half_spaces *all) {
  nearest_point found = {.kind = NEAREST_OPEN};
  active_set active = {.count = 0};
  for (int steps = 0; steps < MOST_STEPS; ++steps) {
    const size_t worst = most_violated(all, found.z);
    if (worst == all->count) {
      found.kind = NEAREST_FOUND;
      return found;
    }
    if (!enter(all, worst, &active, &found)) return found;
  }
  return found;
}
