// Generalized maps of dimension 3: how volumes, faces, edges and vertices hang together, and nothing of where they are.
//
// After Lienhardt 1994, "N-dimensional generalized combinatorial maps and cellular quasi-manifolds"; sewing is his. The
// one element is the *dart*: a corner's view along an edge, of a face, of a volume. α0 leads to the dart at the edge's
// other end, α1 to the other edge at the corner, α2 to the other face at the edge, α3 to the volume on the other side
// of the face. All four are involutions; α0α2, α0α3 and α1α3 are, too: so cells meet whole. A cell is all darts
// that the other involutions reach (cells.hpp). A dart whose α3 is itself is *free*: nothing lies beyond its face. α0,
// α1 and α2 fix none, so each volume is closed.
//
// Volumes begin as prisms (prism.hpp) and are made by the three operations of 3Gmap L-systems (Terraz et al. 2009,
// "3Gmap L-systems: an application to the modelling of wood"; Petrenko 2014, "Simulation of flowering plants",
// section 2.2.1): grow, glue, split. Each either succeeds or refuses and leaves the map as it was. `check`
// (check.hpp) verifies the result.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "foundation/limits.hpp"
#include "foundation/message.hpp"
#include "generalized_map/prism.hpp"

namespace panicle::generalized_map {

inline constexpr std::uint32_t none = ~0u;

// The reason of a refused operation.
enum class Refusal : std::uint8_t {
  nothing,       // it was done
  order,         // prisms have 3 to 4096 sides
  no_face,       // the volume has no face of that name
  occupied,      // something lies beyond the face, or stands on it
  not_adjacent,  // the two faces have no edge with nothing between them
  unequal,       // the two faces have different numbers of edges
  same_volume,   // a volume is not glued to itself
  uneven,        // not every corner of the face has one edge that leaves it
  folded,        // an edge that leaves the face is glued to one of its own
  full,          // the map would have more darts than it may
};

// The reason of a refusal, which is not `nothing`, with advice.
Message message_of(Refusal refusal);

struct Volume {
  std::uint32_t label = 0;  // the caller's: which word names it
  std::uint32_t order = 0;
  std::uint32_t parent = none;  // it grew from, or stands on
  Face parent_face = base_face;
  bool attached = false;  // stands on the parent's face, unsewn
  // Cells of its boundary. Of a prism 2 n, 3 n, n + 2; a cut at one of its edges adds a vertex and an edge, one across
  // a face an edge and a face.
  std::uint32_t vertices = 0, edges = 0, faces = 0;
  // Indices of its darts: a prism's are contiguous, those of a split volume are listed in the map.
  std::uint32_t first = none, corners = none;
  std::uint32_t last_attached = none, attached_before = none;  // linked list of the volumes attached to it
};

// An edge that a split has cut: the new vertex, and the ends of the edge at that time, as darts at them.
struct Cut {
  std::uint32_t first, count;  // the new vertex's darts, which were made together
  std::uint32_t from, to;
  std::uint32_t step;
};

struct GrowResult {
  Refusal refusal = Refusal::nothing;
  std::uint32_t volume = none;
  bool attached = false;  // orders differ: it stands on the face, sewn to nothing
};

struct SplitResult {
  Refusal refusal = Refusal::nothing;
  std::uint32_t rest = none, part = none;
};

// A face that another could be glued to, and a dart of each that would be sewn together.
struct Adjacency {
  std::uint32_t volume = none;
  std::uint32_t own = none, other = none;
};

class Map {
 public:
  // `most`: the limit of darts.
  explicit Map(std::uint32_t most = Limits{}.darts) : most_(most) {}

  void clear();                                              // keeps its memory
  void reserve(std::uint32_t darts, std::uint32_t volumes);  // or doubling takes three times the memory for a while

  std::uint32_t darts() const { return static_cast<std::uint32_t>(volume_.size()); }
  std::uint32_t volumes() const { return static_cast<std::uint32_t>(list_.size()); }
  // The dart to which involution α_i, i = 0 … 3, leads: the neighbour by vertex, edge, face or volume. A dart is a
  // half-edge of one face.
  std::uint32_t alpha(std::uint32_t i, std::uint32_t dart) const { return alpha_[i][dart]; }
  std::span<const std::uint32_t> alphas(std::uint32_t i) const { return alpha_[i]; }
  std::span<const std::uint32_t> volume_of() const { return volume_; }  // by dart
  std::span<const Face> face_of() const { return face_; }               // by dart
  const Volume& volume(std::uint32_t v) const { return list_[v]; }
  // Changes the label of a volume.
  void relabel(std::uint32_t v, std::uint32_t label) { list_[v].label = label; }
  std::span<const Cut> cuts() const { return cuts_; }
  std::uint64_t bytes() const;  // that it holds

