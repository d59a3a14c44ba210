"""Is all there that a Dockerfile copies from the project's folder? usage: sources_of.py DOCKERFILE"""
import glob
import re
import sys

text = re.sub(r"\\\n", " ", open(sys.argv[1], encoding="utf-8").read())
stages, copied, faults = [], 0, []
for line in text.splitlines():
    if match := re.match(r"FROM\s+(\S+)(?:\s+AS\s+(\S+))?", line, re.I):
        stages.append(match[2])
    elif match := re.match(r"(?:COPY|ADD)\s+(.*)", line, re.I):
        words = match[1].split()
        origin = [word.split("=", 1)[1] for word in words if word.startswith("--from=")]
        sources = [word for word in words if not word.startswith("--")][:-1]
        copied += len(sources)
        faults += [f"{name}: no stage before is called so" for name in origin if name not in stages]
        if not origin:
            faults += [f"{source}: is not in the project" for source in sources if not glob.glob(source)]
for user in re.findall(r"^USER\s+(\S+)", text, re.M):
    if user != "root" and not re.search(rf"useradd\b.*\b{re.escape(user)}\b", text):
        faults.append(f"{user}: no such user is made")
for fault in faults:
    print(f"{sys.argv[1]}: {fault}")
sys.exit(1 if faults or not copied else 0)
