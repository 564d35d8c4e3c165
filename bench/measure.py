# SPDX-License-Identifier: Apache-2.0
"""What every benchmark shares: whole processes measured one after the other, peers in turn, and reports that say machine,
commit and load. CPU time is what the system charges the process (wait4); anonymous memory (RssAnon) is looked at while it runs."""
import json
import os
import platform
import statistics
import subprocess
import sys
import threading
import time
from dataclasses import dataclass
from pathlib import Path

HERE = Path(__file__).resolve().parent
MIB = 1 << 20


@dataclass
class Run:
    """One run of one process."""
    wall: float
    cpu: float
    peak_rss: int  # bytes, mapped files included
    peak_anon: int  # bytes of anonymous memory, the most that was seen; 0 when nobody looked
    out: str
    err: str = ""


def _watch_anon(pid, stop, peak):
    path = f"/proc/{pid}/status"
    while not stop.wait(0.002):
        try:
            with open(path) as status:
                for line in status:
                    if line.startswith("RssAnon:"):
                        peak[0] = max(peak[0], int(line.split()[1]) * 1024)
                        break
        except OSError:
            return


def _prepare(cores, alone):
    if cores:
        os.sched_setaffinity(0, cores)
    if alone:
        try:
            os.sched_setscheduler(0, os.SCHED_RR, os.sched_param(1))
        except OSError:
            pass  # Not allowed: it shares the cores with whatever else runs.


def run_process(command, *, cores=None, env=None, watch_memory=False, alone=False):
    """Runs a command to its end. `cores`: on these only ({0}, {0, 1}). `alone`: before all other work on the machine, where
    the system lets us, so that wall times mean something on a busy one. Watching memory costs the other core a little: times
    are taken in runs without it."""
    pin = (lambda: _prepare(cores, alone)) if cores or alone else None
    start = time.monotonic()
    process = subprocess.Popen([str(part) for part in command], stdout=subprocess.PIPE, stderr=subprocess.PIPE,
                               env={**os.environ, **(env or {})}, preexec_fn=pin)
    peak, stop = [0], threading.Event()
    watcher = threading.Thread(target=_watch_anon, args=(process.pid, stop, peak)) if watch_memory else None
    if watcher:
        watcher.start()
    said = []
    drain = threading.Thread(target=lambda: said.append(process.stderr.read()))
    drain.start()
    out = process.stdout.read()
    drain.join()
    _, status, usage = os.wait4(process.pid, 0)
    wall = time.monotonic() - start
    process.returncode = os.waitstatus_to_exitcode(status)
    if watcher:
        stop.set()
        watcher.join()
    if process.returncode:
        sys.exit(f"bench: {' '.join(str(part) for part in command)} failed with {process.returncode}: "
                 f"{said[0].decode(errors='replace').strip()}")
    return Run(wall, usage.ru_utime + usage.ru_stime, usage.ru_maxrss * 1024, peak[0], out.decode(), said[0].decode(errors="replace"))


def run_alternating(commands, rounds, **how):
    """commands: {name: command}. Runs all of them once unmeasured, so that files are in memory, then `rounds` times in turn,
    every other round in the opposite order. Returns {name: [Run, ...]}."""
    runs = {name: [] for name in commands}
    for command in commands.values():
        run_process(command, **how)
    for i in range(rounds):
        for name in list(commands)[:: -1 if i % 2 else 1]:
            runs[name].append(run_process(commands[name], **how))
    return runs


def spread(values, digits=4):
    values = list(values)
    return {"median": round(statistics.median(values), digits), "least": round(min(values), digits),
            "most": round(max(values), digits)}


def ratios(slow, fast, key="cpu"):
    """Of each round: how many times `slow` took what `fast` took."""
    return spread((getattr(a, key) / getattr(b, key) for a, b in zip(slow, fast)), 2)


def machine():
    model = next((line.split(":", 1)[1].strip() for line in open("/proc/cpuinfo") if line.startswith("model name")), "?")
    return f"{model}, {os.cpu_count()} cores, Linux {platform.release()}"


def commit():
    """Of what is measured: results and documents that measuring itself changes do not make it another."""
    def git(*words):
        return subprocess.run(["git", "-C", HERE.parent, *words], capture_output=True, text=True, check=True).stdout.strip()
    try:
        dirty = git("status", "--porcelain", "--untracked-files=no", "--", ".", ":!bench/results", ":!docs")
        return git("rev-parse", "--short", "HEAD") + ("-dirty" if dirty else "")
    except (OSError, subprocess.CalledProcessError):
        return "unknown"


def write_report(name, report):
    """bench/results/NAME.json, with machine, commit, load of the last minute and the command that makes it again."""
    command = " ".join(["bench/" + Path(sys.argv[0]).name, *sys.argv[1:]])
    full = {"what": report["what"], "command": command, "machine": machine(), "commit": commit(),
            "load": round(os.getloadavg()[0], 1), **report}
    path = HERE / "results" / f"{name}.json"
    path.parent.mkdir(exist_ok=True)
    path.write_text(json.dumps(full, indent=1) + "\n")
    return full
