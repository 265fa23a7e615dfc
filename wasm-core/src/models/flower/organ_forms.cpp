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

// The number of collapses within an error.
std::size_t within(const std::vector<Collapse>& thinning, float error) {
  return static_cast<std::size_t>(
      std::upper_bound(thinning.begin(), thinning.end(), error,
                       [](float value, const Collapse& each) { return value < each.error; }) -
      thinning.begin());
}

bool is_flat(std::uint32_t a, std::uint32_t b, std::uint32_t c) { return a == b || b == c || c == a; }

}  // namespace

std::size_t OrganForm::remaining(float error) const {
  if (is_kite(error)) return 4;
  const std::size_t gone = within(thinning, error);
  return gone == 0 ? triangles.size() : thinning[gone - 1].triangles;
}

std::vector<std::uint32_t> OrganForm::targets(float error) const {
  std::vector<std::uint32_t> to(is_foot.size());
  std::iota(to.begin(), to.end(), 0u);
  for (std::size_t count = within(thinning, error); count-- > 0;) to[thinning[count].vertex] = to[thinning[count].into];
  return to;
}

// Temporary data while forms are found.
class OrganForms::FormFinder {
 public:
  FormFinder(OrganForms& found, const Derived& derived, const generalized_map::Boundary& boundary,
             const std::vector<glm::vec3>& places);

  void find_organs();
  void find_form(std::uint32_t organ);

 private:
  std::vector<std::uint32_t> number_vertices(std::uint32_t organ);
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
  std::uint32_t comparable_ = most_compared;                   // triangles, in all further forms together
};

OrganForms::OrganForms(const Derived& derived, const generalized_map::Boundary& boundary,
                       const std::vector<glm::vec3>& places) {
  FormFinder finder(*this, derived, boundary, places);
  finder.find_organs();
  for (std::uint32_t organ = 0; organ < organs_.size(); ++organ) finder.find_form(organ);
  for (FormedOrgan& organ : organs_) organ.number = forms_[organ.form].organs++;
  for (std::uint32_t i = 1; i < organs_.size(); ++i) forms_[organs_[organs_[i].maker].form].has_attached = true;
}

OrganForms::FormFinder::FormFinder(OrganForms& found, const Derived& derived, const generalized_map::Boundary& boundary,
                                   const std::vector<glm::vec3>& places)
    : found_(found), derived_(derived), boundary_(boundary), places_(places) {
  const ClosedSurface& surface = boundary.surface;
  begin_.resize(surface.faces + 1, surface.half_edges());
  for (std::uint32_t h = surface.half_edges(); h-- > 0;) begin_[surface.face[h]] = h;
  owner_.assign(surface.positions.size(), invalid);
  for (std::uint32_t h = 0; h < surface.half_edges(); ++h) {
    const std::uint32_t volume = boundary.volume[surface.face[h]];
    std::uint32_t& of = owner_[surface.origin[h]];
    of = std::min(of, derived.records[derived.record_of[volume]].instance);
  }
  local_.assign(surface.positions.size(), invalid);
}

// Sorts faces by organ, in their order.
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

// Numbers an organ's vertices in the order of its faces, and returns its topology: the faces' corners, and whether each
// vertex belongs to the parent organ.
std::vector<std::uint32_t> OrganForms::FormFinder::number_vertices(std::uint32_t organ) {
  const ClosedSurface& surface = boundary_.surface;
  FormedOrgan& of = found_.organs_[organ];
  of.vertices = static_cast<std::uint32_t>(found_.own_vertices_.size());
  const std::size_t end =
      organ + 1 < found_.organs_.size() ? found_.organs_[organ + 1].faces : found_.own_faces_.size();
  std::vector<std::uint32_t> signature;
  for (std::size_t i = of.faces; i < end; ++i) {
    const std::uint32_t face = found_.own_faces_[i];
    signature.push_back(begin_[face + 1] - begin_[face]);
    for (std::uint32_t h = begin_[face]; h < begin_[face + 1]; ++h) {
      const std::uint32_t vertex = surface.origin[h];
      if (local_[vertex] == invalid) {
        local_[vertex] = static_cast<std::uint32_t>(found_.own_vertices_.size()) - of.vertices;
        found_.own_vertices_.push_back(vertex);
      }
      signature.push_back(2 * local_[vertex] + (owner_[vertex] != organ));
    }
  }
  for (std::size_t i = of.vertices; i < found_.own_vertices_.size(); ++i) local_[found_.own_vertices_[i]] = invalid;
  return signature;
}

