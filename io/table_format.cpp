#include "io/table_format.h"

#include <algorithm>

namespace honeycomb::Io {

namespace {

struct ArrayName {
  TableArray array;
  std::string_view name;
};

constexpr std::array kArrayNames{ArrayName{TableArray::info, "info"},
                                 ArrayName{TableArray::steps, "steps"},
                                 ArrayName{TableArray::primvars, "primvars"},
                                 ArrayName{TableArray::faceOffsets, "faceOffsets"},
                                 ArrayName{TableArray::faceVertices, "faceVertices"},
                                 ArrayName{TableArray::faceOrigins, "faceOrigins"},
                                 ArrayName{TableArray::triangles, "triangles"},
                                 ArrayName{TableArray::lines, "lines"},
                                 ArrayName{TableArray::levelCounts, "levelCounts"},
                                 ArrayName{TableArray::circulants, "circulants"},
                                 ArrayName{TableArray::projected, "projected"},
                                 ArrayName{TableArray::dense, "dense"},
                                 ArrayName{TableArray::looseOutputs, "looseOutputs"},
                                 ArrayName{TableArray::looseOffsets, "looseOffsets"},
                                 ArrayName{TableArray::summedOutputs, "summedOutputs"},
                                 ArrayName{TableArray::summedOffsets, "summedOffsets"},
                                 ArrayName{TableArray::shareOffsets, "shareOffsets"},
                                 ArrayName{TableArray::shareFaces, "shareFaces"},
                                 ArrayName{TableArray::indices, "indices"},
                                 ArrayName{TableArray::weights, "weights"},
                                 ArrayName{TableArray::weightsSingle, "weightsSingle"},
                                 ArrayName{TableArray::limitCounts, "limitCounts"},
                                 ArrayName{TableArray::limitBatches, "limitBatches"},
                                 ArrayName{TableArray::limitElements, "limitElements"},
                                 ArrayName{TableArray::limitIndices, "limitIndices"},
                                 ArrayName{TableArray::limitWeights, "limitWeights"},
                                 ArrayName{TableArray::limitWeightsSingle, "limitWeightsSingle"},
                                 ArrayName{TableArray::tileCounts, "tileCounts"},
                                 ArrayName{TableArray::tilePointCount, "tilePointCount"},
                                 ArrayName{TableArray::tiles, "tiles"},
                                 ArrayName{TableArray::tileSteps, "tileSteps"},
                                 ArrayName{TableArray::tileStages, "tileStages"},
                                 ArrayName{TableArray::tileImports, "tileImports"},
                                 ArrayName{TableArray::tileIndices, "tileIndices"},
                                 ArrayName{TableArray::tileRows, "tileRows"},
                                 ArrayName{TableArray::tileOutputs, "tileOutputs"},
                                 ArrayName{TableArray::tileWritten, "tileWritten"},
                                 ArrayName{TableArray::tileWeights, "tileWeights"},
                                 ArrayName{TableArray::tileWeightsSingle, "tileWeightsSingle"},
                                 ArrayName{TableArray::sharedFirst, "sharedFirst"},
                                 ArrayName{TableArray::sharedWritten, "sharedWritten"},
                                 ArrayName{TableArray::normalTiles, "normalTiles"},
                                 ArrayName{TableArray::normalImports, "normalImports"},
                                 ArrayName{TableArray::normalFrames, "normalFrames"},
                                 ArrayName{TableArray::normalIndices, "normalIndices"},
                                 ArrayName{TableArray::normalFirstFace, "normalFirstFace"},
                                 ArrayName{TableArray::normalFaces, "normalFaces"},
                                 ArrayName{TableArray::normalBorn, "normalBorn"},
                                 ArrayName{TableArray::normalWeights, "normalWeights"},
                                 ArrayName{TableArray::normalWeightsSingle, "normalWeightsSingle"},
                                 ArrayName{TableArray::normalSharedOffsets, "normalSharedOffsets"},
                                 ArrayName{TableArray::normalSharedFaces, "normalSharedFaces"},
                                 ArrayName{TableArray::exactTiles, "exactTiles"},
                                 ArrayName{TableArray::exactFrames, "exactFrames"},
                                 ArrayName{TableArray::exactIndices, "exactIndices"},
                                 ArrayName{TableArray::exactWeights, "exactWeights"},
                                 ArrayName{TableArray::exactWeightsSingle, "exactWeightsSingle"},
                                 ArrayName{TableArray::exactRingTiles, "exactRingTiles"},
                                 ArrayName{TableArray::exactRings, "exactRings"},
                                 ArrayName{TableArray::exactWindows, "exactWindows"}};

}  // namespace

std::string_view arrayName(std::uint32_t kind) {
  const auto found = std::ranges::find(kArrayNames, static_cast<TableArray>(kind), &ArrayName::array);
  return found == kArrayNames.end() ? std::string_view{} : found->name;
}

}  // namespace honeycomb::Io
