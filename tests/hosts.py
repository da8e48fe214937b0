"""Hosts of a network of their own: network namespaces of one Linux machine, joined by a bridge. It takes root."""

import os
import subprocess
from collections.abc import Iterator
from contextlib import contextmanager
from dataclasses import dataclass

NETWORK = "10.77.0"
OURS = f"{NETWORK}.254"  # of whoever made the network


def _ip(*words: str) -> None:
    subprocess.run(["ip", *words], check=True, capture_output=True, text=True)


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
        for host in hosts:
            subprocess.run(["ip", "netns", "del", host.name], check=False, capture_output=True)
        subprocess.run(["ip", "link", "del", bridge], check=False, capture_output=True)
