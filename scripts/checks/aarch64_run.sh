#!/usr/bin/env bash
# The program cross-compiled for 64-bit ARM: `adit run` under qemu, against the answers given here.
. "$(dirname "${BASH_SOURCE[0]}")/prelude.sh"
# With Debian's libraries for that machine, where the archive that apt knows has them.
if ! quietly aarch64-sysroot scripts/aarch64_sysroot build/aarch64-sysroot; then
  echo "adit run on aarch64: skipped: the libraries cannot be had here"
  tally 0 0 1
  exit 0
fi
tail -n 1 build/aarch64-sysroot.log
sysroot=$PWD/build/aarch64-sysroot/root
build_folder=aarch64-program build_targets=adit_program build_preset aarch64 -DADIT_CORE_ONLY=OFF -DADIT_SIM=OFF \
  -DADIT_BENCH=OFF -DADIT_TESTS=OFF -DADIT_WERROR=OFF "-DADIT_AARCH64_SYSROOT=$sysroot"
build_preset release -DADIT_SIM=ON

there() {
  qemu-aarch64 -L "$sysroot" -E LD_LIBRARY_PATH=/usr/lib/aarch64-linux-gnu/blas:/usr/lib/aarch64-linux-gnu/lapack \
    build/aarch64-program/adit "$@"
}
there --version
# The clip as pictures, without loss: on ARM, FFmpeg turns a video's colours into BGR by other code than here, and levels
# differ by one. What is compared is adit.
clip=build/aarch64-clip
rm -rf "$clip"
mkdir -p "$clip"
quietly aarch64-clip ffmpeg -nostdin -y -i data/clip.avi "$clip/%03d.png"
inputs=(data/tunnel.jpg "$clip")
real=${ADIT_DATA:-../shared/data}/real/caves
if [ -d "$real" ]; then mapfile -t -O 2 inputs < <(find "$real" -name '*.jpg' -o -name '*.png' | sort | head -n 3); fi
status=0
for input in "${inputs[@]}"; do
  for method in paper adit; do
    begin=$SECONDS
    there run "$input" --sequence --method "$method" --csv build/aarch64-there.csv --quiet
    build/release/adit run "$input" --sequence --method "$method" --csv build/aarch64-here.csv --quiet
    if cmp build/aarch64-here.csv build/aarch64-there.csv; then
      echo "adit run ${input##*/} --sequence --method $method: $(($(wc -l < build/aarch64-there.csv) - 1)) rows, the same bytes as" \
        "here, in $((SECONDS - begin)) s"
      tally 1 0 0
    else
      diff build/aarch64-here.csv build/aarch64-there.csv | head -n 6 || true
      tally 0 1 0
      status=1
    fi
  done
done

# The video itself: every frame of it is read and judged.
there run data/clip.avi --csv build/aarch64-video.csv --quiet
if [ "$(grep -c ',found,' build/aarch64-video.csv)" = 60 ]; then
  echo "adit run clip.avi: an opening in each of 60 frames"
  tally 1 0 0
else
  cut -d , -f 1-8 build/aarch64-video.csv | head -n 6
  tally 0 1 0
  status=1
fi
exit $status
