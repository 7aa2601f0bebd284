/* SPDX-License-Identifier: MIT */
/* Shares of kinetic energy, added up over the nodes of a frame. */
#include "energy.h"
#include "common/text.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

typedef struct group {
    const char *name;
    int length; /* of the part of the name that counts */
    double share;
} group;

/* "frame" of "frame.left.1.z"; names with one point are whole. */
static int length_of(const char *name)
{
    const char *first = strchr(name, '.');
    return first && strchr(first + 1, '.') ? (int)(first - name) : (int)strlen(name);
}

static int collect(const trk_model *model, const double *share, group *all)
{
    int groups = 0;
    for (int32_t k = 1; k <= trk_model_count(model, TRK_PART_COORDINATE); k++) {
        const char *name = trk_model_part_name(model, TRK_PART_COORDINATE, k);
        const int length = length_of(name);
        int g = groups - 1; /* nodes of a frame follow each other */
        while (g >= 0 &&
               (all[g].length != length || strncmp(all[g].name, name, (size_t)length) != 0))
            g--;
        if (g < 0)
            all[g = groups++] = (group){name, length, 0};
        all[g].share += share[k - 1];
    }
    return groups;
}

void energy_text(const trk_model *model, const double *share, char *text, size_t room)
{
    group *all = need((size_t)trk_model_count(model, TRK_PART_COORDINATE), sizeof *all);
    const int groups = collect(model, share, all);
    text[0] = 0;
    for (int part = 0; part < 4 && groups > 0; part++) {
        group *most = all;
        for (group *g = all; g < all + groups; g++)
            most = g->share > most->share ? g : most;
        const size_t used = strlen(text);
        if (!(most->share >= 0.05) || used + (size_t)most->length + 16 > room)
            break;
        snprintf(text + used, room - used, "%s%.*s %.0f %%", part ? ", " : "", most->length,
                 most->name, 100 * most->share);
        most->share = 0;
    }
    free(all);
}
