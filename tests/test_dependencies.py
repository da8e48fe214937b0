"""What is installed is what was locked: every file by its hash, from the public index alone."""

import tomllib
from pathlib import Path
from urllib.parse import urlsplit

LOCK = tomllib.loads((Path(__file__).parents[1] / "uv.lock").read_text())


def test_every_package_is_pinned_by_the_hashes_of_its_files() -> None:
    files = 0
    for package in LOCK["package"]:
        if package["source"] in ({"editable": "."}, {"virtual": "."}):
            continue
        assert package["source"] == {"registry": "https://pypi.org/simple"}, package["name"]
        for file in [*package.get("wheels", ()), *([package["sdist"]] if "sdist" in package else ())]:
            assert urlsplit(file["url"]).netloc == "files.pythonhosted.org", package["name"]
            kind, _, digest = file["hash"].partition(":")
            assert (kind, len(digest)) == ("sha256", 64), package["name"]
            files += 1
    assert files > len(LOCK["package"])
