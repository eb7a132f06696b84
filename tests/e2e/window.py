"""The real program in an X server and on a bus of its own, found and read as a screen reader does (AT-SPI), driven by
mouse and keys (xdotool). For the tests that use the window from outside.
"""
import os
import shutil
import signal
import subprocess
import time

SCREEN = "1280x720"


class Failure(Exception):
    pass


def what_is_missing():
    """Why the window can't be used here; None if it can."""
    for tool in ("Xvfb", "xdotool", "dbus-daemon", "import"):
        if not shutil.which(tool):
            return f"{tool} is not installed"
    if not os.path.exists("/usr/libexec/at-spi-bus-launcher"):
        return "at-spi2-core is not installed"
    try:
        import gi

        gi.require_version("Atspi", "2.0")
    except (ImportError, ValueError):
        return "python3-gi or gir1.2-atspi-2.0 is not installed"
    return None


class Group:
    """A program with all that it starts, ended together; by their group, which is ours alone."""

    def __init__(self, stack, arguments, **options):
        self.process = subprocess.Popen(arguments, start_new_session=True, **options)
        stack.callback(self.end)

    def end(self):
        for sign in (signal.SIGTERM, signal.SIGKILL):
            try:
                os.killpg(self.process.pid, sign)
            except ProcessLookupError:
                break
            try:
                self.process.wait(5)
            except subprocess.TimeoutExpired:
                continue
        self.process.wait()


