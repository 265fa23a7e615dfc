#include "stems/tubes.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>
#include <utility>

#include "foundation/fingerprint.hpp"
#include "foundation/mathematics.hpp"
#include "foundation/random.hpp"
#include "mesh/surface.hpp"

using namespace panicle;
using namespace panicle::test;

namespace {

constexpr StemEnd flared{.flare = 0.35f, .height = 0.35f};
constexpr StemEnd shrunk{.body = 0.75f, .tip = 0.5f, .height = 0.7f};

struct Skeleton {
  std::vector<Segment> segments;
  std::vector<std::int32_t> groups;
  std::vector<StemEnd> ends;

  void add(std::int32_t parent, std::int32_t group, glm::vec3 start, glm::vec3 end, float radius = 7,
           StemEnd shape = {}) {
    segments.push_back({parent, 0, start, end, radius, radius * 0.98f});
    groups.push_back(group);
    ends.push_back(shape);
  }
  StemMesh swept(const TubeOptions& options, float scale) const {
    return sweep_stems({segments, groups, ends}, options, scale);
  }
  std::size_t size() const { return segments.size(); }
};

// A stem with two branches; it and the first branch end in a fork whose twigs are flared, one of them shrunk.
Skeleton small_panicle() {
  Skeleton panicle;
  panicle.add(-1, -1, {0, 0, 0}, {0, -50, 0});
  panicle.add(0, -1, {0, -50, 0}, {2, -100, 0});
  panicle.add(1, -1, {2, -100, 0}, {2, -130, 1});
  panicle.add(2, -1, {2, -130, 1}, {2, -175, 1}, 6, flared);
  panicle.add(2, -1, {2, -130, 1}, {40, -152, 1}, 6, flared);
  panicle.add(2, -1, {2, -130, 1}, {-6, -136, 1}, 6, shrunk);
  panicle.add(0, 0, {0, -50, 0}, {43, -75, 0}, 6.5f);
  panicle.add(6, 0, {43, -75, 0}, {70, -90, 0}, 6);
  panicle.add(7, 0, {70, -90, 0}, {110, -110, 0}, 5.5f, flared);
  panicle.add(1, 1, {2, -100, 0}, {-40, -120, 0}, 5, flared);
  return panicle;
}

// Any skeleton at all: wild turns, segments without length, thin, thick, detached, from near the origin to far away.
Skeleton random_skeleton(std::uint64_t seed) {
  Skeleton skeleton;
  const auto unit = [&](std::uint64_t stream, std::uint64_t i) { return random_unit(seed, stream, i); };
  const std::uint64_t count = 1 + static_cast<std::uint64_t>(random_integer(seed, 1, 0, 0, 60));
  const float unit_length = 50 * power(10, static_cast<float>(random_integer(seed, 1, 1, -4, 3)));
  const glm::vec3 middle = unit(1, 2) < 0.2f ? glm::vec3(40 * unit_length) : glm::vec3(0);
  for (std::uint64_t i = 0; i < count; ++i) {
    Segment next;
    next.parent =
        random_integer(seed, 2, i, i > 8 ? static_cast<std::int32_t>(i) - 8 : -1, static_cast<std::int32_t>(i) - 1);
    const bool stub = random_integer(seed, 3, i, 0, 3) < 3;
    const StemEnd fruiting = unit(4, i) < 0.3f ? shrunk : flared;
    next.start = next.parent < 0 ? middle : skeleton.segments[static_cast<std::size_t>(next.parent)].end;
    if (unit(6, i) < 0.05f) next.start += random_direction(seed, 7, i) * unit_length;
    const float lengths[] = {1, 1, 0.6f, 0.1f, 1e-3f, 1e-6f, 0};
    const float length = unit_length * lengths[random_integer(seed, 8, i, 0, 6)];
    next.end = next.start + random_direction(seed, 9, i) * length;
    const float radii[] = {0.15f, 0.15f, 0.1f, 0.5f, 1e-3f, 0};
    next.radius = unit_length * radii[random_integer(seed, 10, i, 0, 5)];
    next.radius_end = next.radius * (0.5f + unit(11, i));
    skeleton.segments.push_back(next);
    skeleton.groups.push_back(random_integer(seed, 5, i / 6, -1, 4));
    skeleton.ends.push_back(stub ? StemEnd{} : fruiting);
  }
  return skeleton;
}

void check_stems(const StemMesh& stem, std::size_t segments) {
  check_sound(stem.mesh);
  REQUIRE(stem.segment.size() == stem.mesh.positions.size() / 3);
  CHECK(std::all_of(stem.segment.begin(), stem.segment.end(), [&](std::uint32_t i) { return i < segments; }));
  std::uint32_t vertex = 0, index = 0;
  for (std::size_t p = 0; p < stem.parts.size(); ++p) {
    const StemPart& part = stem.parts[p];
    CHECK(part.first_vertex == vertex);
    CHECK(part.first_index == index);
    CHECK(part.index_count > 0);
    if (p > 0) CHECK(part.group > stem.parts[p - 1].group);
    const auto first = stem.mesh.indices.begin() + index;
    CHECK(std::all_of(first, first + part.index_count,
                      [&](std::uint32_t i) { return i >= vertex && i < vertex + part.vertex_count; }));
    vertex += part.vertex_count;
    index += part.index_count;
  }
  CHECK(vertex == stem.segment.size());
  CHECK(index == stem.mesh.indices.size());
}

// First index of every tube, and the end: indices of a tube begin at its first pole, where none before it reach.
std::vector<std::size_t> tubes_of(const StemMesh& stem) {
  std::vector<std::size_t> first = {0};
  std::uint32_t furthest = stem.mesh.indices.empty() ? 0 : stem.mesh.indices[0];
  for (std::size_t t = 0; t < stem.mesh.indices.size(); t += 3) {
    const auto* corner = &stem.mesh.indices[t];
    if (t > 0 && std::min({corner[0], corner[1], corner[2]}) > furthest) first.push_back(t);
    furthest = std::max({furthest, corner[0], corner[1], corner[2]});
  }
  first.push_back(stem.mesh.indices.size());
  return first;
}

void check_tubes_closed(const StemMesh& stem) {
  const std::vector<std::size_t> first = tubes_of(stem);
  for (std::size_t i = 0; i + 1 < first.size(); ++i) {
    CHECK(surface_of(stem.mesh, first[i], first[i + 1] - first[i]).open_edges == 0);
  }
}

constexpr TubeOptions twelve{12};

}  // namespace

