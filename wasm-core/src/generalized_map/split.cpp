#include <algorithm>

#include "generalized_map/map.hpp"

namespace panicle::generalized_map {

// A dart is one of the two half-edges of an edge of a face; sewn faces are connected dart by dart by the involution α3.

// One split at work. The face F that it goes along has corners k = 0 … m − 1; rim[k] is F's dart at corner k that looks
// to corner k + 1. Across that edge lies the face G_k of the same volume. From corner k one edge leaves F, which bounds
// G_k and G_{k−1}; where it is cut, near[k] is the dart of G_k that looks back to F. The cut meets G_k in an edge from
// the one cut to the next; ring[k] is its dart on F's side at near[k].
class Splitting {
 public:
  // Collects the darts of the face along which the volume v is split.
  Splitting(Map& map, std::uint32_t v, Face face) : map_(map), v_(v), face_(face), first_new_(map.darts()) {
    const std::uint32_t first = map.dart_of(v, face);
    std::uint32_t d = first;
    do {
      rim_.push_back(d);
      d = a(1, a(0, d));
    } while (d != first);
    sorted_rim_ = rim_;
    std::sort(sorted_rim_.begin(), sorted_rim_.end());
  }

  // The number of the face's corners.
  std::uint32_t order() const { return static_cast<std::uint32_t>(rim_.size()); }

  // Whether one edge leaves F at every corner.
  bool is_even() const {
    return std::all_of(rim_.begin(), rim_.end(),
                       [this](std::uint32_t d) { return a(2, leaving(d)) == a(1, a(2, a(1, d))); });
  }

  // Whether an edge that leaves F is glued to one of F's own. Then no cut parts F from the rest.
  bool is_folded() {
    for (const std::uint32_t d : rim_) {
      gather_fan(leaving(d));
      for (const std::uint32_t at : fan_)
        if (is_of_rim(at) || is_of_rim(a(0, at))) return true;
    }
    return false;
  }

  // An upper bound of the new darts: of cuts, of edges across faces on both sides of them, and of the two faces that
  // close it.
  std::uint64_t max_darts() {
    std::uint64_t count = 12 * rim_.size();
    for (const std::uint32_t d : rim_) {
      gather_fan(leaving(d));
      count += 2 * fan_.size();
    }
    return count;
  }

  // Cuts all edges that leave the face, unless this step has cut them for another volume, and divides the faces between
  // them.
  void cut(std::uint32_t step) {
    for (const std::uint32_t d : rim_) {
      const std::uint32_t edge = leaving(d);
      if (!is_of_step(a(0, edge), step)) cut_edge(edge, step);
      near_.push_back(a(0, edge));
    }
    for (std::size_t k = 0; k < rim_.size(); ++k) ring_.push_back(divide(k));
  }

