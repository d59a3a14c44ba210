"""Runs every command that the docs show. usage: docs_commands.py [--phase NAME] ADIT FILE.md...

A block ```sh is run as it stands, in a scratch folder per file that has all of this project and stand-ins for what a reader
would have (flight.mp4, frames/, frame.jpg, camera.yaml). Programs of scripts/stand_ins come first on the path: they cut
flights, renders and benches short, end what shows a page, and keep the system as it is.
A line before a block can say that it is another phase's (<!-- phase NAME: what stands in -->), which then calls this with
--phase NAME; or that it cannot be run here, and why: <!-- not run: REASON -->. Nothing slips by for its language: bash, shell
and console are refused (write sh), and so is a block without a language; what is no commands is written as text, and text that
begins with a program of ours needs a reason, too.
"""

import argparse
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
STAND_INS = ROOT / "scripts/stand_ins"
HERE = "docs"  # the phase of blocks that name none
BLOCK_S = 600
CALIBRATION = """\
image_width: 640
image_height: 480
camera_name: camera
camera_matrix: {rows: 3, cols: 3, data: [420, 0, 319.5, 0, 420, 239.5, 0, 0, 1]}
distortion_model: plumb_bob
distortion_coefficients: {rows: 1, cols: 5, data: [-0.1, 0.02, 0, 0, 0]}
rectification_matrix: {rows: 3, cols: 3, data: [1, 0, 0, 0, 1, 0, 0, 0, 1]}
projection_matrix: {rows: 3, cols: 4, data: [420, 0, 319.5, 0, 0, 420, 239.5, 0, 0, 0, 1, 0]}
"""  # of the camera that stands in


def blocks_of(text):
    """(line, language, phase, reason not to run it, lines) of each fenced block."""
    phase, reason, language, begin, lines = HERE, "", None, 0, []
    for number, line in enumerate(text.splitlines(), 1):
        if language is not None:
            if line.startswith("```"):
                yield begin, language, phase, reason, lines
                language, phase, reason = None, HERE, ""
            else:
                lines.append(line)
        elif line.startswith("```"):
            language, begin, lines = line[3:].strip(), number, []
        elif match := re.fullmatch(r"<!-- not run: (.+) -->", line.strip()):
            reason = match.group(1)
        elif match := re.fullmatch(r"<!-- phase ([a-z0-9_]+): (.+) -->", line.strip()):
            phase = match.group(1)
        elif line.strip():
            phase, reason = HERE, ""


def commands_of(lines):
    """The block's commands; one that goes on in the next line is one."""
    joined = re.sub(r"\\\n\s*", "", "\n".join(lines)).splitlines()
    return [c for c in joined if c.strip() and not c.lstrip().startswith("#")]


OUR_PROGRAMS = r"(\$ |adit|(scripts|jobs|build)/\S+|cmake|ctest|sbatch|ffmpeg|docker|pip|apt-get|sudo|ros2|colcon)( |$)"


def fault_of(path, language, phase, reason, commands):
    """Why a block would be neither run nor excused; "" when it is fine."""
    if language == "":
        return "a block without a language: write ```sh for commands, ```text for what is none"
    if language in ("bash", "shell", "console", "zsh", "shell-session"):
        return f"commands in a block of {language}: write ```sh, or nobody runs them"
    if language == "text" and not reason and any(re.match(OUR_PROGRAMS, c) for c in commands):
        return "commands in a block of text: write ```sh, or <!-- not run: why -->"
    if phase != HERE:
        script = ROOT / f"scripts/checks/{phase}.sh"
        calls = script.read_text(encoding="utf-8") if script.exists() else ""
        if f"--phase {phase} " not in calls or str(path.relative_to(ROOT)) not in calls:
            return f"left to phase {phase}, and scripts/checks/{phase}.sh does not run it"
    return ""


def furnish_scripts(folder):
    """Scripts that install, build and test for hours: their own words are read, and what they would begin stands in."""
    scripts = folder / "scripts"
    (scripts / "checks").mkdir(parents=True)
    for entry in (ROOT / "scripts").iterdir():
        if entry.name not in ("checks", "demo", "playground", "setup", "test"):
            (scripts / entry.name).symlink_to(entry)
    shutil.copy(ROOT / "scripts/test", scripts)
    for phase in (ROOT / "scripts/checks").glob("*.sh"):
        lines = phase.read_text(encoding="utf-8").splitlines()
        (scripts / "checks" / phase.name).write_text("\n".join([*lines[:2], 'echo "1 0 0" >> "$ADIT_TALLY"', ""]))
    for name, words in (
            ("setup", '"$ADIT_ROOT/scripts/setup" --print "$@"'), ("playground", '"$ADIT_ROOT/scripts/playground" "$@"'),
            ("demo", 'test -e "$ADIT_ONCE/demo" || "$ADIT_ROOT/scripts/demo" --clip --program "$ADIT_PROGRAM" "$@" &&\n'
                     '  touch "$ADIT_ONCE/demo"  # two pages show it')):
        (scripts / name).write_text(f'#!/bin/sh\nPATH=${{PATH#"$ADIT_STAND_INS:"}}\n{words}\n')
        (scripts / name).chmod(0o755)


