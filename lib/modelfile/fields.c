/* SPDX-License-Identifier: MIT */
/* Fields of options structs as values of JSON, by their tables. */
#include <math.h>
#include <string.h>

#include "modelfile/shared.h"
#include "modelfile/writer.h"

void trk_write_triple(trk_emit *emit, const char *key, const double *triple)
{
    if (!isfinite(triple[0]) || !isfinite(triple[1]) || !isfinite(triple[2]))
        return; /* only a field that is not used, which no check has seen, can be so */
    trk_emit_open(emit, key, '[');
    for (int k = 0; k < 3; k++)
        trk_emit_number(emit, NULL, triple[k]);
    trk_emit_close(emit, ']');
}

static void write_direction(trk_emit *emit, const char *key, const double *direction)
{
    static const char *const axes[] = {"x", "y", "z"};
    for (int k = 0; k < 3; k++) {
        double axis[3] = {0, 0, 0};
        axis[k] = 1;
        if (memcmp(axis, direction, sizeof axis) == 0) {
            trk_emit_text(emit, key, axes[k]);
            return;
        }
    }
    trk_write_triple(emit, key, direction);
}

static void write_words(trk_emit *emit, const trk_entry *entry, int32_t value)
{
    if (entry->kind == TRK_ENTRY_FREEDOMS) {
        trk_emit_open(emit, entry->key, '[');
        for (const trk_word *word = trk_freedom_words; word->text; word++)
            if (value & word->value)
                trk_emit_text(emit, NULL, word->text);
        trk_emit_close(emit, ']');
        return;
    }
    for (const trk_word *word = entry->words; word->text; word++)
        if (word->value == value)
            trk_emit_text(emit, entry->key, word->text);
}

static size_t size_of(trk_entry_kind kind)
{
    switch (kind) {
    case TRK_ENTRY_APART: return 0;
    case TRK_ENTRY_NUMBER: return sizeof(double);
    case TRK_ENTRY_TRIPLE:
    case TRK_ENTRY_POINT:
    case TRK_ENTRY_DIRECTION: return 3 * sizeof(double);
    case TRK_ENTRY_CURVE:
    case TRK_ENTRY_LAW: return sizeof(void *);
    default: return sizeof(int32_t);
    }
}

/* The data of a curve; its name where it is not that of the section's key. */
void trk_write_curve(trk_writer *w, const char *key, const trk_curve *curve, bool named)
{
    trk_emit *emit = &w->emit;
    trk_curve_options options, defaults;
    trk_curve_options_init(&defaults, sizeof defaults);
    options = defaults;
    options.interpolation = trk_curve_interpolation(curve);
    options.extrapolation = trk_curve_extrapolation(curve);
    trk_emit_open(emit, key, '{');
    if (!named)
        trk_emit_text(emit, "name", trk_curve_name(curve));
    trk_write_fields(w, trk_curve_entries, &options, &defaults);
    trk_emit_open(emit, "points", '[');
    for (int64_t k = 0; k < trk_curve_count(curve); k++) {
        trk_emit_open(emit, NULL, '[');
        trk_emit_number(emit, NULL, trk_curve_x(curve)[k]);
        trk_emit_number(emit, NULL, trk_curve_y(curve)[k]);
        trk_emit_close(emit, ']');
    }
    trk_emit_close(emit, ']');
    trk_emit_close(emit, '}');
}

void trk_write_law(trk_writer *w, const char *key, const trk_law *law, bool named)
{
    trk_emit *emit = &w->emit;
    trk_law_options options, defaults;
    const trk_law_form *form = trk_law_read_form(law, &options);
    if (!form)
        return;
    form->init(&defaults);
    trk_emit_open(emit, key, '{');
    if (!named)
        trk_emit_text(emit, "name", trk_law_name(law));
    trk_emit_open(emit, form->key, '{');
    trk_write_fields(w, form->entries, &options, &defaults);
    trk_emit_close(emit, '}');
    trk_emit_close(emit, '}');
}

static void write_field(trk_writer *w, const trk_entry *entry, const void *field)
{
    trk_emit *emit = &w->emit;
    const trk_curve *curve;
    const trk_law *law;
    switch (entry->kind) {
    case TRK_ENTRY_APART: break;
    case TRK_ENTRY_NUMBER: trk_emit_number(emit, entry->key, *(const double *)field); break;
    case TRK_ENTRY_WHOLE: trk_emit_number(emit, entry->key, *(const int32_t *)field); break;
    case TRK_ENTRY_TRIPLE:
    case TRK_ENTRY_POINT: trk_write_triple(emit, entry->key, field); break;
    case TRK_ENTRY_DIRECTION: write_direction(emit, entry->key, field); break;
    case TRK_ENTRY_WORD:
    case TRK_ENTRY_FREEDOMS: write_words(emit, entry, *(const int32_t *)field); break;
    case TRK_ENTRY_CURVE:
        curve = *(const trk_curve *const *)field;
        if (trk_curve_is_named(w->spec, curve))
            trk_emit_text(emit, entry->key, trk_curve_name(curve));
        else
            trk_write_curve(w, entry->key, curve, false);
        break;
    case TRK_ENTRY_LAW:
        law = *(const trk_law *const *)field;
        if (trk_law_is_named(w->spec, law))
            trk_emit_text(emit, entry->key, trk_law_name(law));
        else
            trk_write_law(w, entry->key, law, false);
        break;
    case TRK_ENTRY_LINK:
        if (*(const int32_t *)field > 0 &&
            *(const int32_t *)field <= trk_spec_count(w->spec, TRK_PART_LINK))
            trk_emit_text(emit, entry->key,
                          trk_spec_part_name(w->spec, TRK_PART_LINK, *(const int32_t *)field));
        break;
    }
}

void trk_write_fields(trk_writer *w, const trk_entry *entries, const void *options,
                      const void *defaults)
{
    for (; entries->key; entries++) {
        const char *field = (const char *)options + entries->offset;
        const char *usual = (const char *)defaults + entries->offset;
        if (entries->required || memcmp(field, usual, size_of(entries->kind)) != 0)
            write_field(w, entries, field);
    }
}