TEST_CASE("a straight segment is one closed tube of about a cylinder's volume, from end to end") {
  const Segment segment{-1, 0, {0, 0, 0}, {0, -100, 0}, 5, 5};
  const StemMesh stem = sweep_stems({{&segment, 1}}, {64}, 0.00025f);
  check_stems(stem, 1);
  check_tubes_closed(stem);
  CHECK(share_turned(stem.mesh) == 0);
  REQUIRE(stem.parts.size() == 1);
  const double cylinder = 3.14159265 * 25 * 100 * 0.00025 * 0.00025 * 0.00025;
  CHECK(surface_of(stem.mesh, 0, stem.mesh.indices.size()).volume == doctest::Approx(cylinder * 0.9).epsilon(0.1));
  float top = -1, bottom = 1, furthest = 0;
  for (std::size_t i = 0; i < stem.mesh.positions.size(); i += 3) {
    top = std::max(top, stem.mesh.positions[i + 1]);
    bottom = std::min(bottom, stem.mesh.positions[i + 1]);
    furthest = std::max(furthest, std::hypot(stem.mesh.positions[i], stem.mesh.positions[i + 2]));
  }
  CHECK(top > 0);
  CHECK(top < 2.5f * 0.00025f);
  CHECK(bottom < -100 * 0.00025f);
  CHECK(bottom > -103 * 0.00025f);
  CHECK(furthest < 6.5f * 0.00025f);
}

TEST_CASE("an axis is one tube; each branch, and each twig beside the middle one, is another") {
  const Skeleton panicle = small_panicle();
  const StemMesh stem = panicle.swept(twelve, 0.00025f);
  check_stems(stem, panicle.size());
  check_tubes_closed(stem);
  CHECK(share_turned(stem.mesh) < 0.01);
  REQUIRE(stem.parts.size() == 3);
  CHECK(stem.parts[0].group == -1);
  CHECK(stem.parts[1].group == 0);
  CHECK(stem.parts[2].group == 1);
  CHECK(tubes_of(stem).size() - 1 == 3 + 1 + 1);  // the stem with its middle twig, two beside it; a branch; a lone twig
  CHECK(std::set<std::uint32_t>(stem.segment.begin(), stem.segment.end()).size() == panicle.size());
}

