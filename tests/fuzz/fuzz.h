/* SPDX-License-Identifier: MIT */
/* One reader under random bytes: the interface of libFuzzer, which driver.c also fulfils. */
#ifndef TRK_TESTS_FUZZ_H
#define TRK_TESTS_FUZZ_H

#include <stddef.h>
#include <stdint.h>
#include <truckride/base.h>

int LLVMFuzzerTestOneInput(const uint8_t *bytes, size_t size);

/* Small good files of the format, from which driver.c starts; NULL at the end. */
typedef struct fuzz_seed {
    const char *bytes;
    size_t size;
} fuzz_seed;
extern const fuzz_seed fuzz_seeds[];

/* Context whose allocator ends the process when more than a small multiple of size is asked for. */
trk_context *fuzz_begin(size_t size);
/* Ends the process if something is left. */
void fuzz_end(trk_context *context);

/* Ends the process with a text unless it holds. */
void fuzz_check(int holds, const char *what);

#endif
