# SPDX-License-Identifier: MIT
"""truckride/truckride.h includes every public header and holds nothing else."""
import re

from tree import blank, public_headers


def check(root):
    text = blank((root / "include" / "truckride" / "truckride.h").read_text())
    included = set()
    for line in text.splitlines():
        match = re.fullmatch(r"#include <truckride/(\w+\.h)>\s*", line)
        if match:
            included.add(match[1])
        elif line.strip() and not re.fullmatch(r"#(ifndef|define) TRUCKRIDE_TRUCKRIDE_H|#endif", line.strip()):
            yield f"truckride.h holds more than includes: {line.strip()}"
    present = {path.name for path in public_headers(root)}
    for name in sorted(present - included):
        yield f"truckride.h does not include <truckride/{name}>"
    for name in sorted(included - present):
        yield f"truckride.h includes <truckride/{name}>, which does not exist"
