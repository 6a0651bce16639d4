/* Best places: jacdet and volume are affine in the place; the nearest point of half-spaces is one; a best place is not below others nor
   above its bound; turned, scaled and ordered stars have the same bits; what is no star is refused. */
#include "bernstein.h"
#include "map.h"
#include "nearest.h"
#include "random.h"
#include "reference.h"
#include "report.h"
#include "star.h"

#include <stdlib.h>
#include <string.h>

enum { POINTS = 27, CELLS = 8, MIDDLE = 13, STARS = 400, SAMPLES = 200 };

static random_stream stream = {20260601};

/* 2 x 2 x 2 cells with noise, the middle vertex with noise of its own. */
typedef struct grid {
  double points[3 * POINTS];
  uint32_t cells[HL_VERTICES * CELLS];
} grid;

static void random_grid(double sigma, double thrown, grid *g) {
  for (int p = 0; p < POINTS; ++p)
    for (int r = 0; r < 3; ++r) {
      const int number = r == 0 ? p % 3 : r == 1 ? p / 3 % 3 : p / 9;
      g->points[3 * p + r] = number + (p == MIDDLE ? thrown : sigma) * random_normal(&stream);
    }
  for (int c = 0; c < CELLS; ++c)
    for (int v = 0; v < HL_VERTICES; ++v) {
      const int *o = reference_corner[v];
      g->cells[8 * c + v] = (uint32_t)(c % 2 + o[0] + 3 * (c / 2 % 2 + o[1]) + 9 * (c / 4 + o[2]));
    }
}

static hl_star star_of(const grid *g) {
  return (hl_star){{g->points, 3 * POINTS, g->cells, HL_VERTICES * CELLS}, NULL, MIDDLE, NULL};
}

/* In memory of just the size that is asked for, so that sanitizers see what goes beyond. */
static hl_status best_place(const hl_star *star, hl_place *place) {
  const size_t room = hl_best_place_room(star_cell_count(star));
  void *memory = malloc(room);
  const hl_status status = hl_best_place(star, memory, room, place);
  free(memory);
  return status;
}

static hl_place best_of(const hl_star *star) {
  hl_place place = {.round_count = 0};
  CHECK(best_place(star, &place) == HL_OK, "status");
  return place;
}

/* The measure of a place, from the core's minima. */
static double value_at(const hl_star *star, const double place[3], hl_measure measure, const star_cell *cells,
                       int unit) {
  double least = INFINITY;
  for (size_t c = 0; c < star_cell_count(star); ++c) {
    double vertices[24];
    hl_minimum minimum;
    placed_cell(star, cells[c].number, place, vertices);
    hl_boundary_minimum(vertices, HL_ROOTS_B, &minimum);
    const scaled_double volume = find_volume(vertices);
    const double size =
        measure == HL_BY_VOLUME ? ldexp(volume.mantissa, volume.exponent) : ldexp(cells[c].scale, 3 * unit);
    if (!(size > 0)) return -INFINITY;
    least = fmin(least, minimum.minimizer.value / size);
  }
  return least;
}

static void jacdet_and_volume_are_affine(void) {
  for (int n = 0; n < TIMES(2000); ++n) {
    double vertices[24], z[3];
    random_hexahedron(&stream, 0.3, vertices);
    uint8_t moving = (uint8_t)(n % 4 == 0 ? 1 + random_bits(&stream) % 255 : 1u << random_bits(&stream) % 8);
    int first = 0;
    while (!(moving >> first & 1)) ++first;
    for (int v = 0; v < 8; ++v)
      if (moving >> v & 1) memmove(vertices + 3 * v, vertices + 3 * first, 3 * sizeof *vertices);
    const hl_star star = {{vertices, 24, NULL, 0}, &moving, 0, NULL};
    star_frame frame;
    star_cell cell;
    CHECK(read_star(&star, &frame, &cell) == HL_OK, "%d: status", n);
    for (int r = 0; r < 3; ++r) z[r] = random_normal(&stream);
    double place[3], moved[24];
    place_of(&frame, z, place);
    placed_cell(&star, 0, place, moved);
    const double unit = ldexp(1, 3 * frame.exponent), error = 1e-13 * (1 + edge_product(moved));
    long double volume = 0;
    for (int i = 0; i < HL_BERNSTEIN; ++i) {
      /* Simpson's rule on each axis, exact for quadratics. */
      const int at[3] = {i / 9, i / 3 % 3, i % 3};
      const double point[3] = {0.5 * at[0], 0.5 * at[1], 0.5 * at[2]};
      const long double jacdet = reference_jacdet(moved, point);
      long double weight = 1;
      for (int axis = 0; axis < 3; ++axis) weight *= at[axis] == 1 ? 4 / 6.L : 1 / 6.L;
      volume += weight * jacdet;
      if (i == CUBE_CENTRE) continue;
      double weights[27] = {0}, value = 0;
      for (int j = 0; j < HL_BERNSTEIN; ++j) {
        weights[j] = 1;
        for (int axis = 0; axis < 3; ++axis) {
          const int k = axis_digit(j, axis), x = at[axis];
          weights[j] *= x == 1 ? (k == 1 ? 0.5 : 0.25) : (double)(k == x);
        }
        value += weights[j] * affine_at(&cell.bernstein[j], z);
      }
      CHECK(fabsl(value * unit - jacdet) <= error, "%d: jacdet %.17g, affine %.17g", n, (double)jacdet, value * unit);
    }
    CHECK(fabsl(affine_at(&cell.volume, z) * unit - volume) <= error, "%d: volume", n);
  }
}