  // Closes the cut by two faces, a `lid` on the part and a `stump` on the rest, which are sewn together. Returns the
  // new volume, the part.
  std::uint32_t close(std::uint32_t rest_label, std::uint32_t part_label) {
    const std::uint32_t m = order(), part = map_.volumes();
    const bool at_base = face_ == base_face;
    Volume volume;
    volume.label = part_label;
    volume.order = m;
    volume.vertices = 2 * m;
    volume.edges = 3 * m;
    volume.faces = m + 2;
    volume.corners = static_cast<std::uint32_t>(map_.corners_.size());
    map_.list_.push_back(volume);

    const std::uint32_t lid = map_.add_darts(2 * m, part, at_base ? end_face : base_face);
    const std::uint32_t stump = map_.add_darts(2 * m, v_, face_);
    for (std::uint32_t k = 0; k < m; ++k) {
      const std::uint32_t next = 2 * (k + 1 == m ? 0 : k + 1), own = 2 * k;
      const std::uint32_t beyond = a(2, ring_[k]), beyond_end = a(0, beyond), ring_end = a(0, ring_[k]);
      for (const std::uint32_t polygon : {lid, stump}) {
        map_.sew(0, polygon + own, polygon + own + 1);
        map_.sew(1, polygon + own + 1, polygon + next);
      }
      for (std::uint32_t s = 0; s < 2; ++s) map_.sew(3, lid + own + s, stump + own + s);
      map_.sew(2, ring_[k], lid + own);
      map_.sew(2, ring_end, lid + own + 1);
      map_.sew(2, beyond, stump + own);
      map_.sew(2, beyond_end, stump + own + 1);
    }
    assign_polygon(rim_[0], part, at_base ? base_face : end_face);
    for (std::uint32_t k = 0; k < m; ++k) assign_polygon(ring_[k], part, side(k + 1));
    for (const bool of_base : {true, false})
      for (std::uint32_t k = 0; k < m; ++k) map_.corners_.push_back(of_base == at_base ? rim_[k] : lid + 2 * k);

    keep_corners(part);
    Volume& rest = map_.list_[v_];
    rest.label = rest_label;
    // Together both parts have the cells of the volume, the vertices and edges of the cut twice, and the two faces that
    // close it.
    rest.vertices += m - 2 * m;
    rest.edges += m - 3 * m;
    rest.faces += 2 - (m + 2);
    inherit(part);
    return part;
  }

 private:
  // The dart to which the involution α_i leads.
  std::uint32_t a(std::uint32_t i, std::uint32_t d) const { return map_.alpha_[i][d]; }
  // For a dart of the rim: the dart at its corner, of the face across its edge, that looks away from F.
  std::uint32_t leaving(std::uint32_t d) const { return a(1, a(2, d)); }

  // Whether a dart is on the rim of the cut.
  bool is_of_rim(std::uint32_t d) const { return std::binary_search(sorted_rim_.begin(), sorted_rim_.end(), d); }

  // Whether a dart is at a vertex that this step has put on its edge, so that the edge continues beyond.
  bool is_of_step(std::uint32_t dart, std::uint32_t step) const {
    const std::vector<Cut>& cuts = map_.cuts_;
    const auto after =
        std::upper_bound(cuts.begin(), cuts.end(), dart, [](std::uint32_t d, const Cut& cut) { return d < cut.first; });
    if (after == cuts.begin()) return false;
    const Cut& cut = after[-1];
    if (dart >= cut.first + cut.count) return false;
    // For every step, two edges of the volume that are glued together are cut once.
    if (cut.first < first_new_ && (step == none || cut.step != step)) return false;
    return goes_on(dart, cut) && goes_on(a(2, dart), cut);
  }

  // Whether the next edge in a dart's face is the other half of its edge, and not an edge by which a neighbour has
  // divided the face. Where the volume itself was split, another face is next.
  bool goes_on(std::uint32_t dart, const Cut& cut) const {
    const std::uint32_t next = a(1, dart), half = cut.count / 2;
    const std::uint32_t other = dart < cut.first + half ? dart + half : dart - half;
    return next == other || map_.face_[a(2, next)] == map_.face_[dart];
  }

  // Collects the darts at one end of a whole edge in `fan_`: pairs across α2, one pair for each volume about the edge,
  // each pair's second dart sewn to the next pair's first; from one free face to the other, or around.
  void gather_fan(std::uint32_t dart) {
    std::uint32_t start = dart;
    while (a(3, start) != start) {
      start = a(2, a(3, start));
      if (start == dart) break;
    }
    fan_.clear();
    for (std::uint32_t d = start;;) {
      const std::uint32_t second = a(2, d);
      fan_.push_back(d);
      fan_.push_back(second);
      d = a(3, second);
      if (d == second || d == start) break;
    }
  }

