/* SPDX-License-Identifier: MIT */
/* Life of a law: what the create functions share, copies, questions. */
#include "law/law.h"

#include <math.h>

trk_status trk_law_begin(trk_context *context, const trk_law_ops *ops, const char *name,
                         const void *options, void *known, size_t known_size, trk_law **out_law)
{
    if (!out_law)
        return trk_fail(context, TRK_E_ARGUMENT, "%s law: out_law is NULL", ops->word);
    *out_law = NULL;
    if (!context)
        return TRK_E_ARGUMENT;
    if (!name)
        return trk_fail(context, TRK_E_ARGUMENT, "%s law: name is NULL", ops->word);
    if (!options)
        return trk_fail(context, TRK_E_ARGUMENT, "%s '%s': options is NULL", ops->word, name);
    trk_status status = trk_read_options(context, ops->word, options, known, known_size);
    return status ? trk_fail_within(context, status, "law '%s'", name) : TRK_OK;
}

trk_status trk_law_allocate(trk_context *context, const trk_law_ops *ops, const char *name,
                            size_t size, trk_law **out_law)
{
    trk_law *law = trk_new(context, 1, size);
    if (!law)
        return TRK_E_MEMORY;
    law->context = context;
    law->ops = ops;
    law->name = trk_copy_text(context, name);
    if (!law->name) {
        trk_free(context, law);
        return TRK_E_MEMORY;
    }
    *out_law = law;
    return TRK_OK;
}

trk_status trk_law_check_positive(trk_context *context, const trk_law_ops *ops, const char *name,
                                  const char *field, double value)
{
    if (isfinite(value) && value > 0)
        return TRK_OK;
    return trk_fail(context, TRK_E_RANGE, "%s '%s': %s is %g; a finite number > 0 is needed",
                    ops->word, name, field, value);
}

trk_status trk_law_check_not_negative(trk_context *context, const trk_law_ops *ops,
                                      const char *name, const char *field, double value)
{
    if (isfinite(value) && value >= 0)
        return TRK_OK;
    return trk_fail(context, TRK_E_RANGE, "%s '%s': %s is %g; a finite number >= 0 is needed",
                    ops->word, name, field, value);
}

trk_status trk_law_read(const trk_law *law, trk_law_kind kind, const void *known, size_t known_size,
                        void *out_options)
{
    if (!out_options || trk_law_get_kind(law) != kind)
        return TRK_E_ARGUMENT;
    return trk_write_options(out_options, known, known_size);
}

trk_status trk_law_copy(trk_context *context, const trk_law *law, trk_law **out_law)
{
    TRK_REQUIRE(context, out_law, "trk_law_copy");
    *out_law = NULL;
    TRK_REQUIRE(context, context, "trk_law_copy");
    TRK_REQUIRE(context, law, "trk_law_copy");
    return law->ops->copy(context, law, out_law);
}

void trk_law_destroy(trk_law *law)
{
    if (!law)
        return;
    trk_context *context = law->context;
    if (law->ops->release)
        law->ops->release(law);
    trk_free(context, law->name);
    trk_free(context, law);
}

trk_law_kind trk_law_get_kind(const trk_law *law)
{
    return law ? law->ops->kind : 0;
}

const char *trk_law_name(const trk_law *law)
{
    return law ? law->name : NULL;
}
