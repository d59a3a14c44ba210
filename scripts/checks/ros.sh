#!/usr/bin/env bash
# The ROS 1 package, built and flown: rostest suites against a roscore on loopback. Skipped where ROS is not installed.
# shellcheck disable=SC2317  # functions that are called by their names
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
export ADIT_STAND_IN=$PWD/build/release/tests/camera/adit_v4l2_stand_in.so
build_preset release -DADIT_SIM=ON
echo "ros: ros/adit_ros2 is not compiled, here or anywhere: there is no ROS 2 in Debian (see its README)"

# Frames of 640 x 480 for the latency, and a recording to play.
export ADIT_VGA=$PWD/build/ros1-data/frames ADIT_RECORDING=$PWD/build/ros1-data/recording.bag
rm -rf build/ros1-data
quietly ros1-vga "$ADIT_PROGRAM" render s_bend --frames 60 --out build/ros1-data --quiet
quietly ros1-recording "$ADIT_PROGRAM" fly s_bend --method paper --time 4 --set lens.width=160 --set lens.height=120 \
  --bag "$ADIT_RECORDING" --quiet

# As the README tells newcomers: a catkin workspace with this project in it, and catkin_make. The project is linked and not
# cloned, and the build folder lies where the compiler's cache sees the same paths as in the build above. Beside it stands a
# message that goes by MAVROS's name (test/stand_in/mavros_msgs), so that the controller's part for MAVROS is compiled and tried.
begin=$SECONDS
space=build/ros1-space
rm -rf "$space/src" && mkdir -p "$space/src/adit"
for entry in *; do
  if [ "$entry" != build ]; then ln -s "$PWD/$entry" "$space/src/adit/"; fi
done
cp -r ros/adit_ros1/test/stand_in/mavros_msgs "$space/src/"
export ADIT_MAVROS=1
in_space() { (cd "$space" && catkin_make --build ../ros1-space-build --use-ninja -j "$jobs" "$@"); }
quietly ros1-space in_space -DCMAKE_BUILD_TYPE=Release -DPYTHON_EXECUTABLE=/usr/bin/python3 -DADIT_WERROR=ON
quietly ros1-space-install in_space install
unset ADIT_MAVROS
echo "built the workspace $space in $((SECONDS - begin)) s"

# And against adit as it is installed, which is what was built above, without MAVROS's messages: nodes and nodelets alone.
begin=$SECONDS
rm -rf build/ros1-adit  # a header that is gone must not be found
quietly ros1-install cmake --install build/release --prefix build/ros1-adit --component development
quietly ros1-configure cmake -S ros/adit_ros1 -B build/ros1 -G Ninja -DCMAKE_BUILD_TYPE=Release \
  -DPYTHON_EXECUTABLE=/usr/bin/python3 -DADIT_ROS1_INSTALLED=ON -DCATKIN_ENABLE_TESTING=OFF \
  "-Dadit_DIR=$(dirname "$(find "$PWD/build/ros1-adit" -name adit-config.cmake)")"
quietly ros1-build cmake --build build/ros1 --parallel "$jobs"
echo "built build/ros1 in $((SECONDS - begin)) s"

status=0
judged() {  # WORDS COMMAND...: one test more, passed when the command is.
  local words=$1
  shift
  if "$@"; then
    tally 1 0 0
  else
    echo "ros: $words"
    tally 0 1 0
    status=1
  fi
}

# enter SETUP: what follows sees the packages of this space alone, beside the system's.
enter() {
  unset CMAKE_PREFIX_PATH ROS_PACKAGE_PATH PYTHONPATH LD_LIBRARY_PATH
  set +u  # catkin's script asks for variables that are not set
  # shellcheck source=/dev/null
  . "$1"
  set -u
}

# What a launch file would start, with these arguments: none of its files, arguments and conditions is broken.
launch_names() {  # WANTED LAUNCH-FILE ARGUMENT...
  local wanted=$1 found
  shift
  found=$(roslaunch --nodes adit_ros1 "$@" 2> build/ros1-launch.log | sort | xargs) || true
  if [ "$found" = "$wanted" ]; then return; fi
  echo "roslaunch --nodes adit_ros1 $*: '$found', not '$wanted'"
  cat build/ros1-launch.log
  return 1
}
launch_files() {
  launch_names '/adit_manager /controller /open_space' perception.launch &&
    launch_names '/open_space' perception.launch manager:=/cam/manager controller:=false &&
    launch_names '/camera /camera_manager /controller /open_space /rviz' camera.launch input:=/dev/video0 rviz:=true &&
    launch_names '/adit_manager /bag /controller /open_space /rqt /rviz' bag.launch bag:=drift.bag rqt:=true &&
    launch_names '/controller /open_space /rviz /sim' simulation.launch course_file:=s_bend.yaml rviz:=true &&
    # A recording is not taken to go where the commands send it; a robot's own configuration is left alone.
    roslaunch --dump-params adit_ros1 bag.launch bag:=drift.bag 2> /dev/null | grep -qx '/open_space/is_steered: false' &&
    ! roslaunch --dump-params adit_ros1 perception.launch 2> /dev/null | grep -q is_steered
}

