"""Hosts of a network of their own: network namespaces of one Linux machine, joined by a bridge. It takes root."""

import os
import subprocess
from collections.abc import Iterator
from contextlib import contextmanager
from dataclasses import dataclass
from pathlib import Path

import psutil

NETWORK = "10.77.0"
OURS = f"{NETWORK}.254"  # of whoever made the network


def _ip(*words: str) -> None:
    subprocess.run(["ip", *words], check=True, capture_output=True, text=True)


def _remove(owner: int) -> None:
    for space in Path("/run/netns").glob(f"ts{owner}-*"):
        subprocess.run(["ip", "netns", "del", space.name], check=False, capture_output=True)
    subprocess.run(["ip", "link", "del", f"ts{owner}"], check=False, capture_output=True)


@dataclass(frozen=True, kw_only=True)
class Host:
    """One of them.

    Attributes
    ----------
    name : str
        Of the namespace.
    address : str
    port : str
        Where its cable is plugged in.
    """

    name: str
    address: str
    port: str

    def command(self, *words: str) -> list[str]:
        """What runs a program on this host. The process is that of the program."""
        return ["ip", "netns", "exec", self.name, *words]

    def cut_off(self) -> None:
        """Pull the plug: what runs there runs on, and nobody hears of it."""
        _ip("link", "set", self.port, "down")

    def reconnect(self) -> None:
        _ip("link", "set", self.port, "up")


@contextmanager
def network(count: int) -> Iterator[list[Host]]:
    """So many hosts. They reach one another and the machine they are made on, and nobody else.

    Raises
    ------
    PermissionError
        If this user may not make them.
    """
    if os.geteuid() != 0:
        raise PermissionError("network namespaces take root")
    for space in Path("/run/netns").glob("ts*-1"):  # of those who were killed: they have the same addresses
        if not psutil.pid_exists(owner := int(space.name.removeprefix("ts").removesuffix("-1"))):
            _remove(owner)
    own = os.getpid()
    bridge = f"ts{own}"
    hosts = [Host(name=f"ts{own}-{n}", address=f"{NETWORK}.{n}", port=f"ts{own}p{n}") for n in range(1, count + 1)]
    try:
        _ip("link", "add", bridge, "type", "bridge")
        _ip("addr", "add", f"{OURS}/24", "dev", bridge)
        _ip("link", "set", bridge, "up")
        for host in hosts:
            _ip("netns", "add", host.name)
            _ip("link", "add", host.port, "type", "veth", "peer", "name", "eth0", "netns", host.name)
            _ip("link", "set", host.port, "master", bridge, "up")
            for words in (("addr", "add", f"{host.address}/24", "dev", "eth0"), ("link", "set", "eth0", "up")):
                subprocess.run(host.command("ip", *words), check=True)
            subprocess.run(host.command("ip", "link", "set", "lo", "up"), check=True)
        yield hosts
    finally:
        _remove(own)
