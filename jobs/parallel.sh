#!/usr/bin/env bash
# Any of `adit run`, `adit eval`, `adit fly` in N shards by GNU parallel, here or over machines.
set -euo pipefail

usage() {
  cat <<'EOF'
usage: jobs/parallel.sh N WHOLE run|eval|fly ARGUMENT...

Runs N shards, one for each core at a time, and joins them. WHOLE is the file or folder that the arguments name
(--csv, --jsonl, --json FILE, or --out DIR). Called again after a breakdown, it runs the shards that are missing.

ADIT        the program (adit)
SSH_LOGINS  machines for parallel --sshlogin, such as 8/alpha,8/beta; they see the same files under the same names
            (default: this machine)

example: jobs/parallel.sh 64 headings.csv run /fleet/2026-11 --csv headings.csv
EOF
}

if [ $# -lt 4 ]; then usage >&2; exit 2; fi
shards=$1 whole=$2
shift 2
adit=${ADIT:-adit}

# The shards that have no part yet: all, or what `adit merge` names.
if missing=$("$adit" merge "$whole" --missing 2>/dev/null); then
  wanted=$(tr ',' '\n' <<< "$missing")
else
  wanted=$(seq "$shards")
fi
where=()
if [ -n "${SSH_LOGINS:-}" ]; then where=(--sshlogin "$SSH_LOGINS" --workdir .); fi
if [ -n "$wanted" ]; then
  # --halt: a shard that fails stops nobody else; the last line says which are missing.
  parallel --will-cite "${where[@]}" --halt never "$(printf '%q ' "$adit" "$@")" --shard "{}/$shards" --jobs 1 \
    <<< "$wanted" || true
fi
exec "$adit" merge "$whole"
