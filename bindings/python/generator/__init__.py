# SPDX-License-Identifier: MIT
"""From the public headers to truckride/_abi.py and truckride/_options.py."""