static void finds_the_nearest_point(void) {
  int found = 0, none = 0;
  for (int n = 0; n < TIMES(4000); ++n) {
    enum { MOST = 40 };
    double x[MOST], y[MOST], w[MOST], offset[MOST];
    const int count = 1 + (int)(random_bits(&stream) % MOST);
    const double shift = 2 * random_unit(&stream) - 1.2;
    for (int i = 0; i < count; ++i) {
      double normal[3], length = 0;
      for (int r = 0; r < 3; ++r) normal[r] = random_normal(&stream);
      if (n % 5 == 0) normal[2] = 0;
      for (int r = 0; r < 3; ++r) length += normal[r] * normal[r];
      x[i] = normal[0] / sqrt(length);
      y[i] = normal[1] / sqrt(length);
      w[i] = normal[2] / sqrt(length);
      offset[i] = shift + 0.3 * random_normal(&stream);
    }
    const half_spaces all = {x, y, w, offset, (size_t)count};
    const nearest_point p = find_nearest(&all);
    CHECK(p.kind != NEAREST_OPEN, "%d: open", n);
    if (p.kind == NEAREST_FOUND) {
      ++found;
      /* z is a combination of normals at whose borders it is, with factors that are not negative: so no other point is nearer. Here by
         points that are: none of them is in all half-spaces. */
      const double size = sqrt(dot(p.z, p.z));
      for (int i = 0; i < count; ++i)
        CHECK(x[i] * p.z[0] + y[i] * p.z[1] + w[i] * p.z[2] >= offset[i] - 1e-12 * (1 + size), "%d: outside %d", n, i);
      for (int s = 0; s < SAMPLES; ++s) {
        double q[3], length = 0;
        for (int r = 0; r < 3; ++r) q[r] = p.z[r] + (s % 2 ? 0.1 : 1) * size * random_normal(&stream);
        for (int r = 0; r < 3; ++r) length += q[r] * q[r];
        if (sqrt(length) >= size * (1 - 1e-9)) continue;
        bool is_inside = true;
        for (int i = 0; i < count; ++i) is_inside = is_inside && x[i] * q[0] + y[i] * q[1] + w[i] * q[2] >= offset[i];
        CHECK(!is_inside, "%d: a nearer point", n);
      }
    } else {
      ++none;
      double sum[3] = {0, 0, 0}, rise = 0;
      for (int i = 0; i < p.support_count; ++i) {
        const size_t at = p.supports[i];
        CHECK(p.weights[i] > 0, "%d: weight", n);
        sum[0] += p.weights[i] * x[at];
        sum[1] += p.weights[i] * y[at];
        sum[2] += p.weights[i] * w[at];
        rise += p.weights[i] * offset[at];
      }
      CHECK(rise > 0, "%d: no contradiction", n);
      for (int r = 0; r < 3; ++r) CHECK(fabs(sum[r]) < 1e-9, "%d: normals do not cancel, %.3g", n, sum[r]);
    }
  }
  CHECK(found > TIMES(400) && none > TIMES(400), "%d found, %d without", found, none);
}

