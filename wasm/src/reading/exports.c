/* The exports of hexlens-reading.wasm: bytes go into one static input, numbers come out of one
   static output. */
#include "decimal.h"
#include "halves.h"
#include "inflate.h"
#include "text.h"

#define EXPORT(name) __attribute__((export_name(#name)))

enum { INPUT = 1 << 20, PADDING = 16, OUTPUT = 1 << 20, PLACES = 1 << 18, PATTERN = 1 << 10, PART = 1 << 13 };

static _Alignas(8) uint8_t input[INPUT + PADDING];
static uint8_t pattern[PATTERN];
static uint32_t places[PLACES];
static union {
  double numbers[OUTPUT / 8];
  uint32_t indices[OUTPUT / 4];
  uint8_t bytes[OUTPUT];
} output;
static hl_taken taken;
static hl_halves known[INPUT / 8 / PART];

EXPORT(start) void start(void) { hl_start_decimals(); }

EXPORT(input_address) uint8_t *input_address(void) { return input; }
EXPORT(input_length) uint32_t input_length(void) { return INPUT; }
EXPORT(output_address) uint8_t *output_address(void) { return output.bytes; }
EXPORT(output_length) uint32_t output_length(void) { return OUTPUT; }
EXPORT(pattern_address) uint8_t *pattern_address(void) { return pattern; }
EXPORT(pattern_length) uint32_t pattern_length(void) { return PATTERN; }
EXPORT(places_address) uint32_t *places_address(void) { return places; }
EXPORT(places_length) uint32_t places_length(void) { return PLACES; }
EXPORT(parts_address) hl_halves *parts_address(void) { return known; }
EXPORT(part_length) uint32_t part_length(void) { return PART; }
EXPORT(taken_address) hl_taken *taken_address(void) { return &taken; }

EXPORT(numbers) void numbers(uint32_t limit, uint32_t length, uint32_t most) {
  taken = hl_numbers(input, input + limit, input + length, output.numbers, most);
}

EXPORT(indices) void indices(uint32_t limit, uint32_t length, uint32_t most, uint32_t largest) {
  taken = hl_indices(input, input + limit, input + length, output.indices, most, largest);
}

EXPORT(rows) void rows(uint32_t length, uint32_t parts, uint32_t most) {
  taken = hl_rows(input, input + length, pattern, parts, output.numbers, places, most);
}

/* The low halves of `count` integers of 64 bits, part by part. */
EXPORT(halves) void halves(uint32_t count) {
  for (uint32_t from = 0; from < count; from += PART)
    known[from / PART] = hl_low_halves((const uint32_t *)input + 2 * from, count - from < PART ? count - from : PART,
                                       output.indices + from);
}

EXPORT(unzlib) uint32_t unzlib(uint32_t length, uint32_t unpacked) {
  return hl_unzlib(input, length, output.bytes, unpacked);
}
