#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Runs a program with the test runtime: run.py MODE COMMAND...

MODE is simulated, qwerty (says each pulse at the end), remote (somebody must move the hands), xcb or remote_xcb (a
window shows what the headset would show). The service's log follows on stderr. Exit code: the program's; 77: no runtime here.
"""
import sys

import remote
from monado import MODES, SKIPPED, Monado, Skipped


def main():
    if len(sys.argv) < 3 or sys.argv[1] not in MODES:
        sys.exit(__doc__)
    if sys.argv[1].startswith("remote"):
        remote.in_own_network()
    try:
        with Monado(sys.argv[1]) as runtime:
            program = runtime.popen(sys.argv[2:], stdin=None, stdout=None, stderr=None)
            code = program.wait()
            sys.stderr.write(runtime.said())
    except Skipped as reason:
        print(f"skipped: {reason}", file=sys.stderr)
        code = SKIPPED
    except KeyboardInterrupt:
        code = 130
    sys.exit(code)


if __name__ == "__main__":
    main()