static void no_place_around_is_better(void) {
  int valid = 0, held = 0;
  for (int n = 0; n < TIMES(STARS); ++n) {
    grid g;
    random_grid(0.05 + 0.05 * (n % 5), n % 3 == 0 ? 2 : 0.3, &g);
    const hl_star star = star_of(&g);
    const hl_place best = best_of(&star);
    star_frame frame;
    star_cell cells[CELLS];
    read_star(&star, &frame, cells);
    const double value = value_at(&star, best.position, best.measure, cells, frame.exponent);
    CHECK(fabs(value - best.value) <= 1e-12 * fabs(value), "%d: %.17g there, %.17g said", n, value, best.value);
    CHECK(best.is_closed && best.bound >= best.value && best.bound - best.value <= 1.1e-6 * fabs(best.value),
          "%d: %.17g, bound %.17g", n, best.value, best.bound);
    if (best.measure == HL_BY_VOLUME) ++valid;
    else ++held;
    CHECK((best.measure == HL_BY_VOLUME) == (best.value > 0), "%d: measure %d of %.17g", n, best.measure, best.value);
    for (int s = 0; s < SAMPLES; ++s) {
      double place[3];
      const double size = pow(10, -3. * random_unit(&stream));
      for (int r = 0; r < 3; ++r) place[r] = best.position[r] + size * random_normal(&stream);
      const double there = value_at(&star, place, best.measure, cells, frame.exponent);
      CHECK(there <= best.bound + 1e-12, "%d: %.17g is above the bound %.17g", n, there, best.bound);
    }
  }
  CHECK(valid > TIMES(100) && held > TIMES(40), "%d valid, %d held", valid, held);
}

/* Limits of coordinates, planes and lines: the best place is within, exactly where they are coordinates', and none around it is better. */
static void stays_within_limits(void) {
  int valid = 0, held = 0, at_sides = 0;
  for (int n = 0; n < TIMES(STARS); ++n) {
    grid g;
    random_grid(0.05 + 0.05 * (n % 4), n % 3 == 0 ? 1 : 0.3, &g);
    hl_limits limits = {{-INFINITY, -INFINITY, -INFINITY}, {INFINITY, INFINITY, INFINITY}, {{0, 0, 0}, {0, 0, 0}}};
    const double *from = g.points + 3 * MIDDLE;
    const bool has_box = n % 2, is_turned = n / 2 % 2;
    const int normal_count = n / 4 % 3;
    for (int r = 0; r < 3 && has_box; ++r) {
      limits.low[r] = from[r] - 0.2 * random_unit(&stream);
      limits.high[r] = from[r] + (r == 1 ? 0 : 0.2 * random_unit(&stream));
    }
    for (int i = 0; i < normal_count; ++i)
      for (int r = 0; r < 3; ++r) limits.normals[i][r] = is_turned ? random_normal(&stream) : 3 * (r == i);
    hl_star star = star_of(&g);
    star.limits = &limits;
    const hl_place best = best_of(&star);
    star_frame frame;
    star_cell cells[CELLS];
    CHECK(read_star(&star, &frame, cells) == HL_OK, "%d: status", n);
    valid += best.measure == HL_BY_VOLUME;
    held += best.measure == HL_BY_SCALE;
    CHECK(best.is_closed, "%d: %.17g, bound %.17g", n, best.value, best.bound);
    for (int h = 0; h < best.hold_count; ++h) at_sides += best.holds[h].cell == HL_BOX_SIDE;
    double way[3];
    for (int r = 0; r < 3; ++r) {
      CHECK(limits.low[r] <= best.position[r] && best.position[r] <= limits.high[r], "%d: axis %d", n, r);
      CHECK(is_turned || r >= normal_count || best.position[r] == from[r], "%d: axis %d", n, r);
      way[r] = best.position[r] - from[r];
    }
    for (int i = 0; i < normal_count; ++i)
      CHECK(fabs(dot(limits.normals[i], way)) < 1e-13, "%d: %g out of a plane", n, dot(limits.normals[i], way));
    for (int s = 0; s < SAMPLES; ++s) {
      double step[3], place[3];
      const double size = pow(10, -3. * random_unit(&stream));
      for (int a = 0; a < 3; ++a) step[a] = size * random_normal(&stream);
      project(&frame, step);
      bool is_within = true;
      for (int a = 0; a < 3; ++a) {
        const int r = frame.axis[a];
        place[r] = best.position[r] + frame.sign[a] * step[a];
        is_within = is_within && limits.low[r] <= place[r] && place[r] <= limits.high[r];
      }
      if (!is_within) continue;
      const double there = value_at(&star, place, best.measure, cells, frame.exponent);
      CHECK(there <= best.bound + 1e-12, "%d: %.17g is above the bound %.17g", n, there, best.bound);
    }
  }
  CHECK(valid > TIMES(80) && held > TIMES(40) && at_sides > TIMES(60), "%d valid, %d held, %d", valid, held, at_sides);
}

