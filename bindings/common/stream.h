/* SPDX-License-Identifier: MIT */
/* Files to be written, and those of the library, which have paths, on standard output. */
#ifndef TRUCKRIDE_COMMON_STREAM_H
#define TRUCKRIDE_COMMON_STREAM_H

#include <stdbool.h>
#include <stddef.h>

/* Could a file of this name be written? For asking before long work; false with errno set. */
bool stream_writable(const char *path);

/* Make an empty temporary file; false with errno set. */
bool stream_temporary(char *path, size_t room);

/* Copy the file to standard output and remove it; false with errno set. */
bool stream_to_stdout(const char *path);

#endif
