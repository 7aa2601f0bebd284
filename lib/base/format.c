/* SPDX-License-Identifier: MIT */
/* Number formatting that does not depend on the locale of the caller. */
#define _POSIX_C_SOURCE 200809L
#include "base/base.h"

#include <locale.h>
#include <stdio.h>

void trk_locale_enter(trk_locale *out_locale)
{
    /* uselocale acts on this thread only and is put back; the C locale always exists. */
    out_locale->c_locale = newlocale(LC_ALL_MASK, "C", (locale_t)0);
    out_locale->before = out_locale->c_locale ? uselocale(out_locale->c_locale) : NULL;
}

void trk_locale_leave(trk_locale *locale)
{
    if (!locale->c_locale)
        return;
    uselocale(locale->before);
    freelocale(locale->c_locale);
}

int trk_format_list(char *out, size_t size, const char *format, va_list arguments)
{
    trk_locale locale;
    trk_locale_enter(&locale);
    int length = vsnprintf(out, size, format, arguments);
    trk_locale_leave(&locale);
    return length;
}

int trk_format(char *out, size_t size, const char *format, ...)
{
    va_list arguments;
    va_start(arguments, format);
    int length = trk_format_list(out, size, format, arguments);
    va_end(arguments);
    return length;
}
