#include "apps/config/layout_file.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "features/geometry/angles.h"
#include "tests/apps/test_files.h"

namespace lineservo::apps {
namespace {

using ::testing::AllOf;
using testing::complaint;
using ::testing::HasSubstr;
using ::testing::StartsWith;
using testing::TempFolder;

/// A layout of one edge whose parts can be exchanged: one line each for name, nodes, edges, start and the
/// rest.
struct Text {
  std::string name = "name: test";
  std::string nodes = "nodes: [{name: p, x_m: 0, y_m: 0}, {name: q, x_m: 3, y_m: 4}]";
  std::string edges = "edges: [{from: p, to: q}]";
  std::string start = "start: {node: p}";
  std::string rest = "";

  std::string joined() const {
    return name + "\n" + nodes + "\n" + edges + "\n" + start + "\n" + rest + "\n";
  }
};

class LayoutFileTest : public ::testing::Test {
 protected:
  vehicle::Layout read(const Text& text) { return read_layout(folder_.write("l.yaml", text.joined())); }
  std::string refusal(const Text& text) {
    return complaint([&] { read(text); });
  }
  std::string at(int line) const {
    return (folder_.path() / "l.yaml").string() + ":" + std::to_string(line) + ": ";
  }

  TempFolder folder_;
};

TEST_F(LayoutFileTest, AnEdgeIsTheStraightLineBetweenItsNodes) {
  const vehicle::Layout layout = read({});
  EXPECT_EQ(layout.name, "test");
  ASSERT_EQ(layout.nodes.size(), 2u);
  ASSERT_EQ(layout.edges.size(), 1u);
  EXPECT_EQ(layout.nodes[1].p_W, Eigen::Vector2d(3, 4));
  EXPECT_DOUBLE_EQ(layout.edges[0].centreline.length_m(), 5.0);
  EXPECT_EQ(layout.edges[0].width_m, 0.36);
  EXPECT_EQ(layout.start, 0u);
  EXPECT_TRUE(layout.start_markers.empty());
  EXPECT_TRUE(layout.labels.empty());
}

TEST_F(LayoutFileTest, ColoursAreRedGreenBlueAndWidthsFallBackToTheLine) {
  Text text;
  text.nodes = "nodes: [{name: p, x_m: 0, y_m: 0}, {name: q, x_m: 3, y_m: 4}, {name: r, x_m: 6, y_m: 4}]";
  text.edges = "edges: [{from: p, to: q}, {from: q, to: r, width_m: 0.2, colour: [0, 127.6, 255]}]";
  text.rest = "floor: {colour: [1, 2, 3]}\nline: {width_m: 0.05, colour: [10, 20, 30]}";
  const vehicle::Layout layout = read(text);
  EXPECT_EQ(layout.floor_colour, (vehicle::Bgr{3, 2, 1}));
  EXPECT_EQ(layout.edges[0].width_m, 0.05);
  EXPECT_EQ(layout.edges[0].colour, (vehicle::Bgr{30, 20, 10}));
  EXPECT_EQ(layout.edges[1].width_m, 0.2);
  EXPECT_EQ(layout.edges[1].colour, (vehicle::Bgr{255, 128, 0}));
}

TEST_F(LayoutFileTest, AnArcTurnsAboutItsCentre) {
  Text text;
  text.nodes = "nodes: [{name: p, x_m: 2, y_m: 0}, {name: q, x_m: 0, y_m: 2}]";
  text.edges = "edges: [{from: p, to: q, arc: {centre: [0, 0], direction: left}}]";
  EXPECT_NEAR(read(text).edges[0].centreline.length_m(), features::kPi, 1e-12);
  text.edges = "edges: [{from: p, to: q, arc: {centre: [0, 0], direction: right}}]";
  EXPECT_NEAR(read(text).edges[0].centreline.length_m(), 3.0 * features::kPi, 1e-12);
}

TEST_F(LayoutFileTest, AnEdgeGoesThroughItsPoints) {
  Text text;
  text.edges = "edges: [{from: p, to: q, through: [[3, 0]]}]";
  const vehicle::Layout layout = read(text);
  EXPECT_DOUBLE_EQ(layout.edges[0].centreline.length_m(), 7.0);
  EXPECT_EQ(layout.edges[0].centreline.at(3.0).p_W, Eigen::Vector2d(3, 0));
}

TEST_F(LayoutFileTest, MarkersLieOnTheirNodes) {
  Text text;
  text.start = "start: {node: q, marker_radius_m: 0.18, marker_colour: [220, 40, 30]}";
  text.rest = "end_markers: [{node: p, radius_m: 0.1, colour: [200, 0, 0]}]";
  const vehicle::Layout layout = read(text);
  EXPECT_EQ(layout.start, 1u);
  ASSERT_EQ(layout.start_markers.size(), 1u);
  EXPECT_EQ(layout.start_markers[0].p_W, Eigen::Vector2d(3, 4));
  EXPECT_EQ(layout.start_markers[0].radius_m, 0.18);
  EXPECT_EQ(layout.start_markers[0].colour, (vehicle::Bgr{30, 40, 220}));
  ASSERT_EQ(layout.end_markers.size(), 1u);
  EXPECT_EQ(layout.end_markers[0].p_W, Eigen::Vector2d(0, 0));
}

TEST_F(LayoutFileTest, LabelsAreInstructionsInTheirShortSpelling) {
  Text text;
  text.rest = "labels: {a:1:2: q, a:12:3: p}";
  const vehicle::Layout layout = read(text);
  EXPECT_EQ(layout.labels, (std::map<std::string, std::size_t>{{"a12", 1}, {"a:12:3", 0}}));
}

TEST_F(LayoutFileTest, LinesThatRunOverEachOtherAreToldInOneLine) {
  Text text;
  text.nodes =
      "nodes: [{name: p, x_m: 0, y_m: 0}, {name: q, x_m: 4, y_m: 0}, {name: r, x_m: 2, y_m: -2}, "
      "{name: s, x_m: 2, y_m: 2}]";
  text.edges = "edges: [{from: p, to: q}, {from: r, to: s}, {from: q, to: p}]";
  const std::string message = refusal(text);
  EXPECT_THAT(message, AllOf(StartsWith((folder_.path() / "l.yaml").string() + ": "),
                             HasSubstr("edge 2 (q to p) doubles edge 0 (p to q)"),
                             HasSubstr("edge 0 (p to q) and edge 1 (r to s) run over each other at (")));
  EXPECT_EQ(message.find('\n'), std::string::npos);
}

TEST_F(LayoutFileTest, SkewedBranchesAreSound) {
  for (const char* tip : {"x_m: 5, y_m: 2", "x_m: 4, y_m: 1.7", "x_m: 1, y_m: 2"}) {
    Text text;
    text.nodes =
        std::string("nodes: [{name: p, x_m: 0, y_m: 0}, {name: q, x_m: 3, y_m: 0}, {name: r, ") + tip + "}]";
    text.edges = "edges: [{from: p, to: q}, {from: q, to: r}]";
    EXPECT_EQ(refusal(text), "no error") << tip;
  }
}

/// A fault, the line of the file that it stands on, and words of the complaint.
struct Fault {
  std::string what;
  Text text;
  int line;
  std::string words;
};

void PrintTo(const Fault& fault, std::ostream* stream) {
  *stream << fault.what;
}

std::vector<Fault> all_faults() {
  const auto nodes = [](const std::string& text) { return Text{.nodes = text}; };
  const auto edges = [](const std::string& text) { return Text{.edges = text}; };
  const auto start = [](const std::string& text) { return Text{.start = text}; };
  const auto rest = [](const std::string& text) { return Text{.rest = text}; };
  return {
      {"no name", {.name = "description: x"}, 1, "'name' is missing"},
      {"unknown key", rest("colours: red"), 5, "unknown key 'colours' of a layout; allowed: name"},
      {"no nodes", nodes("nodes: []"), 2, "'nodes' must be a list with at least one item"},
      {"a node without y", nodes("nodes: [{name: p, x_m: 0}]"), 2, "'y_m' is missing"},
      {"a node at infinity", nodes("nodes: [{name: p, x_m: .inf, y_m: 0}]"), 2,
       "'x_m' must be a finite number"},
      {"a node too far away", nodes("nodes: [{name: p, x_m: 0, y_m: 10001}]"), 2,
       "x and y must be -10000 to 10000"},
      {"a point too far away", edges("edges: [{from: p, to: q, through: [[-1e150, 2]]}]"), 3,
       "x and y must be -10000 to 10000"},
      {"an arc too wide", edges("edges: [{from: p, to: q, arc: {centre: [0, 1001], direction: left}}]"), 3,
       "radius must be at most 1000"},
      {"unknown key of a node", nodes("nodes: [{name: p, x_m: 0, y_m: 0, z_m: 0}]"), 2,
       "unknown key 'z_m' of a node"},
      {"a node twice",
       nodes("nodes:\n  - {name: p, x_m: 0, y_m: 0}\n  - {name: q, x_m: 1, y_m: 0}\n"
             "  - {name: p, x_m: 2, y_m: 0}"),
       5, "'p'"},
      {"no edges", edges("edges: []"), 3, "'edges' must be a list with at least one item"},
      {"an unknown node", edges("edges: [{from: p, to: z}]"), 3, "'to' names no node: 'z'"},
      {"an edge of no length", edges("edges: [{from: p, to: p}]"), 3, "edge from 'p' to 'p': "},
      {"an edge through its own end", edges("edges: [{from: p, to: q, through: [[3, 4]]}]"), 3,
       "edge from 'p' to 'q': "},
      {"radii that differ", edges("edges: [{from: p, to: q, arc: {centre: [0, 4], direction: left}}]"), 3,
       "same, positive distance"},
      {"an arc without direction", edges("edges: [{from: p, to: q, arc: {centre: [0, 4]}}]"), 3,
       "'direction' is missing"},
      {"an arc up", edges("edges: [{from: p, to: q, arc: {centre: [0, 4], direction: up}}]"), 3,
       "left or right"},
      {"an arc through points",
       edges("edges: [{from: p, to: q, arc: {centre: [0, 4], direction: left}, through: [[1, 1]]}]"), 3,
       "not both"},
      {"a point of three", edges("edges: [{from: p, to: q, through: [[1, 2, 3]]}]"), 3, "2 finite numbers"},
      {"through a word", edges("edges: [{from: p, to: q, through: somewhere}]"), 3,
       "'through' must be a list"},
      {"no width", edges("edges: [{from: p, to: q, width_m: 0}]"), 3, "width"},
      {"a colour of two", edges("edges: [{from: p, to: q, colour: [1, 2]}]"), 3, "3 finite numbers"},
      {"a colour above 255", rest("line: {colour: [0, 256, 0]}"), 5, "0 to 255"},
      {"a colour below 0", rest("floor: {colour: [0, 0, -1]}"), 5, "0 to 255"},
      {"a colour by name", rest("floor: {colour: red}"), 5, "3 finite numbers"},
      {"no start", start(""), 1, "'start' is missing"},
      {"an unknown start", start("start: {node: z}"), 4, "names no node: 'z'"},
      {"a start that is a word", start("start: p"), 4, "start must be a map"},
      {"a marker below nothing", start("start: {node: p, marker_radius_m: -0.1}"), 4, "radius"},
      {"a marker too large", start("start: {node: p, marker_radius_m: 2.1}"), 4, "radius"},
      {"an end marker of no size", rest("end_markers: [{node: p, radius_m: 0}]"), 5, "radius"},
      {"a bad label", rest("labels:\n  a13: p\n  e13: q"), 7, "'e13' is not an instruction"},
      {"a label of no node", rest("labels: {a13: z}"), 5, "names no node: 'z'"},
      {"a label twice in two spellings", rest("labels:\n  a13: p\n  a:1:3: q"), 7, "a13"},
      {"labels in a list", rest("labels: [a13]"), 5, "'labels' must map"},
  };
}

class LayoutFault : public LayoutFileTest, public ::testing::WithParamInterface<Fault> {};

TEST_P(LayoutFault, IsToldInOneLineWithItsPlace) {
  const std::string message = refusal(GetParam().text);
  EXPECT_THAT(message, AllOf(StartsWith(at(GetParam().line)), HasSubstr(GetParam().words)))
      << GetParam().what;
  EXPECT_EQ(message.find('\n'), std::string::npos);
}

INSTANTIATE_TEST_SUITE_P(All, LayoutFault, ::testing::ValuesIn(all_faults()), [](const auto& param) {
  std::string name = param.param.what;
  for (char& c : name) c = std::isalnum(static_cast<unsigned char>(c)) ? c : '_';
  return name;
});

}  // namespace
}  // namespace lineservo::apps
