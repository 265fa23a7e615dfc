// Forms of organs: organs with the same topology and similar size, and how far one can be thinned from afar: computed
// for the first organ of each form, and valid for all.
#pragma once

#include <array>
#include <cstdint>
#include <glm/vec3.hpp>
#include <vector>

#include "generalized_map/boundary.hpp"
#include "mesh/simplification.hpp"
#include "models/flower/derivation.hpp"

namespace panicle::flower {

struct OrganForm {
  static constexpr std::uint8_t free_foot = 2;  // of an attached organ, whose foot may be thinned like any vertex

  std::vector<std::array<std::uint32_t, 3>> triangles;  // of the first organ, by its own vertices
  std::vector<std::uint32_t> faces;                     // of triangles: index of the face
  std::vector<Collapse> thinning;
  std::vector<std::uint8_t> is_foot;  // by vertex: 1 of the parent organ, `free_foot` of a base of its own
  std::uint32_t organs = 0;
  // The last shape of an organ without others attached: a kite with two sides. Its corners are a vertex of the foot,
  // one at a side, the one farthest from the foot, and one at the other side.
  std::array<std::uint32_t, 4> kite{};
  std::array<std::uint32_t, 2> kite_faces{};  // the faces whose materials its two sides have
  float kite_error = 0;
  bool has_attached = false, rooted = false;

  std::uint32_t tip() const { return kite[2]; }
  // Whether an organ is drawn as a kite, of two triangles, at that tolerated error.
  bool is_kite(float error) const { return rooted && !has_attached && error >= kite_error; }
  std::size_t remaining(float error) const;               // number of triangles
  std::vector<std::uint32_t> targets(float error) const;  // by vertex, the vertex that it is merged into
};

// An organ of a flower, by its index in the derivation's instances.
struct FormedOrgan {
  std::uint32_t form = 0, number = 0;     // form, and index of the organ among its form's
  std::uint32_t maker = 0;                // the parent organ
  std::uint32_t vertices = 0, faces = 0;  // where its own vertices and faces begin
};

class OrganForms {
 public:
  // `places`: of the boundary's vertices, for the errors of thinning.
  OrganForms(const Derived& derived, const generalized_map::Boundary& boundary, const std::vector<glm::vec3>& places);

  const std::vector<FormedOrgan>& organs() const { return organs_; }
  const std::vector<OrganForm>& forms() const { return forms_; }
  const OrganForm& form(const FormedOrgan& of) const { return forms_[of.form]; }
  // Its own vertices and faces, by numbers of the boundary; as many as its form has.
  const std::uint32_t* vertices(const FormedOrgan& of) const { return own_vertices_.data() + of.vertices; }
  // The first of an organ's own faces.
  const std::uint32_t* faces(const FormedOrgan& of) const { return own_faces_.data() + of.faces; }
  // Collapses that were compared to find all thinnings (thinning_of), a unit of work each.
  std::uint64_t work() const { return work_; }
  // Whether forms have so many triangles together that some were thinned on a grid.
  bool is_coarse() const { return coarse_; }
  std::uint64_t bytes() const;  // memory that it holds, roughly

 private:
  class FormFinder;

  std::vector<FormedOrgan> organs_;
  std::vector<std::uint32_t> own_vertices_, own_faces_;  // of organs, one after the other
  std::vector<OrganForm> forms_;
  std::uint64_t work_ = 0;
  bool coarse_ = false;
};

}  // namespace panicle::flower
