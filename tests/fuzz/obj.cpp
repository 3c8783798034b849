#include "io/obj.h"

#include <vector>

#include "tests/fuzz/read_mesh.h"

namespace honeycomb::Fuzz {

bool obj(Bytes bytes) {
  // A copy of exactly its size, so that the address sanitizer sees a read past its end.
  const std::vector<char> text(bytes.begin(), bytes.end());
  const Result<Io::Mesh> mesh = Io::parseObj({text.data(), text.size()}, "a.mesh");
  useMesh(mesh);
  return mesh.has_value();
}

}  // namespace honeycomb::Fuzz