  // Whether volume `v` exists and has that face.
  bool has(std::uint32_t v, Face face) const { return v < volumes() && face < list_[v].order + 2; }

  // Corner `i` of a volume's base or end: the dart there that looks along the edge to corner i + 1. Neighbours that are
  // split put further vertices between corners, and leave these.
  std::uint32_t base_corner(std::uint32_t v, std::uint32_t i) const;
  std::uint32_t end_corner(std::uint32_t v, std::uint32_t i) const;
  // A face's first dart: at its lower left corner, along its lower edge. Of a face that a neighbour's split has
  // divided, of the piece that has this corner.
  std::uint32_t dart_of(std::uint32_t v, Face face) const;
  // The number of edges of the face that a dart belongs to.
  std::uint32_t degree(std::uint32_t dart) const;
  bool is_free(std::uint32_t v, Face face) const;

  // From a free dart around its edge to the only other free dart there: at the same corner, of the face that the gap at
  // this edge leads to. The dart's own volume where nothing else is at the edge.
  std::uint32_t across_gap(std::uint32_t dart) const;

  // Adds a prism without a parent.
  GrowResult plant(std::uint32_t order, std::uint32_t label);

  // A -> A[B(n)]F: a new prism whose base is sewn to the face, its C1 at the face's first edge. Where orders differ no
  // sewing exists: then it stands on the face (`attached`), which is no longer free.
  GrowResult grow(std::uint32_t v, Face face, std::uint32_t order, std::uint32_t label);

  // A: A_F < A_G -> A_F | A_G: two free faces with a common edge, and nothing between them there, become one, turned
  // about that edge. Where they have several the first of `face` counts.
  Refusal glue(std::uint32_t v, Face face, std::uint32_t other, Face other_face);

  // The first free face `other_face`, of a volume of that label which `fits(volume)`, that has a gap with this one;
  // `Adjacency{}` where there is none. `glue` may still find them unequal.
  template <class Fits>
  Adjacency adjacent(std::uint32_t v, Face face, std::uint32_t label, Face other_face, Fits fits) const {
    if (!has(v, face) || !is_free(v, face)) return {};
    const std::uint32_t start = dart_of(v, face);
    std::uint32_t d = start;
    do {
      const std::uint32_t other = across_gap(d), w = volume_[other];
      if (w != v && face_[other] == other_face && list_[w].label == label && is_free(w, other_face) && fits(w))
        return {w, d, other};
      d = alpha_[1][alpha_[0][d]];
    } while (d != start);
    return {};
  }
  // The adjacency of a face to the face `other_face` of any volume with that label.
  Adjacency adjacent(std::uint32_t v, Face face, std::uint32_t label, Face other_face) const {
    return adjacent(v, face, label, other_face, [](std::uint32_t) { return true; });
  }

  // A -F-> B C: every face at F is divided and both halves are closed by a new face. C, the new volume, is the part at
  // F: a prism as if it had grown where the cut is, its end F and its base the cut, C1 at F's first edge. B keeps A's
  // number, faces and place, and the cut for F. Where F is the base, C stands on A's support, and B on C's end.
  //
  // The cut goes through each edge that leaves F, so volumes that share these edges get a vertex more, and those that
  // share the divided faces an edge across theirs. Splits with the same `step` (other than `none`) meet in the vertices
  // that one of them has made: neighbours that are split in one step of a derivation are cut all along one surface.
  SplitResult split(std::uint32_t v, Face face, std::uint32_t rest_label, std::uint32_t part_label,
                    std::uint32_t step = none);

 private:
  friend class Splitting;
  friend struct RawAccess;  // tests spoil maps to see that it is noticed

  // Whether so many more darts are within the limit.
  bool room_for(std::uint64_t darts) const { return this->darts() + darts <= most_; }
  std::uint32_t add_darts(std::uint32_t count, std::uint32_t v, Face face);
  std::uint32_t add_prism(std::uint32_t order, std::uint32_t label);
  // Connects darts `a` and `b` by involution α_i.
  void sew(std::uint32_t i, std::uint32_t a, std::uint32_t b) {
    alpha_[i][a] = b;
    alpha_[i][b] = a;
  }
  // Sews faces of equal degree round, from these two darts on.
  void sew_faces(std::uint32_t a, std::uint32_t b);
  void attach(std::uint32_t v, std::uint32_t parent, Face face);

  std::uint32_t most_;
  std::array<std::vector<std::uint32_t>, 4> alpha_;
  std::vector<std::uint32_t> volume_;
  std::vector<Face> face_;
  std::vector<Volume> list_;
  // Of each volume that a split has left: the corners of its base, then those of its end.
  std::vector<std::uint32_t> corners_;
  std::vector<Cut> cuts_;  // by their first darts
};

}  // namespace panicle::generalized_map