def start_screen(stack):
    read, write = os.pipe()
    Group(stack, ["Xvfb", "-displayfd", str(write), "-screen", "0", SCREEN + "x24", "-nolisten", "tcp", "-noreset"],
          pass_fds=[write], stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
    os.close(write)
    with os.fdopen(read) as number:
        line = number.readline().strip()
    if not line:
        raise Failure("Xvfb did not start")
    return ":" + line


def start_bus(stack, environment):
    read, write = os.pipe()
    Group(stack, ["dbus-daemon", "--session", "--nofork", "--nopidfile", f"--print-address={write}"],
          pass_fds=[write], env=environment, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
    os.close(write)
    with os.fdopen(read) as address:
        line = address.readline().strip()
    if not line:
        raise Failure("dbus-daemon did not start")
    return line


def start_program(stack, bin_folder, home, out):
    """The program in a home of its own, on a screen and a bus of their own; what it says goes to out."""
    for name in ("config", "data", "cache", "run"):
        (home / name).mkdir(parents=True)
    (home / "run").chmod(0o700)
    os.environ.update({
        "HOME": str(home), "XDG_CONFIG_HOME": str(home / "config"), "XDG_DATA_HOME": str(home / "data"),
        "XDG_CACHE_HOME": str(home / "cache"), "XDG_RUNTIME_DIR": str(home / "run"), "LC_ALL": "C.UTF-8",
        "QT_QPA_PLATFORM": "xcb", "QT_LINUX_ACCESSIBILITY_ALWAYS_ON": "1", "QT_SCALE_FACTOR": "1",
        "NO_AT_BRIDGE": "0",
    })
    os.environ["DISPLAY"] = start_screen(stack)
    os.environ["DBUS_SESSION_BUS_ADDRESS"] = start_bus(stack, dict(os.environ))
    log = stack.enter_context(open(out / "driftbench.log", "w", encoding="utf-8"))
    return Group(stack, [bin_folder / "driftbench"], stdout=log, stderr=log).process


class Window:
    """The program's window, from outside."""

    def __init__(self, process, out):
        import gi

        gi.require_version("Atspi", "2.0")
        from gi.repository import Atspi

        self.atspi = Atspi
        self.process = process
        self.out = out
        Atspi.init()
        self.application = self.wait_for("the program on the accessibility bus", self.find_application, 60)

    def must_run(self):
        code = self.process.poll()
        if code is not None:
            raise Failure(f"the program ended by itself with {code}")

    def wait_for(self, what, condition, seconds):
        """The first true value of condition; nothing is waited for longer."""
        end = time.monotonic() + seconds
        while True:
            self.must_run()
            began = time.monotonic()
            value = condition()
            if value:
                return value
            now = time.monotonic()
            if now > end:
                raise Failure(f"not within {seconds:.0f} s: {what}")
            time.sleep(max(0.05, now - began))  # who is asked has other things to do

    def find_application(self):
        desktop = self.atspi.get_desktop(0)
        desktop.clear_cache()
        for i in range(desktop.get_child_count()):
            child = desktop.get_child_at_index(i)
            if child is not None and child.get_process_id() == self.process.pid:
                return child
        return None

    def shown(self, under=None):
        """Everything that is on the screen, depth first."""
        under = under or self.application
        try:
            count = under.get_child_count()
            if count > 0 and under.get_role_name() in ("table", "tree table", "menu bar"):
                return
        except Exception:  # it went away meanwhile
            return
        for i in range(min(count, 300)):
            try:
                child = under.get_child_at_index(i)
                if child is None:
                    continue
                states = child.get_state_set()
            except Exception:
                continue
            if not states.contains(self.atspi.StateType.SHOWING):
                continue
            yield child
            yield from self.shown(child)

    def find(self, name, role=None, start=False):
        self.application.clear_cache()
        for each in self.shown():
            try:
                text = each.get_name() or ""
                if (text.startswith(name) if start else text == name) and role in (None, each.get_role_name()):
                    return each
            except Exception:
                continue
        return None

    def need(self, name, role=None, seconds=30.0, start=False):
        return self.wait_for(f"“{name}” on the screen", lambda: self.find(name, role, start), seconds)

    def has_state(self, control, state):
        control.clear_cache()
        return control.get_state_set().contains(state)

    def enabled(self, control):
        return self.has_state(control, self.atspi.StateType.ENABLED)

    def checked(self, control):
        return self.has_state(control, self.atspi.StateType.CHECKED)

    def click(self, control):
        area = control.get_extents(self.atspi.CoordType.SCREEN)
        if area.width <= 0 or area.height <= 0:
            raise Failure(f"“{control.get_name()}” has no place on the screen")
        run_xdotool("mousemove", str(area.x + area.width // 2), str(area.y + area.height // 2), "click", "1")

    def focus(self):
        self.wait_for("the window", lambda: focused("--class", "driftbench"), 30)

    def picture(self, name):
        subprocess.run(["import", "-window", "root", str(self.out / (name + ".png"))], timeout=30, check=False)

    def fill_file_dialog(self, title, path):
        self.wait_for(f"“{title}” on the screen", lambda: focused("--name", title), 30)
        time.sleep(0.5)
        run_xdotool("key", "ctrl+a")
        run_xdotool("type", "--delay", "5", str(path))
        run_xdotool("key", "Return")

    def quit(self, seconds=30):
        """By Ctrl+Q; it must end well."""
        self.focus()
        run_xdotool("key", "ctrl+q")
        try:
            code = self.process.wait(seconds)
        except subprocess.TimeoutExpired as slow:
            raise Failure("the program did not end on Ctrl+Q") from slow
        if code != 0:
            raise Failure(f"the program ended with {code}")


def run_xdotool(*arguments):
    subprocess.run(["xdotool", *arguments], timeout=10, check=True)


def xdotool_lines(*arguments):
    try:
        done = subprocess.run(["xdotool", *arguments], timeout=2, check=False, capture_output=True, text=True)
    except subprocess.TimeoutExpired:
        return []
    return done.stdout.split()


def focused(*which):
    """Whether there is such a window and it could be given the keys: one that is just being mapped can't yet."""
    found = xdotool_lines("search", "--onlyvisible", *which)
    return bool(found) and subprocess.run(
        ["xdotool", "windowfocus", found[-1]], timeout=10, check=False, stderr=subprocess.DEVNULL).returncode == 0
