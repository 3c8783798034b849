// Which form the faces of a level take, and that its weights are those of the row.
#include "far/tables/circulant_form.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "far/schemes/akleman.h"
#include "far/schemes/doo_sabin.h"
#include "tests/support/refined.h"
#include "tests/support/shapes.h"

namespace honeycomb::Test {
namespace {

using Far::CirculantForm;

CirculantForm formOf(const Result<Far::Scheme>& scheme, std::int32_t sides) {
  return Far::circulantForm(Far::firstRow(scheme.value().faceRule(sides), sides));
}

TEST(CirculantForm, OfAklemanSchemesInTheMiddleOfEdgesHasTwoOrThreeWeights) {
  for (const auto rule : {Far::Tension::Rule::paper, Far::Tension::Rule::sqrt3, Far::Tension::Rule::topmod}) {
    Far::AklemanOptions options;
    options.tension.rule = rule;
    EXPECT_EQ(formOf(Far::akleman(options), 4), CirculantForm::quad);
    EXPECT_EQ(formOf(Far::akleman(options), 6), CirculantForm::hexagon);
  }
}

TEST(CirculantForm, OfOtherRowsIsGeneral) {
  EXPECT_EQ(formOf(Far::akleman(), 5), CirculantForm::direct);
  EXPECT_EQ(formOf(Far::akleman(), 8), CirculantForm::evenOdd);
  Far::AklemanOptions aside;
  aside.edgeParameter = 0.25;
  EXPECT_EQ(formOf(Far::akleman(aside), 4), CirculantForm::evenOdd);
  EXPECT_EQ(formOf(Far::akleman(aside), 6), CirculantForm::evenOdd);
  EXPECT_EQ(formOf(Far::dooSabin(), 6), CirculantForm::evenOdd);
}

TEST(CirculantForm, SeesRoundingButNoRealDifference) {
  const std::vector<double> row{0.3, 0.3, 0.15, 0.05, 0.05, 0.15};
  EXPECT_EQ(Far::circulantForm(row), CirculantForm::hexagon);
  for (std::size_t k = 0; k < 6; ++k) {
    std::vector<double> rounded = row, other = row;
    rounded[k] += 2e-16;
    other[k] += 1e-13;
    EXPECT_EQ(Far::circulantForm(rounded), CirculantForm::hexagon) << k;
    EXPECT_EQ(Far::circulantForm(other), CirculantForm::evenOdd) << k;
  }
}

TEST(CirculantForm, WeightsOfAHexagonAreThoseOfTheDocumentedSums) {
  const std::vector<double> row{0.3, 0.3, 0.15, 0.05, 0.05, 0.15};
  const auto weights = Far::formWeights(CirculantForm::hexagon, row);
  ASSERT_EQ(weights.size(), static_cast<std::size_t>(Far::formWeightCount(CirculantForm::hexagon, 6)));
  EXPECT_DOUBLE_EQ(weights[0], (0.3 + 0.05) / 2);           // K = E_0
  EXPECT_NEAR(weights[1], (0.3 + 0.05) / 2 - 0.15, 1e-16);  // A = E_0 - E_2
  EXPECT_DOUBLE_EQ(weights[2], (0.3 - 0.05) / 2);           // G = O_0
}

TEST(CirculantForm, WeightsOfAQuadAreThoseOfTheDocumentedSums) {
  const auto weights = Far::formWeights(CirculantForm::quad, {0.4, 0.4, 0.1, 0.1});
  ASSERT_EQ(weights.size(), static_cast<std::size_t>(Far::formWeightCount(CirculantForm::quad, 4)));
  EXPECT_DOUBLE_EQ(weights[0], 0.25);
  EXPECT_DOUBLE_EQ(weights[1], 0.15);
}

TEST(CirculantForm, OfARefinedTorusIsThatOfItsSides) {
  const Far::Refinement refinement = refined(torus(6, 5), schemeCase(NamedTension::paper).scheme, 3);
  const auto& batches = refinement.last().table.circulants;
  const auto formOfSides = [&](std::int32_t sides) {
    return std::find_if(batches.begin(), batches.end(), [&](const auto& batch) { return batch.sides == sides; })->form;
  };
  EXPECT_EQ(formOfSides(4), CirculantForm::quad) << "of its quads";
  EXPECT_EQ(formOfSides(6), CirculantForm::hexagon) << "of the vertices of level 1";
  EXPECT_EQ(formOfSides(8), CirculantForm::evenOdd) << "of its vertices";
}

}  // namespace
}  // namespace honeycomb::Test