  // Puts a vertex on the whole edge of a dart, in all volumes that have it.
  void cut_edge(std::uint32_t dart, std::uint32_t step) {
    gather_fan(dart);
    const auto ends = static_cast<std::uint32_t>(fan_.size());
    for (std::uint32_t i = 0; i < ends; ++i) fan_.push_back(a(0, fan_[i]));
    const auto count = static_cast<std::uint32_t>(fan_.size());
    const std::uint32_t first = map_.add_darts(count, v_, face_);
    for (std::uint32_t i = 0; i < count; ++i) {
      map_.volume_[first + i] = map_.volume_[fan_[i]];
      map_.face_[first + i] = map_.face_[fan_[i]];
    }
    for (std::uint32_t i = 0; i < ends; i += 2) {
      Volume& volume = map_.list_[map_.volume_[fan_[i]]];
      ++volume.vertices;
      ++volume.edges;
      for (const std::uint32_t at : {i, ends + i}) {
        map_.sew(2, first + at, first + at + 1);
        // From one pair to the next; α3 of darts at the edge's ends has not changed.
        const std::uint32_t beyond = a(3, fan_[at + 1]);
        if (beyond != fan_[at + 1]) map_.sew(3, first + at + 1, first + (i + 2 == ends ? at - i : at + 2));
      }
    }
    for (std::uint32_t i = 0; i < ends; ++i) map_.sew(1, first + i, first + ends + i);
    const std::uint32_t other = a(0, dart);
    for (std::uint32_t i = 0; i < count; ++i) map_.sew(0, fan_[i], first + i);
    map_.cuts_.push_back({first, count, dart, other, step});
  }

  // Divides G_k, the k-th face round the split volume, on both sides, between the two cuts through its edges, and
  // returns ring[k], the dart on the new edge. Where a neighbour's split has divided it already, nothing is changed.
  std::uint32_t divide(std::size_t k) {
    const std::size_t next = k + 1 == rim_.size() ? 0 : k + 1;
    const std::uint32_t p = near_[k], q = a(2, near_[next]);  // both of G_k
    if (a(0, a(1, p)) == a(1, q)) return a(1, p);
    const std::uint32_t v = v_, w = a(3, p) == p ? none : map_.volume_[a(3, p)];
    const std::uint32_t p3 = a(3, p), q3 = a(3, q);
    const std::uint32_t own = add_edge(p, q, v);
    if (w != none) {
      const std::uint32_t mirrored = add_edge(p3, q3, w);
      for (std::uint32_t i = 0; i < 4; ++i) map_.sew(3, own + i, mirrored + i);
    }
    return own;
  }

  // Adds an edge across a face of the volume v, from the corner of the dart p to that of q: two darts on the side of p
  // and q, two beyond. Returns the first.
  std::uint32_t add_edge(std::uint32_t p, std::uint32_t q, std::uint32_t v) {
    const std::uint32_t x = map_.add_darts(4, v, map_.face_[p]), b = a(1, p), d = a(1, q);
    map_.sew(1, p, x);
    map_.sew(1, q, x + 1);
    map_.sew(1, b, x + 2);
    map_.sew(1, d, x + 3);
    map_.sew(0, x, x + 1);
    map_.sew(0, x + 2, x + 3);
    map_.sew(2, x, x + 2);
    map_.sew(2, x + 1, x + 3);
    ++map_.list_[v].edges;
    ++map_.list_[v].faces;
    return x;
  }

  // Assigns all darts of a dart's face to a volume and a face.
  void assign_polygon(std::uint32_t dart, std::uint32_t v, Face face) {
    std::uint32_t d = dart;
    do {
      for (const std::uint32_t at : {d, a(0, d)}) {
        map_.volume_[at] = v;
        map_.face_[at] = face;
      }
      d = a(1, a(0, d));
    } while (d != dart);
  }

  // Updates the corners of the rest: those that went with the part move along the edges that leave F, to the cut.
  void keep_corners(std::uint32_t part) {
    const std::uint32_t n = map_.list_[v_].order;
    scratch_.clear();
    for (std::uint32_t i = 0; i < n; ++i) scratch_.push_back(corner_after_split(map_.base_corner(v_, i), part));
    for (std::uint32_t i = 0; i < n; ++i) scratch_.push_back(corner_after_split(map_.end_corner(v_, i), part));
    Volume& rest = map_.list_[v_];
    if (rest.corners == none) {
      rest.corners = static_cast<std::uint32_t>(map_.corners_.size());
      map_.corners_.insert(map_.corners_.end(), scratch_.begin(), scratch_.end());
    } else {
      std::copy(scratch_.begin(), scratch_.end(), map_.corners_.begin() + rest.corners);
    }
  }

