# SPDX-License-Identifier: Apache-2.0
# A fresh Debian 12 that runs the two commands of the README. As it is built it does what ./run does without a display; the container
# then runs every test:
#   docker build -t handsight . && docker run --rm handsight
# The command line alone: docker run --rm -v "$PWD:/data" handsight build/app/cli/handsight-cli check /data/SESSION
FROM debian:bookworm-slim
RUN apt-get update && apt-get install -y --no-install-recommends ca-certificates && rm -rf /var/lib/apt/lists/*
WORKDIR /handsight
COPY . .
RUN ./run
CMD ["./test"]
