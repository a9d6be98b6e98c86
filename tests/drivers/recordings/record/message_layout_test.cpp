// Definitions as rosbag2 writes them: the .msg files of their packages, unchanged, one behind the
// other. The rules are those of rosidl_adapter's parser and of XCDR1.
#include "drivers/recordings/record/message_layout.hpp"

#include <gtest/gtest.h>

#include "drivers/recordings/record/layouts.hpp"

namespace drydock::record {
namespace message_layout_test {

/// The names of all scalars and texts, with their paths, in their order.
void names_of(const MessageNode& node, const std::string& path, std::string& out) {
  if (node.scalar != Scalar::nested) out += path + node.name + " ";
  for (const auto& member : node.members)
    names_of(member, node.name.empty() ? path : path + node.name + ".", out);
}

std::string names_in(const std::string& definition, const std::string& type = "t/msg/M") {
  const auto layout = parse_definition(definition, type);
  if (!layout) return layout.error().line;
  std::string out;
  names_of(*layout, "", out);
  return out;
}

std::string behind(const std::string& type, const std::string& text) {
  return "\n" + std::string(80, '=') + "\nMSG: " + type + "\n" + text;
}

TEST(Definition, ABareNameIsOfThePackageThatNamesIt) {
  const std::string pose =
      behind("geometry_msgs/Pose", "Point position\nQuaternion orientation\n") +
      behind("geometry_msgs/Point", "float64 x\nfloat64 y\nfloat64 z\n") +
      behind("geometry_msgs/Quaternion", "float64 x 0\nfloat64 w 1\n");
  const std::string names = "position.x position.y position.z orientation.x orientation.w ";
  EXPECT_EQ(names_in("Point position\nQuaternion orientation\n" + pose, "geometry_msgs/msg/Pose"),
            names);
  EXPECT_EQ(names_in("geometry_msgs/Pose pose\n" + pose, "nav_msgs/msg/Odometry"),
            "pose.position.x pose.position.y pose.position.z pose.orientation.x "
            "pose.orientation.w ");
  EXPECT_EQ(names_in("Point p\n" + behind("a/Point", "int8 a\n") + behind("b/Point", "int8 b\n"),
                     "b/msg/M"),
            "p.b ");
}

TEST(Definition, ANestedTypeHasItsFullName) {
  const auto layout = parse_definition(
      "Time stamp\n" + behind("builtin_interfaces/Time", "int32 sec\nuint32 nanosec\n"),
      "builtin_interfaces/msg/Stamped");
  ASSERT_TRUE(layout) << layout.error().line;
  EXPECT_EQ(layout->members[0].type, "builtin_interfaces/Time");
}

TEST(Definition, TheFolderOfATypeMayBeNamed) {
  EXPECT_EQ(names_in("a/msg/P p\n" + behind("a/P", "int8 x\n")), "p.x ");
  EXPECT_EQ(names_in("a/P p\n" + behind("a/msg/P", "int8 x\n")), "p.x ");
}

TEST(Definition, ConstantsAreNoFieldsAndDefaultsAreNoConstants) {
  EXPECT_EQ(names_in("int32 A=1\nint32 B = 2\nint32 C= 3\nint32 D =4\nint8 a\n"), "a ");
  EXPECT_EQ(names_in("string<=10 NAME=\"x\"\nstring<=5 S = 'a'\nint8 a\n"), "a ");
  EXPECT_EQ(names_in("string COMPARE=\"a<=b\"\nint8 a\n"), "a ");
  EXPECT_EQ(names_in("string key \"a=b\"\nint8 a 7\nint32[3] v [1, 2, 3]\nfloat64[] w []\n"),
            "key a v w ");
}

TEST(Definition, CommentsTabsAndLineEndsOfWindowsAreRead) {
  EXPECT_EQ(names_in("# int8 no\r\n\tint8\ta   # = 3\r\n   # more\r\nstring s \"#\"\r\n"), "a s ");
}

TEST(Definition, BoundedTextsAndArraysHaveTheirScalars) {
  const auto layout = parse_definition(
      "string<=10 a\nstring<=10[] b\nstring<=10[<=5] c\nstring<=10[5] d\nfloat32[<=9] e\nbyte[2] "
      "f\nchar g\n",
      "t/msg/M");
  ASSERT_TRUE(layout) << layout.error().line;
  using Repeat = MessageNode::Repeat;
  const Repeat repeats[]{Repeat::once,     Repeat::sequence, Repeat::sequence, Repeat::array,
                         Repeat::sequence, Repeat::array,    Repeat::once};
  for (std::size_t i = 0; i < std::size(repeats); ++i) {
    EXPECT_EQ(layout->members[i].repeat, repeats[i]) << i;
    EXPECT_EQ(layout->members[i].scalar, i < 4    ? Scalar::text
                                         : i == 4 ? Scalar::float32
                                                  : Scalar::uint8);
  }
  EXPECT_EQ(layout->members[3].count, 5U);
}

/// rosidl puts one byte into a message without fields, because a C structure needs a member.
TEST(Definition, AMessageWithoutFieldsHasOneByte) {
  EXPECT_EQ(names_in("# nothing\nint8 A=1\n", "std_msgs/msg/Empty"),
            "structure_needs_at_least_one_member ");
  EXPECT_EQ(names_in("std_msgs/Empty e\nint8 a\n" + behind("std_msgs/Empty", "")),
            "e.structure_needs_at_least_one_member a ");
}

TEST(Definition, WhatIsNotReadIsSaid) {
  EXPECT_EQ(names_in("geometry_msgs/Pose pose\n"),
            "its definition does not have geometry_msgs/Pose");
  EXPECT_EQ(names_in("Pose pose\n"), "its definition does not have t/Pose");
  EXPECT_EQ(names_in("wstring w\n"), "its definition has a wstring, which is not read");
  EXPECT_EQ(names_in("@optional int8 a\n"),
            "its definition has an @optional field, which is not read");
  EXPECT_EQ(names_in("A a\n" + behind("t/A", "A a\n")),
            "its definition is nested too deeply, or has more than 10000 fields");
}

Understood message_of(const mcap::Channel& channel, const mcap::Schema& schema) {
  return {&channel, &schema, {}, {}};
}

TEST(Layouts, AnotherEncodingIsSaid) {
  const auto why = [](const mcap::Schema& schema, const std::string& encoding) {
    const mcap::Channel channel{1, 1, "/t", encoding, {}};
    Layouts layouts;
    const auto& layout = layouts.of(message_of(channel, schema));
    return layout ? std::string() : layout.error().line;
  };
  EXPECT_EQ(why({1, "t/msg/M", "ros2msg", "int8 a\n"}, "cdr"), "");
  EXPECT_EQ(why({1, "t/msg/M", "ros2idl", "module t {};\n"}, "cdr"),
            "its definition is in 'ros2idl', and only 'ros2msg' is read");
  EXPECT_EQ(why({1, "t/msg/M", "ros2msg", "int8 a\n"}, "json"),
            "it is encoded as 'json', and only 'cdr' is read");
  EXPECT_EQ(why({1, "t/msg/M", "", ""}, "cdr"), "the recording has no definition of it");
}

TEST(Misfit, SaysWhyAMessageIsNotRead) {
  const auto layout = parse_definition("int32 a\nfloat64 b\n", "t/msg/M").value();
  std::vector<std::uint8_t> cdr(4 + 16);
  cdr[1] = 1;
  EXPECT_EQ(misfit(layout, cdr), "");
  cdr.pop_back();
  EXPECT_EQ(misfit(layout, cdr), "it ends before its definition does");
  cdr.push_back(0);
  cdr[1] = 0;
  EXPECT_EQ(misfit(layout, cdr),
            "its CDR begins with 00 00, and only plain CDR, little endian (00 01) is read");
  EXPECT_EQ(misfit(layout, mcap::Bytes(cdr).first(3)), "it ends before its definition does");
}

}  // namespace message_layout_test
}  // namespace drydock::record
