/* SPDX-License-Identifier: MIT */
/* Options structs that may come from an older or a newer header than this library. */
#include "base/base.h"

#include <string.h>

/* No struct is as small as a pointer: init(p, sizeof p) is a slip for init(p, sizeof *p). */
static bool plausible(size_t struct_size)
{
    return struct_size > sizeof(void *) && struct_size <= 65536;
}

trk_status trk_read_options(trk_context *context, const char *what, const void *options,
                            void *known, size_t known_size)
{
    if (!options)
        return TRK_OK;
    size_t given;
    memcpy(&given, options, sizeof given);
    if (!plausible(given))
        return trk_fail(context, TRK_E_OPTIONS,
                        "%s: struct_size is %zu, the struct has %zu bytes; call its init function "
                        "with the size of the struct, not of a pointer to it",
                        what, given, known_size);
    const unsigned char *bytes = options;
    for (size_t k = known_size; k < given; k++)
        if (bytes[k])
            return trk_fail(context, TRK_E_OPTIONS,
                            "%s: byte %zu is set, but this library (%s) knows only %zu bytes", what,
                            k, trk_version_text(), known_size);
    memcpy(known, options, given < known_size ? given : known_size);
    memcpy(known, &known_size, sizeof known_size);
    return TRK_OK;
}

void trk_write_defaults(void *options, size_t struct_size, const void *defaults, size_t known_size)
{
    if (!options || struct_size < sizeof struct_size || struct_size > 65536)
        return;
    if (!plausible(struct_size)) { /* so that whoever reads the struct refuses it */
        memcpy(options, &struct_size, sizeof struct_size);
        return;
    }
    memset(options, 0, struct_size);
    memcpy(options, defaults, struct_size < known_size ? struct_size : known_size);
    memcpy(options, &struct_size, sizeof struct_size);
}

trk_status trk_write_options(void *options, const void *known, size_t known_size)
{
    size_t given;
    memcpy(&given, options, sizeof given);
    if (!plausible(given))
        return TRK_E_OPTIONS;
    trk_write_defaults(options, given, known, known_size);
    return TRK_OK;
}
