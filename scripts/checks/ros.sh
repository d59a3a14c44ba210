#!/usr/bin/env bash
# The ROS 1 package, built and flown: rostest suites against a roscore on loopback. Skipped where ROS is not installed.
. "$(dirname "${BASH_SOURCE[0]}")/prelude.sh"
if ! scripts/setup --ros --check ros rostest bag; then
  echo "ros: skipped: ROS 1 is not installed here (scripts/setup --ros installs it)"
  tally 0 0 1
  exit 0
fi
# catkin's Python is Debian's, whatever else is on the path; nothing listens or speaks beyond loopback.
export PATH=/usr/bin:$PATH ROS_IP=127.0.0.1 ROS_HOSTNAME=127.0.0.1 ROS_HOME=$PWD/build/ros1/home IGN_IP=127.0.0.1
export ADIT_PROGRAM=$PWD/build/release/adit ADIT_COURSES=$PWD/courses
export ADIT_CLIP=$PWD/data/clip.avi ADIT_PICTURE=$PWD/data/tunnel.jpg
build_preset release -DADIT_SIM=ON
echo "ros: ros/adit_ros2 is not compiled, here or anywhere: there is no ROS 2 in Debian (see its README)"

# Frames of 640 x 480 for the latency, and a recording to play.
export ADIT_VGA=$PWD/build/ros1-data/frames ADIT_RECORDING=$PWD/build/ros1-data/recording.bag
rm -rf build/ros1-data
quietly ros1-vga "$ADIT_PROGRAM" render s_bend --frames 60 --out build/ros1-data --quiet
quietly ros1-recording "$ADIT_PROGRAM" fly s_bend --method paper --time 4 --set lens.width=160 --set lens.height=120 \
  --bag "$ADIT_RECORDING" --quiet

# Against adit as it is installed, which is what was built above. From adit's sources (what a catkin workspace does) it is
# configured here, and built with ADIT_ROS_FROM_SOURCE=1: the same files once more.
begin=$SECONDS
if [ -n "${ADIT_ROS_FROM_SOURCE:-}" ]; then
  from=(-DADIT_ROS1_INSTALLED=OFF)
else
  rm -rf build/ros1-adit  # a header that is gone must not be found
  quietly ros1-install cmake --install build/release --prefix build/ros1-adit --component development
  from=(-DADIT_ROS1_INSTALLED=ON "-Dadit_DIR=$(dirname "$(find "$PWD/build/ros1-adit" -name adit-config.cmake)")")
  quietly ros1-source cmake -S ros/adit_ros1 -B build/ros1-source -G Ninja -DPYTHON_EXECUTABLE=/usr/bin/python3
fi
quietly ros1-configure cmake -S ros/adit_ros1 -B build/ros1 -G Ninja -DCMAKE_BUILD_TYPE=Release \
  -DPYTHON_EXECUTABLE=/usr/bin/python3 "${from[@]}"
quietly ros1-build cmake --build build/ros1 --parallel "$jobs"
echo "built build/ros1 in $((SECONDS - begin)) s"
set +u  # catkin's script asks for variables that are not set
# shellcheck source=/dev/null
. build/ros1/devel/setup.sh
set -u

status=0
# What a launch file would start, with these arguments: none of its files, arguments and conditions is broken.
launch_names() {  # WANTED LAUNCH-FILE ARGUMENT...
  local wanted=$1 found
  shift
  found=$(roslaunch --nodes adit_ros1 "$@" 2> build/ros1/launch.log | sort | xargs) || true
  if [ "$found" = "$wanted" ]; then
    tally 1 0 0
  else
    echo "roslaunch --nodes adit_ros1 $*: '$found', not '$wanted'"
    cat build/ros1/launch.log
    tally 0 1 0
    status=1
  fi
}
launch_names '/adit_manager /controller /open_space' perception.launch
launch_names '/open_space' perception.launch manager:=/cam/manager controller:=false
launch_names '/camera /camera_manager /controller /open_space /rviz' camera.launch input:=/dev/video0 rviz:=true
launch_names '/adit_manager /bag /controller /open_space /rqt /rviz' bag.launch bag:=drift.bag rqt:=true
launch_names '/controller /open_space /rviz /sim' simulation.launch course_file:=s_bend.yaml rviz:=true

# All that can be judged of the ROS 2 package here: the same messages, and a launch file that is Python.
ros2_reads() {
  local message
  for message in ros/adit_ros1/msg/*.msg; do
    diff <(sed 's|^Header |std_msgs/Header |' "$message") "ros/adit_ros2/msg/$(basename "$message")" || return 1
  done
  python3 -c 'import ast, sys; ast.parse(open(sys.argv[1]).read())' ros/adit_ros2/launch/perception.launch.py
}
if ros2_reads; then
  tally 1 0 0
else
  echo "ros/adit_ros2: its messages or its launch file"
  tally 0 1 0
  status=1
fi

# A count in rostest's summary, which is coloured when it is bad news.
summary_count() { sed -n "s/^.*\* $1: \([0-9][0-9]*\).*/\1/p" "$2" | head -n 1; }

run_suite() {  # FILE
  local name log verdict=passed begin=$SECONDS failed errors total
  name=$(basename "$1" .test)
  log=build/ros1/$name.log
  # Two minutes of the one are the soak: memory has to stay flat.
  if [ "$name" = latency ]; then export ADIT_LATENCY_S=${ADIT_SOAK_S:-120}; else export ADIT_LATENCY_S=20; fi
  timeout $((ADIT_LATENCY_S + 600)) rostest --results-base-dir="$PWD/build/ros1/results" "$1" > "$log" 2>&1 ||
    verdict=FAILED
  total=$(summary_count TESTS "$log")
  failed=$(summary_count FAILURES "$log") errors=$(summary_count ERRORS "$log")
  failed=$((${failed:-0} + ${errors:-0}))
  if [ "${total:-0}" = 0 ]; then verdict=FAILED total=1; fi
  if [ $verdict = FAILED ] && [ $failed = 0 ]; then failed=1; fi
  tally $((total - failed)) "$failed" 0
  echo "rostest $name: $verdict, $total tests in $((SECONDS - begin)) s"
  sed -n 's/^.*\(flight through topics:\|latency over\|same numbers:\)/  \1/p' \
    "build/ros1/results/adit_ros1/rosunit-$name.xml" 2>/dev/null | head -n 4
  if [ $verdict = FAILED ]; then
    status=1
    tail -n 60 "$log"
  fi
}
for file in ros/adit_ros1/test/*.test; do run_suite "$file"; done

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
