# Two stages: the first builds, the second holds the program and the libraries it runs with.
#   docker build -t adit .
#   docker run --rm -v "$PWD:/work" adit run clip.avi --csv headings.csv
FROM debian:12-slim AS build
WORKDIR /src
COPY scripts/setup scripts/packages.txt scripts/
# dpkg-dev and file: cpack asks them which libraries the program needs.
# hadolint ignore=DL3008
RUN scripts/setup --yes build sim \
    && apt-get install -y --no-install-recommends dpkg-dev file \
    && rm -rf /var/lib/apt/lists/*
COPY . .
RUN cmake -S . -B /build -G Ninja -DCMAKE_BUILD_TYPE=Release -DADIT_SIM=ON -DADIT_TESTS=OFF -DADIT_BENCH=OFF \
      -DCMAKE_INSTALL_PREFIX=/usr \
    && cmake --build /build \
    && (cd /build && cpack -G DEB)

FROM debian:12-slim
COPY --from=build /build/libadit0_*.deb /build/adit_*.deb /tmp/
# hadolint ignore=DL3008
RUN apt-get update \
    && apt-get install -y --no-install-recommends /tmp/libadit0_*.deb /tmp/adit_*.deb \
    && rm -rf /var/lib/apt/lists/* /tmp/*.deb \
    && useradd --create-home adit
USER adit
WORKDIR /work
ENTRYPOINT ["adit"]
CMD ["--help"]
