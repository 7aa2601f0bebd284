#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""run.py CHECK ROOT [ARGUMENT...]: run one style check, print its complaints, fail if there are any.

A check is a module of this folder with check(root, *arguments), yielding one sentence per complaint.
"""
import importlib
import pathlib
import sys


def main():
    module = importlib.import_module(sys.argv[1])
    complaints = list(module.check(pathlib.Path(sys.argv[2]), *sys.argv[3:]))
    for complaint in complaints:
        print(complaint)
    return 1 if complaints else 0


if __name__ == "__main__":
    sys.exit(main())
