/* SPDX-License-Identifier: MIT */
/* Ready-made vehicles and model files. */
#include "common/vehicle.h"
#include "common/recording.h"

#include <truckride/modelfile.h>

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

const char *const vehicle_names[] = {"thesis_quarter", "reference_front", "reference_rear",
                                     "reference_half", "reference_truck", NULL};
const char *const vehicle_variants[] = {"linear", "thesis", "nonlinear", NULL};

const char *const vehicle_fields[] = {"stiffness", "damping",  "mass",    "inertia", "mass_inertia",
                                      "friction",  "approach", "bending", NULL};

static bool choose(const char *what, const char *const *list, const char *name, complaint *wrong,
                   int *out)
{
    *out = text_index(list, name);
    if (*out >= 0)
        return true;
    char all[256] = "";
    for (int k = 0; list[k]; k++)
        snprintf(all + strlen(all), sizeof all - strlen(all), "%s%s", k ? ", " : "", list[k]);
    const char *nearest = text_nearest(list, name);
    if (nearest)
        return say(wrong, "there is no %s '%s'; did you mean '%s'? There are %s", what, name,
                   nearest, all);
    return say(wrong, "there is no %s '%s', but %s", what, name, all);
}

static trk_status read_builtin(trk_context *context, const char *text, complaint *wrong,
                               trk_spec **out_spec)
{
    char *copy = text_copy(text), *rest = copy;
    const char *name = text_field(&rest, ':');
    const char *variant = rest ? rest : "thesis";
    int vehicle = 0, kind = 0;
    trk_status status = TRK_E_NAME;
    if (choose("ready-made vehicle", vehicle_names, name, wrong, &vehicle) &&
        choose("variant", vehicle_variants, variant, wrong, &kind))
        status = trk_vehicle_create_builtin(context, TRK_VEHICLE_THESIS_QUARTER + vehicle,
                                            TRK_VARIANT_LINEAR + kind, out_spec);
    free(copy);
    return status;
}

static trk_status read_stream(trk_context *context, complaint *wrong, trk_spec **out_spec)
{
    size_t length;
    char *text = read_standard_input(&length);
    if (!text) {
        say(wrong, "standard input cannot be read");
        return TRK_E_FILE;
    }
    trk_status status = trk_model_file_parse(context, text, length, "<stdin>", ".", out_spec);
    free(text);
    return status;
}

trk_status vehicle_read(trk_context *context, const char *text, complaint *wrong,
                        trk_spec **out_spec)
{
    static const char builtin[] = "builtin:";
    *out_spec = NULL;
    wrong->text[0] = 0;
    if (strncmp(text, builtin, strlen(builtin)) == 0)
        return read_builtin(context, text + strlen(builtin), wrong, out_spec);
    if (strcmp(text, "-") == 0)
        return read_stream(context, wrong, out_spec);
    return trk_model_file_read(context, text, out_spec);
}
