#!/usr/bin/env python3
"""What can be judged of this package where there is no ROS 2: it is read, and compared with the one for ROS 1 and the tables.

Nothing here is compiled or run by ROS 2; scripts/test ros says so, too.
"""
import ast
import os
import re
import sys

import yaml
from catkin_pkg.package import parse_package

HERE = os.path.join(os.path.dirname(os.path.abspath(__file__)), "..")
ROS = os.path.join(HERE, "..")
# Not in this package, and its README says so.
NOT_HERE = {"setpoint_raw/local", "image/compressed", "~parameter_descriptions", "~parameter_updates", "~set_parameters"}
faults = []


def expect(is_good, words):
    if not is_good:
        faults.append(words)


def read(*path):
    with open(os.path.join(*path)) as file:
        return file.read()


def check_messages():
    for name in os.listdir(os.path.join(ROS, "adit_ros1", "msg")):
        of_ros1 = re.sub(r"^Header ", "std_msgs/Header ", read(ROS, "adit_ros1", "msg", name), flags=re.M)
        expect(of_ros1 == read(HERE, "msg", name), "msg/%s: not that of adit_ros1" % name)


def check_package():
    package = parse_package(os.path.join(HERE, "package.xml"))
    package.evaluate_conditions({"ROS_VERSION": "2"})
    expect(package.get_build_type() == "ament_cmake", "package.xml: not of ament_cmake under ROS 2")
    wanted = set(re.findall(r"find_package\((\w+) REQUIRED", read(HERE, "CMakeLists.txt")))
    named = {d.name for d in package.buildtool_depends + package.build_depends if d.evaluated_condition}
    expect(wanted - {"adit"} <= named, "package.xml: without %s, which CMakeLists.txt looks for" % (wanted - {"adit"} - named))
    package.evaluate_conditions({"ROS_VERSION": "1"})
    expect(package.get_build_type() == "catkin", "package.xml: stands in catkin's way under ROS 1")
    expect(not [d for d in package.build_depends if d.evaluated_condition], "package.xml: wants ROS 2 under ROS 1")


def tables(title):
    """Node: the first cells in backquotes of its tables in this part of ros/PARAMETERS.md."""
    part = read(ROS, "PARAMETERS.md").split("\n## %s\n" % title)[1].split("\n## ")[0]
    found, node = {}, None
    for line in part.splitlines():
        if line.startswith("### Node `"):
            node = line.split("`")[1]
        elif line.startswith("| ") and "`" in line and node:
            found.setdefault(node, set()).add(line.split("`")[1])
    return found


def check_topics_and_parameters():
    topics, parameters = tables("Topics"), tables("Parameters")
    for node, source in (("open_space", "open_space.cpp"), ("controller", "controller.cpp")):
        text = read(HERE, "src", source)
        named = set(re.findall(r"create_(?:publisher|subscription)<[\w:]+>\(\s*\"([\w/]+)\"", text))
        named |= set(re.findall(r"create_subscription\(\s*this, \"([\w/]+)\"", text))
        if "diagnostic_updater::Updater" in text:
            named.add("/diagnostics")
        expect(named == topics[node] - NOT_HERE, "src/%s: topics that the tables do not have, or not here: %s" % (
            source, sorted(named ^ (topics[node] - NOT_HERE))))
        for name in re.findall(r"declare_parameter\(\"(\w+)\"", text):
            expect(name in parameters[node], "src/%s: parameter %s is in no table" % (source, name))
    for name, node in yaml.safe_load(read(HERE, "config", "default.yaml")).items():
        for parameter in node["ros__parameters"]:
            expect(parameter in parameters[name], "config/default.yaml: %s/%s is in no table" % (name, parameter))


def check_launch():
    tree = ast.parse(read(HERE, "launch", "perception.launch.py"))
    functions = [n.name for n in tree.body if isinstance(n, ast.FunctionDef)]
    expect("generate_launch_description" in functions, "launch/perception.launch.py: describes no launch")
    text = read(HERE, "launch", "perception.launch.py")
    components = set(re.findall(r"plugin=\"([\w:]+)\"", text))
    registered = set(re.findall(r"PLUGIN \"([\w:]+)\"", read(HERE, "CMakeLists.txt")))
    expect(components == registered, "launch/perception.launch.py: other components than CMakeLists.txt registers")
    for component in registered:
        sources = "".join(read(HERE, "src", name) for name in os.listdir(os.path.join(HERE, "src")))
        expect("REGISTER_NODE(%s)" % component in sources, "CMakeLists.txt: %s is in no source" % component)


for check in (check_messages, check_package, check_topics_and_parameters, check_launch):
    check()
for fault in faults:
    print("ros/adit_ros2: " + fault)
sys.exit(1 if faults else 0)