static void refuses_other_limits(void) {
  grid g;
  random_grid(0.1, 0.1, &g);
  hl_star star = star_of(&g);
  hl_place place;
  hl_limits limits = {{-9, -9, -9}, {9, 9, 0}, {{0, 0, 0}, {0, 0, 0}}};
  star.limits = &limits;
  CHECK(best_place(&star, &place) == HL_OUTSIDE_LIMITS, "a vertex above its limit");
  limits = (hl_limits){{-9, -9, -9}, {9, 9, 9}, {{1, 2, 3}, {2, 4, 6}}};
  CHECK(best_place(&star, &place) == HL_OUTSIDE_LIMITS, "a normal twice");
  limits.low[0] = NAN;
  CHECK(best_place(&star, &place) == HL_OUTSIDE_LIMITS, "not a number");
}

/* Where one point that no place lifts holds the value, all places of a region are best: none of them is nearer. */
static void takes_the_nearest_of_several(void) {
  int count = 0;
  for (int n = 0; n < TIMES(STARS); ++n) {
    grid g;
    random_grid(0.3, 0.6, &g);
    const hl_star star = star_of(&g);
    const hl_place best = best_of(&star);
    if (best.hold_count != 1 || !best.is_moved) continue;
    ++count;
    star_frame frame;
    star_cell cells[CELLS];
    read_star(&star, &frame, cells);
    const double *from = g.points + 3 * MIDDLE;
    double distance = 0;
    for (int r = 0; r < 3; ++r) distance += (best.position[r] - from[r]) * (best.position[r] - from[r]);
    for (int s = 0; s < SAMPLES; ++s) {
      double place[3], square = 0;
      for (int r = 0; r < 3; ++r) {
        place[r] = best.position[r] + (s % 2 ? 0.05 : 0.5) * sqrt(distance) * random_normal(&stream);
        square += (place[r] - from[r]) * (place[r] - from[r]);
      }
      if (sqrt(square) > 0.999 * sqrt(distance)) continue;
      const double there = value_at(&star, place, best.measure, cells, frame.exponent);
      CHECK(there < best.bound - 1e-12, "%d: a nearer place with %.17g, bound %.17g", n, there, best.bound);
    }
  }
  CHECK(count > TIMES(100), "%d", count);
}

static bool is_same_place(const double p[3], const double q[3]) { return memcmp(p, q, 3 * sizeof *p) == 0; }

/* Rotations about the axes by right angles, a power of two, another order of cells, points and mirror images of nothing. */
static void has_the_same_bits_however_it_lies(void) {
  static const int axes[4][3] = {{1, 2, 0}, {1, 0, 2}, {0, 1, 2}, {2, 1, 0}};
  static const double signs[4][3] = {{1, 1, 1}, {1, 1, -1}, {-1, -1, 1}, {-1, 1, 1}};
  for (int n = 0; n < TIMES(STARS); ++n) {
    grid g, turned;
    random_grid(0.05 + 0.05 * (n % 5), n % 3 == 0 ? 2 : 0.3, &g);
    const int turn = n % 4, power = (int)(random_bits(&stream) % 400) - 200;
    for (int p = 0; p < POINTS; ++p)
      for (int r = 0; r < 3; ++r)
        turned.points[3 * p + r] = signs[turn][r] * ldexp(g.points[3 * p + axes[turn][r]], power);
    const int first = (int)(random_bits(&stream) % CELLS);
    for (int c = 0; c < CELLS; ++c)
      memcpy(turned.cells + 8 * c, g.cells + 8 * ((3 * c + first) % CELLS), 8 * sizeof(uint32_t));
    const hl_star star = star_of(&g), other = star_of(&turned);
    const hl_place best = best_of(&star), same = best_of(&other);
    double expected[3];
    for (int r = 0; r < 3; ++r) expected[r] = signs[turn][r] * ldexp(best.position[axes[turn][r]], power);
    CHECK(is_same_place(expected, same.position), "%d: %.17g or %.17g", n, expected[0], same.position[0]);
    CHECK(best.value == same.value && best.bound == same.bound, "%d: value or bound", n);
    CHECK(best.hold_count == same.hold_count, "%d: holds", n);
    for (int h = 0; h < best.hold_count; ++h)
      CHECK(best.holds[h].weight == same.holds[h].weight &&
                best.holds[h].cell == (3 * same.holds[h].cell + (unsigned)first) % CELLS,
            "%d: hold %d", n, h);
  }
}

