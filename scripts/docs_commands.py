"""Runs every command that the docs show. usage: docs_commands.py ADIT FILE.md...

A block ```sh is run line by line, in a scratch folder per file that has data/, courses/ and stand-ins for what a reader would
have (flight.mp4, frames/, frame.jpg, camera.yaml). Flights, renders and benches are cut short; programs that show a page are
ended with Ctrl-C once they have printed its address. A block that cannot be run has a line before it that says why:
<!-- not run: REASON -->. Nothing slips by for its language: bash, shell and console are refused (write sh), and so is a block
without a language; what is no commands is written as text, and text that begins with a program of ours needs a reason, too.
"""

import json
import os
import pathlib
import re
import shutil
import signal
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parent.parent

# What stands in for `adit` in a shell: the same, with short times.
SHORT = '''#!/usr/bin/env python3
import os, signal, subprocess, sys
words = sys.argv[1:]
def put(option, value):
    if option in words: words[words.index(option) + 1] = value
    else: words.extend([option, value])
command = words[0] if words else ""
if "--help" in words: pass
elif command == "fly": put("--time", "0.4")
elif command == "render": put("--frames", "2")
elif command == "bench": put("--seconds", "0.05")
program = [os.environ["ADIT_PROGRAM"], *words]
if command not in ("view", "mark") and "--view" not in words: os.execv(program[0], program)
if "--port" in words: put("--port", "0"), words.remove("--port"), words.remove("0")
shown = subprocess.Popen([program[0], *words], stdout=subprocess.PIPE, text=True)
line = shown.stdout.readline()
if not line.startswith("http://"): sys.exit("no address: " + line)
if "--view" in words: os.environ.pop("ADIT_PROGRAM")
shown.send_signal(signal.SIGINT)
code = shown.wait(timeout=120)
sys.exit(0 if code in (0, 130) else code)
'''


def blocks_of(text):
    """(line, language, reason not to run it, lines) of each fenced block."""
    reason, language, begin, lines = "", None, 0, []
    for number, line in enumerate(text.splitlines(), 1):
        if language is not None:
            if line.startswith("```"):
                yield begin, language, reason, lines
                language, reason = None, ""
            else:
                lines.append(line)
        elif line.startswith("```"):
            language, begin, lines = line[3:].strip(), number, []
        elif match := re.fullmatch(r"<!-- not run: (.+) -->", line.strip()):
            reason = match.group(1)
        elif line.strip():
            reason = ""


OUR_PROGRAMS = r"(\$ |adit|(scripts|jobs|build)/\S+|cmake|ctest|sbatch|ffmpeg|docker|pip|apt-get|sudo|ros2|colcon)( |$)"


def fault_of(language, reason, commands):
    """Why a block would be neither run nor excused; "" when it is fine."""
    if language == "":
        return "a block without a language: write ```sh for commands, ```text for what is none"
    if language in ("bash", "shell", "console", "zsh", "shell-session"):
        return f"commands in a block of {language}: write ```sh, or nobody runs them"
    if language == "text" and not reason and any(re.match(OUR_PROGRAMS, c) for c in commands):
        return "commands in a block of text: write ```sh, or <!-- not run: why -->"
    return ""


def furnish(folder, adit):
    for name in ("data", "courses"):
        (folder / name).symlink_to(ROOT / name)
    shutil.copy(ROOT / "data/tunnel.jpg", folder / "frame.jpg")
    subprocess.run([adit, "run", "data/clip.avi", "--limit", "4", "--quiet", "--frames", "frames", "--video", "flight.mp4"],
                   cwd=folder, check=True)
    frames = sorted((folder / "frames").iterdir())
    shutil.copy(frames[0], folder / "frame.png")
    marks = {frame.name: [[200, 120, 440, 340]] for frame in frames}
    (folder / "frames/openings.json").write_text(json.dumps({"openings": marks}))
    shutil.copytree(ROOT / "data", folder / "caves", ignore=lambda d, names: [n for n in names if n not in
                                                                              ("openings.json", "tunnel.jpg")])
    subprocess.run([adit, "run", "caves", "--quiet", "--csv", "answers.csv"], cwd=folder, check=True)
    tools = folder / ".bin"
    tools.mkdir()
    (tools / "adit").write_text(SHORT)
    (tools / "adit").chmod(0o755)


def run_file(path, adit):
    """How many commands were run, how many were excused, and the faults."""
    runs = excused = 0
    faults = []
    with tempfile.TemporaryDirectory(prefix="adit-docs-") as scratch:
        folder = pathlib.Path(scratch)
        furnished = False
        for line, language, reason, lines in blocks_of(path.read_text(encoding="utf-8")):
            commands = [c for c in lines if c.strip() and not c.lstrip().startswith("#")]
            place = f"{path.relative_to(ROOT)}:{line}"
            if fault := fault_of(language, reason, commands):
                faults.append(f"{place}: {fault}")
            if language != "sh":
                continue
            if reason:
                excused += len(commands)
                continue
            if not furnished:
                furnish(folder, adit)
                furnished = True
            for command in commands:
                runs += 1
                environment = {**os.environ, "ADIT_PROGRAM": adit, "PATH": f"{folder}/.bin:{os.environ['PATH']}"}
                done = subprocess.run(["bash", "-euc", command], cwd=folder, env=environment, capture_output=True, text=True,
                                      timeout=300)
                if done.returncode != 0:
                    faults.append(f"{place}: {command}\n  exit code {done.returncode}: {done.stderr.strip()[-400:]}")
    return runs, excused, faults


def main():
    adit = str(pathlib.Path(sys.argv[1]).resolve())
    signal.signal(signal.SIGINT, signal.SIG_DFL)
    runs = excused = 0
    faults = []
    for name in sys.argv[2:]:
        of_file = run_file(pathlib.Path(name).absolute(), adit)
        runs, excused, faults = runs + of_file[0], excused + of_file[1], faults + of_file[2]
    for fault in faults:
        print(fault, file=sys.stderr)
    print(f"{runs} commands of the docs run, {excused} not (each says why), {len(faults)} faults")
    sys.exit(1 if faults else 0)


main()
