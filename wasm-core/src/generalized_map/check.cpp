#include "generalized_map/check.hpp"

#include <algorithm>

namespace panicle::generalized_map {

// A dart is one of the two half-edges of an edge of a face.

namespace {

// The map's arrays by dart: the involutions α0 … α3, its volume and its face; and the numbers of darts and volumes.
struct Involutions {
  const std::uint32_t *a0, *a1, *a2, *a3, *volume;
  const Face* face;
  std::uint32_t darts, volumes;
};

// Whether each involution, applied twice, leads back to the dart d.
bool is_involutive(const Involutions& m, std::uint32_t d) {
  return m.a0[m.a0[d]] == d && m.a1[m.a1[d]] == d && m.a2[m.a2[d]] == d && m.a3[m.a3[d]] == d;
}

// Whether α0, α1 and α2 lead from d to other darts, and α0 and α2 to different ones.
bool moves(const Involutions& m, std::uint32_t d) {
  return m.a0[d] != d && m.a1[d] != d && m.a2[d] != d && m.a0[d] != m.a2[d];
}

// Whether α0α2, α0α3 and α1α3 are involutions at d, that is, commute.
bool has_products(const Involutions& m, std::uint32_t d) {
  return m.a0[m.a2[d]] == m.a2[m.a0[d]] && m.a0[m.a3[d]] == m.a3[m.a0[d]] && m.a1[m.a3[d]] == m.a3[m.a1[d]];
}

// Whether α0, α1 and α2 stay in the dart's volume, and α0 and α1 in its face.
bool is_home(const Involutions& m, std::uint32_t d) {
  const std::uint32_t v = m.volume[d], a0 = m.a0[d], a1 = m.a1[d];
  return v < m.volumes && m.volume[a0] == v && m.volume[a1] == v && m.volume[m.a2[d]] == v && m.face[a0] == m.face[d] &&
         m.face[a1] == m.face[d];
}

// Whether the dart is not sewn to another one of its own volume.
bool is_unfolded(const Involutions& m, std::uint32_t d) { return m.a3[d] == d || m.volume[m.a3[d]] != m.volume[d]; }

// Returns the first fault at one dart, in the order of the list.
Fault fault_of(const Involutions& m, std::uint32_t d) {
  if (!is_involutive(m, d)) return Fault::involution;
  if (!moves(m, d)) return Fault::fixed;
  if (!has_products(m, d)) return Fault::product;
  if (!is_home(m, d)) return Fault::foreign;
  return is_unfolded(m, d) ? Fault::nothing : Fault::folded;
}

// Tests all darts at once, without a branch per dart: maps are valid but for mistakes.
bool are_well(const Involutions& m) {
  std::uint32_t wrong = 0;
  for (std::uint32_t d = 0; d < m.darts; ++d) {
    const std::uint32_t a0 = m.a0[d], a1 = m.a1[d], a2 = m.a2[d], a3 = m.a3[d], v = m.volume[d];
    wrong |= (m.a0[a0] ^ d) | (m.a1[a1] ^ d) | (m.a2[a2] ^ d) | (m.a3[a3] ^ d);
    wrong |= (m.a0[a2] ^ m.a2[a0]) | (m.a0[a3] ^ m.a3[a0]) | (m.a1[a3] ^ m.a3[a1]);
    wrong |= (m.volume[a0] ^ v) | (m.volume[a1] ^ v) | (m.volume[a2] ^ v);
    wrong |= static_cast<std::uint32_t>((m.face[a0] ^ m.face[d]) | (m.face[a1] ^ m.face[d]));
    wrong |= static_cast<std::uint32_t>((a0 == d) | (a1 == d) | (a2 == d) | (a0 == a2) | (v >= m.volumes));
    wrong |= static_cast<std::uint32_t>((a3 != d) & (m.volume[a3] == v));
  }
  return wrong == 0;
}

// The numbers of a volume's cells and darts.
struct Counted {
  std::uint32_t vertices = 0, faces = 0, darts = 0;
};

// Counts the orbits of two of a volume's involutions: α0 and α1 give faces, α2 and α1 vertices.
void count_orbits(const Involutions& m, std::vector<Counted>& counted) {
  constexpr std::uint8_t in_face = 1, at_vertex = 2;
  std::vector<std::uint8_t> seen(m.darts, 0);
  for (std::uint32_t d = 0; d < m.darts; ++d) {
    Counted& own = counted[m.volume[d]];
    ++own.darts;
    if (!(seen[d] & in_face)) {
      ++own.faces;
      std::uint32_t at = d;
      do {
        const std::uint32_t other = m.a0[at];
        seen[at] |= in_face;
        seen[other] |= in_face;
        at = m.a1[other];
      } while (at != d);
    }
    if (!(seen[d] & at_vertex)) {
      ++own.vertices;
      std::uint32_t at = d;
      do {
        const std::uint32_t other = m.a2[at];
        seen[at] |= at_vertex;
        seen[other] |= at_vertex;
        at = m.a1[other];
      } while (at != d);
    }
  }
}

// Whether all corners that a volume lists are darts of its base and of its end.
bool has_corners(const Map& map, std::uint32_t v) {
  const auto stands = [&](std::uint32_t dart, Face face) {
    return dart < map.darts() && map.volume_of()[dart] == v && map.face_of()[dart] == face;
  };
  for (std::uint32_t i = 0; i < map.volume(v).order; ++i)
    if (!stands(map.base_corner(v, i), base_face) || !stands(map.end_corner(v, i), end_face)) return false;
  return true;
}

// Whether a volume's parent has the face that it names, and its list of attached volumes is a list of children that are
// attached to it. Counting the steps ends on lists that run in a circle.
bool has_descent(const Map& map, std::uint32_t v) {
  const Volume& volume = map.volume(v);
  if (volume.parent != none && (volume.parent == v || !map.has(volume.parent, volume.parent_face))) return false;
  std::uint32_t steps = 0;
  for (std::uint32_t child = volume.last_attached; child != none; child = map.volume(child).attached_before)
    if (child >= map.volumes() || !map.volume(child).attached || map.volume(child).parent != v ||
        ++steps > map.volumes())
      return false;
  return true;
}

}  // namespace

// Checks that a map is a valid generalized map. Returns the first kind of fault with a dart or volume that has it.
Finding check(const Map& map) {
  const std::uint32_t darts = map.darts(), volumes = map.volumes();
  // In the order of the faults: dangling darts, faults of single darts, numbers of cells, corners, descent.
  for (std::uint32_t i = 0; i < 4; ++i) {
    const std::span<const std::uint32_t> alpha = map.alphas(i);
    const auto beyond = std::find_if(alpha.begin(), alpha.end(), [darts](std::uint32_t d) { return d >= darts; });
    if (beyond != alpha.end()) return {Fault::dangling, static_cast<std::uint32_t>(beyond - alpha.begin())};
  }
  const Involutions m{map.alphas(0).data(),
                      map.alphas(1).data(),
                      map.alphas(2).data(),
                      map.alphas(3).data(),
                      map.volume_of().data(),
                      map.face_of().data(),
                      darts,
                      volumes};
  if (!are_well(m)) {
    Finding worst;
    for (std::uint32_t d = 0; d < darts; ++d) {
      const Fault fault = fault_of(m, d);
      if (fault != Fault::nothing && (worst.fault == Fault::nothing || fault < worst.fault)) worst = {fault, d};
    }
    return worst;
  }
  std::vector<Counted> counted(volumes);
  count_orbits(m, counted);
  for (std::uint32_t v = 0; v < volumes; ++v) {
    const Volume& volume = map.volume(v);
    // α0 and α2 lead from each dart to three others: an edge of a volume is four darts.
    if (counted[v].vertices != volume.vertices || counted[v].faces != volume.faces ||
        counted[v].darts != 4 * volume.edges)
      return {Fault::cells, v};
  }
  for (std::uint32_t v = 0; v < volumes; ++v)
    if (!has_corners(map, v)) return {Fault::corner, v};
  for (std::uint32_t v = 0; v < volumes; ++v)
    if (!has_descent(map, v)) return {Fault::descent, v};
  return {};
}

// Describes a fault in words, for tests and tools.
const char* words(Fault fault) {
  switch (fault) {
    case Fault::nothing:
      return "nothing";
    case Fault::dangling:
      return "an α leads to no dart";
    case Fault::involution:
      return "an α is no involution";
    case Fault::fixed:
      return "α0, α1 or α2 fixes a dart";
    case Fault::product:
      return "α0α2, α0α3 or α1α3 is no involution";
    case Fault::foreign:
      return "a dart is not of its volume or face";
    case Fault::folded:
      return "a volume is sewn to itself";
    case Fault::cells:
      return "a volume has other cells than its arithmetic says";
    case Fault::corner:
      return "a corner is not where it should be";
    case Fault::descent:
      return "a parent, or what stands on a face, is none";
  }
  return "";
}

}  // namespace panicle::generalized_map
