/* SPDX-License-Identifier: MIT */
/* Header of an MTS RPC III file, and the size of the data it promises (FILES.3). */
#include "files/rpc.h"

#include <math.h>
#include <string.h>

#include "base/number.h"

/* Text up to its end, a 0 or the room for it. */
static trk_slice terminated(const char *begin, size_t room)
{
    const char *zero = memchr(begin, '\0', room);
    return trk_trim((trk_slice){begin, zero ? zero : begin + room});
}

trk_slice trk_rpc_find(const trk_rpc *rpc, const char *keyword)
{
    const int64_t header = rpc->blocks * TRK_RPC_BLOCK;
    for (int64_t at = 0; at + TRK_RPC_RECORD <= header; at += TRK_RPC_RECORD)
        if (trk_slice_is(terminated(rpc->bytes + at, TRK_RPC_KEYWORD), keyword))
            return terminated(rpc->bytes + at + TRK_RPC_KEYWORD, TRK_RPC_RECORD - TRK_RPC_KEYWORD);
    return (trk_slice){NULL, NULL};
}

static trk_status fail_value(const trk_rpc *rpc, const char *keyword, trk_slice value,
                             const char *expected)
{
    char excerpt[TRK_EXCERPT];
    return trk_fail(rpc->context, TRK_E_SYNTAX, "%s: byte %lld: %s is %s, expected %s", rpc->name,
                    (long long)(value.begin - rpc->bytes), keyword, trk_excerpt(value, excerpt),
                    expected);
}

/* A whole number of the header; `fallback` where the keyword is absent, if that is >= 0. */
static trk_status read_count(const trk_rpc *rpc, const char *keyword, int64_t least, int64_t most,
                             int64_t fallback, int64_t *out)
{
    const trk_slice value = trk_rpc_find(rpc, keyword);
    double number;
    *out = fallback;
    if (!value.begin && fallback >= 0)
        return TRK_OK;
    if (!value.begin)
        return trk_fail(rpc->context, TRK_E_SYNTAX, "%s: the header has no %s", rpc->name, keyword);
    if (trk_number_read(value.begin, value.end, '.', &number) == value.end &&
        number >= (double)least && number <= (double)most && number == floor(number)) {
        *out = (int64_t)number;
        return TRK_OK;
    }
    char expected[80];
    trk_format(expected, sizeof expected, "a whole number from %lld to %lld", (long long)least,
               (long long)most);
    return fail_value(rpc, keyword, value, expected);
}

static trk_status read_step(trk_rpc *rpc)
{
    const trk_slice value = trk_rpc_find(rpc, "DELTA_T");
    if (!value.begin)
        return trk_fail(rpc->context, TRK_E_SYNTAX, "%s: the header has no DELTA_T", rpc->name);
    if (trk_number_read(value.begin, value.end, '.', &rpc->step) != value.end ||
        !(rpc->step > 1e-12 && rpc->step < 1e12))
        return fail_value(rpc, "DELTA_T", value, "seconds above 0");
    return TRK_OK;
}

/* FORMAT and FILE_TYPE: is this such a file at all? */
static trk_status read_format(trk_rpc *rpc)
{
    if (rpc->size < TRK_RPC_BLOCK ||
        !trk_slice_is(terminated(rpc->bytes, TRK_RPC_KEYWORD), "FORMAT"))
        return trk_fail(
            rpc->context, TRK_E_SYNTAX,
            "%s: no RPC III file: expected the keyword FORMAT and a header of 512 bytes",
            rpc->name);
    rpc->blocks = 1; /* FORMAT, NUM_HEADER_BLOCKS and NUM_PARAMS stand in the first */
    const trk_slice format = trk_rpc_find(rpc, "FORMAT");
    rpc->big_endian = trk_slice_is(format, "BINARY_IEEE_BIG_END");
    if (trk_slice_is(format, "ASCII"))
        return trk_fail(rpc->context, TRK_E_UNSUPPORTED,
                        "%s: FORMAT is ASCII, expected a binary one", rpc->name);
    if (!rpc->big_endian && !trk_slice_is(format, "BINARY") &&
        !trk_slice_is(format, "BINARY_IEEE_LITTLE_END"))
        return fail_value(rpc, "FORMAT", format,
                          "BINARY_IEEE_LITTLE_END, BINARY_IEEE_BIG_END or BINARY");
    int64_t blocks;
    trk_status status = read_count(rpc, "NUM_HEADER_BLOCKS", 1, TRK_RPC_MOST_BLOCKS, -1, &blocks);
    if (status)
        return status;
    if (blocks * TRK_RPC_BLOCK > rpc->size)
        return trk_fail(rpc->context, TRK_E_SYNTAX,
                        "%s: the file has %lld bytes, its header of %lld blocks alone needs %lld",
                        rpc->name, (long long)rpc->size, (long long)blocks,
                        (long long)blocks * TRK_RPC_BLOCK);
    rpc->blocks = blocks;
    const trk_slice type = trk_rpc_find(rpc, "FILE_TYPE");
    char excerpt[TRK_EXCERPT];
    if (type.begin && !trk_slice_is(type, "TIME_HISTORY"))
        return trk_fail(rpc->context, TRK_E_UNSUPPORTED,
                        "%s: FILE_TYPE is %s, expected TIME_HISTORY", rpc->name,
                        trk_excerpt(type, excerpt));
    return TRK_OK;
}

