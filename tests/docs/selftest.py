#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""selftest.py ROOT BUILD CMAKE CC: plant mistakes in a page that is right, and see run.py find each."""
import pathlib
import sys
import tempfile

from pages import Page
from run import Place, complaints

PAGE = """# Page

```c
trk_curve *curve = NULL;
const double x[] = {-1, 1};
TRY(trk_curve_create(context, "damper", 2, x, x, NULL, &curve));
printf("%.1f\\n", twice(trk_curve_value(curve, 2)));
trk_curve_destroy(curve);
```

```c
static double twice(double value)
{
    return 2 * value;
}
```

```output
4.0
```

```python
print(1 + 1)
```

```output
2
```

```cmake
find_package(truckride 0.1 CONFIG REQUIRED)
target_link_libraries(app PRIVATE truckride::truckride m)
```

```sh
test -f LICENSE
bash .ci/test    # needs long
```
"""
MISTAKES = [
    ("return 2 * value;", "return 2 * valu;", "valu"),
    ("curve_value(curve, 2)", "curve_value(curve, 3)", "c does not print"),
    ('"damper", 2,', '"damper", 1,', "ended with 1"),
    ("trk_curve_destroy(curve);\n", "", "not freed"),
    ("print(1 + 1)", "print(1 + one)", "NameError"),
    ("print(1 + 1)", "print(1 + 2)", "python does not print"),
    ("truckride 0.1", "truckride 99", "compatible with requested version"),
    ("truckride::truckride", "truckride::other", "truckride::other"),
    ("test -f LICENSE", "test -f LICENCE", "ended with 1"),
    ("bash .ci/test ", "bash .ci/tests ", "no script of .ci runs"),
    ("```python", "```", "block marked ''"),
    ("```python", "```py", "block marked 'py'"),
    ("```python\nprint(1 + 1)\n```", "Run:\n\n    print(1 + 1)", "indented block"),
    ("bash .ci/test    # needs long\n```\n", "", "does not end"),
]


def main(root, build, cmake, cc):
    failures = 0
    with tempfile.TemporaryDirectory() as top:
        place = Place(pathlib.Path(root), build, cmake, cc, pathlib.Path(top))
        found = list(complaints(place, Page("right.md", PAGE)))
        if found:
            failures += 1
            print("complains about a page without mistakes:", *found)
        for number, (old, new, words) in enumerate(MISTAKES):
            assert PAGE.count(old) == 1, old
            found = list(complaints(place, Page(f"wrong{number}.md", PAGE.replace(old, new))))
            if not any(words in complaint for complaint in found):
                failures += 1
                print(f"not found: {words!r} with {new!r}; found: {found}")
    print(f"{len(MISTAKES)} mistakes planted, {failures} failures")
    return 1 if failures else 0


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:]))
