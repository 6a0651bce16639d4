/* Streams of zlib, RFC 1950 and 1951. */
#ifndef HL_READING_INFLATE_H
#define HL_READING_INFLATE_H

#include <stdbool.h>
#include <stdint.h>

/*
 * Fills `output` from the stream in `input`, which must have just so many bytes and their checksum. False if it has not, or is damaged: then
 * `output` holds anything. 8 bytes behind the input may be read, which must be there.
 */
bool hl_unzlib(const uint8_t *input, uint32_t input_length, uint8_t *output, uint32_t output_length);

#endif
