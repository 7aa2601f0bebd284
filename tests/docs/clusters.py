# SPDX-License-Identifier: MIT
"""Every command block of docs/clusters.md, run; and the tables that come out, byte by byte.

clusters.py <clusters.md> <truckride-study> [<truckride-study-mpi>]
"""
import os
import pathlib
import re
import shutil
import signal
import subprocess
import sys
import tempfile
import time

# Blocks of this page are told apart by how they begin.
BEGINNINGS = {"study.txt": "# ", "serial": "truckride-study @", "parallel": "parallel ", "slurm": "#!/bin/bash",
              "slurm-merge": "truckride-study merge", "mpi": "mpirun "}
page = re.findall(r"^```text\n(.*?)^```$", pathlib.Path(sys.argv[1]).read_text(), re.M | re.S)
blocks = {name: text for name, beginning in BEGINNINGS.items() for text in page if text.startswith(beginning)}
if len(blocks) != len(page):
    sys.exit(f"{len(page)} blocks, of which {sorted(blocks)} are known")
environment = dict(os.environ, PATH=os.pathsep.join(
    [str(pathlib.Path(program).parent) for program in sys.argv[2:]] + [os.environ["PATH"]]),
    OMPI_ALLOW_RUN_AS_ROOT="1", OMPI_ALLOW_RUN_AS_ROOT_CONFIRM="1",
    OMPI_MCA_rmaps_base_oversubscribe="1")


def run(command, expected=0, **more):
    result = subprocess.run(command, env=dict(environment, **more), capture_output=True, text=True, timeout=120)
    if result.returncode != expected:
        sys.exit(f"{command}: exit code {result.returncode}, expected {expected}\n{result.stdout}{result.stderr}")
    return result


def block(name, **more):
    return run(["bash", "-euc", blocks[name]], **more)


def same(name):
    if pathlib.Path(name).read_bytes() != pathlib.Path("serial.csv").read_bytes():
        sys.exit(f"{name} differs from serial.csv")


def killed_and_resumed(program):
    """Killed a few times while it works, the command ends with the same table."""
    command = [program, "@study.txt", "--quiet", "--chunk", "2", "--journal", "killed.journal", "--csv", "killed.csv"]
    for pause in (0.02, 0.05, 0.1, 0.2):
        process = subprocess.Popen(command, env=environment)
        time.sleep(pause)
        process.send_signal(signal.SIGKILL)
        process.wait()
    run(command)
    same("killed.csv")


def usage(program):
    """Exit codes and messages."""
    assert "--vary" in run([program, "--help"]).stdout
    assert "cab_front_left_z" in run([program, "--list"]).stdout
    for words in (["--nonsense", "1"], ["--cases"], ["--cases", "many"], ["stray"], ["--vary", "a=b"],
                  ["--output", "x=rms"], ["--road", "river"], ["--shard", "3/2"], ["--design", "art"]):
        assert "--help" in run([program, *words], expected=2).stderr, words
    for words in (["@missing.txt"], [], ["--output", "x=rms:nowhere"], ["@study.txt", "--csv", "no/such/folder"],
                  ["merge", "@study.txt", "missing.journal"], ["@study.txt", "--seed", "2", "--journal", "task-1.journal"]):
        assert run([program, *words], expected=1).stderr, words
    table, journal = pathlib.Path("serial.csv"), pathlib.Path("task-1.journal")
    before = table.read_bytes(), journal.read_bytes()
    for words in (["--csv", str(journal), "--journal", str(journal)], ["--csv", "--quiet"], ["--journal", "--vary"]):
        run([program, "@study.txt", *words], expected=2)
    run([program, "merge", "@study.txt", str(journal), "--csv", f"./{journal}"], expected=2)
    run([program, "@study.txt", "--seed", "2", "--journal", str(journal), "--csv", str(table)], expected=1)
    assert before == (table.read_bytes(), journal.read_bytes())  # refused: nothing is overwritten
    wrong = run([program, "--shard", "3/2"], expected=2).stderr
    assert wrong.startswith("truckride-study: --shard expects I/N"), wrong
    run(["bash", "-c", f"ulimit -v 4000000; exec '{program}' @study.txt --duration 0.1 --cases 1000000000000"],
        expected=1)  # no memory, and it says so at once
    pathlib.Path("nul.txt").write_bytes(b"--cases 5\0--seed 3\n")
    run([program, "@nul.txt"], expected=1)
    missing = run([program, "merge", "@study.txt", "task-1.journal", "--csv", "part.csv"], expected=1)
    assert "do not hold all cases" in missing.stderr


with tempfile.TemporaryDirectory() as folder:
    os.chdir(folder)
    pathlib.Path("study.txt").write_text(blocks["study.txt"])
    block("serial")
    pathlib.Path("study.sh").write_text(blocks["slurm"])
    run(["bash", "-n", "study.sh"])
    for task in range(1, 9):
        run(["bash", "study.sh"], SLURM_ARRAY_TASK_ID=str(task), SLURM_CPUS_PER_TASK="1")
    block("slurm-merge")
    same("slurm.csv")
    usage(sys.argv[2])
    killed_and_resumed(sys.argv[2])
    if shutil.which("parallel"):
        block("parallel")
        same("parallel.csv")
    if len(sys.argv) > 3 and shutil.which("mpirun"):
        block("mpi")
        same("mpi.csv")
        # Two ranks, one of them at work; then one alone; and a journal that the serial program began.
        for ranks in ("1", "2"):
            run(["mpirun", "-n", ranks, sys.argv[3], "@study.txt", "--quiet", "--csv", f"mpi-{ranks}.csv"])
            same(f"mpi-{ranks}.csv")
        run([sys.argv[2], "@study.txt", "--quiet", "--shard", "2/3", "--journal", "mixed.journal"])
        run(["mpirun", "-n", "2", sys.argv[3], "@study.txt", "--quiet", "--journal", "mixed.journal", "--csv", "mixed.csv"])
        same("mixed.csv")
