"""Follow docs/deploy.md, line by line, on two empty machines: ``python -m tests.deploy.follow FOLDER [--site FILES]``.

The machines are QEMU's, each with Debian's own kernel. It takes root, 10 GB and, from Debian, ``debootstrap nftables
qemu-system-x86``. ``FOLDER`` keeps their disks, what they print (``first.console``) and what was typed and answered
(``transcript.md``). ``FILES`` is a tree laid over an empty machine: what it takes to reach packages where you are. The
sources are the last commit's.

Their processors are emulated. That takes half an hour, as the cases of the guide's study, which would take hours, are
made small. With ``--accelerator kvm`` nothing is emulated, and the study is the guide's own.
"""

import argparse
import json
import os
import re
import shlex
import shutil
import socket
import subprocess
import time
from concurrent.futures import ThreadPoolExecutor
from contextlib import ExitStack
from functools import partial
from pathlib import Path

from tests.deploy.test_document import BLOCKS, ROOT
from tests.e2e.conftest import SMALL

NETWORK, OURS = "10.78.0", "10.78.0.254"
KERNEL = "linux-image-cloud-amd64"
PATIENCE_S = 3600  # installing, and compiling the solver
CONSOLE = f"""[Unit]
After=network.target
[Service]
EnvironmentFile=-/etc/environment
Environment=HOME=/root
ExecStart=/bin/bash -c 'exec bash --norc <>/dev/tcp/{OURS}/$PORT >&0 2>&1'
Restart=always
RestartSec=1
StartLimitIntervalSec=0
"""
INTERFACES = f"""auto lo eth0
iface lo inet loopback
iface eth0 inet static
    address {NETWORK}.%d/24
    gateway {OURS}
"""


def run(command: str) -> str:
    """What a command of this machine prints."""
    return subprocess.run(shlex.split(command), check=True, stdout=subprocess.PIPE, text=True).stdout


class Machine:
    """One of the two, number 1 or 2, with a shell of root's that stays."""

    def __init__(self, name: str, number: int, folder: Path) -> None:
        self.name, self.number, self.folder = name, number, folder
        self.address = f"{NETWORK}.{number}"
        self._server = socket.create_server((OURS, 7000 + number))
        self._server.settimeout(PATIENCE_S)

    def install(self, empty: Path, accelerator: str) -> None:
        """Give it a disk with nothing but the base system, and the sources."""
        tree = self.folder / self.name
        subprocess.run(["cp", "-a", empty, tree], check=True)
        (tree / "etc/hostname").write_text(self.name)
        (tree / "etc/hosts").write_text(f"127.0.0.1 localhost\n127.0.1.1 {self.name}\n")
        (tree / "etc/network/interfaces").write_text(INTERFACES % self.number)
        units = tree / "etc/systemd/system"
        (units / "console.service").write_text(CONSOLE.replace("$PORT", str(7000 + self.number)))
        (units / "multi-user.target.wants/console.service").symlink_to("../console.service")
        sources = tree / "usr/local/src/tracksweep"
        sources.mkdir()
        with subprocess.Popen(["git", "archive", "HEAD"], cwd=ROOT, stdout=subprocess.PIPE) as archive:
            subprocess.run(["tar", "--extract", "--directory", sources], stdin=archive.stdout, check=True)
        if accelerator == "tcg":
            study = sources / "examples/speed_sweep.json"
            study.write_text(json.dumps(json.loads(study.read_text()) | {"numerics": SMALL}))
        disk = self.folder / f"{self.name}.ext4"
        disk.unlink(missing_ok=True)
        os.truncate(os.open(disk, os.O_CREAT | os.O_WRONLY), 8 << 30)
        run(f"mkfs.ext4 -q -F -d {tree} {disk}")
        shutil.rmtree(tree)

    def boot(self, empty: Path, accelerator: str) -> None:
        kernel, initrd = (next(empty.glob(f"boot/{name}-*")) for name in ("vmlinuz", "initrd.img"))
        disk = self.folder / f"{self.name}.ext4"
        command = (
            f"qemu-system-x86_64 -accel {accelerator} -cpu max -m 3G -display none"
            f" -kernel {kernel} -initrd {initrd} -append 'root=/dev/vda rw console=ttyS0 net.ifnames=0'"
            f" -serial file:{self.folder / self.name}.console -drive file={disk},format=raw,if=virtio"
            f" -netdev tap,id=cable,ifname=followed{self.number},script=no,downscript=no"
            f" -device virtio-net-pci,netdev=cable,mac=02:00:00:00:00:0{self.number}"
        )
        self._process = subprocess.Popen(shlex.split(command), stdin=subprocess.DEVNULL, start_new_session=True)
        connection, _ = self._server.accept()
        connection.settimeout(PATIENCE_S)
        self._shell = connection.makefile("rwb", buffering=0)
        self.type("trap 'failed=1; echo \"failed: $BASH_COMMAND\"' ERR; set -E; export FIRST SECOND")

    def type(self, block: str) -> str:
        """What it answers. Any line of the block that fails ends all."""
        self._shell.write(f"failed=\n{block.rstrip()}\necho; echo ----$failed\n".encode())
        lines: list[str] = []
        while (line := self._shell.readline().decode(errors="replace")) and not re.match(r"----1?$", line):
            lines.append(line)
        with (self.folder / "transcript.md").open("a") as transcript:
            print(
                f"## {self.name}, {time.strftime('%X')}\n```sh\n{block}```\n```\n{''.join(lines)}```", file=transcript
            )
        if line != "----\n":
            raise RuntimeError(f"{self.name}: {''.join(lines[-20:])}")
        return "".join(lines)

    def shut_down(self) -> None:
        self._shell.write(b"systemctl poweroff\n")
        self._process.wait(timeout=300)


