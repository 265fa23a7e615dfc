#include "models/flower/organ_forms.hpp"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <limits>
#include <map>
#include <numeric>
#include <set>
#include <span>
#include <utility>

#include "foundation/bytes.hpp"

namespace panicle::flower {
namespace {

constexpr std::uint32_t fewest = 8;  // least number of triangles; below, a kite is as good
constexpr float flat = 0.3f;         // error of a kite, as a share of half its width

// The number of collapses with at most this error; `thinning` is sorted by rising error.
std::size_t count_within(const std::vector<Collapse>& thinning, float error) {
  return static_cast<std::size_t>(
      std::upper_bound(thinning.begin(), thinning.end(), error,
                       [](float value, const Collapse& each) { return value < each.error; }) -
      thinning.begin());
}

// Whether a triangle has two equal corners, and so no area.
bool is_flat(std::uint32_t a, std::uint32_t b, std::uint32_t c) { return a == b || b == c || c == a; }

using Edge = std::pair<std::uint32_t, std::uint32_t>;
// An organ's faces: for each the number of its corners, and of each corner twice its vertex, plus 1 where the vertex
// belongs to the parent organ.
using Topology = std::span<const std::uint32_t>;

// Adds all faces as triangles, and fixes the parent's vertices. Returns the edges without a face on their other side.
std::set<Edge> triangulate(Topology topology, OrganForm& form, Patch& patch) {
  std::set<Edge> open;
  for (std::size_t i = 0, face = 0; i < topology.size(); ++face) {
    const std::size_t first = i + 1, end = first + topology[i];
    for (std::size_t c = first; c < end; ++c) {
      const std::uint32_t a = topology[c] / 2, b = topology[c + 1 < end ? c + 1 : first] / 2;
      patch.is_fixed[a] = topology[c] % 2;
      if (c >= first + 2) {
        patch.triangles.push_back({topology[first] / 2, topology[c - 1] / 2, a});
        form.faces.push_back(static_cast<std::uint32_t>(face));
      }
      const auto other = open.find({b, a});
      if (other != open.end()) {
        open.erase(other);
      } else {
        open.insert({a, b});
      }
    }
    i = end;
  }
  return open;
}

// Closes the holes of a surface with fans of triangles, so that their rims keep their shape when the surface is
// simplified: an organ is open at its foot and where others are attached. `open` are the edges without a face on one
// side; it becomes empty.
void close_holes(std::set<Edge>& open, Patch& patch) {
  while (!open.empty()) {
    std::vector<std::uint32_t> ring;
    for (auto edge = open.begin(); edge != open.end(); edge = open.lower_bound({ring.back(), 0})) {
      if (!ring.empty() && edge->first != ring.back()) break;
      if (ring.empty()) ring.push_back(edge->first);
      ring.push_back(edge->second);
      open.erase(edge);
    }
    for (std::size_t i = 2; i < ring.size(); ++i)
      if (!is_flat(ring[0], ring[i], ring[i - 1])) patch.triangles.push_back({ring[0], ring[i], ring[i - 1]});
  }
}

}  // namespace

// The number of triangles of a form that is simplified up to an error.
std::size_t OrganForm::remaining(float error) const {
  if (is_kite(error)) return 4;
  const std::size_t gone = count_within(thinning, error);
  return gone == 0 ? triangles.size() : thinning[gone - 1].triangles;
}

// By vertex, the vertex that it is merged into when the form is simplified up to an error.
std::vector<std::uint32_t> OrganForm::targets(float error) const {
  std::vector<std::uint32_t> to(is_foot.size());
  std::iota(to.begin(), to.end(), 0u);
  for (std::size_t count = count_within(thinning, error); count-- > 0;)
    to[thinning[count].vertex] = to[thinning[count].into];
  return to;
}

// Finder of the forms of organs: organs of the same topology and size share one form and its simplification.
class OrganForms::FormFinder {
 public:
  FormFinder(OrganForms& found, const Derived& derived, const generalized_map::Boundary& boundary,
             const std::vector<glm::vec3>& places);

