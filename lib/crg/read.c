/* SPDX-License-Identifier: MIT */
/* Life of a surface, and reading one from bytes or a file. */
#include "crg/crg.h"
#include "files/slurp.h"

void trk_crg_options_init(trk_crg_options *options, size_t struct_size)
{
    const trk_crg_options defaults = {sizeof defaults, TRK_CRG_BORDER_FILE, TRK_CRG_BORDER_FILE,
                                      TRK_CRG_MISSING_FILE, 0};
    trk_write_defaults(options, struct_size, &defaults, sizeof defaults);
}

void trk_crg_destroy(trk_crg *crg)
{
    if (!crg)
        return;
    trk_context *context = crg->context;
    trk_free(context, crg->banking);
    trk_free(context, crg->line);
    trk_free(context, crg->grid);
    trk_free(context, crg->v);
    trk_free(context, crg);
}

static trk_status read_options(trk_context *context, const trk_crg_options *options,
                               trk_crg_options *out)
{
    trk_crg_options_init(out, sizeof *out);
    trk_status status = trk_read_options(context, "trk_crg_options", options, out, sizeof *out);
    if (status)
        return status;
    const int32_t value[] = {out->border_u, out->border_v, out->missing, out->reserved};
    const int32_t most[] = {TRK_CRG_BORDER_REFLECT, TRK_CRG_BORDER_REFLECT,
                            TRK_CRG_MISSING_NEIGHBOUR, 0};
    static const char *const name[] = {"border_u", "border_v", "missing", "reserved"};
    for (int k = 0; k < 4; k++)
        if (value[k] < 0 || value[k] > most[k])
            return trk_fail(context, TRK_E_RANGE, "trk_crg_options: %s is %d, expected 0 to %d",
                            name[k], (int)value[k], (int)most[k]);
    return TRK_OK;
}

static trk_status run(trk_crg_reader *r, trk_crg_missing missing)
{
    trk_status status = trk_crg_read_header(r);
    if (status == TRK_OK)
        status = trk_crg_build_axis(r);
    if (status == TRK_OK)
        status = trk_crg_read_data(r);
    return status == TRK_OK ? trk_crg_finish(r, missing) : status;
}

static trk_status parse(trk_context *context, const char *name, const void *bytes, size_t size,
                        const trk_crg_options *options, trk_crg **out_crg)
{
    trk_crg_options o;
    trk_status status = read_options(context, options, &o);
    if (status)
        return status;
    trk_crg_reader r = {.context = context, .text = trk_text_of(context, name, bytes, size)};
    r.begin = r.text.at;
    r.value[TRK_CRG_SCALE_Z] = r.value[TRK_CRG_SCALE_SLOPE] = r.value[TRK_CRG_SCALE_BANKING] = 1;
    r.crg = trk_new(context, 1, sizeof *r.crg);
    if (!r.crg)
        return TRK_E_MEMORY;
    r.crg->context = context;
    r.crg->border_u = o.border_u;
    r.crg->border_v = o.border_v;
    status = run(&r, o.missing);
    trk_free(context, r.column);
    trk_free(context, r.place);
    trk_free(context, r.slope);
    trk_free(context, r.bank);
    if (status) {
        trk_crg_destroy(r.crg);
        return status;
    }
    *out_crg = r.crg;
    return TRK_OK;
}

trk_status trk_crg_parse(trk_context *context, const char *name, const void *bytes, size_t size,
                         const trk_crg_options *options, trk_crg **out_crg)
{
    TRK_REQUIRE(context, out_crg, "trk_crg_parse");
    *out_crg = NULL;
    if (!context)
        return TRK_E_ARGUMENT;
    TRK_REQUIRE(context, name, "trk_crg_parse");
    TRK_REQUIRE(context, bytes || size == 0, "trk_crg_parse");
    return parse(context, name, bytes, size, options, out_crg);
}

trk_status trk_crg_read(trk_context *context, const char *path, const trk_crg_options *options,
                        trk_crg **out_crg)
{
    TRK_REQUIRE(context, out_crg, "trk_crg_read");
    *out_crg = NULL;
    if (!context)
        return TRK_E_ARGUMENT;
    TRK_REQUIRE(context, path, "trk_crg_read");
    char *bytes;
    size_t size;
    trk_status status = trk_slurp(context, path, &bytes, &size);
    if (status == TRK_OK)
        status = parse(context, path, bytes, size, options, out_crg);
    trk_free(context, bytes);
    return status;
}