# All that can be judged of the ROS 2 package here: it is text. Where colcon is installed it finds what the READMEs say it does.
colcon_finds() {
  if ! command -v colcon > /dev/null; then
    echo "ros: colcon is not installed (scripts/setup --ros colcon): whether it finds ros/adit_ros2 was not asked"
    return
  fi
  local found
  found=$(ROS_VERSION=2 colcon --log-base build/ros2-log list --base-paths ros 2> build/ros2-colcon.log | sort | cut -f 1,3 | xargs) || true
  if [ "$found" = 'adit_ros1 (ros.catkin) adit_ros2 (ros.ament_cmake)' ]; then return; fi
  echo "colcon list --base-paths ros: '$found'"
  cat build/ros2-colcon.log
  return 1
}
judged "ros/adit_ros2 is not in order" /usr/bin/python3 ros/adit_ros2/test/check_sources.py
judged "colcon does not find the packages" colcon_finds
well_formed() { xmllint --noout ros/*/package.xml ros/adit_ros1/nodelets.xml ros/adit_ros1/*/*.{launch,test} gz/*/model.* gz/worlds/*.sdf; }
if command -v xmllint > /dev/null; then judged "a file of XML is none" well_formed; fi

# A count in rostest's summary, which is coloured when it is bad news.
summary_count() { sed -n "s/^.*\* $1: \([0-9][0-9]*\).*/\1/p" "$2" | head -n 1; }

run_suite() {  # SPACE NAME
  local results="$PWD/$1/results" name=$2 log=$1/$2.log verdict=passed begin=$SECONDS failed errors total
  timeout "${3:-600}" rostest --results-base-dir="$results" "ros/adit_ros1/test/$name.test" > "$log" 2>&1 || verdict=FAILED
  total=$(summary_count TESTS "$log")
  failed=$(summary_count FAILURES "$log") errors=$(summary_count ERRORS "$log")
  failed=$((${failed:-0} + ${errors:-0}))
  if [ "${total:-0}" = 0 ]; then verdict=FAILED total=1; fi
  if [ $verdict = FAILED ] && [ $failed = 0 ]; then failed=1; fi
  tally $((total - failed)) "$failed" 0
  echo "rostest $name: $verdict, $total tests in $((SECONDS - begin)) s"
  sed -n 's/^.*\(flight through topics:\|latency over\|same numbers:\)/  \1/p' \
    "$results"/adit_ros1/rosunit-"$name"{,_paper,_adit}.xml 2> /dev/null | head -n 5 || true  # not all of them are there
  if [ $verdict = FAILED ]; then
    tail -n 60 "$log"
    return 1
  fi
}

# run_suites SPACE NAME...: one after the other.
run_suites() {
  local space=$1 suite failed=0
  shift
  for suite in "$@"; do
    run_suite "$space" "$suite" || failed=1
  done
  return $failed
}

# The workspace's, with MAVROS's message. The soak takes its two minutes beside the others (memory has to stay flat), and so do
# the suites that wait for answers and not for time.
space=build/ros1-space
enter "$space/devel/setup.sh"
judged "a launch file is broken" launch_files
export ADIT_SOAK_S=${ADIT_SOAK_S:-120}
beside=()
run_suite "$space" soak $((ADIT_SOAK_S + 600)) > "$space/soak.out" 2>&1 &
beside+=($!)
run_suites "$space" s_bend bag zero_copy camera > "$space/beside.out" 2>&1 &
beside+=($!)
run_suites "$space" topics graph signs faults clock inputs parameters watchdog recording || status=1
for one in "${beside[@]}"; do wait "$one" || status=1; done
cat "$space/beside.out" "$space/soak.out"
# Then nothing else of ours runs.
run_suites "$space" latency latency_processes || status=1

# Each command of the READMEs, in that workspace.
ADIT_SPACE=$PWD/$space
export ADIT_SPACE
docs_run() {
  local begin=$SECONDS
  quietly ros1-docs python3 scripts/docs_commands.py --phase ros build/release/adit docs/ros.md ros/adit_ros1/README.md \
    "$@" || return 1
  echo "$(tail -n 1 build/ros1-docs.log) ($((SECONDS - begin)) s)"
}
if scripts/setup --ros --check gz; then
  judged "a command of the docs does not run" docs_run gz/README.md
else
  judged "a command of the docs does not run" docs_run
fi

# The install space: its launch file finds its nodelets, and commands come.
enter "$space/install/setup.sh"
judged "a launch file is broken where it is installed" launch_files
run_suite "$space" installed || status=1

# Without MAVROS's message, against the installed adit: the tables and the signs once more.
enter build/ros1/devel/setup.sh
run_suites build/ros1 graph signs || status=1

# Everything that roslaunch starts has a log file under ROS_HOME on its command line.
if pgrep -af "$ROS_HOME" > build/ros1-left.log; then
  echo "processes are left over:"
  cat build/ros1-left.log
  tally 0 1 0
  status=1
else
  tally 1 0 0
fi
exit $status
