#include "tests/support/mesh_edit.h"

#include <algorithm>

#include "tests/support/manifold_check.h"

namespace honeycomb::Test {
namespace {

/// The loop from position i to position j (inclusive), going forward.
Loop arc(const Loop& loop, std::size_t i, std::size_t j) {
  Loop result;
  for (std::size_t k = i;; k = (k + 1) % loop.size()) {
    result.push_back(loop[k]);
    if (k == j) return result;
  }
}

/// The position of v in the loop, or its size.
std::size_t positionOf(const Loop& loop, std::size_t v) {
  return static_cast<std::size_t>(std::find(loop.begin(), loop.end(), v) - loop.begin());
}

/// Is a -> b an edge of the loop? `position` receives that of a.
bool runsAlong(const Loop& loop, std::size_t a, std::size_t b, std::size_t& position) {
  position = positionOf(loop, a);
  return position < loop.size() && loop[(position + 1) % loop.size()] == b;
}

}  // namespace

bool MeshEdit::accept(std::vector<Loop> faces) {
  for (const Loop& loop : faces) {
    if (loop.size() > maxSides_) return false;
  }
  if (faces.empty() || !isManifold(faces)) return false;
  faces_ = std::move(faces);
  return true;
}

std::vector<Loop> MeshEdit::without(std::size_t f) const {
  std::vector<Loop> faces = faces_;
  faces.erase(faces.begin() + static_cast<std::ptrdiff_t>(f));
  return faces;
}

bool MeshEdit::splitFace(Random& random) {
  const std::size_t f = random.below(faces_.size());
  const Loop loop = faces_[f];
  if (loop.size() < 4) return false;
  const std::size_t i = random.below(loop.size());
  const std::size_t j = (i + random.between(2, loop.size() - 2)) % loop.size();
  std::vector<Loop> faces = faces_;
  faces[f] = arc(loop, i, j);
  faces.push_back(arc(loop, j, i));
  return accept(std::move(faces));
}

bool MeshEdit::splitEdge(Random& random) {
  const Loop& loop = faces_[random.below(faces_.size())];
  const std::size_t i = random.below(loop.size());
  const std::size_t a = loop[i];
  const std::size_t b = loop[(i + 1) % loop.size()];
  std::vector<Loop> faces = faces_;
  for (Loop& face : faces) {
    std::size_t p = 0;
    if (runsAlong(face, a, b, p) || runsAlong(face, b, a, p)) {
      face.insert(face.begin() + static_cast<std::ptrdiff_t>(p) + 1, nextVertex_);
    }
  }
  if (!accept(std::move(faces))) return false;
  ++nextVertex_;
  return true;
}

bool MeshEdit::deleteEdge(Random& random) {
  const std::size_t f = random.below(faces_.size());
  const Loop& loop = faces_[f];
  const std::size_t i = random.below(loop.size());
  const std::size_t j = (i + 1) % loop.size();
  for (std::size_t g = 0; g < faces_.size(); ++g) {
    std::size_t p = 0;
    if (g == f || !runsAlong(faces_[g], loop[j], loop[i], p)) continue;
    const Loop& other = faces_[g];
    Loop merged = arc(loop, j, i);
    const Loop rest = arc(other, (p + 1) % other.size(), p);
    merged.insert(merged.end(), rest.begin() + 1, rest.end() - 1);
    std::vector<Loop> faces = without(std::max(f, g));
    faces[std::min(f, g)] = std::move(merged);
    return accept(std::move(faces));
  }
  return false;
}

bool MeshEdit::collapseEdge(Random& random) {
  const Loop& loop = faces_[random.below(faces_.size())];
  const std::size_t i = random.below(loop.size());
  const std::size_t keep = loop[i];
  const std::size_t gone = loop[(i + 1) % loop.size()];
  std::vector<Loop> faces;
  for (Loop face : faces_) {
    std::replace(face.begin(), face.end(), gone, keep);
    face.erase(std::unique(face.begin(), face.end()), face.end());
    if (face.size() > 1 && face.front() == face.back()) face.pop_back();
    if (face.size() > 2) faces.push_back(std::move(face));
  }
  return accept(std::move(faces));
}

bool MeshEdit::kisFace(Random& random) {
  const std::size_t f = random.below(faces_.size());
  const Loop loop = faces_[f];
  if (loop.size() > 16) return false;
  std::vector<Loop> faces = without(f);
  for (std::size_t i = 0; i < loop.size(); ++i) {
    faces.push_back({loop[i], loop[(i + 1) % loop.size()], nextVertex_});
  }
  if (!accept(std::move(faces))) return false;
  ++nextVertex_;
  return true;
}

bool MeshEdit::glueHandle(Random& random) {
  const std::size_t f = random.below(faces_.size());
  const std::size_t g = random.below(faces_.size());
  const Loop a = faces_[f];
  const Loop b = faces_[g];
  const std::size_t n = a.size();
  if (f == g || n != b.size()) return false;
  std::vector<Loop> faces;
  for (std::size_t k = 0; k < faces_.size(); ++k) {
    if (k != f && k != g) faces.push_back(faces_[k]);
  }
  const std::size_t twist = random.below(n);
  for (std::size_t i = 0; i < n; ++i) {
    faces.push_back({a[i], a[(i + 1) % n], b[(2 * n - i - 1 + twist) % n], b[(2 * n - i + twist) % n]});
  }
  return accept(std::move(faces));
}

bool MeshEdit::removeFace(Random& random) {
  return accept(without(random.below(faces_.size())));
}

bool MeshEdit::any(Random& random) {
  switch (random.below(5)) {
    case 0:
      return splitFace(random);
    case 1:
      return splitEdge(random);
    case 2:
      return deleteEdge(random);
    case 3:
      return collapseEdge(random);
    default:
      return kisFace(random);
  }
}

}  // namespace honeycomb::Test
