/* SPDX-License-Identifier: MIT */
/* Links of a spec. */
#include "spec/spec.h"

static const trk_link_options defaults = {
    .struct_size = sizeof defaults, .direction = {0, 0, 1}, .spring_scale = 1, .damper_scale = 1};

void trk_link_options_init(trk_link_options *options, size_t struct_size)
{
    trk_write_defaults(options, struct_size, &defaults, sizeof defaults);
}

static trk_status check_ends(const trk_spec *spec, const char *name, const trk_link_options *link)
{
    trk_context *context = spec->context;
    trk_status status = TRK_OK;
    if (link->motion != TRK_MOTION_TRANSLATION && link->motion != TRK_MOTION_ROTATION)
        return trk_fail(context, TRK_E_ARGUMENT, "link '%s': there is no motion %d", name,
                        link->motion);
    if (link->from_body)
        status = trk_check_id(spec, "link", name, TRK_PART_BODY, link->from_body);
    if (status == TRK_OK && link->from_road)
        status = trk_check_id(spec, "link", name, TRK_PART_ROAD, link->from_road);
    if (status == TRK_OK && link->to_body)
        status = trk_check_id(spec, "link", name, TRK_PART_BODY, link->to_body);
    if (status != TRK_OK)
        return status;
    if (link->from_road && link->from_body)
        return trk_fail(context, TRK_E_ARGUMENT,
                        "link '%s': starts on body '%s' and on road '%s'; one of them is needed",
                        name, trk_spec_part_name(spec, TRK_PART_BODY, link->from_body),
                        trk_spec_part_name(spec, TRK_PART_ROAD, link->from_road));
    if (link->from_road && link->motion == TRK_MOTION_ROTATION)
        return trk_fail(
            context, TRK_E_ARGUMENT,
            "link '%s': a road does not rotate; a torsional link ends on bodies or ground", name);
    if (link->from_road && !link->to_body)
        return trk_fail(context, TRK_E_ARGUMENT,
                        "link '%s': runs from road '%s' to the ground; it must end on a body", name,
                        trk_spec_part_name(spec, TRK_PART_ROAD, link->from_road));
    if (!link->from_body && !link->to_body)
        return trk_fail(context, TRK_E_ARGUMENT, "link '%s': both ends are on the ground", name);
    if (link->from_body == link->to_body)
        return trk_fail(context, TRK_E_ARGUMENT, "link '%s': both ends are on body '%s'", name,
                        trk_spec_part_name(spec, TRK_PART_BODY, link->to_body));
    return TRK_OK;
}

trk_status trk_check_link_values(trk_context *context, const char *name,
                                 const trk_link_options *link)
{
    trk_status status = trk_check_direction(context, "link", name, link->direction);
    if (status == TRK_OK)
        status = trk_check_finite(context, "link", name, "from_point", 3, link->from_point);
    if (status == TRK_OK)
        status = trk_check_finite(context, "link", name, "to_point", 3, link->to_point);
    if (status == TRK_OK)
        status = trk_check_finite(context, "link", name, "stiffness", 1, &link->stiffness);
    if (status == TRK_OK)
        status = trk_check_finite(context, "link", name, "spring_offset", 1, &link->spring_offset);
    if (status == TRK_OK)
        status = trk_check_not_negative(context, "link", name, "damping", link->damping);
    if (status == TRK_OK)
        status = trk_check_not_negative(context, "link", name, "spring_scale", link->spring_scale);
    if (status == TRK_OK)
        status = trk_check_not_negative(context, "link", name, "damper_scale", link->damper_scale);
    return status;
}

static trk_status own_curve(trk_context *context, const trk_curve **curve)
{
    trk_curve *copy = NULL;
    trk_status status = *curve ? trk_curve_copy(context, *curve, &copy) : TRK_OK;
    *curve = copy;
    return status;
}

static void drop_owned(const trk_link_options *link)
{
    trk_curve_destroy((trk_curve *)link->spring_curve);
    trk_curve_destroy((trk_curve *)link->damper_curve);
    trk_law_destroy((trk_law *)link->law);
}

/* Put copies in the place of curves and law; all or nothing. */
static trk_status own(trk_context *context, trk_link_options *link)
{
    const trk_law *law = link->law;
    trk_law *copy = NULL;
    link->law = NULL;
    trk_status status = own_curve(context, &link->spring_curve);
    trk_status of_damper = own_curve(context, &link->damper_curve);
    if (status == TRK_OK)
        status = of_damper;
    if (status == TRK_OK && law)
        status = trk_law_copy(context, law, &copy);
    link->law = copy;
    if (status != TRK_OK)
        drop_owned(link);
    return status;
}

/* Read, check, and take copies of curves and law. */
static trk_status read_link(const trk_spec *spec, const char *name, const trk_link_options *options,
                            trk_link_options *out)
{
    trk_context *context = spec->context;
    *out = defaults;
    trk_status status = trk_read_options(context, "trk_link_options", options, out, sizeof *out);
    if (status == TRK_OK)
        status = check_ends(spec, name, out);
    if (status == TRK_OK)
        status = trk_check_link_values(context, name, out);
    return status == TRK_OK ? own(context, out) : status;
}

trk_status trk_spec_add_link(trk_spec *spec, const char *name, const trk_link_options *options,
                             int32_t *out_link)
{
    TRK_REQUIRE(NULL, spec, "trk_spec_add_link");
    TRK_REQUIRE(spec->context, options, "trk_spec_add_link");
    trk_link_options link;
    trk_status status = read_link(spec, name ? name : "", options, &link);
    if (status != TRK_OK)
        return status;
    status = trk_spec_append(spec, TRK_PART_LINK, name, (void **)&spec->links, sizeof link);
    if (status != TRK_OK) {
        drop_owned(&link);
        return status;
    }
    int32_t id = trk_spec_count(spec, TRK_PART_LINK);
    spec->links[id - 1] = link;
    if (out_link)
        *out_link = id;
    return TRK_OK;
}

trk_status trk_spec_get_link(const trk_spec *spec, int32_t link, trk_link_options *out_options)
{
    if (!out_options || link < 1 || link > trk_spec_count(spec, TRK_PART_LINK))
        return TRK_E_ARGUMENT;
    return trk_write_options(out_options, &spec->links[link - 1], sizeof *spec->links);
}

trk_status trk_spec_set_link(trk_spec *spec, int32_t link, const trk_link_options *options)
{
    TRK_REQUIRE(NULL, spec, "trk_spec_set_link");
    TRK_REQUIRE(spec->context, options, "trk_spec_set_link");
    trk_status status = trk_check_id(spec, "trk_spec_set_link", spec->name, TRK_PART_LINK, link);
    if (status != TRK_OK)
        return status;
    trk_link_options changed;
    status = read_link(spec, trk_spec_part_name(spec, TRK_PART_LINK, link), options, &changed);
    if (status != TRK_OK)
        return status;
    drop_owned(&spec->links[link - 1]);
    spec->links[link - 1] = changed;
    return TRK_OK;
}