def network(stack: ExitStack) -> None:
    """Join both to this machine by a bridge, and to what lies beyond as if they were this machine."""
    run("ip link add followed type bridge")
    stack.callback(run, "ip link del followed")
    run(f"ip addr add {OURS}/24 dev followed")
    run("ip link set followed up")
    for number in (1, 2):
        run(f"ip tuntap add followed{number} mode tap")
        stack.callback(run, f"ip tuntap del followed{number} mode tap")
        run(f"ip link set followed{number} master followed up")
    run("sysctl -q net.ipv4.ip_forward=1")
    run("nft add table ip followed")
    stack.callback(run, "nft delete table ip followed")
    run("nft add chain ip followed out { type nat hook postrouting priority 100 ; }")
    run(f"nft add rule ip followed out ip saddr {NETWORK}.0/24 oifname != followed masquerade")


def debian(folder: Path, site: Path | None) -> Path:
    """A tree of Debian's base system, and of the files that belong to the place."""
    tree = folder / "debian"
    if not tree.exists():
        run(f"debootstrap --include=ca-certificates,{KERNEL} bookworm {folder / 'unfinished'}")
        (folder / "unfinished").rename(tree)
    shutil.copy("/etc/resolv.conf", tree / "etc/resolv.conf")
    if site:
        shutil.copytree(site, tree, dirs_exist_ok=True)
        run(f"chroot {tree} update-ca-certificates")
    return tree


def filled(block: str, values: dict[str, str]) -> str:
    """What the guide leaves to fill in: addresses, and what an earlier block has printed."""
    return re.sub(r"(\w+)=(192\.0\.2\.\d|0123456789abcdef|ts_1_\.\.\.)", lambda m: f"{m[1]}={values[m[1]]}", block)


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("folder", type=lambda name: Path(name).resolve())
    parser.add_argument("--site", type=Path)
    parser.add_argument("--accelerator", choices=("tcg", "kvm"), default="tcg")
    asked = parser.parse_args()
    asked.folder.mkdir(exist_ok=True)
    with ExitStack() as stack:
        network(stack)
        first, second = machines = [Machine(name, n, asked.folder) for n, name in enumerate(("first", "second"), 1)]
        empty = debian(asked.folder, asked.site)
        for machine in machines:
            machine.install(empty, asked.accelerator)
            machine.boot(empty, asked.accelerator)
            stack.callback(machine.shut_down)
        where = {"both": machines, "first": [first], "second": [second], "anywhere": [second], "upgrade": machines}
        values = {"FIRST": first.address, "SECOND": second.address}
        pool = stack.enter_context(ThreadPoolExecutor())
        for place, block in BLOCKS:
            if place not in where:
                continue
            for answer in pool.map(partial(Machine.type, block=filled(block, values)), where[place]):
                values |= {"PASSWORD": found[0]} if (found := re.search(r"^[0-9a-f]{48}$", answer, re.M)) else {}
                values |= {"TRACKSWEEP_API_KEY": found[0]} if (found := re.search(r"^ts_\S+$", answer, re.M)) else {}
            print(f"followed: {place}", flush=True)
            if "peaks.csv" in block and "wheel_rail_force" not in answer:
                raise RuntimeError("no peaks")


if __name__ == "__main__":
    main()
