"""The browser of these tests: Chromium, wherever this machine has it. ``python -m tests.web.browser`` installs it."""

import os
import shutil
import subprocess
import sys
from pathlib import Path

# The first has nothing of a browser but what pages need, and shows the first of them in half the time.
NAMES = ("chromium-headless-shell", "chromium", "chromium-browser", "google-chrome", "google-chrome-stable")
OWN = Path(__file__).parents[2] / ".browsers"  # where Playwright puts its own
FLAGS = [
    "--no-sandbox",
    "--disable-gpu",
    "--disable-background-networking",
    "--disable-quic",
    "--no-first-run",
    "--disable-component-update",
    "--disable-sync",
]


def find() -> str | None:
    """The path of a Chromium, or None."""
    found = filter(None, map(shutil.which, NAMES))
    return next(found, None) or next(map(str, OWN.glob("chromium_headless_shell-*/*/*headless*shell")), None)


def install() -> None:
    """By Debian's packages or, where that cannot be, by Playwright."""
    root = [] if os.geteuid() == 0 else ["sudo", "-n"]
    apt = [*root, "apt-get", "-qq", "-o", "Dpkg::Use-Pty=0"]
    own = [sys.executable, "-m", "playwright", "install", "--only-shell", "chromium"]
    packages = ["chromium-headless-shell", "fonts-liberation"]
    ways = [[[*apt, "update"], [*apt, "install", "-y", "--no-install-recommends", *packages]], [own]]
    for commands in ways:
        if all(_done(command) for command in commands) and find():
            return
    sys.exit("The tests of the page need Chromium, and it could not be installed: install it, or put it on the PATH.")


def _done(command: list[str]) -> bool:
    environment = os.environ | {"DEBIAN_FRONTEND": "noninteractive", "PLAYWRIGHT_BROWSERS_PATH": str(OWN)}
    try:
        return subprocess.run(command, env=environment, stdout=sys.stderr, check=False).returncode == 0
    except FileNotFoundError:
        return False


if __name__ == "__main__" and find() is None:
    print("Installing Chromium for the tests of the page ...", flush=True)
    install()
