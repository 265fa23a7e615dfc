#include "stems/wood.hpp"

#include <algorithm>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <vector>

#include "foundation/vectors.hpp"
#include "mesh/normals.hpp"
#include "stems/twigs.hpp"

namespace panicle {
namespace {

constexpr std::uint32_t sides = 12, thin_sides = 6;
// The picture of bark lies half a metre across and a metre along a trunk (web/src/plant/wood/bark_picture.ts).
constexpr BarkScale bark_scale{.width = 0.5f, .height = 1};
// Axes thinner than this share of the thickest are thin; segments thinner than that share of the whole plant are twigs:
// where all of it is seen, they are a pixel or two wide.
constexpr float thin = 0.3f, fine_of_all = 0.002f;

// Repairs normals that look into the wood: where a branch leaves at a narrow angle, its first rings fold over each
// other and over the parent, which shows as black facets. Such vertices get the normals of their triangles. Ends of
// tubes, where one normal agrees, are as they should be.
void repair_normals(Mesh& mesh) {
  std::vector<std::uint8_t> opposed(mesh.positions.size() / 3, 0);
  bool any = false;
  for (std::size_t t = 0; t + 2 < mesh.indices.size(); t += 3) {
    const std::uint32_t* corners = &mesh.indices[t];
    const glm::vec3 face = triangle_normal(vector_at(mesh.positions, corners[0]), vector_at(mesh.positions, corners[1]),
                                           vector_at(mesh.positions, corners[2]));
    float sum = 0, most = 0;
    for (int k = 0; k < 3; ++k) {
      const float cosine = glm::dot(face, vector_at(mesh.normals, corners[k]));
      sum += cosine;
      most = std::max(most, cosine);
    }
    if (sum >= 0 || most > 0.5f * glm::length(face)) continue;
    for (int k = 0; k < 3; ++k) opposed[corners[k]] = 1;
    any = true;
  }
  if (!any) return;
  const std::vector<glm::vec3> sums = sum_normals(mesh);
  for (std::size_t v = 0; v < opposed.size(); ++v) {
    const float length = glm::length(sums[v]);
    if (!opposed[v] || !(length > 0)) continue;
    for (int k = 0; k < 3; ++k) mesh.normals[3 * v + static_cast<std::size_t>(k)] = sums[v][k] / length;
  }
}

// The swept segments: without twigs, and with the pieces of trunk bases; for each the index in the whole plant, and the
// axis.
struct Branches {
  std::vector<Segment> segments;
  std::vector<std::int32_t> groups;
  std::vector<std::uint32_t> whole;
};

// Collects the segments whose radius is at least `fine`, and replaces those of `bases` by their base_pieces.
Branches branches_of(std::span<const Segment> segments, std::span<const std::int32_t> axes,
                     std::span<const std::int32_t> bases, const RootFlareOptions& options, float fine) {
  Branches found;
  std::vector<std::int32_t> numbers(segments.size(), -1);
  const auto add = [&](const Segment& segment, std::int32_t parent, std::size_t whole) {
    found.segments.push_back(segment);
    found.segments.back().parent = parent;
    found.groups.push_back(axes[whole]);
    found.whole.push_back(static_cast<std::uint32_t>(whole));
    return static_cast<std::int32_t>(found.segments.size()) - 1;
  };
  for (std::size_t i = 0; i < segments.size(); ++i) {
    if (segments[i].radius < fine) continue;
    const std::int32_t parent = segments[i].parent;
    std::int32_t last = parent >= 0 ? numbers[static_cast<std::size_t>(parent)] : -1;
    if (std::find(bases.begin(), bases.end(), static_cast<std::int32_t>(i)) == bases.end()) {
      numbers[i] = add(segments[i], last, i);
      continue;
    }
    for (const Segment& piece : base_pieces(segments[i], options)) last = add(piece, last, i);
    numbers[i] = last;
  }
  return found;
}

}  // namespace

// Builds the mesh of a woody plant: tubes, flared trunks at the targets, and thin twigs.
StemMesh sweep_wood(std::span<const Segment> segments, std::span<const std::int32_t> axes,
                    std::span<const glm::vec3> targets, const RootFlareOptions& flare) {
  float thickest = 0;
  glm::vec3 low(0), high(0);
  for (const Segment& segment : segments) {
    thickest = std::max(thickest, segment.radius);
    low = glm::min(low, segment.end);
    high = glm::max(high, segment.end);
  }
  const glm::vec3 size = high - low;
  const float fine = fine_of_all * std::max({size.x, size.y, size.z});
  const std::vector<std::int32_t> bases = trunk_bases(segments, targets);
  const Branches branches = branches_of(segments, axes, bases, flare, fine);
  // Stems are thinner from fork to fork: every parent of branches is one. Wood does not swell where its pieces meet.
  std::vector<RootFlare> flares;
  for (const std::int32_t base : bases) {
    if (base < 0 || !flare.standing) continue;
    const auto whole = static_cast<std::uint32_t>(base);
    const auto number = std::find(branches.whole.begin(), branches.whole.end(), whole) - branches.whole.begin();
    flares.push_back(root_flare_of(segments[whole], static_cast<std::uint32_t>(number), flare));
  }
  const BarkScale bark = flare.standing ? bark_scale : BarkScale{};
  const TubeOptions options{.sides = sides,
                            .thin = thin * thickest,
                            .thin_sides = thin_sides,
                            .thin_plain = true,
                            .collars = true,
                            .bark = bark,
                            .flares = flares};
  StemMesh stems = sweep_stems(
      {.segments = branches.segments, .groups = branches.groups, .jointed = false, .tapering = true}, options, 1.0f);
  for (std::uint32_t& segment : stems.segment) segment = branches.whole[segment];
  repair_normals(stems.mesh);
  add_twigs(stems, segments, axes, fine, bark);
  return stems;
}

}  // namespace panicle
