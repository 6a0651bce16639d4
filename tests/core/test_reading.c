/* The readers' C, against strtod and itself; under the sanitizers no byte beyond a text may be read. */
#include <math.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

#include "check.h"
#include "random.h"
#include "reading/decimal.h"
#include "reading/halves.h"
#include "reading/inflate.h"
#include "reading/text.h"

enum { LONGEST = 2000 };

/* The double of a word, read from a copy that ends where the word does. */
static double value_of(const char *word, bool *is_whole_word) {
  const size_t length = strlen(word);
  uint8_t *bytes = malloc(length);
  memcpy(bytes, word, length);
  hl_decimal number;
  const uint8_t *end = hl_scan_decimal(bytes, bytes + length, false, &number);
  *is_whole_word = end == bytes + length;
  const double value = end == NULL ? NAN : hl_double_of(&number);
  free(bytes);
  return value;
}

static void check_word(const char *word) {
  bool is_whole_word;
  const double value = value_of(word, &is_whole_word), expected = strtod(word, NULL);
  CHECK(is_whole_word && memcmp(&value, &expected, sizeof value) == 0, "%s became %.17g, not %.17g", word, value,
        expected);
}

static void doubles_are_those_of_strtod(void) {
  static const char *const words[] = {
      "0",
      "-0",
      "1",
      ".5",
      "1.",
      "1e400",
      "-1e400",
      "1e-400",
      "1e99999999999",
      "2.4703282292062327e-324",
      "2.4703282292062328e-324",
      "4.9406564584124654e-324",
      "2.2250738585072011e-308",
      "2.2250738585072014e-308",
      "1.7976931348623157e308",
      "1.7976931348623158e308",
      "1.7976931348623159e308",
      "9007199254740993",
      "9007199254740992.999999999999999999999",
      "18446744073709551616",
      "0.000000000000000000000000000000000000123",
  };
  for (size_t i = 0; i < sizeof words / sizeof *words; ++i) check_word(words[i]);
}

static void random_digits_are_those_of_strtod(void) {
  random_stream stream = {20261};
  for (int i = 0; i < 200000; ++i) {
    char word[LONGEST + 32];
    const int count = i % 50 == 0 ? 1 + (int)(random_bits(&stream) % 900) : 1 + (int)(random_bits(&stream) % 22);
    const int point = (int)(random_bits(&stream) % (uint64_t)(count + 1));
    int at = 0;
    if (random_bits(&stream) % 2 == 0) word[at++] = '-';
    for (int k = 0; k < count; ++k) {
      if (k == point) word[at++] = '.';
      word[at++] = (char)('0' + random_bits(&stream) % 10);
    }
    const int exponent = (int)(random_bits(&stream) % 700) - 350 - (i % 2 == 0 ? count : 0);
    snprintf(word + at, sizeof word - (size_t)at, "e%d", exponent);
    check_word(word);
  }
}

static void middles_go_to_even_and_their_neighbours_do_not(void) {
  random_stream stream = {7};
  for (int i = 0; i < 2000; ++i) {
    /* k + 1/2 units in the last place, whose decimals strtod reads exactly, too. */
    const double least =
        ldexp((double)((random_bits(&stream) >> 11) | (UINT64_C(1) << 52)), -(int)(random_bits(&stream) % 60));
    char word[LONGEST];
    snprintf(word, sizeof word, "%.120f", least);
    check_word(word);
    snprintf(word, sizeof word, "%.60f5", least);
    check_word(word);
  }
}

static void any_bytes_are_read_within_their_bounds(void) {
  static const char letters[] = "0123456789.-+eEdD, \n\t";
  static const uint8_t patterns[][16] = {
      {HL_WHOLE, 0, HL_REAL, 0, HL_LINE_END},
      {HL_WHOLE, 8, HL_BLANKS, 1, HL_REAL, 8, HL_LINE_END},
      {HL_BYTES, 1, '1', HL_COMMA, HL_REAL, 0, HL_LINE_END},
  };
  static const uint32_t lengths[] = {5, 7, 7};
  random_stream stream = {3};
  for (int i = 0; i < 100000; ++i) {
    const uint32_t length = (uint32_t)(random_bits(&stream) % 40);
    uint8_t *bytes = malloc(length + 1);
    for (uint32_t k = 0; k < length; ++k) bytes[k] = (uint8_t)letters[random_bits(&stream) % (sizeof letters - 1)];
    uint8_t *text = malloc(length > 0 ? length : 1);
    memcpy(text, bytes, length);
    double numbers[64];
    uint32_t places[64], indices[64];
    const hl_taken run = hl_numbers(text, text + length, text + length, numbers, 64);
    CHECK(run.bytes <= length, "%u of %u bytes", run.bytes, length);
    CHECK(hl_indices(text, text + length, text + length, indices, 64, 255).bytes <= length, "more than %u bytes",
          length);
    for (size_t k = 0; k < 3; ++k) {
      const hl_taken rows = hl_rows(text, text + length, patterns[k], lengths[k], numbers, places, 16);
      CHECK(rows.bytes <= length && (rows.count == 0 || text[rows.bytes - 1] == '\n'), "a row ends within a line");
    }
    free(text);
    free(bytes);
  }
}

