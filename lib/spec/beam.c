/* SPDX-License-Identifier: MIT */
/* Beams of a spec. */
#include "spec/spec.h"

#include <math.h>

static const trk_beam_options defaults = {.struct_size = sizeof defaults, .up = {0, 0, 1}};

/* Sine of the angle between `up` and the beam below which its section has no direction. */
static const double least_sine = 1e-6;

void trk_beam_options_init(trk_beam_options *options, size_t struct_size)
{
    trk_write_defaults(options, struct_size, &defaults, sizeof defaults);
}

static double length_of(const double *v)
{
    return hypot(hypot(v[0], v[1]), v[2]);
}

static void cross(const double *a, const double *b, double *out)
{
    out[0] = a[1] * b[2] - a[2] * b[1];
    out[1] = a[2] * b[0] - a[0] * b[2];
    out[2] = a[0] * b[1] - a[1] * b[0];
}

double trk_beam_axes(const trk_beam_options *beam, double axes[3][3], double *out_sine)
{
    for (int k = 0; k < 3; k++)
        axes[0][k] = beam->to_point[k] - beam->from_point[k];
    double length = length_of(axes[0]), height = length_of(beam->up), up[3];
    for (int k = 0; k < 3; k++) {
        axes[0][k] /= length;
        up[k] = beam->up[k] / height;
    }
    cross(up, axes[0], axes[1]);
    *out_sine = length_of(axes[1]);
    for (int k = 0; k < 3; k++)
        axes[1][k] /= *out_sine;
    cross(axes[0], axes[1], axes[2]);
    return length;
}

static trk_status check_geometry(trk_context *context, const char *name,
                                 const trk_beam_options *beam)
{
    trk_status status = trk_check_finite(context, "beam", name, "from_point", 3, beam->from_point);
    if (status == TRK_OK)
        status = trk_check_finite(context, "beam", name, "to_point", 3, beam->to_point);
    if (status == TRK_OK)
        status = trk_check_finite(context, "beam", name, "up", 3, beam->up);
    if (status != TRK_OK)
        return status;
    double axes[3][3], sine, length = trk_beam_axes(beam, axes, &sine);
    if (!isfinite(length) || length <= 0)
        return trk_fail(context, TRK_E_RANGE,
                        "beam '%s': length is %g m; its ends must be apart, a finite length", name,
                        length);
    if (!(sine > least_sine)) /* also when it is NaN: up has no length */
        return trk_fail(context, TRK_E_RANGE,
                        "beam '%s': up is (%g, %g, %g), zero or along the beam; a direction across "
                        "it is needed",
                        name, beam->up[0], beam->up[1], beam->up[2]);
    return TRK_OK;
}

trk_status trk_check_beam_values(trk_context *context, const char *name,
                                 const trk_beam_options *beam)
{
    const struct {
        const char *field;
        double value;
    } numbers[] = {{"axial", beam->axial},
                   {"torsion", beam->torsion},
                   {"bending_y", beam->bending_y},
                   {"bending_z", beam->bending_z},
                   {"shear_y", beam->shear_y},
                   {"shear_z", beam->shear_z},
                   {"mass_per_length", beam->mass_per_length},
                   {"inertia_x", beam->inertia_x},
                   {"inertia_y", beam->inertia_y},
                   {"inertia_z", beam->inertia_z},
                   {"mass_damping", beam->mass_damping},
                   {"stiffness_damping", beam->stiffness_damping}};
    trk_status status = TRK_OK;
    for (size_t k = 0; status == TRK_OK && k < sizeof numbers / sizeof *numbers; k++)
        status = trk_check_not_negative(context, "beam", name, numbers[k].field, numbers[k].value);
    return status == TRK_OK ? check_geometry(context, name, beam) : status;
}

static trk_status check_ends(const trk_spec *spec, const char *name, const trk_beam_options *beam)
{
    trk_status status = TRK_OK;
    if (beam->from_body)
        status = trk_check_id(spec, "beam", name, TRK_PART_BODY, beam->from_body);
    if (status == TRK_OK && beam->to_body)
        status = trk_check_id(spec, "beam", name, TRK_PART_BODY, beam->to_body);
    if (status == TRK_OK && !beam->from_body && !beam->to_body)
        return trk_fail(spec->context, TRK_E_ARGUMENT, "beam '%s': both ends are on the ground",
                        name);
    if (status == TRK_OK && beam->from_body == beam->to_body)
        status = trk_fail(spec->context, TRK_E_ARGUMENT, "beam '%s': both ends are on body '%s'",
                          name, trk_spec_part_name(spec, TRK_PART_BODY, beam->to_body));
    return status;
}

static trk_status read_beam(const trk_spec *spec, const char *name, const trk_beam_options *options,
                            trk_beam_options *out)
{
    *out = defaults;
    trk_status status =
        trk_read_options(spec->context, "trk_beam_options", options, out, sizeof *out);
    if (status == TRK_OK)
        status = check_ends(spec, name, out);
    return status == TRK_OK ? trk_check_beam_values(spec->context, name, out) : status;
}

trk_status trk_spec_add_beam(trk_spec *spec, const char *name, const trk_beam_options *options,
                             int32_t *out_beam)
{
    TRK_REQUIRE(NULL, spec, "trk_spec_add_beam");
    TRK_REQUIRE(spec->context, options, "trk_spec_add_beam");
    trk_beam_options beam;
    trk_status status = read_beam(spec, name ? name : "", options, &beam);
    if (status == TRK_OK)
        status = trk_spec_append(spec, TRK_PART_BEAM, name, (void **)&spec->beams, sizeof beam);
    if (status != TRK_OK)
        return status;
    int32_t id = trk_spec_count(spec, TRK_PART_BEAM);
    spec->beams[id - 1] = beam;
    if (out_beam)
        *out_beam = id;
    return TRK_OK;
}

trk_status trk_spec_get_beam(const trk_spec *spec, int32_t beam, trk_beam_options *out_options)
{
    if (!out_options || beam < 1 || beam > trk_spec_count(spec, TRK_PART_BEAM))
        return TRK_E_ARGUMENT;
    return trk_write_options(out_options, &spec->beams[beam - 1], sizeof *spec->beams);
}

trk_status trk_spec_set_beam(trk_spec *spec, int32_t beam, const trk_beam_options *options)
{
    TRK_REQUIRE(NULL, spec, "trk_spec_set_beam");
    TRK_REQUIRE(spec->context, options, "trk_spec_set_beam");
    trk_status status = trk_check_id(spec, "trk_spec_set_beam", spec->name, TRK_PART_BEAM, beam);
    if (status != TRK_OK)
        return status;
    trk_beam_options changed;
    status = read_beam(spec, trk_spec_part_name(spec, TRK_PART_BEAM, beam), options, &changed);
    if (status == TRK_OK)
        spec->beams[beam - 1] = changed;
    return status;
}
