#include "generalized_map/embedding.hpp"

#include <algorithm>

#include "generalized_map/cells.hpp"

namespace panicle::generalized_map {

// Prepares the embedding of a map in space: numbers the vertices, and sorts the volumes so that each is placed after
// its parent.
void Embedding::build(const Map& map) {
  Orbits vertices = orbits_of(map, of_cell(0));
  vertex_of_ = std::move(vertices.of_dart);
  places_.assign(vertices.count, glm::vec3(0));
  proposals_.assign(vertices.count, 0);
  frames_.assign(map.volumes(), {});
  base_centres_.assign(map.volumes(), glm::vec3(0));
  placements_.clear();
  corners_.clear();
  supports_.clear();

  std::vector<std::uint8_t> is_placed(map.volumes(), 0);
  for (std::uint32_t v = 0; v < map.volumes(); ++v) {
    waiting_.clear();
    for (std::uint32_t at = v; at != none && !is_placed[at]; at = map.volume(at).parent) {
      waiting_.push_back(at);
      is_placed[at] = 1;
    }
    for (std::size_t i = waiting_.size(); i-- > 0;) add_placement(map, waiting_[i]);
  }

  cuts_.clear();
  cut_of_.clear();
  if (map.cuts().empty()) return;
  cut_of_.assign(vertices.count, none);
  for (const Cut& cut : map.cuts()) {
    const std::uint32_t vertex = vertex_of_[cut.first];
    if (cut_of_[vertex] != none) continue;  // two cuts that were glued together
    cut_of_[vertex] = static_cast<std::uint32_t>(cuts_.size());
    cuts_.push_back({vertex, vertex_of_[cut.from], vertex_of_[cut.to]});
  }
  settled_.assign(cuts_.size(), glm::vec3(0));
}

// Adds a volume to the order of placing: lists the vertices of its corners and, where it is attached, those of the face
// that it is attached to, and makes the polygon of its order.
void Embedding::add_placement(const Map& map, std::uint32_t v) {
  const Volume& volume = map.volume(v);
  Placement placement;
  placement.volume = v;
  placement.parent = volume.parent;
  placement.order = volume.order;
  placement.parent_order = volume.parent == none ? 0 : map.volume(volume.parent).order;
  placement.parent_face = volume.parent_face;
  placement.proposes_base = volume.attached || volume.parent == none;
  placement.corners = static_cast<std::uint32_t>(corners_.size());
  for (std::uint32_t i = 0; i < volume.order; ++i) corners_.push_back(vertex_of_[map.base_corner(v, i)]);
  for (std::uint32_t i = 0; i < volume.order; ++i) corners_.push_back(vertex_of_[map.end_corner(v, i)]);
  placement.support = static_cast<std::uint32_t>(supports_.size());
  if (volume.attached) {
    const std::uint32_t start = map.dart_of(volume.parent, volume.parent_face);
    std::uint32_t d = start;
    do {
      supports_.push_back(vertex_of_[d]);
      d = map.alpha(1, map.alpha(0, d));
    } while (d != start);
  }
  placement.support_count = static_cast<std::uint32_t>(supports_.size()) - placement.support;
  placements_.push_back(placement);
  if (polygons_.size() <= volume.order) polygons_.resize(volume.order + 1);
  if (polygons_[volume.order].empty()) polygons_[volume.order] = polygon(volume.order);
}

// Computes the places of all vertices from the shapes of the volumes: the mean of the places that volumes propose;
// vertices of cuts are in the middle of their edges.
void Embedding::place(std::span<const Shape> shapes) {
  std::fill(places_.begin(), places_.end(), glm::vec3(0));
  std::fill(proposals_.begin(), proposals_.end(), 0);
  is_settled_.assign(cuts_.size(), 0);
  for (const Placement& placement : placements_) place(placement, shapes[placement.volume]);
  // Where a child on a volume's base was split, and then the volume, its base may have corners that are in no volume's
  // end.
  if (!cuts_.empty())
    for (const Placement& placement : placements_) propose_rest(placement, shapes[placement.volume]);
  for (std::size_t vertex = 0; vertex < places_.size(); ++vertex) {
    if (proposals_[vertex] == 0) continue;
    places_[vertex] /= static_cast<float>(proposals_[vertex]);
    proposals_[vertex] = 1;
  }
  // Settles the cuts again: the earlier pass used vertices for which not all volumes had proposed places yet.
  for (std::uint32_t cut = 0; cut < cuts_.size(); ++cut)
    if (!is_proposed(cuts_[cut].vertex)) settle_cut(cut);
  for (std::uint32_t cut = 0; cut < cuts_.size(); ++cut)
    if (!is_proposed(cuts_[cut].vertex)) places_[cuts_[cut].vertex] = settled_[cut];
}

// Computes the frame of one volume from that of its parent, and proposes places for the corners of its end; for those
// of its base if it is attached or has no parent.
void Embedding::place(const Placement& placement, const Shape& shape) {
  const std::span<const std::uint32_t> corners(&corners_[placement.corners], 2 * std::size_t{placement.order});
  const auto base = corners.first(placement.order);
  Frame frame;
  glm::vec3 base_centre(0);
  if (placement.parent != none) {
    frame = on_face(frames_[placement.parent], placement.parent_order, placement.parent_face);
    base_centre = centre(placement.proposes_base ? std::span<const std::uint32_t>(supports_).subspan(
                                                       placement.support, placement.support_count)
                                                 : base,
                         base_centres_[placement.parent]);
  }
  base_centres_[placement.volume] = base_centre;
  frame = turned(frame, shape);
  frames_[placement.volume] = frame;
  if (placement.proposes_base) propose(base, frame, shape, base_centre);
  propose(corners.last(placement.order), frame, shape, base_centre + frame.z * (shape.translation * shape.height));
}

// Proposes places for the corners of a polygon about a centre, scaled by the shape's length and width.
void Embedding::propose(std::span<const std::uint32_t> vertices, const Frame& frame, const Shape& shape,
                        const glm::vec3& centre) {
  const std::vector<glm::vec2>& corners = polygons_[vertices.size()];
  const glm::vec3 along = frame.x * shape.length, across = frame.y * shape.width;
  for (std::size_t i = 0; i < vertices.size(); ++i) {
    places_[vertices[i]] += centre + corners[i].x * along + corners[i].y * across;
    ++proposals_[vertices[i]];
  }
}

// Proposes places for those corners of a base that no volume before has proposed and that are not on a cut: the corners
// of the volume's own polygon about the middle of its base.
void Embedding::propose_rest(const Placement& placement, const Shape& shape) {
  for (std::uint32_t i = 0; i < placement.order; ++i) {
    const std::uint32_t vertex = corners_[placement.corners + i];
    if (is_proposed(vertex) || cut_of_[vertex] != none) continue;
    const Frame& frame = frames_[placement.volume];
    const glm::vec2 corner = polygons_[placement.order][i];
    places_[vertex] =
        base_centres_[placement.volume] + corner.x * shape.length * frame.x + corner.y * shape.width * frame.y;
    proposals_[vertex] = 1;
  }
}

// Returns the mean place of the vertices that are known so far, and `otherwise` where none is. Settles vertices of cuts
// on the way.
glm::vec3 Embedding::centre(std::span<const std::uint32_t> vertices, const glm::vec3& otherwise) {
  glm::vec3 sum(0);
  float known = 0;
  for (const std::uint32_t vertex : vertices) {
    if (!is_proposed(vertex)) {
      // After splits a vertex may belong only to volumes that are placed later.
      if (cut_of_.empty() || cut_of_[vertex] == none) continue;
      settle(vertex);
    }
    sum += is_proposed(vertex) ? places_[vertex] / static_cast<float>(proposals_[vertex]) : settled_[cut_of_[vertex]];
    ++known;
  }
  return known > 0 ? sum / known : otherwise;
}

// Settles a vertex that only a cut determines, after the earlier cuts that its edge's ends are.
void Embedding::settle(std::uint32_t vertex) {
  waiting_.assign(1, vertex);
  needed_.clear();
  while (!waiting_.empty()) {
    const std::uint32_t at = waiting_.back();
    waiting_.pop_back();
    if (is_proposed(at) || is_settled_[cut_of_[at]]) continue;
    const std::uint32_t cut = cut_of_[at];
    is_settled_[cut] = 1;
    needed_.push_back(cut);
    for (const std::uint32_t end : {cuts_[cut].from, cuts_[cut].to})
      if (!is_proposed(end) && cut_of_[end] < cut) waiting_.push_back(end);
  }
  std::sort(needed_.begin(), needed_.end());
  for (const std::uint32_t cut : needed_) settle_cut(cut);
}

// Places the vertex of a cut midway between the ends that are known; in glued volumes, an end may be the vertex of a
// later cut.
void Embedding::settle_cut(std::uint32_t cut) {
  glm::vec3 sum(0);
  float known = 0;
  for (const std::uint32_t end : {cuts_[cut].from, cuts_[cut].to}) {
    if (!is_proposed(end) && cut_of_[end] >= cut) continue;
    sum += is_proposed(end) ? places_[end] / static_cast<float>(proposals_[end]) : settled_[cut_of_[end]];
    ++known;
  }
  settled_[cut] = known > 0 ? sum / known : glm::vec3(0);
}

// The memory that it holds, roughly.
std::uint64_t Embedding::bytes() const {
  const std::uint64_t words = vertex_of_.capacity() + corners_.capacity() + supports_.capacity() + cut_of_.capacity() +
                              proposals_.capacity() + waiting_.capacity() + needed_.capacity();
  std::uint64_t corners = 0;
  for (const auto& polygon : polygons_) corners += polygon.capacity();
  return 4 * words + sizeof(glm::vec2) * corners + sizeof(polygons_[0]) * polygons_.capacity() +
         sizeof(glm::vec3) * (places_.capacity() + settled_.capacity() + base_centres_.capacity()) +
         sizeof(Placement) * placements_.capacity() + sizeof(Ends) * cuts_.capacity() +
         sizeof(Frame) * frames_.capacity() + is_settled_.capacity();
}

}  // namespace panicle::generalized_map
