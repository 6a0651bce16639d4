/*
 * Inflating, as web/mesh/codecs/inflate.ts does it, which also says what is wrong with a stream that is damaged: 64 bits of the
 * input are held, and of each code the first ten bits are looked up at once.
 */
#include "inflate.h"

#include <string.h>

enum { FIRST_BITS = 10, LONGEST = 15, LITERALS = 288, DISTANCES = 32, END = 256, NO_CODE = 0 };

/* An entry is a symbol * 16 + its bits; in the first table, where bit 15 is set, the place of a second table of `second_bits` bits. */
typedef struct code {
  uint16_t table[(1 << FIRST_BITS) + LITERALS * (1 << (LONGEST - FIRST_BITS))];
  int second_bits;
} code;

enum { SECOND = 1 << 15 };

static code literals, distances, code_lengths;

typedef struct stream {
  const uint8_t *at, *end;
  uint64_t held;
  int bits;
} stream;

static const uint16_t LENGTH_BASE[] = {3,  4,  5,  6,  7,  8,  9,  10, 11,  13,  15,  17,  19,  23, 27,
                                       31, 35, 43, 51, 59, 67, 83, 99, 115, 131, 163, 195, 227, 258};
static const uint8_t LENGTH_BITS[] = {0, 0, 0, 0, 0, 0, 0, 0, 1, 1, 1, 1, 2, 2, 2,
                                      2, 3, 3, 3, 3, 4, 4, 4, 4, 5, 5, 5, 5, 0};
static const uint16_t DISTANCE_BASE[] = {1,    2,    3,    4,    5,    7,    9,    13,    17,    25,
                                         33,   49,   65,   97,   129,  193,  257,  385,   513,   769,
                                         1025, 1537, 2049, 3073, 4097, 6145, 8193, 12289, 16385, 24577};
static const uint8_t DISTANCE_BITS[] = {0, 0, 0, 0, 1, 1, 2, 2,  3,  3,  4,  4,  5,  5,  6,
                                        6, 7, 7, 8, 8, 9, 9, 10, 10, 11, 11, 12, 12, 13, 13};
static const uint8_t CODE_LENGTH_ORDER[] = {16, 17, 18, 0, 8, 7, 9, 6, 10, 5, 11, 4, 12, 3, 13, 2, 14, 1, 15};

/* At least 56 bits are held then, the last of them zeros behind the end of the input. */
static inline void hold(stream *s) {
  uint64_t next;
  if (s->at <= s->end) {
    memcpy(&next, s->at, sizeof next);
    s->held |= next << s->bits;
  }
  s->at += (63 - s->bits) >> 3;
  s->bits |= 56;
}

static inline uint32_t take(stream *s, int count) {
  const uint32_t value = (uint32_t)(s->held & ((UINT64_C(1) << count) - 1));
  s->held >>= count;
  s->bits -= count;
  return value;
}

/* False unless the lengths make a complete code, or one with a single symbol. */
static bool set_code(code *c, const uint8_t *lengths, int count) {
  uint16_t counts[LONGEST + 1] = {0}, next[LONGEST + 1] = {0};
  for (int i = 0; i < count; ++i) ++counts[lengths[i]];
  const int codes = count - counts[0];
  counts[0] = 0;
  int left = 1, longest = 0;
  for (int bits = 1; bits <= LONGEST; ++bits) {
    left = 2 * left - counts[bits];
    if (left < 0) return false;
    next[bits] = (uint16_t)((next[bits - 1] + counts[bits - 1]) << 1);
    if (counts[bits] > 0) longest = bits;
  }
  if (left > 0 && codes > 1) return false;
  const int second_bits = longest > FIRST_BITS ? longest - FIRST_BITS : 0;
  c->second_bits = second_bits;
  memset(c->table, NO_CODE, sizeof(uint16_t) << FIRST_BITS);
  int used = 1 << FIRST_BITS;
  for (int symbol = 0; symbol < count; ++symbol) {
    const int length = lengths[symbol];
    if (length == 0) continue;
    const int own = next[length]++;
    int reversed = 0;
    for (int bit = 0; bit < length; ++bit) reversed |= (own >> bit & 1) << (length - 1 - bit);
    const uint16_t entry = (uint16_t)(symbol << 4 | length);
    if (length <= FIRST_BITS) {
      for (int i = reversed; i < 1 << FIRST_BITS; i += 1 << length) c->table[i] = entry;
      continue;
    }
    uint16_t *first = &c->table[reversed & ((1 << FIRST_BITS) - 1)];
    if (*first == NO_CODE) {
      memset(&c->table[used], NO_CODE, sizeof(uint16_t) << second_bits);
      *first = (uint16_t)(SECOND | used);
      used += 1 << second_bits;
    }
    uint16_t *second = &c->table[*first & ~SECOND];
    for (int i = reversed >> FIRST_BITS; i < 1 << second_bits; i += 1 << (length - FIRST_BITS)) second[i] = entry;
  }
  return true;
}

/* The entry of the symbol that is next. */
static inline uint32_t entry_of(const code *c, const stream *s) {
  const uint32_t entry = c->table[s->held & ((1 << FIRST_BITS) - 1)];
  if ((entry & SECOND) == 0) return entry;
  return c->table[(entry & ~(uint32_t)SECOND) + (s->held >> FIRST_BITS & ((UINT64_C(1) << c->second_bits) - 1))];
}

