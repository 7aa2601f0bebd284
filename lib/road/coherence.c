/* SPDX-License-Identifier: MIT */
/* Coherence of two parallel tracks (ROAD.2), from operations that round alike everywhere. */
#include "base/plain.h"
#include "road/road.h"

static const double two_pi = 6.283185307179586476925;

/* Trapezoidal rule over s: error exp(-pi^2 / step) = 7e-18, tails below 1e-14 for waviness 1. */
static const double node_step = 0.25, last_node = 4.25;

void trk_coherence_rule_set(trk_coherence_rule *rule, const trk_road_options *options)
{
    rule->options = options;
    if (options->tracks != TRK_ROAD_TRACKS_ISOTROPIC)
        return;
    double sum = 0;
    for (int k = 0; k < TRK_COHERENCE_NODES; k++) {
        const double s = last_node - node_step * k;
        rule->reach[k] = trk_plain_exp(s);
        rule->weight[k] = trk_plain_exp(0.5 * options->waviness * s - rule->reach[k]);
        sum += rule->weight[k];
    }
    for (int k = 0; k < TRK_COHERENCE_NODES; k++)
        rule->weight[k] /= sum;
}

/* 2 (z/2)^m K_m(z) / Gamma(m), m = waviness / 2: quotient of two integrals of one kind (ROAD.2b). */
static double isotropic(const trk_coherence_rule *rule, double z)
{
    double sum = 0;
    for (int k = 0; k < TRK_COHERENCE_NODES; k++) {
        const double exponent = 0.25 * z * z / rule->reach[k];
        if (exponent > 50) /* and all that follow, whose weight falls as well */
            break;
        sum += rule->weight[k] * trk_plain_exp(-exponent);
    }
    return sum < 1 ? sum : 1;
}

double trk_coherence_of(const trk_coherence_rule *rule, double wavenumber)
{
    const trk_road_options *o = rule->options;
    const double z = two_pi * wavenumber * o->track_width;
    switch (o->tracks) {
    case TRK_ROAD_TRACKS_EQUAL: return 1;
    case TRK_ROAD_TRACKS_INDEPENDENT: return 0;
    case TRK_ROAD_TRACKS_EXPONENTIAL: return trk_plain_exp(-(o->coherence_decay * z));
    default: return isotropic(rule, z);
    }
}
