"""Keep a handful of processes running: start them in order, restart what ends, stop all of them together.

SIGUSR2 drains: the parts of the last stage get it too, are not restarted once they have ended, and then all else stops.
"""

import asyncio
import ctypes
import os
import signal
import subprocess
import sys
import time
from collections.abc import AsyncIterator, Awaitable, Callable, Sequence
from contextlib import AsyncExitStack, asynccontextmanager, suppress
from dataclasses import dataclass
from functools import partial
from pathlib import Path
from typing import cast

import structlog

log = structlog.get_logger()

FIRST_PAUSE_S, LONGEST_PAUSE_S = 0.2, 10.0
STEADY_S = 30.0  # a part that ran this long starts its pauses anew
READY_TIMEOUT_S = 60.0
READY_ATTEMPTS = 3
STOP_TIMEOUT_S = 5.0
STOP_SIGNALS = (signal.SIGINT, signal.SIGTERM, signal.SIGHUP)
DRAIN_SIGNAL = signal.SIGUSR2

PR_SET_PDEATHSIG = 1
_libc = ctypes.CDLL(None)  # loaded here: little is safe between fork and exec


@dataclass(frozen=True, kw_only=True)
class Part:
    """One process of the service.

    Attributes
    ----------
    name : str
    command : sequence of str
    ready : callable, optional
        Whether the part does its work by now; asked until true before the next stage starts.
    pass_fds : sequence of int
        File descriptors the process inherits.
    """

    name: str
    command: Sequence[str]
    ready: Callable[[], Awaitable[bool]] | None = None
    pass_fds: Sequence[int] = ()


class PartFailedError(Exception):
    """A part that does not come up."""


def _die_with(parent: int) -> None:
    """Have the kernel kill this process when its parent ends, however that ends (Linux)."""
    _libc.prctl(PR_SET_PDEATHSIG, signal.SIGKILL)
    if os.getppid() != parent:  # it ended before the call
        os.kill(os.getpid(), signal.SIGKILL)


class Keeper:
    """Keeps one part running and its output in a file."""

    def __init__(self, part: Part, log_file: Path) -> None:
        self.part = part
        self.log_file = log_file
        self.endings = 0
        self._process: asyncio.subprocess.Process | None = None
        self._draining = False
        self._log = log.bind(part=part.name)

    def drain(self) -> None:
        """Have the part end when it has finished what it is at."""
        self._draining = True
        if self._process is not None:
            with suppress(ProcessLookupError):
                self._process.send_signal(DRAIN_SIGNAL)

    async def keep(self) -> None:
        """Run the part again and again, until cancelled or drained."""
        pause = FIRST_PAUSE_S
        while not self._draining:
            started = time.monotonic()
            code = await self._run_once()
            self.endings += 1
            if self._draining:
                self._log.info("part drained", exit_code=code)
                return
            if time.monotonic() - started > STEADY_S:
                pause = FIRST_PAUSE_S
            self._log.warning("part ended, will be restarted", exit_code=code, pause_s=pause, log=str(self.log_file))
            await asyncio.sleep(pause)
            pause = min(2 * pause, LONGEST_PAUSE_S)

    async def wait_until_ready(self) -> None:
        """Return once the part is ready; raise PartFailedError when it will not be."""
        deadline = time.monotonic() + READY_TIMEOUT_S
        while self.part.ready is not None and not await self.part.ready():
            if self.endings >= READY_ATTEMPTS or time.monotonic() > deadline:
                raise PartFailedError(f"{self.part.name} does not start.\n{self._last_lines()}")
            await asyncio.sleep(0.05)

    async def _run_once(self) -> int:
        with self.log_file.open("ab") as output:
            process = self._process = await asyncio.create_subprocess_exec(
                *self.part.command,
                stdin=subprocess.DEVNULL,
                stdout=output,
                stderr=output,
                pass_fds=self.part.pass_fds,
                # The terminal's Ctrl-C is for the supervisor alone. Not a session of its own: Linux weighs the
                # niceness of processes only within one.
                process_group=0,
                preexec_fn=partial(_die_with, os.getpid()) if sys.platform == "linux" else None,
            )
        self._log.info("part started", pid=process.pid)
        try:
            return await process.wait()
        finally:
            await self._end(process)

    async def _end(self, process: asyncio.subprocess.Process) -> None:
        if process.returncode is None:
            process.terminate()
            with suppress(TimeoutError):
                await asyncio.wait_for(process.wait(), STOP_TIMEOUT_S)
                self._log.info("part stopped", exit_code=process.returncode)
        with suppress(ProcessLookupError):  # the part, if it would not stop, and whatever it started
            os.killpg(process.pid, signal.SIGKILL)
        await process.wait()

    def _last_lines(self) -> str:
        lines = self.log_file.read_text(errors="replace").splitlines()[-20:]
        return "\n".join([f"The end of {self.log_file}:", *(f"  {line}" for line in lines)])


@asynccontextmanager
async def _stage(parts: Sequence[Part], logs: Path) -> AsyncIterator[Callable[[], Awaitable[None]]]:
    """Parts that start and stop side by side, and what drains them."""
    keepers = [Keeper(part, logs / f"{part.name}.log") for part in parts]
    tasks = [asyncio.create_task(keeper.keep()) for keeper in keepers]

    async def drain() -> None:
        for keeper in keepers:
            keeper.drain()
        await asyncio.gather(*tasks)

    try:
        await asyncio.gather(*(keeper.wait_until_ready() for keeper in keepers))
        yield drain
    finally:
        for task in tasks:
            task.cancel()
        await asyncio.gather(*tasks, return_exceptions=True)


async def supervise(stages: Sequence[Sequence[Part]], logs: Path, on_ready: Callable[[], None]) -> None:
    """Start the stages one after another and keep them up until a signal; then stop them in reverse order, the last
    one drained before if that is what the signal says.

    Raises
    ------
    PartFailedError
        If a part does not become ready; those that run are stopped before.
    """
    loop, this = asyncio.get_running_loop(), cast("asyncio.Task[None]", asyncio.current_task())

    def stop(number: signal.Signals) -> None:
        log.info("stopping", signal=number.name)
        for each in STOP_SIGNALS:  # one is enough: all that follows has a time limit
            loop.add_signal_handler(each, lambda: None)
        this.cancel()

    for number in STOP_SIGNALS:
        loop.add_signal_handler(number, stop, number)
    draining = asyncio.Event()
    loop.add_signal_handler(DRAIN_SIGNAL, draining.set)
    with suppress(asyncio.CancelledError):
        async with AsyncExitStack() as running:
            for parts in stages:
                drain = await running.enter_async_context(_stage(parts, logs))
            on_ready()
            await draining.wait()
            log.info("draining", signal=DRAIN_SIGNAL.name)
            await drain()