static bool read_codes(stream *s) {
  uint8_t lengths[LITERALS + DISTANCES];
  hold(s);
  const int literal_count = (int)take(s, 5) + 257;
  const int count = literal_count + (int)take(s, 5) + 1;
  const int code_count = (int)take(s, 4) + 4;
  memset(lengths, 0, sizeof CODE_LENGTH_ORDER);
  for (int i = 0; i < code_count; ++i) {
    hold(s);
    lengths[CODE_LENGTH_ORDER[i]] = (uint8_t)take(s, 3);
  }
  if (literal_count > 286 || !set_code(&code_lengths, lengths, sizeof CODE_LENGTH_ORDER)) return false;
  for (int i = 0; i < count;) {
    hold(s);
    const uint32_t entry = entry_of(&code_lengths, s);
    if (entry == NO_CODE) return false;
    take(s, entry & 15);
    const uint32_t symbol = entry >> 4;
    if (symbol < 16) {
      lengths[i++] = (uint8_t)symbol;
      continue;
    }
    if (symbol == 16 && i == 0) return false;
    const uint8_t repeated = symbol == 16 ? lengths[i - 1] : 0;
    const int times = symbol == 16 ? 3 + (int)take(s, 2) : symbol == 17 ? 3 + (int)take(s, 3) : 11 + (int)take(s, 7);
    if (i + times > count) return false;
    memset(lengths + i, repeated, (size_t)times);
    i += times;
  }
  return lengths[END] != 0 && set_code(&literals, lengths, literal_count) &&
         set_code(&distances, lengths + literal_count, count - literal_count);
}

static void set_fixed_codes(void) {
  uint8_t lengths[LITERALS];
  memset(lengths, 8, 144);
  memset(lengths + 144, 9, 112);
  memset(lengths + 256, 7, 24);
  memset(lengths + 280, 8, 8);
  set_code(&literals, lengths, LITERALS);
  memset(lengths, 5, DISTANCES);
  set_code(&distances, lengths, DISTANCES);
}

/* The end of the block's output; NULL if the block is damaged or does not fit. */
static uint8_t *inflate_block(stream *s, const uint8_t *begin, uint8_t *to, const uint8_t *end) {
  for (;;) {
    /* A symbol and its distance take at most 15 + 5 + 15 + 13 bits. */
    hold(s);
    uint32_t entry = entry_of(&literals, s);
    if (entry == NO_CODE || s->at - 8 > s->end) return NULL;
    take(s, entry & 15);
    uint32_t symbol = entry >> 4;
    if (symbol < END) {
      if (to == end) return NULL;
      *to++ = (uint8_t)symbol;
      continue;
    }
    if (symbol == END) return to;
    if (symbol > 285) return NULL;
    const uint32_t length = LENGTH_BASE[symbol - 257] + take(s, LENGTH_BITS[symbol - 257]);
    entry = entry_of(&distances, s);
    symbol = entry >> 4;
    if (entry == NO_CODE || symbol > 29) return NULL;
    take(s, entry & 15);
    const uint32_t distance = DISTANCE_BASE[symbol] + take(s, DISTANCE_BITS[symbol]);
    if (distance > (uint32_t)(to - begin) || length > (uint32_t)(end - to)) return NULL;
    const uint8_t *from = to - distance;
    if (distance >= length) memcpy(to, from, length);
    else
      for (uint32_t i = 0; i < length; ++i) to[i] = from[i];
    to += length;
  }
}

static uint8_t *copy_stored(stream *s, uint8_t *to, const uint8_t *end) {
  /* The bytes that are held and not begun go back. */
  s->at -= s->bits >> 3;
  s->held = 0;
  s->bits = 0;
  if (s->end - s->at < 4) return NULL;
  const uint32_t length = s->at[0] | (uint32_t)s->at[1] << 8;
  if ((length ^ 0xffff) != (s->at[2] | (uint32_t)s->at[3] << 8)) return NULL;
  s->at += 4;
  if (length > (uint32_t)(s->end - s->at) || length > (uint32_t)(end - to)) return NULL;
  memcpy(to, s->at, length);
  s->at += length;
  return to + length;
}

static uint32_t adler32(const uint8_t *bytes, uint32_t length) {
  enum { LARGEST_PRIME = 65521, RUN = 5552 }; /* so many bytes that b stays below 2^32 */
  uint32_t a = 1, b = 0;
  for (uint32_t from = 0; from < length; from += RUN) {
    const uint32_t to = length - from < RUN ? length : from + RUN;
    for (uint32_t i = from; i < to; ++i) {
      a += bytes[i];
      b += a;
    }
    a %= LARGEST_PRIME;
    b %= LARGEST_PRIME;
  }
  return b << 16 | a;
}

bool hl_unzlib(const uint8_t *input, uint32_t input_length, uint8_t *output, uint32_t output_length) {
  if (input_length < 6) return false;
  if ((input[0] & 15) != 8 || (input[0] << 8 | input[1]) % 31 != 0 || (input[1] & 32) != 0) return false;
  stream s = {input + 2, input + input_length, 0, 0};
  uint8_t *to = output;
  const uint8_t *end = output + output_length;
  for (bool is_last = false; !is_last;) {
    hold(&s);
    is_last = take(&s, 1) == 1;
    const uint32_t kind = take(&s, 2);
    if (kind == 3) return false;
    if (kind == 0) to = copy_stored(&s, to, end);
    else {
      if (kind == 1) set_fixed_codes();
      else if (!read_codes(&s)) return false;
      to = inflate_block(&s, output, to, end);
    }
    if (to == NULL) return false;
  }
  const uint8_t *trailer = s.at - (s.bits >> 3);
  if (to != end || trailer > s.end || s.end - trailer < 4) return false;
  const uint32_t stated =
      (uint32_t)trailer[0] << 24 | (uint32_t)trailer[1] << 16 | (uint32_t)trailer[2] << 8 | trailer[3];
  return adler32(output, output_length) == stated;
}
