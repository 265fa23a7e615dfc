#include "generalized_map/map.hpp"

namespace panicle::generalized_map {

const char* words(Refusal refusal) {
  switch (refusal) {
    case Refusal::nothing:
      return "";
    case Refusal::order:
      return "A prism has 3 to 4096 sides.";
    case Refusal::no_face:
      return "The volume has no such face: there are O, E and as many C as its order.";
    case Refusal::occupied:
      return "The face is not free: something has grown on it or is glued to it.";
    case Refusal::not_adjacent:
      return "The faces are not adjacent: they need an edge in common with nothing between them.";
    case Refusal::unequal:
      return "The faces have different numbers of edges.";
    case Refusal::same_volume:
      return "Both faces are of one volume, which cannot be glued to itself.";
    case Refusal::uneven:
      return "The volume cannot be split along a face with a corner that more or fewer than three edges meet in.";
    case Refusal::folded:
      return "The volume cannot be split along a face with an edge glued to one that leaves the face.";
    case Refusal::full:
      return "The map has reached its limit of darts.";
  }
  return "";
}

void Map::clear() {
  for (auto& alpha : alpha_) alpha.clear();
  volume_.clear();
  face_.clear();
  list_.clear();
  corners_.clear();
  cuts_.clear();
}

void Map::reserve(std::uint32_t darts, std::uint32_t volumes) {
  for (auto& alpha : alpha_) alpha.reserve(darts);
  volume_.reserve(darts);
  face_.reserve(darts);
  list_.reserve(volumes);
}

std::uint64_t Map::bytes() const {
  std::uint64_t words = volume_.capacity() + corners_.capacity();
  for (const auto& alpha : alpha_) words += alpha.capacity();
  return 4 * words + sizeof(Face) * face_.capacity() + sizeof(Volume) * list_.capacity() +
         sizeof(Cut) * cuts_.capacity();
}

std::uint32_t Map::base_corner(std::uint32_t v, std::uint32_t i) const {
  const Volume& volume = list_[v];
  return volume.corners == none ? volume.first + 2 * i : corners_[volume.corners + i];
}

std::uint32_t Map::end_corner(std::uint32_t v, std::uint32_t i) const {
  const Volume& volume = list_[v];
  return volume.corners == none ? volume.first + 2 * (volume.order + i) : corners_[volume.corners + volume.order + i];
}

std::uint32_t Map::dart_of(std::uint32_t v, Face face) const {
  const Volume& volume = list_[v];
  if (volume.corners == none) return volume.first + first_of(face, volume.order);
  if (face == base_face) return base_corner(v, 0);
  if (face == end_face) return end_corner(v, 0);
  return alpha_[2][base_corner(v, side_number(face) - 1)];
}

std::uint32_t Map::degree(std::uint32_t dart) const {
  std::uint32_t edges = 0, d = dart;
  do {
    d = alpha_[1][alpha_[0][d]];
    ++edges;
  } while (d != dart);
  return edges;
}

bool Map::is_free(std::uint32_t v, Face face) const {
  const std::uint32_t dart = dart_of(v, face);
  if (alpha_[3][dart] != dart) return false;
  for (std::uint32_t child = list_[v].last_attached; child != none; child = list_[child].attached_before)
    if (list_[child].parent_face == face) return false;
  return true;
}

std::uint32_t Map::across_gap(std::uint32_t dart) const {
  std::uint32_t d = alpha_[2][dart];
  while (alpha_[3][d] != d) d = alpha_[2][alpha_[3][d]];
  return d;
}

std::uint32_t Map::add_darts(std::uint32_t count, std::uint32_t v, Face face) {
  const std::uint32_t first = darts();
  for (auto& alpha : alpha_) alpha.resize(first + count);
  volume_.resize(first + count, v);
  face_.resize(first + count, face);
  for (std::uint32_t d = first; d < first + count; ++d) alpha_[3][d] = d;
  return first;
}

std::uint32_t Map::add_prism(std::uint32_t order, std::uint32_t label) {
  const std::uint32_t v = volumes(), n = order;
  const std::uint32_t o = add_darts(prism_darts(n), v, base_face), e = o + 2 * n, c = o + 4 * n;
  std::uint32_t *a0 = alpha_[0].data(), *a1 = alpha_[1].data(), *a2 = alpha_[2].data();
  const auto edge = [a0](std::uint32_t d) {
    a0[d] = d + 1;
    a0[d + 1] = d;
  };
  for (std::uint32_t i = 0; i < n; ++i) {
    const std::uint32_t j = i + 1 == n ? 0 : i + 1;
    const std::uint32_t own = c + 8 * i, next = c + 8 * j;
    for (const std::uint32_t polygon : {o, e}) {
      edge(polygon + 2 * i);
      a1[polygon + 2 * i + 1] = polygon + 2 * j;
      a1[polygon + 2 * j] = polygon + 2 * i + 1;
    }
    for (std::uint32_t k = 0; k < 4; ++k) {
      edge(own + 2 * k);
      const std::uint32_t after = own + (2 * k + 2) % 8;
      a1[own + 2 * k + 1] = after;
      a1[after] = own + 2 * k + 1;
    }
    // Edges of the base run as the side's lower edge does, those of the end against its upper one; right meets left.
    for (std::uint32_t s = 0; s < 2; ++s) {
      a2[o + 2 * i + s] = own + s;
      a2[own + s] = o + 2 * i + s;
      a2[e + 2 * i + s] = own + 5 - s;
      a2[own + 5 - s] = e + 2 * i + s;
      a2[own + 2 + s] = next + 7 - s;
      a2[next + 7 - s] = own + 2 + s;
    }
    face_[e + 2 * i] = face_[e + 2 * i + 1] = end_face;
    for (std::uint32_t d = own; d < own + 8; ++d) face_[d] = side(i + 1);
  }
  Volume volume;
  volume.label = label;
  volume.order = n;
  volume.first = o;
  volume.vertices = 2 * n;
  volume.edges = 3 * n;
  volume.faces = n + 2;
  list_.push_back(volume);
  return v;
}

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

void Map::attach(std::uint32_t v, std::uint32_t parent, Face face) {
  list_[v].parent = parent;
  list_[v].parent_face = face;
  list_[v].attached = true;
  list_[v].attached_before = list_[parent].last_attached;
  list_[parent].last_attached = v;
}

GrowResult Map::plant(std::uint32_t order, std::uint32_t label) {
  if (order < least_order || order > largest_order) return {Refusal::order};
  if (!room_for(prism_darts(order))) return {Refusal::full};
  return {Refusal::nothing, add_prism(order, label)};
}

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
