// Large faces, in three dispatches with a barrier after each, so that a face of any size is spread over the device:
//     projected_blocks   sums of kProjectionBlock corners each     blocks[(block*kLength + c)*3 + {S, C, D}]
//     projected_sums     the block sums of a face, in order        sums[(face*kLength + c)*3 + {S, C, D}]
//     projected          the outputs
struct ProjectedFace {
  uint corners;
  uint outputs;      // none: only S is wanted, and there are weights for it alone
  uint firstCorner;
  uint firstIndex;   // from push.firstIndex
  uint firstOutput;
  uint firstWeight;  // from push.firstWeight
  uint firstBlock;   // of the dispatch
  uint blockCount;
};
layout(set = 0, binding = 5, std430) restrict readonly buffer Records { ProjectedFace faces[]; };