/* Are there so many numbers of this size, and behind them nothing or what fills the last block? */
static bool fits(const trk_rpc *rpc, int64_t size)
{
    const int64_t there = rpc->size - rpc->blocks * TRK_RPC_BLOCK;
    const int64_t rest = there - size * rpc->groups * rpc->points_per_group * rpc->channels;
    return rest == 0 || (rest > 0 && rest < TRK_RPC_BLOCK && rpc->size % TRK_RPC_BLOCK == 0);
}

/* DATA_TYPE, from the size of the file where it is missing. */
static trk_status read_type(trk_rpc *rpc)
{
    const trk_slice type = trk_rpc_find(rpc, "DATA_TYPE");
    rpc->floating = trk_slice_is(type, "FLOATING_POINT");
    if (type.begin && !rpc->floating && !trk_slice_is(type, "SHORT_INTEGER"))
        return fail_value(rpc, "DATA_TYPE", type, "SHORT_INTEGER or FLOATING_POINT");
    if (!type.begin)
        rpc->floating = !fits(rpc, 2) && fits(rpc, 4);
    const int64_t size = rpc->floating ? 4 : 2;
    if (fits(rpc, size))
        return TRK_OK;
    return trk_fail(rpc->context, TRK_E_SYNTAX,
                    "%s: %lld bytes of data, expected %lld (%lld groups of %lld points of %lld "
                    "channels, %lld bytes each), or filled up to a block of 512",
                    rpc->name, (long long)(rpc->size - rpc->blocks * TRK_RPC_BLOCK),
                    (long long)(size * rpc->groups * rpc->points_per_group * rpc->channels),
                    (long long)rpc->groups, (long long)rpc->points_per_group,
                    (long long)rpc->channels, (long long)size);
}

trk_status trk_rpc_read_header(trk_rpc *rpc)
{
    const int64_t most = INT32_MAX; /* products of two of them fit */
    int64_t ours;
    trk_status status = read_format(rpc);
    if (status == TRK_OK)
        status = read_count(rpc, "CHANNELS", 1, TRK_RPC_MOST_CHANNELS, -1, &rpc->channels);
    if (status == TRK_OK)
        status = read_count(rpc, "PTS_PER_FRAME", 1, most, -1, &rpc->points_per_frame);
    if (status == TRK_OK)
        status = read_count(rpc, "PTS_PER_GROUP", rpc->points_per_frame, most, -1,
                            &rpc->points_per_group);
    if (status == TRK_OK)
        status = read_count(rpc, "FRAMES", 1, most, -1, &rpc->frames);
    if (status == TRK_OK)
        status = read_step(rpc);
    if (status)
        return status;
    if (rpc->points_per_group % rpc->points_per_frame != 0)
        return trk_fail(rpc->context, TRK_E_SYNTAX,
                        "%s: PTS_PER_GROUP is %lld, expected a multiple of PTS_PER_FRAME, %lld",
                        rpc->name, (long long)rpc->points_per_group,
                        (long long)rpc->points_per_frame);
    const int64_t frames_per_group = rpc->points_per_group / rpc->points_per_frame;
    rpc->groups = (rpc->frames - 1) / frames_per_group + 1;
    rpc->samples = rpc->frames * rpc->points_per_frame;
    if (rpc->samples > rpc->size || rpc->groups * rpc->points_per_group > rpc->size)
        return trk_fail(rpc->context, TRK_E_SYNTAX,
                        "%s: %lld frames of %lld points are more than the %lld bytes of the file",
                        rpc->name, (long long)rpc->frames, (long long)rpc->points_per_frame,
                        (long long)rpc->size);
    status = read_count(rpc, "TRUCKRIDE_SAMPLES", 1, rpc->samples, rpc->samples, &ours);
    rpc->samples = ours;
    return status ? status : read_type(rpc);
}
