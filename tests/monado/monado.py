# SPDX-License-Identifier: Apache-2.0
"""The real OpenXR runtime of the tests: starts Monado's service, runs programs with it, and cleans up.

It lives in build/xr-runtime (scripts/xr_runtime.sh) as files of Debian 13, so each program that uses it, ours too, is
started by Debian 13's dynamic loader; libraries that Debian 13 does not have come from the system, behind its own.
"""
import contextlib
import ctypes
import os
import pathlib
import shutil
import signal
import subprocess
import sys
import tempfile
import time

ROOT = pathlib.Path(__file__).resolve().parents[2]
SKIPPED = 77
SYSTEM_LIBRARIES = ["/usr/lib/x86_64-linux-gnu", "/lib/x86_64-linux-gnu", "/usr/lib"]

# What the service is told. `null`: nothing is composed, 20 frames a second. Each gives two controllers.
MODES = {
    "simulated": {"XRT_COMPOSITOR_NULL": "1", "SIMULATED_ENABLE": "1", "SIMULATED_LEFT": "simple", "SIMULATED_RIGHT": "simple"},
    "qwerty": {"XRT_COMPOSITOR_NULL": "1", "QWERTY_ENABLE": "1", "QWERTY_LOG": "info"},
    "remote": {"XRT_COMPOSITOR_NULL": "1", "P_OVERRIDE_ACTIVE_CONFIG": "remote"},
    "xcb": {"XRT_COMPOSITOR_FORCE_XCB": "1", "XRT_COMPOSITOR_SCALE_PERCENTAGE": "50",
            "SIMULATED_ENABLE": "1", "SIMULATED_LEFT": "simple", "SIMULATED_RIGHT": "simple"},
    "remote_xcb": {"XRT_COMPOSITOR_FORCE_XCB": "1", "XRT_COMPOSITOR_SCALE_PERCENTAGE": "50", "P_OVERRIDE_ACTIVE_CONFIG": "remote"},
}


def die_with_parent():
    """For preexec_fn: a test that is killed leaves nothing running."""
    pr_set_pdeathsig = 1
    ctypes.CDLL(None).prctl(pr_set_pdeathsig, signal.SIGKILL)


class Skipped(Exception):
    """The runtime cannot be had here."""


def fetch(folder):
    script = ROOT / "scripts/xr_runtime.sh"
    result = subprocess.run([script, folder], stdin=subprocess.DEVNULL, stdout=sys.stderr, check=False)
    if result.returncode == SKIPPED:
        raise Skipped("the OpenXR runtime cannot be had here")
    result.check_returncode()


