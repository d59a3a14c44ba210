#!/usr/bin/env bash
# The ROS 1 package, built and flown: rostest suites against a roscore on loopback. Skipped where ROS is not installed.
. "$(dirname "${BASH_SOURCE[0]}")/prelude.sh"
if ! scripts/setup --ros --check; then
  echo "ros: skipped: ROS 1 is not installed here (scripts/setup --ros installs it)"
  tally 0 0 1
  exit 0
fi
# catkin's Python is Debian's, whatever else is on the path; nothing listens or speaks beyond loopback.
export PATH=/usr/bin:$PATH ROS_IP=127.0.0.1 ROS_HOSTNAME=127.0.0.1 ROS_HOME=$PWD/build/ros1/home IGN_IP=127.0.0.1
export ADIT_CLIP=$PWD/data/clip.avi ADIT_COURSES=$PWD/courses ADIT_PROGRAM=$PWD/build/release/adit
build_preset release -DADIT_SIM=ON
# Frames of 640 x 480 for the latency.
export ADIT_VGA=$PWD/build/ros1-vga/frames
quietly ros1-vga build/release/adit render s_bend --frames 60 --out build/ros1-vga --quiet
begin=$SECONDS
quietly ros1-configure cmake -S ros/adit_ros1 -B build/ros1 -G Ninja -DCMAKE_BUILD_TYPE=Release \
  -DPYTHON_EXECUTABLE=/usr/bin/python3
quietly ros1-build cmake --build build/ros1 --parallel "$jobs"
echo "built build/ros1 in $((SECONDS - begin)) s"
set +u  # catkin's script asks for variables that are not set
# shellcheck source=/dev/null
. build/ros1/devel/setup.sh
set -u

# A count in the head of rostest's summary.
summary_count() { sed -n "s/^ \* $1: \([0-9]*\).*/\1/p" "$2" | head -n 1; }

status=0
for file in ros/adit_ros1/test/*.test; do
  name=$(basename "$file" .test) begin=$SECONDS verdict=passed
  log=build/ros1/$name.log
  # Two minutes of the one are the soak: memory has to stay flat.
  if [ "$name" = latency ]; then export ADIT_LATENCY_S=${ADIT_SOAK_S:-120}; else export ADIT_LATENCY_S=20; fi
  timeout $((ADIT_LATENCY_S + 600)) rostest --results-base-dir="$PWD/build/ros1/results" "$file" > "$log" 2>&1 || verdict=FAILED
  failed=$(($(summary_count FAILURES "$log") + $(summary_count ERRORS "$log")))
  total=$(summary_count TESTS "$log")
  if [ "${total:-0}" = 0 ]; then verdict=FAILED total=1 failed=1; fi
  tally $((total - failed)) "$failed" 0
  echo "rostest $name: $verdict, $total tests in $((SECONDS - begin)) s"
  sed -n 's/^.*\(flight through topics\|latency over\|soak\|same numbers\): /  \1: /p' \
    "build/ros1/results/adit_ros1/rosunit-$name.xml" 2>/dev/null | head -n 4
  if [ $verdict = FAILED ]; then
    status=1
    tail -n 60 "$log"
  fi
done

# Everything that roslaunch starts has a log file under ROS_HOME on its command line.
if pgrep -af "$ROS_HOME" > build/ros1/left.log; then
  echo "processes are left over:"
  cat build/ros1/left.log
  tally 0 1 0
  status=1
else
  tally 1 0 0
fi
exit $status
