"""Settings, from the environment (``TRACKSWEEP_…``) or their defaults: everything below one data folder."""

import hashlib
import os
import tempfile
from functools import cached_property
from pathlib import Path
from typing import Literal
from urllib.parse import quote

from pydantic import Field
from pydantic_settings import BaseSettings, SettingsConfigDict

LONGEST_SOCKET_PATH = 100  # bytes; Linux takes 107, macOS 103


class Settings(BaseSettings):
    """What a process of the service needs to know.

    The URLs left empty are filled from the data folder: SQLite, the embedded broker's socket, a folder of histories.
    """

    model_config = SettingsConfigDict(env_prefix="TRACKSWEEP_", frozen=True)

    data_dir: Path = Field(default=Path("data"), description="Folder of the embedded database, broker and histories.")
    database_url: str = Field(default="", description="SQLAlchemy URL; empty for SQLite in the data folder.")
    broker_url: str = Field(default="", description="Celery broker URL; empty for the embedded broker.")
    storage_url: str = Field(default="", description="URL of the history store; empty for a folder of the data folder.")
    presigned_s: int = Field(default=0, ge=0, le=604_800, description="Life of links into a bucket; 0: none are given.")
    host: str = Field(default="127.0.0.1", description="Address the API listens on.")
    port: int = Field(default=8000, ge=0, le=65535, description="Port the API listens on; 0 for any free one.")
    url: str = Field(default="", description="Service that commands talk to; empty for the one on the data folder.")
    api_processes: int = Field(default=1, ge=1, le=64, description="Processes that answer requests, behind one port.")
    workers: int = Field(default=2, ge=0, le=1024, description="Worker processes that `tracksweep serve` runs.")
    worker_nice: int = Field(default=10, ge=0, le=19, description="How far workers stand back for other processes.")
    writers: int = Field(default=4, ge=1, le=1024, description="Workers that add peaks to PostgreSQL at once.")
    lease_s: float = Field(default=15.0, gt=0, le=3600, description="Time after which a silent worker loses its case.")
    max_attempts: int = Field(default=3, ge=1, le=100, description="Attempts after which a case counts as poison.")
    retention_days: int = Field(default=0, ge=0, le=36500, description="Days that ended studies are kept; 0: for ever.")
    case_time_limit_s: float = Field(default=3600.0, gt=0, le=1e6, description="Longest computation of one case.")
    case_memory_mb: int = Field(default=4096, ge=16, description="Largest memory of cases computed side by side.")
    max_cases_per_study: int = Field(default=10_000, ge=1, description="Largest study that is accepted.")
    max_page_size: int = Field(default=500, ge=1, description="Largest page of a list.")
    max_body_bytes: int = Field(default=1_000_000, ge=1, description="Largest request body.")
    max_profile_bytes: int = Field(default=10_000_000, ge=1, description="Largest measured profile, as CSV.")

    require_keys: Literal["auto", "always", "never"] = Field(
        default="auto", description="Whether every request needs an API key; auto: unless it comes by the loopback."
    )
    reads_per_minute: int = Field(default=6000, ge=0, description="Requests to read, per key or address; 0: any.")
    writes_per_minute: int = Field(default=1200, ge=0, description="Other requests, per key or address; 0: any.")

    max_watchers: int = Field(default=100, ge=1, description="Streams of events that one API process keeps open.")
    watch_keep_alive_s: float = Field(default=15.0, gt=0, description="Longest silence of a stream of events.")

    @cached_property
    def broker_socket(self) -> Path:
        """Unix socket of the embedded broker: in the data folder or, if too long a path, among temporary files."""
        path = os.fsencode(self.data_dir.resolve() / "broker.sock")
        if len(path) <= LONGEST_SOCKET_PATH:
            return Path(os.fsdecode(path))
        private = f"tracksweep-{os.getuid()}-{hashlib.sha256(path).hexdigest()[:16]}"
        return Path(tempfile.gettempdir()) / private / "broker.sock"

    @cached_property
    def resolved_database_url(self) -> str:
        """The database to connect to."""
        return self.database_url or f"sqlite:///{quote(str(self.data_dir.resolve()))}/tracksweep.db"

    @cached_property
    def resolved_broker_url(self) -> str:
        """The broker to connect to."""
        return self.broker_url or f"redis+socket://{quote(str(self.broker_socket))}"

    @cached_property
    def resolved_storage_url(self) -> str:
        """The store of histories."""
        return self.storage_url or (self.data_dir.resolve() / "histories").as_uri()
