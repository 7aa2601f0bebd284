/* SPDX-License-Identifier: MIT */
/* Texts of the status codes, version, features. */
#include "base/base.h"

const char *trk_status_text(trk_status status)
{
    switch (status) {
#define TRK_STATUS_CASE(name, value, text)                                                         \
    case value: return text;
        TRK_STATUS_LIST(TRK_STATUS_CASE)
#undef TRK_STATUS_CASE
    default: return "unknown status";
    }
}

int32_t trk_version(void)
{
    return TRK_VERSION_MAJOR * 10000 + TRK_VERSION_MINOR * 100 + TRK_VERSION_PATCH;
}

#define TEXT(x) #x
#define VERSION_TEXT(major, minor, patch) TEXT(major) "." TEXT(minor) "." TEXT(patch)

const char *trk_version_text(void)
{
    return VERSION_TEXT(TRK_VERSION_MAJOR, TRK_VERSION_MINOR, TRK_VERSION_PATCH);
}

int32_t trk_has_feature(trk_feature feature)
{
    switch (feature) {
#ifdef TRUCKRIDE_WITH_CHOLMOD
    case TRK_FEATURE_CHOLMOD: return 1;
#endif
#ifdef TRUCKRIDE_WITH_LAPACK
    case TRK_FEATURE_LAPACK: return 1;
#endif
#ifdef TRUCKRIDE_WITH_NLOPT
    case TRK_FEATURE_NLOPT: return 1;
#endif
#ifdef TRUCKRIDE_WITH_JSON
    case TRK_FEATURE_JSON: return 1;
#endif
#ifdef TRUCKRIDE_WITH_ARPACK
    case TRK_FEATURE_ARPACK: return 1;
#endif
    default: return 0;
    }
}
