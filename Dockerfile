# One image for the API, the workers and the migration: what runs is the argument, as in `tracksweep api`.
ARG PYTHON=python:3.11-slim-bookworm@sha256:a36c24f9cbdf4fd0f52d67f0823eeac19c2028c637cecc392d97f980d4fec56b

FROM ${PYTHON} AS build
ENV UV_PYTHON_DOWNLOADS=never UV_LINK_MODE=copy UV_PROJECT_ENVIRONMENT=/opt/tracksweep
RUN pip install --no-cache-dir uv==0.13.9
WORKDIR /src
# What is locked changes less often than the sources: it is a layer of its own.
COPY pyproject.toml uv.lock README.md LICENSE ./
RUN uv sync --frozen --no-dev --extra postgres --no-install-project --compile-bytecode
COPY app app
COPY worker worker
COPY solver solver
COPY migrations migrations
COPY client client
RUN uv sync --frozen --no-dev --extra postgres --no-editable --compile-bytecode

FROM ${PYTHON}
# The folders exist so that volumes mounted there begin with their owner: histories, and the solver's compiled code.
RUN useradd --uid 10001 --create-home tracksweep \
    && install -d -o tracksweep -g tracksweep -m 700 /data /home/tracksweep/.cache
COPY --from=build /opt/tracksweep /opt/tracksweep
ENV PATH=/opt/tracksweep/bin:$PATH \
    PYTHONDONTWRITEBYTECODE=1 \
    PYTHONUNBUFFERED=1 \
    TRACKSWEEP_DATA_DIR=/data \
    TRACKSWEEP_HOST=0.0.0.0
USER 10001
WORKDIR /data
VOLUME ["/data", "/home/tracksweep/.cache"]
EXPOSE 8000
# Of the API. A worker that hangs loses its lease, which needs no one to look.
HEALTHCHECK --interval=10s --timeout=5s --start-period=30s \
    CMD ["python", "-c", "import urllib.request; urllib.request.urlopen('http://127.0.0.1:8000/readyz', timeout=4)"]
ENTRYPOINT ["tracksweep"]
CMD ["api"]
