/* SPDX-License-Identifier: MIT */
/* Numbers as bytes, in either order, whatever the order of the processor. */
#ifndef TRK_FILES_BYTES_H
#define TRK_FILES_BYTES_H

#include <stdbool.h>
#include <stdint.h>
#include <string.h>

static inline uint64_t trk_bytes_get(const void *bytes, int size, bool big_endian)
{
    const unsigned char *b = bytes;
    uint64_t value = 0;
    for (int k = 0; k < size; k++)
        value = value << 8 | b[big_endian ? k : size - 1 - k];
    return value;
}

static inline void trk_bytes_put(void *bytes, int size, bool big_endian, uint64_t value)
{
    unsigned char *b = bytes;
    for (int k = 0; k < size; k++, value >>= 8)
        b[big_endian ? size - 1 - k : k] = (unsigned char)value;
}

static inline double trk_bytes_int16(const void *bytes, bool big_endian)
{
    const int value = (int)trk_bytes_get(bytes, 2, big_endian);
    return value < 0x8000 ? value : value - 0x10000;
}

static inline double trk_bytes_float(const void *bytes, bool big_endian)
{
    const uint32_t bits = (uint32_t)trk_bytes_get(bytes, 4, big_endian);
    float value;
    memcpy(&value, &bits, sizeof value);
    return (double)value;
}

static inline double trk_bytes_double(const void *bytes, bool big_endian)
{
    const uint64_t bits = trk_bytes_get(bytes, 8, big_endian);
    double value;
    memcpy(&value, &bits, sizeof value);
    return value;
}

#endif
