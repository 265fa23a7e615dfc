#include "generalized_map/map.hpp"

#include "generalized_map/messages.generated.hpp"

namespace panicle::generalized_map {

// Sewn faces are connected dart by dart by the involution α3.

// The message that names the reason of a refusal.
Message message_of(Refusal refusal) {
  switch (refusal) {
    case Refusal::order:
      return message(messages::generalized_map::refusal_order);
    case Refusal::no_face:
      return message(messages::generalized_map::refusal_no_face);
    case Refusal::occupied:
      return message(messages::generalized_map::refusal_occupied);
    case Refusal::not_adjacent:
      return message(messages::generalized_map::refusal_not_adjacent);
    case Refusal::unequal:
      return message(messages::generalized_map::refusal_unequal);
    case Refusal::same_volume:
      return message(messages::generalized_map::refusal_same_volume);
    case Refusal::uneven:
      return message(messages::generalized_map::refusal_uneven);
    case Refusal::folded:
      return message(messages::generalized_map::refusal_folded);
    default:
      return message(messages::generalized_map::refusal_full);
  }
}

// Removes all volumes.
void Map::clear() {
  for (auto& alpha : alpha_) alpha.clear();
  volume_.clear();
  face_.clear();
  list_.clear();
  corners_.clear();
  cuts_.clear();
}

// Reserves memory for so many darts (half-edges of faces) and volumes.
void Map::reserve(std::uint32_t darts, std::uint32_t volumes) {
  for (auto& alpha : alpha_) alpha.reserve(darts);
  volume_.reserve(darts);
  face_.reserve(darts);
  list_.reserve(volumes);
}

// The memory that it holds, roughly.
std::uint64_t Map::bytes() const {
  std::uint64_t words = volume_.capacity() + corners_.capacity();
  for (const auto& alpha : alpha_) words += alpha.capacity();
  return 4 * words + sizeof(Face) * face_.capacity() + sizeof(Volume) * list_.capacity() +
         sizeof(Cut) * cuts_.capacity();
}

// The dart at corner i of a volume's base or end. Prisms have it by number; volumes that were split list their corners.
std::uint32_t Map::base_corner(std::uint32_t v, std::uint32_t i) const {
  const Volume& volume = list_[v];
  return volume.corners == none ? volume.first + 2 * i : corners_[volume.corners + i];
}

// The dart at corner `i` of the end face of volume `v`.
std::uint32_t Map::end_corner(std::uint32_t v, std::uint32_t i) const {
  const Volume& volume = list_[v];
  return volume.corners == none ? volume.first + 2 * (volume.order + i) : corners_[volume.corners + volume.order + i];
}

// A dart of a volume's face; for base and end that at corner 0.
std::uint32_t Map::dart_of(std::uint32_t v, Face face) const {
  const Volume& volume = list_[v];
  if (volume.corners == none) return volume.first + first_of(face, volume.order);
  if (face == base_face) return base_corner(v, 0);
  if (face == end_face) return end_corner(v, 0);
  return alpha_[2][base_corner(v, side_number(face) - 1)];
}

// The number of edges of a dart's face.
std::uint32_t Map::degree(std::uint32_t dart) const {
  std::uint32_t edges = 0, d = dart;
  do {
    d = alpha_[1][alpha_[0][d]];
    ++edges;
  } while (d != dart);
  return edges;
}

// Whether a volume's face has neither a neighbour that is sewn to it nor a volume attached.
bool Map::is_free(std::uint32_t v, Face face) const {
  const std::uint32_t dart = dart_of(v, face);
  if (alpha_[3][dart] != dart) return false;
  for (std::uint32_t child = list_[v].last_attached; child != none; child = list_[child].attached_before)
    if (list_[child].parent_face == face) return false;
  return true;
}

// The dart across the edge on the next free face: turns about the edge through the volumes that are sewn together.
std::uint32_t Map::across_gap(std::uint32_t dart) const {
  std::uint32_t d = alpha_[2][dart];
  while (alpha_[3][d] != d) d = alpha_[2][alpha_[3][d]];
  return d;
}

// Appends darts of a volume and face, without neighbours. Returns the index of the first.
std::uint32_t Map::add_darts(std::uint32_t count, std::uint32_t v, Face face) {
  const std::uint32_t first = darts();
  for (auto& alpha : alpha_) alpha.resize(first + count);
  volume_.resize(first + count, v);
  face_.resize(first + count, face);
  for (std::uint32_t d = first; d < first + count; ++d) alpha_[3][d] = d;
  return first;
}

// Adds a closed prism without a parent or neighbours, and returns its number. Its darts are numbered as in prism.hpp:
// first the base's, then the end's, then the sides'. add_darts gives all of them the base's face; those of the end and
// the sides get their own here.
std::uint32_t Map::add_prism(std::uint32_t order, std::uint32_t label) {
  const std::uint32_t v = volumes(), n = order;
  const std::uint32_t base = add_darts(prism_darts(n), v, base_face), end = base + 2 * n, sides = base + 4 * n;
  std::uint32_t *a0 = alpha_[0].data(), *a1 = alpha_[1].data(), *a2 = alpha_[2].data();
  const auto edge = [a0](std::uint32_t d) {
    a0[d] = d + 1;
    a0[d + 1] = d;
  };
  for (std::uint32_t i = 0; i < n; ++i) {
    const std::uint32_t j = i + 1 == n ? 0 : i + 1;
    const std::uint32_t side_darts = sides + 8 * i, next_darts = sides + 8 * j;
    for (const std::uint32_t polygon : {base, end}) {
      edge(polygon + 2 * i);
      a1[polygon + 2 * i + 1] = polygon + 2 * j;
      a1[polygon + 2 * j] = polygon + 2 * i + 1;
    }
    for (std::uint32_t k = 0; k < 4; ++k) {
      edge(side_darts + 2 * k);
      const std::uint32_t after = side_darts + (2 * k + 2) % 8;
      a1[side_darts + 2 * k + 1] = after;
      a1[after] = side_darts + 2 * k + 1;
    }
    // Edges of the base run as the side's lower edge does, those of the end against its upper one; right meets left.
    for (std::uint32_t s = 0; s < 2; ++s) {
      a2[base + 2 * i + s] = side_darts + s;
      a2[side_darts + s] = base + 2 * i + s;
      a2[end + 2 * i + s] = side_darts + 5 - s;
      a2[side_darts + 5 - s] = end + 2 * i + s;
      a2[side_darts + 2 + s] = next_darts + 7 - s;
      a2[next_darts + 7 - s] = side_darts + 2 + s;
    }
    face_[end + 2 * i] = face_[end + 2 * i + 1] = end_face;
    for (std::uint32_t d = side_darts; d < side_darts + 8; ++d) face_[d] = side(i + 1);
  }
  Volume volume;
  volume.label = label;
  volume.order = n;
  volume.first = base;
  volume.vertices = 2 * n;
  volume.edges = 3 * n;
  volume.faces = n + 2;
  list_.push_back(volume);
  return v;
}

// Sews two faces of equal degree together by α3, beginning with the darts a and b.
void Map::sew_faces(std::uint32_t a, std::uint32_t b) {
  const std::uint32_t start = a;
  do {
    sew(3, a, b);
    a = alpha_[0][a];
    b = alpha_[0][b];
    sew(3, a, b);
    a = alpha_[1][a];
    b = alpha_[1][b];
  } while (a != start);
}

// Attaches a volume to a face of its parent without sewing: their numbers of edges differ.
void Map::attach(std::uint32_t v, std::uint32_t parent, Face face) {
  list_[v].parent = parent;
  list_[v].parent_face = face;
  list_[v].attached = true;
  list_[v].attached_before = list_[parent].last_attached;
  list_[parent].last_attached = v;
}

// Adds a first volume: a prism with `order` sides.
GrowResult Map::plant(std::uint32_t order, std::uint32_t label) {
  if (order < least_order || order > largest_order) return {Refusal::order};
  if (!room_for(prism_darts(order))) return {Refusal::full};
  return {Refusal::nothing, add_prism(order, label)};
}

// Grows a prism on a free face of a volume. It is sewn there if the face has as many edges as its base, else attached.
GrowResult Map::grow(std::uint32_t v, Face face, std::uint32_t order, std::uint32_t label) {
  if (!has(v, face)) return {Refusal::no_face};
  if (!is_free(v, face)) return {Refusal::occupied};
  GrowResult grown = plant(order, label);
  if (grown.refusal != Refusal::nothing) return grown;
  const std::uint32_t support = dart_of(v, face);
  grown.attached = degree(support) != order;
  if (grown.attached) {
    attach(grown.volume, v, face);
    return grown;
  }
  list_[grown.volume].parent = v;
  list_[grown.volume].parent_face = face;
  // A base seen from outside runs clockwise: a volume that grows there is sewn backwards, or the map would be a Möbius
  // band.
  sew_faces(list_[grown.volume].first, face == base_face ? alpha_[0][support] : support);
  return grown;
}

// Sews a face of a volume to a face of another one that it meets at an edge.
Refusal Map::glue(std::uint32_t v, Face face, std::uint32_t other, Face other_face) {
  if (!has(v, face) || !has(other, other_face)) return Refusal::no_face;
  if (v == other) return Refusal::same_volume;
  if (!is_free(v, face) || !is_free(other, other_face)) return Refusal::occupied;
  const std::uint32_t start = dart_of(v, face);
  std::uint32_t d = start;
  do {
    const std::uint32_t hinge = across_gap(d);
    if (volume_[hinge] == other && face_[hinge] == other_face) {
      if (degree(d) != degree(hinge)) return Refusal::unequal;
      sew_faces(d, hinge);
      return Refusal::nothing;
    }
    d = alpha_[1][alpha_[0][d]];
  } while (d != start);
  return Refusal::not_adjacent;
}

}  // namespace panicle::generalized_map
