/* SPDX-License-Identifier: MIT */
/* Philox4x32-10, and a permutation without a table on top of it. */
#include "base/random.h"

enum { PHILOX_ROUNDS = 10, FEISTEL_ROUNDS = 8 };

void trk_philox(const uint32_t counter[4], const uint32_t key[2], uint32_t out[4])
{
    uint32_t c0 = counter[0], c1 = counter[1], c2 = counter[2], c3 = counter[3];
    uint32_t k0 = key[0], k1 = key[1];
    for (int round = 0; round < PHILOX_ROUNDS; round++) {
        const uint64_t a = (uint64_t)0xD2511F53u * c0, b = (uint64_t)0xCD9E8D57u * c2;
        c0 = (uint32_t)(b >> 32) ^ c1 ^ k0;
        c1 = (uint32_t)b;
        c2 = (uint32_t)(a >> 32) ^ c3 ^ k1;
        c3 = (uint32_t)a;
        k0 += 0x9E3779B9u;
        k1 += 0xBB67AE85u;
    }
    out[0] = c0;
    out[1] = c1;
    out[2] = c2;
    out[3] = c3;
}

void trk_random_bits(int64_t seed, uint64_t place, uint32_t stream, uint32_t purpose,
                     uint32_t out[4])
{
    const uint32_t counter[4] = {(uint32_t)place, (uint32_t)(place >> 32), stream, purpose};
    const uint32_t key[2] = {(uint32_t)seed, (uint32_t)((uint64_t)seed >> 32)};
    trk_philox(counter, key, out);
}

double trk_random_uniform(int64_t seed, uint64_t place, uint32_t stream)
{
    uint32_t bits[4];
    trk_random_bits(seed, place, stream, TRK_PURPOSE_SAMPLE, bits);
    const uint64_t word = (uint64_t)bits[1] << 32 | bits[0];
    return ((double)(word >> 12) + 0.5) * 0x1p-52;
}

/* One pass of the network over 2 half bits. */
static uint64_t feistel(int64_t seed, uint32_t stream, int half, uint64_t x)
{
    const uint64_t mask = ((uint64_t)1 << half) - 1;
    uint64_t left = x >> half, right = x & mask;
    for (uint32_t round = 0; round < FEISTEL_ROUNDS; round++) {
        uint32_t bits[4];
        trk_random_bits(seed, right, stream, TRK_PURPOSE_PERMUTE + round, bits);
        const uint64_t next = left ^ (bits[0] & mask);
        left = right;
        right = next;
    }
    return left << half | right;
}

uint64_t trk_random_permute(int64_t seed, uint32_t stream, uint64_t n, uint64_t place)
{
    int half = 1;
    while (half < 31 && (uint64_t)1 << (2 * half) < n)
        half++;
    /* Walking along a cycle of the network until it comes back below n permutes 0 .. n - 1;
     * the network has less than 4 n places (4 for n = 1), so that this takes few passes. */
    do
        place = feistel(seed, stream, half, place);
    while (place >= n);
    return place;
}