static void any_bytes_are_inflated_within_their_bounds(void) {
  random_stream stream = {5};
  int whole = 0;
  for (int i = 0; i < 100000; ++i) {
    const uint32_t length = 6 + (uint32_t)(random_bits(&stream) % 60);
    uint8_t *input = calloc(length + 8, 1);
    input[0] = 0x78;
    input[1] = 0x01;
    for (uint32_t k = 2; k < length; ++k) input[k] = (uint8_t)random_bits(&stream);
    const uint32_t room = (uint32_t)(random_bits(&stream) % 300);
    uint8_t *output = malloc(room + 1);
    whole += hl_unzlib(input, length, output, room);
    free(output);
    free(input);
  }
  CHECK(whole == 0, "%d random streams have a right checksum", whole);
}

static hl_halves halves_by_a_plain_loop(const uint64_t *numbers, uint32_t count) {
  hl_halves known = {0, INT32_MAX, INT32_MIN, 0};
  bool has_step = count > 1;
  for (uint32_t i = 0; i < count; ++i) {
    const int32_t low = (int32_t)(uint32_t)numbers[i];
    known.high |= numbers[i] >> 32 != 0;
    if (low < known.least) known.least = low;
    if (low > known.greatest) known.greatest = low;
    if (i > 0 && (uint32_t)(numbers[i] - numbers[i - 1]) != (uint32_t)(numbers[1] - numbers[0])) has_step = false;
  }
  if (has_step) known.step = (uint32_t)(numbers[1] - numbers[0]);
  return known;
}

static void check_halves(const uint64_t *numbers, uint32_t count) {
  /* Copies that end where the numbers do. */
  uint32_t *words = calloc(count, 2 * sizeof *words), *low = malloc(count * sizeof *low);
  for (uint32_t i = 0; i < count; ++i) {
    words[2 * i] = (uint32_t)numbers[i];
    words[2 * i + 1] = (uint32_t)(numbers[i] >> 32);
  }
  const hl_halves known = hl_low_halves(words, count, low), expected = halves_by_a_plain_loop(numbers, count);
  CHECK((known.high != 0) == (expected.high != 0), "%u numbers: high halves are %x", count, known.high);
  CHECK(known.least == expected.least && known.greatest == expected.greatest, "%u numbers: from %d to %d, not %d to %d",
        count, known.least, known.greatest, expected.least, expected.greatest);
  CHECK(known.step == expected.step, "%u numbers: the step is %u, not %u", count, known.step, expected.step);
  for (uint32_t i = 0; i < count; ++i)
    CHECK(low[i] == (uint32_t)numbers[i], "%u numbers: %u became %u", count, (uint32_t)numbers[i], low[i]);
  free(low);
  free(words);
}

static void low_halves_are_those_of_a_plain_loop(void) {
  enum { PART = 8192 };
  static uint64_t numbers[PART];
  static const uint32_t steps[] = {0, 1, 8, 0xfffffff8u, 0x80000000u};
  random_stream stream = {11};
  for (uint32_t length = 1; length <= 41; ++length) {
    const uint32_t count = length <= 40 ? length : PART;
    /* Without a sign, with one, and with high halves now and then. */
    for (int kind = 0; kind < 3; ++kind) {
      for (uint32_t i = 0; i < count; ++i) {
        const uint64_t bits = random_bits(&stream);
        numbers[i] = kind == 0 ? bits & INT32_MAX : kind == 1 ? bits & UINT32_MAX : bits % 8 ? bits & 0xff : bits;
      }
      check_halves(numbers, count);
    }
    for (size_t s = 0; s < sizeof steps / sizeof *steps; ++s) {
      const uint64_t first = random_bits(&stream) & 0xffffff;
      for (uint32_t i = 0; i < count; ++i) numbers[i] = (uint32_t)(first + i * steps[s]);
      check_halves(numbers, count);
      /* One that is out of step, least, greatest or high, in each place of the short ones. */
      for (uint32_t i = 0; i < count; i += count <= 40 ? 1 : 1023) {
        static const uint64_t others[] = {1, INT32_MAX, 0x80000000u, UINT64_C(1) << 32, UINT64_C(1) << 63, UINT64_MAX};
        const uint64_t own = numbers[i];
        for (size_t o = 0; o < sizeof others / sizeof *others; ++o) {
          numbers[i] = own ^ others[o];
          check_halves(numbers, count);
        }
        numbers[i] = own;
      }
    }
  }
}

int main(void) {
  hl_start_decimals();
  RUN(doubles_are_those_of_strtod);
  RUN(random_digits_are_those_of_strtod);
  RUN(middles_go_to_even_and_their_neighbours_do_not);
  RUN(any_bytes_are_read_within_their_bounds);
  RUN(any_bytes_are_inflated_within_their_bounds);
  RUN(low_halves_are_those_of_a_plain_loop);
  return test_summary();
}