class Monado:
    """One service in one mode. Use as a context: at its end everything that was started is gone.

    with Monado("simulated") as runtime:
        lines = runtime.run(["build/dev/bin/xr_probe"]).stdout
    """

    def __init__(self, mode, folder=None, environment=None):
        self.mode = mode
        self.folder = pathlib.Path(folder or ROOT / "build/xr-runtime")
        self.more = environment or {}
        self.service = None
        self.programs = []

    def __enter__(self):
        fetch(self.folder)
        self.root = self.folder / "root"
        self.libraries = self.root / "usr/lib/x86_64-linux-gnu"
        self.home = pathlib.Path(tempfile.mkdtemp(prefix="feelem-xr-"))
        self.log = self.home / "service.log"
        self.complaints = self.home / "programs.log"
        manifest = (self.root / "usr/share/openxr/1/openxr_monado.json").read_text()
        self.manifest = self.home / "runtime.json"
        self.manifest.write_text(manifest.replace("libopenxr_monado.so", str(self.libraries / "libopenxr_monado.so")))
        (self.home / "monado").mkdir()
        (self.home / "monado/config_v0.json").write_text('{"remote": {"version": 0, "port": 4242, "view_count": 2}}')
        try:
            self.start()
        except BaseException as error:
            self.__exit__(type(error), error, None)
            raise
        return self

    def __exit__(self, _kind, error, _trace):
        for program in self.programs:
            if program.poll() is None:
                with contextlib.suppress(ProcessLookupError):
                    os.killpg(program.pid, signal.SIGKILL)
                program.wait()
        self.stop()
        if error and not isinstance(error, Skipped):
            for log in (self.log, self.complaints):
                if log.exists():
                    print(f"--- end of {log.name}", log.read_text(errors="replace")[-3000:], sep="\n", file=sys.stderr)
        shutil.rmtree(self.home, ignore_errors=True)

    def environment(self):
        """For the service and its programs alike; nothing of the user's own runtime or settings shines through."""
        mine = {name: value for name, value in os.environ.items()
                if not name.startswith(("XR_", "XRT_", "QWERTY_", "SIMULATED_", "P_", "LD_", "VK_"))}
        data = self.root / "usr/share"
        return mine | {
            "XDG_RUNTIME_DIR": str(self.home),
            "XDG_CONFIG_HOME": str(self.home),
            "XR_RUNTIME_JSON": str(self.manifest),
            "VK_ICD_FILENAMES": str(data / "vulkan/icd.d/lvp_icd.json"),
            "VK_LOADER_LAYERS_DISABLE": "~implicit~",
            "LIBGL_ALWAYS_SOFTWARE": "1",
            "LIBGL_DRIVERS_PATH": str(self.libraries / "dri"),
            "GBM_BACKENDS_PATH": str(self.libraries / "gbm"),
            "__EGL_VENDOR_LIBRARY_DIRS": str(data / "glvnd/egl_vendor.d"),
            "DRIRC_CONFIGDIR": str(data / "drirc.d"),
        } | self.more

    def command(self, command):
        """The same command, started by Debian 13's loader."""
        path = [self.libraries] + [self.libraries / name for name in ("pulseaudio", "lapack", "blas")]
        path += [self.root / "usr/lib", *SYSTEM_LIBRARIES]
        loader = self.libraries / "ld-linux-x86-64.so.2"
        return [str(loader), "--library-path", ":".join(map(str, path)), *map(str, command)]

    def start(self, seconds=60.0):
        """Starts the service and waits until it listens."""
        socket = self.home / "monado_comp_ipc"
        socket.unlink(missing_ok=True)
        with open(self.log, "ab") as log:
            self.service = subprocess.Popen(
                self.command([self.root / "usr/bin/monado-service"]),
                env=self.environment() | MODES[self.mode] | {"XRT_NO_STDIN": "1"},
                stdin=subprocess.DEVNULL, stdout=log, stderr=log, start_new_session=True, preexec_fn=die_with_parent)
        end = time.monotonic() + seconds
        while not socket.exists():
            if self.service.poll() is not None or time.monotonic() > end:
                raise RuntimeError("the service does not start")
            time.sleep(0.02)

    def kill(self):
        """As a crash: no farewell."""
        self.service.kill()
        self.service.wait()

    def stop(self):
        if self.service and self.service.poll() is None:
            self.service.terminate()
            try:
                self.service.wait(5)
            except subprocess.TimeoutExpired:
                self.kill()

    def said(self):
        return self.log.read_text(errors="replace") if self.log.exists() else ""

    def popen(self, command, **settings):
        environment = self.environment() | settings.pop("environment", {})
        environment = {name: value for name, value in environment.items() if value is not None}  # None takes it away.
        with open(self.complaints, "ab") as complaints:
            settings = {"stdin": subprocess.DEVNULL, "stdout": subprocess.PIPE, "stderr": complaints, "text": True} | settings
            program = subprocess.Popen(self.command(command), env=environment, start_new_session=True, preexec_fn=die_with_parent, **settings)
        self.programs.append(program)
        return program

    def run(self, command, seconds=60.0, **settings):
        """Runs to the end, at most `seconds`; what it printed and its exit code."""
        program = self.popen(command, **settings)
        said, _ = program.communicate(timeout=seconds)
        return subprocess.CompletedProcess(command, program.returncode, said)
