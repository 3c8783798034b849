#include "reference.h"

#include <algorithm>
#include <array>
#include <cfloat>
#include <cmath>

namespace honeycomb::VulkanTests {

namespace {

using Far::kProjectionBlock;
using Osd::BufferDescriptor;

// One component of the points of a buffer.
struct Component {
  const std::vector<float>& data;
  BufferDescriptor desc;
  int c;
  float operator[](std::int64_t point) const {
    return data[static_cast<std::size_t>(desc.offset + point * desc.stride + c)];
  }
};

struct WritableComponent {
  std::vector<float>& data;
  BufferDescriptor desc;
  int c;
  float& operator[](std::int64_t point) const {
    return data[static_cast<std::size_t>(desc.offset + point * desc.stride + c)];
  }
};

template <class Container>
auto at(const Container& values, std::int64_t i) {
  return values[static_cast<std::size_t>(i)];
}

void evenOddFace(const std::vector<float>& p, const float* form, std::vector<float>& out) {
  const std::size_t m = p.size() / 2;
  for (std::size_t i = 0; i < m; ++i) {
    float e = 0, o = 0;
    for (std::size_t k = 0; k < m; ++k) {
      const std::size_t j = (i + k) % m;
      const float evenTerm = form[k] * (p[j] + p[j + m]);
      const float oddTerm = form[m + k] * (p[j] - p[j + m]);
      e = k == 0 ? evenTerm : e + evenTerm;
      o = k == 0 ? oddTerm : i + k >= m ? o - oddTerm : o + oddTerm;
    }
    out[i] = e + o;
    out[i + m] = e - o;
  }
}

void directFace(const std::vector<float>& p, const float* row, std::vector<float>& out) {
  for (std::size_t i = 0; i < p.size(); ++i) {
    float sum = row[0] * p[i];
    for (std::size_t k = 1; k < p.size(); ++k) sum = sum + row[k] * p[(i + k) % p.size()];
    out[i] = sum;
  }
}

void quadFace(const std::vector<float>& p, const float* form, std::vector<float>& out) {
  const float s = form[0] * ((p[0] + p[2]) + (p[1] + p[3]));
  const std::array<float, 2> d{p[0] - p[2], p[1] - p[3]};
  const std::array<float, 2> o{form[1] * (d[0] + d[1]), form[1] * (d[1] - d[0])};
  out = {s + o[0], s + o[1], s - o[0], s - o[1]};
}

void hexagonFace(const std::vector<float>& p, const float* form, std::vector<float>& out) {
  const std::array<float, 3> q{p[0] + p[3], p[1] + p[4], p[2] + p[5]};
  const std::array<float, 3> d{p[0] - p[3], p[1] - p[4], p[2] - p[5]};
  const float s = form[0] * ((q[0] + q[1]) + q[2]);
  const std::array<float, 3> e{s - form[1] * q[2], s - form[1] * q[0], s - form[1] * q[1]};
  const std::array<float, 3> o{form[2] * (d[0] + d[1]), form[2] * (d[1] + d[2]), form[2] * (d[2] - d[0])};
  out = {e[0] + o[0], e[1] + o[1], e[2] + o[2], e[0] - o[0], e[1] - o[1], e[2] - o[2]};
}

void face(Far::CirculantForm which, const std::vector<float>& p, const float* form, std::vector<float>& out) {
  switch (which) {
    case Far::CirculantForm::direct:
      return directFace(p, form, out);
    case Far::CirculantForm::evenOdd:
      return evenOddFace(p, form, out);
    case Far::CirculantForm::quad:
      return quadFace(p, form, out);
    case Far::CirculantForm::hexagon:
      return hexagonFace(p, form, out);
  }
}

void circulant(const Far::LevelTable& table, const Far::CirculantBatch& batch, Component in, WritableComponent out) {
  const auto sides = static_cast<std::size_t>(batch.sides);
  std::vector<float> p(sides), result(sides);
  const float* form = table.weightsSingle.data() + batch.firstForm;
  for (std::int32_t g = 0; g < batch.faceCount; ++g) {
    const std::int64_t first = std::int64_t{g} * batch.sides;
    for (std::size_t i = 0; i < sides; ++i) {
      p[i] = in[at(table.indices, batch.firstIndex + first + static_cast<std::int64_t>(i))];
    }
    face(batch.form, p, form, result);
    for (std::size_t i = 0; i < sides; ++i) out[batch.firstOutput + first + static_cast<std::int64_t>(i)] = result[i];
  }
}

// sum of weights[k] * values[k] in blocks.
float blockedSum(std::size_t count, const auto& term) {
  float total = 0;
  for (std::size_t begin = 0; begin < count; begin += kProjectionBlock) {
    float sum = term(begin);
    for (std::size_t j = begin + 1; j < std::min<std::size_t>(count, begin + kProjectionBlock); ++j)
      sum = sum + term(j);
    total = begin == 0 ? sum : total + sum;
  }
  return total;
}

void projected(const Far::LevelTable& table, const Far::ProjectedFace& face, Component in, WritableComponent out) {
  const auto corners = static_cast<std::size_t>(face.corners);
  const auto outputs = static_cast<std::size_t>(face.outputs);
  const float* w = table.weightsSingle.data() + face.firstWeight;
  const float* x = w + 2 + 3 * corners;
  const auto point = [&](std::size_t j) {
    return in[at(table.indices, face.firstIndex + static_cast<std::int64_t>(j))];
  };
  std::array<float, 3> sums{};
  for (std::size_t s = 0; s < 3; ++s) {
    sums[s] = blockedSum(corners, [&](std::size_t j) { return w[2 + s * corners + j] * point(j); });
  }
  for (std::size_t i = 0; i < outputs; ++i) {
    const std::size_t a = (static_cast<std::size_t>(face.firstCorner) + i) % corners;
    float value = w[0] * point(a) + w[1] * point((a + 1) % corners);
    for (std::size_t s = 0; s < 3; ++s) value = value + x[s * outputs + i] * sums[s];
    out[face.firstOutput + static_cast<std::int64_t>(i)] = value;
  }
}

void dense(const Far::LevelTable& table, const Far::DenseRows& batch, Component in, WritableComponent out) {
  for (std::int64_t g = 0; g < batch.rowCount; ++g) {
    float sum = 0;
    for (std::int64_t j = 0; j < batch.width; ++j) {
      const float term = at(table.weightsSingle, batch.firstWeight + j) *
                         in[at(table.indices, batch.firstIndex + g * batch.width + j)];
      sum = j == 0 ? term : sum + term;
    }
    out[batch.firstOutput + g] = sum;
  }
}

void loose(const Far::LevelTable& table, Component in, WritableComponent out) {
  const Far::LooseRows& rows = table.loose;
  for (std::int32_t r = 0; r < rows.rowCount(); ++r) {
    float sum = 0;
    for (std::int32_t b = at(rows.offsets, r); b < at(rows.offsets, r + 1); ++b) {
      const float term = at(table.weightsSingle, rows.firstWeight + b) * in[at(table.indices, rows.firstIndex + b)];
      sum = b == at(rows.offsets, r) ? term : sum + term;
    }
    out[at(rows.outputs, r)] = sum;
  }
}

void summed(const Far::LevelTable& table, Component in, WritableComponent out) {
  const Far::SummedRows& rows = table.summed;
  std::vector<float> sums;
  for (const Far::ProjectedFace& face : rows.rowCount() > 0 ? table.projected : decltype(table.projected){}) {
    sums.push_back(blockedSum(static_cast<std::size_t>(face.corners), [&](std::size_t j) {
      const auto corner = static_cast<std::int64_t>(j);
      return at(table.weightsSingle, face.firstWeight + 2 + corner) * in[at(table.indices, face.firstIndex + corner)];
    }));
  }
  for (std::int32_t r = 0; r < rows.rowCount(); ++r) {
    std::vector<float> terms;
    for (std::int32_t b = at(rows.rows.offsets, r); b < at(rows.rows.offsets, r + 1); ++b) {
      terms.push_back(at(table.weightsSingle, rows.rows.firstWeight + b) *
                      in[at(table.indices, rows.rows.firstIndex + b)]);
    }
    for (std::int32_t t = at(rows.shareOffsets, r); t < at(rows.shareOffsets, r + 1); ++t) {
      terms.push_back(at(table.weightsSingle, rows.firstShare + t) * at(sums, at(rows.faces, t)));
    }
    float sum = terms.front();
    for (std::size_t i = 1; i < terms.size(); ++i) sum = sum + terms[i];
    out[at(rows.rows.outputs, r)] = sum;
  }
}

using Vector = std::array<float, 3>;

Vector unitNormal(const Vector& s, const Vector& t) {
  const Vector n = {(s[1] * t[2] - s[2] * t[1]) + 0.0F, (s[2] * t[0] - s[0] * t[2]) + 0.0F,
                    (s[0] * t[1] - s[1] * t[0]) + 0.0F};
  const float q = (n[0] * n[0] + n[1] * n[1]) + n[2] * n[2];
  if (!(q >= FLT_MIN) || !std::isfinite(q)) return {0, 0, 0};
  const float r = 1.0F / std::sqrt(q);
  return {n[0] * r, n[1] * r, n[2] * r};
}

}  // namespace

void evaluateLevel(const Far::LevelTable& table, const std::vector<float>& source, const BufferDescriptor& sourceDesc,
                   std::vector<float>& target, const BufferDescriptor& targetDesc) {
  for (int c = 0; c < sourceDesc.length; ++c) {
    const Component in{source, sourceDesc, c};
    const WritableComponent out{target, targetDesc, c};
    for (const auto& batch : table.circulants) circulant(table, batch, in, out);
    for (const auto& face : table.projected) {
      if (face.outputs > 0) projected(table, face, in, out);
    }
    for (const auto& batch : table.dense) dense(table, batch, in, out);
    summed(table, in, out);
    loose(table, in, out);
  }
}

void evaluateLimits(const Far::LimitRows& rows, const std::vector<float>& source, const BufferDescriptor& sourceDesc,
                    std::vector<float>& positions, const BufferDescriptor& positionDesc, std::vector<float>& normals,
                    const BufferDescriptor& normalDesc) {
  for (const Far::FrameBatch& batch : rows.batches) {
    const auto sides = static_cast<std::size_t>(batch.sides);
    const float* weights = rows.weightsSingle.data() + batch.firstWeight;
    for (std::int32_t g = 0; g < batch.count; ++g) {
      std::array<Vector, 3> frame{};
      for (int c = 0; c < 3; ++c) {
        const Component in{source, sourceDesc, c};
        for (std::size_t s = 0; s < 3; ++s) {
          frame[s][static_cast<std::size_t>(c)] = blockedSum(sides, [&](std::size_t j) {
            const std::int64_t index = batch.firstIndex + std::int64_t{g} * batch.sides + static_cast<std::int64_t>(j);
            return weights[s * sides + j] * in[at(rows.indices, index)];
          });
        }
      }
      const Vector normal = unitNormal(frame[1], frame[2]);
      const std::int32_t element = at(rows.elements, batch.firstElement + g);
      for (int c = 0; c < 3; ++c) {
        WritableComponent{positions, positionDesc, c}[element] = frame[0][static_cast<std::size_t>(c)];
        WritableComponent{normals, normalDesc, c}[element] = normal[static_cast<std::size_t>(c)];
      }
    }
  }
}

}  // namespace honeycomb::VulkanTests