  // The dart at a corner of the rest. A corner that went with the part moves along the edge that leaves F, to the cut.
  std::uint32_t corner_after_split(std::uint32_t d, std::uint32_t part) const {
    if (map_.volume_[d] != part) return d;
    const Face f = face_ == base_face ? base_face : end_face, lid = face_ == base_face ? end_face : base_face;
    const auto at = [this](std::uint32_t dart) { return map_.face_[dart]; };
    const auto across = [this](std::uint32_t ring) { return a(3, a(2, ring)); };  // on the stump
    if (at(d) == f) return across(a(1, a(0, a(1, a(2, d)))));
    // Of a divided face: along F's edge, along the cut, or along an edge between them, away from F or towards it.
    if (at(a(2, d)) == f) return a(2, across(a(1, a(0, a(1, d)))));
    if (at(a(2, d)) == lid) return a(2, across(d));
    return a(1, a(2, across(at(a(2, a(1, d))) == f ? a(1, a(0, d)) : a(1, d))));
  }

  // Updates parents, and the volumes that are attached to F.
  void inherit(std::uint32_t part) {
    std::vector<Volume>& list = map_.list_;
    Volume &rest = list[v_], &own = list[part];
    const Face rest_face = face_ == base_face ? base_face : end_face;
    // Moves volumes that are attached to F.
    std::uint32_t waiting = rest.last_attached;
    rest.last_attached = none;
    while (waiting != none) {
      const std::uint32_t child = waiting;
      waiting = list[child].attached_before;
      const bool moves = list[child].parent_face == face_;
      map_.attach(child, moves ? part : v_, moves ? rest_face : list[child].parent_face);
    }
    const std::uint32_t beyond = a(3, rim_[0]);
    if (beyond != rim_[0]) {
      Volume& child = list[map_.volume_[beyond]];
      if (child.parent == v_ && child.parent_face == face_ && !child.attached) {
        child.parent = part;
        child.parent_face = rest_face;
      }
    }
    if (face_ != base_face) {
      own.parent = v_;
      own.parent_face = face_;
      return;
    }
    own.parent = rest.parent;
    own.parent_face = rest.parent_face;
    own.attached = rest.attached;
    if (rest.attached) {
      own.attached_before = rest.attached_before;
      std::uint32_t* link = &list[rest.parent].last_attached;
      while (*link != v_) link = &list[*link].attached_before;
      *link = part;
    }
    rest.parent = part;
    rest.parent_face = end_face;
    rest.attached = false;
    rest.attached_before = none;
  }

  Map& map_;
  std::uint32_t v_;
  Face face_;
  std::uint32_t first_new_;  // of the darts that this split makes
  std::vector<std::uint32_t> rim_, near_, ring_;
  std::vector<std::uint32_t> sorted_rim_;  // the same in ascending order
  std::vector<std::uint32_t> fan_, scratch_;
};

// Splits a volume along a face: the part at the face becomes a new volume. `step` identifies cuts that neighbours make
// in the same step.
SplitResult Map::split(std::uint32_t v, Face face, std::uint32_t rest_label, std::uint32_t part_label,
                       std::uint32_t step) {
  if (!has(v, face)) return {Refusal::no_face};
  Splitting splitting(*this, v, face);
  if (!splitting.is_even()) return {Refusal::uneven};
  if (splitting.is_folded()) return {Refusal::folded};
  if (!room_for(splitting.max_darts())) return {Refusal::full};
  splitting.cut(step);
  return {Refusal::nothing, v, splitting.close(rest_label, part_label)};
}

}  // namespace panicle::generalized_map
