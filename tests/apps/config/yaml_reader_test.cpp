#include "apps/config/yaml_reader.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/apps/test_files.h"

namespace lineservo::apps {
namespace {

using ::testing::AllOf;
using testing::complaint;
using ::testing::HasSubstr;
using ::testing::StartsWith;
using testing::TempFolder;

class YamlReaderTest : public ::testing::Test {
 protected:
  std::string file(const std::string& text) { return folder_.write("f.yaml", text).string(); }
  /// The complaint about the file of this text, when it is read and all its scalars are taken.
  std::string complaint_about(const std::string& text) {
    const std::string path = file(text);
    return complaint([&path] { YamlReader(path).scalars(); });
  }
  /// "FILE:LINE: ".
  std::string at(int line) const {
    return (folder_.path() / "f.yaml").string() + ":" + std::to_string(line) + ": ";
  }

  TempFolder folder_;
};

TEST_F(YamlReaderTest, JoinsTheKeysOfNestedMapsByDotsAndKeepsTheirLines) {
  const YamlReader yaml(file("a: 1\nb:\n  c: word\n  d: {e: 2.50}\n"));
  const std::vector<YamlEntry> entries = yaml.scalars();
  ASSERT_EQ(entries.size(), 3u);
  EXPECT_EQ(entries[0].key, "a");
  EXPECT_EQ(entries[0].text, "1");
  EXPECT_EQ(entries[0].line, 1);
  EXPECT_EQ(entries[1].key, "b.c");
  EXPECT_EQ(entries[1].text, "word");
  EXPECT_EQ(entries[1].line, 3);
  EXPECT_EQ(entries[2].key, "b.d.e");
  EXPECT_EQ(entries[2].text, "2.50");
  EXPECT_EQ(entries[2].line, 4);
}

TEST_F(YamlReaderTest, NamesAFileThatIsMissing) {
  EXPECT_EQ(complaint([] { YamlReader("/nowhere/x.yaml"); }), "/nowhere/x.yaml: cannot be read");
}

TEST_F(YamlReaderTest, NamesTheLineWhereAFileIsNotYaml) {
  EXPECT_THAT(complaint_about("a: 1\nb: [1, 2\nc: 3\n"), AllOf(StartsWith(at(3)), HasSubstr("not YAML")));
}

TEST_F(YamlReaderTest, RefusesWhatIsNotAMap) {
  EXPECT_THAT(complaint_about(""), HasSubstr("must be a map"));
  EXPECT_THAT(complaint_about("- 1\n- 2\n"), HasSubstr("must be a map"));
  EXPECT_THAT(complaint_about("word\n"), HasSubstr("must be a map"));
}

TEST_F(YamlReaderTest, RefusesAFolder) {
  const std::string path = folder_.path().string();
  EXPECT_THAT(complaint([&path] { YamlReader{path}; }), StartsWith(path));
}

TEST_F(YamlReaderTest, RefusesAKeyThatStandsTwiceAtAnyDepth) {
  EXPECT_EQ(complaint_about("a: 1\nb: 2\na: 3\n"), at(3) + "key 'a' twice");
  EXPECT_EQ(complaint_about("m:\n  a: 1\n  a: 1\n"), at(3) + "key 'a' twice");
  EXPECT_EQ(complaint_about("m:\n  - {a: 1, b: 2}\n  - {a: 1, a: 2}\n"), at(3) + "key 'a' twice");
}

TEST_F(YamlReaderTest, AKeyWithDotsIsTheOneOfItsMap) {
  EXPECT_EQ(complaint_about("m.a: 1\nm:\n  a: 2\n"), at(3) + "key 'm.a' twice, first in line 1");
}

TEST_F(YamlReaderTest, AllowsTheSameKeyInDifferentMaps) {
  EXPECT_EQ(complaint_about("m: {a: 1}\nn: {a: 1}\n"), "no error");
}

TEST_F(YamlReaderTest, RefusesAKeyThatIsNoWord) {
  EXPECT_EQ(complaint_about("a: 1\n[x, y]: 2\n"), at(2) + "a key must be a word");
}

TEST_F(YamlReaderTest, RefusesAListOrNothingWhereAScalarIsExpected) {
  EXPECT_EQ(complaint_about("a: 1\nm:\n  b: [1, 2]\n"), at(3) + "key 'm.b' needs a single value");
  EXPECT_EQ(complaint_about("a: 1\nb:\n"), at(2) + "key 'b' needs a single value");
}

TEST_F(YamlReaderTest, RefusesAnUnknownKeyWithItsLineAndTheAllowedOnes) {
  const YamlReader yaml(file("colour: red\nwidth: 1\n"));
  EXPECT_EQ(complaint([&] {
              yaml.allow(yaml.root(), {"colour", "radius"}, "a disc");
            }),
            at(2) + "unknown key 'width' of a disc; allowed: colour, radius");
  EXPECT_EQ(complaint([&] { yaml.allow(yaml.root(), {"colour", "width"}, "a disc"); }), "no error");
}

TEST_F(YamlReaderTest, NumbersAreFinite) {
  const YamlReader yaml(file("a: 0.25\nb: -3e-2\nc: .nan\nd: .inf\ne: word\nf: [1]\n"));
  EXPECT_EQ(yaml.number(yaml.root(), "a"), 0.25);
  EXPECT_EQ(yaml.number(yaml.root(), "b"), -0.03);
  for (const auto& [key, line] : {std::pair{"c", 3}, {"d", 4}, {"e", 5}, {"f", 6}}) {
    EXPECT_EQ(complaint([&, key = key] { yaml.number(yaml.root(), key); }),
              at(line) + "key '" + key + "' must be a finite number");
  }
}

TEST_F(YamlReaderTest, AMissingKeyIsAnErrorOrTheDefault) {
  const YamlReader yaml(file("a: 1\n"));
  EXPECT_EQ(complaint([&] { yaml.number(yaml.root(), "b"); }), at(1) + "key 'b' is missing");
  EXPECT_EQ(complaint([&] { yaml.text(yaml.root(), "b"); }), at(1) + "key 'b' is missing");
  EXPECT_EQ(complaint([&] { yaml.numbers(yaml.root(), "b", 2); }), at(1) + "key 'b' is missing");
  EXPECT_EQ(yaml.number(yaml.root(), "b", 7.5), 7.5);
  EXPECT_EQ(yaml.text(yaml.root(), "b", "x"), "x");
  EXPECT_EQ(yaml.number(yaml.root(), "a", 7.5), 1.0);
}

TEST_F(YamlReaderTest, TextIsAWordThatIsNotEmpty) {
  const YamlReader yaml(file("a: word\nb: ''\nc: [x]\n"));
  EXPECT_EQ(yaml.text(yaml.root(), "a"), "word");
  EXPECT_EQ(complaint([&] { yaml.text(yaml.root(), "b"); }), at(2) + "key 'b' must be a word");
  EXPECT_EQ(complaint([&] { yaml.text(yaml.root(), "c"); }), at(3) + "key 'c' must be a word");
}

TEST_F(YamlReaderTest, AListOfNumbersHasItsLength) {
  const YamlReader yaml(file("a: [1, -2.5]\nb: [1]\nc: [1, x]\nd: 4\ne: [1, .inf]\nf: [1, [2]]\n"));
  EXPECT_EQ(yaml.numbers(yaml.root(), "a", 2), (std::vector<double>{1.0, -2.5}));
  for (const auto& [key, line] : {std::pair{"b", 2}, {"c", 3}, {"d", 4}, {"e", 5}, {"f", 6}}) {
    EXPECT_EQ(complaint([&, key = key] { yaml.numbers(yaml.root(), key, 2); }),
              at(line) + "key '" + key + "' must be a list of 2 finite numbers");
  }
}

TEST_F(YamlReaderTest, AnchorsAndAliasesAreRefused) {
  for (const char* text : {"a: 1\nb: &x\n  c: *x\n", "a: 1\nb: &x 2\n", "a: 1\nb: &x [1]\n", "a: 1\nb: &x\n"})
    EXPECT_EQ(complaint_about(text), at(2) + "anchors (&x) and aliases (*x) are not allowed") << text;
}

// Each line doubles what the one before stands for nine times over: 9²⁰ words.
TEST_F(YamlReaderTest, ABombOfAliasesIsRefusedAtOnce) {
  std::string bomb = "a0: &a0 [x, x, x, x, x, x, x, x, x]\n";
  for (int k = 1; k < 20; ++k) {
    const std::string alias = "*a" + std::to_string(k - 1), name = "a" + std::to_string(k);
    bomb += name + ": &" + name + " [" + alias;
    for (int i = 1; i < 9; ++i) bomb += ", " + alias;
    bomb += "]\n";
  }
  EXPECT_THAT(complaint_about(bomb), StartsWith(at(1)));
}

TEST_F(YamlReaderTest, ASecondDocumentIsRefused) {
  for (const char* text : {"a: 1\n---\nb: 2\n", "a: 1\n---\n", "a: 1\n--- &x\n", "a: 1\n--- {b: [\n"})
    EXPECT_THAT(complaint_about(text), AllOf(StartsWith(at(2)), HasSubstr("second document"))) << text;
  EXPECT_THAT(complaint_about("a: 1\n...\nb: 2\n"), AllOf(StartsWith(at(3)), HasSubstr("second document")));
  for (const char* text : {"---\na: 1\n", "a: 1\n...\n", "%YAML 1.2\n---\na: 1\n", "a: 1\n# ---\n"})
    EXPECT_EQ(complaint_about(text), "no error") << text;
}

TEST_F(YamlReaderTest, RefusesAFileThatIsTooLongOrNotUtf8) {
  EXPECT_THAT(complaint_about("a: " + std::string(1 << 20, 'x') + "\n"), HasSubstr("longer than 1 MiB"));
  EXPECT_THAT(complaint_about("a: \"\xff\"\n"), HasSubstr("not UTF-8"));
  EXPECT_EQ(complaint_about("a: größer\n"), "no error");
}

TEST_F(YamlReaderTest, RefusesWhatIsNestedTooDeeply) {
  EXPECT_THAT(complaint_about("a: " + std::string(100, '[') + std::string(100, ']')),
              HasSubstr("nested too deeply"));
  EXPECT_THAT(complaint_about("a: " + std::string(100000, '[')), StartsWith(folder_.path().string()));
}

}  // namespace
}  // namespace lineservo::apps
