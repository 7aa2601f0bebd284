/* SPDX-License-Identifier: MIT */
/* A stranger's program: valid C99, C11 and C++17. Prints "ok" if library and headers fit. */
#include <stdio.h>
#include <string.h>
#include <truckride/truckride.h>

int main(void)
{
    char version[32];
    trk_context *context = NULL;
    snprintf(version, sizeof version, "%d.%d.%d", TRK_VERSION_MAJOR, TRK_VERSION_MINOR,
             TRK_VERSION_PATCH);
    if (strcmp(version, trk_version_text()) != 0) {
        printf("headers %s, library %s\n", version, trk_version_text());
        return 1;
    }
    if (trk_context_create(NULL, NULL, &context) != TRK_OK)
        return 1;
    trk_context_destroy(context);
    puts("ok");
    return 0;
}