TEST_CASE("vertices are near their segment") {
  const Skeleton panicle = small_panicle();
  const StemMesh stem = panicle.swept(twelve, 1);
  for (std::uint32_t i = 0; i < stem.segment.size(); ++i) {
    const Segment& near = panicle.segments[stem.segment[i]];
    const glm::dvec3 p = position_of(stem.mesh, i), a = near.start, b = near.end;
    const double along = std::clamp(glm::dot(p - a, b - a) / glm::dot(b - a, b - a), 0.0, 1.0);
    CHECK(glm::length(p - (a + (b - a) * along)) < 2.2 * near.radius);
  }
}

TEST_CASE("jointed stems swell at their joints, others are as thick as their segments") {
  Skeleton chain;
  for (int i = 0; i < 5; ++i) {
    const auto at = static_cast<float>(i);
    chain.add(i - 1, 0, {0, -50 * at, 0}, {0, -50 * (at + 1), 0}, 7);
    chain.segments.back().radius_end = 7;
  }
  const auto extent = [&](bool jointed) {
    const StemMesh stem = sweep_stems({.segments = chain.segments, .jointed = jointed}, twelve, 1);
    float least = 100, most = 0;
    for (std::size_t i = 0; i < stem.mesh.positions.size(); i += 3) {
      const float height = stem.mesh.positions[i + 1];
      if (height > -30 || height < -230) continue;  // where it stands and where it ends it is rounded
      const float radius = std::hypot(stem.mesh.positions[i], stem.mesh.positions[i + 2]);
      least = std::min(least, radius);
      most = std::max(most, radius);
    }
    return std::pair(least, most);
  };
  CHECK(extent(true).first < 0.9f * extent(true).second);
  CHECK(extent(false).first == doctest::Approx(7).epsilon(1e-4));
  CHECK(extent(false).second == doctest::Approx(7).epsilon(1e-4));
}

TEST_CASE("an axis ends in the shape of its StemEnd") {
  const Segment twig{-1, 0, {0, 0, 0}, {0, -60, 0}, 5, 5};
  const auto widest_below = [&](float y, const StemEnd& end) {
    const StemMesh stem = sweep_stems({{&twig, 1}, {}, {&end, 1}}, twelve, 1);
    float widest = 0;
    for (std::size_t i = 0; i < stem.mesh.positions.size(); i += 3) {
      if (stem.mesh.positions[i + 1] > y) continue;
      widest = std::max(widest, std::hypot(stem.mesh.positions[i], stem.mesh.positions[i + 2]));
    }
    return widest;
  };
  CHECK(widest_below(-55, flared) > 6);
  CHECK(widest_below(-55, shrunk) < 4);
  CHECK(widest_below(-55, {}) == doctest::Approx(5).epsilon(0.15));
  // A rounded end has the height that is set.
  const auto lowest = [&](const StemEnd& end) {
    const Mesh mesh = sweep_stems({{&twig, 1}, {}, {&end, 1}}, twelve, 1).mesh;
    float y = 0;
    for (std::size_t i = 1; i < mesh.positions.size(); i += 3) y = std::min(y, mesh.positions[i]);
    return y;
  };
  CHECK(lowest({.height = 0.5f}) == doctest::Approx(-62.5).epsilon(0.005));
  CHECK(lowest({.height = 2}) == doctest::Approx(-70).epsilon(0.005));
}

TEST_CASE("a branch begins within its parent and spreads at the parent's surface") {
  Skeleton skeleton;
  skeleton.add(-1, -1, {0, 0, 0}, {0, -50, 0}, 7);
  skeleton.add(0, -1, {0, -50, 0}, {0, -100, 0}, 7);
  skeleton.add(0, 0, {0, -50, 0}, {50, -50, 0}, 4);
  const StemMesh stem = skeleton.swept(twelve, 1);
  const StemPart& branch = stem.parts.at(1);
  double agreement = 1;
  std::uint32_t at_surface = 0;
  float hidden = 100, height_near = 0, height_far = 0;
  for (std::uint32_t i = branch.first_vertex; i < branch.first_vertex + branch.vertex_count; ++i) {
    const glm::dvec3 p = position_of(stem.mesh, i);
    const float height = static_cast<float>(std::fabs(p.y + 50));
    hidden = std::min(hidden, static_cast<float>(p.x));
    // Where it comes out, it is shaded as its parent is: no edge shows between them.
    const glm::dvec3 out = glm::normalize(glm::dvec3(p.x, 0, p.z));
    if (std::hypot(p.x, p.z) > 5 && std::hypot(p.x, p.z) < 9) {
      agreement = std::min(agreement, glm::dot(out, normal_of(stem.mesh, i)));
      ++at_surface;
    }
    if (p.x < 0) CHECK(std::hypot(p.x, p.z) < 6.9);
    if (p.x > 6 && p.x < 9) height_near = std::max(height_near, height);
    if (p.x > 25 && p.x < 35) height_far = std::max(height_far, height);
  }
  CHECK(hidden < 0);
  CHECK(at_surface >= 6);
  CHECK(agreement > 0.8);
  CHECK(height_near > 1.12f * height_far);
}