def furnish(folder, adit):
    for entry in ROOT.iterdir():
        if entry.name not in ("build", "data", "out", "scripts") and not entry.name.startswith("."):
            (folder / entry.name).symlink_to(entry)
    furnish_scripts(folder)
    shutil.copytree(ROOT / "data", folder / "data")
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
    (folder / "camera.yaml").write_text(CALIBRATION)
    (folder / "home/catkin_ws/src").mkdir(parents=True)
    for program in ("release/adit", "data/make_clip"):
        (folder / "build" / program).parent.mkdir(parents=True)
        (folder / "build" / program).symlink_to(STAND_INS / pathlib.Path(program).name)


def run_block(commands, folder, adit, once):
    """"" or what went wrong. Each command is judged; the shell is the same for all, as a reader's is."""
    words = "set -o pipefail\n" + "".join(
        f"{command}\n_code=$?; if [ $_code != 0 ]; then echo 'command {number}: exit code '$_code >&2; exit 1; fi\n"
        for number, command in enumerate(commands, 1))
    environment = {**os.environ, "ADIT_PROGRAM": adit, "ADIT_BUILD": str(pathlib.Path(adit).parent), "ADIT_ROOT": str(ROOT),
                   "ADIT_ONCE": once, "ADIT_SCRATCH": str(folder), "ADIT_STAND_INS": str(STAND_INS),
                   "HOME": str(folder / "home"),
                   "PATH": f"{STAND_INS}:{os.environ['PATH']}"}
    with tempfile.TemporaryFile("w+") as said:
        shell = subprocess.Popen(["bash", "-c", words], cwd=folder, env=environment, stdin=subprocess.DEVNULL, stdout=said,
                                 stderr=said, start_new_session=True)
        try:
            code = shell.wait(timeout=BLOCK_S)
        except subprocess.TimeoutExpired:
            os.killpg(shell.pid, signal.SIGKILL)
            code = f"none in {BLOCK_S} s"
        said.seek(0)
        return "" if code == 0 else f"\n  exit code {code}: ...{said.read().strip()[-1500:]}"


def run_file(path, adit, phase_here, once):
    """How many commands were run, are another phase's, and were excused; and the faults."""
    runs = others = excused = 0
    faults = []
    with tempfile.TemporaryDirectory(prefix="adit-docs-") as scratch:
        folder = pathlib.Path(scratch)
        furnished = False
        for line, language, phase, reason, lines in blocks_of(path.read_text(encoding="utf-8")):
            commands = commands_of(lines)
            place = f"{path.relative_to(ROOT)}:{line}"
            if fault := fault_of(path, language, phase, reason, commands):
                faults.append(f"{place}: {fault}")
            if language != "sh":
                continue
            if reason:
                excused += len(commands)
                continue
            if phase != phase_here:
                others += len(commands)
                continue
            if not furnished:
                furnish(folder, adit)
                furnished = True
            runs += len(commands)
            if fault := run_block(commands, folder, adit, once):
                faults.append(f"{place}: {fault}")
    return runs, others, excused, faults


def main():
    parser = argparse.ArgumentParser(usage=__doc__)
    parser.add_argument("--phase", default=HERE)
    parser.add_argument("adit", type=lambda name: str(pathlib.Path(name).resolve()))
    parser.add_argument("files", nargs="+", type=lambda name: pathlib.Path(name).absolute())
    asked = parser.parse_args()
    # Whoever runs this in the background has told it to pass Ctrl-C over; what it starts is ended by it.
    signal.signal(signal.SIGINT, signal.SIG_DFL)
    runs = others = excused = 0
    faults = []
    with tempfile.TemporaryDirectory(prefix="adit-docs-") as once:  # what has been run and need not be again
        for path in asked.files:
            of_file = run_file(path, asked.adit, asked.phase, once)
            runs, others, excused, faults = runs + of_file[0], others + of_file[1], excused + of_file[2], faults + of_file[3]
    for fault in faults:
        print(fault, file=sys.stderr)
    print(f"{runs} commands of the docs run in phase {asked.phase}, {others} left to other phases, {excused} not run (each "
          f"says why), {len(faults)} faults")
    if asked.phase != HERE and runs == 0:
        sys.exit(f"no block of these files names phase {asked.phase}")
    sys.exit(1 if faults else 0)


main()
