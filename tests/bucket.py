"""A bucket of a server that speaks S3, in a process of its own. It forgets everything when it is killed."""

import socket
import subprocess
import sys
from collections.abc import Iterator
from contextlib import suppress

import httpx
import pytest

from tests.conftest import free_port

NAME = "tracksweep"


class Bucket:
    """A bucket on a port that stays the same, however often its server is started."""

    def __init__(self) -> None:
        self._port = free_port()
        self.endpoint = f"http://127.0.0.1:{self._port}"
        self.url = f"s3://{NAME}/histories"
        self.start()

    def start(self) -> None:
        command = [sys.executable, "-m", "moto.server", "-H", "127.0.0.1", "-p", str(self._port)]
        self._server = subprocess.Popen(command, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
        while True:
            assert self._server.poll() is None
            with suppress(OSError), socket.create_connection(("127.0.0.1", self._port)):
                break
        httpx.put(f"{self.endpoint}/{NAME}", trust_env=False).raise_for_status()

    def kill(self) -> None:
        self._server.kill()
        self._server.wait()

    def get(self, key: str) -> httpx.Response:
        """An object, as its owner reads it."""
        return httpx.get(
            f"{self.endpoint}/{NAME}/histories/{key}", headers={"Authorization": "AWS key:signature"}, trust_env=False
        )


@pytest.fixture(scope="module")
def bucket() -> Iterator[Bucket]:
    bucket = Bucket()
    with pytest.MonkeyPatch.context() as patch:
        patch.setenv("AWS_ENDPOINT", bucket.endpoint)
        patch.setenv("AWS_REGION", "eu-central-1")
        patch.setenv("AWS_ACCESS_KEY_ID", "key")
        patch.setenv("AWS_SECRET_ACCESS_KEY", "secret")
        yield bucket
    bucket.kill()
