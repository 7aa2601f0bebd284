/* SPDX-License-Identifier: MIT */
/* MTS RPC III: what the header says (FILES.3). */
#ifndef TRK_FILES_RPC_H
#define TRK_FILES_RPC_H

#include "files/text.h"
#include <truckride/files.h>

enum {
    TRK_RPC_BLOCK = 512,
    TRK_RPC_RECORD = 128, /* a keyword and a value */
    TRK_RPC_KEYWORD = 32,
    TRK_RPC_MOST_BLOCKS = 256,
    TRK_RPC_MOST_CHANNELS = 256, /* readers allow more than the 128 of the document */
    TRK_RPC_FULL_SCALE = 32752,  /* INT_FULL_SCALE when it is absent                */
    TRK_RPC_FRAME = 1024,
    TRK_RPC_GROUP = 2048
};

typedef struct trk_rpc {
    trk_context *context;
    const char *name, *bytes; /* of the file                             */
    int64_t size;             /* [byte]                                  */
    int64_t blocks, channels; /* of the header                           */
    int64_t points_per_frame, points_per_group, frames;
    int64_t samples; /* of a channel, the padding left out               */
    int64_t groups;  /* stored, the last as large as the others          */
    double step;     /* [s]                                              */
    bool big_endian, floating;
} trk_rpc;

/* Value of a keyword, NULL begin if there is none. */
trk_slice trk_rpc_find(const trk_rpc *rpc, const char *keyword);

/* Everything but bytes, size, name and context, checked against the size of the file. */
trk_status trk_rpc_read_header(trk_rpc *rpc);

#endif
