# SPDX-License-Identifier: MIT
"""The library has no writable global: any number of contexts live in one process. The exception is
a lock that guards the variables of a third-party library."""
import re
import subprocess

LOCKS = {"arpack_lock"}


def check(root, static_library, objdump="objdump"):
    output = subprocess.run([objdump, "-t", static_library], check=True,
                            capture_output=True, text=True).stdout
    member = ""
    for line in output.splitlines():
        if line.endswith(tuple("elf64-x86-64 elf64-littleaarch64".split())):
            member = line.split(":")[0]
        # address flags section size name; .data.rel.ro is read-only once loaded
        match = re.match(r"[0-9a-f]+ .{7} (\S+)\s+([0-9a-f]+)\s+(?:\.\w+ )?(\S+)$", line)
        if match and int(match[2], 16) and match[3] not in LOCKS and re.match(r"\.(data|bss|tdata|tbss)(?!\.rel\.ro)|\*COM\*", match[1]):
            yield f"{member}: {match[3]} is a writable global"