  void find_organs();
  void find_form(std::uint32_t organ);

 private:
  std::vector<std::uint32_t> number_vertices(std::uint32_t organ);
  int size_exponent(std::span<const std::uint32_t> vertices) const;
  void free_base(OrganForm& form, const FormedOrgan& organ, Topology topology) const;
  // `labels`: of the volumes of the organ's faces.
  static void find_kite(OrganForm& form, const std::vector<glm::vec3>& places,
                        const std::vector<std::uint32_t>& labels);

  OrganForms& found_;
  const Derived& derived_;
  const generalized_map::Boundary& boundary_;
  const std::vector<glm::vec3>& places_;
  std::vector<std::uint32_t> begin_;                           // first half-edge of each face; and the end
  std::vector<std::uint32_t> owner_;                           // by vertex, the first organ that has it
  std::vector<std::uint32_t> local_;                           // by vertex, its number in the current organ
  std::map<std::vector<std::uint32_t>, std::uint32_t> known_;  // forms by their signature
  std::uint32_t comparable_ = max_compared;                    // triangles, in all further forms together
};

// Finds the organs of a flower's boundary and their forms; `places` are the boundary's vertices.
OrganForms::OrganForms(const Derived& derived, const generalized_map::Boundary& boundary,
                       const std::vector<glm::vec3>& places) {
  FormFinder finder(*this, derived, boundary, places);
  finder.find_organs();
  for (std::uint32_t organ = 0; organ < organs_.size(); ++organ) finder.find_form(organ);
  for (FormedOrgan& organ : organs_) organ.number = forms_[organ.form].organs++;
  for (std::uint32_t i = 1; i < organs_.size(); ++i) forms_[organs_[organs_[i].maker].form].has_attached = true;
}

// Finds where each face's half-edges begin, and the organ that owns each vertex: of the organs whose volumes meet
// there, the one with the lowest index, so that an organ shares its foot with its parent.
OrganForms::FormFinder::FormFinder(OrganForms& found, const Derived& derived, const generalized_map::Boundary& boundary,
                                   const std::vector<glm::vec3>& places)
    : found_(found), derived_(derived), boundary_(boundary), places_(places) {
  const ClosedSurface& surface = boundary.surface;
  begin_.resize(surface.faces + 1, surface.half_edges());
  for (std::uint32_t h = surface.half_edges(); h-- > 0;) begin_[surface.face[h]] = h;
  owner_.assign(surface.positions.size(), invalid);
  for (std::uint32_t h = 0; h < surface.half_edges(); ++h) {
    const std::uint32_t volume = boundary.volume[surface.face[h]];
    std::uint32_t& owner = owner_[surface.origin[h]];
    owner = std::min(owner, derived.records[derived.record_of[volume]].instance);
  }
  local_.assign(surface.positions.size(), invalid);
}

// Sorts the boundary's faces by organ.
void OrganForms::FormFinder::find_organs() {
  found_.organs_.resize(derived_.instances.size());
  for (const Record& record : derived_.records)
    if (record.instance != record.maker) found_.organs_[record.instance].maker = record.maker;
  std::vector<std::uint32_t> count(found_.organs_.size() + 1, 0), of_face(boundary_.surface.faces);
  for (std::uint32_t f = 0; f < boundary_.surface.faces; ++f) {
    of_face[f] = derived_.records[derived_.record_of[boundary_.volume[f]]].instance;
    ++count[of_face[f]];
  }
  std::uint32_t next = 0;
  for (std::uint32_t i = 0; i < found_.organs_.size(); ++i) {
    found_.organs_[i].faces = next;
    next += std::exchange(count[i], next);
  }
  found_.own_faces_.resize(next);
  for (std::uint32_t f = 0; f < boundary_.surface.faces; ++f) found_.own_faces_[count[of_face[f]]++] = f;
}

// Numbers an organ's vertices in the order of its faces, and returns its topology.
std::vector<std::uint32_t> OrganForms::FormFinder::number_vertices(std::uint32_t organ) {
  const ClosedSurface& surface = boundary_.surface;
  FormedOrgan& formed = found_.organs_[organ];
  formed.vertices = static_cast<std::uint32_t>(found_.own_vertices_.size());
  const std::size_t end =
      organ + 1 < found_.organs_.size() ? found_.organs_[organ + 1].faces : found_.own_faces_.size();
  std::vector<std::uint32_t> signature;
  for (std::size_t i = formed.faces; i < end; ++i) {
    const std::uint32_t face = found_.own_faces_[i];
    signature.push_back(begin_[face + 1] - begin_[face]);
    for (std::uint32_t h = begin_[face]; h < begin_[face + 1]; ++h) {
      const std::uint32_t vertex = surface.origin[h];
      if (local_[vertex] == invalid) {
        local_[vertex] = static_cast<std::uint32_t>(found_.own_vertices_.size()) - formed.vertices;
        found_.own_vertices_.push_back(vertex);
      }
      signature.push_back(2 * local_[vertex] + (owner_[vertex] != organ));
    }
  }
  for (std::size_t i = formed.vertices; i < found_.own_vertices_.size(); ++i) local_[found_.own_vertices_[i]] = invalid;
  return signature;
}

// The exponent of two of an organ's extent. Organs of twice the size are another form: an error that is right for a
// leaf is too large for a petal.
int OrganForms::FormFinder::size_exponent(std::span<const std::uint32_t> vertices) const {
  glm::vec3 low(std::numeric_limits<float>::max()), high(-low);
  for (const std::uint32_t vertex : vertices) {
    low = glm::min(low, places_[vertex]);
    high = glm::max(high, places_[vertex]);
  }
  int size = 0;
  if (!vertices.empty()) std::frexp(glm::length(high - low), &size);
  return size;
}

// Marks the base of an attached organ, which shares no vertices with its parent, as a foot of its own.
void OrganForms::FormFinder::free_base(OrganForm& form, const FormedOrgan& organ, Topology topology) const {
  if (std::find(form.is_foot.begin(), form.is_foot.end(), 1) != form.is_foot.end()) return;
  for (std::size_t i = 0, face = organ.faces; i < topology.size(); i += 1 + topology[i], ++face)
    if (boundary_.face[found_.own_faces_[face]] == generalized_map::base_face)
      for (std::size_t c = i + 1; c <= i + topology[i]; ++c) form.is_foot[topology[c] / 2] = OrganForm::free_foot;
}

// Finds the form of an organ: the one of an earlier organ with the same topology and size, or a new form, for which the
// order of its simplification is computed.
void OrganForms::FormFinder::find_form(std::uint32_t organ) {
  std::vector<std::uint32_t> signature = number_vertices(organ);
  FormedOrgan& formed = found_.organs_[organ];
  const auto own_vertices = std::span<const std::uint32_t>(found_.own_vertices_).subspan(formed.vertices);
  const std::size_t corners = signature.size();
  signature.push_back(static_cast<std::uint32_t>(size_exponent(own_vertices) + 1024));
  const auto same = known_.find(signature);
  formed.form = same != known_.end() ? same->second : static_cast<std::uint32_t>(found_.forms_.size());
  if (same != known_.end()) return;

  const Topology topology = Topology(signature).first(corners);
  OrganForm& form = found_.forms_.emplace_back();
  Patch patch;
  for (const std::uint32_t vertex : own_vertices) patch.positions.push_back(places_[vertex]);
  patch.is_fixed.assign(own_vertices.size(), 0);
  std::set<Edge> open = triangulate(topology, form, patch);
  form.triangles = patch.triangles;
  patch.counted = static_cast<std::uint32_t>(patch.triangles.size());
  close_holes(open, patch);
  const auto triangles = static_cast<std::uint32_t>(patch.triangles.size());
  found_.coarse_ |= triangles > comparable_;
  form.thinning = thinning_of(patch, comparable_, &found_.work_);
  if (triangles <= comparable_) comparable_ -= triangles;
  while (!form.thinning.empty() && form.thinning.back().triangles < fewest) form.thinning.pop_back();
  form.is_foot = std::move(patch.is_fixed);
  if (organ > 0) free_base(form, formed, topology);
  std::vector<std::uint32_t> labels;
  for (std::size_t i = 0, face = formed.faces; i < corners; i += 1 + topology[i], ++face)
    labels.push_back(derived_.map.volume(boundary_.volume[found_.own_faces_[face]]).label);
  find_kite(form, patch.positions, labels);
  known_.emplace(std::move(signature), formed.form);
}

// Finds the kite of a form; organs without a foot have none. `places`: of the organ's own vertices; `labels`: of its
// faces. The kite reaches from the mean of the foot to the vertex farthest from it, the tip, and has for sides the
// vertex farthest from that line and the farthest one on the other side of it.
void OrganForms::FormFinder::find_kite(OrganForm& form, const std::vector<glm::vec3>& places,
                                       const std::vector<std::uint32_t>& labels) {
  glm::vec3 foot(0);
  float feet = 0;
  for (std::uint32_t v = 0; v < places.size(); ++v) {
    if (form.is_foot[v] == 0) continue;
    if (feet == 0) form.kite[0] = v;
    foot += places[v];
    feet += 1;
  }
  form.rooted = feet > 0;
  if (!form.rooted) return;
  foot /= feet;
  const auto farthest = [&](auto how_far) {
    std::uint32_t best = form.kite[0];
    float greatest = 0;
    for (std::uint32_t v = 0; v < places.size(); ++v) {
      const float distance = form.is_foot[v] == 0 ? how_far(places[v] - foot) : 0;
      if (distance > greatest) greatest = distance, best = v;
    }
    return best;
  };
  form.kite[2] = farthest([](const glm::vec3& way) { return glm::dot(way, way); });
  const glm::vec3 way = places[form.kite[2]] - foot;
  const auto across = [&](const glm::vec3& place) {
    return place - glm::dot(place, way) / std::max(glm::dot(way, way), 1e-20f) * way;
  };
  form.kite[1] = farthest([&](const glm::vec3& place) { return glm::dot(across(place), across(place)); });
  const glm::vec3 side = across(places[form.kite[1]] - foot);
  form.kite[3] = farthest([&](const glm::vec3& place) { return -glm::dot(across(place), side); });
  const float half = glm::length(side), before = form.thinning.empty() ? 0 : form.thinning.back().error;
  form.kite_error = std::max(before, half * flat);

  // Each side has the material of the greatest area.
  const glm::vec3 normal = glm::cross(side, way);
  for (std::size_t k = 0; k < 2; ++k) {
    std::map<std::uint32_t, float> area;  // by label
    float greatest = 0;
    for (std::size_t t = 0; t < form.triangles.size(); ++t) {
      const auto& [a, b, c] = form.triangles[t];
      const float signed_area = glm::dot(normal, glm::cross(places[b] - places[a], places[c] - places[a]));
      if (k == 0 ? signed_area <= 0 : signed_area >= 0) continue;
      float& sum = area[labels[form.faces[t]]];
      sum += std::abs(signed_area);
      if (sum > greatest) greatest = sum, form.kite_faces[k] = form.faces[t];
    }
  }
}

// The memory that it holds, roughly.
std::uint64_t OrganForms::bytes() const {
  std::uint64_t bytes = bytes_of(organs_) + bytes_of(own_vertices_) + bytes_of(own_faces_);
  for (const OrganForm& form : forms_)
    bytes += sizeof form + bytes_of(form.triangles) + bytes_of(form.faces) + bytes_of(form.thinning) +
             bytes_of(form.is_foot);
  return bytes;
}

}  // namespace panicle::flower