static void blocks_are_as_indices(void) {
  for (int n = 0; n < TIMES(100); ++n) {
    grid g;
    double blocks[24 * CELLS];
    uint8_t moving[CELLS];
    random_grid(0.2, 0.3, &g);
    for (int c = 0; c < CELLS; ++c) {
      moving[c] = 0;
      for (int v = 0; v < 8; ++v) {
        const uint32_t p = g.cells[8 * c + v];
        memcpy(blocks + 24 * c + 3 * v, g.points + 3 * p, 3 * sizeof(double));
        moving[c] = (uint8_t)(moving[c] | (p == MIDDLE) << v);
      }
    }
    const hl_star by_indices = star_of(&g), by_blocks = {{blocks, 24 * CELLS, NULL, 0}, moving, 0, NULL};
    const hl_place one = best_of(&by_indices), other = best_of(&by_blocks);
    CHECK(is_same_place(one.position, other.position) && one.bound == other.bound, "%d", n);
  }
}

static void any_vertex_of_one_cell(void) {
  for (int n = 0; n < TIMES(1600); ++n) {
    double vertices[24];
    random_hexahedron(&stream, 0.02 * (1 + n % 20), vertices);
    const uint8_t moving = (uint8_t)(1u << n % 8);
    const hl_star star = {{vertices, 24, NULL, 0}, &moving, 0, NULL};
    const hl_place best = best_of(&star);
    CHECK(best.is_closed, "%d: value %.17g, bound %.17g", n, best.value, best.bound);
    CHECK(!(best.relative_minimum < best.present_relative_minimum) || best.measure == HL_BY_SCALE, "%d: worse", n);
  }
}

static void every_finite_star_is_answered(void) {
  for (int n = 0; n < TIMES(3000); ++n) {
    double vertices[24];
    uint8_t moving = (uint8_t)(1u << n % 8);
    for (int i = 0; i < 24; ++i) {
      const uint64_t bits = random_bits(&stream) & (n % 3 ? ~(uint64_t)0 : 0xc00fffffffffffffu);
      memcpy(&vertices[i], &bits, sizeof bits);
      if (!isfinite(vertices[i])) vertices[i] = 0;
      if (n % 7 == 0) vertices[i] = (double)(bits % 3);
    }
    const hl_star star = {{vertices, 24, NULL, 0}, &moving, 0, NULL};
    const hl_place best = best_of(&star);
    for (int r = 0; r < 3; ++r) CHECK(isfinite(best.position[r]), "%d: no place", n);
    CHECK(best.bound >= best.value, "%d: value %.17g, bound %.17g", n, best.value, best.bound);
  }
}

static void refuses_what_is_no_star(void) {
  grid g;
  random_grid(0.1, 0.1, &g);
  hl_place place = {.round_count = 7};
  hl_star star = star_of(&g);
  double memory[8];
  CHECK(hl_best_place(&star, memory, sizeof memory, &place) == HL_NO_ROOM, "little room");
  star.cells.index_count = 63;
  CHECK(best_place(&star, &place) == HL_INCOMPLETE, "63 indices");
  star.cells.index_count = 0;
  CHECK(best_place(&star, &place) == HL_MISSING_LIST, "no cells");
  star = star_of(&g);
  star.vertex = 12;
  CHECK(best_place(&star, &place) == HL_NOTHING_MOVES, "a vertex that not all cells have");
  star = star_of(&g);
  g.cells[5] = POINTS;
  CHECK(best_place(&star, &place) == HL_NO_SUCH_POINT, "an index too many");
  random_grid(0.1, 0.1, &g);
  g.points[7] = NAN;
  CHECK(best_place(&star, &place) == HL_NOT_FINITE, "NaN");
  const uint8_t moving[2] = {1, 2};
  double blocks[48];
  random_hexahedron(&stream, 0.1, blocks);
  random_hexahedron(&stream, 0.1, blocks + 24);
  star = (hl_star){{blocks, 48, NULL, 0}, moving, 0, NULL};
  CHECK(best_place(&star, &place) == HL_SEVERAL_PLACES, "two places");
  star.moving = NULL;
  CHECK(best_place(&star, &place) == HL_MISSING_LIST, "blocks without bits");
  CHECK(place.round_count == 7, "the output was written");
}

int main(void) {
  RUN(jacdet_and_volume_are_affine);
  RUN(finds_the_nearest_point);
  RUN(no_place_around_is_better);
  RUN(stays_within_limits);
  RUN(refuses_other_limits);
  RUN(takes_the_nearest_of_several);
  RUN(has_the_same_bits_however_it_lies);
  RUN(blocks_are_as_indices);
  RUN(any_vertex_of_one_cell);
  RUN(every_finite_star_is_answered);
  RUN(refuses_what_is_no_star);
  return test_summary();
}