TEST_CASE("texture: u once round, v one unit to a circumference") {
  const Segment segment{-1, 0, {0, 0, 0}, {0, -200, 0}, 5, 5};
  const StemMesh stem = sweep_stems({{&segment, 1}}, twelve, 1);
  float max_v = 0;
  for (std::size_t i = 0; i < stem.mesh.uvs.size(); i += 2) {
    REQUIRE(stem.mesh.uvs[i] >= 0);
    REQUIRE(stem.mesh.uvs[i] <= 1);
    REQUIRE(stem.mesh.uvs[i + 1] >= 0);
    max_v = std::max(max_v, stem.mesh.uvs[i + 1]);
  }
  CHECK(max_v == doctest::Approx(200 / (2 * 3.14159265 * 5)).epsilon(0.06));
}

TEST_CASE("sides are clamped to 3 … 64; no segments make no mesh") {
  const Skeleton panicle = small_panicle();
  CHECK(panicle.swept({0}, 1).mesh.positions == panicle.swept({3}, 1).mesh.positions);
  CHECK(panicle.swept({9999}, 1).mesh.positions == panicle.swept({64}, 1).mesh.positions);
  const StemMesh none = sweep_stems({}, twelve, 1);
  CHECK(none.parts.empty());
  CHECK(none.mesh.indices.empty());
}

TEST_CASE("segments without length, reversals and values that are not finite give a valid mesh") {
  const float nan = std::numeric_limits<float>::quiet_NaN();
  const float infinity = std::numeric_limits<float>::infinity();
  Skeleton skeleton;
  skeleton.add(-1, -1, {0, 0, 0}, {0, -50, 0});
  skeleton.add(0, -1, {0, -50, 0}, {0, -50, 0});
  skeleton.add(1, -1, {0, -50, 0}, {0, -50.00001f, 0});
  skeleton.add(2, -1, {0, -50, 0}, {3, -1, 0});   // straight back
  skeleton.add(3, -1, {3, -1, 0}, {50, -30, 0});  // by 125°
  skeleton.add(4, 0, {50, -30, 0}, {nan, 0, 0});
  skeleton.add(5, 0, {60, -30, 0}, {100, -30, 0});
  skeleton.add(6, 0, {100, -30, 0}, {infinity, 0, 0});
  skeleton.add(6, 0, {100, -30, 0}, {130, -30, 0}, 0, flared);
  skeleton.add(8, 0, {130, -30, 0}, {130, -60, 0}, nan, flared);
  skeleton.add(99, 1, {0, 0, 0}, {0, 30, 0});
  skeleton.add(11, 1, {0, 0, 0}, {0, 0, 30});
  skeleton.add(-1, 1, {3e30f, 0, 0}, {0, 0, 30});
  const StemMesh stem = skeleton.swept(twelve, 0.00025f);
  check_stems(stem, skeleton.size());
  check_tubes_closed(stem);
  CHECK(stem.parts.size() == 3);
}

TEST_CASE("random skeletons give closed, valid tubes") {
  double worst_turned = 0;
  std::size_t tubes = 0;
  for (std::uint64_t seed = 0; seed < 150; ++seed) {
    CAPTURE(seed);
    const Skeleton skeleton = random_skeleton(seed);
    const std::uint32_t sides = static_cast<std::uint32_t>(random_integer(seed, 20, 0, 3, 20));
    const StemMesh stem = skeleton.swept({sides}, 0.00025f);
    check_stems(stem, skeleton.size());
    check_tubes_closed(stem);
    worst_turned = std::max(worst_turned, share_turned(stem.mesh));
    tubes += tubes_of(stem).size() - 1;
  }
  CHECK(tubes > 1500);
  CHECK(worst_turned < 0.5);
}

