/* SPDX-License-Identifier: MIT */
/* The context itself; only files of this room look inside. */
#ifndef TRK_BASE_CONTEXT_H
#define TRK_BASE_CONTEXT_H

#include "base/base.h"

enum { TRK_MESSAGE_SIZE = 1024 };

struct trk_context {
    trk_allocate allocate;
    void *allocate_user;
    trk_log log;
    void *log_user;
    int64_t blocks; /* live blocks, the context itself not counted */
    char message[TRK_MESSAGE_SIZE];
};

#endif
