"""Perception and controller in one container behind any camera driver.

ros2 launch adit_ros2 perception.launch.py image:=/camera/image_raw camera_info:=/camera/camera_info
"""
from launch import LaunchDescription
from launch.actions import DeclareLaunchArgument
from launch.substitutions import LaunchConfiguration, PathJoinSubstitution
from launch_ros.actions import ComposableNodeContainer
from launch_ros.descriptions import ComposableNode
from launch_ros.substitutions import FindPackageShare


def generate_launch_description():
    config = PathJoinSubstitution([FindPackageShare("adit_ros2"), "config", "default.yaml"])
    intra_process = [{"use_intra_process_comms": True}]
    return LaunchDescription([
        DeclareLaunchArgument("image", default_value="camera/image_raw"),
        DeclareLaunchArgument("camera_info", default_value="camera/camera_info"),
        DeclareLaunchArgument("imu", default_value="imu"),
        ComposableNodeContainer(
            name="adit_container", namespace="", package="rclcpp_components", executable="component_container",
            output="screen",
            composable_node_descriptions=[
                ComposableNode(
                    package="adit_ros2", plugin="adit_ros2::OpenSpaceNode", name="open_space",
                    parameters=[config], extra_arguments=intra_process,
                    remappings=[("image", LaunchConfiguration("image")),
                                ("camera_info", LaunchConfiguration("camera_info")),
                                ("imu", LaunchConfiguration("imu"))]),
                ComposableNode(
                    package="adit_ros2", plugin="adit_ros2::ControllerNode", name="controller",
                    parameters=[config], extra_arguments=intra_process),
            ]),
    ])
