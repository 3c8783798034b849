#include "workplace.h"

namespace honeycomb::Test {
namespace {

using testing::HasSubstr;
using Options = std::vector<std::string>;

/// Options that must be refused, and what the one line must say.
struct Refused {
  Options options;
  std::vector<std::string> what;
};

class BadSchemeTest : public Workplace {
 protected:
  void expectRefused(const std::string& in, const std::vector<Refused>& list) const {
    for (const Refused& bad : list) {
      Options arguments{"refine", in, path("out.obj")};
      arguments.insert(arguments.end(), bad.options.begin(), bad.options.end());
      std::vector<testing::Matcher<std::string>> parts;
      for (const std::string& part : bad.what) parts.emplace_back(HasSubstr(part));
      EXPECT_REFUSED(arguments, testing::AllOfArray(parts));
    }
  }
};

TEST_F(BadSchemeTest, ChainsThatCantBeReadOrMeanTooMuch) {
  expectRefused(file("cube.obj", cubeObj()),
                {{{"--scheme", "akleman:1,half-box"}, {"'half-box' must say how many levels", "half-box:1"}},
                 {{"--scheme", "akleman:0"}, {"'akleman:0'", "1 to 20"}},
                 {{"--scheme", "akleman:x"}, {"'akleman:x'"}},
                 {{"--scheme", "akleman:1,"}, {"NAME:LEVELS", "missing"}},
                 {{"--scheme", "akleman:1,polish:2"}, {"no 'polish'", "zhang-wang", "half-box"}},
                 {{"--scheme", "akleman:12,half-box:9"}, {"21 levels, 20 is the most"}},
                 {{"--scheme", "akleman:1,half-box:1", "--levels", "3"}, {"--levels 3", "has 2"}},
                 {{"--scheme", "midpoint:1,half-box:1", "--convert", "none"}, {"level 1: ", "has 4 edges"}}});
}

TEST_F(BadSchemeTest, OptionsOfOtherSchemesAreRefusedNamingTheirs) {
  expectRefused(
      file("cube.obj", cubeObj()),
      {{{"--scheme", "half-box", "--tension", "paper"}, {"--tension: half-box", "only akleman"}},
       {{"--ratio", "0.3"}, {"--ratio: akleman", "only trisect"}},
       {{"--scheme", "zhang-wang", "--tuned", "all"}, {"--tuned: zhang-wang", "only half-box"}},
       {{"--scheme", "midpoint", "--boundary", "brick"}, {"--boundary: midpoint", "only akleman, zhang-wang"}},
       {{"--scheme", "centroid", "--boundary", "brick"}, {"no 'brick'", "centroid has drop"}},
       {{"--scheme", "akleman:1,half-box:1", "--boundary", "x"}, {"brick, eq16, drop; half-box has natural"}},
       {{"--scheme", "half-box", "--corners", "valence2"}, {"--corners: half-box"}},
       {{"--scheme", "zhang-wang", "--corners", "valence2"}, {"--boundary eq16", "brick"}},
       {{"--scheme", "zhang-wang", "--boundary", "brick", "--sn", "0.1"}, {"--sn 0.1", "eq16"}},
       {{"--scheme", "half-box:1,zhang-wang:1", "--ccv-offset", "1"}, {"--ccv-offset", "half-box hasn't"}}});
}

TEST_F(BadSchemeTest, ValuesOutOfRangeAreRefusedWithTheirRangeOrChoices) {
  expectRefused(file("cube.obj", cubeObj()),
                {{{"--scheme", "zhang-wang", "--an", "2"}, {"zhang-wang: a 2", "[0, 1]"}},
                 {{"--scheme", "zhang-wang", "--an", "soft"}, {"--an", "paper, kobbelt"}},
                 {{"--scheme", "zhang-wang", "--an", "0.02"}, {"faces of 4 sides", "no tangent plane", "--force"}},
                 {{"--scheme", "zhang-wang", "--bn", "1"}, {"b 1 ", "(0, 1)"}},
                 {{"--scheme", "zhang-wang", "--cn", "-1"}, {"c -1 "}},
                 {{"--scheme", "zhang-wang", "--alpha", "nan"}, {"alpha nan "}},
                 {{"--scheme", "zhang-wang", "--sn", "2"}, {"boundary weight 2"}},
                 {{"--scheme", "zhang-wang", "--interpolate", "edges"}, {"none, vertices"}},
                 {{"--scheme", "zhang-wang", "--ccv-offset", "inf"}, {"--ccv-offset inf", "finite"}},
                 {{"--scheme", "trisect", "--ratio", "0.5"}, {"ratio 0.5", "(0, 1/2)"}},
                 {{"--scheme", "half-box", "--tuned", "some"}, {"none, first, all"}},
                 {{"--scheme", "half-box", "--convert", "some"}, {"auto, none, dual, trisect, akleman"}}});
}

TEST_F(BadSchemeTest, CentralControlVerticesThatDontFitTheMeshAreRefused) {
  const auto central = [this](const std::string& name, const std::string& text) {
    return Options{"--scheme", "zhang-wang", "--ccv", file(name, text)};
  };
  Options both = central("six.obj", "v 0 0 0\nv 0 0 0\nv 0 0 0\nv 0 0 0\nv 0 0 0\nv 0 0 0\n");
  both.insert(both.end(), {"--ccv-offset", "1"});
  expectRefused(
      file("cube.obj", cubeObj()),
      {{central("few.obj", "v 0 0 0\nv 1 1 1\n"), {"few.obj: has 2 points", "cube.obj has 6 faces"}},
       {central("text.obj", "\nv 0 0 x\n"), {"text.obj:2: "}},
       {central("nan.obj", "v 0 nan 0\n"), {"nan.obj:1: point 1"}},
       {central("none.obj", "# nothing\n"), {"none.obj: has no points"}},
       {central("walk.pc2", "POINTCACHE2"), {"--ccv", "walk.pc2", "one pose"}},
       {{"--scheme", "zhang-wang", "--ccv", path("missing.obj")}, {"missing.obj"}},
       {both, {"--ccv-offset", "--ccv already"}},
       {{"--scheme", "zhang-wang", "--ccv-offset", path("far")}, {"--ccv-offset", "far: is neither a number nor"}},
       {{"--scheme", "zhang-wang", "--ccv-offset", file("few.txt", "1\n2\n")},
        {"few.txt: has 2 offsets", "cube.obj has 6 faces"}},
       {{"--scheme", "zhang-wang", "--ccv-offset", file("bad.txt", "1\n2x\n")},
        {"bad.txt:2: give one finite number"}}});
}

TEST_F(BadSchemeTest, VerticesThatASchemeCantTakeAreNamedAsInTheFile) {
  // A pyramid: vertex 2 of the file is the apex, with four edges; vertex 1 is dropped.
  const std::string pyramid =
      "v 9 9 9\nv 0 0 1\nv 1 1 0\nv -1 1 0\nv -1 -1 0\nv 1 -1 0\nf 6 5 4 3\nf 3 4 2\nf 4 5 2\nf 5 6 2\nf 6 3 2\n";
  expectRefused(file("pyramid.obj", pyramid), {{{"--scheme", "half-box", "--convert", "none", "--drop-isolated"},
                                                {"pyramid.obj:2: vertex 2 has 4 edges", "--convert auto"}}});
  // Two triangles back to back: each vertex has two faces.
  expectRefused(file("pillow.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\nf 3 2 1\n"),
                {{{"--scheme", "half-box"}, {"pillow.obj:1: vertex 1 has 2 faces", "dissolve it"}}});
}

TEST_F(BadSchemeTest, TessellationsNeedThePatchesOfUntunedHalfBoxSplines) {
  expectRefused(
      file("cube.obj", cubeObj()),
      {{{"--tessellate", "4"}, {"akleman has no patches", "half-box"}},
       {{"--scheme", "half-box", "--tessellate", "0"}, {"1 to 64"}},
       {{"--scheme", "half-box", "--tessellate", "65"}, {"1 to 64"}},
       {{"--scheme", "half-box", "--levels", "0"}, {"--levels 0", "1 to 20"}},
       {{"--scheme", "half-box", "--tuned", "all", "--tessellate", "2"}, {"--tuned none"}},
       {{"--scheme", "half-box", "--tuned", "first", "--levels", "0", "--tessellate", "2"}, {"--levels 1 or more"}},
       {{"--scheme", "half-box", "--boundary", "clamped", "--tessellate", "2"}, {"natural"}},
       {{"--scheme", "half-box", "--tessellate", "64", "--levels", "7"}, {"cube.obj: --tessellate 64", "bytes"}}});
}

}  // namespace
}  // namespace honeycomb::Test