void OrganForms::FormFinder::find_form(std::uint32_t organ) {
  std::vector<std::uint32_t> signature = number_vertices(organ);
  FormedOrgan& of = found_.organs_[organ];
  const auto own = std::span<const std::uint32_t>(found_.own_vertices_).subspan(of.vertices);
  glm::vec3 low(std::numeric_limits<float>::max()), high(-low);
  for (const std::uint32_t vertex : own) {
    low = glm::min(low, places_[vertex]);
    high = glm::max(high, places_[vertex]);
  }
  // Organs of twice the size are another form: an error that is right for a leaf is too large for a petal.
  int size = 0;
  if (!own.empty()) std::frexp(glm::length(high - low), &size);
  const std::size_t corners = signature.size();
  signature.push_back(static_cast<std::uint32_t>(size + 1024));
  const auto same = known_.find(signature);
  of.form = same != known_.end() ? same->second : static_cast<std::uint32_t>(found_.forms_.size());
  if (same != known_.end()) return;

  OrganForm& form = found_.forms_.emplace_back();
  Patch patch;
  for (const std::uint32_t vertex : own) patch.positions.push_back(places_[vertex]);
  patch.is_fixed.assign(own.size(), 0);
  std::set<std::pair<std::uint32_t, std::uint32_t>> open;  // edges without a face on their other side
  for (std::size_t i = 0, face = 0; i < corners; ++face) {
    const std::size_t first = i + 1, end = first + signature[i];
    for (std::size_t c = first; c < end; ++c) {
      const std::uint32_t a = signature[c] / 2, b = signature[c + 1 < end ? c + 1 : first] / 2;
      patch.is_fixed[a] = signature[c] % 2;
      if (c >= first + 2) {
        patch.triangles.push_back({signature[first] / 2, signature[c - 1] / 2, a});
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
  form.triangles = patch.triangles;
  patch.counted = static_cast<std::uint32_t>(patch.triangles.size());
  // Holes at the foot and at attached organs are closed while thinning, so that their rims keep their shape.
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
  const auto triangles = static_cast<std::uint32_t>(patch.triangles.size());
  found_.coarse_ |= triangles > comparable_;
  form.thinning = thinning_of(patch, comparable_, &found_.work_);
  if (triangles <= comparable_) comparable_ -= triangles;
  while (!form.thinning.empty() && form.thinning.back().triangles < fewest) form.thinning.pop_back();
  // An attached organ has a base of its own.
  form.is_foot = std::move(patch.is_fixed);
  if (organ > 0 && std::find(form.is_foot.begin(), form.is_foot.end(), 1) == form.is_foot.end())
    for (std::size_t i = 0, face = of.faces; i < corners; i += 1 + signature[i], ++face)
      if (boundary_.face[found_.own_faces_[face]] == generalized_map::base_face)
        for (std::size_t c = i + 1; c <= i + signature[i]; ++c) form.is_foot[signature[c] / 2] = OrganForm::free_foot;
  std::vector<std::uint32_t> labels;
  for (std::size_t i = 0, face = of.faces; i < corners; i += 1 + signature[i], ++face)
    labels.push_back(derived_.map.volume(boundary_.volume[found_.own_faces_[face]]).label);
  find_kite(form, patch.positions, labels);
  known_.emplace(std::move(signature), of.form);
}

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
    float most = 0;
    for (std::uint32_t v = 0; v < places.size(); ++v) {
      const float far = form.is_foot[v] == 0 ? how_far(places[v] - foot) : 0;
      if (far > most) most = far, best = v;
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
    float most = 0;
    for (std::size_t t = 0; t < form.triangles.size(); ++t) {
      const auto& [a, b, c] = form.triangles[t];
      const float like = glm::dot(normal, glm::cross(places[b] - places[a], places[c] - places[a]));
      if (k == 0 ? like <= 0 : like >= 0) continue;
      float& all = area[labels[form.faces[t]]];
      all += std::abs(like);
      if (all > most) most = all, form.kite_faces[k] = form.faces[t];
    }
  }
}

std::uint64_t OrganForms::bytes() const {
  std::uint64_t bytes = bytes_of(organs_) + bytes_of(own_vertices_) + bytes_of(own_faces_);
  for (const OrganForm& form : forms_)
    bytes += sizeof form + bytes_of(form.triangles) + bytes_of(form.faces) + bytes_of(form.thinning) +
             bytes_of(form.is_foot);
  return bytes;
}

}  // namespace panicle::flower
