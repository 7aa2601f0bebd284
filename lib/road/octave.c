/* SPDX-License-Identifier: MIT */
/* One octave of a road on its grid: lapped cosines of fixed size and random sign (ROAD.4). */
#include "base/random.h"
#include "road/road.h"

enum { FLIPS_PER_DRAW = 8 }; /* 128 bits, 16 for each */

void trk_octave_reader_start(trk_octave_reader *reader, const trk_track *track, int32_t octave)
{
    reader->track = track;
    reader->octave = octave;
    reader->block[0] = reader->block[1] = INT64_MIN; /* lie beyond every road */
    for (int k = 0; k < TRK_ROAD_POINTS; k++)
        reader->point[k] = INT64_MIN;
}

/* Bit j: line j of the block is negative. */
static void draw_signs(const trk_octave_reader *reader, int64_t block, uint64_t negative[2])
{
    const trk_track *track = reader->track;
    const trk_octave *octave = &track->octaves[reader->octave];
    uint32_t bits[4];
    trk_random_bits(track->seed, (uint64_t)block, (uint32_t)reader->octave, TRK_PURPOSE_ROAD_SIGN,
                    bits);
    negative[0] = (uint64_t)bits[1] << 32 | bits[0];
    negative[1] = (uint64_t)bits[3] << 32 | bits[2];
    if (!octave->flips)
        return;
    for (int draw = octave->first / FLIPS_PER_DRAW; draw < TRK_ROAD_LINES / FLIPS_PER_DRAW;
         draw++) {
        trk_random_bits(track->seed, (uint64_t)block, (uint32_t)(reader->octave << 8 | draw),
                        TRK_PURPOSE_ROAD_FLIP, bits);
        for (int k = 0; k < FLIPS_PER_DRAW; k++) {
            const int line = draw * FLIPS_PER_DRAW + k;
            const uint32_t chance = bits[k / 2] >> 16 * (k % 2) & 0xffff;
            negative[line / 64] ^= (uint64_t)(chance < octave->flip[line]) << line % 64;
        }
    }
}

static const double *lines(trk_octave_reader *reader, int64_t block)
{
    static const double sign[2] = {1, -1};
    const int slot = (int)(block & 1);
    double *line = reader->line[slot];
    if (reader->block[slot] != block) {
        const trk_octave *octave = &reader->track->octaves[reader->octave];
        uint64_t negative[2];
        draw_signs(reader, block, negative);
        for (int j = octave->first; j < TRK_ROAD_LINES; j++)
            line[j] = octave->amplitude[j] * sign[negative[j / 64] >> j % 64 & 1];
        reader->block[slot] = block;
    }
    return line;
}

/* Sum of a block's cosines at its point `place`, 0 .. 2 HOP - 1, under its window. */
static double lapped(const trk_track *track, const double *line, int32_t first, int32_t place)
{
    const double *cosine = track->cosine;
    const uint32_t mask = TRK_ROAD_ANGLES - 1;
    const uint32_t step = 2u * (uint32_t)place + 1 + TRK_ROAD_HOP;
    uint32_t angle = (step * (2u * (uint32_t)(TRK_ROAD_FIRST_LINE + first) + 1) - 1) / 2;
    double sum[4] = {0};
    for (int j = first; j < TRK_ROAD_LINES; j += 4, angle += 4 * step) {
        sum[0] += line[j] * cosine[angle & mask];
        sum[1] += line[j + 1] * cosine[(angle + step) & mask];
        sum[2] += line[j + 2] * cosine[(angle + 2 * step) & mask];
        sum[3] += line[j + 3] * cosine[(angle + 3 * step) & mask];
    }
    const double window = cosine[(TRK_ROAD_HOP - 1 - place) & (int32_t)mask];
    return window * ((sum[0] + sum[1]) + (sum[2] + sum[3]));
}

double trk_octave_read(trk_octave_reader *reader, int64_t point)
{
    const int slot = (int)(point & (TRK_ROAD_POINTS - 1));
    if (reader->point[slot] != point) {
        const trk_track *track = reader->track;
        const int32_t first = track->octaves[reader->octave].first;
        const int32_t place = (int32_t)(point & (TRK_ROAD_HOP - 1));
        const int64_t block = (point - place) / TRK_ROAD_HOP;
        reader->height[slot] = lapped(track, lines(reader, block), first, place) +
                               lapped(track, lines(reader, block - 1), first, place + TRK_ROAD_HOP);
        reader->point[slot] = point;
    }
    return reader->height[slot];
}