TEST_CASE("thin axes get fewer sides and rings at the same place; thick ones do not change") {
  Skeleton skeleton;
  skeleton.add(-1, -1, {0, 0, 0}, {0, -100, 0}, 5);
  skeleton.add(0, 0, {0, -50, 0}, {40, -60, 0}, 1, flared);
  TubeOptions options{12};
  const StemMesh fine = skeleton.swept(options, 1);
  options.thin = 2;
  options.thin_sides = 5;
  const StemMesh thin = skeleton.swept(options, 1);
  check_stems(thin, skeleton.size());
  check_tubes_closed(thin);
  REQUIRE(thin.parts.size() == 2);
  CHECK(thin.parts[0].vertex_count == fine.parts[0].vertex_count);
  CHECK(std::equal(fine.mesh.positions.begin(), fine.mesh.positions.begin() + 3 * fine.parts[0].vertex_count,
                   thin.mesh.positions.begin()));
  CHECK(thin.parts[1].index_count * 3 < fine.parts[1].index_count);
  const auto volume = [](const StemMesh& stem) {
    return surface_of(stem.mesh, stem.parts[1].first_index, stem.parts[1].index_count).volume;
  };
  // A pentagon has three quarters of its circle, twelve sides have 95 %.
  CHECK(volume(thin) / volume(fine) == doctest::Approx(0.757 / 0.955).epsilon(0.06));
  const auto reach = [](const StemMesh& stem, std::size_t axis) {
    float most = 0;
    for (std::size_t i = axis; i < stem.mesh.positions.size(); i += 3) most = std::max(most, stem.mesh.positions[i]);
    return most;
  };
  CHECK(reach(thin, 0) == doctest::Approx(reach(fine, 0)).epsilon(0.01));
}

TEST_CASE("scale only scales, and the same skeleton gives the same bytes") {
  const Skeleton panicle = small_panicle();
  const StemMesh one = panicle.swept(twelve, 1);
  const StemMesh half = panicle.swept(twelve, 0.5f);
  REQUIRE(one.mesh.positions.size() == half.mesh.positions.size());
  CHECK(std::equal(one.mesh.positions.begin(), one.mesh.positions.end(), half.mesh.positions.begin(),
                   [](float whole, float scaled) { return whole * 0.5f == scaled; }));
  CHECK(one.mesh.normals == half.mesh.normals);
  CHECK(one.mesh.uvs == half.mesh.uvs);
  CHECK(panicle.swept(twelve, 1).mesh.positions == one.mesh.positions);
}

TEST_CASE("a skeleton too large for smooth tubes gets fewer sides, then fewer rings") {
  Skeleton skeleton;
  for (std::int32_t i = 0; i < 400; ++i) {
    const glm::vec3 start(static_cast<float>(i % 20) * 60, static_cast<float>(i / 20) * 60, 0);
    skeleton.add(-1, -1, start, start + glm::vec3(0, 50, 0));
  }
  std::size_t before = 1000000;
  for (const std::uint64_t most : {100000, 50000, 30000, 14000}) {
    const StemMesh stem = skeleton.swept({12, most}, 1);
    check_sound(stem.mesh);
    CHECK(stem.segment.size() <= most);
    CHECK(stem.segment.size() < before);
    before = stem.segment.size();
  }
}

TEST_CASE("the mesh of a fixed skeleton does not change") {
  const StemMesh stem = small_panicle().swept(twelve, 0.00025f);
  CHECK(stem.segment.size() == 1310);
  CHECK(stem.mesh.indices.size() / 3 == 2400);
  CHECK(surface_of(stem.mesh, 0, stem.parts[0].index_count).volume * 1e9 == doctest::Approx(423.724).epsilon(1e-4));
  Fingerprint fingerprint;  // changes when tubes are shaped anew, never between toolchains
  fingerprint.add(std::span<const float>(stem.mesh.positions));
  fingerprint.add(std::span<const float>(stem.mesh.normals));
  fingerprint.add(std::span<const float>(stem.mesh.uvs));
  fingerprint.add(std::span<const std::uint32_t>(stem.mesh.indices));
  CHECK(fingerprint.value() == 0xc75f10e8506e3b3cu);
}
