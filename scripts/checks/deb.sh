#!/usr/bin/env bash
# Debian packages by cpack: accepted by lintian, installed and run in a clean debootstrap chroot (needs root).
. "$(dirname "${BASH_SOURCE[0]}")/prelude.sh"

# A build of its own, without tests: cpack wants all of a build. With /usr for a prefix libraries go where Debian has those
# of this machine's kind.
folder=build/deb
quietly deb-configure cmake --preset release -B "$folder" -DADIT_SIM=ON -DADIT_PYTHON=ON -DADIT_TESTS=OFF -DADIT_BENCH=OFF \
  -DCMAKE_INSTALL_PREFIX=/usr \
  -DADIT_WERROR=ON -DPython3_EXECUTABLE=/usr/bin/python3
quietly deb-build cmake --build "$folder" --parallel "$jobs"
rm -f "$folder"/*.deb
(umask 022 && cd "$folder" && cpack -G DEB) > build/cpack.log 2>&1 || { tail -n 40 build/cpack.log; exit 1; }
mapfile -t packages < <(find "$folder" -maxdepth 1 -name '*.deb' | sort)
printf '%s\n' "${packages[@]##*/}"
[ ${#packages[@]} -eq 4 ]
tally 1 0 0

quietly lintian lintian --allow-root --fail-on error,warning --info --tag-display-limit 0 "${packages[@]}"
grep -E '^[EW]:' build/lintian.log || echo "lintian: no errors, no warnings"
tally 1 0 0

for page in "$folder"/manual/*.1; do
  # Style is a matter of taste; errors are not.
  mandoc -T lint -W error "$page"
done
bash -n "$folder/manual/adit.bash"
words=$(bash -c "source $folder/manual/adit.bash;"' COMP_WORDS=(adit run --cs); COMP_CWORD=2; _adit; echo "${COMPREPLY[@]}"')
[ "$words" = --csv ]
tally 2 0 0

if [ "$(id -u)" -ne 0 ] || ! command -v debootstrap >/dev/null; then
  echo "skipped: a chroot needs root and debootstrap"
  tally 0 0 1
  exit 0
fi
chroot=$(mktemp -d)
# shellcheck disable=SC2064  # the folder's name now, not then
trap "rm -rf --one-file-system '$chroot'" EXIT
. /etc/os-release
mirror=$(awk '$1 == "URIs:" { print $2; exit } $1 == "deb" { print $2; exit }' /etc/apt/sources.list.d/debian.sources \
  /etc/apt/sources.list 2>/dev/null || true)
begin=$SECONDS
quietly debootstrap debootstrap --variant=minbase --include=ca-certificates "$VERSION_CODENAME" "$chroot" \
  "${mirror:-http://deb.debian.org/debian}"
cp "${packages[@]}" data/clip.avi tests/package/consumer/consumer.c "$chroot/srv/"
# No network but apt's, no services.
printf '#!/bin/sh\nexit 101\n' > "$chroot/usr/sbin/policy-rc.d"
chmod +x "$chroot/usr/sbin/policy-rc.d"
# What apt was told here about proxies and certificates holds there too.
if [ -d /etc/apt/apt.conf.d ]; then cp -r /etc/apt/apt.conf.d/. "$chroot/etc/apt/apt.conf.d/"; fi
inside() { chroot "$chroot" /usr/bin/env -i PATH=/usr/sbin:/usr/bin:/sbin:/bin HOME=/root DEBIAN_FRONTEND=noninteractive "$@"; }
quietly deb-update inside apt-get update -q
quietly deb-install inside sh -c 'apt-get install -y -q --no-install-recommends /srv/*.deb'
echo "installed in a clean $VERSION_CODENAME in $((SECONDS - begin)) s"
inside adit --version
inside sh -c 'cd /srv && adit run clip.avi --method adit --csv out.csv --quiet && head -n 3 out.csv'
"$folder/adit" run data/clip.avi --method adit --csv build/deb_here.csv --quiet
# The first column is the file as it was named.
cmp <(cut -d , -f 2- build/deb_here.csv) <(cut -d , -f 2- "$chroot/srv/out.csv")
inside adit fly s_bend --time 1 --quiet --out /srv/flight
inside test -s /srv/flight/summary.json
inside /usr/bin/python3 -c 'import adit, numpy; print(adit.OpenSpaceFinder().find(numpy.zeros((48, 64), numpy.uint8)))'
inside test -s /usr/share/bash-completion/completions/adit
inside sh -c 'test -e /usr/lib/*/libadit.so.0'
tally 6 0 0
# A stranger's program in C, by what libadit-dev brings.
quietly deb-compiler inside apt-get install -y -q --no-install-recommends gcc libc6-dev pkg-config
# shellcheck disable=SC2016  # it is expanded there
inside sh -c 'cd /srv && gcc consumer.c -o consumer $(pkg-config --cflags --libs adit) && ./consumer' | tee build/deb-consumer.log
grep -q 'adit says: no_contrast' build/deb-consumer.log
tally 1 0 0
quietly deb-remove inside apt-get purge -y -q adit libadit-dev libadit0 python3-adit
if inside sh -c 'find /usr -path "*adit*" | grep -v "^/usr/share/doc" | grep -E "adit(-|\.|/|$)|libadit"'; then
  echo "files stay behind after the packages are gone" >&2
  exit 1
fi
tally 1 0 0
