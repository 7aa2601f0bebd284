/* SPDX-License-Identifier: MIT */
/* Plots. No shell is involved: gnuplot is started directly, its script comes through a pipe, its
 * drawing goes to a file that was opened here. */
#define _POSIX_C_SOURCE 200809L
#include "plot_script.h"
#include "common/stream.h"
#include "common/text.h"

#include <errno.h>
#include <fcntl.h>
#include <signal.h>
#include <spawn.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

extern char **environ;

static bool on_path(const char *program)
{
    const char *path = getenv("PATH");
    char *copy = text_copy(path ? path : "/bin:/usr/bin"), *rest = copy, file[4096];
    const char *folder;
    bool found = false;
    while (!found && (folder = text_field(&rest, ':'))) {
        const int length = snprintf(file, sizeof file, "%s/%s", *folder ? folder : ".", program);
        found = length > 0 && (size_t)length < sizeof file && access(file, X_OK) == 0;
    }
    free(copy);
    return found;
}

int plot_check(session *s, const char *path)
{
    char buffer[96];
    if (!path)
        return EXIT_DONE;
    if (!plot_terminal(path, 1, buffer, sizeof buffer))
        return session_usage(s, "--plot expects a file that ends in .png, .svg or .pdf, not '%s'",
                             path);
    if (!stream_writable(path))
        return session_error(s, "%s: cannot be written (%s)", path, strerror(errno));
    if (!on_path("gnuplot"))
        return session_error(s, "--plot needs gnuplot, which is not installed (Debian: the package "
                                "gnuplot-nox)");
    return EXIT_DONE;
}

/* Start gnuplot with our pipe as its input and the file as its output. */
static int start(pid_t *out_child, int *out_pipe, int drawing)
{
    char *const call[] = {"gnuplot", "-d", NULL};
    posix_spawn_file_actions_t actions;
    int ends[2];
    if (pipe(ends) != 0)
        return errno;
    posix_spawn_file_actions_init(&actions);
    posix_spawn_file_actions_adddup2(&actions, ends[0], STDIN_FILENO);
    posix_spawn_file_actions_adddup2(&actions, drawing, STDOUT_FILENO);
    posix_spawn_file_actions_addclose(&actions, ends[1]);
    posix_spawn_file_actions_addclose(&actions, ends[0]);
    const int reason = posix_spawnp(out_child, call[0], &actions, NULL, call, environ);
    posix_spawn_file_actions_destroy(&actions);
    close(ends[0]);
    *out_pipe = ends[1];
    if (reason != 0)
        close(ends[1]);
    return reason;
}

/* Feed the script to the child and wait; true if it drew. */
static bool feed(pid_t child, int pipe_end, const char *path, const plot_page *page)
{
    struct sigaction ignore = {.sa_handler = SIG_IGN}, before;
    int state = 1;
    sigaction(SIGPIPE, &ignore, &before); /* if it ends early, its exit code tells */
    FILE *file = fdopen(pipe_end, "w");
    if (file) {
        plot_script(file, path, page);
        fclose(file);
    } else {
        close(pipe_end);
    }
    while (waitpid(child, &state, 0) < 0 && errno == EINTR)
        ;
    sigaction(SIGPIPE, &before, NULL);
    return file && WIFEXITED(state) && WEXITSTATUS(state) == 0;
}

int plot_draw(session *s, const char *path, const plot_page *page)
{
    pid_t child;
    int pipe_end = -1;
    struct stat about;
    const int drawing = open(path, O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0666);
    if (drawing < 0)
        return session_error(s, "%s: cannot be written (%s)", path, strerror(errno));
    const bool regular = fstat(drawing, &about) == 0 && S_ISREG(about.st_mode);
    fflush(stdout);
    const int reason = start(&child, &pipe_end, drawing);
    const bool drawn = reason == 0 && feed(child, pipe_end, path, page);
    const bool closed = close(drawing) == 0;
    if (drawn && closed)
        return EXIT_DONE;
    if (regular)
        unlink(path);
    if (reason != 0)
        return session_error(s, "gnuplot cannot be started (%s)", strerror(reason));
    return session_error(s, "%s: gnuplot failed to draw it", path);
}
