/* SPDX-License-Identifier: MIT */
/* A spec as a model file: its sections, to memory or to a file. */
#define _POSIX_C_SOURCE 200809L
#include <truckride/modelfile.h>

#include <errno.h>
#include <stdio.h>
#include <string.h>
#include <sys/stat.h>

#include "modelfile/shared.h"
#include "modelfile/writer.h"

static void write_section(trk_writer *w, const char *key, trk_part part,
                          void (*write_part)(trk_writer *, int32_t))
{
    const int32_t count = trk_spec_count(w->spec, part);
    if (count == 0)
        return;
    trk_emit_open(&w->emit, key, '{');
    for (int32_t id = 1; id <= count; id++) {
        trk_emit_open(&w->emit, trk_spec_part_name(w->spec, part, id), '{');
        write_part(w, id);
        trk_emit_close(&w->emit, '}');
    }
    trk_emit_close(&w->emit, '}');
}

/* Curves and laws that have names; a section appears with the first. */
static void write_curves(trk_writer *w)
{
    bool open = false;
    for (int64_t k = 0; k < trk_curve_uses(w->spec); k++)
        if (trk_curve_leads(w->spec, k)) {
            if (!open)
                trk_emit_open(&w->emit, "curves", '{');
            open = true;
            const trk_curve *curve = trk_curve_use(w->spec, k);
            trk_write_curve(w, trk_curve_name(curve), curve, true);
        }
    if (open)
        trk_emit_close(&w->emit, '}');
}

static void write_laws(trk_writer *w)
{
    bool open = false;
    for (int64_t k = 0; k < trk_law_uses(w->spec); k++)
        if (trk_law_leads(w->spec, k)) {
            if (!open)
                trk_emit_open(&w->emit, "laws", '{');
            open = true;
            const trk_law *law = trk_law_use(w->spec, k);
            trk_write_law(w, trk_law_name(law), law, true);
        }
    if (open)
        trk_emit_close(&w->emit, '}');
}

static void write_all(trk_writer *w)
{
    trk_locale locale;
    trk_locale_enter(&locale);
    w->emit.first = true;
    trk_emit_open(&w->emit, NULL, '{');
    trk_emit_number(&w->emit, "truckride_model", 1);
    trk_emit_text(&w->emit, "name", trk_spec_name(w->spec));
    write_curves(w);
    write_laws(w);
    write_section(w, "bodies", TRK_PART_BODY, trk_write_body);
    write_section(w, "beams", TRK_PART_BEAM, trk_write_beam);
    write_section(w, "masses", TRK_PART_MASS, trk_write_mass);
    write_section(w, "roads", TRK_PART_ROAD, trk_write_road);
    write_section(w, "links", TRK_PART_LINK, trk_write_link);
    write_section(w, "ports", TRK_PART_PORT, trk_write_port);
    write_section(w, "sensors", TRK_PART_SENSOR, trk_write_sensor);
    trk_emit_close(&w->emit, '}');
    trk_emit_end(&w->emit);
    trk_locale_leave(&locale);
}

trk_status trk_model_file_format(const trk_spec *spec, size_t capacity, char *out_text,
                                 size_t *out_length)
{
    if (!spec || (!out_text && capacity > 0))
        return TRK_E_ARGUMENT;
    trk_writer w = {spec, {.text = out_text, .capacity = capacity}};
    write_all(&w);
    if (out_length)
        *out_length = w.emit.length;
    if (w.emit.bad)
        return TRK_E_NAME;
    return out_text && w.emit.length >= capacity ? TRK_E_RANGE : TRK_OK;
}

/* Write beside the file and rename; what is no regular file (a pipe, a link) is written through. */
static trk_status write_file(trk_context *context, const trk_spec *spec, const char *path,
                             const char *beside)
{
    struct stat about;
    trk_sink sink;
    trk_writer w = {spec, {.sink = &sink}};
    const bool replace = lstat(path, &about) != 0 || S_ISREG(about.st_mode);
    trk_status status = trk_sink_open(context, replace ? beside : path, &sink);
    if (status)
        return status;
    write_all(&w);
    if (w.emit.bad)
        status =
            trk_fail(context, TRK_E_NAME, "%s: the name '%.80s' is no UTF-8", path, w.emit.bad);
    status = trk_sink_close(&sink, status);
    if (status || !replace || rename(beside, path) == 0)
        return status;
    const int error = errno;
    remove(beside);
    return trk_fail(context, TRK_E_FILE, "%s: cannot be replaced (error %d)", path, error);
}

trk_status trk_model_file_write(trk_context *context, const trk_spec *spec, const char *path)
{
    TRK_REQUIRE(context, context, "trk_model_file_write");
    TRK_REQUIRE(context, spec, "trk_model_file_write");
    TRK_REQUIRE(context, path, "trk_model_file_write");
    const size_t room = strlen(path) + sizeof ".part";
    char *beside = trk_new(context, (int64_t)room, 1);
    if (!beside)
        return TRK_E_MEMORY;
    trk_format(beside, room, "%s.part", path);
    trk_status status = write_file(context, spec, path, beside);
    trk_free(context, beside);
    return status;
}
